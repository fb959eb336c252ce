"""What was found in a window, in plain words: how much detail is left, and which step of production explains it."""
from __future__ import annotations

import math
from typing import TYPE_CHECKING

from ..toolkit.translation import filled, percent, shown_number, tr
from .cause_words import cause_clause, judged_change
from .judged_value import judged_kept
from .measure.window_records import SEAM
from .verdict_words import verdict_sentence, verdict_word
from .what_happened import Happening, as_sentence, by_mixture, what_happened

if TYPE_CHECKING:
    from .measure.explanation import Explanation
    from .measure.window.window_result import WindowResult
    from .measure.window_records import WindowRecord

_APART = 0.05  # a ratio to the composite that differs by less from the one to the sources is not told beside it
_AS_SHARP = 0.03  # of the sharpness: less is not told
_THIN = 0.6  # a strip takes less than this part of its own loss from the window
_UNEXPLAINED = 0.005  # of the pixels
_ALL_KEPT = 0.97  # less is said to be less, though the interval holds 1
_TONES = ("dodging", "gamma", "balanced", "clipping", "narrowed histogram")
"""Causes that change what share of all variance the finest detail is."""
_NOT_COMPARABLE = "not_comparable"
LOSSES = ("significant", "reduced")
_SEVERITY = (*LOSSES, "preserved")
_SAME = 1e-6  # relative; a layer may keep fewer digits than were measured


def window_sentence(row: WindowRecord, result: WindowResult | None = None) -> str:
    """What was found in a window; with its result the numbers of the cause are told too.

    A result that is not the one in the row, as after an undo, is left aside.
    """
    if not row.verdict:
        return verdict_sentence("")
    why = explanation_of(row, result)
    if row.verdict != _NOT_COMPARABLE:
        found = _verdict_and_cause(row, why)
    else:
        happened = what_happened(row, why)
        said = [*as_sentence(happened.along_the_seam), happened.in_the_whole, happened.besides]
        found = " ".join(filter(None, [row.reason or verdict_sentence(row.verdict), *said]))
    return filled(tr("{finding} Changed since: inspect it again."), finding=found) if row.stale else found


def explanation_of(row: WindowRecord, result: WindowResult | None) -> Explanation | None:
    """The explanation behind what the row holds; None when it is not at hand."""
    found = result.explanation if result is not None else None
    if result is None or found is None or found.cause.value != row.cause:
        return None
    return found if all(map(is_same, row.ratios, result.judgement.ratios.detail)) else None


def cause_numbers(found: Explanation) -> list[str]:
    """What was measured against the composite of the sources, one line each, for a tooltip."""
    change = judged_change(found)
    lines = [tr("Against the composite of the sources:")]
    if change.tone is not None:
        tone, words = change.tone, tr("gain {gain}, bias {bias}, gamma {gamma}")
        gain, bias, gamma = shown_number(tone.gain), shown_number(tone.bias, 1), shown_number(tone.gamma)
        lines.append(filled(words, gain=gain, bias=bias, gamma=gamma))
    if change.contrast[0] is not None:
        lines.append(filled(tr("contrast at level 1: {percent} %"), percent=percent(change.contrast[0])))
    if found.sharpness is not None:
        lines.append(filled(tr("sharpness at level 1: {percent} %"), percent=percent(found.sharpness)))
    lines.append(filled(tr("clipped: {percent} %"), percent=percent(change.clipped)))
    if change.colour_shift is not None:
        factor = shown_number(change.colour_shift)
        lines.append(filled(tr("gains of the colours differ by a factor of {factor}"), factor=factor))
    if change.shift is not None:
        lines.append(filled(tr("shift: {length} px"), length=shown_number(change.shift.length)))
    if found.misfit is not None:
        lines.append(filled(tr("images lie {value} px apart where they meet"), value=shown_number(found.misfit)))
    if found.expected and found.expected[0] is not None:
        left = percent(found.expected[0])
        lines.append(filled(tr("half of each source would leave {percent} % at level 1"), percent=left))
    mixed = percent(max(found.mixed_share, found.unclear_share))
    return [*lines, filled(tr("mixed or unclear: {percent} % of the pixels"), percent=mixed)]


def _verdict_and_cause(row: WindowRecord, found: Explanation | None) -> str:
    """The verdict, what it was taken by, and the causes."""
    if row.reference == SEAM:
        said = [*_by_the_seam(row, what_happened(row, found), found), *by_the_paper(row)]
        return " ".join([verdict_sentence(row.verdict), *said])
    verdict, ratio = verdict_sentence(row.verdict), row.ratio
    because = cause_clause(row.cause, found, row.verdict in LOSSES)
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
    left = filled(left, **values)
    return f"{verdict} {left}; {because}." if because else f"{verdict} {left}."


def _by_the_seam(row: WindowRecord, happened: Happening, found: Explanation | None) -> list[str]:
    """What is kept beside the seam and in the whole, what took the rest, and what could not be compared."""
    is_blurred = row.verdict == "significant" and judged_kept(row) is None
    has_kept = row.kept_1 is not None and row.kept_low is not None and row.kept_high is not None
    if is_blurred or not has_kept:
        said = [] if is_blurred else [row.reason or tr("There is no seam in the window to be judged.")]
        said += [*(_sharpness(row.sharpness, happened)), *as_sentence(happened.along_the_seam)]
    else:
        said = _along_the_seam(row, happened, by_mixture(found))
    if row.reason and row.reason not in said:
        said.append(row.reason)
    missing = 0.0 if row.explained is None else 1 - row.explained
    is_told = f"{100 * missing:.0f} %" in row.reason  # VERDICT_OF_THE_REST says how many, too, in whatever language
    if missing > _UNEXPLAINED and not is_told:
        text = tr("{percent} % of the pixels match none of the given sources and took no part.")
        said.append(filled(text, percent=percent(missing)))
    return [*said, happened.besides] if happened.besides else said


