"""The picture of a window's noise. Imports matplotlib: load it only when a chart is to be seen."""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from typing import NamedTuple

from qgis.PyQt.QtWidgets import QWidget

from ...toolkit.charts.chart_style import ChartStyle
from ...toolkit.desk.painted_chart import ROOMY_LINES, PaintedChart, Room, draw_figure, fit_figure, set_font
from ...toolkit.translation import band_title
from ..charts import draw_noise_clip
from ..measure.band_noise import BandNoise
from ..noise_summary import NO_GROUP, CurveGroup

from matplotlib.axes import Axes  # isort: skip
from matplotlib.backends.backend_agg import FigureCanvasAgg  # isort: skip
from matplotlib.figure import Figure  # isort: skip
from matplotlib.font_manager import FontProperties  # isort: skip

_LARGEST = 0.45  # share of a side that a legend may take from the chart
_FLAT = 2.2  # width over height of a chart that has its legend beside it


class NoiseDrawing(NamedTuple):
    """What is to be drawn."""

    bands: Mapping[str, BandNoise]
    style: ChartStyle
    room: Room
    group: CurveGroup = NO_GROUP


class NoiseChart(PaintedChart):
    """Shows the curves of one window's bands with the rising rule drawn in."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(partial(draw_figure, figure), parent)
        self._bands: Mapping[str, BandNoise] = {}
        self._style: ChartStyle | None = None
        self._group = NO_GROUP

    @property
    def bands(self) -> Mapping[str, BandNoise]:
        """What is asked for."""
        return self._bands

    def show_bands(self, bands: Mapping[str, BandNoise], style: ChartStyle, group: CurveGroup = NO_GROUP) -> None:
        """Draw a window before the range of those like it; nothing happens when it is there already."""
        self._bands, self._style, self._group = bands, style, group
        self._ask()

    def _request(self) -> NoiseDrawing | None:
        if self._style is None:
            return None
        return NoiseDrawing(self._bands, self._style, self._room(), self._group)


def figure(request: NoiseDrawing) -> Figure:
    """The chart; a low one does without what it has no room for."""
    bands, style, room, group = request
    made = Figure()
    FigureCanvasAgg(made)  # which measures words
    fit_figure(made, room)
    made.set_facecolor(style.background)
    axes = made.add_subplot()
    draw_noise_clip(axes, bands, style, group=group)
    is_roomy, is_flat = room.height > ROOMY_LINES * room.line, room.width > _FLAT * room.height
    axes.xaxis.label.set_visible(is_roomy)
    axes.yaxis.label.set_visible(is_roomy)
    font = set_font(axes, room)
    if is_flat:
        across, up = 1 - _add_legend(axes, request, font, "center right", (1,), (_LARGEST, 1.0))[0], 1.0
    else:
        columns = range(len(bands) + 2, 0, -1)
        across, up = 1.0, 1 - _add_legend(axes, request, font, "upper center", columns, (1.0, _LARGEST))[1]
    made.tight_layout(pad=0.4, rect=(0.0, 0.0, across, up))
    return made


def _add_legend(
    axes: Axes, request: NoiseDrawing, font: FontProperties, place: str, columns: Iterable[int],
    most: tuple[float, float],
) -> tuple[float, float]:
    """Where it hides nothing, in as many columns as there is room for; the rule, which is drawn first, comes last.

    Returns the shares of the figure's width and height that it takes; a legend that takes more than ``most`` of them
    is left out.
    """
    titles = {name: band_title(name) for name in request.bands}
    entries = [(handle, titles.get(label, label)) for handle, label in zip(*axes.get_legend_handles_labels())]
    entries.sort(key=lambda entry: entry[1] not in titles.values())
    made, (handles, words) = axes.figure, zip(*entries)
    for count in columns:
        legend = made.legend(
            handles, words, loc=place, ncol=count, prop=font, labelcolor=request.style.text, frameon=False,
            handlelength=1.5, handletextpad=0.5, columnspacing=0.9, borderpad=0.3, borderaxespad=0.0,
        )  # fmt: skip
        box = legend.get_window_extent(made.canvas.get_renderer())
        width, height = box.width / made.bbox.width, box.height / made.bbox.height
        if width <= most[0] and height <= most[1]:
            return width, height
        legend.remove()
    return 0.0, 0.0
