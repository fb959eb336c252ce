"""The report of an inspection as one HTML page, with a sketch of the map: plain data in, a file out.

It reads pixels and draws charts, so it belongs into a worker; no layer and no widget is touched.
"""
from __future__ import annotations

import math
import statistics
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

from ...imagery import messages as imagery_messages
from ...imagery.clips import read_overview
from ...imagery.errors import CancelledError, Message, RasterError
from ...imagery.grids import Extent, middle_of
from ...imagery.reference_systems import metres_per_unit
from ...imagery.statistics import INVISIBLE, UNSURE, VISIBLE
from ...toolkit.background_tasks import Cancelled, Job
from ...toolkit.charts.round_ticks import round_below
from ...toolkit.pages.picture_files import encoded
from ...toolkit.pages.templates import HowMeasured, each_raster, measured_raster, save_page, sentences_once
from ...toolkit.translation import filled, formatted, percent, shown_number, tr
from ..clip_pictures import bytes_picture
from ..measure import limits, messages
from ..measure.window_records import SEAM, WindowRecord
from ..window_summary import judged_words
from ..words import VERDICTS, cause_sentence, cause_word, loss_legend, verdict_colour, verdict_word
from .flagged_windows import CHART_MM, WindowSections, anchor, window_rows
from .report_request import ReportRequest

_WIDTH, _HEIGHT, _STRIP = 170.0, 90.0, 11.0  # mm: the map at most, below the summary, and what stands below it
_NARROWEST = 60.0  # mm: room for the scale bar
_MARGIN = 0.06  # of the longer side, around all shapes
_SMALLEST = 1.6  # mm: a shape's side, so that it is seen
_LETTERS = 3.0  # mm high
_CROWDED = 4.0  # mm: labels nearer to each other than that are left out

Box = tuple[float, float, float, float]
"""Left, top, width and height, mm."""


@dataclass(frozen=True)
class SketchShape:
    """A rectangle on the map."""

    extent: Extent  # map units
    colour: str
    label: str  # written beside it where there is room
    tip: str  # said when the pointer rests on it
    anchor: str = ""  # where a click leads in the page; empty for nowhere


@dataclass(frozen=True)
class SketchBackground:
    """A picture below the shapes."""

    jpeg: bytes
    extent: Extent  # map units


@dataclass(frozen=True)
class Sketch:
    """What is drawn where."""

    width: float
    height: float  # height of the map
    strip: float  # height of what stands below the map
    letters: float
    background: tuple[Box, bytes] | None
    shapes: Sequence[tuple[Box, SketchShape]]
    labels: Sequence[tuple[float, float, str]]  # middle of the foot of each
    bar: float  # length of the scale bar
    bar_words: str


def sketch_extent(shapes: Sequence[SketchShape], metres_x: float = 1.0, metres_y: float = 1.0) -> Extent:
    """What the sketch shows: all shapes, and a margin around them that is equally wide on the ground."""
    xs = [x for shape in shapes for x in (shape.extent[0], shape.extent[2])]
    ys = [y for shape in shapes for y in (shape.extent[1], shape.extent[3])]
    margin = _MARGIN * max((max(xs) - min(xs)) * metres_x, (max(ys) - min(ys)) * metres_y)
    x, y = margin / metres_x, margin / metres_y
    return min(xs) - x, min(ys) - y, max(xs) + x, max(ys) + y


def map_sketch(
    shapes: Sequence[SketchShape],
    metres_x: float = 1.0,
    metres_y: float = 1.0,
    background: SketchBackground | None = None,
) -> Sketch:
    """The sketch of one shape or more; later shapes lie above earlier ones, and are labelled first.

    ``metres_x``, ``metres_y``: metres on the ground per map unit.
    """
    frame = _Frame(sketch_extent(shapes, metres_x, metres_y), metres_x, metres_y)
    placed = [(_seen_box(frame, shape), shape) for shape in shapes]
    bar, words = _scale_bar(frame)
    picture = None if background is None else (frame.box(background.extent), background.jpeg)
    return Sketch(frame.width, frame.height, _STRIP, _LETTERS, picture, placed, _labels(placed), bar, words)


class _Frame:
    """From map units to millimetres on paper."""

    def __init__(self, extent: Extent, metres_x: float, metres_y: float) -> None:
        across, down = (extent[2] - extent[0]) * metres_x, (extent[3] - extent[1]) * metres_y
        self.metres_per_mm = max(across / _WIDTH, down / _HEIGHT, 1e-9)
        self._x, self._y = metres_x / self.metres_per_mm, metres_y / self.metres_per_mm
        self.width, self.height = max(across / self.metres_per_mm, _NARROWEST), down / self.metres_per_mm
        self._left = extent[0] - (self.width - across / self.metres_per_mm) / 2 / self._x
        self._top = extent[3]

    def box(self, extent: Extent) -> Box:
        left, top = (extent[0] - self._left) * self._x, (self._top - extent[3]) * self._y
        return left, top, (extent[2] - extent[0]) * self._x, (extent[3] - extent[1]) * self._y


def _seen_box(frame: _Frame, shape: SketchShape) -> Box:
    """Not smaller than can be seen."""
    x, y, width, height = frame.box(shape.extent)
    wider, higher = max(_SMALLEST - width, 0), max(_SMALLEST - height, 0)
    return x - wider / 2, y - higher / 2, width + wider, height + higher


