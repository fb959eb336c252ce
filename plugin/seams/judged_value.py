"""What the verdict on a window was taken by: a number that orders windows by their loss, and the words of each."""
from __future__ import annotations

from typing import TYPE_CHECKING

from ..imagery.limits import MAX_SIGNIFICANT_RATIO
from ..toolkit.translation import filled, tr
from .measure.limits import MAX_SIGNIFICANT_KEPT, MAX_SIGNIFICANT_SHARPNESS_SQUARED
from .measure.window_records import COMPOSITE, SEAM

if TYPE_CHECKING:
    from .measure.window_records import WindowRecord


def judged_value(row: WindowRecord) -> float | None:
    """Relative to the standard limit of a significant loss, so the smaller the worse; None where there is none.

    By the seam, the lesser of what is kept along it and of the sharpness of the whole.
    """
    if row.reference == SEAM:
        kept = None if row.kept_1 is None else row.kept_1 / MAX_SIGNIFICANT_KEPT
        sharpness = None if row.sharpness is None else row.sharpness**2 / MAX_SIGNIFICANT_SHARPNESS_SQUARED
        return min((value for value in (kept, sharpness) if value is not None), default=None)
    ratio = row.composite_ratio if row.reference == COMPOSITE else row.ratio
    return None if ratio is None else ratio / MAX_SIGNIFICANT_RATIO


def judged_kept(row: WindowRecord) -> float | None:
    """kept_1 where the verdict was taken by it; None where the sharpness of the whole told the loss."""
    if row.reference != SEAM or row.kept_1 is None or row.kept_high is None:
        return None
    sharpness_squared = 1.0 if row.sharpness is None else row.sharpness**2
    by_sharpness = {
        "significant": row.kept_high >= 1 or sharpness_squared <= MAX_SIGNIFICANT_SHARPNESS_SQUARED,
        "reduced": row.kept_high >= 1,
        "preserved": False,
    }
    return None if by_sharpness.get(row.verdict, True) else row.kept_1


def judged_words(row: WindowRecord) -> list[str]:
    """Each number that the verdict looks at; empty where nothing was measured."""
    if row.reference == SEAM:
        return [*_kept_words(row), *_number_words(tr("sharpness 1: {value:.2f}"), row.sharpness)]
    composite = _number_words(tr("composite: {value:.2f}"), row.composite_ratio)
    return [*_number_words(tr("ratio 1: {value:.2f}"), row.ratio), *composite]


def _kept_words(row: WindowRecord) -> list[str]:
    if row.kept_1 is None:
        return []
    if row.kept_low is None or row.kept_high is None:
        return _number_words(tr("kept 1: {value:.2f}"), row.kept_1)
    text = tr("kept 1: {value:.2f} ({low:.2f} to {high:.2f})")
    return [filled(text, value=row.kept_1, low=row.kept_low, high=row.kept_high)]


def _number_words(text: str, value: float | None) -> list[str]:
    return [] if value is None else [filled(text, value=value)]
