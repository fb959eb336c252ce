"""Rasters that are read over the network, by GDAL's own file systems: how, and what to say when that fails."""
from __future__ import annotations

import os
import re
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import Callable, TypeVar

from osgeo import gdal

from . import messages
from .errors import Message, RasterError
from .gdal_calls import gdal_heard, gdal_settings, gdal_silenced, vsi_bytes
from .gdal_paths import is_remote, readable_path, with_parts

Result = TypeVar("Result")

SETTINGS = {
    "GDAL_HTTP_CONNECTTIMEOUT": "10",
    "GDAL_HTTP_LOW_SPEED_TIME": "10",  # seconds in which next to nothing comes: no answer
    "GDAL_HTTP_LOW_SPEED_LIMIT": "1000",  # bytes a second; a window would take hours
    "GDAL_HTTP_TIMEOUT": "600",  # seconds of one answer: some never end
    "GDAL_HTTP_MAX_RETRY": "3",  # of a request that is refused for now (429, 5xx)
    "GDAL_HTTP_RETRY_DELAY": "0.5",  # seconds, more each time
    "GDAL_HTTP_MERGE_CONSECUTIVE_RANGES": "YES",
    "GDAL_DISABLE_READDIR_ON_OPEN": "TRUE",  # a mask beside a file is asked for by name, and no folder is listed
}
"""GDAL's options for all that is remote; those that the user has set stay."""
REMEMBERED_S = 60.0  # in which what failed is not asked for again: each block would wait for it
_PROBED_BYTES = 16384  # the least that GDAL fetches
_TOO_SLOW = "too slow"
_FAILED = re.compile(f"Range downloading|CURL error|{_TOO_SLOW}")
_MOST_PROBED = 32  # remote parts of a VRT that are asked which one failed
_MAY_BE_THE_NETWORK = (
    messages.NOT_FOUND.template, messages.NOT_A_RASTER.template, messages.NOT_READABLE.template,
    messages.DAMAGED.template,
)


def remote_parts(path: str) -> tuple[str, ...]:
    """What of a raster is read over the network: itself, or what VRTs and tile indexes on this machine name."""
    return tuple(filter(is_remote, with_parts(path)))


@contextmanager
def remote_settings(**more: str) -> Iterator[None]:
    """GDAL's options for remote files in this thread, but for those that the user set otherwise."""
    options = {**SETTINGS, **more}
    # One that only this thread has is from a block around this one.
    free = {
        name: value for name, value in options.items()
        if gdal.GetThreadLocalConfigOption(name) is not None or gdal.GetConfigOption(name) is None
    }
    with gdal_settings(**free):
        yield


_failures: dict[str, tuple[float, Message]] = {}
"""Until when a path is not asked for again, and why."""


def forget_failures() -> None:
    """Ask again for all that failed."""
    _failures.clear()


def with_retries(path: str, name: str, read: Callable[[bool], Result]) -> Result:
    """What ``read`` gives of a raster at once, or in a second attempt: told so, it is to open the raster anew.

    Raises RasterError with the cause, or what ``read`` raises about a raster that came whole. What failed is
    remembered for a while, by all threads, and fails at once; of a VRT not, since others of its parts may be there.
    """
    until, failure = _failures.get(path, (0.0, messages.NOT_FOUND))
    if time.monotonic() < until:
        raise RasterError(failure)
    try:
        return read(False)
    except RasterError as error:
        if error.message.template not in _MAY_BE_THE_NETWORK:
            raise
    gdal.VSICurlClearCache()  # what was fetched, and what is said to be there
    probed = ((part, _said_on_reading(part)) for part in remote_parts(path)[:_MOST_PROBED])
    part, said = next(((part, said) for part, said in probed if said), (path, ""))
    shown = (name if part == path else os.path.basename(part)).partition("?")[0]  # without what may be a password
    if said:
        status = re.search(r"HTTP (?:response|error) code:? ([1-9]\d\d)", said)
        words = re.sub(r" on \w+://\S+", "", said)  # an address may hold a password
        why = f"HTTP {status[1]}" if status else words.rpartition("CURL error: ")[2]
        failure = messages.REMOTE_NOT_READABLE(name=shown, why=why)
    else:
        try:
            return read(True)
        except RasterError as error:
            failure = error.message
    if is_remote(path):
        _failures[path] = time.monotonic() + REMEMBERED_S, failure
    raise RasterError(failure)


def remote_state(path: str) -> str:
    """Size, time of change and entity tag of what a server has, as far as it tells them now."""
    path = readable_path(path)
    gdal.VSICurlClearCache()
    with gdal_silenced(), suppress(RuntimeError):
        status, headers = gdal.VSIStatL(path), gdal.GetFileMetadata(path, "HEADERS") or {}
        tags = [value for name, value in headers.items() if name.lower() == "etag"]
        return f"{status and status.size} {status and status.mtime} {''.join(tags)}"
    return ""


def _said_on_reading(path: str) -> str:
    """GDAL's words for why the first bytes of a remote file can't be read; empty where they can."""
    try:
        with gdal_heard() as said, remote_settings(CPL_VSIL_CURL_USE_HEAD="NO"):  # bytes, as of the pixels
            gdal.VSIErrorReset()
            content, status = vsi_bytes(readable_path(path), _PROBED_BYTES), gdal.VSIStatL(readable_path(path))
    except RuntimeError as error:
        return str(error)
    words = [text for _, text in said]
    if status is None:
        return gdal.VSIGetLastErrorMsg() or "".join(words[-1:]) or "unknown"
    if len(content) < min(status.size, _PROBED_BYTES):
        words.append(_TOO_SLOW)  # GDAL makes do with what came until it lost patience
    return next(filter(_FAILED.search, words), "")
