"""What was found in a window, in plain words: how much detail is left, and which step of production explains it."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QLocale

from ..toolkit.translation import tr
from .verdict_words import verdict_sentence

if TYPE_CHECKING:
    from .measure.explanation import Change, Explanation
    from .measure.inspection import WindowResult
    from .measure.window_records import WindowRecord

_APART = 0.05  # a ratio to the composite that differs by less from the one to the sources is not told beside it
_LOSSES = ("significant", "reduced")
_SAME = 1e-6  # relative; a layer may keep fewer digits than were measured


def window_sentence(row: WindowRecord, result: WindowResult | None = None) -> str:
    """What was found in a window; with its result the numbers of the cause are told too.

    A result that is not the one in the row, as after an undo, is left aside.
    """
    if not row.verdict:
        return verdict_sentence("")
    if row.is_compared:
        found = _verdict_and_cause(row, explanation_of(row, result))
    else:
        found = row.reason or verdict_sentence(row.verdict)
    return tr("{finding} Changed since: inspect it again.").format(finding=found) if row.stale else found


def explanation_of(row: WindowRecord, result: WindowResult | None) -> Explanation | None:
    """The explanation behind what the row holds; None when it is not at hand."""
    found = result.explanation if result is not None else None
    if result is None or found is None or found.cause.value != row.cause:
        return None
    return found if all(map(_is_same, row.ratios, result.judgement.ratios.detail)) else None


def cause_numbers(found: Explanation) -> list[str]:
    """What was measured against the composite of the sources, one line each, for a tooltip."""
    change = _judged(found)
    lines = [tr("Against the composite of the sources:")]
    if change.tone is not None:
        lines.append(
            tr("gain {gain}, bias {bias}, gamma {gamma}").format(
                gain=_number(change.tone.gain), bias=_number(change.tone.bias, 1), gamma=_number(change.tone.gamma)
            )
        )
    if change.contrast[0] is not None:
        lines.append(tr("contrast at level 1: {percent} %").format(percent=percent(change.contrast[0])))
    if change.sharpness[0] is not None:
        lines.append(tr("sharpness at level 1: {percent} %").format(percent=percent(change.sharpness[0])))
    lines.append(tr("clipped: {percent} %").format(percent=percent(change.clipped)))
    if change.colour_shift is not None:
        lines.append(tr("gains of the colours differ by a factor of {factor}").format(
            factor=_number(change.colour_shift)
        ))
    if change.shift is not None:
        lines.append(tr("shift: {length} px").format(length=_number(change.shift.length)))
    if found.apart is not None:
        lines.append(tr("the sources lie {length} px apart").format(length=_number(found.apart)))
    if found.expected and found.expected[0] is not None:
        lines.append(tr("half of each source would leave {percent} % at level 1").format(
            percent=percent(found.expected[0])
        ))
    lines.append(tr("mixed or unclear: {percent} % of the pixels").format(
        percent=percent(max(found.mixed_share, found.unclear_share))
    ))
    return lines


def percent(ratio: float) -> str:
    """Whole per cents; one decimal where they would hide that a ratio is not 1, or is small."""
    decimals = 1 if 0 < ratio < 0.1 or (0.99 < ratio < 1.01 and ratio != 1) else 0
    share = 100 * ratio
    if ratio < 1:
        share = min(share, 99.9)
    return QLocale().toString(share, "f", decimals)


def _verdict_and_cause(row: WindowRecord, found: Explanation | None) -> str:
    """The verdict, the ratios, and the cause."""
    verdict, ratio, because = verdict_sentence(row.verdict), row.ratio, _because(row, found)
    if ratio is None:
        return f"{verdict} {because[:1].upper()}{because[1:]}." if because else verdict
    values = {"percent": percent(ratio)}
    if row.composite_ratio is not None and abs(row.composite_ratio - ratio) > _APART:
        values["composite"] = percent(row.composite_ratio)
        left = tr("Detail at level 1 is {percent} % of the sources' and {composite} % of their composite's")
        if row.sources == 1:
            left = tr("Detail at level 1 is {percent} % of the source's and {composite} % of the levelled source's")
    elif row.sources == 1:
        left = tr("Detail at level 1 is {percent} % of the source's")
    else:
        left = tr("Detail at level 1 is {percent} % of the sources'")
    left = left.format(**values)
    return f"{verdict} {left}; {because}." if because else f"{verdict} {left}."


def _because(row: WindowRecord, found: Explanation | None) -> str:
    """What the cause did, to go on a sentence with; empty where there is nothing to be said."""
    is_loss = row.verdict in _LOSSES
    template, value = "", None
    if found is not None:
        template, value = _measured_cause(row.cause, found, is_loss)
    if not template:
        template = _named_cause(row.cause, is_loss)
    return template if value is None else template.format(value=value)


def _measured_cause(cause: str, found: Explanation, is_loss: bool) -> tuple[str, str | None]:
    """The clause with its number; empty where there is no number, or it says nothing."""
    change = _judged(found)
    sharpness, tone, shift = change.sharpness[0], change.tone, _misregistration(found)
    if cause == "blur" and sharpness is not None:
        words = tr("blur to {value} % of their sharpness explains it") if is_loss else tr(
            "it is blurred to {value} % of their sharpness"
        )
        return words, percent(sharpness)
    if cause == "feathering" and found.apart is not None and _number(found.apart, 1) != _number(0.0, 1):
        words = tr("feathering of images {value} px apart explains it") if is_loss else tr(
            "images {value} px apart are feathered"
        )
        return words, _number(found.apart, 1)
    if cause == "narrowed histogram" and tone is not None:
        return tr("the histogram is narrowed, gain {value}"), _number(tone.gain)
    if cause == "gamma" and tone is not None:
        return tr("grey values are bent, gamma {value}"), _number(tone.gamma)
    if cause == "clipping":
        return tr("{value} % of the pixels are clipped"), percent(change.clipped)
    if cause == "colour shift" and change.colour_shift is not None:
        return tr("the colours are shifted, gains differ by a factor of {value}"), _number(change.colour_shift)
    if cause == "misregistration" and shift > 0:
        return tr("the mosaic lies {value} px off its sources"), _number(shift, 1)
    return "", None


def _named_cause(cause: str, is_loss: bool) -> str:
    """The clause from the cause's word alone."""
    clauses = {
        "blur": tr("blur explains it") if is_loss else tr("it is blurred"),
        "feathering": tr("feathering explains it") if is_loss else tr("images are feathered"),
        "narrowed histogram": tr("the histogram is narrowed"),
        "gamma": tr("grey values are bent by a gamma"),
        "clipping": tr("highlights or shadows are clipped"),
        "colour shift": tr("the colours are shifted"),
        "misregistration": tr("the mosaic does not lie where its sources do"),
        "none": tr("no step of production took detail away") if is_loss else "",
        "unclear": tr("the cause is unclear: its detail is not that of the sources"),
    }
    return clauses.get(cause, "")


def _judged(found: Explanation) -> Change:
    """The mosaic against the composite, in the judged band, which is the first."""
    return next(iter(found.changes[-1].values()))


def _misregistration(found: Explanation) -> float:
    """How far the mosaic lies off the source that the composite agrees with best in this, px; 0 where not known."""
    shifts = [next(iter(bands.values())).shift for bands in found.changes]
    *lengths, against = [None if shift is None else shift.length for shift in shifts]
    known = [length for length in lengths if length is not None]
    if against is None:
        return max(known, default=0.0)
    return min(known, key=lambda length: abs(length - against), default=against)


def _is_same(one: float | None, other: float | None) -> bool:
    return one == other or (one is not None and other is not None and math.isclose(one, other, rel_tol=_SAME))


def _number(value: float, decimals: int = 2) -> str:
    return QLocale().toString(value, "f", decimals)
