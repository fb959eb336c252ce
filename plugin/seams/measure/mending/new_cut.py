"""Where two images are cut best: the way along which they agree, from one end of a seam that stays to the other.

A mixture of two images p and q that are alike in tone loses |p - q|^2 / 4 of their detail (``feather_prediction``). So
the difference of the levelled images says what a seam costs at any place: it is large at roofs, cars and trees, which
the images show in different places, and where they don't fit. The new cut is the way that costs least.
"""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import ndimage, sparse
from scipy.sparse import csgraph

from ..following.boxes import box_means, in_squares
from ..following.levelling import gain_field, square_means, to_pixels

CELL_PX = 4
"""Side of the cells of which a cut consists."""
FAR = 32  # cells: what differs over more than that is tone
MOST_APART = 0.9
"""Of the detail coarser than a cell along a cut: unrelated images have 1."""
_LENGTH = 0.2  # of the middle cost, for every cell: a way round has to be worth it
_NEAR, _WIDE = 3, 9  # cells a side: what is beside a way, and what detail is coarser than


@dataclass(frozen=True, eq=False)
class Difference:
    """Of two images, by cells, (rows, columns) float32 each."""

    cost: np.ndarray
    """Mean square, DN squared, of fine detail and of tones; infinite where one image has no pixels."""
    apart: np.ndarray
    """Energy of the difference of their detail coarser than a cell."""
    detail: np.ndarray
    """Energy of that detail itself, of both together."""


def difference(first: np.ndarray, second: np.ndarray, valid: np.ndarray) -> Difference:
    """Of two planes (rows, columns) float32 whose sides are multiples of 8; ``valid``: pixels that both have."""
    whole = square_means(valid) == 1
    gain = to_pixels(gain_field(square_means(first), square_means(second), whole), first.shape)
    levelled = gain * second
    rest = first - levelled
    known = in_squares(valid, CELL_PX).all(axis=(1, 3))
    own, other, mean = (in_squares(one, CELL_PX).mean(axis=(1, 3)) for one in (first, levelled, rest))
    fine = in_squares(np.square(rest), CELL_PX).mean(axis=(1, 3)) - np.square(mean)
    cost = np.maximum(fine, 0) + np.square(mean - _around(mean, known))
    detail = np.square(_detail(own)) + np.square(_detail(other))
    apart = np.square(_detail(own) - _detail(other))
    cost[~known], apart[~known], detail[~known] = np.inf, 0, 0
    return Difference(cost, apart, detail)


def cheapest_way(
    cost: np.ndarray, allowed: np.ndarray, start: tuple[int, int], end: tuple[int, int]
) -> np.ndarray | None:
    """Rows and columns (n, 2) of the cells from start to end; None where there is no way.

    ``allowed``: (rows, columns) bool. Start and end are taken as they are.
    """
    free = allowed & np.isfinite(cost)
    if not free.any():
        return None
    cost = cost / (cost[free].max() or 1)  # the way is the same, and no sum of them overflows
    near = box_means(np.where(free, cost, 0), (_NEAR,))[0] / np.maximum(box_means(free, (_NEAR,))[0], 1e-6)
    near += _LENGTH * np.float32(np.median(near[free])) + np.float32(1e-6)
    free[start], free[end] = True, True
    numbers = np.full(cost.shape, -1)
    numbers[free] = np.arange(np.count_nonzero(free))
    heads, tails, lengths = [], [], []
    for down, across in ((0, 1), (1, 0), (1, 1), (1, -1)):
        here, there = _neighbours(cost.shape, down, across)
        both = free[here] & free[there]
        heads.append(numbers[here][both])
        tails.append(numbers[there][both])
        lengths.append(np.hypot(down, across) * (near[here][both] + near[there][both]) / 2)
    count = int(numbers.max()) + 1
    graph = sparse.coo_matrix((np.concatenate(lengths), (np.concatenate(heads), np.concatenate(tails))), (count, count))
    _, before = csgraph.dijkstra(
        graph.tocsr(), directed=False, indices=int(numbers[start]), return_predecessors=True
    )
    way = [int(numbers[end])]
    while way[-1] != numbers[start]:
        previous = int(before[way[-1]])
        if previous < 0:
            return None
        way.append(previous)
    return np.argwhere(free)[way[::-1]]


def apart_along(found: Difference, way: np.ndarray) -> float:
    """How little the images agree along a way: 0 where they are alike, 1 where nothing in one is in the other."""
    beside = np.zeros(found.cost.shape, bool)
    beside[tuple(way.T)] = True
    beside = ndimage.binary_dilation(beside, iterations=2)
    total = float(found.detail[beside].sum())
    return float(found.apart[beside].sum()) / total if total > 0 else 0.0


def _detail(cells: np.ndarray) -> np.ndarray:
    return np.asarray(cells - ndimage.uniform_filter(cells, _WIDE))


def _around(values: np.ndarray, known: np.ndarray) -> np.ndarray:
    """Means of what is known around every cell."""
    weight = ndimage.gaussian_filter(known.astype(np.float32), FAR)
    return np.asarray(ndimage.gaussian_filter(np.where(known, values, 0), FAR) / np.maximum(weight, 1e-6))


def _neighbours(shape: tuple[int, ...], down: int, across: int) -> tuple[tuple[slice, slice], tuple[slice, slice]]:
    """All cells that have a neighbour so far off, and these."""
    rows, columns = shape
    left = slice(max(-across, 0), columns - max(across, 0))
    right = slice(max(across, 0), columns - max(-across, 0))
    return (slice(0, rows - down), left), (slice(down, rows), right)
