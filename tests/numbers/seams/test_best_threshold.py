"""The best threshold: how far it errs, and how often its range covers the true one."""
from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from scipy.special import ndtr, ndtri
from seam_inspector.plugin.seams.measure.calibration.threshold_calibration import Neighbourhoods, best_threshold

from benchmarks.calibration import ALONE, POPULATIONS, Layout, Population, coverage
from tests.examples import at_most

NORMAL, LOGNORMAL = (
    next(kind for kind in POPULATIONS if kind.name == name) for name in ("normal, AUC 0.85", "lognormal, AUC 0.92")
)
VALUES = st.lists(st.integers(1, 40).map(lambda number: number / 20), min_size=5, max_size=12, unique=True)


def alone(visible: int, invisible: int) -> Neighbourhoods:
    return Neighbourhoods(range(visible), range(visible, visible + invisible))


@pytest.mark.slow
@pytest.mark.parametrize("population", [NORMAL, LOGNORMAL], ids=lambda population: population.name)
def test_the_range_covers_the_true_threshold_from_ten_verdicts_of_a_kind_on(population: Population) -> None:
    result = coverage(population, ALONE, (10, 10), runs=150)
    assert 0.91 <= result.covered <= 0.985  # 0.95, give or take what 150 runs are off by
    assert result.error < 0.75 * result.error_of_step


@pytest.mark.slow
def test_the_range_covers_where_neighbours_are_alike() -> None:
    layout = Layout("by 4", size=4, correlation=0.6)
    result = coverage(NORMAL, layout, (20, 20), runs=150)
    assert 0.9 <= result.covered <= 0.99
    as_if_alone = coverage(NORMAL, Layout("by 4", 4, 0.6), (20, 20), runs=150, are_known=False)
    assert as_if_alone.covered < result.covered - 0.04


@at_most(15)
@given(VALUES, VALUES, st.floats(0.01, 100))
@example([0.05, 0.2, 0.25, 0.35, 0.4], [0.05, 0.1, 0.15, 0.2, 0.4], 1.0)
def test_the_unit_of_a_measure_does_not_matter(visible: list[float], invisible: list[float], factor: float) -> None:
    places = alone(len(visible), len(invisible))
    threshold = best_threshold(np.array(visible), np.array(invisible), places)
    other = best_threshold(factor * np.array(visible), factor * np.array(invisible), places)
    assert [other.value, other.low, other.high] == pytest.approx(
        [factor * threshold.value, factor * threshold.low, factor * threshold.high], rel=1e-5
    )
    assert 0 <= threshold.low <= threshold.value <= threshold.high


def test_the_threshold_of_mirrored_kinds_lies_in_their_middle() -> None:
    values = np.array([-0.4, -0.1, 0.0, 0.1, 0.4])
    threshold = best_threshold(values - 0.5, values + 0.5, alone(5, 5))  # not all positive, so taken as they are
    assert threshold.value == pytest.approx(0, abs=0.01)
    assert threshold.low < 0 < threshold.high


def test_values_without_spread_have_a_threshold_between_them() -> None:
    threshold = best_threshold(np.full(5, 0.5), np.full(6, 0.8), alone(5, 6))
    assert 0.5 < threshold.value < 0.8
    same = best_threshold(np.full(5, 0.5), np.full(6, 0.5), alone(5, 6))
    assert (same.value, same.low, same.high) == (0.5, 0.5, 0.5)


def test_many_verdicts_that_are_normal_have_it_where_their_densities_cross() -> None:
    random = np.random.default_rng(1)
    visible, invisible = random.normal(0.5, 0.15, 400), random.normal(0.8, 0.15, 64)
    many = best_threshold(visible, invisible, alone(400, 64))
    fitted = (visible.mean() + invisible.mean()) / 2  # the best threshold of two normals that spread alike
    assert many.value == pytest.approx(fitted, abs=0.015)
    assert many.low < 0.65 < many.high


@pytest.mark.parametrize("spreads", [(0.1, 0.3), (0.3, 0.1), (0.2, 0.2)])
def test_no_threshold_of_the_fitted_distributions_is_better(spreads: tuple[float, float]) -> None:
    shares = (np.arange(200) + 0.5) / 200
    visible, invisible = (ndtri(shares) * spread + middle for spread, middle in zip(spreads, (-0.4, 0.4)))
    threshold = best_threshold(visible, invisible, alone(200, 200)).value
    tried = np.linspace(-2, 2, 4001)
    youden = ndtr((tried - visible.mean()) / visible.std()) - ndtr((tried - invisible.mean()) / invisible.std())
    assert threshold == pytest.approx(tried[youden.argmax()], abs=2e-3)
