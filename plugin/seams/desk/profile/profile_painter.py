"""Paints the seam profile: kept detail against the distance from the seam. By QPainter alone, in a millisecond, so
that it can follow the mouse; on the screen and on paper alike."""
from __future__ import annotations

from math import isinf
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QLineF, QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QFontMetricsF, QPainter, QPen, QPolygonF

from ....toolkit.translation import filled, percent, shown_number, tr
from ...charts.profile_scale import ProfileScale, ShownProfile

if TYPE_CHECKING:
    from ....toolkit.charts.chart_style import ChartStyle
    from ...measure.profile.seam_profile import ProfileBin

_NARROW = 0.6  # of the axis: words of the mixture's line may take so much of it
_WORDS_AT = 0.375  # between two lines of shares: farther off no feather has as much
_ROOMY_LINES = 13  # of the font: a lower chart has no title below its axis


def level_colour(level: int, style: ChartStyle) -> QColor:
    """Of a level's line."""
    return QColor(style.sources[(level - 1) % len(style.sources)])


def bin_words(shown: ShownProfile, one: ProfileBin) -> list[str]:
    """What was measured in a bin, in full and in short."""
    values = {
        "near": shown_number(one.near_px * shown.pixel_m), "far": shown_number(one.far_px * shown.pixel_m),
        "kept": percent(one.kept), "low": percent(one.low), "high": percent(one.high),
        "other": percent(one.mixture or 0),
    }  # fmt: skip
    if isinf(one.far_px):
        long, short = tr("beyond {near} m from the seam: {kept} % kept ({low} to {high} %)"), tr("> {near} m: {kept} %")
    else:
        long = tr("{near} to {far} m from the seam: {kept} % kept ({low} to {high} %)")
        short = tr("{near} to {far} m: {kept} %")
    words = [long, short]
    if one in shown.mixed:
        words.insert(0, tr("{near} to {far} m from the seam: {kept} % kept ({low} to {high} %), {other} % other image"))
    return [filled(text, **values) for text in words]


def summary_words(shown: ShownProfile) -> list[str]:
    """What is kept beside the seam, in full and in short."""
    profile = shown.profile
    if profile.kept[0] is None:
        return [""]
    values = {
        "kept": percent(profile.kept[0]), "low": percent(profile.low), "high": percent(profile.high),
        "width": shown_number(profile.band_width_px * shown.pixel_m, 1),
        "feather": shown_number((profile.feather_width_px or 0) * shown.pixel_m, 1),
    }  # fmt: skip
    words = [tr("Beside the seam {kept} % kept ({low} to {high} %)"), tr("{kept} % kept ({low} to {high} %)")]
    if profile.band_width_px:
        words.insert(0, tr("Beside the seam {kept} % kept ({low} to {high} %), band of {width} m"))
        if profile.feather_width_px:
            words.insert(
                0, tr("Beside the seam {kept} % kept ({low} to {high} %), band of {width} m, feather of {feather} m")
            )
    return [filled(text, **values) for text in words]


