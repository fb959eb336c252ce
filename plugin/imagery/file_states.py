"""What is known of the files that rasters are read from, without opening them.

By it a file is known again elsewhere, and seen to have changed, or to be another one.
"""
from __future__ import annotations

import json
import os
import stat
from collections.abc import Iterable, Iterator
from hashlib import blake2b
from pathlib import Path
from typing import NamedTuple
from xml.etree.ElementTree import Element, ParseError, tostring

from osgeo import gdal

from .documents import json_document, xml_root
from .gdal_calls import gdal_silenced
from .gdal_paths import is_remote, local_file, readable_path, vrt_parts
from .remote_files import forget_fetched

_BESIDE = ("", ".msk")
"""Endings of the files that say what a raster's pixels are: itself, its mask."""
_LOOKS, _LOOK_BYTES = 16, 4096
"""Parts of a file that are looked at: it may change with its size and time kept."""
OF_NO_CONSEQUENCE = "Metadata", "Histograms", "Description", "CategoryNames"
"""What QGIS writes when it first shows a raster, such as statistics, changes no pixel."""
_MOST_READ = 20_000_000  # bytes of a VRT
_NAMED_FILE = "SourceFilename", "SourceDataset"


class FileState(NamedTuple):
    """A file at some time."""

    size: int
    """Bytes."""
    time_ns: int
    """Of its last change; 0 of a VRT, into which GDAL writes statistics."""
    digest: str
    """Of its head, its end and some bytes between; of a VRT of all that it says but the folders of its files. Empty
    where it is no plain file."""

    @property
    def content(self) -> tuple[int, str]:
        """The same for a copy."""
        return self.size, self.digest


def local_states(paths: Iterable[str]) -> dict[str, FileState]:
    """Of the files of this machine that rasters are read from, by their whole paths: those that a VRT or an archive is
    made of, and masks, too. What is not there is left out."""
    found = {}
    for one in (part for path in paths if not is_remote(path) for part in with_parts(path)):
        file = local_file(one)
        for ending in _BESIDE if file == one else ("",):
            if (state := local_state(file + ending)) is not None:
                found[os.path.abspath(file + ending)] = state
    return found


def known_states(paths: Iterable[str], ask: bool = True) -> dict[str, FileState]:
    """``local_states``, and of remote rasters what their server says of them where it is to be asked. What nothing is
    known of has an empty digest."""
    found: dict[str, FileState] = {}
    for path in paths:
        if is_remote(path):
            found[path] = FileState(0, 0, remote_state(path) if ask else "")
        else:
            found.update(local_states([path]) or {path: FileState(0, 0, "")})
    return found


def content_of(path: str) -> str:
    """The same for a copy of a raster elsewhere: a digest of what its files hold, or the address where it is remote."""
    if is_remote(path):
        return path
    return blake2b(repr([state.content for state in local_states([path]).values()]).encode()).hexdigest()


PlacedState = tuple[str, FileState]
"""The whole path of a file, or the address of what a server has, and its state."""


def states_text(files: Iterable[PlacedState]) -> str:
    """Words that a layer can hold."""
    return json.dumps([[path, *state] for path, state in dict.fromkeys(files)])


def states_in(text: str) -> list[PlacedState]:
    """What ``states_text`` wrote; empty where it is something else."""
    try:
        return [(str(path), FileState(int(size), int(time_ns), str(digest)))
                for path, size, time_ns, digest in json_document(text or "[]")]  # fmt: skip
    except (ValueError, TypeError, OverflowError):
        return []


def with_parts(path: str) -> Iterator[str]:
    """A raster of this machine, and those that it is made of where it is a VRT."""
    seen = {path}
    waiting = [path]
    while waiting:
        one = waiting.pop()
        yield one
        if _is_vrt(one):
            parts = [part for part in vrt_parts(one) if part not in seen]
            seen.update(parts)
            waiting += parts


def _is_vrt(path: str) -> bool:
    return path.lower().endswith(".vrt")


def local_state(path: str) -> FileState | None:
    """None where there is no such file."""
    try:
        found = os.stat(path)
        if not stat.S_ISREG(found.st_mode):
            return FileState(found.st_size, found.st_mtime_ns, "")
        if _is_vrt(path) and found.st_size <= _MOST_READ:
            said = _said(Path(path).read_bytes())
            return FileState(len(said), 0, blake2b(said, digest_size=12).hexdigest())
        digest = blake2b(digest_size=12)
        with open(path, "rb") as file:
            for look in range(_LOOKS):
                file.seek(max(found.st_size - _LOOK_BYTES, 0) * look // (_LOOKS - 1))
                digest.update(file.read(_LOOK_BYTES))
    except (OSError, ValueError):
        return None
    return FileState(found.st_size, found.st_mtime_ns, digest.hexdigest())


def _said(vrt: bytes) -> bytes:
    """What a VRT says of its pixels, wherever its files lie."""
    try:
        root = xml_root(vrt)
    except ParseError:
        return vrt
    for element in list(root.iter()):
        _say_shortly(element)
    return tostring(root)


def _say_shortly(element: Element) -> None:
    if element.tag in _NAMED_FILE:
        element.text = (element.text or "").replace("\\", "/").rpartition("/")[2]
        element.attrib.pop("relativeToVRT", None)
    for child in [one for one in element if one.tag in OF_NO_CONSEQUENCE]:
        element.remove(child)
    element.text, element.tail = (element.text or "").strip(), ""


def remote_state(path: str) -> str:
    """Size, time of change and entity tag of what a server has, as far as it tells them now."""
    path = readable_path(path)
    forget_fetched(path)
    with gdal_silenced():
        try:
            found = gdal.VSIStatL(path)
            headers = gdal.GetFileMetadata(path, "HEADERS") or {}
        except RuntimeError:
            return ""
    told = {name.lower(): value for name, value in headers.items()}
    return f"{found and found.size} {found and found.mtime} {told.get('etag', '')}"
