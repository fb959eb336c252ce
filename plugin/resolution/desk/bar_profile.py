"""The profile of one bar group as a chart. Imports matplotlib: load it only when a chart is to be seen."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial

from qgis.PyQt.QtWidgets import QWidget

from ...toolkit.charts.chart_style import ChartStyle
from ...toolkit.desk.painted_chart import PaintedChart, Room, draw_figure, fit_figure, set_font
from ...toolkit.desk.theme import chart_style
from ...toolkit.translation import tr
from ..charts import BAND_COLOURS, draw_profiles
from ..measure.bar_groups import GroupResult
from ..measure.bars import BarReading

from matplotlib.figure import Figure  # isort: skip


@dataclass(frozen=True)
class ProfileDrawing:
    """What is to be drawn."""

    number: int
    """Number of the readings: others have another one."""
    readings: Mapping[str, BarReading] = field(compare=False)
    criterion: float
    style: ChartStyle
    room: Room


class BarProfile(PaintedChart):
    """Shows the profiles of a line by band, with their bars and the threshold of the gaps between them."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(partial(draw_figure, figure), parent)
        self._number = 0
        self._readings: Mapping[str, BarReading] = {}
        self._criterion = 0.0

    @property
    def bands_shown(self) -> int:
        """How many profiles are to be seen."""
        return len(self._readings)

    def show_results(self, results: Sequence[GroupResult], criterion: float) -> None:
        """Draw what a line showed; nothing where nothing was measured."""
        self._number += 1
        self._readings = {result.band: result.reading for result in results if result.reading is not None}
        self._criterion = criterion
        self._ask()

    def _request(self) -> ProfileDrawing:
        return ProfileDrawing(self._number, self._readings, self._criterion, chart_style(self), self._room())


def figure(request: ProfileDrawing) -> Figure:
    """The chart; an empty sheet where there is no profile."""
    made = Figure(facecolor=request.style.background)
    fit_figure(made, request.room)
    if not request.readings:
        return made
    axes = made.add_subplot()
    draw_profiles(axes, request.readings, request.criterion, request.style)
    axes.set_xlabel(tr("along the line, px"), color=request.style.text)
    axes.set_ylabel("DN", color=request.style.text)
    font = set_font(axes, request.room)
    if len(request.readings) > 1 and not set(request.readings) <= set(BAND_COLOURS):  # colours that don't name a band
        above = {"loc": "lower right", "bbox_to_anchor": (1, 1), "ncol": len(request.readings), "borderaxespad": 0}
        axes.legend(frameon=False, labelcolor=request.style.text, prop=font, **above)
    made.tight_layout(pad=0.4)
    return made
