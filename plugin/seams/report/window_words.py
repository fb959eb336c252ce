"""What a report says of windows in the table of all of them, as table 1 of Pyka 2010."""
from __future__ import annotations

from collections.abc import Iterator, Sequence, Set

from ...toolkit.translation import filled, shown_number, tr
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
        "found": list(_findings(record)),
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


def _findings(record: WindowRecord) -> Iterator[str]:
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
