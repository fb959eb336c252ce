"""What a feature's attributes say, whatever the types of their fields: NULL, numbers as text, fields that are missing.

The decimal point is a point: CSV files and text fields know no locale.
"""
from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence

from qgis.core import NULL, QgsFeature

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
        found = value if type(value) is float else float(str(value))
    except ValueError:
        return None
    return found if math.isfinite(found) else None


def whole_number(value: object, largest: float = math.inf) -> int | None:
    """A whole number whose size is at most ``largest``."""
    found = number(value)
    if found is None or not found.is_integer() or abs(found) > largest:
        return None
    return value if type(value) is int else int(found)


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
    """Those of every feature of a table with fields of these names."""
    for row in rows:
        yield Attributes(row, dict(zip(names, row.attributes())))
