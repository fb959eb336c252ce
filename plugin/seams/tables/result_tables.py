"""The tables of windows as rows of layers.

Columns of what is measured are in ``measure/window/window_tables``; those of a forecast, of placed windows and of a
calibration are here. The field names are contracts.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from qgis.core import QgsFeature, QgsFields, QgsGeometry

from ...imagery.records import Column
from ...imagery.statistics import JUDGING_FIELDS
from ...toolkit.layer_styles import give_titles
from ...toolkit.table_fields import LARGEST_WHOLE, column_fields, column_values, feature, table_fields, whole_number
from ...toolkit.translation import sentence
from ...toolkit.version_differences import field
from ..measure.calibration.threshold_calibration import STANDARD_LIMITS, Step, ThresholdCalibration, step_at
from ..measure.planning.loss_forecast import Forecast, ForecastPair
from ..measure.window.window_result import WindowResult
from ..measure.window.window_tables import MEASURED, WINDOW_FIELDS

give_titles({column.name: column.title for column in WINDOW_FIELDS if column.title})

FORECAST_COLUMNS: tuple[Column[Forecast], ...] = (
    Column("window_id", "integer", lambda forecast: forecast.window_id),
    Column("reason", "text", lambda forecast: forecast.reason),
    Column("sources", "integer", lambda forecast: forecast.sources),
    Column("expected_ratio", "real", lambda forecast: forecast.expected, by_level=True),
    Column("window_kept", "real", lambda forecast: forecast.kept and forecast.kept.window, by_level=True),
    Column("strip_kept", "real", lambda forecast: forecast.kept and forecast.kept.strip, by_level=True),
)
"""OUTPUT of ``predictloss``: one polygon per window."""

FORECAST_PAIR_COLUMNS: tuple[Column[tuple[Forecast, ForecastPair]], ...] = (
    Column("window_id", "integer", lambda row: row[0].window_id),
    Column("source", "text", lambda row: row[1].source),
    Column("other", "text", lambda row: row[1].other),
    Column("band", "text", lambda row: row[0].band),
    Column("rho", "real", lambda row: row[1].feather.rho, by_level=True),
    Column("ratio", "real", lambda row: row[1].feather.ratios, by_level=True),
    Column("window_kept", "real", lambda row: row[1].kept and row[1].kept.window, by_level=True),
    Column("strip_kept", "real", lambda row: row[1].kept and row[1].kept.strip, by_level=True),
    Column("shift_x", "real", lambda row: row[1].shift and row[1].shift.x),
    Column("shift_y", "real", lambda row: row[1].shift and row[1].shift.y),
    Column("resampled", "integer", lambda row: int(row[1].resampled)),
)
"""PAIRS of ``predictloss``: one row per window and pair of sources."""


def output_fields(levels: int, said: Iterable[str]) -> QgsFields:
    """Fields of OUTPUT: those of every window, and what operators said as far as the windows given have it."""
    fields = column_fields(MEASURED, levels)
    for name in said:
        if fields.indexOf(name) < 0:
            fields.append(field(name, JUDGING_FIELDS[name]))
    return fields


def window_feature(result: WindowResult, geometry: QgsGeometry | None, said: Mapping[str, str | None]) -> QgsFeature:
    """The row of OUTPUT for a result; ``said``: what operators said, by the fields' names."""
    levels = result.levels
    fields = output_fields(levels, said)
    values = column_values(MEASURED, result, levels)
    row = feature(fields, [*values, *[None] * (fields.count() - len(values))], geometry)
    for name, value in said.items():
        row[name] = whole_number(value, LARGEST_WHOLE) if JUDGING_FIELDS[name] == "integer" else value
    return row


SUMMARY, STANDARD, STEP = "summary", "standard", "step"
_COLUMNS = (
    ("measure", "text"),
    ("row", "text"),  # summary: the threshold to set; standard: the plugin's own; step: every other
    ("threshold", "real"),
    ("sensitivity", "real"),
    ("specificity", "real"),
    ("youden", "real"),
    ("flagged_visible", "integer"),
    ("flagged_invisible", "integer"),
    ("visible", "integer"),
    ("invisible", "integer"),
    ("auc", "real"),
    ("auc_low", "real"),
    ("auc_high", "real"),
    ("threshold_low", "real"),
    ("threshold_high", "real"),
    ("wanted_visible", "integer"),
    ("wanted_invisible", "integer"),
    ("neighbourhoods", "integer"),
    ("note", "text"),
)


def calibration_fields() -> QgsFields:
    """OUTPUT of ``calibratethreshold``: for each measure a summary, the standard limit, and all steps."""
    return table_fields(*_COLUMNS)


def calibration_features(calibration: ThresholdCalibration) -> Iterator[QgsFeature]:
    """The rows of one measure."""
    counts = {"visible": len(calibration.verdicts.visible), "invisible": len(calibration.verdicts.invisible)}
    note = " ".join(map(sentence, calibration.notices)) or None
    summary = {**_threshold_values(calibration.best), **counts, "note": note}
    if calibration.area is not None:
        summary.update(auc=calibration.area.value, auc_low=calibration.area.low, auc_high=calibration.area.high)
    summary.update(zip(("threshold_low", "threshold_high"), calibration.best_range or ()))
    summary.update(zip(("wanted_visible", "wanted_invisible"), calibration.wanted or ()))
    summary["neighbourhoods"] = calibration.neighbourhoods
    yield _row(calibration, SUMMARY, summary)
    limit = STANDARD_LIMITS.get(calibration.verdicts.measure)
    if calibration.steps and limit is not None:
        yield _row(calibration, STANDARD, {**_threshold_values(step_at(calibration.verdicts, limit)), **counts})
    for step in calibration.steps:
        yield _row(calibration, STEP, {**_threshold_values(step), **counts})


def _threshold_values(step: Step | None) -> dict[str, object]:
    if step is None:
        return {}
    names = ("threshold", "sensitivity", "specificity", "youden", "flagged_visible", "flagged_invisible")
    return {name: getattr(step, name) for name in names}


def _row(calibration: ThresholdCalibration, kind: str, values: dict[str, object]) -> QgsFeature:
    given = {"measure": calibration.verdicts.measure, "row": kind, **values}
    return feature(calibration_fields(), [given.get(name) for name, _ in _COLUMNS])
