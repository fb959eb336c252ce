"""What the desk reads of a folder that others handed over, as an algorithm.

A project's settings, its windows file, and the records of a scan beside it.
"""
from __future__ import annotations

from contextlib import suppress
from dataclasses import asdict
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
from seam_inspector.plugin.imagery.errors import SeamInspectorError
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.imagery.records import NotUnderstoodError, record_of, value_of
from seam_inspector.plugin.seams.desk.inputs.project_inputs import load_inputs, save_inputs
from seam_inspector.plugin.seams.desk.judging import JudgingSettings, load_judging
from seam_inspector.plugin.seams.desk.windows.window_watch import WindowWatch
from seam_inspector.plugin.seams.measure.blocks.block_grid import ScanSettings
from seam_inspector.plugin.seams.measure.blocks.scan_block import BlockScan, scan_block
from seam_inspector.plugin.seams.measure.scan.block_runs import open_journal
from seam_inspector.plugin.seams.measure.scan.scan_request import scan_request
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window, make_block, window_request
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult
from seam_inspector.plugin.seams.tables import window_file, window_layer
from seam_inspector.plugin.toolkit.project_settings import save_settings
from seam_inspector.plugin.toolkit.translation import sentence

NAME, FOLDER = "desk", "FOLDER"
SCAN, BLOCK, FINGERPRINT = "windows.scan", "block 0 0", "settings=sound"
LEVELS = 3


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
        project, path = QgsProject(), Path(self.parameterAsString(parameters, FOLDER, context)) / "windows.qgs"
        if not (path.is_file() and path.with_suffix(".gpkg").is_file()):
            return {}  # QGIS itself opens those, and would wait for a pipe
        project.read(str(path))
        load_inputs(project)
        load_judging(project)
        for layer in project.mapLayers().values():
            if isinstance(layer, QgsVectorLayer) and layer.isValid():
                _look_at(layer, feedback)
        _go_on_with_scan(path.with_name(SCAN), feedback)
        return {}


def _look_at(layer: QgsVectorLayer, feedback: QgsProcessingFeedback) -> None:
    watch = WindowWatch(QObject())
    watch.watch(layer)
    watch.set_state("inputs")
    for row in watch.rows():
        if watch.path is not None:
            window_file.load_result(watch.path, row.window_id)
            window_file.known_mosaic(watch.path)
    watch.close()


def _go_on_with_scan(path: Path, feedback: QgsProcessingFeedback) -> None:
    try:
        journal, notice = open_journal(path, FINGERPRINT)
    except SeamInspectorError as error:
        feedback.pushWarning(sentence(error.message))
        return
    if notice is not None:
        feedback.pushWarning(sentence(notice))
    with suppress(OSError, NotUnderstoodError):
        if (record := journal.files.load(BLOCK)) is not None:
            value_of(BlockScan, record, {})
    journal.close()


def make_folder(folder: Path, windows: Path) -> None:
    """A project of a windows file with a result, and a scan that was stopped."""
    folder.mkdir()
    given = QgsVectorLayer(str(windows), "windows", "ogr")
    path = window_layer.copy_to_file(given, LEVELS, "", folder)
    project = QgsProject()
    project.addMapLayer(window_layer.open_window_layer(path))
    save_inputs(project, load_inputs(project))
    save_settings(project, "judging", asdict(JudgingSettings()))
    assert project.write(str(folder / "windows.qgs"))
    project.clear()
    window_file.store(path, [window_file.StoredResult(1, "fingerprint", _inspected(folder.parent))])
    window_file.note_mosaic(path, window_file.KnownMosaic("mosaic.tif", "content"))
    journal, _ = open_journal(folder / SCAN, FINGERPRINT)
    journal.files.save(BLOCK, record_of(_scanned(folder.parent / "scan"), exact=True))
    journal.close()


def _inspected(folder: Path) -> WindowResult:
    mosaic, *sources = (RasterRef(str(folder / f"{name}.tif")) for name in ("mosaic", "west", "east"))
    block, _ = make_block(describe_mosaic(mosaic), sources)
    return inspect_window(window_request(block, 1, block.mosaic.extent, InspectionSettings()))


def _scanned(folder: Path) -> BlockScan:
    mosaic, *sources = (describe_mosaic(RasterRef(str(folder / f"{name}.tif"))) for name in ("mosaic", "west", "east"))
    request, _ = scan_request(mosaic, [Source(source.ref, source.extent) for source in sources], ScanSettings())
    return scan_block(request.block((0, 0)))
