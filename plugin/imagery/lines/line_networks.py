"""Networks of lines: pieces that lie anyhow -> common nodes -> the longest paths through them.

Points are complex numbers x + iy in pixels of the mosaic, none of them negative: shifts, lengths, directions and
projections are then one operation each.
"""
from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import chain, combinations

import numpy as np

BORDER_SNAP_PX = 0.5  # borders of polygons nearer than this are one: half a raster step
BRANCH_REACH_PX = 10  # how far a branch's direction is looked at: beyond it a raster step turns it by < 6 degrees
BRANCH_TURN_DEG = 75.0  # the straightest two of three branches turn by 60 at most, so one seam always goes on



def network(pieces: np.ndarray, tolerance: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Make pieces meet in common nodes.

    ``pieces``: (n, 2) start and end. Ends within ``tolerance`` of each other become one node, and a piece that
    passes a node within ``tolerance`` is split there. No new crossing points are made: pieces that cross
    elsewhere do overlap and share no border.

    Returns nodes (k,), edges (m, 2) as node numbers, in the direction of their piece, and the piece (m,) that
    each edge is a part of.
    """
    nodes, ends = _clustered(pieces, tolerance)
    piece, passed = _passed_nodes(nodes, ends, tolerance)
    count = np.arange(len(ends))
    piece = np.concatenate([count, piece, count])
    node = np.concatenate([ends[:, 0], passed, ends[:, 1]])
    start, stop = nodes[ends[piece]].T
    along = ((nodes[node] - start) * (stop - start).conj()).real
    order = np.lexsort((node, along, piece))
    piece, node = piece[order], node[order]
    follows = (piece[1:] == piece[:-1]) & (node[1:] != node[:-1])
    return nodes, np.column_stack([node[:-1], node[1:]])[follows], piece[1:][follows]


def _clustered(points: np.ndarray, tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """Points no two of which lie within ``tolerance``, and for each input point the number of its one.

    From west to east each point is kept unless a kept one is near: chains of near points don't collapse.
    """
    unique, member = np.unique(points, return_inverse=True)
    # The box of 2 x tolerance around a point lies in four cells of that size.
    one, other = _in_cells(unique, unique, 2 * tolerance)
    near = (one < other) & (abs(unique[one] - unique[other]) <= tolerance)
    one, other = one[near], other[near]
    order = np.lexsort((one, other))
    kept = list(range(len(unique)))
    for earlier, later in zip(one[order].tolist(), other[order].tolist()):
        if kept[earlier] == earlier and kept[later] == later:
            kept[later] = earlier
    used, cluster = np.unique(kept, return_inverse=True)
    return unique[used], cluster[member].reshape(points.shape)


def _passed_nodes(nodes: np.ndarray, ends: np.ndarray, tolerance: float) -> tuple[np.ndarray, np.ndarray]:
    """Pairs (piece, node) where a piece passes a node within ``tolerance`` between its ends; pairs may repeat."""
    start, stop = nodes[ends].T
    length = abs(stop - start)
    # Pieces are searched in steps of up to the mean length, and steps of like length together: long borders
    # of a block then cost as little as the raster steps within it.
    steps = np.maximum(np.ceil(length / max(length.mean(), tolerance)), 1).astype(int)
    piece, step = np.repeat(np.arange(len(ends)), steps), _count_up(steps)
    middle = start[piece] + (stop - start)[piece] * (step + 0.5) / steps[piece]
    octave = np.ceil(np.log2(np.maximum(length / steps, tolerance)))[piece]
    found = []
    for size in np.unique(octave):
        chosen = np.flatnonzero(octave == size)
        near, node = _in_cells(middle[chosen], nodes, 2**size + 2 * tolerance)
        passing = piece[chosen[near]]
        span = length[passing]
        offset = (nodes[node] - start[passing]) * (stop - start)[passing].conj()
        inside = (offset.real > 0) & (offset.real < span**2) & (abs(offset.imag) <= tolerance * span)
        inside &= (node != ends[passing, 0]) & (node != ends[passing, 1])
        found.append(np.stack([passing, node])[:, inside])
    passing, node = np.concatenate(found, axis=1)
    return passing, node


def _in_cells(centres: np.ndarray, points: np.ndarray, size: float) -> tuple[np.ndarray, np.ndarray]:
    """Pairs (centre, point) that hold all points in the square of ``size`` around each centre, and some more."""
    rows = int(points.imag.max() / size) + 3  # all coordinates are 0 or more; a cell free on either side
    cell = np.floor(points.real / size).astype(int) * rows + np.floor(points.imag / size).astype(int)
    order = np.argsort(cell, kind="stable")
    cell = cell[order]
    pairs = []
    corner = np.floor(centres.real / size - 0.5).astype(int) * rows + np.floor(centres.imag / size - 0.5).astype(int)
    # Two cells above each other are neighbours in the sorted list.
    for column in (corner, corner + rows):
        first, last = np.searchsorted(cell, column), np.searchsorted(cell, column + 1, side="right")
        centre = np.repeat(np.arange(len(centres)), last - first)
        pairs.append((centre, order[first[centre] + _count_up(last - first)]))
    return np.concatenate([pairs[0][0], pairs[1][0]]), np.concatenate([pairs[0][1], pairs[1][1]])


def _count_up(counts: np.ndarray) -> np.ndarray:
    """0, 1, ..., n - 1 for each n in ``counts``, one after the other."""
    return np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)


def borders(pieces: np.ndarray, owner: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Nodes and edges (m, 2) that have one feature's polygon on their left and another feature's on their right.

    ``pieces``: (n, 2) of all rings, the interior on their left; ``owner``: (n,) the feature of each.
    """
    nodes, edges, piece = network(pieces, BORDER_SNAP_PX)
    owner = owner[piece]
    forward = edges[:, 0] < edges[:, 1]
    pairs, pair = undirected(edges, len(nodes))
    left, right = np.zeros((2, len(pairs)), dtype=bool)
    left[pair[forward]] = True
    right[pair[~forward]] = True
    first, last = np.full(len(pairs), owner.max()), np.zeros(len(pairs), dtype=int)
    np.minimum.at(first, pair, owner)
    np.maximum.at(last, pair, owner)
    return nodes, pairs[left & right & (first < last)]


def undirected(edges: np.ndarray, node_count: int) -> tuple[np.ndarray, np.ndarray]:
    """Each pair of nodes that edges join, once, (k, 2); and for each edge the number of its pair, (m,)."""
    key, pair = np.unique(edges.min(axis=1) * node_count + edges.max(axis=1), return_inverse=True)
    return np.column_stack(np.divmod(key, node_count)), pair


def joined(nodes: np.ndarray, edges: np.ndarray) -> Iterator[np.ndarray]:
    """Edges (m, 2) end to end: paths of vertices, the longest possible ones under the rules above.

    An end of edge e is numbered 2e (its start) or 2e + 1 (its stop), so ``end ^ 1`` is the other end.
    """
    edges, _ = undirected(edges, len(nodes))
    ends = edges.ravel()
    order = np.argsort(ends, kind="stable")
    degree = np.bincount(ends, minlength=len(nodes))
    simple = order[(degree == 2)[ends[order]]].reshape(-1, 2)
    next_end = np.full(len(ends), -1)
    next_end[simple] = simple[:, ::-1]
    chains = [np.append(ends[run], ends[run[-1] ^ 1]) for run in _runs(next_end)]

    # The same once more with chains for edges, now through the branches.
    outward: dict[int, list[tuple[int, complex]]] = {}
    for number, nodes_of_chain in enumerate(chains):
        for end, path in ((2 * number, nodes_of_chain), (2 * number + 1, nodes_of_chain[::-1])):
            if degree[path[0]] > 2:
                outward.setdefault(path[0], []).append((end, _direction(nodes[path])))
    next_end = np.full(2 * len(chains), -1)
    for ends_here in outward.values():
        for one, other in _straightest(ends_here):
            next_end[[one, other]] = other, one
    for run in _runs(next_end):
        parts = [chains[end >> 1][:: -1 if end & 1 else 1] for end in run]
        yield nodes[np.concatenate([part[:-1] for part in parts] + [parts[-1][-1:]])]


def _runs(next_end: np.ndarray) -> Iterator[list[int]]:
    """Edges in a row, each given by the end it is entered at. ``next_end``: the end that goes on from each, or -1."""
    following = next_end.tolist()
    done = bytearray(len(following) // 2)
    # Open ends first; what is left after them are rings.
    for start in chain(np.flatnonzero(next_end < 0).tolist(), range(len(following))):
        run = []
        while start >= 0 and not done[start >> 1]:
            done[start >> 1] = True
            run.append(start)
            start = following[start ^ 1]
        if run:
            yield run


def _direction(path: np.ndarray) -> complex:
    """Unit vector from the first vertex to the point some pixels along the path, beyond the raster's steps."""
    head = path[: 4 * BRANCH_REACH_PX]
    station = np.append(0, np.cumsum(abs(np.diff(head))))
    reach = min(BRANCH_REACH_PX, station[-1] / 2)  # half: the far end of a loop is its start
    step = np.interp(reach, station, head.real) + 1j * np.interp(reach, station, head.imag) - path[0]
    return step / abs(step) if step else 0j


def _straightest(branches: Sequence[tuple[int, complex]]) -> Iterator[tuple[int, int]]:
    """Pairs of ends at one node that go on into each other, straightest first.

    ``branches``: number of each end and the direction it goes from the node.
    """
    limit = -math.cos(math.radians(BRANCH_TURN_DEG))
    pairs = [((a * b.conjugate()).real, one, other) for (one, a), (other, b) in combinations(branches, 2)]
    free = {end for end, _ in branches}
    for cosine, one, other in sorted(pairs):
        if cosine <= limit and one in free and other in free:
            free -= {one, other}
            yield one, other
