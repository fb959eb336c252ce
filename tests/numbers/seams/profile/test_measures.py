"""What judges a seam: energies against the ground around, the mixture of the sources, or both; and what is an edge."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.profile.cell_table import EDGES_PX
from seam_inspector.plugin.seams.measure.profile.intervals import MOST_KEPT_LOW, Kept, together
from seam_inspector.plugin.seams.measure.profile.seam_profile import STRIP_PX, Measure, SeamProfile

from tests.numbers.seams.profile.blends import SIDE, Blend, blend

BAND_PX = 12


def beside(made: Blend, changed: np.ndarray) -> SeamProfile:
    """Another image along the seam alone."""
    return made.profile(np.where(made.distance < BAND_PX, changed, made.made))


@pytest.mark.parametrize("width", [0, 13, 33, 100])
def test_of_a_feather_both_say_the_same(width: int) -> None:
    profile = blend(width).profile()
    assert profile.measure is Measure.BOTH
    assert profile.by_energy == pytest.approx(profile.by_mixture, abs=0.05)
    assert min(profile.by_energy, profile.by_mixture) <= profile.kept[0] <= max(profile.by_energy, profile.by_mixture)


@pytest.mark.parametrize("sigma", [0.4, 0.5])
def test_a_blur_along_the_seam_alone_is_seen_by_the_energy(sigma: float) -> None:
    made = blend(0)
    profile = beside(made, ndimage.gaussian_filter(made.made, sigma))
    assert profile.measure is Measure.ENERGY
    assert profile.by_mixture == pytest.approx(1, abs=0.02)
    assert profile.kept[0] == profile.by_energy
    assert profile.high < 0.8
    assert profile.feather_width_px == pytest.approx(0, abs=1)


def test_a_blur_on_top_of_a_feather_takes_more_than_the_mixture() -> None:
    made = blend(33)
    profile = beside(made, ndimage.gaussian_filter(made.made, 0.5))
    assert profile.measure is Measure.ENERGY
    assert profile.by_mixture == pytest.approx(made.truth(), abs=0.04)
    assert profile.high < profile.by_mixture


@pytest.mark.parametrize("side", [3, 5])
@pytest.mark.parametrize("width", [0, 33])
def test_a_median_filter_is_not_called_a_mixture(side: int, width: int) -> None:
    made = blend(width)
    profile = beside(made, ndimage.median_filter(made.made, side))
    assert profile.measure is Measure.ENERGY
    assert profile.kept[0] == profile.by_energy
    assert profile.high < 0.5


@pytest.mark.parametrize("side", [128, 256, 512])
@pytest.mark.parametrize("in_common", [0.0, 0.5])
def test_the_mean_of_two_images_all_over_the_window_is_seen_by_the_mixture(side: int, in_common: float) -> None:
    """The ground around has lost as much, and small windows have none at all."""
    mean = blend(0, side=side, in_common=in_common).with_mosaic_of(np.full((side, side), 0.5))
    profile = mean.profile()
    assert profile.measure is Measure.MIXTURE
    assert profile.kept[0] == profile.by_mixture == pytest.approx((1 + in_common) / 2, abs=0.04)
    assert profile.low < mean.truth() < profile.high
    assert profile.by_energy is None or profile.by_energy > 0.9
    widths = [bin_.far_px - bin_.near_px for bin_ in profile.bins if bin_.level == 1]
    assert profile.feather_width_px >= min(2 * sum(widths), 0.85 * 2 * EDGES_PX[-3])


def test_detail_that_came_along_the_seam_hides_no_mixture() -> None:
    """Twice as much as the images have; one time in five the energies still say too much."""
    made = blend(33)
    profiles = [
        beside(made, made.made + np.random.default_rng(seed).normal(0, 16, made.labels.shape)) for seed in range(2, 7)
    ]
    assert np.median([profile.kept[0] for profile in profiles]) == pytest.approx(made.truth(), abs=0.06)
    for profile in profiles:
        assert profile.by_mixture == pytest.approx(made.truth(), abs=0.06)
        assert profile.high < 0.9


@pytest.mark.parametrize("other_years", [10.0, 25.0, 60.0])
@pytest.mark.parametrize("seed", [0, 5])
def test_a_hard_cut_of_images_of_different_years_keeps_all(other_years: float, seed: int) -> None:
    """The step between them is added detail, and none that was kept."""
    made = blend(0, other_years=other_years, seed=seed)
    profile = made.profile()
    assert profile.measure is Measure.BOTH
    assert profile.kept == pytest.approx((1, 1, 1), abs=0.01)
    assert profile.by_energy == pytest.approx(1, abs=0.01)
    assert profile.by_mixture == pytest.approx(1, abs=0.01)
    assert profile.low < 1 < profile.high
    assert profile.added_beside > 0.1
    near = made.detail().cells.chosen(made.detail().cells.bin < EDGES_PX.index(STRIP_PX))
    assert near.mm[0].sum() > 1.01 * near.cc[0].sum()  # what it would keep with its edge


def kept(value: float, low: float, high: float) -> Kept:
    return Kept(*(np.array([number]) for number in (value, low, high)))


NOTHING = kept(np.nan, np.nan, np.nan)


def judged(energy: Kept, mixture: Kept) -> tuple[float, Measure]:
    kept, share = together(energy, mixture)
    return float(kept.value[0]), Measure.of(float(share[0]))


def test_where_they_contradict_each_other_the_lower_one_judges() -> None:
    low, high = kept(0.5, 0.45, 0.55), kept(0.9, 0.8, 1.0)
    assert judged(low, high) == (0.5, Measure.ENERGY)
    assert judged(high, low) == (0.5, Measure.MIXTURE)


@pytest.mark.parametrize("sigma", [1.0, 2.0])
@pytest.mark.parametrize("gain", [0.5, 1.0, 1.7])
def test_a_soft_brush_is_no_mixture_whatever_the_tones(sigma: float, gain: float) -> None:
    """A blur along a seam fits a feather of its width, of which only the weights tell that it has too little."""
    made = blend(0)
    untoned = beside(made, ndimage.gaussian_filter(made.made, sigma))
    toned = made.profile(gain * np.where(made.distance < BAND_PX, ndimage.gaussian_filter(made.made, sigma), made.made))
    for profile in (untoned, toned):
        assert profile.measure is Measure.ENERGY
        assert profile.high < 0.2
    assert toned.kept[0] == pytest.approx(untoned.kept[0], abs=0.01)


def test_energies_that_no_seam_has_do_not_judge() -> None:
    mixture = kept(0.98, 0.9, 1.06)
    assert judged(kept(1.2, MOST_KEPT_LOW + 0.001, 1.4), mixture) == (0.98, Measure.MIXTURE)
    assert judged(kept(1.2, MOST_KEPT_LOW, 1.4), mixture)[1] is Measure.BOTH
    assert judged(kept(1.2, 1.1, 1.4), NOTHING) == (1.2, Measure.ENERGY)


def test_where_they_agree_each_weighs_by_its_precision() -> None:
    energy, mixture = kept(0.8, 0.64, 1.0), kept(0.9, 0.81, 1.0)  # one twice as wide as the other, on the logarithm
    both, share = together(energy, mixture)
    expected = np.log(0.9 / 0.81) ** 2 / (np.log(0.9 / 0.81) ** 2 + np.log(0.8 / 0.64) ** 2)
    assert share[0] == pytest.approx(expected)
    for end, first, second in zip(both, energy, mixture):
        assert np.log(end[0]) == pytest.approx(expected * np.log(first[0]) + (1 - expected) * np.log(second[0]))


def test_a_window_without_ground_is_measured_by_its_mixture() -> None:
    """A window of 128 px, with nothing 32 px from all seams."""
    for width in (0, 33):
        made = blend(width, side=128)
        profile = made.profile()
        assert profile.by_energy is None
        assert profile.measure is Measure.MIXTURE
        assert profile.kept[0] == pytest.approx(made.truth(), abs=0.05)
        assert profile.low < made.truth() < profile.high


def test_a_seam_beside_the_window_is_none_of_its() -> None:
    """It was read with the ground around."""
    made = blend(33)
    assert made.distance[:, :160].min() > 20
    without = made.detail(inside=(slice(128, 384), slice(0, 160)))
    assert not without.has_seam
    assert without.profile is None
    assert made.detail(inside=(slice(128, 384), slice(128, 384))).has_seam


def test_what_is_read_around_a_window_is_ground_and_is_not_judged() -> None:
    """One half of the seam is feathered, the other one, in which the window lies, is not."""
    hard, soft = blend(0), blend(33)
    half = replace(hard, weights=np.where(np.arange(SIDE)[:, np.newaxis] < SIDE // 2, soft.weights, hard.weights))
    profile = half.detail(inside=(slice(SIDE // 2 + 32, SIDE - 32), slice(128, 384))).profile
    assert profile.kept[0] == pytest.approx(1, abs=0.03)
    assert profile.feather_width_px == pytest.approx(0, abs=1)
    other = half.detail(inside=(slice(32, SIDE // 2 - 32), slice(128, 384))).profile
    assert other.kept[0] < 0.7


@pytest.mark.parametrize("sigma", [2.0, 3.0])
def test_of_a_mosaic_without_fine_detail_nothing_is_said_to_be_kept(sigma: float) -> None:
    """All of it blurred and rounded to 8 bit: what is left of the finest detail is rounding."""
    made = blend(60)
    profile = made.profile(np.rint(ndimage.gaussian_filter(made.made, sigma)))
    assert profile.low < made.truth()
