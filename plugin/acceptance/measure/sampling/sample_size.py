"""How many items make a plan whose risks are given, also where items come in clusters."""
from __future__ import annotations

from dataclasses import dataclass

from scipy import stats

from ....imagery.errors import SettingsError
from .. import messages
from .clustering import design_effect
from .sampling_plan import SamplingPlan

MOST_NUMBER = 300  # of the acceptance number: beyond it the two qualities are as good as one
BY_RISK = "risk"


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
    design_effect: float


def plan_by_risk(lot_size: int, risk: StatedRisk, correlation: float = 0.0, clusters: int = 1) -> RiskPlan:
    """The smallest plan that keeps both risks.

    The two-point plan of the binomial distribution (Hald 1981, Statistical theory of sampling inspection by attributes,
    2.3), from quantiles of the beta distribution. Items of one of ``clusters`` are alike by ``correlation``: the sample
    and its acceptance number grow by the design effect, counts divided by which are as good as binomial (Rao and Scott
    1992, Biometrics 48, 577-585). A sample cannot be larger than the lot: then all of it is inspected, and the lot is
    accepted up to the share between the two qualities that the plan would take.
    """
    risk.check()
    if lot_size < 1:
        raise SettingsError(messages.LOT_EMPTY())
    number, size = _two_point_plan(risk)
    effect, items = 1.0, float(size)
    for _ in range(100):  # more items are more of each cluster
        effect = design_effect(items / max(clusters, 1), correlation)
        if size * effect >= lot_size or abs(size * effect - items) < 0.5:
            break
        items = size * effect
    wanted = -int(-size * effect // 1)
    if wanted >= lot_size:
        acceptance, wanted = int(lot_size * (number + 0.5) / size), lot_size
    else:
        acceptance = int(number * effect)
    plan = SamplingPlan(
        lot_size, wanted, acceptance, acceptance + 1, 100 * risk.good_share, "", BY_RISK, "", ""
    )
    return RiskPlan(plan, size, effect)


def _two_point_plan(risk: StatedRisk) -> tuple[int, int]:
    """Acceptance number and sample size."""
    for number in range(MOST_NUMBER):
        size = _fewest(number, risk)
        if stats.binom.cdf(number, size, risk.good_share) >= 1 - risk.producers_risk:
            return number, size
    raise SettingsError(messages.QUALITIES_TOO_NEAR(good=100 * risk.good_share, bad=100 * risk.bad_share))


def _fewest(number: int, risk: StatedRisk) -> int:
    """The smallest sample in which as few as ``number`` of a bad lot are rare enough."""
    few, many = number, number + 1
    while stats.binom.cdf(number, many, risk.bad_share) > risk.consumers_risk:
        few, many = many, 2 * many
    while many - few > 1:
        middle = (few + many) // 2
        if stats.binom.cdf(number, middle, risk.bad_share) > risk.consumers_risk:
            few = middle
        else:
            many = middle
    return many
