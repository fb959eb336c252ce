"""The border where a mosaic passes from one source to another: to that which leaves least of its fine detail over.

The correlation that finds what a mosaic follows leans towards the stronger of two sources where they meet. What a
source leaves over does not: beside a seam it grows alike on either side, and in a feather the border lies where both
weigh the same. What compression made of weak detail is expected of every source.
"""
from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations, combinations_with_replacement

import numpy as np
from scipy import ndimage

from ..energy_response import EnergyResponse, fit_response, sampled
from ..seam_cells import is_one_of, present
from .best_ground import (
    MIN_ALIKE_STRANGE,
    MIN_EVEN_LEFT,
    MIN_STAND_IN_FACTOR,
    MIN_STAND_IN_STRANGE,
    MIN_STRANGE,
    BestGround,
    learn_best_ground,
)
from .boxes import box_means, enlarged, narrowed, near_border, opened, square_sums
from .compression import IsCompressed
from .followed_source import (
    CELL_PX,
    LEAST_ENERGY,
    MIN_MIXTURE_WEIGHT,
    NEAR_CELLS,
    WIDE_CELLS,
    is_likelier,
    weights_of_two,
)
from .foreign_ground import NOISE_CELL_PX, CellSums, foreign_ground

MIN_FIT = 0.05  # of the mosaic's detail where a source is followed; strangers explain 0.01 to 0.03
MIN_TEXTURE = 0.3  # of the energy that a source would have
MAX_EXPECTED = 0.7  # of what a stranger leaves over
MAX_LEARNED = 0.25  # of the way to a stranger: squares that a source explains better tell its gain
SMALLEST_PART_PX = 600  # pixels of one source on their own that are believed; a square of 24 px

_WIDE_WEIGHT = 0.1  # of the wider neighbourhood: it decides only where the near one doesn't
_INSIDE_PX = 8  # from the border that is known so far
_FEWEST_PX = 1600  # that follow a source for sure, for the others to be left out
_FEWEST_LEARNED_PX = 800
_BEST = 0.6  # quantile of the squares' fit that is begun with
_ROUNDS = 5
_MIN_TEXTURED = 8  # times the least energy
_STRIP_CELLS = 4  # a side of the least part that no source explains: a seam leaves something over along itself
_ALIKE_CELLS = 12  # the same where a source does resemble it
_MIXED_LEFT = 0.5  # of what one source leaves over: with less a mixture explains the mosaic
_AS_STRONG = 0.85  # of the energy that a source would have, for it to stand in for another
_NOWHERE_FACTOR = 50.0  # times as much as other sources leave over on their ground; resampled ones had 34 to 76
_NOWHERE_SPREAD = 1.45  # between the quartiles of that, by what its best ground leaves over; resampled ones had 1.34
_FOREIGN_LEFT, _FOREIGN_FACTOR = 0.1, 20.0  # as the first: evenly or not, resampled ones left over 0.03 or 14 times
_EVEN_PART, _EVEN_SHARE = 0.5, 0.4  # of what is left over around: most cells leave so much, of a step of tones few do


@dataclass(frozen=True)
class Sampling:
    """How closely sources are told from each other."""

    grid_px: int
    """Side of the squares that are summed up."""
    near: int
    """Squares a side that are looked at together, odd."""
    wide: int
    """Squares a side that decide where those don't, odd."""

    def sums(self, a: np.ndarray, b: np.ndarray) -> np.ndarray:
        """Sums of the products over the squares, (rows, columns)."""
        return square_sums(a, b, self.grid_px)

    def squares(self, pixels: int) -> int:
        """How many squares so many pixels make."""
        return pixels // self.grid_px**2


FINE = Sampling(2, 7, 17)
"""14 and 34 px."""
QUICK = Sampling(CELL_PX, NEAR_CELLS, WIDE_CELLS)
"""12 and 36 px, a third of the time: for labels whose borders are then moved to the pixel."""


