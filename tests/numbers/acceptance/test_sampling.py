"""Samples, their risks and sizes, held against simulations and scipy."""
from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats
from seam_inspector.plugin.acceptance.measure.measured_pieces import failed_share_interval
from seam_inspector.plugin.acceptance.measure.sampling_plans import (
    LIMITING_QUALITIES,
    REDUCED,
    isolated_lot_plan,
    single_sampling_plan,
)
from seam_inspector.plugin.acceptance.measure.sampling_risks import (
    StatedRisk,
    acceptance_probability,
    intraclass_correlation,
    limiting_quality,
    operating_characteristic,
    plan_by_risk,
    stratified_sample,
)
from seam_inspector.plugin.imagery.errors import SettingsError

RISK = StatedRisk(0.01, 0.05, 0.08, 0.10)


@pytest.mark.slow
def test_the_characteristic_is_that_of_2000_drawn_lots() -> None:
    random, lots, size = np.random.default_rng(3), 2000, 1000
    plan = single_sampling_plan(size, "1.0")
    strata = np.repeat(np.arange(5), 200).tolist()
    for share in (0.005, 0.01, 0.02, 0.04, 0.065):
        accepted = 0
        for seed in range(lots):
            failing = np.zeros(size, bool)
            failing[random.choice(size, round(share * size), replace=False)] = True
            accepted += failing[stratified_sample(strata, plan.sample_size, seed)].sum() <= plan.acceptance_number
        expected = float(acceptance_probability(plan, np.array([share]))[0])
        error = math.sqrt(max(expected * (1 - expected), 1e-3) / lots)
        assert accepted / lots == pytest.approx(expected, abs=3.5 * error), share


@pytest.mark.parametrize(
    ("lot", "aql", "limiting"),
    [  # as the standard's table for normal inspection of a series has it, in %
        (1000, "1.0", 6.5), (1000, "0.15", 2.84), (1000, "2.5", 11.3), (150, "4.0", 24.5), (10_000, "1.0", 4.6),
        (15, "4.0", 53.6),
    ],
)  # fmt: skip
def test_limiting_quality_is_the_published_one(lot: int, aql: str, limiting: float) -> None:
    plan = single_sampling_plan(lot, aql)
    as_of_series = replace(plan, lot_size=1_000_000)
    assert 100 * limiting_quality(as_of_series) == pytest.approx(limiting, rel=0.03)


def test_the_curve_falls_from_one_and_risks_lie_on_it() -> None:
    plan = single_sampling_plan(1000, "1.0")
    for lot in (1000, 1_000_000):
        large = replace(plan, lot_size=lot)
        curve = operating_characteristic(large)
        assert curve.accepted[0] == pytest.approx(1)
        assert np.diff(curve.accepted).max() <= 1e-12
        at = acceptance_probability(large, np.array([curve.limiting_quality]))[0]
        assert at <= 0.10 + 1e-9
        assert at == pytest.approx(0.10, abs=0.01)
    of_series = 1 - stats.binom.cdf(2, 80, 0.01)
    assert operating_characteristic(large).producers_risk == pytest.approx(of_series, rel=1e-3)
    assert operating_characteristic(plan).producers_risk == pytest.approx(1 - stats.hypergeom.cdf(2, 1000, 10, 80))


@pytest.mark.parametrize("lq", LIMITING_QUALITIES)
def test_an_isolated_lot_as_bad_as_its_limiting_quality_is_hardly_ever_accepted(lq: str) -> None:
    lots = [*range(16, 400, 3), 500, 1200, 3200, 10_000, 35_000, 150_000, 500_000, 2_000_000]
    plans = [plan for lot in lots if not (plan := isolated_lot_plan(lot, lq)).is_whole_lot]
    risks = [
        stats.hypergeom.cdf(one.acceptance_number, one.lot_size, math.ceil(one.lot_size * float(lq) / 100),
                            one.sample_size) for one in plans
    ]  # fmt: skip
    assert [operating_characteristic(one).consumers_risk for one in plans] == pytest.approx(risks)
    # the standard: usually below 10 %, always below 13 %; its plan for the smallest lots at 2 % is not
    assert max(risk for risk, one in zip(risks, plans) if lq != "2.00" or one.lot_size > 90) < 0.13
    assert np.mean(np.array(risks) < 0.10) > 0.7
    for one in plans:
        found = operating_characteristic(one)
        worse = found.good_quality + 1 / one.lot_size
        rejected = 1 - acceptance_probability(one, np.array([found.good_quality, worse]))
        assert rejected[0] == pytest.approx(found.producers_risk)
        assert rejected[0] <= 0.05 or round(found.good_quality * one.lot_size) == 1
        assert rejected[1] > 0.05


def test_a_whole_lot_has_no_risk() -> None:
    plan = single_sampling_plan(40, "0.10")
    assert operating_characteristic(plan).producers_risk == 0
    assert limiting_quality(plan) == pytest.approx(1 / 40)


