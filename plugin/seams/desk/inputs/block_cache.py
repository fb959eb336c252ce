"""The block under inspection, made from the project's layers, and windows on its pixels."""
from __future__ import annotations

import contextlib
import hashlib
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from threading import Lock

from qgis.core import (
    QgsCoordinateReferenceSystem,
    QgsCoordinateTransform,
    QgsCsException,
    QgsGeometry,
    QgsMapLayer,
    QgsProject,
    QgsRasterLayer,
    QgsVectorLayer,
    QgsVectorLayerFeatureSource,
)
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery import messages as imagery_messages
from ....imagery.errors import WARNING, Message, RasterError, SeamInspectorError, SettingsError, WindowError
from ....imagery.file_identity import content_of
from ....imagery.grids import PixelWindow
from ....imagery.open_raster import OpenRaster, check_readable, describe_mosaic
from ....imagery.rasters import Raster, RasterRef
from ....toolkit import layers
from ....toolkit import messages as toolkit_messages
from ....toolkit.background_tasks import BackgroundTasks, Cancelled, Job, Outcome
from ....toolkit.reference_systems import reference_system, transformation
from ....toolkit.translation import tr
from ...jobs import ScanOrder
from ...measure import messages
from ...measure.blocks.block_grid import ScanSettings
from ...measure.seam_cells import Cell
from ...measure.source_images import Source
from ...measure.window.inspection import Block, make_block, window_request, without_copies
from ...measure.window.measured_window import InspectionSettings, WindowRequest
from ...measure.window_records import WindowRecord
from ...tables import input_layers, window_layer
from ...tables.window_file import KnownMosaic
from .project_inputs import Inputs


