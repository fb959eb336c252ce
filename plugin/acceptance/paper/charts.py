"""Charts of a decision: where seams failed, and how a plan of sampling decides."""
from __future__ import annotations

from collections.abc import Sequence
from itertools import chain

import numpy as np
from matplotlib import patheffects
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...imagery.errors import printable
from ...imagery.reference_systems import metres_per_unit
from ...toolkit.charts.chart_style import PAPER
from ...toolkit.charts.figure_files import new_figure
from ...toolkit.translation import filled, formatted, shown_number, tr
from ..measure.decision import Decision, Defect, PieceState, PlanOutcome
from ..measure.delivery import extent_of
from ..measure.sampling_risks import acceptance_probability

_SIZE = (6.2, 3.4)  # inches
_MOST_KEPT = 1.3  # beyond it nothing is of interest


def kept_figure(decision: Decision) -> Figure:
    """The share of the metres that kept less than each value, with the limit."""
    figure = new_figure(*_SIZE)
    axes = figure.add_subplot()
    known = [(one.piece.kept_1, one.piece.length_m) for one in decision.pieces if one.piece.kept_1 is not None]
    if known:
        kept, lengths = np.array(sorted(known)).T
        shares = 100 * np.cumsum(lengths) / lengths.sum()
        axes.step(np.minimum(kept, _MOST_KEPT), shares, where="post", color=PAPER.sources[0], linewidth=2)
    least = decision.rules.least_kept
    axes.axvline(least, color=PAPER.limit, linewidth=1.5, label=filled(tr("least: {least:g}"), least=least))
    share = decision.whole.failed_share
    if share is not None:
        words = filled(tr("failed: {share:.2f} %"), share=100 * share)
        axes.axhline(100 * share, color=PAPER.text, linewidth=1, linestyle=":", label=words)
    axes.set_xlabel(tr("share of detail kept (kept_1)"))
    axes.set_ylabel(tr("metres that kept less (%)"))
    axes.set_xlim(0, _MOST_KEPT)
    axes.set_ylim(0, 102)
    axes.grid(True, color=PAPER.grid, linewidth=0.8)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False, fontsize=8)
    return figure


STATE_COLOURS = {PieceState.PASSED: "#57606a", PieceState.NOT_MEASURED: "#56b4e9", PieceState.FAILED: "#d55e00"}
"""In the order in which they are drawn."""
_WIDTHS = {PieceState.PASSED: 0.7, PieceState.NOT_MEASURED: 1.0, PieceState.FAILED: 2.2}
_WIDTH, _MOST_HEIGHT, _LEAST_HEIGHT = 6.7, 6.2, 1.6  # inches on paper
_STRIP = 0.35  # inches: below the map, for scale bar and north
_MARGIN = 0.04  # of the longer side
_FINEST_PT = 0.25  # lines are thinned to it
_MOST_SHEET_NAMES = 60
_NAME_PT, _LETTER_PT = 6.0, 3.6  # a sheet's name, and how wide a letter of it is about
_HALO = [patheffects.withStroke(linewidth=1.6, foreground="white")]
_NAME_COLOUR, _LEAST_LETTERS = "#57606a", 12
_MOST_STEPS = 4000
_CROWDED_NAMES_PT = (45.0, 9.0)  # likewise of sheets
_CROWDED_PT = (18.0, 9.0)  # across and up: numbers of failures nearer to each other than that are left out


def seams_figure(decision: Decision, defects: Sequence[Defect]) -> Figure | None:
    """A sketch map: sheets, seams by what became of them, the numbers of failures. None without seams."""
    if not decision.pieces:
        return None
    outlines = _outlines(decision)
    xmin, ymin, xmax, ymax = extent_of([*(one.piece.vertices for one in decision.pieces), *chain(*outlines.values())])
    metres_x, metres_y = metres_per_unit(decision.delivery.wkt, (ymin + ymax) / 2)
    margin = max((xmax - xmin) * metres_x, (ymax - ymin) * metres_y, 1.0) * _MARGIN
    across, down = (xmax - xmin) * metres_x + 2 * margin, (ymax - ymin) * metres_y + 2 * margin
    height = min(max(_WIDTH * down / across, _LEAST_HEIGHT), _MOST_HEIGHT)
    figure = Figure(figsize=(_WIDTH, height + _STRIP))
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_axis_off()
    scale = min(72 * _WIDTH / across, 72 * height / down)  # points per metre

    def placed(points: np.ndarray) -> np.ndarray:
        middle = np.array([(xmin + xmax) / 2, (ymin + ymax) / 2])
        return (points - middle) * (metres_x * scale, metres_y * scale)

    named: list[np.ndarray] = []
    for name, rings in outlines.items():
        for ring in rings:
            axes.plot(*placed(ring).T, color=PAPER.grid, linewidth=0.8)
        left, _, right, top = extent_of(map(placed, rings))
        corner = np.array([left, top])
        is_free = all((abs(corner - other) > _CROWDED_NAMES_PT).any() for other in named)
        if 1 < len(outlines) <= _MOST_SHEET_NAMES and is_free:
            named.append(corner)
            axes.text(left + 2, top - 2, _short(printable(name), (right - left - 4) / _LETTER_PT), color=_NAME_COLOUR,
                      fontsize=_NAME_PT, ha="left", va="top", parse_math=False, path_effects=_HALO, zorder=3)
    for state, colour in STATE_COLOURS.items():
        lines = [_thinned(placed(one.piece.vertices)) for one in decision.pieces if one.state is state]
        if lines:
            gap = np.full((1, 2), np.nan)
            path = np.concatenate([part for line in lines for part in (line, gap)])
            axes.plot(*path.T, color=colour, linewidth=_WIDTHS[state], solid_capstyle="round")
    taken: list[np.ndarray] = []
    for defect in defects:
        place = placed(np.array([defect.place]))[0]
        if all((abs(place - other) > _CROWDED_PT).any() for other in taken):
            taken.append(place)
            axes.annotate(str(defect.number), place, (3, 3), textcoords="offset points", fontsize=7, fontweight="bold",
                          color=PAPER.text, path_effects=_HALO, zorder=4)
    axes.set_xlim(-36 * _WIDTH, 36 * _WIDTH)
    axes.set_ylim(-36 * height - 72 * _STRIP, 36 * height)
    _draw_scale_bar(axes, scale, -36 * height - 72 * _STRIP)
    return figure


