"""What a mosaic is mixed of beside a seam: known feathers, whatever came after, and PyWavelets' energies."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from statistics import harmonic_mean

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.profile.cell_table import EDGES_PX, MIXED_BINS

from tests.numbers.seams.profile.blends import Blend, blend

Change = Callable[[np.ndarray], np.ndarray]
MIDDLES = np.array([(near + far) / 2 for near, far in zip(EDGES_PX, EDGES_PX[1 : MIXED_BINS + 1])])


def linear(width: float) -> np.ndarray:
    return np.tile(np.clip(0.5 - MIDDLES / width, 0, 1), 2)


def shares_of(made: Blend, mosaic: np.ndarray | None = None) -> np.ndarray:
    """alpha by distance, the mean of both sides."""
    finest = [bin_ for bin_ in made.profile(mosaic).bins if bin_.level == 1 and bin_.mixture is not None]
    assert [bin_.near_px for bin_ in finest] == list(EDGES_PX[:MIXED_BINS])
    return np.array([bin_.mixture for bin_ in finest], float)


def true_shares(made: Blend) -> np.ndarray:
    """The weight of whatever is not followed, by distance."""
    followed = np.take_along_axis(made.weights, made.labels[np.newaxis].astype(np.intp), 0)[0]
    ends = zip(EDGES_PX[:MIXED_BINS], EDGES_PX[1:])
    return np.array([1 - followed[(made.distance >= near) & (made.distance < far)].mean() for near, far in ends])


AFTERWARDS: dict[str, Change] = {
    "nothing": lambda plane: plane,
    "gain": lambda plane: 0.5 * plane + 40,
    "noise": lambda plane: plane + np.random.default_rng(4).normal(0, 4, plane.shape),
    "unsharp": lambda plane: 1.7 * plane - 0.7 * ndimage.gaussian_filter(plane, 1),
    "blur": lambda plane: ndimage.gaussian_filter(plane, 0.5),
    "8 bit": lambda plane: np.rint(plane),
}
WIDTHS = {"linear": 1.0, "cosine": 0.738}


@pytest.mark.slow
@pytest.mark.parametrize("change", AFTERWARDS)
@pytest.mark.parametrize("ramp", WIDTHS)
@pytest.mark.parametrize("width", [33, 100])
def test_the_mixture_is_the_feather_itself(width: int, ramp: str, change: str) -> None:
    made = blend(width, ramp)
    mosaic = AFTERWARDS[change](made.made)
    np.testing.assert_allclose(shares_of(made, mosaic), true_shares(made), atol=0.04)
    profile = made.profile(mosaic)
    assert profile.feather_width_px == pytest.approx(WIDTHS[ramp] * width, rel=0.1, abs=2)
    assert profile.by_mixture == pytest.approx(made.truth(), abs=0.03)


@pytest.mark.parametrize("change", AFTERWARDS)
@pytest.mark.parametrize("seed", [0, 1])
def test_a_narrow_feather_is_told_from_a_cut_whatever_came_after(seed: int, change: str) -> None:
    """How much of the cut's edge is left says how narrow it is, as a share of what the sources have left."""
    made = blend(13, side=256, seed=seed, other_years=5.0 * seed)
    profile = made.profile(AFTERWARDS[change](made.made))
    assert profile.by_mixture == pytest.approx(made.truth(), abs=0.05)
    assert 8 < profile.feather_width_px < 16


@pytest.mark.parametrize("other_years", [0.0, 25.0])
@pytest.mark.parametrize("change", AFTERWARDS)
def test_a_hard_cut_mixes_nothing(change: str, other_years: float) -> None:
    made = blend(0, other_years=other_years)
    profile = made.profile(AFTERWARDS[change](made.made))
    assert profile.by_mixture == pytest.approx(1, abs=0.01)
    assert profile.feather_width_px == pytest.approx(0, abs=1)


@pytest.mark.slow
@pytest.mark.parametrize("ramp", WIDTHS)
@pytest.mark.parametrize("width", [13, 33, 66, 200])
@pytest.mark.parametrize("other_years", [0.0, 25.0])
def test_kept_by_mixture_is_what_pywavelets_says_of_the_sources(width: int, ramp: str, other_years: float) -> None:
    made = blend(width, ramp, other_years=other_years)
    assert made.profile().by_mixture == pytest.approx(made.truth(), abs=0.05 if width == 13 else 0.03)


@pytest.mark.parametrize("in_common", [0.0, 0.3, 0.8])
def test_the_mean_of_two_images_keeps_what_they_have_in_common(in_common: float) -> None:
    made = blend(0, in_common=in_common)
    mean = made.with_mosaic_of(np.full(made.labels.shape, 0.5))
    profile = mean.profile()
    assert profile.by_mixture == pytest.approx((1 + in_common) / 2, abs=0.03)
    # Nobody knows which of two halves is followed.
    either = [mean.truth(), replace(mean, labels=1 - mean.labels).truth()]
    assert profile.by_mixture == pytest.approx(harmonic_mean(either), abs=0.01)
    assert shares_of(mean) == pytest.approx(0.5, abs=0.03)


def test_a_feather_that_lies_on_one_side_of_the_border_is_found_there() -> None:
    """The border is where the labels say, the feather begins at it."""
    made = blend(0)
    inside = np.where(made.labels == 1, made.distance, 0)
    one_sided = made.with_mosaic_of(np.where(made.labels == 1, np.clip(inside / 40, 0, 1), 0))
    profile = one_sided.profile()
    assert profile.feather_width_px == pytest.approx(0.9 * 40 / 0.8, rel=0.1)
    # Beside the border the other source is followed more than half, and its detail is what can be kept.
    assert profile.by_mixture == pytest.approx(one_sided.truth(), abs=0.07)


def test_three_sources_are_three_mixtures() -> None:
    made = blend(33, count=3)
    profile = made.profile()
    assert profile.by_mixture == pytest.approx(made.truth(), abs=0.04)
    beside = made.detail().mixture
    pairs = set(zip(beside.source.tolist(), beside.other.tolist()))
    assert pairs == {(0, 1), (1, 0), (0, 2), (2, 0), (1, 2), (2, 1)}
