"""Results as rows of tables, and as bytes and back: a file that somebody sent brings numbers and words, and no code.

- A ``Column`` says its field, and how its value comes from a result; layers and plain rows are made of the same ones.
- ``packed`` makes bytes of arrays by name: numpy's own archives take longer to open than a block takes to be put
  together.
- ``record_of`` makes bytes of frozen dataclasses, as JSON and arrays. What is read is only ever made into the classes
  that the given class's annotations name, and into sentences that are known. Floats come back to the last digit; arrays
  of float32, which are pictures, to a two-thousandth.
- ``RecordFiles`` keeps records in a folder, a file each: there whole or not at all, whatever ends the process that
  writes them. Whoever sees the folder reads and writes them, be it a thread or another machine. As a ``RecordFolder``
  one process at a time has it, which knows what its records are of.
"""
from __future__ import annotations

import ast
import dataclasses
import errno
import json
import math
import os
import shutil
import stat
import struct
import sys
import typing
import zlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import ExitStack, suppress
from dataclasses import dataclass
from enum import Enum
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any, BinaryIO, Callable, Generic, TypeVar
from uuid import uuid4

import numpy as np

from . import messages
from .documents import json_document
from .errors import Level, Message, SettingsError

Result = TypeVar("Result")

Row = dict[str, Any]
"""Numbers, texts and None by the names of their fields."""


@dataclass(frozen=True)
class Column(Generic[Result]):
    """A column of a table of results."""

    name: str
    kind: str
    """``integer``, ``real`` or ``text``."""
    value: Callable[[Result], Any]
    """What a result has there, None where it has nothing; a ``Message`` for a sentence."""
    by_level: bool = False
    """Whether there are columns ``name_1``..``name_R``; the value is then that of all levels, in their order."""

    def names(self, levels: int) -> list[str]:
        """Names of the fields."""
        return [f"{self.name}_{level}" for level in range(1, levels + 1)] if self.by_level else [self.name]

    def values(self, result: Result, levels: int) -> Sequence[object]:
        """Values of the fields."""
        value = self.value(result)
        listed = ([None] * levels if value is None else value) if self.by_level else [value]
        return [value.item() if isinstance(value, np.generic) else value for value in listed]  # fields take no numpy's


def kinds_of(columns: Sequence[Column[Any]], levels: int = 0) -> dict[str, str]:
    """Kinds of all fields of a table by their names."""
    return {name: column.kind for column in columns for name in column.names(levels)}


def rows_of(columns: Sequence[Column[Result]], results: Iterable[Result], levels: int = 0) -> Iterator[Row]:
    """Each result as a row, sentences in English."""
    names = kinds_of(columns, levels)
    for result in results:
        values = [value for column in columns for value in column.values(result, levels)]
        yield {name: str(value) if isinstance(value, Message) else value for name, value in zip(names, values)}


_DTYPES = {"integer": "int64", "real": "float64", "text": "object"}
GEOMETRY = "geometry"
"""In plain rows, where a layer has lines: the line as WKT."""


class TableRows(list[Row]):
    """Rows of a table; frames of pandas and geopandas, where these are installed."""

    def __init__(self, rows: Iterable[Row] = (), wkt: str = "", kinds: Mapping[str, str] | None = None) -> None:
        """``wkt``: the reference system of the rows' lines; empty where they have none. ``kinds``: of the fields."""
        super().__init__(rows)
        self.wkt, self.kinds = wkt, kinds or {}

    def to_dataframe(self) -> Any:
        """The table as a ``pandas.DataFrame``."""
        import pandas

        frame = pandas.DataFrame(self, columns=None if self else [*self.kinds])
        # Also without any number in it, so that frames of many results have one type together.
        return frame.astype({name: _DTYPES[kind] for name, kind in self.kinds.items() if kind == "real" or not self})

    def to_geodataframe(self) -> Any:
        """The table as a ``geopandas.GeoDataFrame``, its lines as geometries. Raises SettingsError without lines."""
        if GEOMETRY not in (self[0] if self else self.kinds):
            raise SettingsError(messages.TABLE_WITHOUT_LINES())
        import geopandas

        frame = self.to_dataframe()
        lines = geopandas.GeoSeries.from_wkt(frame[GEOMETRY]) if len(frame) else []
        return geopandas.GeoDataFrame(frame, geometry=lines, crs=self.wkt or None)


