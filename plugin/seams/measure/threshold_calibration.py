"""Judging the judge: how well a measure tells the windows where an observer saw a loss from those where he saw none.

A measure is low where detail was lost. At a threshold t every window with measure <= t is flagged; sensitivity is the
share of the visible losses that are flagged, specificity the share of the invisible ones that are not. Both for all t
are the ROC curve; the area under it is the probability that a visible loss has the lower value (Hanley and McNeil
1982). Pyka 2010, section 6, asks for it: limits of loss need research on statistically significant samples.
"""
from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from ...imagery.message import Message
from . import messages

MIN_VERDICTS = 5  # of either kind: below it one verdict moves the sensitivity by more than 20 %
RESAMPLES = 2000  # of the verdicts; Efron and Tibshirani 1993, section 12.5: 1000 and more for an interval's ends
PERCENTILES_95 = (2.5, 97.5)
NORMAL_95 = 1.959964  # standard errors either side of a normal value that hold 95 %
WANTED_AREA_ERROR = 0.05  # half of the 95 % interval of an area under the ROC curve that is known well enough

_SEED = 20100705  # the same verdicts give the same interval
_CELLS_AT_ONCE = 1 << 20  # of a table of resamples by values, 8 MB a table


@dataclass(frozen=True)
class Verdicts:
    """The values of one measure in the windows that an observer judged; none of them NaN."""

    measure: str
    """Name of the field it comes from."""
    visible: tuple[float, ...]
    """Where a loss was seen."""
    invisible: tuple[float, ...]
    """Where none was seen."""


@dataclass(frozen=True)
class Step:
    """What a threshold does to the judged windows."""

    threshold: float
    """Windows with the measure at or below it are flagged."""
    flagged_visible: int
    """How many of the visible losses it flags."""
    flagged_invisible: int
    """How many windows without a visible loss it flags in vain."""
    sensitivity: float
    """Share of the visible losses that are flagged, 0 to 1."""
    specificity: float
    """Share of the windows without one that are not, 0 to 1."""

    @property
    def youden(self) -> float:
        """Youden's index, sensitivity + specificity - 1: 0 is a guess, 1 is without fault."""
        return self.sensitivity + self.specificity - 1


@dataclass(frozen=True)
class Interval:
    """A value with its 95 % confidence interval."""

    value: float
    low: float
    high: float


@dataclass(frozen=True)
class ThresholdCalibration:
    """What the verdicts say of one measure."""

    verdicts: Verdicts
    steps: tuple[Step, ...] = ()
    """One for each value that occurs, ascending: between two values nothing changes. Empty with too few verdicts."""
    area: Interval | None = None
    """Under the ROC curve; 0.5 is a guess, 1 is without fault. None with too few verdicts."""
    best: Step | None = None
    """The threshold with the largest Youden index; None where none is better than a guess."""
    best_range: tuple[float, float] | None = None
    """The 95 % of thresholds that resampled verdicts would have chosen."""
    wanted: tuple[int, int] | None = None
    """How many visible and invisible verdicts would be enough; None with too few to say."""
    notices: tuple[Message, ...] = ()
    """Why there is no number, or how far to trust it."""


def calibrate(verdicts: Verdicts, most: float = math.inf) -> ThresholdCalibration:
    """Area, best threshold and verdicts wanted of one measure.

    ``most``: the threshold has to stay below it, as one that can be set does. With fewer than five visible or five
    invisible verdicts there is a notice and no number.
    """
    visible, invisible = len(verdicts.visible), len(verdicts.invisible)
    if min(visible, invisible) < MIN_VERDICTS:
        too_few = messages.TOO_FEW_VERDICTS(
            measure=verdicts.measure, visible=visible, invisible=invisible, fewest=MIN_VERDICTS
        )
        return ThresholdCalibration(verdicts, notices=(too_few,))
    table = _Table(verdicts, most)
    area, best = table.area(), table.best()
    wanted = wanted_verdicts(area.value, visible, invisible)
    return ThresholdCalibration(
        verdicts, table.steps(), area, best, table.best_range(best) if best else None, wanted,
        tuple(_notices(verdicts, table, area, best)),
    )


