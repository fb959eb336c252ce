"""Charts of a radiometric acceptance: histograms with their limits, and the seams' steps against contrast."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import cycle

import numpy as np
from matplotlib.figure import Figure

from ..imagery.rasters import ValueRange
from ..toolkit.charts.chart_style import BAND_COLOURS, MOST_NAMED, PAPER, UNNAMED
from ..toolkit.charts.figure_files import new_figure
from ..toolkit.translation import tr
from .measure.assessment import Assessment
from .measure.image_statistics import Histogram
from .measure.rules import CLIPPED_HIGH, CLIPPED_LOW, LUMINOSITY, PEAK, SEAM_CONTRAST, SEAM_STEP
from .words import band_words


def histogram_figure(result: Assessment) -> Figure | None:
    """The histograms of what is judged, the tails that count as clipped and where the peak has to lie.

    Without a known range they end at the largest value, and nothing is marked.
    """
    if not result.histograms or not any(histogram.pixels for histogram in result.histograms.values()):
        return None
    low, high = shown = result.available or _range_of_values(result)
    figure = new_figure(2.7, 1.7)
    axes = figure.subplots()
    spare = cycle(PAPER.sources)
    for place, (name, histogram) in enumerate(_drawn(result).items()):
        counts, middles = histogram.binned(shown)
        is_dark = name == LUMINOSITY or len(_drawn(result)) == 1
        colour = PAPER.text if is_dark else BAND_COLOURS.get(name) or next(spare)
        words = band_words(name) if place < MOST_NAMED else UNNAMED
        axes.plot(middles, 100 * counts / max(histogram.pixels, 1), color=colour, linewidth=1.1, label=words)
    known = result.checked_figures if result.available is not None else ()
    rules = {checked.rule.check: checked.rule for checked in known}
    whole = next(iter(result.histograms.values())).has_steps
    for check in (CLIPPED_LOW, CLIPPED_HIGH):
        if check in rules:
            width = rules[check].values * (1 if whole else (high - low) / 256)
            start = low - 0.5 if check == CLIPPED_LOW else high - width + 0.5
            axes.axvspan(start, start + width, color=PAPER.limit, alpha=0.2, linewidth=0)
    most = rules[PEAK].most if PEAK in rules else None
    if most is not None:
        reach, middle = most * (high - low), (low + high) / 2
        axes.axvspan(middle - reach, middle + reach, color="#009e73", alpha=0.12, linewidth=0)
    axes.set_xlim(low - 0.01 * (high - low), high + 0.01 * (high - low))
    axes.set_ylim(bottom=0)
    axes.set_xlabel(tr("value (DN)"), fontsize=7)
    axes.set_ylabel(tr("pixels (%)"), fontsize=7)
    axes.tick_params(labelsize=7)
    axes.spines[["top", "right"]].set_visible(False)
    if len(axes.get_lines()) > 1:
        axes.legend(fontsize=6, frameon=False, handlelength=1)
    return figure


def _drawn(result: Assessment) -> Mapping[str, Histogram]:
    """Of one band the luminosity is the band itself, so that one of the two is enough."""
    return dict(list(result.histograms.items())[:1]) if len(result.image.band_names) == 1 else result.histograms


def _range_of_values(result: Assessment) -> ValueRange:
    histograms = result.histograms.values()
    least = min(float(one.values[np.flatnonzero(one.counts)[0]]) for one in histograms if one.pixels)
    most = max(one.largest for one in histograms if one.pixels)
    return least, max(most, least + 1)


def balance_figure(results: Sequence[Assessment]) -> Figure | None:
    """Contrast beside the seams against the step at them, a numbered point for each raster with seams: tonal unity
    is bought with contrast. None with fewer than two."""
    points = [(result, *pair) for result in results if (pair := step_and_contrast(result)) is not None]
    if len(points) < 2:
        return None
    figure = new_figure(5.2, 3.4)
    axes = figure.subplots()
    for number, (_, step, contrast) in enumerate(points, 1):
        axes.plot([100 * step], [100 * contrast], "o", color=PAPER.sources[0], markersize=6)
        axes.annotate(str(number), (100 * step, 100 * contrast), xytext=(4, 4), textcoords="offset points", fontsize=8)
    axes.set_xlim(0, 115 * max(max(step for _, step, _ in points), 1e-3))
    axes.set_ylim(0, 115 * max(max(contrast for _, _, contrast in points), 1e-3))
    axes.set_xlabel(tr("largest step at a seam (% of the largest value)"))
    axes.set_ylabel(tr("contrast beside the seams (% of the range)"))
    axes.grid(True, color=PAPER.grid)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    return figure


def step_and_contrast(result: Assessment) -> tuple[float, float] | None:
    """The largest step of any seam and band, and the mean of the bands' contrasts beside the seams; None where they
    are not measured."""
    steps, contrasts = (
        [one.value for one in result.checked_figures if one.rule.check == check and one.value is not None]
        for check in (SEAM_STEP, SEAM_CONTRAST)
    )
    return (max(steps), math.fsum(contrasts) / len(contrasts)) if steps and contrasts else None
