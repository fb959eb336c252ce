"""The words of a report of an inspection and what they mean, those that stand in it."""
from __future__ import annotations

from collections.abc import Iterator, Sequence, Set

from ...toolkit.translation import filled, percent, tr
from ..measure.window_records import SEAM, WindowRecord


def reading_terms(
    records: Sequence[WindowRecord], min_kept: float, max_ratio: float, shown: Set[str]
) -> Iterator[tuple[str, str]]:
    """Term and meaning, in the order in which a reader meets them.

    ``shown``: which of ``curves``, ``profiles`` and ``clips`` the report has.
    """
    by_seam = any(one.reference == SEAM for one in records)
    yield tr("flagged"), tr("Has a significant loss, or one that the observer saw.")
    if by_seam:
        words = tr(
            "Significant: {percent} % or less of the finest detail is kept along the seam, or the whole window is "
            "blurred badly. Reduced: surely less than all is kept. Preserved: no loss is sure."
        )
        yield tr("verdict"), filled(words, percent=percent(min_kept))
    words = tr(
        "Looks at ratio 1 in whole windows. Significant: {limit:.2f} or less. Reduced: below 1. Preserved: 1 or more."
    )
    yield tr("the paper's rule"), filled(words, limit=max_ratio)
    yield tr("observer"), tr("What the operator saw at 2x magnification.")
    yield tr("kept 1"), tr(
        "The share of the sources' finest detail that is left in the strip along the seam, relative to the ground "
        "around it, so that what was done to the whole mosaic does not count; in brackets its 95 % interval. 0.5 is "
        "what is left where two images that have nothing in common were averaged."
    )
    if any(one.visibility is not None for one in records):
        yield tr("visibility at 2x (JND)"), tr(
            "How many times more of the detail along the seam was lost than an eye just sees side by side at 2x: just "
            "noticeable differences of contrast, by the sensitivity of the eye to the size and contrast of the detail."
        )
    if any(one.sharpness is not None for one in records):
        yield tr("sharpness 1"), tr(
            "The contrast of the finest detail in the whole window, 1 for that of its sources in the mosaic's tones."
        )
    yield tr("ratio 1"), tr(
        "The mosaic's relative variance at level 1 divided by a source's; a window's is the largest over its sources."
    )
    yield tr("relative variance"), tr(
        "The share of a clip's variance that lies in the details of each level, and in the background that is left "
        "(wavelet decomposition; Pyka 2010)."
    )
    yield tr("level of detail"), tr("Level 1 is the finest, of some 2 px; each further one is twice as coarse.")
    if "curves" in shown:
        yield tr("hard-cut composite"), tr(
            "What the mosaic would be if its sources had been cut along the seam and nothing were mixed."
        )
    if any(value is not None for one in records for value in one.expected_ratios):
        yield tr("expected of a 50:50 feather"), tr(
            "What would be left of the sources' detail if the two were averaged."
        )
    if "profiles" in shown:
        yield tr("seam profile"), tr(
            "The share of the detail that is kept by distance from the seam, with its 95 % interval; where level 1 "
            "drops below the dashed line, the loss is significant. The dotted line is the share of the image beyond "
            "the seam in the mixture of the two."
        )
    if "clips" in shown:
        yield tr("lost detail"), tr(
            "The colours say how much of the finest detail is kept, relative to the ground around; ground without a "
            "colour is even."
        )
        yield tr("clips"), tr(
            "The part of the window where the mosaic lost most of the finest detail, all stretched alike. JPEG takes a "
            "little of it from all of them."
        )
