"""The outputs of a run: which files they are, and that they can be written, and over no input.

They are held against what they name before anything is measured or written.
"""
from __future__ import annotations

import errno
import os
import re
import sqlite3
import stat
from collections.abc import Iterator, Mapping
from contextlib import closing
from pathlib import Path
from typing import Any, NamedTuple, Union
from urllib.parse import quote
from xml.etree.ElementTree import ParseError

from osgeo import gdal
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
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterRasterDestination,
    QgsProcessingUtils,
    QgsProperty,
    QgsProviderRegistry,
    QgsVectorFileWriter,
    QgsVirtualLayerDefinition,
)
from qgis.PyQt.QtCore import QUrl

from ...imagery import messages as imagery_messages
from ...imagery.documents import document_bytes, xml_root
from ...imagery.errors import RasterError, SettingsError
from ...imagery.gdal_paths import ANYTHING, check_raster_path, open_dataset
from ...imagery.messages import system_reason
from .. import messages
from . import parameters as common

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
_ADDRESSES = ("ogr:", "spatialite:")
_MISREAD = re.compile(r"[:\\]|\|(?!layer(name|id)=)|%[0-9A-Fa-f]{2}(?=[^/]*\.(gpkg|sqlite)$)", re.I)
"""What of a file's name QGIS takes for a provider, a folder or a part of an address, SQLite for another character."""
_IN_MEMORY = "/vsimem/"
_NO_TABLE_BEGINS_WITH = "`~!@#$%^&*()+-={}|[]\\:\";'<>?,/"  # as GDAL's GeoPackage has it
_JOURNAL = "-journal"  # SQLite's, beside the database
_OF_WORDS_AND_NUMBERS = {"boolean", "enum", "number", "range", "string"}  # parameters that name no file
_VECTORS = (
    QgsProcessing.SourceType.TypeVector,
    QgsProcessing.SourceType.TypeVectorAnyGeometry,
    QgsProcessing.SourceType.TypeVectorPoint,
    QgsProcessing.SourceType.TypeVectorLine,
    QgsProcessing.SourceType.TypeVectorPolygon,
)
_WITHOUT_SIDECARS = (".csv", ".gpkg", ".html", ".json", ".points", ".shp", ".txt", ".xml")
_SIDECARS = {".aux", ".aux.xml", ".geom", ".hdr", ".msk", ".ovr", ".prj", ".rpb", ".rpc", "_rpc.txt", ".wld"}

_Identity = Union[tuple[int, int], str]


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
    is_uri = f"{provider}:" in _ADDRESSES
    path = (QgsDataSourceUri(rest).database() or rest) if is_uri else text.partition("|")[0]
    if is_uri and is_database(path):
        return DataPlace(path, QgsDataSourceUri(rest).table())
    is_known = QgsVectorFileWriter.driverForExtension(os.path.splitext(path)[1][1:])
    return DataPlace(path if is_known else path + ".gpkg")  # as QGIS does


def is_file(text: str) -> bool:
    """Whether an output's text names a file, and no table of a server."""
    return _SERVER.match(text) is None


def is_database(path: str) -> bool:
    """Whether other tables may lie in the same file."""
    return os.path.splitext(path)[1].lower() in _DATABASES


class _Output(NamedTuple):
    """An output that is wanted, and goes neither to memory nor to a temporary file."""

    title: str
    place: DataPlace
    files: dict[_Identity, str]
    """All that would be written or removed."""

    def meets(self, other: DataPlace) -> str:
        """The file by which it would be written over another, or what lies beside that; empty where there is none.

        Another table of a database is no matter.
        """
        tables = {self.place.table.lower(), other.table.lower()}
        same = self.files.get(_identity(other.path))
        if same is not None:
            return same if "" in tables or len(tables) == 1 else ""
        if other.path.lower().endswith(_WITHOUT_SIDECARS):
            return ""
        beside = (file for file in self.files.values() if os.path.exists(file) and _is_sidecar(file, other.path))
        return next(beside, "")


