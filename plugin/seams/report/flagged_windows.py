"""The flagged windows of a report: what was found, the curves, and the clips at 2x."""
from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import repeat

from ...imagery.errors import Message
from ...imagery.limits import judged_band
from ...toolkit.translation import filled, formatted, percent, sentence, tr
from ..measure import messages
from ..measure.window_records import COMPOSITE, WindowRecord, contrast_of
from ..window_summary import by_the_paper, window_sentence, window_why
from ..words import LOSSES, cause_sentence, cause_word, observer_word, verdict_word
from .clip_parts import ClipJob, WindowParts, window_parts
from .report_request import ReportRequest
from .window_charts import curve_legend, curves_svg, profile_picture
from .window_words import anchor, paper_words, two_digits

REPORT_CLIPS_BYTES = 16_000_000  # of all JPEG pictures together: with charts and base64 a report stays below 30 MB

CHART_MM = 84.6  # 320 px, as wide as a clip


class WindowSections:
    """Makes the sections of a report's windows one after another."""

    def __init__(self, request: ReportRequest, count: int) -> None:
        """``count``: how many sections there will be, which share the bytes that a report may have."""
        self.notices: list[Message] = []  # what could not be shown
        self._request = request
        self._pixel_m = None if request.block is None else request.block.mosaic.ground_sample_distance
        self._bytes_each = REPORT_CLIPS_BYTES / max(count, 1)

    def sections(self, records: Sequence[WindowRecord]) -> Iterator[dict[str, object]]:
        """What the page shows of each."""
        for record, clips in zip(records, self._clips(records)):
            yield self._section(record, clips)

    def _clips(self, records: Sequence[WindowRecord]) -> Iterator[WindowParts]:
        if self._request.block is None:
            return repeat(WindowParts(), len(records))
        return window_parts(self._request.block, map(self._job, records), self._bytes_each)

    def _job(self, record: WindowRecord) -> ClipJob:
        """The sources that took part, the least sharp in front: even they have more detail than the mosaic."""
        pairs, loss = self._request.pairs.get(record.window_id, ()), self._request.losses.get(record.window_id)
        if pairs:
            band = judged_band(pair.band for pair in pairs)
            judged = [pair for pair in pairs if pair.band == band and pair.source != COMPOSITE]
            judged.sort(key=lambda pair: -(pair.ratio or 0))
            return ClipJob(record.extent, tuple(pair.source for pair in judged), loss)
        curves = self._request.curves.get(record.window_id, ())
        return ClipJob(record.extent, tuple(curve.raster for curve in curves if curve.role == "source"), loss)

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
            "profile": profile_picture(record, request.profiles.get(window, ()), self._pixel_m, request.min_kept),
            "chart": curves_svg(same, request.max_ratio) if same else "",
            "legend": curve_legend(same) if same else (),
            "clips": clips.pictures,
            "place": "" if clips.extent is None else _place_words(clips),
            "loss": clips.loss,
        }

    def _facts(self, record: WindowRecord) -> Iterator[str]:
        """What was found, what its main cause means, and what else is known, in words."""
        pixel_m = self._pixel_m
        yield " ".join([window_sentence(record, pixel_m=pixel_m), *window_why(record, pixel_m=pixel_m)])
        facts = []
        if record.cause and record.cause != "none":
            words = tr("Found: {cause}.")
            if record.verdict in LOSSES:
                words = tr("Main cause in the whole window: {cause}.")
            facts += [filled(words, cause=cause_word(record.cause)), cause_sentence(record.cause)]
        facts += [filled(tr("Observer: {word}."), word=observer_word(record.observer) or tr("not judged"))]
        paper = paper_words(record)
        if paper and not by_the_paper(record):
            facts.append(f"{paper[:1].upper()}{paper[1:]}.")
        contrast = record.contrast
        if contrast is None:
            contrast = contrast_of(self._request.pairs.get(record.window_id, ()))
        if contrast is not None:
            facts.append(filled(tr("Absolute contrast at level 1: {percent} %."), percent=percent(contrast)))
        if record.unclear_share is not None:
            words = tr("Pixels where no source wins clearly: {percent} %.")
            facts.append(filled(words, percent=percent(record.unclear_share)))
        yield " ".join(filter(None, facts))


def _ratios(record: WindowRecord) -> tuple[list[int], list[list[str]]]:
    """The levels, and a row for each ratio that is known: against what, by level, that of the background."""
    rows = [
        (_kept_heading(record), record.kept, None),
        (tr("against the sources"), record.ratios, record.background_ratio),
        (tr("against the hard-cut composite"), record.composite_ratios, None),
        (tr("expected of a 50:50 feather"), record.expected_ratios, None),
    ]
    known = [row for row in rows if any(value is not None for value in row[1])]
    levels = max((len(row[1]) for row in known), default=0)
    return list(range(1, levels + 1)), [
        [name, *map(two_digits, values), *[""] * (levels - len(values)), two_digits(background)]
        for name, values, background in known
    ]


def _kept_heading(record: WindowRecord) -> str:
    if record.kept_low is None or record.kept_high is None:
        return tr("kept along the seam")
    text = tr("kept along the seam (level 1: {low:.2f} to {high:.2f})")
    return filled(text, low=record.kept_low, high=record.kept_high)


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
