"""How likely a plan accepts lots of any quality, and what it risks.

The number of nonconforming items in a random sample of a lot of known size is hypergeometric (type A), and binomial
where the lot is one of a series or much larger than the sample (type B): ISO 2859-1:1999, 12.2; Montgomery,
Introduction to statistical quality control, 15.2.2. Under reduced inspection a lot between Ac and Re is accepted, too.
"""
from __future__ import annotations

import numpy as np
from scipy import stats

from .sampling_plan import OperatingCharacteristic, SamplingPlan

CONSUMERS_RISK = 0.10  # ISO 2859-1:1999, 12.6: the limiting quality is that accepted with 10 %
CURVE_POINTS = 101
_REACH = 2.5  # times the limiting quality: where the curve ends
HYPERGEOMETRIC, BINOMIAL = "hypergeometric", "binomial"


def operating_characteristic(plan: SamplingPlan, of_series: bool = False) -> OperatingCharacteristic:
    """Of the lot itself, or ``of_series``: of a production that many such lots come from."""
    distribution = BINOMIAL if of_series else HYPERGEOMETRIC
    limiting = limiting_quality(plan, CONSUMERS_RISK, of_series)
    consumers = float(acceptance_probability(plan, np.array([limiting]), of_series)[0])
    end = min(1.0, _REACH * max(limiting, plan.aql / 100))
    shares = np.linspace(0, end, CURVE_POINTS)
    if not of_series:
        shares = np.unique(np.rint(shares * plan.lot_size)) / plan.lot_size
    accepted = acceptance_probability(plan, shares, of_series)
    return OperatingCharacteristic(
        tuple(shares.tolist()), tuple(accepted.tolist()), producers_risk(plan, of_series), limiting, consumers,
        distribution,
    )


def acceptance_probability(plan: SamplingPlan, shares: np.ndarray, of_series: bool = False) -> np.ndarray:
    """For shares of nonconforming items; of a lot those are rounded to whole items."""
    most, shares = plan.rejection_number - 1, np.asarray(shares, float)
    if of_series:
        return stats.binom.cdf(most, plan.sample_size, shares)
    return stats.hypergeom.cdf(most, plan.lot_size, np.rint(shares * plan.lot_size), plan.sample_size)


def allowed_at_aql(plan: SamplingPlan) -> int:
    """How many items of the lot are nonconforming where it is as good as the AQL."""
    return int(np.floor(plan.aql / 100 * plan.lot_size + 1e-9))


def producers_risk(plan: SamplingPlan, of_series: bool = False) -> float:
    """The probability that a lot with as many nonconforming items as the AQL allows is rejected."""
    share = plan.aql / 100 if of_series else allowed_at_aql(plan) / plan.lot_size
    return float(1 - acceptance_probability(plan, np.array([share]), of_series)[0])


def limiting_quality(plan: SamplingPlan, risk: float = CONSUMERS_RISK, of_series: bool = False) -> float:
    """The smallest share of nonconforming items at which a lot is accepted with at most this probability."""
    if of_series:  # of the binomial it is a quantile of the beta distribution (Clopper and Pearson 1934)
        most = plan.rejection_number - 1
        return float(stats.beta.ppf(1 - risk, most + 1, plan.sample_size - most)) if most < plan.sample_size else 1.0
    few, many = 0, plan.lot_size  # of the nonconforming items: with none the lot is accepted, with all it is not
    while many - few > 1:
        middle = (few + many) // 2
        if acceptance_probability(plan, np.array([middle / plan.lot_size]))[0] <= risk:
            many = middle
        else:
            few = middle
    return many / plan.lot_size
