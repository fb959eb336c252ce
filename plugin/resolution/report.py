"""The ground resolved distance of a target as one HTML page."""
from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..imagery.grids import PixelWindow
from ..imagery.open_raster import OpenRaster
from ..imagery.rasters import Raster
from ..toolkit.charts.chart_style import band_colour
from ..toolkit.charts.figure_files import new_figure, svg_text
from ..toolkit.pages.templates import HowMeasured, measured_raster, save_page, sentences_once
from ..toolkit.translation import band_title, filled, percent, sentence, shown_number, tr
from .charts import VERDICT_COLOURS, lines_of, profile_rows, verdict_of, verdict_word
from .distance_words import direction_title, distance_number, distance_text, target_distances
from .measure.bar_groups import GroupResult, TargetResolution
from .measure.profiles import Segment
from .measure.target import BAR, COARSEST, DIRECTIONS, Target


def save_resolution_report(path: Path, raster: Raster, resolution: TargetResolution, target: Target) -> None:
    """Write distances, the target with its lines, every group's profiles, and a table of all that was measured.

    Raises SettingsError where no file can be.
    """
    results = resolution.results
    picture, verdicts = target_picture(raster, results), {verdict_of(line) for line in lines_of(results)}
    save_page(
        path,
        "resolution",
        HowMeasured(_settings(target), [measured_raster(tr("image"), raster)]),
        name=raster.ref.name,
        summary=_summary(resolution, target),
        figures=[(distance_text(grd, error), words) for words, grd, error in target_distances(resolution)],
        notices=sentences_once(resolution.notices),
        **_distances(resolution),
        contrasts=[(band_title(band), f"{shown_number(value, 1)} : 1") for band, value in resolution.contrasts.items()],
        observers=_observers(resolution),
        picture=None if picture is None else svg_text(picture),
        verdicts=[(colour, verdict_word(name)) for name, colour in VERDICT_COLOURS.items() if name in verdicts],
        profiles=map(svg_text, profile_rows(results, target.criterion)),
        bands=_bands(results),
        criterion=target.criterion,
        measurements=[_row(result) for result in results],
        reasons=_reasons(results),
    )


def _distances(resolution: TargetResolution) -> dict[str, object]:
    finest = resolution.finest
    bands = list(dict.fromkeys(band for _, band in finest))

    def word(key: tuple[str, str]) -> str:
        group = finest.get(key)
        if group is None:
            return tr("none") if key in finest else ""
        return distance_number(group.distance, group.grd_error_cm)

    rows = [
        [direction_title(direction), *(word((direction, band)) for band in bands)]
        for direction in DIRECTIONS if any(where == direction for where, _ in finest)
    ]  # fmt: skip
    return {"distance_bands": [band_title(band) for band in bands], "distances": rows}


def _reasons(results: Sequence[GroupResult]) -> list[tuple[str, str, str, str]]:
    """Direction, band, reason, and the groups that it is true of: each sentence is said once."""
    groups: dict[tuple[str, str, str], list[str]] = {}
    for result in results:
        if result.reason is not None:
            group, direction, band = _names(result)
            groups.setdefault((direction, band, sentence(result.reason)), []).append(str(group))
    return [(*known, ", ".join(filter(None, numbers))) for known, numbers in groups.items()]


def _bands(results: Sequence[GroupResult]) -> list[tuple[str, str]]:
    """Colours and names of the bands that were measured; empty for a single one."""
    names = list(dict.fromkeys(result.band for result in results if result.band))
    if len(names) < 2:
        return []
    return [(band_colour(name, place, False), band_title(name)) for place, name in enumerate(names)]


def _observers(resolution: TargetResolution) -> list[tuple[str, ...]]:
    """Each observer's distances along and across the flight, and those that all agree on."""
    observers = list(dict.fromkeys(name for result in resolution.results for name in result.measured.line.seen))
    if not observers:
        return []

    def distances(observer: str | None) -> list[str]:
        distances = [resolution.seen(direction, observer) for direction in DIRECTIONS]
        return ["" if grd is None else shown_number(grd) for grd in distances]

    rows = [(name, *distances(name)) for name in observers]
    return [*rows, (tr("all of them"), *distances(None))]


def _summary(resolution: TargetResolution, target: Target) -> str:
    if not target_distances(resolution):
        return tr("No group is resolved in every band.")
    if target.grd_of == BAR:
        return tr("Ground resolved distance: one bar of the finest group that is resolved in every band.")
    return tr("Ground resolved distance: one bar and one gap of the finest group that is resolved in every band.")


def _settings(target: Target) -> list[tuple[str, str]]:
    coarser = tr("higher") if target.reversed else tr("lower")
    of_group, coarsest = tr("the group's own bars against plain gaps"), tr("that of the coarsest group")
    full = coarsest if target.full_amplitude == COARSEST else of_group
    words = tr("group {group} is {grd:.2f} cm wide, the next {coarser} number {step:.3f} times as wide")
    return [
        (tr("bars in each group"), str(target.bars)),
        (tr("widths"), filled(words, group=target.reference_group, grd=target.reference_grd_cm, coarser=coarser,
                              step=target.step)),
        (tr("widths are of"), tr("one bar") if target.grd_of == BAR else tr("a bar and a gap together")),
        (tr("criterion"), f"{percent(target.criterion)} %"),
        (tr("full amplitude"), full),
    ]  # fmt: skip


