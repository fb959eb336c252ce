"""The frame of a chart of relative variances: levels across, shares up. ``Figure`` and axes only: no pyplot, no Qt."""
from __future__ import annotations

from matplotlib.axes import Axes
from matplotlib.ticker import Locator, NullLocator

from ..translation import formatted, tr
from .chart_style import ChartStyle
from .round_ticks import decade_ticks


def draw_frame(axes: Axes, levels: int, style: ChartStyle) -> None:
    """Scales, ticks, grid and words of a chart without curves."""
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(_ShareLocator())
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
        return decade_ticks(vmin, vmax, room)


def _plain(value: float, _position: int) -> str:
    return formatted(value, "g")
