"""Charts of random noise: the curves of one clip with the rising rule, and the ranges of whole groups."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import Locator, NullLocator

from ..imagery.errors import printable
from ..imagery.limits import LUMINANCE, judged_band
from ..toolkit.charts.chart_style import PAPER, band_colour, decade_ticks, round_below
from ..toolkit.charts.figure_files import new_figure
from ..toolkit.translation import band_title, filled, formatted, tr
from .measure.band_noise import BandNoise, noisiest_band
from .measure.group_noise import ClipNoise
from .noise_summary import NoiseGroup, class_title, compared_curve, noise_groups

_LINES = {1: "-", 2: "--"}
_HEADROOM = 1.25
MAX_LEGEND = 16  # lines
MAX_PANELS = 8  # classes of windows that a chart shows; the report's table has all
MAX_TITLE = 40  # characters of a name


def draw_noise(axes: Axes, measured: Mapping[str, BandNoise], line: str = "-", label: str = "") -> None:
    """The curves of one clip by band, the judged one (the noisiest) bold; see ``draw_rule``."""
    bold = noisiest_band(measured) if measured else ""
    for place, (band, noise) in enumerate(measured.items()):
        if noise.curve.variance == 0:
            continue
        colour = band_colour(band, place, band in (LUMINANCE, bold))
        detail = noise.curve.detail
        width, size, order = (2.4, 5, 4) if band == bold else (1.3, 3, 3)
        axes.plot(
            range(1, len(detail) + 1), detail, color=colour, linestyle=line, linewidth=width,
            marker="o", markersize=size, zorder=order, label=f"{label} {band_title(band)}".strip(),
        )


def draw_rule(axes: Axes, detail: Sequence[float]) -> None:
    """The rising rule of a curve: where each level has to stay out of for the noise to be low."""
    for level, finer in enumerate(detail[:-1], 2):
        reach = [level - 0.22, level + 0.22]
        axes.fill_between(reach, finer, finer * 1e-9, color=PAPER.limit, alpha=0.13, linewidth=0)
        label = tr("bold curve in the red: noise") if level == 2 else None
        axes.plot(reach, [finer, finer], color=PAPER.limit, linewidth=1.6, label=label)


def draw_group(axes: Axes, curves: Sequence[Sequence[float]], group: int, label: str) -> None:
    """The range of a group's curves as a band, with its mean line, in the group's colour."""
    values = np.array(curves)
    levels = range(1, values.shape[1] + 1)
    colour = PAPER.sources[(group - 1) % len(PAPER.sources)]
    low, high = values.min(axis=0), values.max(axis=0)
    band = axes.fill_between(levels, low, high, facecolor=colour, alpha=0.25, linewidth=0, zorder=2)
    if group == 2:
        band.set(hatch="////", edgecolor=colour)
    axes.plot(
        levels, values.mean(axis=0), color=colour, linewidth=2.6, linestyle=_LINES.get(group, "-"),
        marker="o", zorder=4, label=label,
    )


def noise_frame(axes: Axes, levels: int, curves: Sequence[Sequence[float]]) -> None:
    """Scales, ticks, grid and words of a chart of levels without background, for curves that will be drawn."""
    draw_frame(axes)
    axes.set_xticks(range(1, levels + 1), [str(level) for level in range(1, levels + 1)])
    axes.set_xlim(0.6, max(levels, 1) + 0.4)
    shares = [share for curve in curves for share in curve if share > 0]
    if shares:
        axes.set_ylim(round_below(min(shares)) * 0.8, max(shares) * _HEADROOM)


def noise_figure(results: Sequence[ClipNoise], field: str = "") -> Figure | None:
    """The range of each group with its mean line (Pyka 2009, figure 3), a panel for each class of windows, and last the
    bands of one window (figure 4), dashed those of the second group; None where nothing was measured.

    ``field``: what the windows are grouped by.
    """
    panels = _panels(results)
    if not panels:
        return None
    count = len(panels) + 1
    columns = 2 if count < 5 else 3
    rows = math.ceil(count / columns)
    figure = new_figure(5 * columns, 5.2 * rows)
    places = iter(figure.subplots(rows, columns).flat)
    curves = [curve for groups in panels.values() for group in groups for curve in group.curves]
    for window_class, groups in panels.items():
        axes = next(places)
        noise_frame(axes, len(curves[0]), curves)
        for group in groups:
            draw_group(axes, group.curves, group.group, _range_words(group))
        title = filled(tr("{field}: {value}"), field=field, value=class_title(window_class)) if field else (
            filled(tr("All windows, {band}"), band=band_title(judged_band(example(results)[0].bands)))
        )
        axes.set_title(shown_title(title), fontsize="medium", wrap=True)
        _legend(axes, 1)
    _draw_example(next(places), results)
    for spare in places:
        spare.set_visible(False)
    return figure


def _panels(results: Sequence[ClipNoise]) -> dict[str | None, list[NoiseGroup]]:
    """The groups with a curve by class of windows; of many classes those with the most windows."""
    panels: dict[str | None, list[NoiseGroup]] = {}
    for group in noise_groups(results):
        if group.curves:
            panels.setdefault(group.window_class, []).append(group)
    sizes = {window_class: max(group.windows for group in groups) for window_class, groups in panels.items()}
    largest = sorted(panels, key=lambda window_class: -sizes[window_class])[:MAX_PANELS]
    return {window_class: groups for window_class, groups in panels.items() if window_class in largest}


def _range_words(group: NoiseGroup) -> str:
    if group.windows == 1:
        return shown_title(group.name) or tr("1 window")
    words = tr("{name}: mean and range of {count} windows") if group.name else tr("mean and range of {count} windows")
    return filled(words, name=shown_title(group.name), count=group.windows)


def _draw_example(axes: Axes, results: Sequence[ClipNoise]) -> None:
    """The bands of one window."""
    shown = example(results)
    first = shown[0]
    curves = [noise.curve.detail for result in shown for noise in result.bands.values() if noise.curve.variance > 0]
    noise_frame(axes, len(curves[0]), curves)
    if len(shown) == 1:
        draw_rule(axes, first.bands[noisiest_band(first.bands)].curve.detail)
    for result in shown:
        member = result.part.member
        label = f"{shown_title(member.group_name)}:" if len(shown) > 1 else ""
        draw_noise(axes, result.bands, line=_LINES[member.group], label=label)
    names = " / ".join(shown_title(result.part.member.image.ref.name) for result in shown)
    axes.set_title(filled(tr("Window {window}: {names}"), window=first.window_id, names=names), fontsize="medium",
                   wrap=True)
    _legend(axes, 2)


def shown_title(name: str) -> str:
    """A user's word as a chart shows it: none of it is a formula, and not all of a long one."""
    cut = name if len(name) <= MAX_TITLE else f"{name[: MAX_TITLE - 3]}..."
    return printable(cut).replace("$", "\\$").lstrip("_")


