"""The mouse of an operator who draws bar groups."""
from __future__ import annotations

from qgis.core import QgsPointXY
from qgis.gui import QgsMapCanvas, QgsMapMouseEvent, QgsRubberBand
from qgis.PyQt.QtCore import QEvent, QPoint, Qt
from seam_inspector.plugin.resolution.desk.bar_dock import BarDock

from tests.qgis.resolution.bar_scenes import BarScene
from tests.qgis.scenes import at

LEFT, RIGHT, NONE = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton, Qt.MouseButton.NoButton
Place = tuple[float, float]


class Operator:
    """Mouse over a map of the target; places are columns and rows."""

    def __init__(self, dock: BarDock, canvas: QgsMapCanvas, scene: BarScene) -> None:
        self.dock, self.canvas, self.scene, self.tool = dock, canvas, scene, dock.tool

    def event(self, kind: QEvent.Type, place: Place, button: Qt.MouseButton, held: Qt.MouseButton) -> QgsMapMouseEvent:
        point = self.canvas.getCoordinateTransform().transform(QgsPointXY(*at(*place)))
        return QgsMapMouseEvent(self.canvas, kind, QPoint(round(point.x()), round(point.y())), button, held)

    def press(self, place: Place, button: Qt.MouseButton = LEFT) -> None:
        self.tool.canvasPressEvent(self.event(QEvent.Type.MouseButtonPress, place, button, button))

    def move(self, place: Place) -> None:
        self.tool.canvasMoveEvent(self.event(QEvent.Type.MouseMove, place, NONE, LEFT))

    def release(self, place: Place, button: Qt.MouseButton = LEFT) -> None:
        self.tool.canvasReleaseEvent(self.event(QEvent.Type.MouseButtonRelease, place, button, NONE))

    def draw(self, group: int, direction: str = "along") -> None:
        start, end = self.ends(group, direction)
        self.press(start)
        self.move(end)
        self.release(end)

    def ends(self, group: int, direction: str = "along") -> tuple[Place, Place]:
        ends = self.scene.groups[group, direction].line()
        return ends[:2], ends[2:]

    def rows(self) -> list[tuple[int, str]]:
        lines = self.dock.line_layer()
        return [] if lines is None else [(row["group"], row["direction"]) for row in lines.getFeatures()]

    @property
    def bands(self) -> list[QgsRubberBand]:
        return [item for item in self.canvas.scene().items() if isinstance(item, QgsRubberBand)]
