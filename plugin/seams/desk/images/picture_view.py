"""One raster's picture with its name above it. All views share a viewport, so they move as one."""
from __future__ import annotations

from qgis.PyQt.QtCore import QEvent, QPoint, QPointF, QRect, QRectF, QSize, QSizeF, Qt, pyqtSignal
from qgis.PyQt.QtGui import (
    QColor,
    QFocusEvent,
    QHelpEvent,
    QImage,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QPen,
    QResizeEvent,
    QWheelEvent,
)
from qgis.PyQt.QtWidgets import QSizePolicy, QToolTip, QWidget

from ....imagery.grids import PixelWindow
from ....toolkit.desk.theme import readable_on, readable_palette
from ....toolkit.painting import painting
from ....toolkit.translation import filled, tr
from ...clip_pictures import ClipPicture
from ...measure.profile.window_detail import LossPicture
from ...words import LOSS_OPACITY, loss_rgba
from ..map.picture_overlay import rgba_image
from .viewport import Viewport

_WHEEL_STEP = 120  # eighths of a degree: one notch
_KEY_PAN = 0.25  # of a view
_READING_OPACITY = 0.25
_ARROWS: dict[int, tuple[int, int]] = {
    Qt.Key.Key_Left: (1, 0), Qt.Key.Key_Right: (-1, 0), Qt.Key.Key_Up: (0, 1), Qt.Key.Key_Down: (0, -1)
}  # fmt: skip
_ARMS = ((1, 0), (-1, 0), (0, 1), (0, -1))  # of the linked cursor's cross


class PictureImages:
    """A picture as images on its arrays' own memory, without copies; it keeps the arrays as long as it lives."""

    def __init__(self, picture: ClipPicture) -> None:
        self.picture = picture
        arrays = (picture.pixels, *picture.reduced)
        self._arrays = [array if array.flags.c_contiguous else array.copy() for array in arrays]
        self._images = [
            QImage(array.data, array.shape[1], array.shape[0], array.strides[0], QImage.Format.Format_RGB888)
            for array in self._arrays
        ]

    def at(self, scale: float) -> tuple[QImage, int]:
        """The image to draw at a scale, and how many of the picture's pixels one of its pixels stands for a side."""
        step = 0
        while step + 1 < len(self._images) and scale * 2 ** (step + 1) <= 1:
            step += 1
        return self._images[step], 2**step


class LossImage:
    """Ready to be painted at any scale."""

    def __init__(self, loss: LossPicture) -> None:
        self.loss = loss
        self._image = rgba_image(loss_rgba(loss.kept))

    def paint(
        self, painter: QPainter, corner: QPointF, viewport: Viewport, ratio: float, inside: PixelWindow | None
    ) -> None:
        """Over a picture whose corner on the widget is given; ``inside``: the window in it, None: all of it."""
        box, cell = viewport.box(inside), self.loss.cell_px * viewport.scale
        painter.save()
        painter.translate(corner)
        painter.scale(1 / ratio, 1 / ratio)
        painter.setClipRect(box & QRectF(0, 0, *viewport.screen))
        painter.setOpacity(LOSS_OPACITY)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)  # as on the map
        painter.drawImage(QRectF(box.topLeft(), cell * QSizeF(self._image.size())), self._image)
        painter.restore()


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


def kind_of(picture: ClipPicture) -> str:
    """Mosaic, source or composite, in a word."""
    if picture.is_composite:
        return tr("composite")
    return tr("mosaic") if picture.is_mosaic else tr("source")


def short_name(picture: ClipPicture) -> str:
    """The raster's name, or what it is where there is only one of the kind."""
    return kind_of(picture) if picture.is_mosaic or picture.is_composite else picture.raster


