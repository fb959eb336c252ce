"""QGIS layers and Processing values -> the plain data that is measured; changes of layers by steps of undo."""
from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from functools import lru_cache
from typing import TypeVar

from osgeo import gdal
from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsFeature,
    QgsFeatureRequest,
    QgsGeometry,
    QgsMapLayer,
    QgsPointXY,
    QgsProcessingContext,
    QgsProcessingFeatureSource,
    QgsProcessingUtils,
    QgsProject,
    QgsProviderRegistry,
    QgsRasterLayer,
    QgsRectangle,
    QgsVectorLayer,
    QgsWkbTypes,
)

from ..imagery import messages as imagery_messages
from ..imagery.errors import Message, RasterError, WindowError, WindowLayerError
from ..imagery.gdal_calls import gdal_silenced
from ..imagery.gdal_paths import FEATURES, open_dataset
from ..imagery.grids import Extent
from ..imagery.rasters import Raster, RasterRef
from . import messages
from .reference_systems import known_system, reference_system, transformation
from .translation import tr


def raster_ref(value: object, context: QgsProcessingContext) -> RasterRef:
    """The file behind a raster layer, a layer's id or name, or a path.

    Raises RasterError for a layer that is not a file that GDAL reads.
    """
    layer = value
    if isinstance(value, str):
        layer = QgsProcessingUtils.mapLayerFromString(value, context, False)
        if layer is None:
            return RasterRef(value)
    if not isinstance(layer, QgsRasterLayer):
        name = layer.name() if isinstance(layer, QgsMapLayer) else value
        raise RasterError(messages.NOT_A_RASTER_LAYER(name=name))
    return layer_ref(layer)


def layer_ref(layer: QgsRasterLayer) -> RasterRef:
    """The file behind a raster layer, with the layer's reference system and its additional nodata value.

    Raises RasterError for a layer that is not a file that GDAL reads.
    """
    if layer.providerType() not in ("gdal", ""):
        raise RasterError(messages.NOT_A_FILE(name=layer.name()))
    return RasterRef(_raster_path(layer.source()), system_wkt(layer.crs()), nodata=additional_nodata(layer))


def additional_nodata(layer: QgsRasterLayer) -> float | None:
    """The value that a user gave a layer as no data: QGIS asks for one, of all bands."""
    ranges = [] if layer.dataProvider() is None else layer.dataProvider().userNoDataValues(1)
    return next((values.min() for values in ranges if values.min() == values.max()), None)


def other_systems(layers: Iterable[QgsMapLayer | None]) -> Iterator[Message]:
    """What to say of raster layers that were given another reference system than their files'."""
    from ..imagery.reference_systems import other_system, same_system  # with numpy, not loaded when QGIS starts

    for layer in layers:
        if isinstance(layer, QgsRasterLayer) and layer.dataProvider() is not None:
            of_file, given = system_wkt(layer.dataProvider().crs()), system_wkt(layer.crs())
            if of_file and given and not same_system(of_file, given):
                yield from other_system(layer.name(), of_file, given)


@lru_cache(4096)
def _raster_path(source: str) -> str:
    """The path that GDAL opens, kept for each source: projects of hundreds of rasters ask again and again."""
    parts = QgsProviderRegistry.instance().decodeUri("gdal", source)
    if parts.get("layerName"):
        return source  # a subdataset has no path of its own
    return str(parts.get("vsiPrefix", "") + parts["path"] + parts.get("vsiSuffix", ""))


def layer_path(layer: QgsMapLayer) -> str:
    """The file of a layer; empty for one in memory or in a database."""
    if layer.providerType() not in ("ogr", "gdal"):
        return ""
    return QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source()).get("path") or ""


def layer_address(layer: QgsVectorLayer) -> str:
    """The address of a vector layer for people: no passwords, and no fields of one in memory."""
    return tr("temporary layer") if layer.providerType() == "memory" else str(layer.publicSource())


_HOLDS_NOTES = ".gpkg"  # of the formats of files that layers are kept in, that which has a place for them


def layer_notes(layer: QgsVectorLayer, domain: str) -> dict[str, str]:
    """The words that ``write_layer_notes`` wrote beside the rows of a layer; empty where there are none."""
    uri = QgsProviderRegistry.instance().decodeUri(layer.providerType(), layer.source())
    path = str(uri.get("path") or "")
    if layer.providerType() != "ogr" or not path.lower().endswith(_HOLDS_NOTES):
        keys = [key for key in layer.customPropertyKeys() if key.startswith(f"{domain}/")]
        return {key.partition("/")[2]: str(layer.customProperty(key)) for key in keys}
    with gdal_silenced(), suppress(RuntimeError):
        dataset = open_dataset(path, FEATURES)
        table = str(uri.get("layerName") or "")
        opened = dataset and (dataset.GetLayerByName(table) if table else dataset.GetLayer(0))
        return dict(opened.GetMetadata(domain)) if opened else {}
    return {}


def write_layer_notes(place: QgsVectorLayer | str, domain: str, notes: Mapping[str, str], table: str = "") -> bool:
    """Write words beside the rows of a layer in memory, or of a file that is closed; False where it has no place for
    them. ``table``: of a file with several."""
    if isinstance(place, QgsVectorLayer):
        for name, value in notes.items():
            place.setCustomProperty(f"{domain}/{name}", value)
        return True
    path, _, named = place.partition("|layername=")
    if not path.lower().endswith(_HOLDS_NOTES):
        return False
    with gdal_silenced(), suppress(RuntimeError):
        dataset = open_dataset(path, FEATURES, gdal.OF_UPDATE)
        table = table or named
        layer = dataset and (dataset.GetLayerByName(table) if table else dataset.GetLayer(0))
        return layer is not None and layer.SetMetadata(dict(notes), domain) == gdal.CE_None
    return False


