"""The best cut between two images: the way along which they agree, from one end of a seam that stays to the other.

A mixture of two images p and q that are alike in tone loses |p - q|^2 / 4 of their detail (``feather_prediction``). So
the difference of the levelled images says what a seam costs at any place: it is large at roofs, cars and trees, which
the images show in different places, and where they don't fit. The new cut is the way that costs least.
"""
from __future__ import annotations

import numpy as np
from scipy import ndimage, sparse
from scipy.sparse import csgraph

from ....imagery.errors import Message
from ....imagery.shifts import MIN_TILE_SHARE, Shift, find_shift, shifted
from ..following.boxes import box_means, enlarged, in_squares
from ..following.levelling import gain_field, square_means, to_pixels
from . import messages

CELL_PX = 4
"""Side of the cells of which a cut consists."""
MOST_MISFIT_PX = 2.5
"""Along the new cut: where images lie farther apart, an edge that it crosses is seen to break."""
LEAST_ALIKE = 0.1
"""Correlation of what is coarser than a cell along a cut; unrelated images have 0."""
_FAR = 32  # cells: what differs over more than that is tone
_LENGTH = 0.2  # of the middle cost, for every cell: a way round has to be worth it
_NEAR, _WIDE = 3, 9  # cells a side: what is beside a way, and what detail is coarser than
_STRETCH = 16  # cells of a way: images may lie apart in a part of it only
_TILE_PX = 128  # around its middle, in which images are compared
_CROSSED_PX = 12  # on either side of a way: what it crosses
_STRIP_PX = 40  # on either side of a way, in which images are compared


def cutting_cost(first: np.ndarray, second: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """Mean square of what two planes (rows, columns) float32 differ by in fine detail and in tones, DN squared, by
    cells, (rows, columns) float32; infinite where one has no pixels.

    The sides are multiples of 8. ``valid``: bool, pixels that both have.
    """
    gain = gain_field(square_means(first), square_means(second), square_means(valid) == 1)
    rest = first - to_pixels(gain, first.shape) * second
    known, mean = in_squares(valid, CELL_PX).all(axis=(1, 3)), _by_cell(rest)
    weight, near = (
        ndimage.gaussian_filter(np.asarray(plane, np.float32), _FAR) for plane in (known, np.where(known, mean, 0))
    )
    tones = mean - near / np.maximum(weight, 1e-6)
    fine = np.maximum(_by_cell(np.square(rest)) - np.square(mean), 0)
    return np.where(known, fine + np.square(tones), np.float32(np.inf))


def cheapest_way(
    cost: np.ndarray, allowed: np.ndarray, start: tuple[int, int], end: tuple[int, int]
) -> np.ndarray | None:
    """Rows and columns (n, 2) of the cells from start to end; None where there is no way.

    ``allowed``: (rows, columns) bool. Start and end are taken as they are.
    """
    free = allowed & np.isfinite(cost)
    if not free.any():
        return None
    cost = np.where(free, cost / (cost[free].max() or 1), 0)  # the way is the same, and no sum of them overflows
    near = box_means(cost, (_NEAR,))[0] / np.maximum(box_means(free, (_NEAR,))[0], 1e-6)
    near += _LENGTH * np.float32(np.median(near[free])) + np.float32(1e-6)
    free[start], free[end] = True, True
    numbers = np.arange(free.size).reshape(free.shape)
    rows, columns = free.shape
    steps = []
    for down, across in ((0, 1), (1, 0), (1, 1), (1, -1)):
        here = np.s_[: rows - down, max(-across, 0) : columns - max(across, 0)]
        there = np.s_[down:, max(across, 0) : columns - max(-across, 0)]
        both = free[here] & free[there]
        lengths = np.hypot(down, across) * (near[here] + near[there]) / 2
        steps.append([column[both] for column in (lengths, numbers[here], numbers[there])])
    lengths, heads, tails = map(np.concatenate, zip(*steps))
    graph = sparse.coo_matrix((lengths, (heads, tails)), (free.size, free.size)).tocsr()
    before = csgraph.dijkstra(graph, directed=False, indices=numbers[start], return_predecessors=True)[1]
    way = [numbers[end]]
    while way[-1] != numbers[start]:
        if before[way[-1]] < 0:
            return None
        way.append(before[way[-1]])
    return np.column_stack(np.unravel_index(way[::-1], free.shape))


def fit_along(
    way: np.ndarray, first: np.ndarray, second: np.ndarray, valid: np.ndarray
) -> tuple[float | None, Message | None, np.ndarray]:
    """How far two planes lie from each other along a way (n, 2), rows and columns of cells, px, where it is most, None
    where nothing in common shows it; why they can't be cut there; and (n,) bool: where they lie too far apart."""
    off = np.ones([length // CELL_PX for length in valid.shape], bool)
    off[tuple(way.T)] = False
    from_way = CELL_PX * ndimage.distance_transform_edt(off)
    beside, crossed = from_way <= _STRIP_PX, enlarged(from_way <= _CROSSED_PX, CELL_PX) & valid
    shift = find_shift(first, second, enlarged(beside, CELL_PX) & valid)
    stretches = np.array_split(way, max(1, round(len(way) / _STRETCH)))
    shifts = []
    for cells in stretches:
        middle = cells[len(cells) // 2] * CELL_PX + CELL_PX // 2
        tile = tuple(map(slice, np.maximum(middle - _TILE_PX // 2, 0), middle + _TILE_PX // 2))
        shifts.append(_apart(first[tile], second[tile], valid[tile], crossed[tile]))
    lengths = [0.0 if offset is None else offset.length for offset in shifts]
    far = np.repeat(np.array(lengths) > MOST_MISFIT_PX, [len(stretch) for stretch in stretches])
    misfit = max((offset.length for offset in (shift, *shifts) if offset is not None), default=None)
    if misfit is not None:
        return misfit, messages.IMAGES_MISFIT(misfit=misfit) if misfit > MOST_MISFIT_PX else None, far
    beside &= in_squares(valid, CELL_PX).all(axis=(1, 3))
    a, b = ((cells - ndimage.uniform_filter(cells, _WIDE))[beside] for cells in map(_by_cell, (first, second)))
    alike = float(a @ b) >= LEAST_ALIKE * float(np.sqrt((a @ a) * (b @ b)))
    return None, None if alike else messages.IMAGES_UNLIKE(), far


def _apart(first: np.ndarray, second: np.ndarray, valid: np.ndarray, crossed: np.ndarray) -> Shift | None:
    """How two planes lie around a place on a way, where the ground that is ``crossed`` there shows it, and not just an
    object beside it that it leads around."""
    shift = find_shift(first, second) if valid.mean() >= MIN_TILE_SHARE else None
    if shift is None or shift.length <= MOST_MISFIT_PX:
        return shift
    a, b, moved = (
        (plane - ndimage.uniform_filter(plane, _WIDE * CELL_PX))[crossed]
        for plane in (first, second, shifted(second, shift.x, shift.y))
    )
    return shift if np.square(a - moved).sum() < np.square(a - b).sum() else None


def _by_cell(plane: np.ndarray) -> np.ndarray:
    return np.asarray(in_squares(plane, CELL_PX).mean(axis=(1, 3)))
