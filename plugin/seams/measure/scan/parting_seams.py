"""The given seams that can be some: those between two orthoimages, away from the border of the mosaic's pixels."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import replace

import numpy as np

from ....imagery.errors import RasterError, SeamlineError
from ....imagery.grids import PixelWindow
from ....imagery.lines import vertex_stations
from ....imagery.open_raster import OpenRaster
from .. import messages
from ..inputs.valid_cells import is_whole
from ..seamlines.given_seams import GivenSeams
from ..seamlines.seam_pieces import SidedSeam, cut_at, points_beside

_STEP_PX = 4  # between the places of a seam that are looked at, and the pixels that are read
_ASIDE_PX = 8.0  # to either side: farther than an outline lies off the pixels that it was drawn around
_SHORTEST_PX = 64.0  # beside holes that are shorter a seam goes on
_BLOCK_CELLS = 128  # along a side, each of such a step, that are read at once: a tile or some


def parting_seams(given: GivenSeams, numbers: Mapping[str, int], mosaic: OpenRaster) -> tuple[SidedSeam, ...]:
    """The given seams that part two orthoimages, ``numbers`` by their names, as far as the mosaic has pixels on both
    sides or on none: what runs along the border of its pixels is an outline. Raises SeamlineError where none is left.
    """
    found = tuple(
        part for seam in given.seams if not _is_in_one(seam, given, numbers) for part in _off_border(seam, mosaic)
    )
    if not found:
        raise SeamlineError(messages.SEAMS_PART_NOTHING())
    return found


def _is_in_one(seam: SidedSeam, given: GivenSeams, numbers: Mapping[str, int]) -> bool:
    """Whether the same orthoimage lies on both sides, by whichever names. Two of one day are two."""
    left, right = (numbers.get(side, side) if isinstance(side, str) else side for side in (seam.left, seam.right))
    is_date = isinstance(left, str) and given.dates.get(left) == left
    return left is not None and left == right and not is_date


def _off_border(seam: SidedSeam, mosaic: OpenRaster) -> Iterator[SidedSeam]:
    if seam.left is not None and seam.right is not None:
        yield seam
        return
    path = mosaic.raster.grid.to_pixels(seam.vertices)
    along = vertex_stations(path)
    stations = np.linspace(0, along[-1], int(along[-1] / _STEP_PX) + 2)
    left, right = (_has_pixels(mosaic, side[:, 0]) for side in points_beside(path, along, stations, (_ASIDE_PX,)))
    on_border = np.flatnonzero(np.diff(np.concatenate([[False], left != right, [False]])))
    first, last = stations[on_border[::2]], stations[on_border[1::2] - 1]
    long = last - first >= min(_SHORTEST_PX, along[-1] / 2)
    if not long.any():
        yield seam
        return
    cuts = np.concatenate([[0.0], np.column_stack([first, last])[long].ravel(), along[-1:]])
    for number, vertices in enumerate(cut_at(seam.vertices, along, cuts)):
        if number % 2 == 0 and cuts[number + 1] - cuts[number] > 2 * _ASIDE_PX:
            yield replace(seam, vertices=vertices)


def _has_pixels(mosaic: OpenRaster, places: np.ndarray) -> np.ndarray:
    """Whether the mosaic has pixels at columns and rows, (n, 2); what can't be read counts as some."""
    size = np.array([mosaic.columns, mosaic.rows])
    found = ((places >= 0) & (places < size)).all(axis=1)
    if is_whole(mosaic):
        return np.asarray(found)
    cell = np.floor(places / _STEP_PX).astype(np.int64)
    block = np.where(found[:, np.newaxis], cell // _BLOCK_CELLS, -1)
    for key in np.unique(block[found], axis=0):
        here = (block == key).all(axis=1)
        left, top = (key * _BLOCK_CELLS * _STEP_PX).tolist()
        wide, high = (min(_BLOCK_CELLS * _STEP_PX, end) for end in (mosaic.columns - left, mosaic.rows - top))
        with suppress(RasterError):
            valid = mosaic.thinned(PixelWindow(left, top, wide, high), _STEP_PX).valid
            column, row = (cell[here] - key * _BLOCK_CELLS).T
            found[here] = valid[row.clip(max=len(valid) - 1), column.clip(max=valid.shape[1] - 1)]
    return np.asarray(found)
