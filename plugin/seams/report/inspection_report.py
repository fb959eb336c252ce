"""The report of an inspection as one HTML page, with a map: plain data in, a file out.

It reads pixels and draws charts, so it belongs into a worker; no layer and no widget is touched.
"""
from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Callable

from ...imagery import messages as imagery_messages
from ...imagery.errors import CancelledError, Message
from ...imagery.statistics import INVISIBLE, UNSURE, VISIBLE
from ...toolkit.background_tasks import Cancelled, Job
from ...toolkit.pages.templates import HowMeasured, each_raster, measured_raster, save_page, sentences_once
from ...toolkit.translation import percent, shown_number, tr
from ..measure import limits, messages
from ..measure.window_records import SEAM, WindowRecord
from ..words import VERDICTS, cause_sentence, cause_word, loss_legend, verdict_colour, verdict_word
from .flagged_windows import CHART_MM, WindowSections, window_rows
from .report_request import ReportRequest
from .window_map import MAP_PX, window_map

MAX_REPORT_DETAILS = 300  # flagged windows with curves and clips; the others stand in the table

Progress = Callable[[float], None]


def write_report(
    path: Path, request: ReportRequest, progress: Progress = lambda share: None, cancelled: Callable[[], bool] = bool
) -> list[Message] | None:
    """Write the page; returns what it could not show, or None when it was cancelled and there is no page.

    ``progress`` is told the share that is done, 0 to 1. Raises SettingsError where no file can be written.
    """
    notices: list[Message] = []
    flagged = flagged_windows(request.records)
    detailed = sorted(flagged, key=lambda record: (-(record.loss or 0.0), record.window_id))[:MAX_REPORT_DETAILS]
    linked = {record.window_id for record in detailed}
    names = ", ".join(filter(None, _by_mosaic(request)))
    if len(detailed) < len(flagged):
        notices.append(messages.DETAILS_LIMITED(count=len(flagged), most=len(detailed)))
    sections = WindowSections(request)

    def shown() -> Iterator[dict[str, object]]:
        for done, section in enumerate(sections.sections(detailed), 1):
            if cancelled():
                raise CancelledError(imagery_messages.CANCELLED())
            yield section
            progress(done / len(detailed))

    levels = max((len(curve.detail) for rows in request.curves.values() for curve in rows), default=0)
    try:
        save_page(
            path,
            "inspection",
            _how_measured(request),
            title=request.title or ": ".join(filter(None, (tr("Seam inspection"), names))),
            count=len(request.records),
            flagged=len(flagged),
            notices=sentences_once(notices),
            **_summary(request),
            **_map(request),
            has=_shown(request),
            levels=levels,
            ratio_levels=max((len(record.ratios) for record in request.records), default=0),
            windows=(
                window_rows(row, request.curves.get(row.window_id, ()), levels, linked) for row in request.records
            ),
            sections=shown(),
            magnification=limits.JUDGED_MAGNIFICATION,
            chart_mm=CHART_MM,
            loss_legend=[(f"rgb{colour[:3]}", words) for words, colour in loss_legend()],
        )
    except CancelledError:
        return None
    return notices + sections.notices


