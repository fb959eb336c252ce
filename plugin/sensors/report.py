"""Reports of sensor models."""
from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.ticker import MaxNLocator

from ..imagery.errors import WARNING, Message
from ..toolkit.charts.chart_style import round_below
from ..toolkit.charts.figure_files import new_figure, svg_text
from ..toolkit.pages.templates import HowMeasured, save_page, sentences_once, system_name
from ..toolkit.translation import filled, formatted, sentence, tr
from .measure.adjustment import LEAVE_ONE_OUT, Accuracy, Adjustment, Comparison
from .measure.points import ControlCoverage, ImageBox

_CONTROL, _CHECK, _BLUNDER, _QUIET = "#0072b2", "#d55e00", "#cc3311", "#57606a"
_ARROWS: dict[str, Any] = {"angles": "xy", "scale_units": "xy", "scale": 1, "width": 0.0032, "headwidth": 3.5}
_ARROW_SHARE = 0.08  # of the image's longer side, for a residual of usual size


def residual_chart(done: Adjustment, coverage: ControlCoverage, box: ImageBox) -> Figure:
    """The residuals as arrows in the image, enlarged; the outline of the control points is what is not extrapolated."""
    width, height = max(box[2] - box[0], 1.0), max(box[3] - box[1], 1.0)  # points may all lie at one place
    figure = new_figure(6.4, min(max(6.4 * height / width, 3.6), 7.5))
    axes = figure.add_subplot()
    axes.set_aspect("equal")
    axes.add_patch(Rectangle(box[:2], box[2] - box[0], box[3] - box[1], fill=False, edgecolor="#1b1f23", lw=0.8))
    if len(coverage.outline) > 3:
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
    reach, longest = [np.reshape(box, (2, 2))], 3 * _ARROW_SHARE * max(width, height)  # what has to be in the picture
    for label, group, colour, marker in groups:
        if not group.any():
            continue
        places, arrows = points.image[group], residuals[group] * factor
        arrows *= np.minimum(1, longest / np.maximum(np.linalg.norm(arrows, axis=1, keepdims=True), 1e-12))
        reach += [places, places + arrows]
        axes.plot(*places.T, marker, color=colour, ms=4, label=label, ls="none")
        axes.quiver(*places.T, *arrows.T, color=colour, **_ARROWS)
    if usual > 0:
        step = round_below(usual)
        key = axes.quiver([box[0]], [box[1]], [0], [0], color=_QUIET, **_ARROWS)
        words = formatted(step, "g") + " px"
        axes.quiverkey(key, 0.85, 0.04, step * factor, words, labelpos="E", coordinates="figure", color=_QUIET)
    margin = 0.02 * max(width, height)
    low, high = np.concatenate(reach).min(axis=0) - margin, np.concatenate(reach).max(axis=0) + margin
    axes.set(xlim=(low[0], high[0]), ylim=(high[1], low[1]), xlabel=tr("Column (px)"), ylabel=tr("Row (px)"))
    axes.xaxis.set_major_locator(MaxNLocator(5))
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), ncols=3, frameon=False, fontsize=9, handletextpad=0.2)
    axes.spines[["top", "right", "left", "bottom"]].set_visible(False)
    return figure


def comparison_chart(result: Comparison) -> Figure:
    """The mean errors of all models that were judged, on a logarithmic scale, the recommended one marked."""
    judged = [(row, row.errors) for row in result.rows if row.errors is not None and row.errors.rmse is not None]
    figure = new_figure(6.4, 1.1 + 0.3 * max(len(judged), 1))
    axes = figure.add_subplot()
    for place, (row, errors) in enumerate(judged):
        axes.plot([errors.rmse_x, errors.rmse_y], [place, place], color="#d0d7de", lw=2, zorder=1)
        colour = _CHECK if row is result.recommended else _CONTROL
        for value, marker, name in ((errors.rmse_x, "o", "X"), (errors.rmse_y, "D", "Y")):
            axes.plot([value], [place], marker, color=colour, ms=6, label=name if place == 0 else None)
    axes.set_yticks(range(len(judged)), [row.request.name for row, _ in judged], fontsize=9)
    for label, (row, _) in zip(axes.get_yticklabels(), judged):
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


_MOST_POINTS = 200  # listed one by one


def save_fit_report(
    path: Path, done: Adjustment, coverage: ControlCoverage, box: ImageBox, notices: Sequence[Message]
) -> None:
    """The report of one model. Raises SettingsError where no file can be written."""
    points = [
        (
            done.points.ids[index], tr("check") if done.points.check[index] else tr("control"),
            *map(_number, (*done.residuals_px[index], *done.residuals_m[index])),
            tr("yes") if done.blunder[index] else "",
        )
        for index in np.argsort(-np.linalg.norm(done.residuals_m, axis=1))[:_MOST_POINTS]  # the largest first
    ]  # fmt: skip
    variant = done.request.variant
    words = tr("{count}, held by priors") if variant.with_priors else "{count}"
    save_page(
        path, "sensor_model", HowMeasured([(tr("reference system of the points"), system_name(done.points.wkt))]),
        name=done.request.name, unknowns=filled(words, count=variant.with_priors or variant.unknowns),
        control_count=done.control.count,
        notices=sentences_once(notice for notice in notices if notice.level is WARNING),
        notes=sentences_once(notice for notice in notices if notice.level is not WARNING),
        iterations=done.fitted.iterations, condition=done.fitted.condition, sigma=_number(done.sigma_px, "px"),
        extrapolated=coverage.extrapolated, check=_errors(done.check), control=_errors(done.control),
        chart=svg_text(residual_chart(done, coverage, box)), points=points,
    )  # fmt: skip


def save_comparison_report(path: Path, result: Comparison, notices: Sequence[Message]) -> None:
    """The report of all models. Raises SettingsError where no file can be written."""
    rows = [(row.request.name.replace(" ", "\N{NO-BREAK SPACE}"), row) for row in result.rows]
    judged = [(name, row.control_count, row.errors) for name, row in rows if row.errors is not None]
    can_be_drawn = any(0 < (errors.rmse or 0.0) < math.inf for *_, errors in judged)  # on a logarithmic scale
    save_page(
        path, "sensor_comparison", HowMeasured(),
        recommendation=sentence(result.reason), notices=sentences_once(notices),
        chart=svg_text(comparison_chart(result)) if can_be_drawn else "",
        models=[(name, *_errors(errors)[1:5], count, errors.count) for name, count, errors in judged],
        is_leave_one_out=result.method == LEAVE_ONE_OUT,
        doubtful=[(name, sentence(row.reason)) for name, row in rows if row.reason is not None],
    )  # fmt: skip


def _errors(errors: Accuracy) -> list[object]:
    values = (errors.rmse_x, errors.rmse_y, errors.max_x, errors.max_y, errors.rmse_column, errors.rmse_row)
    return [errors.count, *("" if value is None else _number(value) for value in values)]


def _number(value: float, unit: str = "") -> str:
    if not math.isfinite(value):
        return tr("unknown")
    words = formatted(value, ".3f" if abs(value) >= 0.001 or value == 0 else ".1e")
    return f"{words} {unit}".strip()
