"""What the desk reads of a folder that others handed over, as an algorithm.

A project's settings, its layers' properties, and the records beside them.
"""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from qgis.core import (
    QgsProcessingAlgorithm,
    QgsProcessingContext,
    QgsProcessingFeedback,
    QgsProcessingParameterFile,
    QgsProject,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QObject
from seam_inspector.plugin.imagery.record_store import RecordStore
from seam_inspector.plugin.seams.desk import unsaved_windows
from seam_inspector.plugin.seams.desk.inputs.project_inputs import LayerPlaces, load_inputs, save_inputs
from seam_inspector.plugin.seams.desk.judging import JudgingSettings, load_judging, save_judging
from seam_inspector.plugin.seams.desk.keeping import UNSAVED, Keeping
from seam_inspector.plugin.seams.desk.windows.window_watch import WindowWatch
from seam_inspector.plugin.toolkit.translation import sentence

NAME, FOLDER = "desk", "FOLDER"
STALE, LEVELS = "seam_inspector/stale", 3


class ReadDesk(QgsProcessingAlgorithm):
    """Opens the project of a folder and reads what the desk reads."""

    def name(self) -> str:
        return NAME

    def displayName(self) -> str:
        return NAME

    def createInstance(self) -> QgsProcessingAlgorithm:
        return ReadDesk()

    def initAlgorithm(self, configuration: Any = None) -> None:
        behaviour = QgsProcessingParameterFile.Behavior.Folder
        self.addParameter(QgsProcessingParameterFile(FOLDER, FOLDER, behaviour))

    def processAlgorithm(
        self, parameters: dict[str, Any], context: QgsProcessingContext, feedback: QgsProcessingFeedback
    ) -> dict[str, Any]:
        project, path = QgsProject(), Path(parameters[FOLDER]) / "windows.qgs"
        if not (path.is_file() and path.with_suffix(".gpkg").is_file()):
            return {}  # QGIS itself opens those, and would wait for a pipe
        project.read(str(path))
        inputs, places = load_inputs(project), LayerPlaces(project)
        load_judging(project)
        places.load()
        places.found_again(inputs)
        for layer in project.mapLayers().values():
            if isinstance(layer, QgsVectorLayer) and layer.isValid():
                _look_at(layer, feedback)
        return {}


def _look_at(layer: QgsVectorLayer, feedback: QgsProcessingFeedback) -> None:
    owner = QObject()
    watch = WindowWatch(owner)
    watch.watch(layer)
    keeping = Keeping(watch, owner)
    keeping.told.connect(lambda message: feedback.pushWarning(sentence(message)))
    keeping.follow(layer, LEVELS)
    for row in watch.rows():
        if keeping.results is not None:
            keeping.results.last(row.window_id)
    keeping.close()
    watch.close()


def make_folder(folder: Path, windows: Path) -> None:
    """A project of a layer of windows, with a window that was not saved and a result that can't be read."""
    folder.mkdir()
    path = folder / "windows.gpkg"
    path.write_bytes(windows.read_bytes())
    project = QgsProject()
    layer = QgsVectorLayer(str(path), "windows", "ogr")
    layer.setCustomProperty(STALE, ["1", "2"])
    project.addMapLayer(layer)
    save_inputs(project, load_inputs(project))
    save_judging(project, JudgingSettings())
    assert project.write(str(folder / "windows.qgs"))
    project.clear()
    kept = RecordStore(Path(f"{path}{UNSAVED}"), unsaved_windows._KIND)
    kept.save("1", json.dumps({"number": 1, "wkb": None, "values": {"remark": "a"}, "stale": True}).encode())
    kept.close()
