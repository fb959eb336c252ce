"""The chart of a failure: what its worst piece kept by distance from the seam."""
from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from ...toolkit.charts.chart_style import PAPER
from ...toolkit.charts.figure_files import new_figure
from ...toolkit.translation import formatted, tr
from ..measure.delivery import DeliveredPiece

_MOST_KEPT = 1.3  # beyond it nothing is of interest
_PROFILE_SIZE = (2.2, 1.75)  # inches: beside the pictures of a failure


def profile_figure(piece: DeliveredPiece, least_kept: float) -> Figure:
    """What a piece kept by distance from its seam, as its scan wrote it: the judged strip, the curve, the limit."""
    strip, *steps = piece.profile
    figure = new_figure(*_PROFILE_SIZE)
    axes = figure.add_subplot()
    axes.axvspan(0, strip.far_m, color=PAPER.grid, linewidth=0)
    axes.axhline(least_kept, color=PAPER.limit, linewidth=1)
    axes.plot(*np.array([(x, step.kept) for step in steps for x in (step.near_m, step.far_m)]).reshape(-1, 2).T,
              color=PAPER.sources[0], linewidth=1.2)
    axes.plot([0, strip.far_m], [strip.kept] * 2, color=PAPER.text, linewidth=2.5, solid_capstyle="butt")
    farthest = max((step.far_m for step in steps), default=strip.far_m)
    axes.set_xscale("function", functions=(lambda x: np.sqrt(np.maximum(x, 0)), np.square))  # narrow steps matter most
    axes.set_xlim(0, farthest)
    axes.set_xticks([strip.far_m, farthest / 4, farthest])
    axes.xaxis.set_major_formatter(lambda x, _: formatted(x, ".2g"))
    axes.minorticks_off()
    axes.set_ylim(0, max(_MOST_KEPT, *(step.kept for step in piece.profile)))
    axes.set_xlabel(tr("distance from the seam (m)"), fontsize=6.5)
    axes.tick_params(labelsize=6.5)
    axes.spines[["top", "right"]].set_visible(False)
    return figure
