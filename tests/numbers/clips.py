"""What the tests of rasters share."""
from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from osgeo import gdal, osr
from seam_inspector.plugin.imagery.clips import Clip, read_clip
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef

from tests.numbers.synthetic import ORIGIN, UTM33, wkt

MakeRaster = Callable[..., str]
SIZE = (256, 256)
WINDOW = PixelWindow(96, 80, 64, 64)
RED, GREEN, BLUE = gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand
GRAY, ALPHA, UNDEFINED = gdal.GCI_GrayIndex, gdal.GCI_AlphaBand, gdal.GCI_Undefined
YELLOW, CYAN = gdal.GCI_YellowBand, gdal.GCI_CyanBand


def clip_of(
    path: str, mosaic: Raster, window: PixelWindow = WINDOW, system: str = "", nodata: float | None = None,
    partly: bool = False,
) -> Clip:
    return read_clip(OpenRaster(RasterRef(path, system, nodata=nodata)), mosaic, window, partly)


def inside(array: np.ndarray, window: PixelWindow = WINDOW) -> np.ndarray:
    return array[..., window.row : window.row + window.height, window.column : window.column + window.width]


def scene(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """A smooth scene by coordinates of the mosaic's reference system."""
    right, up = x - ORIGIN[0], y - ORIGIN[1]
    waves = 60 * np.sin(2 * np.pi * right / 3.1) * np.cos(2 * np.pi * up / 4.3)
    return np.asarray(120 + waves + 30 * np.sin(2 * np.pi * (right + 2 * up) / 5.7))


def scene_raster(
    make_raster: MakeRaster,
    gsd: float = 0.1,
    turn_deg: float = 0.0,
    mirror: tuple[int, int] = (1, 1),
    system: int = UTM33,
    side_m: float = 10.0,
    **options: Any,
) -> str:
    """The scene as a float32 raster in any reference system, about the middle of WINDOW, turned and mirrored."""
    to_mosaic = osr.CoordinateTransformation(reference(system), reference(UTM33))
    to_system = osr.CoordinateTransformation(reference(UTM33), reference(system))
    x0, y0, _ = to_system.TransformPoint(ORIGIN[0] + 12.8, ORIGIN[1] - 11.2)
    side = round(side_m / gsd)
    cosine, sine = gsd * math.cos(math.radians(turn_deg)), gsd * math.sin(math.radians(turn_deg))
    a, b, d, e = mirror[0] * cosine, mirror[1] * sine, mirror[0] * sine, -mirror[1] * cosine
    geotransform = (x0 - (a + b) * side / 2, a, b, y0 - (d + e) * side / 2, d, e)
    row, column = np.mgrid[:side, :side] + 0.5
    x, y = geotransform[0] + a * column + b * row, geotransform[3] + d * column + e * row
    points = to_mosaic.TransformPoints(np.column_stack([x.ravel(), y.ravel()]).tolist())
    placed = np.array(points)[:, :2].reshape(side, side, 2)
    image = scene(placed[..., 0], placed[..., 1]).astype(np.float32)
    return make_raster("source.tif", image, geotransform=geotransform, system=system, **options)


def reference(system: int | str) -> osr.SpatialReference:
    made = osr.SpatialReference()
    made.SetFromUserInput(wkt(system))
    made.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return made


STRETCHING: dict[str, tuple[int | str, float, float]] = {
    "Web Mercator": (3857, 7.0, 46.85),
    "UTM off its zone": (32633, 9.0, 50.0),
    "Lambert": (2154, -4.0, 48.0),
    "Poland": (2180, 14.2, 53.9),
    "feet": (2263, -74.0, 40.7),
    "feet of California": (2225, -122.0, 40.5),
    "kilometres": ("+proj=utm +zone=33 +datum=WGS84 +units=km", 15.0, 50.0),
}
"""Systems that show lengths longer or shorter than they are on the ground, each with a longitude and a latitude."""


def metres_by_arcs(system: str | int, longitude: float, latitude: float) -> tuple[tuple[float, float], float, float]:
    """A place on the map, and metres per unit there along the parallel and the meridian: arcs of the ellipsoid of some
    100 m over their lengths on the map."""
    to_map = osr.CoordinateTransformation(reference(4326), reference(system))
    step = math.radians(1e-3)
    sine = math.sin(math.radians(latitude))
    vertical = 6378137 / math.sqrt(1 - 0.0066943799901413 * sine**2)
    meridian = vertical * (1 - 0.0066943799901413) / (1 - 0.0066943799901413 * sine**2)
    lengths = []
    for dx, dy in ((5e-4, 0), (0, 5e-4)):
        ends = [to_map.TransformPoint(longitude + sign * dx, latitude + sign * dy)[:2] for sign in (-1, 1)]
        lengths.append(math.dist(*ends))
    x, y, _ = to_map.TransformPoint(longitude, latitude)
    return (x, y), vertical * math.sqrt(1 - sine**2) * step / lengths[0], meridian * step / lengths[1]
