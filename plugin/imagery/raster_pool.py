"""Rasters kept open from one read to the next, since a scan reads each of them thousands of times, and who reads them.

The rasters of a window are read one after the other, or by threads that keep them open, side by side.
"""
from __future__ import annotations

import os
import threading
import weakref
from collections import OrderedDict
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import replace
from typing import Protocol, TypeVar

from .errors import RasterError
from .gdal_paths import is_remote, readable_path
from .grids import PixelWindow
from .open_raster import OpenRaster, PixelBlock
from .rasters import RasterRef
from .remote_files import COMPLETE, WITH_OTHERS, forget_failures, persistently, remote_parts, remote_settings

KEPT_OPEN = 16  # rasters per thread: the sources of some blocks, far from the files a process may have open

_Stamp = tuple[int, int, int]
"""File number, size and time of the last change."""


def open_raster(ref: RasterRef) -> OpenRaster:
    """A raster that this thread has open already, or that is opened and kept; for this thread only.

    Of the rasters of a thread the ``KEPT_OPEN`` used last stay open, until the thread ends or a ``rasters_kept`` block
    of the process does. One that can't be read is closed, and so is one whose file was replaced meanwhile.

    Raises RasterError when it can't be opened or used.
    """
    return _pool().open(ref)


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
    with _all_pools_lock:
        pools = list(_all_pools)
    for pool in pools:
        pool.close()
    forget_failures()


class KeptRaster(OpenRaster):
    """A raster of a pool: one that fails is not used again, and what comes over the network is asked for again."""

    def __init__(self, ref: RasterRef, pool: weakref.ref[RasterPool]) -> None:
        super().__init__(ref)
        self._pool = pool

    def read(self, window: PixelWindow, size: tuple[int, int] | None = None, averaged: bool = False) -> PixelBlock:
        try:
            return self._read(window, size, averaged)
        except RasterError:
            pool = self._pool()
            if pool is not None:
                pool.drop(self)
            raise

    def _read(self, window: PixelWindow, size: tuple[int, int] | None, averaged: bool) -> PixelBlock:
        return super().read(window, size, averaged)


class RemoteRaster(KeptRaster):
    """One of which all, or the parts that a VRT names, come over the network."""

    def __init__(self, ref: RasterRef, pool: weakref.ref[RasterPool]) -> None:
        self._beside = COMPLETE
        persistently(ref.path, ref.name, lambda again: self._open(ref, pool))

    def _open(self, ref: RasterRef, pool: weakref.ref[RasterPool]) -> None:
        with remote_settings(self._beside):
            KeptRaster.__init__(self, ref, pool)
            is_complete = self.dataset.GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE") == "COG"
        if self._beside == COMPLETE and is_remote(ref.path) and not is_complete:
            self._beside = WITH_OTHERS
            self._open(ref, pool)

    def _read(self, window: PixelWindow, size: tuple[int, int] | None, averaged: bool) -> PixelBlock:
        def attempt(again: bool) -> PixelBlock:
            if again:
                self._open(self.ref, self._pool)
            with remote_settings(self._beside):
                return KeptRaster._read(self, window, size, averaged)

        return persistently(self.ref.path, self.ref.name, attempt)


class RasterPool:
    """The rasters that one thread keeps open, the one used last at the end."""

    def __init__(self, most: int = KEPT_OPEN) -> None:
        self._most = most
        self._kept: OrderedDict[RasterRef, tuple[OpenRaster, _Stamp | None]] = OrderedDict()
        self._lock = threading.Lock()  # other threads close, and never open

    def __len__(self) -> int:
        return len(self._kept)

    def open(self, ref: RasterRef) -> OpenRaster:
        """Raises RasterError when it can't be opened or used."""
        ref = replace(ref, path=readable_path(ref.path))
        stamp = file_stamp(ref.path)
        with self._lock:
            raster, kept_stamp = self._kept.pop(ref, (None, None))
            if raster is not None and kept_stamp == stamp:
                self._kept[ref] = raster, stamp
                return raster
        kind = RemoteRaster if remote_parts(ref.path) else KeptRaster
        raster = kind(ref, weakref.ref(self))
        with self._lock:
            self._kept[ref] = raster, stamp
            while len(self._kept) > self._most:
                self._kept.popitem(last=False)
        return raster

    def drop(self, raster: OpenRaster) -> None:
        """Forget a raster that is broken."""
        with self._lock:
            if self._kept.get(raster.ref, (None, None))[0] is raster:
                del self._kept[raster.ref]

    def __enter__(self) -> RasterPool:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def close(self) -> None:
        """Forget all of them."""
        self.emptied()

    def emptied(self) -> list[OpenRaster]:
        """Forget all of them; they are closed when whoever gets them lets go of them."""
        with self._lock:
            kept = [raster for raster, _ in self._kept.values()]
            self._kept.clear()
        return kept


