"""What is opened, by whom, with which drivers, and what is not: a path of others may lead to what never ends.

| who | opens | as |
|---|---|---|
| `open_raster` | mosaics, orthoimages, heights, photos, also those that VRTs name | `RASTERS`, checked |
| `seam_features` | seamlines and cells that the Python interface is given | `FEATURES`, checked |
| `file_identity` | inputs and what is to be replaced, to see which files they are | `ANYTHING`, checked |
| `open_raster`, `delivered_files` | parts and sheets, as one raster | GDAL's `BuildVRT`, checked before |
| here | tile indexes of a raster (GTI) | `FEATURES` |
| here | an image, alone, for what it names inside | the driver that knows it |
| `layers`, `point_tables`, `feature_sinks` | a file that QGIS has open, or that was just written | `FEATURES` |
| `geopackages` | a file of ours that is being written | `FEATURES` |
| `raster_writer`, `orthorectification`, `mended_mosaic` | what was read or written just before | `RASTERS` |
| `record_store` | `.unsaved`, `.results`, `.scan`, which nobody chose | Python, of files alone, up to a size |
| `window_layer` | `windows*.gpkg` beside a project, which nobody chose | SQLite, after `holds_only_tables` |
| `keeping` | the windows of a project that had no file, to move them | SQLite, as QGIS has them open |
| `outputs` | a database that is to be written, to see whether others write it | SQLite |
| `delivery_layers`, `mosaic_scans`, `swiped_layer`, `line_layers` | what the user chose, or was just written | QGIS |
| `inspection_record`, `file_identity` | the bytes of inputs, for fingerprints | Python, of files alone |
| `mark_tables` | the layers in a folder of marks | QGIS, after `is_layer_file` |
| `documents` | XML, JSON, rules, camera files | Python, after `is_endless`, up to a size |

Checked is by ``check_raster_path``. QGIS itself opens the layers of projects, and the vector inputs of algorithms once
``is_endless`` let their paths pass.
"""
from __future__ import annotations

import os
import re
import sqlite3
import stat
from collections.abc import Iterable, Iterator, Mapping
from contextlib import closing, suppress
from enum import Enum
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import unquote

from osgeo import gdal

from . import messages
from .errors import Message, RasterError
from .gdal_calls import gdal_settings, gdal_silenced

_HELD_BY_ITSELF = (
    "GTiff", "COG", "JPEG", "PNG", "GIF", "BIGGIF", "BMP", "WEBP", "JPEGXL", "HEIF", "PNM", "JP2OpenJPEG", "JP2ECW",
    "JP2KAK", "JP2MrSID", "JP2Lura", "ECW", "MrSID", "HFA", "ENVI", "EHdr", "NITF", "RMF", "RST", "KRO", "SGI", "TGA",
    "AAIGrid", "GRASSASCIIGrid", "GSAG", "GSBG", "GS7BG", "XYZ", "SRTMHGT", "DTED", "USGSDEM", "SAGA", "PCRaster",
    "BYN", "CTable2", "GTX", "ISG", "LOSLAS", "NGSGEOID", "NTv2", "GPKG", "MBTiles",
)  # fmt: skip
"""Formats of images, heights and geoids that name no other file, as ERS, MRF, DIMAP, HDF5 and services do."""
_MADE_OF_OTHERS = ("VRT", "GTI")
_TABLES = (
    "GPKG", "ESRI Shapefile", "GeoJSON", "GeoJSONSeq", "TopoJSON", "ESRIJSON", "FlatGeobuf", "CSV", "SQLite", "KML",
    "LIBKML", "GML", "GPX", "DXF", "DGN", "MapInfo File", "OpenFileGDB", "Parquet", "Arrow", "XLSX", "ODS",
)  # fmt: skip
"""Formats of features without VRTs and servers of databases."""


class Access(NamedTuple):
    """What is opened for one purpose."""

    kind: int
    """GDAL's flag."""
    drivers: tuple[str, ...]


RASTERS = Access(gdal.OF_RASTER, (*_HELD_BY_ITSELF, *_MADE_OF_OTHERS))
FEATURES = Access(gdal.OF_VECTOR, _TABLES)
ANYTHING = Access(0, (*RASTERS.drivers, *_TABLES, "OGR_VRT"))


