"""Fields, rows and attribute values of layers.

What a feature's attributes say, whatever the types of their fields: NULL, numbers as text, fields that are missing. The
decimal point is a point: CSV files and text fields know no locale. And columns of tables as fields and rows.
"""
from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from qgis.core import NULL, QgsFeature, QgsFields, QgsGeometry

from ..imagery.errors import Message
from .translation import sentence
from .version_differences import field

if TYPE_CHECKING:
    from ..imagery.records import Column, Result  # with numpy, which is not loaded when QGIS starts

LARGEST_WHOLE = 2**31 - 1  # the largest that a field of whole numbers holds, and Qt's int
_NO = ("0", "0.0", "false", "no", "off", "f", "n", "")


def is_known(value: object) -> bool:
    """Whether there is a value at all."""
    return isinstance(value, (str, int, float)) or (value is not None and value != NULL)


def text(value: object) -> str:
    """A word, name or sentence, empty where there is none; 1 and 1.0 are the same."""
    if isinstance(value, float):
        return f"{value:.15g}" if abs(value) < 1e15 else str(value)
    return str(value).strip() if is_known(value) else ""


def number(value: object) -> float | None:
    """A finite number."""
    if not isinstance(value, (str, int, float)):  # NULL, as most values of a layer that is not inspected yet
        return None
    try:
        finite = value if type(value) is float else float(str(value))
    except ValueError:
        return None
    return finite if math.isfinite(finite) else None


def whole_number(value: object, largest: float = math.inf) -> int | None:
    """A whole number whose size is at most ``largest``."""
    finite = number(value)
    if finite is None or not finite.is_integer() or abs(finite) > largest:
        return None
    return value if type(value) is int else int(finite)


def is_true(value: object) -> bool:
    """A yes or a no; every value that is known and says nothing else is a yes."""
    return text(value).lower() not in _NO


class Attributes:
    """The attributes of one feature by name; a field that is missing holds nothing."""

    def __init__(self, feature: QgsFeature, values: dict[str, object]) -> None:
        self.feature = feature
        self._values = values

    def __getitem__(self, name: str) -> object:
        return self._values.get(name)


def attributes(rows: Iterable[QgsFeature], names: Sequence[str]) -> Iterator[Attributes]:
    """The attributes of every feature of a table with fields of these names."""
    for row in rows:
        yield Attributes(row, dict(zip(names, row.attributes())))


def column_fields(columns: Iterable[Column[Result]], levels: int = 0) -> QgsFields:
    return table_fields(*((name, column.kind) for column in columns for name in column.names(levels)))


def column_values(columns: Iterable[Column[Result]], result: Result, levels: int = 0) -> list[object]:
    """The values of a result in these columns, field by field; sentences in the user's language."""
    values = (value for column in columns for value in column.values(result, levels))
    return [sentence(value) if isinstance(value, Message) else value for value in values]


def column_features(
    columns: Sequence[Column[Result]], results: Iterable[Result], levels: int = 0
) -> Iterator[QgsFeature]:
    fields = column_fields(columns, levels)
    for result in results:
        yield feature(fields, column_values(columns, result, levels))


def feature(fields: QgsFields, values: list[object], geometry: QgsGeometry | None = None) -> QgsFeature:
    """A feature with all of its attributes."""
    row = QgsFeature(fields)
    row.setAttributes(values)
    if geometry is not None:
        row.setGeometry(geometry)
    return row


def table_fields(*columns: tuple[str, str]) -> QgsFields:
    """Fields of these names and kinds (``integer``, ``real`` or ``text``)."""
    fields = QgsFields()
    for name, kind in columns:
        fields.append(field(name, kind))
    return fields
