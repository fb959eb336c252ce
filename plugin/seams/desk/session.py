"""The one model behind the dock, the map tool and all panels: inputs, windows, results, and work in the background."""
from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from qgis.core import QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...imagery.errors import SeamInspectorError
from ...imagery.grids import Grid, PixelWindow
from ...imagery.message import Message
from ...toolkit.desk.background_tasks import BackgroundTasks
from ...toolkit.desk.timers import single_shot
from ...toolkit.layer_editing import edit_step
from ...toolkit.message_bar import bar_level
from ...toolkit.translation import sentence, tr
from ..clip_pictures import ClipPicture
from ..measure.inputs.valid_cells import FEWEST_PX, SEARCHED_SIDES
from ..measure.inspection import Block, WindowRequest
from ..measure.live.live_window import LiveWindow
from ..measure.observers import FIRST, Operator
from ..measure.window.window_result import WindowCurves, WindowResult
from ..measure.window_records import WindowRecord
from ..scan_job import ScanOrder
from ..tables import window_layer
from .images.window_pictures import WindowPictures
from .inputs.block_cache import BlockCache
from .inputs.inputs_watch import InputsWatch
from .inputs.layer_places import LayerPlaces
from .inputs.project_inputs import Inputs, load_inputs, save_inputs
from .keeping.keeping import Keeping
from .live.live_windows import LiveWindows
from .loss_view import LossView
from .map.seam_finder import SeamFinder
from .map.window_coverage import Coverage, WindowCoverage
from .windows.new_windows import NewWindows
from .windows.window_results import WindowResults
from .windows.window_watch import WindowWatch


