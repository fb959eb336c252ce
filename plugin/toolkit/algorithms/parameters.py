"""Parameters that several algorithms have, and how their values are read."""
from __future__ import annotations

import math
import os
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterBoolean,
    QgsProcessingParameterCrs,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterField,
    QgsProcessingParameterFile,
    QgsProcessingParameterFileDestination,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsProcessingParameterString,
    QgsRasterLayer,
    QgsSettings,
)

from ...imagery import limits as imagery_limits
from ...imagery import messages as imagery_messages
from ...imagery.errors import SettingsError
from ...imagery.gdal_paths import RASTERS, check_raster_path, is_endless, is_remote, open_dataset
from .. import messages
from ..table_fields import LARGEST_WHOLE
from ..translation import tr

Described = tuple[QgsProcessingParameterDefinition, str]

MOSAIC = "MOSAIC"
SOURCES = "SOURCES"
SOURCE_INDEX = "SOURCE_INDEX"
LEVELS = "LEVELS"
WAVELET = "WAVELET"
MAX_RATIO = "MAX_RATIO"
SCHEDULER = "SCHEDULER"
CHART = "CHART"
REPORT = "REPORT"

POINT = QgsProcessing.SourceType.TypeVectorPoint
LINE = QgsProcessing.SourceType.TypeVectorLine
POLYGON = QgsProcessing.SourceType.TypeVectorPolygon
ANY_GEOMETRY = QgsProcessing.SourceType.TypeVectorAnyGeometry
TABLE = QgsProcessing.SourceType.TypeVector  # with or without geometry
RASTER = QgsProcessing.SourceType.TypeRaster

_LAYER_ADDRESS = re.compile(r"^delimitedtext:/*file:/{2}|^file:/{2}|[|?].*$", re.S)
"""What stands around the path of a file in the address of a layer."""


def choice(
    name: str, title: str, choices: Sequence[str], default: str | None = "", optional: bool = False
) -> QgsProcessingParameterDefinition:
    """A choice that models and scripts name by its word; the first one where there is no default, none with None."""
    first = None if default is None else default or choices[0]
    return QgsProcessingParameterEnum(
        name, title, list(choices), defaultValue=first, optional=optional, usesStaticStrings=True
    )


def real(
    name: str, title: str, default: float | None, least: float | None = None, most: float | None = None,
    optional: bool = False, decimals: int | None = 2,
) -> QgsProcessingParameterDefinition:
    """A number that the form shows with so many decimals; None: as many as QGIS has."""
    number = QgsProcessingParameterNumber(name, title, QgsProcessingParameterNumber.Type.Double, default, optional)
    if least is not None:
        number.setMinimum(least)
    if most is not None:
        number.setMaximum(most)
    if decimals is not None:
        number.setMetadata({"widget_wrapper": {"decimals": decimals}})
    return number


def whole(
    name: str, title: str, default: int | None, least: int | None = None, most: int | None = None,
    optional: bool = False,
) -> QgsProcessingParameterDefinition:
    number = real(name, title, default, least, most, optional, None)
    number.setDataType(QgsProcessingParameterNumber.Type.Integer)
    return number


def flag(name: str, title: str, default: bool = False, optional: bool = False) -> QgsProcessingParameterDefinition:
    """A yes or a no."""
    return QgsProcessingParameterBoolean(name, title, default, optional)


def words(name: str, title: str) -> QgsProcessingParameterDefinition:
    return QgsProcessingParameterString(name, title, optional=True)


_REMEMBERED = "seam_inspector/remembered/{}"  # the setting that keeps what was given for a parameter last, by its name


def with_last_value(definition: QgsProcessingParameterDefinition) -> QgsProcessingParameterDefinition:
    """The parameter, whose form begins with what was given for its name last, where that is remembered; those of models
    are written small."""
    if last := QgsSettings().value(_REMEMBERED.format(definition.name().upper()), ""):
        definition.setGuiDefaultValueOverride(last)
    return definition


def remember(values: Mapping[str, str]) -> None:
    for name, value in values.items():
        QgsSettings().setValue(_REMEMBERED.format(name), value)


def file(
    name: str, title: str, extension: str | None = None, optional: bool = False
) -> QgsProcessingParameterDefinition:
    return QgsProcessingParameterFile(name, title, extension=extension, optional=optional)


