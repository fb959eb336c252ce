"""A part of a satellite image with its vendor's RPC, a terrain model, and points that a surveyor measured on both.

The RPC is off by a shift, as the RPCs of vendors are: the points tell it.
"""
from __future__ import annotations

import math
from pathlib import Path

import numpy as np
from osgeo import gdal, osr
from scipy import ndimage

from .files import Value, system, texture, write_layer, write_raster

COLUMNS, ROWS = 1200, 1000
PIXEL = 2.0  # m
UTM, WGS84 = 32634, 4326
MIDDLE = (420000.0, 5545000.0)  # m, UTM 34 N, south of Krakow
TERRAIN_PIXEL, REACH = 10.0, 2200.0  # m
LOWEST, HIGHEST = 240.0, 420.0  # m above the ellipsoid
TILT = math.radians(18)  # of the view, from the vertical to the west
SHIFT = (3.2, -2.1)  # px, columns and rows that the RPC is off by
POINTS, POINTED = 24, 0.3  # how many, standard deviation in the image (px)


def make_satellite_scene(folder: Path) -> None:
    """Write `image.tif`, `terrain.tif` and `points.gpkg`."""
    folder.mkdir(parents=True, exist_ok=True)
    random = np.random.default_rng(2003)
    cells = int(2 * REACH / TERRAIN_PIXEL)
    hills = ndimage.gaussian_filter(texture((cells, cells), 4, random), 3)
    heights = LOWEST + (HIGHEST - LOWEST) * (hills - hills.min()) / np.ptp(hills)
    left, top = MIDDLE[0] - REACH, MIDDLE[1] + REACH
    write_raster(folder / "terrain.tif", heights[np.newaxis].astype(np.float32), UTM, (left, top, TERRAIN_PIXEL))

    def height(ground: np.ndarray) -> np.ndarray:
        """Height of the terrain at (n, 2) places."""
        at = [(top - ground[:, 1]) / TERRAIN_PIXEL - 0.5, (ground[:, 0] - left) / TERRAIN_PIXEL - 0.5]
        return np.asarray(ndimage.map_coordinates(heights, at, order=1, mode="nearest"))

    rows, columns = np.mgrid[:ROWS, :COLUMNS] + 0.5
    ground = _ground(np.column_stack([columns.ravel(), rows.ravel()]), height)
    pixels = _seen(ground, random).reshape(ROWS, COLUMNS)
    write_raster(folder / "image.tif", pixels[np.newaxis])
    image = gdal.Open(str(folder / "image.tif"), gdal.GA_Update)
    image.SetMetadata(_rpc(), "RPC")
    image.FlushCache()

    places = _spread(random)
    there = _ground(places, height)
    pointed = places + random.normal(0, POINTED, places.shape)
    turned = np.array(osr.CoordinateTransformation(system(UTM), system(WGS84)).TransformPoints(there.tolist()))
    features: list[tuple[str, dict[str, Value]]] = []
    for number, ((x, y, _), z, (column, row)) in enumerate(zip(turned, height(there), pointed), 1):
        fields: dict[str, Value] = {"id": f"P{number:02d}", "column": float(column), "row": float(row), "z": float(z)}
        features.append((f"POINT ({x:.8f} {y:.8f})", fields))
    write_layer(folder / "points.gpkg", WGS84, features)


def _spread(random: np.random.Generator) -> np.ndarray:
    """Column and row of a point in each cell of a grid."""
    across = 6
    down = POINTS // across
    cells = np.array([(column, row) for row in range(down) for column in range(across)])
    return (cells + random.uniform(0.15, 0.85, cells.shape)) * [COLUMNS / across, ROWS / down]


def _ground(places: np.ndarray, height: object) -> np.ndarray:
    """(n, 2) places on the terrain that (n, 2) places in the image show."""
    assert callable(height)
    columns, rows = places.T
    found = np.column_stack([MIDDLE[0] + PIXEL * (columns - COLUMNS / 2), MIDDLE[1] - PIXEL * (rows - ROWS / 2)])
    flat = found.copy()
    for _ in range(12):  # the view is steeper than the slopes
        found[:, 0] = flat[:, 0] - math.tan(TILT) * (height(found) - (LOWEST + HIGHEST) / 2)
    return found


def _rpc() -> dict[str, str]:
    """The geometry as quotients, with the shift; to GDAL the middle of the first pixel is 0.

    The image is a parallel projection of UTM coordinates. These follow from longitude and latitude by polynomials to
    some millimetres, so the quotients are as good.
    """
    to_ground = osr.CoordinateTransformation(system(WGS84), system(UTM))
    back = osr.CoordinateTransformation(system(UTM), system(WGS84))
    longitude, latitude, _ = back.TransformPoint(*MIDDLE)
    reach = np.array([0.035, 0.025, 150.0])
    middle = np.array([longitude, latitude, (LOWEST + HIGHEST) / 2])
    axes = np.linspace(-1, 1, 9)
    scaled = np.array([(u, v, w) for u in axes for v in axes for w in axes])
    places = middle + scaled * reach
    ground = np.array(to_ground.TransformPoints(places[:, :2].tolist()))[:, :2]
    columns = COLUMNS / 2 + (ground[:, 0] - MIDDLE[0] + math.tan(TILT) * (places[:, 2] - middle[2])) / PIXEL
    rows = ROWS / 2 - (ground[:, 1] - MIDDLE[1]) / PIXEL
    u, v, w = scaled.T
    terms = np.column_stack([np.ones_like(u), u, v, w, u * v, u * w, v * w, u * u, v * v, w * w])  # as RPC00B has them
    half = np.array([COLUMNS / 2, ROWS / 2])
    numbers = {"LONG_OFF": middle[0], "LAT_OFF": middle[1], "HEIGHT_OFF": middle[2], "LONG_SCALE": reach[0],
               "LAT_SCALE": reach[1], "HEIGHT_SCALE": reach[2], "SAMP_OFF": half[0] - 0.5 + SHIFT[0],
               "LINE_OFF": half[1] - 0.5 + SHIFT[1], "SAMP_SCALE": half[0], "LINE_SCALE": half[1]}
    items = {name: f"{value:.12g}" for name, value in numbers.items()}
    for name, seen, middle_px in (("SAMP", columns, half[0]), ("LINE", rows, half[1])):
        fitted = np.linalg.lstsq(terms, (seen - middle_px) / middle_px, rcond=None)[0]
        items[f"{name}_NUM_COEFF"] = " ".join(f"{one:.15g}" for one in np.append(fitted, np.zeros(10)))
        items[f"{name}_DEN_COEFF"] = " ".join(["1"] + ["0"] * 19)
    return items


def _seen(ground: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Grey values of fields and woods at (n, 2) places."""
    cells = int(2 * REACH / PIXEL)
    fields = ndimage.zoom(random.uniform(-1, 1, (cells // 64 + 2,) * 2), 64, order=0)[:cells, :cells]
    picture = 120 + 25 * fields + 16 * texture((cells, cells), 2, random)
    at = [(MIDDLE[1] + REACH - ground[:, 1]) / PIXEL, (ground[:, 0] - MIDDLE[0] + REACH) / PIXEL]
    values = ndimage.map_coordinates(picture, at, order=1, mode="nearest")
    return np.clip(np.rint(values + random.normal(0, 1.5, values.shape)), 1, 255).astype(np.uint8)