def refuse_outputs(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> dict[str, str]:
    """Where the paths of outputs lead through links. Raises SettingsError for outputs that can't be where they are to
    go, that are one file, or a file of an input, sidecars included."""
    wanted = []
    for definition in algorithm.destinationParameterDefinitions():
        if text := output_text(parameters.get(definition.name()), context):
            _refuse_impossible(definition, text)
            wanted.append((definition, text))
    paths = [_place(*one).path for one in wanted if is_file(one[1])]
    leads = {os.path.abspath(path): os.path.realpath(path) for path in paths if not path.startswith("/vsi")}
    outputs: list[_Output] = []
    for output in (_output(*one, leads) for one in wanted):
        for other in outputs:
            if any(output.meets(DataPlace(file, other.place.table)) for file in other.files.values()):
                path, first = output.place.path, other.title
                raise SettingsError(messages.OUTPUTS_ARE_ONE(path=path, first=first, second=output.title))
        outputs.append(output)
    if not any(os.path.exists(file) or file.startswith("/vsi") for one in outputs for file in one.files.values()):
        return leads  # what is not there yet is no input: most runs need no look at them
    for place in _inputs(algorithm, parameters, context):
        for output in outputs:
            if met := output.meets(place):
                raise SettingsError(messages.OUTPUT_IS_INPUT(output=output.title, path=met))
    return leads


def _place(definition: QgsProcessingParameterDefinition, text: str) -> DataPlace:
    return table_place(text) if isinstance(definition, QgsProcessingParameterFeatureSink) else DataPlace(text)


def _refuse_impossible(definition: QgsProcessingParameterDefinition, text: str) -> None:
    """Raise SettingsError for an output of features or a raster that can't be written where it is to go.

    Pages and charts are written last, and what keeps them from that is told then: it costs nothing that was measured.
    """
    title, is_raster = definition.description(), isinstance(definition, QgsProcessingParameterRasterDestination)
    if "\0" in text:
        raise SettingsError(messages.OUTPUT_NAMES_NO_FILE(output=title, path=text))
    if not is_raster and not (isinstance(definition, QgsProcessingParameterFeatureSink) and is_file(text)):
        return  # of a database server QGIS asks and tells itself
    if not text.strip() or not is_file(text) or (is_raster and text.startswith("ogr:")):
        raise SettingsError(messages.OUTPUT_NAMES_NO_FILE(output=title, path=text))
    place = DataPlace(text) if is_raster else table_place(text)
    is_folder = text.endswith(("/", os.sep)) or (os.path.exists(text) and not os.path.isfile(text))
    path = text if is_folder else place.path
    if path.startswith("/vsi") and not path.startswith(_IN_MEMORY):
        # archives and servers: most of GDAL's can't be written, and are left half-made
        raise SettingsError(messages.OUTPUT_NAMES_NO_FILE(output=title, path=path))
    try:
        if not path.startswith(_IN_MEMORY):
            _check_file(path)
    except OSError as error:
        raise SettingsError(imagery_messages.FILE_NOT_WRITTEN(path=path, error=system_reason(error))) from None
    if is_raster:
        return
    _check_name(title, text, place)
    if is_database(path) and os.path.isfile(path) and _is_locked(path):
        raise SettingsError(messages.OUTPUT_IN_USE(path=path))


def _check_name(title: str, text: str, place: DataPlace) -> None:
    """Raise SettingsError for a layer whose name QGIS or GDAL would take for something else."""
    path, name = place.path, os.path.basename(place.path)
    if is_database(path) and not place.table and name[0] in _NO_TABLE_BEGINS_WITH:
        raise SettingsError(messages.TABLE_BEGINS_WRONG(output=title, name=name, begins=name[0]))
    shown = os.path.splitdrive(path if text.startswith(_ADDRESSES) else text)[1].replace(os.sep, "/")
    if misread := _MISREAD.search(shown):
        raise SettingsError(messages.NAME_MISREAD(output=title, path=text, found=misread[0]))


def _check_file(path: str) -> None:
    """Raise OSError where no file can be."""
    if path.endswith(("/", os.sep)):
        raise _system_error(errno.EISDIR)
    found, folder = _state(path), os.path.dirname(os.path.realpath(path))
    if is_database(path):
        _state(path + _JOURNAL)
    os.stat(os.path.join(folder, ""))
    if found is not None and not stat.S_ISREG(found.st_mode):
        raise _system_error(errno.EISDIR if stat.S_ISDIR(found.st_mode) else errno.EPERM)
    if not os.access(folder if found is None else path, os.W_OK):
        raise _system_error(errno.EACCES)


def _system_error(number: int) -> OSError:
    return OSError(number, os.strerror(number))


def _state(path: str) -> os.stat_result | None:
    """None where there is no such file. Raises OSError where there can be none."""
    try:
        return os.stat(path)
    except FileNotFoundError:
        return None


def _is_locked(path: str) -> bool:
    """Whether another program is writing a database. Nothing is written to it."""
    try:
        with closing(sqlite3.connect(f"file:{quote(os.path.abspath(path))}?mode=rw", timeout=0, uri=True)) as database:
            database.execute("BEGIN IMMEDIATE")
            database.rollback()
    except sqlite3.DatabaseError as error:
        return "locked" in str(error)
    return False


def _output(definition: QgsProcessingParameterDefinition, text: str, leads: Mapping[str, str]) -> _Output:
    """``leads``: where links lead, as it is held against the inputs, whatever they lead to when this is asked."""
    place = _place(definition, text)
    stem, ending = os.path.splitext(place.path)
    files = [place.path, text, leads.get(os.path.abspath(place.path), place.path)]
    files += [stem + other for other in _WRITTEN_BESIDE.get(ending.lower(), ())]
    if not place.path.lower().endswith(".vrt"):  # GDAL removes a raster with its sidecars before it writes a new one
        files += _dataset_files(place.path, gdal.OF_RASTER)
    return _Output(definition.description(), place, {_identity(file): file for file in files})


def _inputs(
    algorithm: QgsProcessingAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
) -> Iterator[DataPlace]:
    """Each file of each input."""
    seen: set[_Identity] = set()
    for definition in algorithm.parameterDefinitions():
        name, kind = definition.name(), definition.type()
        if definition.isDestination() or kind in _OF_WORDS_AND_NUMBERS:
            continue
        for place in _places(parameters.get(name), "ogr" if _is_vector(definition) else "gdal", context):
            yield place
            if os.path.isdir(place.path):  # of which every file is read
                with os.scandir(place.path) as entries:
                    files = [one.path for one in entries if one.is_file()]
                yield from map(DataPlace, files)
                continue
            yield from _parts(place.path, seen)
        if name.upper() == common.SOURCE_INDEX and parameters.get(name):
            for path in _indexed(algorithm.parameterAsVectorLayer(parameters, name, context)):
                yield DataPlace(path)
                if path.lower().endswith(".vrt"):  # there may be too many to open all
                    yield from _parts(path, seen)


def _is_vector(definition: QgsProcessingParameterDefinition) -> bool:
    """Whether its values are layers of features, alone or in a list."""
    if isinstance(definition, QgsProcessingParameterMultipleLayers):
        return definition.layerType() in _VECTORS
    return definition.type() in ("source", "vector")


def _places(
    value: object, provider: str, context: QgsProcessingContext, queries: frozenset[str] = frozenset()
) -> Iterator[DataPlace]:
    """What an input's value names: a layer or its id or name, an address of a layer, a path, or a list of those.

    ``queries``: virtual layers on the way to it, which may name each other.
    """
    if isinstance(value, (list, tuple)):
        for one in value:
            yield from _places(one, provider, context, queries)
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
    """What a virtual layer is made of: layers that it brings along, and layers of the project that its query names."""
    definition = QgsVirtualLayerDefinition.fromUrl(QUrl.fromEncoded(source.encode()))
    for one in definition.sourceLayers():
        address = one.reference() if one.isReferenced() else f"{one.provider()}://{one.source()}"
        yield from _places(address, "ogr", context, queries)
    project = context.project()
    for layer in project.mapLayers().values() if project is not None else ():
        names = "|".join(map(re.escape, (layer.id(), layer.name())))
        if re.search(rf"(?<!\w)({names})(?!\w)", definition.query()):
            yield from _places(layer, "ogr", context, queries)


def _table(parts: dict[str, Any]) -> str:
    """The table of a database that an address names, else its first; empty when there is none."""
    dataset = None if parts.get("layerName") else _opened(parts["path"], gdal.OF_VECTOR)
    layer = dataset.GetLayer(parts.get("layerId") or 0) if dataset is not None else None
    return str(layer.GetName() if layer is not None else parts.get("layerName") or "")


def _indexed(index: QgsMapLayer | None) -> Iterator[str]:
    """The files that an index of sources names; their paths may start at the index file's folder."""
    from ..layers import layer_path

    if index is None or "location" not in index.fields().names():
        return
    folder = os.path.dirname(layer_path(index))
    for row in index.getFeatures():
        yield os.path.join(folder, str(row["location"]))


def _parts(path: str, seen: set[_Identity]) -> Iterator[DataPlace]:
    """The files of a dataset, and of the rasters that a virtual one is made of."""
    if _identity(path) in seen:
        return
    seen.add(_identity(path))
    for file in _dataset_files(path):
        yield DataPlace(file)
        if file.lower().endswith(".vrt"):
            yield from _parts(file, seen)
    if path.lower().endswith(".vrt"):
        for file in _vector_sources(Path(path)):
            yield DataPlace(file)
            yield from _parts(file, seen)


def _vector_sources(path: Path) -> Iterator[str]:
    """The files that a virtual dataset of features names: GDAL does not tell those."""
    try:
        root = xml_root(document_bytes(path))
    except (OSError, ParseError):
        return
    for source in root.iter("SrcDataSource"):
        is_relative = source.get("relativeToVRT", "0").lower() in ("1", "yes", "true")
        yield str(path.parent / (source.text or "")) if is_relative else source.text or ""


def _dataset_files(path: str, flags: int = 0) -> list[str]:
    """All files that GDAL counts to a dataset, but for databases, of which other tables may be written."""
    dataset = None if is_database(path) else _opened(path, flags)
    files = (dataset.GetFileList() or []) if dataset is not None else []
    return [file for file in files if not is_database(file)]


def _opened(path: str, flags: int = 0) -> gdal.Dataset | None:
    try:
        check_raster_path(path, path)
    except RasterError:  # what must not be opened is refused by whoever needs it
        return None
    return open_dataset(path, ANYTHING, flags)


def _is_sidecar(file: str, path: str) -> bool:
    """Whether a file is by its name a part of another, whether or not GDAL reads it now."""
    if os.path.dirname(os.path.realpath(file)) != os.path.dirname(os.path.realpath(path)):
        return False
    stem, ending = os.path.splitext(os.path.basename(path).lower())
    name = os.path.basename(file).lower()
    worlds = {ending + "w", ending[:2] + ending[-1:] + "w"}  # .tifw, .tfw
    return any(name == start + end for start in (stem, stem + ending) for end in _SIDECARS | worlds)


def _identity(path: str) -> _Identity:
    """The same for every name of a file: relative, through links, in other letters where the system takes them so."""
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        return path if path.startswith("/vsi") else os.path.normcase(os.path.realpath(path))
    return found.st_dev, found.st_ino
