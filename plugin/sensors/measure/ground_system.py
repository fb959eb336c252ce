"""The reference system that a model's ground coordinates are in."""
from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ...imagery.reference_systems import is_geographic, metres_per_unit, same_system, transform_points

WGS84 = "EPSG:4326"


@dataclass(frozen=True)
class GroundSystem:
    """Ground coordinates: x and y of a reference system and heights above the ellipsoid in m."""

    wkt: str
    """Anything that PROJ understands; x or longitude comes first."""

    @cached_property
    def is_wgs84(self) -> bool:
        """Whether x and y are longitude and latitude of WGS 84 already."""
        return is_geographic(self.wkt) and same_system(self.wkt, WGS84)

    def to_geographic(self, ground: np.ndarray) -> np.ndarray:
        """(n, 3) of this system -> (n, 3) longitude, latitude (WGS 84), height."""
        return ground if self.is_wgs84 else self._moved(ground, self.wkt, WGS84)

    def from_geographic(self, geographic: np.ndarray) -> np.ndarray:
        """(n, 3) longitude, latitude (WGS 84), height -> (n, 3) of this system."""
        return geographic if self.is_wgs84 else self._moved(geographic, WGS84, self.wkt)

    def metres(self, y: float) -> tuple[float, float]:
        """Metres on the ground per unit of x and of y."""
        return metres_per_unit(self.wkt, y)

    @staticmethod
    def _moved(ground: np.ndarray, wkt: str, target: str) -> np.ndarray:
        return np.column_stack([transform_points(ground, wkt, target), ground[:, 2]])


GEOGRAPHIC = GroundSystem(WGS84)
