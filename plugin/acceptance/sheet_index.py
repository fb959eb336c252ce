"""An index of sheets, polygons such as gdaltindex writes: which sheet of one large mosaic a piece of seam lies in."""
from __future__ import annotations

import os
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from qgis.core import QgsCsException, QgsGeometry, QgsPoint, QgsRectangle, QgsSpatialIndex, QgsWkbTypes

from ..imagery.errors import SettingsError
from ..imagery.gdal_paths import path_from
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.reference_systems import reference_system
from ..toolkit.table_fields import Attributes, attributes, text
from ..toolkit.translation import tr
from .measure import messages

if TYPE_CHECKING:
    from .measure.delivery import Delivery, SheetOutline

SHEETS = "SHEETS"
COMPLETE, FINDINGS, LOCATION, STATE = "complete", "findings", "location", "state"
"""Fields of 'Check a delivery': whether nothing was found at a sheet, what was, its file, and its ``SheetState``."""
_NAME_FIELDS = ("sheet", "name", "location", "tile", "id")
"""The first that a layer has says what its sheets are called; of a file's path its name."""


def add_sheets(algorithm: SeamInspectorAlgorithm) -> None:
    algorithm.addDescribed(common.features(SHEETS, tr("Sheets"), common.POLYGON, optional=True), tr(
        "Outlines of the sheets if all were scanned as one mosaic: an index as gdaltindex writes it, or polygons with "
        "a field sheet or name. Empty: each layer of seams is a sheet, unless its field sheet says otherwise."
    ))


def with_sheets(delivery: Delivery, run: Run) -> Delivery:
    """The pieces with the sheets that their middles lie in, and all outlines, where SHEETS is given.

    Pieces in no sheet keep theirs, which is told.

    Raises SettingsError where the polygons have no names or no numbers for coordinates, or none holds a piece.
    """
    if not run.parameters.get(SHEETS):
        return delivery
    rows, is_checked = _sheet_rows(run, SHEETS)
    transform = run.transform(run.source(SHEETS), reference_system(delivery.wkt))
    shapes: list[tuple[str, QgsGeometry]] = []
    outlines = []
    for name, row in rows:
        shape = QgsGeometry(row.feature.geometry())
        try:
            shape.transform(transform)
        except QgsCsException:
            raise SettingsError(messages.NOT_TRANSFORMED(name=run.source(SHEETS).sourceName())) from None
        shapes.append((name, shape))
        outlines.append(_sheet_outline(name, shape, row if is_checked else None))
    sheets = _names_at(shapes, [piece.middle for piece in delivery.pieces])
    outside = sum(sheet is None for sheet in sheets)
    if outside == len(sheets):
        raise SettingsError(messages.SHEETS_ELSEWHERE())
    if outside:
        run.tell(messages.PIECES_OFF_SHEETS(count=outside))
    pieces = tuple(
        replace(piece, sheet=sheet or piece.sheet, scan=piece.seam[0])
        for piece, sheet in zip(delivery.pieces, sheets)
    )
    return replace(delivery, pieces=pieces, outlines=tuple(outlines), is_checked=is_checked)


def _sheet_outline(name: str, shape: QgsGeometry, checked: Attributes | None) -> SheetOutline:
    """``checked``: what 'Check a delivery' wrote of the sheet; None where the index does not come from it."""
    from .measure.delivery import SheetOutline, SheetState

    flat = shape.coerceToType(QgsWkbTypes.Type.MultiPolygon)
    findings, state = (text(checked[FINDINGS]), text(checked[STATE])) if checked else ("", "")
    wkb = bytes(flat[0].asWkb()) if flat else b""
    return SheetOutline(name, wkb, findings, SheetState.of_word(state))


def _names_at(outlines: list[tuple[str, QgsGeometry]], places: list[tuple[float, float]]) -> list[str | None]:
    """The first sheet that holds each place, its border included; None where none does."""
    index, engines = QgsSpatialIndex(), {}
    for number, (_, outline) in enumerate(outlines):
        if not outline.isEmpty():
            index.addFeature(number, outline.boundingBox())
            engines[number] = QgsGeometry.createGeometryEngine(outline.constGet())
            engines[number].prepareGeometry()
    return [
        next((outlines[i][0] for i in sorted(index.intersects(QgsRectangle(*place, *place)))
              if engines[i].intersects(QgsPoint(*place))), None)
        for place in places
    ]  # fmt: skip


def index_rows(run: Run, parameter: str, index_path: str) -> Iterator[tuple[str, str, bytes, str]]:
    """Name of each sheet, its file where the index names one, its outline as WKB and that one's reference system.

    ``index_path``: the index's own file, at whose folder paths start. Raises SettingsError for sheets without a name or
    a place.
    """
    from ..toolkit.layers import system_wkt

    wkt, folder = system_wkt(run.source(parameter).sourceCrs()), os.path.dirname(index_path)
    for name, row in _sheet_rows(run, parameter)[0]:
        path = text(row[LOCATION])
        yield name, path_from(folder, path) if path else "", bytes(row.feature.geometry().asWkb()), wkt


def _sheet_rows(run: Run, parameter: str) -> tuple[list[tuple[str, Attributes]], bool]:
    """The sheets by name, and whether they come from 'Check a delivery'.

    Raises SettingsError where one has no name or no place.
    """
    from ..toolkit.layers import features, has_numbers

    source = run.source(parameter)
    names = source.fields().names()
    field = next((name for wanted in _NAME_FIELDS for name in names if name.lower() == wanted), None)
    if field is None:
        raise SettingsError(messages.SHEETS_WITHOUT_NAMES(fields=", ".join(_NAME_FIELDS)))
    rows = list(attributes(features(source), names))
    for number, row in enumerate(rows, 1):
        if not text(row[field]).strip():
            raise SettingsError(messages.SHEET_WITHOUT_NAME(number=number, field=field))
        if not has_numbers(row.feature.geometry()):
            raise SettingsError(messages.SHEET_WITHOUT_PLACE(name=text(row[field])))
    return [(Path(text(row[field])).stem, row) for row in rows], {COMPLETE, FINDINGS} <= set(names)
