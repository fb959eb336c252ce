"""The source that a mosaic follows, pixel by pixel, and where it mixes two of them.

The fingerprint is the fine detail: a mosaic carries the very noise of the source that its pixels were taken from, so
the local correlation of the high-passed mosaic with that source's is near 1, whatever gain, bias or gamma was
applied. Where images were feathered no single source explains the mosaic, and a mixture of two does.

Sums of products are taken over cells of 4 x 4 px, and everything else is computed on those. The scan asks the same
rule of its patches: own = sum m m, energy = sum s s, shared = sum m s, common = sum s1 s2 of high-passed planes,
the mosaic's m and the sources' s, arrays of one shape.
"""
from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np
from scipy import ndimage

from ..seam_cells import UNKNOWN
from .boxes import PIECE_PX, box_means, enlarged, near_border, square_sums

MIN_WINNER_LEAD = 0.1  # of the correlation over the next source's
MIN_LEFT_FACTOR = 2.0  # or that the next leaves this many times as much unexplained: images of one scene are alike
MIN_LIKELIHOOD = 50.0  # logarithm of the ratio of two sources': within 12 px one leaves twice as much as the other
MIN_MIXTURE_FIT = 0.9  # share of the mosaic's fine detail that a mixture of two explains; a hard cut stays below
MIN_MIXTURE_GAIN = 0.05  # by which the mixture has to explain more than the better source alone
MIN_MIXTURE_WEIGHT = 0.1  # of each of the two sources
LEAST_ENERGY = 1e-2  # DN squared a pixel, below what rounding to whole values leaves
MIN_TEXTURED = 8  # times that: with less there is nothing to tell a source by


def local_correlation(mosaic: np.ndarray, energy: np.ndarray, shared: np.ndarray) -> np.ndarray:
    """Correlation of the mosaic with a source; energies above zero."""
    return np.asarray(shared / np.sqrt(mosaic * energy))


