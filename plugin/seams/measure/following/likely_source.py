"""Where exactly a mosaic passes from one source to another: to that which leaves least of its fine detail unexplained.

The correlation that finds what a mosaic follows leans towards the stronger of two sources where they meet. What a
source leaves over does not: beside a seam it grows alike on either side, and in a feather the border lies where both
weigh the same. What compression made of weak detail is expected of every source.
"""
from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ..profile.energy_response import EnergyResponse, fit_response, log_energies, sampled
from .boxes import box_means, enlarged, near_border, opened
from .followed_source import CELL_PX, sums_over_cells

MIN_UNEXPLAINED = 0.4  # of the way from what a source leaves over elsewhere to what a stranger would
MIN_FIT = 0.05  # of the mosaic's detail where a source is followed; strangers explain 0.01 to 0.03
MIN_UNEXPLAINED_BY_ONE = 0.15  # where one source alone is followed there is no mixture that it could be half of
MIN_ALIKE_FIT = 0.75  # another image of the same flight, moved to where it fits best, explains 0.55 to 0.7
MIN_ALIKE_FACTOR = 20.0  # by which one that stands in for another leaves more than those that are truly followed
MIN_TEXTURE = 0.3  # of the energy that a source would have
MAX_EXPECTED = 0.7  # of what a stranger leaves over
MAX_LEARNED = 0.25  # of the way to a stranger: squares that a source explains better tell what it leaves over
SMALLEST_PART_PX = 600  # pixels of one source on their own that are believed; a square of 24 px

_WIDE_WEIGHT = 0.1  # of the wider neighbourhood: it decides only where the near one doesn't
_INSIDE_PX = 8  # from the border that is known so far
_FEWEST_PX = 1600  # that follow a source for sure, for the others to be left out
_FEWEST_LEARNED_PX = 800
_BEST = 0.6  # quantile of the squares' fit that is begun with
_ROUNDS = 5
_LEAST_ENERGY = 1e-2  # DN squared a pixel
_PIECE_PX = 128  # rows multiplied at a time, so that what lies between two passes stays in the cache


@dataclass(frozen=True)
class Sampling:
    """How closely sources are told from each other."""

    grid_px: int
    """Side of the squares that are summed up."""
    near: int
    """Squares a side that are looked at together, odd."""
    wide: int
    """The same where those don't decide, odd."""
    strip: int
    """Squares: what a seam leaves unexplained along itself is no part of a source."""

    def sums(self, a: np.ndarray, b: np.ndarray) -> np.ndarray:
        """Of the products over the squares, (rows, columns)."""
        return _sums(a, b) if self.grid_px == 2 else sums_over_cells(a, b)

    def squares(self, pixels: int) -> int:
        """So many pixels."""
        return pixels // self.grid_px**2


FINE = Sampling(2, 7, 17, 7)
"""14 and 34 px."""
QUICK = Sampling(CELL_PX, 3, 9, 4)
"""12 and 36 px, a third of the time: for labels whose borders are then moved to the pixel."""


@dataclass(frozen=True, eq=False)
class LikelySource:
    """The most likely source of every pixel."""

    labels: np.ndarray
    """(rows, columns) uint8"""
    unexplained: np.ndarray
    """(rows, columns) bool: where not even that one explains the mosaic's fine detail."""


