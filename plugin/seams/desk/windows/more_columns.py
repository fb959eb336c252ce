"""Columns of the windows' table that are there when somebody used or chose them."""
from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from operator import attrgetter
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP, Qt

from ....toolkit.translation import filled, percent, shown_number, tr
from ...cause_words import cause_word
from ...verdict_words import observer_word
from .windows_columns import ALIGNED_LEFT, TableColumn

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord

_RIGHT = int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
_OBSERVERS = {"visible": 0, "invisible": 1, "unsure": 2}


def _words(name: str, heading: str, explanation: str, word: Callable[[str], str] = str) -> TableColumn:
    read = attrgetter(name)
    return TableColumn(
        name, heading, explanation, lambda row: word(read(row)), lambda row: word(read(row)).casefold() or None,
        ALIGNED_LEFT,
    )  # fmt: skip


def _number(name: str, heading: str, explanation: str, shown: Callable[[float], str] = shown_number) -> TableColumn:
    read = attrgetter(name)
    return TableColumn(
        name, heading, explanation, lambda row: "" if read(row) is None else shown(read(row)), read, _RIGHT
    )


def _percent(value: float) -> str:
    return f"{percent(value)} %"


def _metres(value: float) -> str:
    return filled(tr("{metres} m"), metres=shown_number(value, 2 if value < 10 else 0))


def _causes(words: str) -> str:
    return ", ".join(cause_word(word) for word in words.split("; ") if word)


JUDGING_COLUMNS = (
    TableColumn(
        "observer_2", QT_TRANSLATE_NOOP("@default", "observer 2"),
        QT_TRANSLATE_NOOP("@default", "What the second operator saw at 2x magnification."),
        lambda row: observer_word(row.observer_2), lambda row: _OBSERVERS.get(row.observer_2),
    ),
    _number(
        "confidence", QT_TRANSLATE_NOOP("@default", "sure"),
        QT_TRANSLATE_NOOP("@default", "How sure the observer is, 0 to 100 %."), lambda value: f"{value} %",
    ),
    _number(
        "confidence_2", QT_TRANSLATE_NOOP("@default", "sure 2"),
        QT_TRANSLATE_NOOP("@default", "How sure the second operator is, 0 to 100 %."), lambda value: f"{value} %",
    ),
    _words(
        "remark", QT_TRANSLATE_NOOP("@default", "remark"), QT_TRANSLATE_NOOP("@default", "The observer's remark.")
    ),
    _words(
        "remark_2", QT_TRANSLATE_NOOP("@default", "remark 2"),
        QT_TRANSLATE_NOOP("@default", "The second operator's remark."),
    ),
)  # fmt: skip
"""Shown as soon as one window has something there."""

CHOSEN_COLUMNS = (
    _number(
        "kept_low", QT_TRANSLATE_NOOP("@default", "kept from"),
        QT_TRANSLATE_NOOP("@default", "Lower end of the 95 % interval of what is kept along the seam."), _percent,
    ),
    _number(
        "kept_high", QT_TRANSLATE_NOOP("@default", "kept to"),
        QT_TRANSLATE_NOOP("@default", "Upper end of the 95 % interval of what is kept along the seam."), _percent,
    ),
    _number(
        "band_width", QT_TRANSLATE_NOOP("@default", "band width"),
        QT_TRANSLATE_NOOP("@default", "Width of the band along the seam in which detail was lost."), _metres,
    ),
    _number(
        "feather_width", QT_TRANSLATE_NOOP("@default", "feather width"),
        QT_TRANSLATE_NOOP(
            "@default",
            "Width of the feather, by where the mixture of the two images goes from 10 to 90 %; 0 for a hard cut."
        ),
        _metres,
    ),
    _number(
        "visibility", QT_TRANSLATE_NOOP("@default", "visibility"),
        QT_TRANSLATE_NOOP(
            "@default",
            "How many times more was lost along the seam than an eye just sees side by side at 2x (just noticeable "
            "differences, JND)."
        ),
        partial(shown_number, decimals=1),
    ),
    _number(
        "misfit", QT_TRANSLATE_NOOP("@default", "misfit"),
        QT_TRANSLATE_NOOP("@default", "How far apart the two images lie where they meet, as the mosaic has them."),
        lambda value: filled(tr("{length} px"), length=shown_number(value, 1)),
    ),
    _number(
        "sharpness", QT_TRANSLATE_NOOP("@default", "sharpness"),
        QT_TRANSLATE_NOOP("@default", "Sharpness of the whole window against the composite of its sources."), _percent,
    ),
    _number(
        "added", QT_TRANSLATE_NOOP("@default", "added"),
        QT_TRANSLATE_NOOP("@default", "Share of the mosaic's finest detail that its sources don't have."), _percent,
    ),
    _number(
        "explained", QT_TRANSLATE_NOOP("@default", "explained"),
        QT_TRANSLATE_NOOP("@default", "Share of the pixels whose detail the given sources explain."), _percent,
    ),
    _words(
        "causes", QT_TRANSLATE_NOOP("@default", "all causes"),
        QT_TRANSLATE_NOOP("@default", "All that happened to the contrast, what took most first."), _causes,
    ),
    _number(
        "seam_id", QT_TRANSLATE_NOOP("@default", "seam"),
        QT_TRANSLATE_NOOP("@default", "Number of the seam that the window was placed on."), str,
    ),
    _number(
        "station", QT_TRANSLATE_NOOP("@default", "station"),
        QT_TRANSLATE_NOOP("@default", "How far along its seam the window lies."), _metres,
    ),
)  # fmt: skip
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