def open_dataset(path: str, access: Access, flags: int = gdal.OF_READONLY) -> gdal.Dataset | None:
    """None for what can't be opened by the drivers that are allowed. GDAL says nothing."""
    drivers = _HELD_BY_ITSELF if access is RASTERS and _is_not_looked_at(path) else access.drivers
    with gdal_silenced():
        try:
            return gdal.OpenEx(readable_path(path), access.kind | flags, list(drivers))
        except RuntimeError:
            return None


# --- what has an end --------------------------------------------------------------------------------------------

_OF_THE_SYSTEM = ("/dev/", "/proc/", "/sys/")
_MEMORY = ("MEM:::", "DATAPOINTER", "/VSISTDIN")
"""In names of what GDAL takes for places in the process's memory, or for what is typed."""


def is_endless(path: str) -> bool:
    """Whether a path is no file with an end: a device, a pipe, a socket, memory, or a file that the system makes up;
    or lies in an archive that is one."""
    try:
        return _is_special(path, os.stat(path).st_mode)
    except (OSError, ValueError):
        return _looked_at(path).refused is _Refused.ENDLESS


def _is_special(path: str, mode: int) -> bool:
    if stat.S_ISDIR(mode):
        return False
    return not stat.S_ISREG(mode) or os.path.realpath(path).startswith(_OF_THE_SYSTEM)


# --- what leads elsewhere ---------------------------------------------------------------------------------------

_MOST_PARTS = 100_000  # of a VRT, and of those in it
_MOST_BYTES = 100_000_000  # of a VRT's text
_MOST_MARKS = 4_000_000  # < and = in it: what the time and memory of its reading go by
_MOST_COLONS = 8  # in a name, of which each part between two of them may be a file's
_MOST_READINGS = 300_000  # of files for one band, where VRTs name VRTs that name each file again and again
_MOST_DEPTH = 1000  # of VRTs in VRTs; GDAL itself gives up long before
_HEAD_BYTES = 1024  # by which GDAL's drivers know their files
_VRT = b"<VRTDataset"
_ROOTS = (_VRT, b"<OGRVRT", b"<PAMDataset", b"<GDALTileIndexDataset")
"""Documents that name files."""
_AUXILIARY = ".aux.xml"
_BESIDE = (_AUXILIARY, ".ovr", ".msk", ".aux")
"""After a raster's name: metadata, overviews and masks, which GDAL opens with any driver."""
_ADDRESS = re.compile(r"(?:https?|ftp)://", re.I)
_LOOKED_AT = re.compile(r"\.(vrt|gti(\.\w+)?)(?=$|\?)", re.I)
"""Names over the network of what may lead elsewhere: of nothing else the first bytes are fetched to find out."""
_INDEX = re.compile(r"\.gti(\.gpkg|\.fgb|\.parquet)?$", re.I)
_NETWORK = {"curl", "s3", "gs", "az", "adls", "oss", "swift", "hdfs", "webhdfs"}
_ARCHIVES = {"zip", "tar", "gzip", "7z", "rar"}
_PARTS_OF_FILES = {"GTIFF_DIR", "GTIFF_RAW", "NITF_IM", "GPKG"}
"""Before the name of a file of which a part is meant."""
_NAMING = ("FILE", "DATASET", "DATASOURCE", "DEMPATH")
"""In what elements, and keys of metadata, are called that name a file."""
_ELEMENT, _TEXT, _ATTRIBUTE = range(3)  # as GDAL's reader counts the nodes of XML


class _Refused(Enum):
    ENDLESS, SERVICE, TOO_MANY, DRIVER = range(4)


class _PathLook(NamedTuple):
    """What a path is, as long as it stays the same file."""

    refused: _Refused | None = None
    """Why it must not be opened."""
    parts: tuple[str, ...] = ()
    """What a VRT names, or a file of auxiliary data; none of what is neither."""
    bands: int = 1
    """Number of bands of a VRT, which names its parts once for each."""
    driver: str = ""
    """GDAL's, which is why or by which an image is read."""
    identity: tuple[int, ...] = ()
    beside: tuple[str, ...] = ()
    """What lies beside it in an archive, called like it."""


def _leads_out(path: str, name: str, part: str) -> Message:
    if vrt_parts(path):
        return messages.VRT_LEADS_OUT(name=name, path=part)
    return messages.LEADS_OUT(name=name, path=part)


