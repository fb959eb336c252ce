"""An image, or a window of it, against the rules: every figure with its limit, or why it can't be measured."""
from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Callable

from ...imagery.grids import PixelWindow
from ...imagery.lines.seamlines import Seam
from ...imagery.message import Message
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster
from ...imagery.value_ranges import ValueRange, is_range_known, value_range
from . import limits, messages
from . import rules as checks
from .image_statistics import Histogram, ImageStatistics, can_count, stream_statistics
from .rules import Rule, RuleSet
from .seam_steps import SeamStep, seam_steps
from .uniform_areas import colour_balance, signal_to_noise

MIN_STATISTICS_PIXELS = 4096  # 64 x 64: a histogram of fewer is no picture of an image

ALL_BANDS = "all"
"""The band of a figure that is taken between the bands."""


@dataclass(frozen=True)
class CheckedFigure:
    """One figure of one band against its rule."""

    band: str
    """As in ``Image.band_names``, or ``all``."""
    rule: Rule
    value: float | None
    """Shares are fractions of 1; None when it can't be measured."""
    passed: bool | None
    """None when it can't be measured or the rule has no limit."""
    reason: Message | None = None
    """Why it can't be measured or judged."""


@dataclass(frozen=True, eq=False)
class Assessment:
    """An image, or a window of it, and what was found."""

    image: Raster
    window_id: int | None
    """None for the whole image."""
    checked_figures: tuple[CheckedFigure, ...]
    available: ValueRange | None
    """The range that shares are shares of."""
    histograms: dict[str, Histogram]
    """By band name; empty when the values can't be counted."""
    seams: tuple[SeamStep, ...]
    notices: tuple[Message, ...]


def assess(
    source: OpenRaster, window: PixelWindow, rules: RuleSet,
    seams: Sequence[Seam] | None = None, window_id: int | None = None,
    progress: Callable[[float], bool] = lambda share: True,
) -> Assessment | None:
    """Stream a window of an image (all of it: ``image.whole``) and hold it against the rules.

    ``seams`` are in the image's reference system; without them the rule on seams is left out. ``progress`` is told
    the share that is done and ends the work by returning False: then there is no result.

    Raises RasterError when the pixels can't be read.
    """
    image = source.raster
    applied = [rule for rule in rules.rules if rule.check not in checks.AT_SEAMS or seams is not None]
    if not can_count(image, rules.value_range):
        why = messages.NO_VALUE_RANGE(data_type=image.data_type)
        return Assessment(image, window_id, tuple(_not_measurable(image, applied, why)), None, {}, (), ())
    statistics = stream_statistics(source, window, rules.value_range, progress)
    if not statistics.complete:
        return None
    count = min(histogram.pixels for histogram in statistics.histograms.values())
    if count < MIN_STATISTICS_PIXELS:
        why = messages.TOO_FEW_VALID_PIXELS(count=count, least=MIN_STATISTICS_PIXELS)
        figures = tuple(_not_measurable(image, applied, why))
        return Assessment(image, window_id, figures, None, statistics.histograms, (), ())
    largest = max(histogram.largest for histogram in statistics.histograms.values())
    available = rules.value_range or value_range(image, largest)
    assert available is not None  # else the values could not have been counted
    notices = []
    if rules.value_range is None and not is_range_known(image):
        notices.append(
            messages.RANGE_ASSUMED(name=image.ref.name, largest=f"{largest:g}", low=available[0], high=available[1])
        )
    steps = seam_steps(source, window, seams) if seams else []
    figures = tuple(
        checked for rule in applied for checked in _checked_figures(rule, image, statistics, available, steps, largest)
    )
    return Assessment(image, window_id, figures, available, statistics.histograms, tuple(steps), tuple(notices))


def clipped_share(histogram: Histogram, rule: Rule, available: ValueRange) -> float:
    """Share of the pixels in the lowest or highest values of the range, or beyond them.

    Values without steps of their own (float) are taken as 256 steps.
    """
    low, high = available
    width = rule.values - 1 if histogram.has_steps else rule.values * (high - low) / 256
    if rule.check == checks.CLIPPED_LOW:
        return histogram.share(most=low + width)
    return histogram.share(least=high - width)


