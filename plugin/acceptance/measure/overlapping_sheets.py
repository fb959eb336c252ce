"""Sheets that hide each other: where two overlap a mosaic shows one of them, so both have to show the same."""
from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Callable

import numpy as np

from ...imagery.errors import RasterError
from ...imagery.grids import PixelWindow
from ...imagery.open_raster import OpenRaster
from ...imagery.raster_pool import KEPT_OPEN
from ...imagery.rasters import Raster, RasterRef

AT_ONCE = 1 << 22  # pixels that are read at once
_LEAST_PX = 2.0  # of an overlap: what is narrower comes of outlines that are drawn on the ground, not on pixels
_MOST_ASIDE = 0.05  # of a pixel, that grids may lie beside each other
_LOOKED_AT = 1 << 27  # pixels of which a file is asked at once whether it has any
_COARSE_PX, _CELL_PX = 4, 64
_LOSSY_WHITE, _LOSSY_SHARE, _LOSSY_DETAIL = 2 / 255, 0.15, 2.5
"""What compression of one scene may make of it, JPEG of quality 60 and 90: means of 4 px differ in a cell by so much of
the brightest value and of their own standard deviation (0.11 of it, an image that is moved by a pixel by 0.4), the
energies of the finest detail by such a factor (2.1, and 4 in the median where it was blurred by 0.6 px)."""
_LEAST_DETAIL = 8 / 255**2
"""Energy of the finest detail, of the brightest value squared, that is no more than rounding and noise."""


def overlapping_otherwise(rasters: Sequence[Raster], tell: Callable[[float], None]) -> list[list[int]]:
    """For each raster, all of one reference system and pixel size, the numbers of those that show something else where
    both have pixels.

    Files compressed with loss may differ by that. ``tell``: is told the share that is done; what it raises ends the
    look.
    """
    others: list[list[int]] = [[] for _ in rasters]
    edges = np.array([raster.extent for raster in rasters]).reshape(-1, 4)
    least = np.array([_LEAST_PX * raster.grid.pixel_width for raster in rasters])
    opened = lru_cache(KEPT_OPEN)(OpenRaster)
    for number, raster in enumerate(rasters):
        tell(number / len(rasters))
        left, bottom, right, top = edges[number]
        width = np.minimum(edges[:, 2], right) - np.maximum(edges[:, 0], left)
        height = np.minimum(edges[:, 3], top) - np.maximum(edges[:, 1], bottom)
        for other in np.flatnonzero((width > least) & (height > least)).tolist():
            if other > number and _differ(raster, rasters[other], opened):
                others[number].append(other)
                others[other].append(number)
    return others


def _differ(raster: Raster, other: Raster, opened: Callable[[RasterRef], OpenRaster]) -> bool:
    """Whether two rasters show different things; not where one of them can't be read, which is told elsewhere."""
    grid, (left, bottom, right, top) = raster.grid, other.extent
    aside = [grid.column_at(left), grid.column_at(right) - other.columns]
    aside += [grid.row_at(top), grid.row_at(bottom) - other.rows]
    columns, rows = round(aside[0]), round(aside[2])
    if max(abs(place - whole) for place, whole in zip(aside, (columns, columns, rows, rows))) > _MOST_ASIDE:
        return True
    shared = PixelWindow(columns, rows, other.columns, other.rows).cut_to(raster.columns, raster.rows)
    is_lossy = raster.is_lossy or other.is_lossy
    try:
        first, second = opened(raster.ref), opened(other.ref)

        def has_any(window: PixelWindow) -> bool:
            return bool(first.stored_share(window) or second.stored_share(window.moved_by(-columns, -rows)))

        parts = filter(has_any, first.blocks(shared, _LOOKED_AT))
        for window in filter(has_any, (window for part in parts for window in first.blocks(part, AT_ONCE))):
            mine, theirs = first.read(window), second.read(window.moved_by(-columns, -rows))
            valid = mine.valid & theirs.valid
            if (_differ_much if is_lossy else _differ_at_all)(mine.bands, theirs.bands, valid):
                return True
    except RasterError:
        pass
    return False


def _differ_at_all(mine: np.ndarray, theirs: np.ndarray, valid: np.ndarray) -> bool:
    return bool(((mine != theirs).any(axis=0) & valid).any())


def _differ_much(mine: np.ndarray, theirs: np.ndarray, valid: np.ndarray) -> bool:
    """Whether any cell differs by more than compression does: what it shows, or how much detail it has."""
    images = [np.where(valid, image, 0).astype(np.float32) for image in (mine, theirs)]
    white = max(float(image.max(initial=0)) for image in images)
    coarse, their_coarse = (_means(image, _COARSE_PX) for image in images)
    cell = _CELL_PX // _COARSE_PX
    difference = np.sqrt(_means((coarse - their_coarse) ** 2, cell))
    deviation = np.sqrt(np.maximum(_means(coarse**2, cell) - _means(coarse, cell) ** 2, 0))
    if (difference > _LOSSY_WHITE * white + _LOSSY_SHARE * deviation).any():
        return True
    detail, their_detail = (_means(_detail(image), _CELL_PX) + _LEAST_DETAIL * white**2 for image in images)
    return bool((np.maximum(detail, their_detail) > _LOSSY_DETAIL * np.minimum(detail, their_detail)).any())


def _means(values: np.ndarray, side: int) -> np.ndarray:
    """Means of squares of ``side`` px, those at the edge smaller, (..., rows, columns)."""
    rows, columns = (np.arange(0, length, side) for length in values.shape[-2:])
    sums = np.add.reduceat(np.add.reduceat(values, rows, axis=-2), columns, axis=-1)
    high, wide = (np.diff(np.append(first, length)) for first, length in zip((rows, columns), values.shape[-2:]))
    return np.asarray(sums / (high[:, np.newaxis] * wide))


def _detail(image: np.ndarray) -> np.ndarray:
    """Squares of the steps from pixel to pixel, of the mean of all bands."""
    grey = image.mean(axis=0)
    squares = np.zeros_like(grey)
    squares[:, :-1] += np.diff(grey, axis=1) ** 2
    squares[:-1] += np.diff(grey, axis=0) ** 2
    return squares
