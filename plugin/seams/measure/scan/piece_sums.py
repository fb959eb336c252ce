"""What is kept along every piece of seam: the cells of all blocks added up to the piece that is nearest to them."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ....imagery.grids import Grid, PixelWindow
from ....imagery.rasters import Raster
from ..profile.cell_table import CELL_PX, EDGES_PX, MIXED_BINS, CellTable, MixtureTable, whole_cells
from ..profile.ground import FAR_PX, LevelGround
from ..profile.seam_profile import strip_bins
from ..profile.seam_sums import SeamSums, StripProfile
from ..visibility import visibility, white_grey
from .blocks.block_grid import BLOCK_PX
from .blocks.scan_block import CELLS
from .lines.piece_index import PieceIndex
from .lines.seam_pieces import SeamPiece

REACH_PX = 144.0
"""How far from a piece cells are counted to it: what lies beyond is ground."""
MOST_ASIDE_PX = 40.0
"""How far a line may lie from the seam that the mosaic shows, for that to be its seam."""
NOTHING = StripProfile(None, 0.0, 0.0, 0.0)
"""Of a piece that no cell is near to."""


class PieceSums:
    """Adds up blocks, row by row of them; then tells every piece. Only pieces that blocks to come may lie beside are
    held as sums, so that memory does not grow with the mosaic."""

    def __init__(self, pieces: Sequence[SeamPiece], grid: Grid, levels: int) -> None:
        self._levels = levels
        self._index = PieceIndex(pieces, grid)
        self._last_row = np.array([_last_row(one, grid) for one in pieces], np.intp)
        order = np.argsort(self._last_row, kind="stable")
        # The place of each among those that end in the same row of blocks.
        self._place = np.empty(len(pieces), np.intp)
        firsts = np.searchsorted(self._last_row[order], self._last_row[order])
        self._place[order] = np.arange(len(pieces)) - firsts
        self._open: dict[int, SeamSums] = {}  # by the last row of their pieces
        self._found: list[StripProfile] = [NOTHING] * len(pieces)
        self._grey = np.zeros((2, len(pieces)))  # of the strip's cells: mean of the mosaic times area, and area
        self._brightest = 0.0  # of cells

    def add(
        self, table: CellTable, mixture: MixtureTable, ground: Sequence[LevelGround | None], window: PixelWindow,
        grey: np.ndarray | None = None,
    ) -> None:
        """The cells of one block; rows of blocks come one after the other. ``mixture`` has numbers of sources that
        mean the same in all blocks. ``grey``: means of the mosaic as ``BlockScan`` has them, None where not known."""
        self._finish(window.row // BLOCK_PX)
        index = self._index.near(window, REACH_PX)
        whole = whole_cells(table)
        beside = np.flatnonzero(whole.nearest < MIXED_BINS)
        if not len(beside) or not len(index):
            return
        number, distance = index.nearest(
            (whole.column[beside] + 0.5) * CELL_PX, (whole.row[beside] + 0.5) * CELL_PX, REACH_PX
        )
        nearest = np.array(EDGES_PX)[whole.nearest[beside]]
        is_its_own = (distance <= nearest + MOST_ASIDE_PX) | (nearest >= FAR_PX)
        piece_of = np.full(len(whole.keys), -1)
        piece_of[beside] = np.where(is_its_own, number, -1)
        near = table.bin < MIXED_BINS
        table, whole = table.chosen(near), replace(whole, of_row=whole.of_row[near])
        if grey is not None:
            self._add_grey(table, grey, piece_of[whole.of_row])
        last = np.where(piece_of >= 0, self._last_row[piece_of], -1)
        for row in np.unique(last[last >= 0]).tolist():
            if row not in self._open:
                self._open[row] = SeamSums(int(np.count_nonzero(self._last_row == row)), self._levels)
            own = np.where(last == row, self._place[piece_of], -1)
            self._open[row].add(table, mixture, whole, ground, own)

    def profiles(self) -> list[StripProfile]:
        """Of every piece, in their order."""
        self._finish(max(self._open, default=0) + 1)
        return self._found

    def visibilities(self, mosaic: Raster) -> list[float | None]:
        """Of every piece, in just noticeable differences at 2x; ``mosaic``: what its grey values mean on a screen."""
        grey, area = self._grey
        means = np.divide(grey, area, out=np.full(len(area), np.nan), where=area > 0)
        white = white_grey(mosaic, self._brightest)
        return [
            visibility(one.profile.kept, one.profile.energy, mean, white) if one.profile else None
            for one, mean in zip(self.profiles(), means.tolist())
        ]

    def _add_grey(self, table: CellTable, grey: np.ndarray, piece: np.ndarray) -> None:
        strip = (table.bin < strip_bins(0).stop) & (piece >= 0)
        values, area = grey[table.row[strip] % CELLS, table.column[strip] % CELLS], table.area[0, strip]
        self._grey += [np.bincount(piece[strip], one, len(self._found)) for one in (area * values, area)]
        self._brightest = float(np.fmax.reduce(values, initial=self._brightest))

    def _finish(self, row: int) -> None:
        """The pieces that lie above a row of blocks."""
        for last in [one for one in self._open if one < row]:
            numbers = np.flatnonzero(self._last_row == last)
            for number, profile in zip(numbers.tolist(), self._open.pop(last).profiles(levels=1)):
                self._found[number] = profile


def _last_row(piece: SeamPiece, grid: Grid) -> int:
    """Of the blocks whose cells may lie beside it."""
    lowest = float(np.max(grid.row_at(piece.vertices[:, 1])))
    return int(max(lowest + REACH_PX, 0) // BLOCK_PX)
