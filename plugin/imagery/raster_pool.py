"""Rasters kept open from one read to the next, since a scan reads each of them thousands of times, and who reads them.

The rasters of a window are read one after the other, or by threads that keep them open, side by side.
"""
from __future__ import annotations

import os
import threading
import weakref
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import replace
from functools import lru_cache
from typing import Any, TypeVar

from .errors import RasterError
from .gdal_paths import failures, file_stamp, readable_path
from .open_raster import OpenRaster
from .rasters import RasterRef

KEPT_OPEN = 16  # rasters per thread: the sources of some blocks, far from the files a process may have open


def open_raster(ref: RasterRef) -> OpenRaster:
    """A raster that this thread has open already, or that is opened and kept; for this thread only. The ``KEPT_OPEN``
    used last stay open, until the thread ends or a ``rasters_kept`` block of the process does.

    Raises RasterError when it can't be opened or used.
    """
    key = replace(ref, path=readable_path(ref.path)), file_stamp(ref.path)
    raster = _kept()(*key)
    if raster.is_broken:
        _kept().cache_clear()
        raster = _kept()(*key)
    return raster


@contextmanager
def rasters_kept() -> Iterator[None]:
    """A run with ``open_raster`` in its threads: when the block ends, all that is open in this process is closed.

    A thread that still reads keeps the raster it reads until it lets go of it.
    """
    try:
        yield
    finally:
        close_rasters()


def close_rasters() -> None:
    """Close what is kept open in all threads of this process; what failed over the network is asked for again."""
    with _lock:
        every = list(_kept_by_all)
    for kept in every:
        kept.cache_clear()
    failures.clear()


_threads = threading.local()
_kept_by_all: weakref.WeakSet[Any] = weakref.WeakSet()  # what a thread keeps lives as long as it
_lock = threading.Lock()


def _kept() -> Any:
    """The rasters that this thread keeps open; another one may close them."""
    if not hasattr(_threads, "kept"):
        _threads.kept = lru_cache(KEPT_OPEN)(lambda ref, stamp: OpenRaster(ref))
        with _lock:
            _kept_by_all.add(_threads.kept)
    return _threads.kept


AHEAD = 2  # requests under way per worker: one is measured while the next waits


@contextmanager
def own_threads(executor: Executor | None = None, ahead: int = 0) -> Iterator[tuple[Executor, int]]:
    """An executor, and how many requests it should have under way: those that are given, where they are."""
    workers = os.cpu_count() or 1
    with reading_threads(workers) if executor is None else nullcontext(executor) as opened:
        yield opened, ahead or AHEAD * workers


@contextmanager
def reading_threads(count: int) -> Iterator[Executor]:
    """Threads that read rasters. The end of the block waits for what they are at, and drops what waits for them."""
    executor = ThreadPoolExecutor(count, "seam-inspector")
    try:
        yield executor
    finally:
        executor.shutdown(cancel_futures=True)


Found = TypeVar("Found")
Reading = tuple[RasterRef, Callable[[OpenRaster], Found]]
"""A raster, and what is read from it once it is open."""


ReadEach = Callable[[Iterable[Reading[Any]]], list[Any]]
"""Does all readings; gives what each found, or the RasterError that it found nothing for, in their order."""


def one_by_one(
    readings: Iterable[Reading[Found]], opened: Callable[[RasterRef], OpenRaster] = OpenRaster
) -> list[Found | RasterError]:
    """In this thread; each raster is opened for it, unless ``opened`` has it already."""
    return [read_one(opened, *reading) for reading in readings]


def read_one(
    opened: Callable[[RasterRef], OpenRaster], ref: RasterRef, work: Callable[[OpenRaster], Found]
) -> Found | RasterError:
    """What is found in a raster, or why nothing is."""
    try:
        return work(opened(ref))
    except RasterError as error:
        error.__context__ = None  # that and where it was raised would keep the file open as long as it is remembered
        return error.with_traceback(None)


LANES = min(4, os.cpu_count() or 1)  # more than there are processors cost more than they gain


class ReadingLanes:
    """A ``ReadEach``. One thread alone reads a raster, so that it is open already and its blocks are in GDAL's cache.

    The lanes start with the first reading. ``let_go`` closes the files; the next reading opens them again.
    """

    def __init__(self, lanes: int = LANES) -> None:
        self._lanes = [ThreadPoolExecutor(1, f"seam-inspector-lane-{number}") for number in range(lanes)]
        self._lane_of: dict[RasterRef, Executor] = {}

    def __call__(self, readings: Iterable[Reading[Found]]) -> list[Found | RasterError]:
        lane_of, every = self._lane_of, self._lanes
        lanes = ((lane_of.setdefault(ref, every[len(lane_of) % len(every)]), ref, work) for ref, work in readings)
        futures = [lane.submit(read_one, open_raster, ref, work) for lane, ref, work in lanes]
        try:
            return [future.result() for future in futures]
        finally:
            for future in futures:
                future.cancel()

    def let_go(self) -> None:
        """Close all files, in their threads, as a large one takes its time: when what was asked for has been read."""
        for lane in self._lanes:
            with suppress(RuntimeError):  # closed meanwhile: its thread closes them as it ends
                lane.submit(lambda: _kept().cache_clear())

    def close(self) -> None:
        """Read nothing more; the threads close their files as they end."""
        for lane in self._lanes:
            lane.shutdown(wait=False, cancel_futures=True)