def check_raster_path(path: str, name: str) -> None:
    """Raise RasterError for what GDAL must not open: no file with an end, memory, a service, or what leads to those.

    Each part is asked for what it is now; only what changed is looked at anew, as mosaics are opened for every window.
    """
    waiting: list[tuple[str, ...]] = [(path,)]
    seen, virtual, folders = set[str](), dict[str, _PathLook](), dict[str, _Folder]()
    waits = ""
    while waiting:
        for part in waiting.pop():
            if part in seen:
                continue
            seen.add(part)
            look = _looked_at(part)
            if look.refused is not None:
                raise RasterError(_refusal(look, name) if part == path else _leads_out(path, name, part))
            odd, beside = _beside(part, folders)
            waits = waits or odd
            inside = _named_inside(part, look.driver, *look.identity) if look.driver and not odd else ()
            if parts := (*look.parts, *beside, *look.beside, *inside):
                virtual[part] = look._replace(parts=parts)
                waiting.append(parts)
        if len(seen) > _MOST_PARTS:
            raise RasterError(messages.VRT_OF_TOO_MANY(name=name, most=_MOST_PARTS))
    if waits:
        raise RasterError(messages.NO_FILE_BESIDE(name=name, path=waits))
    if len(virtual) > 1 and _readings(path, virtual) > _MOST_READINGS:
        raise RasterError(messages.VRT_OF_TOO_MANY(name=name, most=_MOST_READINGS))


def _refusal(look: _PathLook, name: str) -> Message:
    if look.refused is _Refused.SERVICE:
        return messages.SERVICE(name=name)
    if look.refused is _Refused.DRIVER:
        return messages.DRIVER_NOT_USED(name=name, driver=look.driver)
    if look.refused is _Refused.TOO_MANY:
        return messages.VRT_OF_TOO_MANY(name=name, most=_MOST_PARTS)
    return messages.NO_FILE(name=name)


def _readings(path: str, virtual: Mapping[str, _PathLook]) -> float:
    """How many files the deepest of VRTs in VRTs has opened for one band, each as often as it is named."""
    counts, most = {path: 1.0}, 0.0
    for _ in range(_MOST_DEPTH):
        named: dict[str, float] = {}
        for one, count in counts.items():
            for part in virtual[one].parts if one in virtual else ():
                named[part] = named.get(part, 0.0) + count / virtual[one].bands
        most = max(most, sum(named.values()))
        counts = {one: count for one, count in named.items() if one in virtual}
        if not counts or most > _MOST_READINGS:
            break
    return most


def vrt_parts(path: str) -> tuple[str, ...]:
    """The files that a VRT or a tile index names, as far as it can be read; none of what is neither."""
    return _looked_at(path).parts


def begins_vrt(content: bytes) -> bool:
    """Whether GDAL takes a file that begins with this for a VRT, whatever it is called."""
    return _VRT in content[:_HEAD_BYTES].partition(b"\0")[0]


_REMOTE = re.compile(r"/vsi(?:curl|s3|gs|az|adls|oss|swift|hdfs|webhdfs)(?:_streaming)?[/?]|^(?:https?|ftp)://", re.I)


def is_remote(path: str) -> bool:
    """Whether a raster's path leads over the network, an archive there included."""
    return _REMOTE.search(path) is not None


def local_file(path: str) -> str:
    """The file of this machine that a path is read from: of one inside an archive, the archive."""
    if os.path.exists(path):
        return path
    bare = path.replace("{", "").replace("}", "")  # around an archive in an archive
    inside = re.sub(r"^(?:/?vsi(?:(?:zip|tar|gzip|7z|rar|sparse|cached)/|subfile/[\d_]+,))+", "", bare)
    for place in (inside, *map(str, Path(inside).parents)):
        if os.path.isfile(place):
            return place
    named = [part.strip('"') for part in path.split(":")]  # a part of a file: DRIVER:"file":name
    return next((part for part in named if part and os.path.isfile(part)), path)


def readable_path(path: str) -> str:
    """What GDAL reads in parts: of a plain address it would fetch the whole file first."""
    return f"/vsicurl/{path}" if _ADDRESS.match(path) else path


def is_layer_file(path: Path) -> bool:
    """Whether a file that nobody chose is a table of features with an end, and no view or VRT leads elsewhere."""
    if is_endless(str(path)):
        return False
    with gdal_silenced():
        try:
            driver = gdal.IdentifyDriverEx(str(path), gdal.OF_VECTOR)
        except RuntimeError:
            return False
    if driver is None or driver.ShortName not in FEATURES.drivers:
        return False
    return driver.ShortName not in ("GPKG", "SQLite") or holds_only_tables(path)


