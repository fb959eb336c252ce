"""Curves of a window -> matplotlib axes: the mosaic bold, its sources thin. No pyplot, no Qt."""
from __future__ import annotations

import math
from collections.abc import Collection, Sequence

from matplotlib.artist import Artist
from matplotlib.axes import Axes

from ...toolkit.charts.chart_style import PAPER, ChartStyle, LineStyle, source_look
from ...toolkit.charts.variance_axes import draw_frame
from ...toolkit.translation import tr
from .chart_curves import ChartCurve, significance_limit

COMPOSITE_DASHES = (0, (4.0, 2.0))
_LOWEST_SHARE = 1e-6  # a logarithmic axis goes no further down: what the measurement resolves
_DIGITS = (1, 2, 5)


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
        look = {"color": colour, "linestyle": line, "linewidth": width * style.scale}
        points = {"marker": "o", "markersize": size * style.scale}
        drawn += axes.plot(x, curve.values, **look, **points, zorder=order, label=curve.label)
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
