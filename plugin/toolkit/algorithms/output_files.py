"""Which files an output is, by the value that a user or a model gave it."""
from __future__ import annotations

import os
import re
from typing import NamedTuple

from qgis.core import (
    NULL,
    QgsDataSourceUri,
    QgsProcessing,
    QgsProcessingContext,
    QgsProcessingOutputLayerDefinition,
    QgsProperty,
    QgsVectorFileWriter,
)

RASTER_ENDINGS = ("tif", "tiff")
GEOTIFF_FILES = f"GeoTIFF ({' '.join(f'*.{ending}' for ending in RASTER_ENDINGS)})"
"""What every output raster is: other formats hold no five bands, no float, or can't be written strip by strip."""
_DATABASES = {".gpkg", ".sqlite"}  # files that a table can be added to
_WRITTEN_BESIDE = {  # of formats that are several files, by the ending of the first
    ".shp": (".shx", ".dbf", ".prj", ".cpg"),
    ".tab": (".dat", ".map", ".id", ".ind"),
    ".mif": (".mid",),
    **dict.fromkeys((".bil", ".bip", ".bsq"), (".hdr",)),
}

_SERVER = re.compile(r"^(?!ogr:|spatialite:)[A-Za-z][\w+.-]+:")  # a drive has one letter


class DataPlace(NamedTuple):
    """Where data lie."""

    path: str
    table: str = ""
    """In a database; empty for the whole file."""


def value_text(value: object, context: QgsProcessingContext) -> str:
    """A value that is a text or an expression for one; empty for none."""
    if isinstance(value, QgsProperty):
        value = value.valueAsString(context.expressionContext())[0]
    return str(value) if value is not None and value != NULL else ""


def output_text(value: object, context: QgsProcessingContext) -> str:
    """What an output's value says; empty where it is not wanted, or goes to memory or to a temporary file."""
    text = value_text(value.sink if isinstance(value, QgsProcessingOutputLayerDefinition) else value, context)
    return "" if text == QgsProcessing.TEMPORARY_OUTPUT or text.startswith("memory:") else text


def table_place(text: str) -> DataPlace:
    """The file that a destination of features names, and the table when it is to be added to a database."""
    provider, _, rest = text.partition(":")
    is_uri = provider in ("ogr", "spatialite")
    path = (QgsDataSourceUri(rest).database() or rest) if is_uri else text.partition("|")[0]
    if is_uri and is_database(path):
        return DataPlace(path, QgsDataSourceUri(rest).table())
    is_known = QgsVectorFileWriter.driverForExtension(os.path.splitext(path)[1][1:])
    return DataPlace(path if is_known else path + ".gpkg")  # as QGIS does


def is_file(text: str) -> bool:
    """Whether an output's text names a file, and no table of a server."""
    return _SERVER.match(text) is None


def files_beside(path: str) -> list[str]:
    """What else is written where a format is several files."""
    stem, ending = os.path.splitext(path)
    return [stem + other for other in _WRITTEN_BESIDE.get(ending.lower(), ())]


def is_database(path: str) -> bool:
    """Whether other tables may lie in the same file."""
    return os.path.splitext(path)[1].lower() in _DATABASES
