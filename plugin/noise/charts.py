"""Charts of random noise: the curves of one clip with the rising rule, and the ranges of whole groups."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..imagery.band_names import judged_band
from ..toolkit.charts.chart_style import BAND_COLOURS, PAPER, ChartStyle
from ..toolkit.charts.figure_files import new_figure
from ..toolkit.charts.variance_axes import draw_frame
from ..toolkit.translation import tr
from .measure.band_noise import BandNoise
from .measure.group_noise import ClipNoise
from .noise_summary import judged_noise

_LINES = {1: "-", 2: "--"}
_HEADROOM = 1.25


def draw_noise(
    axes: Axes, measured: Mapping[str, BandNoise], style: ChartStyle = PAPER, line: str = "-", label: str = ""
) -> list[Artist]:
    """The curves of one clip by band, the judged one (luminance, or the only band) bold; see ``noise_rule``."""
    drawn: list[Artist] = []
    bold = judged_band(measured) if measured else ""
    spare = iter(style.sources * 9)
    for band, noise in measured.items():
        if noise.curve.variance == 0:
            continue
        colour = style.text if band == bold else BAND_COLOURS.get(band) or next(spare)
        detail = noise.curve.detail
        width, size, order = (2.4, 5, 4) if band == bold else (1.3, 3, 3)
        drawn += axes.plot(
            range(1, len(detail) + 1), detail, color=colour, linestyle=line, linewidth=width * style.scale,
            marker="o", markersize=size * style.scale, zorder=order, label=f"{label} {band}".strip(),
        )
    return drawn


def draw_rule(axes: Axes, detail: Sequence[float], style: ChartStyle = PAPER) -> list[Artist]:
    """The rising rule of a curve: where each level has to stay out of for the noise to be low."""
    drawn: list[Artist] = []
    for level, finer in enumerate(detail[:-1], 2):
        reach = [level - 0.22, level + 0.22]
        drawn.append(axes.fill_between(reach, finer, finer * 1e-9, color=style.limit, alpha=0.13, linewidth=0))
        label = tr("bold curve in the red: noise") if level == 2 else None
        drawn += axes.plot(reach, [finer, finer], color=style.limit, linewidth=1.6 * style.scale, label=label)
    return drawn


def draw_noise_clip(
    axes: Axes, measured: Mapping[str, BandNoise], style: ChartStyle = PAPER, logarithmic: bool = True
) -> None:
    """A whole chart of one clip: frame, rule and curves. For the desk and reports."""
    levels = max((len(noise.curve.detail) for noise in measured.values()), default=0)
    known = [noise.curve.detail for noise in measured.values() if noise.curve.variance > 0]
    noise_frame(axes, levels, known, style, logarithmic)
    bold = measured[judged_band(measured)] if measured else None
    if bold is not None and bold.curve.variance > 0:
        draw_rule(axes, bold.curve.detail, style)
    draw_noise(axes, measured, style)


def draw_group(
    axes: Axes, curves: Sequence[Sequence[float]], group: int, label: str, style: ChartStyle = PAPER
) -> list[Artist]:
    """The range of a group's curves as a band, with its mean line."""
    values = np.array(curves)
    levels = range(1, values.shape[1] + 1)
    colour = style.sources[(group - 1) % len(style.sources)]
    low, high = values.min(axis=0), values.max(axis=0)
    band = axes.fill_between(levels, low, high, facecolor=colour, alpha=0.25, linewidth=0, zorder=2)
    if group == 2:
        band.set(hatch="////", edgecolor=colour)
    mean = axes.plot(
        levels, values.mean(axis=0), color=colour, linewidth=2.6 * style.scale, linestyle=_LINES.get(group, "-"),
        marker="o", zorder=4, label=label,
    )
    return [band, *mean]


