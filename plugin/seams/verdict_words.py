"""Words and colours of what tables hold: verdicts and the observer's words."""
from __future__ import annotations

from typing import NamedTuple

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..toolkit.translation import tr


class ShownVerdict(NamedTuple):
    """How people meet a verdict."""

    word: str
    colour: str
    """The one on the map, too (resources/styles/windows.qml)."""
    sentence: str = ""
    """What is said of such a window, where that is more than the word."""


VERDICTS = {
    "significant": ShownVerdict(
        QT_TRANSLATE_NOOP("@default", "significant"), "#d55e00", QT_TRANSLATE_NOOP("@default", "Significant loss.")
    ),
    "reduced": ShownVerdict(QT_TRANSLATE_NOOP("@default", "reduced"), "#f0c800"),
    "preserved": ShownVerdict(QT_TRANSLATE_NOOP("@default", "preserved"), "#0072b2"),
    "not_comparable": ShownVerdict(
        QT_TRANSLATE_NOOP("@default", "not comparable"),
        "#8a8a8a",
        QT_TRANSLATE_NOOP("@default", "The mosaic could not be compared with a source here."),
    ),
    "": ShownVerdict(
        QT_TRANSLATE_NOOP("@default", "not inspected"), "#c8c8c8", QT_TRANSLATE_NOOP("@default", "Not inspected yet.")
    ),
}
"""By the word that tables hold, the worst first; the empty one is that of a window not inspected."""


def verdict_word(verdict: str) -> str:
    """A verdict for the user."""
    return tr(VERDICTS[verdict].word) if verdict in VERDICTS else verdict


def verdict_sentence(verdict: str) -> str:
    """What a verdict says of a window."""
    told = VERDICTS[verdict].sentence if verdict in VERDICTS else ""
    return tr(told) if told else f"{verdict_word(verdict).capitalize()}."


def verdict_colour(verdict: str) -> str:
    """The colour of a verdict, that of ``not_comparable`` for an unknown one."""
    return VERDICTS[verdict if verdict in VERDICTS else "not_comparable"].colour


def observer_word(observer: str) -> str:
    """The observer's word for the user."""
    words = {"visible": tr("visible"), "invisible": tr("invisible"), "unsure": tr("not sure")}
    return words.get(observer, observer)
