"""Mosaic and orthoimages of a run, from the parameters MOSAIC, SOURCES and SOURCE_INDEX."""
from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from qgis.core import QgsProcessingContext

from . import parameters as common
from .base import SeamInspectorAlgorithm, Warnings

if TYPE_CHECKING:
    from ..core.cells import Cell
    from ..core.inspection import Block
    from ..core.rasters import Mosaic


def given_block(
    algorithm: SeamInspectorAlgorithm,
    parameters: dict[str, Any],
    context: QgsProcessingContext,
    mosaic: Mosaic,
    given: common.GivenSources,
    warnings: Warnings,
    cells: Iterable[Cell] = (),
) -> Block:
    """Mosaic and sources; warns of those left out. Raises SettingsError when none is named at all."""
    from ..adapters.layers import mosaic_crs
    from ..core.inspection import make_block

    indexed = []
    if parameters.get(common.SOURCE_INDEX):
        index = algorithm.source(parameters, common.SOURCE_INDEX, context)
        indexed = common.indexed_sources(index, given.index_path, mosaic_crs(mosaic), context)
    warnings.say(given.left_out)
    block, notices = make_block(mosaic, given.refs, indexed, cells)
    warnings.say(notices)
    return block
