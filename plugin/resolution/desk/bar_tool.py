"""The map tool that draws a line across the bars of one group: drag, or click at both ends."""
from __future__ import annotations

from qgis.core import QgsGeometry, QgsPointXY, QgsWkbTypes
from qgis.gui import QgsMapCanvas, QgsMapMouseEvent, QgsRubberBand
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QPoint, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QKeyEvent

from ...toolkit.desk.tool_dock import DrawingTool, is_drag

_LINE, _CASING = QColor("#ffd400"), QColor(0, 0, 0, 170)


class BarTool(DrawingTool):
    """The first press sets an end, a release after a drag or a second click the other one.

    Esc takes the first end back; the right button does too, or ends when there is none.
    """

    moved = pyqtSignal(QgsPointXY, QgsPointXY)  # both ends, on the map, while the second one follows the mouse
    drawn = pyqtSignal(QgsPointXY, QgsPointXY)  # both ends of a finished line, on the map
    cancelled = pyqtSignal()  # the line under way was given up

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self._band: QgsRubberBand | None = None
        self._start: QgsPointXY | None = None
        self._pressed_at: QPoint | None = None

    def canvasPressEvent(self, event: QgsMapMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton and self._start is None:
            self._start, self._pressed_at = event.mapPoint(), event.pixelPoint()

    def canvasMoveEvent(self, event: QgsMapMouseEvent) -> None:
        if self._start is not None:
            self._show(event.mapPoint())
            if self._start != event.mapPoint():
                self.moved.emit(self._start, event.mapPoint())

    def canvasReleaseEvent(self, event: QgsMapMouseEvent) -> None:
        if event.button() == Qt.MouseButton.RightButton:
            if self._start is not None:
                self._give_up()
            else:
                self.finished.emit()
        elif event.button() == Qt.MouseButton.LeftButton and self._start is not None:
            if self._pressed_at is not None and not is_drag(self._pressed_at, event.pixelPoint()):
                self._pressed_at = None  # the first of two clicks
                return
            start = self._start
            self._clear()
            if start != event.mapPoint():
                self.drawn.emit(start, event.mapPoint())

    def _key_pressed(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self._start is not None:
            event.accept()
            self._give_up()

    def _give_up(self) -> None:
        self._clear()
        self.cancelled.emit()

    def _clear(self) -> None:
        self._start = self._pressed_at = None
        if self._band is not None and not sip.isdeleted(self.canvas()):
            self.canvas().scene().removeItem(self._band)
        self._band = None

    def _show(self, end: QgsPointXY) -> None:
        if self._band is None:
            self._band = QgsRubberBand(self.canvas(), QgsWkbTypes.GeometryType.LineGeometry)
            self._band.setStrokeColor(_LINE)
            self._band.setSecondaryStrokeColor(_CASING)
            self._band.setWidth(2)
        self._band.setToGeometry(QgsGeometry.fromPolylineXY([self._start, end]))
