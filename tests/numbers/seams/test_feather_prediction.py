"""What a feather leaves of two images' detail: the blend itself, by PyWavelets, against what is foretold of it."""
from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.seams.measure.judgement.feather_prediction import Feather, expected_ratios, feathers

from tests.numbers.synthetic import decompose, texture

SHAPE = (128, 64)
seeds = st.integers(0, 10_000)


def energies(image: np.ndarray, wavelet: str = "coif3", levels: int = 3) -> np.ndarray:
    """Sums of squares of the details of level 1..R."""
    return np.array([np.sum(part**2) for part in decompose(image, wavelet, levels).details])


def left_of(a: np.ndarray, b: np.ndarray, wavelet: str = "coif3", levels: int = 3) -> np.ndarray:
    """The detail variance of the 50:50 blend over the mean of its two images', level by level."""
    both = energies(a, wavelet, levels) + energies(b, wavelet, levels)
    return np.asarray(energies((a + b) / 2, wavelet, levels) / (both / 2))


def related(seed: int, shared: float) -> list[np.ndarray]:
    """Two grey images that have a share of their texture in common."""
    common, *own = (texture(SHAPE, 1.6, seed + i) for i in range(3))
    return [120 + 30 * (shared * common + (1 - shared) * one) for one in own]


@pytest.mark.parametrize(("wavelet", "levels"), [("coif3", 3), ("haar", 1), ("db4", 4), ("sym8", 2)])
def test_a_blend_of_two_images_keeps_what_was_foretold(wavelet: str, levels: int) -> None:
    a, b = related(5, 0.6)
    (found,) = feathers([a, b], wavelet, levels)
    np.testing.assert_allclose(found.ratios, left_of(a, b, wavelet, levels), rtol=1e-6)


@given(seeds, st.floats(0, 1), st.floats(0.2, 3), st.floats(-50, 50), st.sampled_from((1, -1)))
def test_it_holds_for_any_two_images(seed: int, shared: float, gain: float, bias: float, sign: int) -> None:
    a, b = related(seed, shared)
    b = sign * gain * b + bias
    (found,) = feathers([a, b], "coif3", 3)
    np.testing.assert_allclose(found.ratios, left_of(a, b), rtol=1e-5, atol=1e-7)
    for rho in found.rho:
        assert -1 - 1e-9 <= rho <= 1 + 1e-9


def test_every_pair_stands_for_its_two_images_whatever_the_others() -> None:
    images = [*related(3, 0.8), texture(SHAPE, 1.6, 99) * 30, related(3, 0.2)[1]]
    found = feathers(images, "coif3", 3)
    assert [(one.first, one.second) for one in found] == list(combinations(range(4), 2))
    for one in found:
        (alone,) = feathers([images[one.first], images[one.second]], "coif3", 3)
        assert one.rho == pytest.approx(alone.rho)


def test_fewer_than_two_images_have_no_feather() -> None:
    assert feathers([], "coif3", 3) == feathers([np.ones(SHAPE)], "coif3", 3) == []
    assert expected_ratios([], 3) == (None, None, None)


def test_without_detail_there_is_no_ratio() -> None:
    flat = np.full(SHAPE, 7.0)
    (found,) = feathers([flat, flat], "coif3", 3)
    assert found.rho == found.ratios == (None, None, None)
    coarse = np.kron(texture((32, 16)), np.ones((4, 4)))  # nothing finer than 4 px
    (found,) = feathers([coarse, coarse[::-1]], "haar", 3)
    assert found.rho[:2] == (None, None)
    assert found.rho[2] is not None


def test_what_is_expected_is_the_smallest_at_every_level() -> None:
    found = [Feather(0, 1, (0.8, None, None)), Feather(0, 2, (0.9, 0.4, None)), Feather(1, 2, (0.2, 0.6, None))]
    assert expected_ratios(found, 3) == pytest.approx((0.6, 0.7, None))
