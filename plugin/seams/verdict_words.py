"""Words and colours of what tables hold: verdicts, the observer's words, causes."""
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
    return {"visible": tr("visible"), "invisible": tr("invisible")}.get(observer, observer)


def cause_word(cause: str) -> str:
    """A cause for the user."""
    return {
        "blur": tr("blur"),
        "feathering": tr("feathering"),
        "narrowed histogram": tr("narrowed histogram"),
        "gamma": tr("gamma"),
        "clipping": tr("clipping"),
        "colour shift": tr("colour shift"),
        "misregistration": tr("misregistration"),
        "none": tr("none"),
        "unclear": tr("unclear"),
    }.get(cause, cause)


def cause_sentence(cause: str) -> str:
    """What a cause means, in plain words; empty for an unknown one."""
    return {
        "blur": tr("The mosaic is less sharp than its sources, beyond what tone and feathering explain."),
        "feathering": tr("Images that do not fit were blended along the seam."),
        "narrowed histogram": tr("Grey values were pressed together by a linear function."),
        "gamma": tr("Grey values were changed by a power function."),
        "clipping": tr("Highlights or shadows were driven into the limits."),
        "colour shift": tr("The channels were corrected one by one, so that colours turned."),
        "misregistration": tr("The mosaic does not lie where its sources do."),
        "none": tr("No step of production is found that took contrast away."),
        "unclear": tr("What was measured does not point to one cause."),
    }.get(cause, "")
