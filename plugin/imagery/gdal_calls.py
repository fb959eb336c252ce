"""GDAL without its own messages, its failures as ours whether or not its exceptions are on, and what it must not open.

That are paths that never end, make whoever reads them wait, or are memory, whoever names them.
"""
from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import lru_cache
from html import unescape
from typing import Any, Callable, NamedTuple

from osgeo import gdal

from . import messages
from .errors import Message, RasterError

_OF_THE_SYSTEM = ("/dev/", "/proc/", "/sys/")
_NOT_FILES = re.compile(r"MEM:::|DATAPOINTER\s*=|/vsistdin", re.I)
"""What GDAL takes for places in the process's memory, or for what is typed."""
_MOST_PARTS = 100_000  # of a VRT, and of those in it
_MOST_BYTES = 100_000_000  # of a VRT's text
_MOST_READINGS = 300_000  # of files for one band, where VRTs name VRTs that name each file again and again
_MOST_DEPTH = 1000  # of VRTs in VRTs; GDAL itself gives up long before
_HEAD = re.compile(rb"\s*(?:\xef\xbb\xbf)?\s*<VRT")
_BAND = re.compile(r"<VRTRasterBand\b", re.I)
_SOURCE = re.compile(r"<Source(?:Filename|Dataset)([^>]*)>\s*(?:<!\[CDATA\[)?([^<\]]+)", re.I)
_RELATIVE = re.compile(r"relativeToVRT\s*=\s*[\"']1[\"']")


class _PathLook(NamedTuple):
    """What a path is, as long as it stays the same file."""

    is_no_file: bool
    """Whether it has no end, or is memory."""
    parts: tuple[str, ...]
    """What a VRT names; none of what is no VRT."""
    bands: int = 1
    """Of a VRT, which names its parts once for each."""


def is_endless(path: str) -> bool:
    """Whether a path is no file with an end: a device, a pipe, a socket, or a file that the system makes up."""
    return _looked_at(path).is_no_file


def check_raster_path(path: str, name: str) -> None:
    """Raise RasterError for what GDAL must not open: no file with an end, memory, or a VRT that leads to those.

    Each part is asked for what it is now; only what changed is looked at anew, as mosaics are opened for every window.
    """
    look = _looked_at(path)
    if look.is_no_file:
        raise RasterError(messages.NO_FILE(name=name))
    waiting, seen, virtual = [look.parts], {path}, {path: look}
    while waiting:
        for part in waiting.pop():
            if part in seen:
                continue
            look = _looked_at(part)
            if look.is_no_file:
                raise RasterError(messages.VRT_LEADS_OUT(name=name, path=part))
            seen.add(part)
            if look.parts:
                virtual[part] = look
                waiting.append(look.parts)
        if len(seen) > _MOST_PARTS:
            raise RasterError(messages.VRT_OF_TOO_MANY(name=name, most=_MOST_PARTS))
    if len(virtual) > 1 and _readings(path, virtual) > _MOST_READINGS:
        raise RasterError(messages.VRT_OF_TOO_MANY(name=name, most=_MOST_READINGS))


def _readings(path: str, virtual: Mapping[str, _PathLook]) -> float:
    """How many files the deepest of VRTs in VRTs has opened for one band, each as often as it is named."""
    counts, most = {path: 1.0}, 0.0
    for _ in range(_MOST_DEPTH):
        named: dict[str, float] = {}
        for one, count in counts.items():
            for part in virtual[one].parts:
                named[part] = named.get(part, 0.0) + count / virtual[one].bands
        most = max(most, sum(named.values()))
        counts = {one: count for one, count in named.items() if one in virtual}
        if not counts or most > _MOST_READINGS:
            break
    return most


def vrt_parts(path: str) -> tuple[str, ...]:
    """The files that a VRT on this machine names, as far as it can be read; none of what is no VRT."""
    return _looked_at(path).parts


def _looked_at(path: str) -> _PathLook:
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return _PathLook(_NOT_FILES.search(path) is not None, ())
    return _look(
        path, found.st_mode, found.st_dev, found.st_ino, found.st_size, found.st_mtime_ns, found.st_ctime_ns
    )  # fmt: skip


@lru_cache(_MOST_PARTS)
def _look(path: str, mode: int, *identity: int) -> _PathLook:
    """Of what is there: links may lead elsewhere by now, but then to a file of another ``identity``."""
    is_folder, is_file = stat.S_ISDIR(mode), stat.S_ISREG(mode)
    is_made_up = is_file and os.path.realpath(path).startswith(_OF_THE_SYSTEM)
    if _NOT_FILES.search(path) or is_made_up or not (is_file or is_folder):
        return _PathLook(True, ())
    if is_folder:
        return _PathLook(False, ())
    try:
        with open(path, "rb") as file:
            head = file.read(64)
            content = head + file.read(_MOST_BYTES) if _HEAD.match(head) else b""
    except OSError:
        return _PathLook(False, ())
    text, folder = unescape(content.decode(errors="replace")), os.path.dirname(os.path.abspath(path))
    return _PathLook(False, tuple(_named(text, folder)), max(len(_BAND.findall(text)), 1))


def _named(text: str, folder: str) -> Iterator[str]:
    for attributes, name in _SOURCE.findall(text):
        yield os.path.normpath(os.path.join(folder, name)) if _RELATIVE.search(attributes) else name.strip()
    yield from (found.group() for found in _NOT_FILES.finditer(text))


_MASK_INSIDE = "GDAL_TIFF_INTERNAL_MASK"


@contextmanager
def gdal_silenced() -> Iterator[None]:
    """GDAL's own messages off in this thread; ours say it in the user's terms."""
    gdal.PushErrorHandler("CPLQuietErrorHandler")
    try:
        yield
    finally:
        gdal.PopErrorHandler()


def gdal_call(call: Callable[[], Any], failure: Message) -> Any:
    """What a GDAL call returns; RasterError when it fails."""
    with gdal_silenced():
        try:
            result = call()
        except RuntimeError:
            result = None
    if result is None:
        raise RasterError(failure)
    return result


@contextmanager
def gdal_writing(failure: Message) -> Iterator[None]:
    """RasterError for whatever fails in a block that writes or closes a file; closing has no result to look at."""
    with gdal_silenced():
        gdal.ErrorReset()
        try:
            yield
            failed = gdal.GetLastErrorType() >= gdal.CE_Failure
        except RuntimeError:
            failed = True
    if failed:
        raise RasterError(failure)


@contextmanager
def gdal_masks_beside() -> Iterator[None]:
    """A mask that this thread adds to a TIFF becomes a file beside it, as before GDAL 3.13."""
    before = gdal.GetThreadLocalConfigOption(_MASK_INSIDE)
    gdal.SetThreadLocalConfigOption(_MASK_INSIDE, "NO")
    try:
        yield
    finally:
        gdal.SetThreadLocalConfigOption(_MASK_INSIDE, before)


def drop_from_memory(path: str) -> None:
    """Remove a file of /vsimem and what GDAL wrote beside it; removing what is not there raises in GDAL 3.10."""
    for name in (path, *(path + ending for ending in (".aux.xml", ".msk", ".ovr"))):
        if gdal.VSIStatL(name) is not None:
            gdal.Unlink(name)
