"""The chart of a seam profile: kept detail against the distance from the seam, and what is said of it."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import floor, inf, isfinite, isinf, log10, nan

from qgis.PyQt.QtCore import QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QFont, QPainter, QPen, QPolygonF

from ...toolkit.charts.chart_painter import ChartPainter
from ...toolkit.charts.chart_style import ChartStyle
from ...toolkit.translation import filled, percent, shown_number, tr
from ..measure.profile.cell_table import EDGES_PX
from ..measure.profile.seam_profile import ProfileBin, SeamProfile
from ..measure.window_records import ProfileRecord, WindowRecord
from ..words import strip_words

FARTHEST_PX = 400.0
"""The end that the last bin, which has none, is drawn with."""
_LOWEST_TOP, _HIGHEST_TOP = 1.2, 2.0  # of the axis of shares, between which the values choose
_HIGHEST_END = 1.45  # of an interval that is shown whole
_LEAST_MIXTURE = 0.05  # of any bin: a cut mixes nothing, but for a pixel on a border that was found
_TICK_STEPS = (1.0, 2.0, 5.0)
_NARROW = 0.6  # of the axis: words of the mixture's line may take so much of it
_WORDS_AT = 0.375  # between two lines of shares: farther off no feather has as much
_ROOMY_LINES = 13  # of the font: a lower chart has no title below its axis
_HIGH_LINES = 7  # of the font: axes that are higher have a line at every quarter, others at halves
_SAME_PLACE = 0.05  # relative: a distance that is so near to a bin's middle is that bin's


@dataclass(frozen=True)
class ShownProfile:
    """What a chart shows."""

    profile: SeamProfile
    pixel_m: float  # the mosaic's pixel size, m
    min_kept: float  # share at or below which a loss is significant
    levels: frozenset[int] = frozenset({1})  # which are drawn; the finest of them with its interval
    ground_left: float = 1.0  # what the ground around has of the sources' finest detail

    def bins(self, level: int) -> list[ProfileBin]:
        """Bins of one level, from the seam outwards."""
        return [bin_ for bin_ in self.profile.bins if bin_.level == level]

    @property
    def main_level(self) -> int:
        """The finest that is drawn."""
        return min(self.levels, default=1)

    @property
    def mixed(self) -> list[ProfileBin]:
        """The part of the chart in which the images' mixture is drawn, from the seam outwards: beside level 1, where
        anything is mixed."""
        known = [bin_ for bin_ in self.bins(1) if bin_.mixture is not None] if 1 in self.levels else []
        return known if any((bin_.mixture or 0) >= _LEAST_MIXTURE for bin_ in known) else []

    def bin_at(self, distance_m: float) -> ProfileBin | None:
        """The main level's bin at a distance from the seam; None where nothing was measured."""
        away = distance_m / self.pixel_m
        return next((bin_ for bin_ in self.bins(self.main_level) if bin_.near_px <= away < bin_.far_px), None)


def shown_profile(
    record: WindowRecord, rows: Sequence[ProfileRecord], pixel_m: float | None, min_kept: float
) -> ShownProfile | None:
    """The profile of a window from its rows; None where they tell nothing.

    ``pixel_m``: the mosaic's pixel size; where it is not known, the first distance is the middle of the first bin.
    """
    known = [row for row in rows if isfinite(row.kept) and isfinite(row.distance) and row.distance > 0]
    known.sort(key=lambda row: (row.level, row.distance))
    if not known:
        return None
    pixel_m = pixel_m or known[0].distance / _middles()[0][0]
    bins = [bin_ for row in known if (bin_ := _bin_of(row, pixel_m)) is not None]
    if not bins:
        return None
    width_px, feather_px = ((width or 0.0) / pixel_m for width in (record.band_width, record.feather_width))
    low, high = (nan if end is None else end for end in (record.kept_low, record.kept_high))
    profile = SeamProfile(record.kept, low, high, width_px, 0.0, tuple(bins), feather_px)
    return ShownProfile(profile, pixel_m, min_kept, frozenset(bin_.level for bin_ in bins))


def _middles() -> list[tuple[float, float, float]]:
    """Middle and ends of each bin, px; the last one has no end and stands where it begins."""
    ends = [*zip(EDGES_PX[:-1], EDGES_PX[1:])]
    return [((near + far) / 2, near, far) for near, far in ends] + [(EDGES_PX[-1], EDGES_PX[-1], inf)]


def _bin_of(row: ProfileRecord, pixel_m: float) -> ProfileBin | None:
    """The bin whose middle a row of the table names; None for one of another table."""
    away = row.distance / pixel_m
    middle, near, far = min(_middles(), key=lambda edges: abs(edges[0] - away))
    if abs(middle - away) > _SAME_PLACE * middle:
        return None
    return ProfileBin(row.level, near, far, row.kept, row.low, row.high, nan, nan, row.mixture)


