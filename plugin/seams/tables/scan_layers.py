"""What a scan found as rows of layers, in one GeoPackage: pieces of seam, parts of the sources, the worst places."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Callable

from qgis.core import (
    QgsCoordinateTransformContext,
    QgsFeature,
    QgsFeatureSink,
    QgsFields,
    QgsGeometry,
    QgsLineString,
    QgsRasterLayer,
    QgsVectorFileWriter,
    QgsWkbTypes,
)

from ...imagery import messages as imagery_messages
from ...imagery.atomic_files import whole_file
from ...imagery.errors import SettingsError
from ...toolkit import layers as layers
from ...toolkit.layers import mosaic_crs
from ...toolkit.table_fields import column_features, column_fields, column_values, feature
from ..measure.scan.scan_tables import CELL_COLUMNS, SEAM_COLUMNS
from .result_tables import PLACED_COLUMNS

if TYPE_CHECKING:
    from ..measure.scan.gathering import ScanResult
    from ..measure.scan.scan_request import ScanRequest


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


def write_scan_file(path: Path, result: ScanResult, request: ScanRequest) -> None:
    """Write the file, whole or not at all, with a table for each of ``SCAN_LAYERS``.

    Raises SettingsError when it can't be written.
    """
    crs, writers = mosaic_crs(request.mosaic), QgsVectorFileWriter
    with whole_file(path) as unfinished:
        for layer in SCAN_LAYERS:
            options = writers.SaveVectorOptions()
            options.driverName, options.layerName, options.fileEncoding = "GPKG", layer.name, "UTF-8"
            if unfinished.exists():
                options.actionOnExistingFile = writers.ActionOnExistingFile.CreateOrOverwriteLayer
            writer = writers.create(
                str(unfinished), layer.fields(request.settings.levels), layer.geometry, crs,
                QgsCoordinateTransformContext(), options,
            )
            failed = writer.hasError() != writers.WriterError.NoError
            if not failed:
                rows = layer.rows(result, request)
                failed = not all(writer.addFeature(row, QgsFeatureSink.Flag.FastInsert) for row in rows)
                failed = not writer.flushBuffer() or failed
            error = writer.errorMessage()
            del writer  # closes the file
            if failed:
                raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=path, error=error))
