"""Windows files: which mosaic each is of, and its place, beside the project; until that is saved in the user's profile,
held by a lock.

The lock tells a file whose QGIS was killed, which is taken again with its mosaic, from one whose project was discarded
and from one that another QGIS has open.
"""
from __future__ import annotations

import contextlib
import shutil
import time
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path

from qgis.core import QgsApplication, QgsMapLayer, QgsProcessingUtils, QgsProject, QgsVectorLayer
from qgis.PyQt.QtCore import QLockFile, QObject, pyqtSignal

from ...imagery.errors import SeamInspectorError, WindowLayerError
from ...imagery.messages import system_reason
from ...imagery.rasters import RasterRef
from ...toolkit import layers
from ...toolkit.geopackages import free_path
from ...toolkit.reference_systems import known_system
from ..tables import window_file
from ..tables.window_file import KnownMosaic
from . import messages
from .inputs.block_cache import BlockCache
from .windows.window_watch import WindowWatch

_FOLDER = "seam_inspector"  # of the user's profile of QGIS
_LOCK = ".lock"
_KEPT_S = 30 * 24 * 3600.0  # s; of a project that was discarded: a month to ask for it back
_LEFT_S = 60.0  # s; a file without windows may be one that is just being made


FAILURES = "seam_inspector/failures"  # custom property of the failures of a decision
MADE_FOR = "seam_inspector/made_for"  # custom property of all layers that the desk made: the mosaic layer they are of
HIDDEN = "seam_inspector/hidden"  # custom property of what judging took off the map
_WAITING = "seam_inspector/of_another_mosaic"  # custom property of what is off the map until its mosaic comes back
_WINDOWS = "seam_inspector/windows"  # custom property of a mosaic layer: the window layer that it had last


def windows_of(project: QgsProject, mosaic: str) -> str:
    """The id of the window layer that a mosaic had last; empty where the project has none."""
    layer = project.mapLayer(mosaic)
    layer_id = "" if layer is None else str(layer.customProperty(_WINDOWS))
    return layer_id if project.mapLayer(layer_id) is not None else ""


def show_layers_of(project: QgsProject, mosaic: str) -> None:
    """Take what the desk made of other mosaics off the map, and put back what it took off it of this one."""
    for node in project.layerTreeRoot().findLayers():
        made_for = node.layer().customProperty(MADE_FOR) if node.layer() is not None else None
        if made_for == mosaic and node.customProperty(_WAITING):
            node.removeCustomProperty(_WAITING)
            node.setItemVisibilityChecked(True)
        elif made_for and made_for != mosaic and (node.itemVisibilityChecked() or node.customProperty(HIDDEN)):
            node.removeCustomProperty(HIDDEN)
            node.setCustomProperty(_WAITING, True)
            node.setItemVisibilityChecked(False)


def pictures_beside(failures: Path) -> Path:
    """The folder with the pictures of a layer of failures."""
    return failures.with_name(f"{failures.stem}_pictures")


def unsaved_folder() -> Path:
    """The folder of windows whose project has no file."""
    folder = Path(QgsApplication.qgisSettingsDirPath()) / _FOLDER
    with contextlib.suppress(OSError):  # told when the windows' file can't be written
        folder.mkdir(parents=True, exist_ok=True)
    return folder