def level_colour(level: int, style: ChartStyle) -> str:
    """Colour of a level's line."""
    return style.sources[(level - 1) % len(style.sources)]


def bin_words(shown: ShownProfile, bin_: ProfileBin) -> str:
    """What was measured in a bin."""
    text = tr("beyond {near} m: {kept} % kept ({low} to {high} %)") if isinf(bin_.far_px) else tr(
        "{near} to {far} m: {kept} % kept ({low} to {high} %)"
    )
    if bin_.low == bin_.high:  # as a scan wrote it
        text = tr("{near} to {far} m: {kept} % kept")
    if bin_ in shown.mixed:
        text = tr("{near} to {far} m: {kept} % kept ({low} to {high} %), {other} % other image")
    return filled(
        text, near=shown_number(bin_.near_px * shown.pixel_m), far=shown_number(bin_.far_px * shown.pixel_m),
        **{name: percent(getattr(bin_, name), shown.min_kept) for name in ("kept", "low", "high")},
        other=percent(bin_.mixture or 0),
    )  # fmt: skip


def summary_words(shown: ShownProfile) -> str:
    """What is kept beside the seam."""
    profile = shown.profile
    if profile.kept[0] is None:
        return ""
    text = tr("{kept} % kept ({low} to {high} %) in {width} m")
    if shown.ground_left < 1 and profile.is_of_the_ground:
        text = tr("{kept} % kept ({low} to {high} %) in {width} m; around it {left} %")
    kept, low, high = (percent(share, shown.min_kept) for share in (profile.kept[0], profile.low, profile.high))
    return filled(
        text, kept=kept, low=low, high=high, width=strip_words(shown.pixel_m), left=percent(shown.ground_left)
    )


