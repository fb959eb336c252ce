"""Paints the seam profile: kept detail against the distance from the seam. By QPainter alone, in a millisecond, so
that it can follow the mouse; on the screen and on paper alike."""
from __future__ import annotations

from dataclasses import dataclass
from math import floor, isinf, log10
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QLineF, QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QFontMetricsF, QPainter, QPen, QPolygonF

from ....toolkit.translation import percent, shown_number, tr

if TYPE_CHECKING:
    from ....toolkit.charts.chart_style import ChartStyle
    from ...measure.profile.seam_profile import ProfileBin, SeamProfile

_LOWEST_TOP, _HIGHEST_TOP = 1.2, 2.0  # of the axis of shares, between which the values choose
_HIGHEST_END = 1.45  # of an interval that is shown whole
_FARTHEST_PX = 400.0  # where the last bin, which has no end, is drawn to
_ROOMY_LINES = 13  # of the font: a lower chart has no title below its axis
_TICK_STEPS = (1.0, 2.0, 5.0)


@dataclass(frozen=True)
class ShownProfile:
    """What a chart shows."""

    profile: SeamProfile
    pixel_m: float
    """The mosaic's pixel size, m."""
    min_kept: float
    """Share at or below which a loss is significant."""
    levels: frozenset[int] = frozenset({1})
    """Which are drawn; the finest of them with its interval."""

    def bins(self, level: int) -> list[ProfileBin]:
        """Of one level, from the seam outwards."""
        return [one for one in self.profile.bins if one.level == level]

    @property
    def main_level(self) -> int:
        """The finest that is drawn."""
        return min(self.levels, default=1)

    def bin_at(self, distance_m: float) -> ProfileBin | None:
        """The main level's bin at a distance from the seam; None where nothing was measured."""
        away = distance_m / self.pixel_m
        return next((one for one in self.bins(self.main_level) if one.near_px <= away < one.far_px), None)


def level_colour(level: int, style: ChartStyle) -> QColor:
    """Of a level's line."""
    return QColor(style.sources[(level - 1) % len(style.sources)])


def bin_words(shown: ShownProfile, one: ProfileBin) -> list[str]:
    """What was measured in a bin, in full and in short."""
    values = {
        "near": shown_number(one.near_px * shown.pixel_m), "far": shown_number(one.far_px * shown.pixel_m),
        "kept": percent(one.kept), "low": percent(one.low), "high": percent(one.high),
    }  # fmt: skip
    if isinf(one.far_px):
        long, short = tr("beyond {near} m from the seam: {kept} % kept ({low} to {high} %)"), tr("> {near} m: {kept} %")
    else:
        long = tr("{near} to {far} m from the seam: {kept} % kept ({low} to {high} %)")
        short = tr("{near} to {far} m: {kept} %")
    return [long.format(**values), short.format(**values)]


def summary_words(shown: ShownProfile) -> list[str]:
    """What is kept beside the seam, in full and in short."""
    profile = shown.profile
    if profile.kept[0] is None:
        return [""]
    values = {
        "kept": percent(profile.kept[0]), "low": percent(profile.low), "high": percent(profile.high),
        "width": shown_number(profile.band_width_px * shown.pixel_m, 1),
    }  # fmt: skip
    words = [tr("Beside the seam {kept} % kept ({low} to {high} %)"), tr("{kept} % kept ({low} to {high} %)")]
    if profile.band_width_px:
        words.insert(0, tr("Beside the seam {kept} % kept ({low} to {high} %), band of {width} m"))
    return [text.format(**values) for text in words]


