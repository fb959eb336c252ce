"""The block under inspection from the project's layers. No source is opened; mosaic and index are, in a task."""
from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass

from qgis.core import QgsCoordinateTransform, QgsProject, QgsRasterLayer, QgsVectorLayer, QgsVectorLayerFeatureSource

from ..core import messages
from ..core.errors import RasterError, SeamInspectorError, SettingsError
from ..core.inspection import Source
from ..core.rasters import Mosaic, RasterRef, describe_mosaic
from . import layers
from .inputs import Inputs
from .tasks import Cancelled, Job


@dataclass(frozen=True)
class BlockFiles:
    """What of a block has to be opened: that may take long when it is on a network drive."""

    mosaic: RasterRef
    index: str = ""
    """Where the source index comes from; empty without one."""
    index_wkt: str = ""


@dataclass(frozen=True)
class OpenedFiles:
    """What was found in them."""

    mosaic: Mosaic
    indexed: tuple[Source, ...]
    """The orthoimages of the source index."""


def block_files(project: QgsProject, inputs: Inputs) -> BlockFiles:
    """The files of the inputs. Raises SettingsError when there is no mosaic, RasterError when it is no file."""
    mosaic = project.mapLayer(inputs.mosaic)
    if not isinstance(mosaic, QgsRasterLayer):
        raise SettingsError(messages.NO_MOSAIC())
    ref, index = layers.layer_ref(mosaic), project.mapLayer(inputs.source_index)
    if not isinstance(index, QgsVectorLayer):
        return BlockFiles(ref)
    return BlockFiles(ref, index.source(), layers.system_wkt(index.crs()))


def opening_job(project: QgsProject, inputs: Inputs, files: BlockFiles) -> Job:
    """Opens them; yields the OpenedFiles, or the Message why there are none."""
    index, context = project.mapLayer(inputs.source_index), project.transformContext()
    source = QgsVectorLayerFeatureSource(index) if isinstance(index, QgsVectorLayer) else None
    path, crs = (layers.layer_path(index), index.crs()) if source is not None else ("", None)

    def opened() -> OpenedFiles:
        mosaic = describe_mosaic(files.mosaic)
        if source is None:
            return OpenedFiles(mosaic, ())
        transform = QgsCoordinateTransform(crs, layers.mosaic_crs(mosaic), context)
        indexed = layers.indexed_sources(source.getFeatures(), source.fields().names(), path, transform)
        return OpenedFiles(mosaic, tuple(indexed))

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        try:
            yield 1.0, opened()
        except SeamInspectorError as error:
            yield 1.0, error.message

    return job


def layer_sources(project: QgsProject, inputs: Inputs, mosaic: Mosaic) -> list[Source]:
    """The source layers with their footprints; those that are not there any more are left out.

    Raises WindowError when a footprint can't be transformed.
    """
    crs = layers.mosaic_crs(mosaic)
    sources = []
    for layer in map(project.mapLayer, inputs.sources):
        if isinstance(layer, QgsRasterLayer):
            with contextlib.suppress(RasterError):  # a layer that is no file can't take part
                footprint = layers.transformed_extent(layers.box_extent(layer.extent()), layer.crs(), crs, project)
                sources.append(Source(layers.layer_ref(layer), footprint))
    return sources
