"""Curves -> matplotlib figures. ``Figure`` and axes only: no pyplot, no Qt."""
from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from typing import Union

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.ticker import Locator, MaxNLocator, NullLocator

from ..translation import tr
from .variance_curves import ChartCurve, significance_limit

__all__ = [
    "BAND_COLOURS",
    "DARK",
    "PAPER",
    "ChartCurve",
    "ChartStyle",
    "curve_look",
    "draw_curves",
    "draw_frame",
    "draw_lines",
    "level_labels",
    "numbered",
    "share_range",
    "source_look",
]

BAND_COLOURS = {"red": "#d62728", "green": "#2ca02c", "blue": "#1f77b4", "nir": "#8c564b"}
"""Of bands that are drawn together."""
COMPOSITE_DASHES = (0, (4.0, 2.0))
_LINE_STYLES = ("-", "--", ":", "-.")  # the next one when the colours are used up
_LOWEST_SHARE = 1e-6  # a logarithmic axis goes no further down: what the measurement resolves
_DIGITS = (1, 2, 5)


@dataclass(frozen=True)
class ChartStyle:
    """Colours of a chart, and how heavy its lines are."""

    text: str
    """Of words, axes and the mosaic's curve."""
    background: str
    grid: str
    limit: str
    sources: tuple[str, ...]
    scale: float = 1.0
    """Factor on the widths of lines and the sizes of points."""


PAPER = ChartStyle(
    text="#111111",
    background="#ffffff",
    grid="#dddddd",
    limit="#b00020",
    sources=("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"),  # Okabe and Ito, for all eyes
)
DARK = ChartStyle(
    text="#eeeeee",
    background="#232629",
    grid="#454a4f",
    limit="#ff6b6b",
    sources=("#56b4e9", "#e69f00", "#009e73", "#cc79a7", "#f0e442", "#d55e00"),  # theirs that show on black
)


LineStyle = Union[str, tuple[int, tuple[float, ...]]]
"""As matplotlib takes it: a word, or an offset with lengths of dashes and gaps in widths of the line."""


def source_look(number: int, style: ChartStyle) -> tuple[str, str]:
    """Colour and line style of a source."""
    count = len(style.sources)
    return style.sources[number % count], _LINE_STYLES[number // count % len(_LINE_STYLES)]


def curve_look(curve: ChartCurve, number: int, style: ChartStyle) -> tuple[str, LineStyle]:
    """Colour and line style of a curve; ``number`` counts the sources, for one that has no colour of its own."""
    if curve.is_mosaic:
        return style.text, "-"
    if curve.is_composite:
        return style.text, COMPOSITE_DASHES
    return source_look(number if curve.colour is None else curve.colour, style)


def numbered(curves: Sequence[ChartCurve]) -> list[tuple[int, ChartCurve]]:
    """The curves with their numbers among the sources."""
    sources = [curve for curve in curves if not (curve.is_mosaic or curve.is_composite)]
    places = {curve.key: number for number, curve in enumerate(sources)}
    return [(places.get(curve.key, 0), curve) for curve in curves]


def draw_curves(
    axes: Axes,
    curves: Sequence[ChartCurve],
    max_ratio: float,
    style: ChartStyle = PAPER,
    logarithmic: bool = True,
    hidden: Collection[tuple[bool, str]] = (),
) -> None:
    """The curves of one band: mosaic bold, sources thin, the limit of a significant loss at level 1.

    Means come with their range. ``hidden``: keys of curves that are not drawn, but count for limit and scale.
    """
    draw_frame(axes, len(curves[0].detail) if curves else 0, style, logarithmic)
    axes.set_ylim(*share_range(curves, max_ratio, logarithmic))
    draw_lines(axes, curves, max_ratio, style, hidden)


def draw_frame(axes: Axes, levels: int, style: ChartStyle, logarithmic: bool) -> None:
    """Scales, ticks, grid and words of a chart without curves."""
    axes.set_yscale("log" if logarithmic else "linear")
    axes.yaxis.set_major_locator(_ShareLocator() if logarithmic else MaxNLocator(6, min_n_ticks=3))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(_plain)
    axes.set_xticks(np.arange(levels + 1), level_labels(levels))
    axes.set_xlim(-0.4, max(levels, 1) + 0.4)
    axes.set_xlabel(tr("level"), color=style.text)
    axes.set_ylabel(tr("relative variance"), color=style.text)
    axes.tick_params(colors=style.text)
    axes.set_facecolor(style.background)
    axes.set_axisbelow(True)
    axes.grid(True, which="major", color=style.grid, linewidth=0.8)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["bottom", "left"]].set_color(style.text)


def level_labels(levels: int, in_two_rows: bool = False) -> list[str]:
    """What stands below the components; the long word in a row of its own where it would not fit."""
    return [*(str(level) for level in range(1, levels + 1)), "\n" * in_two_rows + tr("background")]


def draw_lines(
    axes: Axes, curves: Sequence[ChartCurve], max_ratio: float, style: ChartStyle, hidden: Collection[tuple[bool, str]]
) -> list[Artist]:
    """What ``draw_curves`` draws into the frame."""
    drawn: list[Artist] = []
    limit = significance_limit(curves, max_ratio)
    if limit is not None:
        reach = [-0.25, 0.25]
        drawn.append(axes.fill_between(reach, limit, limit * 1e-9, color=style.limit, alpha=0.15, linewidth=0))
        label = tr("significant loss below")
        drawn += axes.plot(reach, [limit, limit], color=style.limit, linewidth=2 * style.scale, label=label)
    for number, curve in sorted(numbered(curves), key=lambda one: one[1].is_mosaic):
        if curve.key in hidden:
            continue
        colour, line = curve_look(curve, number, style)
        width, size, order = (2.6, 5.0, 4) if curve.is_mosaic else (1.2, 3.0, 3)
        x = range(len(curve.values))
        if curve.spread:
            low, high = zip(*curve.spread)
            drawn.append(axes.fill_between(x, low, high, color=colour, alpha=0.2, linewidth=0, zorder=order - 2))
        drawn += axes.plot(
            x,
            curve.values,
            color=colour,
            linestyle=line,
            linewidth=width * style.scale,
            marker="o",
            markersize=size * style.scale,
            zorder=order,
            label=curve.label,
        )
    return drawn


def share_range(curves: Sequence[ChartCurve], max_ratio: float, logarithmic: bool) -> tuple[float, float]:
    """Limits of the axis, rounded so that they seldom change from window to window."""
    shares = [share for curve in curves for share in curve.values]
    shares += [share for curve in curves for ends in curve.spread for share in ends]
    shares.append(significance_limit(curves, max_ratio) or math.nan)
    positive = [share for share in shares if share > 0]
    if not logarithmic:
        return 0, 1.05 * math.ceil(10 * max(positive, default=1)) / 10
    lowest = max(min(positive, default=0.01) * 0.9, _LOWEST_SHARE)
    decade = 10.0 ** math.floor(math.log10(lowest))
    return decade * max(digit for digit in _DIGITS if digit * decade <= lowest * (1 + 1e-9)), 1.25


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
    return f"{value:g}"
