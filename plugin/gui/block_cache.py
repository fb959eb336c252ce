"""The block under inspection, made from the project's layers when it is needed, and windows on its pixels."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

from qgis.core import (
    QgsCoordinateTransform,
    QgsCsException,
    QgsFeatureRequest,
    QgsGeometry,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
    QgsVectorLayerFeatureSource,
)

from ..adapters import layers, window_layer
from ..adapters.blocks import layer_block
from ..adapters.inputs import Inputs
from ..adapters.window_layer import WindowRow
from ..core import messages
from ..core.errors import SeamInspectorError, WindowError
from ..core.inspection import Block, Settings, WindowRequest, window_request
from ..core.windows import PixelWindow


class BlockCache:
    """Knows the inputs; opens the mosaic's header once, not at every move of the mouse."""

    def __init__(self, project: QgsProject) -> None:
        self._project = project
        self.inputs = Inputs()
        self._block: Block | None = None
        self._has_failed = False

    def forget(self) -> None:
        """The inputs or the project's layers have changed."""
        self._block = None
        self._has_failed = False

    def mosaic_layer(self) -> QgsRasterLayer | None:
        """The mosaic, while it is there."""
        layer = self._project.mapLayer(self.inputs.mosaic)
        return layer if isinstance(layer, QgsRasterLayer) else None

    def settings(self) -> Settings:
        """How windows are measured."""
        return Settings(self.inputs.wavelet, self.inputs.levels, self.inputs.max_ratio)

    def required(self) -> Block:
        """The block. Raises SeamInspectorError when the inputs make none."""
        if self._block is None:
            self._has_failed = True
            self._block = layer_block(self._project, self.inputs)
            self._has_failed = False
        return self._block

    def silent(self) -> Block | None:
        """The block; None when the inputs make none."""
        if self._block is None and not self._has_failed:
            with suppress(SeamInspectorError):
                return self.required()
        return self._block

    def seamlines(self, block: Block) -> Iterator[bytes | None] | None:
        """The seamlines' geometries in the mosaic's reference system, to be read in any thread."""
        layer = self._project.mapLayer(self.inputs.seamlines)
        if not isinstance(layer, QgsVectorLayer):
            return None
        crs = layers.mosaic_crs(block.mosaic)
        transform = QgsCoordinateTransform(layer.crs(), crs, self._project.transformContext())
        return _geometries(QgsVectorLayerFeatureSource(layer), transform)

    def outlines(self, block: Block, layer: QgsVectorLayer, windows: Sequence[PixelWindow]) -> list[QgsGeometry]:
        """Windows as polygons in a layer's reference system, where they need not be upright.

        Raises WindowError when they can't be transformed.
        """
        crs = layers.mosaic_crs(block.mosaic)
        transform = QgsCoordinateTransform(crs, layer.crs(), self._project.transformContext())
        found = [layers.rectangle(block.mosaic.grid.window_extent(window)) for window in windows]
        if not all(_is_transformed(geometry, transform) for geometry in found):
            raise WindowError(messages.EXTENT_NOT_TRANSFORMED())
        return found

    def requests(self, block: Block, layer: QgsVectorLayer, rows: Sequence[WindowRow]) -> Iterator[WindowRequest]:
        """The requests for windows, to be made in any thread, as there may be thousands."""
        crs = layers.mosaic_crs(block.mosaic)
        transform = QgsCoordinateTransform(layer.crs(), crs, self._project.transformContext())
        shapes = {}
        if layer.crs() != crs:  # the box of a polygon that is not upright there is too large
            shapes = window_layer.read_shapes(layer, [row.fid for row in rows])
        return _requests(block, list(rows), shapes, transform, self.settings())


def measured(inputs: Inputs) -> tuple[object, ...]:
    """The inputs that a result depends on."""
    return inputs.mosaic, inputs.sources, inputs.source_index, inputs.wavelet, inputs.levels, inputs.max_ratio


def _requests(
    block: Block,
    rows: list[WindowRow],
    shapes: dict[int, QgsGeometry],
    transform: QgsCoordinateTransform,
    settings: Settings,
) -> Iterator[WindowRequest]:
    """A generator, so that nothing is done before it is asked."""
    for row in rows:
        geometry = shapes.get(row.fid, layers.rectangle(row.extent))
        if _is_transformed(geometry, transform):
            yield window_request(block, row.window_id, layers.extent(geometry), settings)
        else:
            why = messages.EXTENT_NOT_TRANSFORMED()
            yield WindowRequest(row.window_id, block.mosaic, (), None, settings, why)


def _geometries(source: QgsVectorLayerFeatureSource, transform: QgsCoordinateTransform) -> Iterator[bytes | None]:
    """A generator, so that features are fetched where it runs, and the source lives as long as it does."""
    for feature in source.getFeatures(QgsFeatureRequest()):
        yield layers.line_wkb(feature, transform)


def _is_transformed(geometry: QgsGeometry, transform: QgsCoordinateTransform) -> bool:
    try:
        geometry.transform(transform)
    except QgsCsException:
        return False
    return True
