"""The flagged windows of a report: what was found, the curves, and the clips at 2x."""
from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence, Set
from dataclasses import dataclass
from itertools import repeat

from markupsafe import Markup
from qgis.PyQt.QtCore import QRectF

from ...imagery.errors import Message
from ...imagery.limits import MAX_SIGNIFICANT_RATIO, judged_band
from ...toolkit.charts.chart_painter import chart_svg, paper_font
from ...toolkit.charts.chart_style import PAPER
from ...toolkit.translation import filled, formatted, sentence, shown_number, tr
from ..charts.curves_painter import Chart, ChartCurve, CurvesPainter, curve_look, numbered
from ..charts.profile_painter import ProfilePainter, ShownProfile, level_colour, shown_profile
from ..measure import messages
from ..measure.limits import MAX_SIGNIFICANT_KEPT
from ..measure.window_records import COMPOSITE, SEAM, CurveRecord, WindowRecord
from ..window_summary import judged_words, loss_place, painted_width_m, two_digits, window_sentence, window_why
from ..words import LOSSES, cause_sentence, cause_word, causes_words, observer_word, verdict_colour, verdict_word
from .clip_parts import ClipJob, WindowParts, window_parts
from .report_request import ReportRequest

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
        "ratios": [two_digits(ratio, MAX_SIGNIFICANT_RATIO) for ratio in (*record.ratios, record.background_ratio)],
        "rasters": [_raster_row(curve, levels) for role in _ROLES for curve in curves if curve.role == role],
    }


def anchor(window_id: int) -> str:
    """The name that links to a window's section go to."""
    return f"window-{window_id}"


def paper_words(record: WindowRecord) -> str:
    """What the paper's rule says of a window that was judged by its seam; empty for others."""
    if record.reference != SEAM or not record.paper_verdict:
        return ""
    word = verdict_word(record.paper_verdict)
    if record.ratio is None:
        return filled(tr("by the paper's rule: {verdict}"), verdict=word)
    ratio = two_digits(record.ratio, MAX_SIGNIFICANT_RATIO)
    return filled(tr("by the paper's rule: {verdict}, ratio 1: {ratio}"), verdict=word, ratio=ratio)


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


CHART_MM = 84.6  # 320 px, as wide as a clip


class WindowSections:
    """Makes the sections of a report's windows one after another."""

    def __init__(self, request: ReportRequest) -> None:
        self.notices: list[Message] = []  # what could not be shown
        self._request = request
        self._pixel_m = None if request.block is None else request.block.mosaic.ground_sample_distance

    def sections(self, records: Sequence[WindowRecord]) -> Iterator[dict[str, object]]:
        """What the page shows of each."""
        for record, clips in zip(records, self._clips(records)):
            yield self._section(record, clips)

    def _clips(self, records: Sequence[WindowRecord]) -> Iterator[WindowParts]:
        if self._request.block is None:
            return repeat(WindowParts(), len(records))
        return window_parts(self._request.block, map(self._job, records))

    def _job(self, record: WindowRecord) -> ClipJob:
        """The sources that took part, the least sharp in front: even they have more detail than the mosaic."""
        request, window = self._request, record.window_id
        pairs, result = request.pairs.get(window, ()), request.results.get(window)
        names = [curve.raster for curve in request.curves.get(window, ()) if curve.role == "source"]
        if pairs:
            band = judged_band(pair.band for pair in pairs)
            judged = [pair for pair in pairs if pair.band == band and pair.source != COMPOSITE]
            names = [pair.source for pair in sorted(judged, key=lambda pair: -(pair.ratio or 0))]
        loss = None if result is None else result.loss
        return ClipJob(
            record.extent, tuple(names), loss, painted_width_m(record, result), loss_place(record).is_decisive
        )

    def _section(self, record: WindowRecord, clips: WindowParts) -> dict[str, object]:
        request, window = self._request, record.window_id
        problem = ""
        if clips.problem is not None:
            notice = messages.CLIP_NOT_SHOWN(window=window, why=clips.problem)
            self.notices.append(notice)
            problem = sentence(notice)
        curves = request.curves.get(window, ())
        has_curve = any(curve.detail[0] == curve.detail[0] for curve in curves if curve.role == "mosaic")
        same = [curve for curve in curves if len(curve.detail) == len(curves[0].detail)] if has_curve else []
        levels, ratios = _ratios(record)
        return {
            "number": window,
            "anchor": anchor(window),
            "title": filled(tr("Window {number}: {verdict}"), number=window, verdict=verdict_word(record.verdict)),
            "facts": list(self._facts(record)),
            "levels": levels,
            "ratios": ratios,
            "problem": problem,
            "profile": profile_picture(self._profile(record)),
            "chart": curves_svg(same, request.max_ratio) if same else "",
            "legend": curve_legend(same) if same else (),
            "clips": clips.pictures,
            "place": "" if clips.extent is None else _place_words(clips),
            "loss": clips.loss,
        }

    def _profile(self, record: WindowRecord) -> ShownProfile | None:
        """The profile that was measured, where that is known, else that of the rows of the table."""
        request, result = self._request, self._request.results.get(record.window_id)
        if result is None or result.profile is None:
            return shown_profile(record, request.profiles.get(record.window_id, ()), self._pixel_m, request.min_kept)
        levels = frozenset(bin_.level for bin_ in result.profile.bins)
        pixel_m = result.ground_sample_distance
        return ShownProfile(result.profile, pixel_m, request.min_kept, levels, result.ground_left)

    def _facts(self, record: WindowRecord) -> Iterator[str]:
        """What was found, what its main cause means, and what else is known, in words."""
        known = record, self._request.results.get(record.window_id), self._pixel_m
        yield " ".join([window_sentence(*known), *window_why(*known)])
        facts = []
        if (cause := record.cause) and cause != "none":
            words = tr("Main cause: {cause}.") if record.verdict in LOSSES else tr("Found: {cause}.")
            facts += [filled(words, cause=cause_word(cause)), cause_sentence(cause)]
        facts += [filled(tr("Observer: {word}."), word=observer_word(record.observer) or tr("not judged"))]
        if paper := paper_words(record):
            facts.append(f"{paper[:1].upper()}{paper[1:]}.")
        yield " ".join(filter(None, facts))


