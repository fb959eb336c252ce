"""What plans of sampling risk, how many items keep stated risks, and the drawing of them.

The number of nonconforming items in a random sample of a lot of known size is hypergeometric (type A): ISO
2859-1:1999, 12.2; Montgomery, Introduction to statistical quality control, 15.2.2. Under reduced inspection a lot
between Ac and Re is accepted, too.
Items are drawn at random, and where a lot has parts, from each in proportion to its size (8.1 and 8.2).
"""
from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import stats

from ...imagery.errors import SettingsError
from . import messages
from .sampling_plans import OperatingCharacteristic, SamplingPlan

CONSUMERS_RISK = 0.10  # ISO 2859-1:1999, 12.6: the limiting quality is that accepted with 10 %
PRODUCERS_RISK = 0.05
CURVE_POINTS = 101
_LAST_DIGITS = 1e-9
_REACH = 2.5  # times the limiting quality: where the curve ends


def operating_characteristic(plan: SamplingPlan) -> OperatingCharacteristic:
    """Operating characteristic of the lot itself."""
    good = good_items(plan) / plan.lot_size
    limiting = limiting_quality(plan)
    producers, consumers = 1 - acceptance_probability(plan, good), acceptance_probability(plan, limiting)
    end = min(1.0, _REACH * max(limiting, (plan.aql or 0.0) / 100))
    shares = np.unique(np.rint(np.linspace(0, end, CURVE_POINTS) * plan.lot_size)) / plan.lot_size
    accepted = acceptance_probability(plan, shares)
    return OperatingCharacteristic(
        tuple(shares.tolist()), tuple(accepted.tolist()), good, float(producers), limiting, float(consumers)
    )


def acceptance_probability(plan: SamplingPlan, shares: np.ndarray | float) -> np.ndarray:
    """For shares of nonconforming items, which are rounded to whole items of the lot."""
    items = np.rint(np.asarray(shares, float) * plan.lot_size)
    return stats.hypergeom.cdf(plan.rejection_number - 1, plan.lot_size, items, plan.sample_size)


def good_items(plan: SamplingPlan) -> int:
    """How many items of a lot are nonconforming that is as good as the AQL; of an isolated lot the most with which it
    is rejected with 5 % at most, or one."""
    def is_often_rejected(items: int) -> bool:
        return bool(1 - acceptance_probability(plan, items / plan.lot_size) > PRODUCERS_RISK)

    if plan.aql is None:
        return max(_first(is_often_rejected, 0, plan.lot_size) - 1, 1)
    return int(np.floor(plan.aql / 100 * plan.lot_size + 1e-9))


def limiting_quality(plan: SamplingPlan) -> float:
    """The smallest share of nonconforming items at which a lot is accepted with a probability of 10 % at most; of an
    isolated lot as many whole items as its limiting quality makes."""
    def is_rare(items: int) -> bool:
        return bool(acceptance_probability(plan, items / plan.lot_size) <= CONSUMERS_RISK)

    if plan.lq is not None:
        return math.ceil(plan.lq / 100 * plan.lot_size - _LAST_DIGITS) / plan.lot_size
    return _first(is_rare, 0, plan.lot_size) / plan.lot_size  # with none the lot is accepted, with all it is not


def _first(holds: Callable[[int], bool], below: int, known: int) -> int:
    """The smallest number for which something holds, as it does for all larger ones: above ``below``, where it does not
    hold, and at most the one for which that is ``known``; by bisection."""
    while known - below > 1:
        middle = (below + known) // 2
        below, known = (below, middle) if holds(middle) else (middle, known)
    return known


MOST_NUMBER = 300  # of the acceptance number: beyond it the two qualities are as good as one
BY_RISK = "risk"
_MOST_ALIKE = 1 - 1e-6


@dataclass(frozen=True)
class StatedRisk:
    """Two qualities, and how often each may be taken for the other."""

    good_share: float
    """Share of nonconforming items with which lots should be accepted (the producer's risk quality), 0 to 1."""
    producers_risk: float
    """With which probability they may be rejected nevertheless."""
    bad_share: float
    """Share with which lots should be rejected (the consumer's risk quality)."""
    consumers_risk: float
    """With which probability they may be accepted nevertheless."""

    def check(self) -> None:
        """Raise SettingsError for numbers that make no plan."""
        if not 0 <= self.good_share < self.bad_share <= 1:
            raise SettingsError(messages.QUALITIES_CROSSED(good=100 * self.good_share, bad=100 * self.bad_share))
        if not (0 < self.producers_risk < 1 and 0 < self.consumers_risk < 1):
            raise SettingsError(
                messages.RISK_OUT_OF_RANGE(producers=100 * self.producers_risk, consumers=100 * self.consumers_risk)
            )


