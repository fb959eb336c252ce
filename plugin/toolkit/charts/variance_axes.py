"""The frame of a chart of relative variances: levels across, shares up. ``Figure`` and axes only: no pyplot, no Qt."""
from __future__ import annotations

import math

from matplotlib.axes import Axes
from matplotlib.ticker import Locator, MaxNLocator, NullLocator

from ..translation import formatted, tr
from .chart_style import ChartStyle


def draw_frame(axes: Axes, levels: int, style: ChartStyle, logarithmic: bool) -> None:
    """Scales, ticks, grid and words of a chart without curves."""
    axes.set_yscale("log" if logarithmic else "linear")
    axes.yaxis.set_major_locator(_ShareLocator() if logarithmic else MaxNLocator(6, min_n_ticks=3))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(_plain)
    axes.set_xticks(range(levels + 1), [*map(str, range(1, levels + 1)), tr("background")])
    axes.set_xlim(-0.4, max(levels, 1) + 0.4)
    axes.set_xlabel(tr("level"), color=style.text, loc="right")  # a long word in a narrow chart is not cut off there
    axes.set_ylabel(tr("relative variance"), color=style.text)
    axes.tick_params(colors=style.text)
    axes.set_facecolor(style.background)
    axes.set_axisbelow(True)
    axes.grid(True, which="major", color=style.grid, linewidth=0.8)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["bottom", "left"]].set_color(style.text)


class _ShareLocator(Locator):
    """1, 2, 5, 10, or fewer, as many as there is room for. (matplotlib's own looks at the decades only.)"""

    def __call__(self) -> list[float]:
        return self.tick_values(*self.axis.get_view_interval())

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        room = max(int(1.3 * self.axis.get_tick_space()), 2)  # labels may stand closer than matplotlib has them
        first, last = math.floor(math.log10(vmin)), math.ceil(math.log10(vmax))
        ticks: list[float] = []
        for digits, step in (((1, 2, 5), 1), ((1, 3), 1), ((1,), 1), ((1,), 2), ((1,), 3)):
            shares = (digit * 10.0**decade for decade in range(last, first - 1, -step) for digit in digits)
            ticks = sorted(share for share in shares if vmin <= share <= vmax)
            if len(ticks) <= room:
                break
        return ticks


def _plain(value: float, _position: int) -> str:
    return formatted(value, "g")
