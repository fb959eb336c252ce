"""What the ground of a block makes one expect of the strips along its seams."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ...profile.detail_cells import CELL_PX, EDGES_PX
from ...profile.ground import GroundResponse, ground_response
from ...profile.seam_profile import ENOUGH_FAR_CELLS, FAR_PX, FARTHER_PX, FEWEST_FAR_CELLS, REACH_ERROR
from ..blocks.cell_table import CellTable

_BESIDE = 3  # cells of a block of 2 x 2 that have to be there for its scatter to count
_FEWEST_BLOCKS = 24


@dataclass(frozen=True, eq=False)
class LevelGround:
    """One level's response, and what feathers may have taken from the ground itself."""

    response: GroundResponse
    reach: float
    """As a share of kept."""


@dataclass(frozen=True, eq=False)
class WholeCells:
    """The cells of a table, all bins of each together."""

    row: np.ndarray
    """(n,) of cells of 16 px in the mosaic."""
    column: np.ndarray
    """(n,)"""
    nearest: np.ndarray
    """(n,) uint8: the bin of the part that is nearest to a seam."""
    area: np.ndarray
    """(levels, n) px"""
    mm: np.ndarray
    """(levels, n) DN squared"""
    cc: np.ndarray
    """(levels, n) DN squared"""
    mc: np.ndarray
    """(levels, n) DN squared"""
    of_row: np.ndarray
    """(rows of the table,): the cell that each is of."""

    def energy(self, level: int) -> np.ndarray:
        """Of the composite's detail, a pixel, (n,)."""
        return np.asarray(self.cc[level] / np.maximum(self.area[level], 1))


def whole_cells(table: CellTable) -> WholeCells:
    """The cells that the rows of a table are of."""
    keys, of_row = np.unique((table.row.astype(np.int64) << 32) + table.column, return_inverse=True)
    count = len(keys)
    nearest = np.full(count, len(EDGES_PX), np.uint8)
    np.minimum.at(nearest, of_row, table.bin)
    sums = [
        np.stack([np.bincount(of_row, row, count) for row in values]) if count else np.zeros((table.levels, 0))
        for values in (table.area, table.mm, table.cc, table.mc)
    ]
    area, mm, cc, mc = sums
    return WholeCells(keys >> 32, keys & 0xFFFFFFFF, nearest, area, mm, cc, mc, of_row)


def grounds(table: CellTable, around: CellTable) -> list[LevelGround | None]:
    """Of a block, by level, from its own cells or where these are few from those ``around``, too; None where there is
    too little ground."""
    own = whole_cells(table)
    found = [_level_ground(table, own, level, ENOUGH_FAR_CELLS) for level in range(table.levels)]
    if all(found):
        return found
    everyone = whole_cells(around)
    return [
        one or _level_ground(around, everyone, level, FEWEST_FAR_CELLS) for level, one in enumerate(found)
    ]


def _level_ground(table: CellTable, cells: WholeCells, level: int, fewest: int) -> LevelGround | None:
    whole = (cells.area[0] >= CELL_PX**2) & (cells.area[level] > 0)
    for distance in (*FARTHER_PX, FAR_PX):
        beyond = EDGES_PX.index(distance)
        far = whole & (cells.nearest >= beyond)
        if np.count_nonzero(far) >= ENOUGH_FAR_CELLS:
            break
    if np.count_nonzero(far) < fewest:
        return None
    area, mm, cc, mc = (values[level][far] for values in (cells.area, cells.mm, cells.cc, cells.mc))
    _, of_block, counts = np.unique(
        ((cells.row[far] // 2) << 32) + cells.column[far] // 2, return_inverse=True, return_counts=True
    )
    full = counts >= _BESIDE
    # Samples on their own scatter more than the blocks of ground that a strip is made of.
    chosen = full[of_block] if np.count_nonzero(full) >= _FEWEST_BLOCKS else np.ones(len(of_block), bool)
    response = ground_response(cc / area, mm / area, mc / area, mm, cc, np.where(chosen, of_block, -1))
    before = table.bin == beyond - 1
    expected = table.cc[level][before] * response.amplitude(cells.energy(level)[cells.of_row[before]])
    total = float(expected.sum())
    still = float(table.mm[level][before].sum()) / total if total > 0 else 1.0
    return LevelGround(response, REACH_ERROR * min(max(1 - still, 0.0), 1.0))
