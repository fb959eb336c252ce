"""How much detail is kept along a seam: known blends by PyWavelets, and what whole mosaics go through afterwards."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.profile.cell_table import EDGES_PX
from seam_inspector.plugin.seams.measure.profile.seam_profile import STRIP_PX, SeamProfile

from tests.numbers.seams.profile.blends import SIDE, Blend, blend

Change = Callable[[np.ndarray], np.ndarray]


def profile_of(made: Blend, mosaic: np.ndarray | None = None) -> SeamProfile:
    return made.profile(mosaic)


@pytest.mark.parametrize("ramp", ["cosine", "linear"])
@pytest.mark.parametrize("width", [13, 33, 66, 200])
def test_what_a_feather_kept_is_what_pywavelets_says(width: int, ramp: str) -> None:
    made = blend(width, ramp)
    profile = profile_of(made)
    assert profile.kept[0] == pytest.approx(made.truth(0, STRIP_PX), abs=0.05)
    assert profile.low < made.truth(0, STRIP_PX) < profile.high


@pytest.mark.parametrize("level", [2, 3])
def test_coarser_levels_are_kept_in_strips_twice_and_four_times_as_wide(level: int) -> None:
    made = blend(66)
    expected = made.truth(0, STRIP_PX * 2 ** (level - 1), level)
    assert profile_of(made).kept[level - 1] == pytest.approx(expected, abs=0.06)
    assert expected < 0.85


def test_each_bin_is_what_pywavelets_says_at_that_distance() -> None:
    made = blend(66)
    bins = [bin_ for bin_ in profile_of(made).bins if bin_.level == 1]
    for bin_ in bins[:11]:
        assert bin_.kept == pytest.approx(made.truth(bin_.near_px, bin_.far_px), abs=0.06), bin_.near_px
        assert bin_.low < bin_.kept < bin_.high


def test_bins_follow_each_other_and_stand_for_all_pixels() -> None:
    bins = profile_of(blend(33)).bins
    for level in (1, 2, 3):
        of_level = [bin_ for bin_ in bins if bin_.level == level]
        nears = [bin_.near_px for bin_ in of_level]
        assert nears == sorted(nears)
        assert set(nears) <= set(EDGES_PX)
        assert sum(bin_.area_px for bin_ in of_level) == SIDE**2
    assert all(bin_.near_px < bin_.middle_px < bin_.far_px for bin_ in bins if np.isfinite(bin_.far_px))
    assert [bin_.middle_px for bin_ in bins if np.isinf(bin_.far_px)] == [
        bin_.near_px for bin_ in bins if np.isinf(bin_.far_px)
    ]


@pytest.mark.parametrize(("ramp", "share"), [("cosine", 0.705), ("linear", 0.894)])
@pytest.mark.parametrize("width", [33, 66, 150])
def test_the_band_is_where_less_than_nine_tenths_are_kept(width: int, ramp: str, share: float) -> None:
    """Strangers keep w^2 + (1 - w)^2 = 0.9 where w = 0.947."""
    profile = profile_of(blend(width, ramp))
    assert profile.band_width_px == pytest.approx(share * width, rel=0.12, abs=3)


def unsharp(plane: np.ndarray) -> np.ndarray:
    return 2 * plane - ndimage.gaussian_filter(plane, 1)


def noisy(plane: np.ndarray) -> np.ndarray:
    return plane + np.random.default_rng(5).normal(0, 2, plane.shape)


def curved(plane: np.ndarray) -> np.ndarray:
    return 255 * (np.clip(plane, 1, 255) / 255) ** 0.7


def rounded(plane: np.ndarray) -> np.ndarray:
    return np.clip(np.rint(0.5 * plane), 0, 255)


CHANGES: dict[str, Change] = {
    "gain": lambda plane: 0.6 * plane + 20, "negative": lambda plane: 255 - plane, "unsharp": unsharp,
    "blur": lambda plane: ndimage.gaussian_filter(plane, 0.5), "noise": noisy, "gamma": curved, "8 bit": rounded,
}


@pytest.mark.parametrize("change", CHANGES)
@pytest.mark.parametrize("width", [0, 33, 100])
def test_what_is_done_to_the_whole_mosaic_drops_out(width: int, change: str) -> None:
    made = blend(width)
    plain, after = profile_of(made), profile_of(made, CHANGES[change](made.made))
    assert after.kept[0] == pytest.approx(plain.kept[0], abs=0.06)
    assert after.low < made.truth(0, STRIP_PX) < after.high


@pytest.mark.release
@pytest.mark.parametrize(("side", "count"), [(256, 40), (512, 6)])
def test_a_sound_hard_cut_is_held_by_its_interval(side: int, count: int) -> None:
    """What came afterwards differs from place to place: noise whose strength follows the ground's brightness."""
    held, lost = [], []
    for seed in range(count):
        made = blend(0, side=side, seed=seed)
        rng = np.random.default_rng(seed)
        strength = 3 + 2 * ndimage.gaussian_filter(rng.standard_normal((side, side)), 20, mode="wrap") * 70
        profile = profile_of(made, made.hard + np.clip(strength, 0.5, 9) * rng.standard_normal((side, side)))
        held.append(profile.low <= 1 <= profile.high)
        lost.append(profile.high < 1)
    assert np.mean(held) >= 0.9
    assert np.mean(lost) <= 0.05


