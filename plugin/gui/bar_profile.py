"""The profile of one bar group as a chart. Imports matplotlib: load it only when a chart is to be seen."""
from __future__ import annotations

from collections.abc import Sequence

from qgis.PyQt.QtWidgets import QSizePolicy, QWidget

from ..adapters.bar_charts import draw_profiles
from ..adapters.text import tr
from ..core.resolution.groups import GroupResult
from .painted_chart import chart_style

# after qgis.PyQt, whose binding matplotlib then takes
from matplotlib.backends.backend_qtagg import FigureCanvasQTAgg  # isort: skip
from matplotlib.figure import Figure  # isort: skip


class BarProfile(FigureCanvasQTAgg):
    """Shows the profiles of a line by band, with their bars and the threshold of the gaps between them."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(Figure(layout="constrained"))
        self.setParent(parent)
        self._axes = self.figure.add_subplot()
        line = self.fontMetrics().height()
        self.setMinimumSize(11 * line, 8 * line)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.show_results([], 0.5)

    @property
    def bands_shown(self) -> int:
        """How many profiles are to be seen."""
        return len({line.get_label() for line in self._axes.get_lines() if not line.get_label().startswith("_")})

    def show_results(self, results: Sequence[GroupResult], criterion: float) -> None:
        """Draw what a line showed; an empty frame where nothing was measured."""
        style = chart_style(self)
        self.figure.set_facecolor(style.background)
        self._axes.clear()
        readings = {result.band: result.reading for result in results if result.reading is not None}
        draw_profiles(self._axes, readings, criterion, style)
        self._axes.tick_params(labelsize=8)
        self._axes.set_xlabel(tr("along the line, px"), fontsize=8, color=style.text)
        self._axes.set_ylabel("DN", fontsize=8, color=style.text)
        self.draw_idle()
