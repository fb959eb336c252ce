"""What becomes of the desk as its project is read, saved and changed: layers, their files, the window layer."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...imagery.errors import SeamInspectorError
from ...toolkit.desk.widgets import single_shot
from ..tables import window_layer
from ..tables.window_looks import style_if_plain
from .desk_parts import DeskParts
from .inputs.inputs_watch import InputsWatch
from .inputs.layer_places import LayerPlaces
from .inputs.project_inputs import Inputs, load_inputs, save_inputs
from .keeping import messages


class ProjectFollower(QObject):
    """Leads the desk's parts after the project."""

    inputsChanged = pyqtSignal()
    windowsFound = pyqtSignal(object, object)
    """Path of windows that the project lacks, and the Message that says so."""
    told = pyqtSignal(object)

    def __init__(self, parts: DeskParts, parent: QObject) -> None:
        super().__init__(parent)
        self._parts = parts
        self._places = LayerPlaces(parts.project)
        self._layers = InputsWatch(parts.project, self)
        self._layers.layersChanged.connect(self._files_changed)
        self._layers.indexEdited.connect(self._files_changed)
        self._layers.seamlinesEdited.connect(self._seamlines_edited)
        parts.block.opened.connect(self._opened)
        parts.watch.replaced.connect(self._windows_replaced)
        self._searcher = single_shot(self, self._find_left)  # the project is still being read when it tells so
        self._is_read = True
        self._connections: list[tuple[Any, Callable[..., None]]] = [
            (parts.project.readProject, self._load),
            (parts.project.cleared, self._cleared),
            (parts.project.writeProject, self._save),
            (parts.project.layersAdded, self._layers_added),
            (parts.project.layersWillBeRemoved, self._forget_layers),
            (parts.project.layersRemoved, self._layers_changed),
        ]
        for signal, slot in self._connections:
            signal.connect(slot)
        self._load()

    def close(self) -> None:
        """Let go of the project; once is enough."""
        while self._connections:
            signal, slot = self._connections.pop()
            signal.disconnect(slot)
        self._layers.close()
        self._searcher.stop()

    @property
    def _inputs(self) -> Inputs:
        return self._parts.block.inputs

    def set_inputs(self, inputs: Inputs) -> None:
        """Change the inputs and remember them in the project."""
        before = self._inputs
        if before == inputs:
            self._parts.block.inputs = inputs  # the same, but chosen by whoever sets them now
            return
        if before.windows != inputs.windows:
            self._parts.results.write()  # into the layer they are of
        self._parts.block.inputs = inputs
        save_inputs(self._parts.project, inputs)
        self._layers_changed()

    def take_layer(self, layer_id: str) -> None:
        """Windows are those of this layer from now on."""
        self.set_inputs(replace(self._inputs, windows=layer_id))

    def open_windows(self, path: Path) -> None:
        """Take the windows of a file that the desk has made; raises SeamInspectorError."""
        self.take_layer(self._parts.project.addMapLayer(window_layer.open_window_layer(path)).id())

    # What the project tells

    def _cleared(self) -> None:
        self._load()
        self._is_read = False

    def _load(self, *_: object) -> None:
        self._is_read = True
        self._parts.live.leave()
        self._parts.live.let_go()
        self._parts.inputs_background.abandon()
        self._parts.block.forget()
        self._parts.seams.forget()
        self._parts.forget_windows()
        self._parts.block.inputs = load_inputs(self._parts.project)
        self._places.load()
        self._layers_changed()
        self._searcher.start()

    def _find_left(self) -> None:
        """Windows that the project lacks, as it was never saved with them or QGIS ended before."""
        keeping, project = self._parts.keeping, self._parts.project
        if self._parts.watch.layer is not None or (project.fileName() and not self._is_read):
            return  # a project that is being read lacks layers yet
        if (path := keeping.left_in(project)) is None:
            if (beside := keeping.beside(project)) is not None:
                path, count = beside
                self.windowsFound.emit(path, messages.WINDOWS_BESIDE(name=path.name, count=count))
            return
        if not project.fileName():
            self.windowsFound.emit(path, messages.WINDOWS_FOUND(path=path))
            return
        try:
            self.open_windows(path)
        except SeamInspectorError as error:
            self.told.emit(error.message)

    def _save(self, *_: object) -> None:
        """Save the windows with the project, as its user expects."""
        self._parts.results.write()
        self._parts.watch.save_stale()
        if (layer := self._parts.watch.layer) is not None:
            self._parts.keeping.save(layer, self._parts.project)

    def _layers_added(self, *_: object) -> None:
        """One that was removed may be back, under another id."""
        inputs = self._places.found_again(self._inputs)
        if inputs != self._inputs:
            self.set_inputs(inputs)
        else:
            self._layers_changed()

    def _layers_changed(self, *_: object) -> None:
        self._places.note(self._inputs)
        self._parts.block.refresh()
        self._layers.follow(self._inputs)
        layer = self._parts.project.mapLayer(self._inputs.windows)
        if (layer if window_layer.holds_windows(layer) else None) is not self._parts.watch.layer:
            self._parts.forget_windows()
            self._parts.watch.watch(layer)
            if self._parts.watch.layer is not None:
                style_if_plain(self._parts.watch.layer)
                self._parts.keeping.follow(self._parts.watch.layer, self._inputs.levels)
        self._opened()

    def _opened(self) -> None:
        """There may be another block, or none any more."""
        self._parts.seams.refresh()
        self._parts.coverage.follow(self._parts.block.silent())
        self._parts.watch.set_state(self._parts.block.state())
        self.inputsChanged.emit()

    def _files_changed(self) -> None:
        self._parts.live.let_go()
        self._parts.block.refresh(anew=True)
        self._parts.coverage.follow(None)  # what lies in the files may be something else
        self._opened()

    def _seamlines_edited(self) -> None:
        self._parts.seams.refresh(anew=True)

    def _windows_replaced(self) -> None:
        if (layer := self._parts.watch.layer) is not None:
            self._parts.keeping.leave([layer.id()])
        self._parts.forget_windows()
        self._layers_changed()

    def _forget_layers(self, ids: list[str]) -> None:
        self._parts.live.let_go()  # or their files could not be moved or deleted
        self._layers.leave(ids)
        self._parts.keeping.leave(ids)
        if (layer := self._parts.watch.layer) is not None and layer.id() in ids:
            self._parts.forget_windows()
