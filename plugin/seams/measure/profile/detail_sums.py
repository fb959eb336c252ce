"""What a mosaic has of its sources' detail: sums of products over small cells and distances from the seam.

m are detail coefficients of the mosaic. s are those of the source that is followed where the coefficient lies, o those
of the one beyond the nearest seam, both as the mosaic shows its sources. Neither is taken from a cut image: beside a
cut its coefficients hold the cut's own edge, which no source has. k is that edge: the cut image's coefficients less s.
Where more than two sources are mixed, o is all that s is mixed with, each by its share.
"""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy import ndimage
from scipy.sparse import csc_matrix

from ..following.boxes import enlarged, narrowed
from ..following.expected_mosaic import ExpectedMosaic
from ..following.meeting import SHARES_PX
from ..seam_cells import UNKNOWN
from .cell_table import CELL_PX, EDGES_PX, FARTHEST, MIXED_BINS, PRODUCTS, CellTable, MixtureTable

MOSAIC, CUT, FIRST_SOURCE = range(3)
"""Planes of details."""

_AREA, _SS, _OO, _CODEC = map(PRODUCTS.index, ("area", "ss", "oo", "codec"))
_SHOWN, _BEFORE = ([PRODUCTS.index(name) for name in names] for names in (("ss", "so", "oo"), ("pp", "pq", "qq")))
_GRID_PX = 2  # distances are taken on the grid of the finest coefficients
_UNKNOWN_MARGIN_PX = 8  # what is not explained reaches into its neighbours' coefficients
ROUNDING = 1e-4
"""Rms of detail as a share of the mean grey: weaker is what float32 leaves of even ground, and no detail."""


def compared_planes(mosaic: np.ndarray, expected: ExpectedMosaic) -> np.ndarray:
    """Planes (planes, rows, columns) whose details are compared: the mosaic, its hard cut, and where sources meet each
    of them as the mosaic shows it, in the order of their numbers; then, if that differs, before anything came over the
    mosaic."""
    ways = (expected.shown, expected.toned) if expected.is_filtered else (expected.shown,)
    return np.stack([mosaic, expected.plane, *(way[number] for way in ways for number in numbers_of(expected))])


def numbers_of(expected: ExpectedMosaic) -> tuple[int, ...]:
    """The sources that meet; none where all follow one, which the cut then is."""
    return tuple(sorted(expected.shown)) if len(expected.shown) > 1 else ()


def energy_of_rounding(plane: np.ndarray) -> float:
    """Most energy of rounding, a pixel, DN squared, in details of planes as bright as this one, (rows, columns)."""
    return float((ROUNDING * np.abs(plane).mean()) ** 2)


@dataclass(frozen=True, eq=False)
class SeamGeometry:
    """The course of a window's seams, on the grid of the finest coefficients, (rows / 2, columns / 2) each."""

    labels: np.ndarray
    """uint8: the source that is followed."""
    other: np.ndarray
    """uint8: the one beyond the nearest seam, ``UNKNOWN`` where there is none."""
    bins: np.ndarray
    """int: of distance from the seam; ``len(EDGES_PX)`` where no source explains the mosaic."""


@dataclass(frozen=True, eq=False)
class MeetingSources:
    """The sources whose details are compared with a mosaic's, and where each is followed."""

    labels: np.ndarray
    """(rows, columns) uint8: the source that each pixel follows; pixels of ``UNKNOWN`` take no part."""
    numbers: Sequence[int] = ()
    """Numbers of the sources among the ``compared_planes``."""
    shares: Mapping[int, np.ndarray] | None = None
    """Shares of the sources where more than two are mixed (``ExpectedMosaic``)."""
    is_filtered: bool = False
    """Whether each source is among the planes in both ways."""
    was_compressed: bool = False
    """Whether the mosaic shows traces of a codec."""
    spoilt: np.ndarray | None = None
    """(rows, columns) bool: pixels that take no part (``ExpectedMosaic``)."""

    @classmethod
    def of(cls, expected: ExpectedMosaic) -> MeetingSources:
        """The sources of an expected mosaic."""
        return cls(
            expected.labels, numbers_of(expected), expected.shares, expected.is_filtered, expected.was_compressed,
            expected.spoilt,
        )


