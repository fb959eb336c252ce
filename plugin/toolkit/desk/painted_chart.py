"""A chart of matplotlib in a widget, in its font. matplotlib takes 20 to 150 ms for one, so a thread draws it.

Imports matplotlib: load it only when a chart is to be seen.
"""
from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, Callable, NamedTuple

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties, fontManager
from qgis.PyQt.QtCore import QPointF, QSize, QTimer
from qgis.PyQt.QtGui import QFontInfo, QImage, QPaintEvent, QPalette
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ..background_tasks import interface_first
from ..charts.figure_files import set_local_ticks
from ..painting import painting
from .theme import readable_palette

ROOMY_LINES = 12  # a lower chart does without the axes' titles
_FALLBACK_FAMILY = "DejaVu Sans"  # matplotlib brings it along
_LOOK_MS = 5  # a drawing under way is asked this often whether it is done
_DIMMED = 0.35  # how much is left of a chart that is disabled


class Room(NamedTuple):
    """What a chart has to fit into, in the interface's pixels."""

    width: int
    height: int
    ratio: float
    """Pixels of the screen on one of the interface."""
    family: str
    font: int
    """Height of the font."""
    line: int


class FigurePicture(NamedTuple):
    """A whole figure that was drawn."""

    request: Any
    pixels: bytes
    """RGBA, row by row."""
    width: int
    height: int


def draw_figure(figure: Callable[[Any], Figure], request: Any) -> FigurePicture:
    """What ``figure`` makes of a request, as pixels. Has no part in Qt."""
    with interface_first():
        made = figure(request)
        set_local_ticks(made)
        canvas = FigureCanvasAgg(made)
        canvas.draw()
        pixels = np.asarray(canvas.buffer_rgba())
        return FigurePicture(request, pixels.tobytes(), pixels.shape[1], pixels.shape[0])


def fit_figure(figure: Figure, room: Room) -> None:
    """Give a figure as many pixels as there is room for; points grow with the screen's."""
    dpi = 100 * room.ratio
    figure.set_dpi(dpi)
    figure.set_size_inches(room.width * room.ratio / dpi, room.height * room.ratio / dpi)


def set_font(axes: Any, room: Room) -> FontProperties:
    """The interface's font for the words around axes."""
    known = {font.name for font in fontManager.ttflist}
    family = room.family if room.family in known else _FALLBACK_FAMILY
    size = round(room.font * 0.72, 2)  # points of 1/72 inch, at 100 pixels per inch
    font = FontProperties(family=family, size=size)
    labels = [*axes.get_xticklabels(), *axes.get_yticklabels()]  # later ones are made from these
    for text in (*labels, axes.xaxis.label, axes.yaxis.label):
        text.set_fontproperties(font)
    axes.tick_params(labelsize=size)
    return font


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

    def _room(self) -> Room:
        """What the chart has to fit into."""
        info, ratio = QFontInfo(self.font()), self.devicePixelRatioF()
        height = self.fontMetrics().height()
        return Room(self.width(), self.height(), ratio, info.family(), info.pixelSize(), height)

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
        with painting(self) as painter:
            painter.fillRect(self.rect(), readable_palette(self).color(QPalette.ColorRole.Base))
            if not self._image.isNull():
                painter.setOpacity(1.0 if self.isEnabled() else _DIMMED)
                painter.drawImage(QPointF(), self._image)
        self._ask()  # size, font or screen may be others now
