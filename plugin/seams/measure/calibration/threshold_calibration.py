"""Judging the judge: how well a measure tells the windows where an observer saw a loss from those where he saw none.

A measure is low where detail was lost. At a threshold t every window with measure <= t is flagged (of the visibility,
which is high there, with measure >= t); sensitivity is the share of the visible losses that are flagged, specificity
the share of the invisible ones that are not. Both for all t are the ROC curve; the area under it is the probability
that a visible loss has the lower value (Hanley and McNeil 1982). Pyka 2010, section 6, asks for it: limits of loss
need research on statistically significant samples.

The threshold is that with the largest Youden index of two normal distributions. The best step of the judged windows
themselves jumps from one window's value to another's: it errs like the cube root of their number, and a bootstrap of it
does not hold (Kim and Pollard 1990, Annals of Statistics 18, 191-219; Abrevaya and Huang 2005, Econometrica 73,
1175-1204). That of fitted distributions (Fluss, Faraggi and Reiser 2005, Biometrical Journal 47, 458-472) moves evenly
with every verdict, errs half as much, and can be resampled.

Windows that lie near each other tell less than as many far apart: they share ground, sources and feathering. So judged
windows are put into neighbourhoods, and resampled neighbourhood by neighbourhood (the cluster bootstrap: Davison and
Hinkley 1997, section 3.8; blocks of a long row: Kuensch 1989, Annals of Statistics 17, 1217-1241).

And how well two observers agree on the windows that both judged (Cohen's kappa).
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import Polynomial
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree
from scipy.special import ndtr

from ....imagery import limits as imagery_limits
from ....imagery.errors import Message
from ....imagery.grids import Extent
from ....imagery.statistics import DECIDED, NORMAL_95, Interval, critical_t
from .. import limits, messages

STANDARD_LIMITS = {
    "kept_1": limits.MAX_SIGNIFICANT_KEPT, "ratio_1": imagery_limits.MAX_SIGNIFICANT_RATIO,
    "visibility": limits.JUST_VISIBLE,
}  # fmt: skip
"""What the plugin itself takes a measure to tell a loss at."""

MIN_VERDICTS = 5  # of either kind: below it one verdict moves the sensitivity by more than 20 %
PERCENTILES_95 = (2.5, 97.5)  # the ends of a 95 % interval
WANTED_AREA_ERROR = 0.05  # half of the 95 % interval of an area under the ROC curve that is known well enough
_ROUNDING = 1 / 40  # of the threshold's range: a twentieth of what it is off by at most, so nothing is lost
_FINEST_STEP = 1e-9  # a threshold that has to stay below a number stays that far below it


@dataclass(frozen=True)
class Verdicts:
    """The values of one measure in the windows that an observer judged; none of them NaN."""

    measure: str
    """Name of the field it comes from."""
    visible: tuple[float, ...]
    """Windows where a loss was seen."""
    invisible: tuple[float, ...]
    """Windows where none was seen."""
    places: tuple[Sequence[int], Sequence[int]] | None = None
    """The neighbourhoods of the visible and of the invisible verdicts; None where every window stands for itself."""
    is_loss: bool = False
    """Whether the measure is high where detail was lost."""


def verdicts_of(
    measure: str, values: Sequence[tuple[Extent | None, bool, float]], is_loss: bool = False
) -> Verdicts:
    """Verdicts of judged windows: where each lies, whether a loss was seen there, and the measure's value."""
    places = np.array(find_neighbourhoods([extent for extent, _, _ in values]), int)
    seen, measured = np.array([seen for _, seen, _ in values], bool), np.array([value for *_, value in values], float)
    visible, invisible = (tuple(measured[kind].tolist()) for kind in (seen, ~seen))
    return Verdicts(measure, visible, invisible, (places[seen].tolist(), places[~seen].tolist()), is_loss)