def step_at(verdicts: Verdicts, threshold: float) -> Step:
    """What a threshold does to judged windows, of which there is at least one of either kind."""
    seen, unseen = len(verdicts.visible), len(verdicts.invisible)
    hits = sum(value <= threshold for value in verdicts.visible)
    vain = sum(value <= threshold for value in verdicts.invisible)
    return Step(threshold, hits, vain, hits / seen, (unseen - vain) / unseen)


def area_interval(area: float, visible: int, invisible: int) -> tuple[float, float]:
    """The 95 % score interval of an area under the ROC curve.

    Newcombe 2006 (Statistics in Medicine 25, 559-573), method 5: the limits are the areas whose standard error after
    Hanley and McNeil 1982, averaged over both kinds, puts the observed area at 1.96 of it. It holds its width where
    all pairs are in order and a bootstrap has none.
    """

    def limit(end: float) -> float:
        inside, outside = area, end  # the observed area lies within 1.96 standard errors of the first, not the second
        for _ in range(60):
            middle = (inside + outside) / 2
            if abs(area - middle) <= NORMAL_95 * _standard_error(middle, visible, invisible):
                inside = middle
            else:
                outside = middle
        return inside

    return limit(0.0), limit(1.0)


def wanted_verdicts(area: float, visible: int, invisible: int) -> tuple[int, int]:
    """How many visible and invisible verdicts make the score interval of this area narrow enough (0.10 wide).

    At the present share of both kinds, and not fewer than five of either.
    """
    share = visible / (visible + invisible)

    def split(total: int) -> tuple[int, int]:
        return max(MIN_VERDICTS, round(total * share)), max(MIN_VERDICTS, round(total * (1 - share)))

    def is_enough(total: int) -> bool:
        low, high = area_interval(area, *split(total))
        return high - low <= 2 * WANTED_AREA_ERROR

    few, many = 0, 2 * MIN_VERDICTS
    while not is_enough(many):
        few, many = many, 2 * many
    while many - few > 1:
        middle = (few + many) // 2
        few, many = (few, middle) if is_enough(middle) else (middle, many)
    return split(many)


def _standard_error(area: float, visible: int, invisible: int) -> float:
    """Hanley and McNeil 1982, equation 1, with the mean number of both kinds in the place of either (Newcombe)."""
    others = (visible + invisible) / 2 - 1
    spread = 1 + others * (1 - area) / (2 - area) + others * area / (1 + area)
    return math.sqrt(max(area * (1 - area) * spread, 0) / (visible * invisible))


def _notices(verdicts: Verdicts, table: _Table, area: Interval, best: Step | None) -> list[Message]:
    name, found = verdicts.measure, []
    if area.low <= 0.5:
        found.append(messages.NO_BETTER_THAN_CHANCE(measure=name, low=area.low, high=area.high))
    if area.value == 1:
        found.append(messages.VERDICTS_FULLY_APART(measure=name))
    free = table.best(settable=False)
    if best is None:
        found.append(messages.NO_THRESHOLD(measure=name))
    elif free is not None and free.youden > best.youden:
        found.append(messages.THRESHOLD_TOO_HIGH(measure=name, threshold=free.threshold, most=table.most))
    return found