class WindowHome:
    """The windows files of one project."""

    def __init__(self, project: QgsProject) -> None:
        self._project = project
        self._locks: dict[Path, QLockFile] = {}

    @property
    def folder(self) -> Path:
        """The folder in which the project's windows are made."""
        return Path(self._project.homePath()) if self._project.homePath() else unsaved_folder()

    def hold(self, path: Path) -> None:
        """A file is in use, which matters in the profile alone."""
        if path.parent == unsaved_folder() and path not in self._locks:
            lock = QLockFile(f"{path}{_LOCK}")
            if _take(lock):
                self._locks[path] = lock

    def let_go(self) -> None:
        """The project is closed, whether or not somebody saved it."""
        while self._locks:
            self._locks.popitem()[1].unlock()

    def left_behind(self, mosaic: KnownMosaic) -> Path | None:
        """The windows of a mosaic that the project does not know, since QGIS ended before it was saved: the last ones.

        Beside a project those that were written after it was saved; in the profile those that a QGIS held to its end.
        """
        is_saved = bool(self._project.fileName())
        saved = _written(Path(self._project.fileName())) if is_saved else 0.0
        candidates = []
        for path in self.folder.glob("windows*.gpkg"):
            written = _written(path)
            if str(path) in self._known() or written is None or written <= (saved or 0.0):
                continue
            if window_file.count_windows(path):
                known = window_file.known_mosaic(path)
                if known is not None and known.content == mosaic.content:
                    candidates.append((written, path))
        in_order = (path for _, path in sorted(candidates, reverse=True))
        return next((path for path in in_order if path.parent != unsaved_folder() or self._was_killed(path)), None)

    def tidy(self) -> None:
        """Delete what discarded projects left in the profile: at once without a window in it, else after a month."""
        for path in unsaved_folder().glob("windows*.gpkg"):
            written = _written(path)
            if str(path) in self._known() or written is None or Path(f"{path}{_LOCK}").exists():
                continue
            age = time.time() - written
            if age > _KEPT_S or (age > _LEFT_S and window_file.count_windows(path) == 0):
                _remove(path)

    def is_to_be_moved(self, path: Path) -> bool:
        """Whether the project has a file by now, and the windows are still in the profile."""
        return bool(self._project.fileName() and self._project.homePath()) and path.parent == unsaved_folder()

    def move(self, layer: QgsVectorLayer) -> Path:
        """Put a layer's file beside the project. It must not be edited.

        Raises WindowLayerError when it stays where it was.
        """
        old, new = Path(layers.layer_path(layer)), free_path(self.folder, window_file.TABLE)
        _move(old, new, [layer])
        _remove(old)
        if (lock := self._locks.pop(old, None)) is not None:
            lock.unlock()
        return new

    def move_scans(self) -> None:
        """Put what scans left in the profile beside the project, unless it is edited. Raises WindowLayerError."""
        of_file: dict[Path, list[QgsMapLayer]] = defaultdict(list)
        for layer in self._project.mapLayers().values():
            path = Path(layers.layer_path(layer))
            if self.is_to_be_moved(path) and layer.isValid() and not window_file.is_window_file(path):
                of_file[path].append(layer)
        for old, shown in of_file.items():
            if not any(layer.isEditable() for layer in shown):
                _move(old, free_path(self.folder, old.stem, old.suffix), shown)
                _remove(old)

    def keep_failures(self) -> None:
        """Copy failures that are shown, and gone with QGIS, beside the project with their pictures. Raises
        WindowLayerError."""
        layers_shown = self._project.mapLayers().values() if self._project.homePath() else ()
        for layer in layers_shown:
            old = Path(layers.layer_path(layer))
            if layer.customProperty(FAILURES) and Path(QgsProcessingUtils.tempFolder()) in old.parents:
                _move(old, free_path(self.folder, old.stem), [layer])
                pictures = pictures_beside(old)
                with contextlib.suppress(OSError):  # of an earlier decision; the layer is what counts
                    shutil.copytree(pictures, self.folder / pictures.name)

    def _known(self) -> set[str]:
        """The files of the project's vector layers."""
        map_layers = self._project.mapLayers().values()
        return {layers.layer_path(layer) for layer in map_layers if isinstance(layer, QgsVectorLayer)}

    def _was_killed(self, path: Path) -> bool:
        """Whether a QGIS that is no more had the file open when it ended."""
        name = f"{path}{_LOCK}"
        if path in self._locks or not Path(name).exists():
            return False
        lock = QLockFile(name)
        if _take(lock):
            self._locks[path] = lock
            return True
        return False


def _move(old: Path, new: Path, shown: Sequence[QgsMapLayer]) -> None:
    """Copy a file, of which the layers that show it show the copy. Raises WindowLayerError when that can't be."""
    sources, why = [layer.source() for layer in shown], ""
    try:
        (window_file.copy_file if old.suffix == ".gpkg" else shutil.copyfile)(old, new)
    except (OSError, WindowLayerError) as error:
        why = system_reason(error) if isinstance(error, OSError) else str(error.message.values["error"])
    for layer, source in zip(shown, sources if not why else ()):
        layer.setDataSource(source.replace(str(old), str(new), 1), layer.name(), layer.providerType())
    if why or not all(layer.isValid() for layer in shown):
        for layer, source in zip(shown, sources):
            layer.setDataSource(source, layer.name(), layer.providerType())
        raise WindowLayerError(messages.NOT_MOVED(name=shown[0].name(), old=old, folder=new.parent, error=why or new))


