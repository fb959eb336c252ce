"""Curves -> matplotlib figures. ``Figure`` and axes only: no pyplot, no Qt."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import LogLocator, NullLocator

from .text import tr

MOSAIC_COLOUR = "#111111"
SOURCE_COLOURS = ("#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00")  # Okabe and Ito, for all eyes
LIMIT_COLOUR = "#b00020"


@dataclass(frozen=True)
class ChartCurve:
    """One raster's line in a chart."""

    label: str
    """File name without its folder."""
    is_mosaic: bool
    detail: tuple[float, ...]
    """Relative variance at levels 1..R."""
    background: float


def draw_curves(axes: Axes, curves: Sequence[ChartCurve], max_ratio: float) -> None:
    """The curves of one window and band: mosaic bold, sources thin, the limit of a significant loss at level 1."""
    colours = iter(SOURCE_COLOURS * (1 + len(curves) // len(SOURCE_COLOURS)))
    for curve in sorted(curves, key=lambda curve: curve.is_mosaic):
        style = (
            {"color": MOSAIC_COLOUR, "linewidth": 2.6, "marker": "o", "markersize": 5, "zorder": 3}
            if curve.is_mosaic
            else {"color": next(colours), "linewidth": 1.2, "marker": "o", "markersize": 3}
        )
        axes.plot(range(len(curve.detail) + 1), [*curve.detail, curve.background], label=curve.label, **style)
    sources = [curve for curve in curves if not curve.is_mosaic]
    if sources:
        limit = max_ratio * min(curve.detail[0] for curve in sources)
        axes.plot([-0.25, 0.25], [limit, limit], color=LIMIT_COLOUR, linewidth=2, label=tr("significant loss below"))
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(_plain)
    levels = len(curves[0].detail) if curves else 0
    axes.set_xticks(np.arange(levels + 1), [*(str(level) for level in range(1, levels + 1)), tr("background")])
    axes.set_xlabel(tr("level"))
    axes.set_ylabel(tr("relative variance"))
    axes.grid(True, which="major", color="#dddddd", linewidth=0.8)
    axes.spines[["top", "right"]].set_visible(False)


def _plain(value: float, _position: int) -> str:
    return f"{value:g}"
