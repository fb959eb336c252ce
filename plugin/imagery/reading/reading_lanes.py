"""Threads that read the rasters of a window side by side and keep them open, for whoever waits for each picture."""
from __future__ import annotations

import os
import threading
from collections.abc import Iterable
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Callable

from ..errors import RasterError
from ..open_raster import OpenRaster
from ..raster_pool import RasterPool
from ..rasters import RasterRef
from .readings import Found, Reading, read_one

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
        return [future.result() for future in futures]

    def submit(self, ref: RasterRef, work: Callable[[OpenRaster], Found]) -> Future[Found | RasterError]:
        """Have one raster read."""
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
