"""Nothing that was judged or measured is lost: what is kept beside the window layers that are looked at."""
from __future__ import annotations

import contextlib
import shutil
import sqlite3
from collections.abc import Iterable
from functools import partial
from pathlib import Path

from qgis.core import QgsApplication, QgsProject, QgsProviderRegistry, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...imagery.errors import SeamInspectorError, WindowLayerError
from ...imagery.record_store import RecordKeeper
from ...toolkit import layers
from ..measure.window.window_result import WindowResult
from ..measure.window.window_tables import result_of, result_record
from ..measure.window_records import WindowRecord
from ..tables import window_layer
from ..window_summary import is_same
from . import messages
from .unsaved_windows import UnsavedWindows, owner_of, restore
from .windows.window_watch import WindowWatch

UNSAVED, RESULTS = ".unsaved", ".results"
"""What comes after the name of a layer's file: for what is not saved in it yet, and for the results of its windows."""
_FOLDER = "seam_inspector"  # of the user's profile of QGIS
_KIND = "Seam Inspector: results of windows, "
_VERSION = "3"


class Keeping(QObject):
    """Of every layer that is followed, until it goes."""

    told = pyqtSignal(object)
    """A Message."""

    def __init__(self, watch: WindowWatch, parent: QObject) -> None:
        super().__init__(parent)
        self._watch = watch
        self._kept: dict[str, tuple[UnsavedWindows, KeptResults]] = {}  # by the layer's id
        self._complained: set[str] = set()  # layers and files of which was said that they can't be kept

    def follow(self, layer: QgsVectorLayer, levels: int) -> None:
        """Keep what is changed in a layer from now on; what was left of it comes back into it."""
        if layer.id() in self._kept:
            return
        path, results_path = path_beside(layer, UNSAVED), path_beside(layer, RESULTS)
        if path is None or results_path is None:
            return
        results = KeptResults(results_path, self)
        results.failed.connect(partial(self._results_failed, str(results_path)))
        unsaved = UnsavedWindows(layer, path, self._is_stale, self)
        unsaved.failed.connect(partial(self._failed, layer.id(), str(path)))
        self._kept[layer.id()] = unsaved, results
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

    @property
    def results(self) -> KeptResults | None:
        """What was measured in windows of the layer that is looked at; None where it can't be kept."""
        layer = self._watch.layer
        return self._kept[layer.id()][1] if layer is not None and layer.id() in self._kept else None

    def note_judged(self, layer: QgsVectorLayer) -> None:
        """Something was judged that is worth being kept."""
        if layer.id() not in self._kept:
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
        for layer_id in self._kept.keys() & set(ids):
            for file in self._kept.pop(layer_id):
                file.close()

    def close(self) -> None:
        """What is not saved in layers that are still there stays open in them, and QGIS itself asks about it."""
        for unsaved, _ in self._kept.values():
            unsaved.drop()
        self.leave(list(self._kept))

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


class KeptResults(QObject):
    """By the windows' numbers, the last one of each."""

    failed = pyqtSignal(object)
    """Why they can't be kept."""

    def __init__(self, path: Path, parent: QObject) -> None:
        super().__init__(parent)
        self._keeper = RecordKeeper(path, _KIND + _VERSION, self.failed.emit, _KIND)
        self._missing: set[int] = set()

    def keep(self, result: WindowResult) -> None:
        """Written in the background."""
        self._missing.discard(result.window_id)
        self._keeper.save(str(result.window_id), partial(result_record, result))

    def holds(self, window_id: int) -> bool:
        """Whether a result of a window is written by now."""
        return self._keeper.holds(str(window_id))

    def result(self, row: WindowRecord) -> WindowResult | None:
        """What was measured in a window, if its row still says so; None where that is not known and can't be read."""
        found = self.last(row.window_id) if row.verdict else None
        return found if found is not None and _is_of(found, row) else None

    def last(self, window_id: int) -> WindowResult | None:
        """What was last measured in a window, whatever its row says."""
        if window_id in self._missing:
            return None
        record = self._keeper.load(str(window_id))
        found = result_of(record) if record is not None else None
        if found is None:
            self._missing.add(window_id)
        return found

    def close(self) -> None:
        """Write what is to be written."""
        self._keeper.close()


def _is_of(result: WindowResult, row: WindowRecord) -> bool:
    """Whether a row has the values of a result; another inspection may have written others into the layer since."""
    profile = result.profile
    return (
        row.window_id == result.window_id
        and row.verdict == result.judgement.verdict.value
        and all(map(is_same, row.ratios, result.judgement.ratios.detail))
        and all(map(is_same, row.kept, profile.kept if profile is not None else row.kept))
    )


def home_of(project: QgsProject) -> Path:
    """Where the windows of a project are made: beside it, or in a folder for all that are not saved yet."""
    return Path(project.homePath()) if project.homePath() else unsaved_folder()


def unsaved_folder() -> Path:
    """The folder of windows whose project has no file."""
    folder = Path(QgsApplication.qgisSettingsDirPath()) / _FOLDER
    with contextlib.suppress(OSError):  # told when the windows' file can't be written
        folder.mkdir(parents=True, exist_ok=True)
    return folder


def is_to_be_moved(layer: QgsVectorLayer, project: QgsProject) -> bool:
    """Whether the project has a file by now, and the windows are still in that folder."""
    path = layers.layer_path(layer)
    return bool(path and project.fileName() and project.homePath()) and Path(path).parent == unsaved_folder()


def move(layer: QgsVectorLayer, folder: Path) -> Path:
    """Put a layer's file into a folder, with the results beside it. It must be saved, and not be edited.

    Raises WindowLayerError when it stays where it was.
    """
    old, source = Path(layers.layer_path(layer)), layer.source()
    new = window_layer.free_path(folder)
    try:
        _copy(old, new)
        if (results := Path(f"{old}{RESULTS}")).is_file():
            Path(f"{new}{RESULTS}").unlink(missing_ok=True)  # it may be a link to somewhere else
            shutil.copyfile(results, f"{new}{RESULTS}")
    except (OSError, sqlite3.Error) as error:
        with contextlib.suppress(OSError):
            new.unlink(missing_ok=True)
        raise WindowLayerError(messages.WINDOWS_NOT_MOVED(old=old, folder=folder, error=error)) from None
    layer.setDataSource(source.replace(str(old), str(new), 1), layer.name(), "ogr")
    if not layer.isValid():
        layer.setDataSource(source, layer.name(), "ogr")
        raise WindowLayerError(messages.WINDOWS_NOT_MOVED(old=old, folder=folder, error=new))
    for path in (old, *(Path(f"{old}{ending}") for ending in ("-wal", "-shm", RESULTS))):
        with contextlib.suppress(OSError):  # one that is open elsewhere stays
            path.unlink(missing_ok=True)
    return new


def _copy(old: Path, new: Path) -> None:
    """A GeoPackage whose last changes may still be in a file beside it. Raises OSError, sqlite3.Error."""
    new.touch(exist_ok=False)
    with contextlib.closing(sqlite3.connect(old)) as given, contextlib.closing(sqlite3.connect(new)) as made:
        given.backup(made)
        made.execute("PRAGMA journal_mode = DELETE")


def path_beside(layer: QgsVectorLayer, ending: str) -> Path | None:
    """The file that goes with a layer; None for a layer that has none itself."""
    path = Path(layers.layer_path(layer) or ".")
    if not path.is_file():
        return None
    name = QgsProviderRegistry.instance().decodeUri("ogr", layer.source()).get("layerName") or path.stem
    part = "" if name == path.stem else f".{name}"
    return path.with_name(f"{path.name}{part}{ending}")
