"""Random noise of a clip, on ramps too: curve, kurtosis, sigma and verdict against PyWavelets, scipy, known noise."""
from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.limits import WAVELETS
from seam_inspector.plugin.noise.measure.band_noise import (
    BandNoise,
    NoiseVerdict,
    check_noise_settings,
    inner_ranges,
    measure_noise,
    noise_verdict,
    noisiest_band,
)
from seam_inspector.plugin.noise.measure.group_noise import filled

from tests.examples import at_most
from tests.numbers.noise.inner_coefficients import inner_kurtoses
from tests.numbers.synthetic import decompose, luminance, orthoimage, patchy_texture, texture, wavedec

RGB = ("red", "green", "blue")
WORDS = ["low", "uncertain", "moderate", "strong"]


def measured(band: np.ndarray, **options: object) -> BandNoise:
    return measure_noise(band[np.newaxis], ("band_1",), **options)["band_1"]  # type: ignore[arg-type]


def noise(sigma: float, shape: tuple[int, int] = (512, 512), seed: int = 1) -> np.ndarray:
    return np.random.default_rng(seed).normal(0, sigma, shape)


def test_figures_are_those_of_pywavelets_and_scipy() -> None:
    bands = orthoimage((512, 512))
    noises = measure_noise(bands, RGB)
    assert list(noises) == ["luminance", *RGB]
    for name, band in zip(noises, [luminance(bands), *bands]):
        ours = noises[name]
        assert np.allclose([*ours.curve.detail, ours.curve.background], decompose(band).shares, atol=1e-7)
        expected = inner_kurtoses(band, "coif3", 3)
        assert ours.kurtosis == pytest.approx(expected, rel=1e-4)
        finest_diagonal = wavedec(band, "coif3", 1)[1][2]
        assert ours.sigma == pytest.approx(stats.median_abs_deviation(finest_diagonal.ravel(), center=lambda x, axis: 0)
                                           / stats.norm.ppf(0.75), rel=1e-3)


@at_most(12)
@given(sigma=st.floats(0.5, 500), seed=st.integers(0, 99))
def test_gaussian_noise_has_kurtosis_three_and_its_sigma(sigma: float, seed: int) -> None:
    result = measured(noise(sigma, seed=seed))
    assert result.sigma == pytest.approx(sigma, rel=0.02)
    for level, kurtosis in enumerate(result.kurtosis, 1):
        assert kurtosis == pytest.approx(3, abs=6 * np.sqrt(24 / (3 * 512 * 512 / 4**level)))
    assert result.curve.detail == pytest.approx((3 / 4, 3 / 16, 3 / 64), rel=0.05)
    assert result.verdict == NoiseVerdict.STRONG


@pytest.mark.parametrize(
    ("detail", "verdict", "noted"),
    [
        ((1, 2, 3), "low", False),
        ((2, 1, 3), "moderate", False),
        ((3, 2, 1), "strong", False),
        ((2, 2, 3), "moderate", False),
        ((1, 3, 2), "moderate", True),
        ((3, 2, 1, 4), "strong", False),
        ((3, 2, 4, 1), "moderate", False),
        ((1, 2, 3, 2), "moderate", True),
        ((1, 2), "low", False),
        ((2, 1), "moderate", False),
    ],
)
def test_verdicts(detail: tuple[float, ...], verdict: str, noted: bool) -> None:
    judged, note = noise_verdict(detail)
    assert judged.value == verdict
    assert (note is not None) == noted


@pytest.mark.parametrize("beta", [2.6, 3.2])
def test_growing_noise_goes_from_low_to_moderate_to_strong(beta: float) -> None:
    clean = 128 + 25 * patchy_texture((512, 512), beta, 5)
    verdicts = [
        measured(np.rint(clean + noise(sigma)).clip(0, 255).astype(np.uint8)).verdict.value
        for sigma in np.geomspace(0.05, 40, 60)
    ]
    places = [WORDS.index(verdict) for verdict in verdicts]
    assert places == sorted(places)
    assert set(places) >= {0, 2, 3}


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.float32])
@pytest.mark.parametrize("sigma", [2, 5, 10, 20])
def test_sigma_recovers_what_was_added_to_a_smooth_image(sigma: float, dtype: type) -> None:
    smooth = 128 + 15 * texture((512, 512), 4, 2)
    values = smooth + noise(sigma)
    pixels = values.astype(dtype) if dtype is np.float32 else np.rint(values).clip(0, 255).astype(dtype)
    assert measured(pixels).sigma == pytest.approx(sigma, rel=0.05)


def test_the_bands_are_judged_and_not_the_luminance_that_averages_their_noise() -> None:
    clean = np.stack([120 + 25 * patchy_texture((512, 512), 2.8, 1)] * 3)
    noises = measure_noise(clean + np.stack([noise(6, seed=seed) for seed in range(3)]), RGB)
    assert {noises[name].verdict.value for name in RGB} == {"strong"}
    assert noises["luminance"].verdict.value == "moderate"
    assert noisiest_band(noises) in RGB


