"""All blocks of a mosaic, scanned by an executor and kept in a journal; a scan that was stopped goes on there."""
from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from typing import Callable

import numpy as np

from ....imagery.errors import Message
from ..seam_cells import UNKNOWN
from .blocks.block_grid import SQUARES, UNITS, BlockKey, place_of
from .blocks.block_records import record_of, scan_of
from .blocks.scan_block import BlockRequest, BlockScan, called_for, scan_block
from .inputs.scan_request import ScanRequest
from .journal.journaled import BlockLook, Clock, Crew, held, journaled
from .journal.scan_journal import ScanJournal

NOTHING = -1
"""Of a source's number in the whole scan: none is followed."""


@dataclass(frozen=True, eq=False)
class ScanStep:
    """One block more is done."""

    share: float
    """Of all blocks, 0 to 1."""
    seconds_left: float | None
    """At the pace so far; None before that is known."""
    notices: tuple[Message, ...]
    """What could not be read in it."""
    scan: BlockScan | None = None
    """What was measured in it; None in a scan without orthoimages."""


class BlockRun:
    """Measures the blocks that a journal doesn't hold yet."""

    def __init__(self, request: ScanRequest, journal: ScanJournal) -> None:
        self._request, self._journal = request, journal
        self._looks_twice = request.seam_squares is None
        shape = (request.blocks.rows, request.blocks.columns) if self._looks_twice else (0, 0)
        self._squares = np.full([SQUARES * count for count in shape], NOTHING, np.int32)

    def steps(self, executor: Executor, ahead: int, cancelled: Callable[[], bool]) -> Iterator[ScanStep]:
        """First every block, then along the borders of blocks what only two neighbours together show."""
        crew = Crew(executor, ahead, cancelled)
        keys = self._request.keys()
        clock = Clock(len(keys))
        for done in journaled(FIRST_LOOK, keys, self._request.block, self._journal, crew, clock, self._is_ours):
            scan = done.scan
            if self._looks_twice:
                self._squares[place_of(scan.key, SQUARES)] = global_numbers(scan, self._request.numbers)[scan.squares]
            yield ScanStep(done.share, done.seconds_left, done.notices, scan)
        if cancelled() or not self._looks_twice:
            return
        second = {one.key: one for one in self._second_look()}
        clock.more(len(second))
        look = SECOND_LOOK, list(second), second.__getitem__
        for done in journaled(*look, self._journal, crew, clock, self._is_ours):
            yield ScanStep(done.share, done.seconds_left, done.notices, done.scan)

    def _is_ours(self, scan: BlockScan) -> bool:
        """Whether it knows no source that this scan does not have."""
        return self._request.numbers.keys() >= set(scan.sources)

    def _second_look(self) -> Iterator[BlockRequest]:
        """Row by row, and by what the journal holds: units of the whole mosaic are more than memory holds."""
        for row in range(self._request.blocks.rows):
            above = min(row, 1)
            first = row * SQUARES
            wanted = called_for(self._squares[first - above : first + SQUARES + 1], NOTHING)
            wanted = wanted[above * UNITS // SQUARES :][:UNITS]
            for column in range(self._request.blocks.columns):
                key, own = (row, column), wanted[place_of((0, column), UNITS)]
                if own.any() and (own := own & ~block_scans(self._journal, key)[0].dense).any():
                    yield replace(self._request.block(key), wanted=own, look_every=0)


def _failed(request: BlockRequest, reason: Message) -> BlockScan:
    """A block whose measurement failed in a way that nobody foresaw."""
    return BlockScan.nothing(request, (reason.as_warning(),))


FIRST_LOOK = BlockLook("block", scan_block, _failed, record_of, scan_of)
SECOND_LOOK = BlockLook("border", scan_block, _failed, record_of, scan_of)


def block_scans(journal: ScanJournal, key: BlockKey) -> list[BlockScan]:
    """What was measured of one block, the second look last."""
    found = [held(part, journal, key) for part in (FIRST_LOOK, SECOND_LOOK)]
    return [one for one in found if one is not None]


def global_numbers(scan: BlockScan, numbers: dict[str, int]) -> np.ndarray:
    """(256,) int32: the number in the whole scan of each source of a block; ``NOTHING`` for ``UNKNOWN``."""
    found = np.full(UNKNOWN + 1, NOTHING, np.int32)
    found[: len(scan.sources)] = [numbers[path] for path in scan.sources]
    return found