@dataclass(frozen=True)
class RiskPlan:
    """A plan for stated risks."""

    plan: SamplingPlan
    correlation: float
    """How much alike items of one cluster were taken to be."""
    independent_size: int
    """How many items it would take if they had nothing to do with each other."""
    producers_risk: float
    """That it keeps."""
    consumers_risk: float
    """That it keeps; one of the two is larger than was asked for where the lot is too small."""

    @property
    def design_effect(self) -> float:
        """Factor by which the sample grew since items are alike."""
        return self.plan.sample_size / self.independent_size


@dataclass(frozen=True)
class _Lots:
    """Lots of a size, the items of which are alike by ``correlation``, any two of them."""

    size: int
    correlation: float

    def accepted(self, number: int, sample: int, share: float, is_bad: bool) -> float:
        """How often at most ``number`` of a sample are nonconforming.

        Of items that are not alike it is this lot that has the share, in whole items. Of others it is the production:
        the count is beta-binomial, in the sample as in the lot, as all counts of items that are alike in pairs.
        """
        if self.correlation <= 0:
            exact = share * self.size
            items = math.ceil(exact - _LAST_DIGITS) if is_bad else math.floor(exact + _LAST_DIGITS)
            return float(stats.hypergeom.cdf(number, self.size, items, sample))
        if share in (0.0, 1.0):
            return float(number >= share * sample)
        spread = (1 - self.correlation) / self.correlation
        return float(stats.betabinom.cdf(number, sample, share * spread, (1 - share) * spread))

    def risks(self, number: int, sample: int, risk: StatedRisk) -> tuple[float, float]:
        """The producer's and the consumer's."""
        rejected = 1 - self.accepted(number, sample, risk.good_share, is_bad=False)
        return max(rejected, 0.0), self.accepted(number, sample, risk.bad_share, is_bad=True)


def plan_by_risk(lot_size: int, risk: StatedRisk, correlation: float = 0.0, cluster_size: float = 1.0) -> RiskPlan:
    """The smallest plan that keeps both risks (Hald 1981, Statistical theory of sampling inspection, 2.3).

    Items of one cluster are alike by ``correlation``, and ``cluster_size`` is that of the cluster an item lies in, on
    average over items. A sample cannot be larger than the lot: where not even all of it keeps both risks all of it is
    inspected, against the number that comes nearest to both.
    """
    risk.check()
    if lot_size < 1:
        raise SettingsError(messages.LOT_EMPTY())
    independent = _smallest(_Lots(lot_size, 0.0), risk)
    # of two items drawn at random from the lot: that they are of one cluster, times how much alike these are
    alike = correlation * (min(cluster_size, lot_size) - 1) / max(lot_size - 1, 1)
    lots = _Lots(lot_size, min(alike, _MOST_ALIKE))
    found = _smallest(lots, risk)
    number, size = found or (_fairest(lots, risk), lot_size)
    producers, consumers = lots.risks(number, size, risk)
    plan = SamplingPlan(lot_size, size, number, number + 1, 100 * risk.good_share, "", BY_RISK, "")
    return RiskPlan(plan, correlation, independent[1] if independent else lot_size, producers, consumers)


def _smallest(lots: _Lots, risk: StatedRisk) -> tuple[int, int] | None:
    """Acceptance number and sample size; None where the lot is too small."""
    size = 0
    for number in range(MOST_NUMBER):
        fewest = _fewest(lots, number, max(size, number), risk)
        if fewest is None:
            return None
        size = fewest
        if lots.risks(number, size, risk)[0] <= risk.producers_risk:
            return number, size
    raise SettingsError(messages.QUALITIES_TOO_NEAR(good=100 * risk.good_share, bad=100 * risk.bad_share))


