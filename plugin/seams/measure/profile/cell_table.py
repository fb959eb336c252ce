"""What was measured in cells of 16 px, as tables: sums of products of detail coefficients, which add up.

Those of a window, of a block, of a strip and of a whole mosaic are one and the same: all that is said of a seam follows
from them.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from functools import cached_property
from typing import TypeVar

import numpy as np

CELL_PX = 16
"""Side of a cell."""
EDGES_PX = (0, 2, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256)
"""Begins of the bins of distance from the seam, px; the last one has no end."""
FARTHEST = len(EDGES_PX) - 1
"""The last bin: no seam is near."""
MIXED_BINS = EDGES_PX.index(128)
"""Bins in which a mixture of two sources is looked for: half a feather of 256 px."""
PRODUCTS = ("area", "mm", "ms", "mo", "mk", "ss", "so", "sk", "oo", "ok", "kk", "pp", "pq", "qq", "codec")
"""Products of the mosaic m, the source s that is followed, the other one o beyond the nearest seam, and k, what a hard
cut has beside s: the edge that it makes itself. p and q are s and o before anything came over the whole mosaic.
``area`` and, where the mosaic shows traces of a codec, ``codec`` in pixels, the others in DN squared."""

_Rows = TypeVar("_Rows", bound="Rows")


@dataclass(frozen=True, eq=False)
class Rows:
    """Rows of cells; those of several parts can be put one after the other. The last axis of every field."""

    row: np.ndarray
    """(n,) int32: of cells of 16 px in the mosaic."""
    column: np.ndarray
    """(n,) int32"""
    bin: np.ndarray
    """(n,) uint8: of ``EDGES_PX``, the distance from the nearest seam."""

    def __len__(self) -> int:
        return len(self.row)

    @property
    def keys(self) -> np.ndarray:
        """(n,) int64: one number for each cell, ascending row by row."""
        return np.asarray((self.row.astype(np.int64) << 32) + self.column)

    @classmethod
    def joined(cls: type[_Rows], tables: Sequence[_Rows]) -> _Rows:
        """One after the other; at least one."""
        return cls(*(np.concatenate([getattr(table, name) for table in tables], axis=-1) for name in cls.names()))

    @classmethod
    def names(cls) -> tuple[str, ...]:
        """Names of the fields."""
        return tuple(field.name for field in fields(cls))

    def chosen(self: _Rows, where: np.ndarray) -> _Rows:
        """The rows that a mask or an index names."""
        if where.dtype == bool:
            if where.all():
                return self
            where = np.flatnonzero(where)  # once for all columns
        return type(self)(*(np.take(getattr(self, name), where, axis=-1) for name in self.names()))

    def moved(self: _Rows, rows: int, columns: int) -> _Rows:
        """All rows so many cells farther down and to the right."""
        return replace(self, row=self.row + np.int32(rows), column=self.column + np.int32(columns))

    def within(self: _Rows, place: tuple[slice, slice]) -> _Rows:
        """Rows of the table that lie in some rows and columns of cells."""
        return self.chosen(self.are_within(place))

    def are_within(self, place: tuple[slice, slice]) -> np.ndarray:
        """Rows of the table that are of some rows and columns of cells, (n,) bool."""
        rows, columns = place
        inside = (self.row >= rows.start) & (self.row < rows.stop)
        return np.asarray(inside & (self.column >= columns.start) & (self.column < columns.stop))


@dataclass(frozen=True, eq=False)
class CellTable(Rows):
    """A row for each cell and bin of distance that there is."""

    area: np.ndarray
    """(levels, n) float32: pixels that the coefficients stand for; 0 where a level was not measured."""
    mm: np.ndarray
    """(levels, n) float32: energy of the mosaic's detail, DN squared."""
    cc: np.ndarray
    """(levels, n) float32: that of the source that is followed, as the mosaic shows it."""
    mc: np.ndarray
    """(levels, n) float32: their inner product."""

    @property
    def levels(self) -> int:
        """Rows of the sums."""
        return len(self.mm)

    @property
    def whole(self) -> CellTable:
        """A row for each cell, ascending, its parts together: float64, with the bin of the part nearest to a seam."""
        return self._whole_cells[0]

    @property
    def cell(self) -> np.ndarray:
        """(n,): the row of ``whole`` that each row is a part of."""
        return self._whole_cells[1]

    def energy(self, level: int) -> np.ndarray:
        """Energy of the sources' detail, a pixel, DN squared, (n,)."""
        return np.asarray(self.cc[level] / np.maximum(self.area[level], 1))

    @cached_property
    def _whole_cells(self) -> tuple[CellTable, np.ndarray]:
        if not len(self):
            return self, np.zeros(0, np.intp)
        # Numbered by the rectangle around them, as sorting takes ten times as long.
        top, leftmost = int(self.row.min()), int(self.column.min())
        width = int(self.column.max()) - leftmost + 1
        place = (self.row.astype(np.intp) - top) * width + (self.column - leftmost)
        held = np.flatnonzero(np.bincount(place))
        number = np.empty(int(held[-1]) + 1, np.intp)
        number[held] = np.arange(len(held))
        cell, count, bins = number[place], len(held), len(EDGES_PX)
        has_bin = np.bincount(cell * bins + self.bin, minlength=count * bins).reshape(count, bins) > 0
        area, mm, cc, mc = (
            np.stack([np.bincount(cell, level, count) for level in values])
            for values in (self.area, self.mm, self.cc, self.mc)
        )
        nearest = has_bin.argmax(axis=1).astype(np.uint8)
        return CellTable(top + held // width, leftmost + held % width, nearest, area, mm, cc, mc), cell

    @classmethod
    def empty(cls, levels: int) -> CellTable:
        """A table without rows."""
        nothing = np.zeros((levels, 0), np.float32)
        return cls(*_no_place(), nothing, nothing, nothing, nothing)

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


@dataclass(frozen=True, eq=False)
class MixtureTable(Rows):
    """A row for each cell, bin of distance and pair of sources beside a seam."""

    source: np.ndarray
    """(n,) uint8: number of the source that is followed."""
    other: np.ndarray
    """(n,) uint8: of the one beyond the nearest seam."""
    products: np.ndarray
    """(len(PRODUCTS), levels, n) float32"""

    @classmethod
    def empty(cls, levels: int) -> MixtureTable:
        """A table without rows."""
        number = np.zeros(0, np.uint8)
        return cls(*_no_place(), number, number, np.zeros((len(PRODUCTS), levels, 0), np.float32))


def _no_place() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    place = np.zeros(0, np.int32)
    return place, place, np.zeros(0, np.uint8)
