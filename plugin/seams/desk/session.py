"""The one model behind the dock, the map tool and all panels: inputs, windows, results, and work in the background.

It makes the parts, leads them after the project as that is read, saved and changed, and is what all others ask.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from qgis.core import QgsMapLayer, QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal
from qgis.PyQt.QtGui import QIcon
from qgis.PyQt.QtWidgets import QAction

from ...imagery.errors import Message, SeamInspectorError
from ...imagery.grids import Grid, PixelWindow
from ...imagery.statistics import FIRST, Operator
from ...toolkit.background_tasks import BackgroundTasks
from ...toolkit.connections import Connections
from ...toolkit.desk.tool_dock import bar_level
from ...toolkit.resources import icon_path
from ...toolkit.translation import filled, sentence, tr
from ..jobs import ScanOrder
from ..measure.window.explained_window import LiveWindow
from ..measure.window.inspection import Block, WindowRequest
from ..measure.window.window_result import WindowResult
from ..measure.window_records import WindowRecord
from ..tables import window_layer
from ..tables.window_layer import style_once
from . import messages
from .inputs.block_cache import BlockCache
from .inputs.project_inputs import Inputs, InputsWatch, load_inputs, save_inputs
from .map.under_mouse import ClickedPiece, LiveWindows, SeamFinder
from .window_home import MADE_FOR, WindowHome, WindowsMosaic, show_layers_of, windows_of
from .windows.new_windows import NewWindows
from .windows.window_results import WindowResults, WindowSteps, words_of
from .windows.window_watch import WindowWatch


class Session(QObject):
    """Inputs, windows, results. Everything that reads pixels runs in tasks; results come back by signals."""

    inputsChanged = pyqtSignal()
    liveChanged = pyqtSignal()
    messageRaised = pyqtSignal(str, int)
    messageOutdated = pyqtSignal(str)
    windowsChanged = pyqtSignal()
    selectionChanged = pyqtSignal()
    curvesArrived = pyqtSignal(int)
    resultArrived = pyqtSignal(int)
    progressChanged = pyqtSignal(int, int)
    mosaicDoubted = pyqtSignal(object)
    """The Message why the mosaic is not for the windows; ``take_windows`` and its like go on."""
    copyDoubted = pyqtSignal(object)
    """The Message why nothing can be written to the windows; ``copy_to_file`` and ``leave_windows`` go on."""
    placesTaken = pyqtSignal(list)  # feature ids of the windows at the worst places of a scan, worst first
    stepped = pyqtSignal(int)  # feature id of a window that undo or redo has changed
    begunAnew = pyqtSignal()  # other windows, or another mosaic, are looked at from now on

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._project = project = QgsProject.instance()
        self.lost_detail = QAction(QIcon(icon_path("loss")), tr("Lost detail"), self)
        """Checked while lost detail is painted over the map and the images."""
        self.lost_detail.setToolTip(
            tr("Show where detail was lost, over the map and the images (L while judging). One scale for all windows")
        )
        self.lost_detail.setCheckable(True)
        self._opening = BackgroundTasks(self)  # apart, since another window layer does not matter to it
        self._block = block = BlockCache(project, self._opening, self)
        self._seams = SeamFinder(block, self._opening)
        self._live = LiveWindows(block, self)
        self._layers = InputsWatch(project, self)
        self.piece: ClickedPiece | None = None  # of a scanned seam, which is looked at; ``liveChanged`` tells
        self._background = BackgroundTasks(self)
        self._watch = watch = WindowWatch(self)
        self._home = home = WindowHome(project)
        self._steps = steps = WindowSteps(watch, self)
        self._mosaics = WindowsMosaic(block, watch, self)
        self._results = WindowResults(block, steps, watch, self._background, self, self._live.measure)
        self._new = NewWindows(home, block, watch, steps, self._background, self)
        self._searched: set[str] = set()  # mosaics whose windows were looked for
        self._gone: dict[str, str] = {}  # ids of layers that were removed, by what they show
        self._connect_parts()
        self._connections = Connections(
            (project.readProject, self._load),
            (project.cleared, self._load),
            (project.writeProject, self._save),
            (project.layersAdded, self._take_back),
            (project.layersWillBeRemoved, self._forget_layers),
            (project.layersRemoved, self._layers_changed),
        )
        self._load()

    def _connect_parts(self) -> None:
        for signal, slot in (
            (self._live.changed, self.liveChanged),
            (self._block.opened, self._follow_block),
            (self._layers.layersChanged, self._files_changed),
            (self._watch.windowsChanged, self.windowsChanged),
            (self._watch.selectionChanged, self.selectionChanged),
            (self._watch.replaced, self._forget_windows), (self._watch.replaced, self._layers_changed),
            (self._results.curvesArrived, self._live.stay_open),
            (self._results.curvesArrived, self.curvesArrived),
            (self._results.arrived, self.resultArrived),
            (self._results.progressChanged, self.progressChanged),
            (self._new.layerMade, self._take_layer),
            (self._mosaics.doubted, self.mosaicDoubted),
            (self._steps.stepped, self._follow_step),
            *((notifier, self._tell) for notifier in (
                self._opening.failed, self._live.failed, self._block.notified, self._background.failed,
                self._results.failed, self._mosaics.notified, self._new.notified, self._steps.failed,
                self._watch.fieldMissed,
            )),
        ):  # fmt: skip
            signal.connect(slot)

    def close(self) -> None:
        """Stop all work, keep what is done, and let go of the project and the window layer; once is enough."""
        self._connections.close()
        for part in (self._layers, self._live, self._opening, self._background, self._results, self._watch):
            part.close()
        self._home.let_go()

    # Inputs

    @property
    def inputs(self) -> Inputs:
        """What is inspected and how."""
        return self._block.inputs

    def set_inputs(self, inputs: Inputs) -> None:
        """Change the inputs and remember them in the project. Inspected windows become stale when they matter."""
        is_another = self.inputs.mosaic != inputs.mosaic
        if is_another and self.inputs.windows == inputs.windows:
            inputs = replace(inputs, windows=windows_of(self._project, inputs.mosaic) or inputs.windows)
        if self.inputs.windows != inputs.windows:
            self._results.write()  # into the layer they are of
        if self.inputs == inputs:
            self._block.inputs = inputs  # the same, but chosen by whoever sets them now
            return
        if is_another:
            self.begunAnew.emit()  # judging puts back what it took off the map
            show_layers_of(self._project, inputs.mosaic)
        self._block.inputs = inputs
        save_inputs(self._project, inputs)
        self._layers_changed()

    def mosaic_grid(self) -> Grid | None:
        """The mosaic's pixel grid; None while there is no mosaic that windows can lie on, or it is being opened."""
        block = self.block()
        return block.mosaic.grid if block is not None else None

    @property
    def live(self) -> LiveWindow | None:
        """The window that is being drawn or moved, as far as it is known; ``liveChanged`` tells."""
        return self._live.current

    def block(self) -> Block | None:
        """The mosaic and its sources; None while there are none, or they are being opened."""
        return self._block.silent()

    def problem(self) -> Message | None:
        """Why there is no block; None when there is one."""
        return self._block.problem()

    def mosaic_layer(self) -> QgsRasterLayer | None:
        """The mosaic, while it is there."""
        return self._block.mosaic_layer()

    def scan_order(self) -> ScanOrder:
        """What a scan of the mosaic is made of. Raises SeamInspectorError when the inputs do not allow one."""
        return self._block.scan_order()

    def seam_point_near(self, x: float, y: float, reach: float) -> tuple[float, float] | None:
        """The nearest point of a seam within reach; None where there is none, or while they are being found."""
        return self._seams.nearest(x, y, reach)

    def hover(self, window: PixelWindow, is_live: bool) -> None:
        """The mouse is over this window; ``is_live``: its curves follow."""
        self._live.hover(window, is_live)

    def is_useless(self, window: PixelWindow) -> bool:
        """Whether nothing can be compared in the window under the mouse, as is known when the mouse has rested."""
        return self._live.useless == window

    def leave(self) -> None:
        """The mouse is over no window any more."""
        self._live.leave()

    def request(self, fid: int) -> WindowRequest | None:
        """A window as it is measured, and the sources over it; None while there is no block."""
        row, block, layer = self.row(fid), self.block(), self.window_layer()
        if row is None or block is None or layer is None:
            return None
        return next(self._block.requests(block, layer, [row]))

    # Windows

    @property
    def steps(self) -> Any:
        """What can be undone: a QUndoStack."""
        return self._steps.stack

    def window_layer(self) -> QgsVectorLayer | None:
        """The layer that holds the windows, while it is there."""
        return self._watch.layer

    def windows(self) -> list[WindowRecord]:
        """All windows by their number."""
        return self._watch.rows()

    def row(self, fid: int) -> WindowRecord | None:
        """One window."""
        return self._watch.row(fid)

    def numbered(self, window_id: int) -> WindowRecord | None:
        """The window with a number, which is for good."""
        return self._watch.numbered(window_id)

    def selected(self) -> list[int]:
        """Feature ids of the selected windows."""
        return self._watch.selected()

    def select(self, fids: Iterable[int]) -> None:
        """Select these windows and no others, on the map and in the table alike."""
        self._watch.select(fids)

    def add_window(self, window: PixelWindow) -> None:
        """Add one window, or take the one that is there already."""
        with self._raised():
            if fids := self._new.draw(window):
                self.select(fids)
                self.inspect(fids, is_step=False)

    def take_places(self, worst: QgsVectorLayer) -> None:
        """Add the worst places of a scan, inspect them, and tell ``placesTaken``."""
        with self._raised():
            fids = self._new.add_scanned(worst)
            self.inspect([fid for fid in fids if (row := self.row(fid)) and not row.verdict], is_step=False)
            self.placesTaken.emit(fids)

    def open_windows(self, path: Path) -> None:
        """Take the windows of a windows file."""
        with self._raised():
            self._home.hold(path)
            self._take_layer(self._project.addMapLayer(window_layer.open_window_layer(path)).id())

    def remove(self, fids: Sequence[int]) -> None:
        """Remove windows; undo brings them back."""
        with self._raised():
            rows = [row for row in map(self.row, fids) if row is not None]
            self._steps.remove(fids, words_of(rows, tr("removing window {number}"), tr("removing {count} windows")))

    def judge(self, fids: Sequence[int], word: str, operator: Operator = FIRST) -> None:
        """Write what an operator saw: ``visible``, ``invisible``, ``unsure`` or nothing, of which he can't be sure."""
        values: dict[str, object] = {operator.observer: word or None}
        if not word:
            values[operator.confidence] = None
        self.note(fids, values)

    def note(self, fids: Sequence[int], values: Mapping[str, object]) -> None:
        """Write what an operator says of windows, by his fields' names; None takes it back."""
        with self._raised():
            if (layer := self._watch.writable()) is None:
                return
            held = window_layer.held_values(layer, fids, list(values))
            others = [fid for fid, said in held.items() if any(said.get(name) != values[name] for name in values)]
            rows = [row for row in map(self.row, others) if row is not None]
            if rows:  # the same again is no step
                words = words_of(rows, tr("judging window {number}"), tr("judging {count} windows"))
                self._steps.change({row.fid: values for row in rows}, words)
                self._mosaics.note()

    def _follow_step(self, numbers: list[int]) -> None:
        """The operator sees what undo or redo did."""
        fids = [row.fid for row in map(self.numbered, numbers) if row is not None]
        if fids:
            self.select(fids)
            self.stepped.emit(fids[0])

    # Windows of another mosaic

    def take_windows(self) -> None:
        """They are of the present mosaic."""
        self._mosaics.take()
        self._follow_block()

    def leave_windows(self) -> None:
        """They stay as they are, and others are looked at."""
        self.set_inputs(replace(self.inputs, windows=""))

    def copy_to_file(self) -> None:
        """The windows of another format are copied into a windows file, and looked at there."""
        with self._raised():
            self._new.copy_file()

    def _take_layer(self, layer_id: str) -> None:
        """Windows are those of this layer, made or opened for the mosaic, from now on."""
        layer, mosaic = self._project.mapLayer(layer_id), self.mosaic_layer()
        if layer is not None and mosaic is not None:
            layer.setName(filled(tr("Windows of {mosaic}"), mosaic=mosaic.name()))
        self.set_inputs(replace(self.inputs, windows=layer_id))
        self._mosaics.note()

    # Results, and work in the background

    @property
    def is_busy(self) -> bool:
        """Whether windows are being placed or inspected, which ``stop`` ends."""
        return self._background.is_busy

    def is_pending(self, fid: int) -> bool:
        """Whether a window is being inspected, or its result not written yet."""
        row = self.row(fid)
        return row is not None and self._results.is_pending(row.window_id)

    def place_windows(self) -> None:
        """Place windows along the seamlines; they are added when all are found, and not inspected yet."""
        with self._raised():
            self._new.place()

    def inspect(self, fids: Sequence[int], is_step: bool = True) -> None:
        """Inspect windows, those left out that are being inspected already. ``is_step``: as a step of undo."""
        with self._raised():
            self._results.inspect(fids, is_step)
            self._mosaics.note()

    def inspect_pending(self) -> None:
        """Inspect all windows that are not inspected yet or have changed since."""
        self.inspect([row.fid for row in self.windows() if not row.verdict or row.stale])

    def stop(self) -> None:
        """Cancel placing and inspection; what is done stays."""
        self._results.forget_asked()
        self._background.stop()

    def result(self, fid: int) -> WindowResult | None:
        """All that was measured in a window; None until it is complete."""
        row = self.row(fid)
        return self._results.result(row.window_id) if row is not None else None

    def clips(self, fid: int) -> WindowResult | None:
        """The curves of a window, which ``curvesArrived`` tells before the rest; its result once that is there."""
        row = self.row(fid)
        return self._results.clips(row.window_id) if row is not None else None

    def _tell(self, message: Message) -> None:
        if message.template == messages.WINDOWS_TO_COPY.template:
            self.copyDoubted.emit(message)
        else:
            self.messageRaised.emit(sentence(message), bar_level(message))

    @contextmanager
    def _raised(self) -> Iterator[None]:
        """Errors the user can mend become a message, not a traceback."""
        try:
            yield
        except SeamInspectorError as error:
            self._tell(error.message)

    # What the project tells

    def _load(self, *_: object) -> None:
        self._forget_windows()
        self._watch.state = None
        self._home.let_go()
        self._searched.clear()
        self._gone.clear()
        self.lost_detail.setChecked(False)
        self._live.leave()
        self._live.let_go()
        self._opening.abandon()
        self._block.forget()
        self._seams.forget()
        self._block.inputs = load_inputs(self._project)
        self._layers_changed()
        self._home.tidy()

    def _find_windows(self) -> None:
        """Windows of the mosaic that the project lacks, as QGIS ended before it was saved."""
        mosaic = self._block.known_mosaic()
        if mosaic is None or mosaic.content in self._searched:
            return
        self._searched.add(mosaic.content)
        if self._watch.layer is None and (path := self._home.left_behind(mosaic)) is not None:
            self.open_windows(path)
            self._tell(messages.WINDOWS_BACK(path=path))

    def _save(self, *_: object) -> None:
        """Windows and scans of a project that had no file move beside it, and failures that lie in no lasting one."""
        self._results.write()
        with self._raised():
            self._home.move_scans()
            self._home.keep_failures()
        layer, path = self._watch.layer, self._watch.path
        if layer is None or path is None or not self._home.is_to_be_moved(path):
            return
        if layer.isEditable():
            layer.commitChanges()
        with self._raised(), self._watch.unmoved():  # the windows are the same
            self._tell(messages.WINDOWS_MOVED(path=self._home.move(layer)))
            self.messageOutdated.emit(sentence(messages.WINDOWS_KEPT_MEANWHILE(path=path)))

    def _layers_changed(self, *_: object) -> None:
        layer = self._project.mapLayer(self.inputs.windows)
        if (layer if window_layer.holds_windows(layer) else None) is not self._watch.layer:
            self._forget_windows()
            self._watch.watch(layer)
            if self._watch.layer is not None and self._watch.path is not None:
                style_once(self._watch.layer)
                self._home.hold(self._watch.path)
        self._block.refresh()
        self._layers.follow(self.inputs)
        self._follow_block()

    def _follow_block(self) -> None:
        """There may be another block, or none any more."""
        self._mosaics.check()
        self._watch.set_state(self._block.state())
        self._seams.refresh()
        self.inputsChanged.emit()
        self._find_windows()

    def _files_changed(self) -> None:
        self._live.let_go()
        self._block.refresh(anew=True)
        self._seams.refresh(anew=True)
        self._follow_block()

    def _take_back(self, added: Sequence[QgsMapLayer]) -> None:
        """A layer that was removed is there again, by another id: it is what it was, with what was made of it."""
        back = {self._gone.pop(layer.source()): layer.id() for layer in added if layer.source() in self._gone}
        for layer in self._project.mapLayers().values():
            if (made_for := layer.customProperty(MADE_FOR)) in back:
                layer.setCustomProperty(MADE_FOR, back[made_for])
        self.set_inputs(self.inputs.with_ids(back))
        self._layers_changed()

    def _forget_layers(self, ids: list[str]) -> None:
        self._gone.update((layer.source(), layer.id()) for layer in map(self._project.mapLayer, ids) if layer)
        self._live.let_go()  # or their files could not be moved or deleted
        self._layers.leave(ids)
        if (layer := self._watch.layer) is not None and layer.id() in ids:
            self._forget_windows()

    def _forget_windows(self) -> None:
        """What is of the window layer so far; nothing of it may reach another one."""
        self._background.abandon()
        self._watch.watch(None)
        self._results.forget()
        self._steps.stack.clear()
        self.begunAnew.emit()