def test_reduced_inspection_accepts_up_to_its_rejection_number() -> None:
    plan = single_sampling_plan(2000, "0.65", severity=REDUCED)
    found = acceptance_probability(plan, np.array([0.02]))[0]
    assert found == pytest.approx(stats.hypergeom.cdf(2, 2000, 40, 50))


@given(st.lists(st.integers(1, 60), min_size=1, max_size=8), st.integers(0, 200), st.integers(0, 2**31))
def test_a_sample_is_in_proportion_and_repeats(sizes: list[int], count: int, seed: int) -> None:
    strata = [number for number, size in enumerate(sizes) for _ in range(size)]
    drawn = stratified_sample(strata, count, seed)
    assert drawn == stratified_sample(strata, count, seed)
    assert len(set(drawn)) == len(drawn) == min(count, len(strata))
    for number, size in enumerate(sizes):
        exact = size * len(drawn) / len(strata)
        assert math.floor(exact + 1e-9) <= sum(strata[place] == number for place in drawn) <= math.ceil(exact - 1e-9)


def test_each_item_is_drawn_as_often_as_any_other() -> None:
    strata = [0] * 7 + [1] * 5 + [2] * 1
    counts = np.zeros(13)
    for seed in range(6000):
        counts[stratified_sample(strata, 4, seed)] += 1
    assert stats.chisquare(counts).pvalue > 1e-3


@pytest.mark.parametrize("lot", [1000, 5000])
def test_a_plan_for_stated_risks_keeps_both_and_is_the_smallest(lot: int) -> None:
    found = plan_by_risk(lot, RISK)
    good, bad = lot // 100, 8 * lot // 100

    def keeps(number: int, size: int) -> bool:
        accepted = stats.hypergeom.cdf(number, lot, [good, bad], size)
        return bool(accepted[0] >= 0.95 and accepted[1] <= 0.10)

    size = found.plan.sample_size
    assert keeps(found.plan.acceptance_number, size)
    assert not any(keeps(c, n) for n in range(1, size) for c in range(min(n, 8)))
    kept = stats.hypergeom.cdf(found.plan.acceptance_number, lot, [good, bad], size)
    assert (1 - found.producers_risk, found.consumers_risk) == pytest.approx(tuple(kept))


def test_a_plan_for_a_large_lot_is_that_of_the_binomial_distribution() -> None:
    found = plan_by_risk(10**7, RISK)
    size = next(
        n for n in range(1, 300)
        if any(stats.binom.cdf(c, n, 0.01) >= 0.95 and stats.binom.cdf(c, n, 0.08) <= 0.10 for c in range(8))
    )  # fmt: skip
    assert found.plan.sample_size == size


@pytest.mark.parametrize(("sizes", "correlation"), [
    ([20] * 50, 0.1), ([20] * 50, 0.3), ([10] * 100, 0.4), ([5, 60] * 200, 0.3), ([100] * 10, 0.3),
])  # fmt: skip
def test_the_risks_of_a_plan_are_those_of_simulated_lots(sizes: list[int], correlation: float) -> None:
    random, members, lots = np.random.default_rng(8), np.array(sizes), 4000
    stated = StatedRisk(0.01, 0.05, 0.05, 0.10)
    found = plan_by_risk(int(members.sum()), stated, correlation, float((members**2).sum() / members.sum()))
    near = 0.015 if len(sizes) > 10 else 0.035  # of so few seams two moments do not tell all
    accepted = []
    for share in (0.01, 0.05):
        spread = (1 - correlation) / correlation
        own = random.beta(share * spread, (1 - share) * spread, (lots, len(sizes)))
        failing = random.binomial(members, own).sum(1)
        drawn = random.hypergeometric(failing, members.sum() - failing, found.plan.sample_size)
        accepted.append(float((drawn <= found.plan.acceptance_number).mean()))
    assert (found.producers_risk, found.consumers_risk) == pytest.approx((1 - accepted[0], accepted[1]), abs=near)
    if not found.plan.is_whole_lot:
        assert found.producers_risk <= 0.05
        assert found.consumers_risk <= 0.10


def test_clustering_makes_the_sample_larger() -> None:
    plain, clustered = plan_by_risk(1000, RISK), plan_by_risk(1000, RISK, 0.3, 20)
    assert clustered.independent_size == plain.plan.sample_size
    assert clustered.plan.sample_size > 1.3 * plain.plan.sample_size
    assert clustered.design_effect == pytest.approx(clustered.plan.sample_size / plain.plan.sample_size)


def test_a_lot_that_is_too_small_is_inspected_whole_and_says_what_it_keeps() -> None:
    found = plan_by_risk(60, RISK, 0.9, 30)
    assert found.plan.is_whole_lot
    assert found.producers_risk > RISK.producers_risk or found.consumers_risk > RISK.consumers_risk
    assert plan_by_risk(1, RISK, 1.0, 1).plan.is_whole_lot
    assert plan_by_risk(30, RISK, 1.0, 30).plan.is_whole_lot