class Session(QObject):
    """Inputs, windows, results. Everything that reads pixels runs in tasks; results come back by signals."""

    inputsChanged = pyqtSignal()
    coverageChanged = pyqtSignal()
    windowsChanged = pyqtSignal()
    selectionChanged = pyqtSignal()
    curvesArrived = pyqtSignal(int)
    resultArrived = pyqtSignal(int)
    liveChanged = pyqtSignal()
    picturesArrived = pyqtSignal(int)
    progressChanged = pyqtSignal(int, int)
    messageRaised = pyqtSignal(str, int)
    windowsFound = pyqtSignal(object)
    """Path of windows of a project that was never saved, as QGIS ended before."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.loss_view = LossView(self)
        """Whether lost detail is painted over the map and the images."""
        self._project = QgsProject.instance()
        self._inputs_background = BackgroundTasks(self)  # apart, since another window layer does not matter to it
        self._inputs_background.failed.connect(self._tell)
        self._block = BlockCache(self._project, self._inputs_background, self)
        self._block.opened.connect(self._opened)
        self._places = LayerPlaces(self._project)
        self._seams = SeamFinder(self._block, self._inputs_background)
        self._coverage = WindowCoverage(self)
        self._coverage.changed.connect(self.coverageChanged)
        self._layers = InputsWatch(self._project, self)
        self._layers.layersChanged.connect(self._files_changed)
        self._layers.indexEdited.connect(self._files_changed)
        self._layers.seamlinesEdited.connect(self._seamlines_edited)
        self._watch = WindowWatch(self)
        self._watch.windowsChanged.connect(self.windowsChanged)
        self._watch.selectionChanged.connect(self.selectionChanged)
        self._watch.replaced.connect(self._windows_replaced)
        self._keeping = Keeping(self._watch, self)
        self._keeping.told.connect(self._tell)
        self._background = BackgroundTasks(self)
        self._background.failed.connect(self._tell)
        self._live = LiveWindows(self._block, self)
        self._live.changed.connect(self.liveChanged)
        self._live.failed.connect(self._tell)
        self._results = WindowResults(
            self._block, self._watch, self._background, self._keeping, self, self._live.measure
        )
        self._results.curvesArrived.connect(self._live.stay_open)
        self._results.curvesArrived.connect(self.curvesArrived)
        self._results.arrived.connect(self.resultArrived)
        self._results.progressChanged.connect(self.progressChanged)
        self._results.failed.connect(self._tell)
        self._new = NewWindows(self._project, self._block, self._watch, self._background, self)
        self._new.layerMade.connect(self._take_layer)
        self._new.drawn.connect(self._take_drawn)
        self._new.told.connect(self._tell)
        self._pictures = WindowPictures(self._block, self._watch, self._background, self)
        self._pictures.arrived.connect(self.picturesArrived)
        self._searcher = single_shot(self, self._find_left)  # the project is still being read when it tells so
        self._connections: list[tuple[Any, Callable[..., None]]] = [
            (self._project.readProject, self._load),
            (self._project.cleared, self._load),
            (self._project.writeProject, self._save),
            (self._project.layersAdded, self._layers_added),
            (self._project.layersWillBeRemoved, self._forget_layers),
            (self._project.layersRemoved, self._layers_changed),
        ]
        for signal, slot in self._connections:
            signal.connect(slot)
        self._load()

    def close(self) -> None:
        """Stop all work, keep what is done, and let go of the project and the window layer; once is enough."""
        while self._connections:
            signal, slot = self._connections.pop()
            signal.disconnect(slot)
        self._new.abandon()
        self._live.close()
        self._layers.close()
        self._coverage.close()
        self._inputs_background.close()
        self._background.close()
        self._results.close()
        self._searcher.stop()
        self._keeping.close()
        self._watch.close()

    # Inputs

    @property
    def inputs(self) -> Inputs:
        """What is inspected and how."""
        return self._block.inputs

    def set_inputs(self, inputs: Inputs) -> None:
        """Change the inputs and remember them in the project. Inspected windows become stale when they matter."""
        before = self.inputs
        if before == inputs:
            return
        if before.windows != inputs.windows:
            self._results.write()  # into the layer they are of
        self._block.inputs = inputs
        save_inputs(self._project, inputs)
        self._layers_changed()

    def mosaic_layer(self) -> QgsRasterLayer | None:
        """The mosaic, while it is there."""
        return self._block.mosaic_layer()

    def mosaic_grid(self) -> Grid | None:
        """The mosaic's pixel grid; None while there is no mosaic that windows can lie on, or it is being opened."""
        block = self._block.silent()
        return block.mosaic.grid if block is not None else None

    def block(self) -> Block | None:
        """Mosaic and sources under inspection; None while there are none, or they are being opened."""
        return self._block.silent()

    def problem(self) -> Message | None:
        """Why nothing can be inspected now: an input is missing or can't be used, or the mosaic is being opened."""
        return self._block.problem()

    def scan_order(self) -> ScanOrder:
        """What a scan of the whole mosaic is made of. Raises SeamInspectorError when the inputs do not allow one."""
        return self._block.scan_order()

    def source_count_over(self, window: PixelWindow) -> int:
        """How many sources' footprints cover a window."""
        block = self._block.silent()
        return len(block.sources_over(window)) if block is not None else 0

    def coverage(self, window: PixelWindow) -> Coverage:
        """What mosaic and sources have in a window, as far as it was looked at."""
        return self._coverage.at(window)

    def nearest_judgeable(self, window: PixelWindow, on_seam: bool) -> PixelWindow | None:
        """The nearest window of that size that can be judged, its middle on a seam; None where none is near."""
        grid = self.mosaic_grid()
        if grid is None:
            return None
        xmin, ymin, xmax, ymax = grid.window_extent(window)
        reach, spacing = SEARCHED_SIDES * max(xmax - xmin, ymax - ymin), FEWEST_PX * grid.pixel_width
        middle = (xmin + xmax) / 2, (ymin + ymax) / 2
        return self._coverage.nearest(window, self._seams.points(*middle, reach, spacing) if on_seam else None)

    def request(self, fid: int) -> WindowRequest | None:
        """A window as it is measured, and the sources over it; None while there is no block."""
        row, block, layer = self.row(fid), self.block(), self.window_layer()
        if row is None or block is None or layer is None:
            return None
        return next(self._block.requests(block, layer, [row]))

    def seam_point_near(self, x: float, y: float, reach: float) -> tuple[float, float] | None:
        """The nearest point of a seam within ``reach``, all in the mosaic's reference system."""
        return self._seams.nearest(x, y, reach)

    # The window under the mouse

    @property
    def live(self) -> LiveWindow | None:
        """The window that is being drawn or moved, as far as it is known; ``liveChanged`` tells."""
        return self._live.current

    def hover(self, window: PixelWindow, is_live: bool) -> None:
        """A window that a click or the end of a drag would make; ``is_live``: its curves are to be seen meanwhile."""
        self._live.hover(window, is_live)

    def leave(self) -> None:
        """The mouse is over no window any more."""
        self._live.leave()

    # Windows

    def window_layer(self) -> QgsVectorLayer | None:
        """The layer that holds the windows, while it is there."""
        return self._watch.layer

    def windows(self) -> list[WindowRecord]:
        """All windows by their number."""
        return self._watch.rows()

    def row(self, fid: int) -> WindowRecord | None:
        """One window."""
        return self._watch.row(fid)

    def selected(self) -> list[int]:
        """Feature ids of the selected windows."""
        return self._watch.selected()

    def select(self, fids: Sequence[int]) -> None:
        """Select windows, on the map and in the table alike."""
        self._watch.select(fids)

    def add_window(self, window: PixelWindow) -> None:
        """A new window, selected and inspected at once in the background; the first one waits for its layer."""
        self._new.draw(window)

    def remove(self, fids: Sequence[int]) -> None:
        """Remove windows; undo brings them back."""
        with self._raised():
            if self._watch.layer is not None and fids:
                window_layer.remove_windows(self._watch.layer, fids)

    def judge(self, fids: Sequence[int], word: str, operator: Operator = FIRST) -> None:
        """Write what an operator saw: ``visible``, ``invisible``, ``unsure`` or nothing."""
        self.note(fids, {operator.observer: word or None})

    def note(self, fids: Sequence[int], values: Mapping[str, object]) -> None:
        """Write what an operator says of windows, by his fields' names; None takes it back."""
        with self._raised():
            if (layer := self._watch.layer) is None:
                return
            others = window_layer.not_judged_so(layer, fids, values)  # the same again is no step
            if others:
                with edit_step(layer, tr("Judge windows")):
                    prepared = self._watch.prepare(others, self.inputs.levels, values)
                    window_layer.write_judgement(layer, prepared, values)
                self._keeping.note_judged(layer)

    # Work in the background

    @property
    def is_busy(self) -> bool:
        """Whether windows are being made, placed or inspected."""
        return self._background.is_busy or self._new.is_busy

    def is_pending(self, fid: int) -> bool:
        """Whether a window is being inspected, or its result not written yet."""
        row = self.row(fid)
        return row is not None and self._results.is_pending(row.window_id)

    def place_windows(self) -> None:
        """Place windows along the seamlines; they are added when all are found, and not inspected yet."""
        with self._raised():
            self._new.place()

    def inspect(self, fids: Sequence[int]) -> None:
        """Inspect windows, those left out that are being inspected already."""
        with self._raised():
            self._results.inspect(fids)

    def inspect_pending(self) -> None:
        """Inspect all windows that are not inspected yet or have changed since."""
        self.inspect([row.fid for row in self.windows() if not row.verdict or row.stale])

    def stop(self) -> None:
        """Cancel placing and inspection; what is done stays."""
        self._results.forget_asked()
        self._background.stop()

    def result(self, fid: int) -> WindowResult | None:
        """All that was measured in a window in this session; None until it is complete."""
        row = self.row(fid)
        return self._results.result(row.window_id) if row is not None else None

    def results(self) -> list[WindowResult]:
        """Of all windows that were inspected in this session."""
        return self._results.results()

    def clips(self, fid: int) -> WindowCurves | None:
        """The curves of a window, which ``curvesArrived`` tells before the rest; its result once that is there."""
        row = self.row(fid)
        return self._results.clips(row.window_id) if row is not None else None

    def pictures(self, fid: int) -> tuple[ClipPicture, ...] | None:
        """The clips of a window as pictures; when they are not there yet they are read in the background."""
        return self._pictures.pictures(fid)

    def composite(self, fid: int) -> tuple[ClipPicture, ...] | None:
        """The hard-cut composite of a window whose pictures are there; None while it is made, empty without one."""
        return self._pictures.composite(fid)

    def _take_layer(self, layer_id: str) -> None:
        """A window layer was made for new windows."""
        self.set_inputs(replace(self.inputs, windows=layer_id))

    def _take_drawn(self, fids: list[int]) -> None:
        self.select(fids)
        self.inspect(fids)

    # The project

    def _load(self, *_: object) -> None:
        self._live.leave()
        self._live.let_go()
        self._inputs_background.abandon()
        self._block.forget()
        self._seams.forget()
        self._forget_windows()
        self._block.inputs = load_inputs(self._project)
        self._places.load()
        self._layers_changed()
        self._searcher.start()

    def _find_left(self) -> None:
        """Windows of this project that were never saved with it, as QGIS ended before; or of one without a file."""
        if self._watch.layer is not None or (path := self._keeping.left_in(self._project)) is None:
            return
        if self._project.fileName():
            self.open_windows(path)
        else:
            self.windowsFound.emit(path)

    def open_windows(self, path: Path) -> None:
        """Take the windows of a file that the desk has made."""
        with self._raised():
            self._take_layer(self._project.addMapLayer(window_layer.open_window_layer(path)).id())

    def _save(self, *_: object) -> None:
        """Save the windows with the project, as its user expects."""
        self._results.write()
        self._watch.save_stale()
        if (layer := self._watch.layer) is not None:
            self._keeping.save(layer, self._project)

    def _layers_added(self, *_: object) -> None:
        """One that was removed may be back, under another id."""
        inputs = self._places.found_again(self.inputs)
        if inputs != self.inputs:
            self.set_inputs(inputs)
        else:
            self._layers_changed()

    def _layers_changed(self, *_: object) -> None:
        self._places.note(self.inputs)
        self._block.refresh()
        self._layers.follow(self.inputs)
        layer = self._project.mapLayer(self.inputs.windows)
        if (layer if window_layer.holds_windows(layer) else None) is not self._watch.layer:
            self._forget_windows()
            self._watch.watch(layer)
            if self._watch.layer is not None:
                self._keeping.follow(self._watch.layer, self.inputs.levels)
        self._opened()

    def _opened(self) -> None:
        """There may be another block, or none any more."""
        self._seams.refresh()
        self._coverage.follow(self._block.silent())
        self._watch.set_state(self._block.state())
        self.inputsChanged.emit()

    def _files_changed(self) -> None:
        self._live.let_go()
        self._block.refresh(anew=True)
        self._coverage.follow(None)  # what lies in the files may be something else
        self._opened()

    def _seamlines_edited(self) -> None:
        self._seams.refresh(anew=True)

    def _windows_replaced(self) -> None:
        if (layer := self._watch.layer) is not None:
            self._keeping.leave([layer.id()])
        self._forget_windows()
        self._layers_changed()

    def _forget_layers(self, ids: list[str]) -> None:
        self._live.let_go()  # or their files could not be moved or deleted
        self._layers.leave(ids)
        self._keeping.leave(ids)
        if (layer := self._watch.layer) is not None and layer.id() in ids:
            self._forget_windows()

    def _forget_windows(self) -> None:
        """What is of the window layer so far; nothing of it may reach another one."""
        self._new.abandon()
        self._background.abandon()
        self._watch.watch(None)
        self._pictures.forget()
        self._results.forget()

    def _tell(self, message: Message) -> None:
        self.messageRaised.emit(sentence(message), bar_level(message))

    @contextmanager
    def _raised(self) -> Iterator[None]:
        """Errors the user can mend become a message, not a traceback."""
        try:
            yield
        except SeamInspectorError as error:
            self._tell(error.message)