def likely_source(
    mosaic: np.ndarray,
    sources: Mapping[int, np.ndarray],
    labels: np.ndarray,
    clear: np.ndarray,
    valid: Mapping[int, np.ndarray],
    moved: Collection[int] = (),
    sampling: Sampling = FINE,
) -> LikelySource:
    """Of ``sources``, high-passed planes as ``mosaic``, (rows, columns), those that it follows by a first estimate.

    ``labels``, ``clear`` (rows, columns): that estimate, and where it is sure. ``valid``: pixels that a source has, of
    those that don't have all. ``moved``: sources that lie elsewhere than where they were given.
    """
    near_side, wide_side, step = sampling.near, sampling.wide, sampling.grid_px
    grid = np.s_[::step, ::step]
    least_energy = _LEAST_ENERGY * step**2
    first = np.ascontiguousarray(labels[grid])
    sure = clear[grid] & ~near_border(first, _INSIDE_PX // step)
    own = sampling.sums(mosaic, mosaic)
    near, wide = box_means(own, (near_side, wide_side))
    costs, rests, fits = [], [], []
    for i, plane in sources.items():
        energy, shared = sampling.sums(plane, plane), sampling.sums(mosaic, plane)
        energy_near, energy_wide = box_means(energy, (near_side, wide_side))
        shared_near, shared_wide = box_means(shared, (near_side, wide_side))
        own_part = first == i if i not in valid else (first == i) & valid[i][grid]
        where = np.flatnonzero(own_part & sure)
        if len(where) < sampling.squares(_FEWEST_PX):
            where = np.flatnonzero(own_part if own_part.any() else first == i)
        gain, response, fit = _learned(
            sampled(where), wide, energy_wide, shared_wide, sampling.squares(_FEWEST_LEARNED_PX)
        )
        logs_wide = log_energies(energy_wide)
        gain_wide = gain.at(logs_wide)
        cost, _ = _left_over(near, energy_near, shared_near, gain(energy_near))
        left_wide, _ = _left_over(wide, energy_wide, shared_wide, gain_wide)
        left_wide *= _WIDE_WEIGHT
        cost += left_wide
        left, stranger = _left_over(own, energy, shared, gain_wide)
        rest = np.stack([left, stranger, np.minimum(response.at(logs_wide) * energy, MAX_EXPECTED * stranger)])
        fits.append(fit)
        if i in valid:
            missing = ~valid[i][grid]
            cost[missing] = np.inf
            rest[:2, missing], rest[2, missing] = own[missing] + 1, 0
        costs.append(cost)
        rests.append(rest)
    for i, fit, rest in zip(sources, fits, rests):
        stands_in = fit < MIN_ALIKE_FIT and 1 - fit > MIN_ALIKE_FACTOR * (1 - max(fits))
        if fit < MIN_FIT or stands_in or (i in moved and fit < MIN_ALIKE_FIT):
            rest[0], rest[2] = rest[1], 0.0
    numbers, rest = _least(list(sources), costs, rests)
    found = without_islands(numbers, sampling.squares(SMALLEST_PART_PX))
    limit = MIN_UNEXPLAINED if len(sources) > 1 else MIN_UNEXPLAINED_BY_ONE
    unexplained = opened(_strange(rest, wide, wide_side, least_energy) > limit, sampling.strip)
    unexplained = without_islands(unexplained.view(np.uint8), sampling.squares(SMALLEST_PART_PX)) > 0
    if all(i in valid for i in sources):
        unexplained |= np.logical_and.reduce([~valid[i][grid] for i in sources])
    return LikelySource(enlarged(found, step), enlarged(unexplained, step))


def _strange(rest: np.ndarray, wide: np.ndarray, side: int, least: float) -> np.ndarray:
    """How far what the sources leave over is on the way to what strangers would; ``rest`` (3, rows, columns): left
    over, left over by a stranger, expected to be left over, of the source of every square."""
    (left,), (stranger,), (expected,) = (box_means(sums, (side,)) for sums in rest)
    # Where the mosaic shows nothing of a source's texture it was clipped, or blurred away.
    textured = (wide > least) & ((1 + MIN_TEXTURE) * wide >= MIN_TEXTURE * stranger)
    return np.where(textured, (left - expected) / np.maximum(stranger - expected, least), 0)


def _learned(
    sample: np.ndarray, own: np.ndarray, energy: np.ndarray, shared: np.ndarray, fewest: int
) -> tuple[EnergyResponse, EnergyResponse, float]:
    """The gain of a source by its energy, what it leaves over, and the share that it explains, from squares that follow
    it, ``sample`` by number.

    What it can't explain is no part of it: learned from the squares that it explains best, then from all that are like
    those, round by round.
    """
    own, energy, shared = (sums.ravel()[sample] for sums in (own, energy, shared))
    explains = shared * np.abs(shared) / np.maximum(own * energy, 1e-9)
    chosen = explains >= np.quantile(explains, _BEST)
    for _ in range(_ROUNDS):
        gain = fit_response(energy[chosen], np.maximum(shared[chosen], 0))
        left, stranger = _left_over(own, energy, shared, gain(energy))
        response = fit_response(energy[chosen], np.maximum(left[chosen], 0))
        expected = np.minimum(response(energy) * energy, MAX_EXPECTED * stranger)
        explained = left - expected < MAX_LEARNED * (stranger - expected)
        if np.count_nonzero(explained) < min(fewest, len(own)) or (explained == chosen).all():
            break
        chosen = explained
    return gain, response, _fit(own[chosen], energy[chosen], shared[chosen])


def _left_over(
    own: np.ndarray, energy: np.ndarray, shared: np.ndarray, gain: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """What is left of the mosaic's energy without a source, and what would be without a stranger as strong."""
    weighted = gain * energy
    weighted *= gain
    stranger = own + weighted
    rest = gain * shared
    rest *= -2
    rest += stranger
    return rest, stranger


def _least(
    numbers: list[int], costs: list[np.ndarray], rests: list[np.ndarray]
) -> tuple[np.ndarray, np.ndarray]:
    """The source of least cost, (rows, columns) uint8, and its rest, (3, rows, columns)."""
    found, cost, rest = np.full(costs[0].shape, numbers[0], np.uint8), costs[0], rests[0]
    for number, other, own in zip(numbers[1:], costs[1:], rests[1:]):
        less = other < cost
        np.copyto(found, np.uint8(number), where=less)
        np.copyto(rest, own, where=less)
        np.minimum(cost, other, out=cost)
    return found, rest


def _fit(own: np.ndarray, energy: np.ndarray, shared: np.ndarray) -> float:
    """Share of the mosaic's detail that a source explains where it is followed best."""
    product = float(shared.sum())
    energies = float(own.sum()) * float(energy.sum())
    return product**2 / energies if product > 0 and energies > 0 else 0.0


def without_islands(labels: np.ndarray, least: int) -> np.ndarray:
    """Parts of fewer than ``least`` samples go with what is nearest to them; labels (rows, columns) uint8."""
    numbers = np.flatnonzero(np.bincount(labels.ravel(), minlength=1))
    if len(numbers) == 1:
        return labels
    small = np.zeros(labels.shape, bool)
    for number in numbers.tolist():
        parts, count = ndimage.label(labels == number)
        few = np.bincount(parts.ravel(), minlength=count + 1) < least
        few[0] = False
        if few.any():
            small |= few[parts]
    return filled_in(labels, small)


def filled_in(labels: np.ndarray, open_to: np.ndarray) -> np.ndarray:
    """What is ``open_to`` what surrounds it goes with what is nearest, (rows, columns); labels if all or nothing is."""
    if not open_to.any() or open_to.all():
        return labels
    found, small = labels.copy(), open_to
    islands, _ = ndimage.label(small, np.ones((3, 3)))
    for number, place in enumerate(ndimage.find_objects(islands), 1):
        # What is nearest to an island touches it.
        around = tuple(slice(max(part.start - 1, 0), part.stop + 1) for part in place)
        nearest = ndimage.distance_transform_edt(small[around], return_distances=False, return_indices=True)
        np.copyto(found[around], labels[around][tuple(nearest)], where=islands[around] == number)
    return found


def _sums(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Of the products over squares of 2 px, (rows / 2, columns / 2)."""
    sums = np.empty(tuple(length // 2 for length in a.shape), np.float32)
    for start in range(0, len(a), _PIECE_PX):
        part = slice(start, start + _PIECE_PX)
        product = a[part] * b[part]
        down = product[0::2] + product[1::2]
        np.add(down[:, 0::2], down[:, 1::2], out=sums[start // 2 : (start + _PIECE_PX) // 2])
    return sums
