"""The layer that 'Check a delivery' leaves, as 'Accept or reject a delivery' takes it for SHEETS."""
from __future__ import annotations

from collections.abc import Iterator, Sequence

from qgis.core import QgsFeature, QgsGeometry, QgsWkbTypes

from ..imagery.records import Column
from ..imagery.reference_systems import extent_on
from ..toolkit.algorithms.run import Run
from ..toolkit.layers import rectangle
from ..toolkit.reference_systems import reference_system
from ..toolkit.table_fields import column_features, column_fields
from ..toolkit.translation import sentence
from .measure.delivered_files import CheckedSheet
from .sheet_index import COMPLETE, FINDINGS, LOCATION, STATE

_COLUMNS: tuple[Column[CheckedSheet], ...] = (
    Column("sheet", "text", lambda one: one.sheet.name),
    Column(LOCATION, "text", lambda one: one.sheet.path or None),
    Column(COMPLETE, "integer", lambda one: int(not one.findings)),
    Column(FINDINGS, "text", lambda one: "; ".join(map(sentence, one.findings)) or None),
    Column(STATE, "text", lambda one: one.state.value),
    Column("missing", "real", lambda one: None if one.missing is None else round(100 * one.missing, 4)),
    Column("pixel", "real", lambda one: None if one.raster is None else one.raster.ground_sample_distance),
    Column("bands", "integer", lambda one: None if one.raster is None else len(one.raster.band_names)),
    Column("type", "text", lambda one: None if one.raster is None else one.raster.data_type),
)


def write_checked(run: Run, output: str, found: Sequence[CheckedSheet]) -> str | None:
    """One polygon for each sheet, in the outlines' reference system, else in the first file's; its destination."""
    systems = (one.sheet.wkt or (one.raster.wkt if one.raster else "") for one in found)
    wkt = next((one for one in systems if one), "")
    layout = column_fields(_COLUMNS), QgsWkbTypes.Type.MultiPolygon, reference_system(wkt)
    sink, destination = run.sink(output, *layout)

    def rows() -> Iterator[QgsFeature]:
        for one, row in zip(found, column_features(_COLUMNS, found)):
            row.setGeometry(_outline(one, wkt))
            yield row

    run.write(sink, rows())
    return destination


def _outline(one: CheckedSheet, wkt: str) -> QgsGeometry:
    shape = QgsGeometry()
    if one.sheet.outline is not None:
        shape.fromWkb(one.sheet.outline)
    elif one.raster is not None:
        shape = rectangle(extent_on(one.raster.extent, one.raster.wkt, wkt))
    shape.convertToMultiType()
    return shape
