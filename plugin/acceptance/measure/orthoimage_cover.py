"""How much of its side of pieces of seam each orthoimage beside them shows, by the pixels that its file has.

A mosaic that was made of an orthoimage has its pixels where it shows it. Beyond the seam an orthoimage may end.
"""
from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from functools import cache, lru_cache
from pathlib import PureWindowsPath

import numpy as np
from scipy.ndimage import maximum_filter, minimum_filter

from ...imagery.errors import RasterError
from ...imagery.grids import PixelWindow, extents_meet
from ...imagery.lines import points_along
from ...imagery.open_raster import OpenRaster, describe
from ...imagery.raster_pool import KEPT_OPEN
from ...imagery.rasters import RasterRef
from ...imagery.reference_systems import extent_on, transform_points
from .delivery import DeliveredPiece, SeamCover, typical_m

COVERED = 0.9  # of its side of a piece, that an orthoimage shows: with less the mosaic has pixels that it has not
_STRIP_PX = 8  # on either side of a seam: what a scan judges by
_CELL_PX = 4  # of labels, which a seam may lie aside by, and of what is measured, where it is whole
_LEAST_PX, _SHORTER = 78.0, 0.75  # that scans make pieces long at least; times a typical one, less is a rest


def file_stem(name: str) -> str:
    """What files of one orthoimage are called alike; seamlines may name them with folders of any system."""
    return PureWindowsPath(name).stem.lower()


def seam_cover(
    pieces: Sequence[DeliveredPiece], wkt: str, mosaics: Sequence[str], paths: Sequence[str],
    not_given: Collection[str] = (),
) -> dict[int, SeamCover]:
    """Shares by the numbers of those pieces whose orthoimages can be read, where the mosaic has pixels itself.

    ``mosaics`` and ``paths``: of all; ``not_given``: names of those that the scan lacked. Where a piece that was not
    measured does not name both, they are those two that show most of it.
    """
    by_stem, opened = {file_stem(path): path for path in reversed(paths)}, lru_cache(KEPT_OPEN)(OpenRaster)
    described, missing = cache(lambda path: describe(RasterRef(path))), {*map(file_stem, not_given)}
    typical, cover = typical_m(pieces), dict[int, SeamCover]()

    def shown(files: Iterable[str], strip: np.ndarray) -> Iterator[np.ndarray]:
        for path in files:
            with suppress(RasterError):
                raster = described(path)
                extent = extent_on((*strip.min(axis=0), *strip.max(axis=0)), wkt, raster.wkt)
                yield _shown(opened(raster.ref), transform_points(strip, wkt, raster.wkt)) if (
                    extents_meet(extent, raster.extent)) else np.zeros((3, len(strip)), bool)

    for piece in pieces:
        is_blank = piece.kept_1 is None
        stems = [file_stem(name) for name in (piece.left_source, piece.right_source) if name]
        if is_blank and not missing.isdisjoint(stems):
            cover[piece.number] = SeamCover(0.0, 0.0)
            continue
        is_nameless = is_blank and len(stems) < 2
        beside = [*by_stem.values()] if is_nameless else [by_stem[stem] for stem in stems if stem in by_stem]
        with suppress(RasterError, IndexError):  # of the first, which says how large pixels are
            pixel_m = described(beside[0]).ground_sample_distance
            strip = _strip(piece, pixel_m)
            of_mosaics = [*shown(mosaics, strip)] if is_blank else []
            in_mosaic = np.any(of_mosaics or [np.ones((3, len(strip)), bool)], axis=0)
            known = in_mosaic[1] if in_mosaic[1].any() else slice(None)
            by_cover = sorted(shown(beside, strip[known]), key=lambda pixels: pixels[0].sum())
            less, most = by_cover[-2], by_cover[-1]
            side, both = min(2 * less[0].mean(), 1.0), (less[1] & most[1]).mean()
            rest = (less[2] & most[2]).mean() if piece.length_m < _SHORTER * typical else 1.0
            is_short = piece.length_m * in_mosaic[2].mean() * rest < _LEAST_PX * pixel_m
            is_short &= min(side, most[0].mean()) >= COVERED  # else nobody knows what is hidden
            cover[piece.number] = SeamCover(float(side), float(both), bool(is_short))
    return cover


def _strip(piece: DeliveredPiece, pixel_m: float) -> np.ndarray:
    """Places of the strip along a piece, (n, 2), a pixel apart, in its reference system."""
    pixel = pixel_m * float(np.hypot(*np.diff(piece.vertices, axis=0).T).sum()) / (piece.length_m or 1.0) or pixel_m
    course = points_along(piece.vertices, pixel)
    along = np.gradient(course, axis=0)
    normal = along[:, ::-1] * (1, -1) / np.maximum(np.hypot(*along.T), np.finfo(float).tiny)[:, np.newaxis]
    aside = (np.arange(-_STRIP_PX, _STRIP_PX) + 0.5) * pixel
    return (course[:, np.newaxis] + aside[:, np.newaxis] * normal[:, np.newaxis]).reshape(-1, 2)


def _shown(opened: OpenRaster, places: np.ndarray) -> np.ndarray:
    """Whether a raster has a pixel near a place, there, and all around it; (3, n) bool."""
    raster = opened.raster
    pixels = np.floor(raster.grid.to_pixels(places)).astype(int)
    left, top = (pixels.min(axis=0) - _CELL_PX).tolist()
    width, height = (pixels.max(axis=0) + _CELL_PX + 1 - (left, top)).tolist()
    inside = PixelWindow(left, top, width, height).cut_to(raster.columns, raster.rows)
    valid = np.zeros((height, width), bool)
    if inside.width and inside.height:
        valid[inside.row - top :, inside.column - left :][: inside.height, : inside.width] = opened.read(inside).valid
    columns, rows = (pixels - (left, top)).T
    masks = maximum_filter(valid, 2 * _CELL_PX + 1), valid, minimum_filter(valid, _CELL_PX + 1)
    return np.stack([mask[rows, columns] for mask in masks])