_OBJECTS = "SELECT type, rootpage, lower(sql) FROM sqlite_master"
_INDEXES = ("create virtual table", " using rtree")  # of a GeoPackage


def holds_only_tables(path: Path) -> bool:
    """Whether a database holds rows, and no view or table of a module's making: reading them has an end."""
    if not path.is_file() or is_endless(str(path)):
        return False
    try:
        with closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", 0.05, uri=True)) as database:
            return all(_is_of_rows(*row) for row in database.execute(_OBJECTS))
    except (OSError, sqlite3.Error):
        return False


def _is_of_rows(kind: str, page: int | None, sql: str | None) -> bool:
    if kind == "trigger":  # those of a GeoPackage go over no rows again and again
        return not re.search(r"\b(with|join)\b", sql or "")
    if kind == "table" and not page:
        return all(words in (sql or "") for words in _INDEXES)
    return kind in ("table", "index")


def _looked_at(path: str) -> _PathLook:
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return _look_by_name(path)
    return _look(path, path, found.st_mode, *_identity(found))


def _is_not_looked_at(path: str) -> bool:
    return is_remote(path) and _LOOKED_AT.search(path) is None


def _identity(found: os.stat_result) -> tuple[int, ...]:
    return found.st_dev, found.st_ino, found.st_size, found.st_mtime_ns, found.st_ctime_ns


def _look_by_name(path: str) -> _PathLook:
    """Look at what the system has no file of: a part of a file, a file in an archive or elsewhere, or a description."""
    if "<" in path and not path.startswith("/vsi"):
        return _inline(path)
    if any(word in path.upper() for word in _MEMORY):
        return _PathLook(_Refused.ENDLESS)
    if path.startswith("/vsi"):
        return _look_in_file_system(path)
    prefix, colon, rest = path.partition(":")
    if path.lstrip().startswith("{"):
        return _PathLook(_Refused.SERVICE)
    if not colon or len(prefix) == 1 or _ADDRESS.match(path):
        return _PathLook()
    if prefix.lower() == "vrt" and rest.startswith("//"):
        return _PathLook(None, (rest[2:].partition("?")[0],))
    if prefix.upper() == "GTI":
        return _PathLook(None, tuple(_indexed(rest)))
    if prefix not in _PARTS_OF_FILES or rest.count(":") > _MOST_COLONS:
        return _PathLook(_Refused.SERVICE)
    return _PathLook(None, tuple(_files_in(rest)))


def _files_in(text: str, folder: str = "") -> Iterator[str]:
    """The names between colons and quotes that are files, or may be some elsewhere."""
    words = text.split(":")
    for first in range(len(words)):
        for last in range(first + 1, len(words) + 1):
            name = os.path.join(folder, ":".join(words[first:last]).strip('"'))
            if os.path.lexists(name) or name.startswith("/vsi") or "<" in name:
                yield name


def _look_in_file_system(path: str) -> _PathLook:
    """Look at a path of GDAL's own file systems: archives, memory, the network."""
    rest = path
    while rest.startswith("/vsi"):
        handler, _, rest = rest[len("/vsi") :].partition("/")
        handler, _, query = handler.partition("?")
        handler = handler.replace("_streaming", "")
        if handler in _NETWORK:
            address = unquote(f"{query}/{rest}".partition("url=")[2]) if query else rest
            if handler == "curl" and not _ADDRESS.match(address):
                return _PathLook(_Refused.ENDLESS)  # which may be a file of this machine
            return _PathLook() if _is_not_looked_at(path) else _look(path, path, stat.S_IFREG)
        if handler == "mem":
            found = gdal.VSIStatL(path)
            return _look(path, path, stat.S_IFREG, found.size, found.mtime) if found is not None else _PathLook()
        if handler == "subfile":
            rest = rest.partition(",")[2]
        elif handler not in _ARCHIVES:
            return _PathLook(_Refused.ENDLESS)
        rest = rest.lstrip("{")  # around an archive in an archive
        rest = f"/{rest}" if rest.startswith("vsi") else rest
    file = rest.replace("{", "").replace("}", "")
    while file and not os.path.exists(file) and file != os.path.dirname(file):
        file = os.path.dirname(file)
    try:
        found = os.stat(file)
    except (OSError, ValueError):
        return _PathLook()
    return _look(path, file, found.st_mode, *_identity(found))


