"""The picture of the curves. Imports matplotlib: load it only when a chart is to be seen."""
from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor
from math import hypot, inf

from qgis.PyQt.QtCore import QEvent, QPointF, QSize, QTimer, pyqtSignal
from qgis.PyQt.QtGui import QFontInfo, QImage, QMouseEvent, QPainter, QPaintEvent, QPalette
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ..adapters.charts import DARK, PAPER, ChartStyle, level_labels
from .chart_painter import TICK_PX, Chart, ChartPainter, Key, Picture, Point, Request, Room
from .theme import blended, readable_palette

__all__ = ["Chart", "CurvesChart", "chart_style"]

_FONT_PX = 12  # of the interface on an ordinary screen
_DARKEST_LIGHT = 128  # of 255: a background darker than this is a dark theme
_LOOK_MS = 5  # a drawing under way is asked this often whether it is done


def chart_style(widget: QWidget) -> ChartStyle:
    """The colours of a chart in a widget, its lines as heavy as the widget's font is large."""
    palette, scale = readable_palette(widget), QFontInfo(widget.font()).pixelSize() / _FONT_PX
    back, text = palette.color(QPalette.ColorRole.Base), palette.color(QPalette.ColorRole.Text)
    theme = DARK if back.lightness() < _DARKEST_LIGHT else PAPER
    grid = blended(text, back, 0.18)
    return ChartStyle(text.name(), back.name(), grid.name(), theme.limit, theme.sources, scale)


class CurvesChart(QWidget):
    """Shows a ``Chart``; says which of its points is nearest to the mouse.

    A thread draws what was asked for last; until it is done the picture before stays.
    """

    pointed = pyqtSignal(object)  # Point, or None when the mouse is elsewhere

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.painter = ChartPainter()
        self._thread = ThreadPoolExecutor(1, "seam-inspector-chart")  # ends with the last reference to it
        self._chart: Chart | None = None
        self._style: ChartStyle | None = None
        self._marked: int | None = None
        self._point: Point | None = None
        self._asked: Request | None = None
        self._drawing: Future[Picture] | None = None
        self._picture: Picture | None = None
        self._image = QImage()
        self._clock = QTimer(self)
        self._clock.setInterval(_LOOK_MS)
        self._clock.timeout.connect(self._look)
        line = self.fontMetrics().height()
        self.setMinimumSize(11 * line, 6 * line)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMouseTracking(True)

    def sizeHint(self) -> QSize:
        return 2 * self.minimumSize()

    @property
    def chart(self) -> Chart | None:
        """What is asked for."""
        return self._chart

    @property
    def point(self) -> Point | None:
        """What the mouse points at."""
        return self._point

    @property
    def is_drawn(self) -> bool:
        """Whether what is asked for is what is seen."""
        return self._picture is not None and self._picture.request == self._request()

    def place_of(self, point: Point) -> tuple[float, float] | None:
        """Where a point is in the widget; None while it is hidden or off the axis."""
        return self._picture.places.get(point) if self._picture is not None else None

    def show_chart(self, chart: Chart, style: ChartStyle) -> None:
        """Draw a chart; nothing happens when it is there already."""
        if (chart, style) != (self._chart, self._style):
            self._chart, self._style = chart, style
            self._marked = self._point = None
            self._ask()
            self.pointed.emit(None)

    def mark(self, key: Key | None) -> None:
        """Make one curve stand out, as while the mouse is on its entry in the legend."""
        keys = [curve.key for curve in self._chart.curves] if self._chart else []
        self._set_mark(keys.index(key) if key in keys else None, None)

    # drawing

    def _request(self) -> Request | None:
        if self._chart is None or self._style is None:
            return None
        info, metrics = QFontInfo(self.font()), self.fontMetrics()
        room = Room(
            self.width(),
            self.height(),
            self.devicePixelRatioF(),
            info.family(),
            info.pixelSize(),
            metrics.height(),
            metrics.horizontalAdvance("0"),
            metrics.horizontalAdvance(level_labels(0)[0]),
        )
        return Request(self._chart, self._style, room, self._marked, self._point)

    def _ask(self) -> None:
        """Have what is to be seen now drawn, unless it is or the thread is at work still."""
        request = self._request()
        if request is None or request == self._asked or self._drawing is not None:
            return
        self._asked, self._drawing = request, self._thread.submit(self.painter.draw, request)
        self._clock.start()

    def _look(self) -> None:
        """Take the picture once it is there."""
        drawing = self._drawing
        if drawing is None or not drawing.done():
            return
        self._clock.stop()
        self._drawing = None
        self._picture = picture = drawing.result()
        stride, layout = 4 * picture.width, QImage.Format.Format_RGBX8888
        self._image = QImage(picture.pixels, picture.width, picture.height, stride, layout)
        self._image.setDevicePixelRatio(picture.request.room.ratio)
        self.update()
        self._ask()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.fillRect(self.rect(), readable_palette(self).color(QPalette.ColorRole.Base))
        if not self._image.isNull():
            painter.drawImage(QPointF(), self._image)
        painter.end()
        self._ask()  # size, font or screen may be others now

    # mouse

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """A point is pointed at from anywhere in the axes, else from close by."""
        picture = self._picture
        if picture is None or picture.request.chart != self._chart or not picture.places:
            self._set_mark(None, None)
            return
        x, y = event.pos().x(), event.pos().y()
        left, top, right, bottom = picture.axes
        away, point = min((hypot(x - px, y - py), point) for point, (px, py) in picture.places.items())
        reach = inf if left <= x <= right and top <= y <= bottom else TICK_PX
        self._set_mark(*((point[0], point) if away <= reach else (None, None)))

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._set_mark(None, None)

    def _set_mark(self, index: int | None, point: Point | None) -> None:
        if (index, point) != (self._marked, self._point):
            self._marked, self._point = index, point
            self._ask()
            self.pointed.emit(point)
