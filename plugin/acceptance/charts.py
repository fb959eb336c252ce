"""The risk of a decision, or what it rests on, as a chart."""
from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..toolkit.charts.chart_style import PAPER, ChartStyle
from ..toolkit.charts.figure_files import new_figure
from ..toolkit.translation import tr
from .measure.decision import Decision, PlanOutcome
from .measure.sampling.characteristic import CONSUMERS_RISK

_SIZE = (6.2, 3.4)  # inches
_MOST_KEPT = 1.3  # beyond it nothing is of interest


def decision_figure(decision: Decision) -> Figure:
    """The operating characteristic of the plan; without one how many metres kept how much."""
    figure = new_figure(*_SIZE)
    axes = figure.add_subplot()
    if decision.plan is not None:
        _draw_characteristic(axes, decision.plan, PAPER)
    else:
        _draw_kept(axes, decision, PAPER)
    return figure


def _draw_characteristic(axes: Axes, outcome: PlanOutcome, style: ChartStyle) -> None:
    plan, curve = outcome.plan, outcome.characteristic
    shares = 100 * np.array(curve.nonconforming_shares)
    axes.plot(shares, 100 * np.array(curve.accepted), color=style.sources[0], linewidth=2)
    marks = [
        (plan.aql, 100 * (1 - curve.producers_risk), tr("AQL {aql:g} %: accepted with {share:.1f} %")),
        (100 * curve.limiting_quality, 100 * CONSUMERS_RISK, tr("{aql:.1f} % failing: accepted with {share:.0f} %")),
    ]
    for (x, y, words), shape in zip(marks, "os"):
        axes.plot([x], [y], shape, color=style.limit, markersize=7, label=words.format(aql=x, share=y))
    if outcome.inspected:
        found = 100 * outcome.nonconforming / outcome.inspected
        words = tr("found in the sample: {share:.1f} %").format(share=found)
        axes.axvline(found, color=style.text, linewidth=1, linestyle=":", label=words)
    axes.set_title(
        tr("{size} of {lot} pieces inspected, accepted up to {number} failing").format(
            size=plan.sample_size, lot=plan.lot_size, number=plan.rejection_number - 1
        ),
        fontsize=10,
    )
    axes.set_xlabel(tr("failing pieces in the lot (%)"))
    axes.set_ylabel(tr("lots accepted (%)"))
    axes.set_xlim(0, max(shares[-1], 1e-6))
    axes.set_ylim(0, 102)
    _frame(axes, style)


def _draw_kept(axes: Axes, decision: Decision, style: ChartStyle) -> None:
    known = [(one.piece.kept_1, one.piece.length_m) for one in decision.pieces if one.piece.kept_1 is not None]
    if known:
        kept, metres = np.array(sorted(known)).T
        shares = 100 * np.cumsum(metres) / metres.sum()
        axes.step(np.minimum(kept, _MOST_KEPT), shares, where="post", color=style.sources[0], linewidth=2)
    least = decision.rules.least_kept
    axes.axvline(least, color=style.limit, linewidth=1.5, label=tr("least: {least:g}").format(least=least))
    share = decision.whole.failed_share
    if share is not None:
        words = tr("failed: {share:.2f} %").format(share=100 * share)
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
