"""All blocks of a mosaic, measured by an executor and kept in a journal, each once whatever happens to the run.

A scan that was stopped goes on there.
"""
from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Callable

import numpy as np

from ....imagery.errors import Message
from ....imagery.records import NotUnderstoodError, packed, understanding, unpacked
from ..inspection import in_order
from ..profile.cell_table import CellTable, MixtureTable
from ..seam_cells import UNKNOWN
from .blocks.block_grid import LABELS, SQUARES, UNITS, BlockKey, place_of
from .blocks.scan_block import CELLS, BlockRequest, BlockScan, called_for, scan_block
from .scan_journal import ScanJournal
from .scan_request import ScanRequest

_INCOMPLETE = "again"  # before the name of a block that lacks something; a later run measures it anew
_FEWEST_TIMED = 3  # blocks before an estimate of the time left is honest


# No type parameters: typing keeps classes that have some for as long as Python runs, and with them the whole plugin.
Request = Any
Scan = Any
"""Has the ``key`` of its block, and ``notices``: what could not be read, which the block lacks."""


@dataclass(frozen=True)
class BlockLook:
    """One kind of measurement of blocks."""

    name: str
    """In the journal."""
    measure: Callable[[Request], Scan]
    nothing: Callable[[Request, tuple[Message, ...]], Scan]
    """The result where nothing could be measured, and why."""
    record_of: Callable[[Scan], bytes]
    scan_of: Callable[[bytes], Scan]
    """Raises NotUnderstoodError for what no scan of ours has written."""


@dataclass(frozen=True, eq=False)
class ScanStep:
    """One block more is done."""

    share: float
    """Of all blocks, 0 to 1."""
    seconds_left: float | None
    """At the pace so far; None before that is known."""
    scan: Scan
    """What was measured in it."""
    notices: tuple[Message, ...] = ()
    """What could not be read in it; a later run measures the block anew."""


class JournaledBlocks:
    """Has blocks measured that a journal doesn't hold yet; knows how much is done, and how long the rest will take."""

    def __init__(
        self, journal: ScanJournal, executor: Executor, ahead: int, cancelled: Callable[[], bool],
        is_ours: Callable[[Scan], bool] = lambda scan: True,
    ) -> None:
        """``ahead``: blocks under way or waiting to be taken. ``is_ours``: whether a block that the journal holds can
        be one of this scan."""
        self._journal, self._is_ours = journal, is_ours
        self._crew = executor, ahead, cancelled
        self._total = self._done = self._timed = 0
        self._started = time.monotonic()

    def steps(
        self, look: BlockLook, keys: Sequence[BlockKey], request: Callable[[BlockKey], Request]
    ) -> Iterator[ScanStep]:
        """The blocks that the journal holds, then the others as they are measured."""
        self._total += len(keys)
        missing = []
        for key in keys:
            scan = _held(look, self._journal, key, _name(look, key), self._is_ours)
            if scan is None:
                missing.append(key)
                continue
            self._done += 1
            self._started = time.monotonic()
            yield ScanStep(self._done / self._total, None, scan)
        measure, failed = partial(_measured_record, look), partial(_failed_record, look)
        for record, notices in in_order(map(request, missing), measure, failed, *self._crew):
            scan = look.scan_of(record)
            name = _name(look, scan.key)
            self._journal.save(f"{_INCOMPLETE} {name}" if notices else name, record)
            self._done, self._timed = self._done + 1, self._timed + 1
            left = None
            if self._timed >= _FEWEST_TIMED:
                left = (time.monotonic() - self._started) / self._timed * (self._total - self._done)
            yield ScanStep(self._done / self._total, left, scan, notices)


_Recorded = tuple[bytes, tuple[Message, ...]]
"""A block as it goes to the journal, and its notices: made where it is measured, and smaller on its way from there."""


def _measured_record(look: BlockLook, request: Request) -> _Recorded:
    scan = look.measure(request)
    return look.record_of(scan), scan.notices


def _failed_record(look: BlockLook, request: Request, reason: Message) -> _Recorded:
    """Where the measurement failed in a way that nobody foresaw."""
    scan = look.nothing(request, (reason.as_warning(),))
    return look.record_of(scan), scan.notices


def held(look: BlockLook, journal: ScanJournal, key: BlockKey) -> Scan | None:
    """What a journal holds of one block."""
    name = _name(look, key)
    return _held(look, journal, key, name) or _held(look, journal, key, f"{_INCOMPLETE} {name}")


