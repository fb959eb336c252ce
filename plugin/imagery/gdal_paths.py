"""What GDAL may open, with which drivers, and which files the path of a raster leads to.

What users choose is looked at by ``check_raster_path`` and opened by ``open_dataset``: mosaics and orthoimages as
``RASTERS``, seamlines and tables as ``FEATURES``, both as ``ANYTHING`` where it is only asked which files they are. XML
and JSON are read by ``documents``. What a VRT leads to, GDAL opens with all of its drivers, as QGIS does.

What is read over the network, by GDAL's own file systems, is asked for again where that fails, and the cause is named.
"""
from __future__ import annotations

import os
import re
import sqlite3
import stat
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from functools import lru_cache
from html import unescape
from itertools import combinations
from pathlib import Path
from typing import Callable, TypeVar

from osgeo import gdal

from . import messages
from .errors import Message, RasterError
from .gdal_calls import gdal_heard, gdal_settings, gdal_silenced, vsi_bytes

_IMAGES = (
    "GTiff", "COG", "JPEG", "PNG", "GIF", "BIGGIF", "BMP", "WEBP", "JPEGXL", "HEIF", "PNM", "JP2OpenJPEG", "JP2ECW",
    "JP2KAK", "JP2MrSID", "JP2Lura", "ECW", "MrSID", "HFA", "ENVI", "EHdr", "NITF", "RMF", "RST", "KRO", "SGI", "TGA",
    "AAIGrid", "GRASSASCIIGrid", "GSAG", "GSBG", "GS7BG", "XYZ", "SRTMHGT", "DTED", "USGSDEM", "SAGA", "PCRaster",
    "BYN", "CTable2", "GTX", "ISG", "LOSLAS", "NGSGEOID", "NTv2", "netCDF", "GPKG", "MBTiles", "Rasterlite", "VRT",
)  # fmt: skip
"""Formats of images, heights and geoids. But for VRT they name no other file, as ERS, MRF, GTI and KMZ do."""
_TABLES = (
    "GPKG", "ESRI Shapefile", "GeoJSON", "GeoJSONSeq", "TopoJSON", "ESRIJSON", "FlatGeobuf", "CSV", "SQLite", "KML",
    "LIBKML", "GML", "GPX", "DXF", "DGN", "MapInfo File", "OpenFileGDB", "Parquet", "Arrow", "XLSX", "ODS",
)  # fmt: skip
"""Formats of features without VRTs and servers of databases."""


RASTERS, FEATURES, ANYTHING = gdal.OF_RASTER, gdal.OF_VECTOR, 0
"""GDAL's flags for what is opened."""
_DRIVERS = {RASTERS: _IMAGES, FEATURES: _TABLES, ANYTHING: (*_IMAGES, *_TABLES, "OGR_VRT")}


def open_dataset(path: str, kind: int = RASTERS, flags: int = gdal.OF_READONLY) -> gdal.Dataset | None:
    """None for what has no end, and what can't be opened by the drivers that are allowed. GDAL says nothing."""
    if not is_endless(path):
        with gdal_silenced(), suppress(RuntimeError):
            return gdal.OpenEx(readable_path(path), kind | flags, list(_DRIVERS[kind]))
    return None


def check_raster_path(path: str, name: str) -> None:
    """Raise RasterError for a path that is no file with an end, or that only drivers would open that are not used."""
    if is_endless(path):
        raise RasterError(messages.NO_FILE(name=name))
    driver = "" if is_remote(path) else _driver(path, gdal.OF_RASTER)
    if driver and driver not in _DRIVERS[ANYTHING]:
        raise RasterError(messages.DRIVER_NOT_USED(name=name, driver=driver))


def _driver(path: str, kind: int) -> str:
    """The first of GDAL's drivers that takes a path for its own; empty where none does."""
    driver = None
    with gdal_silenced(), suppress(RuntimeError):
        driver = gdal.IdentifyDriverEx(path, kind)
    return "" if driver is None else str(driver.ShortName)


