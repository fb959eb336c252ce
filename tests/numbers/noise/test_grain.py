"""Noise whatever the scene: grain coarser than a pixel, sigma without texture, signal to noise, the second verdict."""
from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import numpy as np
import pytest
import pywt
from hypothesis import given
from hypothesis import strategies as st
from scipy import ndimage
from seam_inspector.plugin.noise.measure.band_noise import BandNoise, NoiseAmount, NoiseVerdict, measure_noise
from seam_inspector.plugin.noise.measure.grain import (
    ACCEPTABLE_RATIO,
    EXCELLENT_RATIO,
    grain_spectrum,
    noise_amount,
    quiet_ground,
)

from tests.examples import at_most
from tests.numbers.synthetic import luminance, patchy_texture, read_pixels, texture

SCANNED, DRONE = Path("fiducials/unbc/15BCC02013_114.jpg"), Path("noise/seneca/IMG_0460.jpg")
GROUND = [  # of real images: file, first column and row, side
    *((SCANNED, column, row, 1024) for column, row in ((600, 500), (1800, 4000), (3000, 1700), (4100, 2900))),
    *((DRONE, column, row, 1024) for column, row in ((100, 200), (1250, 1450), (2400, 200))),
    (Path("seams/brighton/mosaic_hardseam.tif"), 900, 1400, 512),
    (Path("seams/packo/19FD5606Ax00020_16371.tif"), 0, 0, 256),
]


def grain(sigma: float, size: float, shape: tuple[int, int], seed: int = 0) -> np.ndarray:
    """White noise smoothed by a Gaussian of so many pixels, of standard deviation ``sigma``."""
    made = np.random.default_rng(seed).standard_normal(shape)
    if size:
        made = ndimage.gaussian_filter(made, size, mode="wrap")
    return made * sigma / made.std()


def measured(band: np.ndarray, wavelet: str = "coif3", levels: int = 3, whole: bool = True) -> BandNoise:
    pixels = np.rint(band).clip(0, 255).astype(np.uint8) if whole else band.astype(np.float32)
    return measure_noise(pixels[np.newaxis], ("band_1",), wavelet, levels)["band_1"]


@lru_cache(maxsize=1)
def scanned_grain(size: float) -> np.ndarray:
    """1024 x 1024 px, as a scanner samples what is finer than its pixels."""
    return grain(1, 4 * size, (4096, 4096))[::4, ::4].copy() if size else grain(1, 0, (1024, 1024))


@pytest.mark.release
@pytest.mark.parametrize("wavelet", ["haar", "db4", "coif3", "sym8"])
@pytest.mark.parametrize("size", [0.0, 0.5, 1.0, 1.5])
def test_the_spectrum_of_grain_is_what_pywavelets_makes_of_it(wavelet: str, size: float) -> None:
    made = scanned_grain(size)
    details = pywt.wavedec2(made, wavelet, mode="periodization", level=4)[:0:-1]
    expected = [np.mean(np.square(level)) / made.var() for level in details]
    assert grain_spectrum(wavelet, 4, size) == pytest.approx(expected, rel=0.06)


@at_most(15)
@given(sigma=st.floats(0.1, 100), seed=st.integers(0, 99))
def test_pure_noise_is_quiet_ground_of_its_own_strength(sigma: float, seed: int) -> None:
    ground = quiet_ground(np.random.default_rng(seed).normal(0, sigma, (3, 120, 120)))
    assert ground.quiet == pytest.approx(sigma, rel=0.06)
    assert ground.least == pytest.approx(sigma, rel=0.15)
    assert ground.unevenness == pytest.approx(1, abs=0.06)


def test_a_cut_off_sky_does_not_hide_the_noise_of_the_ground() -> None:
    pixels = np.rint(120 + 25 * texture((512, 512), 3.0, 1) + grain(8, 1.0, (512, 512)))
    pixels[:, 380:] = 255
    assert measured(pixels).verdict != NoiseVerdict.LOW


@pytest.mark.parametrize("size", [0.5, 0.7, 1.0])
@pytest.mark.parametrize("sigma", [6.0, 8.0, 15.0])
def test_grain_on_even_ground_is_recognised_with_its_size_and_strength(size: float, sigma: float) -> None:
    noise = measured(120 + 15 * texture((1024, 1024), 4, 2) + grain(sigma, size, (1024, 1024)))
    assert noise.grain.size == pytest.approx(size, abs=0.11)
    assert noise.grain.sigma == pytest.approx(sigma, rel=0.1)
    assert noise.verdict in (NoiseVerdict.MODERATE, NoiseVerdict.STRONG)


@at_most(15)
@given(sigma=st.floats(8, 20), size=st.floats(0, 1.0), beta=st.floats(2.3, 3.5), seed=st.integers(0, 50))
def test_strong_grain_is_never_low(sigma: float, size: float, beta: float, seed: int) -> None:
    ground = 120 + 15 * patchy_texture((512, 512), beta, seed)
    noise = measured(ground + grain(sigma, size, ground.shape, seed))
    assert noise.verdict != NoiseVerdict.LOW
    assert (noise.largest_sigma or 0) > 0.9 * sigma


@at_most(15)
@given(beta=st.floats(2.4, 4), seed=st.integers(0, 50))
def test_ground_with_quiet_places_and_no_noise_is_low(beta: float, seed: int) -> None:
    assert measured(120 + 25 * patchy_texture((512, 512), beta, seed)).verdict == NoiseVerdict.LOW


def test_a_window_too_small_to_look_for_grain_is_uncertain_and_says_so() -> None:
    noise = measured(120 + 25 * texture((64, 64), 3.0, 1), "coif10")
    assert noise.largest_sigma is None
    assert noise.verdict == NoiseVerdict.UNCERTAIN
    assert "too small" in str(noise.note)


@pytest.mark.release
@pytest.mark.parametrize("size", [0.0, 0.5, 0.7, 1.0])
@pytest.mark.parametrize("place", GROUND, ids=lambda place: f"{place[0].stem}-{place[1]}-{place[2]}")
def test_made_grain_on_real_ground_is_never_low(
    place: tuple[Path, int, int, int], size: float, data_folder: Path
) -> None:
    path, column, row, side = place
    ground = luminance(read_pixels(str(data_folder / path), column, row, side, side))
    noise = measured(ground + grain(8, size, ground.shape))
    if size == 0.0:  # white noise is judged by the curve, against the texture
        assert (noise.sigma or 0) > 7.5
    else:
        assert noise.verdict != NoiseVerdict.LOW
    assert (noise.largest_sigma or 0) > 7


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