def _labels(placed: Sequence[tuple[Box, SketchShape]]) -> list[tuple[float, float, str]]:
    """The labels there is room for, the last shape's first."""
    taken: list[tuple[float, float, str]] = []
    for (x, y, width, height), shape in reversed(placed):
        across, down = x + width / 2, y + height / 2 + 0.36 * _LETTERS
        reach = max(_CROWDED, 0.65 * _LETTERS * len(shape.label))
        if all(abs(across - a) > reach or abs(down - b) > _LETTERS for a, b, _ in taken):
            taken.append((across, down, shape.label))
    return taken


def _scale_bar(frame: _Frame) -> tuple[float, str]:
    """A round length of about a quarter of the width, and its words."""
    metres = round_below(0.3 * frame.width * frame.metres_per_mm)
    words = formatted(metres / 1000, "g") + " km" if metres >= 1000 else formatted(metres, "g") + " m"
    return metres / frame.metres_per_mm, words


MAX_REPORT_DETAILS = 300  # flagged windows with curves and clips; the others stand in the table
OVERVIEW_SIDE_PX = 900  # of the sketch's background, 170 mm wide

Progress = Callable[[float], None]


def write_report(
    path: Path, request: ReportRequest, progress: Progress = lambda share: None, cancelled: Callable[[], bool] = bool
) -> list[Message] | None:
    """Write the page; returns what it could not show, or None when it was cancelled and there is no page.

    ``progress`` is told the share that is done, 0 to 1. Raises SettingsError where no file can be written.
    """
    notices: list[Message] = []
    flagged = flagged_windows(request.records)
    detailed = _detailed(flagged)
    linked = {record.window_id for record in detailed}
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
            title=request.title or _mosaics_title(request),
            count=len(request.records),
            flagged=len(flagged),
            notices=sentences_once(notices),
            **_summary(request),
            **_map(request, linked),
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
        "profiles": bool(request.profiles), "clips": request.block is not None,
        "seam": any(record.reference == SEAM for record in records),
        "visibility": any(record.visibility is not None for record in records),
        "sharpness": any(record.sharpness is not None for record in records),
        "expected": any(value is not None for record in records for value in record.expected_ratios),
    }


def flagged_windows(records: Iterable[WindowRecord]) -> list[WindowRecord]:
    """Windows with a significant loss, and those where the observer saw one."""
    return [record for record in records if record.verdict == "significant" or record.observer == "visible"]


def _detailed(flagged: Sequence[WindowRecord]) -> list[WindowRecord]:
    """Windows that a report shows in detail, as many as it can, the greatest loss first."""
    return sorted(flagged, key=lambda record: (-(record.loss or 0.0), record.window_id))[:MAX_REPORT_DETAILS]


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


def _mosaics_title(request: ReportRequest) -> str:
    names = [name for name in _by_mosaic(request) if name]
    return filled(tr("Seam inspection: {names}"), names=", ".join(names)) if names else tr("Seam inspection")


def _summary(request: ReportRequest) -> dict[str, object]:
    """Verdicts, observer's words and ratios of each mosaic, and its causes."""
    verdicts = [verdict for verdict in VERDICTS if verdict or any(not record.verdict for record in request.records)]
    main = Counter((_mosaic_of(request, record), record.cause) for record in request.records if record.cause)
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


# The map


def _map(request: ReportRequest, detailed: set[int]) -> dict[str, object]:
    """The sketch and its legend."""
    order = list(VERDICTS)[::-1]
    known = [record for record in request.records if record.extent is not None]
    known.sort(key=lambda row: (order.index(row.verdict) if row.verdict in order else 0, row.window_id in detailed))
    if not known:
        return {"sketch": None}
    shapes = [_shape(record, record.window_id in detailed) for record in known]
    metres = metres_per_unit(request.wkt, middle_of(shapes[0].extent))
    if not all(0 < metre < math.inf for metre in metres):
        metres = 1.0, 1.0  # a system whose units have no length: drawn as the map shows it
    counts = Counter(record.verdict for record in known)
    return {
        "sketch": map_sketch(shapes, *metres, background=_background(request, shapes, metres)),
        "map_legend": [
            (verdict_colour(word), f"{verdict_word(word)} ({counts[word]})") for word in VERDICTS if counts[word]
        ],
    }


def _shape(record: WindowRecord, detailed: bool) -> SketchShape:
    assert record.extent is not None
    tip = filled(tr("window {number}: {verdict}"), number=record.window_id, verdict=verdict_word(record.verdict))
    tip = ", ".join([tip, *judged_words(record)])
    link = anchor(record.window_id) if detailed else ""
    return SketchShape(record.extent, verdict_colour(record.verdict), str(record.window_id), tip, link)


def _background(
    request: ReportRequest, shapes: Sequence[SketchShape], metres: tuple[float, float]
) -> SketchBackground | None:
    if request.block is None:
        return None
    extent = sketch_extent(shapes, *metres)
    with suppress(RasterError):  # then the sketch stands on plain paper
        overview = read_overview(request.block.mosaic, extent, OVERVIEW_SIDE_PX)
        if overview is not None:
            block, place = overview
            pixels = bytes_picture(block.bands, request.block.mosaic.has_luminance, block.valid)
            return SketchBackground(encoded(pixels, "JPEG"), place)
    return None