@dataclass(frozen=True)
class Step:
    """What a threshold does to the judged windows."""

    threshold: float
    """Windows with the measure at or below it, for one of loss at or above it, are flagged."""
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
class ThresholdCalibration:
    """What the verdicts say of one measure."""

    verdicts: Verdicts
    steps: tuple[Step, ...] = ()
    """One for each value that occurs, that which flags least first: between two values nothing changes. Empty with too
    few verdicts."""
    area: Interval | None = None
    """Under the ROC curve; 0.5 is a guess, 1 is without fault. None with too few verdicts."""
    best: Step | None = None
    """The threshold with the largest Youden index of fitted distributions; None where it can't be set or is a guess."""
    best_range: tuple[float, float] | None = None
    """The interval of the best threshold of all windows like these, 95 %."""
    wanted: tuple[int, int] | None = None
    """How many visible and invisible verdicts would be enough; None with too few to say."""
    neighbourhoods: int | None = None
    """How many neighbourhoods the judged windows form; None where they were taken as if each stood for itself."""
    notices: tuple[Message, ...] = ()
    """Why there is no number, or how far to trust it."""


def calibrate(verdicts: Verdicts, most: float = math.inf) -> ThresholdCalibration:
    """Area, best threshold and verdicts wanted of one measure.

    ``most``: the threshold has to stay below it, as one that can be set does. With fewer than five visible or five
    invisible verdicts there is a notice and no number.
    """
    sign = -1 if verdicts.is_loss else 1  # below, what is lost is low
    visible, invisible = (sign * np.array(kind, np.float64) for kind in (verdicts.visible, verdicts.invisible))
    if min(len(visible), len(invisible)) < MIN_VERDICTS:
        too_few = messages.TOO_FEW_VERDICTS(
            measure=verdicts.measure, visible=len(visible), invisible=len(invisible), fewest=MIN_VERDICTS
        )
        return ThresholdCalibration(verdicts, notices=(too_few,))
    places = Neighbourhoods(*verdicts.places) if verdicts.places else None
    is_one_place = places is not None and places.fewest < MIN_NEIGHBOURHOODS
    if places is None or is_one_place:
        places = Neighbourhoods(range(len(visible)), range(len(visible), len(visible) + len(invisible)))
    area, fitted = (statistic(visible, invisible, places) for statistic in (roc_area, best_threshold))
    values = sign * np.unique(np.concatenate([visible, invisible]))
    name, reach = verdicts.measure, (fitted.high - fitted.low) * _ROUNDING
    rounded = (round(fitted.value, digits) for digits in range(12))  # the fewest decimals that are near enough
    threshold = next((value for value in rounded if abs(value - fitted.value) <= reach), fitted.value)
    step = step_at(verdicts, sign * min(threshold, most - _FINEST_STEP))
    best = step if fitted.value < most and step.youden > 0 else None
    # The range of thresholds that can be set, the given one among them.
    fitting = [best.threshold, *(sign * end for end in (fitted.low, min(fitted.high, most)))] if best else []
    ends = (max(min(fitting), 0.0) if verdicts.is_loss else min(fitting), max(fitting)) if best else None
    notices = (
        (area.low <= 0.5, messages.NO_BETTER_THAN_CHANCE(measure=name, low=area.low, high=area.high)),
        (area.value == 1, messages.VERDICTS_FULLY_APART(measure=name)),
        (fitted.value < most and best is None, messages.NO_THRESHOLD(measure=name)),
        (fitted.value >= most, messages.THRESHOLD_TOO_HIGH(measure=name, threshold=fitted.value, most=most)),
        (is_one_place, messages.VERDICTS_IN_ONE_PLACE(measure=name)),
    )  # fmt: skip
    return ThresholdCalibration(
        verdicts, tuple(step_at(verdicts, value) for value in values.tolist()), area, best, ends,
        wanted=wanted_verdicts(area.value, len(visible), len(invisible)),
        neighbourhoods=places.count if verdicts.places and not is_one_place else None,
        notices=tuple(notice for is_so, notice in notices if is_so),
    )  # fmt: skip


def step_at(verdicts: Verdicts, threshold: float) -> Step:
    """What a threshold does to judged windows, of which there is at least one of either kind."""
    hits, vain = (
        sum(value >= threshold if verdicts.is_loss else value <= threshold for value in kind)
        for kind in (verdicts.visible, verdicts.invisible)
    )
    seen, unseen = len(verdicts.visible), len(verdicts.invisible)
    return Step(threshold, hits, vain, hits / seen, (unseen - vain) / unseen)


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
    value, others = Polynomial([0, 1]), (visible + invisible) / 2 - 1
    # Hanley and McNeil's equation 1, with the mean number of both kinds in the place of either, times (2 - A)(1 + A).
    scale = (2 - value) * (1 + value)
    spread = scale + others * ((1 - value) * (1 + value) + value * (2 - value))
    apart = (area - value) ** 2 * scale * visible * invisible - NORMAL_95**2 * value * (1 - value) * spread
    low, high = np.sort(apart.roots().real)[1:3].clip(0, 1)  # of the others one is below 0 and one above 1
    return min(float(low), area), max(float(high), area)  # roots are exact to some digits


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


