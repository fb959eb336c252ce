"""Files that data are in, whatever they are called: relative, through links, in other letters, in an archive, as a
part of a file, or named by a VRT.

The one guard of what is written: over no input, over nothing that belongs to one, and over no other output. And the
state of what is read, by which a file is known again elsewhere, and seen to have changed or to be another one.
"""
from __future__ import annotations

import errno
import json
import os
import re
import stat
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from hashlib import blake2b
from itertools import chain
from pathlib import Path
from typing import NamedTuple, Union

from osgeo import gdal

from . import messages
from .atomic_files import UnfinishedFile, files_written
from .documents import json_document
from .errors import SettingsError
from .gdal_calls import gdal_settings, gdal_silenced
from .gdal_paths import ANYTHING, begins_vrt, is_remote, local_file, open_dataset, remote_state, vrt_parts, with_parts

_DATABASES = (".gpkg", ".sqlite")  # files that a table can be added to
_WRITTEN_BESIDE = {  # of formats that are several files, by the ending of the first
    ".shp": (".shx", ".dbf", ".prj", ".cpg"),
    ".tab": (".dat", ".map", ".id", ".ind"),
    ".mif": (".mid",),
    **dict.fromkeys((".bil", ".bip", ".bsq"), (".hdr",)),
}

_Identity = Union[tuple[int, int], str]


class DataPlace(NamedTuple):
    """A place of data."""

    path: str
    table: str = ""
    """In a database; empty for the whole file."""


def refuse_overwriting(outputs: Mapping[str, str], inputs: Iterable[str]) -> None:
    """Raise SettingsError for an output, paths by what they are called, that is no file, one of the inputs, which GDAL
    opens, or another output."""
    for title, path in outputs.items():
        if not path.startswith("/vsimem/"):  # where the desk lays what it shows; nobody chooses it for an output
            check_is_file(title, path)
    check_outputs(((title, DataPlace(path)) for title, path in outputs.items()), map(DataPlace, inputs))


def check_is_file(title: str, path: str) -> None:
    """Raise SettingsError for a place in an archive, in memory or on a server: most of GDAL's are left half-made."""
    if "\0" in path or path.startswith("/vsi"):
        raise SettingsError(messages.OUTPUT_NAMES_NO_FILE(output=title, path=path))


def check_can_be_written(title: str, path: str) -> None:
    """Raise SettingsError where no file can be, which is looked at before anything is measured."""
    check_is_file(title, path)
    if not path.strip():
        raise SettingsError(messages.OUTPUT_NAMES_NO_FILE(output=title, path="''"))
    with files_written(path):
        number = errno.EISDIR if path.endswith(("/", os.sep)) else 0
        with suppress(FileNotFoundError):
            mode = os.stat(path).st_mode
            number = errno.EISDIR if stat.S_ISDIR(mode) else 0 if stat.S_ISREG(mode) else errno.EPERM
        if number:
            raise OSError(number, os.strerror(number))
        UnfinishedFile(Path(path)).drop()


def check_outputs(
    outputs: Iterable[tuple[str, DataPlace]], inputs: Iterable[DataPlace], indexed: Iterable[str] = ()
) -> None:
    """Raise SettingsError for outputs, each with what it is called, that are one file, or an input's or its sidecar.

    ``indexed``: further inputs, which may be too many to open all.
    """
    by_file: dict[_Identity, list[tuple[str, DataPlace]]] = defaultdict(list)
    for title, place in outputs:
        stem, ending = os.path.splitext(place.path)
        files = [place.path, *(stem + other for other in _WRITTEN_BESIDE.get(ending.lower(), ()))]
        files += [os.path.join(os.path.dirname(place.path), name) for name in files_beside(place.path)]
        written = [(title, DataPlace(file, place.table)) for file in dict.fromkeys(files)]
        for _, file in written:
            for first, _ in _same_data(by_file, file):
                raise SettingsError(messages.OUTPUTS_ARE_ONE(path=place.path, first=first, second=title))
        for entry in written:
            by_file[_identity(entry[1].path)].append(entry)
    if not any(os.path.exists(file.path) or file.path.startswith("/vsi") for (_, file), *_ in by_file.values()):
        return  # what is not there yet is no input: most runs need no look at them
    read = chain(*(_read_with(place, True) for place in inputs), *(_read_with(DataPlace(path)) for path in indexed))
    for place in read:
        for title, file in _same_data(by_file, place):
            raise SettingsError(messages.OUTPUT_IS_INPUT(output=title, path=file.path))


