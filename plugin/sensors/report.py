"""Reports of sensor models."""
from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from ..imagery.message import Message
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages import html_page
from ..toolkit.translation import sentence, tr
from .charts import comparison_chart, residual_chart
from .measure.adjustment import Accuracy, Adjustment
from .measure.comparison import LEAVE_ONE_OUT, Comparison
from .measure.control_coverage import ControlCoverage, ImageBox
from .measure.models.registry import Variant

_MOST_POINTS = 200  # listed one by one


def save_fit_report(
    done: Adjustment,
    coverage: ControlCoverage,
    box: ImageBox,
    warnings: Sequence[Message],
    notes: Sequence[Message],
    path: Path,
) -> None:
    """The report of one model. Raises SettingsError where no file can be written."""
    parts = [html_page.paragraph(sentence(notice), "warning") for notice in warnings]
    parts += [html_page.paragraph(sentence(notice)) for notice in notes]
    request, fitted = done.request, done.fitted
    parts += [
        html_page.heading(tr("Model")),
        html_page.table(
            (tr("Property"), tr("Value")),
            [
                (tr("Model"), request.name),
                (tr("Unknowns"), _unknowns(request.variant)),
                (tr("Control points"), done.control.count),
                (tr("Iterations"), fitted.iterations),
                (tr("Condition number"), f"{fitted.condition:.3g}"),
                (tr("Standard deviation of a control point"), _number(done.sigma_px, "px")),
                (tr("Image outside the control points' outline"), f"{coverage.extrapolated:.0%}"),
            ],
        ),
        html_page.heading(tr("Accuracy")),
        html_page.table(
            (
                tr("Points"), tr("Count"), tr("Mean X (m)"), tr("Mean Y (m)"), tr("Largest X (m)"), tr("Largest Y (m)"),
                tr("Mean column (px)"), tr("Mean row (px)"),
            ),
            [(tr("Check points"), *_errors(done.check)), (tr("Control points"), *_errors(done.control))],
        ),
        html_page.paragraph(
            tr(
                "Mean errors are root mean squares. Only check points, which took no part in the fit, say how accurate "
                "the image becomes."
            ),
            "small",
        ),
        html_page.heading(tr("Residuals")),
        html_page.drawing(
            svg_text(residual_chart(done, coverage, box)),
            tr("Model minus measured in the image, enlarged; the shaded outline holds what is not extrapolated."),
        ),
        html_page.heading(tr("Points")),
        html_page.table(
            (tr("Point"), tr("Role"), tr("Column (px)"), tr("Row (px)"), "X (m)", "Y (m)", tr("Blunder")),
            [
                (
                    done.points.ids[index],
                    tr("check") if done.points.check[index] else tr("control"),
                    *(_number(value) for value in done.residuals_px[index]),
                    *(_number(value) for value in done.residuals_m[index]),
                    tr("yes") if done.blunder[index] else "",
                )
                for index in _worst(done)
            ],
        ),
    ]  # fmt: skip
    html_page.save_page(html_page.page(tr("Sensor model: {name}").format(name=request.name), parts), path)


def save_comparison_report(result: Comparison, notices: Sequence[Message], path: Path) -> None:
    """The report of all models. Raises SettingsError where no file can be written."""
    how = (
        tr("Each point was predicted by a fit to all others (leave-one-out), since check points are few.")
        if result.method == LEAVE_ONE_OUT
        else tr("Errors are those of check points, which took no part in the fit.")
    )
    parts = [
        html_page.paragraph(sentence(result.reason)),
        *(html_page.paragraph(sentence(notice), "warning") for notice in notices),
        html_page.drawing(svg_text(comparison_chart(result)), tr("The recommended model stands out.")),
        html_page.heading(tr("Table")),
        html_page.table(
            (
                tr("Model"), tr("Mean X (m)"), tr("Mean Y (m)"), tr("Largest X (m)"), tr("Largest Y (m)"),
                tr("Control points"), tr("Judged on"),
            ),
            [
                (
                    _unbroken(row.request.name),
                    *_errors(row.errors)[1:5],
                    row.control_count,
                    row.errors.count,
                )
                for row in result.rows
                if row.errors is not None
            ],
        ),
        html_page.paragraph(how + " " + tr("Mean errors are root mean squares."), "small"),
    ]  # fmt: skip
    doubtful = [(_unbroken(row.request.name), sentence(row.reason)) for row in result.rows if row.reason is not None]
    if doubtful:
        parts.append(html_page.heading(tr("Not fitted, or not to be trusted")))
        parts.append(html_page.table((tr("Model"), tr("Why")), doubtful))
    html_page.save_page(html_page.page(tr("Sensor models compared"), parts), path)


def _unknowns(variant: Variant) -> str:
    words = tr("{count}, held by priors") if variant.with_priors else "{count}"
    return words.format(count=variant.with_priors or variant.unknowns)


def _unbroken(name: str) -> str:
    """A name that no line break parts."""
    return name.replace(" ", "\N{NO-BREAK SPACE}")


def _errors(errors: Accuracy) -> tuple[object, ...]:
    values = (errors.rmse_x, errors.rmse_y, errors.max_x, errors.max_y, errors.rmse_column, errors.rmse_row)
    return errors.count, *("" if value is None else _number(value) for value in values)


def _worst(done: Adjustment) -> list[int]:
    """The points by their residual on the ground, the largest first."""
    return [int(index) for index in np.argsort(-np.linalg.norm(done.residuals_m, axis=1))[:_MOST_POINTS]]


def _number(value: float, unit: str = "") -> str:
    if not math.isfinite(value):
        return tr("unknown")
    words = f"{value:.3f}" if abs(value) >= 0.001 or value == 0 else f"{value:.1e}"
    return f"{words} {unit}".strip()