def _fewest(lots: _Lots, number: int, too_few: int, risk: StatedRisk) -> int | None:
    """The smallest sample in which as few as ``number`` of a bad lot are rare enough, more than ``too_few``."""
    def is_rare(sample: int) -> bool:
        return lots.accepted(number, sample, risk.bad_share, is_bad=True) <= risk.consumers_risk

    few, many = too_few, min(2 * too_few + 1, lots.size)
    while not is_rare(many):
        if many == lots.size:
            return None
        few, many = many, min(2 * many, lots.size)
    return _first(is_rare, few, many)


def _fairest(lots: _Lots, risk: StatedRisk) -> int:
    """The acceptance number with which all of a lot comes nearest to both risks."""
    def is_fair(number: int) -> bool:
        producers, consumers = lots.risks(number, lots.size, risk)
        return producers / risk.producers_risk <= consumers / risk.consumers_risk

    return _first(is_fair, -1, lots.size)  # the producer's risk falls with the number, the consumer's grows


MIN_CLUSTERS = 2


def intraclass_correlation(failed: Sequence[bool], clusters: Sequence[Hashable]) -> float | None:
    """How much alike the pieces of one cluster are, 0 (no more than those of others) to 1.

    The analysis of variance estimator for shares (Ridout, Demetrio and Firth 1999, Biometrics 55, 137-148), not below
    0. None where there are fewer than two clusters, no cluster has two pieces, or all pieces are the same.
    """
    values, members = np.asarray(failed, float), cluster_members(clusters)
    sizes = np.bincount(members).astype(float)
    total, count = len(values), len(sizes)
    if count < MIN_CLUSTERS or total == count or values.min() == values.max():
        return None
    means = np.bincount(members, values) / sizes
    between = float((sizes * (means - values.mean()) ** 2).sum()) / (count - 1)
    within = float(((values - means[members]) ** 2).sum()) / (total - count)
    typical = (total - float((sizes**2).sum()) / total) / (count - 1)
    spread = between + (typical - 1) * within
    return float(np.clip((between - within) / spread, 0.0, 1.0)) if spread > 0 else None


def typical_cluster_size(clusters: Sequence[Hashable]) -> float:
    """The size of the cluster that a piece lies in, on average over pieces: sum m^2 / sum m (Kish 1965, 8.2)."""
    sizes = np.bincount(cluster_members(clusters)).astype(float)
    return float((sizes**2).sum() / sizes.sum())


def cluster_members(clusters: Sequence[Hashable]) -> np.ndarray:
    """The number of each item's cluster, from 0."""
    numbers = {name: number for number, name in enumerate(dict.fromkeys(clusters))}
    return np.array([numbers[name] for name in clusters], np.int64)


def stratified_sample(strata: Sequence[Hashable], count: int, seed: int) -> list[int]:
    """Places of ``count`` items, all of them where there are no more, in the order in which they were drawn.

    ``strata``: that of each item. The same items, count and seed give the same sample. The first part of a sample of
    one stratum is a sample, too.
    """
    random = np.random.default_rng(seed)
    members: dict[Hashable, list[int]] = {}
    for place, stratum in enumerate(strata):
        members.setdefault(stratum, []).append(place)
    shares = proportional_counts([len(places) for places in members.values()], min(count, len(strata)), random)
    drawn = [
        int(place)
        for places, share in zip(members.values(), shares)
        for place in random.permutation(places)[:share]
    ]
    return [drawn[place] for place in random.permutation(len(drawn))]


def proportional_counts(sizes: Sequence[int], count: int, random: np.random.Generator) -> list[int]:
    """How many items each stratum gives.

    What is left of whole numbers goes to strata at random, a stratum with probability of its remainder (systematic
    sampling of the remainders in random order), so that each item is as likely to be drawn as any other.
    """
    exact = np.asarray(sizes, float) * count / max(sum(sizes), 1)
    counts = np.floor(exact + 1e-9).astype(int)
    missing = count - int(counts.sum())
    if missing > 0:
        order = random.permutation(len(sizes))
        reach = np.cumsum(np.clip(exact - counts, 0, None)[order])
        reach *= missing / reach[-1]
        hits = np.searchsorted(reach, random.random() + np.arange(missing), side="right")
        np.add.at(counts, order[np.minimum(hits, len(sizes) - 1)], 1)
    return counts.tolist()
