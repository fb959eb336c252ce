"""SHEETS_OUT: one polygon for each sheet with its verdict, to return rejected ones."""
from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from qgis.core import QgsFeature, QgsGeometry, QgsRectangle

from ...imagery.records import Column
from ...toolkit.layers import rectangle
from ...toolkit.table_fields import column_features
from ..measure.decision import AcceptanceOutcome, Decision, MetreFigures
from ..measure.delivery import Delivery, extent_of
from .words import rounded


@dataclass(frozen=True, eq=False)
class _DecidedSheet:
    figures: MetreFigures
    outcome: AcceptanceOutcome | None  # None without seams, or where the delivery was decided on by a sample
    findings: str  # what is wrong with its file; empty where that was not looked at


_NO_SEAMS = "no_seams"
SHEET_COLUMNS: tuple[Column[_DecidedSheet], ...] = (
    Column("sheet", "text", lambda sheet: sheet.figures.name),
    Column("verdict", "text", lambda sheet: (
        (sheet.outcome.value if sheet.outcome else None) if sheet.figures.piece_count else _NO_SEAMS
    )),
    Column("length", "real", lambda sheet: rounded(sheet.figures.total_m)),
    Column("measured", "real", lambda sheet: rounded(sheet.figures.measured_m)),
    Column("failed", "real", lambda sheet: rounded(sheet.figures.failed_m)),
    Column("failed_share", "real", lambda sheet: (
        None if sheet.figures.failed_share is None else rounded(100 * sheet.figures.failed_share)
    )),
    Column("longest_failure", "real", lambda sheet: rounded(sheet.figures.longest_failure_m)),
    Column("pieces", "integer", lambda sheet: sheet.figures.piece_count),
    Column("failed_pieces", "integer", lambda sheet: sheet.figures.failed_count),
    Column("findings", "text", lambda sheet: sheet.findings or None),
)


def sheet_features(decision: Decision) -> Iterator[QgsFeature]:
    """In the order of ``decision.sheets``; a sheet of which no place is known has no outline."""
    shapes, findings = sheet_shapes(decision.delivery), decision.delivery.findings
    rows = [
        _DecidedSheet(figures, outcome, findings.get(figures.name, ""))
        for figures, outcome in zip(decision.sheets, decision.sheet_outcomes)
    ]
    for row, feature in zip(rows, column_features(SHEET_COLUMNS, rows)):
        feature.setGeometry(shapes.get(row.figures.name, QgsGeometry()))
        yield feature


def sheet_shapes(delivery: Delivery) -> dict[str, QgsGeometry]:
    """Polygons of sheets by their names: as given, or the box around their seams."""
    parts: dict[str, list[QgsGeometry]] = defaultdict(list)
    for outline in delivery.outlines:
        shape = QgsGeometry()
        shape.fromWkb(outline.shape)
        parts[outline.name] += [] if shape.isEmpty() else [shape]
    seams: dict[str, list[np.ndarray]] = defaultdict(list)
    for piece in delivery.pieces:
        seams[piece.sheet].append(piece.vertices)
    boxes = {name: [rectangle(extent_of(lines))] for name, lines in seams.items()}
    shapes = {name: QgsGeometry.collectGeometry(parts[name] or boxes.get(name, [])) for name in delivery.sheets}
    for shape in shapes.values():
        shape.convertToMultiType()
    return shapes


def extent_of_all(delivery: Delivery) -> QgsRectangle:
    """The box around all seams and sheets of a delivery that has seams."""
    box = QgsRectangle(*extent_of(piece.vertices for piece in delivery.pieces))
    for shape in sheet_shapes(delivery).values():
        box.combineExtentWith(shape.boundingBox())
    return box
