"""What lies on either side of a piece of seam, as the labels of the mosaic show it."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from .....imagery.grids import Grid
from .....imagery.lines import points_at, vertex_stations
from .label_cleaning import NONE
from .seam_pieces import SeamPiece, Side

_STATIONS = 6  # along a piece
_OFFSETS_PX = (10.0, 20.0)  # to either side: beyond the errors of labels at a seam, and within narrow parts
_TINY = np.finfo(float).tiny
_LEAST_SHARE = 0.5  # of the samples on a side that have to agree


def sides_of(
    pieces: Sequence[SeamPiece],
    strips: Iterable[np.ndarray],
    grid: Grid,
    label_px: int = 4,
    numbers: Mapping[str, int] | None = None,
) -> list[SeamPiece]:
    """Pieces with the sources that most labels beside them show.

    ``strips``: labels as ``trace_borders`` takes them, read once. A piece whose sides aren't named gets the numbers of
    its sources, None where labels don't agree, and the same number twice where the mosaic doesn't change sources
    there. One that is named keeps its names; they are exchanged where the labels say so (``numbers``: of the names).
    """
    columns, rows = _places(pieces, grid, label_px)
    found = _looked_up(columns, rows, strips)
    winners = _majorities(found)
    return [_sided(piece, winners[i], numbers or {}) for i, piece in enumerate(pieces)]


def _places(pieces: Sequence[SeamPiece], grid: Grid, label_px: int) -> tuple[np.ndarray, np.ndarray]:
    """Columns and rows of labels, (pieces, left and right, samples) each."""
    places = np.empty((len(pieces), 2, _STATIONS, len(_OFFSETS_PX), 2))
    shares = (np.arange(_STATIONS) + 0.5) / _STATIONS
    offsets = np.array(_OFFSETS_PX)[:, np.newaxis]
    for i, piece in enumerate(pieces):
        path = grid.to_pixels(piece.vertices)
        along = vertex_stations(path)
        wanted = shares * along[-1]
        middle = points_at(path, along, wanted)[:, np.newaxis]
        across, down = np.diff(path, axis=0)[np.searchsorted(along, wanted).clip(1, len(path) - 1) - 1].T
        left = np.column_stack([down, -across])  # rows run down
        aside = (left / np.maximum(np.hypot(across, down), _TINY)[:, np.newaxis])[:, np.newaxis] * offsets
        places[i] = middle + aside, middle - aside
    found = np.floor(places / label_px).astype(np.int64).reshape(len(pieces), 2, _STATIONS * len(_OFFSETS_PX), 2)
    return found[..., 0], found[..., 1]


def _looked_up(columns: np.ndarray, rows: np.ndarray, strips: Iterable[np.ndarray]) -> np.ndarray:
    """The label at each place, ``NONE`` outside."""
    found = np.full(columns.size, NONE, np.int64)
    order = np.argsort(rows, axis=None, kind="stable")
    flat_rows, flat_columns = rows.ravel()[order], columns.ravel()[order]
    top = 0
    for strip in strips:
        first, last = np.searchsorted(flat_rows, (top, top + len(strip)))
        within = (flat_columns[first:last] >= 0) & (flat_columns[first:last] < strip.shape[1])
        chosen = np.arange(first, last)[within]
        found[order[chosen]] = strip[flat_rows[chosen] - top, flat_columns[chosen]]
        top += len(strip)
    return found.reshape(columns.shape)


def _majorities(found: np.ndarray) -> np.ndarray:
    """The label of most samples on each side, (pieces, 2), ``NONE`` where fewer than half agree."""
    best = np.full(found.shape[:2], NONE, np.int64)
    most = np.zeros(found.shape[:2], dtype=int)
    for place in range(found.shape[2]):
        candidate = found[:, :, place]
        count = (found == candidate[:, :, np.newaxis]).sum(axis=2)
        better = (candidate != NONE) & ((count > most) | ((count == most) & (candidate < best)))
        best[better], most[better] = candidate[better], count[better]
    best[most < _LEAST_SHARE * found.shape[2]] = NONE
    return best


def _sided(piece: SeamPiece, shown: np.ndarray, numbers: Mapping[str, int]) -> SeamPiece:
    left, right = (None if label == NONE else int(label) for label in shown)
    if piece.left is None and piece.right is None:
        return replace(piece, left=left, right=right)
    named = _number(piece.left, numbers), _number(piece.right, numbers)
    if left != right and _agreeing(named[::-1], (left, right)) > _agreeing(named, (left, right)):
        return replace(piece, left=piece.right, right=piece.left)
    return piece


def _number(side: Side, numbers: Mapping[str, int]) -> int | None:
    return numbers.get(side) if isinstance(side, str) else side


def _agreeing(named: tuple[int | None, ...], shown: tuple[int | None, ...]) -> int:
    return sum(one is not None and one == other for one, other in zip(named, shown))
