"""A chart as pixels. matplotlib takes 20 to 150 ms for one, so it draws in a thread and the interface goes on.

Three layers, each kept as pixels: the frame (axes, ticks, grid; most of the time of a drawing), the curves, and the
mark of the one that the mouse points at. A new window, band or hidden raster mostly draws the curves alone.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from ....toolkit.background_tasks import interface_first
from ....toolkit.charts.chart_style import ChartStyle
from ....toolkit.charts.figure_painter import ROOMY_LINES, TICK_PX, Room, fit_figure, set_font
from ....toolkit.charts.variance_axes import draw_frame, level_labels
from ...charts.chart_curves import ChartCurve
from ...charts.curve_chart import draw_lines, share_range

from matplotlib.artist import Artist  # isort: skip
from matplotlib.backends.backend_agg import FigureCanvasAgg  # isort: skip
from matplotlib.figure import Figure  # isort: skip


Key = tuple[bool, str]
Point = tuple[int, int]
"""A curve's index and a component's."""


@dataclass(frozen=True)
class Chart:
    """All that a chart shows."""

    curves: tuple[ChartCurve, ...]
    max_ratio: float
    logarithmic: bool = True
    hidden: frozenset[Key] = frozenset()


class PaintRequest(NamedTuple):
    """What is to be drawn."""

    chart: Chart
    style: ChartStyle
    room: Room
    marked: int | None = None
    """Index of the curve that stands out."""
    point: Point | None = None


class PaintedPicture(NamedTuple):
    """What was drawn."""

    request: PaintRequest
    pixels: bytes
    """RGBA, row by row."""
    width: int
    height: int
    places: dict[Point, tuple[float, float]]
    """Where the points that can be seen are, in the interface's pixels from the upper left."""
    axes: tuple[float, float, float, float]
    """Left, top, right, bottom of the axes, likewise."""


class ChartPainter:
    """Draws one request after the other, in a thread. It has no part in Qt, and may outlive the widget that asked."""

    def __init__(self) -> None:
        self.artists: list[Artist] = []
        self.axes: Any = None
        self.frames_drawn = self.curves_drawn = 0  # for tests
        self._canvas: Any = None
        self._drawn: PaintRequest | None = None
        self._frame_key: object = None
        self._frame: Any = None  # pixels of the frame
        self._curves: Any = None  # pixels of frame and curves

    @interface_first()
    def draw(self, request: PaintRequest) -> PaintedPicture:
        """As pixels; what is there from the request before is used again."""
        chart, style, room, _, _ = request
        if self._canvas is None:
            self._canvas = FigureCanvasAgg(Figure())
            self.axes = self._canvas.figure.add_axes((0.2, 0.2, 0.7, 0.7))
        levels = len(chart.curves[0].detail) if chart.curves else 0
        limits = share_range(chart.curves, chart.max_ratio, chart.logarithmic)
        frame_key = levels, limits, chart.logarithmic, style, room
        drawn, self._drawn = self._drawn, None  # what fails midway is not there the next time
        if frame_key != self._frame_key:
            self._frame_key, drawn = None, None
            self._draw_frame(levels, limits, request)
            self._frame_key = frame_key
        if drawn is None or drawn[:3] != request[:3]:
            self._draw_curves(request)
        self._canvas.restore_region(self._curves)
        self._draw_mark(request)
        self._drawn = request
        return self._picture(request)

    # layers

    def _draw_frame(self, levels: int, limits: tuple[float, float], request: PaintRequest) -> None:
        chart, style, room, _, _ = request
        figure, axes = self._canvas.figure, self.axes
        self._clear()
        fit_figure(figure, room)
        figure.set_facecolor(style.background)
        draw_frame(axes, levels, style, chart.logarithmic)
        axes.set_ylim(*limits)
        self._arrange(levels, room)
        self._canvas.draw()
        self._frame = self._canvas.copy_from_bbox(figure.bbox)
        self.frames_drawn += 1

    def _draw_curves(self, request: PaintRequest) -> None:
        chart, style, _, _, _ = request
        self._clear()
        self.artists = draw_lines(self.axes, chart.curves, chart.max_ratio, style, chart.hidden)
        self._canvas.restore_region(self._frame)
        for artist in sorted(self.artists, key=Artist.get_zorder):
            self.axes.draw_artist(artist)
        self._curves = self._canvas.copy_from_bbox(self._canvas.figure.bbox)
        self.curves_drawn += 1

    def _draw_mark(self, request: PaintRequest) -> None:
        chart, style, _, marked, point = request
        if marked is None:
            return
        label = chart.curves[marked].label
        line = next((artist for artist in self.artists if artist.get_label() == label), None)
        if line is None:
            return
        width = line.get_linewidth()
        line.set_linewidth(width + 1.6 * style.scale)
        self.axes.draw_artist(line)
        line.set_linewidth(width)
        if point is not None:
            share = chart.curves[point[0]].values[point[1]]
            look = {"markerfacecolor": "none", "markeredgewidth": 1.4, "markersize": 10 * style.scale}
            (ring,) = self.axes.plot([point[1]], [share], marker="o", markeredgecolor=style.text, **look)
            self.axes.draw_artist(ring)
            ring.remove()

    def _clear(self) -> None:
        for artist in self.artists:
            artist.remove()
        self.artists = []

    def _picture(self, request: PaintRequest) -> PaintedPicture:
        chart, ratio = request.chart, request.room.ratio
        pixels = np.asarray(self._canvas.buffer_rgba())
        height, width = pixels.shape[:2]
        points = [
            (index, component)
            for index, curve in enumerate(chart.curves)
            if curve.key not in chart.hidden
            for component, share in enumerate(curve.values)
            if share == share and (share > 0 or not chart.logarithmic)
        ]
        shares = [(component, chart.curves[index].values[component]) for index, component in points]
        places = self.axes.transData.transform(np.array(shares).reshape(-1, 2))
        box = self.axes.bbox
        return PaintedPicture(
            request,
            pixels.tobytes(),
            width,
            height,
            {point: (x / ratio, (height - y) / ratio) for point, (x, y) in zip(points, places.tolist())},
            (box.x0 / ratio, (height - box.y1) / ratio, box.x1 / ratio, (height - box.y0) / ratio),
        )

    # layout

    def _arrange(self, levels: int, room: Room) -> None:
        """Margins for the words around the axes, from the font: matplotlib's own layouts double the time."""
        width, height, line, word = max(room.width, 1), max(room.height, 1), room.line, 1.15 * room.word
        roomy = height > ROOMY_LINES * line
        left = TICK_PX + 5.5 * room.digit + line * (1.3 if roomy else 0.1)
        step = (width - left) / (levels + 1.0)
        in_two_rows = step < 0.6 * word
        right = max(0.5 * line, word / 2 - 0.4 * step)
        top, bottom = 0.6 * line, TICK_PX + line * (2.2 if roomy or in_two_rows else 1.2)
        across, up = max(width - left - right, 1), max(height - bottom - top, 1)
        axes = self.axes
        axes.set_position((left / width, bottom / height, across / width, up / height))
        axes.set_xticks(range(levels + 1), level_labels(levels, in_two_rows))
        axes.xaxis.label.set_visible(roomy and not in_two_rows)  # they would meet
        axes.yaxis.label.set_visible(roomy)
        axes.xaxis.set_label_coords(1, -(TICK_PX + line) / up)  # their own places take a third of the drawing
        axes.yaxis.set_label_coords(-(left - 1.2 * line) / across, 0.5)
        set_font(axes, room)