class ProfilePainter(ChartPainter):
    """A profile in a rectangle, and where everything is.

    The axis of distances goes by their square roots: bins near the seam are narrow, and matter most.
    """

    def __init__(
        self, shown: ShownProfile, room: QRectF, style: ChartStyle, font: QFont,
        pointed: ProfileBin | None = None,
    ) -> None:
        """``pointed``: the bin under the mouse."""
        super().__init__(room, style, font)
        self._shown, self._pointed = shown, pointed
        left = self.metrics.horizontalAdvance("100 %") + 0.6 * self.line
        self._is_roomy = room.height() > _ROOMY_LINES * self.line
        bottom = (2.5 if self._is_roomy else 1.5) * self.line
        self.axes = room.adjusted(left, 0.6 * self.line, -0.9 * self.line, -bottom)
        highest = max((bin_.kept for level in shown.levels for bin_ in shown.bins(level)), default=1.0)
        ends = max((min(bin_.high, _HIGHEST_END) for bin_ in self._main_bins()), default=1.0)
        self.most_kept = min(max(1.08 * highest, 1.03 * ends, _LOWEST_TOP), _HIGHEST_TOP)
        """The share at the axis's upper end."""

    def x_of(self, distance_m: float) -> float:
        """x of a distance from the seam."""
        away = min(max(distance_m / self._shown.pixel_m, 0.0), FARTHEST_PX)
        return float(self.axes.left() + self.axes.width() * (away / FARTHEST_PX) ** 0.5)

    def distance_at(self, x: float) -> float:
        """From the seam, m."""
        share = min(max((x - self.axes.left()) / max(self.axes.width(), 1.0), 0.0), 1.0)
        return float(share**2 * FARTHEST_PX * self._shown.pixel_m)

    def y_of(self, kept: float) -> float:
        """y of a share that is kept; what is above the axis stays at its end."""
        return float(self.axes.bottom() - self.axes.height() * min(max(kept, 0.0), self.most_kept) / self.most_kept)

    def ends(self, bin_: ProfileBin) -> tuple[float, float]:
        """Left and right of a bin."""
        metres = self._shown.pixel_m
        return self.x_of(bin_.near_px * metres), self.x_of(min(bin_.far_px, FARTHEST_PX) * metres)

    @property
    def mixture(self) -> list[tuple[float, float]]:
        """The line of the image beyond the seam: through the middles of the bins, from end to end; empty for none."""
        shown = self._shown.mixed
        if not shown:
            return []
        points = [(self.x_of(bin_.middle_px * self._shown.pixel_m), self.y_of(bin_.mixture or 0)) for bin_ in shown]
        return [(self.ends(shown[0])[0], points[0][1]), *points, (self.ends(shown[-1])[1], points[-1][1])]

    def distance_ticks(self) -> list[tuple[float, str]]:
        """Places of round distances and their words, as many as there is room for."""
        farthest = FARTHEST_PX * self._shown.pixel_m
        metres, size = [0.0], 10.0 ** floor(log10(farthest) - 3)
        while size <= farthest:
            metres += [float(f"{step * size:.3g}") for step in _TICK_STEPS if step * size <= farthest]
            size *= 10
        ticks: list[tuple[float, str]] = []
        end = self.axes.left() - self.line
        for tick in metres:
            if 0 < tick < 2 * self._shown.pixel_m:
                continue
            words = shown_number(tick, len(f"{tick:.12g}".partition(".")[2]))
            x, half = self.x_of(tick), self.metrics.horizontalAdvance(words) / 2
            reach = x if self._is_roomy else x + half + 0.5 * self.line  # its unit ends the row there
            if x - half >= end + 0.4 * self.line and reach <= self.axes.right():
                ticks.append((x, words))
                end = x + half
        return ticks

    def _main_bins(self) -> list[ProfileBin]:
        """Bins whose interval is drawn and known."""
        bins = self._shown.bins(self._shown.main_level)
        return [bin_ for bin_ in bins if isfinite(bin_.low) and isfinite(bin_.high)]

    def _paint(self, painter: QPainter) -> None:
        axes = self.axes
        if self._pointed is not None:
            left, right = self.ends(self._pointed)
            painter.fillRect(QRectF(left, axes.top(), right - left, axes.height()), QColor(self.style.grid))
        self._paint_frame(painter)
        self._paint_interval(painter)
        self._paint_mixture(painter)
        for level in sorted(self._shown.levels, reverse=True):
            steps = [QPointF(x, self.y_of(bin_.kept)) for bin_ in self._shown.bins(level) for x in self.ends(bin_)]
            width = 2.2 if level == self._shown.main_level else 1.5
            painter.setPen(QPen(QColor(level_colour(level, self.style)), width * self.style.scale))
            painter.drawPolyline(QPolygonF(steps))

    def _paint_frame(self, painter: QPainter) -> None:
        axes, line, style = self.axes, self.line, self.style
        step = 0.25 if axes.height() > _HIGH_LINES * line else 0.5
        for number in range(int(self.most_kept / step) + 1):
            share = number * step
            words = f"{percent(share) if share else 0} %"
            self._share_tick(painter, self.y_of(share), words, style.text if share == 1 else style.grid)
        limit, dashes = self.y_of(self._shown.min_kept), Qt.PenStyle.DashLine
        self._rule(painter, (axes.left(), limit), (axes.right(), limit), style.limit, 1.3 * style.scale, dashes)
        words = filled(tr("limit {percent} %"), percent=percent(self._shown.min_kept))
        self._words_left_of(painter, axes.right(), limit + 0.95 * line, words)
        self._rule(painter, (axes.left(), axes.bottom()), (axes.right(), axes.bottom()), style.text)
        for x, words in self.distance_ticks():
            self._tick_below(painter, x, words)
        if not self._is_roomy:
            painter.drawText(QPointF(axes.right() - 0.1 * line, axes.bottom() + 1.1 * line), "m")
            return
        words = tr("distance from the seam (m)")
        if self.metrics.horizontalAdvance(words) > axes.width():
            words = tr("from the seam (m)")
        self._words_around(painter, axes.center().x(), axes.bottom() + 2.2 * line, words)

    def _paint_interval(self, painter: QPainter) -> None:
        colour = QColor(level_colour(self._shown.main_level, self.style))
        colour.setAlphaF(0.22)
        for bin_ in self._main_bins():
            left, right = self.ends(bin_)
            painter.fillRect(QRectF(QPointF(left, self.y_of(bin_.high)), QPointF(right, self.y_of(bin_.low))), colour)

    def _paint_mixture(self, painter: QPainter) -> None:
        """With its words at the right, above where a feather ends and below what is kept."""
        points = self.mixture
        if not points:
            return
        line = self.line
        painter.setPen(QPen(QColor(self.style.quiet), 1.3 * self.style.scale, Qt.PenStyle.DotLine))
        painter.drawPolyline(QPolygonF([QPointF(*point) for point in points]))
        words, room = tr("share of the other image"), _NARROW * self.axes.width() - 2 * line
        if self.metrics.horizontalAdvance(words) > room:
            words = tr("other image")
        y, left = self.y_of(_WORDS_AT) + line / 3, self.axes.right() - self.metrics.horizontalAdvance(words)
        painter.drawLine(QPointF(left - 2 * line, y - 0.3 * line), QPointF(left - 0.4 * line, y - 0.3 * line))
        painter.setPen(QColor(self.style.quiet))
        painter.drawText(QPointF(left, y), words)
