"""The orthoimages of the parameters SOURCES and SOURCE_INDEX."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from qgis.core import QgsCoordinateTransform, QgsProcessingContext, QgsProcessingFeedback

from ..adapters.text import sentence
from ..core.errors import RasterError
from . import parameters as common
from .base import SeamInspectorAlgorithm

if TYPE_CHECKING:
    from ..core.inspection import Block
    from ..core.messages import Message
    from ..core.rasters import Mosaic, RasterRef


class GivenSources:
    """What a run was given: made in ``prepare``, for layers are asked there, and used in ``execute``."""

    def __init__(
        self, algorithm: SeamInspectorAlgorithm, parameters: dict[str, Any], context: QgsProcessingContext
    ) -> None:
        from ..adapters.layers import raster_ref

        self._algorithm, self._parameters, self._context = algorithm, parameters, context
        self._refs: list[RasterRef] = []
        self._left_out: list[Message] = []
        for value in common.raster_values(parameters, common.SOURCES, context):
            try:
                self._refs.append(raster_ref(value, context))
            except RasterError as error:
                self._left_out.append(error.message)
        self._index_path = common.index_path(algorithm, parameters, common.SOURCE_INDEX, context)

    @property
    def are_named(self) -> bool:
        """Whether there are any."""
        return bool(self._refs or self._parameters.get(common.SOURCE_INDEX))

    def block(self, mosaic: Mosaic, feedback: QgsProcessingFeedback) -> Block:
        """Mosaic and sources; warns of those left out. Raises SettingsError when none is named at all."""
        from ..adapters import layers
        from ..core.inspection import make_block

        indexed = []
        if self._parameters.get(common.SOURCE_INDEX):
            index = self._algorithm.source(self._parameters, common.SOURCE_INDEX, self._context)
            crs = layers.mosaic_crs(mosaic)
            transform = QgsCoordinateTransform(index.sourceCrs(), crs, self._context.transformContext())
            names = index.fields().names()
            indexed = layers.indexed_sources(layers.features(index), names, self._index_path, transform)
        for notice in self._left_out:
            feedback.pushWarning(sentence(notice))
        block, notices = make_block(mosaic, self._refs, indexed)
        for notice in notices:
            feedback.pushWarning(sentence(notice))
        return block
