"""New GeoPackages of ours."""
from __future__ import annotations

import os
from collections.abc import Iterable
from itertools import chain, count
from pathlib import Path

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransformContext,
    QgsFeature,
    QgsFeatureSink,
    QgsFields,
    QgsVectorFileWriter,
    QgsWkbTypes,
)


def free_path(folder: Path, name: str) -> Path:
    """For a file: one that is not there yet."""
    names = chain([f"{name}.gpkg"], (f"{name}_{number}.gpkg" for number in count(2)))
    return next(path for path in map(folder.joinpath, names) if not os.path.lexists(path))


def write_table(
    path: Path, name: str, fields: QgsFields, geometry: QgsWkbTypes.Type, crs: QgsCoordinateReferenceSystem,
    rows: Iterable[QgsFeature] = (),
) -> str | None:
    """Write a table into a file, beside those that it has; None, or what is said of why it can't be."""
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName, options.layerName, options.fileEncoding = "GPKG", name, "UTF-8"
    if path.exists():
        options.actionOnExistingFile = QgsVectorFileWriter.ActionOnExistingFile.CreateOrOverwriteLayer
    writer = QgsVectorFileWriter.create(str(path), fields, geometry, crs, QgsCoordinateTransformContext(), options)
    is_whole = writer.hasError() == QgsVectorFileWriter.WriterError.NoError
    if is_whole:
        is_whole = all(writer.addFeature(row, QgsFeatureSink.Flag.FastInsert) for row in rows)
        is_whole = writer.flushBuffer() and is_whole
    error = str(writer.errorMessage())
    del writer  # closes the file
    return None if is_whole else error
