"""A whole scan without orthoimages: along given seams, by what lies on either side."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache, partial

import numpy as np

from ....imagery.errors import Message, NotCoveredError, RasterError
from ....imagery.grids import PixelWindow
from ....imagery.records import RecordFolder
from .. import messages
from ..blocks.block_grid import BLOCK_PX, UNITS, BlockKey, blocks_near, place_of, rectangles, units_along
from ..blocks.block_pixels import ALL_READ, BlockPixels, BlockReading
from ..blocks.scan_block import BlockRequest
from ..compared_image import ComparedImage
from ..seamlines.seam_pieces import PieceIndex, around_pieces
from ..workers import Workers, measuring
from .block_runs import BlockLook, JournaledBlocks, ScanStep, held
from .lone_kept import LoneSeams, judge_pieces, judge_stretches
from .lone_stretches import (
    MARGIN_PX,
    REACH_PX,
    STRIP_PX,
    LoneStretches,
    LoneTable,
    lone_cells,
    lone_stretches,
)
from .loss_raster import NODATA, LossRaster, empty_cells
from .piece_sums import blocks_of, by_blocks
from .scan_request import ScanRequest
from .scan_result import JudgedPiece, ScanResult

_HELD = 64  # tables of blocks that are kept: some rows of neighbours
_CELLS_BESIDE_PX = 12  # what a cell whose middle is within reach sticks out


@dataclass(frozen=True, eq=False)
class LoneScan:
    """What was measured along the seams of one block."""

    key: BlockKey
    table: LoneTable
    notices: tuple[Message, ...] = ()
    """What could not be read; the block then lacks it."""
    reading: BlockReading = ALL_READ
    """What could be read."""

    @classmethod
    def nothing(cls, request: BlockRequest, notices: tuple[Message, ...]) -> LoneScan:
        """A block of which nothing could be measured."""
        return cls(request.key, LoneTable.empty(), notices, BlockReading((request.window,), False))


@measuring()
def scan_lone_block(request: BlockRequest) -> LoneScan:
    """The cells along the seams of a block, which are its ``pieces``. What can't be read is told in its notices."""
    assert request.wanted is not None
    assert request.pieces is not None
    tables: list[LoneTable] = []
    notices: list[Message] = []
    unread: list[PixelWindow] = []
    parts = rectangles(request.wanted)
    for part in parts:
        window = part.moved_by(request.window.column, request.window.row)
        try:
            around = window.with_margin(MARGIN_PX)
            pixels = BlockPixels(request.mosaic, (), around)
        except NotCoveredError:
            continue
        except RasterError as error:
            notices.append(error.message.as_warning())
            unread.append(window)
        else:
            clip, judged = pixels.held[0], pixels.part(around, ()).mosaic.plane
            image = ComparedImage(
                clip.bands, clip.raster.band_names, {}, {}, clip.raster, valid=clip.valid, judged=judged
            )
            near = request.pieces.near(around, REACH_PX)
            tables.append(lone_cells(image, around, window, near, request.settings.wavelet))
    reading = BlockReading(tuple(unread), not unread or len(unread) < len(parts))
    return LoneScan(request.key, LoneTable.of_all(tables), tuple(dict.fromkeys(notices)), reading)


LONE_LOOK = BlockLook("lone", scan_lone_block, LoneScan.nothing, LoneScan)


class LoneScanning:
    """Measures blocks, then reads them one by one from the journal, so that memory grows with the seams only."""

    def __init__(self, request: ScanRequest, journal: RecordFolder) -> None:
        self._request, self._mosaic, self._pieces = request, request.mosaic, request.pieces
        self._index = PieceIndex(request.pieces, request.mosaic.grid)
        self._journal, self._blocks = journal, request.blocks
        self._along = units_along(request.seams, self._blocks, int(REACH_PX) + _CELLS_BESIDE_PX)
        self._keys = blocks_near(self._along, self._blocks)
        self._scan = lru_cache(_HELD)(partial(held, LONE_LOOK, journal.files))

    def steps(self, workers: Workers) -> Iterator[ScanStep]:
        """Every block that a seam meets."""
        def block(key: BlockKey) -> BlockRequest:
            window = self._blocks.window(key)
            return BlockRequest(
                self._mosaic, (), key, window, self._request.settings, self._along[place_of(key, UNITS)],
                pieces=self._index.near(window, REACH_PX + MARGIN_PX),
            )

        yield from JournaledBlocks(self._journal, workers).steps(LONE_LOOK, self._keys, block)

    def result(self, raster: LossRaster | None, workers: Workers) -> tuple[ScanResult, list[str]]:
        """Pieces and, where it is wanted, the picture of losses, in which no source is shown. Raises CancelledError.

        Levels beyond the first are not told.
        """
        mosaic, settings = self._mosaic, self._request.settings
        pixel_m = mosaic.ground_sample_distance
        groups = by_blocks(self._pieces, self._blocks)
        parts = []
        for done, numbers in enumerate(groups):
            pieces_here = [self._pieces[number] for number in numbers.tolist()]
            near = blocks_of(around_pieces(pieces_here, mosaic.grid, BLOCK_PX), self._blocks)
            tables = [scan.table for key in near if (scan := self._scan(key)) is not None]
            if tables:
                parts.append(lone_stretches(LoneTable.of_all(tables), self._pieces, numbers, self._index, pixel_m))
            workers.tell(0.8 * done / len(groups))
        pieces: list[JudgedPiece] = []
        stretches: list[JudgedPiece] = []
        notices: list[Message] = []
        if parts:
            seams = LoneSeams(LoneStretches.joined(parts), [piece.seam_id for piece in self._pieces])
            pieces = judge_pieces(seams, self._pieces, pixel_m, settings.levels)
            stretches = judge_stretches(seams, pieces, pixel_m, settings.levels)
            if (whole := seams.kept()) is not None:
                least = seams.judgeable_px
                notices += (
                    messages.LONE_NETWORK(kept=100 * whole.kept, low=100 * whole.low, high=100 * whole.high),
                    messages.LONE_FROM_LENGTH(length=least * pixel_m) if least else messages.LONE_NEVER(),
                )
        if raster is not None:
            self._draw(raster, pieces, settings.cell_px)
        counted, counted_stretches = (
            tuple(judged for judged in of_kind if self._request.counts(judged.piece)) for of_kind in (pieces, stretches)
        )
        notes = {"orthoimages": "none"}
        return ScanResult(counted, (), stretches=counted_stretches, notices=tuple(notices), told=notes), []

    def _draw(self, raster: LossRaster, judged: Sequence[JudgedPiece], cell_px: int) -> None:
        """What each piece kept, in the cells of its strip."""
        kept = np.array([NODATA if piece.least_kept is None else piece.least_kept for piece in judged], np.float32)
        side = BLOCK_PX // cell_px
        for key in self._keys if len(kept) else ():
            window = self._blocks.window(key)
            near = self._index.near(window, BLOCK_PX // side)
            if not len(near):
                continue
            columns = window.column + (np.arange(side) + 0.5) * cell_px
            rows = window.row + (np.arange(side) + 0.5) * cell_px
            number = near.beside(columns, rows[:, np.newaxis], max(cell_px / 2, STRIP_PX)).number
            cells = empty_cells(side)
            cells[0][number >= 0] = kept[number[number >= 0]]
            raster.write(*key, cells)
