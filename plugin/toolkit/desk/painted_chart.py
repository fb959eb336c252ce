"""A chart that a thread draws. Imports matplotlib: load it only when a chart is to be seen."""
from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Callable

from qgis.PyQt.QtCore import QPointF, QSize, QTimer
from qgis.PyQt.QtGui import QFontInfo, QImage, QPainter, QPaintEvent, QPalette
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ..charts.figure_painter import Room
from .theme import readable_palette

_LOOK_MS = 5  # a drawing under way is asked this often whether it is done
_DIMMED = 0.35  # how much is left of a chart that is disabled


class PaintedChart(QWidget):
    """Shows what ``draw`` makes of a request, for requests and pictures of any kind.

    A thread draws what was asked for last; until it is done the picture before stays.
    """

    def __init__(self, draw: Callable[[Any], Any], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._draw = draw
        self._thread = ThreadPoolExecutor(1, "seam-inspector-chart")  # ends with the last reference to it
        self._asked: Any = None
        self._drawing: Future[Any] | None = None
        self._picture: Any = None
        self._image = QImage()
        self._clock = QTimer(self)
        self._clock.setInterval(_LOOK_MS)
        self._clock.timeout.connect(self._look)
        line = self.fontMetrics().height()
        self.setMinimumSize(11 * line, 6 * line)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def sizeHint(self) -> QSize:
        return 2 * self.minimumSize()

    @property
    def is_drawn(self) -> bool:
        """Whether what is asked for is what is seen."""
        return self._picture is not None and self._picture.request == self._request()

    def _request(self) -> Any:
        """What is to be seen now; None for nothing."""
        raise NotImplementedError

    def _room(self, longest_word: str) -> Room:
        """What the chart has to fit into."""
        info, metrics = QFontInfo(self.font()), self.fontMetrics()
        return Room(
            self.width(),
            self.height(),
            self.devicePixelRatioF(),
            info.family(),
            info.pixelSize(),
            metrics.height(),
            metrics.horizontalAdvance("0"),
            metrics.horizontalAdvance(longest_word),
        )

    def _ask(self) -> None:
        """Have what is to be seen now drawn, unless it is or the thread is at work still."""
        request = self._request()
        if request is None or request == self._asked or self._drawing is not None:
            return
        self._asked, self._drawing = request, self._thread.submit(self._draw, request)
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
            painter.setOpacity(1.0 if self.isEnabled() else _DIMMED)
            painter.drawImage(QPointF(), self._image)
        painter.end()
        self._ask()  # size, font or screen may be others now
