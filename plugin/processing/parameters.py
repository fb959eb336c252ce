"""Parameters that several algorithms have, and how their values are read."""
from __future__ import annotations

from typing import Any

from qgis.core import (
    QgsProcessing,
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingParameterDefinition,
    QgsProcessingParameterEnum,
    QgsProcessingParameterFeatureSource,
    QgsProcessingParameterMultipleLayers,
    QgsProcessingParameterNumber,
    QgsProcessingParameterRasterLayer,
    QgsProperty,
)

from ..adapters.text import tr
from ..core import thresholds

Parameters = dict[str, Any]
Described = tuple[QgsProcessingParameterDefinition, str]

MOSAIC = "MOSAIC"
SOURCES = "SOURCES"
SOURCE_INDEX = "SOURCE_INDEX"
LEVELS = "LEVELS"
WAVELET = "WAVELET"

_LARGEST_NUMBER = 2_000_000_000  # of a window: the outputs' integers have 32 bits, and new numbers come above it


def mosaic() -> Described:
    return (
        QgsProcessingParameterRasterLayer(MOSAIC, tr("Mosaic")),
        tr("The orthophoto mosaic under inspection: north-up, with a coordinate reference system."),
    )


def sources() -> Described:
    return (
        QgsProcessingParameterMultipleLayers(
            SOURCES, tr("Sources"), QgsProcessing.SourceType.TypeRaster, optional=True
        ),
        tr(
            "The orthoimages that the mosaic was made from. Each is clipped on its own pixel grid; one whose pixels "
            "differ in size by more than 1 %, or whose axes are not parallel, is resampled and marked so."
        ),
    )


def source_index() -> Described:
    return (
        QgsProcessingParameterFeatureSource(
            SOURCE_INDEX, tr("Source index"), [QgsProcessing.SourceType.TypeVectorPolygon], optional=True
        ),
        tr(
            "A tile index of orthoimages as gdaltindex writes it, with their paths in the field 'location'; relative "
            "paths start at the index file's folder. For blocks with too many sources to load, alone or beside them."
        ),
    )


def levels() -> Described:
    return (
        QgsProcessingParameterNumber(
            LEVELS,
            tr("Levels"),
            QgsProcessingParameterNumber.Type.Integer,
            thresholds.DEFAULT_LEVELS,
            minValue=thresholds.MIN_LEVELS,
            maxValue=thresholds.MAX_LEVELS,
        ),
        tr("Steps of the decomposition. Level 1 holds the finest detail, each further one detail twice as coarse."),
    )


def wavelet() -> Described:
    return (
        QgsProcessingParameterEnum(
            WAVELET,
            tr("Wavelet"),
            list(thresholds.WAVELETS),
            defaultValue=thresholds.DEFAULT_WAVELET,
            usesStaticStrings=True,
        ),
        tr("An orthogonal wavelet of PyWavelets; the Coiflet of order 3 is the one of Pyka's papers."),
    )


def raster_value(parameters: Parameters, name: str, context: QgsProcessingContext) -> object:
    """A raster parameter as it was given: a layer, a layer's id, or a path."""
    value = parameters.get(name)
    return value.valueAsString(context.expressionContext())[0] if isinstance(value, QgsProperty) else value


def raster_values(parameters: Parameters, name: str, context: QgsProcessingContext) -> list[object]:
    """A parameter of several rasters as it was given; nothing is loaded."""
    value: object = raster_value(parameters, name, context)
    if value is None or value == "":
        return []
    return list(value) if isinstance(value, (list, tuple)) else [value]


def index_path(
    algorithm: QgsProcessingAlgorithm, parameters: Parameters, name: str, context: QgsProcessingContext
) -> str:
    """The file of an index layer, from which relative locations start; empty for a layer in memory."""
    from ..adapters.layers import layer_path

    layer = algorithm.parameterAsVectorLayer(parameters, name, context)
    return layer_path(layer) if layer is not None else ""


def whole_number(value: object) -> int | None:
    """A window's number from a field of any type."""
    try:
        number = float(str(value))
    except ValueError:
        return None
    return int(number) if number.is_integer() and abs(number) <= _LARGEST_NUMBER else None
