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
    Column("sheet", "text", lambda checked: checked.sheet.name),
    Column(LOCATION, "text", lambda checked: checked.sheet.path or None),
    Column(COMPLETE, "integer", lambda checked: int(not checked.findings)),
    Column(FINDINGS, "text", lambda checked: "; ".join(map(sentence, checked.findings)) or None),
    Column(STATE, "text", lambda checked: checked.state.value),
    Column("missing", "real", lambda checked: None if checked.missing is None else round(100 * checked.missing, 4)),
    Column("pixel", "real", lambda checked: None if checked.raster is None else checked.raster.ground_sample_distance),
    Column("bands", "integer", lambda checked: None if checked.raster is None else len(checked.raster.band_names)),
    Column("type", "text", lambda checked: None if checked.raster is None else checked.raster.data_type),
)


def write_checked(run: Run, output: str, sheets: Sequence[CheckedSheet]) -> str | None:
    """One polygon for each sheet, in the outlines' reference system, else in the first file's; its destination."""
    systems = (checked.sheet.wkt or (checked.raster.wkt if checked.raster else "") for checked in sheets)
    wkt = next((system for system in systems if system), "")
    layout = column_fields(_COLUMNS), QgsWkbTypes.Type.MultiPolygon, reference_system(wkt)
    sink, destination = run.sink(output, *layout)

    def rows() -> Iterator[QgsFeature]:
        for checked, row in zip(sheets, column_features(_COLUMNS, sheets)):
            row.setGeometry(_outline(checked, wkt))
            yield row

    run.write(sink, rows())
    return destination


def _outline(checked: CheckedSheet, wkt: str) -> QgsGeometry:
    shape = QgsGeometry()
    if checked.sheet.outline is not None:
        shape.fromWkb(checked.sheet.outline)
    elif checked.raster is not None:
        shape = rectangle(extent_on(checked.raster.extent, checked.raster.wkt, wkt))
    shape.convertToMultiType()
    return shape
