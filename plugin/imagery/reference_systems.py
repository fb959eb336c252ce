"""Reference systems: extents from one to another, and metres on the ground."""
from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress
from functools import lru_cache
from typing import Any, Callable

import numpy as np
from osgeo import ogr, osr

from . import messages
from .errors import Message, RasterError, SettingsError
from .gdal_calls import gdal_silenced
from .grids import Extent


def extent_on(extent: Extent, wkt: str, target_wkt: str) -> Extent:
    """The bounding box of an extent in the target reference system. Raises RasterError when it can't be transformed."""
    if same_system(wkt, target_wkt):
        return extent
    bounds = _moved(lambda: _transformation(wkt, target_wkt).TransformBounds(*extent, 21))
    if bounds is None:
        raise RasterError(messages.EXTENT_NOT_TRANSFORMED())
    return tuple(bounds.tolist())


def geometry_on(geometry: ogr.Geometry, wkt: str, target_wkt: str) -> ogr.Geometry:
    """A geometry in the target reference system. Raises RasterError when it can't be transformed."""
    if same_system(wkt, target_wkt):
        return geometry
    moved = geometry.Clone()
    if _moved(lambda: moved.Transform(_transformation(wkt, target_wkt))) != ogr.OGRERR_NONE:
        raise RasterError(messages.EXTENT_NOT_TRANSFORMED())
    return moved


def _moved(transform: Callable[[], Any]) -> np.ndarray | None:
    """Numbers that a transformation gives; None where PROJ knows none, or it fails."""
    # RuntimeError with GDAL's exceptions, the others without them.
    with gdal_silenced(), suppress(RuntimeError, TypeError, AttributeError, ValueError, IndexError):
        moved = np.array(transform(), float)
        return moved if moved.size and np.isfinite(moved).all() else None
    return None


def _transformation(wkt: str, target_wkt: str) -> osr.CoordinateTransformation:
    return osr.CoordinateTransformation(_horizontal(wkt), _horizontal(target_wkt))


def same_coordinates(wkt: str, other: str, extent: Extent, tolerance: float) -> bool:
    """Whether coordinates inside an extent of one system mean the same place in another, however that is named."""
    if same_system(wkt, other):
        return True
    try:
        moved = extent_on(extent, other, wkt)
    except RasterError:
        return False
    return max(abs(a - b) for a, b in zip(moved, extent)) <= tolerance


_HALF_STEP = 1e-4
"""Radians, 640 m, over which a scale is taken: PROJ's own 1e-10 is a millionth of it, the change of the scale less."""


def metres_per_unit(wkt: str, place: Sequence[float]) -> tuple[float, float]:
    """Metres on the ground (the ellipsoid) per map unit along x and y at a place (x, y); NaN where the system describes
    none there. Map units are metres where there is no system, or one of a site."""
    system = _horizontal(wkt)
    geographic = system.CloneGeogCS() if system.IsProjected() else system
    if geographic is None or not geographic.IsGeographic():
        return (system.GetLinearUnits(),) * 2
    unit = system.GetLinearUnits() / geographic.GetSemiMajor() if system.IsProjected() else system.GetAngularUnits()
    half = _HALF_STEP / unit
    ends = np.add((*place[:2], 0.0), np.array([(-half, 0, 0), (half, 0, 0), (0, -half, 0), (0, half, 0)]))
    geocentric = osr.SpatialReference()
    geocentric.SetGeocCS("")
    geocentric.CopyGeogCSFrom(geographic)
    spatial = moved_points(lambda: osr.CoordinateTransformation(system, geocentric), ends)
    if spatial is None:
        return math.nan, math.nan
    metres = np.linalg.norm(spatial[1::2] - spatial[::2], axis=1) / (2 * half)
    return float(metres[0]), float(metres[1])


def spatial_reference(wkt: str) -> osr.SpatialReference:
    """What a text names, x or longitude first; an empty one where it names nothing."""
    system = osr.SpatialReference()
    with gdal_silenced(), suppress(RuntimeError):
        system.SetFromUserInput(wkt)
    system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return system


@lru_cache(1024)
def same_system(a: str, b: str) -> bool:
    """Whether two texts name one reference system, whatever they say of heights."""
    return a == b or bool(a and b and _horizontal(a).IsSame(_horizontal(b)))  # newer GDAL: all that are empty are one


def known_wkt(name: Any) -> str:
    """WKT of what names a reference system on the map: a text, a number of EPSG, or an object with ``to_wkt``, as
    rasterio's and pyproj's; empty for an empty text or None. Raises SettingsError for what names none."""
    text = "" if name is None else str(name.to_wkt() if hasattr(name, "to_wkt") else name)
    if not text:
        return ""
    system = spatial_reference(f"EPSG:{text}" if text.isdecimal() else text)
    if not (system.IsProjected() or system.IsGeographic()):
        raise SettingsError(messages.NO_SYSTEM(text=text))
    return str(system.ExportToWkt())


def system_name(wkt: str) -> str:
    """What people call a reference system, its authority's code first where it has one."""
    return " ".join(filter(None, [authority_code(wkt), spatial_reference(wkt).GetName()]))


def other_system(name: str, of_file: str, taken: str) -> tuple[Message, ...]:
    """What to say of a raster whose file names another reference system than the one it is taken in."""
    return (messages.OTHER_SYSTEM_TAKEN(name=name, system=system_name(taken), own=system_name(of_file)),)


def transform_points(points: np.ndarray, wkt: str, target_wkt: str) -> np.ndarray:
    """Horizontal coordinates (n, 2), x or longitude first, in another reference system. Heights play no part.

    Raises RasterError when there is no transformation or a point has no place in the target.
    """
    if same_system(wkt, target_wkt) or not len(points):
        return np.array(points[:, :2], float)
    moved = moved_points(lambda: _transformation(wkt, target_wkt), points[:, :2])
    if moved is None:
        raise RasterError(messages.EXTENT_NOT_TRANSFORMED())
    return moved[:, :2]


def moved_points(transformation: Callable[[], osr.CoordinateTransformation], points: np.ndarray) -> np.ndarray | None:
    """Points (n, 3) of points (n, 2) or (n, 3); None where one of them has no place."""
    return _moved(lambda: transformation().TransformPoints(points.tolist()))


def authority_code(wkt: str) -> str:
    """What an authority calls a reference system, such as ``EPSG:2180``; empty for one that none names."""
    system = spatial_reference(wkt)
    name, code = system.GetAuthorityName(None), system.GetAuthorityCode(None)
    return f"{name}:{code}" if name and code else ""


def is_geographic(wkt: str) -> bool:
    """Whether coordinates are degrees of longitude and latitude."""
    return bool(spatial_reference(wkt).IsGeographic())


def utm_wkt(longitude: float, latitude: float) -> str:
    """The UTM zone (WGS 84) of a place."""
    code = (32600 if latitude >= 0 else 32700) + int((longitude + 180) % 360 // 6) + 1
    return str(spatial_reference(f"EPSG:{code}").ExportToWkt())


def horizontal_wkt(wkt: str) -> str:
    """A reference system without its heights."""
    return str(_horizontal(wkt).ExportToWkt())


def _horizontal(wkt: str) -> osr.SpatialReference:
    system = spatial_reference(wkt)
    if system.IsCompound():
        system.StripVertical()
    if system.GetAxesCount() == 3:
        system.DemoteTo2D()
    system.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return system