def noise_frame(
    axes: Axes, levels: int, curves: Sequence[Sequence[float]], style: ChartStyle = PAPER, logarithmic: bool = True
) -> None:
    """Scales, ticks, grid and words of a chart of levels without background, for curves that will be drawn."""
    draw_frame(axes, levels, style, logarithmic)
    axes.set_xticks(range(1, levels + 1), [str(level) for level in range(1, levels + 1)])
    axes.set_xlim(0.6, max(levels, 1) + 0.4)
    shares = [share for curve in curves for share in curve if share > 0]
    if not shares:
        return
    if logarithmic:
        decade = 10 ** math.floor(math.log10(min(shares)))
        axes.set_ylim(max(digit for digit in (1, 2, 5) if digit * decade <= min(shares)) * decade * 0.8,
                      max(shares) * _HEADROOM)
    else:
        axes.set_ylim(0, max(shares) * _HEADROOM)


def noise_figure(results: Sequence[ClipNoise]) -> Figure | None:
    """Left the range of each group with its mean line (Pyka 2009, figure 3), right the bands of one window
    (figure 4), dashed those of the second group; None where nothing was measured."""
    groups = _judged(results)
    if not groups:
        return None
    figure = new_figure(10, 5.2)
    left, right = figure.subplots(1, 2)
    levels = len(next(iter(groups.values()))[0])
    noise_frame(left, levels, [curve for curves in groups.values() for curve in curves])
    for group, curves in groups.items():
        words = tr("group {group}: mean and range of {count} windows") if len(groups) > 1 else (
            tr("mean and range of {count} windows")
        )
        draw_group(left, curves, group, words.format(group=group, count=len(curves)))
    left.set_title(tr("All windows, judged band"), fontsize="medium")
    _legend(left, 1)
    shown = example(results)
    first = shown[0]
    clips = [result.bands for result in shown]
    curves = [noise.curve.detail for bands in clips for noise in bands.values() if noise.curve.variance > 0]
    noise_frame(right, levels, curves)
    if len(shown) == 1:
        draw_rule(right, first.bands[judged_band(first.bands)].curve.detail)
    for result in shown:
        group = result.part.member.group
        label = tr("group {group}:").format(group=group) if len(shown) > 1 else ""
        draw_noise(right, result.bands, line=_LINES[group], label=label)
    names = " / ".join(result.part.member.image.ref.name for result in shown)
    right.set_title(tr("Window {window}: {names}").format(window=first.window_id, names=names), fontsize="medium",
                    wrap=True)
    _legend(right, 2)
    return figure


def _legend(axes: Axes, columns: int) -> None:
    """Below the chart, where it hides nothing."""
    axes.legend(
        fontsize="small", frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.13), ncol=columns, handlelength=3
    )


def example(results: Sequence[ClipNoise]) -> list[ClipNoise]:
    """The window whose bands are shown: of group 1 (paired where any is) the one with the median noise, with its
    partner of group 2."""
    measured = [result for result in results if _detail(result) is not None]
    first = min(result.part.member.group for result in measured)
    candidates = [result for result in measured if result.part.member.group == first]
    candidates = [result for result in candidates if result.paired] or candidates
    candidates.sort(key=lambda result: result.bands[judged_band(result.bands)].sigma or 0.0)
    shown = candidates[len(candidates) // 2]
    same = [result for result in measured if result.window_id == shown.window_id and shown.paired]
    return [shown, *[result for result in same if result.part.member.group != first][:1]]


def _judged(results: Sequence[ClipNoise]) -> dict[int, list[tuple[float, ...]]]:
    """The judged curves by group."""
    groups: dict[int, list[tuple[float, ...]]] = {}
    for result in results:
        detail = _detail(result)
        if detail is not None:
            groups.setdefault(result.part.member.group, []).append(detail)
    return dict(sorted(groups.items()))


def _detail(result: ClipNoise) -> tuple[float, ...] | None:
    """The judged curve of a result; None where there is none."""
    judged = judged_noise(result)
    return judged.curve.detail if judged is not None and judged.curve.variance > 0 else None
