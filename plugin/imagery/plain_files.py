"""Paths that must not be opened, whoever names them: they never end, make whoever reads them wait, or are memory."""
from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterator
from functools import lru_cache
from html import unescape

from . import messages
from .errors import RasterError

_OF_THE_SYSTEM = ("/dev/", "/proc/", "/sys/")
_NOT_FILES = re.compile(r"MEM:::|DATAPOINTER\s*=|/vsistdin", re.I)
"""What GDAL takes for places in the process's memory, or for what is typed."""
_MOST_PARTS = 100_000  # of a VRT, and of those in it
_MOST_BYTES = 100_000_000  # of a VRT's text
_HEAD = re.compile(rb"\s*(?:\xef\xbb\xbf)?\s*<VRT")
_SOURCE = re.compile(r"<Source(?:Filename|Dataset)([^>]*)>\s*(?:<!\[CDATA\[)?([^<\]]+)", re.I)
_RELATIVE = re.compile(r"relativeToVRT\s*=\s*[\"']1[\"']")


def is_endless(path: str) -> bool:
    """Whether a path is no file with an end: a device, a pipe, a socket, or a file that the system makes up."""
    try:
        mode = os.stat(path).st_mode
    except (OSError, ValueError):
        return False
    if not (stat.S_ISREG(mode) or stat.S_ISDIR(mode)):
        return True
    return os.path.realpath(path).startswith(_OF_THE_SYSTEM) and not stat.S_ISDIR(mode)


def check_raster_path(path: str, name: str) -> None:
    """Raise RasterError for what GDAL must not open: no file with an end, memory, or a VRT that leads to those."""
    if _NOT_FILES.search(path) or is_endless(path):
        raise RasterError(messages.NO_FILE(name=name))
    waiting, seen = [path], {path}
    while waiting:
        for part in vrt_parts(waiting.pop()):
            if part in seen:
                continue
            if _NOT_FILES.search(part) or is_endless(part):
                raise RasterError(messages.VRT_LEADS_OUT(name=name, path=part))
            seen.add(part)
            waiting.append(part)
        if len(seen) > _MOST_PARTS:
            raise RasterError(messages.VRT_OF_TOO_MANY(name=name, most=_MOST_PARTS))


def vrt_parts(path: str) -> tuple[str, ...]:
    """The files that a VRT on this machine names, as far as it can be read; none of what is no VRT."""
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return ()
    return _sources_in(path, found.st_mtime_ns, found.st_size)


@lru_cache(4096)
def _sources_in(path: str, changed_ns: int, size: int) -> tuple[str, ...]:
    """What a VRT names, as long as it does not change; none of what is no VRT."""
    if not stat.S_ISREG(os.stat(path).st_mode):
        return ()
    try:
        with open(path, "rb") as file:
            head = file.read(64)
            content = head + file.read(_MOST_BYTES) if _HEAD.match(head) else b""
    except OSError:
        return ()
    return tuple(_named(unescape(content.decode(errors="replace")), os.path.dirname(os.path.abspath(path))))


def _named(text: str, folder: str) -> Iterator[str]:
    for attributes, name in _SOURCE.findall(text):
        yield os.path.normpath(os.path.join(folder, name)) if _RELATIVE.search(attributes) else name.strip()
    yield from (found.group() for found in _NOT_FILES.finditer(text))
