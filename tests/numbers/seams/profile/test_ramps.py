"""Feathers as ramps of the share of the other source, by distance from the border."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.seams.measure.profile.cell_table import EDGES_PX, MIXED_BINS
from seam_inspector.plugin.seams.measure.profile.ramps import fit_ramps

SLOTS = 2 * MIXED_BINS
FINE = 0.05  # px, between places over which a bin's mean is taken


def shares_of(
    width: float, offset: float = 0.0, is_cosine: bool = False, floors: tuple[float, float] = (0.0, 0.0)
) -> np.ndarray:
    """Share of the other source in every bin, (1, SLOTS), by a ramp of a full width whose middle lies aside. A share of
    ``floors`` explains pure ground of either side."""
    found = []
    for sign in (-1, 1):
        for near, far in zip(EDGES_PX, EDGES_PX[1 : MIXED_BINS + 1]):
            place = sign * np.arange(near + FINE / 2, far, FINE)
            part = np.clip((place - offset) / max(width, 1e-6), -0.5, 0.5)
            higher = 0.5 + (0.5 * np.sin(np.pi * part) if is_cosine else part)
            other = higher.mean() if sign < 0 else 1 - higher.mean()
            near_floor, far_floor = floors if sign < 0 else floors[::-1]
            found.append(near_floor * (1 - other) + (1 - far_floor) * other)
    return np.array([found])


def noise(seed: int, spread: float, count: int = 1) -> np.ndarray:
    return np.random.default_rng(seed).normal(0, spread, (count, SLOTS))


@pytest.mark.parametrize("is_cosine", [False, True])
@pytest.mark.parametrize("width", [10, 13, 33, 66, 120])
@pytest.mark.parametrize("offset", [0, 2, -3])
def test_a_ramp_is_what_it_is(width: float, offset: float, is_cosine: bool) -> None:
    given = shares_of(width, offset, is_cosine)
    other, _, soft = fit_ramps(given, np.full((1, SLOTS), 0.003))
    np.testing.assert_allclose(other, given, atol=0.03)
    assert soft[0, 0] > 0.99


@pytest.mark.parametrize("floors", [(0.0, 0.0), (0.12, 0.12), (0.4, 0.0), (0.1, 0.35)])
@pytest.mark.parametrize("offset", [0, 3])
def test_a_noisy_cut_mixes_nothing_wherever_it_was_drawn_and_whatever_noise_explains(
    offset: float, floors: tuple[float, float]
) -> None:
    given = shares_of(0, offset, floors=floors) + noise(1, 0.03, 200)
    other, _, soft = fit_ramps(given, np.full(given.shape, 0.03))
    assert np.median(soft) < 0.35
    assert abs(other.mean()) < 0.02


@pytest.mark.parametrize("floors", [(0.4, 0.0), (0.1, 0.3)])
@pytest.mark.parametrize("width", [20, 33, 66])
def test_a_feather_beside_a_compressed_orthoimage_is_the_feather_alone(
    width: float, floors: tuple[float, float]
) -> None:
    given = shares_of(width, floors=floors)
    other, _, _ = fit_ramps(given, np.full((1, SLOTS), 0.01))
    np.testing.assert_allclose(other, shares_of(width), atol=0.04)


def test_what_no_noise_makes_is_a_mixture() -> None:
    """A third of the other source all over one side, and nothing left over: somebody mixed it in."""
    given = shares_of(0, floors=(0.33, 0.0))
    spread = np.full((1, SLOTS), 0.01)
    assert abs(fit_ramps(given, spread)[0]).max() < 0.05
    other, _, soft = fit_ramps(given, spread, np.array([[0.05, 0.05]]))
    assert soft[0, 0] > 0.99
    np.testing.assert_allclose(other[0, :MIXED_BINS], 0.33, atol=0.1)


def test_what_deviates_more_than_noise_lets_it_comes_back() -> None:
    """A feather on one side of the border alone is no ramp of ours."""
    given = shares_of(60)
    given[0, MIXED_BINS:] = 0
    other, _, _ = fit_ramps(given, np.full((1, SLOTS), 0.003))
    np.testing.assert_allclose(other, given, atol=0.06)
    vague, _, _ = fit_ramps(given, np.full((1, SLOTS), 0.3))
    assert abs(vague - given).max() > 0.1
