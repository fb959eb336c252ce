"""The blocks of a mosaic that are scanned one by one, and the squares in them that are looked at."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from .....imagery.grids import Grid, PixelWindow

BLOCK_PX = 2048
"""Side of a block: what is held in memory at a time."""
SQUARE_PX = 128
"""Side of a square: one patch in each is looked at."""
SQUARES = BLOCK_PX // SQUARE_PX
"""Along a side of a block."""
UNIT_PX = 32
"""What is measured densely is told in units of this side."""
UNITS = BLOCK_PX // UNIT_PX
"""Along a side of a block."""
LABEL_PX = 4
"""Side of a sample of the labels that are kept."""
LABELS = BLOCK_PX // LABEL_PX
"""Along a side of a block."""

BlockKey = tuple[int, int]
"""Row and column of a block, from the top left."""


@dataclass(frozen=True)
class BlockGrid:
    """Which blocks a mosaic has."""

    grid: Grid

    @property
    def rows(self) -> int:
        """Of blocks."""
        return -(-self.grid.rows // BLOCK_PX)

    @property
    def columns(self) -> int:
        """Of blocks."""
        return -(-self.grid.columns // BLOCK_PX)

    def __iter__(self) -> Iterator[BlockKey]:
        """All blocks, row by row."""
        return ((row, column) for row in range(self.rows) for column in range(self.columns))

    def window(self, key: BlockKey) -> PixelWindow:
        """The pixels of a block; those at the right and bottom edge are smaller."""
        row, column = key
        whole = PixelWindow(column * BLOCK_PX, row * BLOCK_PX, BLOCK_PX, BLOCK_PX)
        return whole.cut_to(self.grid.columns, self.grid.rows)


def place_of(key: BlockKey, side: int) -> tuple[slice, slice]:
    """Of a block in an array of the whole mosaic that has ``side`` samples along a block's."""
    row, column = key
    return slice(row * side, (row + 1) * side), slice(column * side, (column + 1) * side)