_LENGTH = struct.Struct("<I")
_QUICK = 1  # of zlib: what is worth it are runs
_MOST_BYTES = 2**29  # of all arrays of a record; the largest of ours is a tenth of it


class NotUnderstoodError(Exception):
    """A record of another version, or by somebody else."""


def packed(arrays: Mapping[str, np.ndarray]) -> bytes:
    """Arrays of numbers one after the other, deflated but for floats of full precision, which hardly get shorter."""
    parts, layout = [], []
    for name, array in arrays.items():
        held, is_compressed = np.ascontiguousarray(array).tobytes(), array.dtype.kind != "f" or array.itemsize == 2
        if is_compressed:
            held = zlib.compress(held, _QUICK)
        layout.append((name, array.dtype.str, array.shape, len(held), is_compressed))
        parts.append(held)
    head = json.dumps(layout).encode()
    return b"".join([_LENGTH.pack(len(head)), head, *parts])


def unpacked(record: bytes) -> dict[str, np.ndarray]:
    """What ``packed`` made bytes of; arrays can't be written to. Raises whatever other bytes lead to."""
    (length,) = _LENGTH.unpack_from(record)
    place, arrays, room = _LENGTH.size + length, {}, _MOST_BYTES
    for name, kind, shape, size, is_compressed in json_document(record[_LENGTH.size : place]):
        held, place = record[place : place + size], place + size
        whole = math.prod(shape) * np.dtype(kind).itemsize
        room -= max(whole, size)
        if room < 0:
            raise NotUnderstoodError(f"{name}: {shape}")
        if is_compressed:
            held = zlib.decompressobj().decompress(held, max(whole, 1))
        arrays[name] = np.frombuffer(held, kind).reshape(shape)
    return arrays


_JSON = "json"
_MESSAGE = ("template", "level", "values")
_WORDS = (type(None), bool, int, float, str, tuple, Message, np.generic)
"""What goes into a sentence; paths and errors as they are shown."""


def record_of(value: object, exact: bool = False) -> bytes:
    """A dataclass of numbers, words, enums, arrays, messages, and tuples, mappings and dataclasses of those; ``exact``:
    arrays of float32 to the last digit."""
    arrays: dict[str, np.ndarray] = {}

    def plain(value: Any) -> Any:
        if isinstance(value, Enum):
            return value.value
        if isinstance(value, np.generic):
            return value.item()
        if isinstance(value, np.ndarray):
            name = str(len(arrays))
            arrays[name] = value.astype(np.float16) if value.dtype == np.float32 and not exact else value
            return name
        if isinstance(value, Message):
            words = {name: word if isinstance(word, _WORDS) else str(word) for name, word in value.values.items()}
            return dict(zip(_MESSAGE, (value.template, value.level.value, words)))
        if dataclasses.is_dataclass(value):
            return {field.name: getattr(value, field.name) for field in dataclasses.fields(value)}
        if isinstance(value, Mapping):
            return dict(value)
        raise TypeError(f"no record of {type(value).__name__}")

    text = json.dumps(value, default=plain, separators=(",", ":")).encode()
    return packed({_JSON: np.frombuffer(text, np.uint8), **arrays})


def value_of(kind: type, record: bytes, sentences: Mapping[str, Message]) -> Any:
    """The instance of a dataclass; ``sentences`` are the known ones, by template. Raises NotUnderstoodError."""
    try:
        arrays = unpacked(record)
        return _Reader(arrays, sentences).read(kind, json_document(arrays[_JSON].tobytes()))
    except NotUnderstoodError:
        raise
    except Exception as error:  # whatever its bytes do
        raise NotUnderstoodError(f"{type(error).__name__}: {error}") from None


@cache
def sentences_of(*modules: ModuleType) -> dict[str, Message]:
    """Sentences that a record may hold, by template."""
    values = (value for module in modules for value in vars(module).values())
    return {value.template: value for value in values if isinstance(value, Message)}


