"""Rasters that are read over the network, by GDAL's own file systems: how, and what to say when that fails."""
from __future__ import annotations

import os
import re
import threading
import time
from collections.abc import Iterator, Mapping
from concurrent.futures import Future, ThreadPoolExecutor, wait
from contextlib import contextmanager
from functools import partial
from typing import Any, Callable, NamedTuple, TypeVar
from urllib.parse import urlsplit

from osgeo import gdal

from . import messages
from .errors import CancelledError, Message, RasterError
from .gdal_calls import gdal_settings, gdal_silenced
from .gdal_paths import is_remote, readable_path, vrt_parts

Result = TypeVar("Result")

SETTINGS = {
    "GDAL_HTTP_CONNECTTIMEOUT": "10",
    "GDAL_HTTP_LOW_SPEED_TIME": "10",  # seconds in which next to nothing comes: no answer
    "GDAL_HTTP_LOW_SPEED_LIMIT": "1000",  # bytes a second; a window would take hours
    "GDAL_HTTP_TIMEOUT": "600",  # of one answer: some never end
    "GDAL_HTTP_MAX_RETRY": "2",  # by GDAL, of a request that is refused for now (429, 5xx)
    "GDAL_HTTP_RETRY_DELAY": "0.5",
    "GDAL_HTTP_MERGE_CONSECUTIVE_RANGES": "YES",
}
"""GDAL's options for all that is remote; those that the user has set stay."""
COMPLETE = {"GDAL_DISABLE_READDIR_ON_OPEN": "EMPTY_DIR"}
"""For a file that has all inside, as a COG: nothing beside it is asked for."""
WITH_OTHERS = {"GDAL_DISABLE_READDIR_ON_OPEN": "TRUE"}
"""For one that may have a mask beside it: that is asked for by name, and no folder is listed."""
DELAYS_S = (1.0, 4.0)  # before the second attempt and the third, our own: GDAL gives up a group of ranges at once
PATIENCE_S = 30.0  # no further attempt when those before took longer and it still is not there
REMEMBERED_S = 60.0  # in which what failed is not asked for again: each block would wait for it
GONE_S = 600.0  # the same for what is not there, or refused
_PROBED_BYTES = 16384  # the least that GDAL fetches
_TOO_SLOW = "too slow"
MOST_PROBED = 32  # remote parts of a VRT that are asked which one failed

_STATUS = re.compile(r"HTTP (?:response|error) code[^:]*: (\d{3})")
_MAY_BE_THE_NETWORK = (
    messages.NOT_FOUND.template, messages.NOT_A_RASTER.template, messages.NOT_READABLE.template,
    messages.DAMAGED.template,
)


class RemoteError(RasterError):
    """A raster could not be read over the network."""

    def __init__(self, message: Message, may_pass: bool = False) -> None:
        super().__init__(message)
        self.may_pass = may_pass
        """Whether it may be there again later: no answer, an overloaded server, a broken connection."""


class _Failure(NamedTuple):
    """Why the network gave nothing."""

    message: Message
    may_pass: bool
    of_host: bool = False
    """Whether every file of that server will have it."""


def remote_parts(path: str) -> tuple[str, ...]:
    """What of a raster is read over the network: itself, or what VRTs and tile indexes on this machine name."""
    found = {path: None}  # in their order
    waiting = [path]
    while waiting:
        one = waiting.pop()
        parts = () if is_remote(one) else vrt_parts(one)
        waiting += [part for part in dict.fromkeys(parts) if part not in found]
        found.update(dict.fromkeys(parts))
    return tuple(filter(is_remote, found))


@contextmanager
def remote_settings(more: Mapping[str, str]) -> Iterator[None]:
    """GDAL's options for remote files in this thread, but for those that the user set otherwise."""
    options = {**SETTINGS, **more}
    # One that only this thread has is from a block around this one.
    free = {
        name: value for name, value in options.items()
        if gdal.GetThreadLocalConfigOption(name) is not None or gdal.GetConfigOption(name) is None
    }
    with gdal_settings(**free):
        yield


