"""Windows of a project that is not saved yet: where they are meanwhile, and how they come to stand beside it."""
from __future__ import annotations

import contextlib
import shutil
import sqlite3
from pathlib import Path

from qgis.core import QgsApplication, QgsProject, QgsVectorLayer

from ....imagery.errors import WindowLayerError
from ....toolkit import layers as layers
from ...tables import window_layer
from . import messages
from .window_files import RESULTS

_FOLDER = "seam_inspector"  # of the user's profile of QGIS


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
