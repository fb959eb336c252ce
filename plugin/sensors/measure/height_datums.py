"""What heights refer to, and bringing them to the ellipsoid: by PROJ's grids, or by a grid file of one's own."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Union

import numpy as np
from osgeo import gdal

from ...imagery.errors import RasterError
from ...imagery.gdal_calls import gdal_silenced
from ...imagery.grids import PixelWindow
from ...imagery.message import Message
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import RasterRef
from ...imagery.reference_systems import (
    heights_above_ellipsoid,
    is_geographic,
    transform_points,
    vertical_code,
    vertical_part,
)
from . import limits, messages
from .ground_system import WGS84

AUTO, ELLIPSOID, EGM96, EGM2008, GEOID = limits.HEIGHT_DATUMS
VERTICAL = {EGM96: "EPSG:5773", EGM2008: "EPSG:3855"}
MAX_UNDULATION_M = 120.0  # the geoid stays within -107 and +86 m of the ellipsoid
TURN = 360.0  # degrees of longitude


@dataclass(frozen=True)
class Geoid:
    """A grid file of heights of sea level above the ellipsoid."""

    ref: RasterRef

    @property
    def name(self) -> str:
        """File name without its folder."""
        return self.ref.name

    def undulation(self, geographic: np.ndarray) -> np.ndarray:
        """(n,) m, bilinear, at longitudes and latitudes (n, 2 or more).

        Raises RasterError where the file is no such grid, or does not cover all places.
        """
        source = OpenRaster(self.ref)
        wkt, transform = source.raster.wkt or WGS84, source.raster.geotransform
        if transform is None or not source.raster.is_north_up:
            raise RasterError(messages.NO_GEOID(name=self.name))
        places = transform_points(geographic, WGS84, wkt)
        middle = transform[0] + transform[1] * source.columns / 2
        if is_geographic(wkt):  # from 0 to 360 degrees, or from -180 to 180
            places[:, 0] += TURN * np.round((middle - places[:, 0]) / TURN)
        column = (places[:, 0] - transform[0]) / transform[1] - 0.5
        row = (places[:, 1] - transform[3]) / transform[5] - 0.5
        round_earth = is_geographic(wkt) and abs(transform[1]) * source.columns >= TURN - 1e-6
        edge = 0.5 + 1e-6
        outside = (row < -edge) | (row > source.rows - 1 + edge)
        if not round_earth:
            outside |= (column < -edge) | (column > source.columns - 1 + edge)
            column = np.clip(column, 0, source.columns - 1)
        if outside.any():
            raise RasterError(messages.GEOID_NOT_COVERING(name=self.name))
        row = np.clip(row, 0, source.rows - 1)
        left, top = np.floor(column).astype(int), np.floor(row).astype(int)
        x, y = column - left, row - top
        right, bottom = left + 1, np.minimum(top + 1, source.rows - 1)
        if round_earth:
            period = round(TURN / abs(transform[1]))
            left, right = left % period, right % period
        else:
            right = np.minimum(right, source.columns - 1)
        first = int(min(left.min(), right.min())), int(top.min())
        grid = self._read(source, PixelWindow(
            *first, int(max(left.max(), right.max())) - first[0] + 1, int(bottom.max()) - first[1] + 1
        ))
        left, right, top, bottom = left - first[0], right - first[0], top - first[1], bottom - first[1]
        upper = grid[top, left] * (1 - x) + grid[top, right] * x
        lower = grid[bottom, left] * (1 - x) + grid[bottom, right] * x
        found: np.ndarray = upper * (1 - y) + lower * y
        if not np.isfinite(found).all():
            raise RasterError(messages.GEOID_NOT_COVERING(name=self.name))
        if np.abs(found).max(initial=0) > MAX_UNDULATION_M:
            raise RasterError(messages.NO_GEOID(name=self.name))
        return found

    def _read(self, source: OpenRaster, window: PixelWindow) -> np.ndarray:
        """(rows, columns) m; NaN where there are none."""
        with gdal_silenced():
            alone = gdal.Translate("", source.dataset, format="VRT", bandList=[1])
        block = OpenRaster(self.ref, alone).read(window)
        grid: np.ndarray = block.bands[0].astype(np.float64)
        grid[~block.valid] = np.nan
        return grid


Datum = Union[str, "Geoid"]  # in quotes: typing would else remember the class when QGIS unloads it
"""One of ``limits.HEIGHT_DATUMS`` but ``geoid``, or the grid of that."""


def vertical_system(wkt: str, datum: Datum, name: str) -> tuple[Datum, tuple[Message, ...]]:
    """What heights are to be converted from, empty for nothing, and what to say about it.

    ``wkt`` is the reference system that the heights come with.
    """
    if isinstance(datum, Geoid):
        return datum, ()
    if datum in VERTICAL:
        return VERTICAL[datum], ()
    if datum == ELLIPSOID:
        return "", ()
    part = vertical_part(wkt)
    if not part:
        return "", (messages.HEIGHTS_ASSUMED(name=name),)
    return ("" if part == "ellipsoid" else vertical_code(wkt)), ()


def above_ellipsoid(geographic: np.ndarray, vertical: Datum) -> np.ndarray:
    """Heights (n,) above the ellipsoid of (n, 3) longitude, latitude (WGS 84) and height; ``vertical`` is not empty.

    Raises RasterError where there is no grid to convert them by, and names the one that is there.
    """
    if isinstance(vertical, Geoid):
        moved: np.ndarray = geographic[:, 2] + vertical.undulation(geographic)
        return moved
    try:
        return heights_above_ellipsoid(geographic, vertical)
    except RasterError as error:
        there = [name for name, code in VERTICAL.items() if code != vertical and _has_grid(geographic[:1], code)]
        if not there:
            raise
        named = error.message.values.get("vertical", vertical)
        raise RasterError(messages.ANOTHER_GRID_IS_THERE(vertical=named, there=" or ".join(there))) from None


def _has_grid(geographic: np.ndarray, vertical: str) -> bool:
    try:
        heights_above_ellipsoid(geographic, vertical)
    except RasterError:
        return False
    return True


def heights_converted(added: np.ndarray, wkt: str, datum: Datum, name: str) -> Message:
    """What to say of heights that were brought to the ellipsoid by adding so much."""
    named = datum.name if isinstance(datum, Geoid) else datum if datum in VERTICAL else vertical_part(wkt)
    return messages.HEIGHTS_CONVERTED(name=name, vertical=named, least=float(added.min()), most=float(added.max()))