def _along_the_seam(row: WindowRecord, happened: Happening, by_what: list[str]) -> list[str]:
    """What is kept there, where that is known, and how sharp the whole is."""
    kept, low, high, clause = row.kept_1 or 0.0, row.kept_low or 0.0, row.kept_high or 0.0, happened.along_the_seam
    if high < 1:
        values = {"lost": percent(1 - kept), "least": percent(1 - high), "most": percent(1 - low)}
        text = tr("Beside the seam {lost} % of the finest detail is lost ({least} to {most} %)")
        if row.band_width:
            values["width"] = shown_number(row.band_width, 1)
            text = tr(
                "In a strip of {width} m along the seam {lost} % of the finest detail is lost ({least} to {most} %)"
            )
        lost = filled(text, **values) + _to_an_eye(row.visibility)
        return [f"{lost}: {clause}." if clause else f"{lost}.", *by_what, *_rest(row.sharpness, happened)]
    text = tr("Along the seam as much of the finest detail is left as around it ({kept} %, {low} to {high} %)")
    if kept < _ALL_KEPT:
        text = tr("Along the seam no loss can be told from chance: {kept} % of the finest detail is left "
                  "({low} to {high} %)")
    text = filled(text, kept=percent(kept), low=percent(low), high=percent(high))
    along = f"{text}; {clause}." if clause else f"{text}."
    if row.verdict == "reduced" and row.sharpness is not None:  # the seam is sound, so the whole is the reason
        text = tr("The whole window lost sharpness: it has {percent} % of that of its sources.")
        return [happened.in_the_whole or filled(text, percent=percent(row.sharpness)), along, *by_what]
    return [along, *by_what, *_rest(row.sharpness, happened)]


def by_the_paper(row: WindowRecord) -> list[str]:
    """What the paper's rule says where that is something else, and why as far as the figures tell.

    The ratio to the least detailed source is the one to the hard cut times what the hard cut has of that source's.
    """
    ratio, composite, kept = row.ratio, row.composite_ratio, judged_kept(row)
    if ratio is None or row.paper_verdict not in _SEVERITY or row.verdict not in _SEVERITY:
        return []
    milder = _SEVERITY.index(row.paper_verdict) - _SEVERITY.index(row.verdict)
    content = ratio / composite if composite else None
    has_other_tones = not set(row.causes.split("; ")).isdisjoint(_TONES)
    change = (row.sharpness or 1) - 1
    reasons = []
    if content and (row.sources or 0) > 1 and not has_other_tones:
        if milder > 0 and content > 1 + _APART:
            text = tr("another source has more detail here: cut hard, the window would have {percent} %")
            reasons.append(filled(text, percent=percent(content)))
        if milder < 0 and content < 1 - _APART:
            text = tr("the sources differ here: cut hard, the window would have no more than {percent} %")
            reasons.append(filled(text, percent=percent(content)))
    if has_other_tones and milder:
        reasons.append(tr("it takes detail as a share of all variance, and the tones were changed"))
    if abs(change) > _APART and (change > 0) == (milder > 0) and milder:
        text = tr("it takes the window as a whole, which has {percent} % of the sharpness of its sources")
        reasons.append(filled(text, percent=percent(1 + change)))
    elif milder > 0 and kept is not None and composite and row.band_width and _is_thin(composite, kept):
        text = tr("the strip is thin in the window, all of which has {percent} % of a hard cut's")
        reasons.append(filled(text, percent=percent(composite)))
    if not reasons and (row.paper_verdict in LOSSES) == (row.verdict in LOSSES):
        return []  # the same, or two limits and no more
    text = tr("By the paper's rule it is {verdict}, with {percent} % of the detail of the least detailed source")
    said = filled(text, verdict=verdict_word(row.paper_verdict), percent=percent(ratio))
    return ["; ".join([said, *reasons]) + "."]


def _is_thin(composite: float, kept: float) -> bool:
    """Whether what a strip lost hardly shows in the whole window."""
    return abs(1 - composite) < _THIN * (1 - kept)


def _to_an_eye(visibility: float | None) -> str:
    """What a loss along the seam means to an eye, to go on with in its sentence."""
    if visibility is None:
        return ""
    if visibility < 1:
        return tr(", less than an eye just sees at 2x")
    return filled(tr(", {times} times what an eye just sees at 2x"), times=shown_number(visibility, 1))


def _rest(sharpness: float | None, happened: Happening) -> list[str]:
    """How sharp the window is beside its seam."""
    if not happened.in_the_whole and sharpness is not None and abs(sharpness - 1) < _AS_SHARP:
        return [tr("The rest is as sharp as its sources.")]
    return _sharpness(sharpness, happened)


def _sharpness(sharpness: float | None, happened: Happening) -> list[str]:
    """Of the whole window, with what took of it where that is known."""
    if happened.in_the_whole or sharpness is None:
        return [happened.in_the_whole] if happened.in_the_whole else []
    return [filled(tr("The whole window has {percent} % of the sharpness of its sources."), percent=percent(sharpness))]


def is_same(one: float | None, other: float | None) -> bool:
    """Whether two numbers are one, of which a layer may keep fewer digits."""
    return one == other or (one is not None and other is not None and math.isclose(one, other, rel_tol=_SAME))
