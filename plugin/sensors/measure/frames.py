"""The frame camera of an aerial photo: where it shows places on the ground."""
from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from scipy.spatial.transform import Rotation

from ...imagery.errors import SensorModelError
from . import messages
from .lenses import Lens
from .sensor_model import SensorModel, newton

START_REACH = 0.8  # of what the lens shows, where the search for the inverse of its distortion begins at most
TANGENT_STEP = 1e-6  # that derivatives of the distortion are taken with
SMALLEST_OFFSET = 1e-12  # tangents: the centre itself has no direction
EARTH_CURVATURE = 1 / 6_371_000.0  # 1/m, of the mean Earth
_CURVED_STEPS = 4  # each leaves a thousandth of what the one before changed


@dataclass(frozen=True)
class FrameInterior:
    """A camera, in pixels of the image that it is used for: (0, 0) is the upper left corner of the first pixel."""

    focal: np.ndarray
    """(2,) focal length along columns and rows, px."""
    principal: np.ndarray
    """(2,) column and row of the principal point."""
    lens: Lens
    """Its distortion, about ``centre``."""
    centre: np.ndarray
    """(2,) column and row that distortion is symmetric about."""

    def shown(self, across: np.ndarray, down: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Column and row of views whose tangents along the camera's columns and rows are given."""
        principal, centre, focal = (one.tolist() for one in (self.principal, self.centre, self.focal))
        x, y = self.lens.distorted(
            across + (principal[0] - centre[0]) / focal[0], down + (principal[1] - centre[1]) / focal[1]
        )
        return centre[0] + focal[0] * x, centre[1] + focal[1] * y

    def tangents(self, image: np.ndarray) -> np.ndarray:
        """(n, 2) column, row -> (n, 2) tangents of the views that are shown there; NaN where the lens shows none."""
        offset = (image - self.centre) / self.focal
        share = START_REACH * self.lens.reach / np.maximum(np.hypot(*offset.T), SMALLEST_OFFSET)
        start = offset * np.minimum(share, 1.0)[:, None] + (self.centre - self.principal) / self.focal
        return newton(lambda tangents: np.column_stack(self.shown(*tangents.T)), image, start, TANGENT_STEP)


@dataclass(frozen=True)
class FrameCamera(SensorModel):
    """Collinearity: x, y of a plane system and heights are one Cartesian space. A point behind the camera has no place:
    NaN."""

    GEOGRAPHIC: ClassVar[bool] = False

    interior: FrameInterior
    position: np.ndarray
    """(3,) projection centre: x, y, height, m."""
    axes: np.ndarray
    """(3, 3) columns: the camera's axes along columns, along rows and along the view, on the ground."""
    curvature: float = 0.0
    """1/m, of the ground: 0 where x and y are taken as Cartesian, else the Earth's, and x and y are those of a
    projection about the camera that keeps distances there."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        """(n, 3) x, y, height -> (n, 2) column, row."""
        return np.column_stack(self.seen(*ground.T))

    def seen(
        self, x: np.ndarray, y: np.ndarray, height: np.ndarray, kind: type = np.float64
    ) -> tuple[np.ndarray, np.ndarray]:
        """Column and row of places given in arrays that numpy broadcasts; float32 halves the time and is 0.001 px off
        at 10,000."""
        if self.curvature:
            swelling = 1 + self.curvature * height  # further from the Earth's middle, further apart
            x, y = (x - self.position[0]) * swelling, (y - self.position[1]) * swelling
            height = height - self.position[2] - self.curvature / 2 * (x * x + y * y)
        else:
            x, y, height = (one - origin for one, origin in zip((x, y, height), self.position))
        x, y, height = (np.asarray(one, kind) for one in (x, y, height))
        east, north, up = self.axes.tolist()
        depth = x * east[2] + y * north[2] + height * up[2]
        depth[depth <= 0] = np.nan
        ideal = []
        for axis in (0, 1):
            along = x * east[axis] + y * north[axis] + height * up[axis]
            along /= depth
            ideal.append(along)
        return self.interior.shown(*ideal)

    def places(
        self, image: np.ndarray, heights: np.ndarray, middle: np.ndarray, metres: tuple[float, float]
    ) -> np.ndarray:
        return self.places_at(self.views(image), heights)  # exact, however oblique

    def views(self, image: np.ndarray) -> np.ndarray:
        """(n, 3) unit vectors on the ground towards (n, 2) column, row. Raises SensorModelError for what the lens can't
        show."""
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
