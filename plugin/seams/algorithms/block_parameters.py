"""Mosaic, orthoimages and seams of a run, from the parameters MOSAIC, SOURCES, SOURCE_INDEX and others, and the long
jobs that are done with them."""
from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from qgis.core import QgsCoordinateReferenceSystem

from ...imagery.errors import Message, SettingsError
from ...toolkit.algorithms import parameters as common
from ...toolkit.algorithms.base import SeamInspectorAlgorithm
from ...toolkit.algorithms.run import Run
from ..measure import messages

if TYPE_CHECKING:
    from ...imagery.rasters import Raster, RasterRef
    from ..measure.scan.block_runs import ScanStep
    from ..measure.seam_cells import Cell
    from ..measure.seamlines.seam_features import SeamFeature
    from ..measure.source_images import Source
    from ..measure.window.inspection import Block


_TOLD_EVERY_S = 10.0  # from one word on how long the rest of a job will take to the next


@dataclass(frozen=True)
class GivenSources:
    """The values of SOURCES and SOURCE_INDEX in plain data, as far as they can be had before the work begins."""

    refs: tuple[RasterRef, ...]  # the files of SOURCES
    left_out: tuple[Message, ...]  # why others have no file
    index_path: str  # the file of SOURCE_INDEX; empty for a layer in memory, or none at all


def check_sources(run: Run) -> None:
    """Raise SettingsError when neither SOURCES nor SOURCE_INDEX names any."""
    if not run.raster_values(common.SOURCES) and not run.parameters.get(common.SOURCE_INDEX):
        raise SettingsError(messages.NO_SOURCES_GIVEN())


def given_sources(run: Run) -> GivenSources:
    """What the layers of SOURCES and SOURCE_INDEX say of their files; to be asked in their thread."""
    from ...toolkit.layers import layer_path

    refs, left_out = run.raster_refs(common.SOURCES)
    index = run.vector_layer(common.SOURCE_INDEX)
    return GivenSources(tuple(refs), tuple(left_out), layer_path(index) if index is not None else "")


class BlockAlgorithm(SeamInspectorAlgorithm):
    """What works on a mosaic and its orthoimages."""

    def add_block(self) -> None:
        """Add MOSAIC, SOURCES and SOURCE_INDEX."""
        for described in (common.mosaic(), common.sources(), common.source_index()):
            self.addDescribed(*described)

    def prepare_run(self, run: Run) -> None:
        self._mosaic, self._given = run.mosaic(), given_sources(run)


def gathered_sources(
    run: Run, given: GivenSources, crs: QgsCoordinateReferenceSystem, wkt: str, mosaic: RasterRef | None = None
) -> list[Source]:
    """All sources, each once, with their footprints in a reference system; warns of those left out. Copies of the
    mosaic are still among them."""
    from ..measure.source_images import gather_sources

    indexed = _indexed_sources(run, given, crs)
    run.tell_once(given.left_out)
    sources, notices = gather_sources(given.refs, indexed, wkt, mosaic)
    run.tell_once(notices)
    return sources


def _indexed_sources(run: Run, given: GivenSources, crs: QgsCoordinateReferenceSystem) -> list[Source]:
    """The orthoimages of SOURCE_INDEX with their footprints in a reference system; none where it is not given.

    Raises SettingsError when the layer is no such index.
    """
    from ...toolkit import layers
    from ..tables.input_layers import indexed_sources

    if not run.parameters.get(common.SOURCE_INDEX):
        return []
    index = run.source(common.SOURCE_INDEX)
    transform = run.transform(index, crs)
    return indexed_sources(layers.features(index), index.fields().names(), given.index_path, transform)


def given_block(run: Run, mosaic: Raster, given: GivenSources, cells: Iterable[Cell] = ()) -> Block:
    """Mosaic and sources; warns of those left out. Raises SettingsError when none is named at all."""
    from ...toolkit.layers import mosaic_crs
    from ..measure.window.inspection import make_block, without_copies

    indexed = _indexed_sources(run, given, mosaic_crs(mosaic))
    run.tell_once(given.left_out)
    block, notices = make_block(mosaic, given.refs, indexed, cells)
    block, of_copies = without_copies(block)
    run.tell_once([*notices, *of_copies])
    return block


def given_features(run: Run, name: str, crs: QgsCoordinateReferenceSystem) -> tuple[list[SeamFeature], Sequence[str]]:
    """The seams of a parameter in a reference system, and the names of their fields; tells how many can't be
    transformed."""
    from ...toolkit import layers
    from ..tables.input_layers import seam_features

    layer = run.source(name)
    names = layer.fields().names()
    features, lost = seam_features(layers.features(layer), names, run.transform(layer, crs))
    run.tell(*(() if lost is None else (lost,)))
    return features, names


def follow_steps(run: Run, steps: Iterable[ScanStep], part: float) -> None:
    """Do what a job still has to do: its progress, as a part of the whole run's, its notices, and now and then how
    long the rest will take."""
    from ..jobs import time_left

    told_at = time.monotonic()
    for step in steps:
        run.tell_once(step.notices)
        run.progress(part * step.share)
        if step.seconds_left is not None and time.monotonic() - told_at > _TOLD_EVERY_S:
            told_at = time.monotonic()
            run.feedback.setProgressText(time_left(step.seconds_left))