def report_job(path: Path, request: ReportRequest) -> Job:
    """Writes the report; yields the messages about what it could not show."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        notices = write_report(path, request, cancelled=cancelled)
        if notices is not None:
            yield 1.0, notices

    return job


def _shown(request: ReportRequest) -> dict[str, object]:
    """What there is in this report, by whose words it is read."""
    records = request.records
    return {
        "percent": percent(request.min_kept), "limit": request.max_ratio, "curves": bool(request.curves),
        "profiles": any((*request.profiles.values(), *(result.profile for result in request.results.values()))),
        "clips": request.block is not None,
        "seam": any(record.reference == SEAM for record in records),
        "visibility": any(record.visibility is not None for record in records),
        "sharpness": any(record.sharpness is not None for record in records),
        "expected": any(value is not None for record in records for value in record.expected_ratios),
    }


def flagged_windows(records: Iterable[WindowRecord]) -> list[WindowRecord]:
    """Windows with a significant loss, and those where the observer saw one."""
    return [record for record in records if record.verdict == "significant" or record.observer == "visible"]


def _how_measured(request: ReportRequest) -> HowMeasured:
    settings = [
        (tr("least share kept along the seam"), shown_number(request.min_kept)),
        (tr("limit of the paper's rule, ratio 1"), shown_number(request.max_ratio)),
    ]
    if request.block is None:
        return HowMeasured(settings, made_on=request.made_on)
    sources = each_raster(tr("orthoimage"), (source.ref for source in request.block.sources))
    return HowMeasured(settings, [measured_raster(tr("mosaic"), request.block.mosaic), *sources], request.made_on)


# The page's head


def _mosaic_of(request: ReportRequest, record: WindowRecord) -> str:
    """The mosaic that a window belongs to."""
    names = (curve.raster for curve in request.curves.get(record.window_id, ()) if curve.role == "mosaic")
    return next(names, "") or (request.block.mosaic.ref.name if request.block else request.name)


def _by_mosaic(request: ReportRequest) -> dict[str, list[WindowRecord]]:
    by_mosaic: dict[str, list[WindowRecord]] = {}
    for record in request.records:
        by_mosaic.setdefault(_mosaic_of(request, record), []).append(record)
    return by_mosaic


def _summary(request: ReportRequest) -> dict[str, object]:
    """Verdicts, observer's words and ratios of each mosaic, and its causes."""
    verdicts = [verdict for verdict in VERDICTS if verdict or any(not record.verdict for record in request.records)]
    main = Counter((_mosaic_of(request, record), record.cause) for record in request.records)
    causes = Counter(_parts(request, request.records))
    flagged = Counter(_parts(request, flagged_windows(request.records)))
    ordered = sorted(causes.items(), key=lambda item: (item[0][0], -main[item[0]], -item[1], item[0][1]))
    return {
        "verdicts": [verdict_word(verdict) for verdict in verdicts],
        "mosaics": [(mosaic, _counts(records, verdicts)) for mosaic, records in _by_mosaic(request).items()],
        "causes": [
            (mosaic, cause_word(cause), cause_sentence(cause), (main[mosaic, cause], count, flagged[mosaic, cause]))
            for (mosaic, cause), count in ordered
        ],
    }


def _parts(request: ReportRequest, records: Iterable[WindowRecord]) -> Iterator[tuple[str, str]]:
    """The mosaic and each cause that took part, window by window."""
    for record in records:
        for cause in (record.causes or record.cause).split("; "):
            if cause and cause != "none":
                yield _mosaic_of(request, record), cause


def _counts(records: Sequence[WindowRecord], verdicts: Sequence[str]) -> list[object]:
    """Windows, those of each verdict and of each of the observer's words, their median kept_1 and ratio."""
    counts = Counter(record.verdict for record in records)
    seen = Counter(record.observer for record in records)
    words = (seen[word] for word in (VISIBLE, INVISIBLE, UNSURE))
    medians = [_median(record.kept_1 for record in records), _median(record.ratio for record in records)]
    return [len(records), *(counts[verdict] for verdict in verdicts), *words, *medians]


def _median(values: Iterable[float | None]) -> str:
    known = [value for value in values if value is not None]
    return shown_number(statistics.median(known)) if known else ""


def _map(request: ReportRequest) -> dict[str, object]:
    """The windows over their mosaic, and the legend."""
    mosaic = None if request.block is None else request.block.mosaic
    counts = Counter(record.verdict for record in request.records if record.extent is not None)
    legend = [(verdict_colour(word), f"{verdict_word(word)} ({counts[word]})") for word in VERDICTS if counts[word]]
    return {"map": window_map(request.records, request.wkt, mosaic), "map_px": MAP_PX, "map_legend": legend}
