"""How obliquely an image was taken, and what errors of the terrain make of that."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...imagery.message import Message
from ...imagery.reference_systems import metres_per_unit
from . import messages
from .ground_system import WGS84
from .models.rpc import Domain, located
from .models.sensor_model import SensorModel

_RISE_M = 100.0  # between the two heights that a line of sight is taken at


@dataclass(frozen=True)
class ViewDirection:
    """The line of sight, at the ground."""

    angle: float
    """From the vertical, degrees, in the middle of the image."""
    azimuth: float
    """Where it was taken from, degrees from north over east."""
    largest: float
    """The largest angle from the vertical in the image's corners, degrees."""

    def shift_m(self, terrain_error_m: float) -> float:
        """How far an error in the terrain's heights moves the middle of the orthoimage, m."""
        return float(np.tan(np.radians(self.angle)) * abs(terrain_error_m))

    def told(self, terrain_error_m: float) -> Message:
        """In words, for an error of the terrain's heights."""
        return messages.VIEW_TOLD(
            angle=self.angle, azimuth=self.azimuth, largest=self.largest, error=terrain_error_m,
            shift=self.shift_m(terrain_error_m),
        )  # fmt: skip


def view_direction(model: SensorModel, wkt: str, domain: Domain) -> ViewDirection | None:
    """Of a model fitted to points of the system ``wkt``; None for a plane model, which knows none.

    Raises SensorModelError where the model can't be inverted over the image.
    """
    if not model.SPATIAL:
        return None
    (left, right), (top, bottom) = domain.columns, domain.rows
    image = [((left + right) / 2, (top + bottom) / 2), (left, top), (right, top), (left, bottom), (right, bottom)]
    height = float(np.mean(domain.heights))
    low, high = (
        located(model, wkt, np.column_stack([image, np.full(len(image), level)]), domain)
        for level in (height - _RISE_M / 2, height + _RISE_M / 2)
    )
    towards = (high - low)[:, :2] * metres_per_unit(WGS84, float(low[0, 1]))
    angles = np.degrees(np.arctan(np.linalg.norm(towards, axis=1) / _RISE_M))
    azimuth = float(np.degrees(np.arctan2(towards[0, 0], towards[0, 1])) % 360)
    return ViewDirection(float(angles[0]), azimuth, float(angles.max()))