class BlockCache(QObject):
    """Knows the inputs and the ``Block`` that they make. Mosaic and source index are opened in the background, once."""

    opened = pyqtSignal()
    """The mosaic was opened, or could not be; or copies of it were found among its sources."""
    notified = pyqtSignal(object)  # a Message on copies of the mosaic among its sources
    _compared = pyqtSignal(object)  # a ComparedBlock, from whatever thread

    def __init__(self, project: QgsProject, background: BackgroundTasks, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._project = project
        self._background = background
        self._background.ended.connect(self._ended)
        self._compared.connect(self._take_compared)
        self._comparing = Lock()
        self._last_compared: ComparedBlock | None = None
        self.inputs = Inputs()
        self._turn = 0  # counts what was opened, so that only the last one is taken
        self.doubt: Message | None = None  # why the mosaic is not for the windows that are looked at
        self.forget()

    def forget(self) -> None:
        """Another project."""
        self._files: object = None  # what has to be opened, which may take long when it is on a network drive
        self._opened: OpenedFiles | None = None
        self._unopened: Message = messages.NO_MOSAIC()  # why nothing is opened; a warning while it is being opened
        self._block: Block | None = None
        self._failure: Message | None = None  # why what is opened makes no block
        self._made: tuple[object, Block] | None = None  # what the last block was made of, and that

    def refresh(self, anew: bool = False) -> None:
        """The inputs or the project's layers have changed; ``anew``: there may be something else in the files."""
        self._block = self._failure = None
        if anew:
            self._made = None
        mosaic, vectors = self.mosaic_layer(), (self.inputs.source_index, self.inputs.cells)
        try:
            if mosaic is None:
                raise SettingsError(messages.NO_MOSAIC())
            ref, origins = layers.layer_ref(mosaic), [_origin(self._project.mapLayer(name)) for name in vectors]
        except SeamInspectorError as error:
            self.forget()
            self._unopened = error.message
            self._background.cancel_others(set())
            return
        files = ref, origins
        if files == self._files and not anew:
            return
        if files != self._files:
            self._opened = None
        self._files = files
        self._unopened = messages.MOSAIC_OPENING()
        self._turn += 1
        self._background.cancel_others({self._turn})
        job = opening_job(self._project, self.inputs, ref)
        self._background.start(tr("Open the mosaic"), job, partial(self._take, self._turn), self._turn)

    def mosaic_layer(self) -> QgsRasterLayer | None:
        """The mosaic, while it is there."""
        layer = self._project.mapLayer(self.inputs.mosaic)
        return layer if isinstance(layer, QgsRasterLayer) else None

    def known_mosaic(self) -> KnownMosaic | None:
        """The mosaic as it is known again; None while it is not open."""
        if self._opened is None:
            return None
        return KnownMosaic(self._opened.mosaic.ref.path, self._opened.content)

    def settings(self) -> InspectionSettings:
        """How windows are measured."""
        inputs = self.inputs
        return InspectionSettings(inputs.wavelet, inputs.levels, inputs.max_ratio, inputs.reference, inputs.min_kept)

    def problem(self) -> Message | None:
        """Why there is no block; None when there is one."""
        if self._opened is None:
            return self._unopened
        if self.doubt is not None:
            return self.doubt
        if self._block is None and self._failure is None:
            try:
                self._block = self._made_of(self._opened)
            except SeamInspectorError as error:
                self._failure = error.message
        return self._failure

    def _made_of(self, opened: OpenedFiles) -> Block:
        """The block, made once of the same layers: of hundreds that takes a tenth of a second.

        Raises SeamInspectorError when they make none.
        """
        key = opened, [(name, self.seen(name)) for name in self.inputs.sources]
        if self._made is None or self._made[0] != key:
            sources = layer_sources(self._project, self.inputs, opened.mosaic)
            self._made = key, make_block(opened.mosaic, [], [*sources, *opened.indexed], opened.cells)[0]
        known = self._last_compared
        return known.kept if known is not None and known.block is self._made[1] else self._made[1]

    def without_copies(self, block: Block) -> Block:
        """A block without copies of the mosaic among its sources, which hide all that was lost. In any thread but the
        interface's: it reads pixels, once for each block, and others wait for it."""
        with self._comparing:
            known = self._last_compared
            if known is None or not (block is known.block or block is known.kept):
                kept, notices = without_copies(block)
                self._last_compared = known = ComparedBlock(block, kept, tuple(notices))
                self._compared.emit(known)
        return known.kept

    def _take_compared(self, compared: ComparedBlock) -> None:
        if self._made is not None and self._made[1] is compared.block:
            for notice in compared.notices:
                self.notified.emit(notice)
            if compared.kept != compared.block:
                self._block = None
                self.opened.emit()

    def required(self) -> Block:
        """The block. Raises SettingsError when there is none, or not yet."""
        problem = self.problem()
        if problem is not None:
            raise SettingsError(problem)
        assert self._block is not None
        return self._block

    def scan_order(self) -> ScanOrder:
        """What a scan of the whole mosaic is made of; it needs no sources where there are seamlines.

        Raises SeamInspectorError when the inputs do not allow one.
        """
        if self._opened is None:
            raise SettingsError(self._unopened)
        inputs, mosaic, read_seams = self.inputs, self._opened.mosaic, None
        if (given := self._given_seams(mosaic)) is not None:
            seamlines, transform = given
            source, names = seamlines.source, seamlines.names
            read_seams = lambda: input_layers.seam_features(source.getFeatures(), names, transform)  # noqa: E731
        is_without = not self._opened.indexed and not layer_sources(self._project, inputs, mosaic)
        sources = () if is_without and read_seams is not None else self.required().sources
        settings = ScanSettings(
            inputs.wavelet, inputs.levels, inputs.density, piece_m=inputs.piece_m,
            corridor_m=inputs.corridor_m if read_seams is not None else 0.0,
        )
        settings.check()
        return ScanOrder(mosaic, sources, settings, read_seams)

    def silent(self) -> Block | None:
        """The block; None when there is none, or not yet."""
        return self._block if self.problem() is None else None

    def state(self) -> str | None:
        """The fingerprint of all that a result depends on; None while that is not known.

        Equal inputs have equal fingerprints, so results are up to date again when a change is taken back, and wherever
        mosaic and sources were moved to together. A layer that was removed counts no more.
        """
        inputs, mosaic, opened = self.inputs, self.seen(self.inputs.mosaic), self._opened
        if mosaic is None or opened is None:
            return None
        folder, windows = os.path.dirname(mosaic[0]), self.seen(inputs.windows)
        sources = [(_from(folder, place[0]), place[1]) for place in map(self.seen, inputs.sources) if place is not None]
        listed = [(_from(folder, source.ref.path), source.extent) for source in opened.indexed]
        windows_crs = "" if windows is None else windows[1]
        said = os.path.basename(mosaic[0]), mosaic[1], sources, listed, opened.cells, self.settings(), windows_crs
        return hashlib.sha256(repr(said).encode()).hexdigest()

    def seen(self, layer_id: str) -> tuple[str, str] | None:
        """Data source of a layer, and its reference system with its additional nodata; None where it is gone."""
        layer = self._project.mapLayer(layer_id)
        if layer is None:
            return None
        crs = layer.crs()
        nodata = layers.additional_nodata(layer) if isinstance(layer, QgsRasterLayer) else None
        return layer.source(), (crs.authid() or layers.system_wkt(crs)) + ("" if nodata is None else f" {nodata!r}")

    def _take(self, turn: int, opened: object) -> None:
        if turn != self._turn:
            return
        if isinstance(opened, OpenedFiles):
            self._opened = opened
        else:
            self._opened = None
            self._unopened = opened if isinstance(opened, Message) else messages.MOSAIC_NOT_OPENED()
        self._block = self._failure = None
        self.opened.emit()

    def _ended(self, key: object, outcome: Outcome) -> None:
        """A task that was cancelled in QGIS, or failed, must not leave us waiting."""
        if key == self._turn and self._unopened.level is WARNING and self._opened is None:
            self._take(self._turn, outcome.failure)

    def seamlines(self, block: Block) -> Iterator[bytes | None] | None:
        """The seamlines' geometries in the mosaic's reference system, to be read in any thread."""
        given = self._given_seams(block.mosaic)
        return None if given is None else _geometries(*given)

    def _given_seams(self, mosaic: Raster) -> tuple[LayerFeatures, QgsCoordinateTransform] | None:
        seamlines, crs = LayerFeatures.of(self._project.mapLayer(self.inputs.seamlines)), layers.mosaic_crs(mosaic)
        if seamlines is None:
            return None
        return seamlines, transformation(seamlines.crs, crs, self._project.transformContext())

    def outlines(self, block: Block, layer: QgsVectorLayer, windows: Sequence[PixelWindow]) -> list[QgsGeometry]:
        """Windows as polygons in a layer's reference system, where they need not be upright.

        Raises WindowError when they can't be transformed.
        """
        crs = layers.mosaic_crs(block.mosaic)
        rectangles = [layers.rectangle(block.mosaic.grid.window_extent(window)) for window in windows]
        return self._transformed(rectangles, crs, layer.crs())

    def shapes(
        self, layer: QgsVectorLayer, fids: Sequence[int], crs: QgsCoordinateReferenceSystem
    ) -> list[QgsGeometry]:
        """Windows of a layer in another reference system, in the order of their ids here.

        Raises WindowError when they can't be transformed.
        """
        by_fid = window_layer.read_shapes(layer, fids)
        return self._transformed([by_fid[fid] for fid in fids if fid in by_fid], layer.crs(), crs)

    def _transformed(
        self, shapes: list[QgsGeometry], crs: QgsCoordinateReferenceSystem, target: QgsCoordinateReferenceSystem
    ) -> list[QgsGeometry]:
        transform = transformation(crs, target, self._project.transformContext())
        if not all(_is_transformed(geometry, transform) for geometry in shapes):
            raise WindowError(imagery_messages.EXTENT_NOT_TRANSFORMED())
        return shapes

    def requests(
        self, block: Block, layer: QgsVectorLayer, rows: Sequence[WindowRecord], compared: bool = False
    ) -> Iterator[WindowRequest]:
        """The requests for windows, to be made in any thread, as there may be thousands; ``compared``: in another one
        than the interface's, where copies of the mosaic are looked for first."""
        crs, transform, shapes = layers.mosaic_crs(block.mosaic), None, {}
        with contextlib.suppress(WindowError):  # each window tells
            transform = transformation(layer.crs(), crs, self._project.transformContext())
        if layer.crs() != crs:  # the box of a polygon that is not upright there is too large
            shapes = window_layer.read_shapes(layer, [row.fid for row in rows])
        made_of = partial(self.without_copies if compared else lambda given: given, block)
        return _requests(made_of, list(rows), shapes, transform, self.settings())


def _from(folder: str, path: str) -> str:
    """The way to a file from a folder, which stays when both are moved; other sources as they are."""
    try:
        return os.path.relpath(path, folder) if os.path.isabs(path) else path
    except ValueError:  # on another drive
        return path


def _requests(
    made_of: Callable[[], Block],
    rows: list[WindowRecord],
    shapes: dict[int, QgsGeometry],
    transform: QgsCoordinateTransform | None,
    settings: InspectionSettings,
) -> Iterator[WindowRequest]:
    """A generator, so that nothing is done before it is asked."""
    block = made_of()
    for row in rows:
        why = toolkit_messages.WINDOW_EMPTY()
        if row.extent is not None:
            geometry = shapes.get(row.fid, layers.rectangle(row.extent))
            if transform is not None and _is_transformed(geometry, transform):
                yield window_request(block, row.window_id, layers.extent(geometry), settings)
                continue
            why = imagery_messages.EXTENT_NOT_TRANSFORMED()
        yield WindowRequest(row.window_id, block.mosaic, (), None, settings, why)


def _geometries(seamlines: LayerFeatures, transform: QgsCoordinateTransform) -> Iterator[bytes | None]:
    """A generator, so that features are fetched where it runs, and their source lives as long as it does."""
    for feature in seamlines.source.getFeatures():
        yield layers.line_wkb(feature, transform)


def _is_transformed(geometry: QgsGeometry, transform: QgsCoordinateTransform) -> bool:
    try:
        geometry.transform(transform)
    except QgsCsException:
        return False
    return True


@dataclass(frozen=True)
class ComparedBlock:
    """A block whose sources were compared with its mosaic."""

    block: Block
    kept: Block  # without copies of the mosaic
    notices: tuple[Message, ...]  # which are left out, and which may be some


@dataclass(frozen=True)
class OpenedFiles:
    """What was found in the files of the inputs."""

    mosaic: Raster
    indexed: tuple[Source, ...]  # the orthoimages of the source index
    cells: tuple[Cell, ...] = ()  # which source each part of the mosaic was cut from
    content: str = ""  # what the mosaic is known again by, wherever it lies


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


def opening_job(project: QgsProject, inputs: Inputs, ref: RasterRef) -> Job:
    """Opens the files of the inputs; yields the OpenedFiles, or the Message why there are none."""
    context, crs = project.transformContext(), reference_system(ref.wkt)
    index, cells = (LayerFeatures.of(project.mapLayer(layer_id)) for layer_id in (inputs.source_index, inputs.cells))

    def opened() -> OpenedFiles:
        mosaic = describe_mosaic(ref)
        check_readable(OpenRaster(ref))
        target = crs if crs.isValid() else layers.mosaic_crs(mosaic)
        indexed: list[Source] = []
        known: list[Cell] = []
        if index is not None:
            transform = transformation(index.crs, target, context)
            indexed = input_layers.indexed_sources(index.source.getFeatures(), index.names, index.path, transform)
        if cells is not None:
            if input_layers.CELL_FIELD not in cells.names:
                raise SettingsError(messages.CELLS_WITHOUT_SOURCE())
            transform = transformation(cells.crs, target, context)
            known = input_layers.seam_cells(cells.source.getFeatures(), transform)
        return OpenedFiles(mosaic, tuple(indexed), tuple(known), content_of(ref.path))

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
