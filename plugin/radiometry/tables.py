"""The table of a radiometric acceptance: its fields, and rows from results. The field names are contracts."""
from __future__ import annotations

from collections.abc import Iterator

from qgis.core import QgsFeature, QgsFields

from ..toolkit.table_fields import feature, table_fields
from ..toolkit.translation import sentence
from .measure.assessment import Assessment
from .measure.rules import Rule


def radiometry_fields() -> QgsFields:
    """OUTPUT: one row per raster (or window of it), check and band. Shares are fractions of 1; ``passed`` is 1, 0, or
    nothing where the figure can't be measured or has no limit."""
    return table_fields(
        ("raster", "text"),
        ("window_id", "integer"),
        ("band", "text"),
        ("check", "text"),
        ("value", "real"),
        ("limit", "text"),
        ("passed", "integer"),
        ("source", "text"),
        ("reason", "text"),
        ("least", "real"),
        ("most", "real"),
    )


def radiometry_features(result: Assessment) -> Iterator[QgsFeature]:
    """The rows of OUTPUT for an image or a window of it."""
    for checked in result.checked_figures:
        rule = checked.rule
        yield feature(
            radiometry_fields(),
            [
                result.image.ref.name,
                result.window_id,
                checked.band,
                rule.check,
                checked.value,
                limit_text(rule),
                None if checked.passed is None else int(checked.passed),
                rule.source,
                sentence(checked.reason) if checked.reason else None,
                rule.least,
                rule.most,
            ],
        )


def limit_text(rule: Rule) -> str | None:
    """The limits in the unit of the value; None without any."""
    if rule.least is not None and rule.most is not None:
        return f"{rule.least:g} to {rule.most:g}"
    if rule.most is not None:
        return f"<= {rule.most:g}"
    return None if rule.least is None else f">= {rule.least:g}"
