"""What lies on the canvas while swiping: the other raster on its side, and what either side shows."""
from __future__ import annotations

from qgis.gui import QgsMapCanvas, QgsMapCanvasItem
from qgis.PyQt.QtCore import QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QPainter

from .map_picture import MapPicture

_ABOVE_THE_MAP = -5.0  # which lies at -10; outlines and marks of the canvas lie at 0 and more
_LABEL_BOX, _LABEL_TEXT = QColor(20, 20, 20, 220), QColor(255, 255, 255)
_SAME = 1e-4  # of a pixel per pixel: drawn where it was


class SwipeItem(QgsMapCanvasItem):
    """Paints one picture on either side of the handle. A side without a picture shows the map as it is."""

    def __init__(self, canvas: QgsMapCanvas, first: MapPicture, second: MapPicture) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self._pictures = first, second
        self.names = "", ""
        """What is said of the two pictures."""
        self.share = 0.5
        """Where the handle stands, from the left or from the top."""
        self.is_upright = True
        """Whether the handle is, so that the sides are left and right."""
        self.is_flipped = False
        """Whether the second picture comes first."""
        self.setZValue(_ABOVE_THE_MAP)

    def seen(self) -> QRectF:
        """What is seen of the scene, which the canvas moves while the map is dragged."""
        return QRectF(self._canvas.sceneRect().topLeft(), QRectF(self._canvas.viewport().rect()).size())

    def boundingRect(self) -> QRectF:
        # the scene asks for it in between, so it must not depend on where the map is dragged to
        size = self._canvas.viewport().size()
        return QRectF(-size.width(), -size.height(), 3 * size.width(), 3 * size.height())

    def updatePosition(self) -> None:
        """It lies on the screen: the canvas must not move or turn it."""

    def sides(self) -> tuple[QRectF, QRectF]:
        """Left and right of the handle, or above and below it."""
        seen = self.seen()
        if self.is_upright:
            at = round(seen.left() + self.share * seen.width())
            before, after = QPointF(at, seen.bottom()), QPointF(at, seen.top())
            return QRectF(seen.topLeft(), before), QRectF(after, seen.bottomRight())
        at = round(seen.top() + self.share * seen.height())
        before, after = QPointF(seen.right(), at), QPointF(seen.left(), at)
        return QRectF(seen.topLeft(), before), QRectF(after, seen.bottomRight())

    def paint(self, painter: QPainter, *_: object) -> None:
        order = (1, 0) if self.is_flipped else (0, 1)
        sides = self.sides()
        for side, number in zip(sides, order):
            self._paint_picture(painter, side, self._pictures[number])
        for place, (side, number) in enumerate(zip(sides, order)):
            self._paint_label(painter, side, self.names[number], place == 0)

    def _paint_picture(self, painter: QPainter, side: QRectF, picture: MapPicture) -> None:
        where = picture.onto(self._canvas.mapSettings())
        if where is None or picture.image is None:
            return
        moved = max(abs(where.m11() - 1), abs(where.m22() - 1), abs(where.m12()), abs(where.m21())) > _SAME
        painter.save()
        painter.setClipRect(side)
        if moved:
            painter.setTransform(where, True)
            painter.drawImage(QPointF(), picture.image)
        else:
            painter.drawImage(QPointF(round(where.dx()), round(where.dy())), picture.image)
        painter.restore()

    def _paint_label(self, painter: QPainter, side: QRectF, text: str, is_before: bool) -> None:
        """Beside the handle at the end of a side's lower edge, where there is room: QGIS's messages lie at the top."""
        painter.setFont(self._canvas.font())
        metrics = painter.fontMetrics()
        gap = metrics.height() / 3
        box = QRectF(0, 0, metrics.horizontalAdvance(text) + 2 * gap, metrics.height() + gap)
        if not text or side.width() < box.width() + 4 * gap or side.height() < box.height() + 2 * gap:
            return
        if self.is_upright and is_before:
            box.moveBottomRight(side.bottomRight() - QPointF(2 * gap, gap))
        else:
            box.moveBottomLeft(side.bottomLeft() + QPointF(2 * gap, -gap))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_LABEL_BOX)
        painter.drawRoundedRect(box, gap / 2, gap / 2)
        painter.setPen(_LABEL_TEXT)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)
