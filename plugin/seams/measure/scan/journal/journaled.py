"""Blocks measured by an executor and kept in a journal, each once whatever happens to the run."""
from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from functools import partial
from typing import Any, Callable

from .....imagery.errors import Message
from .....imagery.records import NotUnderstoodError
from ...window_runs import in_order
from ..blocks.block_grid import BlockKey
from .scan_journal import ScanJournal

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
    failed: Callable[[Request, Message], Scan]
    """The result where the measurement failed in a way that nobody foresaw."""
    record_of: Callable[[Scan], bytes]
    scan_of: Callable[[bytes], Scan]
    """Raises NotUnderstoodError for what no scan of ours has written."""


@dataclass(frozen=True)
class JournaledScan:
    """A block that is done."""

    share: float
    """Of all blocks, 0 to 1."""
    seconds_left: float | None
    """None before they are known."""
    scan: Scan
    notices: tuple[Message, ...] = ()
    """What could not be read; a later run measures the block anew."""


@dataclass(frozen=True)
class Crew:
    """Who measures."""

    executor: Executor
    ahead: int
    """Blocks under way or waiting to be taken."""
    cancelled: Callable[[], bool]


class Clock:
    """How much is done, and how long the rest will take."""

    def __init__(self, total: int) -> None:
        self._total, self._done, self._timed = total, 0, 0
        self._started = time.monotonic()

    def more(self, count: int) -> None:
        """Blocks that have come up."""
        self._total += count

    def held(self) -> float:
        """One that was measured before; returns the share that is done."""
        self._done += 1
        self._started = time.monotonic()
        return self._done / max(self._total, 1)

    def measured(self) -> tuple[float, float | None]:
        """One more; returns the share that is done and the seconds left, None before they are known."""
        self._done, self._timed = self._done + 1, self._timed + 1
        left = None
        if self._timed >= _FEWEST_TIMED:
            left = (time.monotonic() - self._started) / self._timed * (self._total - self._done)
        return self._done / max(self._total, 1), left


def journaled(
    part: BlockLook, keys: Sequence[BlockKey], request: Callable[[BlockKey], Request],
    journal: ScanJournal, crew: Crew, clock: Clock, is_ours: Callable[[Scan], bool] = lambda scan: True,
) -> Iterator[JournaledScan]:
    """The blocks that a journal holds, then the others as they are measured. ``is_ours``: whether a block that it holds
    can be one of this scan."""
    missing_keys = []
    for key in keys:
        if (scan := _held(part, journal, key, _name(part, key), is_ours)) is not None:
            yield JournaledScan(clock.held(), None, scan)
        else:
            missing_keys.append(key)
    missing = map(request, missing_keys)
    measure, failed = partial(_measured, part), partial(_failed, part)
    for found in in_order(missing, measure, failed, crew.executor, crew.ahead, crew.cancelled):
        scan = part.scan_of(found.record)
        name = _name(part, scan.key)
        journal.save(f"{_INCOMPLETE} {name}" if found.notices else name, found.record)
        yield JournaledScan(*clock.measured(), scan, found.notices)


@dataclass(frozen=True)
class _Recorded:
    """A block as it goes to the journal: made where it is measured, and smaller on its way from there."""

    record: bytes
    notices: tuple[Message, ...]


def _measured(part: BlockLook, request: Request) -> _Recorded:
    scan = part.measure(request)
    return _Recorded(part.record_of(scan), scan.notices)


def _failed(part: BlockLook, request: Request, reason: Message) -> _Recorded:
    scan = part.failed(request, reason)
    return _Recorded(part.record_of(scan), scan.notices)


def held(part: BlockLook, journal: ScanJournal, key: BlockKey) -> Scan | None:
    """What a journal holds of one block."""
    name = _name(part, key)
    return _held(part, journal, key, name) or _held(part, journal, key, f"{_INCOMPLETE} {name}")


def _held(
    part: BlockLook, journal: ScanJournal, key: BlockKey, name: str, is_ours: Callable[[Scan], bool] = lambda scan: True
) -> Scan | None:
    """None as well for a record that is of no such block, which is forgotten."""
    if name not in journal.keys:
        return None
    try:
        scan = part.scan_of(journal.load(name))
        if scan.key == key and is_ours(scan):
            return scan
    except NotUnderstoodError:
        pass
    journal.forget(name)
    return None


def _name(part: BlockLook, key: BlockKey) -> str:
    return f"{part.name} {key[0]} {key[1]}"
