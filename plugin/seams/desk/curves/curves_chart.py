"""The picture of the curves. Imports matplotlib: load it only when a chart is to be seen."""
from __future__ import annotations

from math import hypot, inf

from qgis.PyQt.QtCore import QEvent, pyqtSignal
from qgis.PyQt.QtGui import QMouseEvent
from qgis.PyQt.QtWidgets import QWidget

from ....toolkit.charts.chart_style import ChartStyle
from ....toolkit.charts.figure_painter import TICK_PX
from ....toolkit.charts.variance_axes import level_labels
from ....toolkit.desk.painted_chart import PaintedChart
from ....toolkit.desk.theme import chart_style
from .curves_painter import Chart, ChartPainter, Key, PaintRequest, Point

__all__ = ["Chart", "CurvesChart", "chart_style"]

_LEAST_PX = 150  # of height: in less, curves can't be told apart


class CurvesChart(PaintedChart):
    """Shows a ``Chart``; says which of its points is nearest to the mouse."""

    pointed = pyqtSignal(object)  # Point, or None when the mouse is elsewhere

    def __init__(self, parent: QWidget | None = None) -> None:
        self.painter = ChartPainter()
        super().__init__(self.painter.draw, parent)
        self._chart: Chart | None = None
        self._style: ChartStyle | None = None
        self._marked: int | None = None
        self._point: Point | None = None
        self.setMinimumHeight(_LEAST_PX)
        self.setMouseTracking(True)

    @property
    def chart(self) -> Chart | None:
        """What is asked for."""
        return self._chart

    @property
    def point(self) -> Point | None:
        """What the mouse points at."""
        return self._point

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

    def _request(self) -> PaintRequest | None:
        if self._chart is None or self._style is None:
            return None
        return PaintRequest(self._chart, self._style, self._room(level_labels(0)[0]), self._marked, self._point)

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