def is_database(path: str) -> bool:
    """Whether other tables may lie in the same file."""
    return path.lower().endswith(_DATABASES)


def files_beside(path: str) -> set[str]:
    """Names of the files that GDAL takes for a raster's own and that are called like it, which go when it does."""
    name = os.path.basename(path)
    called = {name + ending for ending in (".aux.xml", ".msk", ".ovr")}
    with gdal_silenced(), suppress(RuntimeError):  # one that can't be read any more
        dataset = open_dataset(path) if os.path.isfile(path) and not is_database(path) else None
        if dataset is not None and dataset.GetDriver().ShortName != "VRT":  # whose files are its sources
            names = {os.path.basename(file) for file in _files_of(dataset)} - {name}
            called |= {other for other in names if other.startswith(os.path.splitext(name)[0])}
    return called


def _same_data(
    by_file: Mapping[_Identity, list[tuple[str, DataPlace]]], place: DataPlace
) -> Iterator[tuple[str, DataPlace]]:
    """The outputs in the same file; another table of a database is no matter."""
    for title, file in by_file.get(_identity(place.path), ()):
        if not (file.table and place.table) or file.table.lower() == place.table.lower():
            yield title, file


def _read_with(given: DataPlace, is_opened: bool = False) -> Iterator[DataPlace]:
    """An input's file, the files that a virtual one or a folder is made of, and what GDAL reads with them: with a VRT,
    and with others where they are to be opened."""
    for part in with_parts(given.path):
        if is_remote(part):
            continue
        file = local_file(part)
        if os.path.isdir(file):  # of which every file is read
            yield from (DataPlace(os.path.join(file, name)) for name in os.listdir(file))
            continue
        table = part.rpartition(":")[2] if file != part and is_database(file) else given.table
        yield from (DataPlace(part, table), DataPlace(file, table))
        # Other tables of a database may be written.
        if not is_database(part) and ((is_opened and part == given.path) or vrt_parts(part)):
            files = _files_of(open_dataset(part, ANYTHING))
            yield from (DataPlace(beside) for beside in files if not is_database(beside))


def _files_of(dataset: gdal.Dataset | None) -> list[str]:
    return [] if dataset is None else dataset.GetFileList() or []


def _identity(path: str) -> _Identity:
    """One key for all names of a file: relative, through links, in other letters where the system takes them so."""
    try:
        status = os.stat(path)
    except (OSError, ValueError):
        return path if path.startswith("/vsi") else os.path.normcase(os.path.realpath(path))
    return status.st_dev, status.st_ino


_MASK = ".msk"
_NOT_PIXELS = (".aux.xml", ".aux", ".ovr", ".rrd", ".stx")
"""Files of a raster that programs write when they show it: statistics and overviews."""
_MOST_WHOLE = 64_000_000  # bytes of a file of which each is looked at
_STRETCH_BYTES, _LOOK_BYTES = 1 << 17, 1 << 12
"""A larger file has one look in each stretch: it may change with its size and time kept."""
_LOOK_STEP = 78_479  # from a look's place in its stretch to the next's: no rows and tiles keep pace with that
_MOST_PARSED = 20_000_000  # bytes of a VRT
_NO_CONSEQUENCE = re.compile(
    rb"<(Metadata|Histograms|Description|CategoryNames|SourceProperties)\b(?:[^>]*/>|.*?</\1>)", re.S
)
"""What QGIS writes, or leaves out, when it first shows a raster, such as statistics, changes no pixel."""
_FOLDERS = re.compile(rb"<(SourceFilename|SourceDataset)\b[^>]*>(?:[^<]*[\\/])?")


