"""Rasters kept open from one read to the next, since a scan reads each of them thousands of times."""
from __future__ import annotations

import os
import threading
import weakref
from collections import OrderedDict
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace

from .errors import RasterError
from .grids import PixelWindow
from .open_raster import OpenRaster, PixelBlock
from .rasters import RasterRef
from .remote_files import (
    COMPLETE,
    WITH_OTHERS,
    forget_failures,
    is_remote,
    persistently,
    readable_path,
    remote_parts,
    remote_settings,
)

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
        stamp = _stamp(ref.path)
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


def _stamp(path: str) -> _Stamp | None:
    """Which file it is by now; None for what is no file of this machine."""
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return None
    return found.st_ino, found.st_size, found.st_mtime_ns
