"""Columns of a table of results as the fields and rows of a layer."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from qgis.core import QgsFeature, QgsFields, QgsGeometry

from ..imagery.errors import Message
from ..imagery.records import Column, Result
from .translation import sentence
from .version_differences import field


def column_fields(columns: Iterable[Column[Result]], levels: int = 0) -> QgsFields:
    """The fields of these columns."""
    return table_fields(*((name, column.kind) for column in columns for name in column.names(levels)))


def column_values(columns: Iterable[Column[Result]], result: Result, levels: int = 0) -> list[object]:
    """What a result has in these columns, field by field; sentences in the user's language."""
    values = (value for column in columns for value in column.values(result, levels))
    return [sentence(value) if isinstance(value, Message) else value for value in values]


def column_features(
    columns: Sequence[Column[Result]], results: Iterable[Result], levels: int = 0
) -> Iterator[QgsFeature]:
    """The rows of results."""
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
