"""A session without tasks: what the map tool and the inputs panel ask of it, and a record of what they do."""
from __future__ import annotations

from types import SimpleNamespace

from qgis.core import QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal
from seam_inspector.plugin.imagery.errors import Message
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.measure.window_records import WindowRecord

from tests.qgis.scenes import ORIGIN, PIXEL


class FakeSession(QObject):
    """Inputs that can be set; one seam along a meridian; three sources over every window."""

    inputsChanged = pyqtSignal()
    liveChanged = pyqtSignal()
    messageRaised = pyqtSignal(str, int)
    windowsChanged = pyqtSignal()
    progressChanged = pyqtSignal(int, int)

    def __init__(self, inputs: Inputs, columns: int = 4096, rows: int = 2048) -> None:
        super().__init__()
        self.inputs = inputs
        self.grid: Grid | None = Grid(*ORIGIN, PIXEL, PIXEL, columns, rows)
        self.seam_x: float | None = None
        self.source_count = 3
        self.hovered: tuple[PixelWindow, bool] | None = None
        """The window under the mouse, and whether its curves follow."""
        self.useless: PixelWindow | None = None
        self.added: list[PixelWindow] = []
        self.settings: list[Inputs] = []
        self.layer: QgsVectorLayer | None = None
        self.rows: list[WindowRecord] = []
        self.chosen: list[int] = []

    def set_inputs(self, inputs: Inputs) -> None:
        before, self.inputs = self.inputs, inputs
        if inputs != before:
            self.settings.append(inputs)
            self.inputsChanged.emit()

    def mosaic_layer(self) -> QgsRasterLayer | None:
        layer = QgsProject.instance().mapLayer(self.inputs.mosaic)
        return layer if isinstance(layer, QgsRasterLayer) else None

    def mosaic_grid(self) -> Grid | None:
        return self.grid if self.mosaic_layer() is not None else None

    def problem(self) -> Message | None:
        return None if self.mosaic_grid() is not None else seams_messages.NO_MOSAIC()

    def block(self) -> SimpleNamespace:
        return SimpleNamespace(sources_over=lambda window: range(self.source_count))

    def seam_point_near(self, x: float, y: float, reach: float) -> tuple[float, float] | None:
        return (self.seam_x, y) if self.seam_x is not None and abs(x - self.seam_x) <= reach else None

    def window_layer(self) -> QgsVectorLayer | None:
        return self.layer

    def windows(self) -> list[WindowRecord]:
        return self.rows

    def selected(self) -> list[int]:
        return self.chosen

    def select(self, fids: list[int]) -> None:
        self.chosen = list(fids)

    def hover(self, window: PixelWindow, is_live: bool) -> None:
        self.hovered = window, is_live

    def is_useless(self, window: PixelWindow) -> bool:
        return self.useless == window

    def leave(self) -> None:
        self.hovered = None

    def add_window(self, window: PixelWindow) -> int | None:
        self.added.append(window)
        return len(self.added)