_threads = threading.local()
_all_pools: weakref.WeakSet[RasterPool] = weakref.WeakSet()  # a pool lives as long as its thread
_all_pools_lock = threading.Lock()


def _pool() -> RasterPool:
    pool: RasterPool | None = getattr(_threads, "pool", None)
    if pool is None:
        pool = _threads.pool = RasterPool()
        with _all_pools_lock:
            _all_pools.add(pool)
    return pool


def file_stamp(path: str) -> _Stamp | None:
    """Which file it is by now; None for what is no file of this machine."""
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return None
    return found.st_ino, found.st_size, found.st_mtime_ns


_AHEAD = 2  # requests under way per worker: one is measured while the next waits


@contextmanager
def own_threads(executor: Executor | None = None, ahead: int = 0) -> Iterator[tuple[Executor, int]]:
    """An executor, and how many requests it should have under way: those that are given, where they are."""
    workers = os.cpu_count() or 1
    if executor is not None:
        yield executor, ahead or ahead_of(workers)
        return
    with reading_threads(workers) as executor:
        yield executor, ahead_of(workers)


@contextmanager
def reading_threads(count: int) -> Iterator[Executor]:
    """Threads that read rasters. The end of the block waits for what they are at, and drops what waits for them."""
    executor = ThreadPoolExecutor(count, "seam-inspector")
    try:
        yield executor
    finally:
        executor.shutdown(cancel_futures=True)


def ahead_of(workers: int) -> int:
    """How many requests should be under way with so many workers."""
    return _AHEAD * workers


Found = TypeVar("Found")
Reading = tuple[RasterRef, Callable[[OpenRaster], Found]]
"""A raster, and what is read from it once it is open."""


class ReadEach(Protocol):
    """Does all readings; gives what each found, or why it found nothing, in their order."""

    def __call__(self, readings: Iterable[Reading[Found]]) -> list[Found | RasterError]: ...


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
KEPT_PER_LANE = 8  # rasters that a lane keeps open


class ReadingLanes:
    """A ``ReadEach``. One thread alone reads a raster, so that it is open already and its blocks are in GDAL's cache.

    The lanes start with the first reading. ``let_go`` closes the files; the next reading opens them again.
    """

    def __init__(self, lanes: int = LANES) -> None:
        self._lanes = [_Lane(number) for number in range(lanes)]
        self._lane_of: dict[RasterRef, _Lane] = {}
        self._lock = threading.Lock()

    def __call__(self, readings: Iterable[Reading[Found]]) -> list[Found | RasterError]:
        futures = [self.submit(ref, work) for ref, work in readings]
        try:
            return [future.result() for future in futures]
        finally:
            for future in futures:
                future.cancel()

    def submit(self, ref: RasterRef, work: Callable[[OpenRaster], Found]) -> Future[Found | RasterError]:
        """Have one raster read, unless whoever asks for it is cancelled before."""
        with self._lock:
            lane = self._lane_of.get(ref)
            if lane is None:
                lane = self._lane_of[ref] = self._lanes[len(self._lane_of) % len(self._lanes)]
            return lane.submit(ref, work)

    def open_count(self) -> int:
        """How many rasters are open."""
        return sum(len(lane.pool) for lane in self._lanes)

    def let_go(self) -> None:
        """Close all files, in their threads, as a large one takes its time: soon, or when what is read has been."""
        with self._lock:
            self._lane_of.clear()
        for lane in self._lanes:
            lane.let_go()

    def close(self) -> None:
        """Read nothing more."""
        self.let_go()
        for lane in self._lanes:
            lane.close()


class _Lane:
    """One thread and what it keeps open."""

    def __init__(self, number: int) -> None:
        self.pool = RasterPool(KEPT_PER_LANE)
        self._turn = 0  # counts how often all was let go
        self._thread = ThreadPoolExecutor(1, f"seam-inspector-lane-{number}")

    def submit(self, ref: RasterRef, work: Callable[[OpenRaster], Found]) -> Future[Found | RasterError]:
        return self._thread.submit(self._read, self._turn, ref, work)

    def let_go(self) -> None:
        """Keep nothing open that was asked for until now."""
        self._turn += 1
        if kept := self.pool.emptied():
            self._thread.submit(kept.clear)

    def _read(self, turn: int, ref: RasterRef, work: Callable[[OpenRaster], Found]) -> Found | RasterError:
        try:
            return read_one(self.pool.open, ref, work)
        finally:
            if turn != self._turn:
                self.pool.close()

    def close(self) -> None:
        """Read nothing more."""
        self._thread.shutdown(wait=False, cancel_futures=True)