@dataclass(frozen=True, eq=False)
class LikelySource:
    """The most likely source of every pixel."""

    labels: np.ndarray
    """(rows, columns) uint8"""
    unexplained: np.ndarray
    """(rows, columns) bool: where not even that one explains the mosaic's fine detail."""
    left_over: float
    """Share of the mosaic's fine detail that it leaves over, the less the better."""


@dataclass(frozen=True, eq=False)
class FineDetail:
    """The fine detail of a mosaic and of the sources that it may follow: high-passed planes, (rows, columns)."""

    mosaic: np.ndarray
    sources: Mapping[int, np.ndarray]
    valid: Mapping[int, np.ndarray] = field(default_factory=dict)
    """(rows, columns) bool: pixels that a source has, of those that don't have all."""
    is_compressed: IsCompressed = lambda number: False
    interpolated: Collection[int] = ()
    """Sources that lie between the mosaic's pixels, which leave more over than others do."""


def likely_source(
    fine: FineDetail, labels: np.ndarray, clear: np.ndarray, sampling: Sampling = FINE
) -> LikelySource:
    """The most likely source of every pixel, of those that the mosaic follows by a first estimate.

    ``labels``, ``clear`` (rows, columns): that estimate, and where it is sure.
    """
    mosaic, sources, valid = fine.mosaic, fine.sources, fine.valid
    near_side, wide_side, step = sampling.near, sampling.wide, sampling.grid_px
    grid = np.s_[::step, ::step]
    first = np.ascontiguousarray(labels[grid])
    sure = clear[grid] & ~near_border(first, _INSIDE_PX // step)
    mosaic_energy = sampling.sums(mosaic, mosaic)
    near, wide = box_means(mosaic_energy, (near_side, wide_side))
    costs, energies, products = [], {}, {}
    for i, plane in sources.items():
        energy, shared = sampling.sums(plane, plane), sampling.sums(mosaic, plane)
        energies[i], products[i] = energy, shared
        energy_near, energy_wide = box_means(energy, (near_side, wide_side))
        shared_near, shared_wide = box_means(shared, (near_side, wide_side))
        own_part = first == i if i not in valid else (first == i) & valid[i][grid]
        where = np.flatnonzero(own_part & sure)
        if len(where) < sampling.squares(_FEWEST_PX):
            where = np.flatnonzero(own_part if own_part.any() else first == i)
        gain = _learned(sampled(where), wide, energy_wide, shared_wide, sampling.squares(_FEWEST_LEARNED_PX))
        cost = _left_over(near, energy_near, shared_near, gain(energy_near))[0]
        left_wide = _left_over(wide, energy_wide, shared_wide, gain(energy_wide))[0]
        left_wide *= _WIDE_WEIGHT
        cost += left_wide
        if i in valid:
            cost[~valid[i][grid]] = np.inf
        costs.append(cost)
    times = CELL_PX // step
    in_cells = _in_cells(mosaic_energy, times)
    of_cells, shared_of_cells = (
        {i: _in_cells(plane, times) for i, plane in held.items()} for held in (energies, products)
    )

    def between(i: int, j: int) -> np.ndarray:
        return square_sums(sources[i], sources[j], CELL_PX)

    if len(sources) > 2:
        apart = _outside_mixtures(in_cells, of_cells, shared_of_cells, between)
        for cost, of_cell in zip(costs, apart):
            cost[enlarged(of_cell, times, cost.shape)] = np.inf
    nearest, cost = _least(list(sources), costs)
    followed = without_islands(nearest, sampling.squares(SMALLEST_PART_PX))
    cut = np.zeros_like(mosaic_energy)
    for i in sources:
        np.copyto(cut, np.maximum(mosaic_energy - 2 * products[i] + energies[i], 0), where=followed == i)
    place = np.s_[: in_cells.shape[0], : in_cells.shape[1]]
    sums = CellSums(
        in_cells,
        of_cells,
        shared_of_cells,
        _in_cells(cut, times),
        followed[::times, ::times][place],
        {i: valid[i][grid][::times, ::times][place] for i in sources if i in valid},
        between,
    )
    unexplained = enlarged(_unexplained(sums, fine, sampling is FINE), times, followed.shape)
    if all(i in valid for i in sources):
        unexplained |= np.logical_and.reduce([~valid[i][grid] for i in sources])
    share_left = float(cost[np.isfinite(cost)].sum()) / max(float(near.sum()), 1e-9)
    return LikelySource(enlarged(followed, step), enlarged(unexplained, step), share_left)


def _outside_mixtures(
    mosaic: np.ndarray, energies: Mapping[int, np.ndarray], products: Mapping[int, np.ndarray],
    between: Callable[[int, int], np.ndarray],
) -> list[np.ndarray]:
    """Cells, of each source, where a mixture of two others is far likelier than any source alone, bool: what resembles
    both of them would explain it better than either. As ``CellSums`` has sums."""
    least = np.float32(LEAST_ENERGY * CELL_PX**2)
    wide = box_means(mosaic, (WIDE_CELLS,))[0] + least
    energy = {i: box_means(plane, (WIDE_CELLS,))[0] + least for i, plane in energies.items()}
    shared = {i: box_means(plane, (WIDE_CELLS,))[0] for i, plane in products.items()}
    alone = np.min([wide - np.maximum(shared[i], 0) ** 2 / energy[i] for i in energy], axis=0)
    by_two, mixed = np.full_like(wide, np.inf), np.full((2, *wide.shape), -1)
    for i, j in combinations(energy, 2):
        a, b = weights_of_two(energy[i], energy[j], shared[i], shared[j], box_means(between(i, j), (WIDE_CELLS,))[0])
        takes_part = np.minimum(a, b) > MIN_MIXTURE_WEIGHT * (a + b)
        rest = np.where(takes_part, wide - a * shared[i] - b * shared[j], np.inf)
        better = rest < by_two
        np.copyto(by_two, rest, where=better)
        for number, place in zip((i, j), mixed):
            np.copyto(place, number, where=better)
    likelier = is_likelier(by_two, alone, (WIDE_CELLS * CELL_PX) ** 2)
    return [likelier & (mixed != i).all(axis=0) for i in energy]


def _unexplained(sums: CellSums, fine: FineDetail, is_window: bool) -> np.ndarray:
    """Cells that the sources explain worse than true ones do, (cell rows, cell columns) bool: by the noise of each
    where anything was compressed, else by the best ground of all, which tells images that are nearly alike as well."""
    mosaic, labels, energies, products = sums.mosaic, sums.labels, sums.energies, sums.shared
    energy, product = np.zeros_like(mosaic), np.zeros_like(mosaic)
    for i in energies:
        of = labels == i
        gain = np.float32(max(float(products[i][of].sum()), 0.0) / max(float(energies[i][of].sum()), 1e-9))
        np.copyto(energy, gain**2 * energies[i], where=of)
        np.copyto(product, gain * products[i], where=of)
    least = np.float32(LEAST_ENERGY * CELL_PX**2)
    rest = mosaic - 2 * product + energy
    wide, energy, product = (box_means(plane, (WIDE_CELLS,))[0] for plane in (mosaic, energy, product))
    wide += least
    energy += least
    # Where the mosaic shows nothing of a source's texture it was clipped, or blurred away.
    textured = (wide > _MIN_TEXTURED * least) & (wide >= MIN_TEXTURE * energy)
    left_over = np.maximum(wide - np.maximum(product, 0) ** 2 / energy, 0)
    if _is_explained(wide, left_over, textured):
        return np.zeros_like(textured)
    if fine.is_compressed(None):
        return enlarged(foreign_ground(sums, fine.is_compressed, is_window), NOISE_CELL_PX // CELL_PX, mosaic.shape)
    # A step of tones leaves over much along a line, and nothing beside it.
    even = box_means(rest * wide >= _EVEN_PART * left_over * mosaic, (WIDE_CELLS,))[0] >= _EVEN_SHARE
    sharp = textured & (wide >= _AS_STRONG * energy)  # a seam that was brushed soft is followed all the same
    cells = _Cells(wide, left_over, textured, sharp, even, labels, is_window)
    strange = cells.strange()
    if len(energies) == 1 or not strange.any():
        return strange
    near, *with_mosaic = (box_means(plane, (NEAR_CELLS,))[0] for plane in (mosaic, *products.values()))
    shared = dict(zip(products, with_mosaic))
    common = {
        (i, j): box_means(energies[i] if i == j else sums.between(i, j), (NEAR_CELLS,))[0]
        for i, j in combinations_with_replacement(energies, 2)
    }
    mixed = left_over.copy()
    for count in (2, 3):  # a mixture of some that are given is nothing strange
        for some in combinations(energies, count):
            pairs = combinations_with_replacement(some, 2)
            by_some = _left_by(near, [shared[i] for i in some], [common[pair] for pair in pairs])
            np.minimum(mixed, by_some, out=mixed)
    if _is_explained(wide, mixed, textured):
        return np.zeros_like(strange)
    # What weights that change within a square leave over of a mixture is as much as of one that stands in.
    cells = replace(cells, left_over=mixed, sharp=sharp & (mixed > _MIXED_LEFT * left_over))
    return cells.strange(fine.interpolated)


@dataclass(frozen=True, eq=False)
class _Cells:
    """What sources leave over of a mosaic's fine detail; (cell rows, cell columns) each."""

    wide: np.ndarray
    """Energy of the mosaic, over the wide squares."""
    left_over: np.ndarray
    """What is left over of that."""
    textured: np.ndarray
    """bool: what is told at all."""
    sharp: np.ndarray
    """bool: where a source may stand in for another."""
    even: np.ndarray
    """bool: of which much is left over not only along a line."""
    labels: np.ndarray
    """uint8: the source that is followed."""
    is_window: bool
    """A part of a block has too little ground to say that it is of no given source."""

    def strange(self, interpolated: Collection[int] = ()) -> np.ndarray:
        """Parts that no source explains, (cell rows, cell columns) bool; those that lie between the mosaic's pixels are
        judged by their own ground."""
        stand_ins, parts = self._stand_ins(), np.zeros_like(self.textured)
        numbers = frozenset(present(self.labels))
        for group in filter(None, (numbers.difference(interpolated), numbers.intersection(interpolated))):
            parts |= self._strange_parts(is_one_of(self.labels, group), stand_ins)
        return parts

    def _stand_ins(self) -> np.ndarray:
        """Cells where a source stands in for another of the same ground, (cell rows, cell columns) bool: it leaves over
        many times as much as it does on its own best ground, or all over its part as much more than the others do on
        theirs, and unevenly. One that was resampled leaves over evenly what is finest."""
        stand_ins = np.zeros_like(self.sharp)
        sharp, wide, left_over = self.sharp, self.wide, self.left_over
        if not opened(sharp & self.even & (left_over > MIN_STAND_IN_STRANGE * wide), _ALIKE_CELLS).any():
            return stand_ins
        parts = {number: sharp & (self.labels == number) for number in present(self.labels)}
        grounds = {number: learn_best_ground(wide[cells_of], left_over[cells_of]) for number, cells_of in parts.items()}
        for number, ground in grounds.items():
            if ground is None:
                continue
            part = parts[number]
            stand_ins |= part & ground.strangeness(wide, left_over, MIN_STAND_IN_STRANGE, MIN_STAND_IN_FACTOR)[1]
            # A seam leaves something over along itself.
            inside = part & narrowed(self.labels == number, WIDE_CELLS // 2 + 1)
            if inside.any() and np.median(expected := ground.response(wide[inside])) >= MIN_STAND_IN_STRANGE:
                others = [other for other in parts if other != number]
                rest = sharp & (self.labels != number)
                best = grounds[others[0]] if len(others) == 1 else learn_best_ground(wide[rest], left_over[rest])
                if best is not None and _is_nowhere_true(expected, best, wide[inside], left_over[inside]):
                    stand_ins |= part & (left_over > MIN_STAND_IN_STRANGE * wide)
        return stand_ins

    def _strange_parts(self, of: np.ndarray, stand_ins: np.ndarray) -> np.ndarray:
        """Parts of which more is left over of the mosaic's energy than true sources leave, (cell rows, cell columns)
        bool, and evenly. Images that resemble the true one are told as well, ``stand_ins`` are such."""
        textured, wide, left_over = self.textured & of, self.wide, self.left_over
        seen = textured & self.even
        certain = seen & stand_ins
        could_be = opened(seen & (left_over > MIN_STRANGE * wide), _STRIP_CELLS).any()
        if not could_be:
            could_be = opened(certain | (seen & (left_over > MIN_ALIKE_STRANGE * wide)), _ALIKE_CELLS).any()
        if not could_be and not (self.is_window and _is_much_left(wide, left_over, textured)):
            return np.zeros_like(seen)  # whatever true sources leave over
        ground = learn_best_ground(wide[textured], left_over[textured])
        if ground is None:
            return np.zeros_like(textured)
        if self.is_window and ground.is_of_none():
            return textured
        strange, alike = ground.strangeness(wide, left_over)
        parts = opened(seen & (strange > MIN_STRANGE), _STRIP_CELLS)
        inside = ndimage.binary_propagation(opened(certain, _ALIKE_CELLS), mask=certain)
        parts |= opened(seen & alike, _ALIKE_CELLS) | inside
        if not parts.any():
            return parts
        parts = _to_borders(parts, strange) | narrowed(inside, WIDE_CELLS // 2 + 1)
        return without_islands(parts.view(np.uint8), SMALLEST_PART_PX // CELL_PX**2) > 0


def _is_nowhere_true(expected: np.ndarray, others: BestGround, energy: np.ndarray, left_over: np.ndarray) -> bool:
    """Whether a source stands in for another wherever it is followed, by the mosaic's energy there, what is left and
    what share it leaves over on its own best ground."""
    of_others = others.response(energy)
    if np.mean(expected >= np.maximum(_FOREIGN_LEFT, _FOREIGN_FACTOR * of_others)) >= 0.5:
        return True
    is_more = expected >= np.maximum(MIN_STAND_IN_STRANGE, _NOWHERE_FACTOR * of_others)
    low, high = np.quantile(left_over / (expected * energy), (0.25, 0.75))
    return bool(is_more.mean() >= 0.5 and high >= _NOWHERE_SPREAD * low)


def _is_explained(wide: np.ndarray, left_over: np.ndarray, textured: np.ndarray) -> bool:
    """Whether nothing could be strange, whatever true sources leave over: the usual window, in a tenth of the time."""
    much = (textured & (left_over > least * wide) for least in (MIN_STRANGE, MIN_STAND_IN_STRANGE))
    if any(opened(cells, side).any() for cells, side in zip(much, (_STRIP_CELLS, _ALIKE_CELLS))):
        return False
    return not _is_much_left(wide, left_over, textured)


def _is_much_left(wide: np.ndarray, left_over: np.ndarray, textured: np.ndarray) -> bool:
    """Whether not even the best ground may be of a given source."""
    return np.count_nonzero(textured & (left_over > MIN_EVEN_LEFT / 2 * wide)) * 2 >= np.count_nonzero(textured)


def _to_borders(cells: np.ndarray, strange: np.ndarray) -> np.ndarray:
    """Parts without the blur of their borders: up to where half of a wide square is within them."""
    for _ in range(3):  # the blur is in what is found first
        parts, count = ndimage.label(cells)
        if not count:
            break
        boxes = enumerate(ndimage.find_objects(parts), 1)
        inside = np.clip([np.median(strange[box][parts[box] == number]) for number, box in boxes], 0, 1)
        # A share is the square of a correlation, and that is what is halfway.
        halfway = np.concatenate([[np.inf], 1 - (0.5 + 0.5 * np.sqrt(1 - inside)) ** 2])
        cells = strange > halfway[parts]
    return cells


def _left_by(mosaic: np.ndarray, shared: Sequence[np.ndarray], common: Sequence[np.ndarray]) -> np.ndarray:
    """What a mixture of some sources leaves over of the mosaic's energy, over the wide squares; its weights, all of
    which are above zero, are even within the near ones. Means over those: of the ``mosaic``, ``shared`` of each
    with it, ``common`` of each with itself and those after it."""
    count = len(shared)
    normal: dict[tuple[int, int], np.ndarray] = {}
    for (row, column), products in zip(combinations_with_replacement(range(count), 2), common):
        normal[row, column] = products.astype(np.float64)
        if row == column:
            normal[row, row] += LEAST_ENERGY * CELL_PX**2
    # By elimination, as ``solve`` has it, in a fifth of the time.
    rest = [products.astype(np.float64) for products in shared]
    for row in range(count):
        for below in range(row + 1, count):
            factor = normal[row, below] / normal[row, row]
            for column in range(below, count):
                normal[below, column] -= factor * normal[row, column]
            rest[below] -= factor * rest[row]
    for row in reversed(range(count)):
        for column in range(row + 1, count):
            rest[row] -= normal[row, column] * rest[column]
        rest[row] /= normal[row, row]
    explained = sum(weight * products for weight, products in zip(rest, shared))
    all_above = np.logical_and.reduce([weight > 0 for weight in rest])
    left_over = np.where(all_above, np.maximum(mosaic - explained, 0), mosaic)
    return box_means(left_over, (WIDE_CELLS - NEAR_CELLS + 1,))[0]


def _in_cells(sums: np.ndarray, times: int) -> np.ndarray:
    """Sums over whole cells from those over squares of which ``times`` make a side."""
    if times == 1:
        return sums
    rows, columns = (length // times * times for length in sums.shape)
    down = sums[0:rows:2, :columns] + sums[1:rows:2, :columns]
    return np.asarray(down[:, 0::2] + down[:, 1::2])


def _learned(
    sample: np.ndarray, mosaic: np.ndarray, energy: np.ndarray, shared: np.ndarray, fewest: int
) -> EnergyResponse:
    """The gain of a source by its energy, from squares that follow it, ``sample`` by number.

    What it can't explain is no part of it: learned from the squares that it explains best, then from all like those.
    """
    mosaic, energy, shared = (sums.ravel()[sample] for sums in (mosaic, energy, shared))
    explains = shared * np.abs(shared) / np.maximum(mosaic * energy, 1e-9)
    chosen = explains >= np.quantile(explains, _BEST)
    for _ in range(_ROUNDS):
        gain = fit_response(energy[chosen], np.maximum(shared[chosen], 0))
        left_over, stranger = _left_over(mosaic, energy, shared, gain(energy))
        response = fit_response(energy[chosen], np.maximum(left_over[chosen], 0))
        expected = np.minimum(response(energy) * energy, MAX_EXPECTED * stranger)
        explained = left_over - expected < MAX_LEARNED * (stranger - expected)
        if np.count_nonzero(explained) < min(fewest, len(mosaic)) or (explained == chosen).all():
            break
        chosen = explained
    return gain


def _left_over(
    mosaic: np.ndarray, energy: np.ndarray, shared: np.ndarray, gain: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """What is left of the mosaic's energy without a source, and what would be without a stranger as strong."""
    weighted = gain * energy
    weighted *= gain
    stranger = mosaic + weighted
    rest = gain * shared
    rest *= -2
    rest += stranger
    return rest, stranger


def _least(numbers: list[int], costs: list[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """The source of least cost, uint8, and that; (rows, columns) each."""
    source, cost = np.full(costs[0].shape, numbers[0], np.uint8), costs[0]
    for number, other in zip(numbers[1:], costs[1:]):
        np.copyto(source, np.uint8(number), where=other < cost)
        cost = np.minimum(cost, other)
    return source, cost


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
    filled, small = labels.copy(), open_to
    islands, _ = ndimage.label(small, np.ones((3, 3)))
    for number, place in enumerate(ndimage.find_objects(islands), 1):
        # What is nearest to an island touches it.
        around = tuple(slice(max(part.start - 1, 0), part.stop + 1) for part in place)
        nearest = ndimage.distance_transform_edt(small[around], return_distances=False, return_indices=True)
        np.copyto(filled[around], labels[around][tuple(nearest)], where=islands[around] == number)
    return filled