def detail_sums(
    details: Sequence[np.ndarray], sources: MeetingSources, of_rounding: float = 0.0
) -> tuple[CellTable, MixtureTable]:
    """The cells of one window from the details of ``compared_planes``, level by level as ``placed_components`` gives
    them: (3, 2 + sources or more, rows / 2^r, columns / 2^r).

    ``of_rounding``: ``energy_of_rounding``; sources with no more have no detail.
    """
    numbers, is_filtered = sources.numbers, sources.is_filtered
    rows, columns = (length // CELL_PX for length in sources.labels.shape)
    place = seam_geometry(sources.labels)
    if sources.spoilt is not None:
        place.bins[sources.spoilt[::_GRID_PX, ::_GRID_PX]] = len(EDGES_PX)
    levels, per_cell = len(details), CELL_PX // _GRID_PX
    whole = np.s_[: rows * per_cell, : columns * per_cell]  # cells
    followed, other, bins = (plane[whole] for plane in (place.labels, place.other, place.bins))
    beside = (bins < MIXED_BINS) & (other != UNKNOWN) & bool(len(numbers))
    others = _among_others(sources.shares or {}, numbers, place.labels)[(slice(None), *whole)]
    cell = np.add.outer(*(np.arange(many * per_cell) // per_cell * by for many, by in ((rows, columns), (columns, 1))))
    # What no source explains, and what lies beside no seam, is left out. Each coarser coefficient lies at a finest one.
    of_bin = _numbered(cell * len(EDGES_PX) + bins, bins < len(EDGES_PX))
    pair = _numbered(followed.astype(np.intp) * (UNKNOWN + 1) + other, beside)
    pairs = len(pair.held)
    of_pair = _numbered((cell * MIXED_BINS + bins) * pairs + pair.number, beside)
    sums = np.zeros((4, levels, len(of_bin.held)))
    mixed = np.zeros((len(PRODUCTS), levels, len(of_pair.held)))
    number = np.full(UNKNOWN + 1, CUT)  # of what no source explains, which takes no part
    number[list(numbers)] = np.arange(FIRST_SOURCE, FIRST_SOURCE + len(numbers))
    for level, detail in enumerate(details):
        pixels = 2 ** (level + 1)
        step, counted = pixels // _GRID_PX, CELL_PX // pixels
        if not counted:
            break  # coefficients larger than a cell tell nothing of a place
        coarse = np.s_[step // 2 :: step, step // 2 :: step]
        detail = np.ascontiguousarray(detail[..., : rows * counted, : columns * counted])
        size = rows * columns * counted**2
        planes = detail.reshape(3, -1)  # by one number each, and whole rows first: a third of the time
        here, there = (np.take(number, labels[coarse].ravel()) for labels in (followed, other))
        m, c = (detail[:, plane].reshape(3, size) for plane in (MOSAIC, CUT))
        s = np.take(planes, here * size + np.arange(size), axis=1) if numbers else c
        _add(sums[:, level], of_bin.number[coarse], pixels**2, ((m, m), (s, s), (m, s)))
        if not pairs:
            continue
        index = of_pair.number[coarse].ravel()
        at = np.flatnonzero(index < len(of_pair.held))
        m, c, s = (np.take(plane, at, axis=1) for plane in (m, c, s))
        o = np.take(planes, there[at] * size + at, axis=1)
        among = others[(slice(None), *coarse)].reshape(len(others), size)[:, at]
        o = _beyond(o, detail, at, among, FIRST_SOURCE)
        k = c - s
        products = [(m, m), (m, s), (m, o), (m, k), (s, s), (s, o), (s, k), (o, o), (o, k), (k, k)]
        if is_filtered:
            p, q = (np.take(planes, (side[at] + len(numbers)) * size + at, axis=1) for side in (here, there))
            q = _beyond(q, detail, at, among, FIRST_SOURCE + len(numbers))
            products += [(p, p), (p, q), (q, q)]
        _add(mixed[:, level], np.take(index, at), pixels**2, products)
    if not is_filtered:
        mixed[_BEFORE] = mixed[_SHOWN]
    mixed[_CODEC] = mixed[_AREA] * sources.was_compressed
    sums[2:, sums[2] <= of_rounding * sums[0]] = 0
    mixed[1:, np.maximum(mixed[_SS], mixed[_OO]) <= of_rounding * mixed[_AREA]] = 0
    row, column, near_bin, which = _unravelled(of_pair.held, (rows, columns, MIXED_BINS, max(pairs, 1)))
    source, beyond = np.divmod(pair.held[which], UNKNOWN + 1)
    return (
        CellTable(*_unravelled(of_bin.held, (rows, columns, len(EDGES_PX))), *sums.astype(np.float32)),
        MixtureTable(row, column, near_bin, source.astype(np.uint8), beyond.astype(np.uint8), mixed.astype(np.float32)),
    )


def _unravelled(codes: np.ndarray, shape: tuple[int, ...]) -> Iterator[np.ndarray]:
    """Row, column and bin, and what else codes are made of, as tables hold them."""
    for numbers, kind in zip(np.unravel_index(codes, shape), (np.int32, np.int32, np.uint8, np.intp)):
        yield numbers.astype(kind)


@dataclass(frozen=True, eq=False)
class _Numbered:
    """Samples of the finest grid by what they are counted to."""

    held: np.ndarray
    """(n,) codes of what there is, ascending."""
    number: np.ndarray
    """int, as the samples: which of them; their count where a sample is left out."""


def _numbered(codes: np.ndarray, where: np.ndarray) -> _Numbered:
    held = np.flatnonzero(np.bincount(codes[where]))
    number = np.full(codes.max(initial=0) + 1, len(held), np.int32)
    number[held] = np.arange(len(held))
    return _Numbered(held, np.where(where, np.take(number, codes), np.int32(len(held))))


def _add(
    sums: np.ndarray, number: np.ndarray, pixels: int, products: Sequence[tuple[np.ndarray, np.ndarray]]
) -> None:
    """Area and products of three details each, (3, n), by the number of every sample, (n,); into (sums, numbers). As
    one product with a sparse matrix: a third of the time that it takes to count one by one."""
    count, size = sums.shape[1], number.size
    values = np.empty((size, 1 + len(products)), products[0][0].dtype)
    values[:, 0] = pixels
    for place, (a, b) in enumerate(products, 1):
        np.einsum("dn,dn->n", a, b, out=values[:, place])
    each = csc_matrix((np.ones(size, values.dtype), number.ravel(), np.arange(size + 1)), shape=(count + 1, size))
    sums[: len(products) + 1] = (each @ values)[:count].T


def seam_geometry(labels: np.ndarray) -> SeamGeometry:
    """Distances from the nearest seam, and what lies beyond it."""
    coarse = np.ascontiguousarray(labels[::_GRID_PX, ::_GRID_PX])
    seam, beyond = seam_samples(labels)
    other = np.full(coarse.shape, UNKNOWN, np.uint8)
    if seam.any():
        row, column = ndimage.distance_transform_edt(~seam, return_distances=False, return_indices=True)
        nearest = row * coarse.shape[1] + column
        here, there = np.take(coarse, nearest), np.take(beyond, nearest)
        np.copyto(other, there, where=coarse == here)
        np.copyto(other, here, where=coarse == there)
        row -= np.arange(len(seam), dtype=row.dtype)[:, np.newaxis]
        column -= np.arange(seam.shape[1], dtype=column.dtype)
        row *= row
        column *= column
        row += column
        bins = np.take(_bins_of_squares(), np.minimum(row, (EDGES_PX[-1] // _GRID_PX) ** 2, out=row))
    else:
        bins = np.full(seam.shape, FARTHEST, np.intp)
    explained = explained_samples(labels)
    if not explained.all():
        bins[~explained] = len(EDGES_PX)
    return SeamGeometry(coarse, other, bins)


def explained_samples(labels: np.ndarray) -> np.ndarray:
    """Samples on the grid of the finest coefficients that take part, (rows / 2, columns / 2) bool."""
    return narrowed(labels[::_GRID_PX, ::_GRID_PX] != UNKNOWN, _UNKNOWN_MARGIN_PX // _GRID_PX)


def seam_samples(labels: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Samples on the grid of the finest coefficients, (rows / 2, columns / 2), beside which another source is followed,
    bool, and the source that each of them meets, uint8."""
    coarse = labels[::_GRID_PX, ::_GRID_PX]
    known = coarse != UNKNOWN
    seam, beyond = np.zeros(coarse.shape, bool), np.full(coarse.shape, UNKNOWN, np.uint8)
    for here, there in ((np.s_[:, :-1], np.s_[:, 1:]), (np.s_[:-1], np.s_[1:])):
        meet = (coarse[here] != coarse[there]) & known[here] & known[there]
        for side, opposite in ((here, there), (there, here)):
            seam[side] |= meet
            np.copyto(beyond[side], coarse[opposite], where=meet)
    return seam, beyond


def _among_others(shares: Mapping[int, np.ndarray], numbers: Sequence[int], labels: np.ndarray) -> np.ndarray:
    """Share of each source among those that are not followed, (sources, rows, columns) on the grid of the labels; 0
    where there is one at most. Without sources where none are mixed."""
    if not shares:
        return np.zeros((0, *labels.shape))
    squares = (enlarged(shares[number], SHARES_PX // _GRID_PX, labels.shape) for number in numbers)
    among = np.stack([np.where(labels == number, 0, share) for number, share in zip(numbers, squares)])
    among[:, np.count_nonzero(among, axis=0) < 2] = 0
    return np.asarray(among / np.maximum(among.sum(axis=0), 1e-9))


def _beyond(beyond: np.ndarray, details: np.ndarray, at: np.ndarray, among: np.ndarray, first: int) -> np.ndarray:
    """Details of the other side, (3, n), at the places ``at``: as found, or by the shares ``among``, (sources, n), of
    the planes from ``first`` on, where there are any."""
    some = np.flatnonzero(among.any(axis=0))
    if len(some):
        planes = details[:, first : first + len(among)].reshape(3, len(among), -1)
        beyond[:, some] = np.einsum("dsn,sn->dn", planes[..., at[some]], among[:, some])
    return beyond


@cache
def _bins_of_squares() -> np.ndarray:
    """The bin of each squared distance, samples of the grid squared."""
    squares = np.arange((EDGES_PX[-1] // _GRID_PX) ** 2 + 1)
    return np.digitize(np.sqrt(squares) * _GRID_PX, EDGES_PX) - 1