class FileState(NamedTuple):
    """A file at some time."""

    size: int
    """Bytes."""
    time_ns: int
    """Time of its last change; 0 of a VRT, into which GDAL writes statistics, and of what a server has."""
    digest: str
    """Digest of all its bytes, of a large file of some all over it; of a VRT of all it says but the folders of its
    files.
    Empty where it is no plain file."""

    @property
    def content(self) -> tuple[int, str]:
        """Size and digest, equal for a copy."""
        return self.size, self.digest

    @property
    def is_vrt(self) -> bool:
        """Whether it is a VRT, whatever it is called."""
        return self.size > 0 and not self.time_ns


def local_states(paths: Iterable[str]) -> dict[str, FileState]:
    """States of the files of this machine that rasters are read from, by their whole paths: all that GDAL counts to
    them but statistics and overviews, and those that a VRT or an archive is made of. What is not there is left out."""
    files: dict[str, None] = {}
    with gdal_settings(GDAL_DISABLE_READDIR_ON_OPEN="TRUE"):  # a folder of thousands is not listed for each of them
        for part in (part for path in paths for part in with_parts(path) if not is_remote(part)):
            file, beside = local_file(part), [part + _MASK]
            if os.path.exists(file) and not vrt_parts(part):
                beside += map(local_file, _files_of(open_dataset(part)))
            beside = [name for name in beside if not name.lower().endswith(_NOT_PIXELS)]
            files.update(dict.fromkeys(map(os.path.abspath, (file, *beside))))
    with ThreadPoolExecutor(os.cpu_count()) as pool:  # digests are made while Python waits
        return {file: state for file, state in zip(files, pool.map(local_state, files)) if state is not None}


def known_states(paths: Collection[str], ask: bool = True) -> dict[str, FileState]:
    """``local_states``, and of remote rasters what their server says of them where it is to be asked. What nothing is
    known of has an empty digest."""
    remote, local = ([path for path in paths if is_remote(path) is there] for there in (True, False))
    states = local_states(local)
    states.update((path, FileState(0, 0, remote_state(path) if ask else "")) for path in remote)
    unknown = (path for path in local if os.path.abspath(local_file(path)) not in states and not vrt_parts(path))
    return {**states, **dict.fromkeys(unknown, FileState(0, 0, ""))}


def content_of(path: str) -> str:
    """Key of a raster, equal for a copy elsewhere: a digest of what its files hold, or the address of a remote one."""
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


def local_state(path: str) -> FileState | None:
    """None where there is no such file."""
    try:
        status = os.stat(path)
        if not stat.S_ISREG(status.st_mode):
            return FileState(status.st_size, status.st_mtime_ns, "")
        with open(path, "rb", buffering=0) as file:
            if status.st_size <= _MOST_PARSED and begins_vrt(file.read(_LOOK_BYTES)):
                named = _FOLDERS.sub(rb"<\1>", _NO_CONSEQUENCE.sub(b"", Path(path).read_bytes()))
                said = b"".join(named.split())  # of its pixels, wherever its files lie
                return FileState(len(said), 0, blake2b(said, digest_size=12).hexdigest())
            digest = blake2b(digest_size=12)
            for place, count in _looks(status.st_size):
                file.seek(place)
                digest.update(file.read(count))
    except (OSError, ValueError):
        return None
    return FileState(status.st_size, status.st_mtime_ns or 1, digest.hexdigest())


def _looks(size: int) -> Iterator[tuple[int, int]]:
    """Places in a file that are looked at, and how many bytes there."""
    if size <= _MOST_WHOLE:
        yield from ((start, _STRETCH_BYTES) for start in range(0, size, _STRETCH_BYTES))
        return
    for number, start in enumerate(range(0, size, _STRETCH_BYTES)):
        yield start + number * _LOOK_STEP % (_STRETCH_BYTES - _LOOK_BYTES), _LOOK_BYTES
    yield size - _LOOK_BYTES, _LOOK_BYTES
