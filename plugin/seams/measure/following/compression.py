"""Which sources a mosaic's own compression took alike of, as JPEG does in squares of 8 px.

What is compressed again in the squares that it was compressed in before comes out as it was, nearly to the bit; what
lay in other squares, was not compressed yet or was brought to other tones loses several per cent of its fine detail,
more or less by how the squares lie in each other. All may be in one mosaic, and the ground of one tells nothing of what
another leaves over.
"""
from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from ..seam_cells import UNKNOWN, present
from .boxes import square_sums
from .followed_source import LEAST_ENERGY

JPEG_SQUARE_PX = 8

_MIN_SURE = 4.0  # standard errors, along both axes: that there are squares; chance reaches 3
_MIN_TOLD = 2.0  # the same at places that are known
_MIN_SAME = 0.75  # of the mosaic's edges, that a source in the same squares has at their places
MORE_LEFT = 8.0  # times as much as the source that came out best leaves over: rounded anew, though in its own squares
_MIXED = 0.25  # of the squares, that are not believed
_EXACT = 1e-3  # of the fine detail, that is left over of what came out as it was
_MOST_ROUNDED = 0.4  # of the fine detail, that rounding anew takes; other images of the same ground leave over more
_EVERY = 2  # lines apart are looked at
_MOST_EDGE = 3.0  # times the differences beside it, that one edge counts

Alike = tuple[frozenset[int], ...]
"""Numbers of the sources in groups, first those that came out as they were; none where all are alike."""


def compressed_alike(
    mosaic: np.ndarray, sources: Mapping[int, np.ndarray], labels: np.ndarray, patch_px: int = 0
) -> Alike:
    """The sources that are followed by how their squares lie in the mosaic's.

    High-passed planes (rows, columns), ``labels`` which source is followed, uint8, ``UNKNOWN`` for none. ``patch_px``:
    side of the patches that all of them consist of.
    """
    numbers = present(labels)
    if len(numbers) < 2:
        return ()
    own = _Edges(mosaic, patch_px)
    errors = {number: own.errors(labels == number) for number in numbers}
    shown = [_places(of) for of in errors.values()]
    places = _places(own.errors(labels != UNKNOWN)) or next(filter(None, shown), None)
    if places is None or any(one not in (None, places) for one in shown):
        return ()  # nor was a mosaic compressed where only its sources were, each in squares of its own
    groups: dict[tuple[object, ...], set[int]] = {}
    for number in numbers:
        seen = sources[number] != 0
        its = _Edges(sources[number], patch_px).errors(seen)
        edges, same = (of[(0, 1), places] for of in (own.errors(seen), its))
        in_same = (edges >= _MIN_TOLD) & (same >= _MIN_SAME * edges)
        lies: tuple[object, ...] = places if in_same.all() else _places(its) or (None, *in_same.tolist())
        if (errors[number][(0, 1), places] < _MIN_TOLD).any():
            lies = ()  # this one alone was not compressed
        groups.setdefault(lies, set()).add(number)
    left = {number: _left_over(mosaic, sources[number], labels == number) for number in numbers}
    most = max(MORE_LEFT * min(left.values()), _EXACT)
    if groups.keys() <= {places, ()} and max(left.values()) <= most:
        return ()  # all came out as they were
    same_squares = groups.pop(places, set())
    anew = {number for number in same_squares if most < left[number] <= _MOST_ROUNDED}
    found = (same_squares - anew, *filter(None, (anew, *groups.values())))
    return tuple(map(frozenset, found)) if sum(map(bool, found)) > 1 else ()


def _left_over(mosaic: np.ndarray, source: np.ndarray, followed: np.ndarray) -> float:
    """What its source leaves over of the mosaic's fine detail in all but a quarter of the squares, where it may be
    mixed with another; 0 where there is none."""
    side = JPEG_SQUARE_PX
    own, energy, shared = (square_sums(*two, side) for two in ((mosaic,) * 2, (source,) * 2, (mosaic, source)))
    middles = followed[side // 2 :: side, side // 2 :: side][: own.shape[0], : own.shape[1]]
    of = middles & (np.minimum(own, energy) > LEAST_ENERGY * side**2)
    explained = np.square(shared[of]) / (own[of] * energy[of])
    return 1 - float(np.quantile(explained, _MIXED)) if len(explained) else 0.0


def shows_squares(mosaic: np.ndarray) -> bool:
    """Whether a high-passed plane (rows, columns) was compressed in squares."""
    return _places(_Edges(mosaic, 0).errors(mosaic != 0)) is not None


class _Edges:
    """How much greater the difference between neighbours is than those on either side (Wang and Bovik 2000)."""

    def __init__(self, plane: np.ndarray, patch_px: int) -> None:
        self._edges = [_edges(one[::_EVERY]) for one in (plane, plane.T)]
        self._patch_px = patch_px

    def errors(self, where: np.ndarray) -> np.ndarray:
        """By axis, columns first, and place within a square, (2, 8): the mean above that of all places, in standard
        errors; 0 where nothing is known."""
        return np.stack([self._errors(edges, one) for edges, one in zip(self._edges, (where, where.T))])

    def _errors(self, edges: np.ndarray, where: np.ndarray) -> np.ndarray:
        where, place = where[::_EVERY], np.arange(2, where.shape[1] - 1)
        known = where[:, 2:-1] & where[:, :-3] & where[:, 3:]
        if self._patch_px:
            known = known & np.isin(place % self._patch_px, np.arange(2, self._patch_px - 1))
        # One long edge of the ground is one event, and not as many as it has pixels.
        counts, sums = np.add.reduce(known.view(np.uint8), axis=0, dtype=np.uint32), np.einsum("ij,ij->j", edges, known)
        total = max(int(counts.sum()), 1)
        means = sums / np.maximum(counts, 1)
        spread = (counts * np.square(means - sums.sum() / total)).sum() / total
        weight, weighted, squares = (
            np.bincount(place % JPEG_SQUARE_PX, of, JPEG_SQUARE_PX) for of in (counts, sums, counts.astype(float) ** 2)
        )
        lines = weight**2 / np.maximum(squares, 1)
        above = weighted / np.maximum(weight, 1) - sums.sum() / total
        return np.asarray(above * np.sqrt(lines / max(spread, 1e-12)))


def _places(errors: np.ndarray) -> tuple[int, int] | None:
    """Column and row of the edges within a square, by the ``errors`` of all places; None where there are none."""
    column, row = errors.argmax(axis=1).tolist()
    return (column, row) if errors.max(axis=1).min() >= _MIN_SURE else None


def _edges(plane: np.ndarray) -> np.ndarray:
    """Along rows, (rows, columns - 3): of the step to column 2 and on."""
    steps = np.abs(np.diff(plane, axis=1))
    beside = steps[:, :-2] + steps[:, 2:]
    return np.clip((steps[:, 1:-1] - beside / 2) / (1 + beside), -1, _MOST_EDGE)