def paint_title(
    painter: QPainter, strip: QRect, palette: QPalette, picture: ClipPicture, name: str, hint: str,
    is_flipped: bool,
) -> None:
    """A badge that says mosaic, source or composite, the name, and a hint where there is room for it.

    A flipped view's strip is highlighted all over.
    """
    metrics = painter.fontMetrics()
    text, faint = palette.color(QPalette.ColorRole.WindowText), palette.color(QPalette.ColorRole.WindowText)
    faint.setAlphaF(0.2)
    bright = palette.color(QPalette.ColorRole.Highlight)
    on_bright = readable_on(bright, palette.color(QPalette.ColorRole.HighlightedText))
    colours = (bright, on_bright) if picture.is_mosaic else (faint, text)
    if is_flipped:
        painter.fillRect(strip, bright)
        colours, text = (on_bright, bright), on_bright
    kind = kind_of(picture)
    badge = QRectF(strip).adjusted(2, 2, -2, -2)
    badge.setWidth(metrics.horizontalAdvance(kind) + 0.8 * metrics.height())
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(colours[0])
    painter.drawRoundedRect(badge, badge.height() / 3, badge.height() / 3)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    painter.setPen(colours[1])
    painter.drawText(badge, Qt.AlignmentFlag.AlignCenter, kind)
    painter.setPen(text)
    room = QRectF(strip)
    room.setLeft(badge.right() + metrics.height() / 3)
    if hint and metrics.horizontalAdvance(f"{name}  {hint}") < room.width():
        painter.drawText(room, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignRight, hint)
    elided = metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, int(room.width()))
    painter.drawText(room, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, elided)