def _row(result: GroupResult) -> tuple[object, ...]:
    reading = result.reading

    def rounded(value: float | None, digits: int) -> str:
        return "" if value is None else shown_number(value, digits)

    bars: tuple[object, ...] = ("",) * 5
    if reading is not None:
        amplitudes = reading.amplitude, reading.amplitude_error, reading.full_amplitude
        bars = len(reading.bars), *(rounded(value, 1) for value in amplitudes), rounded(reading.modulation, 3)
    shift, verdict = result.measured.shifts.get(result.band), verdict_of([result])
    distance = rounded(result.grd_cm, 2), rounded(result.grd_error_cm, 2)
    return (*_names(result), *distance, *bars, rounded(shift, 2), verdict_word(verdict))


def _names(result: GroupResult) -> tuple[object, str, str]:
    line = result.measured.line
    group = "" if line.group is None else line.group
    return group, tr(line.direction), band_title(result.band) if result.band else ""


_LARGEST_PX = 3200  # of the target's longer side: a larger one is not read for a picture
_ROOM = np.array([7.0, 4.0])  # inches: width and height of the picture at most
_LARGEST_PIXEL = 0.08  # inches: no pixel is shown larger
_LETTERS = 7.0  # points
_POINT = 1 / 72  # inches


def target_picture(raster: Raster, results: Sequence[GroupResult]) -> Figure | None:
    """The image around all lines, each line in the colour of its verdict; None when no line lies on the image."""
    lines = [(line, segment) for line in lines_of(results) if (segment := line[0].measured.segment) is not None]
    if not lines:
        return None
    ends = np.array([(segment.start, segment.end) for _, segment in lines])
    longest = float(np.hypot(*(ends[:, 1] - ends[:, 0]).T).max())
    margin = 0.5 * longest + 6  # px around lines, in which their numbers have room
    first = np.floor(ends.min(axis=(0, 1)) - margin).clip(0).astype(int)
    size = np.minimum(np.ceil(ends.max(axis=(0, 1)) + margin), (raster.columns, raster.rows)).astype(int) - first
    if size.max() > _LARGEST_PX:
        return None
    scale = min(*(_ROOM / size).tolist(), _LARGEST_PIXEL)  # inches a pixel
    (left, top), (columns, rows) = first.tolist(), size.tolist()
    figure = new_figure(columns * scale, rows * scale, layout=None)
    axes = figure.add_axes((0, 0, 1, 1))
    bands = OpenRaster(raster.ref).read(PixelWindow(left, top, columns, rows)).bands
    pixels = np.moveaxis(bands[:3], 0, -1) if raster.has_luminance else bands[0]
    low, high = np.percentile(pixels, (0.5, 99.5))
    seen = np.clip((pixels - low) / max(high - low, 1e-9), 0, 1)
    extent = left, left + columns, top + rows, top
    axes.imshow(seen, cmap="gray", vmin=0, vmax=1, extent=extent, interpolation="nearest")
    axes.set_axis_off()
    _draw_lines(axes, lines, scale)
    axes.axis(extent)
    return figure


def _draw_lines(axes: Axes, lines: Sequence[tuple[Sequence[GroupResult], Segment]], scale: float) -> None:
    """Lines, and the numbers of their groups beyond their ends where they cover no other number."""
    taken: list[tuple[float, float, float]] = []
    for line, segment in lines:
        (x1, y1), (x2, y2) = segment.start, segment.end
        axes.plot([x1, x2], [y1, y2], color=VERDICT_COLOURS[verdict_of(line)], linewidth=1.6)
    for line, segment in lines:
        words = str(line[0].measured.line.group)
        (x1, y1), (x2, y2) = segment.start, segment.end
        length = max(math.hypot(x2 - x1, y2 - y1), 1e-9)
        half = (0.35 * len(words) + 0.35) * _LETTERS * _POINT / scale  # px: half the label's width
        away = 0.55 * _LETTERS * _POINT / scale + half * abs(x2 - x1) / length
        for end, start in (((x2, y2), (x1, y1)), ((x1, y1), (x2, y2))):
            x = end[0] + away * (end[0] - start[0]) / length
            y = end[1] + away * (end[1] - start[1]) / length
            high = 1.3 * _LETTERS * _POINT / scale
            if all(abs(x - other) > half + reach or abs(y - down) > high for other, down, reach in taken):
                taken.append((x, y, half))
                axes.text(
                    x, y, words, fontsize=_LETTERS, color="white", ha="center", va="center", clip_on=True,
                    bbox={"facecolor": "black", "alpha": 0.6, "pad": 0.8, "linewidth": 0},
                )  # fmt: skip
                break
