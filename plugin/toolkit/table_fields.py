"""Tables as rows of columns: a column says its field, and how its value comes from a result."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Callable, Generic, TypeVar

import numpy as np
from qgis.core import QgsFeature, QgsFields, QgsGeometry

from .version_differences import field

Result = TypeVar("Result")


@dataclass(frozen=True)
class Column(Generic[Result]):
    """A column of a table of results."""

    name: str
    kind: str
    """``integer``, ``real`` or ``text``."""
    value: Callable[[Result], Any]
    """What a result has there, None where it has nothing."""
    by_level: bool = False
    """Whether there are columns ``name_1``..``name_R``; the value is then that of all levels, in their order."""

    def names(self, levels: int) -> list[str]:
        """Of the fields."""
        return [f"{self.name}_{level}" for level in range(1, levels + 1)] if self.by_level else [self.name]

    def values(self, result: Result, levels: int) -> Sequence[object]:
        """Of the fields."""
        found = self.value(result)
        listed = ([None] * levels if found is None else found) if self.by_level else [found]
        return [value.item() if isinstance(value, np.generic) else value for value in listed]  # fields take no numpy's


def column_fields(columns: Iterable[Column[Result]], levels: int = 0) -> QgsFields:
    """The fields of these columns."""
    return table_fields(*((name, column.kind) for column in columns for name in column.names(levels)))


def column_values(columns: Iterable[Column[Result]], result: Result, levels: int = 0) -> list[object]:
    """What a result has in these columns, field by field."""
    return [value for column in columns for value in column.values(result, levels)]


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
