"""What lies on the canvas while swiping: the other raster on its side, and what either side shows."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from qgis.core import QgsMapLayer, QgsMapRendererParallelJob, QgsMapSettings
from qgis.gui import QgsMapCanvas, QgsMapCanvasItem
from qgis.PyQt.QtCore import QCoreApplication, QObject, QPointF, QRectF, Qt, QTimer, pyqtSignal
from qgis.PyQt.QtGui import QColor, QImage, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF, QTransform, QWheelEvent
from qgis.PyQt.QtWidgets import QWidget

from ....toolkit.desk.widgets import rich_tip
from ....toolkit.painting import painting
from ....toolkit.translation import tr

_under_way: set[QgsMapRendererParallelJob] = set()
"""Cancelled jobs too, until they have ended: to let one go before would wait for it."""


def _job_ended() -> None:
    """It is in the midst of telling so, and must live until it has."""
    QTimer.singleShot(0, _let_go_of_ended)


def _let_go_of_ended() -> None:
    _under_way.difference_update([job for job in _under_way if not job.isActive()])


def end_drawing(*_: object) -> None:
    """Cancel all jobs, and wait until they have ended, as QGIS does with its maps before it closes a project: their
    threads share the styles of layers, and crash when these go meanwhile."""
    for job in list(_under_way):
        job.cancel()


class MapPicture(QObject):
    """Keeps the last picture until the next one is drawn."""

    drawn = pyqtSignal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._job: QgsMapRendererParallelJob | None = None
        self.image: QImage | None = None
        """None before the first one is drawn."""
        self._settings = QgsMapSettings()  # that the image was drawn by

    @property
    def is_drawing(self) -> bool:
        """Whether a picture is under way."""
        return self._job is not None

    def draw(self, like: QgsMapSettings, layers: Sequence[QgsMapLayer]) -> None:
        """Draw what a canvas with these settings would show of other layers, the topmost first."""
        self._cancel()
        settings = QgsMapSettings(like)
        settings.setLayers(list(layers))
        job = QgsMapRendererParallelJob(settings)
        job.finished.connect(self._finished)
        job.finished.connect(_job_ended)
        _under_way.add(job)
        self._job = job
        job.start()

    def close(self) -> None:
        """Draw no more, and forget what was drawn."""
        self._cancel()
        self.image = None

    def onto(self, now: QgsMapSettings) -> QTransform | None:
        """Where the picture lies on a map that was moved, zoomed or turned since; None where it lies nowhere."""
        before = self._settings
        if self.image is None or before.destinationCrs() != now.destinationCrs():
            return None
        width, height = before.outputSize().width(), before.outputSize().height()
        from_pixel, to_pixel = before.mapToPixel(), now.mapToPixel()
        origin, right, below = (
            to_pixel.transform(from_pixel.toMapCoordinates(x, y))
            for x, y in ((0, 0), (width, 0), (0, height))
        )
        return QTransform(
            (right.x() - origin.x()) / width, (right.y() - origin.y()) / width,
            (below.x() - origin.x()) / height, (below.y() - origin.y()) / height, origin.x(), origin.y(),
        )  # fmt: skip

    def _cancel(self) -> None:
        job, self._job = self._job, None
        if job is not None:
            job.finished.disconnect(self._finished)
            job.cancelWithoutBlocking()

    def _finished(self) -> None:
        job, self._job = self._job, None
        if job is not None:
            self.image, self._settings = job.renderedImage(), QgsMapSettings(job.mapSettings())
            self.drawn.emit()


_ABOVE_THE_MAP = -5.0  # which lies at -10; outlines and marks of the canvas lie at 0 and more
_ABOVE_THE_LOSS = 7.0  # the picture of the mosaic's lost detail, which is none of another picture
_LABEL_BOX, _LABEL_TEXT = QColor(20, 20, 20, 220), QColor(255, 255, 255)
_SAME = 1e-4  # of a pixel per pixel: drawn where it was


@dataclass
class Divider:
    """What parts the two sides."""

    share: float = 0.5
    """Where it stands on the map, from the left or from the top."""
    is_upright: bool = True
    """So that the sides are left and right."""
    is_flipped: bool = False
    """Whether the second picture comes first."""


class SwipeItem(QgsMapCanvasItem):
    """Paints one picture on either side of the handle. A side without a picture shows the map as it is."""

    def __init__(
        self, canvas: QgsMapCanvas, divider: Divider, first: MapPicture, second: MapPicture, hides_loss: bool = False
    ) -> None:
        """``hides_loss``: whether it lies over the picture of lost detail too, else below it."""
        super().__init__(canvas)
        self._canvas = canvas
        self._divider, self._pictures = divider, (first, second)
        self.names = "", ""
        """What is said of the two pictures."""
        self.setZValue(_ABOVE_THE_LOSS if hides_loss else _ABOVE_THE_MAP)

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
        seen, share = self.seen(), self._divider.share
        if self._divider.is_upright:
            at = round(seen.left() + share * seen.width())
            before, after = QPointF(at, seen.bottom()), QPointF(at, seen.top())
        else:
            at = round(seen.top() + share * seen.height())
            before, after = QPointF(seen.right(), at), QPointF(seen.left(), at)
        return QRectF(seen.topLeft(), before), QRectF(after, seen.bottomRight())

    def paint(self, painter: QPainter, *_: object) -> None:
        order = (1, 0) if self._divider.is_flipped else (0, 1)
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
        if self._divider.is_upright and is_before:
            box.moveBottomRight(side.bottomRight() - QPointF(2 * gap, gap))
        else:
            box.moveBottomLeft(side.bottomLeft() + QPointF(2 * gap, -gap))
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(_LABEL_BOX)
        painter.drawRoundedRect(box, gap / 2, gap / 2)
        painter.setPen(_LABEL_TEXT)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)


_CASING, _LINE, _ARROW = QColor(0, 0, 0, 170), QColor(255, 255, 255), QColor("#0072b2")


class SwipeHandle(QWidget):
    """Lies on the canvas from edge to edge, and takes the mouse there; the wheel still zooms the map."""

    moved = pyqtSignal(float)
    """To which share of the map, from the left or from the top."""

    def __init__(self, canvas: QgsMapCanvas, divider: Divider) -> None:
        super().__init__(canvas)  # not of its viewport, which scrolls its children
        self._canvas, self._divider = canvas, divider
        self._is_dragged = False
        self.setToolTip(rich_tip(tr("Drag to compare the mosaic with the other image. X swaps them, Esc ends.")))

    def place(self) -> None:
        """Lie where the divider is."""
        share, is_upright = self._divider.share, self._divider.is_upright
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
            share = at.x() / view.width() if self._divider.is_upright else at.y() / view.height()
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
        with painting(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            middle = QRectF(self.rect()).center()
            if not self._divider.is_upright:
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
