"""SHEETS_OUT: one polygon for each sheet with its verdict, to return rejected ones."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from qgis.core import QgsFeature, QgsGeometry, QgsPointXY

from ...imagery.records import Column
from ...toolkit.table_fields import column_features
from ..measure.decision import AcceptanceOutcome, Decision, MetreFigures
from .words import rounded


@dataclass(frozen=True, eq=False)
class _DecidedSheet:
    figures: MetreFigures
    outcome: AcceptanceOutcome | None  # None without seams, or where the delivery was decided on by a sample
    findings: tuple[str, ...]  # what is wrong with its file; none where that was not looked at


def _word(sheet: _DecidedSheet) -> str | None:
    if not sheet.figures.piece_count:
        return _NO_SEAMS
    return sheet.outcome.value if sheet.outcome else None


_NO_SEAMS = "no_seams"
SHEET_COLUMNS: tuple[Column[_DecidedSheet], ...] = (
    Column("sheet", "text", lambda sheet: sheet.figures.name),
    Column("verdict", "text", _word),
    Column("length", "real", lambda sheet: rounded(sheet.figures.total_m)),
    Column("measured", "real", lambda sheet: rounded(sheet.figures.measured_m)),
    Column("failed", "real", lambda sheet: rounded(sheet.figures.failed_m)),
    Column("failed_share", "real", lambda sheet: (
        None if sheet.figures.failed_share is None else rounded(100 * sheet.figures.failed_share)
    )),
    Column("longest_failure", "real", lambda sheet: rounded(sheet.figures.longest_failure_m)),
    Column("pieces", "integer", lambda sheet: sheet.figures.piece_count),
    Column("failed_pieces", "integer", lambda sheet: sheet.figures.failed_count),
    Column("findings", "text", lambda sheet: "; ".join(sheet.findings) or None),
)


def sheet_features(decision: Decision) -> Iterator[QgsFeature]:
    """In the order of ``decision.sheets``; a sheet of which no place is known has no outline."""
    rings = decision.delivery.sheet_rings()
    findings: dict[str, tuple[str, ...]] = {}
    for sheet in decision.delivery.outlines:
        findings[sheet.name] = (*findings.get(sheet.name, ()), *sheet.findings)
    rows = [
        _DecidedSheet(figures, outcome, findings.get(figures.name, ()))
        for figures, outcome in zip(decision.sheets, decision.sheet_outcomes)
    ]
    for row, feature in zip(rows, column_features(SHEET_COLUMNS, rows)):
        if outline := rings.get(row.figures.name):
            feature.setGeometry(_polygon(outline))
        yield feature


def _polygon(rings: Sequence[np.ndarray]) -> QgsGeometry:
    """What lies within an odd number of rings: parts lie beside each other, holes within parts."""
    shape = QgsGeometry()
    for ring in rings:
        part = QgsGeometry.fromPolygonXY([[QgsPointXY(x, y) for x, y in ring.tolist()]])
        shape = part if shape.isNull() else shape.symDifference(part)
    shape.convertToMultiType()
    return shape
