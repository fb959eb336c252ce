"""Terrain heights above the ellipsoid, from a raster in any reference system or one constant height."""
from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from osgeo import gdal

from ...imagery import messages as imagery_messages
from ...imagery.errors import RasterError
from ...imagery.grids import Extent, PixelWindow
from ...imagery.message import Message
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import RasterRef
from ...imagery.reference_systems import extent_on, metres_per_unit, transform_points
from . import messages
from .ground_system import WGS84
from .height_datums import Datum, above_ellipsoid, heights_converted, vertical_system

MAX_DEM_PIXELS = 100_000_000  # 400 MB; 10 to 30 m meshes suffice (Kurczynski and Wolniewicz, conclusion 7)
LOWEST_M, HIGHEST_M = -12_000.0, 10_000.0  # the deepest sea, the highest mountain
UNDULATION_STEP_PX = 16  # of a terrain model: the geoid is smooth


@dataclass(frozen=True)
class Terrain:
    """Heights above the ellipsoid on a north-up grid."""

    name: str
    wkt: str
    origin: tuple[float, float]
    """x of the left and y of the upper edge."""
    step: tuple[float, float]
    """Map units per column and per row; the second is negative."""
    heights: np.ndarray
    """(rows, columns) float32, m; NaN where there are none."""
    notices: tuple[Message, ...]

    def mesh_m(self) -> tuple[float, float]:
        """The shorter and the longer side of a mesh on the ground, m."""
        middle = self.origin[1] + self.step[1] * self.heights.shape[0] / 2
        sides = np.abs(np.multiply(self.step, metres_per_unit(self.wkt, middle)))
        return float(sides.min()), float(sides.max())

    def at(self, geographic: np.ndarray) -> np.ndarray:
        """Bilinear heights (n,) at longitudes and latitudes (n, 2 or more); NaN where there are none."""
        places = transform_points(geographic, WGS84, self.wkt)
        columns = (places[:, 0] - self.origin[0]) / self.step[0] - 0.5
        rows = (places[:, 1] - self.origin[1]) / self.step[1] - 0.5
        last_row, last_column = self.heights.shape[0] - 1, self.heights.shape[1] - 1
        inside = (columns >= -0.5) & (rows >= -0.5) & (columns <= last_column + 0.5) & (rows <= last_row + 0.5)
        columns, rows = np.clip(columns, 0, last_column), np.clip(rows, 0, last_row)
        left, top = columns.astype(int), rows.astype(int)
        right, bottom = np.minimum(left + 1, last_column), np.minimum(top + 1, last_row)
        x, y = columns - left, rows - top
        upper = _mixed(self._height(top, left), self._height(top, right), x)
        lower = _mixed(self._height(bottom, left), self._height(bottom, right), x)
        return np.where(inside, _mixed(upper, lower, y), np.nan)

    def _height(self, rows: np.ndarray, columns: np.ndarray) -> np.ndarray:
        return self.heights[rows, columns].astype(np.float64)  # of the places alone, which are few


