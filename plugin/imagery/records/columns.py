"""Tables as columns: a column says its field, and how its value comes from a result. Layers and plain rows are made of
the same ones."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Callable, Generic, TypeVar

import numpy as np

from ..message import Message

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
        """Of the fields."""
        return [f"{self.name}_{level}" for level in range(1, levels + 1)] if self.by_level else [self.name]

    def values(self, result: Result, levels: int) -> Sequence[object]:
        """Of the fields."""
        found = self.value(result)
        listed = ([None] * levels if found is None else found) if self.by_level else [found]
        return [value.item() if isinstance(value, np.generic) else value for value in listed]  # fields take no numpy's


def rows_of(columns: Sequence[Column[Result]], results: Iterable[Result], levels: int = 0) -> Iterator[Row]:
    """Each result as a row, sentences in English."""
    names = [name for column in columns for name in column.names(levels)]
    for result in results:
        values = [value for column in columns for value in column.values(result, levels)]
        yield {name: str(value) if isinstance(value, Message) else value for name, value in zip(names, values)}
