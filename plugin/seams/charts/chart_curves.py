"""What a chart of relative variances shows: curves of windows, their limit and scale, and words for their points."""
from __future__ import annotations

import math
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...toolkit.charts.round_ticks import decade_ticks, round_below
from ...toolkit.translation import BAND_ORDER, filled, formatted, tr
from ..measure.window_records import COMPOSITE, REFERENCES

if TYPE_CHECKING:
    from ..measure.window.window_result import WindowCurves

Point = tuple[int, int]
"""A curve's index and a component's."""
_LOWEST_SHARE = 1e-6  # a logarithmic axis goes no further down: what the measurement resolves
_TICK_LINES = 1.4  # of the font, that ticks of a logarithmic axis are apart


@dataclass(frozen=True)
class ChartCurve:
    """One line in a chart."""

    label: str  # file name without its folder
    is_mosaic: bool
    detail: tuple[float, ...]  # relative variance at levels 1..R
    background: float
    colour: int | None = None
    """Number of a source's colour, so that it keeps it from window to window; None: by its place in the chart."""
    is_composite: bool = False  # whether it is the hard-cut composite of the sources, which is none of them
    is_reference: bool = False  # whether the verdict is taken against it alone, and not against the sources

    @property
    def values(self) -> tuple[float, ...]:
        """Levels 1..R, then the background; NaN for a constant clip."""
        return (*self.detail, self.background)


@dataclass(frozen=True)
class Chart:
    """All that a chart shows."""

    curves: tuple[ChartCurve, ...]
    max_ratio: float  # the limit of a significant loss at level 1, relative to the least sharp source


def numbered(curves: Sequence[ChartCurve]) -> list[tuple[int, ChartCurve]]:
    """The curves with their numbers among the sources."""
    are_sources = [not (curve.is_mosaic or curve.is_composite) for curve in curves]
    return [(sum(are_sources[:place]), curve) for place, curve in enumerate(curves)]


def least_of_sources(curves: Sequence[ChartCurve], component: int) -> float | None:
    """The lowest share of a component among the sources: of the least sharp one, where it is a detail.

    That of the composite, where the verdict is taken against it.
    """
    rivals = [curve for curve in curves if curve.is_reference]
    rivals = rivals or [curve for curve in curves if not (curve.is_mosaic or curve.is_composite)]
    return min((share for curve in rivals if (share := curve.values[component]) > 0), default=None)


def significance_limit(curves: Sequence[ChartCurve], max_ratio: float) -> float | None:
    """The share at level 1 at or below which a mosaic has lost significantly; None without sources."""
    least = least_of_sources(curves, 0)
    return None if least is None else max_ratio * least


def share_text(share: float) -> str:
    """A share with three digits that count: 0.412, 0.0160, 0.00052."""
    if not share > 0:
        return formatted(share, "g")
    return formatted(share, f".{min(max(2 - math.floor(math.log10(share)), 2), 7)}f")

def share_range(chart: Chart) -> tuple[float, float]:
    """Limits of the axis, rounded so that they seldom change from window to window."""
    shares = [share for curve in chart.curves for share in curve.values]
    shares.append(significance_limit(chart.curves, chart.max_ratio) or math.nan)
    positive = [share for share in shares if share > 0]
    lowest = max(min(positive, default=0.01) * 0.9, _LOWEST_SHARE)
    return round_below(lowest), 1.25


def share_ticks(low: float, high: float, room: float) -> list[float]:
    """Round shares within an axis: as many as there is room for, in lines of the font."""
    return decade_ticks(low, high, max(room / _TICK_LINES, 2))


def bands_of(result: WindowCurves) -> list[str]:
    """The bands of the mosaic, luminance and colours first."""
    names = result.clips[0].curves
    known = [name for name in BAND_ORDER if name in names]
    return [*known, *(name for name in names if name not in known)]


def window_curves(
    result: WindowCurves, band: str, colours: Mapping[str, int], reference: str = REFERENCES[0]
) -> list[ChartCurve]:
    """The curves of one window and band, the mosaic's first, the sources' composite last.

    ``colours``: numbers by file name. ``reference``: what the verdict is taken against, as in ``Settings``.
    """
    curves = []
    seen: Counter[str] = Counter()
    for clip in result.with_composite:
        if band not in clip.curves:
            continue
        is_mosaic = clip.role == "mosaic"
        seen[clip.raster] += not is_mosaic
        twin = f" ({seen[clip.raster]})" if seen[clip.raster] > 1 and not is_mosaic else ""
        curve = clip.curves[band]
        if clip.role == COMPOSITE:
            label, is_reference = tr("composite"), reference == clip.role
            curves.append(ChartCurve(label, False, curve.detail, curve.background, None, True, is_reference))
            continue
        colour = None if is_mosaic else colours.get(clip.raster)
        curves.append(ChartCurve(clip.raster + twin, is_mosaic, curve.detail, curve.background, colour))
    return curves


def point_words(curves: Sequence[ChartCurve], index: int, component: int) -> tuple[str, str]:
    """A curve's name, and the text about one of its points."""
    curve = curves[index]
    value = curve.values[component]
    is_background = component == len(curve.detail)
    place = tr("background") if is_background else filled(tr("level {number}"), number=component + 1)
    words = f", {place}: {share_text(value)}"
    mosaic = next((other.values[component] for other in curves if other.is_mosaic), math.nan)
    least = least_of_sources(curves, component)
    if curve.is_mosaic and least is not None and value == value:
        if any(other.is_reference for other in curves):
            template = tr(" ({percent:.0f} % of the composite)")
        elif is_background:
            template = tr(" ({percent:.0f} % of the lowest source)")
        else:
            template = tr(" ({percent:.0f} % of the least sharp source)")
        return curve.label, words + filled(template, percent=100 * value / least)
    if not curve.is_mosaic and value > 0 and mosaic == mosaic:
        return curve.label, words + filled(tr(" (mosaic: {percent:.0f} % of it)"), percent=100 * mosaic / value)
    return curve.label, words
