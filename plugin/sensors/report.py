"""Reports of sensor models."""
from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ..imagery.message import WARNING, Message
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages.how_measured import HowMeasured, system_name
from ..toolkit.pages.templates import save_page, sentences_once
from ..toolkit.translation import filled, formatted, sentence, tr
from .charts import comparison_chart, residual_chart
from .measure.adjustment import Accuracy, Adjustment
from .measure.comparison import LEAVE_ONE_OUT, Comparison
from .measure.control_coverage import ControlCoverage, ImageBox
from .measure.models.registry import Variant

_MOST_POINTS = 200  # listed one by one


def save_fit_report(
    path: Path, done: Adjustment, coverage: ControlCoverage, box: ImageBox, notices: Sequence[Message]
) -> None:
    """The report of one model. Raises SettingsError where no file can be written."""
    save_page(
        path,
        "sensor_model",
        HowMeasured([(tr("reference system of the points"), system_name(done.points.wkt))]),
        name=done.request.name,
        notices=sentences_once(one for one in notices if one.level is WARNING),
        notes=sentences_once(one for one in notices if one.level is not WARNING),
        unknowns=_unknowns(done.request.variant),
        control_count=done.control.count,
        iterations=done.fitted.iterations,
        condition=done.fitted.condition,
        sigma=_number(done.sigma_px, "px"),
        extrapolated=coverage.extrapolated,
        check=_errors(done.check),
        control=_errors(done.control),
        chart=svg_text(residual_chart(done, coverage, box)),
        points=[
            (
                done.points.ids[index],
                tr("check") if done.points.check[index] else tr("control"),
                *(_number(value) for value in done.residuals_px[index]),
                *(_number(value) for value in done.residuals_m[index]),
                tr("yes") if done.blunder[index] else "",
            )
            for index in _worst(done)
        ],
    )


def save_comparison_report(path: Path, result: Comparison, notices: Sequence[Message]) -> None:
    """The report of all models. Raises SettingsError where no file can be written."""
    save_page(
        path,
        "sensor_comparison",
        HowMeasured(),
        recommendation=sentence(result.reason),
        notices=sentences_once(notices),
        chart=svg_text(comparison_chart(result)) if _can_be_drawn(result) else "",
        models=[
            (_unbroken(row.request.name), *_errors(row.errors)[1:5], row.control_count, row.errors.count)
            for row in result.rows
            if row.errors is not None
        ],
        is_leave_one_out=result.method == LEAVE_ONE_OUT,
        doubtful=[(_unbroken(row.request.name), sentence(row.reason)) for row in result.rows if row.reason is not None],
    )


def _can_be_drawn(result: Comparison) -> bool:
    """Whether any error is a positive number, which a logarithmic scale needs."""
    errors = [row.errors.rmse or 0.0 for row in result.rows if row.errors is not None]
    return any(math.isfinite(error) and error > 0 for error in errors)


def _unknowns(variant: Variant) -> str:
    words = tr("{count}, held by priors") if variant.with_priors else "{count}"
    return filled(words, count=variant.with_priors or variant.unknowns)


def _unbroken(name: str) -> str:
    """A name that no line break parts."""
    return name.replace(" ", "\N{NO-BREAK SPACE}")


def _errors(errors: Accuracy) -> list[object]:
    values = (errors.rmse_x, errors.rmse_y, errors.max_x, errors.max_y, errors.rmse_column, errors.rmse_row)
    return [errors.count, *("" if value is None else _number(value) for value in values)]


def _worst(done: Adjustment) -> list[int]:
    """The points by their residual on the ground, the largest first."""
    return [int(index) for index in np.argsort(-np.linalg.norm(done.residuals_m, axis=1))[:_MOST_POINTS]]


def _number(value: float, unit: str = "") -> str:
    if not math.isfinite(value):
        return tr("unknown")
    words = formatted(value, ".3f" if abs(value) >= 0.001 or value == 0 else ".1e")
    return f"{words} {unit}".strip()
