"""The frame camera: one perspective for the whole image, by its interior and exterior orientation."""
from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from .sensor_model import SensorModel


@dataclass(frozen=True)
class FrameInterior:
    """A camera, in pixels of the image that it is used for: (0, 0) is the upper left corner of the first pixel."""

    focal: np.ndarray
    """(2,) focal length along columns and rows, px."""
    principal: np.ndarray
    """(2,) column and row of the principal point."""
    radial: np.ndarray
    """(k,), one at least: coefficients of r^2, r^4, ..., r the distance from ``distortion_centre`` in focal lengths."""
    tangential: np.ndarray
    """(2,) Brown's p1 (rows) and p2 (columns), in focal lengths."""
    distortion_centre: np.ndarray
    """(2,) column and row that distortion is symmetric about."""

    def distorted(self, ideal: np.ndarray) -> np.ndarray:
        """(n, 2) px where a camera without distortion sees points -> where this one does (Brown 1971)."""
        x, y = ((ideal - self.distortion_centre) / self.focal).T
        squared = x * x + y * y
        scale = 1 + squared * np.polynomial.polynomial.polyval(squared, self.radial)
        first, second = self.tangential
        across = x * scale + 2 * first * x * y + second * (squared + 2 * x * x)
        down = y * scale + first * (squared + 2 * y * y) + 2 * second * x * y
        return self.distortion_centre + self.focal * np.column_stack([across, down])


@dataclass(frozen=True)
class FrameCamera(SensorModel):
    """Collinearity: x and y of a plane system and heights are taken as one Cartesian space, as aerotriangulation does.

    A point behind the camera has no place in the image: NaN.
    """

    GEOGRAPHIC: ClassVar[bool] = False

    interior: FrameInterior
    position: np.ndarray
    """(3,) projection centre: x, y, height, m."""
    axes: np.ndarray
    """(3, 3) columns: the camera's axes along columns, along rows and along the view, on the ground."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        """(n, 3) x, y, height -> (n, 2) column, row."""
        seen = (ground - self.position) @ self.axes
        depth = np.where(seen[:, 2] > 0, seen[:, 2], np.nan)
        interior = self.interior
        return interior.distorted(interior.principal + interior.focal * seen[:, :2] / depth[:, None])

    def place_at(self, height: float) -> np.ndarray:
        """(2,) x and y where the view along the camera's axis meets a height below the camera."""
        view = self.axes[:, 2]
        down = (height - self.position[2]) / view[2] if view[2] < 0 else 0.0
        return self.position[:2] + max(down, 0.0) * view[:2]


def camera_axes(omega: float, phi: float, kappa: float) -> np.ndarray:
    """(3, 3) axes of a camera by the angles (degrees) of photogrammetry, about x, the turned y and the turned z.

    With all angles 0 it looks down, columns to the east. Source: Kraus, Photogrammetry: Rx(omega) Ry(phi) Rz(kappa),
    its second and third axis turned round, since rows run downwards and the view away from the camera.
    """
    (so, co), (sp, cp), (sk, ck) = ((np.sin(angle), np.cos(angle)) for angle in np.radians([omega, phi, kappa]))
    about_x = np.array([[1, 0, 0], [0, co, -so], [0, so, co]])
    about_y = np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
    about_z = np.array([[ck, -sk, 0], [sk, ck, 0], [0, 0, 1]])
    turned: np.ndarray = about_x @ about_y @ about_z @ np.diag([1.0, -1.0, -1.0])
    return turned
