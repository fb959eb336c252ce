"""The handle that is dragged over the map."""
from __future__ import annotations

from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QCoreApplication, QPointF, QRectF, Qt, pyqtSignal
from qgis.PyQt.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF, QWheelEvent
from qgis.PyQt.QtWidgets import QWidget

from ....toolkit.desk.widgets import rich_tip
from ....toolkit.translation import tr

_CASING, _LINE, _ARROW = QColor(0, 0, 0, 170), QColor(255, 255, 255), QColor("#0072b2")


class SwipeHandle(QWidget):
    """Lies on the canvas from edge to edge, and takes the mouse there; the wheel still zooms the map."""

    moved = pyqtSignal(float)
    """To which share of the map, from the left or from the top."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)  # not of its viewport, which scrolls its children
        self._canvas = canvas
        self._is_upright = True
        self._is_dragged = False
        self.setToolTip(rich_tip(tr("Drag to compare the mosaic with the other image. X exchanges them, Esc ends.")))

    def place(self, share: float, is_upright: bool) -> None:
        """Lie at a share of the map."""
        self._is_upright = is_upright
        ways = Qt.CursorShape.SplitHCursor, Qt.CursorShape.SplitVCursor
        self.setCursor(ways[0] if is_upright else ways[1])
        view, width = self._canvas.viewport().geometry(), self._thickness()
        if is_upright:
            self.setGeometry(view.left() + round(share * view.width()) - width // 2, view.top(), width, view.height())
        else:
            self.setGeometry(view.left(), view.top() + round(share * view.height()) - width // 2, view.width(), width)

    def _thickness(self) -> int:
        """An odd number, so that the line lies on a pixel."""
        return int(self.fontMetrics().height() * 1.5) // 2 * 2 + 1

    def mousePressEvent(self, event: QMouseEvent) -> None:
        self._is_dragged = event.button() == Qt.MouseButton.LeftButton
        event.accept()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._is_dragged = False
        event.accept()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._is_dragged:
            view = self._canvas.viewport()
            at = view.mapFromGlobal(self.mapToGlobal(event.pos()))
            share = at.x() / view.width() if self._is_upright else at.y() / view.height()
            self.moved.emit(min(max(share, 0.0), 1.0))

    def wheelEvent(self, event: QWheelEvent) -> None:
        view = self._canvas.viewport()
        at = QPointF(view.mapFromGlobal(event.globalPosition().toPoint()))
        passed = QWheelEvent(
            at, event.globalPosition(), event.pixelDelta(), event.angleDelta(), event.buttons(), event.modifiers(),
            event.phase(), event.inverted(),
        )
        QCoreApplication.sendEvent(view, passed)
        event.accept()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        middle = QRectF(self.rect()).center()
        if not self._is_upright:
            painter.translate(middle)
            painter.rotate(90)
            painter.translate(-middle)
        length, knob = max(self.width(), self.height()), self._thickness() / 2 - 1.5
        for colour, width in ((_CASING, 4), (_LINE, 2)):
            painter.setPen(QPen(colour, width))
            painter.drawLine(QPointF(middle.x(), middle.y() - length), QPointF(middle.x(), middle.y() + length))
        painter.setPen(QPen(_CASING, 1.5))
        painter.setBrush(_LINE)
        painter.drawEllipse(middle, knob, knob)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_ARROW)
        for way in (-1, 1):
            tip, foot = way * 0.75 * knob, way * 0.2 * knob
            corners = ((tip, 0.0), (foot, -0.5 * knob), (foot, 0.5 * knob))
            painter.drawPolygon(QPolygonF([middle + QPointF(x, y) for x, y in corners]))
