"""The area under the ROC curve, its interval, and how many verdicts make that narrow."""
from __future__ import annotations

import math

import numpy as np

from ....imagery.statistics import NORMAL_95, Interval
from .neighbourhoods import Neighbourhoods

MIN_VERDICTS = 5  # of either kind: below it one verdict moves the sensitivity by more than 20 %
RESAMPLES = 2000  # of the verdicts; Efron and Tibshirani 1993, section 12.5: 1000 and more for an interval's ends
PERCENTILES_95 = (2.5, 97.5)
WANTED_AREA_ERROR = 0.05  # half of the 95 % interval of an area under the ROC curve that is known well enough


def roc_area(visible: np.ndarray, invisible: np.ndarray, neighbourhoods: Neighbourhoods) -> Interval:
    """With the percentile interval of resampled neighbourhoods."""
    values, places = np.unique(np.concatenate([visible, invisible]), return_inverse=True)
    seen, unseen = places[: len(visible)], places[len(visible) :]
    value = float(_areas(*(np.bincount(kind, minlength=len(values))[np.newaxis] for kind in (seen, unseen)))[0])
    if value in (0, 1):  # every resample has the same area, which says nothing of its error
        return Interval(value, *area_interval(value, len(visible), len(invisible)))
    areas = [
        _areas(_by_value(drawn_seen, seen, len(values)), _by_value(drawn_unseen, unseen, len(values)))
        for drawn_seen, drawn_unseen in neighbourhoods.resamples(RESAMPLES)
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


def _areas(visible: np.ndarray, invisible: np.ndarray) -> np.ndarray:
    """Areas under the ROC curve of counts (resamples, values): pairs in order, those alike for a half."""
    below = np.cumsum(visible, axis=1) - visible / 2
    return (below * invisible).sum(axis=1) / (visible.sum(axis=1) * invisible.sum(axis=1))


def _by_value(drawn: np.ndarray, places: np.ndarray, values: int) -> np.ndarray:
    """Counts of verdicts (resamples, verdicts) -> of values (resamples, values)."""
    order = np.argsort(places, kind="stable")
    own, starts = np.unique(places[order], return_index=True)
    counts = np.zeros((len(drawn), values), np.int64)
    counts[:, own] = np.add.reduceat(drawn[:, order], starts, axis=1)
    return counts
