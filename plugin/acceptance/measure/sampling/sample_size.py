"""How many items make a plan whose risks are given, also where items come in clusters."""
from __future__ import annotations

import math
from dataclasses import dataclass

from scipy import stats

from ....imagery.errors import SettingsError
from .. import messages
from .sampling_plan import SamplingPlan

MOST_NUMBER = 300  # of the acceptance number: beyond it the two qualities are as good as one
BY_RISK = "risk"
_LAST_DIGITS = 1e-9
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
    independent_size: int
    """How many items it would take if they had nothing to do with each other."""
    producers_risk: float
    """That it keeps."""
    consumers_risk: float
    """That it keeps; one of the two is larger than was asked for where the lot is too small."""

    @property
    def design_effect(self) -> float:
        """By how much the sample grew since items are alike."""
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
    plan = SamplingPlan(lot_size, size, number, number + 1, 100 * risk.good_share, "", BY_RISK, "", "")
    return RiskPlan(plan, independent[1] if independent else lot_size, producers, consumers)


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
    while many - few > 1:
        middle = (few + many) // 2
        few, many = (few, middle) if is_rare(middle) else (middle, many)
    return many


def _fairest(lots: _Lots, risk: StatedRisk) -> int:
    """The acceptance number with which all of a lot comes nearest to both risks."""
    few, many = -1, lots.size  # the producer's risk falls with the number, the consumer's grows
    while many - few > 1:
        middle = (few + many) // 2
        producers, consumers = lots.risks(middle, lots.size, risk)
        if producers / risk.producers_risk > consumers / risk.consumers_risk:
            few = middle
        else:
            many = middle
    return many
