"""The curves of a window in a figure of matplotlib, beside other pictures."""
from __future__ import annotations

from collections.abc import Sequence

from matplotlib.axes import Axes
from seam_inspector.plugin.noise.charts import draw_frame
from seam_inspector.plugin.seams.charts.curves_painter import (
    Chart,
    ChartCurve,
    numbered,
    share_range,
    significance_limit,
)
from seam_inspector.plugin.toolkit.charts.chart_style import PAPER, source_look


def draw_curves(axes: Axes, curves: Sequence[ChartCurve], max_ratio: float) -> None:
    """Mosaic bold, sources thin, the limit of a significant loss at level 1."""
    levels = len(curves[0].detail) if curves else 0
    draw_frame(axes)
    axes.set_xticks(range(levels + 1), [*map(str, range(1, levels + 1)), "background"])
    axes.set_xlim(-0.4, max(levels, 1) + 0.4)
    axes.set_ylim(*share_range(Chart(tuple(curves), max_ratio)))
    limit = significance_limit(curves, max_ratio)
    if limit is not None:
        reach = [-0.25, 0.25]
        axes.fill_between(reach, limit, limit * 1e-9, color=PAPER.limit, alpha=0.15, linewidth=0)
        axes.plot(reach, [limit, limit], color=PAPER.limit, linewidth=2, label="significant loss below")
    for number, curve in sorted(numbered(curves), key=lambda one: one[1].is_mosaic):
        colour, line = source_look(number, PAPER)
        if curve.is_mosaic or curve.is_composite:
            colour, line = PAPER.text, "--" if curve.is_composite else "-"
        width, size, order = (2.6, 5.0, 4) if curve.is_mosaic else (1.2, 3.0, 3)
        axes.plot(
            range(len(curve.values)), curve.values, color=colour, linestyle=line, linewidth=width, marker="o",
            markersize=size, zorder=order, label=curve.label,
        )
