"""Reference systems: extents from one to another, and metres on the ground."""
from __future__ import annotations

import math
from contextlib import suppress

from osgeo import osr

from . import messages
from .errors import RasterError
from .quiet import quiet
from .windows import Extent


def extent_on(extent: Extent, wkt: str, target_wkt: str) -> Extent:
    """The bounding box, in the target reference system, of an extent in another one.

    Raises RasterError when the extent can't be transformed.
    """
    if _same_system(wkt, target_wkt):
        return extent
    with quiet():
        try:
            transform = osr.CoordinateTransformation(_system(wkt), _system(target_wkt))
            bounds = transform.TransformBounds(*extent, 21)
        except (RuntimeError, TypeError):  # TypeError: there is no transformation and GDAL's exceptions are off
            bounds = (math.inf,)
    if not all(map(math.isfinite, bounds)):
        raise RasterError(messages.EXTENT_NOT_TRANSFORMED())
    return tuple(bounds)


def same_coordinates(wkt: str, other: str, extent: Extent, tolerance: float) -> bool:
    """Whether coordinates inside an extent of one system mean the same place in another, however that is named."""
    if _same_system(wkt, other):
        return True
    try:
        moved = extent_on(extent, other, wkt)
    except RasterError:
        return False
    return max(abs(a - b) for a, b in zip(moved, extent)) <= tolerance


def metres_per_unit(wkt: str, y: float) -> tuple[float, float]:
    """Metres on the ground per map unit along x and y; for degrees on the ellipsoid at latitude ``y``."""
    if not wkt:
        return 1.0, 1.0
    system = _system(wkt)
    if not system.IsGeographic():
        return system.GetLinearUnits(), system.GetLinearUnits()
    semi_major, flattening = system.GetSemiMajor(), system.GetInvFlattening()
    squared_eccentricity = (2 - 1 / flattening) / flattening if flattening else 0.0
    unit = system.GetAngularUnits()
    sine, cosine = math.sin(y * unit), math.cos(y * unit)
    prime_vertical = semi_major / math.sqrt(1 - squared_eccentricity * sine**2)
    meridian = prime_vertical * (1 - squared_eccentricity) / (1 - squared_eccentricity * sine**2)
    return prime_vertical * cosine * unit, meridian * unit


def _system(wkt: str) -> osr.SpatialReference:
    system = osr.SpatialReference()
    with quiet(), suppress(RuntimeError):  # a text that means nothing leaves the system empty
        system.SetFromUserInput(wkt)
    system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return system


def _same_system(a: str, b: str) -> bool:
    return a == b or bool(_system(a).IsSame(_system(b)))
