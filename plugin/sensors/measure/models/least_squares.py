"""Linear least squares by singular values on scaled columns, and the scaling of coordinates. No ridge anywhere."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ....imagery.errors import SensorModelError
from .. import messages


@dataclass(frozen=True)
class Solution:
    """Of a linear least squares problem."""

    values: np.ndarray
    """The unknowns."""
    condition: float
    """Largest over smallest singular value of the design matrix with columns of length 1."""
    rank: int


def least_squares(design: np.ndarray, target: np.ndarray) -> Solution:
    """Solve ``design @ x = target`` for (m, n) and (m,) or (m, k), the columns brought to length 1 before.

    Singular values below machine precision times the larger side are taken as zero, nothing is added to the others.
    Raises SensorModelError where an iteration has run away into numbers that are none.
    """
    lengths = np.linalg.norm(design, axis=0)
    lengths[lengths == 0] = 1.0
    scaled = design / lengths
    if not (np.isfinite(scaled).all() and np.isfinite(target).all()):
        raise SensorModelError(messages.FIT_DIVERGED())
    values, _, rank, singular = np.linalg.lstsq(scaled, target, rcond=np.finfo(float).eps * max(design.shape))
    condition = float(singular[0] / singular[-1]) if singular[-1] > 0 else np.inf
    return Solution((values.T / lengths).T, condition, int(rank))


@dataclass(frozen=True)
class Scaling:
    """Coordinates brought to -1..1: (value - offset) / scale."""

    offset: np.ndarray
    """(k,) the middle of the range."""
    scale: np.ndarray
    """(k,) half the range, never 0."""

    @classmethod
    def of(cls, coordinates: np.ndarray) -> Scaling:
        """The scaling that brings (n, k) coordinates to -1..1."""
        low, high = coordinates.min(axis=0), coordinates.max(axis=0)
        half = (high - low) / 2
        return cls((low + high) / 2, np.where(half > 0, half, 1.0))

    def to(self, coordinates: np.ndarray) -> np.ndarray:
        return (coordinates - self.offset) / self.scale

    def back(self, scaled: np.ndarray) -> np.ndarray:
        return scaled * self.scale + self.offset
