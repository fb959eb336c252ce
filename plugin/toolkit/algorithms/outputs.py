"""The outputs of a run: which files they are, and that they can be written, and over no input.

They are held against what they name before anything is measured or written.
"""
from __future__ import annotations

import os
import re
from collections.abc import Iterator
from itertools import chain
from pathlib import Path
from typing import Any

from qgis.core import (
    NULL,
    QgsDataSourceUri,
    QgsMapLayer,
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeatureSourceDefinition,
    QgsProcessingOutputLayerDefinition,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterRasterDestination,
    QgsProcessingUtils,
    QgsProject,
    QgsProperty,
    QgsProviderRegistry,
    QgsVectorFileWriter,
    QgsVirtualLayerDefinition,
)
from qgis.PyQt.QtCore import QUrl

from ...imagery import messages as imagery_messages
from ...imagery.errors import SettingsError
from ...imagery.file_identity import DataPlace, check_can_be_written, check_is_file, check_outputs, is_database
from ...imagery.gdal_paths import FEATURES, open_dataset, path_from
from .. import messages
from . import parameters as common

RASTER_ENDINGS = ("tif", "tiff")
GEOTIFF_FILES = f"GeoTIFF ({' '.join(f'*.{ending}' for ending in RASTER_ENDINGS)})"
"""What every output raster is: other formats hold no five bands, no float, or can't be written strip by strip."""
_SERVER = re.compile(r"^(?!ogr:|spatialite:)[A-Za-z][\w+.-]+:")  # a drive has one letter
_ADDRESSES = ("ogr:", "spatialite:")
_MISREAD = re.compile(r"[:\\]|\|(?!layer(name|id)=)|%[0-9A-Fa-f]{2}(?=[^/]*\.(gpkg|sqlite)$)", re.I)
"""What of a file's name QGIS takes for a provider, a folder or a part of an address, SQLite for another character."""
_NO_TABLE_BEGINS_WITH = "`~!@#$%^&*()+-={}|[]\\:\";'<>?,/"  # as GDAL's GeoPackage has it
_OF_WORDS_AND_NUMBERS = {"boolean", "enum", "number", "range", "string"}  # parameters that name no file


def value_text(value: object, context: QgsProcessingContext) -> str:
    """A value that is a text or an expression for one; empty for none."""
    if isinstance(value, QgsProperty):
        value = value.valueAsString(context.expressionContext())[0]
    return str(value) if value is not None and value != NULL else ""


def output_text(value: object, context: QgsProcessingContext) -> str:
    """The text of an output's value; empty where it is not wanted, or goes to memory or to a temporary file."""
    text = value_text(value.sink if isinstance(value, QgsProcessingOutputLayerDefinition) else value, context)
    return "" if text == QgsProcessing.TEMPORARY_OUTPUT or text.startswith("memory:") else text


def table_place(text: str) -> DataPlace:
    """The file that a destination of features names, and the table when it is to be added to a database."""
    provider, _, rest = text.partition(":")
    is_uri = f"{provider}:" in _ADDRESSES
    path = (QgsDataSourceUri(rest).database() or rest) if is_uri else text.partition("|")[0]
    if is_uri and is_database(path):
        return DataPlace(path, QgsDataSourceUri(rest).table())
    is_known = QgsVectorFileWriter.driverForExtension(os.path.splitext(path)[1][1:])
    return DataPlace(path if is_known else path + ".gpkg")  # as QGIS does


def is_file(text: str) -> bool:
    """Whether an output's text names a file, and no table of a server."""
    return _SERVER.match(text) is None


