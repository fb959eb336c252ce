"""What a report says of windows: the table of all of them, as table 1 of Pyka 2010, and what its terms mean."""
from __future__ import annotations

from collections.abc import Iterator, Sequence, Set

from ...toolkit.translation import filled, percent, shown_number, tr
from ..measure.window_records import COMPOSITE, SEAM, CurveRecord, WindowRecord
from ..window_summary import judged_words
from ..words import LOSSES, causes_words, observer_word, verdict_colour, verdict_word

_ROLES = ("mosaic", "source", COMPOSITE)


def window_rows(
    record: WindowRecord, curves: Sequence[CurveRecord], levels: int, linked: Set[int]
) -> dict[str, object]:
    """The rows of one window; ``linked`` windows lead to theirs. Shallower curves leave their last levels empty."""
    return {
        "number": record.window_id,
        "anchor": anchor(record.window_id) if record.window_id in linked else "",
        "colour": verdict_colour(record.verdict),
        "found": list(_found(record)),
        "ratios": [*map(two_digits, record.ratios), two_digits(record.background_ratio)],
        "rasters": [_raster_row(curve, levels) for role in _ROLES for curve in curves if curve.role == role],
    }


def anchor(window_id: int) -> str:
    """The name that links to a window's section go to."""
    return f"window-{window_id}"


def two_digits(value: float | None) -> str:
    """A ratio; empty where it is not known."""
    return "" if value is None else shown_number(value)


def paper_words(record: WindowRecord) -> str:
    """What the paper's rule says of a window that was judged by its seam; empty for others."""
    if record.reference != SEAM or not record.paper_verdict:
        return ""
    word = verdict_word(record.paper_verdict)
    if record.ratio is None:
        return filled(tr("by the paper's rule: {verdict}"), verdict=word)
    return filled(tr("by the paper's rule: {verdict}, ratio 1: {ratio:.2f}"), verdict=word, ratio=record.ratio)


def _found(record: WindowRecord) -> Iterator[str]:
    """In some lines, its verdict the first."""
    yield ", ".join([verdict_word(record.verdict), *judged_words(record)])
    if record.reason:
        yield record.reason
    if paper := paper_words(record):
        yield paper
    known = []
    causes = record.causes or record.cause
    if causes and (causes != "none" or record.verdict in LOSSES):
        words = tr("cause: {cause}") if record.verdict in LOSSES else tr("found: {cause}")
        known.append(filled(words, cause=causes_words(causes)))
    if record.verdict in LOSSES and record.visibility is not None:
        known.append(filled(tr("visibility at 2x (JND): {value:.1f}"), value=record.visibility))
    if record.observer:
        known.append(filled(tr("observer: {word}"), word=observer_word(record.observer)))
    if known:
        yield "; ".join(known)


def _raster_row(curve: CurveRecord, levels: int) -> dict[str, object]:
    """The shares of one raster in a window, finest first, then the background."""
    shares = [*map(_share, curve.detail), *[""] * (levels - len(curve.detail)), _share(curve.background)]
    name = tr("hard-cut composite") if curve.role == COMPOSITE else curve.raster
    return {"name": name, "is_mosaic": curve.role == "mosaic", "shares": shares}


def _share(value: float) -> str:
    """Three decimals, as in the paper; two digits where they would all be 0."""
    if value != value:
        return ""
    return shown_number(value, 3) if value >= 0.001 or value == 0 else filled("{value:.1e}", value=value)


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
            "Significant: by the best estimate {percent} % or less of the finest detail is kept along the seam, and "
            "that something is lost is sure; or the whole window is blurred badly. Reduced: "
            "less than all is kept, beyond the error of the measurement. "
            "Preserved: no certain loss."
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
    yield tr("level of detail"), tr("Level 1 is the finest, about 2 px; each further one is twice as coarse.")
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
            "The part of the window where the mosaic lost most of the finest detail, all stretched alike. JPEG takes "
            "a little detail from all of them."
        )
