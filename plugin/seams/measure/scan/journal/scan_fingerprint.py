"""What decides on the result of a scan, as a short text that changes with it."""
from __future__ import annotations

import dataclasses
import os
import re
from collections.abc import Iterable, Iterator, Sequence
from hashlib import blake2b
from pathlib import Path
from typing import Any
from xml.etree.ElementTree import ParseError, tostring

import numpy as np
from osgeo import gdal

from .....imagery.documents import xml_root
from .....imagery.errors import Message
from .....imagery.gdal_calls import gdal_silenced, vrt_parts
from .....imagery.rasters import RasterRef
from .....imagery.remote_files import forget_fetched, is_remote, readable_path
from ...source_images import Source
from .. import messages

MOST_ASKED = 20  # remote sources whose server is asked for size and date; more would take seconds before a scan starts
_BESIDE = ("", ".msk")
"""Endings of the files that say what a raster's pixels are: itself, its mask."""
_SAID = ".aux.xml"
"""Of the file that may say more of them, its nodata for instance."""
_OF_NO_CONSEQUENCE = "Metadata", "Histograms", "Description", "CategoryNames"
"""What QGIS writes there when it first shows a raster, such as statistics, changes no pixel."""
_MOST_SAID = 10_000_000  # bytes that are read
_PARTS = {
    "version": messages.SCAN_OF_ANOTHER_VERSION,
    "mosaic": messages.SCAN_OF_ANOTHER_MOSAIC,
    "sources": messages.SCAN_OF_OTHER_SOURCES,
    "settings": messages.SCAN_WITH_OTHER_SETTINGS,
    "seams": messages.SCAN_OF_OTHER_SEAMS,
}


def fingerprint_of(
    mosaic: RasterRef, sources: Sequence[Source], settings: Any, seams: Iterable[object] = ()
) -> str:
    """The same as long as the result of a scan would be: a digest of each of its inputs.

    Local files by path, size and time of change, those that a VRT or an archive is made of too; no source is opened.
    The remote mosaic, and up to ``MOST_ASKED`` remote sources, by what their server says of them; more by their names.
    ``settings``: a dataclass; ``seams``: arrays, dataclasses of them, texts, numbers or bytes.
    """
    asked = sum(is_remote(source.ref.path) for source in sources) <= MOST_ASKED
    parts = {
        "version": _digest([_version()]),
        "mosaic": _digest([mosaic.path, mosaic.wkt, *_states(mosaic.path, ask=True)]),
        "sources": _digest(
            item
            for source in sources
            for item in (source.ref.path, source.ref.wkt, source.extent, *_states(source.ref.path, asked))
        ),
        "settings": _digest([settings]),
        "seams": _digest(seams),
    }
    return " ".join(f"{name}={digest}" for name, digest in parts.items())


def what_changed(older: str, newer: str) -> Message:
    """The first part in which two fingerprints differ, in words."""
    was, is_now = (dict(part.partition("=")[::2] for part in text.split()) for text in (older, newer))
    if was.keys() == is_now.keys():
        for name, message in _PARTS.items():
            if was.get(name) != is_now.get(name):
                return message
    return messages.SCAN_OF_ANOTHER_KIND


def _digest(items: Iterable[object]) -> str:
    digest = blake2b(digest_size=12)
    for part in _flat(items):
        digest.update(f"{len(part)}:".encode())
        digest.update(part)
    return digest.hexdigest()


def _flat(item: object) -> Iterator[bytes]:
    """A value as bytes that don't depend on the process; the names of types are among them."""
    if isinstance(item, bytes):
        yield item
    elif isinstance(item, np.ndarray):
        yield f"{item.dtype.str} {item.shape}".encode()
        yield np.ascontiguousarray(item).tobytes()
    elif dataclasses.is_dataclass(item) and not isinstance(item, type):
        yield type(item).__name__.encode()
        for field in dataclasses.fields(item):
            yield field.name.encode()
            yield from _flat(getattr(item, field.name))
    elif isinstance(item, dict):
        yield from _flat(sorted(item.items()))
    elif isinstance(item, Iterable) and not isinstance(item, str):
        yield b"["
        for part in item:
            yield from _flat(part)
        yield b"]"
    else:
        yield repr(item).encode()


def _states(path: str, ask: bool) -> Iterator[str]:
    """What is known of a raster's files without opening it."""
    if is_remote(path):
        if ask:
            yield _remote_state(readable_path(path))
        return
    seen = {path}
    waiting = [path]
    while waiting:
        one = waiting.pop()
        file = _local_file(one)
        for ending in _BESIDE if file == one else ("",):
            state = _local_state(file + ending)
            if state:
                yield f"{os.path.abspath(file + ending)} {state}"
        if file == one and (said := _said_beside(file + _SAID)):
            yield said
        if one.lower().endswith(".vrt"):
            parts = [part for part in vrt_parts(one) if part not in seen]
            seen.update(parts)
            waiting += parts


def _said_beside(path: str) -> str:
    """What a file of auxiliary data says that may change how pixels are read; empty where there is no such thing."""
    try:
        if os.path.getsize(path) > _MOST_SAID:
            return _local_state(path)
        root = xml_root(Path(path).read_bytes())
    except OSError:
        return ""
    except ParseError:
        return _local_state(path)
    for parent in list(root.iter()):
        for child in [one for one in parent if one.tag in _OF_NO_CONSEQUENCE]:
            parent.remove(child)
    kept = [band for band in root if len(band) or (band.text or "").strip()]
    return "".join(re.sub(r"\s+", " ", tostring(one, "unicode")) for one in kept)


def _local_state(path: str) -> str:
    """Empty where there is no such file."""
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return ""
    return f"{found.st_size} {found.st_mtime_ns}"


def _remote_state(path: str) -> str:
    """Size, time of change and entity tag, as far as the server tells them now."""
    forget_fetched(path)
    with gdal_silenced():
        try:
            found = gdal.VSIStatL(path)
            headers = gdal.GetFileMetadata(path, "HEADERS") or {}
        except RuntimeError:
            return ""
    told = {name.lower(): value for name, value in headers.items()}
    return f"{found and found.size} {found and found.mtime} {told.get('etag', '')}"


def _local_file(path: str) -> str:
    """The file of this machine that a path is read from: of one inside an archive, the archive."""
    if os.path.exists(path):
        return path
    inside = re.sub(r"^(?:/vsi(?:zip|tar|gzip|7z|rar|sparse|cached)/)+", "", path).strip("{}")
    for place in (inside, *map(str, Path(inside).parents)):
        if os.path.isfile(place):
            return place
    named = [part.strip('"') for part in path.split(":")]  # a part of a file: DRIVER:"file":name
    return next((part for part in named if part and os.path.isfile(part)), path)


def _version() -> str:
    """The plugin's version; that of what measures is the package's, wherever it is installed."""
    metadata = Path(__file__).parents[4] / "metadata.txt"
    found = re.search(r"^version=(.*)$", metadata.read_text(encoding="utf-8"), re.M) if metadata.is_file() else None
    return found.group(1).strip() if found else ""