@pytest.mark.parametrize("risk", [StatedRisk(0.08, 0.05, 0.01, 0.1), StatedRisk(0.01, 0, 0.08, 0.1),
                                  StatedRisk(0.01, 0.05, 1.5, 0.1), StatedRisk(0.02, 1e-4, 0.0201, 1e-4)])
def test_risks_that_make_no_plan_are_refused(risk: StatedRisk) -> None:
    with pytest.raises(SettingsError):
        plan_by_risk(10**7, risk)


def clustered_pieces(random: np.random.Generator, seams: int, share: float, correlation: float) -> tuple:
    """Lengths, failures and seams: each seam fails by its own share, beta-distributed."""
    sizes = random.integers(2, 20, seams)
    spread = (1 - correlation) / correlation
    own = random.beta(share * spread, (1 - share) * spread, seams)
    cluster = np.repeat(np.arange(seams), sizes)
    failed = random.random(len(cluster)) < own[cluster]
    return random.uniform(10, 25, len(cluster)), failed, cluster.tolist()


@pytest.mark.parametrize(("seams", "share", "correlation"), [(20, 0.1, 0.3), (60, 0.02, 0.05), (60, 0.4, 0.7),
                                                             (200, 0.02, 0.3)])
def test_the_interval_of_the_share_holds_it(seams: int, share: float, correlation: float) -> None:
    random, held = np.random.default_rng(1), 0
    for _ in range(400):
        interval = failed_share_interval(*clustered_pieces(random, seams, share, correlation))
        held += interval is not None and interval.low <= share <= interval.high
    assert held / 400 >= 0.90


@pytest.mark.parametrize(("sizes", "share", "correlation"), [
    ([5] * 10 + [60] * 10, 0.05, 0.4), ([5] * 10 + [60] * 10, 0.05, 0.2), ([2] * 15 + [40] * 5, 0.1, 0.3),
    ([10] * 9 + [100], 0.05, 0.3), ([20] * 10, 0.1, 0.5),
])  # fmt: skip
def test_the_interval_holds_the_share_where_seams_are_unequal_or_few(
    sizes: list[int], share: float, correlation: float
) -> None:
    random, held = np.random.default_rng(4), 0
    spread = (1 - correlation) / correlation
    cluster = np.repeat(np.arange(len(sizes)), sizes)
    for _ in range(400):
        own = random.beta(share * spread, (1 - share) * spread, len(sizes))
        failed = random.random(len(cluster)) < own[cluster]
        interval = failed_share_interval([25.0] * len(cluster), failed.tolist(), cluster.tolist())
        held += interval is not None and interval.low <= share <= interval.high
    assert held / 400 >= 0.90


def test_few_failures_on_one_seam_do_not_make_a_narrow_interval() -> None:
    sizes = [5] * 10 + [60] * 10
    cluster = np.repeat(np.arange(20), sizes).tolist()
    few = failed_share_interval([25.0] * 650, [False] * 647 + [True] * 3, cluster)
    none = failed_share_interval([25.0] * 650, [False] * 650, cluster)
    assert few is not None
    assert none is not None
    assert few.high >= none.high > 0.05


def test_the_interval_of_independent_pieces_is_that_of_clopper_and_pearson() -> None:
    failed = [True] * 6 + [False] * 94
    found = failed_share_interval([10.0] * 100, failed, range(100))
    exact = stats.binomtest(6, 100).proportion_ci(method="exact")
    assert found is not None
    assert (found.low, found.high) == pytest.approx((exact.low, exact.high), rel=0.06)


def test_pieces_of_a_seam_that_are_no_more_alike_than_others_count_one_by_one() -> None:
    """Fifty seams of two pieces, both, one or none of which failed as often as if thirty had been drawn of all."""
    failed, seams = [True] * 10 + [True, False] * 20 + [False] * 50, np.repeat(np.arange(50), 2).tolist()
    found = failed_share_interval([10.0] * 100, failed, seams)
    exact = stats.binomtest(30, 100).proportion_ci(method="exact")
    assert found is not None
    assert (found.low, found.high) == pytest.approx((exact.low, exact.high), rel=0.06)


def test_seams_that_do_not_vary_at_all_count_as_one_piece_each() -> None:
    found = failed_share_interval([10.0] * 8, [True, False] * 4, [0, 0, 1, 1, 2, 2, 3, 3])
    exact = stats.binomtest(2, 4).proportion_ci(method="exact")
    assert found is not None
    assert (found.low, found.high) == pytest.approx((exact.low, exact.high))


def test_how_much_alike_pieces_of_a_seam_are_is_found() -> None:
    random = np.random.default_rng(2)
    found = [intraclass_correlation(*clustered_pieces(random, 150, 0.3, 0.4)[1:]) for _ in range(30)]
    assert np.mean([value for value in found if value is not None]) == pytest.approx(0.4, abs=0.04)
    assert intraclass_correlation([True, True, False, False], [0, 0, 1, 1]) == pytest.approx(1)
    assert intraclass_correlation([True, False], [0, 0]) is None
    assert intraclass_correlation([True] * 4, [0, 0, 1, 1]) is None
