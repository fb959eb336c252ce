"""What happened to a window, in words: along its seam, in all of it, and what took no detail."""
from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple

from ..toolkit.translation import filled, percent, shown_number, tr
from .cause_words import cause_clause, causes_words, took_words
from .measure.causes import ALONG_THE_SEAM, Cause, causes_taken
from .measure.profile.seam_profile import WIDEST_FEATHER_PX, Measure

if TYPE_CHECKING:
    from .measure.explanation import Explanation
    from .measure.window_records import WindowRecord

_TOLD_BEFORE = ("", Cause.NONE, Cause.MISSING_SOURCE)  # no sentence of their own beside the seam's
_LEAST_WIDTH_M = 0.05  # less is 0.0 m
_LEAST_TAKEN = 0.005  # of the window's finest detail
_MUCH_ADDED = 0.15  # of the detail beside the seam that is not the sources'


class Happening(NamedTuple):
    """What is said of the causes of a window that is judged by its seam."""

    along_the_seam: str
    """What took detail there, to go on a sentence with; empty for nothing."""
    in_the_whole: str
    """A sentence on what took detail all over the window, and how much; empty where that is not known."""
    besides: str
    """A sentence on the rest; empty for none."""


def what_happened(row: WindowRecord, found: Explanation | None) -> Happening:
    """``found``: the explanation behind what the row holds; None where that is not at hand."""
    left = [cause for cause in (row.causes or row.cause).split("; ") if cause not in _TOLD_BEFORE]
    main = left[0] if left else ""
    at_seam = [cause for cause in left if cause in ALONG_THE_SEAM or _is_softened_seam(cause, found)]
    seam = _along_the_seam(at_seam, row, _is_endless(found)) + _mixing_alone(found) if at_seam else ""
    taken = {} if found is None else {cause.value: share for cause, share in causes_taken(found.evidence)}
    took = [
        (cause, words) for cause in left
        if cause not in at_seam and taken.get(cause, 0) >= _LEAST_TAKEN and (words := took_words(cause, taken[cause]))
    ]
    by_seam = sum(taken.get(cause, 0) for cause in at_seam)
    whole = _in_the_whole([words for _, words in took], by_seam, row.sharpness or 0.0) if took else ""
    rest = [cause for cause in left if cause not in at_seam and cause not in [one for one, _ in took]]
    return Happening(seam, whole, _besides(rest, found, main in rest or not (seam or whole)))


def as_sentence(clause: str) -> list[str]:
    """A clause that stands alone."""
    return [f"{clause[:1].upper()}{clause[1:]}."] if clause else []


def by_mixture(found: Explanation | None) -> list[str]:
    """That what is kept was told by the images' mixture alone, and why."""
    profile = None if found is None else found.profile
    if profile is None or profile.measure is not Measure.MIXTURE:
        return []
    if profile.by_energy is None:
        return [tr("This is told by the mixture of the images, as there is too little unmixed ground around.")]
    if profile.added_beside >= _MUCH_ADDED:
        return [tr("This is told by the mixture of the images, as other detail was added along the seam.")]
    return [tr("This is told by the mixture of the images, as the ground around is mixed too.")]


def _in_the_whole(took: list[str], by_seam: float, sharpness: float) -> str:
    """What is left in all of the window and what took the rest, of the energy of detail; sharpness is its root."""
    if by_seam >= _LEAST_TAKEN:
        took = [*took, filled(tr("the seam took {value} %"), value=percent(by_seam))]
    text = tr("In the whole window {left} % of the finest detail is left (sharpness {sharpness} %): {took}.")
    return filled(text, left=percent(sharpness**2), sharpness=percent(sharpness), took=", ".join(took))


def _is_softened_seam(cause: str, found: Explanation | None) -> bool:
    return cause == Cause.BLUR and found is not None and found.evidence.is_smoothed_seam


def _is_endless(found: Explanation | None) -> bool:
    """Whether a feather does not end as far as one is looked for."""
    profile = None if found is None else found.profile
    return profile is not None and (profile.feather_width_px or 0.0) >= WIDEST_FEATHER_PX


def _along_the_seam(causes: list[str], row: WindowRecord, is_endless: bool) -> str:
    """What took detail there; whether images fit is told of those that are mixed."""
    metres = row.feather_width or 0.0
    width = shown_number(metres, 1) if metres >= _LEAST_WIDTH_M else ""
    if width and is_endless:
        width = filled(tr("more than {width}"), width=width)
    apart = shown_number(row.misfit, 1) if Cause.MISREGISTRATION in causes and row.misfit is not None else ""
    if Cause.BLUR in causes:
        text = tr("it is softened along the seam")
    elif Cause.OTHER_MIXTURE in causes:
        text = tr("images are mixed by another rule than weights")
        if width:
            text = tr("images are mixed over {width} m by another rule than weights")
        if apart:
            text = tr("images {apart} px apart are mixed by another rule than weights")
    elif Cause.FEATHERING in causes and apart:
        text = tr("images {apart} px apart are feathered over {width} m") if width else tr(
            "images {apart} px apart are feathered"
        )
        if causes[0] == Cause.MISREGISTRATION:
            text += tr(", and most of that is their misfit")
    elif Cause.FEATHERING in causes:
        text = tr("images are feathered over {width} m") if width else tr("images are feathered")
    else:
        return cause_clause(Cause.MISREGISTRATION, None, False) if not apart else filled(
            tr("images lie {value} px apart where they meet"), value=apart
        )
    return filled(text, width=width, apart=apart)


def _mixing_alone(found: Explanation | None) -> str:
    """What the mixture would leave where the mosaic has less."""
    profile = None if found is None else found.profile
    if profile is None or profile.measure is not Measure.ENERGY or (profile.by_mixture or 0) <= profile.high:
        return ""
    return filled(tr(", where mixing alone would leave {percent} %"), percent=percent(profile.by_mixture or 0))


def _besides(causes: list[str], found: Explanation | None, has_main: bool) -> str:
    """``has_main``: whether the first of them is told in a clause of its own."""
    if not causes:
        return ""
    if not has_main:
        return filled(tr("Besides: {others}."), others=causes_words("; ".join(causes)))
    (main,) = as_sentence(cause_clause(causes[0], found, is_loss=False)) or [""]
    others = causes_words("; ".join(causes[1:]))
    return filled(tr("{cause}; besides: {others}."), cause=main[:-1], others=others) if others else main