def is_endless(path: str) -> bool:
    """Whether a path is no file with an end: a device, a pipe, a socket, what is typed, or what the system makes up."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return path.startswith("/vsistdin")
    if stat.S_ISREG(status.st_mode):
        return status.st_size == 0 and os.path.realpath(path).startswith("/proc/")
    return not stat.S_ISDIR(status.st_mode)


def is_layer_file(path: Path) -> bool:
    """Whether a file that nobody chose is a table of features, and no view or VRT leads elsewhere."""
    driver = _driver(str(path), gdal.OF_VECTOR)
    return driver in _TABLES and (driver not in ("GPKG", "SQLite") or holds_only_tables(path))


_NOT_ROWS = """
    SELECT 1 FROM sqlite_master
    WHERE type = 'view' OR type = 'table' AND rootpage = 0 AND sql NOT LIKE '% using rtree%'
"""
"""What calculates its rows. An R-tree is the spatial index of a GeoPackage."""


def holds_only_tables(path: Path) -> bool:
    """Whether a database that nobody chose holds rows, and no view or table of a module: reading it has an end."""
    if not path.is_file():
        return False
    try:
        with closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", timeout=0.05, uri=True)) as database:
            return database.execute(_NOT_ROWS).fetchone() is None
    except (OSError, sqlite3.Error):
        return False


# --- where a path leads -----------------------------------------------------------------------------------------

_REMOTE = re.compile(r"/vsi(?:curl|s3|gs|az|adls|oss|swift|hdfs|webhdfs)(?:_streaming)?[/?]|^(?:https?|ftp)://", re.I)
_PACKED = re.compile(r"^(?:/?vsi(?:(?:zip|tar|gzip|7z|rar|sparse|cached)/|subfile/[\d_]+,))+")
_MOST_WORDS = 9  # between colons in a name: each stretch of them may be a file's
_HEAD_BYTES = 1024  # by which GDAL's drivers know their files
_VRT = b"<VRTDataset"
_NAMES_OTHERS = (_VRT, b"<OGRVRT")
_ELEMENT = re.compile(rb"<([^<>]+)>\s*([^<\s][^<]*)")
_NAMING = re.compile(rb"FILE|DATASET|DATASOURCE|DEMPATH", re.I)
"""In the names of elements that hold a file's, and in the keys of metadata."""
_RELATIVE = re.compile(rb"""relativetovrt\s*=\s*["'](?!0["'])""", re.I)


def is_remote(path: str) -> bool:
    """Whether a raster's path leads over the network, an archive there included; the text of a VRT does not itself."""
    return "<" not in path and _REMOTE.search(path) is not None


def readable_path(path: str) -> str:
    """What GDAL reads in parts: of a plain address it would fetch the whole file first."""
    return f"/vsicurl/{path}" if re.match(r"(?:https?|ftp)://", path, re.I) else path


def is_there(path: str) -> bool:
    """Whether a path leads to anything: to a file, whatever is in it, or over the network, where nobody is asked."""
    if path.startswith("/vsi") and not is_remote(path):
        with gdal_silenced():
            return gdal.VSIStatL(path) is not None
    return "<" in path or is_remote(path) or os.path.exists(local_file(path))


def path_from(folder: str, name: str) -> str:
    """What a name in an index leads to: one of a file starts at the index's folder, unless it is a whole path."""
    place = os.path.normpath(os.path.join(folder, name))
    is_whole = os.path.isabs(name) or (":" in name and not os.path.exists(place))  # D:\a.tif, GPKG:a.gpkg:table
    return name if is_whole or not folder else place


def local_file(path: str) -> str:
    """The file of this machine that a path is read from: of one inside an archive the archive, of a part of a file
    (GTIFF_DIR:1:a.tif) that file."""
    if os.path.exists(path):
        return path
    inside = _PACKED.sub("", path.replace("{", "").replace("}", ""))  # around an archive in an archive
    places = (inside, *map(str, Path(inside).parents), *_between_colons(path))
    return next(filter(os.path.isfile, places), path)


