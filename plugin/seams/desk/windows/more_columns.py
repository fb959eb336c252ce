"""Columns of the windows' table that are there when somebody used or chose them."""
from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from operator import attrgetter
from typing import TYPE_CHECKING, Any

from qgis.PyQt.QtCore import Qt

from ....toolkit.translation import filled, percent, shown_number, tr
from ...cause_words import cause_word
from ...tables.window_fields import MEASURED, PLACED, SAID, WindowField
from ...verdict_words import observer_word
from .windows_columns import ALIGNED_LEFT, OBSERVERS, TableColumn

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord

_RIGHT = int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)


def _percent(value: float) -> str:
    return f"{percent(value)} %"


def _metres(value: float) -> str:
    return filled(tr("{metres} m"), metres=shown_number(value, 2 if value < 10 else 0))


def _causes(words: str) -> str:
    return ", ".join(cause_word(word) for word in words.split("; ") if word)


_TEXTS: dict[str, Callable[[str], str]] = {"words": str, "causes": _causes}
_NUMBERS: dict[str, Callable[[float], str]] = {
    "number": shown_number, "tenths": partial(shown_number, decimals=1), "percent": _percent, "metres": _metres,
    "of 100": lambda value: f"{value} %", "whole": str,
    "px": lambda value: filled(tr("{length} px"), length=shown_number(value, 1)),
}  # fmt: skip


def _column(field: WindowField) -> TableColumn:
    name = field.read_as

    def read(row: WindowRecord) -> Any:
        return row.read(name)

    if field.shown == "observer":
        return TableColumn(
            field.name, field.heading, field.help, lambda row: observer_word(read(row)),
            lambda row: OBSERVERS.get(read(row)),
        )  # fmt: skip
    if field.shown in _TEXTS:
        words = _TEXTS[field.shown]
        return TableColumn(
            field.name, field.heading, field.help, lambda row: words(read(row) or ""),
            lambda row: words(read(row) or "").casefold() or None, ALIGNED_LEFT,
        )  # fmt: skip
    shown = _NUMBERS[field.shown]
    return TableColumn(
        name, field.heading, field.help, lambda row: "" if read(row) is None else shown(read(row)), read, _RIGHT
    )


JUDGING_COLUMNS = tuple(_column(one) for one in SAID if one.heading)
"""Shown as soon as one window has something there."""

_CHOSEN = (*sorted(MEASURED, key=lambda one: one.shown in _TEXTS), *PLACED)  # numbers first
CHOSEN_COLUMNS = tuple(_column(one) for one in _CHOSEN if one.heading)
"""Shown when the operator chooses them."""


def used_columns(rows: Iterable[WindowRecord]) -> frozenset[str]:
    """Which of the judging columns hold something."""
    names = [column.name for column in JUDGING_COLUMNS]
    said = set(map(attrgetter(*names), rows))
    return frozenset(name for values in said for name, value in zip(names, values) if value not in (None, ""))


def all_columns(standard: tuple[TableColumn, ...], used: frozenset[str]) -> tuple[TableColumn, ...]:
    """The standard ones, before their last one, the reasons, what is used, and after it what can be chosen."""
    judging = (column for column in JUDGING_COLUMNS if column.name in used)
    return *standard[:-1], *judging, standard[-1], *CHOSEN_COLUMNS
