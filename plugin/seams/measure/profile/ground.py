"""What the ground far from any seam makes one expect of the ground beside it."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .cell_table import CELL_PX, EDGES_PX, CellTable, WholeCells, whole_cells
from .energy_response import EnergyResponse, fit_response

FAR_PX = 32
"""Ground beyond this distance is what the strip is compared with."""
FARTHER_PX = (128, 96, 64, 48)
"""Where there is enough of it, ground so far off: wide feathers reach beyond ``FAR_PX``."""
ENOUGH_FAR_CELLS = 300
FEWEST_FAR_CELLS = 24
REACH_ERROR = 0.8
"""Of what is still missing where the ground around begins: a feather reaches into that."""

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

    def is_far(self, cells: WholeCells) -> np.ndarray:
        """Which cells it consists of, (n,) bool."""
        return _is_whole(cells) & (cells.nearest >= EDGES_PX.index(self.far_px))


def grounds(
    table: CellTable, whole: WholeCells | None = None, around: CellTable | None = None
) -> list[LevelGround | None]:
    """Of a window or a block, by level, from its own cells or where these are few from those ``around``, too; None
    where there is too little ground. ``whole``: ``whole_cells`` of the table, where those are known."""
    own = whole_cells(table) if whole is None else whole
    found = [_level_ground(table, own, level, ENOUGH_FAR_CELLS) for level in range(table.levels)]
    if all(found):
        return found
    more = table if around is None else around
    everyone = own if around is None else whole_cells(around)
    return [one or _level_ground(more, everyone, level, FEWEST_FAR_CELLS) for level, one in enumerate(found)]


def _level_ground(table: CellTable, cells: WholeCells, level: int, fewest: int) -> LevelGround | None:
    whole = _is_whole(cells) & (cells.area[level] > 0)
    for distance in (*FARTHER_PX, FAR_PX):
        beyond = EDGES_PX.index(distance)
        far = whole & (cells.nearest >= beyond)
        if np.count_nonzero(far) >= ENOUGH_FAR_CELLS:
            break
    if np.count_nonzero(far) < fewest:
        return None
    area, mm, cc, mc = (values[level][far] for values in (cells.area, cells.mm, cells.cc, cells.mc))
    amplitude, gain = fit_response(cc / area, mm / area), fit_response(cc / area, np.maximum(mc, 0) / area)
    _, of_block, counts = np.unique(
        ((cells.row[far] // 2) << 32) + cells.column[far] // 2, return_inverse=True, return_counts=True
    )
    full = counts >= _BESIDE
    # Samples on their own scatter more than the blocks of ground that a strip is made of.
    chosen = full[of_block] if np.count_nonzero(full) >= _FEWEST_BLOCKS else np.ones(len(of_block), bool)
    sums = (mm[chosen], (cc * amplitude(cc / area))[chosen])
    scatter = scatter_of_blocks(*(np.bincount(of_block[chosen], values) for values in sums))
    before = table.bin == beyond - 1
    expected = table.cc[level][before] * amplitude(cells.energy(level)[cells.of_row[before]])
    total = float(expected.sum())
    still = float(table.mm[level][before].sum()) / total if total > 0 else 1.0
    return LevelGround(amplitude, gain, *scatter, REACH_ERROR * min(max(1 - still, 0.0), 1.0), distance)


def _is_whole(cells: WholeCells) -> np.ndarray:
    return np.asarray(cells.area[0] >= CELL_PX**2)


def scatter_of_blocks(own: np.ndarray, expected: np.ndarray) -> tuple[float, float]:
    """Standard deviation of the logarithm of own / expected between blocks, and how many blocks of one weight these
    are as good as."""
    known = expected > 0
    if np.count_nonzero(known) < 2:
        return 1.0, 1.0
    weights = expected[known]
    ratios = own[known] / weights
    mean = float((weights * ratios).sum() / weights.sum())
    count = float(weights.sum() ** 2 / (weights**2).sum())
    variance = float((weights * (ratios - mean) ** 2).sum() / weights.sum()) * count / max(count - 1, 1)
    return float(np.sqrt(variance)) / max(mean, 1e-6), count
