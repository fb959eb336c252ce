"""The border where a mosaic passes from one source to another: to that which leaves least of its fine detail over.

The correlation that finds what a mosaic follows leans towards the stronger of two sources where they meet. What a
source leaves over does not: beside a seam it grows alike on either side, and in a feather the border lies where both
weigh the same. What compression made of weak detail is expected of every source.
"""
from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import combinations

import numpy as np

from ..energy_response import EnergyResponse, fit_response, sampled
from .boxes import SMALLEST_PART_PX, box_means, enlarged, near_border, square_sums, without_islands
from .compression import IsCompressed
from .followed_source import (
    FINE_CELL_PX,
    LEAST_ENERGY,
    MIN_MIXTURE_WEIGHT,
    NEAR_CELLS,
    WIDE_CELLS,
    is_likelier,
    weights_of_two,
)
from .foreign_ground import CellSums, foreign_ground

MIN_FIT = 0.05  # of the mosaic's detail where a source is followed; strangers explain 0.01 to 0.03
MAX_EXPECTED = 0.7  # of what a stranger leaves over
MAX_LEARNED = 0.25  # of the way to a stranger: squares that a source explains better tell its gain

_WIDE_WEIGHT = 0.1  # of the wider neighbourhood: it decides only where the near one doesn't
_INSIDE_PX = 8  # from the border that is known so far
_FEWEST_PX = 1600  # that follow a source for sure, for the others to be left out
_FEWEST_LEARNED_PX = 800
_BEST = 0.6  # quantile of the squares' fit that is begun with
_ROUNDS = 5


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
QUICK = Sampling(FINE_CELL_PX, NEAR_CELLS, WIDE_CELLS)
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
    times = FINE_CELL_PX // step
    in_cells = _in_cells(mosaic_energy, times)
    of_cells, shared_of_cells = (
        {i: _in_cells(plane, times) for i, plane in held.items()} for held in (energies, products)
    )

    def between(i: int, j: int) -> np.ndarray:
        return square_sums(sources[i], sources[j], FINE_CELL_PX)

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
    cells = foreign_ground(sums, fine.is_compressed, sampling is FINE)
    unexplained = enlarged(cells, times, followed.shape)
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
    least = np.float32(LEAST_ENERGY * FINE_CELL_PX**2)
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
    likelier = is_likelier(by_two, alone, (WIDE_CELLS * FINE_CELL_PX) ** 2)
    return [likelier & (mixed != i).all(axis=0) for i in energy]


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
