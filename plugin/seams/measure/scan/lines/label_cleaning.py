"""Labels as an estimate leaves them, strip by strip -> labels whose borders are worth tracing.

What is done to a label depends on labels less than ``REACH`` samples away only, so neither the strips that come in
nor the tiles that are worked on show in the result.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
from scipy import ndimage

NONE = -1
"""The label where no source is followed, or nobody looked."""
REACH = 96
"""Samples: twice the filters' own, once the largest island removed and once the way to what fills it."""

_GAP = 3  # samples: a strip up to twice as wide without labels (12 to 24 px) is crossed by those around it
_SIGMA = 1.5  # samples, 6 px: of the neighbourhood whose majority counts; errors at borders are a cell or two wide
_ISLAND_PX2 = 600  # px squared: what is smaller says nothing of a seam, and is an error as often as not
_TILE = 512  # samples a side
_SQUARE, _VOTERS = 64, 5  # samples a side that are voted on together, and how far votes come from: 3 sigma


def cleaned(strips: Iterable[np.ndarray], label_px: int) -> Iterator[np.ndarray]:
    """Strips of labels (rows, columns) int16, from top to bottom, of heights of their own -> the same cleaned.

    Narrow gaps are closed, single wrong labels outvoted by their neighbours, and islands of less than 600 px squared
    given to what lies around them.
    """
    island = max(_ISLAND_PX2 // label_px**2, 1)
    held: list[np.ndarray] = []
    above = 0  # rows held that are done and serve as neighbours only
    for strip in strips:
        if not strip.size:
            continue
        held.append(strip)
        if sum(map(len, held)) - above >= _TILE + REACH:
            rows = np.concatenate(held)
            stop = len(rows) - REACH
            yield _clean(rows, above, stop, island)
            held, above = [rows[max(stop - REACH, 0) :]], min(stop, REACH)
    if held:
        rows = np.concatenate(held)
        if len(rows) > above:
            yield _clean(rows, above, len(rows), island)


def _clean(rows: np.ndarray, start: int, stop: int, island: int) -> np.ndarray:
    """Rows ``start`` to ``stop``, tile by tile."""
    out = rows[start:stop].copy()
    for top in range(start, stop, _TILE):
        bottom = min(top + _TILE, stop)
        for left in range(0, rows.shape[1], _TILE):
            right = min(left + _TILE, rows.shape[1])
            first_row, first_column = max(top - REACH, 0), max(left - REACH, 0)
            around = rows[first_row : bottom + REACH, first_column : right + REACH]
            if (around == around[0, 0]).all():
                continue
            own = np.s_[top - first_row : bottom - first_row, left - first_column : right - first_column]
            out[top - start : bottom - start, left:right] = _clean_tile(around, island)[own]
    return out


def _clean_tile(labels: np.ndarray, island: int) -> np.ndarray:
    labels = _outvoted(_gaps_closed(labels))
    return _islands_filled(labels, island)


def _gaps_closed(labels: np.ndarray) -> np.ndarray:
    """Narrow strips without labels filled by the nearest one; the outline of what has labels stays as it is."""
    empty = labels == NONE
    if not empty.any() or empty.all():
        return labels
    away, nearest = ndimage.distance_transform_edt(empty, return_indices=True)
    far = away > _GAP
    if far.any():
        empty &= ndimage.distance_transform_edt(~far) > _GAP
    return np.where(empty, labels[tuple(nearest)], labels)


def _outvoted(labels: np.ndarray) -> np.ndarray:
    """Each label the one that most of a small neighbourhood has, those nearer counting more; NONE has no vote.

    Done in those squares only where labels differ.
    """
    differs = np.zeros(labels.shape, dtype=bool)
    differs[:, 1:] |= labels[:, 1:] != labels[:, :-1]
    differs[1:] |= labels[1:] != labels[:-1]
    out = labels.copy()
    for top in range(0, len(labels), _SQUARE):
        rows, above = _around(top, len(labels))
        for left in range(0, labels.shape[1], _SQUARE):
            columns, beside = _around(left, labels.shape[1])
            if differs[rows, columns].any():
                own = labels[rows, columns]
                winner = np.where(own == NONE, NONE, _majority(own))
                out[top : top + _SQUARE, left : left + _SQUARE] = winner[above, beside]
    return out


def _around(start: int, end: int) -> tuple[slice, slice]:
    """Samples of a square along one axis with those that have a vote there, and the own ones among them."""
    first = max(start - _VOTERS, 0)
    return slice(first, min(start + _SQUARE + _VOTERS, end)), slice(start - first, start - first + _SQUARE)


def _majority(labels: np.ndarray) -> np.ndarray:
    best = np.zeros(labels.shape, np.float32)
    winner = np.full(labels.shape, NONE, labels.dtype)
    for label in np.unique(labels):
        if label == NONE:
            continue
        votes = ndimage.gaussian_filter((labels == label).astype(np.float32), _SIGMA, mode="constant", truncate=3.0)
        more = votes > best
        best[more], winner[more] = votes[more], label
    return winner


def _islands_filled(labels: np.ndarray, island: int) -> np.ndarray:
    """Areas of less than ``island`` samples filled by what lies nearest; empty ones too."""
    small = np.zeros(labels.shape, dtype=bool)
    groups = []
    for label in np.flatnonzero(np.bincount(labels.ravel() - NONE)) + NONE:
        area, _ = ndimage.label(labels == label)
        few = np.bincount(area.ravel()) < island
        few[0] = False
        if few.any():
            small |= few[area]
            boxes = ndimage.find_objects(area)
            groups += [boxes[i - 1] for i in np.flatnonzero(few)]
    out = labels.copy()
    for rows, columns in groups:
        # What fills an island is no farther off than an island may be large; else it stays empty.
        top, left = max(rows.start - island, 0), max(columns.start - island, 0)
        around = np.s_[top : rows.stop + island, left : columns.stop + island]
        own = np.s_[rows.start - top : rows.stop - top, columns.start - left : columns.stop - left]
        away, nearest = ndimage.distance_transform_edt(small[around], return_indices=True)
        near = labels[around][tuple(nearest)][own]
        gone = small[rows, columns]
        known = (away[own] <= island) & ~small[around].all()
        out[rows, columns] = np.where(gone, np.where(known, near, NONE), labels[rows, columns])
    return out