class _Table:
    """Judged windows counted by value, and what follows from the counts of these or of resampled ones."""

    def __init__(self, verdicts: Verdicts, most: float) -> None:
        self.most = most
        groups = [np.array(group, np.float64) for group in (verdicts.visible, verdicts.invisible)]
        self._values, places = np.unique(np.concatenate(groups), return_inverse=True)
        size = len(self._values)
        self._visible = np.bincount(places[: len(groups[0])], minlength=size)
        self._invisible = np.bincount(places[len(groups[0]) :], minlength=size)
        self._settable = self._values < most
        self._above = np.append(self._values[1:], self._values[-1])  # the next value, up to which nothing changes
        self._above[self._settable] = np.minimum(self._above[self._settable], most)

    def steps(self) -> tuple[Step, ...]:
        """One at every value."""
        return tuple(self._step(place, value) for place, value in enumerate(self._values.tolist()))

    def area(self) -> Interval:
        """Under the ROC curve, with the percentile interval of a bootstrap that keeps the number of either kind."""
        value = float(_areas(self._visible[np.newaxis], self._invisible[np.newaxis])[0])
        if value in (0, 1):  # every resample has the same area, which says nothing of its error
            return Interval(value, *area_interval(value, int(self._visible.sum()), int(self._invisible.sum())))
        areas = np.concatenate([_areas(*counts) for counts in self._resamples()])
        return Interval(value, *map(float, np.percentile(areas, PERCENTILES_95)))

    def best(self, settable: bool = True) -> Step | None:
        """The step with the largest Youden index, the lowest of those: it flags least."""
        place = int(_best_places(self._visible[np.newaxis], self._invisible[np.newaxis], self._mask(settable))[0])
        step = self._step(place, _round_between(float(self._values[place]), float(self._above[place])))
        return step if step.youden > 0 and self._mask(settable)[place] else None

    def best_range(self, best: Step) -> tuple[float, float]:
        """Where resampled verdicts would put the threshold, and these do."""
        places = [_best_places(*counts, self._mask(True)) for counts in self._resamples()]
        cuts = (self._values + self._above) / 2
        low, high = np.percentile(cuts[np.concatenate(places)], PERCENTILES_95)
        return min(float(low), best.threshold), max(float(high), best.threshold)

    def _mask(self, settable: bool) -> np.ndarray:
        return self._settable if settable else np.ones(len(self._values), bool)

    def _step(self, place: int, threshold: float) -> Step:
        seen, unseen = int(self._visible.sum()), int(self._invisible.sum())
        hits, vain = int(self._visible[: place + 1].sum()), int(self._invisible[: place + 1].sum())
        return Step(threshold, hits, vain, hits / seen, (unseen - vain) / unseen)

    def _resamples(self) -> Iterator[tuple[np.ndarray, np.ndarray]]:
        """Counts of resampled verdicts, (resamples, values) of either kind, in parts that fit the memory."""
        random = np.random.default_rng(_SEED)
        rows = max(1, _CELLS_AT_ONCE // len(self._values))
        for done in range(0, RESAMPLES, rows):
            size = min(rows, RESAMPLES - done)
            yield _resample(random, self._visible, size), _resample(random, self._invisible, size)


def _round_between(low: float, high: float) -> float:
    """The number with the fewest decimals in the middle half of a range."""
    middle, reach = (low + high) / 2, (high - low) / 4
    return next((rounded for digits in range(12) if abs((rounded := round(middle, digits)) - middle) <= reach), middle)


def _resample(random: np.random.Generator, counts: np.ndarray, size: int) -> np.ndarray:
    return random.multinomial(counts.sum(), counts / counts.sum(), size)


def _areas(visible: np.ndarray, invisible: np.ndarray) -> np.ndarray:
    """Areas under the ROC curve of counts (resamples, values): pairs in order, those alike for a half."""
    below = np.cumsum(visible, axis=1) - visible / 2
    return (below * invisible).sum(axis=1) / (visible.sum(axis=1) * invisible.sum(axis=1))


def _best_places(visible: np.ndarray, invisible: np.ndarray, mask: np.ndarray) -> np.ndarray:
    """The first of the places with the largest Youden index, in whole numbers so that equals are equal."""
    hits, vain = np.cumsum(visible, axis=1), np.cumsum(invisible, axis=1)
    index = hits * invisible.sum(axis=1, keepdims=True) - vain * visible.sum(axis=1, keepdims=True)
    return np.argmax(np.where(mask, index, np.iinfo(index.dtype).min), axis=1)
