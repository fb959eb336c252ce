"""How sure kept is: intervals that hold the truth, and what widens them."""
from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.profile.cell_table import CELL_PX, MixtureTable
from seam_inspector.plugin.seams.measure.profile.energy_sums import EnergySums
from seam_inspector.plugin.seams.measure.profile.intervals import Kept
from seam_inspector.plugin.seams.measure.profile.mixture import MixedStrips, MixtureSums
from seam_inspector.plugin.seams.measure.profile.window_detail import WindowDetail

from tests.numbers.seams.profile.blends import LEVELS, Blend, blend


def afterwards(made: Blend, seed: int) -> np.ndarray:
    """A mosaic that went through what differs from place to place: noise that follows the ground's brightness."""
    rng = np.random.default_rng(seed)
    strength = 2 + 100 * ndimage.gaussian_filter(rng.standard_normal(made.labels.shape), 20, mode="wrap")
    return made.made + np.clip(strength, 0.3, 6) * rng.standard_normal(made.labels.shape)


def mixture_of(detail: WindowDetail) -> MixedStrips:
    sums = MixtureSums(1, LEVELS)
    sums.add(detail.mixture, np.zeros(len(detail.mixture), int))
    return sums.result()


def energy_of(detail: WindowDetail, mixture: MixedStrips | None = None) -> Kept:
    """Energy without its own edge and what the mixture leaves over."""
    sums = EnergySums(1, LEVELS)
    sums.add(detail.cells, detail.ground, np.zeros(len(detail.cells), int))
    mixture = mixture or mixture_of(detail)
    sums.take_out(mixture.edge, mixture.left_over, mixture.soft_left_over, mixture.rounded)
    return sums.kept()[0]


def ratio(kept: Kept) -> float:
    return float(kept.high[0] / kept.low[0])


def holds(kept: Kept, truth: float) -> bool:
    return bool(kept.low[0] <= truth <= kept.high[0])


def test_detail_that_no_mixture_explains_makes_it_less_sure() -> None:
    """Noise everywhere, and more along the strip: the interval reaches farther than by the mixture's own error."""
    feathered = blend(13)
    noise = np.random.default_rng(0).standard_normal(feathered.labels.shape)
    noisy = feathered.made + np.where(feathered.distance < 12, 16, 4) * noise
    profile, detail = feathered.profile(noisy), feathered.detail(noisy)
    alone = mixture_of(detail).kept
    assert profile.left_by_mixture > 0.05
    assert profile.high / profile.low > 1.02 * ratio(alone)


@pytest.mark.release
@pytest.mark.parametrize("width", [0, 13, 33, 66])
def test_of_sixty_windows_nine_in_ten_intervals_hold_the_truth(width: int) -> None:
    """Each of the two measures', and what is judged by both."""
    held = np.zeros(3)
    for seed in range(60):
        made = blend(width, side=192, seed=seed, in_common=0.1 * (seed % 8), other_years=4.0 * (seed % 5))
        detail, truth = made.detail(afterwards(made, seed)), made.truth()
        mixture = mixture_of(detail)
        profile = detail.profile
        held += (
            profile.low <= truth <= profile.high, holds(mixture.kept, truth), holds(energy_of(detail, mixture), truth)
        )
    assert (held >= 0.9 * 60).all(), held


def test_no_interval_is_too_wide_to_say_anything() -> None:
    """A feather of 33 px is found in every window of 192 px, and no hard cut is taken for one."""
    for seed in range(15):
        hard, soft = (blend(width, side=192, seed=seed) for width in (0, 33))
        assert hard.profile(afterwards(hard, seed)).high > 1
        assert soft.profile(afterwards(soft, seed)).high < 0.8


@pytest.mark.parametrize("width", [0, 33])
def test_each_measure_alone_is_sure_enough_to_judge(width: int) -> None:
    """A measure that says nothing would be hidden by the other."""
    made = blend(width)
    detail = made.detail(afterwards(made, 3))
    for measure, most in ((energy_of(detail), 1.5), (mixture_of(detail).kept, 1.2)):
        assert holds(measure, made.truth())
        assert ratio(measure) < most


@pytest.mark.release
def test_a_long_seam_is_surer_than_a_short_one() -> None:
    """Surer in the mean over many seams: a jackknife of eight groups is itself uncertain."""
    widths = np.zeros((2, 2))
    for seed in range(8):
        made = blend(33, seed=seed)
        detail = made.detail(afterwards(made, seed))
        for place, last in enumerate((4, 30)):
            sums, energy = MixtureSums(1, LEVELS), EnergySums(1, LEVELS)
            beside = slice(1, last), slice(0, 32)
            sums.add(detail.mixture, np.where(detail.mixture.are_within(beside), 0, -1))
            energy.add(detail.cells, detail.ground, np.where(detail.cells.are_within(beside), 0, -1))
            mixture = sums.result()
            energy.take_out(mixture.edge, mixture.left_over, mixture.soft_left_over, mixture.rounded)
            widths[place] += np.log(ratio(mixture.kept)), np.log(ratio(energy.kept()[0]))
    assert (widths[0] > 1.2 * widths[1]).all()


def test_a_feather_that_reaches_into_the_ground_around_makes_energies_less_sure() -> None:
    narrow, wide = (energy_of(blend(width, side=256).detail()) for width in (33, 250))
    assert ratio(wide) > 1.2 * ratio(narrow)


def test_rows_of_another_piece_say_nothing_of_this_one() -> None:
    """Two pieces, of which one is feathered, in any order."""
    made, hard = blend(33), blend(0)
    half = np.arange(512)[:, np.newaxis] < 256
    detail = replace(made, weights=np.where(half, made.weights, hard.weights)).detail()
    piece = (detail.mixture.row >= 256 // CELL_PX).astype(int)
    forth, back = MixtureSums(2, LEVELS), MixtureSums(2, LEVELS)
    forth.add(detail.mixture, piece)
    cut = np.arange(len(detail.mixture)) % 3
    for part in (2, 0, 1):
        back.add(detail.mixture.chosen(cut == part), piece[cut == part])
    back.add(MixtureTable.empty(LEVELS), piece[:0])
    forwards, other = forth.result(), back.result()
    assert forwards.kept.value[0] < 0.75
    assert forwards.kept.value[1] == pytest.approx(1, abs=0.03)
    for name in ("value", "low", "high"):
        assert getattr(other.kept, name) == pytest.approx(getattr(forwards.kept, name), rel=1e-6)
    assert other.feather_widths_px == pytest.approx(forwards.feather_widths_px, abs=1e-3)
