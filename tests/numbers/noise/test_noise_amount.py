"""How much noise there is whatever the scene: sigma without texture, signal to noise, and the second verdict."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import ndimage
from seam_inspector.plugin.noise.measure.band_noise import BandNoise, NoiseAmount, measure_noise
from seam_inspector.plugin.noise.measure.noise_amount import ACCEPTABLE_RATIO, EXCELLENT_RATIO, noise_amount

from tests.examples import at_most
from tests.numbers.synthetic import luminance, patchy_texture, read_pixels, texture


def measured(pixels: np.ndarray, whole: bool = True) -> BandNoise:
    values = np.rint(pixels).clip(0, 255).astype(np.uint8) if whole else pixels.astype(np.float32)
    return measure_noise(values[np.newaxis], ("band_1",))["band_1"]


def white(sigma: float, seed: int = 0) -> np.ndarray:
    return np.random.default_rng(seed).normal(0, sigma, (512, 512))


@at_most(12)
@given(sigma=st.floats(3, 15), beta=st.floats(2.6, 4), contrast=st.floats(1, 25), seed=st.integers(0, 50))
def test_white_noise_is_told_from_the_texture_around_it(sigma: float, beta: float, contrast: float, seed: int) -> None:
    result = measured(120 + contrast * patchy_texture((512, 512), beta, seed) + white(sigma, seed))
    assert result.noise == pytest.approx(sigma, rel=0.1)
    assert result.signal_to_noise == pytest.approx(120 / sigma, rel=0.12)


@pytest.mark.parametrize(("sigma", "amount"), [(0, "little"), (2, "little"), (5, "some"), (9, "some"), (20, "much")])
@pytest.mark.parametrize("contrast", [3, 25])
def test_the_amount_is_that_of_the_ratio_on_rough_ground_and_on_smooth(
    sigma: float, amount: str, contrast: float
) -> None:
    assert measured(120 + contrast * texture((512, 512), 4, 2) + white(sigma)).amount == amount


@pytest.mark.parametrize(
    ("ratio", "reached", "missed"),
    [(EXCELLENT_RATIO, NoiseAmount.LITTLE, NoiseAmount.SOME), (ACCEPTABLE_RATIO, NoiseAmount.SOME, NoiseAmount.MUCH)],
)
def test_an_image_is_as_good_as_its_ratio_when_it_just_reaches_it(
    ratio: float, reached: NoiseAmount, missed: NoiseAmount
) -> None:
    quiet = (0.5, 0.5, 0.5)
    assert noise_amount(2.0, 2 * ratio, quiet, "coif3", are_whole=False) is reached
    assert noise_amount(2.0, 1.99 * ratio, quiet, "coif3", are_whole=False) is missed


@pytest.mark.parametrize(("noise", "amount"), [(12.0, NoiseAmount.SOME), (5.0, NoiseAmount.UNCERTAIN)])
def test_noise_that_is_most_of_what_there_can_be_is_all_of_it(noise: float, amount: NoiseAmount) -> None:
    """The quietest ground leaves room for 15 DN of white noise, much of a mean of 130."""
    assert noise_amount(noise, 130, (15.0, 22.0, 32.0), "coif3", are_whole=True) is amount


@pytest.mark.parametrize("size", [0.7, 1.0, 1.35, 2.0])
def test_grain_as_strong_as_that_is_never_little(size: float) -> None:
    grain = ndimage.gaussian_filter(white(1), size, mode="wrap")
    for scale in (2, 25):
        result = measured(120 + scale * patchy_texture((512, 512), 3, 1) + 8 * grain / grain.std())
        assert result.amount != NoiseAmount.LITTLE


def test_grain_that_texture_hides_is_bounded_and_the_bound_holds(data_folder: Path) -> None:
    """Places in real images: little was found, and some is the most that there is."""
    said = []
    for column, row in ((600, 500), (1800, 4000), (3000, 1700)):
        ground = luminance(read_pixels(str(data_folder / "fiducials/unbc/15BCC02013_114.jpg"), column, row, 1024, 1024))
        ground = ground.reshape(512, 2, 512, 2).mean(axis=(1, 3))
        for size in (1, 2):
            grain = ndimage.gaussian_filter(white(1), size, mode="wrap")
            said += [measured(ground + share * ground.mean() * grain / grain.std()).amount for share in (0.05, 0.2)]
    below, above = said[::2], said[1::2]  # ratios of 20 and of 5
    assert below.count(NoiseAmount.AT_MOST_SOME) >= 4
    assert set(below) <= {NoiseAmount.AT_MOST_SOME, NoiseAmount.SOME}
    assert set(above) <= {NoiseAmount.UNCERTAIN, NoiseAmount.MUCH}


def in_colour(ground: np.ndarray, noise: np.ndarray) -> BandNoise:
    """The green band of a texture that three bands have by different shares, each with its noise (3, rows, columns)."""
    bands = np.stack([120 + share * ground for share in (0.8, 1.0, 0.6)]) + noise
    return measure_noise(np.rint(bands).clip(0, 255).astype(np.uint8), ("red", "green", "blue"))["green"]


ROUGH = 40 * texture((512, 512), 3, 3)


@pytest.mark.parametrize(("size", "error"), [(0, 0.1), (1, 0.15), (2, 0.25)])
@pytest.mark.parametrize(("sigma", "amount"), [(5, "some"), (20, "much")])
def test_bands_tell_noise_from_texture_that_is_as_strong_everywhere(
    size: float, error: float, sigma: float, amount: str
) -> None:
    noise = np.random.default_rng(1).normal(0, 1, (3, 512, 512))
    noise = ndimage.gaussian_filter(noise, (0, size, size), mode="wrap")
    result = in_colour(ROUGH, sigma * noise / noise.std())
    assert result.noise == pytest.approx(sigma, rel=error)
    assert result.amount == amount


def test_without_a_signal_nothing_is_said_of_the_amount() -> None:
    result = measured(white(5) - 3, whole=False)
    assert (result.amount, result.signal_to_noise) == (NoiseAmount.NOT_MEASURABLE, None)