def _legend(axes: Axes, columns: int) -> None:
    """Below the chart, where it hides nothing; of very many lines the first, for the chart has to keep its room."""
    lines, names = (each[:MAX_LEGEND] for each in axes.get_legend_handles_labels())
    axes.legend(
        lines, names, fontsize="small", frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.13), ncol=columns,
        handlelength=3,
    )


def example(results: Sequence[ClipNoise]) -> list[ClipNoise]:
    """The window whose bands are shown: of group 1 (paired where any is) the one with the median noise, with its
    partner of group 2."""
    measured = [result for result in results if compared_curve(result) is not None]
    first = min(result.part.member.group for result in measured)
    candidates = [result for result in measured if result.part.member.group == first]
    candidates = [result for result in candidates if result.paired] or candidates
    candidates.sort(key=lambda result: result.bands[noisiest_band(result.bands)].sigma or 0.0)
    shown = candidates[len(candidates) // 2]
    same = [result for result in measured if result.window_id == shown.window_id and shown.paired]
    return [shown, *[result for result in same if result.part.member.group != first][:1]]


def draw_frame(axes: Axes) -> None:
    """Scales, ticks, grid and words of a chart of relative variances without curves: levels across, shares up."""
    axes.set_yscale("log")
    axes.yaxis.set_major_locator(_ShareLocator())
    axes.yaxis.set_minor_locator(NullLocator())
    axes.yaxis.set_major_formatter(_plain)
    axes.set_xlabel(tr("level"), color=PAPER.text, loc="right")  # a long word in a narrow chart is not cut off there
    axes.set_ylabel(tr("relative variance"), color=PAPER.text)
    axes.tick_params(colors=PAPER.text)
    axes.set_facecolor(PAPER.background)
    axes.set_axisbelow(True)
    axes.grid(True, which="major", color=PAPER.grid, linewidth=0.8)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["bottom", "left"]].set_color(PAPER.text)


class _ShareLocator(Locator):
    """1, 2, 5, 10, or fewer, as many as there is room for. (matplotlib's own looks at the decades only.)"""

    def __call__(self) -> list[float]:
        return self.tick_values(*self.axis.get_view_interval())

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        room = max(int(1.3 * self.axis.get_tick_space()), 2)  # labels may stand closer than matplotlib has them
        return decade_ticks(vmin, vmax, room)


def _plain(value: float, _position: int) -> str:
    return formatted(value, "g")
