"""A chart of relative variances: what it shows, words for its points, and how it is painted, the mosaic bold."""
from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import takewhile
from typing import TYPE_CHECKING, NamedTuple, Union

from qgis.PyQt.QtCore import QPointF, QRectF, Qt
from qgis.PyQt.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen, QPolygonF

from ...imagery.errors import printable
from ...toolkit.charts.chart_painter import PT, ChartPainter
from ...toolkit.charts.chart_style import ChartStyle, decade_ticks, round_below, source_look
from ...toolkit.translation import filled, formatted, tr
from ..measure.window_records import COMPOSITE, REFERENCES

if TYPE_CHECKING:
    from ..measure.window.window_result import WindowResult


_LOWEST_SHARE = 1e-6  # a logarithmic axis goes no further down: what the measurement resolves
_TICK_LINES = 1.4  # of the font, that ticks of a logarithmic axis are apart


@dataclass(frozen=True)
class ChartCurve:
    """One line in a chart."""

    label: str  # file name without its folder
    is_mosaic: bool
    detail: tuple[float, ...]  # relative variance at levels 1..R
    background: float
    is_composite: bool = False  # whether it is the hard-cut composite of the sources, which is none of them
    is_reference: bool = False  # whether the verdict is taken against it alone, and not against the sources

    @property
    def values(self) -> tuple[float, ...]:
        """Levels 1..R, then the background; NaN for a constant clip."""
        return (*self.detail, self.background)


@dataclass(frozen=True)
class Chart:
    """All that a chart shows."""

    curves: tuple[ChartCurve, ...]
    max_ratio: float  # the limit of a significant loss at level 1, relative to the least sharp source


def numbered(curves: Sequence[ChartCurve]) -> list[tuple[int, ChartCurve]]:
    """The curves with their numbers among the sources."""
    are_sources = [not (curve.is_mosaic or curve.is_composite) for curve in curves]
    return [(sum(are_sources[:place]), curve) for place, curve in enumerate(curves)]


def significance_limit(curves: Sequence[ChartCurve], max_ratio: float) -> float | None:
    """The share at level 1 at or below which a mosaic has lost significantly: by the least sharp source, or the
    composite, where the verdict is taken against it; None without either."""
    rivals = [curve for curve in curves if curve.is_reference]
    rivals = rivals or [curve for curve in curves if not (curve.is_mosaic or curve.is_composite)]
    least = min((share for curve in rivals if (share := curve.values[0]) > 0), default=None)
    return None if least is None else max_ratio * least


def share_range(chart: Chart) -> tuple[float, float]:
    """Limits of the axis, rounded so that they seldom change from window to window."""
    shares = [share for curve in chart.curves for share in curve.values]
    shares.append(significance_limit(chart.curves, chart.max_ratio) or math.nan)
    positive = [share for share in shares if share > 0]
    lowest = max(min(positive, default=0.01) * 0.9, _LOWEST_SHARE)
    return round_below(lowest), 1.25


def window_curves(result: WindowResult, band: str, reference: str = REFERENCES[0]) -> list[ChartCurve]:
    """The curves of one window and band, the mosaic's first, the sources' composite last.

    ``reference``: what the verdict is taken against, as in ``InspectionSettings``.
    """
    curves = []
    seen: Counter[str] = Counter()
    for clip in result.with_composite:
        if band not in clip.curves:
            continue
        is_mosaic = clip.role == "mosaic"
        seen[clip.raster] += not is_mosaic
        twin = f" ({seen[clip.raster]})" if seen[clip.raster] > 1 and not is_mosaic else ""
        curve = clip.curves[band]
        if clip.role == COMPOSITE:
            label, is_reference = tr("composite"), reference == clip.role
            curves.append(ChartCurve(label, False, curve.detail, curve.background, True, is_reference))
            continue
        curves.append(ChartCurve(clip.raster + twin, is_mosaic, curve.detail, curve.background))
    return curves


