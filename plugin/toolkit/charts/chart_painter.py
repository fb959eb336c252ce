"""Charts by QPainter alone, in a millisecond, so that they follow the mouse: the same on the screen, in a picture file
and in a report."""
from __future__ import annotations

import re
from collections.abc import Callable

from qgis.PyQt.QtCore import QBuffer, QByteArray, QLineF, QPointF, QRectF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QFont, QFontMetricsF, QImage, QPainter, QPen
from qgis.PyQt.QtSvg import QSvgGenerator

from ..painting import painting
from .chart_style import ChartStyle

PT = 100 / 72  # px of a point, on a screen of 100 dpi


def paper_font(pixels: float) -> QFont:
    """Font of pictures that leave the desk."""
    font = QFont("sans-serif")
    font.setStyleHint(QFont.StyleHint.SansSerif)
    font.setPixelSize(round(pixels))
    return font


class ChartPainter:
    """A chart in a rectangle. Its kinds say where their axes are, and paint what stands in them."""

    def __init__(self, room: QRectF, style: ChartStyle, font: QFont) -> None:
        self.room, self.style, self.font = room, style, font
        self.metrics = QFontMetricsF(font)
        self.line = self.metrics.height()
        self.axes = QRectF(room)  # between the axes

    def paint(self, painter: QPainter) -> None:
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setFont(self.font)
        painter.fillRect(self.room, QColor(self.style.background))
        self._paint(painter)
        painter.restore()

    def _paint(self, painter: QPainter) -> None:
        raise NotImplementedError

    def _rule(
        self, painter: QPainter, start: tuple[float, float], end: tuple[float, float], colour: str,
        width: float = 1.0, dashes: Qt.PenStyle = Qt.PenStyle.SolidLine,
    ) -> None:
        painter.setPen(QPen(QColor(colour), width, dashes, Qt.PenCapStyle.FlatCap))
        painter.drawLine(QLineF(*start, *end))

    def _share_tick(self, painter: QPainter, y: float, words: str, colour: str, tick: float = 0.0) -> None:
        """A line across the axes, a tick of a length at its left, and what it stands for."""
        left = self.axes.left() - tick
        self._rule(painter, (self.axes.left(), y), (self.axes.right(), y), colour)
        self._rule(painter, (left, y), (self.axes.left(), y), self.style.text)
        painter.setPen(QColor(self.style.text))
        self._words_left_of(painter, left - 0.3 * self.line, y + self.line / 3, words)

    def _tick_below(self, painter: QPainter, x: float, words: str) -> None:
        """A tick on the lower axis, and its words below."""
        bottom = self.axes.bottom()
        self._rule(painter, (x, bottom), (x, bottom + self.line / 4), self.style.text)
        self._words_around(painter, x, bottom + 1.1 * self.line, words)

    def _words_left_of(self, painter: QPainter, x: float, y: float, words: str) -> None:
        painter.drawText(QPointF(x - self.metrics.horizontalAdvance(words), y), words)

    def _words_around(self, painter: QPainter, x: float, y: float, words: str) -> None:
        painter.drawText(QPointF(x - self.metrics.horizontalAdvance(words) / 2, y), words)


def chart_image(paint: Callable[[QPainter], None], width: int, height: int, dots: int) -> QImage:
    """What is painted on so many px, each of ``dots`` dots a side."""
    image = QImage(width * dots, height * dots, QImage.Format.Format_ARGB32)
    image.fill(Qt.GlobalColor.white)
    with painting(image) as painter:
        painter.scale(dots, dots)
        paint(painter)
    return image


def chart_svg(paint: Callable[[QPainter], None], width: int, height: int) -> str:
    """What is painted on so many px, as an SVG file without what no reader sees."""
    content = QByteArray()
    device = QBuffer(content)
    generator = QSvgGenerator()
    generator.setOutputDevice(device)
    generator.setResolution(96)
    generator.setSize(QSize(width, height))
    generator.setViewBox(QRectF(0, 0, width, height))
    generator.setTitle("")
    generator.setDescription("")
    with painting(generator) as painter:
        paint(painter)
    svg = bytes(content).decode()
    svg = re.sub(r'(<g [^>]*?)( font-[a-z]+="[^"]*")+', r"\1", svg)  # each text has its own
    svg = re.sub(r"<(title|desc|defs)>\s*</\1>|<g [^>]*>\s*</g>| transform=\"matrix\(1,0,0,1,0,0\)\"", "", svg)
    return re.sub(r"\s*\n\s*", " ", svg).replace("> <", "><")
