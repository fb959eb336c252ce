"""How strong detail came over as a function of how strong it was: against what was made, and against scipy's fit."""
from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import optimize
from seam_inspector.plugin.seams.measure.energy_response import EnergyResponse, fit_response

LEAST = 0.01  # DN squared: what is added to every energy


@pytest.fixture(scope="module")
def energies() -> np.ndarray:
    """Energies as cells of a window have them: over four orders of magnitude."""
    return np.exp(np.random.default_rng(1).normal(2.0, 1.5, 500))


def parabola(energies: np.ndarray, *coefficients: float) -> np.ndarray:
    logs = np.log(energies + LEAST)
    first, second, third = coefficients
    return np.exp(first + second * logs + third * logs**2)


def inner(energies: np.ndarray) -> np.ndarray:
    """Those between the quantiles beyond which the curve is held."""
    low, high = np.quantile(energies, (0.02, 0.98))
    return energies[(energies >= low) & (energies <= high)]


@pytest.mark.parametrize(
    "coefficients", [(0.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.4, -0.3, 0.0), (-0.9, 0.35, -0.04), (1.0, -0.2, 0.03)]
)
def test_a_parabola_of_the_logarithm_is_recovered(
    energies: np.ndarray, coefficients: tuple[float, float, float]
) -> None:
    found = fit_response(energies, parabola(energies, *coefficients) * (energies + LEAST))
    asked = inner(energies)
    np.testing.assert_allclose(found(asked), parabola(asked, *coefficients), rtol=2e-3)


def by_scipy(energies: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Coefficients of the generalised linear model: logarithmic link, variance as the square of the mean."""
    logs, weights = np.log(energies + LEAST), np.sqrt(energies + LEAST)
    terms, ratios = np.stack([np.ones_like(logs), logs, logs**2], axis=1), values / (energies + LEAST)

    def deviance(coefficients: np.ndarray) -> float:
        exponent = terms @ coefficients
        return float((weights * (ratios * np.exp(-exponent) + exponent)).sum() / weights.sum())

    def slope(coefficients: np.ndarray) -> np.ndarray:
        left = weights * (1 - ratios * np.exp(-terms @ coefficients))
        return np.asarray(terms.T @ left / weights.sum())

    found: np.ndarray = optimize.minimize(deviance, np.zeros(3), jac=slope, method="Newton-CG", tol=1e-12).x
    return found


@pytest.mark.parametrize("seed", range(4))
def test_with_scatter_it_is_scipys_fit(energies: np.ndarray, seed: int) -> None:
    rng = np.random.default_rng(seed)
    values = parabola(energies, 0.5, -0.25, 0.02) * (energies + LEAST) * rng.gamma(20, 1 / 20, len(energies))
    asked = inner(energies)
    expected = parabola(asked, *by_scipy(energies, values))
    np.testing.assert_allclose(fit_response(energies, values)(asked), expected, rtol=1e-3)


def test_scatter_does_not_pull_it_down(energies: np.ndarray) -> None:
    """A fit of logarithms would lie a twentieth too low here; what is summed over many cells must be right."""
    rng = np.random.default_rng(7)
    values = energies * rng.gamma(10, 1 / 10, (40, len(energies)))
    sums = [(fit_response(energies, value)(energies) * energies).sum() / value.sum() for value in values]
    assert np.mean(sums) == pytest.approx(1, abs=0.01)
    assert np.max(np.abs(np.array(sums) - 1)) < 0.05


@given(factor=st.floats(0.02, 50), seed=st.integers(0, 1000))
def test_values_times_a_factor_are_a_response_times_that_factor(factor: float, seed: int) -> None:
    rng = np.random.default_rng(seed)
    energies = np.exp(rng.normal(2, 1.2, 200))
    values = energies**0.8 * rng.gamma(20, 1 / 20, 200)
    plain, scaled = fit_response(energies, values), fit_response(energies, factor * values)
    np.testing.assert_allclose(scaled(energies), factor * plain(energies), rtol=2e-3)


@given(factor=st.sampled_from([1.0, 3.0, 16.0**2, 256.0**2]), seed=st.integers(0, 1000))
def test_the_unit_of_energy_does_not_matter(factor: float, seed: int) -> None:
    """8, 12 and 16 bit values of the same ground."""
    rng = np.random.default_rng(seed)
    energies = np.exp(rng.normal(4, 1, 200))
    values = energies**0.9 * rng.gamma(20, 1 / 20, 200)
    plain, scaled = fit_response(energies, values), fit_response(factor * energies, factor * values)
    np.testing.assert_allclose(scaled(factor * energies), plain(energies), rtol=0.01)


def test_beyond_what_was_seen_the_curve_is_held(energies: np.ndarray) -> None:
    found = fit_response(energies, (energies + LEAST) * parabola(energies, 0.5, -0.4, 0.05))
    low, high = np.quantile(np.log(energies + LEAST), (0.02, 0.98))
    ends = found(np.exp(np.array([low, high])) - LEAST)
    assert found(np.array([0.0, 1e9])) == pytest.approx(ends, rel=1e-6)
    assert ends[0] > 1.5 * ends[1]


def test_the_shape_of_what_is_asked_stays(energies: np.ndarray) -> None:
    found = fit_response(energies, energies)
    assert found(energies.reshape(20, 25)).shape == (20, 25)
    np.testing.assert_array_equal(found(energies.reshape(20, 25)).ravel(), found(energies))


@pytest.mark.parametrize("count", [3, 24])
def test_cells_that_are_all_alike_give_their_mean(count: int) -> None:
    found = fit_response(np.full(count, 5.0), np.linspace(1.5, 2.5, count))
    assert found(np.array([0.0, 5.0, 100.0])) == pytest.approx(2.0 / (5.0 + LEAST), rel=1e-3)


@pytest.mark.parametrize("values", [np.zeros(50), np.eye(50)[0]], ids=["nothing", "one cell"])
def test_where_nothing_came_over_the_response_is_nothing(values: np.ndarray) -> None:
    found: EnergyResponse = fit_response(np.linspace(1.0, 60.0, 50), values)
    response = found(np.linspace(0, 100, 30))
    assert np.isfinite(response).all()
    assert (response >= 0).all()
    assert response.max() < 1.5


def test_energies_of_nothing_make_nothing_up() -> None:
    found = fit_response(np.zeros(30), np.zeros(30))
    assert found(np.array([0.0, 1.0])) == pytest.approx(0, abs=1e-3)
