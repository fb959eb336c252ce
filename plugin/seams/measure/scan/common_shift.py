"""Whether a mosaic lies beside all its orthoimages by one shift, where it matches none of them."""
from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ....imagery.errors import RasterError
from ....imagery.grids import standard_window
from ....imagery.shifts import find_shift
from ..blocks.block_pixels import BlockPixels
from ..following.boxes import in_squares
from ..following.placed_sources import FARTHEST_FILTERED_PX
from .followed_ground import GroundPlace
from .scan_request import ScanRequest

LEAST_BESIDE = 0.1
"""Least share of the ground that no source explains, to be looked at: less may be what a seam or a building hides."""
_SIDE_PX, _STEP_PX = 1024, 4  # of what is compared at one place; sides of the squares whose means are
_LEAST_SHIFTS, _LEAST_AGREEING = 3, 0.75  # relief moves single ones by as much; share of the shifts
_SAME = 0.5  # of its length: shifts that differ by less are one, whatever the relief adds


def common_shift(request: ScanRequest, places: Sequence[GroundPlace]) -> tuple[float, float] | None:
    """Metres to the east and to the north by which a mosaic lies beside its orthoimages, as most of these agree at some
    places; None where they don't, or where it is so little that a filter tells it."""
    shifts = np.array([shift for place in places for shift in _shifts_at(request, place)]).reshape(-1, 2)
    if len(shifts) < _LEAST_SHIFTS:
        return None
    grid, middle = request.mosaic.grid, np.median(shifts, axis=0)
    agreeing = np.hypot(*(shifts - middle).T) < _SAME * np.hypot(*middle)
    if np.hypot(*middle) <= FARTHEST_FILTERED_PX or agreeing.mean() < _LEAST_AGREEING:
        return None
    x, y = middle.tolist()
    return x * grid.pixel_width * grid.metres_x, -y * grid.pixel_height * grid.metres_y


def _shifts_at(request: ScanRequest, place: GroundPlace) -> Iterator[tuple[float, float]]:
    """Pixels by which the mosaic lies to the right of and below each source around a place."""
    grid = request.mosaic.grid
    window = standard_window(grid, place.x, place.y, _SIDE_PX).moved_into(grid.columns, grid.rows)
    window = window.cut_to(grid.columns, grid.rows)
    refs = [request.sources[i].ref for i in request.footprints.meeting(grid.window_extent(window))]
    try:
        planes = BlockPixels(request.mosaic, refs, window, None).part(window, range(len(refs)))
    except RasterError:  # which the blocks told
        return
    for source in planes.sources.values():
        valid = None if source.valid is None else _means(source.valid) == 1
        if (shift := find_shift(_means(planes.mosaic), _means(source.plane), valid)) is not None:
            yield _STEP_PX * shift.x, _STEP_PX * shift.y


def _means(plane: np.ndarray) -> np.ndarray:
    return np.asarray(in_squares(plane, _STEP_PX).mean(axis=(1, 3), dtype=np.float32))
