"""How strong detail came over as a function of how strong it was: against what was made, and against scipy's fit."""
from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
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