def test_a_hard_cut_that_nothing_happened_to_keeps_all_of_it() -> None:
    """Its edge is added detail."""
    profile = profile_of(blend(0))
    assert profile.kept == pytest.approx((1, 1, 1), abs=2e-3)
    assert profile.low < 1 < profile.high
    assert profile.added_beside > 0.1


def test_a_few_pixels_of_seam_are_too_little() -> None:
    made = blend(0)
    labels = np.zeros((SIDE, SIDE), np.uint8)
    labels[:8, :8] = 1
    assert made.detail(labels=labels).profile is None
    labels[:40, :40] = 1
    assert made.detail(labels=labels).profile is not None


def test_detail_that_was_added_beside_the_seam_is_told_from_what_was_kept() -> None:
    made = blend(66)
    band = made.distance < 16
    noise = np.random.default_rng(2).normal(0, 8, band.shape)
    noisy = profile_of(made, np.where(band, made.made + noise, made.made))
    plain = profile_of(made)
    near, before = noisy.bins[1], plain.bins[1]
    assert near.kept == pytest.approx(before.kept, abs=0.06)
    assert near.gain == pytest.approx(before.gain, abs=0.06)
    assert plain.added_beside == pytest.approx(1 - before.gain**2 / before.kept, abs=0.1)
    assert noisy.added_beside > plain.added_beside + 0.15
    assert noisy.kept == pytest.approx(plain.kept, abs=0.03)  # of its sources, which is what is judged


@pytest.mark.parametrize("width", [0, 13, 33, 66, 256])
def test_the_bins_beside_the_seam_add_up_to_what_is_kept(width: int) -> None:
    profile = profile_of(blend(width))
    beside = [bin_ for bin_ in profile.bins if bin_.level == 1 and bin_.far_px <= STRIP_PX]
    mean = np.average([bin_.kept for bin_ in beside], weights=[bin_.area_px for bin_ in beside])
    assert mean == pytest.approx(profile.kept[0], abs=0.02)


@pytest.mark.parametrize("noise_dn", [4, 8, 12])
@pytest.mark.parametrize("width", [33, 66])
def test_noise_over_all_of_a_mosaic_hides_no_loss(width: int, noise_dn: float) -> None:
    """The energy alone tells it: noise is the same in what a seam left and in the ground around."""
    made = blend(width)
    profile = profile_of(made, made.made + np.random.default_rng(4).normal(0, noise_dn, made.made.shape))
    assert profile.by_energy == pytest.approx(made.truth(0, STRIP_PX), abs=0.06)
    assert profile.low < made.truth(0, STRIP_PX) < profile.high