DEGREES_OF_FREEDOM = 1.5  # a neighbourhood less one: Welch 1947 has 1 to 2, by how alike both kinds' errors are
_LEAST_SPREAD = 0.02  # of all values' standard deviation: a kind whose values are all the same has some
_REACH = 1.5  # standard deviations beyond both means that a threshold may lie
_ALIKE = 1e-9  # share by which variances differ that are as good as equal


def best_threshold(visible: np.ndarray, invisible: np.ndarray, neighbourhoods: Neighbourhoods) -> Interval:
    """The best threshold and its 95 % interval, from the spread of the thresholds of resampled neighbourhoods.

    Of the values or, where those are likelier to be normal, of their logarithms. Few neighbourhoods tell their spread
    badly: therefore Student's distribution. No measure is negative, so none of them is.
    """
    kinds = [visible, invisible]
    values = np.concatenate(kinds)
    if np.ptp(values) == 0:
        return Interval(*[float(values[0])] * 3)
    (middle,), (is_skewed,) = _thresholds(kinds, [np.ones((1, len(kind))) for kind in kinds])
    drawn, _ = _thresholds(kinds, neighbourhoods.resamples())
    spread = float((np.log(drawn.clip(values.min())) if is_skewed else drawn).std(ddof=1))
    count = max(neighbourhoods.fewest, 1.5)
    reach = spread * float(critical_t(0.95, max(DEGREES_OF_FREEDOM * (count - 1), 1)))
    low, high = (float(middle * np.exp(end) if is_skewed else middle + end) for end in (-reach, reach))
    least = min(0.0, float(values.min()))
    return Interval(*(max(value, least) for value in (float(middle), low, high)))


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


LINK_SIDES = 2.0  # centres that far apart or less: windows that overlap, touch or leave room for one between them,
# as those of one seam do at the standard spacing
LONGEST_SIDES = 8.0  # of a block: four windows at the standard spacing
MIN_NEIGHBOURHOODS = 1.5  # of either kind: below it there is nothing to resample

RESAMPLES = 2000
"""Draws of the verdicts; Efron and Tibshirani 1993, section 12.5: 1000 and more for an interval's ends."""
_SEED = 20100705  # the same verdicts give the same interval


def find_neighbourhoods(extents: Sequence[Extent | None]) -> list[int]:
    """The number of each window's neighbourhood; a window without an outline is one of its own.

    Windows that come within a side of each other belong together; what reaches far is cut into even blocks.
    """
    placed = [place for place, extent in enumerate(extents) if extent is not None]
    if not placed:
        return list(range(len(extents)))
    left, bottom, right, top = np.array([extents[place] for place in placed], np.float64).T
    sides = np.median([right - left, top - bottom], axis=1)  # so that degrees do as well as metres
    centres = np.column_stack([left + right, bottom + top]) / 2 / np.where(sides > 0, sides, 1)
    pairs = cKDTree(centres).query_pairs(LINK_SIDES, p=np.inf, output_type="ndarray")
    links = coo_matrix((np.ones(len(pairs), bool), (pairs[:, 0], pairs[:, 1])), shape=(len(placed),) * 2)
    count, groups = connected_components(links, directed=False)
    numbers = list(range(len(extents)))
    blocks: dict[tuple[int, tuple[float, ...]], int] = {}
    for group in range(count):
        members = np.flatnonzero(groups == group)
        away = centres[members] - centres[members].min(axis=0)
        length = away.max(axis=0) + 1
        block = away // (length / np.ceil(length / LONGEST_SIDES))
        for member, key in zip(members.tolist(), map(tuple, block.tolist())):
            numbers[placed[member]] = blocks.setdefault((group, key), len(extents) + len(blocks))
    return np.unique(numbers, return_inverse=True)[1].tolist()


def effective_count(places: Sequence[int] | np.ndarray) -> float:
    """How many neighbourhoods of equal size would tell as much."""
    counts = np.bincount(places)
    return float(counts.sum() ** 2 / (counts**2).sum())


