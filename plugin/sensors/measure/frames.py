"""The frame camera of an aerial photo: what its lens distorts, and where it shows places on the ground."""
from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial.polynomial import polyval
from scipy.spatial.transform import Rotation

from ...imagery.errors import SensorModelError
from . import messages
from .sensor_model import SensorModel, newton

START_REACH = 0.8  # of what the lens shows, where the search for the inverse of its distortion begins at most
TANGENT_STEP = 1e-6  # that derivatives of the distortion are taken with
SMALLEST_OFFSET = 1e-12  # tangents: the centre itself has no direction
EARTH_CURVATURE = 1 / 6_371_000.0  # 1/m, of the mean Earth
_CURVED_STEPS = 4  # each leaves a thousandth of what the one before changed
_STEEPEST = 10.0  # focal lengths, 84 degrees off the axis: what no photo of the ground shows
_STEPS = 2000


@dataclass(frozen=True)
class Lens:
    """A lens without distortion, and what all lenses have in common."""

    @cached_property
    def reach(self) -> float:
        """Distance from the centre, in focal lengths, up to which what lies further out is shown further out; beyond,
        the formula folds back into the photo what the lens never showed."""
        distance = np.linspace(0.0, _STEEPEST, _STEPS)
        folded = np.flatnonzero(np.diff(distance * self.scale(distance**2)) <= 0)
        return float(distance[folded[0]]) if folded.size else np.inf

    def scale(self, squared: np.ndarray) -> np.ndarray:
        """Factor by which a point is shown further out, by the square of its distance from the centre."""
        return np.ones_like(squared)

    def distorted(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The distorted place, in focal lengths along columns and rows; NaN for what the lens doesn't show."""
        squared = x * x + y * y
        scale = self.scale(squared)
        if np.isfinite(self.reach):
            scale[squared > self.reach**2] = np.nan
        return x * scale, y * scale


@dataclass(frozen=True)
class BrownLens(Lens):
    """Brown's (1971), named as OpenCV does."""

    radial: tuple[float, ...]  # k1, k2, k3: coefficients of r^2, r^4, r^6
    tangential: tuple[float, float] = (0.0, 0.0)  # p1 (rows) and p2 (columns)

    def scale(self, squared: np.ndarray) -> np.ndarray:
        return polyval(squared, np.array((1.0, *self.radial), squared.dtype))

    def distorted(self, x: np.ndarray, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        across, down = super().distorted(x, y)
        if not any(self.tangential):
            return across, down
        (first, second), product, squared = self.tangential, 2 * x * y, x * x + y * y
        across += first * product + second * (squared + 2 * x * x)
        down += first * (squared + 2 * y * y) + second * product
        return across, down


@dataclass(frozen=True)
class FisheyeLens(Lens):
    """OpenCV's and OpenSfM's: the distance grows with the angle off the axis (Kannala and Brandt 2006)."""

    angular: tuple[float, ...]  # k1, k2, k3, k4: coefficients of the angle's 2nd, 4th, 6th and 8th power

    def scale(self, squared: np.ndarray) -> np.ndarray:
        distance = np.sqrt(squared)
        angle = np.arctan(distance)
        shown = angle * polyval(angle * angle, np.array((1.0, *self.angular), angle.dtype))
        return np.divide(shown, distance, out=np.ones_like(distance), where=distance > 0)


@dataclass(frozen=True)
class FrameInterior:
    """A camera, in pixels of the image that it is used for: (0, 0) is the upper left corner of the first pixel."""

    focal: np.ndarray  # (2,) focal length along columns and rows, px
    principal: np.ndarray  # (2,) column and row of the principal point
    lens: Lens  # its distortion, about the principal point

    def shown(self, across: np.ndarray, down: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Column and row of views whose tangents along the camera's columns and rows are given."""
        principal, focal = self.principal.tolist(), self.focal.tolist()
        x, y = self.lens.distorted(across, down)
        return principal[0] + focal[0] * x, principal[1] + focal[1] * y

    def tangents(self, image: np.ndarray) -> np.ndarray:
        """(n, 2) column, row -> (n, 2) tangents of the views that are shown there; NaN where the lens shows none."""
        offset = (image - self.principal) / self.focal
        share = START_REACH * self.lens.reach / np.maximum(np.hypot(*offset.T), SMALLEST_OFFSET)
        start = offset * np.minimum(share, 1.0)[:, None]
        return newton(lambda tangents: np.column_stack(self.shown(*tangents.T)), image, start, TANGENT_STEP)


@dataclass(frozen=True)
class FrameCamera(SensorModel):
    """Collinearity: x, y of a plane system and heights are one Cartesian space. What is behind the camera is NaN."""

    interior: FrameInterior
    position: np.ndarray  # (3,) projection centre: x, y, height, m
    axes: np.ndarray  # (3, 3) columns: the camera's axes along columns, along rows and along the view, on the ground
    curvature: float = 0.0  # 1/m: the Earth's, with x and y of a projection about the camera; 0: x and y are Cartesian

    def project(self, ground: np.ndarray) -> np.ndarray:
        """(n, 3) x, y, height -> (n, 2) column, row."""
        return np.column_stack(self.seen(*ground.T))

    def seen(
        self, x: np.ndarray, y: np.ndarray, height: np.ndarray, kind: type = np.float64
    ) -> tuple[np.ndarray, np.ndarray]:
        """Column and row of arrays of places; float32 halves the time and is 0.001 px off at 10,000."""
        if self.curvature:
            swelling = 1 + self.curvature * height  # further from the Earth's middle, further apart
            x, y = (x - self.position[0]) * swelling, (y - self.position[1]) * swelling
            height = height - self.position[2] - self.curvature / 2 * (x * x + y * y)
        else:
            x, y, height = x - self.position[0], y - self.position[1], height - self.position[2]
        x, y, height = (np.asarray(values, kind) for values in (x, y, height))
        east, north, up = self.axes.tolist()
        across, down, depth = (x * east[axis] + y * north[axis] + height * up[axis] for axis in (0, 1, 2))
        depth[depth <= 0] = np.nan
        across /= depth
        down /= depth
        return self.interior.shown(across, down)

    def places(
        self, image: np.ndarray, heights: np.ndarray, middle: np.ndarray, metres: tuple[float, float]
    ) -> np.ndarray:
        return self.places_at(self.views(image), heights)  # exact, however oblique

    def views(self, image: np.ndarray) -> np.ndarray:
        """(n, 3) unit vectors towards (n, 2) column, row. Raises SensorModelError for what the lens can't show."""
        tangents = self.interior.tangents(image)
        if not np.isfinite(tangents).all():
            raise SensorModelError(messages.LENS_FOLDS())
        views = np.column_stack([tangents, np.ones(len(tangents))]) @ self.axes.T
        return np.asarray(views / np.linalg.norm(views, axis=1, keepdims=True))

    def places_at(self, views: np.ndarray, heights: np.ndarray) -> np.ndarray:
        """(n, 2) x and y where views (n, 3) that go down meet heights (n,) below the camera."""
        places = views[:, :2] * ((heights - self.position[2]) / views[:, 2])[:, None]
        for _ in range(_CURVED_STEPS if self.curvature else 0):
            fallen = heights - self.position[2] - self.curvature / 2 * np.sum(places**2, axis=1)
            places = views[:, :2] * (fallen / views[:, 2])[:, None]
        return np.asarray(self.position[:2] + places / (1 + self.curvature * heights)[:, None])


def camera_axes(omega: float, phi: float, kappa: float) -> np.ndarray:
    """(3, 3) axes of a camera by the angles (degrees) of photogrammetry; with all 0 it looks down, columns to the east.
    Kraus, Photogrammetry: Rx(omega) Ry(phi) Rz(kappa), the second and third axis turned to rows and view."""
    turned = Rotation.from_euler("XYZ", [omega, phi, kappa], degrees=True).as_matrix()
    return np.asarray(turned @ np.diag([1.0, -1.0, -1.0]))
