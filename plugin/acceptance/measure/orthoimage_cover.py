"""How much of its side of pieces of seam each orthoimage beside them shows, by the pixels that its file has.

A mosaic that was made of an orthoimage has its pixels where it shows it. Beyond the seam an orthoimage may end.
"""
from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from contextlib import suppress
from functools import cache, lru_cache
from pathlib import PureWindowsPath
from typing import Callable

import numpy as np
from osgeo import ogr
from scipy.ndimage import maximum_filter

from ...imagery.errors import RasterError
from ...imagery.grids import PixelWindow
from ...imagery.lines import burnt, line_wkt
from ...imagery.open_raster import OpenRaster, describe
from ...imagery.raster_pool import KEPT_OPEN
from ...imagery.rasters import Raster, RasterRef
from ...imagery.reference_systems import transform_points
from .delivery import DeliveredPiece, SeamCover

COVERED = 0.9  # of its side of a piece, that an orthoimage shows: with less the mosaic has pixels that it has not
_STRIP_PX = 8.0  # on either side of a seam: what a scan judges by
_ASIDE_PX = 2  # that a seam may lie aside of where it was found
_LEAST_PX, _SHORTER = 62.5, 0.75  # of what is measured of a piece; times a typical one, less than which is a rest


def file_stem(name: str) -> str:
    """What files of one orthoimage are called alike; seamlines may name them with folders of any system."""
    return PureWindowsPath(name).stem.lower()


def seam_cover(
    pieces: Sequence[DeliveredPiece], wkt: str, paths: Iterable[str], not_given: Collection[str] = ()
) -> dict[int, SeamCover]:
    """Shares by the numbers of those pieces whose orthoimages can be read; ``paths``: of all; ``not_given``: names of
    those that the scan lacked.

    Where a piece that was not measured does not name both, they are those two that show most of it.
    """
    by_stem, opened = {file_stem(path): path for path in reversed([*paths])}, lru_cache(KEPT_OPEN)(OpenRaster)
    described, missing = cache(lambda path: describe(RasterRef(path))), {*map(file_stem, not_given)}
    typical_m = np.median([piece.length_m for piece in pieces]) if pieces else 0.0
    cover: dict[int, SeamCover] = {}
    for piece in pieces:
        names = [file_stem(name) for name in (piece.left_source, piece.right_source) if name]
        beside = [by_stem[name] for name in names if name in by_stem]
        lacks = piece.kept_1 is None and not missing.isdisjoint(names)
        if piece.kept_1 is None and len(names) < 2 and not lacks:
            beside = [*by_stem.values()]
        shares = [(0.0, 0.0, 0.0)] * 2 if lacks else []
        for path in beside:
            with suppress(RasterError):
                shares.append(_shown_shares(described(path), opened, piece.vertices, wkt))
        if len(shares) > 1:
            (less_near, less, pixel_m), (most_near, most, _) = sorted(shares)[-2:]
            both = max(less + most - 1, 0.0)
            shown_m = piece.length_m * (both if piece.length_m < _SHORTER * typical_m else 1.0)
            is_short = shown_m < _LEAST_PX * pixel_m
            cover[piece.number] = SeamCover(min(2 * less_near, 1.0), most_near, both, is_short)
    return cover


def _shown_shares(
    raster: Raster, opened: Callable[[RasterRef], OpenRaster], vertices: np.ndarray, wkt: str
) -> tuple[float, float, float]:
    """Shares of the strip along a line for which an orthoimage has pixels nearby, and there; metres of a pixel."""
    on_image = transform_points(vertices, wkt, raster.wkt)
    pixels = raster.grid.to_pixels(on_image)
    left, top = np.floor(pixels.min(axis=0) - _STRIP_PX).astype(int).tolist()
    width, height = (np.ceil(pixels.max(axis=0) + _STRIP_PX).astype(int) - (left, top)).tolist()
    around = PixelWindow(left, top, width, height)
    inside = around.cut_to(raster.columns, raster.rows)
    if not (inside.width > 0 and inside.height > 0):
        return 0.0, 0.0, raster.ground_sample_distance
    line = ogr.CreateGeometryFromWkt(line_wkt(on_image))
    strip = burnt([(line.Buffer(_STRIP_PX * raster.grid.pixel_width), 1)], raster.grid, around, 0) == 1
    valid = np.zeros(strip.shape, bool)
    valid[inside.row - top :, inside.column - left :][: inside.height, : inside.width] = (
        opened(raster.ref).read(inside).valid)
    near = maximum_filter(valid, 2 * _ASIDE_PX + 1)
    return float(near[strip].mean()), float(valid[strip].mean()), raster.ground_sample_distance
