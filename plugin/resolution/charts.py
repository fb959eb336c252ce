"""Bar groups -> matplotlib: profiles with their extremes, threshold and verdict, and the target as a picture."""
from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..imagery.grids import PixelWindow
from ..imagery.open_raster import OpenRaster
from ..imagery.rasters import Raster
from ..toolkit.band_titles import band_title
from ..toolkit.charts.chart_style import PAPER, ChartStyle
from ..toolkit.charts.figure_files import new_figure
from ..toolkit.translation import tr
from .measure.bar_groups import GroupResult
from .measure.bars import BarReading
from .measure.target import DIRECTIONS

BAND_COLOURS = {"red": "#d55e00", "green": "#009e73", "blue": "#0072b2", "nir": "#cc79a7"}
_OTHERS = ("#0072b2", "#e69f00", "#56b4e9", "#d55e00", "#009e73", "#cc79a7")
_VERDICT_COLOURS = {"resolved": "#009e73", "unresolved": "#d55e00", "spurious": "#cc79a7", "unmeasured": "#777777"}
_LARGEST_PICTURE = 1600
_MOST_ROWS = 10  # of panels below each other


def direction_title(direction: str) -> str:
    """A direction for the user."""
    return {"along": tr("along the flight"), "across": tr("across the flight")}.get(direction, direction)


def verdict_of(results: Sequence[GroupResult]) -> str:
    """The worst verdict on a line over its bands: ``resolved``, ``unresolved``, ``spurious`` or ``unmeasured``."""
    if any(result.reading is None for result in results):
        return "unmeasured"
    if all(result.resolved for result in results):
        return "resolved"
    return "spurious" if any(result.spurious for result in results) else "unresolved"


def verdict_word(verdict: str) -> str:
    """A verdict for the user."""
    return {
        "resolved": tr("resolved"),
        "unresolved": tr("not resolved"),
        "spurious": tr("aliasing"),
        "unmeasured": tr("not measured"),
    }[verdict]


def draw_profiles(axes: Axes, readings: Mapping[str, BarReading], criterion: float, style: ChartStyle = PAPER) -> None:
    """The profiles of one line by band, their bars and gaps, and for the weakest band the threshold of its gaps."""
    for place, (band, reading) in enumerate(readings.items()):
        profile = reading.profile
        colour = BAND_COLOURS.get(band, style.text if len(readings) == 1 else _OTHERS[place % len(_OTHERS)])
        axes.plot(profile.positions, profile.values, color=colour, linewidth=1.4 * style.scale, label=band_title(band))
        for extremes, face in ((reading.bars, colour), (reading.gaps, style.background)):
            axes.plot(
                [one.position for one in extremes], [one.value for one in extremes], "o", color=colour,
                markerfacecolor=face, markersize=4.5 * style.scale, zorder=3,
            )
    weakest = min(readings.values(), key=lambda reading: reading.share or 0.0, default=None)
    if weakest is not None:
        axes.axvline(0, color=style.grid, linewidth=1, zorder=0)
        axes.axvline(weakest.profile.length, color=style.grid, linewidth=1, zorder=0)
        if len(weakest.bars) > 1:
            _draw_threshold(axes, weakest, criterion, style)
    axes.set_facecolor(style.background)
    axes.tick_params(colors=style.text)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["bottom", "left"]].set_color(style.text)
    axes.margins(x=0.01, y=0.08)


def _draw_threshold(axes: Axes, reading: BarReading, criterion: float, style: ChartStyle) -> None:
    """A gap on the bars' side of this line is too shallow."""
    down = -1 if reading.bright else 1
    least = (min if reading.bright else max)(bar.value for bar in reading.bars)
    level = least + down * criterion * reading.full_amplitude
    ends = reading.bars[0].position, reading.bars[-1].position
    axes.plot(ends, (level, level), "--", color=style.limit, linewidth=1.2 * style.scale, zorder=2)


