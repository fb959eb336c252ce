"""What the observer's verdicts say of the measures, as a table. The field names are contracts."""
from __future__ import annotations

from collections.abc import Iterator

from qgis.core import QgsFeature, QgsFields

from ...toolkit.table_fields import feature, table_fields
from ...toolkit.translation import sentence
from ..measure.threshold_calibration import STANDARD_LIMITS, Step, ThresholdCalibration, step_at

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


def calibration_features(found: ThresholdCalibration) -> Iterator[QgsFeature]:
    """The rows of one measure."""
    counts = {"visible": len(found.verdicts.visible), "invisible": len(found.verdicts.invisible)}
    summary = {**_threshold_values(found.best), **counts, "note": " ".join(map(sentence, found.notices)) or None}
    if found.area is not None:
        summary.update(auc=found.area.value, auc_low=found.area.low, auc_high=found.area.high)
    summary.update(zip(("threshold_low", "threshold_high"), found.best_range or ()))
    summary.update(zip(("wanted_visible", "wanted_invisible"), found.wanted or ()))
    summary["neighbourhoods"] = found.neighbourhoods
    yield _row(found, SUMMARY, summary)
    limit = STANDARD_LIMITS.get(found.verdicts.measure)
    if found.steps and limit is not None:
        yield _row(found, STANDARD, {**_threshold_values(step_at(found.verdicts, limit)), **counts})
    for step in found.steps:
        yield _row(found, STEP, {**_threshold_values(step), **counts})


def _threshold_values(step: Step | None) -> dict[str, object]:
    if step is None:
        return {}
    names = ("threshold", "sensitivity", "specificity", "youden", "flagged_visible", "flagged_invisible")
    return {name: getattr(step, name) for name in names}


def _row(found: ThresholdCalibration, kind: str, values: dict[str, object]) -> QgsFeature:
    given = {"measure": found.verdicts.measure, "row": kind, **values}
    return feature(calibration_fields(), [given.get(name) for name, _ in _COLUMNS])
