"""The parts of all sensor models: the ground's reference system, the model, least squares and the inverse."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Callable, ClassVar

import numpy as np

from ...imagery import messages as imagery_messages
from ...imagery.documents import document_bytes
from ...imagery.errors import SensorModelError
from ...imagery.grids import Extent
from ...imagery.reference_systems import transform_points
from . import limits, messages

WGS84 = "EPSG:4326"


def file_content(path: Path) -> bytes:
    """Content of a file that the user names. Raises SensorModelError where there is none that can be read."""
    try:
        return document_bytes(path)
    except OSError:
        raise SensorModelError(imagery_messages.NOT_FOUND(path=path)) from None


def reprojected(ground: np.ndarray, wkt: str, target: str) -> np.ndarray:
    """(n, 3) x, y (longitude first) and height above the ellipsoid, m, in another reference system; heights stay."""
    return np.column_stack([transform_points(ground, wkt, target), ground[:, 2]])


def bounding_box(places: np.ndarray) -> Extent:
    """Smallest and largest x and y of (n, 2 or more) places: xmin, ymin, xmax, ymax."""
    (x, y), (right, top) = places[:, :2].min(axis=0).tolist(), places[:, :2].max(axis=0).tolist()
    return x, y, right, top


@dataclass(frozen=True)
class SensorModel:
    """From the ground to the image. A model file holds the fields of the class."""

    GEOGRAPHIC: ClassVar[bool] = False  # whether the ground is longitude and latitude (WGS 84), not the points' system
    SPATIAL: ClassVar[bool] = True  # whether heights play a part; without them there is no RPC

    @classmethod
    def ground_system(cls, wkt: str) -> str:
        """The system that its ground is in, for points of the system ``wkt``."""
        return WGS84 if cls.GEOGRAPHIC else wkt

    def project(self, ground: np.ndarray) -> np.ndarray:
        """(n, 3) x, y, ellipsoidal height -> (n, 2) column, row in px."""
        rational = self.as_rational()
        assert rational is not None  # what has not that form says how it projects
        return rational.project(ground)

    def places(
        self, image: np.ndarray, heights: np.ndarray, middle: np.ndarray, metres: tuple[float, float]
    ) -> np.ndarray:
        """(n, 2) x, y of (n, 2) column, row at heights (n,), found from the ``middle`` on; ``metres`` in a unit of x
        and y. Raises SensorModelError where it can't be inverted."""
        return locate(self.project, image, heights, middle, metres)

    def as_rational(self) -> SensorModel | None:
        """This function as a ``Rational``, which is an RPC's form; None where it does not have that form."""
        return None


@dataclass(frozen=True)
class FittedModel:
    model: SensorModel
    condition: float  # condition number of the last design matrix, its columns scaled to length 1
    iterations: int  # 1 for a linear model
    converged: bool  # whether the last iteration changed the image coordinates by less than the limit
    unknowns: float  # how many the points have determined: all of a free model, less where priors hold some


def least_squares(design: np.ndarray, target: np.ndarray) -> tuple[np.ndarray, float]:
    """Solve ``design @ x = target`` for (m, n) and (m,) or (m, k), columns of length 1, without what rounding makes;
    x, and the largest over the smallest singular value. Raises SensorModelError for numbers that are none."""
    lengths = np.linalg.norm(design, axis=0)
    lengths[lengths == 0] = 1.0
    scaled = design / lengths
    if not (np.isfinite(scaled).all() and np.isfinite(target).all()):
        raise SensorModelError(messages.FIT_DIVERGED())
    values, _, _, singular = np.linalg.lstsq(scaled, target, rcond=np.finfo(float).eps * max(design.shape))
    condition = float(singular[0] / singular[-1]) if singular[-1] > 0 else np.inf
    return (values.T / lengths).T, condition


@dataclass(frozen=True)
class Scaling:
    """Coordinates brought to -1..1: (value - offset) / scale."""

    offset: np.ndarray  # (k,) the middle of the range
    scale: np.ndarray  # (k,) half the range, never 0

    @classmethod
    def of(cls, coordinates: np.ndarray) -> Scaling:
        low, high = coordinates.min(axis=0), coordinates.max(axis=0)
        half = (high - low) / 2
        return cls((low + high) / 2, np.where(half > 0, half, 1.0))

    def to(self, coordinates: np.ndarray) -> np.ndarray:
        with np.errstate(over="ignore"):  # by a scale that is next to nothing
            return np.asarray((coordinates - self.offset) / self.scale)

    def back(self, scaled: np.ndarray) -> np.ndarray:
        return scaled * self.scale + self.offset


Map = Callable[[np.ndarray], np.ndarray]


def newton(
    function: Map, wanted: np.ndarray, start: np.ndarray, step: float = 1e-4, partly: bool = False
) -> np.ndarray:
    """Solve ``function(x) = wanted`` for (n, 2) x near ``start``; where it does not converge NaN, or with ``partly``
    what the first step reaches. ``step``: of derivatives, in x."""
    roots, first = np.array(start, float), None
    last = np.full(len(roots), np.inf)
    for _ in range(limits.MAX_NEWTON_ITERATIONS):
        misfit = wanted - function(roots)
        (a, c), (b, d) = ((function(roots + axis) - function(roots - axis)).T / (2 * step) for axis in np.eye(2) * step)
        x, y = misfit.T
        with np.errstate(all="ignore"):  # of a plane of two equations, [[a, b], [c, d]]
            change = np.column_stack([d * x - b * y, a * y - c * x]) / (a * d - b * c)[:, None]
        roots = roots + change
        first = roots if first is None else first
        last = np.abs(change).max(axis=1)
        if not np.any(last > step * 1e-6):
            break
    return np.where((last <= step)[:, None], roots, first if partly else np.nan)


def locate(
    project: Map, image: np.ndarray, heights: np.ndarray, start: np.ndarray, metres: tuple[float, float],
    partly: bool = False,
) -> np.ndarray:
    """(n, 2) x, y of image points (n, 2) at heights (n,), by Newton's method from ``start``; ``metres`` in a unit of x
    and y. Raises SensorModelError where there is none, but with ``partly``, which is that of ``newton``."""
    scale = 1 / np.asarray(metres)

    def seen(units: np.ndarray) -> np.ndarray:
        return project(np.column_stack([start + units * scale, heights]))

    units = newton(seen, image, np.zeros((len(image), 2)), 1.0, partly)
    if not partly and not np.isfinite(units).all():
        raise SensorModelError(messages.NOT_INVERTED())
    return start + units * scale