def group_chart(results: Sequence[GroupResult], criterion: float) -> Figure:
    """The profiles group by group, the coarsest first: along the flight on the left, across on the right."""
    lines = _by_line(results)
    directions = [one for one in DIRECTIONS if any(line[0].measured.line.direction == one for line in lines)]
    directions = directions or [DIRECTIONS[0]]
    groups = sorted(
        {line[0].measured.line.group: line[0].grd_cm for line in lines if line[0].grd_cm is not None}.items(),
        key=lambda pair: -(pair[1] or 0),
    )
    strands = 2 if len(groups) > _MOST_ROWS else 1  # of panels for each direction, so that the page stays a page
    rows = max(1, -(-len(groups) // strands))
    figure = new_figure(1.0 + (4.0, 3.2)[strands - 1] * strands * len(directions), 0.9 + 1.45 * rows)
    parts = figure.add_gridspec(rows + 1, strands * len(directions), height_ratios=[1.0] * rows + [0.12])
    handles: dict[str, object] = {}
    for column, direction in enumerate(directions):
        for place, (group, _) in enumerate(groups):
            strand, row = divmod(place, rows)
            panel = figure.add_subplot(parts[row, strands * column + strand])
            key = group, direction
            found = [line for line in lines if (line[0].measured.line.group, line[0].measured.line.direction) == key]
            _draw_panel(panel, found[0] if found else [], criterion)
            if place == 0:
                _write_heading(panel, direction_title(direction))
            if row == rows - 1 or place == len(groups) - 1:
                panel.set_xlabel(tr("along the line, px"), fontsize=8)
            for handle, label in zip(*panel.get_legend_handles_labels()):
                handles.setdefault(label, handle)
    _write_legend(figure.add_subplot(parts[rows, :]), handles if len(handles) > 1 else {})
    return figure


def _write_heading(panel: Axes, words: str) -> None:
    panel.annotate(
        words, (0, 1), xytext=(0, 22), xycoords="axes fraction", textcoords="offset points", fontsize=10,
        fontweight="bold",
    )


def _write_legend(axes: Axes, handles: Mapping[str, object]) -> None:
    """A legend in a place of its own."""
    axes.set_axis_off()
    if handles:
        axes.legend(handles.values(), handles.keys(), loc="center", ncol=6, fontsize=8, frameon=False)


def _draw_panel(panel: Axes, results: Sequence[GroupResult], criterion: float) -> None:
    panel.tick_params(labelsize=7)
    if not results:
        panel.set_axis_off()
        return
    readings = {result.band: result.reading for result in results if result.reading is not None}
    verdict, first = verdict_of(results), results[0]
    title = tr("group {group}, {grd:.2f} cm: {verdict}").format(
        group=first.measured.line.group, grd=first.grd_cm, verdict=verdict_word(verdict)
    )
    panel.set_title(title, fontsize=8, loc="left", color=_VERDICT_COLOURS[verdict], fontweight="bold")
    if readings:
        draw_profiles(panel, readings, criterion)
        panel.set_ylabel("DN", fontsize=7)
    else:
        panel.set_axis_off()


def target_picture(raster: Raster, results: Sequence[GroupResult]) -> Figure | None:
    """The image around all lines, each line in the colour of its verdict; None when no line lies on the image."""
    lines = [line for line in _by_line(results) if line[0].measured.segment is not None]
    if not lines:
        return None
    ends = np.array([end for line in lines for end in _ends(line)])
    (left, top), (right, bottom) = ends.min(axis=0), ends.max(axis=0)
    margin = 0.06 * max(right - left, bottom - top) + 6
    column, row = max(0, int(left - margin)), max(0, int(top - margin))
    width = min(raster.grid.columns, int(right + margin)) - column
    height = min(raster.grid.rows, int(bottom + margin)) - row
    if max(width, height) > 2 * _LARGEST_PICTURE:
        return None
    bands = OpenRaster(raster.ref).read(PixelWindow(column, row, width, height)).bands
    shown = np.moveaxis(bands[:3], 0, -1) if raster.has_luminance else bands[0]
    low, high = np.percentile(shown, (0.5, 99.5))
    toned = np.clip((shown - low) / max(high - low, 1e-9), 0, 1)
    side = 7.0
    figure = new_figure(side * min(1.0, width / height), side * min(1.0, height / width) + 0.4)
    parts = figure.add_gridspec(2, 1, height_ratios=[1.0, 0.04])
    axes = figure.add_subplot(parts[0])
    extent = (column, column + width, row + height, row)
    axes.imshow(toned, cmap="gray", extent=extent, interpolation="nearest")
    words = {}
    for line in lines:
        verdict = verdict_of(line)
        (x1, y1), (x2, y2) = _ends(line)
        words[verdict] = axes.plot([x1, x2], [y1, y2], color=_VERDICT_COLOURS[verdict], linewidth=1.8)[0]
        axes.annotate(
            str(line[0].measured.line.group), (x2, y2), xytext=(2, 2), textcoords="offset points", fontsize=6,
            color="white", bbox={"facecolor": "black", "alpha": 0.6, "pad": 0.8, "linewidth": 0},
        )
    axes.set_axis_off()
    _write_legend(figure.add_subplot(parts[1]), {verdict_word(verdict): handle for verdict, handle in words.items()})
    return figure


def _ends(line: Sequence[GroupResult]) -> tuple[tuple[float, float], tuple[float, float]]:
    segment = line[0].measured.segment
    assert segment is not None
    return segment.start, segment.end


def _by_line(results: Sequence[GroupResult]) -> list[list[GroupResult]]:
    lines: dict[int, list[GroupResult]] = {}
    for result in results:
        lines.setdefault(id(result.measured), []).append(result)
    return list(lines.values())
