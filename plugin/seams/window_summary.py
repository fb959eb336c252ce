"""What was found in a window, in plain words: how much detail is left, and which step of production explains it."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..toolkit.translation import percent, shown_number, tr
from .cause_words import cause_clause, judged_change
from .verdict_words import verdict_sentence

if TYPE_CHECKING:
    from .measure.explanation import Explanation
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
    change = judged_change(found)
    lines = [tr("Against the composite of the sources:")]
    if change.tone is not None:
        tone, words = change.tone, tr("gain {gain}, bias {bias}, gamma {gamma}")
        gain, bias, gamma = shown_number(tone.gain), shown_number(tone.bias, 1), shown_number(tone.gamma)
        lines.append(words.format(gain=gain, bias=bias, gamma=gamma))
    if change.contrast[0] is not None:
        lines.append(tr("contrast at level 1: {percent} %").format(percent=percent(change.contrast[0])))
    if change.sharpness[0] is not None:
        lines.append(tr("sharpness at level 1: {percent} %").format(percent=percent(change.sharpness[0])))
    lines.append(tr("clipped: {percent} %").format(percent=percent(change.clipped)))
    if change.colour_shift is not None:
        factor = shown_number(change.colour_shift)
        lines.append(tr("gains of the colours differ by a factor of {factor}").format(factor=factor))
    if change.shift is not None:
        lines.append(tr("shift: {length} px").format(length=shown_number(change.shift.length)))
    if found.apart is not None:
        lines.append(tr("the sources lie {length} px apart").format(length=shown_number(found.apart)))
    if found.expected and found.expected[0] is not None:
        left = percent(found.expected[0])
        lines.append(tr("half of each source would leave {percent} % at level 1").format(percent=left))
    mixed = percent(max(found.mixed_share, found.unclear_share))
    return [*lines, tr("mixed or unclear: {percent} % of the pixels").format(percent=mixed)]


def _verdict_and_cause(row: WindowRecord, found: Explanation | None) -> str:
    """The verdict, the ratios, and the cause."""
    verdict, ratio = verdict_sentence(row.verdict), row.ratio
    because = cause_clause(row.cause, found, row.verdict in _LOSSES)
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


def _is_same(one: float | None, other: float | None) -> bool:
    return one == other or (one is not None and other is not None and math.isclose(one, other, rel_tol=_SAME))
