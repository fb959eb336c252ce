"""Work done for many requests by an executor: results in order, within a bound of memory, until it is cancelled.

What the process has while our own measure, and gives back after: one thread of BLAS, memory that is kept, and no
more of GDAL's cache than that needs.

Several threads of BLAS wait for each other by spinning, which costs more than they help with the small products of a
window, and takes the cores from other windows. By the libraries' own calls: threadpoolctl, which does the same, lets
one thread of a process do so.

A window takes hundreds of arrays, a block thousands. Pages fresh from the system cost as much time as the arithmetic on
them, so what arrays let go of is kept for the next ones. By the C library's call, where it is glibc's.

GDAL keeps what it read until a twentieth of the machine's memory is full. Each pixel is read once, so only what one
read decodes is worth to be kept.
"""
from __future__ import annotations

import ctypes
import logging
import os
import platform
import sys
import threading
from collections import deque
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, Executor, Future, wait
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache
from itertools import islice
from pathlib import Path
from typing import NoReturn, TypeVar

import numpy as np
from osgeo import gdal

from ...imagery.errors import CancelledError, Message, SeamInspectorError
from ...imagery.messages import CANCELLED
from ...imagery.raster_pool import own_threads
from . import messages

_Calls = tuple[Callable[[], int], Callable[[int], object]]
"""How many threads a library has, and the call that sets that."""

_NAMES = tuple(
    (f"{prefix}openblas_get_num_threads{suffix}", f"{prefix}openblas_set_num_threads{suffix}")
    for prefix in ("", "scipy_") for suffix in ("", "64_", "_64")
) + (("MKL_Get_Max_Threads", "MKL_Set_Num_Threads"), ("bli_thread_get_num_threads", "bli_thread_set_num_threads"))
_LIBRARIES = ("openblas", "mkl_rt", "blis")

_TRIM_THRESHOLD, _TOP_PAD, _MMAP_THRESHOLD = -1, -2, -3  # malloc.h
_LARGEST = 32 * 2**20
"""Bytes of what comes from the heap: glibc takes no more, and gets there by itself with the first large raster."""
_KEPT = {_MMAP_THRESHOLD: _LARGEST, _TRIM_THRESHOLD: 16 * _LARGEST, _TOP_PAD: 2 * _LARGEST}
_GIVEN_BACK = {_MMAP_THRESHOLD: _LARGEST, _TRIM_THRESHOLD: 2 * _LARGEST, _TOP_PAD: 2**17}
"""What glibc has after that raster."""

_CACHE_PER_CORE = 128 * 2**20
"""Bytes: tiles of a block's bands, read one band after the other, times ten."""

_lock = threading.Lock()
_under_way = 0
_before: list[int] = []
_cache_before = 0


@contextmanager
def measuring() -> Iterator[None]:
    """While anything runs in such a block, in whatever thread, each BLAS of the process has one thread, memory is kept,
    and GDAL's cache is bounded; then as many as before the first, and it goes back to the system. Where no BLAS or
    another C library is known, nothing changes of these."""
    global _under_way, _cache_before
    with _lock:
        if not _under_way:
            _before[:] = [count() for count, _ in _libraries()]
            _set([1] * len(_before), _KEPT)
            _cache_before = gdal.GetCacheMax()
            gdal.SetCacheMax(min(_cache_before, _CACHE_PER_CORE * (os.cpu_count() or 1)))
        _under_way += 1
    try:
        with np.errstate(over="ignore", invalid="ignore"):  # of values that no image has: nothing is measured there
            yield
    finally:
        with _lock:
            _under_way -= 1
            if not _under_way:
                _set(_before, _GIVEN_BACK)
                gdal.SetCacheMax(_cache_before)


def _set(counts: list[int], memory: dict[int, int]) -> None:
    for (_, set_count), count in zip(_libraries(), counts):
        set_count(count)
    if (library := _glibc()) is not None:
        for option, value in memory.items():
            library.mallopt(option, value)


@cache
def _glibc() -> ctypes.CDLL | None:
    return ctypes.CDLL(None) if platform.libc_ver()[0] == "glibc" else None


@cache
def _libraries() -> list[_Calls]:
    """Calls of every BLAS that is loaded: numpy and scipy may each have brought one."""
    return [calls for path in _loaded() if (calls := _calls_of(path)) is not None]


def _loaded() -> list[str]:
    """Files of libraries that this process has loaded, as far as the system tells."""
    maps = Path("/proc/self/maps")
    if maps.exists():
        paths = {line.split(maxsplit=5)[-1].strip() for line in maps.read_text("utf-8", "replace").splitlines()}
    else:  # Windows and macOS: what comes with the wheels
        wheels = [Path(str(sys.modules[name].__file__)).parent for name in ("numpy", "scipy") if name in sys.modules]
        beside = [folder for wheel in wheels for folder in (wheel.with_name(f"{wheel.name}.libs"), wheel / ".dylibs")]
        paths = {str(path) for folder in beside for path in folder.glob("*")}
    return sorted(path for path in paths if any(name in Path(path).name for name in _LIBRARIES))


