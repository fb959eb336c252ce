"""What was found in a window, in plain words: the verdict, where how much detail was lost, by what, and what to do.

That is the sentence of a window; what it rests on is told apart, to who asks why.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, NamedTuple

from ..imagery.limits import MAX_SIGNIFICANT_RATIO
from ..toolkit.translation import decimals_beside, filled, grouped_number, percent, sentence, shown_number, tr
from .measure.judgement.causes import ALONG_THE_SEAM, MIXTURES, Cause, causes_taken
from .measure.judgement.loss_place import LossPlace
from .measure.limits import MAX_SIGNIFICANT_KEPT, MAX_SIGNIFICANT_SHARPNESS_SQUARED, MIN_MISREGISTRATION_PX
from .measure.profile.seam_profile import Measure
from .measure.window_records import MAY_BE_SIGNIFICANT, OF_THE_REST, SEAM
from .words import (
    CAUSES,
    LOSSES,
    cause_clause,
    loss_words,
    seam_width_words,
    strip_words,
    to_do,
    verdict_sentence,
)

if TYPE_CHECKING:
    from .measure.judgement.explanation import Explanation
    from .measure.window.window_result import WindowResult
    from .measure.window_records import WindowRecord


def judged_kept(row: WindowRecord) -> float | None:
    """kept_1 where the verdict was taken by it; None where the sharpness of the whole told the loss."""
    is_by_seam = row.verdict == "preserved" or loss_place(row).is_along
    return row.kept_1 if row.reference == SEAM and is_by_seam else None


def judged_words(row: WindowRecord) -> list[str]:
    """Each number that the verdict looks at; empty where nothing was measured."""
    if row.reference == SEAM:
        lost = [] if row.loss is None else [filled(tr("loss: {area}"), area=shown_area(row.loss))]
        sharpness = _number_words(tr("sharpness 1: {value}"), row.sharpness, MAX_SIGNIFICANT_SHARPNESS_SQUARED**0.5)
        return [*lost, *_kept_words(row), *sharpness]
    composite = _number_words(tr("composite: {value}"), row.composite_ratio, MAX_SIGNIFICANT_RATIO)
    return [*_number_words(tr("ratio 1: {value}"), row.ratio, MAX_SIGNIFICANT_RATIO), *composite]


def two_digits(value: float | None, *limits: float) -> str:
    """A ratio, with more digits where two would hide that it is beyond a limit; empty where it is not known."""
    return "" if value is None else shown_number(value, decimals_beside(value, limits, 2))


def shown_area(area_m2: float) -> str:
    """Square metres, with tenths where they are few."""
    return filled(tr("{area} m²"), area=grouped_number(area_m2, 0 if area_m2 >= _FEW_M2 else 1))


def _kept_words(row: WindowRecord) -> list[str]:
    if judged_kept(row) is None:
        return []
    if row.kept_low is None or row.kept_high is None:
        return _number_words(tr("kept 1: {value}"), row.kept_1, MAX_SIGNIFICANT_KEPT)
    value, low, high = (two_digits(kept, MAX_SIGNIFICANT_KEPT) for kept in (row.kept_1, row.kept_low, row.kept_high))
    return [filled(tr("kept 1: {value} ({low} to {high})"), value=value, low=low, high=high)]


def _number_words(text: str, value: float | None, limit: float) -> list[str]:
    return [] if value is None else [filled(text, value=two_digits(value, limit))]


_TOLD_BEFORE = ("", Cause.NONE, Cause.MISSING_SOURCE)  # no sentence of their own beside the seam's
_FEW_M2 = 10.0
_MUCH_ADDED = 0.15  # of the detail beside the seam that is not the sources'
_LEAST_TAKEN = 0.005  # of the window's finest detail


def _brief(causes: Sequence[str], row: WindowRecord, widths: SeamWidths) -> str:
    """What took detail there, in a few words, the first with how wide it did along a seam."""
    said = [tr(brief) for cause in causes if cause in CAUSES and (brief := CAUSES[cause].brief)]
    if Cause.MISREGISTRATION in causes and (px := _misfit_px(row)) is not None:
        said[causes.index(Cause.MISREGISTRATION)] = filled(tr("images {value} px apart"), value=shown_number(px, 1))
    return ", ".join([*(_over(first, widths.of(causes[0])) for first in said[:1]), *said[1:]])


def _over(words: str, width: str) -> str:
    return filled(tr("{clause} over {width} m"), clause=words, width=width) if width else words


def _misfit_px(row: WindowRecord) -> float | None:
    """How far apart the images lie that meet; None where that is next to nothing, or not known."""
    return row.misfit if (row.misfit or 0) >= MIN_MISREGISTRATION_PX else None


def _done(row: WindowRecord, explanation: Explanation | None, widths: SeamWidths, most: int | None = None) -> str:
    """All that was done to the window, or the ``most`` that took most, to go on a sentence with."""
    causes = [cause for cause in _causes_of(row)[:most] if cause not in _TOLD_BEFORE]
    clauses = (_over(_clause(cause, row, explanation), widths.of(cause)) for cause in causes)
    return "; ".join(filter(None, clauses))


def _clause(cause: str, row: WindowRecord, explanation: Explanation | None) -> str:
    return cause_clause(cause, explanation, _misfit_px(row) if cause == Cause.MISREGISTRATION else None)


def _as_sentence(clause: str) -> str:
    return f"{clause[:1].upper()}{clause[1:]}." if clause else ""


_APART = 0.05  # a ratio that differs by less from another, or from 1, is not told beside it
_AS_SHARP = 0.03  # of the sharpness: less is not told
_UNEXPLAINED = 0.005  # of the pixels
_ALL_KEPT = 0.97  # less is said to be less, though the interval holds 1
_NOT_COMPARABLE = "not_comparable"
_SAME = 1e-6  # relative; a layer may keep fewer digits than were measured


def window_sentence(row: WindowRecord, result: WindowResult | None = None, pixel_m: float | None = None) -> str:
    """Verdict; where and how much; by what; what to do. With its result the numbers of the cause are told too.

    A result that is not the one in the row, as after an undo, is left aside. ``pixel_m``: the mosaic's pixel size,
    where there is no result to say it.
    """
    if not row.verdict:
        return verdict_sentence("")
    row, why = in_users_language(row, result), explanation_of(row, result)
    if row.verdict == _NOT_COMPARABLE:
        said = row.reason or verdict_sentence(row.verdict)
    elif row.reference == SEAM:
        widths = SeamWidths(row, result, pixel_m)
        said = " ".join([verdict_sentence(row.verdict), *_by_the_seam(row, why, widths)])
    else:
        said = _by_ratio(row, why)
    return filled(tr("{finding} Changed since: inspect it again."), finding=said) if row.stale else said


def window_why(row: WindowRecord, result: WindowResult | None = None, pixel_m: float | None = None) -> list[str]:
    """What the sentence of a window rests on, and all else that was found, a paragraph each."""
    row, explanation = in_users_language(row, result), explanation_of(row, result)
    said = []
    if row.reference == SEAM and row.verdict:
        done = _done(row, explanation, SeamWidths(row, result, pixel_m))
        said = [*_interval(row), _as_sentence(done)]
        profile = None if explanation is None else explanation.profile
        if profile is not None and profile.measure is Measure.MIXTURE:
            said.append(tr("This follows from the mixture of the images; the ground around can't tell it."))
            if profile.added_beside >= _MUCH_ADDED:
                said.append(tr("Other detail was added along the seam."))
        said += _sharpness(row, explanation)
        is_sentence = row.verdict == _NOT_COMPARABLE or (row.verdict not in LOSSES and _has_no_kept(row))
        if row.reason and not is_sentence:
            said.append(row.reason)
        missing = 0.0 if row.explained is None else 1 - row.explained
        if missing > _UNEXPLAINED and row.reason_code != OF_THE_REST:
            text = tr("{percent} % of the pixels match none of the given sources and are left out.")
            said.append(filled(text, percent=percent(missing)))
    return list(filter(None, said))


class SeamWidths(NamedTuple):
    """How wide the loss along the seams of a window is told, metres in words, empty where that is not known."""

    row: WindowRecord
    result: WindowResult | None
    pixel_m: float | None  # the mosaic's pixel size, where there is no result to say it

    @property
    def strip(self) -> str:
        """The strip whose share is told, by its width where that is known."""
        width = strip_words(self.pixel_m if self.result is None else self.result.ground_sample_distance)
        return filled(tr("in {width} m along the seam"), width=width) if width else tr("beside the seam")

    def of(self, cause: str) -> str:
        """Across a seam: the mixture's from end to end, or the band's where nothing mixed has a part in that."""
        result, is_mixed = self.result, not set(MIXTURES).isdisjoint(_causes_of(self.row))
        if cause not in (*MIXTURES, Cause.SOFTENED) or (is_mixed and cause == Cause.SOFTENED):
            return ""
        metres = (is_mixed and self.row.feather_width) or self.row.band_width
        if result is None:
            return seam_width_words(metres, self.pixel_m)
        return seam_width_words(metres, result.ground_sample_distance, result.longer_side_m, result.profile)


def in_users_language(row: WindowRecord, result: WindowResult | None) -> WindowRecord:
    """What a row holds, its reason worded anew where the result tells it: the file has it as it was inspected."""
    reason = None if result is None or not row.reason else result.judgement.reason
    if result is None or reason is None or result.judgement.verdict.value != row.verdict:
        return row
    return replace(row, reason=sentence(reason))


def explanation_of(row: WindowRecord, result: WindowResult | None) -> Explanation | None:
    """The explanation behind what the row holds; None when it is not at hand."""
    explanation = result.explanation if result is not None else None
    if result is None or explanation is None or result.causes[0].value != row.cause:
        return None
    return explanation if all(map(is_same, row.ratios, result.judgement.ratios.detail)) else None


def _by_ratio(row: WindowRecord, explanation: Explanation | None) -> str:
    """The sentence where the verdict was taken by whole windows."""
    verdict, ratio = verdict_sentence(row.verdict), row.ratio
    because = "" if row.cause == Cause.NONE and row.verdict not in LOSSES else _clause(row.cause, row, explanation)
    if ratio is None:
        return f"{verdict} {_as_sentence(because)}".rstrip()
    left = tr("Detail at level 1 is {percent} % of the sources'")
    if row.composite_ratio is not None and abs(row.composite_ratio - ratio) > _APART:
        left = tr("Detail at level 1 is {percent} % of the sources' and {composite} % of their composite's")
    of_sources, of_composite = (percent(left, MAX_SIGNIFICANT_RATIO) for left in (ratio, row.composite_ratio or 0.0))
    left = filled(left, percent=of_sources, composite=of_composite)
    return f"{verdict} {left}; {because}." if because else f"{verdict} {left}."


def loss_place(row: WindowRecord) -> LossPlace:
    """The place of the loss of a window that was judged by its seam."""
    return LossPlace(row.verdict, row.kept_1, row.kept_high, row.sharpness)


def painted_width_m(row: WindowRecord, result: WindowResult | None) -> float:
    """How far across its seam the loss of a window is painted: as wide as it is told. 0 where more took detail than the
    seam, or nothing is told, and all that was measured is painted."""
    is_alone = loss_place(row).is_along and not _is_whole_soft(row, explanation_of(row, result))
    return max(row.band_width or 0.0, row.feather_width or 0.0) if is_alone else 0.0


def _by_the_seam(row: WindowRecord, explanation: Explanation | None, widths: SeamWidths) -> list[str]:
    """Sentences of how much was lost and by what, and what to do about it: two lines at most, so of seam and whole
    window only what took the more, or made the verdict, is told with its cause; what both took stands last."""
    if row.verdict not in LOSSES:
        return [_what_is_left(row, _done(row, explanation, widths, most=1), widths.strip)]
    place = loss_place(row)
    causes = place.decisive(_causes_of(row))
    said, in_all = _lost_in_whole(row, place), []
    if place.is_decisive:
        lost = percent(1 - (row.kept_1 or 0.0), 1 - MAX_SIGNIFICANT_KEPT)
        said = filled(tr("{lost} % of detail lost {strip}"), lost=lost, strip=widths.strip)
        if row.loss is not None and _is_whole_soft(row, explanation):
            in_all = [filled(tr("In all {area}."), area=shown_area(row.loss))]
    named = [cause for cause in causes if cause in ALONG_THE_SEAM and cause != Cause.UNCLEAR]
    clause = _brief(named if causes[:1] == named[:1] else causes[:1], row, widths)
    return [f"{said}: {clause}." if clause else f"{said}.", *_done_about(row, causes), *in_all]


def _causes_of(row: WindowRecord) -> list[str]:
    return (row.causes or row.cause).split("; ")


def _is_whole_soft(row: WindowRecord, explanation: Explanation | None) -> bool:
    return loss_place(row).is_whole_soft if explanation is None else explanation.ground_left < 1


def _lost_in_whole(row: WindowRecord, place: LossPlace) -> str:
    lost, limit = 1 - place.kept_in_whole, 1 - MAX_SIGNIFICANT_SHARPNESS_SQUARED
    said = filled(tr("{lost} % of the window's detail lost"), lost=percent(lost, limit))
    more = [] if row.loss is None else [shown_area(row.loss)]
    if row.verdict == "reduced" and lost > 1 - MAX_SIGNIFICANT_KEPT:  # which would be significant along a seam
        more.append(filled(tr("limit {percent} %"), percent=percent(limit)))
    said = f"{said} ({'; '.join(more)})" if more else said
    if place.is_along:  # of the ground around it
        text = tr("{said}, {lost} % of the rest along the seam")
        return filled(text, said=said, lost=percent(1 - (row.kept_1 or 0.0), 1 - MAX_SIGNIFICANT_KEPT))
    is_even = not place.is_blurred and (row.kept_1 or 0.0) >= _ALL_KEPT
    return filled(tr("{said}, no more along the seam"), said=said) if is_even else said


def _done_about(row: WindowRecord, causes: list[str]) -> list[str]:
    """What to do, a few words."""
    if row.stale:
        return []  # to inspect it again
    if row.reason_code == MAY_BE_SIGNIFICANT:
        return [tr("It may be more: judge by eye.")]
    if not causes and Cause.MISSING_SOURCE in _causes_of(row):
        return [to_do(Cause.MISSING_SOURCE)]
    if causes[:1] == [Cause.UNCLEAR]:
        return [tr("Judge by eye.")]
    return [to_do(cause) for cause in causes[:1]]


def _has_no_kept(row: WindowRecord) -> bool:
    return row.kept_1 is None or row.kept_high is None


def _what_is_left(row: WindowRecord, clause: str, strip: str) -> str:
    """The sentence where no loss is sure."""
    if _has_no_kept(row):
        return f"{row.reason} {_as_sentence(clause)}".strip()
    text = tr("As much of the finest detail is left {strip} as around it")
    if (row.kept_1 or 0.0) < _ALL_KEPT:
        text = tr("No loss is certain {strip}")
    text = filled(text, strip=strip)
    return f"{text}; {clause}." if clause else f"{text}."


def _interval(row: WindowRecord) -> list[str]:
    """How sure the number along the seam is, and what it means to an eye."""
    if row.kept_1 is None or row.kept_low is None or row.kept_high is None:
        return []
    kept, low, high = (percent(kept, MAX_SIGNIFICANT_KEPT) for kept in (row.kept_1, row.kept_low, row.kept_high))
    if not loss_place(row).is_along:
        text = tr("Along the seam {kept} % is left of the finest detail around it ({low} to {high} %).")
        return [] if loss_place(row).is_blurred else [filled(text, kept=kept, low=low, high=high)]
    least, most = (percent(1 - kept, 1 - MAX_SIGNIFICANT_KEPT) for kept in (row.kept_high, row.kept_low))
    text = tr("The loss along the seam lies between {least} and {most} % (95 % interval).")
    said = [filled(text, least=least, most=most)]
    if row.visibility is not None:  # by a model of an eye
        text = tr("It is {times} times what an eye just sees at 2x.")
        said.append(filled(text, times=shown_number(row.visibility, 1)))
    return said


def _sharpness(row: WindowRecord, explanation: Explanation | None) -> list[str]:
    """Sharpness of the whole window, with what took of its detail where that is known. Of the energy of detail, of
    which sharpness is the root."""
    if row.sharpness is None:
        return []
    taken = {} if explanation is None else {cause.value: share for cause, share in causes_taken(explanation.evidence)}
    at_seam = [cause for cause in taken if cause in ALONG_THE_SEAM]
    shares = [
        words for cause in _causes_of(row)
        if cause not in at_seam and taken.get(cause, 0) >= _LEAST_TAKEN and (words := loss_words(cause, taken[cause]))
    ]
    if shares:
        if (by_seam := sum(taken[cause] for cause in at_seam)) >= _LEAST_TAKEN:
            shares.append(filled(tr("the seam took {value} %"), value=percent(by_seam)))
        text = tr("In the whole window {left} % of the finest detail is left (sharpness {sharpness} %): {took}.")
        left, sharpness = percent(row.sharpness**2), percent(row.sharpness)
        return [filled(text, left=left, sharpness=sharpness, took=", ".join(shares))]
    if abs(row.sharpness - 1) < _AS_SHARP:
        return [tr("The window is as sharp as its sources."), *_apart_curves(row)]
    text = tr("The whole window has {percent} % of the sharpness of its sources.")
    return [filled(text, percent=percent(row.sharpness))]


def _apart_curves(row: WindowRecord) -> list[str]:
    """Why curves are apart where nothing is lost: they are shares of a contrast that sharpness knows nothing of."""
    is_apart = any(abs(ratio - 1) > _APART for ratio in (row.ratio, row.composite_ratio) if ratio is not None)
    words = tr("Its curve lies apart all the same: curves are shares of all contrast, which tones change, too.")
    return [words] if is_apart else []


def is_same(first: float | None, other: float | None) -> bool:
    """Whether two numbers are one, of which a layer may keep fewer digits."""
    return first == other or (first is not None and other is not None and math.isclose(first, other, rel_tol=_SAME))