class _Reader:
    def __init__(self, arrays: Mapping[str, np.ndarray], sentences: Mapping[str, Message]) -> None:
        self._arrays, self._sentences = arrays, sentences

    def read(self, kind: Any, plain: Any) -> Any:
        """Raises NotUnderstoodError, or whatever the data is not fit for."""
        origin, inner = typing.get_origin(kind), typing.get_args(kind)
        if isinstance(kind, list):
            for other in kind:
                with suppress(NotUnderstoodError, AttributeError, KeyError, TypeError, ValueError):
                    return self.read(other, plain)
        elif origin is tuple:
            kinds = inner[:1] * len(plain) if inner[-1] is ... else inner
            if type(plain) is list and len(kinds) == len(plain):
                return tuple(map(self.read, kinds, plain))
        elif isinstance(origin, type) and issubclass(origin, Mapping):
            keys = map(int, plain) if inner[0] is int else plain  # which JSON makes words of
            return {self.read(inner[0], key): self.read(inner[1], item) for key, item in zip(keys, plain.values())}
        else:
            return self._single(kind, plain)
        raise NotUnderstoodError(repr(plain)[:80])

    def _single(self, kind: Any, plain: Any) -> Any:
        if kind in (type(None), bool, int, float, str):
            if type(plain) is kind or (kind is float and type(plain) is int):
                return plain if kind is not float else float(plain)
        elif kind is np.ndarray:
            array = self._arrays[plain]
            return array.astype(np.float32) if array.dtype == np.float16 else array
        elif kind is Message:
            return self._message(plain)
        elif issubclass(kind, Enum):
            return kind(plain)
        elif dataclasses.is_dataclass(kind):
            make: Any = kind
            kinds = _annotations(make)
            return make(**{name: self.read(kinds[name], item) for name, item in plain.items()})
        raise NotUnderstoodError(repr(plain)[:80])

    def _message(self, plain: Any) -> Message:
        template, level, values = (plain[name] for name in _MESSAGE)
        sentence = dataclasses.replace(self._sentences[template], level=Level(level))
        words = {name: self._in_sentence(word) for name, word in values.items()}
        message = sentence(**words) if words else sentence
        str(message)  # values of another kind than it takes
        return message

    def _in_sentence(self, plain: Any) -> Any:
        if isinstance(plain, dict):
            return self._message(plain)
        return tuple(map(self._in_sentence, plain)) if isinstance(plain, list) else plain


@cache
def _annotations(kind: type) -> dict[str, Any]:
    """The kinds of a class's fields. Python 3.9 does not know ``int | None`` of its own annotations."""
    names: dict[str, Any] = {}
    for base in reversed(kind.__mro__):  # object brings what is built in
        names.update(vars(sys.modules[base.__module__]))
    return {
        field.name: _kind(ast.parse(str(field.type), mode="eval").body, names) for field in dataclasses.fields(kind)
    }


def _kind(node: ast.expr, names: Mapping[str, Any]) -> Any:
    if isinstance(node, ast.Name):
        return names[node.id]
    if isinstance(node, ast.Attribute):
        return getattr(_kind(node.value, names), node.attr)
    if isinstance(node, ast.Constant):
        return type(None) if node.value is None else node.value
    if isinstance(node, ast.BinOp):  # typing's Union remembers our classes: all of the plugin when it is unloaded
        return [_kind(node.left, names), _kind(node.right, names)]
    if isinstance(node, ast.Tuple):
        return tuple(_kind(part, names) for part in node.elts)
    if isinstance(node, ast.Subscript):
        return _kind(node.value, names)[_kind(node.slice, names)]
    raise NotUnderstoodError(ast.dump(node))


# --- in folders -------------------------------------------------------------------------------------------------

if sys.platform == "win32":
    import msvcrt

    def _lock(file: BinaryIO) -> None:
        """Raises PermissionError where another process has it."""
        msvcrt.locking(file.fileno(), msvcrt.LK_NBLCK, 1)
else:
    import fcntl

    def _lock(file: BinaryIO) -> None:
        """Raises BlockingIOError where another process has it."""
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)


_CHECKSUM_BYTES = 4
_MOST_KEPT_BYTES = 2**30  # of a record; the largest of ours is a twentieth of it
_ABOUT, _LOCK, _UNFINISHED = ".about", ".lock", ".unfinished-"
"""Names of what is no record, which begin with a dot: what the records are of, the lock, unfinished files."""


