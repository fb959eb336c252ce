"""The table of a radiometric acceptance: its fields, and rows from results. The field names are contracts."""
from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from qgis.core import QgsFeature, QgsFields

from ..toolkit.table_fields import Column, column_features, column_fields
from ..toolkit.translation import sentence
from .measure.assessment import Assessment, CheckedFigure
from .measure.rules import Rule


class _Row(NamedTuple):
    result: Assessment
    checked: CheckedFigure


_COLUMNS: tuple[Column[_Row], ...] = (
    Column("raster", "text", lambda row: row.result.image.ref.name),
    Column("window_id", "integer", lambda row: row.result.window_id),
    Column("band", "text", lambda row: row.checked.band),
    Column("check", "text", lambda row: row.checked.rule.check),
    Column("value", "real", lambda row: row.checked.value),
    Column("limit", "text", lambda row: limit_text(row.checked.rule)),
    Column("passed", "integer", lambda row: None if row.checked.passed is None else int(row.checked.passed)),
    Column("source", "text", lambda row: row.checked.rule.source),
    Column("reason", "text", lambda row: sentence(row.checked.reason) if row.checked.reason else None),
    Column("least", "real", lambda row: row.checked.rule.least),
    Column("most", "real", lambda row: row.checked.rule.most),
)


def radiometry_fields() -> QgsFields:
    """OUTPUT: one row per raster (or window of it), check and band. Shares are fractions of 1; ``passed`` is 1, 0, or
    nothing where the figure can't be measured or has no limit."""
    return column_fields(_COLUMNS)


def radiometry_features(result: Assessment) -> Iterator[QgsFeature]:
    """The rows of OUTPUT for an image or a window of it."""
    return column_features(_COLUMNS, (_Row(result, checked) for checked in result.checked_figures))


def limit_text(rule: Rule) -> str | None:
    """The limits in the unit of the value; None without any."""
    if rule.least is not None and rule.most is not None:
        return f"{rule.least:g} to {rule.most:g}"
    if rule.most is not None:
        return f"<= {rule.most:g}"
    return None if rule.least is None else f">= {rule.least:g}"
