"""What plans of sampling risk, and the drawing of samples.

The number of nonconforming items in a random sample of a lot of known size is hypergeometric (type A): ISO
2859-1:1999, 12.2; Montgomery, Introduction to statistical quality control, 15.2.2.
Items are drawn at random, and where a lot has parts, from each in proportion to its size (8.1 and 8.2).
"""
from __future__ import annotations

import math
from collections.abc import Callable, Hashable, Sequence

import numpy as np
from scipy import stats

from .sampling_plans import OperatingCharacteristic, SamplingPlan

CONSUMERS_RISK = 0.10  # ISO 2859-1:1999, 12.6: the limiting quality is that accepted with 10 %
PRODUCERS_RISK = 0.05
_LAST_DIGITS = 1e-9


def operating_characteristic(plan: SamplingPlan) -> OperatingCharacteristic:
    good, limiting = good_items(plan) / plan.lot_size, limiting_quality(plan)
    producers, consumers = 1 - acceptance_probability(plan, good), acceptance_probability(plan, limiting)
    return OperatingCharacteristic(good, float(producers), limiting, float(consumers))


def acceptance_probability(plan: SamplingPlan, shares: np.ndarray | float) -> np.ndarray:
    """For shares of nonconforming items, which are rounded to whole items of the lot."""
    items = np.rint(np.asarray(shares, float) * plan.lot_size)
    return stats.hypergeom.cdf(plan.acceptance_number, plan.lot_size, items, plan.sample_size)


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