def _take(lock: QLockFile) -> bool:
    """Without waiting; one whose process is gone is taken over, however old it is."""
    lock.setStaleLockTime(0)
    return bool(lock.tryLock(0))


def _written(path: Path) -> float | None:
    """When a file was last changed, which for a GeoPackage may be in the log beside it; None where none is."""
    files = [file for file in (path, Path(f"{path}-wal")) if file.is_file()]
    return max(file.stat().st_mtime for file in files) if files else None


def _remove(windows: Path) -> None:
    for ending in ("", "-wal", "-shm", ".aux.xml"):
        with contextlib.suppress(OSError):  # one that is open elsewhere stays
            Path(f"{windows}{ending}").unlink()


class WindowsMosaic(QObject):
    """Mosaic of every windows file followed, which says itself what that is."""

    doubted = pyqtSignal(object)
    """The Message why nothing goes on with these windows and this mosaic; once for each two of them."""

    notified = pyqtSignal(object)  # the Message why the file can't say it

    def __init__(self, block: BlockCache, watch: WindowWatch, parent: QObject) -> None:
        super().__init__(parent)
        self._block, self._watch = block, watch
        self._known: dict[str, KnownMosaic | None] = {}  # by the layer's id
        self._asked: tuple[str, KnownMosaic] | None = None

    def note(self) -> None:
        """Something is measured or judged in the present mosaic."""
        if self._of_layer() is None:
            self.take()

    def take(self) -> None:
        """The windows are of the present mosaic, whatever they were of."""
        layer, now = self._watch.layer, self._block.known_mosaic()
        if layer is None or now is None:
            return
        self._known[layer.id()] = now
        self._block.doubt = None
        self._mark(layer)
        if self._watch.path is not None:
            try:
                window_file.note_mosaic(self._watch.path, now)
            except SeamInspectorError as error:
                self.notified.emit(error.message)

    def check(self) -> None:
        """The windows or the mosaic are others than before."""
        self._block.doubt = None
        layer, now, before = self._watch.layer, self._block.known_mosaic(), self._of_layer()
        block = self._block.silent()
        if layer is not None and block is not None:
            system = known_system(layer.crs())
            if not system.isValid() or not layer.crs().toWkt():  # else the map goes nowhere while keys judge
                layer.setCrs(system if system.isValid() else layers.mosaic_crs(block.mosaic))
        if layer is None or now is None or before is None:
            return
        if before == now:
            self._mark(layer)
            return
        rows, is_elsewhere = self._watch.rows(), before.path != now.path
        holds_something = any(is_elsewhere or row.verdict or row.observer or row.observer_2 for row in rows)
        if before.content == now.content or not holds_something:
            self.take()
            return
        names = RasterRef(before.path).name, RasterRef(now.path).name
        if names[0] == names[1]:
            names = before.path, now.path
        message = messages.WINDOWS_OF_ANOTHER_MOSAIC(name=layer.name(), older=names[0], newer=names[1])
        if not is_elsewhere:
            message = messages.MOSAIC_IS_ANOTHER_NOW(name=layer.name(), mosaic=names[1])
        self._block.doubt = message
        if (layer.id(), now) != self._asked:
            self._asked = layer.id(), now
            self.doubted.emit(message)

    def _mark(self, layer: QgsVectorLayer) -> None:
        """The windows come with their mosaic, and go with it."""
        mosaic = self._block.mosaic_layer()
        if mosaic is not None:
            mosaic.setCustomProperty(_WINDOWS, layer.id())
            if layer.customProperty(MADE_FOR) != mosaic.id():
                layer.setCustomProperty(MADE_FOR, mosaic.id())
                show_layers_of(QgsProject.instance(), mosaic.id())

    def _of_layer(self) -> KnownMosaic | None:
        """What its windows are known to be of."""
        layer, path = self._watch.layer, self._watch.path
        if layer is None or path is None:
            return None
        if layer.id() not in self._known:
            self._known[layer.id()] = window_file.known_mosaic(path)
        return self._known[layer.id()]
