"""The charts of the desk: they show plain data, and say what the mouse points at."""
from __future__ import annotations

from dataclasses import replace
from math import hypot, inf
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QEvent, QPointF, QRectF, QSize, pyqtSignal
from qgis.PyQt.QtGui import QMouseEvent, QPaintEvent
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ....toolkit.charts.chart_painter import ChartPainter
from ....toolkit.desk.theme import chart_style
from ....toolkit.painting import painting
from ...charts.chart_curves import Chart, Key, Point
from ...charts.curves_painter import CurvesPainter
from ...charts.profile_painter import ProfilePainter, ShownProfile

if TYPE_CHECKING:
    from ...measure.profile.seam_profile import ProfileBin, SeamProfile

_LEAST_PX = 150  # of height: in less, neither curves nor the limit and the interval can be told apart
_DIMMED = 0.35  # how much is left of a chart that is disabled
_NEAR_PX = 10  # outside the axes, where a point of a curve is pointed at from close by only


class ChartWidget(QWidget):
    """What a ``ChartPainter`` paints, in the colours of the theme; faint while it is disabled."""

    pointed = pyqtSignal(object)  # what the mouse points at; None when it is elsewhere

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMouseTracking(True)
        self.setMinimumSize(11 * self.fontMetrics().height(), _LEAST_PX)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def sizeHint(self) -> QSize:
        return 2 * self.minimumSize()

    def painter(self) -> ChartPainter | None:
        """In the widget as it is now; None for nothing to be seen."""
        raise NotImplementedError

    def point_at(self, place: QPointF | None) -> None:
        """The mouse is there; None: it is elsewhere."""
        raise NotImplementedError

    def paintEvent(self, _event: QPaintEvent) -> None:
        chart = self.painter()
        if chart is not None:
            with painting(self) as painter:
                painter.setOpacity(1.0 if self.isEnabled() else _DIMMED)
                chart.paint(painter)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self.point_at(QPointF(event.pos()))

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.point_at(None)


class CurvesChart(ChartWidget):
    """Shows a ``Chart``; points at a ``Point``."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.chart: Chart | None = None
        """What is seen."""
        self.point: Point | None = None
        """What the mouse points at."""
        self._marked: int | None = None

    def painter(self) -> CurvesPainter | None:
        if self.chart is None:
            return None
        room, font = QRectF(self.rect()), self.font()
        return CurvesPainter(self.chart, room, chart_style(self), font, self._marked, self.point)

    def show_chart(self, chart: Chart) -> None:
        """Paint a chart, at which nobody points yet; nothing happens when it is there already."""
        if chart != self.chart:
            self.chart = chart
            self._marked = self.point = None
            self.update()
            self.pointed.emit(None)

    def mark(self, key: Key | None) -> None:
        """Make one curve stand out, as while the mouse is on its entry in the legend."""
        keys = [curve.key for curve in self.chart.curves] if self.chart else []
        self._set_mark(keys.index(key) if key in keys else None, None)

    def point_at(self, place: QPointF | None) -> None:
        """A point is pointed at from anywhere in the axes, else from close by."""
        painter = self.painter()
        if place is None or painter is None or not painter.places:
            self._set_mark(None, None)
            return
        away, point = min(
            (hypot(place.x() - at.x(), place.y() - at.y()), point) for point, at in painter.places.items()
        )
        reach = inf if painter.axes.contains(place) else _NEAR_PX
        self._set_mark(*((point[0], point) if away <= reach else (None, None)))

    def _set_mark(self, index: int | None, point: Point | None) -> None:
        if (index, point) != (self._marked, self.point):
            self._marked, self.point = index, point
            self.update()
            self.pointed.emit(point)


class ProfileChart(ChartWidget):
    """Shows one profile; points at a ``ProfileBin``."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.shown: ShownProfile | None = None
        """What is seen."""
        self._levels = frozenset({1})
        self._pointed: ProfileBin | None = None
        self._marked_m: float | None = None

    @property
    def pointed_bin(self) -> ProfileBin | None:
        """What the mouse points at, here or on the map."""
        if self._pointed is None and self._marked_m is not None and self.shown is not None:
            return self.shown.bin_at(self._marked_m)
        return self._pointed

    def painter(self) -> ProfilePainter | None:
        if self.shown is None:
            return None
        room, font = QRectF(self.rect()), self.font()
        return ProfilePainter(self.shown, room, chart_style(self), font, self._pointed, self._marked_m)

    def show_profile(
        self, profile: SeamProfile, pixel_m: float, min_kept: float, ground_left: float = 1.0
    ) -> None:
        """Paint a profile; ``pixel_m``: the mosaic's pixel size, ``min_kept``: the limit of a significant loss."""
        shown = ShownProfile(profile, pixel_m, min_kept, self._levels, ground_left)
        if shown != self.shown:
            self.shown = shown
            self._point(None)
            self.update()

    def show_levels(self, levels: frozenset[int]) -> None:
        """Which levels are drawn from now on."""
        self._levels = levels
        if self.shown is not None:
            self.shown = replace(self.shown, levels=levels)
        self.update()

    def mark(self, distance_m: float | None) -> None:
        """A line at the distance that the mouse has from the seam on the map; none when it is elsewhere."""
        if distance_m != self._marked_m:
            self._marked_m = distance_m
            self.update()

    def point_at(self, place: QPointF | None) -> None:
        painter = self.painter()
        if place is None or painter is None or self.shown is None:
            self._point(None)
            return
        is_inside = painter.axes.left() <= place.x() <= painter.axes.right()
        self._point(self.shown.bin_at(painter.distance_at(place.x())) if is_inside else None)

    def _point(self, one: ProfileBin | None) -> None:
        if one != self._pointed:
            self._pointed = one
            self.update()
            self.pointed.emit(one)