@lru_cache(_MOST_PARTS)
def _look(path: str, file: str, mode: int, *identity: int) -> _PathLook:
    """Look at a path read from a file: links may lead elsewhere by now, but then to one of another ``identity``."""
    if _is_special(file, mode):
        return _PathLook(_Refused.ENDLESS)
    if stat.S_ISDIR(mode):
        return _PathLook(_Refused.ENDLESS if path != file and _is_file_of_gdal(path) else None)
    with gdal_silenced():
        try:
            driver = gdal.IdentifyDriverEx(path, gdal.OF_RASTER)
            content = _document(path)
        except (RuntimeError, UnicodeError):
            return _PathLook()
    if driver is not None and driver.ShortName not in ANYTHING.drivers:
        return _PathLook(_Refused.DRIVER, driver=driver.ShortName)
    if len(content) > _MOST_BYTES or content.count(b"<") + content.count(b"=") > _MOST_MARKS:
        return _PathLook(_Refused.TOO_MANY)
    if _INDEX.search(path):
        return _PathLook(None, tuple(_indexed(path)))
    folder = os.path.dirname(path if path.startswith("/vsi") else os.path.abspath(path))
    if content:
        look = _named(content, folder)
    else:
        look = _PathLook(driver="" if driver is None else driver.ShortName, identity=identity)
    return look._replace(beside=_in_archive(path))


def _is_file_of_gdal(path: str) -> bool:
    """Whether GDAL has a file where the system has none that it could come from."""
    found = gdal.VSIStatL(path)
    return found is not None and not found.IsDirectory()


@lru_cache(_MOST_PARTS)
def _named_inside(path: str, driver: str, *identity: int) -> tuple[str, ...]:
    """What an image names without being a VRT: overviews in its metadata; the parts of an Erdas Imagine file."""
    alone = gdal_settings(GDAL_DISABLE_READDIR_ON_OPEN="EMPTY_DIR", GDAL_PAM_ENABLED="NO")
    with gdal_silenced(), alone:
        try:
            dataset = gdal.OpenEx(path, gdal.OF_RASTER, [driver])
            overviews = dataset.GetMetadataItem("OVERVIEW_FILE", "OVERVIEWS") or ""
            parts = dataset.GetFileList() or () if driver == "HFA" else ()
        except (AttributeError, RuntimeError):  # it can't be opened
            return ()
    named = _places(overviews, os.path.dirname(path), False) if overviews else ()
    return (*named, *(one for one in parts if one != path))


def _indexed(path: str) -> Iterator[str]:
    """The files that a tile index of a raster names."""
    dataset = open_dataset(path, FEATURES)
    layer = None if dataset is None else dataset.GetLayer(0)
    if layer is None or (column := layer.GetLayerDefn().GetFieldIndex("location")) < 0:
        return
    for row in layer:
        name = row.GetFieldAsString(column)
        yield name if is_remote(name) else os.path.join(os.path.dirname(path), name)


def _document(path: str) -> bytes:
    """The content of a file that may name others; empty for any other."""
    file = gdal.VSIFOpenL(path, "rb")
    if file is None:
        return b""
    try:
        head = gdal.VSIFReadL(1, _HEAD_BYTES, file) or b""
        if not path.endswith(_AUXILIARY) and not any(root in head for root in _ROOTS):
            return b""
        return bytes(head) + bytes(gdal.VSIFReadL(1, _MOST_BYTES, file) or b"")
    finally:
        gdal.VSIFCloseL(file)


@lru_cache(100)
def _inline(text: str) -> _PathLook:
    if "<VRTDataset" not in text:
        return _PathLook(_Refused.SERVICE)
    return _named(text.encode(errors="surrogateescape"), "")


def _named(content: bytes, folder: str) -> _PathLook:
    """What a document of GDAL's names, found by GDAL's own reader."""
    with gdal_silenced():
        try:
            root = gdal.ParseXMLString(_readable(content.partition(b"\0")[0]))
        except RuntimeError:
            root = None
    names, bands, waiting = list[str](), 0, [root] if root else []
    while waiting:
        kind, tag, *inner = waiting.pop()
        if kind != _ELEMENT:
            continue
        waiting += reversed(inner)
        bands += tag == "VRTRasterBand"
        said = {str(one[1]).lower(): _text(one) for one in inner if one[0] == _ATTRIBUTE}
        called = " ".join((str(tag), said.get("key", ""), said.get("name", ""))).upper()
        if any(word in called for word in _NAMING):
            is_relative = _is_true(said.get("relativetovrt", ""))
            texts = (form for one in inner if one[0] == _TEXT for form in _as_written(str(one[1])))
            names += (name for text in texts for name in _places(text, folder, is_relative))
    return _PathLook(None, tuple(names), max(bands, 1))