def _mixed(first: np.ndarray, second: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Between two values; the first alone where the second has no share, whatever it is."""
    return np.where(share > 0, first + (second - first) * share, first)


def constant_terrain(height: float, extent: Extent) -> Terrain:
    """A plane at a height above the ellipsoid, over longitudes and latitudes (west, south, east, north)."""
    west, south, east, north = extent
    step = ((east - west) / 2, (south - north) / 2)
    return Terrain("", WGS84, (west, north), step, np.full((2, 2), height, np.float32), ())


def load_terrain(ref: RasterRef, extent: Extent, datum: Datum) -> Terrain:
    """The heights of a raster over longitudes and latitudes (west, south, east, north), brought to the ellipsoid.

    Raises RasterError where the raster lies elsewhere, is rotated,
    has no reference system, is too large there, or where PROJ has no grid for its heights.
    """
    source = OpenRaster(ref)
    wkt, transform = source.raster.wkt, source.raster.geotransform
    if not wkt:
        raise RasterError(imagery_messages.NO_REFERENCE_SYSTEM(name=ref.name))
    if transform is None or not source.raster.is_north_up:
        raise RasterError(imagery_messages.NOT_NORTH_UP(name=ref.name))
    west, south, east, north = extent
    elsewhere = messages.DEM_NOT_COVERING(name=ref.name, west=west, east=east, south=south, north=north)
    try:
        xmin, ymin, xmax, ymax = extent_on(extent, WGS84, wkt)
    except RasterError:
        raise RasterError(elsewhere) from None
    left = max(int((xmin - transform[0]) / transform[1]) - 2, 0)
    top = max(int((ymax - transform[3]) / transform[5]) - 2, 0)
    right = min(int((xmax - transform[0]) / transform[1]) + 3, source.columns)
    bottom = min(int((ymin - transform[3]) / transform[5]) + 3, source.rows)
    if right <= left or bottom <= top:
        raise RasterError(elsewhere)
    count = (right - left) * (bottom - top)
    if count > MAX_DEM_PIXELS:
        most = MAX_DEM_PIXELS // 10**6
        raise RasterError(messages.DEM_TOO_LARGE(name=ref.name, count=count // 10**6, most=most))
    heights_alone = gdal.Translate("", source.dataset, format="VRT", bandList=[1])  # whatever the other bands are
    block = OpenRaster(ref, heights_alone).read(PixelWindow(left, top, right - left, bottom - top))
    band = source.dataset.GetRasterBand(1)
    heights = block.bands[0].astype(np.float32)
    heights *= np.float32(band.GetScale() or 1)
    heights += np.float32(band.GetOffset() or 0)
    heights[~block.valid] = np.nan
    if not block.valid.any():
        raise RasterError(elsewhere)
    low, high = float(np.nanmin(heights)), float(np.nanmax(heights))
    if low < LOWEST_M or high > HIGHEST_M:
        raise RasterError(messages.DEM_HEIGHTS_IMPLAUSIBLE(name=ref.name, low=low, high=high))
    origin = (transform[0] + left * transform[1], transform[3] + top * transform[5])
    found = Terrain(ref.name, wkt, origin, (transform[1], transform[5]), heights, ())
    return _above_ellipsoid(found, datum)


def _above_ellipsoid(terrain: Terrain, datum: Datum) -> Terrain:
    vertical, notices = vertical_system(terrain.wkt, datum, terrain.name)
    if not vertical:
        return replace(terrain, notices=notices)
    added = _add_undulation(terrain, vertical)
    return replace(terrain, notices=(heights_converted(added, terrain.wkt, datum, terrain.name),))


def _add_undulation(terrain: Terrain, vertical: Datum) -> np.ndarray:
    """Bring heights to the ellipsoid where they stand, by a coarse grid, since the geoid is smooth; that grid, m."""
    rows, columns = terrain.heights.shape
    step = UNDULATION_STEP_PX
    knots = [np.unique(np.append(np.arange(0, size, step), size - 1)) for size in (rows, columns)]
    row, column = np.meshgrid(*knots, indexing="ij")
    x = terrain.origin[0] + (column.ravel() + 0.5) * terrain.step[0]
    y = terrain.origin[1] + (row.ravel() + 0.5) * terrain.step[1]
    places = transform_points(np.column_stack([x, y]), terrain.wkt, WGS84)
    coarse = above_ellipsoid(np.column_stack([places, np.zeros(len(places))]), vertical).reshape(row.shape)
    along = np.array([np.interp(np.arange(columns), knots[1], line) for line in coarse], np.float32)
    for number in range(rows):
        upper = max(int(np.searchsorted(knots[0], number, "right")) - 1, 0)
        lower = min(upper + 1, len(knots[0]) - 1)
        share = (number - knots[0][upper]) / max(knots[0][lower] - knots[0][upper], 1)
        terrain.heights[number] += along[upper] + np.float32(share) * (along[lower] - along[upper])
    return coarse
