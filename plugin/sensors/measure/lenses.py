"""Lens distortion: where a lens puts what one without distortion would see, in focal lengths from its centre."""
from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

_STEEPEST = 10.0  # focal lengths, 84 degrees off the axis: what no photo of the ground shows
_STEPS = 2000


@dataclass(frozen=True)
class Lens:
    """One without distortion, and what all have in common."""

    @cached_property
    def reach(self) -> float:
        """Distance from the centre, in focal lengths, up to which what lies further out is shown further out; beyond,
        the formula folds back into the photo what the lens never showed."""
        distance = np.linspace(0.0, _STEEPEST, _STEPS)
        folded = np.flatnonzero(np.diff(distance * self.scale(distance**2)) <= 0)
        return float(distance[folded[0]]) if folded.size else np.inf

    def scale(self, squared: np.ndarray) -> np.ndarray:
        """How much further out a point is shown, by the square of its distance from the centre."""
        return np.ones_like(squared)

    def added(self, x: np.ndarray, y: np.ndarray, squared: np.ndarray) -> tuple[np.ndarray, np.ndarray] | None:
        """What is not radial, in focal lengths along columns and rows; None for nothing."""
        return None

    def distorted(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """In focal lengths along columns and rows; NaN for what the lens doesn't show."""
        squared = x * x + y * y
        scale = self.scale(squared)
        if np.isfinite(self.reach):
            scale[squared > self.reach**2] = np.nan
        added = self.added(x, y, squared)
        across, down = x * scale, y * scale
        return (across, down) if added is None else (across + added[0], down + added[1])


@dataclass(frozen=True)
class BrownLens(Lens):
    """Brown's (1971) with OpenCV's later terms: a quotient of radial polynomials and a thin prism."""

    radial: tuple[float, ...]
    """k1, k2, k3 ...: coefficients of r^2, r^4 ..."""
    tangential: tuple[float, float] = (0.0, 0.0)
    """p1 (rows) and p2 (columns)."""
    divisor: tuple[float, ...] = ()
    """k4, k5, k6: coefficients of r^2, r^4, r^6 of what it is divided by."""
    prism: tuple[float, ...] = ()
    """s1 and s2 (columns), s3 and s4 (rows): coefficients of r^2 and r^4."""

    def scale(self, squared: np.ndarray) -> np.ndarray:
        scale = _polynomial(self.radial, squared)
        return scale / _polynomial(self.divisor, squared) if any(self.divisor) else scale

    def added(self, x: np.ndarray, y: np.ndarray, squared: np.ndarray) -> tuple[np.ndarray, np.ndarray] | None:
        if not any((*self.tangential, *self.prism)):
            return None
        (first, second), product = self.tangential, 2 * x * y
        across = first * product + second * (squared + 2 * x * x)
        down = first * (squared + 2 * y * y) + second * product
        if any(self.prism):
            across = across + squared * (self.prism[0] + self.prism[1] * squared)
            down = down + squared * (self.prism[2] + self.prism[3] * squared)
        return across, down


@dataclass(frozen=True)
class FisheyeLens(Lens):
    """OpenCV's and OpenSfM's: the distance grows with the angle off the axis (Kannala and Brandt 2006)."""

    angular: tuple[float, ...]
    """k1, k2, k3, k4: coefficients of the angle's 2nd, 4th, 6th and 8th power."""

    def scale(self, squared: np.ndarray) -> np.ndarray:
        distance = np.sqrt(squared)
        angle = np.arctan(distance)
        shown = angle * _polynomial(self.angular, angle * angle)
        return np.divide(shown, distance, out=np.ones_like(distance), where=distance > 0)


def _polynomial(coefficients: tuple[float, ...], value: np.ndarray) -> np.ndarray:
    """1 + c1 v + c2 v^2 + ..., by Horner's rule."""
    found = np.zeros_like(value)
    for coefficient in reversed(np.trim_zeros(coefficients, "b")):
        found += coefficient
        found *= value
    found += 1
    return found
