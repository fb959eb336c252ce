"""Blocks of a mosaic whose orthoimages are not given: request -> the cells along its seams, and their records."""
from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from dataclasses import dataclass, fields
from typing import Callable

import numpy as np

from .....imagery.clips import read_clip
from .....imagery.errors import Message, NotCoveredError, RasterError
from .....imagery.grids import PixelWindow
from .....imagery.raster_pool import open_raster
from .....imagery.rasters import Raster
from .....imagery.records import packed, understanding, unpacked
from .....imagery.remote_files import remote_settings
from .....imagery.wavelets import judged_plane
from ...inputs.grey_values import grey_factor
from ..block_runs import ScanStep
from ..blocks.block_grid import BlockGrid, BlockKey
from ..blocks.rectangles import rectangles
from ..blocks.seam_squares import SeamSquares
from ..journal.journaled import BlockLook, Clock, Crew, held, journaled
from ..journal.scan_journal import ScanJournal
from ..lines.piece_index import PieceIndex
from .lone_table import MARGIN_PX, REACH_PX, LoneTable, lone_cells


@dataclass(frozen=True, eq=False)
class LoneRequest:
    """All that is needed to measure the seams of one block, in plain data that can cross threads and processes."""

    mosaic: Raster
    key: BlockKey
    window: PixelWindow
    """Its pixels, on the mosaic's grid."""
    pieces: PieceIndex
    """Those near it."""
    wanted: np.ndarray
    """(UNITS, UNITS) bool: what lies near them."""
    wavelet: str
    grey_factor: float = 1.0
    """What floating point values are multiplied by."""


@dataclass(frozen=True, eq=False)
class LoneScan:
    """What was measured along the seams of one block."""

    key: BlockKey
    table: LoneTable
    notices: tuple[Message, ...] = ()
    """What could not be read; the block then lacks it."""


def scan_lone_block(request: LoneRequest) -> LoneScan:
    """The cells along the seams of a block. What can't be read is told in its notices."""
    tables, notices = [LoneTable.empty(3 if len(request.mosaic.band_names) >= 3 else 1)], []
    for part in rectangles(request.wanted):
        window = part.moved_by(request.window.column, request.window.row)
        try:
            with remote_settings({}):
                tables.append(_cells(request, window))
        except NotCoveredError:
            continue
        except RasterError as error:
            notices.append(error.message.as_warning())
    return LoneScan(request.key, LoneTable.joined(tables), tuple(dict.fromkeys(notices)))


def _cells(request: LoneRequest, window: PixelWindow) -> LoneTable:
    around = window.with_margin(MARGIN_PX)
    clip = read_clip(open_raster(request.mosaic.ref), request.mosaic, around, partly=True, holes=True)
    bands = clip.bands if request.grey_factor == 1 else clip.bands * np.float32(request.grey_factor)
    plane = judged_plane(bands, clip.raster.band_names)
    near = request.pieces.near(around, REACH_PX)
    return lone_cells(plane, bands, clip.valid, around, window, near, request.wavelet)


class LoneRun:
    """Measures the blocks along given seams that a journal doesn't hold yet."""

    def __init__(
        self, mosaic: Raster, index: PieceIndex, along: SeamSquares, wavelet: str, journal: ScanJournal
    ) -> None:
        """``along``: what lies within ``REACH_PX`` of the pieces."""
        self._mosaic, self._index, self._along, self._wavelet = mosaic, index, along, wavelet
        self._journal, self._blocks = journal, BlockGrid(mosaic.grid)
        self._grey_factor = grey_factor(mosaic)

    def steps(self, executor: Executor, ahead: int, cancelled: Callable[[], bool]) -> Iterator[ScanStep]:
        """Every block that a seam meets."""
        keys = self._along.met
        crew = Crew(executor, ahead, cancelled)
        for done in journaled(LONE_LOOK, keys, self._request, self._journal, crew, Clock(len(keys))):
            yield ScanStep(done.share, done.seconds_left, done.notices)

    def _request(self, key: BlockKey) -> LoneRequest:
        window = self._blocks.window(key)
        near = self._index.near(window, REACH_PX + MARGIN_PX)
        return LoneRequest(
            self._mosaic, key, window, near, self._along.dense_in(key), self._wavelet, self._grey_factor
        )


def lone_record_of(scan: LoneScan) -> bytes:
    """All but the notices, which are told once."""
    arrays = {one.name: getattr(scan.table, one.name) for one in fields(LoneTable)}
    return packed({"key": np.array(scan.key), **arrays})


def lone_scan_of(record: bytes) -> LoneScan:
    """What ``lone_record_of`` made bytes of. Raises NotUnderstoodError for anything else."""
    with understanding():
        kept = unpacked(record)
        row, column = kept["key"].tolist()
        return LoneScan((row, column), LoneTable(**{one.name: kept[one.name] for one in fields(LoneTable)}))


def _failed(request: LoneRequest, reason: Message) -> LoneScan:
    return LoneScan(request.key, LoneTable.empty(), (reason.as_warning(),))


LONE_LOOK = BlockLook("lone", scan_lone_block, _failed, lone_record_of, lone_scan_of)


def lone_table_of(journal: ScanJournal, key: BlockKey) -> LoneTable | None:
    """What a journal holds of one block."""
    found = held(LONE_LOOK, journal, key)
    return None if found is None else found.table
