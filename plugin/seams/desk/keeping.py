"""Nothing that was judged or measured is lost: what is kept beside the window layers that are looked at."""
from __future__ import annotations

import contextlib
import shutil
import sqlite3
import time
from collections.abc import Iterable
from functools import partial
from pathlib import Path

from qgis.core import QgsApplication, QgsProject, QgsProviderRegistry, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...imagery.errors import SeamInspectorError, WindowLayerError
from ...imagery.gdal_paths import holds_only_tables
from ...imagery.record_store import RecordKeeper
from ...toolkit import layers
from ...toolkit.geopackages import free_path
from ..measure.window.window_result import WindowResult
from ..measure.window.window_tables import result_of, result_record
from ..measure.window_records import WindowRecord
from ..tables import window_layer
from ..window_summary import is_same
from . import messages
from .unsaved_windows import UnsavedWindows, left_by, restore
from .windows.window_watch import WindowWatch

UNSAVED, RESULTS = ".unsaved", ".results"
"""What ``path_beside`` ends with: for what is not saved in a layer yet, and for the results of its windows."""
_LEFT_S = 60  # s; a file without windows is that of a project that was discarded, and not one that is just being made
_FOLDER = "seam_inspector"  # of the user's profile of QGIS
_KIND, _VERSION = "Seam Inspector: results of windows", "3"


class Keeping(QObject):
    """Keeps what was changed and measured in every layer that is followed, until it goes."""

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
        unsaved = UnsavedWindows(layer, path, self._is_stale, self, path.parent == unsaved_folder())
        unsaved.failed.connect(partial(self._failed, layer.id(), str(path)))
        self._kept[layer.id()] = unsaved, results
        left = unsaved.left() if path.is_dir() and not layer.isModified() else []
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

    def left_in(self, project: QgsProject) -> list[Path]:
        """Files of windows that a project lacks, since QGIS ended before it was saved, the last one first; it may have
        no file."""
        there, found = _files_of(project), []
        for record in home_of(project).glob(f"*.gpkg{UNSAVED}"):
            windows = record.with_suffix("")
            if str(windows) in there or not holds_only_tables(windows):
                continue
            if (left := left_by(record)) is None or not _is_owner(project, left.project):
                continue
            if left.unsaved or window_layer.count_windows(windows):
                found.append((record.stat().st_mtime, windows))
        return [windows for _, windows in sorted(found, reverse=True)]

    def tidy(self, project: QgsProject) -> None:
        """Delete what projects that were discarded left without a window in it."""
        there = _files_of(project)
        for path in unsaved_folder().glob("windows*.gpkg"):
            record, written = _named(path, "", UNSAVED), _written(path)
            if str(path) in there or written is None or time.time() - written < _LEFT_S:
                continue
            if record.is_dir() and ((left := left_by(record)) is None or left.unsaved):
                continue
            if window_layer.count_windows(path) == 0:
                _remove(path, UNSAVED, RESULTS)

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

    def leave(self, ids: Iterable[str], is_left: bool = False) -> None:
        """These layers go. ``is_left``: they stay, and QGIS itself asks what is to become of their changes."""
        for layer_id in self._kept.keys() & set(ids):
            unsaved, results = self._kept.pop(layer_id)
            unsaved.close(is_left)
            results.close()

    def close(self) -> None:
        """What is not saved in layers that are still there stays open in them, and QGIS itself asks about it."""
        self.leave(list(self._kept), is_left=True)

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
    """Results by the windows' numbers, the last one of each."""

    failed = pyqtSignal(object)
    """Why they can't be kept."""

    def __init__(self, path: Path, parent: QObject) -> None:
        super().__init__(parent)
        self._keeper = RecordKeeper(path, _KIND, self.failed.emit, _VERSION)
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

    def note(self, key: str, payload: bytes) -> None:
        """Keep something that is of all windows."""
        self._keeper.save(key, lambda: payload)

    def noted(self, key: str) -> bytes | None:
        """What was kept so."""
        return self._keeper.load(key)

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
    new = free_path(folder, window_layer.TABLE)
    try:
        _copy(old, new)
        if (results := path_beside(layer, RESULTS)) is not None and results.is_dir():
            copied = _named(new, _table_of(layer), RESULTS)
            _delete(copied)
            shutil.copytree(results, copied, symlinks=True)
    except (OSError, sqlite3.Error) as error:
        with contextlib.suppress(OSError):
            new.unlink(missing_ok=True)
        raise WindowLayerError(messages.WINDOWS_NOT_MOVED(old=old, folder=folder, error=error)) from None
    layer.setDataSource(source.replace(str(old), str(new), 1), layer.name(), "ogr")
    if not layer.isValid():
        layer.setDataSource(source, layer.name(), "ogr")
        raise WindowLayerError(messages.WINDOWS_NOT_MOVED(old=old, folder=folder, error=new))
    _remove(old, RESULTS)
    return new


def _remove(windows: Path, *records: str) -> None:
    """A file that the desk made, and these of its records."""
    for path in (*(Path(f"{windows}{ending}") for ending in ("", "-wal", "-shm")),
                 *(_named(windows, "", ending) for ending in records)):
        with contextlib.suppress(OSError):  # one that is open elsewhere stays
            _delete(path)


def _delete(path: Path) -> None:
    """A file, a folder of records, or a link by the name of one, whatever that leads to. Raises OSError."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def _copy(old: Path, new: Path) -> None:
    """A GeoPackage whose last changes may still be in a file beside it. Raises OSError, sqlite3.Error."""
    new.touch(exist_ok=False)
    with contextlib.closing(sqlite3.connect(old)) as given, contextlib.closing(sqlite3.connect(new)) as made:
        given.backup(made)
        made.execute("PRAGMA journal_mode = DELETE")


def path_beside(layer: QgsVectorLayer, ending: str) -> Path | None:
    """The record that goes with a layer; None for a layer that has no file itself."""
    path = Path(layers.layer_path(layer) or ".")
    return _named(path, _table_of(layer), ending) if path.is_file() else None


def _table_of(layer: QgsVectorLayer) -> str:
    """Table of a layer in a file that may hold several; empty for one that the desk made, or that holds one alone."""
    path = Path(layers.layer_path(layer))
    unnamed = path.stem if path.suffix == ".gpkg" else ""
    table = QgsProviderRegistry.instance().decodeUri("ogr", layer.source()).get("layerName") or unnamed
    return "" if table == window_layer.TABLE else str(table)


def _named(path: Path, table: str, ending: str) -> Path:
    """A record beside a file, by the file's name whatever that is, so that they can be moved and renamed together."""
    return path.with_name(f"{path.name}.{table}{ending}" if table else f"{path.name}{ending}")


def _is_owner(project: QgsProject, owner: str) -> bool:
    """Whether a record in a project's home is its own: that of a project which is not there was moved or renamed."""
    return owner == project.fileName() or bool(owner and project.fileName() and not Path(owner).is_file())