def _ratios(record: WindowRecord) -> tuple[list[int], list[list[str]]]:
    """The levels, and a row for each ratio that is known: against what, by level, that of the background."""
    rows = [
        (tr("kept along the seam"), record.kept, None, MAX_SIGNIFICANT_KEPT),
        (tr("against the sources"), record.ratios, record.background_ratio, MAX_SIGNIFICANT_RATIO),
        (tr("against the hard-cut composite"), record.composite_ratios, None, MAX_SIGNIFICANT_RATIO),
        (tr("expected of a 50:50 feather"), record.expected_ratios, None, MAX_SIGNIFICANT_RATIO),
    ]
    known = [row for row in rows if any(value is not None for value in row[1])]
    levels = max((len(row[1]) for row in known), default=0)
    return list(range(1, levels + 1)), [
        [name, *(two_digits(value, limit) for value in values), *[""] * (levels - len(values)), two_digits(background)]
        for name, values, background, limit in known
    ]


def _place_words(clips: WindowParts) -> str:
    assert clips.extent is not None
    xmin, ymin, xmax, ymax = clips.extent
    side = clips.pictures[0].columns
    digits = max(0, 1 - math.floor(math.log10((xmax - xmin) / side)))  # to a tenth of a pixel
    words = filled(tr("clips of {side} px a side around x {x}, y {y}, at 2x on the screen."),
        side=side, x=formatted((xmin + xmax) / 2, f".{digits}f"), y=formatted((ymin + ymax) / 2, f".{digits}f")
    )
    if clips.left_out:
        words += " " + filled(tr("Sources that are not shown: {count}."), count=clips.left_out)
    return words


CURVES_PX = 320, 260
"""Width and height of a chart of curves: as wide as a clip."""
PROFILE_PX = 470, 250
_CURVES_LETTERS_PX = 10.7  # 8 points
_PROFILE_LETTERS_PX = 11


def curves_svg(curves: Sequence[CurveRecord], max_ratio: float) -> str:
    """The curves, the composite dashed; all of the same number of levels."""
    shown = Chart(_chart_curves(curves), max_ratio)
    chart = CurvesPainter(shown, QRectF(0, 0, *CURVES_PX), PAPER, paper_font(_CURVES_LETTERS_PX))
    return chart_svg(chart.paint, *CURVES_PX)


def curve_legend(curves: Sequence[CurveRecord]) -> list[tuple[str, str]]:
    """Colours and names of the curves as ``curves_svg`` paints them."""
    entries = []
    for number, curve in numbered(_chart_curves(curves)):
        name = filled(tr("{name} (mosaic, bold)"), name=curve.label) if curve.is_mosaic else curve.label
        name = tr("hard-cut composite (dashed)") if curve.is_composite else name
        entries.append((curve_look(curve, number, PAPER)[0], name))
    return [*entries, (PAPER.limit, tr("significant by the paper's rule below"))]


def _chart_curves(curves: Sequence[CurveRecord]) -> tuple[ChartCurve, ...]:
    return tuple(
        ChartCurve(
            curve.raster, curve.role == "mosaic", curve.detail, curve.background, is_composite=curve.role == COMPOSITE
        )
        for curve in curves
    )


@dataclass(frozen=True)
class ProfilePicture:
    """The chart, and what its lines are."""

    svg: Markup  # part of the page, so that its words can be found; it has no ids
    legend: Sequence[tuple[str, str]]  # colours and names of the levels


def profile_picture(shown: ShownProfile | None) -> ProfilePicture | None:
    """The chart of a window's profile, all levels; None where nothing was measured."""
    if shown is None:
        return None
    chart = ProfilePainter(shown, QRectF(0, 0, *PROFILE_PX), PAPER, paper_font(_PROFILE_LETTERS_PX))
    svg = chart_svg(chart.paint, *PROFILE_PX)
    as_wide_as_its_room = re.sub(r' (width|height)="[\d.]+mm"', "", svg[svg.index("<svg") :])
    names = [(level_colour(level, PAPER), filled(tr("level {number}"), number=level)) for level in sorted(shown.levels)]
    return ProfilePicture(Markup(as_wide_as_its_room), names)
