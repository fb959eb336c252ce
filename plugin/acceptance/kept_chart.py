"""What a decision without a plan rests on, as a chart: how many metres of seam kept how much."""
from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..toolkit.charts.chart_style import PAPER, ChartStyle
from ..toolkit.charts.figure_files import new_figure
from ..toolkit.translation import filled, tr
from .measure.decision import Decision

_SIZE = (6.2, 3.4)  # inches
_MOST_KEPT = 1.3  # beyond it nothing is of interest


def kept_figure(decision: Decision) -> Figure:
    """The share of the metres that kept less than each value, with the limit."""
    figure = new_figure(*_SIZE)
    _draw_kept(figure.add_subplot(), decision, PAPER)
    return figure


def _draw_kept(axes: Axes, decision: Decision, style: ChartStyle) -> None:
    known = [(one.piece.kept_1, one.piece.length_m) for one in decision.pieces if one.piece.kept_1 is not None]
    if known:
        kept, metres = np.array(sorted(known)).T
        shares = 100 * np.cumsum(metres) / metres.sum()
        axes.step(np.minimum(kept, _MOST_KEPT), shares, where="post", color=style.sources[0], linewidth=2)
    least = decision.rules.least_kept
    axes.axvline(least, color=style.limit, linewidth=1.5, label=filled(tr("least: {least:g}"), least=least))
    share = decision.whole.failed_share
    if share is not None:
        words = filled(tr("failed: {share:.2f} %"), share=100 * share)
        axes.axhline(100 * share, color=style.text, linewidth=1, linestyle=":", label=words)
    axes.set_xlabel(tr("share of detail kept (kept_1)"))
    axes.set_ylabel(tr("metres that kept less (%)"))
    axes.set_xlim(0, _MOST_KEPT)
    axes.set_ylim(0, 102)
    _frame(axes, style)


def _frame(axes: Axes, style: ChartStyle) -> None:
    axes.grid(True, color=style.grid, linewidth=0.8)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    axes.legend(frameon=False, fontsize=8)