PenStyle = Union[Qt.PenStyle, tuple[float, ...]]
"""Lengths of dashes and gaps in widths of the line, where Qt has no word for it."""
_PENS = {
    "-": Qt.PenStyle.SolidLine,
    "--": Qt.PenStyle.DashLine,
    ":": Qt.PenStyle.DotLine,
    "-.": Qt.PenStyle.DashDotLine,
}
COMPOSITE_DASHES = (4.0, 2.0)
_ROOMY_LINES = 12  # a lower chart does without the axes' titles
_LABEL_PX = 10  # below the axis: a tick, and the gap to its label
_OUTER = 0.4  # components beyond the first and the last one
_LIMIT_REACH = 0.25  # components on either side of level 1


def curve_look(curve: ChartCurve, number: int, style: ChartStyle) -> tuple[str, PenStyle]:
    """Colour and dashes of a curve; ``number`` counts the sources."""
    if curve.is_mosaic:
        return style.text, Qt.PenStyle.SolidLine
    if curve.is_composite:
        return style.quiet, COMPOSITE_DASHES
    colour, line = source_look(number, style)
    return colour, _PENS[line]


def _pen(colour: QColor, dashes: PenStyle, width: float) -> QPen:
    """Pen of a curve; its width in px."""
    pen = QPen(colour, width, Qt.PenStyle.SolidLine, Qt.PenCapStyle.FlatCap, Qt.PenJoinStyle.RoundJoin)
    if isinstance(dashes, tuple):
        pen.setDashPattern(dashes)
    else:
        pen.setStyle(dashes)
    return pen