def system_wkt(crs: QgsCoordinateReferenceSystem) -> str:
    """WKT as GDAL writes it; empty for an invalid system."""
    return known_system(crs).toWkt(QgsCoordinateReferenceSystem.WktVariant.WKT_PREFERRED_GDAL)


def mosaic_crs(mosaic: Raster) -> QgsCoordinateReferenceSystem:
    return reference_system(mosaic.wkt)


def features(source: QgsProcessingFeatureSource) -> Iterator[QgsFeature]:
    """All features, those with invalid geometry included: what to do about them is for us to say."""
    skip_checks = QgsProcessingFeatureSource.Flag.FlagSkipGeometryValidityChecks
    return source.getFeatures(QgsFeatureRequest(), skip_checks)


def window_geometry(feature: QgsFeature, transform: QgsCoordinateTransform) -> QgsGeometry:
    """The outline of a window in the mosaic's reference system.

    Raises WindowError for an outline that is no single simple polygon.
    """
    geometry = QgsGeometry(feature.geometry())
    if geometry.isEmpty() or not has_numbers(geometry):
        raise WindowError(messages.WINDOW_EMPTY())
    is_polygon = geometry.type() == QgsWkbTypes.GeometryType.PolygonGeometry and geometry.constGet().partCount() == 1
    if not is_polygon or not geometry.isGeosValid():
        raise WindowError(messages.WINDOW_NO_POLYGON())
    return transformed(geometry, transform)


def has_numbers(geometry: QgsGeometry) -> bool:
    """Whether all coordinates are numbers; of others GEOS writes lines of its own, and bounding boxes lack them."""
    return all(math.isfinite(vertex.x()) and math.isfinite(vertex.y()) for vertex in geometry.vertices())


def extent(geometry: QgsGeometry) -> Extent:
    return box_extent(geometry.boundingBox())


def outline_extent(feature: QgsFeature, transform: QgsCoordinateTransform | None = None) -> Extent | None:
    """The bounding box of a feature, transformed where a transform is given; None when it has no outline, or one of
    coordinates that are no numbers.

    Raises WindowError when it can't be transformed.
    """
    geometry = feature.geometry()
    if geometry.isEmpty():
        return None
    bounds = extent(geometry if transform is None else transformed(QgsGeometry(geometry), transform))
    if all(map(math.isfinite, bounds)):
        return bounds
    if transform is None:  # else they may have become so
        return None
    raise WindowError(messages.WINDOW_EMPTY())


def rectangle(bounds: Extent) -> QgsGeometry:
    return QgsGeometry.fromRect(QgsRectangle(*bounds))


def line_wkb(feature: QgsFeature, transform: QgsCoordinateTransform) -> bytes | None:
    """A seamline or cell in the mosaic's reference system as WKB; None when it has no geometry."""
    geometry = QgsGeometry(feature.geometry())
    return None if geometry.isEmpty() else bytes(transformed(geometry, transform).asWkb())


def transformed_extent(
    bounds: Extent, crs: QgsCoordinateReferenceSystem, target: QgsCoordinateReferenceSystem, project: QgsProject
) -> Extent:
    """The bounding box of an extent in another reference system. Raises WindowError when there is none."""
    if crs == target:
        return bounds
    return extent(transformed(rectangle(bounds), transformation(crs, target, project.transformContext())))


def transformed(geometry: QgsGeometry, transform: QgsCoordinateTransform) -> QgsGeometry:
    try:
        geometry.transform(transform)
    except QgsCsException:
        raise WindowError(imagery_messages.EXTENT_NOT_TRANSFORMED()) from None
    return geometry


def box_extent(box: QgsRectangle) -> Extent:
    """A rectangle of QGIS as an extent."""
    return box.xMinimum(), box.yMinimum(), box.xMaximum(), box.yMaximum()


_Place = TypeVar("_Place", QgsPointXY, QgsRectangle)


def transformed_place(
    place: _Place, crs: QgsCoordinateReferenceSystem, target: QgsCoordinateReferenceSystem
) -> _Place | None:
    """A point, or the rectangle around a rectangle, in another system, by the project's choice of transformations."""
    with suppress(QgsCsException, WindowError):
        moving = transformation(crs, target, QgsProject.instance().transformContext())
        return moving.transformBoundingBox(place) if isinstance(place, QgsRectangle) else moving.transform(place)
    return None


@contextmanager
def edit_step(layer: QgsVectorLayer, name: str) -> Iterator[None]:
    """Changes to the layer that are undone together; within another step they are a part of it.

    Raises WindowLayerError when the layer can't be edited.
    """
    if layer.readOnly() or not (layer.isEditable() or layer.startEditing()):
        raise WindowLayerError(messages.WINDOW_LAYER_READ_ONLY(name=layer.name()))
    if layer.isEditCommandActive():
        yield
        return
    layer.beginEditCommand(name)
    try:
        yield
    except BaseException:
        layer.destroyEditCommand()
        raise
    layer.endEditCommand()
