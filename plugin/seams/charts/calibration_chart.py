"""What the observer's verdicts say of the measures, as a chart: ROC curves, and every judged window."""
from __future__ import annotations

import textwrap
from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...toolkit.charts.chart_style import PAPER, ChartStyle
from ...toolkit.charts.figure_files import new_figure
from ...toolkit.translation import filled, sentence, tr
from ..measure.calibration.threshold_calibration import STANDARD_LIMITS, ThresholdCalibration, Verdicts

_CURVES_SIDE, _WORDS_WIDTH, _MEASURE_HEIGHT = 4.2, 3.0, 1.45  # inches; together as wide as A4 between its margins
_WORDS_LETTERS = 40  # a line of words beside the curves
_FARTHEST = 2.0  # measures above are drawn at the edge: no threshold lies there
_SCATTER = 0.22  # rows: how far points that would hide each other are moved apart
_WIDTHS = (6.4, 5.2, 4.0, 2.6, 1.4)  # of the curves, so that one on top of another does not hide it


def calibration_figure(calibrations: Sequence[ThresholdCalibration]) -> Figure:
    """ROC curves with their areas above, the judged windows of each measure below."""
    heights = [_CURVES_SIDE, *(_MEASURE_HEIGHT for _ in calibrations)]
    figure = new_figure(_CURVES_SIDE + _WORDS_WIDTH, sum(heights))
    grid = figure.add_gridspec(len(heights), 2, height_ratios=heights, width_ratios=(_CURVES_SIDE, _WORDS_WIDTH))
    _draw_roc(figure.add_subplot(grid[0, 0]), figure.add_subplot(grid[0, 1]), calibrations, PAPER)
    for row, calibration in enumerate(calibrations, 1):
        _draw_verdicts(figure.add_subplot(grid[row, :]), calibration, PAPER)
    return figure


def _draw_roc(axes: Axes, words: Axes, calibrations: Sequence[ThresholdCalibration], style: ChartStyle) -> None:
    _frame(axes, style)
    axes.set_aspect("equal")
    axes.set_xlim(-0.02, 1.02)
    axes.set_ylim(-0.02, 1.02)
    axes.set_xlabel(tr("windows flagged by mistake (1 - specificity)"))
    axes.set_ylabel(tr("visible losses flagged (sensitivity)"))
    axes.grid(True, color=style.grid, linewidth=0.8)
    lines = axes.plot([0, 1], [0, 1], color=style.text, linewidth=0.8, linestyle=":", label=tr("a guess"))
    for calibration, colour, width in zip(calibrations, style.sources, _WIDTHS[-len(calibrations) :]):
        if calibration.area is None:
            continue
        x = [0.0, *(1 - step.specificity for step in calibration.steps)]
        y = [0.0, *(step.sensitivity for step in calibration.steps)]
        lines += axes.plot(x, y, color=colour, linewidth=width, label=_area_words(calibration))
        if calibration.best is not None:
            place = [1 - calibration.best.specificity], [calibration.best.sensitivity]
            axes.plot(*place, "o", color=colour, markersize=5 + width, markeredgecolor=style.background)
    words.set_axis_off()
    words.legend(handles=lines, loc="lower left", frameon=False, fontsize=8, borderaxespad=0, labelspacing=0.9)
    why = [sentence(notice) for measure in calibrations if measure.area is None for notice in measure.notices]
    text = "\n\n".join(textwrap.fill(words, _WORDS_LETTERS) for words in why)
    words.text(0.02, 1, text, va="top", fontsize=8, color=style.limit)


def _area_words(calibration: ThresholdCalibration) -> str:
    """A measure with its area and the verdicts wanted."""
    assert calibration.area is not None
    area = filled(tr("AUC {area:.3f} (95 %: {low:.3f} to {high:.3f})"),
        area=calibration.area.value, low=calibration.area.low, high=calibration.area.high
    )
    if calibration.best is None:
        return f"{calibration.verdicts.measure}\n{area}"
    best = filled(tr("threshold {value:g}: {hits} of {seen}, by mistake {vain} of {unseen}"),
        value=calibration.best.threshold,
        hits=calibration.best.flagged_visible,
        seen=len(calibration.verdicts.visible),
        vain=calibration.best.flagged_invisible,
        unseen=len(calibration.verdicts.invisible),
    )
    return f"{calibration.verdicts.measure}\n{area}\n{best}"


def _draw_verdicts(axes: Axes, calibration: ThresholdCalibration, style: ChartStyle) -> None:
    """Each judged window a point, the threshold a line."""
    verdicts = calibration.verdicts
    _frame(axes, style)
    titles = (
        filled(tr("visible ({count})"), count=len(verdicts.visible)),
        filled(tr("invisible ({count})"), count=len(verdicts.invisible)),
    )
    for row, (values, colour) in enumerate(zip((verdicts.visible, verdicts.invisible), (style.limit, "#0072b2"))):
        x, y = np.array(values), 1 - row + _spread(len(values))
        far = x > _FARTHEST
        axes.plot(x[~far], y[~far], "o", color=colour, alpha=0.55, markersize=4, markeredgewidth=0)
        axes.plot(np.full(far.sum(), _FARTHEST), y[far], ">", color=colour, markersize=5, markeredgewidth=0)
    axes.set_yticks([1, 0], titles)
    axes.set_ylim(-0.5, 1.5)
    axes.set_xlim(*_reach(verdicts))
    axes.set_xlabel(verdicts.measure, labelpad=1)
    axes.grid(True, axis="x", color=style.grid, linewidth=0.8)
    standard = STANDARD_LIMITS.get(verdicts.measure)
    if standard is not None:
        _line(axes, standard, tr("standard {value:g}"), style.text, "--")
    if calibration.best is not None:
        if calibration.best_range is not None:
            axes.axvspan(*calibration.best_range, color=style.limit, alpha=0.12, linewidth=0)
        _line(axes, calibration.best.threshold, tr("threshold {value:g}"), style.limit, "-")
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), frameon=False, fontsize=8, borderaxespad=0)


def _line(axes: Axes, value: float, label: str, colour: str, line: str) -> None:
    axes.axvline(value, color=colour, linewidth=1.2, linestyle=line, label=filled(label, value=value))


def _spread(count: int) -> np.ndarray:
    """Offsets that keep neighbours apart, the same for the same number of points: the golden ratio's multiples."""
    return _SCATTER * (2 * (np.arange(count) * 0.618034 % 1) - 1)


def _reach(verdicts: Verdicts) -> tuple[float, float]:
    values = (*verdicts.visible, *verdicts.invisible, 0.0, 1.0)
    low, high = min(values), min(max(values), _FARTHEST)
    return low - 0.03 * (high - low), high + 0.03 * (high - low)


def _frame(axes: Axes, style: ChartStyle) -> None:
    axes.set_axisbelow(True)
    axes.tick_params(colors=style.text, labelsize=8)
    axes.spines[["top", "right"]].set_visible(False)
