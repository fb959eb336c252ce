"""The profile of one bar group as a chart."""
from __future__ import annotations

from collections.abc import Mapping, Sequence

from qgis.PyQt.QtCore import QPointF, QRectF, QSize, Qt
from qgis.PyQt.QtGui import QColor, QFont, QPainter, QPaintEvent, QPen, QPolygonF
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ...toolkit.charts.chart_painter import ChartPainter
from ...toolkit.charts.chart_style import BAND_COLOURS, ChartStyle, band_colour, even_ticks
from ...toolkit.desk.theme import chart_style
from ...toolkit.painting import painting
from ...toolkit.translation import band_title, formatted, tr
from ..measure.bar_groups import GroupResult
from ..measure.bars import BarReading

_MARGIN = 0.08  # of the range of values, above and below
_POINT_PX = 3.0  # radius
_TICKS_ACROSS, _TICK_LINES = 8, 2.2  # ticks at most; and as many lines of the font between two
_ROOMY_LINES = 9  # of the font: a lower chart has no words below its axis


class ProfilesPainter(ChartPainter):
    """The profiles of a line by band, their bars and gaps, and for the weakest band the threshold of its gaps."""

    def __init__(
        self, readings: Mapping[str, BarReading], criterion: float, room: QRectF, style: ChartStyle, font: QFont
    ) -> None:
        super().__init__(room, style, font)
        self._readings, self._criterion = readings, criterion
        profiles = [reading.profile for reading in readings.values()]
        self._first = min(float(profile.positions[0]) for profile in profiles)
        self._last = max(float(profile.positions[-1]) for profile in profiles)
        low = min(float(profile.values.min()) for profile in profiles)
        high = max(float(profile.values.max()) for profile in profiles)
        margin = _MARGIN * max(high - low, 1.0)
        self._low, self._high = low - margin, high + margin
        self._names_bands = len(readings) > 1 and not set(readings) <= set(BAND_COLOURS)  # by which they are known
        most = max(room.height() / (_TICK_LINES * self.line), 2)
        self._ticks = [(value, formatted(value, "g")) for value in even_ticks(self._low, self._high, most)]
        left = max(self.metrics.horizontalAdvance(words) for _, words in [*self._ticks, (0, "DN")]) + self.line
        self._is_roomy = room.height() > _ROOMY_LINES * self.line
        self.axes = room.adjusted(left, 1.6 * self.line, -self.line, -(2.6 if self._is_roomy else 1.5) * self.line)

    def _at(self, position: float, value: float) -> QPointF:
        across = (position - self._first) / max(self._last - self._first, 1e-9)
        up = (value - self._low) / (self._high - self._low)
        return QPointF(self.axes.left() + across * self.axes.width(), self.axes.bottom() - up * self.axes.height())

    def _paint(self, painter: QPainter) -> None:
        axes, weakest = self.axes, min(self._readings.values(), key=lambda reading: reading.share or 0.0)
        for value, words in self._ticks:
            self._share_tick(painter, self._at(self._first, value).y(), words, self.style.grid)
        for position in (0.0, weakest.profile.length):
            x = self._at(position, self._low).x()
            self._rule(painter, (x, axes.top()), (x, axes.bottom()), self.style.grid)
        self._rule(painter, (axes.left(), axes.bottom()), (axes.right(), axes.bottom()), self.style.text)
        painter.setPen(QColor(self.style.text))
        self._words_left_of(painter, axes.left() - 0.3 * self.line, axes.top() - 0.5 * self.line, "DN")
        for position in even_ticks(self._first, self._last, _TICKS_ACROSS):
            self._tick_below(painter, self._at(position, self._low).x(), formatted(position, "g"))
        if self._is_roomy:
            self._words_around(painter, axes.center().x(), axes.bottom() + 2.3 * self.line, tr("along the line, px"))
        for place, (band, reading) in enumerate(self._readings.items()):
            colour = band_colour(band, place, len(self._readings) == 1, self.style)
            self._paint_profile(painter, reading, QColor(colour))
        if len(weakest.bars) > 1:
            self._paint_threshold(painter, weakest)
        if self._names_bands:
            self._paint_names(painter)

    def _paint_profile(self, painter: QPainter, reading: BarReading, colour: QColor) -> None:
        painter.setPen(QPen(colour, 1.8 * self.style.scale))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        points = zip(reading.profile.positions, reading.profile.values)
        painter.drawPolyline(QPolygonF([self._at(*point) for point in points]))
        for extremes, face in ((reading.bars, colour), (reading.gaps, QColor(self.style.background))):
            painter.setBrush(face)
            for extreme in extremes:
                painter.drawEllipse(self._at(extreme.position, extreme.value), _POINT_PX, _POINT_PX)

    def _paint_threshold(self, painter: QPainter, reading: BarReading) -> None:
        """Gaps that lie on the bars' side of this line, on the whole, are too shallow."""
        level = reading.threshold(self._criterion)
        start, end = (self._at(bar.position, level) for bar in (reading.bars[0], reading.bars[-1]))
        dashes, width = Qt.PenStyle.DashLine, 1.6 * self.style.scale
        self._rule(painter, (start.x(), start.y()), (end.x(), end.y()), self.style.limit, width, dashes)

    def _paint_names(self, painter: QPainter) -> None:
        """Above the axes, from the right."""
        x = self.axes.right()
        for place, band in reversed(list(enumerate(self._readings))):
            words = band_title(band)
            painter.setPen(QColor(band_colour(band, place, False, self.style)))
            self._words_left_of(painter, x, self.axes.top() - 0.5 * self.line, words)
            x -= self.metrics.horizontalAdvance(words) + self.line


class BarProfile(QWidget):
    """Shows the profiles of the line that is drawn."""

    def __init__(self) -> None:
        super().__init__()
        self._readings: Mapping[str, BarReading] = {}
        self._criterion = 0.0
        line = self.fontMetrics().height()
        self.setMinimumSize(11 * line, 6 * line)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def sizeHint(self) -> QSize:
        return 2 * self.minimumSize()

    def show_results(self, results: Sequence[GroupResult], criterion: float) -> None:
        """Paint what a line showed; nothing where nothing was measured."""
        self._readings = {result.band: result.reading for result in results if result.reading is not None}
        self._criterion = criterion
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        style, room = chart_style(self), QRectF(self.rect())
        with painting(self) as painter:
            painter.fillRect(room, QColor(style.background))
            if self._readings:
                ProfilesPainter(self._readings, self._criterion, room, style, self.font()).paint(painter)