def _between_colons(name: str) -> Iterator[str]:
    """What may be the file's name where a part of a file is named: GTIFF_DIR:1:a.tif, GPKG:"a.gpkg":table."""
    words = name.split(":")[:_MOST_WORDS]
    return (":".join(words[first:last]).strip('"') for first, last in combinations(range(len(words) + 1), 2))


def begins_vrt(content: bytes) -> bool:
    """Whether GDAL takes a file that begins with this for a VRT, whatever it is called."""
    return _VRT in content[:_HEAD_BYTES].partition(b"\0")[0]


def with_parts(path: str) -> Iterator[str]:
    """A raster or layer and what it is made of where it is a VRT, parts of parts too, each once."""
    parts, known = [path], {path}
    for part in parts:  # which grows meanwhile
        yield part
        named = [other for other in dict.fromkeys(vrt_parts(part)) if other not in known]
        known.update(named)
        parts += named


def vrt_parts(path: str) -> tuple[str, ...]:
    """The files that a VRT names; none of what is none, or lies on a server."""
    if path.lstrip().startswith("<"):
        return tuple(_named(os.fsencode(path), ""))
    if is_remote(path):
        return ()
    if path.startswith("vrt://"):
        return (path[len("vrt://") :].partition("?")[0],)
    stamp = file_stamp(local_file(path))
    if stamp is None:
        return _read_names.__wrapped__(path, ()) if path.startswith("/vsimem/") else ()
    return _read_names(path, stamp)


Stamp = tuple[int, ...]
"""File number, size and times of the last changes of a file."""


def file_stamp(path: str) -> Stamp | None:
    """Stamp of the file as it is by now; None for what is no file of this machine."""
    with suppress(OSError, ValueError):
        status = os.stat(path)
        if stat.S_ISREG(status.st_mode):
            return status.st_ino, status.st_size, status.st_mtime_ns, status.st_ctime_ns
    return None


@lru_cache(100_000)
def _read_names(path: str, stamp: Stamp) -> tuple[str, ...]:
    """What the file at a path names, looked at anew once it is another one: windows open ten thousand files each."""
    with gdal_silenced(), suppress(RuntimeError):
        head = vsi_bytes(path, _HEAD_BYTES)
        if any(root in head.partition(b"\0")[0] for root in _NAMES_OTHERS):
            return tuple(_named(vsi_bytes(path), os.path.dirname(path)))
    return ()


def _named(document: bytes, folder: str) -> Iterator[str]:
    """The files that a document of GDAL's names, whatever GDAL makes of the rest of it."""
    for tag, text in _ELEMENT.findall(document.replace(b"<![CDATA[", b"").replace(b"]]>", b"")):
        if not _NAMING.search(tag):
            continue
        name = unescape(os.fsdecode(text))
        if not _RELATIVE.search(tag):
            yield name
            continue
        yield os.path.join(folder, name)
        yield from filter(os.path.isfile, (os.path.join(folder, part) for part in _between_colons(name)))


# --- over the network -------------------------------------------------------------------------------------------

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


def remote_parts(path: str) -> tuple[str, ...]:
    """What of a raster is read over the network: itself, or what VRTs on this machine name."""
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


failures: dict[str, tuple[float, Message]] = {}
"""Until when a path is not asked for again, and why."""


def with_retries(path: str, name: str, read: Callable[[bool], Result]) -> Result:
    """What ``read`` gives of a raster at once, or in a second attempt: told so, it is to open the raster anew.

    Raises RasterError with the cause, or what ``read`` raises about a raster that came whole. What failed is
    remembered for a while, by all threads, and fails at once; of a VRT not, since others of its parts may be there.
    """
    known = failures.get(path)
    if known is not None and time.monotonic() < known[0]:
        raise RasterError(known[1])
    with suppress(RasterError), remote_settings():
        return read(False)
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
            with remote_settings():
                return read(True)
        except RasterError as error:
            failure = error.message
    if is_remote(path):
        failures[path] = time.monotonic() + REMEMBERED_S, failure
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
