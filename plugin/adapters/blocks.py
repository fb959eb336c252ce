"""The block under inspection from the project's layers. Opens the mosaic's header; no source is opened."""
from __future__ import annotations

import contextlib

from qgis.core import QgsCoordinateTransform, QgsProject, QgsRasterLayer, QgsVectorLayer, QgsVectorLayerFeatureSource

from ..core import messages
from ..core.errors import RasterError, SettingsError
from ..core.inspection import Block, Source, make_block
from ..core.rasters import describe_mosaic
from . import layers
from .inputs import Inputs


def layer_block(project: QgsProject, inputs: Inputs) -> Block:
    """Mosaic and sources with their footprints; layers that are not there any more are left out.

    Raises SettingsError when there is no mosaic or no source, RasterError when the mosaic can't be used.
    """
    mosaic_layer = project.mapLayer(inputs.mosaic)
    if not isinstance(mosaic_layer, QgsRasterLayer):
        raise SettingsError(messages.NO_MOSAIC())
    mosaic = describe_mosaic(layers.layer_ref(mosaic_layer))
    crs = layers.mosaic_crs(mosaic)
    sources = []
    for layer in map(project.mapLayer, inputs.sources):
        if isinstance(layer, QgsRasterLayer):
            with contextlib.suppress(RasterError):  # a layer that is no file can't take part
                footprint = layers.transformed_extent(layers.box_extent(layer.extent()), layer.crs(), crs, project)
                sources.append(Source(layers.layer_ref(layer), footprint))
    index = project.mapLayer(inputs.source_index)
    if isinstance(index, QgsVectorLayer):
        transform = QgsCoordinateTransform(index.crs(), crs, project.transformContext())
        features = QgsVectorLayerFeatureSource(index).getFeatures()
        sources += layers.indexed_sources(features, index.fields().names(), layers.layer_path(index), transform)
    return make_block(mosaic, [], sources)[0]