def _outlines(decision: Decision) -> dict[str, list[np.ndarray]]:
    """The closed rings of each sheet: as given, or the box around its seams."""
    rings = {one.name: [*one.rings] for one in decision.delivery.outlines if one.rings}
    boxed: dict[str, list[np.ndarray]] = {}
    for piece in decision.delivery.pieces:
        boxed.setdefault(piece.sheet, []).append(piece.vertices)
    for name in decision.delivery.sheets:
        if name not in rings and name in boxed:
            left, bottom, right, top = extent_of(boxed[name])
            corners = [(left, bottom), (right, bottom), (right, top), (left, top), (left, bottom)]
            rings[name] = [np.array(corners)]
    return rings


def oc_figure(found: PlanOutcome) -> Figure:
    """The operating characteristic of a plan: how likely a delivery is accepted by how good it is."""
    plan, characteristic = found.plan, found.characteristic
    figure = new_figure(6.2, 3.2)
    axes = figure.subplots()
    shares, accepted = _steps(found)
    axes.step(100 * shares, 100 * accepted, where="post", color=PAPER.text, linewidth=1.6)
    aql, quality = float(plan.aql), 100 * characteristic.limiting_quality
    for x, y, colour, words in (
        (aql, 100 * (1 - characteristic.producers_risk), PAPER.sources[2],
         filled(tr("AQL {aql} %: rejected in {risk} % (producer's risk)"),
             aql=_plain(aql), risk=_plain(100 * characteristic.producers_risk))),
        (quality, 100 * characteristic.consumers_risk, PAPER.limit,
         filled(tr("limiting quality {quality} %: accepted in {risk} % (consumer's risk)"),
             quality=_plain(quality), risk=_plain(100 * characteristic.consumers_risk))),
    ):
        axes.plot([x, x, 0], [0, y, y], color=colour, linewidth=0.9, linestyle="--")
        axes.plot([x], [y], "o", color=colour, markersize=5, label=words)
    far = 100 * shares[accepted > 0.002]
    axes.set_xlim(0, max(float(far[-1]) if len(far) else 0.0, 1.3 * quality, 2 * aql))
    axes.set_ylim(0, 102)
    axes.set_xlabel(tr("failed pieces in the delivery (%)"))
    axes.set_ylabel(tr("probability of acceptance (%)"))
    axes.grid(True, color=PAPER.grid)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(fontsize="small", frameon=True, framealpha=0.9, edgecolor="none", loc="upper right")
    return figure


def _steps(found: PlanOutcome) -> tuple[np.ndarray, np.ndarray]:
    """Shares and probabilities: failed pieces are whole ones, so between two shares nothing changes."""
    plan = found.plan
    last = int(np.ceil(max(found.characteristic.nonconforming_shares) * plan.lot_size))
    counts = np.unique(np.linspace(0, last, min(last, _MOST_STEPS) + 1).astype(int))
    shares = counts / plan.lot_size
    return shares, acceptance_probability(plan, shares)


def _plain(value: float) -> str:
    return shown_number(value, 2 if value < 1 else 1)


def _short(name: str, most: float) -> str:
    """A name in so many letters, though not fewer than tell it from others."""
    letters = max(int(most), _LEAST_LETTERS)
    if len(name) <= letters:
        return name
    begin = (letters - 1) // 2
    return name[:begin] + "…" + name[begin + 1 - letters :]


def _thinned(path: np.ndarray) -> np.ndarray:
    """Vertices of which each lies a little farther on; (n, 2) points on paper."""
    steps = np.floor(np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(path, axis=0).T))]) / (4 * _FINEST_PT))
    kept = np.concatenate([[True], np.diff(steps) > 0])
    kept[-1] = True
    return path[kept]


def _draw_scale_bar(axes: Axes, scale: float, foot: float) -> None:
    """A round length in the lower left corner, north up in the lower right one; ``foot``: of the strip for them."""
    most = 0.25 * 72 * _WIDTH / scale
    decade = 10.0 ** np.floor(np.log10(most))
    metres = max(digit * decade for digit in (1, 2, 5) if digit * decade <= most)
    left, bottom = -36 * _WIDTH + 6, foot + 6
    axes.plot([left, left + metres * scale], [bottom, bottom], color=PAPER.text, linewidth=2.5, solid_capstyle="butt")
    words = formatted(metres / 1000, "g") + " km" if metres >= 1000 else formatted(metres, "g") + " m"
    axes.text(left, bottom + 4, words, fontsize=7, color=PAPER.text)
    right = 36 * _WIDTH - 10
    axes.annotate(tr("N"), (right, bottom + 22), (right, bottom - 4), ha="center", fontsize=8, color=PAPER.text,
                  arrowprops={"arrowstyle": "-|>", "color": PAPER.text, "linewidth": 1})
