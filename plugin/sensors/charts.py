"""Charts of sensor models: residuals in the image, and models side by side."""
from __future__ import annotations

import math

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from ..toolkit.charts.figure_files import new_figure
from ..toolkit.translation import formatted, tr
from .measure.adjustment import Adjustment
from .measure.comparison import Comparison
from .measure.control_coverage import ControlCoverage, ImageBox

_CONTROL, _CHECK, _BLUNDER, _QUIET = "#0072b2", "#d55e00", "#cc3311", "#57606a"
_ARROW_SHARE = 0.08  # of the image's longer side, for a residual of usual size


def residual_chart(done: Adjustment, coverage: ControlCoverage, box: ImageBox) -> Figure:
    """The residuals as arrows in the image, enlarged; the outline of the control points is what is not extrapolated."""
    width, height = max(box[2] - box[0], 1.0), max(box[3] - box[1], 1.0)  # points may all lie at one place
    figure = new_figure(6.4, min(max(6.4 * height / width, 3.6), 7.5))
    axes = figure.add_subplot()
    axes.set_aspect("equal")
    frame = [(0, 1), (2, 1), (2, 3), (0, 3), (0, 1)]
    axes.plot([box[x] for x, _ in frame], [box[y] for _, y in frame], color="#1b1f23", lw=0.8)
    if len(coverage.outline) > 2:
        axes.fill(*coverage.outline.T, facecolor=_CONTROL, alpha=0.07, edgecolor=_CONTROL, lw=0.7, ls=(0, (4, 3)))
    points, residuals = done.points, done.residuals_px
    shown = residuals[~done.blunder] if (~done.blunder).any() else residuals
    usual = float(np.quantile(np.linalg.norm(shown, axis=1), 0.9))
    factor = _ARROW_SHARE * max(width, height) / usual if usual > 0 else 0.0
    groups = (
        (tr("Control points"), ~points.check & ~done.blunder, _CONTROL, "o"),
        (tr("Check points"), points.check & ~done.blunder, _CHECK, "^"),
        (tr("Blunders"), done.blunder, _BLUNDER, "x"),
    )
    reach = [np.array([[box[0], box[1]], [box[2], box[3]]])]  # what has to be in the picture
    for label, group, colour, marker in groups:
        if not group.any():
            continue
        places, arrows = points.image[group], residuals[group] * factor
        longest = 3 * _ARROW_SHARE * max(width, height)
        length = np.linalg.norm(arrows, axis=1, keepdims=True)
        arrows = arrows * np.minimum(1, longest / np.maximum(length, 1e-12))
        reach += [places, places + arrows]
        axes.plot(*places.T, marker, color=colour, ms=4, label=label, ls="none")
        axes.quiver(
            *places.T, *arrows.T, angles="xy", scale_units="xy", scale=1, color=colour, width=0.0032, headwidth=3.5
        )
    step = _round(usual)
    if step > 0:
        corner = ([box[0]], [box[1]], [0], [0])
        key = axes.quiver(*corner, angles="xy", scale_units="xy", scale=1, color=_QUIET, width=0.0032, headwidth=3.5)
        words = formatted(step, "g") + " px"
        axes.quiverkey(key, 0.85, 0.04, step * factor, words, labelpos="E", coordinates="figure", color=_QUIET)
    margin = 0.02 * max(width, height)
    low, high = np.concatenate(reach).min(axis=0) - margin, np.concatenate(reach).max(axis=0) + margin
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(high[1], low[1])
    axes.set_xlabel(tr("Column (px)"))
    axes.set_ylabel(tr("Row (px)"))
    axes.xaxis.set_major_locator(MaxNLocator(5))
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=3, frameon=False, fontsize=9, handletextpad=0.2)
    axes.spines[["top", "right", "left", "bottom"]].set_visible(False)
    return figure


def comparison_chart(result: Comparison) -> Figure:
    """The mean errors of all models that were judged, on a logarithmic scale, the recommended one marked."""
    judged = [row for row in result.rows if row.errors is not None and row.errors.rmse is not None]
    figure = new_figure(6.4, 1.1 + 0.3 * max(len(judged), 1))
    axes = figure.add_subplot()
    for place, row in enumerate(judged):
        assert row.errors is not None
        chosen = row is result.recommended
        low, high = sorted((row.errors.rmse_x or 0.0, row.errors.rmse_y or 0.0))
        axes.plot([low, high], [place, place], color="#d0d7de", lw=2, zorder=1)
        for value, marker, name in ((row.errors.rmse_x, "o", "X"), (row.errors.rmse_y, "D", "Y")):
            axes.plot(
                [value], [place], marker, color=_CHECK if chosen else _CONTROL, ms=6, label=name if place == 0 else None
            )
    axes.set_yticks(range(len(judged)), [row.request.name for row in judged], fontsize=9)
    for label, row in zip(axes.get_yticklabels(), judged):
        if row is result.recommended:
            label.set_color(_CHECK)
            label.set_fontweight("bold")
    axes.set_xscale("log")
    axes.xaxis.set_major_formatter(lambda value, _place: formatted(value, "g"))
    axes.invert_yaxis()
    axes.set_xlabel(tr("Mean error on points not used in the fit (m)"))
    axes.grid(axis="x", color="#eaeef2", which="both")
    axes.set_axisbelow(True)
    if judged:
        axes.legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=2, frameon=False, fontsize=9, handletextpad=0.2)
    axes.spines[["top", "right", "left"]].set_visible(False)
    return figure


def _round(value: float) -> float:
    """A length of one digit, 1, 2 or 5, near a value."""
    if value <= 0 or not math.isfinite(value):
        return 0.0
    power = 10.0 ** math.floor(math.log10(value))
    return power * next(step for step in (5, 2, 1) if step * power <= value * 1.0001)
