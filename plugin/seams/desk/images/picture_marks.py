"""What is drawn over a picture: the window's outline, the linked cursor's cross, and a frame around the view."""
from __future__ import annotations

from qgis.PyQt.QtCore import QPoint, QRect, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QPainter, QPen

_ARMS = ((1, 0), (-1, 0), (0, 1), (0, -1))


def paint_outline(painter: QPainter, box: QRectF) -> None:
    """Light within dark, outside of the box itself."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for margin, colour in ((1.5, QColor(0, 0, 0, 170)), (0.5, QColor(255, 255, 255, 230))):
        painter.setPen(QPen(colour, 1))
        painter.drawRect(box.adjusted(-margin, -margin, margin, margin))


def paint_cross(painter: QPainter, rect: QRect) -> None:
    """An open cross, dark under light, that leaves the pixels around the place free."""
    middle, arm = rect.center(), rect.width() // 2
    gap = arm // 3
    for colour, width in ((QColor(0, 0, 0, 150), 3), (QColor(255, 255, 255, 230), 1)):
        pen = QPen(colour, width)
        pen.setCapStyle(Qt.PenCapStyle.FlatCap)
        painter.setPen(pen)
        for dx, dy in _ARMS:
            painter.drawLine(middle + QPoint(dx, dy) * gap, middle + QPoint(dx, dy) * arm)


def paint_frame(painter: QPainter, rect: QRect, colour: QColor) -> None:
    """Three pixels wide, within the rectangle."""
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(QPen(colour, 3))
    painter.drawRect(rect.adjusted(1, 1, -2, -2))