def peak_deviation(histogram: Histogram, available: ValueRange) -> float:
    """How far the most frequent value lies from the middle of the range, as a share of the range."""
    counts, middles = histogram.binned(available)
    low, high = available
    return abs(float(middles[int(counts.argmax())]) - (low + high) / 2) / (high - low)


def contrast(histogram: Histogram, available: ValueRange) -> float:
    """Standard deviation as a share of the range."""
    return histogram.deviation / (available[1] - available[0])


def seam_contrast(steps: Sequence[SeamStep], band: int, available: ValueRange) -> float:
    """Standard deviation beside the seams as a share of the range, root mean square over all stations."""
    squares = math.fsum(step.stations * step.contrasts[band] ** 2 for step in steps)
    return math.sqrt(squares / sum(step.stations for step in steps)) / (available[1] - available[0])


def _checked_figures(
    rule: Rule, image: Raster, statistics: ImageStatistics, available: ValueRange, steps: Sequence[SeamStep],
    largest: float,
) -> Iterator[CheckedFigure]:
    if rule.check == checks.COLOUR_BALANCE:
        yield _checked_figure(ALL_BANDS, rule, _colour_figure(image, statistics, available))
        return
    for index, (name, histogram) in enumerate(statistics.histograms.items()):
        if rule.check in checks.AT_SEAMS:
            figure = _seam_figure(rule, index, available, steps, largest)
        elif rule.check == checks.SIGNAL_TO_NOISE:
            figure = _noise_figure(statistics, index, available)
        else:
            figure = _histogram_figure(rule, histogram, available)
        yield _checked_figure(name, rule, figure)


def _histogram_figure(rule: Rule, histogram: Histogram, available: ValueRange) -> float | Message:
    if rule.check == checks.PEAK:
        return peak_deviation(histogram, available)
    if rule.check == checks.CONTRAST:
        return contrast(histogram, available)
    return clipped_share(histogram, rule, available)


def _noise_figure(statistics: ImageStatistics, band: int, available: ValueRange) -> float | Message:
    ratio = signal_to_noise(statistics.areas, band, available)
    if ratio is None:
        return messages.NO_UNIFORM_AREA(least=limits.MIN_AREAS, side=limits.AREA_PX)
    return messages.NO_NOISE_AT_ALL() if math.isinf(ratio) else ratio


def _colour_figure(image: Raster, statistics: ImageStatistics, available: ValueRange) -> float | Message:
    if not image.has_luminance:
        return messages.NO_COLOURS()
    balance = colour_balance(statistics.areas, range(3), available)
    if balance is None:
        return messages.NO_NEUTRAL_AREA(least=limits.MIN_AREAS, most=limits.MAX_NEUTRAL_SPREAD)
    return balance


def _seam_figure(
    rule: Rule, band: int, available: ValueRange, steps: Sequence[SeamStep], largest: float
) -> float | Message:
    if not steps or largest <= 0:
        return messages.NO_SEAM_HERE(pixels=limits.MIN_SEAM_STATIONS * limits.SEAM_STATION_PX)
    if rule.check == checks.SEAM_STEP:
        return max(abs(step.steps[band]) for step in steps) / largest
    return seam_contrast(steps, band, available)


def _checked_figure(band: str, rule: Rule, figure: float | Message) -> CheckedFigure:
    """A figure against its rule, or why there is none."""
    if isinstance(figure, Message):
        return CheckedFigure(band, rule, None, None, messages.NOT_MEASURABLE(why=figure))
    if not rule.has_limit:
        return CheckedFigure(band, rule, figure, None, messages.NO_LIMIT())
    return CheckedFigure(band, rule, figure, rule.passes(figure))


def _not_measurable(image: Raster, rules: Sequence[Rule], why: Message) -> Iterator[CheckedFigure]:
    for rule in rules:
        for band in (ALL_BANDS,) if rule.check == checks.COLOUR_BALANCE else image.band_names:
            yield _checked_figure(band, rule, why)


