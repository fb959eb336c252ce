"""What the ground far from any seam makes one expect of the ground beside it: how strong detail came over as a function
of how strong it was (``energy_response``). What a seam did shows only where that is taken out.
"""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ..energy_response import EnergyResponse, fit_response
from .cell_table import CELL_PX, EDGES_PX, CellTable

FAR_PX = 32
"""Ground beyond this distance is what the strip is compared with."""
FARTHER_PX = (128, 96, 64, 48)
"""Distances of ground, px, the first that has enough of it: wide feathers reach beyond ``FAR_PX``. Without it a feather
of 256 px that kept 0.87 read 0.92 and was preserved."""
ENOUGH_FAR_CELLS = 300
FEWEST_FAR_CELLS = 24
REACH_ERROR = 0.8
"""Error of kept as a share of what is still missing where the ground around begins: a feather reaches into that. In 113
mosaics in JPEG 80 % of the energies' intervals held the truth, without it 76 %."""

_BESIDE = 3  # cells of a block of 2 x 2 that have to be there for its scatter to count
_FEWEST_BLOCKS = 24


@dataclass(frozen=True, eq=False)
class LevelGround:
    """One level of the ground far from seams, and what feathers may have taken from the ground itself."""

    amplitude: EnergyResponse
    """Energy of the mosaic's detail over that of the sources'."""
    gain: EnergyResponse
    """Their inner product over the energy of the sources'."""
    scatter: float
    """Standard deviation of log kept between blocks of 32 px."""
    blocks: float
    """How many such blocks, all of one weight, the ground is as good as."""
    reach: float
    """What a feather may have taken from it, as a share of kept."""
    far_px: int
    """How far from any seam it begins."""

    def is_far(self, cells: CellTable) -> np.ndarray:
        """The whole cells that it consists of, (n,) bool."""
        return _is_whole(cells) & (cells.bin >= EDGES_PX.index(self.far_px))


def grounds(table: CellTable, around: Callable[[], CellTable] | None = None) -> list[LevelGround | None]:
    """Ground of a window or a block, by level, from its own cells or where these are few from those ``around``, too,
    which are asked for then only; None where there is too little."""
    by_level = [_level_ground(table, level, ENOUGH_FAR_CELLS) for level in range(table.levels)]
    if all(by_level):
        return by_level
    more = table if around is None else around()
    return [ground or _level_ground(more, level, FEWEST_FAR_CELLS) for level, ground in enumerate(by_level)]


def _level_ground(table: CellTable, level: int, fewest: int) -> LevelGround | None:
    cells = table.whole
    whole = _is_whole(cells) & (cells.area[level] > 0)
    for distance in (*FARTHER_PX, FAR_PX):
        beyond = EDGES_PX.index(distance)
        far = whole & (cells.bin >= beyond)
        if np.count_nonzero(far) >= ENOUGH_FAR_CELLS:
            break
    if np.count_nonzero(far) < fewest:
        return None
    area, mm, cc, mc = (values[level][far] for values in (cells.area, cells.mm, cells.cc, cells.mc))
    amplitude, gain = fit_response(cc / area, mm / area), fit_response(cc / area, np.maximum(mc, 0) / area)
    _, block, counts = np.unique(
        ((cells.row[far] // 2) << 32) + cells.column[far] // 2, return_inverse=True, return_counts=True
    )
    full = counts >= _BESIDE
    # Samples on their own scatter more than the blocks of ground that a strip is made of.
    chosen = full[block] if np.count_nonzero(full) >= _FEWEST_BLOCKS else np.ones(len(block), bool)
    sums = (mm[chosen], (cc * amplitude(cc / area))[chosen])
    scatter = _scatter_of_blocks(*(np.bincount(block[chosen], values) for values in sums))
    before = table.bin == beyond - 1
    expected = table.cc[level][before] * amplitude(cells.energy(level)[table.cell[before]])
    total = float(expected.sum())
    still = float(table.mm[level][before].sum()) / total if total > 0 else 1.0
    return LevelGround(amplitude, gain, *scatter, REACH_ERROR * min(max(1 - still, 0.0), 1.0), distance)


def _is_whole(cells: CellTable) -> np.ndarray:
    return np.asarray(cells.area[0] >= CELL_PX**2)


def _scatter_of_blocks(mosaic_energy: np.ndarray, expected: np.ndarray) -> tuple[float, float]:
    """Standard deviation of log(own / expected) between blocks, and how many of one weight these are as good as."""
    known = expected > 0
    if np.count_nonzero(known) < 2:
        return 1.0, 1.0
    weights = expected[known]
    ratios = mosaic_energy[known] / weights
    mean = float(np.average(ratios, weights=weights))
    count = float(weights.sum() ** 2 / (weights**2).sum())
    variance = float(np.average((ratios - mean) ** 2, weights=weights)) * count / max(count - 1, 1)
    return float(np.sqrt(variance)) / max(mean, 1e-6), count