def _held(
    look: BlockLook, journal: ScanJournal, key: BlockKey, name: str, is_ours: Callable[[Scan], bool] = lambda scan: True
) -> Scan | None:
    """None as well for a record that is of no such block, which is forgotten."""
    if name not in journal.keys:
        return None
    try:
        scan = look.scan_of(journal.load(name))
        if scan.key == key and is_ours(scan):
            return scan
    except NotUnderstoodError:
        pass
    journal.forget(name)
    return None


def _name(look: BlockLook, key: BlockKey) -> str:
    return f"{look.name} {key[0]} {key[1]}"


_OWN = {
    "squares": SQUARES, "dense": UNITS, "outside": UNITS, "labels": LABELS, "mixture": CELLS, "clear": CELLS,
    "grey": CELLS,
}
"""And how many samples each has along a side."""
_TABLES = {"cells": CellTable.names(), "beside": MixtureTable.names()}


def record_of(scan: BlockScan) -> bytes:
    """All but the notices, which are told once."""
    arrays = {name: getattr(scan, name) for name in _OWN}
    for table, names in _TABLES.items():
        arrays |= {f"{table} {name}": getattr(getattr(scan, table), name) for name in names}
    arrays["key"] = np.array(scan.key)
    arrays["sources"] = np.frombuffer("\n".join(scan.sources).encode(), np.uint8)
    return packed(arrays, compressed=_OWN)


def scan_of(record: bytes) -> BlockScan:
    """What ``record_of`` made bytes of. Raises NotUnderstoodError for anything else."""
    with understanding():
        held = unpacked(record)
        row, column = held["key"].tolist()
        names = held["sources"].tobytes().decode()
        cells = CellTable(*(held[f"cells {name}"] for name in _TABLES["cells"]))
        beside = MixtureTable(*(held[f"beside {name}"] for name in _TABLES["beside"]))
        if any(held[name].shape != (side, side) for name, side in _OWN.items()):
            raise NotUnderstoodError("of another size")
        if any(column.shape[-1] != len(table.row) for table in (cells, beside) for column in vars(table).values()):
            raise NotUnderstoodError("a table with holes")
        own = {name: held[name] for name in _OWN}
        return BlockScan(
            (row, column), tuple(names.split("\n")) if names else (), **own, cells=cells, beside=beside
        )


NOTHING = -1
"""Of a source's number in the whole scan: none is followed."""


class BlockRun:
    """Measures the blocks that a journal doesn't hold yet."""

    def __init__(self, request: ScanRequest, journal: ScanJournal) -> None:
        self._request, self._journal = request, journal
        self._looks_twice = request.seam_squares is None
        shape = (request.blocks.rows, request.blocks.columns) if self._looks_twice else (0, 0)
        self._squares = np.full([SQUARES * count for count in shape], NOTHING, np.int32)

    def steps(self, executor: Executor, ahead: int, cancelled: Callable[[], bool]) -> Iterator[ScanStep]:
        """First every block, then along the borders of blocks what only two neighbours together show."""
        blocks = JournaledBlocks(self._journal, executor, ahead, cancelled, self._is_ours)
        for step in blocks.steps(FIRST_LOOK, self._request.keys(), self._request.block):
            if self._looks_twice:
                numbers = global_numbers(step.scan, self._request.numbers)
                self._squares[place_of(step.scan.key, SQUARES)] = numbers[step.scan.squares]
            yield step
        if self._looks_twice and not cancelled():
            second = {one.key: one for one in self._second_look()}
            yield from blocks.steps(SECOND_LOOK, list(second), second.__getitem__)

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


FIRST_LOOK = BlockLook("block", scan_block, BlockScan.nothing, record_of, scan_of)
SECOND_LOOK = BlockLook("border", scan_block, BlockScan.nothing, record_of, scan_of)


def block_scans(journal: ScanJournal, key: BlockKey) -> list[BlockScan]:
    """What was measured of one block, the second look last."""
    found = [held(look, journal, key) for look in (FIRST_LOOK, SECOND_LOOK)]
    return [one for one in found if one is not None]


def global_numbers(scan: BlockScan, numbers: dict[str, int]) -> np.ndarray:
    """(256,) int32: the number in the whole scan of each source of a block; ``NOTHING`` for ``UNKNOWN``."""
    found = np.full(UNKNOWN + 1, NOTHING, np.int32)
    found[: len(scan.sources)] = [numbers[path] for path in scan.sources]
    return found