def test_a_constant_band_has_no_figures_and_says_why() -> None:
    flat = measure_noise(np.full((1, 64, 64), 7, np.uint8), ("band_1",), raster="flat.tif")["band_1"]
    assert (flat.verdict, flat.sigma, set(flat.kurtosis)) == (NoiseVerdict.NOT_MEASURABLE, None, {None})
    assert "flat.tif has no variance" in str(flat.note)


@pytest.mark.parametrize(("wavelet", "levels"), [("bior2.2", 3), ("none", 3), ("coif3", 1), ("coif3", 9)])
def test_settings_that_make_no_sense_are_refused(wavelet: str, levels: int) -> None:
    with pytest.raises(SettingsError):
        check_noise_settings(wavelet, levels)


@at_most(8)
@given(
    beta=st.floats(1.8, 2.8), side=st.integers(3, 110), column=st.integers(0, 390), row=st.integers(0, 390),
    seed=st.integers(0, 20),
)
def test_a_filled_hole_does_not_disturb_the_curve(beta: float, side: int, column: int, row: int, seed: int) -> None:
    clean = 100 + 20 * texture((512, 512), beta, seed)
    mask = np.zeros(clean.shape, bool)
    mask[row : row + side, column : column + side] = True
    spoilt = np.where(mask, -1e6, clean)
    whole, holed = measured(clean), measured(filled(spoilt[np.newaxis], mask)[0], masked=mask)
    assert holed.curve.detail == pytest.approx(whole.curve.detail, rel=0.02 + 1.2 * mask.mean())
    assert holed.sigma == pytest.approx(whole.sigma, rel=0.02)
    assert holed.kurtosis == pytest.approx(whole.kurtosis, rel=0.06)


def test_what_a_hole_is_filled_with_is_in_neither_kurtosis_nor_sigma() -> None:
    hole = np.zeros((128, 128), bool)
    hole[40:71, 50:77] = True
    ground = noise(6, (128, 128))
    figures = []
    for filling in (0.0, noise(40, (128, 128), seed=2)):
        result = measured(np.where(hole, filling, ground), wavelet="haar", masked=hole)  # haar: nothing leaks out of it
        figures.append((result.sigma, *result.kurtosis))
    assert figures[0] == pytest.approx(figures[1], rel=1e-6)
    outside = wavedec(np.where(hole, 0, ground), "haar", 1)[1][2][~hole.reshape(64, 2, 64, 2).any(axis=(1, 3))]
    assert figures[0][0] == pytest.approx(np.median(np.abs(outside)) / stats.norm.ppf(0.75), rel=1e-4)


def ramp(side: int, sigma: float = 4.0, seed: int = 1) -> np.ndarray:
    """A field that grows brighter from left to right and from top to bottom, with white noise, as whole numbers."""
    rows, columns = np.mgrid[:side, :side] / side
    values = 50 + 110 * columns + 60 * rows + np.random.default_rng(seed).normal(0, sigma, (side, side))
    return np.rint(values).clip(0, 255).astype(np.uint8)


def kurtoses(band: np.ndarray, wavelet: str, levels: int = 3) -> tuple[float | None, ...]:
    return measure_noise(band[np.newaxis], ("band_1",), wavelet, levels)["band_1"].kurtosis


@pytest.mark.slow
@pytest.mark.parametrize("wavelet", WAVELETS)
def test_noise_on_a_ramp_has_three_with_every_wavelet(wavelet: str) -> None:
    side, levels = 256, 3
    measured = kurtoses(ramp(side), wavelet)
    for level, kurtosis in enumerate(measured, 1):
        kept = inner_ranges(side, wavelet, levels)[level - 1]
        values = 3 * (kept.stop - kept.start) ** 2
        if values < 192:
            assert kurtosis is None  # a long filter sees the border from everywhere
        else:
            assert kurtosis == pytest.approx(3, abs=5 * np.sqrt(24 / values))
    assert measured[0] is not None


@pytest.mark.parametrize("wavelet", ["haar", "db2", "sym5", "coif3"])
def test_the_figures_are_scipys_on_coefficients_that_do_not_see_the_border(wavelet: str) -> None:
    band = ramp(256)
    for ours, theirs in zip(kurtoses(band, wavelet), inner_kurtoses(band, wavelet, 3)):
        assert ours is None or ours == pytest.approx(theirs, rel=1e-4)


def test_a_window_too_small_for_the_filter_has_none() -> None:
    assert kurtoses(ramp(64), "db38") == (None, None, None)
    assert kurtoses(ramp(64), "coif3")[2] is None
