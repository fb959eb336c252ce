"""What a scan found as rows of layers, in one GeoPackage: pieces of seam, parts of the sources, the worst places."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsFeature, QgsFields, QgsGeometry, QgsLineString, QgsRasterLayer, QgsWkbTypes

from ...imagery import messages as imagery_messages
from ...imagery.atomic_files import whole_file
from ...imagery.errors import INFO, WARNING, Message, SettingsError
from ...imagery.records import Column
from ...imagery.seam_totals import TOTALS_DOMAIN, PieceState
from ...toolkit.geopackages import write_table
from ...toolkit.layers import rectangle, write_layer_notes
from ...toolkit.table_fields import column_fields, column_values, feature
from ..measure.planning.window_placing import PLACED_COLUMNS
from ..measure.scan import scan_result

if TYPE_CHECKING:
    from ..measure.scan.scan_request import ScanRequest
    from ..measure.scan.scan_result import ScanResult


@dataclass(frozen=True)
class ScanLayer:
    """One of the layers that a scan leaves."""

    name: str  # name of the table in a file of several
    style: str  # style in ``resources/styles``
    geometry: QgsWkbTypes.Type
    columns: Sequence[Column]
    results: Callable[[ScanResult, ScanRequest], Iterable[tuple[object, QgsGeometry]]]
    """What the columns take, and outlines in the mosaic's reference system."""

    def fields(self, levels: int) -> QgsFields:
        """For so many levels."""
        return column_fields(self.columns, levels)

    def rows(self, result: ScanResult, request: ScanRequest) -> Iterator[QgsFeature]:
        """All features."""
        levels = request.settings.levels
        fields = self.fields(levels)
        for result_row, outline in self.results(result, request):
            yield feature(fields, column_values(self.columns, result_row, levels), outline)


def _pieces(result: ScanResult, _request: ScanRequest) -> Iterator[tuple[object, QgsGeometry]]:
    for judged in result.features:
        x, y = judged.piece.vertices.T.tolist()
        yield judged, QgsGeometry(QgsLineString(x, y))


def _cells(result: ScanResult, request: ScanRequest) -> Iterator[tuple[object, QgsGeometry]]:
    for polygon in result.polygons:
        outline = QgsGeometry()
        outline.fromWkb(polygon.wkb)
        yield result.sources[polygon.source], outline


def _worst(result: ScanResult, request: ScanRequest) -> Iterator[tuple[object, QgsGeometry]]:
    grid = request.mosaic.grid
    return ((placed, rectangle(grid.window_extent(placed.window))) for placed in result.worst)


SEAMS = ScanLayer("seams", "seams", QgsWkbTypes.Type.LineString, scan_result.SEAM_COLUMNS, _pieces)
"""One line per piece of seam."""
CELLS = ScanLayer("source_cells", "source_cells", QgsWkbTypes.Type.MultiPolygon, scan_result.CELL_COLUMNS, _cells)
"""One polygon per source."""
WORST = ScanLayer("worst_windows", "placed_windows", QgsWkbTypes.Type.Polygon, PLACED_COLUMNS, _worst)
"""Windows of the least kept places, the least first."""
SCAN_LAYERS = (WORST, SEAMS, CELLS)
"""In the order in which they lie on the map, the topmost first."""


NO_SEAM = Message("Scanned: no seam was found.", INFO)
NONE_FAILED = Message("None of {metres:.0f} m of seams failed.", INFO)
FAILED = Message("{failed:.0f} of {metres:.0f} m failed.", WARNING)
NONE_MEASURED = Message("None of {metres:.0f} m of seams could be measured.", WARNING)
PARTLY_MEASURED = Message("{finding} {lacking:.0f} m not measured.", WARNING)


def scan_finding(pieces: Sequence[scan_result.JudgedPiece]) -> Message:
    """What a scan says in the end: how much failed, and how much could not be measured."""
    states = (), (PieceState.FAILED,), (PieceState.NOT_MEASURED,)
    total, failed, lacking = (scan_result.metres(pieces, *counted) for counted in states)
    finding = NONE_FAILED(metres=total - lacking) if total else NO_SEAM()
    if failed:
        finding = FAILED(failed=failed, metres=total - lacking)
    elif total and round(lacking) == round(total):
        return NONE_MEASURED(metres=total)
    if not round(lacking):
        return finding
    level = finding.level if lacking < scan_result.LEAST_WITHOUT_VERDICT * total else WARNING
    return replace(PARTLY_MEASURED(finding=finding, lacking=lacking), level=level)


def is_picture(layer: QgsRasterLayer) -> bool:
    """Whether a raster is a picture of losses, which lies where its mosaic does, and is no source of it."""
    return layer.bandCount() > 0 and ": kept_1" in layer.bandName(1)


def write_scan_file(path: Path, result: ScanResult, request: ScanRequest) -> None:
    """Write the file, whole or not at all, with a table for each of ``SCAN_LAYERS``.

    Raises SettingsError when it can't be written.
    """
    with whole_file(path) as unfinished:
        for layer in SCAN_LAYERS:
            fields, rows = layer.fields(request.settings.levels), layer.rows(result, request)
            error = write_table(unfinished, layer.name, fields, layer.geometry, request.mosaic.wkt, rows)
            if error is not None:
                raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=path, error=error))
        notes = scan_result.seam_notes(result)
        write_layer_notes(str(unfinished), TOTALS_DOMAIN, notes, SEAMS.name)
