"""What judged windows say of a measure: area under its ROC curve and best threshold, both with their intervals.

The threshold is that with the largest Youden index of two normal distributions. The best step of the judged windows
themselves jumps from one window's value to another's: it errs like the cube root of their number, and a bootstrap of it
does not hold (Kim and Pollard 1990, Annals of Statistics 18, 191-219; Abrevaya and Huang 2005, Econometrica 73,
1175-1204). That of fitted distributions (Fluss, Faraggi and Reiser 2005, Biometrical Journal 47, 458-472) moves evenly
with every verdict, errs half as much, and can be resampled.
"""
from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from scipy.special import ndtr

from ....imagery.statistics import NORMAL_95, Interval, critical_t
from .neighbourhoods import Neighbourhoods

MIN_VERDICTS = 5  # of either kind: below it one verdict moves the sensitivity by more than 20 %
PERCENTILES_95 = (2.5, 97.5)  # the ends of a 95 % interval
WANTED_AREA_ERROR = 0.05  # half of the 95 % interval of an area under the ROC curve that is known well enough


def roc_area(visible: np.ndarray, invisible: np.ndarray, neighbourhoods: Neighbourhoods) -> Interval:
    """The share of pairs in order, those alike for a half, with the percentile interval of resampled neighbourhoods."""
    pairs = np.less.outer(visible, invisible) + np.equal.outer(visible, invisible) / 2
    value = float(pairs.mean())
    if value in (0, 1):  # every resample has the same area, which says nothing of its error
        return Interval(value, *area_interval(value, len(visible), len(invisible)))
    seen, unseen = neighbourhoods.resamples()
    areas = (seen @ pairs * unseen).sum(axis=1) / (seen.sum(axis=1) * unseen.sum(axis=1))
    return Interval(value, *map(float, np.percentile(areas, PERCENTILES_95)))


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


DEGREES_OF_FREEDOM = 1.5  # a neighbourhood less one: Welch 1947 has 1 to 2, by how alike both kinds' errors are
_LEAST_SPREAD = 0.02  # of all values' standard deviation: a kind whose values are all the same has some
_REACH = 1.5  # standard deviations beyond both means that a threshold may lie
_ALIKE = 1e-9  # share by which variances differ that are as good as equal


def best_threshold(visible: np.ndarray, invisible: np.ndarray, neighbourhoods: Neighbourhoods) -> Interval:
    """The best threshold and its 95 % interval, from the spread of the thresholds of resampled neighbourhoods.

    Of the values or, where those are likelier to be normal, of their logarithms. Few neighbourhoods tell their spread
    badly: therefore Student's distribution. No measure is negative, so no end is.
    """
    kinds = [visible, invisible]
    values = np.concatenate(kinds)
    if np.ptp(values) == 0:
        return Interval(*[float(values[0])] * 3)
    (middle,), (is_skewed,) = _thresholds(kinds, [np.ones((1, len(kind))) for kind in kinds])
    drawn, _ = _thresholds(kinds, neighbourhoods.resamples())
    spread = float((np.log(drawn.clip(np.finfo(float).tiny)) if is_skewed else drawn).std(ddof=1))
    count = max(neighbourhoods.fewest, 1.5)
    reach = spread * float(critical_t(0.95, max(DEGREES_OF_FREEDOM * (count - 1), 1)))
    low, high = (float(middle * np.exp(end) if is_skewed else middle + end) for end in (-reach, reach))
    return Interval(float(middle), max(low, min(0.0, float(values.min()))), high)


def _thresholds(kinds: Sequence[np.ndarray], weights: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Best thresholds (resamples,) of both kinds' values (n,), weighted, (resamples, n), and whether the logarithms are
    likelier to be normal."""
    crossings, unlikely = _crossings(kinds, weights)
    if min(kind.min() for kind in kinds) <= 0:
        return crossings, np.zeros(len(crossings), bool)
    logs = list(map(np.log, kinds))
    of_logs, unlikely_logs = _crossings(logs, weights)
    is_skewed = unlikely_logs + sum(weight @ log for weight, log in zip(weights, logs)) < unlikely
    return np.where(is_skewed, np.exp(of_logs), crossings), is_skewed


def _crossings(kinds: Sequence[np.ndarray], weights: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Thresholds (resamples,) with the largest Youden index of the normal distributions of both kinds' values: where
    both densities are equal, which is in two places, or in one where they spread alike; and how unlikely the values
    are, the logarithm."""
    least = _LEAST_SPREAD * float(np.concatenate(kinds).std())
    fitted, unlikely = [], np.zeros(len(weights[0]))
    for values, weight in zip(kinds, weights):
        count = weight.sum(axis=1)
        mean = weight @ values / count
        variance = (weight @ values**2 / count - mean**2) * count / (count - 1)
        fitted.append((mean, np.maximum(np.sqrt(np.maximum(variance, 0)), least)))
        unlikely += count * np.log(fitted[-1][1])
    (mean, spread), (other_mean, other_spread) = fitted
    wider = other_spread**2 - spread**2
    is_alike = np.abs(wider) <= _ALIKE * (other_spread**2 + spread**2)
    middle = mean * other_spread**2 - other_mean * spread**2
    aside = spread * other_spread * np.sqrt((mean - other_mean) ** 2 + 2 * wider * np.log(other_spread / spread))
    first, second = ((middle + sign * aside) / np.where(is_alike, 1, wider) for sign in (1, -1))
    youden = (ndtr((place - mean) / spread) - ndtr((place - other_mean) / other_spread) for place in (first, second))
    best = np.where(is_alike, (mean + other_mean) / 2, np.where(np.greater_equal(*youden), first, second))
    lows, highs = zip(*((kind.mean() - _REACH * kind.std(), kind.mean() + _REACH * kind.std()) for kind in kinds))
    return np.clip(best, min(lows), max(highs)), unlikely
