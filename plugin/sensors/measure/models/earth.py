"""The ellipsoid WGS 84: geocentric coordinates and directions."""
from __future__ import annotations

import numpy as np

from .. import limits

WGS84_FLATTENING = 1 / 298.257223563

_SQUARED_ECCENTRICITY = WGS84_FLATTENING * (2 - WGS84_FLATTENING)


def geocentric(geographic: np.ndarray) -> np.ndarray:
    """(n, 3) longitude and latitude in degrees and height above the ellipsoid in m -> (n, 3) X, Y, Z in m."""
    longitude, latitude = np.radians(geographic[:, 0]), np.radians(geographic[:, 1])
    height = geographic[:, 2]
    prime_vertical = limits.WGS84_SEMI_MAJOR_M / np.sqrt(1 - _SQUARED_ECCENTRICITY * np.sin(latitude) ** 2)
    across = (prime_vertical + height) * np.cos(latitude)
    polar = (prime_vertical * (1 - _SQUARED_ECCENTRICITY) + height) * np.sin(latitude)
    return np.column_stack([across * np.cos(longitude), across * np.sin(longitude), polar])


def unit(vectors: np.ndarray) -> np.ndarray:
    """Vectors (..., 3) of length 1."""
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


def rotations(vectors: np.ndarray) -> np.ndarray:
    """Rotation vectors (n, 3) in radians -> (n, 3, 3) matrices, by Rodrigues' formula."""
    squared = np.sum(vectors**2, axis=1)
    angle = np.sqrt(squared)
    cross = np.zeros((len(vectors), 3, 3))
    cross[:, 0, 1], cross[:, 0, 2], cross[:, 1, 2] = -vectors[:, 2], vectors[:, 1], -vectors[:, 0]
    cross -= np.swapaxes(cross, 1, 2)
    first = np.sinc(angle / np.pi)
    second = 0.5 * np.sinc(angle / (2 * np.pi)) ** 2
    return np.eye(3) + first[:, None, None] * cross + second[:, None, None] * (cross @ cross)
