"""What judged windows say of a measure: area under its ROC curve and best threshold, both with their intervals.

The threshold is that with the largest Youden index of smoothed distributions. The best step of the judged windows
themselves jumps from one window's value to another's: it errs like the cube root of their number, and a bootstrap of it
does not hold (Kim and Pollard 1990, Annals of Statistics 18, 191-219; Abrevaya and Huang 2005, Econometrica 73,
1175-1204). Of smoothed distributions (Fluss, Faraggi and Reiser 2005, Biometrical Journal 47, 458-472) it moves evenly
with every verdict, errs half to two thirds as much, and can be resampled.
"""
from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
from scipy.special import ndtr

from ....imagery.statistics import NORMAL_95, Interval, critical_t
from .neighbourhoods import Neighbourhoods

MIN_VERDICTS = 5  # of either kind: below it one verdict moves the sensitivity by more than 20 %
AREA_RESAMPLES = 2000  # of the verdicts; Efron and Tibshirani 1993, section 12.5: 1000 and more for an interval's ends
PERCENTILES_95 = (2.5, 97.5)  # the ends of a 95 % interval
WANTED_AREA_ERROR = 0.05  # half of the 95 % interval of an area under the ROC curve that is known well enough


def roc_area(visible: np.ndarray, invisible: np.ndarray, neighbourhoods: Neighbourhoods) -> Interval:
    """The share of pairs in order, those alike for a half, with the percentile interval of resampled neighbourhoods."""
    pairs = np.less.outer(visible, invisible) + np.equal.outer(visible, invisible) / 2
    value = float(pairs.mean())
    if value in (0, 1):  # every resample has the same area, which says nothing of its error
        return Interval(value, *area_interval(value, len(visible), len(invisible)))
    areas = [
        (seen @ pairs * unseen).sum(axis=1) / (seen.sum(axis=1) * unseen.sum(axis=1))
        for seen, unseen in neighbourhoods.resamples(AREA_RESAMPLES)
    ]
    return Interval(value, *map(float, np.percentile(np.concatenate(areas), PERCENTILES_95)))


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


THRESHOLD_RESAMPLES = 400  # Efron and Tibshirani 1993, section 6.4: 200 and more for a standard error
BANDWIDTH = 1.3  # of the kernel in standard deviations, times count^-1/5: near to a fitted normal with ten verdicts
POWERS = np.linspace(0, 1, 6)  # from the logarithm to the values as they are
DEGREES_OF_FREEDOM = 1.5  # a neighbourhood less one: Welch 1947 has 1 to 2, by how alike both kinds' errors are

_GRID = 61  # thresholds tried; the parabola through the best three places it between them
_REACH = 1.5  # standard deviations beyond both means that the grid spans
_LEAST_SPREAD = 0.02  # of all values' standard deviation: a kind whose values are all the same has some
_MOST_VALUES = 64  # of a kind: more are counted in as many classes, much narrower than the kernel
_CELLS_AT_ONCE = 1 << 21  # of a table of resamples by values by thresholds, 16 MB a table


def smoothed_threshold(visible: np.ndarray, invisible: np.ndarray, neighbourhoods: Neighbourhoods) -> Interval:
    """The best threshold and its 95 % interval, from the spread of the thresholds of resampled neighbourhoods.

    Few neighbourhoods tell their spread badly: therefore Student's distribution. Measures are not negative, and so no
    end is.
    """
    values = np.concatenate([visible, invisible])
    if np.ptp(values) == 0:
        return Interval(*[float(values[0])] * 3)
    scale = _Scale(visible, invisible)
    value, power = (one[0] for one in scale.best(np.ones((1, len(visible))), np.ones((1, len(invisible)))))
    drawn = [scale.best(*weights)[0] for weights in neighbourhoods.resamples(THRESHOLD_RESAMPLES)]
    spread = _powered(np.concatenate(drawn), power).std(ddof=1)
    count = max(neighbourhoods.fewest, 1.5)
    reach = spread * float(critical_t(0.95, max(DEGREES_OF_FREEDOM * (count - 1), 1)))
    middle = _powered(value, power)
    low, high = (scale.back(_unpowered(end, power)) for end in (middle - reach, middle + reach))
    return Interval(scale.back(value), max(low, min(0.0, float(values.min()))), high)