def persistently(path: str, name: str, read: Callable[[bool], Result]) -> Result:
    """What ``read`` gives of a raster at once or in a later attempt, where another one makes sense.

    ``read`` is told whether it is another one, for which the raster is best opened anew.

    Raises RemoteError with the cause, or what ``read`` raises about a raster that came whole; CancelledError where
    nobody wants it any more. What failed is remembered
    for a while, by all threads, and fails at once; of a VRT not, since others of its parts may be there.
    """
    started = time.monotonic()
    if is_remote(path):
        _raise_remembered(path)
    for attempt, delay in enumerate((*DELAYS_S, None)):
        try:
            return unless_cancelled(partial(read, attempt > 0))
        except RasterError as error:
            if error.message.template not in _MAY_BE_THE_NETWORK or is_cancelled():
                raise
            forget_fetched(path)
            lasting = unless_cancelled(lambda: _failure_of(path, name))
            failure = lasting or _failure_in_between(error, name)
        if delay is None or not failure.may_pass or (lasting and time.monotonic() - started > PATIENCE_S):
            break
        if _is_cancelled_within(delay):
            raise RemoteError(failure.message, failure.may_pass)
    if is_remote(path):
        _remember(path, failure)
    raise RemoteError(failure.message, failure.may_pass)


_thread = threading.local()
_ASKED_EVERY_S = 0.1  # whether it is cancelled
_LONGEST_S = 120.0  # of a call whose server drips


def read_until(cancelled: Callable[[], bool]) -> None:
    """This thread gives up what it reads over the network, and makes no further attempts, once this says so."""
    _thread.cancelled = cancelled


@contextmanager
def heeding(cancelled: Callable[[], bool]) -> Iterator[None]:
    """Give up reading over the network once this says so, while the block runs, also in the threads that read for
    it."""
    outer = getattr(_thread, "cancelled", None)
    read_until(cancelled)
    try:
        yield
    finally:
        _thread.cancelled = outer
        _let_helper_go()


def is_cancelled() -> bool:
    """Whether nobody wants any more what this thread reads."""
    cancelled = getattr(_thread, "cancelled", None)
    return cancelled is not None and cancelled()


def asked_by() -> Callable[[], bool]:
    """What tells this thread that it is cancelled, to be asked by those that read for it."""
    return getattr(_thread, "cancelled", None) or (lambda: False)


def unless_cancelled(call: Callable[[], Result]) -> Result:
    """What a call gives that waits for the network. Raises CancelledError as soon as this thread is cancelled.

    GDAL can't be interrupted, so a second thread makes the call where somebody may cancel it; it is left alone then,
    until GDAL's own limits end it (``wait_for_left_alone``). Nothing that it reads may be used by others meanwhile.
    """
    if getattr(_thread, "cancelled", None) is None:
        return call()
    if is_cancelled():
        raise CancelledError(messages.CANCELLED())
    if getattr(_thread, "helper", None) is None:
        _thread.helper = ThreadPoolExecutor(1, "seam-inspector-network")
    under_way = _thread.helper.submit(call)
    while not wait([under_way], _ASKED_EVERY_S).done:
        if is_cancelled():
            _left_alone.add(under_way)
            under_way.add_done_callback(_left_alone.discard)
            _let_helper_go()
            raise CancelledError(messages.CANCELLED())
    return under_way.result()


_left_alone: set[Future[Any]] = set()


def wait_for_left_alone() -> None:
    """Wait for calls that nobody wants any more: GDAL must not be taken down under them."""
    wait(list(_left_alone), _LONGEST_S)


def _let_helper_go() -> None:
    helper: ThreadPoolExecutor | None = getattr(_thread, "helper", None)
    _thread.helper = None
    if helper is not None:
        helper.shutdown(wait=False)


def _is_cancelled_within(seconds: float) -> bool:
    last = time.monotonic() + seconds
    while not is_cancelled():
        left = last - time.monotonic()
        if left <= 0:
            return False
        time.sleep(min(left, _ASKED_EVERY_S))
    return True


def forget_fetched(path: str) -> None:
    """Drop what GDAL keeps of a raster that was fetched, in memory and of its being there."""
    with gdal_silenced():
        if is_remote(path):
            gdal.VSICurlPartialClearCache(_container(readable_path(path)))
        else:
            gdal.VSICurlClearCache()


def forget_failures() -> None:
    """Ask again for all that failed."""
    with _failures_lock:
        _failures.clear()


_failures: dict[str, tuple[float, _Failure]] = {}
"""Until when a path or host is not asked for again, and why."""
_failures_lock = threading.Lock()


def _remember(path: str, failure: _Failure) -> None:
    until = time.monotonic() + (REMEMBERED_S if failure.may_pass else GONE_S)
    with _failures_lock:
        _failures[(failure.of_host and _host(path)) or path] = until, failure


def _raise_remembered(path: str) -> None:
    if not _failures:
        return
    with _failures_lock:
        for key in (path, _host(path)):
            until, failure = _failures.get(key, (0.0, None))
            if failure is not None and time.monotonic() < until:
                raise RemoteError(failure.message, failure.may_pass)
            _failures.pop(key, None)