def highest(values: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Index of the highest of several arrays, and its lead over the next; of one alone the value itself."""
    first, *others = values
    index, second = np.zeros(first.shape, np.intp), np.zeros_like(first) if not others else np.full_like(first, -np.inf)
    for number, other in enumerate(others, 1):
        np.copyto(index, number, where=other > first)
        second = np.maximum(second, np.minimum(first, other))
        first = np.maximum(first, other)
    return index, first - second


def is_sure(correlation: np.ndarray, lead: np.ndarray) -> np.ndarray:
    """Whether the source of highest correlation is followed for sure."""
    left_over, next_left_over = 1 - np.maximum(correlation, 0) ** 2, 1 - np.maximum(correlation - lead, 0) ** 2
    return np.asarray((lead >= MIN_WINNER_LEAD) | (next_left_over >= MIN_LEFT_FACTOR * left_over))


def is_likelier(left_over: np.ndarray, next_left_over: np.ndarray, pixels: int) -> np.ndarray:
    """Whether so many pixels tell which of two sources is followed, by what each leaves over: with Gaussian noise the
    likelihood goes with that to the power of minus half of the pixels."""
    return np.asarray(next_left_over >= math.exp(2 * MIN_LIKELIHOOD / pixels) * left_over)


def mixtures(
    mosaic: np.ndarray, energies: Mapping[int, np.ndarray], shared: Mapping[int, np.ndarray],
    common: Callable[[int, int], np.ndarray], least_fit: float = MIN_MIXTURE_FIT,
) -> tuple[np.ndarray, np.ndarray]:
    """Places where two sources together explain the mosaic and neither does alone, and the share that two explain.

    Least squares for the weights of every two, both of which have to take part; energies above zero. ``least_fit``:
    share that two have to explain.
    """
    alone, explained = np.zeros_like(mosaic), np.zeros_like(mosaic)
    for i in energies:
        np.maximum(alone, np.maximum(shared[i], 0) ** 2 / (mosaic * energies[i]), out=alone)
    for i, j in combinations(energies, 2):
        a, b = weights_of_two(energies[i], energies[j], shared[i], shared[j], common(i, j))
        takes_part = np.minimum(a, b) > MIN_MIXTURE_WEIGHT * (a + b)  # never where they add up to less than 0
        np.maximum(explained, np.where(takes_part, (a * shared[i] + b * shared[j]) / mosaic, 0), out=explained)
    return (explained > least_fit) & (explained > alone + MIN_MIXTURE_GAIN), explained


def weights_of_two(
    energy_i: np.ndarray, energy_j: np.ndarray, shared_i: np.ndarray, shared_j: np.ndarray, common: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Weights with which two sources together come nearest to the mosaic, by least squares; energies above zero."""
    determinant = 1.001 * energy_i * energy_j - common**2
    return (
        (shared_i * energy_j - shared_j * common) / determinant, (shared_j * energy_i - shared_i * common) / determinant
    )


MIN_FOLLOWED_SHARE = 0.005  # of a window's pixels: sources that win fewer do not count
MIN_EXPLAINED = 0.5  # of the mosaic's fine detail within 36 px; a source 2 px off explains 0.1, a blur of 1.2 px 0.6

FINE_CELL_PX = 4
NEAR_CELLS, WIDE_CELLS = 3, 9
"""A side of what is looked at together: 12 px, in which a mixture's weights are even, and 36 px where those do not
decide."""
_MIXED = 2  # cells a side in which the weights of a mixture are taken as constant: 8 px, less than a feather's width


@dataclass(frozen=True, eq=False)
class FollowedSource:
    """What the mosaic was made from in one window."""

    labels: np.ndarray
    """(rows, columns) uint8: index of the source that the mosaic follows, everywhere."""
    clear: np.ndarray
    """(rows, columns) bool: where one source wins clearly."""
    mixed: np.ndarray
    """(rows, columns) bool: where it is a mixture of two sources."""
    shares: tuple[float, ...]
    """Share of the pixels that follow each source."""
    fit: float
    """Share of the mosaic's fine detail that its sources explain, 0 to 1, the mean over the window."""
    unexplained: np.ndarray
    """(rows, columns) bool: where the sources explain less than half of the mosaic's fine detail."""
    likely: np.ndarray
    """(rows, columns) bool: where one source wins clearly, or within 36 px is far likelier than the next."""

    @property
    def mixed_share(self) -> float:
        """Share of the pixels where the mosaic is a mixture of two sources."""
        return float(self.mixed.mean())

    @property
    def unclear_share(self) -> float:
        """Share of the pixels where no source wins clearly."""
        return 1 - int(np.count_nonzero(self.clear)) / self.clear.size

    @property
    def followed(self) -> tuple[int, ...]:
        """Indices of the sources that the mosaic was made from, those with most pixels first."""
        order = np.argsort(self.shares)[::-1]
        return tuple(int(i) for i in order if self.shares[i] >= MIN_FOLLOWED_SHARE)

    def with_known(self, known: np.ndarray) -> FollowedSource:
        """Followed sources where labels are known, (rows, columns) uint8, else ``UNKNOWN``: they decide what is
        followed, and that sources are mixed along the borders between them alone."""
        is_known = known != UNKNOWN
        parts, _ = ndimage.label(self.mixed[::FINE_CELL_PX, ::FINE_CELL_PX])
        meeting = np.unique(parts[near_border(known, FINE_CELL_PX)[::FINE_CELL_PX, ::FINE_CELL_PX]])
        along_borders = enlarged(np.isin(parts, meeting[meeting > 0]), FINE_CELL_PX, known.shape)
        mixed = self.mixed & (along_borders | ~is_known)
        labels = np.where(is_known, known, self.labels)
        counts = np.bincount(labels.ravel(), minlength=len(self.shares))[: len(self.shares)]
        clear = np.where(is_known, ~mixed, self.clear)
        return replace(self, labels=labels, clear=clear, mixed=mixed, shares=tuple((counts / labels.size).tolist()))


HIGH_PASS_PX = 3
"""How far what a pixel is smoothed with reaches."""


def high_pass(band: np.ndarray) -> np.ndarray:
    """A band (rows, columns) less its smoothed self, in float32: what is finer than a Gaussian of about 2 px."""
    fine = np.empty(band.shape, np.float32)
    for start in range(0, len(band), PIECE_PX):
        rows, first = slice(start, start + PIECE_PX), max(start - HIGH_PASS_PX, 0)
        smooth = part = band[first : rows.stop + HIGH_PASS_PX].astype(np.float32, copy=False)
        for spacing in (1, 2):  # binomials with holes: variance 1/2 and 2 px squared along each axis
            for axis in (0, 1):
                smooth = _binomial(smooth, spacing, axis)
        inner = slice(start - first, start - first + PIECE_PX)
        np.multiply(smooth[inner], np.float32(-1 / 256), out=fine[rows])
        fine[rows] += part[inner]
    return fine


def follow_planes(fine: Sequence[np.ndarray]) -> FollowedSource:
    """The source that a mosaic follows; ``fine``: its fine detail (``high_pass``), then that of the sources, each
    (rows, columns), on one grid."""
    mosaic, *sources = fine
    mosaic_energy = square_sums(mosaic, mosaic, FINE_CELL_PX)
    energies = [square_sums(source, source, FINE_CELL_PX) for source in sources]
    shared = [square_sums(mosaic, source, FINE_CELL_PX) for source in sources]
    near, wide = _correlations(mosaic_energy, energies, shared)
    winner, lead = highest(near)
    if len(sources) > 1:
        winner = np.where(lead < MIN_WINNER_LEAD, highest(wide)[0], winner)  # else a wider neighbourhood decides
        # Each cell follows the majority of its 3 x 3 neighbours.
        winner = highest([box_means(winner == i, (3,), mirrored=True)[0] for i in range(len(sources))])[0]
    mixed, explained = _mixtures(sources, mosaic_energy, energies, shared, winner)
    best = np.take_along_axis(np.stack(near), winner[np.newaxis], axis=0)[0]
    textured = mosaic_energy > LEAST_ENERGY * FINE_CELL_PX**2
    clear = ~mixed & (is_sure(best, lead) | ~textured)
    fit = np.maximum(explained, np.maximum(best, 0) ** 2)
    unexplained = _around(np.where(textured, fit, 1))[1] < MIN_EXPLAINED
    top_of_wide, wide_lead = np.max(wide, axis=0), highest(wide)[1]
    pixels = (WIDE_CELLS * FINE_CELL_PX) ** 2
    likely = clear | is_likelier(1 - top_of_wide**2, 1 - np.maximum(top_of_wide - wide_lead, 0) ** 2, pixels)
    return FollowedSource(
        enlarged(winner.astype(np.uint8), FINE_CELL_PX, mosaic.shape),
        enlarged(clear, FINE_CELL_PX, mosaic.shape),
        enlarged(mixed, FINE_CELL_PX, mosaic.shape),
        tuple((np.bincount(winner.ravel(), minlength=len(sources)) / winner.size).tolist()),
        float(fit[textured].mean()) if textured.any() else 0.0,
        enlarged(unexplained, FINE_CELL_PX, mosaic.shape),
        enlarged(likely, FINE_CELL_PX, mosaic.shape),
    )


def _binomial(band: np.ndarray, spacing: int, axis: int) -> np.ndarray:
    """One, two, one times the samples ``spacing`` apart; the edge continues as it is."""
    if axis:
        return _binomial(band.T, spacing, 0).T
    length = len(band)
    pairs = np.empty_like(band, shape=(length + spacing, band.shape[1]))
    np.add(band[:-spacing], band[spacing:], out=pairs[spacing:length])
    np.add(band[:spacing], band[:1], out=pairs[:spacing])
    np.add(band[-spacing:], band[-1:], out=pairs[length:])
    return pairs[:-spacing] + pairs[spacing:]


def _correlations(
    mosaic_energy: np.ndarray, energies: Sequence[np.ndarray], shared: Sequence[np.ndarray]
) -> tuple[list[np.ndarray], list[np.ndarray]]:
    """Local correlation of the mosaic with each source, (cell rows, cell columns), near and wide."""
    least = np.float32(LEAST_ENERGY * FINE_CELL_PX**2)
    of_mosaic = [energy + least for energy in _around(mosaic_energy)]
    correlations = []
    for energy, product in zip(energies, shared):
        for mosaic, of_source, both in zip(of_mosaic, _around(energy), _around(product)):
            correlations.append(local_correlation(mosaic, of_source + least, both))
    return correlations[0::2], correlations[1::2]


def _around(products: np.ndarray) -> list[np.ndarray]:
    """Means over the near and the wide squares of cells."""
    return box_means(products, (NEAR_CELLS, WIDE_CELLS), mirrored=True)


def _mixtures(
    sources: Sequence[np.ndarray],
    mosaic_energy: np.ndarray,
    energies: Sequence[np.ndarray],
    shared: Sequence[np.ndarray],
    winner: np.ndarray,
) -> tuple[np.ndarray, np.ndarray]:
    """Cells in which two sources together explain the mosaic and neither does alone, and how much they explain; only
    sources that win somewhere are mixed."""
    wins = np.bincount(winner.ravel(), minlength=len(sources))
    followed = [i for i, count in enumerate(wins) if count >= MIN_FOLLOWED_SHARE * winner.size]
    return mixtures(
        _together(mosaic_energy) + LEAST_ENERGY,
        {i: _together(energies[i]) + LEAST_ENERGY for i in followed},
        {i: _together(shared[i]) for i in followed},
        lambda i, j: _together(square_sums(sources[i], sources[j], FINE_CELL_PX)),
    )


def _together(products: np.ndarray) -> np.ndarray:
    """Means, a pixel, of squares of two cells a side: each with those before it."""
    down = products + np.concatenate([products[:1], products[:-1]])
    sums = down + np.concatenate([down[:, :1], down[:, :-1]], axis=1)
    sums *= np.float32((_MIXED * FINE_CELL_PX) ** -2)
    return sums