def refuse_outputs(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> None:
    """Raise SettingsError for outputs that can't be where they are to go, that are one file, or a file of an input,
    sidecars included, and for files and rasters whose endings say something else than is written."""
    wanted, endings = [], []
    for definition in algorithm.destinationParameterDefinitions():
        if text := output_text(parameters.get(definition.name()), context):
            _refuse_impossible(definition, text)
            is_sink = isinstance(definition, QgsProcessingParameterFeatureSink)
            place = table_place(text) if is_sink else DataPlace(text)
            wanted.append((title := definition.description(), place))
            if place.path != text and os.path.isfile(text):  # though a layer of that name gets another ending
                wanted.append((title, DataPlace(text)))
            is_raster = isinstance(definition, QgsProcessingParameterRasterDestination) and Path(text).suffix
            is_other = isinstance(definition, QgsProcessingParameterFileDestination) and Path(text).name
            endings.append((Path(text), GEOTIFF_FILES if is_raster else definition.fileFilter() if is_other else ""))
    check_outputs(wanted, _inputs(algorithm, parameters, context), _indexed(algorithm, parameters, context))
    for path, filters in endings:
        if filters and path.suffix.lower() not in re.findall(r"\*(\.\w+)", filters):
            raise SettingsError(messages.FILE_FORMAT_OTHER(name=path.name, filters=filters.replace(";;", ", ")))


def check_chosen_file(path: Path) -> None:
    """Raise SettingsError for a file to be saved that belongs to a layer of the project: it is chosen by its name."""
    if path.exists():
        context, project = QgsProcessingContext(), QgsProject.instance()
        context.setProject(project)
        layers = (_places(layer, layer.providerType(), context) for layer in project.mapLayers().values())
        check_outputs([(path.name, DataPlace(str(path)))], chain.from_iterable(layers))


def _refuse_impossible(definition: QgsProcessingParameterDefinition, text: str) -> None:
    """Raise SettingsError for an output of features or a raster that can't be written where it is to go.

    Pages and charts are written last, and what keeps them from that is told then: it costs nothing that was measured.
    """
    title, is_raster = definition.description(), isinstance(definition, QgsProcessingParameterRasterDestination)
    check_is_file(title, text)
    if not is_raster and not (isinstance(definition, QgsProcessingParameterFeatureSink) and is_file(text)):
        return  # of a database server QGIS asks and tells itself
    if not text.strip() or not is_file(text) or (is_raster and text.startswith("ogr:")):
        raise SettingsError(imagery_messages.OUTPUT_NAMES_NO_FILE(output=title, path=text))
    place = DataPlace(text) if is_raster else table_place(text)
    is_folder = text.endswith(("/", os.sep)) or (os.path.exists(text) and not os.path.isfile(text))
    path = text if is_folder else place.path
    check_can_be_written(title, path)
    if is_raster:
        return
    begins = os.path.basename(path)[0] if is_database(path) and not place.table else ""
    shown = os.path.splitdrive(path if text.startswith(_ADDRESSES) else text)[1].replace(os.sep, "/")
    misread = _MISREAD.search(shown)
    if misread or (begins and begins in _NO_TABLE_BEGINS_WITH):
        raise SettingsError(messages.NAME_MISREAD(output=title, path=text, found=misread[0] if misread else begins))


def _inputs(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Iterator[DataPlace]:
    """The files and tables that each input names."""
    for definition in algorithm.parameterDefinitions():
        if not definition.isDestination() and definition.type() not in _OF_WORDS_AND_NUMBERS:
            value = parameters.get(definition.name())
            is_list_of_layers = definition.type() == "multilayer" and not common.takes_rasters(definition)
            is_vector = is_list_of_layers or definition.type() in ("source", "vector")
            yield from _places(value, "ogr" if is_vector else "gdal", context)


def _places(
    value: object, provider: str, context: QgsProcessingContext, queries: frozenset[str] = frozenset()
) -> Iterator[DataPlace]:
    """The files and tables that a value names: a layer, its id, name or address, a path, or a list of those.

    ``queries``: virtual layers on the way to it, which may name each other.
    """
    if isinstance(value, (list, tuple)):
        for item in value:
            yield from _places(item, provider, context, queries)
        return
    if isinstance(value, QgsProcessingFeatureSourceDefinition):
        value = value.source
    text = "" if isinstance(value, QgsMapLayer) else value_text(value, context)
    layer = QgsProcessingUtils.mapLayerFromString(text, context, False) if text else value
    named, key, source = QgsProcessingUtils.decodeProviderKeyAndUri(text)
    if isinstance(layer, QgsMapLayer):
        key, source = layer.providerType(), layer.source()
    elif not named:
        key, source = provider, text
    if key == "virtual":
        if source not in queries:
            yield from _queried(source, context, queries | {source})
        return
    parts = QgsProviderRegistry.instance().decodeUri(key, source)
    path = parts.get("path") or ""
    if is_database(path):
        yield DataPlace(path, _table(parts))
    elif path:
        yield DataPlace(path)
        yield DataPlace(source)  # in an archive, or a part of a file


def _queried(source: str, context: QgsProcessingContext, queries: frozenset[str]) -> Iterator[DataPlace]:
    """The sources of a virtual layer: layers that it brings along, and layers of the project that its query names."""
    definition = QgsVirtualLayerDefinition.fromUrl(QUrl.fromEncoded(source.encode()))
    for layer in definition.sourceLayers():
        address = layer.reference() if layer.isReferenced() else f"{layer.provider()}://{layer.source()}"
        yield from _places(address, "ogr", context, queries)
    project = context.project()
    for layer in project.mapLayers().values() if project is not None else ():
        names = "|".join(map(re.escape, (layer.id(), layer.name())))
        if re.search(rf"(?<!\w)({names})(?!\w)", definition.query()):
            yield from _places(layer, "ogr", context, queries)


def _table(parts: dict[str, Any]) -> str:
    """The table of a database that an address names, else its first; empty when there is none."""
    dataset = None if parts.get("layerName") else open_dataset(parts["path"], FEATURES)
    layer = dataset.GetLayer(parts.get("layerId") or 0) if dataset is not None else None
    return str(layer.GetName() if layer is not None else parts.get("layerName") or "")


def _indexed(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Iterator[str]:
    """The files that an index of sources names; their paths may start at the index file's folder."""
    from ..layers import layer_path

    names = (definition.name() for definition in algorithm.parameterDefinitions())
    for name in (name for name in names if name.upper() == common.SOURCE_INDEX):
        index = algorithm.parameterAsVectorLayer(parameters, name, context) if parameters.get(name) else None
        if index is not None and "location" in index.fields().names():
            folder = os.path.dirname(layer_path(index))
            yield from (path_from(folder, str(row["location"])) for row in index.getFeatures())