class CurvesPainter(ChartPainter):
    """A ``Chart`` in a rectangle, and where its points are."""

    def __init__(self, chart: Chart, room: QRectF, style: ChartStyle, font: QFont) -> None:
        super().__init__(room, style, font)
        self.chart = chart
        self._levels = len(chart.curves[0].detail) if chart.curves else 0
        self.low, self.high = share_range(chart)
        self.limit = significance_limit(chart.curves, chart.max_ratio)
        """Share at level 1 at or below which the loss is significant; None for none."""
        self._lay_out()
        self.places = {
            (index, component): self._place(component, share)
            for index, curve in enumerate(chart.curves)
            for component, share in enumerate(curve.values) if share > 0
        }  # fmt: skip
        """Places of the points that can be seen, by curve and component."""

    def _lay_out(self) -> None:
        """Margins for the words around the axes, whatever the numbers are, so that they stay from window to window."""
        digit, word = self.metrics.horizontalAdvance("0"), 1.15 * self.metrics.horizontalAdvance(tr("background"))
        self._is_roomy = self.room.height() > _ROOMY_LINES * self.line
        left = _LABEL_PX + 5.5 * digit + self.line * (1.3 if self._is_roomy else 0.1)
        step = (self.room.width() - left) / (self._levels + 1.0)
        self._in_two_rows = step < 0.6 * word  # the long word in a row of its own where it would not fit
        right = max(0.5 * self.line, word / 2 - 0.4 * step)
        bottom = _LABEL_PX + self.line * (2.2 if self._is_roomy or self._in_two_rows else 1.2)
        self.axes = self.room.adjusted(left, 0.6 * self.line, -right, -bottom)

    def x_of(self, component: float) -> float:
        """x of a component: 0 is level 1, the last one the background."""
        share = (component + _OUTER) / (max(self._levels, 1) + 2 * _OUTER)
        return float(self.axes.left() + share * self.axes.width())

    def y_of(self, share: float) -> float:
        """y of a share; what is below the axis stays at its end."""
        low, high, share = map(math.log10, (self.low, self.high, max(share, self.low)))
        return float(self.axes.bottom() - self.axes.height() * (share - low) / (high - low))

    def _place(self, component: int, share: float) -> QPointF:
        return QPointF(self.x_of(component), self.y_of(share))

    def _paint(self, painter: QPainter) -> None:
        self._paint_frame(painter)
        curves = [
            (index, *curve_look(curve, number, self.style))
            for index, (number, curve) in enumerate(numbered(self.chart.curves))
        ]  # fmt: skip
        curves.sort(key=lambda curve: self.chart.curves[curve[0]].is_mosaic)
        self._paint_limit(painter)
        for index, colour, dashes in curves:
            self._paint_curve(painter, index, QColor(colour), dashes)

    def _paint_frame(self, painter: QPainter) -> None:
        axes, style = self.axes, self.style
        for share in decade_ticks(self.low, self.high, max(axes.height() / self.line / _TICK_LINES, 2)):
            self._share_tick(painter, self.y_of(share), formatted(share, "g"), style.grid, _LABEL_PX / 2)
        for component in range(self._levels + 1):
            x = self.x_of(component)
            self._rule(painter, (x, axes.top()), (x, axes.bottom()), style.grid)
            painter.setPen(QColor(style.text))
            if component < self._levels:
                self._tick_below(painter, x, str(component + 1))
            else:
                self._tick_below(painter, x, "" if self._in_two_rows else tr("background"))
        second_row = axes.bottom() + 2.2 * self.line
        if self._in_two_rows:
            self._words_around(painter, self.x_of(self._levels), second_row, tr("background"))
        elif self._is_roomy:
            self._words_left_of(painter, axes.right(), second_row + 0.1 * self.line, tr("level"))
        self._rule(painter, (axes.left(), axes.top()), (axes.left(), axes.bottom()), style.text)
        self._rule(painter, (axes.left(), axes.bottom()), (axes.right(), axes.bottom()), style.text)
        if self._is_roomy:
            painter.save()
            painter.translate(self.room.left() + self.line, axes.center().y())
            painter.rotate(-90)
            self._words_around(painter, 0, 0, tr("relative variance"))
            painter.restore()

    def _paint_limit(self, painter: QPainter) -> None:
        if self.limit is None:
            return
        left, right, y = self.x_of(-_LIMIT_REACH), self.x_of(_LIMIT_REACH), self.y_of(self.limit)
        colour = QColor(self.style.limit)
        colour.setAlphaF(0.15)
        painter.fillRect(QRectF(left, y, right - left, self.axes.bottom() - y), colour)
        self._rule(painter, (left, y), (right, y), self.style.limit, 2 * PT * self.style.scale)

    def _paint_curve(self, painter: QPainter, index: int, colour: QColor, dashes: PenStyle) -> None:
        is_mosaic = self.chart.curves[index].is_mosaic
        width, radius = ((2.6, 3.0) if is_mosaic else (1.2, 2.0))
        painter.setPen(_pen(colour, dashes, width * PT * self.style.scale))
        for piece in self._pieces(index):
            painter.drawPolyline(QPolygonF(piece))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        radius *= PT * self.style.scale
        for piece in self._pieces(index):
            for place in piece:
                painter.drawEllipse(place, radius, radius)
        painter.setBrush(Qt.BrushStyle.NoBrush)

    def _pieces(self, index: int) -> Iterator[list[QPointF]]:
        """The curve, without the points that can't be drawn."""
        piece: list[QPointF] = []
        for component in range(len(self.chart.curves[index].values)):
            place = self.places.get((index, component))
            if place is not None:
                piece.append(place)
            elif piece:
                yield piece
                piece = []
        if piece:
            yield piece


_SHOWN_CHARACTERS = 8  # of a name in the legend at least, so that two fit into a narrow dock
_MOST_ACROSS = 4  # names in a row; more are hard to scan
_MOST_OF_ROOM = 0.35  # that the legend takes
_PIECE_LINES = 1.2  # length of a line's piece, in lines of the font
_BESIDE_NAME = _PIECE_LINES + 0.75  # what else stands in a name's room, in the same


class LegendEntry(NamedTuple):
    """A name in the legend, and what stands before it."""

    name: str
    colour: str
    dashes: PenStyle = Qt.PenStyle.SolidLine
    width: float = 0.11  # of its line, and the radius of its point, in lines of the font
    radius: float = 0.19


