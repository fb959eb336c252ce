"""A real session on a small block, and waiting for what it does in the background."""
from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from qgis.core import QgsApplication, QgsGeometry, QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import QEvent, QEventLoop
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs
from seam_inspector.plugin.seams.desk.session import Session
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.tables.window_layer import is_in_file

from tests.patience import PATIENCE_S
from tests.qgis.scenes import BLURRED, SHARP, Scene, layer, line

SHARP_WINDOW, BLURRED_WINDOW = PixelWindow(*SHARP), PixelWindow(*BLURRED)


def wait_until(condition: Callable[[], Any], what: str = "") -> None:
    """Let Qt work until something holds."""
    stop = time.monotonic() + PATIENCE_S
    while not condition():
        assert time.monotonic() < stop, f"waited in vain {what}"
        QgsApplication.processEvents(QEventLoop.ProcessEventsFlag.AllEvents, 20)


def settle(seconds: float = 0.05) -> None:
    """Let Qt work for a while, and delete what it was asked to delete."""
    stop = time.monotonic() + seconds
    while time.monotonic() < stop:
        QgsApplication.processEvents(QEventLoop.ProcessEventsFlag.AllEvents, 5)
    QgsApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)


def wait_for_tasks() -> None:
    """Until no task is left, of ours or of others."""
    wait_until(lambda: not QgsApplication.taskManager().activeTasks(), "for the tasks' end")
    settle()


class Desk:
    """The project's layers, a session on them, and what it told."""

    def __init__(self, scene: Scene, folder: Path) -> None:
        self.project = QgsProject.instance()
        self.project.setPresetHomePath(str(folder))
        self.folder = folder
        self.lay_out(scene)
        self.messages: list[str] = []
        self.levels: list[int] = []
        self.session = Session()
        self.listen(self.session)

    def lay_out(self, scene: Scene) -> None:
        """The layers of a block, in a project that has none."""
        self.mosaic = self.raster(scene.mosaic)
        self.sources = [self.raster(scene.west), self.raster(scene.east)]
        self.seamlines = layer("LineString", [line((256, 0), (256, 256))])
        self.project.addMapLayer(self.seamlines)

    def listen(self, session: Session) -> None:
        session.messageRaised.connect(self._heard)

    def _heard(self, text: str, level: int) -> None:
        self.messages.append(text)
        self.levels.append(level)

    def raster(self, path: Path) -> QgsRasterLayer:
        made = QgsRasterLayer(str(path), path.stem)
        assert made.isValid()
        self.project.addMapLayer(made)
        return made

    def inputs(self, **changes: Any) -> Inputs:
        """All of the block, with windows of 6.4 m."""
        values: dict[str, Any] = {
            "mosaic": self.mosaic.id(),
            "sources": tuple(source.id() for source in self.sources),
            "seamlines": self.seamlines.id(),
            "windows": self.session.inputs.windows,
            "side_m": 6.4,
            "spacing_m": 6.0,
        }
        return Inputs(**{**values, **changes})

    def use(self, windows: QgsVectorLayer) -> QgsVectorLayer:
        """Make a layer the window layer, copied into a windows file unless it is of one."""
        self.project.addMapLayer(windows)
        self.set(self.inputs(windows=windows.id()))
        if not is_in_file(windows):
            self.session.copy_to_file()
            wait_until(lambda: self.session.window_layer() is not windows, "for the copy")
            self.wait()
        return self.layer()

    def set(self, inputs: Inputs) -> None:
        """Set the inputs and wait until the mosaic is open."""
        self.session.set_inputs(inputs)
        self.wait_for_opening()

    def wait_for_opening(self) -> None:
        """Until the mosaic is open, or can't be opened."""
        wait_until(lambda: self.session.problem() != seams_messages.MOSAIC_OPENING(), "for the mosaic")

    def add(self, window: PixelWindow = BLURRED_WINDOW) -> int:
        """A window that is inspected, its result written."""
        before = set(self.rows())
        self.session.add_window(window)
        self.wait()
        (number,) = set(self.rows()) - before
        return int(self.rows()[number].fid)

    def wait(self) -> None:
        """Until nothing is being placed or inspected, and all results are written."""
        wait_until(lambda: not self.session.is_busy, "for the session")
        settle(0.02)

    def rows(self) -> dict[int, Any]:
        """The windows by their number."""
        return {row.window_id: row for row in self.session.windows()}

    def layer(self) -> QgsVectorLayer:
        result = self.session.window_layer()
        assert result is not None
        return result

    def move(self, fid: int, shape: QgsGeometry) -> None:
        """Move a window as its operator does, with QGIS's pencil."""
        assert self.layer().startEditing()
        assert self.layer().changeGeometry(fid, shape)
        assert self.layer().commitChanges(), self.layer().commitErrors()

    def steps(self) -> list[str]:
        """What undo and redo would take back and do again, from the first."""
        stack = self.session.steps
        return [stack.text(index) for index in range(stack.count())]

    def undo(self) -> None:
        self.session.steps.undo()

    def redo(self) -> None:
        self.session.steps.redo()