class ProfilePainter:
    """Where everything of one chart is, in a rectangle, and how it is painted there.

    The axis of distances goes by their square roots: bins near the seam are narrow, and matter most.
    """

    def __init__(self, shown: ShownProfile, room: QRectF, style: ChartStyle, metrics: QFontMetricsF) -> None:
        self._shown, self._style, self._metrics, self._room = shown, style, metrics, room
        line = metrics.height()
        left = metrics.horizontalAdvance("100 %") + 0.6 * line
        self._is_roomy = room.height() > _ROOMY_LINES * line
        self.axes = room.adjusted(left, 0.6 * line, -0.9 * line, -(2.5 if self._is_roomy else 1.5) * line)
        highest = max((one.kept for level in shown.levels for one in shown.bins(level)), default=1.0)
        ends = max((min(one.high, _HIGHEST_END) for one in shown.bins(shown.main_level)), default=1.0)
        self._top = min(max(1.08 * highest, 1.03 * ends, _LOWEST_TOP), _HIGHEST_TOP)

    def x_of(self, distance_m: float) -> float:
        """Of a distance from the seam."""
        away = min(max(distance_m / self._shown.pixel_m, 0.0), _FARTHEST_PX)
        return float(self.axes.left() + self.axes.width() * (away / _FARTHEST_PX) ** 0.5)

    def distance_at(self, x: float) -> float:
        """From the seam, m."""
        share = min(max((x - self.axes.left()) / max(self.axes.width(), 1.0), 0.0), 1.0)
        return float(share**2 * _FARTHEST_PX * self._shown.pixel_m)

    def y_of(self, kept: float) -> float:
        """Of a share that is kept; what is above the axis stays at its end."""
        return float(self.axes.bottom() - self.axes.height() * min(max(kept, 0.0), self._top) / self._top)

    def paint(self, painter: QPainter, pointed: ProfileBin | None = None, marked_m: float | None = None) -> None:
        """``pointed``: the bin under the mouse; ``marked_m``: the distance that the mouse has on the map."""
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self._room, QColor(self._style.background))
        if pointed is not None:
            self._fill_bin(painter, pointed)
        self._paint_frame(painter)
        painter.save()
        painter.setClipRect(self.axes.adjusted(0, -1, 0, 1))
        self._paint_interval(painter)
        for level in sorted(self._shown.levels, reverse=True):
            self._paint_level(painter, level)
        if marked_m is not None:
            painter.setPen(QPen(QColor(self._style.text), 1.5 * self._style.scale, Qt.PenStyle.DashLine))
            x = self.x_of(marked_m)
            painter.drawLine(QLineF(x, self.axes.top(), x, self.axes.bottom()))
        painter.restore()
        painter.restore()

    # parts

    def _ends(self, one: ProfileBin) -> tuple[float, float]:
        metres = self._shown.pixel_m
        return self.x_of(one.near_px * metres), self.x_of(min(one.far_px, _FARTHEST_PX) * metres)

    def _fill_bin(self, painter: QPainter, one: ProfileBin) -> None:
        left, right = self._ends(one)
        painter.fillRect(QRectF(left, self.axes.top(), right - left, self.axes.height()), QColor(self._style.grid))

    def _paint_frame(self, painter: QPainter) -> None:
        text, grid = QColor(self._style.text), QColor(self._style.grid)
        axes, line, metrics = self.axes, self._metrics.height(), self._metrics
        step = 0.25 if axes.height() > 7 * line else 0.5
        for number in range(int(self._top / step) + 1):
            y = self.y_of(number * step)
            is_whole = number * step == 1
            painter.setPen(QPen(text if is_whole else grid, 1.0))
            painter.drawLine(QLineF(axes.left(), y, axes.right(), y))
            painter.setPen(text)
            words = f"{percent(number * step) if number else 0} %"
            painter.drawText(QPointF(axes.left() - metrics.horizontalAdvance(words) - 0.3 * line, y + line / 3), words)
        limit = self.y_of(self._shown.min_kept)
        painter.setPen(QPen(QColor(self._style.limit), 1.3 * self._style.scale, Qt.PenStyle.DashLine))
        painter.drawLine(QLineF(axes.left(), limit, axes.right(), limit))
        words = tr("limit {percent} %").format(percent=percent(self._shown.min_kept))
        painter.drawText(QPointF(axes.right() - metrics.horizontalAdvance(words), limit + 0.95 * line), words)
        painter.setPen(text)
        painter.drawLine(QLineF(axes.bottomLeft(), axes.bottomRight()))
        end = axes.left() - line
        for metres in self._ticks():
            x, words = self.x_of(metres), f"{metres:.12g}"
            decimals = max(len(words.partition(".")[2]), 0)
            words = shown_number(metres, decimals)
            width = metrics.horizontalAdvance(words)
            if x - width / 2 < end + 0.4 * line or x > axes.right():
                continue
            end = x + width / 2
            painter.drawLine(QLineF(x, axes.bottom(), x, axes.bottom() + line / 5))
            painter.drawText(QPointF(x - width / 2, axes.bottom() + 1.1 * line), words)
        if not self._is_roomy:
            painter.drawText(QPointF(axes.right() - 0.1 * line, axes.bottom() + 1.1 * line), "m")
            return
        words = tr("distance from the seam (m)")
        if metrics.horizontalAdvance(words) > axes.width():
            words = tr("from the seam (m)")
        painter.drawText(
            QPointF(axes.center().x() - metrics.horizontalAdvance(words) / 2, axes.bottom() + 2.2 * line), words
        )

    def _ticks(self) -> list[float]:
        """Round distances, m; more than there may be room for."""
        farthest = _FARTHEST_PX * self._shown.pixel_m
        ticks, size = [0.0], 10.0 ** floor(log10(farthest) - 3)
        while size <= farthest:
            ticks += [float(f"{step * size:.3g}") for step in _TICK_STEPS if step * size <= farthest]
            size *= 10
        return [tick for tick in ticks if not tick or tick >= 2 * self._shown.pixel_m]

    def _paint_interval(self, painter: QPainter) -> None:
        level = self._shown.main_level
        colour = level_colour(level, self._style)
        colour.setAlphaF(0.22)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        for one in self._shown.bins(level):
            left, right = self._ends(one)
            painter.drawRect(QRectF(QPointF(left, self.y_of(one.high)), QPointF(right, self.y_of(one.low))))
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _paint_level(self, painter: QPainter, level: int) -> None:
        steps = QPolygonF()
        for one in self._shown.bins(level):
            y = self.y_of(one.kept)
            for x in self._ends(one):
                steps.append(QPointF(x, y))
        width = 2.2 if level == self._shown.main_level else 1.5
        painter.setPen(QPen(level_colour(level, self._style), width * self._style.scale))
        painter.drawPolyline(steps)