_STAND_IN, _LONE = 0xF700, 0xDC00  # added to a byte: a character of nobody's, and Python's for a byte that is none


def _readable(content: bytes) -> str:
    """A text that GDAL takes from Python, whatever bytes there are: those that are no UTF-8 have stand-ins."""
    text = content.decode(errors="surrogateescape")
    return re.sub("[\udc80-\udcff]", lambda lone: chr(ord(lone[0]) - _LONE + _STAND_IN), text)


def _as_written(text: str) -> Iterable[str]:
    """A name of the document, and where it may hold stand-ins also with the bytes for which they stand."""
    return dict.fromkeys((text, re.sub("[\uf780-\uf7ff]", lambda held: chr(ord(held[0]) - _STAND_IN + _LONE), text)))


_BASE = ":::BASE:::"  # before names that are relative to the file they stand beside


def _places(text: str, folder: str, is_relative: bool) -> Iterator[str]:
    if text.startswith(_BASE):
        text, is_relative = text[len(_BASE) :], True
    if not is_relative or text.count(":") > _MOST_COLONS:
        yield text
        return
    joined = os.path.join(folder, text)
    yield joined if joined.startswith("/vsi") else os.path.normpath(joined)  # else // before an archive's place is lost
    if ":" in text or "<" in text:
        yield from _files_in(text, folder)


def _text(attribute: list[Any]) -> str:
    return str(attribute[2][1]) if len(attribute) > 2 else ""


def _is_true(text: str) -> bool:
    """Whether a text is true as C's atoi and GDAL take it."""
    return re.match(r"\s*[+-]?0*[1-9]|\s*(yes|true|on)\b", text, re.I) is not None


# --- what lies beside -------------------------------------------------------------------------------------------


class _Folder(NamedTuple):
    """What of a folder GDAL may open when it reads a raster in it."""

    odd: str = ""
    """A name of what is neither a file nor a folder: GDAL looks for metadata by many names."""
    called_like: Mapping[str, tuple[str, ...]] = {}
    """Names by that of the raster, in small letters, beside which they lie."""


def _beside(path: str, folders: dict[str, _Folder]) -> tuple[str, tuple[str, ...]]:
    """What has no end in a raster's folder, empty where nothing is, and what lies there called like the raster."""
    folder, name = os.path.split(path)
    if folder not in folders:
        folders[folder] = _Folder()
        with suppress(OSError, ValueError):
            folders[folder] = _folder(folder, *_identity(os.stat(folder or ".")))
    there = folders[folder]
    beside = there.called_like.get(name.lower(), ())
    return there.odd and os.path.join(folder, there.odd), tuple(os.path.join(folder, one) for one in beside)


@lru_cache(1000)
def _folder(folder: str, *identity: int) -> _Folder:
    with os.scandir(folder or ".") as entries:
        found = list(entries)
    odd = (one.name for one in found if not (one.is_file() or one.is_dir()) and _waits(one.path))
    return _Folder(next(odd, ""), _called_like(one.name for one in found if one.is_file()))


def _waits(path: str) -> bool:
    """Whether opening what is no file may wait for ever, as a socket and a link that leads nowhere can't be opened."""
    try:
        return not stat.S_ISSOCK(os.stat(path).st_mode)
    except OSError:
        return False


def _called_like(names: Iterable[str]) -> dict[str, tuple[str, ...]]:
    found: dict[str, tuple[str, ...]] = {}
    for name in names:
        for ending in _BESIDE:
            if name.lower().endswith(ending):
                like = name.lower()[: -len(ending)]
                found[like] = (*found.get(like, ()), name)
    return found


def _in_archive(path: str) -> tuple[str, ...]:
    """What lies beside a raster in an archive or in memory, called like it."""
    if not path.startswith("/vsi") or is_remote(path):
        return ()
    folder, name = os.path.split(path)
    beside = _called_like(gdal.ReadDir(folder) or ()).get(name.lower(), ())
    return tuple(f"{folder}/{one}" for one in beside)