def _failure_in_between(error: RasterError, name: str) -> _Failure:
    """Why a raster failed though its server gives it: the connection broke, or the file itself is broken."""
    if error.message.template == messages.NOT_READABLE.template:
        return _Failure(messages.REMOTE_IN_PART(name=_shown(name)), may_pass=True)
    return _Failure(error.message, may_pass=True)


def _failure_of(path: str, name: str) -> _Failure | None:
    """What keeps the network from giving a raster; None where it gives it by now."""
    several = not is_remote(path)
    for part in remote_parts(path)[:MOST_PROBED]:
        failure = _probed(_container(readable_path(part)), _shown(os.path.basename(part) if several else name))
        if failure is not None:
            return failure
    return None


def _probed(path: str, name: str) -> _Failure | None:
    """What a server says when asked for a file as GDAL asks first (HEAD), and for its bytes (GET)."""
    for head in ("YES", "NO"):
        gdal.VSICurlPartialClearCache(path)
        with remote_settings({"CPL_VSIL_CURL_USE_HEAD": head, "GDAL_HTTP_MAX_RETRY": "0"}):
            said = _said_on_opening(path)
        if said:
            gdal.VSICurlPartialClearCache(path)
            return _failure(said, name)
    return None


def _said_on_opening(path: str) -> str:
    """GDAL's word for why a file can't be opened or read; empty where it can."""
    said: list[str] = []
    gdal.PushErrorHandler(lambda level, number, text: said.append(text))
    try:
        gdal.VSIErrorReset()
        file = gdal.VSIFOpenExL(path, "rb", 1)
        if file is None:
            return gdal.VSIGetLastErrorMsg() or "".join(said[-1:]) or "unknown"
        try:
            gdal.VSIFSeekL(file, 0, os.SEEK_END)
            wanted = min(gdal.VSIFTellL(file), _PROBED_BYTES)
            gdal.VSIFSeekL(file, 0, os.SEEK_SET)
            if len(gdal.VSIFReadL(1, wanted, file) or b"") < wanted and not said:
                return _TOO_SLOW  # GDAL makes do with what came until it lost patience
        finally:
            gdal.VSIFCloseL(file)
    except RuntimeError as error:
        return str(error)
    finally:
        gdal.PopErrorHandler()
    return next((text for text in said if "Range downloading" in text), "")


def _failure(said: str, name: str) -> _Failure:
    status = _STATUS.search(said)
    code = int(status[1]) if status else 0
    if code in (404, 410):
        return _Failure(messages.REMOTE_NOT_FOUND(name=name, code=code), may_pass=False)
    if code in (401, 403, 407):
        return _Failure(messages.REMOTE_REFUSED(name=name, code=code), may_pass=False)
    if code:
        passes = code >= 500 or code in (408, 429)
        return _Failure(messages.REMOTE_FAILING(name=name, code=code), may_pass=passes)
    if "Range downloading" in said:
        return _Failure(messages.REMOTE_WITHOUT_RANGES(name=name), may_pass=False)
    if said == _TOO_SLOW:
        slowest = int(SETTINGS["GDAL_HTTP_LOW_SPEED_LIMIT"])
        return _Failure(messages.REMOTE_SLOW(name=name, bytes=slowest), may_pass=True, of_host=True)
    if "CURL error" in said:
        why = said.partition("CURL error: ")[2]
        return _Failure(messages.REMOTE_SILENT(name=name, why=why), may_pass=True, of_host=True)
    return _Failure(messages.REMOTE_NOT_OPENED(name=name, why=said), may_pass=False)


def _container(path: str) -> str:
    """The file that is fetched: of one inside an archive, the archive."""
    inside = re.match(r"^/vsi(?:zip|tar|gzip|7z|rar|cached)/\{?(.*)$", path)
    if inside is None:
        return path
    archive = re.match(r"(.*?\.(?:zip|kmz|tar|tgz|tar\.gz|gz|7z|rar))(?=/|\}|$)", inside[1], re.I)
    found = archive[1] if archive else inside[1]
    return found if found.startswith("/") else f"/{found}"


def _host(path: str) -> str:
    """The server of an address; empty where the path names none."""
    address = re.search(r"https?://[^/]+", path)
    return urlsplit(address[0]).netloc.rpartition("@")[2] if address else ""


def _shown(name: str) -> str:
    """A name without what may be a password behind it."""
    return name.partition("?")[0]
