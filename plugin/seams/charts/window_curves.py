"""Results of windows -> the curves that a chart shows, and words for their points."""
from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING

from ...toolkit.translation import BAND_ORDER, filled, tr
from ..measure.window_records import COMPOSITE, REFERENCES
from .chart_curves import ChartCurve, least_of_sources, share_text

if TYPE_CHECKING:
    from ..measure.window.window_result import ClipResult, WindowCurves


def bands_of(results: Iterable[WindowCurves]) -> list[str]:
    """The bands of the mosaics, luminance and colours first."""
    names = {name: None for result in results for clip in result.clips[:1] for name in clip.curves}
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
            curves.append(ChartCurve(label, False, curve.detail, curve.background, None, (), True, is_reference))
            continue
        colour = None if is_mosaic else colours.get(clip.raster)
        curves.append(ChartCurve(clip.raster + twin, is_mosaic, curve.detail, curve.background, colour))
    return curves


def mean_curves(results: Sequence[WindowCurves], band: str) -> list[ChartCurve]:
    """Mean and range of the mosaics of many windows, and of all their sources.

    Windows measured with other levels than most are left out.
    """
    clips = [clip for result in results for clip in result.clips if band in clip.curves]
    depths = Counter(len(clip.curves[band].detail) for clip in clips if clip.role == "mosaic")
    if not depths:
        return []
    depth = depths.most_common(1)[0][0]
    clips = [clip for clip in clips if len(clip.curves[band].detail) == depth and clip.curves[band].variance > 0]
    mosaics = [clip for clip in clips if clip.role == "mosaic"]
    sources = [clip for clip in clips if clip.role == "source"]
    titles = tr("mosaic (mean)"), tr("sources (mean)")
    return [_mean(group, band, title) for group, title in zip((mosaics, sources), titles) if group]


def _mean(clips: Sequence[ClipResult], band: str, label: str) -> ChartCurve:
    columns = list(zip(*((*clip.curves[band].detail, clip.curves[band].background) for clip in clips)))
    means = [math.fsum(column) / len(column) for column in columns]
    spread = tuple((min(column), max(column)) for column in columns)
    return ChartCurve(label, clips[0].role == "mosaic", tuple(means[:-1]), means[-1], 0, spread)


def point_words(curves: Sequence[ChartCurve], index: int, component: int) -> tuple[str, str]:
    """A curve's name, and the text about one of its points."""
    curve = curves[index]
    value = curve.values[component]
    is_background = component == len(curve.detail)
    place = tr("background") if is_background else filled(tr("level {number}"), number=component + 1)
    words = f", {place}: {share_text(value)}"
    if curve.spread:
        low, high = (share_text(share) for share in curve.spread[component])
        return curve.label, words + filled(tr(" (range {low} to {high})"), low=low, high=high)
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
