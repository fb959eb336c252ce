"""The layers of a scan in one GeoPackage."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateTransformContext, QgsFeatureSink, QgsVectorFileWriter

from ...imagery import messages as imagery_messages
from ...imagery.atomic_files import whole_file
from ...imagery.errors import SettingsError
from ...toolkit.layers import mosaic_crs
from .scan_layers import SCAN_LAYERS

if TYPE_CHECKING:
    from ..measure.scan.inputs.scan_request import ScanRequest
    from ..measure.scan.results.gathering import ScanResult


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
