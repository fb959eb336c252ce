"""Results as rows of tables, and as bytes and back: a file that somebody sent brings numbers and words, and no code.

- A ``Column`` says its field, and how its value comes from a result; layers and plain rows are made of the same ones.
- ``packed`` makes bytes of arrays by name: numpy's own archives take longer to open than a block takes to be put
  together.
- ``record_of`` makes bytes of frozen dataclasses, as JSON and arrays. What is read is only ever made into the classes
  that the given class's annotations name, and into sentences that are known. Floats come back to the last digit; arrays
  of float32, which are pictures, to a two-thousandth.
"""
from __future__ import annotations

import ast
import builtins
import dataclasses
import json
import math
import struct
import sys
import typing
import zlib
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from enum import Enum
from functools import cache
from types import ModuleType
from typing import Any, Callable, Generic, TypeVar

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


@contextmanager
def understanding() -> Iterator[None]:
    """Around the reading of a record: raises NotUnderstoodError whatever its bytes do."""
    try:
        yield
    except NotUnderstoodError:
        raise
    except Exception as error:
        raise NotUnderstoodError(f"{type(error).__name__}: {error}") from None


def packed(arrays: Mapping[str, np.ndarray], compressed: Collection[str] = ()) -> bytes:
    """Arrays of numbers one after the other, those named in ``compressed`` deflated."""
    parts, layout = [], []
    for name, array in arrays.items():
        held = np.ascontiguousarray(array).tobytes()
        if name in compressed:
            held = zlib.compress(held, _QUICK)
        layout.append((name, array.dtype.str, array.shape, len(held), name in compressed))
        parts.append(held)
    head = json.dumps(layout).encode()
    return b"".join([_LENGTH.pack(len(head)), head, *parts])


def unpacked(record: bytes, names: Collection[str] | None = None) -> dict[str, np.ndarray]:
    """What ``packed`` made bytes of, or of that ``names``; arrays can't be written to. Call it ``understanding``."""
    (length,) = _LENGTH.unpack_from(record)
    place, arrays, room = _LENGTH.size + length, {}, _MOST_BYTES
    for name, kind, shape, size, is_compressed in json_document(record[_LENGTH.size : place]):
        held, place = record[place : place + size], place + size
        if names is not None and name not in names:
            continue
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


def record_of(value: object) -> bytes:
    """A dataclass of numbers, words, enums, arrays, messages, and tuples, mappings and dataclasses of those."""
    arrays: dict[str, np.ndarray] = {}
    text = json.dumps(_plain(value, arrays), separators=(",", ":")).encode()
    held = {_JSON: np.frombuffer(text, np.uint8), **arrays}
    return packed(held, held)


def value_of(kind: type, record: bytes, sentences: Mapping[str, Message]) -> Any:
    """The instance of a dataclass; ``sentences`` are the known ones, by template. Raises NotUnderstoodError."""
    with understanding():
        arrays = unpacked(record)
        return _Reader(arrays, sentences).read(kind, json_document(arrays[_JSON].tobytes()))


@cache
def sentences_of(*modules: ModuleType) -> dict[str, Message]:
    """Sentences that a record may hold, by template."""
    values = (value for module in modules for value in vars(module).values())
    return {value.template: value for value in values if isinstance(value, Message)}


def _plain(value: Any, arrays: dict[str, np.ndarray]) -> Any:
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, np.generic):
        return value.item()
    if value is None or isinstance(value, (bool, int, float, str)):
        return value
    if isinstance(value, np.ndarray):
        name = str(len(arrays))
        arrays[name] = value.astype(np.float16) if value.dtype == np.float32 else value
        return name
    if isinstance(value, Message):
        words = {name: word if isinstance(word, _WORDS) else str(word) for name, word in value.values.items()}
        return dict(zip(_MESSAGE, (value.template, value.level.value, _plain(words, arrays))))
    if dataclasses.is_dataclass(value):
        return {field.name: _plain(getattr(value, field.name), arrays) for field in dataclasses.fields(value)}
    if isinstance(value, Mapping):
        return {_plain(key, arrays): _plain(item, arrays) for key, item in value.items()}
    if isinstance(value, (tuple, list)):
        return [_plain(item, arrays) for item in value]
    raise TypeError(f"no record of {type(value).__name__}")


@dataclasses.dataclass(frozen=True)
class _OneOf:
    """Not typing's Union, which remembers our classes and so keeps all of the plugin when it is unloaded."""

    kinds: tuple[Any, ...]


class _Reader:
    def __init__(self, arrays: Mapping[str, np.ndarray], sentences: Mapping[str, Message]) -> None:
        self._arrays, self._sentences = arrays, sentences

    def read(self, kind: Any, plain: Any) -> Any:
        """Raises NotUnderstoodError, or whatever the data is not fit for."""
        if isinstance(kind, _OneOf):
            for other in kind.kinds:
                with suppress(NotUnderstoodError, AttributeError, KeyError, TypeError, ValueError):
                    return self.read(other, plain)
            raise NotUnderstoodError(repr(plain)[:80])
        origin, inner = typing.get_origin(kind), typing.get_args(kind)
        if origin is tuple:
            kinds = inner[:1] * len(plain) if inner[-1] is ... else inner
            _checked(type(plain) is list and len(kinds) == len(plain), plain)
            return tuple(map(self.read, kinds, plain))
        if isinstance(origin, type) and issubclass(origin, Mapping):
            return {self.read(inner[0], key): self.read(inner[1], item) for key, item in plain.items()}
        return self._single(kind, plain)

    def _single(self, kind: Any, plain: Any) -> Any:
        if kind is type(None) or kind in (bool, int, str):
            return _checked(type(plain) is kind, plain)
        if kind is float:
            return float(_checked(type(plain) in (int, float), plain))
        if kind is np.ndarray:
            array = self._arrays[plain]
            return array.astype(np.float32) if array.dtype == np.float16 else array
        if kind is Message:
            return self._message(plain)
        if issubclass(kind, Enum):
            return kind(plain)
        if not dataclasses.is_dataclass(kind):
            raise NotUnderstoodError(str(kind))
        make: Any = kind
        kinds = _annotations(make)
        return make(**{name: self.read(kinds[name], item) for name, item in plain.items()})

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


def _checked(is_fit: bool, plain: Any) -> Any:
    if not is_fit:
        raise NotUnderstoodError(repr(plain)[:80])
    return plain


@cache
def _annotations(kind: type) -> dict[str, Any]:
    """The kinds of a class's fields. Python 3.9 does not know ``int | None`` of its own annotations."""
    names = {**vars(builtins), **vars(sys.modules[kind.__module__])}
    return {name: _kind(ast.parse(text, mode="eval").body, names) for name, text in kind.__annotations__.items()}


def _kind(node: ast.expr, names: Mapping[str, Any]) -> Any:
    if isinstance(node, ast.Name):
        return names[node.id]
    if isinstance(node, ast.Attribute):
        return getattr(_kind(node.value, names), node.attr)
    if isinstance(node, ast.Constant):
        return type(None) if node.value is None else node.value
    if isinstance(node, ast.BinOp):
        left = _kind(node.left, names)
        return _OneOf((*(left.kinds if isinstance(left, _OneOf) else (left,)), _kind(node.right, names)))
    if isinstance(node, ast.Tuple):
        return tuple(_kind(part, names) for part in node.elts)
    if isinstance(node, ast.Subscript):
        return _kind(node.value, names)[_kind(node.slice, names)]
    raise NotUnderstoodError(ast.dump(node))