class PictureView(QWidget):
    """Shows its picture, or another one while it is flipped."""

    hovered = pyqtSignal(object, bool)
    """The view, and whether the mouse came or went."""
    focused = pyqtSignal(object, bool)
    """The view, and whether the keyboard's focus came or went."""

    def __init__(self, viewport: Viewport, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._viewport = viewport
        self._own: PictureImages | None = None
        self._other: PictureImages | None = None
        self._loss: LossImage | None = None
        self._is_flipped = False
        self._is_reading = False
        self._dragged_from: QPoint | None = None
        self._wheel = 0
        self._marker = QRect()
        self.setMouseTracking(True)
        self.setCursor(Qt.CursorShape.CrossCursor)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        viewport.changed.connect(self.update)
        viewport.cursorMoved.connect(self._move_marker)

    # What is shown

    def set_pictures(self, picture: ClipPicture, other: ClipPicture | None) -> None:
        """Its own, and the one that is seen while the view is flipped."""
        self._own = PictureImages(picture)
        self._other = PictureImages(other) if other is not None and other is not picture else None
        self._is_reading = False
        self.setAccessibleName(self._title())
        self.update()

    def set_loss(self, loss: LossImage | None) -> None:
        """Paint over the picture where detail was lost; None: nothing."""
        if loss is not self._loss:
            self._loss = loss
            self.update()

    def set_reading(self) -> None:
        """Dim the picture: it belongs to another window."""
        self._is_reading = True
        self.update()

    def set_flipped(self, is_flipped: bool) -> None:
        if is_flipped != self._is_flipped:
            self._is_flipped = is_flipped
            self.update()

    @property
    def picture(self) -> ClipPicture | None:
        """The view's own picture."""
        return self._own.picture if self._own is not None else None

    @property
    def shown(self) -> ClipPicture | None:
        """The picture on the screen: the other one while the view is flipped."""
        images = self._shown()
        return images.picture if images is not None else None

    @property
    def hint(self) -> str:
        """What Space shows here; empty while it does, or where there is nothing else."""
        if self._other is None or self._is_flipped_now():
            return ""
        return filled(tr("Space: {name}"), name=short_name(self._other.picture))

    def _is_flipped_now(self) -> bool:
        return self._is_flipped and self._other is not None

    def _shown(self) -> PictureImages | None:
        return self._other if self._is_flipped_now() else self._own

    def _title(self) -> str:
        shown = self.shown
        if shown is None:
            return ""
        if shown.is_composite:
            return tr("hard cut of the sources")
        return filled(tr("{name} (resampled)"), name=shown.raster) if shown.resampled else shown.raster

    # Sizes

    def sizeHint(self) -> QSize:
        side = 16 * self.fontMetrics().height()
        return QSize(side, side + self._title_height())

    def minimumSizeHint(self) -> QSize:
        height = self.fontMetrics().height()
        return QSize(round(8.5 * height), 7 * height + self._title_height())

    def image_rect(self) -> QRect:
        """Where the picture is."""
        return self.rect().adjusted(0, self._title_height(), 0, 0)

    def _title_height(self) -> int:
        return round(1.35 * self.fontMetrics().height())

    def _measure_screen(self) -> None:
        ratio, rect = self.devicePixelRatioF(), self.image_rect()
        self._viewport.screen = (max(1, round(rect.width() * ratio)), max(1, round(rect.height() * ratio)))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._measure_screen()

    # Painting

    def paintEvent(self, event: QPaintEvent) -> None:
        self._measure_screen()  # the desktop's scaling may have changed
        with painting(self) as painter:
            rect = self.image_rect()
            palette = readable_palette(self)
            painter.fillRect(self.rect(), palette.color(QPalette.ColorRole.Window))
            painter.fillRect(rect, palette.color(QPalette.ColorRole.Dark))
            images = self._shown()
            if images is None:
                return
            if self._is_reading:
                painter.setOpacity(_READING_OPACITY)
            strip = QRect(0, 0, self.width(), self._title_height())
            paint_title(painter, strip, palette, images.picture, self._title(), self.hint, self._is_flipped_now())
            painter.setClipRect(rect)
            self._paint_picture(painter, images)
            if self._loss is not None and not self._is_reading:
                corner, ratio = QPointF(self.image_rect().topLeft()), self.devicePixelRatioF()
                self._loss.paint(painter, corner, self._viewport, ratio, images.picture.inside)
            if images.picture.inside is not None:
                self._paint_outline(painter, images.picture.inside)
            if not self._is_reading:
                self._paint_marker(painter)
            if self._is_flipped_now():
                paint_frame(painter, rect, palette.color(QPalette.ColorRole.Highlight))
            elif self.hasFocus():
                paint_frame(painter, rect, palette.color(QPalette.ColorRole.WindowText))

    def _paint_picture(self, painter: QPainter, images: PictureImages) -> None:
        """The part that is seen, in the screen's own pixels, so that an image pixel is the same square everywhere."""
        scale, ratio = self._viewport.scale, self.devicePixelRatioF()
        image, step = images.at(scale)
        left, top = self._viewport.origin()
        left, top = round(left - images.picture.offset_x * scale), round(top - images.picture.offset_y * scale)
        pixel = scale * step
        width, height = self._viewport.screen
        first_x, first_y = max(0, int(-left / pixel)), max(0, int(-top / pixel))
        last_x = min(image.width(), int((width - left) / pixel) + 1)
        last_y = min(image.height(), int((height - top) / pixel) + 1)
        if last_x <= first_x or last_y <= first_y:
            return
        source = QRectF(first_x, first_y, last_x - first_x, last_y - first_y)
        target = QRectF(left + first_x * pixel, top + first_y * pixel, source.width() * pixel, source.height() * pixel)
        painter.save()
        painter.translate(self.image_rect().topLeft())
        painter.scale(1 / ratio, 1 / ratio)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, scale < 1)
        painter.drawImage(target, image, source)
        painter.restore()

    def _paint_outline(self, painter: QPainter, inside: PixelWindow) -> None:
        """Paint the outline of the window within the ground around it, outside of its pixels: light within dark."""
        ratio, corner, part = self.devicePixelRatioF(), QPointF(self.image_rect().topLeft()), self._viewport.box(inside)
        box = QRectF(corner + part.topLeft() / ratio, part.size() / ratio)
        painter.setBrush(Qt.BrushStyle.NoBrush)
        for margin, colour in ((1.5, QColor(0, 0, 0, 170)), (0.5, QColor(255, 255, 255, 230))):
            painter.setPen(QPen(colour, 1))
            painter.drawRect(box.adjusted(-margin, -margin, margin, margin))

    # The linked cursor

    def _marker_rect(self) -> QRect:
        cursor = self._viewport.cursor
        if cursor is None:
            return QRect()
        scale, ratio, (left, top) = self._viewport.scale, self.devicePixelRatioF(), self._viewport.origin()
        corner = self.image_rect().topLeft()
        x, y = corner.x() + (left + cursor[0] * scale) / ratio, corner.y() + (top + cursor[1] * scale) / ratio
        arm = self.fontMetrics().height()
        return QRect(round(x) - arm, round(y) - arm, 2 * arm + 1, 2 * arm + 1)

    def _move_marker(self) -> None:
        old, self._marker = self._marker, self._marker_rect()
        for rect in (old, self._marker):
            self.update(rect.adjusted(-2, -2, 2, 2))

    def _paint_marker(self, painter: QPainter) -> None:
        self._marker = self._marker_rect()
        if not self._marker.isNull():
            paint_cross(painter, self._marker)

    # Mouse and keyboard

    def _place(self, position: QPointF) -> tuple[float, float]:
        """Screen pixels from the picture's upper left corner."""
        ratio, corner = self.devicePixelRatioF(), self.image_rect().topLeft()
        return (position.x() - corner.x()) * ratio, (position.y() - corner.y()) * ratio

    def enterEvent(self, event: QEvent) -> None:
        self.hovered.emit(self, True)

    def leaveEvent(self, event: QEvent) -> None:
        self._viewport.set_cursor(None)
        self.hovered.emit(self, False)

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.focused.emit(self, True)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.focused.emit(self, False)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() in (Qt.MouseButton.LeftButton, Qt.MouseButton.MiddleButton):
            self._dragged_from = event.pos()
            self.setCursor(Qt.CursorShape.ClosedHandCursor)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._dragged_from is not None:
            moved, ratio = event.pos() - self._dragged_from, self.devicePixelRatioF()
            self._dragged_from = event.pos()
            self._viewport.pan(moved.x() * ratio, moved.y() * ratio)
        self._point_at(event.pos())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        self._dragged_from = None
        self.setCursor(Qt.CursorShape.CrossCursor)

    def wheelEvent(self, event: QWheelEvent) -> None:
        self._wheel += event.angleDelta().y()
        steps = int(self._wheel / _WHEEL_STEP)  # touchpads send parts of a notch
        self._wheel -= steps * _WHEEL_STEP
        if steps:
            self._viewport.zoom_by(steps, *self._place(event.position()))
            self._point_at(event.position().toPoint())
        event.accept()

    def _point_at(self, position: QPoint) -> None:
        inside = self.image_rect().contains(position)
        self._viewport.set_cursor(self._viewport.window_point(*self._place(QPointF(position))) if inside else None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in _ARROWS:
            dx, dy = _ARROWS[event.key()]
            width, height = self._viewport.screen
            self._viewport.pan(_KEY_PAN * dx * width, _KEY_PAN * dy * height)
        elif event.key() in (Qt.Key.Key_Plus, Qt.Key.Key_Equal):
            self._viewport.zoom_by(1)
        elif event.key() == Qt.Key.Key_Minus:
            self._viewport.zoom_by(-1)
        else:
            super().keyPressEvent(event)

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            # over the title only: a tooltip must not cover what is being looked at
            if event.pos().y() < self._title_height() and self.shown is not None:
                text = tr("Drag to move, turn the wheel to zoom.")
                if self._other is not None:
                    hold = filled(tr("Hold Space to see {name} here."), name=short_name(self._other.picture))
                    text = f"{text} {hold}"
                QToolTip.showText(event.globalPos(), f"{self._title()}\n{text}", self)
            else:
                QToolTip.hideText()
            return True
        return super().event(event)