def folder(name: str, title: str, optional: bool = False) -> QgsProcessingParameterDefinition:
    """A folder whose files are read."""
    return QgsProcessingParameterFile(name, title, QgsProcessingParameterFile.Behavior.Folder, optional=optional)


def raster(name: str, title: str, optional: bool = False) -> QgsProcessingParameterDefinition:
    return QgsProcessingParameterRasterLayer(name, title, optional=optional)


def layers(
    name: str, title: str, kind: QgsProcessing.SourceType = RASTER, optional: bool = False
) -> QgsProcessingParameterDefinition:
    """Several layers of a kind, rasters by default."""
    return QgsProcessingParameterMultipleLayers(name, title, kind, optional=optional)


def features(
    name: str, title: str, *kinds: QgsProcessing.SourceType, optional: bool = False
) -> QgsProcessingParameterDefinition:
    """A layer of features, or a table, that is read."""
    return QgsProcessingParameterFeatureSource(name, title, list(kinds), optional=optional)


def field(name: str, title: str, layer: str) -> QgsProcessingParameterDefinition:
    """A field of another parameter's layer, which may be left out."""
    return QgsProcessingParameterField(name, title, None, layer, optional=True)


def result(
    name: str, title: str, kind: QgsProcessing.SourceType = ANY_GEOMETRY, optional: bool = False,
    by_default: bool = True,
) -> QgsProcessingParameterDefinition:
    """A layer or table that is made; ``by_default``: where it is optional, unless somebody says no."""
    return QgsProcessingParameterFeatureSink(name, title, kind, None, optional, by_default)


def made_file(
    name: str, title: str, filters: str, optional: bool = False, by_default: bool = True
) -> QgsProcessingParameterDefinition:
    """A file that is made; ``by_default``: where it is optional, unless somebody says no."""
    return QgsProcessingParameterFileDestination(name, title, filters, None, optional, by_default)


def mosaic(optional: bool = False) -> Described:
    return raster(MOSAIC, tr("Mosaic"), optional), tr(
        "The orthophoto mosaic under inspection: north-up, with a coordinate reference system."
    )


def sources() -> Described:
    return layers(SOURCES, tr("Sources"), optional=True), tr(
        "The orthoimages that the mosaic was made from. Each is clipped on its own pixel grid; one whose pixels "
        "differ in size by more than 1 %, or whose axes are not parallel, is resampled and marked so."
    )


def source_index() -> Described:
    return features(SOURCE_INDEX, tr("Source index"), POLYGON, optional=True), tr(
        "A tile index of orthoimages as gdaltindex writes it, with their paths in the field 'location'; relative "
        "paths start at the index file's folder. For blocks with too many sources to load, alone or beside them."
    )


def levels(most: int = imagery_limits.MAX_LEVELS) -> Described:
    usual, least = imagery_limits.DEFAULT_LEVELS, imagery_limits.MIN_LEVELS
    return whole(LEVELS, tr("Levels"), usual, least, most), tr(
        "Steps of the decomposition. Level 1 holds the finest detail, each further one detail twice as coarse."
    )


def wavelet() -> Described:
    return choice(WAVELET, tr("Wavelet"), imagery_limits.WAVELETS, imagery_limits.DEFAULT_WAVELET), tr(
        "An orthogonal wavelet of PyWavelets; the Coiflet of order 3 is the one of Pyka's papers."
    )


def scheduler() -> Described:
    return words(SCHEDULER, tr("Dask scheduler")), tr(
        "Address of a Dask scheduler (tcp://host:8786) whose workers see the rasters under the same paths. "
        "Empty: all cores of this machine."
    )


def max_ratio(description: str) -> Described:
    title, usual = tr("Largest ratio of a significant loss"), imagery_limits.MAX_SIGNIFICANT_RATIO
    return real(MAX_RATIO, title, usual, 0, 1, decimals=None), description


def chart(description: str, by_default: bool = False) -> Described:
    filters = "PNG (*.png);;SVG (*.svg);;PDF (*.pdf)"
    return made_file(CHART, tr("Chart"), filters, optional=True, by_default=by_default), description


def report(description: str, filters: str = "HTML (*.html)", by_default: bool = False) -> Described:
    return made_file(REPORT, tr("Report"), filters, optional=True, by_default=by_default), description


