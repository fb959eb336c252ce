"""What a scan found as rows of layers: its pieces of seam, the parts of its sources, its worst places."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING, Callable

from qgis.core import QgsFeature, QgsFields, QgsGeometry, QgsLineString, QgsRasterLayer, QgsWkbTypes

from ...toolkit import layers as layers
from ...toolkit.table_fields import column_features, column_fields, column_values, feature
from ..measure.scan.results.scan_tables import CELL_COLUMNS, SEAM_COLUMNS
from .result_tables import PLACED_COLUMNS

if TYPE_CHECKING:
    from ..measure.scan.inputs.scan_request import ScanRequest
    from ..measure.scan.results.gathering import ScanResult


@dataclass(frozen=True)
class ScanLayer:
    """One of the layers that a scan leaves."""

    name: str
    """Of the table in a file of several."""
    style: str
    """Of ``resources/styles``."""
    geometry: QgsWkbTypes.Type
    fields: Callable[[int], QgsFields]
    """For so many levels."""
    rows: Callable[[ScanResult, ScanRequest], Iterator[QgsFeature]]
    """The geometries are in the mosaic's reference system."""


def _seam_fields(levels: int) -> QgsFields:
    return column_fields(SEAM_COLUMNS, levels)


def _seam_rows(result: ScanResult, request: ScanRequest) -> Iterator[QgsFeature]:
    levels = request.settings.levels
    for row, one in zip(column_features(SEAM_COLUMNS, result.pieces, levels), result.pieces):
        x, y = one.piece.vertices.T.tolist()
        row.setGeometry(QgsGeometry(QgsLineString(x, y)))
        yield row


def _cell_fields(_levels: int) -> QgsFields:
    return column_fields(CELL_COLUMNS)


def _cell_rows(result: ScanResult, request: ScanRequest) -> Iterator[QgsFeature]:
    fields = column_fields(CELL_COLUMNS)
    for one in result.polygons:
        outline = QgsGeometry()
        outline.fromWkb(one.wkb)
        yield feature(fields, column_values(CELL_COLUMNS, request.sources[one.source].ref.name), outline)


def _worst_fields(_levels: int) -> QgsFields:
    return column_fields(PLACED_COLUMNS)


def _worst_rows(result: ScanResult, request: ScanRequest) -> Iterator[QgsFeature]:
    fields, grid = column_fields(PLACED_COLUMNS), request.mosaic.grid
    for placed in result.worst:
        outline = layers.rectangle(grid.window_extent(placed.window))
        yield feature(fields, column_values(PLACED_COLUMNS, placed), outline)


SEAMS = ScanLayer("seams", "seams", QgsWkbTypes.Type.LineString, _seam_fields, _seam_rows)
"""One line per piece of seam."""
CELLS = ScanLayer("source_cells", "source_cells", QgsWkbTypes.Type.MultiPolygon, _cell_fields, _cell_rows)
"""One polygon per source."""
WORST = ScanLayer("worst_windows", "placed_windows", QgsWkbTypes.Type.Polygon, _worst_fields, _worst_rows)
"""Windows of the least kept places, the least first."""
SCAN_LAYERS = (WORST, SEAMS, CELLS)
"""In the order in which they lie on the map, the topmost first."""


def is_picture(layer: QgsRasterLayer) -> bool:
    """Whether a raster is a picture of losses, which lies where its mosaic does, and is no source of it."""
    return layer.bandCount() > 0 and ": kept_1" in layer.bandName(1)
