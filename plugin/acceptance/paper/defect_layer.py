"""DEFECTS: one feature per failure, for the producer. The field names are contracts."""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from qgis.core import QgsFeature, QgsFields, QgsGeometry, QgsLineString

from ...toolkit.table_fields import Column, column_features, column_fields
from ..measure.defects import Defect


@dataclass(frozen=True)
class DefectRow:
    """A failure and the file that shows it."""

    defect: Defect
    picture: str
    """Its path from the layer's folder; empty for none."""


def _rounded(value: float | None) -> float | None:
    """People read this layer: no digits that mean nothing."""
    return None if value is None else round(value, 3)


def _coordinate(value: float) -> float:
    """To a millimetre or so, in metres as in degrees."""
    return float(f"{value:.10g}")


DEFECT_COLUMNS: tuple[Column[DefectRow], ...] = (
    Column("defect", "integer", lambda one: one.defect.number),
    Column("sheet", "text", lambda one: ", ".join(one.defect.sheets)),
    Column("length", "real", lambda one: _rounded(one.defect.length_m)),
    Column("kept_1", "real", lambda one: _rounded(one.defect.worst.piece.kept_1)),
    Column("kept_low", "real", lambda one: _rounded(one.defect.worst.piece.kept_low)),
    Column("kept_high", "real", lambda one: _rounded(one.defect.worst.piece.kept_high)),
    Column("band_width", "real", lambda one: _rounded(one.defect.band_width_m)),
    Column("cause", "text", lambda one: one.defect.cause or None),
    Column("left_source", "text", lambda one: one.defect.worst.piece.left_source or None),
    Column("right_source", "text", lambda one: one.defect.worst.piece.right_source or None),
    Column("left_date", "text", lambda one: one.defect.worst.piece.left_date or None),
    Column("right_date", "text", lambda one: one.defect.worst.piece.right_date or None),
    Column("x", "real", lambda one: _coordinate(one.defect.place[0])),
    Column("y", "real", lambda one: _coordinate(one.defect.place[1])),
    Column("remark", "text", lambda one: "; ".join(one.defect.remarks) or None),
    Column("picture", "text", lambda one: one.picture or None),
)


def defect_fields() -> QgsFields:
    return column_fields(DEFECT_COLUMNS)


def defect_features(defects: Sequence[Defect], pictures: Mapping[int, str]) -> Iterator[QgsFeature]:
    """``pictures``: paths from the layer's folder, by the failures' numbers."""
    rows = [DefectRow(one, pictures.get(one.number, "")) for one in defects]
    for row, feature in zip(rows, column_features(DEFECT_COLUMNS, rows)):
        lines = (QgsGeometry(QgsLineString(*line.T.tolist())) for line in row.defect.lines)
        whole = QgsGeometry.collectGeometry(list(lines)).mergeLines()
        whole.convertToMultiType()
        feature.setGeometry(whole)
        yield feature
