"""Sentences for the user, and the errors that a user can cause: each carries one of ``messages`` that says what to do.

Names that others gave go into sentences as words that can be shown.
"""
from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cache
from pathlib import PurePath
from string import Formatter

_UNPRINTABLE = re.compile(
    "[\0-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f"  # control characters
    "\u200b\u2060\ufeff"  # without width
    "\u202a-\u202e\u2066-\u2069"  # which turn the direction of what follows
    "\ud800-\udfff\ufffe\uffff]"  # no characters: bytes of a file's name that are no text
)
_FORMULA = re.compile(r"[=+@\t\r-](?![\s\d.,%]*$)")
_LONGEST = 300  # letters of a name in a sentence


def QT_TR_NOOP(text: str) -> str:  # noqa: N802
    """Stand-in for Qt's, which is not known here: marks a text that is translated where it is shown."""
    return text


def printable(text: str) -> str:
    """A text with a question mark in a box for each character that shows nothing or does something."""
    return _UNPRINTABLE.sub("\ufffd", text)


def in_sentence(text: str) -> str:
    """A text on one line, its middle left out where it is very long."""
    line = " ".join(printable(text).splitlines())
    return line if len(line) <= _LONGEST else f"{line[: _LONGEST // 2]} … {line[-_LONGEST // 2 :]}"


def cell_text(text: str) -> str:
    """A text for a cell of a spreadsheet, which would else calculate what begins as a formula does."""
    return f"'{text}" if _FORMULA.match(text) else text


def of_cell(text: str) -> str:
    """The text that was made such a cell."""
    return text[1:] if text.startswith("'") and _FORMULA.match(text, 1) else text


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
    """One sentence for the user, whose text ``str`` gives."""

    template: str
    """English text with ``{name}`` where a value goes."""
    level: Level = Level.ERROR
    """How grave it is."""
    values: Mapping[str, object] = field(default_factory=dict, hash=False)
    """What goes into the template: numbers, texts, other messages or a tuple of those."""

    def __call__(self, **values: object) -> Message:
        """This sentence with its values. Raises TypeError for one that lacks or that has no place in it."""
        if values.keys() != (wanted := placeholders(self.template)):
            raise TypeError(f"{self.template!r} takes {sorted(wanted)} and was given {sorted(values)}")
        return replace(self, values=values)

    def as_warning(self) -> Message:
        """This sentence where it is told and the work goes on, though an exception carries it elsewhere."""
        return replace(self, level=WARNING)

    def __str__(self) -> str:
        return self.worded(lambda template: template)

    def worded(self, translate: Callable[[str], str], fill: Callable[..., str] = str.format) -> str:
        """The sentence, its template and those of the messages in it sent through ``translate``, then ``fill``.

        A sentence at the end of another one leaves its full stop to that.
        """
        template, values = translate(self.template), {}
        for name, value in self.values.items():
            values[name] = words = _worded(value, translate, fill)
            if isinstance(value, Message) and isinstance(words, str) and f"{{{name}}}." in template:
                values[name] = words.removesuffix(".")
        return fill(template, **values)


class Stated(float):
    """A limit, for a message: written as stated, 2%, not 2.00%; a value over it so where fewer digits don't show it."""

    def __new__(cls, value: float, limit: float = math.inf) -> Stated:
        made = super().__new__(cls, value)
        made.limit = limit
        return made

    limit: float

    def __format__(self, spec: str) -> str:
        text, times = format(float(self), spec), 100 if spec.endswith("%") else 1
        is_shown = float(text.rstrip("%")) > self.limit * times
        return text if is_shown else f"{times * self:.6g}{'%' if times > 1 else ''}"


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


class SeamInspectorError(Exception):
    """Base of all errors that are shown to the user as they are."""

    def __init__(self, message: Message) -> None:
        super().__init__(message)
        self.message = message

    def __str__(self) -> str:
        return str(self.message)


class SeamInspectorWarning(UserWarning):
    """Something was left out or assumed, and the work goes on."""


class SettingsError(SeamInspectorError):
    """A setting is out of its range, or the inputs together make no job."""


class RasterError(SeamInspectorError):
    """A raster can't be opened, read or compared."""


class NotCoveredError(RasterError):
    """A raster holds too few valid pixels in a window."""


class WindowError(SeamInspectorError):
    """A window can't be measured on the mosaic's pixel grid."""


class SeamlineError(SeamInspectorError):
    """Seamlines from which no window can be placed."""


class SeamsElsewhereError(SeamlineError):
    """Seamlines none of which is a seam of the mosaic."""


class WindowLayerError(SeamInspectorError):
    """The window layer can't be made or edited."""


class BarLineError(SeamInspectorError):
    """A line across the bars of a target can't be measured."""


class PhotoError(SeamInspectorError):
    """A photo, its calibration or its marks from which no interior orientation can be had."""


class SensorModelError(SeamInspectorError):
    """A sensor model that can't be fitted, read or applied."""


class WorkersLostError(SeamInspectorError):
    """Nobody is left who could do the work; what is done is kept where it is kept at all."""


class CancelledError(SeamInspectorError):
    """The user stopped the work."""
