"""Labels as an estimate leaves them, strip by strip -> cleaned ones -> the borders between them.

Cleaning: what is done to a label depends on labels less than ``REACH`` samples away only, so neither the strips that
come in nor the tiles that are worked on show in the result.

Borders: chains of sample sides from one junction of three labels to the next. A node is a corner of samples, an edge a
side between two samples with different labels. An edge is directed so that the lower label is on its left: at a node
that two edges meet, one therefore comes in and the other goes out, and they part the same two labels. Where four edges
meet and two labels face each other across, the node is taken for two that lie in one place, so that borders pass each
other there and don't end.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

import numpy as np
from scipy import ndimage
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

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


_ROWS = 128  # that are looked at together: their sides take some times as much memory as the labels


@dataclass(frozen=True, eq=False)
class LabelBorder:
    """One border between two labels, from one junction to the next, or a ring."""

    nodes: np.ndarray
    """(n, 2) int64, n >= 2: row and column of sample corners; first and last are equal when it is a ring."""
    left: int
    """The label on the left hand of who walks along it, the lower one; ``NONE`` where it is an outline."""
    right: int
    """The label on the right hand."""
    keys: tuple[int, int]
    """What its two ends are known by: borders with an end of the same key meet there."""


@dataclass(frozen=True, eq=False)
class _Edges:
    """Sides between samples."""

    start: np.ndarray
    """(n,) int64: twice the number of the node, plus 1 for the second of two in one place."""
    stop: np.ndarray
    """(n,) int64"""
    left: np.ndarray
    """(n,) int16"""
    right: np.ndarray
    """(n,) int16"""
    junctions: np.ndarray
    """Nodes where borders end, of those that came with strips before."""

    def taken(self, which: np.ndarray) -> _Edges:
        """Some of them, in the order given."""
        return replace(
            self, start=self.start[which], stop=self.stop[which], left=self.left[which], right=self.right[which]
        )


def label_borders(strips: Iterable[np.ndarray]) -> Iterator[LabelBorder]:
    """All borders, outlines included, each as soon as both its ends are known.

    ``strips``: (rows, columns) labels from top to bottom, all of one width. Memory grows with what is open only.
    """
    above: np.ndarray | None = None
    opened: _Edges | None = None
    row = 0
    for strip in (whole[start : start + _ROWS] for whole in strips for start in range(0, len(whole), _ROWS)):
        if above is None:
            above = np.full((1, strip.shape[1] + 2), NONE, strip.dtype)
        padded = np.pad(strip, ((0, 0), (1, 1)), constant_values=NONE)
        opened, done = _chained(opened, _edges(np.concatenate([above, padded]), row), row + len(strip), strip.shape[1])
        yield from done
        above, row = padded[-1:], row + len(strip)
    if above is not None:
        last = np.concatenate([above, np.full_like(above, NONE)])
        yield from _chained(opened, _edges(last, row), -1, above.shape[1] - 2)[1]


def _edges(labels: np.ndarray, first_row: int) -> _Edges:
    """The edges along the tops of rows and within them; ``labels`` begins with the row above and is a column wider
    on either side."""
    width = labels.shape[1] - 2
    upper, lower = labels[:-1], labels[1:]
    across = upper[:, 1:-1] != lower[:, 1:-1]  # between rows: (row, column)
    down = lower[:, :-1] != lower[:, 1:]  # between columns: (row, node column)
    # Nodes at the tops of these rows: the four samples around each.
    top_left, top_right = upper[:, :-1], upper[:, 1:]
    bottom_left, bottom_right = lower[:, :-1], lower[:, 1:]
    crossing = (top_left != top_right) & down & (top_left != bottom_left) & (top_right != bottom_right)
    falling, rising = top_left == bottom_right, top_right == bottom_left
    double = crossing & (falling | rising)
    falling = double & falling & (~rising | (top_left < top_right))
    rising = double & ~falling

    row, column = np.nonzero(across)
    node = 2 * ((first_row + row) * (width + 1) + column)
    north, south = upper[row, column + 1], lower[row, column + 1]
    # The node is the left end of one side, where falling takes the right arm up, and the right end of another.
    west, east = node + rising[row, column], node + 2 + falling[row, column + 1]
    eastward = north < south
    start, stop = np.where(eastward, west, east), np.where(eastward, east, west)
    left, right = np.minimum(north, south), np.maximum(north, south)

    row, column = np.nonzero(down)
    node = 2 * ((first_row + row) * (width + 1) + column)
    upper_end, lower_end = node + double[row, column], node + 2 * (width + 1)
    west_label, east_label = lower[row, column], lower[row, column + 1]
    southward = east_label < west_label
    return _Edges(
        np.concatenate([start, np.where(southward, upper_end, lower_end)]).astype(np.int64),
        np.concatenate([stop, np.where(southward, lower_end, upper_end)]).astype(np.int64),
        np.concatenate([left, np.minimum(west_label, east_label)]),
        np.concatenate([right, np.maximum(west_label, east_label)]),
        np.empty(0, np.int64),
    )


def _chained(
    opened: _Edges | None, new: _Edges, open_row: int, width: int
) -> tuple[_Edges, list[LabelBorder]]:
    """Edges that belong to borders which go on below the nodes of ``open_row``, and the borders that are whole."""
    edges = new if opened is None else _Edges(
        np.concatenate([opened.start, new.start]),
        np.concatenate([opened.stop, new.stop]),
        np.concatenate([opened.left, new.left]),
        np.concatenate([opened.right, new.right]),
        opened.junctions,
    )
    count = len(edges.start)
    if not count:
        return edges, []
    nodes, ends = np.unique(np.concatenate([edges.start, edges.stop]), return_inverse=True)
    starts, stops = ends[:count], ends[count:]
    pending = nodes // (2 * (width + 1)) == open_row
    # The other borders of a junction may be done and gone, so it is remembered as one.
    ending = ~pending & ((np.bincount(ends, minlength=len(nodes)) != 2) | np.isin(nodes, edges.junctions))
    leaving = np.full(len(nodes), -1)
    leaving[starts] = np.arange(count)
    following = np.where(pending[stops] | ending[stops], -1, leaving[stops])
    linked = np.flatnonzero(following >= 0)
    links = coo_matrix((np.ones(len(linked), bool), (linked, following[linked])), shape=(count, count))
    chains, chain = connected_components(links, directed=False)

    # A ring has no last edge: it is opened at its first node.
    is_ring = np.ones(chains, dtype=bool)
    is_ring[chain[following < 0]] = False
    if is_ring.any():
        first_node = np.full(chains, len(nodes))
        np.minimum.at(first_node, chain, starts)
        following[is_ring[chain] & (stops == first_node[chain])] = -1
    still_open = np.zeros(chains, dtype=bool)
    still_open[chain[pending[starts] | pending[stops]]] = True

    chosen = np.flatnonzero(~still_open[chain])
    left_over = _edges_to_last(following)
    order = chosen[np.lexsort((-left_over[chosen], chain[chosen]))]
    groups = np.split(order, np.flatnonzero(np.diff(chain[order])) + 1) if len(order) else []
    rest = replace(edges.taken(np.flatnonzero(still_open[chain])), junctions=nodes[ending])
    return rest, [_border(edges, group, width) for group in groups]


def _edges_to_last(following: np.ndarray) -> np.ndarray:
    """How many edges follow each one in its chain: pointers that leap twice as far in every round."""
    far, count = following.copy(), (following >= 0).astype(np.int64)
    moving = np.flatnonzero(far >= 0)
    while len(moving):
        target = far[moving]
        count[moving] += count[target]
        far[moving] = far[target]
        moving = moving[far[moving] >= 0]
    return count


def _border(edges: _Edges, group: np.ndarray, width: int) -> LabelBorder:
    keys = np.append(edges.start[group], edges.stop[group[-1]])
    nodes = np.column_stack(np.divmod(keys // 2, width + 1))
    first = group[0]
    return LabelBorder(nodes, int(edges.left[first]), int(edges.right[first]), (int(keys[0]), int(keys[-1])))
