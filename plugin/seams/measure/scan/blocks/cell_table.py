"""What was measured in the cells of a block, as a table: a row for each cell and bin of distance that there is."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...profile.detail_cells import CELL_PX, EDGES_PX, DetailCells

FARTHEST = len(EDGES_PX) - 1
"""The last bin: no seam is near."""


@dataclass(frozen=True, eq=False)
class CellTable:
    """Rows of sums; those of several parts can be put one after the other."""

    row: np.ndarray
    """(n,) int32: of cells of 16 px in the mosaic."""
    column: np.ndarray
    """(n,) int32"""
    bin: np.ndarray
    """(n,) uint8: of ``EDGES_PX``, the distance from the nearest seam."""
    area: np.ndarray
    """(levels, n) float32: pixels that the coefficients stand for; 0 where a level was not measured."""
    mm: np.ndarray
    """(levels, n) float32: energy of the mosaic's detail, DN squared."""
    cc: np.ndarray
    """(levels, n) float32: that of what the sources would show there."""
    mc: np.ndarray
    """(levels, n) float32: their inner product."""

    def __len__(self) -> int:
        return len(self.row)

    @property
    def levels(self) -> int:
        """Rows of the sums."""
        return len(self.mm)

    @classmethod
    def empty(cls, levels: int) -> CellTable:
        """A table without rows."""
        nothing = np.zeros((levels, 0), np.float32)
        place = np.zeros(0, np.int32)
        return cls(place, place, np.zeros(0, np.uint8), nothing, nothing, nothing, nothing)

    @classmethod
    def of(cls, cells: DetailCells, place: tuple[slice, slice], first: tuple[int, int]) -> CellTable:
        """Some cells of a window, rows and columns of them; ``first``: row and column of the window's first cell."""
        area = cells.area[(..., *place)]
        bins, rows, columns = np.nonzero(area[0])
        sums = [one[(..., *place)][:, bins, rows, columns].astype(np.float32) for one in (cells.mm, cells.cc, cells.mc)]
        return cls(
            (rows + place[0].start + first[0]).astype(np.int32), (columns + place[1].start + first[1]).astype(np.int32),
            bins.astype(np.uint8), area[:, bins, rows, columns].astype(np.float32), *sums,
        )

    @classmethod
    def far(
        cls, rows: np.ndarray, columns: np.ndarray, where: np.ndarray, sums: Sequence[np.ndarray], levels: int
    ) -> CellTable:
        """Whole cells far from any seam, those of these rows and columns that ``where``, bool, tells of.

        ``sums``: mm, cc and mc, (levels, rows, columns) each, of all ``levels`` or of the finest ones.
        """
        down, across = np.nonzero(where)
        held = np.zeros((4, levels, len(down)), np.float32)
        held[0, : len(sums[0])] = CELL_PX**2
        for target, values in zip(held[1:], sums):
            target[: len(values)] = values[:, down, across]
        return cls(
            rows[down].astype(np.int32), columns[across].astype(np.int32), np.full(len(down), FARTHEST, np.uint8), *held
        )

    @classmethod
    def joined(cls, tables: Sequence[CellTable]) -> CellTable:
        """One after the other; at least one."""
        return cls(
            *(np.concatenate([getattr(one, name) for one in tables]) for name in ("row", "column", "bin")),
            *(np.concatenate([getattr(one, name) for one in tables], axis=1) for name in ("area", "mm", "cc", "mc")),
        )

    def chosen(self, where: np.ndarray) -> CellTable:
        """The rows that a mask or an index names."""
        return CellTable(
            self.row[where], self.column[where], self.bin[where],
            *(one[:, where] for one in (self.area, self.mm, self.cc, self.mc)),
        )

    def moved(self, rows: int, columns: int) -> CellTable:
        """The same so many cells farther down and to the right."""
        return replace(self, row=self.row + np.int32(rows), column=self.column + np.int32(columns))
