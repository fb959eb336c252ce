"""Windows of the places where least was kept, to be judged one by one."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Callable

import numpy as np

from ....imagery import limits as imagery_limits
from ....imagery.errors import RasterError
from ....imagery.grids import Grid, PixelWindow, standard_side_px, standard_window
from ....imagery.lines import points_at, vertex_stations
from ....imagery.raster_pool import open_raster
from ....imagery.rasters import Raster
from ..window_placing import PlacedWindow, WindowIndex
from .judged_pieces import JudgedPiece

WINDOWS_ALONG = 4
"""Windows that have to fit along the mosaic's shorter side."""
LEAST_SIDE_PX = 256
"""Smaller windows tell too little of a seam."""
SMALLEST_SIDE_PX = 128
"""Beside missing pixels; below it there is no ground around the seam to compare it with."""


def worst_windows(
    pieces: Sequence[JudgedPiece], mosaic: Raster, count: int, levels: int,
    is_valid: Callable[[PixelWindow], bool] | None = None,
) -> list[PlacedWindow]:
    """Up to ``count`` windows on the pieces that kept least, the least first, each where the mosaic has pixels; of two
    that share more than half only the worse.

    A window lies around its piece, or is moved aside, or made smaller, as far as it has to be; where it fits nowhere
    there is none. ``is_valid``: whether a window has enough pixels; the mosaic is asked unless told otherwise.
    """
    grid, is_valid = mosaic.grid, is_valid or valid_in(mosaic)
    side = window_side_px(grid, levels)
    taken = WindowIndex(max(side, 1))
    found: list[PlacedWindow] = []
    measured = [(one.least_kept, number) for number, one in enumerate(pieces) if one.least_kept is not None]
    for _, number in sorted(measured):
        judged = pieces[number]
        if len(found) >= count:
            break
        window = _fitting(*_middle(judged.piece.vertices), grid, side, is_valid)
        if window is None or taken.shares_too_much(window):
            continue
        taken.add(window)
        station = judged.piece.station_m + judged.piece.length_m / 2
        found.append(PlacedWindow(len(found) + 1, judged.piece.seam_id, station, window))
    return found


def window_side_px(grid: Grid, levels: int) -> int:
    """The standard side; of a mosaic that hardly holds such windows a part of it, so that they tell places apart."""
    side, shorter = standard_side_px(grid, imagery_limits.STANDARD_SIDE_M), min(grid.columns, grid.rows)
    while side > LEAST_SIDE_PX and side * WINDOWS_ALONG > shorter:
        side //= 2
    side = min(side, shorter)
    return side - side % 2**levels


def valid_in(mosaic: Raster) -> Callable[[PixelWindow], bool]:
    """Whether a window of a mosaic has enough pixels; always where the file says nothing of it, or can't be read."""
    try:
        opened = open_raster(mosaic.ref)
    except RasterError:
        return lambda window: True
    return (lambda window: True) if opened.is_all_valid else opened.is_valid


def _fitting(
    x: float, y: float, grid: Grid, side: int, is_valid: Callable[[PixelWindow], bool]
) -> PixelWindow | None:
    """The window around a place, else the first of those aside that holds it, else of smaller ones."""
    while True:
        window = standard_window(grid, x, y, side)
        by = side * 3 // 8
        for down, across in ((0, 0), *((i, j) for i in (0, -by, by) for j in (0, -by, by) if i or j)):
            moved = window.moved_by(across, down).moved_into(grid.columns, grid.rows)
            if is_valid(moved):
                return moved
        side //= 2
        if side < SMALLEST_SIDE_PX:
            return None


def _middle(vertices: np.ndarray) -> tuple[float, float]:
    along = vertex_stations(vertices)
    x, y = points_at(vertices, along, along[-1:] / 2)[0].tolist()
    return x, y
