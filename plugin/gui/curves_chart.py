"""The matplotlib canvas of the curves. Imports matplotlib: load it only when a chart is to be seen.

Three layers, each kept as pixels: the frame (axes, ticks, grid; most of the time of a drawing), the curves, and
what the mouse points at. A new window, band or hidden raster mostly draws the curves alone.
"""
from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
from qgis.PyQt.QtCore import pyqtSignal
from qgis.PyQt.QtGui import QFontInfo, QPalette
from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ..adapters.charts import DARK, PAPER, ChartStyle, draw_frame, draw_lines, level_labels, share_range
from ..adapters.curves import ChartCurve

# after qgis.PyQt, whose binding matplotlib then takes
from matplotlib.artist import Artist  # isort: skip
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg  # isort: skip
from matplotlib.figure import Figure  # isort: skip
from matplotlib.font_manager import FontProperties, fontManager  # isort: skip

Key = tuple[bool, str]
Point = tuple[int, int]  # a curve's index and a component's
_FONT_PX = 12  # of the interface on an ordinary screen
_TICK_PX = 10  # a tick and the gap to its label: 7 points, matplotlib's own
_ROOMY_LINES = 12  # a lower chart does without the axes' titles
_DARKEST_LIGHT = 128  # of 255: a background darker than this is a dark theme


@dataclass(frozen=True)
class Chart:
    """All that a chart shows."""

    curves: tuple[ChartCurve, ...]
    max_ratio: float
    logarithmic: bool = True
    hidden: frozenset[Key] = frozenset()


def chart_style(widget: QWidget) -> ChartStyle:
    """The colours of a chart in a widget, its lines as heavy as the widget's font is large."""
    palette, scale = widget.palette(), QFontInfo(widget.font()).pixelSize() / _FONT_PX
    back, text = palette.color(QPalette.ColorRole.Base), palette.color(QPalette.ColorRole.Text)
    theme = DARK if back.lightness() < _DARKEST_LIGHT else PAPER
    mixed = [round(0.82 * b + 0.18 * t) for b, t in zip(back.getRgb()[:3], text.getRgb()[:3])]
    grid = "#{:02x}{:02x}{:02x}".format(*mixed)
    return ChartStyle(text.name(), back.name(), grid, theme.limit, theme.sources, scale)