class _Scale:
    """The judged values of both kinds, as logarithms about their mean where all are positive, and thresholds to try."""

    def __init__(self, visible: np.ndarray, invisible: np.ndarray) -> None:
        self._is_log = min(visible.min(), invisible.min()) > 0
        groups = [np.log(kind) if self._is_log else kind for kind in (visible, invisible)]
        self._mean = float(np.concatenate(groups).mean()) if self._is_log else 0.0  # so that no unit matters
        self._kinds = [_Kind(group - self._mean) for group in groups]
        ends = [(kind.mean - _REACH * kind.spread, kind.mean + _REACH * kind.spread) for kind in self._kinds]
        self._grid = np.linspace(min(low for low, _ in ends), max(high for _, high in ends), _GRID)
        self._least = _LEAST_SPREAD * float(np.concatenate([kind.values for kind in self._kinds]).std())

    def back(self, threshold: float) -> float:
        """The measure's own value of a threshold on this scale."""
        return math.exp(threshold + self._mean) if self._is_log else float(threshold)

    def best(self, visible: np.ndarray, invisible: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """The best thresholds of weighted verdicts (resamples, verdicts), and the powers they were found at."""
        weights = [kind.gather(one) for kind, one in zip(self._kinds, (visible, invisible))]
        powers = self._powers(weights) if self._is_log else np.full(len(visible), np.nan)
        rows = max(1, _CELLS_AT_ONCE // (_GRID * max(len(kind.values) for kind in self._kinds)))
        parts = [slice(start, start + rows) for start in range(0, len(powers), rows)]
        youden = (self._youden([weight[part] for weight in weights], powers[part]) for part in parts)
        return self._grid[0] + np.concatenate(list(map(_parabola, youden))) * (self._grid[1] - self._grid[0]), powers

    def _powers(self, weights: list[np.ndarray]) -> np.ndarray:
        """The Box-Cox power, the same for both kinds, at which the values are likeliest to be normal."""
        likelihoods = np.zeros((len(weights[0]), len(POWERS)))
        for place, power in enumerate(POWERS):
            for kind, weight in zip(self._kinds, weights):
                moved, count = _powered(kind.values, power), weight.sum(axis=1)
                mean = weight @ moved / count
                variance = np.maximum(weight @ moved**2 / count - mean**2, self._least**2)
                likelihoods[:, place] += (power - 1) * (weight @ kind.values) - count / 2 * np.log(variance)
        return POWERS[0] + _parabola(likelihoods) * (POWERS[1] - POWERS[0])

    def _youden(self, weights: list[np.ndarray], powers: np.ndarray) -> np.ndarray:
        """Smoothed Youden index at every threshold, (resamples, thresholds)."""
        moved = _powered(self._grid, powers[:, np.newaxis])
        flagged = [
            _smoothed_shares(_powered(kind.values, powers[:, np.newaxis]), weight, moved, kind.bandwidth, self._least)
            for kind, weight in zip(self._kinds, weights)
        ]
        return flagged[0] - flagged[1]


class _Kind:
    """The values of one kind, ascending; many are gathered in classes."""

    def __init__(self, values: np.ndarray) -> None:
        self._order = np.argsort(values, kind="stable")
        ordered = values[self._order]
        classes = ordered
        if len(values) > _MOST_VALUES:
            classes = np.floor((ordered - ordered[0]) / max(float(np.ptp(ordered)), 1e-300) * _MOST_VALUES)
        self._starts = np.unique(classes, return_index=True)[1]
        counts = np.diff(np.append(self._starts, len(values)))
        self.values = np.add.reduceat(ordered, self._starts) / counts
        self.mean, self.spread = float(values.mean()), float(values.std())
        self.bandwidth = BANDWIDTH * len(values) ** -0.2

    def gather(self, weights: np.ndarray) -> np.ndarray:
        """Weights of verdicts -> of classes."""
        return np.add.reduceat(weights[:, self._order].astype(np.float64), self._starts, axis=1)


def _smoothed_shares(
    values: np.ndarray, weights: np.ndarray, thresholds: np.ndarray, bandwidth: float, least: float
) -> np.ndarray:
    """Share of the verdicts at or below each threshold, each verdict spread by a normal kernel.

    The verdicts are drawn in towards their mean by as much as the kernel spreads them, so that the standard deviation
    stays theirs (Silverman and Young 1987, Biometrika 74, 469-479): values that are normal stay so at any bandwidth.
    """
    count = weights.sum(axis=1, keepdims=True)
    mean = (weights * values).sum(axis=1, keepdims=True) / count
    unbiased = np.sqrt(count / (count - 1))
    spread = np.sqrt((weights * (values - mean) ** 2).sum(axis=1, keepdims=True) / count) * unbiased
    spread = np.maximum(spread, least)
    places = (values - mean) / spread * unbiased
    tried = (thresholds - mean) / spread * math.sqrt(1 + bandwidth**2)
    shares = ndtr((tried[:, np.newaxis, :] - places[:, :, np.newaxis]) / bandwidth)
    found: np.ndarray = np.einsum("rv,rvt->rt", weights, shares) / count
    return found


def _parabola(heights: np.ndarray) -> np.ndarray:
    """Places where rows of evenly spaced heights are largest, in steps from their start; of a plateau the middle."""
    rows, last = np.arange(len(heights)), heights.shape[1] - 1
    peaks = (heights.argmax(axis=1) + last - heights[:, ::-1].argmax(axis=1)) // 2
    left, top, right = (heights[rows, np.clip(peaks + step, 0, last)] for step in (-1, 0, 1))
    bend = left - 2 * top + right
    inner = (peaks > 0) & (peaks < last) & (bend < 0)
    found: np.ndarray = peaks + np.where(inner, (left - right) / 2 / np.where(inner, bend, 1), 0)
    return found


def _powered(logs: Iterable[float] | np.ndarray, powers: np.ndarray) -> np.ndarray:
    """Box and Cox 1964: (x^power - 1) / power of logarithms of x; a power of NaN leaves numbers as they are."""
    numbers, powers = np.broadcast_arrays(np.asarray(logs, np.float64), powers)
    small = np.abs(powers) < 1e-6
    moved = np.where(small, numbers, np.expm1(powers * numbers) / np.where(small, 1, powers))
    return np.where(np.isnan(powers), numbers, moved)


def _unpowered(number: float, power: float) -> float:
    """The logarithm that ``_powered`` moved there, that of 0 where it reaches no number."""
    if math.isnan(power) or abs(power) < 1e-6:
        return number
    inside = 1 + power * number
    return math.log(inside) / power if inside > 0 else -math.inf
