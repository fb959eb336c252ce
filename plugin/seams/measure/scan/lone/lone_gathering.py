"""From the blocks of a scan without orthoimages to its pieces of seam and the picture of losses along them."""
from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Callable

import numpy as np

from .....imagery.lines import points_at, vertex_stations
from .....imagery.rasters import Raster
from ..blocks.block_grid import BLOCK_PX, BlockGrid, BlockKey
from ..journal.scan_journal import ScanJournal
from ..lines.piece_index import PieceIndex
from ..lines.seam_pieces import SeamPiece
from ..results.judged_pieces import JudgedPiece
from ..results.loss_raster import NODATA, LossRaster, empty_cells
from .lone_blocks import lone_table_of
from .lone_kept import LoneKept, LoneSeams
from .lone_stretches import STRIP_PX, LoneStretches, lone_stretches
from .lone_table import LoneTable
from .lone_verdicts import LoneJudgement, judge_pieces

_HELD = 64  # tables of blocks that are kept: some rows of neighbours


@dataclass(frozen=True, eq=False)
class LoneResult:
    """What can be told without orthoimages."""

    pieces: list[JudgedPiece]
    """All of them; levels beyond the first are not told."""
    network: LoneKept | None
    """All seams together; None where nothing could be measured."""
    judgeable_m: float | None
    """From which length on a piece can be judged; None: never."""


class LoneGathering:
    """Reads a journal block by block, so that memory grows with the seams only."""

    def __init__(
        self, mosaic: Raster, pieces: Sequence[SeamPiece], index: PieceIndex, levels: int, journal: ScanJournal
    ) -> None:
        self._mosaic, self._pieces, self._index, self._levels = mosaic, pieces, index, levels
        self._journal = journal
        self._blocks = BlockGrid(mosaic.grid)
        self._table = lru_cache(_HELD)(self._table_of)

    def judged(self, goes_on: Callable[[float], bool]) -> LoneResult | None:
        """Every piece, and all of them together. None where ``goes_on`` says no."""
        pixel_m = self._mosaic.ground_sample_distance
        groups = self._groups()
        parts = []
        for done, (key, numbers) in enumerate(sorted(groups.items())):
            tables = [table for near in self._touched(key, numbers) if (table := self._table(near)) is not None]
            if tables:
                table = LoneTable.joined(tables)
                parts.append(lone_stretches(table, self._pieces, numbers, self._index, pixel_m))
            if not goes_on(done / len(groups)):
                return None
        if not parts:
            return LoneResult([], None, None)
        seams = LoneSeams(LoneStretches.joined(parts), [piece.seam_id for piece in self._pieces])
        told = judge_pieces(seams, [piece.length_m / pixel_m for piece in self._pieces], pixel_m)
        judged = [_judged(piece, one, pixel_m, self._levels) for piece, one in zip(self._pieces, told)]
        least = seams.judgeable_px
        return LoneResult(judged, seams.kept(), None if least is None else least * pixel_m)

    def draw(self, raster: LossRaster, judged: Sequence[JudgedPiece], cell_px: int) -> None:
        """What each piece kept, in the cells of its strip."""
        kept = np.array([NODATA if one.least_kept is None else one.least_kept for one in judged], np.float32)
        side = BLOCK_PX // cell_px
        met = {near for key, numbers in self._groups().items() for near in self._touched(key, numbers)}
        for key in sorted(met):
            window = self._blocks.window(key)
            near = self._index.near(window, BLOCK_PX // side)
            if not len(near):
                continue
            columns = window.column + (np.arange(side) + 0.5) * cell_px
            rows = window.row + (np.arange(side) + 0.5) * cell_px
            number, _ = near.nearest(columns, rows[:, np.newaxis], max(cell_px / 2, STRIP_PX))
            cells = empty_cells(side)
            cells[0][number >= 0] = kept[number[number >= 0]]
            raster.write(*key, cells)

    def _groups(self) -> dict[BlockKey, list[int]]:
        """Pieces by the block that their middle lies in."""
        found = defaultdict(list)
        for number, piece in enumerate(self._pieces):
            found[self._keys(piece.vertices[len(piece.vertices) // 2][np.newaxis])[0]].append(number)
        return found

    def _touched(self, key: BlockKey, numbers: Sequence[int]) -> list[BlockKey]:
        """The blocks of some pieces and their neighbours."""
        vertices = np.concatenate([_filled_in(self._pieces[number].vertices, self._step) for number in numbers])
        own = {key, *self._keys(vertices)}
        around = {(row + down, column + to) for row, column in own for down in (-1, 0, 1) for to in (-1, 0, 1)}
        return sorted(one for one in around if 0 <= one[0] < self._blocks.rows and 0 <= one[1] < self._blocks.columns)

    @property
    def _step(self) -> float:
        """Map units that are surely less than a block."""
        return self._mosaic.grid.pixel_width * BLOCK_PX / 4

    def _keys(self, vertices: np.ndarray) -> list[BlockKey]:
        grid = self._mosaic.grid
        columns = grid.column_at(vertices[:, 0]) // BLOCK_PX
        rows = grid.row_at(vertices[:, 1]) // BLOCK_PX
        last = self._blocks.rows - 1, self._blocks.columns - 1
        return [(min(max(int(row), 0), last[0]), min(max(int(column), 0), last[1]))
                for row, column in zip(rows, columns)]

    def _table_of(self, key: BlockKey) -> LoneTable | None:
        return lone_table_of(self._journal, key)


def _judged(piece: SeamPiece, told: LoneJudgement, pixel_m: float, levels: int) -> JudgedPiece:
    left, right = (side if isinstance(side, str) else None for side in (piece.left, piece.right))
    kept = told.kept
    if kept is None:
        return JudgedPiece(piece, left, right, None, None, None, None, told.verdict, told.reason)
    width = kept.band_width_px * pixel_m
    by_level = (kept.kept, *[None] * (levels - 1))
    return JudgedPiece(piece, left, right, by_level, kept.low, kept.high, width, told.verdict, told.reason)


def _filled_in(vertices: np.ndarray, step: float) -> np.ndarray:
    """The vertices of a line, and points between those that lie far apart."""
    along = vertex_stations(vertices)
    return points_at(vertices, along, np.union1d(along, np.arange(0, along[-1], step)))