def check_values(algorithm: QgsProcessingAlgorithm, values: dict[str, Any], context: QgsProcessingContext) -> None:
    """Raise SettingsError for words that are none of a choice and numbers beyond their limits, which QGIS refuses
    without saying why and models not at all, and for what QGIS lets pass: NaN, infinite numbers, whole ones that are
    too large, words where a number may be left out, and reference systems that there are not."""
    for definition in algorithm.parameterDefinitions():
        title, given = definition.description(), values.get(definition.name())
        is_text = isinstance(given, str) and bool(given.strip())
        is_system = is_text and isinstance(definition, QgsProcessingParameterCrs)
        if is_system and not algorithm.parameterAsCrs(values, definition.name(), context).isValid():
            raise SettingsError(messages.NOT_A_SYSTEM(parameter=title, value=given))
        word = str(given) if isinstance(given, (str, int, float)) else ""
        if isinstance(definition, QgsProcessingParameterEnum) and word and word not in definition.options():
            known = ", ".join(definition.options())
            raise SettingsError(messages.WORD_UNKNOWN(parameter=title, value=word, known=known))
        if not isinstance(definition, QgsProcessingParameterNumber):
            continue
        try:
            float(str(given) if is_text else 0)
        except ValueError:
            raise SettingsError(messages.NO_NUMBER(parameter=title, value=given)) from None
        value = algorithm.parameterAsDouble(values, definition.name(), context)
        if not math.isfinite(value):
            raise SettingsError(messages.NO_NUMBER(parameter=title, value=f"{value:g}"))
        is_whole = definition.dataType() == QgsProcessingParameterNumber.Type.Integer
        largest = LARGEST_WHOLE if is_whole else sys.float_info.max / 2
        least, most = max(definition.minimum(), -largest), min(definition.maximum(), largest)
        if not least <= value <= most and given is not None and given != "":
            is_open = most == largest and value < least
            raise SettingsError(
                messages.NUMBER_TOO_SMALL(parameter=title, value=value, least=least) if is_open
                else messages.NUMBER_BEYOND(parameter=title, value=value, least=least, most=most)
            )  # fmt: skip


def check_files(algorithm: QgsProcessingAlgorithm, values: dict[str, Any]) -> None:
    """Raise SettingsError for an input that is a device or a pipe: whoever opens one may wait for ever."""
    for definition in algorithm.parameterDefinitions():
        for path in () if definition.isDestination() else _paths(values.get(definition.name())):
            if "\0" in path or is_endless(path):
                raise SettingsError(imagery_messages.NO_FILE(name=os.path.basename(path)))


def check_rasters(algorithm: QgsProcessingAlgorithm, values: dict[str, Any]) -> None:
    """Raise RasterError for what GDAL must not open, and what no memory can hold, before QGIS opens it for a model."""
    from ...imagery.open_raster import check_amounts

    for definition in algorithm.parameterDefinitions():
        for path in _paths(values.get(definition.name())) if takes_rasters(definition) else ():
            name = os.path.basename(path)
            check_raster_path(path, name)
            if not is_remote(path):
                check_amounts(open_dataset(path, RASTERS), name)


def takes_rasters(definition: QgsProcessingParameterDefinition) -> bool:
    """Whether a parameter is a raster or a list of them."""
    if isinstance(definition, QgsProcessingParameterMultipleLayers):
        return bool(definition.layerType() == QgsProcessing.SourceType.TypeRaster)
    return isinstance(definition, QgsProcessingParameterRasterLayer)


def _paths(value: Any) -> Iterator[str]:
    """Paths of one layer or several, those that are given as texts."""
    for item in value if isinstance(value, (list, tuple)) else (value,):
        path = _LAYER_ADDRESS.sub("", item) if isinstance(item, str) else ""
        if path:
            yield path


def without_layers(algorithm: QgsProcessingAlgorithm, values: dict[str, Any]) -> dict[str, Any]:
    """The values with nothing to open in place of each raster and each list of layers.

    QGIS would load them all, write statistics beside them (into them, where they are VRTs), and refuse one that it
    can't open without a reason.
    """
    emptied = dict(values)
    for definition in algorithm.parameterDefinitions():
        name, value = definition.name(), values.get(definition.name())
        if isinstance(definition, QgsProcessingParameterRasterLayer):
            if isinstance(value, str) and value:
                emptied[name] = QgsRasterLayer()
        elif name in values and isinstance(definition, QgsProcessingParameterMultipleLayers):
            emptied[name] = []
    return emptied