class LegendedCurves(CurvesPainter):
    """A ``Chart`` above the legend of its curves."""

    def __init__(self, chart: Chart, room: QRectF, style: ChartStyle, font: QFont) -> None:
        metrics, names = QFontMetricsF(font), [curve.label for curve in chart.curves]
        self.entries = _entries(chart, style, names)
        widest = max((metrics.horizontalAdvance(entry.name) for entry in self.entries), default=0.0)
        least = min(widest, _SHOWN_CHARACTERS * metrics.averageCharWidth()) + (_PIECE_LINES + 1) * metrics.height()
        most_rows = max(1, int(_MOST_OF_ROOM * room.height() / metrics.height()))
        across = min(max(-(-len(self.entries) // most_rows), 1), max(int(room.width() / least), 1), _MOST_ACROSS)
        rows = max(1, min(-(-len(self.entries) // across), most_rows))
        if widest > room.width() / across - _BESIDE_NAME * metrics.height():
            self.entries = _entries(chart, style, told_apart(chart.curves))
        if (beyond := len(self.entries) - across * rows) > 0:
            more = filled(tr("and {count} more"), count=beyond + 1)
            self.entries[across * rows - 1 :] = [LegendEntry(more, style.background)]
        self._across = across
        self._legend = QRectF(room)
        self._legend.setTop(room.bottom() - (rows + 0.3) * metrics.height())
        super().__init__(chart, room.adjusted(0, 0, 0, -self._legend.height()), style, font)

    def _paint(self, painter: QPainter) -> None:
        super()._paint(painter)
        painter.fillRect(self._legend, QColor(self.style.background))
        line, width = self.line, self._legend.width() / self._across
        for place, entry in enumerate(self.entries):
            row, column = divmod(place, self._across)
            left, middle = self._legend.left() + column * width + line / 3, self._legend.top() + (row + 0.5) * line
            end = left + _PIECE_LINES * line
            painter.setPen(_pen(QColor(entry.colour), entry.dashes, entry.width * line))
            painter.drawLine(QPointF(left, middle), QPointF(end, middle))
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(entry.colour))
            painter.drawEllipse(QPointF((left + end) / 2, middle), entry.radius * line, entry.radius * line)
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.setPen(QColor(self.style.text))
            way = Qt.TextElideMode.ElideRight if entry.name.isalpha() else Qt.TextElideMode.ElideLeft  # of files
            words = self.metrics.elidedText(entry.name, way, width - _BESIDE_NAME * line)
            painter.drawText(QPointF(end + line / 3, middle + line / 3), words)


def told_apart(curves: Sequence[ChartCurve]) -> list[str]:
    """Names of the curves, those of sources without the words that all of them begin or end with."""
    names = [curve.label for curve in curves if not (curve.is_mosaic or curve.is_composite)]
    words = [re.findall(r"[^\W_]+[\W_]*|[\W_]+", name) for name in names]
    words = [row[_shared(words) :] for row in words]
    end = _shared([row[::-1] for row in words])
    short = {name: "".join(row[: len(row) - end]).rstrip("_-. ") for name, row in zip(names, words)}
    return [(not curve.is_mosaic and short.get(curve.label)) or curve.label for curve in curves]


def _shared(words: Sequence[Sequence[str]]) -> int:
    """The number of words that all begin with."""
    return sum(1 for _ in takewhile(lambda same: len({*same}) == 1, zip(*words)))


def _entries(chart: Chart, style: ChartStyle, names: Sequence[str]) -> list[LegendEntry]:
    entries = []
    for (number, curve), name in zip(numbered(chart.curves), names):
        size = (0.22, 0.3) if curve.is_mosaic else (0.11, 0.19)
        entries.append(LegendEntry(printable(name), *curve_look(curve, number, style), *size))
    if significance_limit(chart.curves, chart.max_ratio) is not None:
        entries.append(LegendEntry(tr("limit"), style.limit, Qt.PenStyle.SolidLine, 0.15, 0.0))
    return entries
