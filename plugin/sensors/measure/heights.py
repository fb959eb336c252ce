"""Heights above the ellipsoid: what heights refer to, terrain models, and the heights of points."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Union

import numpy as np
from osgeo import gdal, osr
from scipy.ndimage import map_coordinates

from ...imagery import messages as imagery_messages
from ...imagery.errors import Message, RasterError
from ...imagery.gdal_calls import gdal_silenced
from ...imagery.grids import Extent, PixelWindow
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import RasterRef
from ...imagery.reference_systems import extent_on, is_geographic, moved_points, spatial_reference, transform_points
from . import limits, messages
from .points import Points, check_heights
from .sensor_model import WGS84, Scaling, bounding_box, least_squares, reprojected

AUTO, ELLIPSOID, EGM96, EGM2008, GEOID = limits.HEIGHT_DATUMS
VERTICAL = {EGM96: "EPSG:5773", EGM2008: "EPSG:3855"}
MAX_UNDULATION_M = 120.0  # the geoid stays within -107 and +86 m of the ellipsoid
TURN = 360.0  # degrees of longitude
MAX_DEM_PIXELS = 100_000_000  # 400 MB; 10 to 30 m meshes suffice (Kurczynski and Wolniewicz, conclusion 7)
UNDULATION_STEP_PX = 16  # of a terrain model: the geoid is smooth
FLAT_SHARE = 0.5  # of a pixel: heights that move the image by less make flat terrain


def undulation(grid: RasterRef, geographic: np.ndarray) -> np.ndarray:
    """(n,) m of sea level above the ellipsoid by a grid file, bilinear, at (n, 2 or more) longitude, latitude. Raises
    RasterError where the grid has none."""
    source = OpenRaster(grid)
    wkt, transform = source.raster.wkt or WGS84, source.raster.geotransform
    if transform is None or not source.raster.is_north_up:
        raise RasterError(messages.NO_GEOID(name=grid.name))
    places = transform_points(geographic, WGS84, wkt)
    around = 0  # columns of a grid that goes around the Earth
    if is_geographic(wkt):  # from 0 to 360 degrees, or from -180 to 180
        middle = transform[0] + transform[1] * source.columns / 2
        places[:, 0] += TURN * np.round((middle - places[:, 0]) / TURN)
        around = round(TURN / abs(transform[1])) if abs(transform[1]) * source.columns >= TURN - 1e-6 else 0
    column, row = grid_places(places, transform[0::3], transform[1::4]).T
    column = column % around if around else column
    last = np.array([source.columns - 1, source.rows - 1])
    inside = np.clip(np.column_stack([column, row]), 0, [around or last[0], last[1]])
    if np.abs(inside - np.column_stack([column, row])).max(initial=0) > 0.5 + 1e-6:
        raise RasterError(messages.GEOID_NOT_COVERING(name=grid.name))
    top, bottom = int(inside[:, 1].min()), min(int(inside[:, 1].max()) + 2, source.rows)
    values = first_band(source, PixelWindow(0, top, source.columns, bottom - top))
    values = np.pad(values, ((0, 0), (0, 1)), mode="wrap") if around else values
    heights = bilinear(values, *(inside - [0, top]).T)
    if not np.isfinite(heights).all():
        raise RasterError(messages.GEOID_NOT_COVERING(name=grid.name))
    if np.abs(heights).max(initial=0) > MAX_UNDULATION_M:
        raise RasterError(messages.NO_GEOID(name=grid.name))
    return heights


def first_band(source: OpenRaster, window: PixelWindow, size: tuple[int, int] | None = None) -> np.ndarray:
    """(rows, columns) float32 of a window or ``size`` (columns, rows) of it, scaled as the file says; NaN without."""
    with gdal_silenced():
        alone = gdal.Translate("", source.dataset, format="VRT", bandList=[1])  # whatever the other bands are
    block, band = OpenRaster(source.ref, alone).read(window, size), source.dataset.GetRasterBand(1)
    heights = block.bands[0].astype(np.float32)
    with np.errstate(invalid="ignore", over="ignore"):  # broken files hold infinite heights; those are implausible
        heights *= np.float32(band.GetScale() or 1)
        heights += np.float32(band.GetOffset() or 0)
    heights[~block.valid] = np.nan
    return heights


def grid_places(places: np.ndarray, origin: Sequence[float], step: Sequence[float]) -> np.ndarray:
    """(n, 2) columns and rows of x and y (n, 2) in a grid, (0, 0) the middle of its first pixel."""
    return np.asarray((places[:, :2] - origin) / step - 0.5)


def bilinear(grid: np.ndarray, columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """(n,) float64 at places in a grid, (0, 0) its first value; NaN beside one that is NaN."""
    return map_coordinates(grid, [rows, columns], np.float64, order=1, mode="nearest")


Datum = Union[str, "RasterRef"]  # in quotes: typing would else remember the class when QGIS unloads it
"""One of ``limits.HEIGHT_DATUMS`` but ``geoid``, or the grid of that."""


def above_ellipsoid(geographic: np.ndarray, vertical: Datum) -> np.ndarray:
    """Heights (n,) above the ellipsoid of (n, 3) longitude, latitude (WGS 84) and height in a vertical system.

    ``vertical`` is ``EPSG:`` and a code, WKT of a compound system, or a grid. Raises RasterError where PROJ has none.
    """
    if isinstance(vertical, RasterRef):
        return np.asarray(geographic[:, 2] + undulation(vertical, geographic))
    source = spatial_reference(f"EPSG:4326+{vertical[5:]}" if vertical.startswith("EPSG:") else vertical)
    options = osr.CoordinateTransformationOptions()
    options.SetBallparkAllowed(False)
    ellipsoid = spatial_reference("EPSG:4979")
    moved = moved_points(lambda: osr.CoordinateTransformation(source, ellipsoid, options), geographic)
    if moved is None:
        raise RasterError(imagery_messages.NO_GEOID_GRID(vertical=source.GetName() or vertical))
    return moved[:, 2]


def converted(geographic: np.ndarray, wkt: str, datum: Datum, name: str) -> tuple[np.ndarray, tuple[Message, ...]]:
    """Heights (n,) above the ellipsoid of (n, 3) longitude, latitude and height in ``datum``, which may be what the
    system ``wkt`` says, and what to say about it. Raises RasterError without a grid."""
    heights, system, vertical = geographic[:, 2], spatial_reference(wkt), VERTICAL.get(str(datum), datum)
    named = datum.name if isinstance(datum, RasterRef) else datum
    if datum == AUTO:
        code = system.GetAuthorityCode("COMPD_CS|VERT_CS")
        vertical = f"EPSG:{code}" if code else wkt
        named = str(system.GetAttrValue("VERT_CS") or system.GetAttrValue("VERTCRS") or "")
        if not system.IsCompound():
            named = ELLIPSOID if system.IsGeographic() and system.GetAxesCount() == 3 else ""
    if not named:
        return heights, (messages.HEIGHTS_ASSUMED(name=name),)
    if named == ELLIPSOID:
        return heights, ()
    moved = above_ellipsoid(geographic, vertical)
    least, most = float((moved - heights).min()), float((moved - heights).max())
    return moved, (messages.HEIGHTS_CONVERTED(name=name, vertical=named, least=least, most=most),)


@dataclass(frozen=True)
class Terrain:
    """Heights above the ellipsoid on a north-up grid."""

    name: str
    wkt: str
    origin: tuple[float, float]  # x of the left and y of the upper edge
    step: tuple[float, float]  # map units per column and per row; the second is negative
    heights: np.ndarray  # (rows, columns) float32, m; NaN where there are none
    notices: tuple[Message, ...]

    def at(self, geographic: np.ndarray) -> np.ndarray:
        """Bilinear heights (n,) at longitudes and latitudes (n, 2 or more); NaN where there are none."""
        places = grid_places(transform_points(geographic, WGS84, self.wkt), self.origin, self.step)
        inside = np.clip(places, 0, np.array(self.heights.shape[::-1]) - 1)
        known = (np.abs(inside - places) <= 0.5).all(axis=1)
        return np.where(known, bilinear(self.heights, *inside.T), np.nan)


def load_terrain(ref: RasterRef, extent: Extent, datum: Datum) -> Terrain:
    """The heights of a raster over longitudes and latitudes (west, south, east, north), brought to the ellipsoid.
    Raises RasterError for a raster that can't be used there, or without a grid for its heights."""
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
    left, right = (int((x - transform[0]) / transform[1]) for x in (xmin, xmax))
    top, bottom = (int((y - transform[3]) / transform[5]) for y in (ymax, ymin))
    around = PixelWindow(left - 2, top - 2, right - left + 5, bottom - top + 5)
    window = around.cut_to(source.columns, source.rows)
    if window.width <= 0 or window.height <= 0:
        raise RasterError(elsewhere)
    count, most = window.width * window.height, MAX_DEM_PIXELS
    if count > most:
        raise RasterError(messages.DEM_TOO_LARGE(name=ref.name, count=count // 10**6, most=most // 10**6))
    heights = first_band(source, window)
    if np.isnan(heights).all():
        raise RasterError(elsewhere)
    check_heights(float(np.nanmin(heights)), float(np.nanmax(heights)), ref.name)
    origin = (transform[0] + window.column * transform[1], transform[3] + window.row * transform[5])
    terrain = Terrain(ref.name, wkt, origin, (transform[1], transform[5]), heights, ())
    return replace(terrain, notices=_brought_to_ellipsoid(terrain, datum))


def _brought_to_ellipsoid(terrain: Terrain, datum: Datum) -> tuple[Message, ...]:
    """Bring heights to the ellipsoid in place, by a coarse grid, since the geoid is smooth; what to say about it."""
    step, sides = UNDULATION_STEP_PX, terrain.heights.shape
    knots = [np.unique(np.append(np.arange(0, side, step), side - 1)) for side in sides]
    row, column = np.meshgrid(*knots, indexing="ij")
    pixels = np.column_stack([column.ravel(), row.ravel()]) + 0.5
    places = transform_points(terrain.origin + pixels * terrain.step, terrain.wkt, WGS84)
    added, notices = converted(np.column_stack([places, np.zeros(len(places))]), terrain.wkt, datum, terrain.name)
    if not added.any():
        return notices
    coarse = added.reshape(row.shape)
    down, across = (np.interp(np.arange(side), at, np.arange(len(at))) for side, at in zip(sides, knots))
    for heights, place in zip(terrain.heights, down):
        heights += bilinear(coarse, across, np.full(len(across), place))
    return notices


def with_heights(
    points: Points, datum: Datum, dem: RasterRef | None, dem_datum: Datum, name: str
) -> tuple[Points, list[Message]]:
    """Points with heights above the ellipsoid, and what to say about them. Given heights refer to ``datum``, others are
    the terrain model's; points without any are left out where others have one. Raises RasterError."""
    notices: list[Message] = []
    heights = points.ground[:, 2].copy()
    given = np.isfinite(heights)
    geographic = reprojected(np.nan_to_num(points.ground), points.wkt, WGS84)
    if given.any():
        heights[given], said = converted(geographic[given], points.heights_wkt or points.wkt, datum, name)
        notices += said
    if dem is not None and not given.all():
        terrain = load_terrain(dem, bounding_box(geographic), dem_datum)
        notices += terrain.notices
        heights[~given] = terrain.at(geographic[~given])
    without = ~np.isfinite(heights)
    if without.any() and (dem is not None or given.any()):  # where no point has one, only models in space are lost
        why = messages.POINT_WITHOUT_HEIGHT()
        notices += [messages.POINT_LEFT_OUT(name=point, why=why) for point, gone in zip(points.ids, without) if gone]
        points, heights = points.only(~without), heights[~without]
    return replace(points, ground=np.column_stack([points.ground[:, :2], heights])), notices


def is_flat(points: Points) -> bool:
    """Whether the points' heights move their images by less than half a pixel, by an affine camera through them."""
    heights = points.ground[:, 2]
    if not np.isfinite(heights).all() or np.ptp(heights) == 0:
        return True  # where heights are not known, nothing but a plane model can be fitted
    scaled = Scaling.of(points.ground).to(points.ground)
    affine, _ = least_squares(np.column_stack([np.ones(len(scaled)), scaled]), points.image)
    return bool(2 * np.linalg.norm(affine[3]) < FLAT_SHARE)
