"""Nothing that was judged or measured is lost: what is kept beside the window layers that are looked at."""
from __future__ import annotations

from collections.abc import Iterable
from functools import partial
from pathlib import Path

from qgis.core import QgsProject, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import SeamInspectorError, WindowLayerError
from ....toolkit import layers as layers
from ...measure.window.window_result import WindowResult
from ...measure.window_records import WindowRecord
from ...tables import window_layer
from ..windows.window_watch import WindowWatch
from . import messages
from .kept_results import KeptResults
from .moving import home_of, is_to_be_moved, move
from .restoring import restore
from .unsaved_windows import UnsavedWindows, owner_of
from .window_files import RESULTS, UNSAVED, path_beside


class Keeping(QObject):
    """Of every layer that is followed, until it goes."""

    told = pyqtSignal(object)
    """A Message."""

    def __init__(self, watch: WindowWatch, parent: QObject) -> None:
        super().__init__(parent)
        self._watch = watch
        self._unsaved: dict[str, UnsavedWindows] = {}  # by the layer's id
        self._results: dict[str, KeptResults] = {}  # likewise
        self._complained: set[str] = set()  # layers and files of which was said that they can't be kept

    def follow(self, layer: QgsVectorLayer, levels: int) -> None:
        """Keep what is changed in a layer from now on; what was left of it comes back into it."""
        if layer.id() in self._unsaved:
            return
        path, results_path = path_beside(layer, UNSAVED), path_beside(layer, RESULTS)
        if path is None or results_path is None:
            return
        self._results[layer.id()] = results = KeptResults(results_path, self)
        results.failed.connect(partial(self._results_failed, str(results_path)))
        unsaved = UnsavedWindows(layer, path, self._is_stale, self)
        unsaved.failed.connect(partial(self._failed, layer.id(), str(path)))
        self._unsaved[layer.id()] = unsaved
        left = unsaved.left() if path.is_file() and not layer.isModified() else []
        if not left:
            return
        try:
            count = restore(self._watch, left, levels)
        except SeamInspectorError as error:
            self.told.emit(error.message)
            return
        if count:
            self.told.emit(messages.WINDOWS_RESTORED(count=count, name=layer.name()))
        else:
            unsaved.drop()

    def keep_result(self, result: WindowResult) -> None:
        """Of a window of the layer that is looked at."""
        if (results := self._kept_results()) is not None:
            results.keep(result)

    def result(self, row: WindowRecord) -> WindowResult | None:
        """What was kept of a window of the layer that is looked at, if its row still says so."""
        results = self._kept_results()
        return results.result(row) if results is not None else None

    def last_result(self, window_id: int) -> WindowResult | None:
        """What was last kept of it, whatever its row says."""
        results = self._kept_results()
        return results.last(window_id) if results is not None else None

    def holds_result(self, window_id: int) -> bool:
        """Whether what was last measured need not be held in memory."""
        results = self._kept_results()
        return results is not None and results.holds(window_id)

    def _kept_results(self) -> KeptResults | None:
        layer = self._watch.layer
        return self._results.get(layer.id()) if layer is not None else None

    def note_judged(self, layer: QgsVectorLayer) -> None:
        """Something was judged that is worth being kept."""
        if layer.id() not in self._unsaved:
            self._complain(layer.id(), messages.WINDOWS_WITHOUT_FILE(name=layer.name()))

    def left_in(self, project: QgsProject) -> Path | None:
        """The file of windows that a project lacks, since QGIS ended before it was saved; it may have no file."""
        there = _files_of(project)
        for path in sorted(home_of(project).glob(f"*.gpkg{UNSAVED}")):
            windows = path.with_suffix("")
            if str(windows) not in there and windows.is_file() and owner_of(path) == project.fileName():
                return windows
        return None

    def beside(self, project: QgsProject) -> tuple[Path, int] | None:
        """The file of windows beside a project that was saved before them and lacks them, and how many there are."""
        if not project.homePath() or (saved := _written(Path(project.fileName()))) is None:
            return None
        there, found = _files_of(project), []
        for path in Path(project.homePath()).glob("windows*.gpkg"):
            written = None if str(path) in there else _written(path)
            if written is not None and written > saved and (count := window_layer.count_windows(path)):
                found.append((written, path, count))
        return max(found)[1:] if found else None

    def save(self, layer: QgsVectorLayer, project: QgsProject) -> None:
        """Save a layer with its project, beside it from the first time on; what is in the way is told."""
        if layer.isModified() and not layer.commitChanges(False):
            error = next((text.rstrip(". ") for text in layer.commitErrors() if text.startswith("ERROR")), "")
            self.told.emit(messages.WINDOWS_NOT_SAVED(name=layer.name(), error=error))
            return
        if not is_to_be_moved(layer, project):
            return
        is_edited = layer.isEditable()
        if is_edited:
            layer.commitChanges()
        self.leave([layer.id()])
        with self._watch.unmoved():  # the windows are the same
            try:
                self.told.emit(messages.WINDOWS_MOVED(path=move(layer, Path(project.homePath()))))
            except WindowLayerError as error:
                self.told.emit(error.message.as_warning())  # nothing is lost
        self.follow(layer, 0)
        if is_edited:
            layer.startEditing()

    def leave(self, ids: Iterable[str]) -> None:
        """These layers go."""
        for layer_id in ids:
            if (unsaved := self._unsaved.pop(layer_id, None)) is not None:
                unsaved.close()
            if (results := self._results.pop(layer_id, None)) is not None:
                results.close()

    def close(self) -> None:
        """What is not saved in layers that are still there stays open in them, and QGIS itself asks about it."""
        for unsaved in self._unsaved.values():
            unsaved.drop()
            unsaved.close()
        for results in self._results.values():
            results.close()
        self._unsaved.clear()
        self._results.clear()

    def flush(self) -> None:
        """Wait until all is on the disk."""
        for unsaved in self._unsaved.values():
            unsaved.flush()
        for results in self._results.values():
            results.flush()

    def _is_stale(self, layer: QgsVectorLayer, number: int) -> bool:
        row = self._watch.numbered(number) if layer is self._watch.layer else None
        return row is not None and row.stale

    def _failed(self, layer_id: str, path: str, error: object) -> None:
        self._complain(layer_id, messages.WINDOWS_NOT_KEPT(path=path, error=error))

    def _results_failed(self, path: str, error: object) -> None:
        self._complain(path, messages.RESULTS_NOT_KEPT(path=path, error=error))

    def _complain(self, what: str, message: object) -> None:
        """Once."""
        if what not in self._complained:
            self._complained.add(what)
            self.told.emit(message)


def _files_of(project: QgsProject) -> set[str]:
    """The paths of its vector layers."""
    return {layers.layer_path(one) for one in project.mapLayers().values() if isinstance(one, QgsVectorLayer)}


def _written(path: Path) -> float | None:
    """When a file was last changed, which for a GeoPackage may be in the log beside it; None where none is."""
    files = [one for one in (path, Path(f"{path}-wal")) if one.is_file()]
    return max(one.stat().st_mtime for one in files) if files else None
