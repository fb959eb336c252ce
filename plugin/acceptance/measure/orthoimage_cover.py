"""How much of its side of pieces of seam each orthoimage beside them shows, by the pixels that its file has.

A mosaic that was made of an orthoimage has its pixels where it shows it. Beyond the seam an orthoimage may end.
"""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress
from functools import lru_cache
from pathlib import PureWindowsPath

import numpy as np
from osgeo import ogr

from ...imagery.errors import RasterError
from ...imagery.grids import PixelWindow
from ...imagery.lines import burnt, line_wkt
from ...imagery.open_raster import OpenRaster
from ...imagery.raster_pool import KEPT_OPEN
from ...imagery.reference_systems import transform_points
from .delivery import DeliveredPiece

_STRIP_PX = 8.0  # on either side of a seam: what a scan judges by


def file_stem(name: str) -> str:
    """What files of one orthoimage are called alike; seamlines may name them with folders of any system."""
    return PureWindowsPath(name).stem.lower()


def seam_cover(pieces: Sequence[DeliveredPiece], wkt: str, paths: Iterable[str]) -> dict[int, tuple[float, float]]:
    """Shares, 0 to 1, by the numbers of those pieces whose two orthoimages can be read: of half of the strip, what the
    one shows that shows less; and of the strip, what both show at least.

    ``paths``: of all orthoimages.
    """
    by_stem, opened = {file_stem(path): path for path in paths}, lru_cache(KEPT_OPEN)(OpenRaster)
    cover: dict[int, tuple[float, float]] = {}
    for piece in pieces:
        beside = [by_stem.get(file_stem(name)) for name in (piece.left_source, piece.right_source)]
        with suppress(RasterError):
            shares = [_shown_share(opened(path), piece.vertices, wkt) for path in beside if path]
            if len(shares) == len(beside):
                cover[piece.number] = min(2 * min(shares), 1.0), max(sum(shares) - 1, 0.0)
    return cover


def _shown_share(image: OpenRaster, vertices: np.ndarray, wkt: str) -> float:
    """The share of the strip along a line for which an orthoimage has pixels."""
    raster = image.raster
    on_image = transform_points(vertices, wkt, raster.wkt)
    pixels = raster.grid.to_pixels(on_image)
    left, top = np.floor(pixels.min(axis=0) - _STRIP_PX).astype(int).tolist()
    width, height = (np.ceil(pixels.max(axis=0) + _STRIP_PX).astype(int) - (left, top)).tolist()
    around = PixelWindow(left, top, width, height)
    line = ogr.CreateGeometryFromWkt(line_wkt(on_image))
    strip = burnt([(line.Buffer(_STRIP_PX * raster.grid.pixel_width), 1)], raster.grid, around, 0) == 1
    inside = around.cut_to(raster.columns, raster.rows)
    if not (inside.width > 0 and inside.height > 0):
        return 0.0
    part = strip[inside.row - top :, inside.column - left :][: inside.height, : inside.width]
    return float((part & image.read(inside).valid).sum() / max(strip.sum(), 1))
