"""What a sentence for the user is made of."""
from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cache
from pathlib import PurePath
from string import Formatter

from .documents.printable import in_sentence


class Level(Enum):
    """How grave a message is where it stands alone; within another one that one's level counts."""

    INFO = "information"
    """A fact, the reason in a table, or a word that goes into a sentence."""
    WARNING = "warning"
    """Something was left out, assumed or is doubtful; the work goes on."""
    ERROR = "error"
    """It can't be done: what an exception carries, and most messages are."""


INFO, WARNING = Level.INFO, Level.WARNING


@dataclass(frozen=True)
class Message:
    """One sentence for the user."""

    template: str
    """English text with ``{name}`` where a value goes."""
    level: Level = Level.ERROR
    """How grave it is."""
    values: Mapping[str, object] = field(default_factory=dict, hash=False)
    """What goes into the template: numbers, texts, other messages or a tuple of those."""

    def __call__(self, **values: object) -> Message:
        """The same sentence with its values. Raises TypeError for one that lacks or that has no place in it."""
        if values.keys() != (wanted := placeholders(self.template)):
            raise TypeError(f"{self.template!r} takes {sorted(wanted)} and was given {sorted(values)}")
        return replace(self, values=values)

    def as_warning(self) -> Message:
        """The same sentence where it is told and the work goes on, though an exception carries it elsewhere."""
        return replace(self, level=WARNING)

    def __str__(self) -> str:
        return self.worded(lambda template: template)

    def worded(self, translate: Callable[[str], str], fill: Callable[..., str] = str.format) -> str:
        """The sentence, its template and those of the messages in it sent through ``translate``, then ``fill``."""
        values = {name: _worded(value, translate, fill) for name, value in self.values.items()}
        return fill(translate(self.template), **values)


class Exceeding(float):
    """A value over its limit, for a message: with as many more decimals as it takes to see that."""

    def __new__(cls, value: float, limit: float) -> Exceeding:
        made = super().__new__(cls, value)
        made._limit = limit
        return made

    _limit: float

    def __format__(self, spec: str) -> str:
        head, point, kind = spec.rpartition(".")
        if not point or not kind[:-1].isdigit() or kind[-1] not in "f%":
            return format(float(self), spec)
        for decimals in range(int(kind[:-1]), int(kind[:-1]) + _MORE_DECIMALS):
            text = format(float(self), f"{head}.{decimals}{kind[-1]}")
            if float(text.rstrip("%")) > self._limit * (100 if kind[-1] == "%" else 1):
                break
        return text


_MORE_DECIMALS = 5


@cache
def placeholders(template: str) -> frozenset[str]:
    """The names in a template."""
    return frozenset(name for _, name, _, _ in Formatter().parse(template) if name is not None)


def _worded(value: object, translate: Callable[[str], str], fill: Callable[..., str]) -> object:
    if isinstance(value, Message):
        return value.worded(translate, fill)
    if isinstance(value, tuple):
        return " ".join(str(_worded(part, translate, fill)) for part in value)
    return in_sentence(str(value)) if isinstance(value, (str, PurePath, Exception)) else value
