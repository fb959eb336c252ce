"""The block under inspection from the project's layers. No source is opened; the others are, in a task."""
from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsMapLayer,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
    QgsVectorLayerFeatureSource,
)

from ....imagery.errors import RasterError, SeamInspectorError, SettingsError
from ....imagery.open_raster import check_readable, describe_mosaic
from ....imagery.rasters import Raster, RasterRef
from ....toolkit import layers as layers
from ....toolkit.background_tasks import Cancelled, Job
from ...measure import messages
from ...measure.inspection import Source
from ...measure.seam_cells import Cell
from ...tables import seam_cell_layer, source_index
from .project_inputs import Inputs


@dataclass(frozen=True)
class BlockFiles:
    """What of a block has to be opened: that may take long when it is on a network drive."""

    mosaic: RasterRef
    index: str = ""
    """Where the source index comes from; empty without one."""
    index_wkt: str = ""
    cells: str = ""
    """Where the seam cells come from; empty without any."""
    cells_wkt: str = ""


@dataclass(frozen=True)
class OpenedFiles:
    """What was found in them."""

    mosaic: Raster
    indexed: tuple[Source, ...]
    """The orthoimages of the source index."""
    cells: tuple[Cell, ...] = ()
    """Which source each part of the mosaic was cut from."""


def block_files(project: QgsProject, inputs: Inputs) -> BlockFiles:
    """The files of the inputs. Raises SettingsError when there is no mosaic, RasterError when it is no file."""
    mosaic = project.mapLayer(inputs.mosaic)
    if not isinstance(mosaic, QgsRasterLayer):
        raise SettingsError(messages.NO_MOSAIC())
    places = [_origin(project.mapLayer(layer_id)) for layer_id in (inputs.source_index, inputs.cells)]
    return BlockFiles(layers.layer_ref(mosaic), *places[0], *places[1])


def _origin(layer: QgsMapLayer | None) -> tuple[str, str]:
    """Source and reference system of a vector layer; empty without one."""
    return (layer.source(), layers.system_wkt(layer.crs())) if isinstance(layer, QgsVectorLayer) else ("", "")


@dataclass(frozen=True)
class LayerFeatures:
    """A vector layer as another thread may read it."""

    source: QgsVectorLayerFeatureSource
    names: list[str]
    path: str
    crs: QgsCoordinateReferenceSystem

    @staticmethod
    def of(layer: QgsMapLayer | None) -> LayerFeatures | None:
        """None when it is no vector layer."""
        if not isinstance(layer, QgsVectorLayer):
            return None
        source = QgsVectorLayerFeatureSource(layer)
        return LayerFeatures(source, source.fields().names(), layers.layer_path(layer), layer.crs())


def opening_job(project: QgsProject, inputs: Inputs, files: BlockFiles) -> Job:
    """Opens them; yields the OpenedFiles, or the Message why there are none."""
    context = project.transformContext()
    index, cells = (LayerFeatures.of(project.mapLayer(layer_id)) for layer_id in (inputs.source_index, inputs.cells))

    def opened() -> OpenedFiles:
        mosaic = describe_mosaic(files.mosaic)
        check_readable(files.mosaic)
        crs = layers.mosaic_crs(mosaic)
        indexed: list[Source] = []
        known: list[Cell] = []
        if index is not None:
            transform = QgsCoordinateTransform(index.crs, crs, context)
            indexed = source_index.indexed_sources(index.source.getFeatures(), index.names, index.path, transform)
        if cells is not None:
            if seam_cell_layer.CELL_FIELD not in cells.names:
                raise SettingsError(messages.CELLS_WITHOUT_SOURCE())
            transform = QgsCoordinateTransform(cells.crs, crs, context)
            known = seam_cell_layer.seam_cells(cells.source.getFeatures(), transform)
        return OpenedFiles(mosaic, tuple(indexed), tuple(known))

    def job(_cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        try:
            yield 1.0, opened()
        except SeamInspectorError as error:
            yield 1.0, error.message

    return job


def layer_sources(project: QgsProject, inputs: Inputs, mosaic: Raster) -> list[Source]:
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
