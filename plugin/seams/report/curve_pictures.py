"""The curves of windows as small SVG pictures for a report: one frame, drawn into again and again."""
from __future__ import annotations

import re
from collections.abc import Sequence

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...toolkit.charts.chart_style import PAPER, source_look
from ...toolkit.charts.figure_files import svg_text
from ...toolkit.charts.variance_axes import draw_frame, level_labels
from ...toolkit.translation import filled, tr
from ..charts.chart_curves import ChartCurve
from ..charts.curve_chart import draw_lines, share_range
from ..measure.window_records import COMPOSITE, CurveRecord

_WIDTH, _HEIGHT = 320 / 96, 260 / 96  # inches: as wide as a clip
_PLACE = (0.19, 0.16, 0.75, 0.82)  # of the axes in the picture: left, bottom, width, height
_LETTERS = 8.0  # points
_LEVELS_IN_A_ROW = 5  # with more there is no room beside them for the word below the background


class CurveDrawer:
    """Draws the curves of one window after another.

    matplotlib takes four times as long for scales and grid as for curves, and few of them differ: frames are kept
    as SVG, and the curves drawn over them without one.
    """

    def __init__(self, max_ratio: float) -> None:
        self._max_ratio = max_ratio
        self._axes: dict[int, Axes] = {}
        self._frames: dict[tuple[int, float, float], str] = {}

    def draw(self, curves: Sequence[CurveRecord]) -> str:
        """The curves as SVG, the composite dashed; all of the same number of levels."""
        shown = [chart_curve(curve) for curve in curves if curve.role != COMPOSITE]
        low, high = share_range(shown, self._max_ratio, logarithmic=True)
        axes, frame = self._frame(len(curves[0].detail), low, high)
        drawn: list[Artist] = list(draw_lines(axes, shown, self._max_ratio, PAPER, ()))
        for composite in (chart_curve(curve) for curve in curves if curve.role == COMPOSITE):
            look = {"color": PAPER.text, "linewidth": 1.2, "linestyle": "--"}
            drawn += axes.plot(range(len(composite.values)), composite.values, **look)
        lines = _slim(svg_text(axes.figure))
        for artist in drawn:
            artist.remove()
        return frame.replace("</svg>", lines[lines.index(">") + 1 :])

    def _frame(self, levels: int, low: float, high: float) -> tuple[Axes, str]:
        """Axes without anything on them, and the picture of what stands around and behind the curves."""
        if levels not in self._axes:
            axes = Figure(figsize=(_WIDTH, _HEIGHT)).add_axes(_PLACE)
            draw_frame(axes, levels, PAPER, logarithmic=True)
            if levels > _LEVELS_IN_A_ROW:
                axes.set_xticks(range(levels + 1), level_labels(levels, in_two_rows=True))
                axes.set_xlabel("")
            axes.tick_params(labelsize=_LETTERS)
            axes.xaxis.label.set_size(_LETTERS)
            axes.yaxis.label.set_size(_LETTERS)
            axes.yaxis.set_label_coords(-0.2, 0.5)  # the same whatever the numbers are, so that it is never cut off
            self._axes[levels] = axes
        axes = self._axes[levels]
        axes.set_ylim(low, high)
        if (levels, low, high) not in self._frames:
            axes.figure.patch.set_visible(True)
            axes.set_axis_on()
            self._frames[levels, low, high] = _slim(svg_text(axes.figure))
            axes.figure.patch.set_visible(False)
            axes.set_axis_off()
        return axes, self._frames[levels, low, high]


def chart_curve(curve: CurveRecord) -> ChartCurve:
    """A curve as charts take it."""
    return ChartCurve(curve.raster, curve.role == "mosaic", curve.detail, curve.background)


def curve_legend(curves: Sequence[CurveRecord]) -> list[tuple[str, str]]:
    """Colours and names of the curves as ``CurveDrawer`` draws them."""
    places = iter(range(len(curves)))
    entries = []
    for curve in curves:
        if curve.role == "source":
            entries.append((source_look(next(places), PAPER)[0], curve.raster))
        elif curve.role == COMPOSITE:
            entries.append((PAPER.text, tr("hard-cut composite (dashed)")))
        else:
            entries.append((PAPER.text, filled(tr("{name} (mosaic, bold)"), name=curve.raster)))
    return [*entries, (PAPER.limit, tr("significant by the paper's rule below"))]


def _slim(svg: str) -> str:
    """Without what no reader sees: a third smaller."""
    body = re.sub(r"<metadata>.*?</metadata>|<!--.*?-->", "", svg[svg.index("<svg") :], flags=re.DOTALL)
    return re.sub(r"\s*\n\s*", " ", body).replace("> <", "><")
