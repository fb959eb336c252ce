"""Bar groups -> matplotlib: profiles with their extremes, threshold and verdict."""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..toolkit.charts.chart_style import MOST_NAMED, PAPER, UNNAMED, band_colour
from ..toolkit.charts.figure_files import new_figure
from ..toolkit.translation import band_title, filled, tr
from .distance_words import direction_title
from .measure.bar_groups import GroupResult
from .measure.bars import BarReading
from .measure.target import DIRECTIONS

VERDICT_COLOURS = {"resolved": "#009e73", "unresolved": "#d55e00", "spurious": "#cc79a7", "unmeasured": "#777777"}
_MOST_ROWS = 10  # of panels below each other
_PANEL_WIDTH, _ROW_HEIGHT = 3.54, 1.32  # inches: two panels are as wide as A4 between its margins


def verdict_of(results: Sequence[GroupResult]) -> str:
    """The worst verdict on a line over its bands: ``resolved``, ``unresolved``, ``spurious`` or ``unmeasured``."""
    if any(result.reading is None for result in results):
        return "unmeasured"
    if all(result.resolved for result in results):
        return "resolved"
    return "spurious" if any(result.spurious for result in results) else "unresolved"


def verdict_word(verdict: str) -> str:
    return {
        "resolved": tr("resolved"),
        "unresolved": tr("not resolved"),
        "spurious": tr("aliasing"),
        "unmeasured": tr("not measured"),
    }[verdict]


def draw_profiles(axes: Axes, readings: Mapping[str, BarReading], criterion: float) -> None:
    """The profiles of one line by band, their bars and gaps, and for the weakest band the threshold of its gaps."""
    for place, (band, reading) in enumerate(readings.items()):
        profile, colour = reading.profile, band_colour(band, place, len(readings) == 1)
        title = band_title(band) if place < MOST_NAMED else UNNAMED
        axes.plot(profile.positions, profile.values, color=colour, linewidth=1.4, label=title)
        for extremes, face in ((reading.bars, colour), (reading.gaps, PAPER.background)):
            axes.plot(
                [extreme.position for extreme in extremes], [extreme.value for extreme in extremes], "o", color=colour,
                markerfacecolor=face, markersize=4.5, zorder=3,
            )
    weakest = min(readings.values(), key=lambda reading: reading.share or 0.0, default=None)
    if weakest is not None:
        axes.axvline(0, color=PAPER.grid, linewidth=1, zorder=0)
        axes.axvline(weakest.profile.length, color=PAPER.grid, linewidth=1, zorder=0)
        if len(weakest.bars) > 1:
            # Gaps that lie on the bars' side of this line, on the whole, are too shallow.
            ends, level = (weakest.bars[0].position, weakest.bars[-1].position), weakest.threshold(criterion)
            axes.plot(ends, (level, level), "--", color=PAPER.limit, linewidth=1.2, zorder=2)
    axes.set_facecolor(PAPER.background)
    axes.tick_params(colors=PAPER.text)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["bottom", "left"]].set_color(PAPER.text)
    axes.margins(x=0.01, y=0.08)


def group_chart(results: Sequence[GroupResult], criterion: float) -> Figure:
    """The profiles of all groups on one page, in the order of ``profile_rows``, with the names of their bands."""
    panels = _panels(results) or [[]]
    columns = 2 if len(panels) <= 2 * _MOST_ROWS else 4
    figure = _panel_figure(panels, columns, criterion, legend_height=0.35)
    figure.supxlabel(tr("along the line, px"), fontsize=8)
    named = {label: line for axes in figure.axes for line, label in zip(*axes.get_legend_handles_labels())}
    if len(named) > 1:
        figure.legend(named.values(), named.keys(), loc="upper center", ncol=6, fontsize=8, frameon=False)
    return figure


def profile_rows(results: Sequence[GroupResult], criterion: float) -> Iterator[Figure]:
    """The profiles two by two, the coarsest group first, each row a figure that breaks across no page.

    Along the flight on the left and across it on the right; of one direction alone, group after group.
    """
    panels = _panels(results)
    for first in range(0, len(panels), 2):
        yield _panel_figure(panels[first : first + 2], 2, criterion)


def _panel_figure(
    panels: Sequence[Sequence[GroupResult]], columns: int, criterion: float, legend_height: float = 0.0
) -> Figure:
    """Panels row by row; ``legend_height``: inches above and below them that are left free."""
    rows = -(-len(panels) // columns)
    height = _ROW_HEIGHT * rows + 2 * legend_height
    figure = new_figure(_PANEL_WIDTH * columns, height, layout=None)
    below, above = legend_height + 0.16 * _ROW_HEIGHT, legend_height + 0.18 * _ROW_HEIGHT
    grid = figure.add_gridspec(
        rows, columns, left=0.15 / columns, right=1 - 0.03 / columns, bottom=below / height, top=1 - above / height,
        wspace=0.22, hspace=0.52,
    )  # fmt: skip
    for place, line in enumerate(panels):
        _draw_panel(figure.add_subplot(grid[place]), line, criterion)
    return figure


def _panels(results: Sequence[GroupResult]) -> list[Sequence[GroupResult]]:
    """The first line of each group that has a width and each direction, the widest group first; nothing where there is
    no line."""
    known = [line for line in lines_of(results) if line[0].grd_cm is not None]
    by_place = {(line[0].measured.line.group, line[0].measured.line.direction): line for line in reversed(known)}
    widths = {group: line[0].distance for (group, _), line in by_place.items()}
    directions = [direction for direction in DIRECTIONS if any(direction == known for _, known in by_place)]
    groups = sorted(widths, key=lambda group: -widths[group])
    return [by_place.get((group, direction), []) for group in groups for direction in directions]


def _draw_panel(panel: Axes, results: Sequence[GroupResult], criterion: float) -> None:
    """The profiles of one line below its group, distance and verdict; nothing where there is no line."""
    panel.tick_params(labelsize=7)
    panel.set_axis_off()
    if not results:
        return
    readings = {result.band: result.reading for result in results if result.reading is not None}
    verdict, first = verdict_of(results), results[0]
    group, where = first.measured.line.group, direction_title(first.measured.line.direction)
    panel.set_title(filled(tr("group {group} {direction}"), group=group, direction=where), fontsize=6.5, loc="left")
    words = filled(tr("{grd:.2f} cm: {verdict}"), grd=first.grd_cm, verdict=verdict_word(verdict))
    panel.set_title(words, fontsize=6.5, loc="right", color=VERDICT_COLOURS[verdict])
    if readings:
        panel.set_axis_on()
        draw_profiles(panel, readings, criterion)
        panel.set_ylabel("DN", fontsize=7)


def lines_of(results: Sequence[GroupResult]) -> list[list[GroupResult]]:
    lines: dict[int, list[GroupResult]] = {}
    for result in results:
        lines.setdefault(id(result.measured), []).append(result)
    return list(lines.values())