class Neighbourhoods:
    """Neighbourhoods of the judged windows of a measure, resampled as wholes."""

    def __init__(self, visible: Sequence[int], invisible: Sequence[int]) -> None:
        """The neighbourhoods' numbers, verdict by verdict."""
        self._places = np.unique(np.array([*visible, *invisible]), return_inverse=True)[1]
        self._visible = len(visible)
        self.count = int(self._places.max()) + 1
        self.fewest = min(effective_count(self._places[: len(visible)]), effective_count(self._places[len(visible) :]))
        """Effective number of those that hold verdicts of a kind, of the kind that has fewer."""

    def resamples(self) -> tuple[np.ndarray, np.ndarray]:
        """How often each visible and each invisible verdict is drawn, (resamples, verdicts).

        Neighbourhoods with visible verdicts alone, with invisible ones alone and with both are drawn among themselves,
        so that both kinds remain, and one fewer than there are, so that resamples spread as much as samples do (Rao and
        Wu 1988, Journal of the American Statistical Association 83, 231-241). A draw lacking two of a kind is left out.
        """
        seen, unseen = (
            np.bincount(kind, minlength=self.count) > 0 for kind in np.split(self._places, [self._visible])
        )
        strata = [np.flatnonzero(kind) for kind in (seen & ~unseen, unseen & ~seen, seen & unseen)]
        if 1 in map(len, strata):  # it would be alone
            strata = [np.arange(self.count)]
        random = np.random.default_rng(_SEED)
        drawn = np.empty((RESAMPLES, self.count), np.int64)
        for stratum in filter(len, strata):
            shares = np.full(len(stratum), 1 / len(stratum))
            drawn[:, stratum] = random.multinomial(len(stratum) - 1, shares, RESAMPLES)
        visible, invisible = np.split(drawn[:, self._places], [self._visible], axis=1)
        usable = (visible.sum(axis=1) >= 2) & (invisible.sum(axis=1) >= 2)
        return visible[usable], invisible[usable]


def agreement(words: Sequence[tuple[str, str]]) -> tuple[int, int, Interval | None]:
    """How many of the windows both operators judged, of how many they said the same, and ``cohen_kappa``; where one of
    the two did not judge, or was not sure, a pair of words does not count."""
    table = np.zeros((2, 2), np.int64)
    for first, second in words:
        if first in DECIDED and second in DECIDED:
            table[DECIDED.index(first), DECIDED.index(second)] += 1
    return int(table.sum()), int(table.trace()), cohen_kappa(table)


def cohen_kappa(table: np.ndarray) -> Interval | None:
    """Cohen's kappa of a square table of counts (first's word, second's word), with its 95 % interval.

    Cohen 1960 (Educational and Psychological Measurement 20, 37-46); the standard error is that of Fleiss, Cohen and
    Everitt 1969 (Psychological Bulletin 72, 323-327). It is zero where all agree or none, however few they are; the
    other end is then the kappa of as many exceptions as the score interval of none in n allows (Wilson 1927). None for
    an empty table, and where one observer used one word only: kappa is 0 then whatever the other one said.
    """
    count = float(table.sum())
    if count == 0:
        return None
    shares = table / count
    rows, columns = shares.sum(axis=1), shares.sum(axis=0)
    if rows.max() == 1 or columns.max() == 1:
        return None
    by_chance = float(rows @ columns)
    agreed = float(shares.trace())
    kappa = (agreed - by_chance) / (1 - by_chance)
    exceptions = NORMAL_95**2 / (count + NORMAL_95**2)
    if agreed == 1:
        return Interval(1.0, (1 - exceptions - by_chance) / (1 - by_chance), 1.0)
    if agreed == 0:
        return Interval(kappa, kappa, (exceptions - by_chance) / (1 - by_chance))
    same, rest = shares.diagonal(), 1 - kappa
    marginals = (columns[:, np.newaxis] + rows) ** 2
    agreeing = float((same * (1 - (rows + columns) * rest) ** 2).sum())
    apart = rest**2 * float((shares * marginals).sum() - (same * marginals.diagonal()).sum())
    spread = agreeing + apart - (kappa - by_chance * rest) ** 2  # Fleiss, Cohen and Everitt 1969, equation 13
    reach = NORMAL_95 * math.sqrt(max(spread, 0.0) / count) / (1 - by_chance)
    return Interval(kappa, max(kappa - reach, -1.0), min(kappa + reach, 1.0))