class CurvesChart(FigureCanvasQTAgg):
    """Shows a ``Chart``; says which of its points is nearest to the mouse."""

    pointed = pyqtSignal(object)  # Point, or None when the mouse is elsewhere

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(Figure())
        self.setParent(parent)
        self._axes = self.figure.add_axes((0.2, 0.2, 0.7, 0.7))
        self._ring = self._axes.plot(
            [], [], marker="o", markerfacecolor="none", markeredgewidth=1.4, animated=True
        )[0]
        self._chart: Chart | None = None
        self._style: ChartStyle | None = None
        self._frame_key: object = None
        self._frame: Any = None  # pixels of the frame; None while it has to be drawn
        self._picture: Any = None  # pixels of frame and curves
        self._artists: list[Artist] = []
        self._points: list[Point] = []
        self._places = np.empty((0, 2))
        self._point: Point | None = None
        self._marked: int | None = None
        self.frames_drawn = self.curves_drawn = 0  # for tests
        line = self.fontMetrics().height()
        self.setMinimumSize(11 * line, 6 * line)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.mpl_connect("draw_event", self._on_frame_drawn)
        self.mpl_connect("resize_event", self._on_resized)
        self.mpl_connect("motion_notify_event", self._on_mouse_moved)
        self.mpl_connect("figure_leave_event", self._on_mouse_left)

    @property
    def chart(self) -> Chart | None:
        """What is shown."""
        return self._chart

    @property
    def point(self) -> Point | None:
        """What the mouse points at."""
        return self._point

    def place_of(self, point: Point) -> tuple[float, float] | None:
        """Where a point is, in pixels from the lower left; None while it is hidden or off the axis."""
        return tuple(self._places[self._points.index(point)]) if point in self._points else None

    def show_chart(self, chart: Chart, style: ChartStyle) -> None:
        """Draw a chart; nothing happens when it is there already."""
        levels = len(chart.curves[0].detail) if chart.curves else 0
        limits = share_range(chart.curves, chart.max_ratio, chart.logarithmic)
        font = self._font()
        frame_key = (levels, limits, chart.logarithmic, style, font)
        if chart == self._chart and frame_key == self._frame_key:
            return
        for artist in self._artists:
            artist.remove()
        self._artists = []
        self._chart, self._style = chart, style
        self._point = self._marked = None
        if frame_key != self._frame_key:
            self._frame_key, self._frame = frame_key, None
            self.figure.set_facecolor(style.background)
            draw_frame(self._axes, levels, style, chart.logarithmic)
            self._axes.set_ylim(*limits)
            self._set_font(*font)
            self._arrange()
        self._artists = draw_lines(self._axes, chart.curves, chart.max_ratio, style, chart.hidden)
        for artist in self._artists:
            artist.set_animated(True)  # left out when the frame is drawn
        if self._frame is None:
            self.draw_idle()
        else:
            self._draw_curves()
            self.update()
        self.pointed.emit(None)

    def mark(self, key: Key | None) -> None:
        """Make one curve stand out, as while the mouse is on its entry in the legend."""
        keys = [curve.key for curve in self._chart.curves] if self._chart else []
        self._set_mark(keys.index(key) if key in keys else None, None)

    # layers

    def _on_frame_drawn(self, _event: object) -> None:
        self.frames_drawn += 1
        self._frame = self.copy_from_bbox(self.figure.bbox)
        self._draw_curves()

    def _draw_curves(self) -> None:
        self.curves_drawn += 1
        self.restore_region(self._frame)
        for artist in sorted(self._artists, key=Artist.get_zorder):
            self._axes.draw_artist(artist)
        self._picture = self.copy_from_bbox(self.figure.bbox)
        curves = self._chart.curves if self._chart else ()
        hidden = self._chart.hidden if self._chart else frozenset()
        shares = [
            (index, component, share)
            for index, curve in enumerate(curves)
            if curve.key not in hidden
            for component, share in enumerate(curve.values)
            if share == share and (share > 0 or not (self._chart and self._chart.logarithmic))
        ]
        self._points = [(index, component) for index, component, _ in shares]
        where = np.array([(component, share) for _, component, share in shares]).reshape(-1, 2)
        self._places = self._axes.transData.transform(where)
        self._draw_mark()

    def _draw_mark(self) -> None:
        if self._marked is None or self._chart is None or self._style is None:
            return
        curve = self._chart.curves[self._marked]
        line = next((artist for artist in self._artists if artist.get_label() == curve.label), None)
        if line is None:
            return
        width = line.get_linewidth()
        line.set_linewidth(width + 1.6 * self._style.scale)
        self._axes.draw_artist(line)
        line.set_linewidth(width)
        if self._point is not None:
            self._ring.set_data([self._point[1]], [curve.values[self._point[1]]])
            self._ring.set_markeredgecolor(self._style.text)
            self._ring.set_markersize(10 * self._style.scale)
            self._axes.draw_artist(self._ring)

    def _set_mark(self, index: int | None, point: Point | None) -> None:
        if (index, point) == (self._marked, self._point):
            return
        self._marked, self._point = index, point
        if self._picture is not None and self._frame is not None:
            self.restore_region(self._picture)
            self._draw_mark()
            self.update()
        self.pointed.emit(point)

    # mouse

    def _on_mouse_moved(self, event: Any) -> None:
        away = np.hypot(*(self._places - (event.x, event.y)).T)
        reach = np.inf if event.inaxes is not None else _TICK_PX * self.device_pixel_ratio
        if self._frame is None or not self._points or away.min() > reach:
            self._set_mark(None, None)
            return
        point = self._points[int(away.argmin())]
        self._set_mark(point[0], point)

    def _on_mouse_left(self, _event: object) -> None:
        self._set_mark(None, None)

    # layout

    def _on_resized(self, _event: object) -> None:
        self._frame = self._picture = None
        self._arrange()

    def _font(self) -> tuple[str, float]:
        """Family and size of the widget's font for matplotlib, in its points."""
        info = QFontInfo(self.font())
        family = info.family() if info.family() in _families() else "DejaVu Sans"  # matplotlib brings that one
        return family, round(info.pixelSize() * 72 / self.figure.dpi * self.device_pixel_ratio, 2)

    def _set_font(self, family: str, size: float) -> None:
        font = FontProperties(family=family, size=size)
        labels = [*self._axes.get_xticklabels(), *self._axes.get_yticklabels()]  # later ones are made from these
        for text in (*labels, self._axes.xaxis.label, self._axes.yaxis.label):
            text.set_fontproperties(font)
        self._axes.tick_params(labelsize=size)

    def _arrange(self) -> None:
        """Margins for the words around the axes, from the font: matplotlib's own layouts double the time."""
        width, height = max(self.width(), 1), max(self.height(), 1)
        metrics = self.fontMetrics()
        line, word = metrics.height(), 1.15 * metrics.horizontalAdvance(level_labels(0)[0])
        levels = len(self._chart.curves[0].detail) if self._chart and self._chart.curves else 0
        roomy = height > _ROOMY_LINES * line
        left = _TICK_PX + 5.5 * metrics.horizontalAdvance("0") + line * (1.3 if roomy else 0.1)
        step = (width - left) / (levels + 1.0)
        in_two_rows = step < 0.6 * word
        right = max(0.5 * line, word / 2 - 0.4 * step)
        top, bottom = 0.6 * line, _TICK_PX + line * (2.2 if roomy or in_two_rows else 1.2)
        across, up = max(width - left - right, 1), max(height - bottom - top, 1)
        axes = self._axes
        axes.set_position((left / width, bottom / height, across / width, up / height))
        axes.set_xticks(range(levels + 1), level_labels(levels, in_two_rows))
        axes.xaxis.label.set_visible(roomy)
        axes.yaxis.label.set_visible(roomy)
        axes.xaxis.set_label_coords(0.5, -(_TICK_PX + line) / up)  # their own places take a third of the drawing
        axes.yaxis.set_label_coords(-(left - 1.2 * line) / across, 0.5)


@cache
def _families() -> frozenset[str]:
    return frozenset(font.name for font in fontManager.ttflist)
