"""How people meet a cause: its word, what it means, and what is said of a window where it was found."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..toolkit.translation import percent, shown_number, tr
from .measure.causes import Cause

if TYPE_CHECKING:
    from .measure.explanation import Change, Explanation

MIN_SHOWN_PX = 0.05  # sources that lie less apart lie 0.0 px apart

Clause = tuple[str, ...]
"""What goes on a sentence: of a loss, and of a window that lost nothing where that is put otherwise."""


def judged_change(found: Explanation) -> Change:
    """The mosaic against the composite, in the judged band, which is the first."""
    return next(iter(found.changes[-1].values()))


def _misregistration(found: Explanation) -> float | None:
    """How far the mosaic lies off the source that the composite agrees with best in this, px."""
    shifts = [next(iter(bands.values())).shift for bands in found.changes]
    *lengths, against = [None if shift is None else shift.length for shift in shifts]
    known = [length for length in lengths if length is not None]
    if against is None:
        return max(known, default=None)
    return min(known, key=lambda length: abs(length - against), default=against)


def _tenths(value: float) -> str:
    return shown_number(value, 1)


class ShownCause(NamedTuple):
    """The texts of a cause."""

    word: str
    meaning: str
    clause: Clause
    measured: Clause = ()
    """The clause with its number, ``{value}``."""
    number: Callable[[Explanation], float | None] = lambda found: None
    """That number; None where it is not known, and 0 says nothing."""
    shown: Callable[[float], str] = shown_number


CAUSES: dict[str, ShownCause] = {
    Cause.BLUR.value: ShownCause(
        QT_TRANSLATE_NOOP("@default", "blur"),
        QT_TRANSLATE_NOOP(
            "@default", "The mosaic is less sharp than its sources, beyond what tone and feathering explain."
        ),
        (QT_TRANSLATE_NOOP("@default", "blur explains it"), QT_TRANSLATE_NOOP("@default", "it is blurred")),
        (
            QT_TRANSLATE_NOOP("@default", "blur to {value} % of their sharpness explains it"),
            QT_TRANSLATE_NOOP("@default", "it is blurred to {value} % of their sharpness"),
        ),
        lambda found: judged_change(found).sharpness[0],
        percent,
    ),
    Cause.FEATHERING.value: ShownCause(
        QT_TRANSLATE_NOOP("@default", "feathering"),
        QT_TRANSLATE_NOOP("@default", "Images that do not fit were blended along the seam."),
        (
            QT_TRANSLATE_NOOP("@default", "feathering explains it"),
            QT_TRANSLATE_NOOP("@default", "images are feathered"),
        ),
        (
            QT_TRANSLATE_NOOP("@default", "feathering of images {value} px apart explains it"),
            QT_TRANSLATE_NOOP("@default", "images {value} px apart are feathered"),
        ),
        lambda found: found.apart if (found.apart or 0) >= MIN_SHOWN_PX else None,
        _tenths,
    ),
    Cause.NARROWED_HISTOGRAM.value: ShownCause(
        QT_TRANSLATE_NOOP("@default", "narrowed histogram"),
        QT_TRANSLATE_NOOP("@default", "Grey values were pressed together by a linear function."),
        (QT_TRANSLATE_NOOP("@default", "the histogram is narrowed"),),
        (QT_TRANSLATE_NOOP("@default", "the histogram is narrowed, gain {value}"),),
        lambda found: getattr(judged_change(found).tone, "gain", None),
    ),
    Cause.GAMMA.value: ShownCause(
        QT_TRANSLATE_NOOP("@default", "gamma"),
        QT_TRANSLATE_NOOP("@default", "Grey values were changed by a power function."),
        (QT_TRANSLATE_NOOP("@default", "grey values are bent by a gamma"),),
        (QT_TRANSLATE_NOOP("@default", "grey values are bent, gamma {value}"),),
        lambda found: getattr(judged_change(found).tone, "gamma", None),
    ),
    Cause.CLIPPING.value: ShownCause(
        QT_TRANSLATE_NOOP("@default", "clipping"),
        QT_TRANSLATE_NOOP("@default", "Highlights or shadows were driven into the limits."),
        (QT_TRANSLATE_NOOP("@default", "highlights or shadows are clipped"),),
        (QT_TRANSLATE_NOOP("@default", "{value} % of the pixels are clipped"),),
        lambda found: judged_change(found).clipped,
        percent,
    ),
    Cause.COLOUR_SHIFT.value: ShownCause(
        QT_TRANSLATE_NOOP("@default", "colour shift"),
        QT_TRANSLATE_NOOP("@default", "The channels were corrected one by one, so that colours turned."),
        (QT_TRANSLATE_NOOP("@default", "the colours are shifted"),),
        (QT_TRANSLATE_NOOP("@default", "the colours are shifted, gains differ by a factor of {value}"),),
        lambda found: judged_change(found).colour_shift,
    ),
    Cause.MISREGISTRATION.value: ShownCause(
        QT_TRANSLATE_NOOP("@default", "misregistration"),
        QT_TRANSLATE_NOOP("@default", "The mosaic does not lie where its sources do."),
        (QT_TRANSLATE_NOOP("@default", "the mosaic does not lie where its sources do"),),
        (QT_TRANSLATE_NOOP("@default", "the mosaic lies {value} px off its sources"),),
        _misregistration,
        _tenths,
    ),
    Cause.NONE.value: ShownCause(
        QT_TRANSLATE_NOOP("@default", "none"),
        QT_TRANSLATE_NOOP("@default", "No step of production is found that took contrast away."),
        (QT_TRANSLATE_NOOP("@default", "no step of production took detail away"), ""),
    ),
    Cause.UNCLEAR.value: ShownCause(
        QT_TRANSLATE_NOOP("@default", "unclear"),
        QT_TRANSLATE_NOOP("@default", "What was measured does not point to one cause."),
        (QT_TRANSLATE_NOOP("@default", "the cause is unclear: its detail is not that of the sources"),),
    ),
}
"""By the word that tables hold; a table of a later version may hold others."""


def cause_word(cause: str) -> str:
    """A cause for the user."""
    return tr(CAUSES[cause].word) if cause in CAUSES else cause


def cause_sentence(cause: str) -> str:
    """What a cause means, in plain words; empty for an unknown one."""
    return tr(CAUSES[cause].meaning) if cause in CAUSES else ""


def cause_clause(cause: str, found: Explanation | None, is_loss: bool) -> str:
    """What the cause did, to go on a sentence with, with its number where that is at hand; empty for nothing to say."""
    if cause not in CAUSES:
        return ""
    shown = CAUSES[cause]
    number = None if found is None else shown.number(found)
    text = (shown.measured if number else shown.clause)[0 if is_loss else -1]
    if not text:
        return ""
    return tr(text).format(value=shown.shown(number)) if number else tr(text)