class ProfilePainter:
    """How a chart is painted in a rectangle; ``ProfileScale`` says where everything is."""

    def __init__(self, shown: ShownProfile, room: QRectF, style: ChartStyle, metrics: QFontMetricsF) -> None:
        self._shown, self._style, self._metrics, self._room = shown, style, metrics, room
        line = metrics.height()
        left = metrics.horizontalAdvance("100 %") + 0.6 * line
        self._is_roomy = room.height() > _ROOMY_LINES * line
        self.axes = room.adjusted(left, 0.6 * line, -0.9 * line, -(2.5 if self._is_roomy else 1.5) * line)
        axes = self.axes
        self._scale = ProfileScale(shown, axes.left(), axes.top(), axes.width(), axes.height())

    def x_of(self, distance_m: float) -> float:
        """Of a distance from the seam."""
        return self._scale.x_of(distance_m)

    def distance_at(self, x: float) -> float:
        """From the seam, m."""
        return self._scale.distance_at(x)

    def y_of(self, kept: float) -> float:
        """Of a share that is kept; what is above the axis stays at its end."""
        return self._scale.y_of(kept)

    @property
    def mixture(self) -> list[tuple[float, float]]:
        """The points of its line; empty for none."""
        return self._scale.mixture_line()

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
        self._paint_mixture(painter)
        for level in sorted(self._shown.levels, reverse=True):
            self._paint_level(painter, level)
        if marked_m is not None:
            painter.setPen(QPen(QColor(self._style.text), 1.5 * self._style.scale, Qt.PenStyle.DashLine))
            x = self.x_of(marked_m)
            painter.drawLine(QLineF(x, self.axes.top(), x, self.axes.bottom()))
        painter.restore()
        painter.restore()

    # parts

    def _fill_bin(self, painter: QPainter, one: ProfileBin) -> None:
        left, right = self._scale.ends(one)
        painter.fillRect(QRectF(left, self.axes.top(), right - left, self.axes.height()), QColor(self._style.grid))

    def _paint_frame(self, painter: QPainter) -> None:
        text, grid = QColor(self._style.text), QColor(self._style.grid)
        axes, line, metrics = self.axes, self._metrics.height(), self._metrics
        step = 0.25 if axes.height() > 7 * line else 0.5
        for share in self._scale.share_ticks(step):
            y = self.y_of(share)
            is_whole = share == 1
            painter.setPen(QPen(text if is_whole else grid, 1.0))
            painter.drawLine(QLineF(axes.left(), y, axes.right(), y))
            painter.setPen(text)
            words = f"{percent(share) if share else 0} %"
            painter.drawText(QPointF(axes.left() - metrics.horizontalAdvance(words) - 0.3 * line, y + line / 3), words)
        limit = self.y_of(self._shown.min_kept)
        painter.setPen(QPen(QColor(self._style.limit), 1.3 * self._style.scale, Qt.PenStyle.DashLine))
        painter.drawLine(QLineF(axes.left(), limit, axes.right(), limit))
        words = filled(tr("limit {percent} %"), percent=percent(self._shown.min_kept))
        painter.drawText(QPointF(axes.right() - metrics.horizontalAdvance(words), limit + 0.95 * line), words)
        painter.setPen(text)
        painter.drawLine(QLineF(axes.bottomLeft(), axes.bottomRight()))
        end = axes.left() - line
        for metres, words in self._scale.distance_ticks():
            x = self.x_of(metres)
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

    def _paint_interval(self, painter: QPainter) -> None:
        level = self._shown.main_level
        colour = level_colour(level, self._style)
        colour.setAlphaF(0.22)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        for one in self._shown.bins(level):
            left, right = self._scale.ends(one)
            painter.drawRect(QRectF(QPointF(left, self.y_of(one.high)), QPointF(right, self.y_of(one.low))))
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _paint_mixture(self, painter: QPainter) -> None:
        """With its words at the right, above where a feather ends and below what is kept."""
        points = self.mixture
        if not points:
            return
        colour, line = QColor(self._style.quiet), self._metrics.height()
        painter.setPen(QPen(colour, 1.3 * self._style.scale, Qt.PenStyle.DotLine))
        painter.drawPolyline(QPolygonF([QPointF(*point) for point in points]))
        words, room = tr("share of the other image"), _NARROW * self.axes.width() - 2 * line
        if self._metrics.horizontalAdvance(words) > room:
            words = tr("other image")
        y, left = self.y_of(_WORDS_AT) + line / 3, self.axes.right() - self._metrics.horizontalAdvance(words)
        painter.drawLine(QLineF(left - 2 * line, y - 0.3 * line, left - 0.4 * line, y - 0.3 * line))
        painter.setPen(colour)
        painter.drawText(QPointF(left, y), words)

    def _paint_level(self, painter: QPainter, level: int) -> None:
        steps = QPolygonF()
        for one in self._shown.bins(level):
            y = self.y_of(one.kept)
            for x in self._scale.ends(one):
                steps.append(QPointF(x, y))
        width = 2.2 if level == self._shown.main_level else 1.5
        painter.setPen(QPen(level_colour(level, self._style), width * self._style.scale))
        painter.drawPolyline(steps)