def _calls_of(path: str) -> _Calls | None:
    try:
        library = ctypes.CDLL(path)
    except OSError:  # it was replaced on the disk meanwhile
        return None
    for get_count, set_count in _NAMES:
        if hasattr(library, get_count) and hasattr(library, set_count):
            return getattr(library, get_count), getattr(library, set_count)
    return None


_log = logging.getLogger("seam_inspector")
Request = TypeVar("Request")
Result = TypeVar("Result")

_PATIENCE_SECONDS = 0.2  # between two looks at whether the run was cancelled
_MANY = 16  # tasks under way: each then has several requests
_AT_A_TIME = 8


@dataclass(frozen=True, eq=False)
class Workers:
    """Who measures, until when, and who is told how far it is."""

    executor: Executor | None = None
    """A thread per core where None."""
    ahead: int = 0
    """Most requests under way or waiting to be taken, so that memory does not grow with their number; twice this
    machine's cores where 0."""
    cancelled: Callable[[], bool] = lambda: False
    """Is asked several times a second whether to end."""
    progress: Callable[[float], object] = lambda share: None
    """Is told the share that is done, 0 to 1, now and then; what it raises ends the work."""

    @property
    def together(self) -> int:
        """Requests that are handed out at once: several where many take them, as one takes as long as all."""
        return _AT_A_TIME if self.ahead > _MANY else 1

    @contextmanager
    def at_work(self) -> Iterator[Workers]:
        """These, with an executor as long as the block lasts."""
        with own_threads(self.executor, self.ahead) as (executor, ahead):
            yield replace(self, executor=executor, ahead=ahead)

    def part(self, first: float, last: float = 1.0) -> Workers:
        """These at a part of the work, from one share that is done to another."""
        return replace(self, progress=lambda share: self.progress(first + (last - first) * share))

    def tell(self, share: float) -> None:
        """So much is done. Raises CancelledError where nobody wants more."""
        self.progress(share)
        if self.cancelled():
            raise CancelledError(CANCELLED())

    def map(self, work: Callable[[Request], Result], requests: Iterable[Request], count: int) -> Iterator[Result]:
        """What is made of each of so many requests, in their order. Raises what it raises, CancelledError."""
        done = 0
        for done, result in enumerate(in_order(requests, work, _raised, self, self.together), 1):
            yield result
            self.tell(done / count)
        if done < count:
            raise CancelledError(CANCELLED())


def _raised(_request: object, reason: Message) -> NoReturn:
    raise SeamInspectorError(reason)


def in_order(
    requests: Iterable[Request],
    measure: Callable[[Request], Result],
    failed: Callable[[Request, Message], Result],
    workers: Workers,
    together: int = 1,
) -> Iterator[Result]:
    """Results in the order of the requests, each as soon as it and those before it are ready.

    ``together``: how many requests are handed out at once. ``failed`` makes the result of a request whose measurement
    raised an error that nobody foresaw. Stops when the run is cancelled, with the results that are ready by then, in a
    fraction of a second even while a window is under way. Raises BrokenExecutor when nobody is left to measure.
    """
    waiting: deque[tuple[list[Request], Future[list[Result]]]] = deque()
    requests = iter(requests)
    try:
        while some := list(islice(requests, together)):
            if workers.cancelled():
                break
            assert workers.executor is not None
            try:
                future = workers.executor.submit(_each, measure, some)
            except RuntimeError as error:  # of one that was shut down, for which Python has no error of its own
                raise BrokenExecutor(str(error)) from None
            waiting.append((some, future))
            if len(waiting) >= workers.ahead:
                yield from _ready(*waiting.popleft(), failed, workers.cancelled)
        while waiting:
            yield from _ready(*waiting.popleft(), failed, workers.cancelled)
    finally:
        for _, future in waiting:
            future.cancel()


def _each(measure: Callable[[Request], Result], requests: Sequence[Request]) -> list[Result]:
    return [measure(request) for request in requests]


def _ready(
    requests: Sequence[Request],
    future: Future[list[Result]],
    failed: Callable[[Request, Message], Result],
    cancelled: Callable[[], bool],
) -> Iterator[Result]:
    """The results as soon as they are there; none when ``cancelled`` says so before."""
    while not future.done():
        if cancelled():
            future.cancel()
            return
        wait([future], timeout=_PATIENCE_SECONDS)
    error = future.exception()
    if error is None:
        yield from future.result()
    elif isinstance(error, Exception) and not isinstance(error, BrokenExecutor):
        reason = unforeseen(error)
        yield from (failed(request, reason) for request in requests)
    else:
        raise error


def unforeseen(error: Exception) -> Message:
    """Why there is no result, of an error that nobody foresaw there; where it came from goes to the log."""
    if isinstance(error, SeamInspectorError):
        return error.message
    _log.error("%s", error, exc_info=error)
    return messages.WINDOW_FAILED(error=f"{type(error).__name__}: {error}")