@dataclass(frozen=True)
class RecordFiles:
    """Payloads by name. Names are words and numbers of ours; links, pipes and folders by these names are no records."""

    folder: Path

    @property
    def names(self) -> set[str]:
        """Names of all there is: nothing where the folder is not, as its disk may be gone. Whoever saves is told."""
        with suppress(OSError), os.scandir(self.folder) as entries:
            files = [entry.name for entry in entries if entry.is_file(follow_symlinks=False)]
            return {name for name in files if not name.startswith(".")}
        return set()

    def save(self, name: str, payload: bytes, is_synced: bool = False) -> None:
        """Keep a payload in the place of an earlier one; it outlives the process, and if ``is_synced`` the power.

        Raises OSError: FileNotFoundError where nobody sees the folder from here, as without the shared disk.
        """
        unfinished = self.folder / f"{_UNFINISHED}{uuid4().hex}"
        try:
            with open(unfinished, "xb") as file:
                file.write(payload)
                file.write(zlib.crc32(payload).to_bytes(_CHECKSUM_BYTES, "little"))
                if is_synced:
                    file.flush()
                    os.fsync(file.fileno())
            os.replace(unfinished, self.folder / name)
        except OSError:
            with suppress(OSError):
                unfinished.unlink()
            raise

    def load(self, name: str) -> bytes | None:
        """The payload, None where there is none. Raises OSError where it can't be read, or the disk damaged it."""
        path = self.folder / name
        try:
            status = path.lstat()
        except FileNotFoundError:
            return None
        held = path.read_bytes() if stat.S_ISREG(status.st_mode) and status.st_size <= _MOST_KEPT_BYTES else b""
        payload, checksum = held[:-_CHECKSUM_BYTES], held[-_CHECKSUM_BYTES:]
        if zlib.crc32(payload).to_bytes(_CHECKSUM_BYTES, "little") != checksum:
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        return payload

    def forget(self, name: str) -> None:
        """There is none of that name any more. Raises OSError."""
        (self.folder / name).unlink(missing_ok=True)


class RecordFolder:
    """Records of one thing, for this process alone; the lock ends with it. Made when it is not there."""

    is_shared = True
    """Whether all who are to write records see the folder."""

    def __init__(self, folder: Path, kind: str, of: str = "") -> None:
        """``kind``: what such folders are for; ``of``: what the records are of, in one line. Records of something else
        are deleted, and what one is that was not written whole.

        Raises OSError where nothing can be written, SettingsError where another process has the folder, or something
        else is there, which is left as it is.
        """
        self.files = RecordFiles(folder)
        self.was_of: str | None = None
        """What the records there were of."""
        self._lock = _locked(folder)
        with ExitStack() as stack:
            stack.callback(self.close)
            about = self.files.load(_ABOUT)
            if about is not None:
                was_kind, _, self.was_of = about.decode(errors="replace").partition("\n")
                if was_kind != kind:
                    raise SettingsError(messages.RECORDS_FOREIGN())
            for unfinished in folder.glob(f"{_UNFINISHED}*"):
                unfinished.unlink()
            if self.was_of != of:
                for name in self.files.names:
                    self.files.forget(name)
                self.files.save(_ABOUT, f"{kind}\n{of}".encode(), is_synced=True)
            stack.pop_all()

    def close(self) -> None:
        """Let go of the folder, which stays."""
        self._lock.close()

    def remove(self) -> None:
        """Delete all of it, records first: if the process dies meanwhile, what is left is still known as ours."""
        for name in self.files.names:
            with suppress(OSError):
                self.files.forget(name)
        if os.name == "nt":  # where no open file can be deleted
            self.close()
        shutil.rmtree(self.files.folder, ignore_errors=True)
        self.close()
        with suppress(OSError):  # on a disk of the network, where the lock took room in it until now
            self.files.folder.rmdir()


def _locked(folder: Path) -> BinaryIO:
    """The lock in a folder, which is made when it is not there. Raises OSError, SettingsError."""
    while True:
        with suppress(FileExistsError):
            folder.mkdir()
        if folder.is_symlink() or not folder.is_dir():
            raise SettingsError(messages.RECORDS_FOREIGN())
        names = os.listdir(folder)
        if _ABOUT not in names and not all(name.startswith((_LOCK, _UNFINISHED)) for name in names):
            raise SettingsError(messages.RECORDS_FOREIGN())
        flags = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0)  # a link in a folder of somebody else
        with ExitStack() as stack:
            file = stack.enter_context(os.fdopen(os.open(folder / _LOCK, flags, 0o666), "r+b", buffering=0))
            try:
                _lock(file)
            except (BlockingIOError, PermissionError):
                raise SettingsError(messages.RECORDS_IN_USE()) from None
            with suppress(FileNotFoundError):  # another process removed it between our opening and our lock
                if os.path.samestat(os.fstat(file.fileno()), os.stat(folder / _LOCK)):
                    stack.pop_all()
                    return file
