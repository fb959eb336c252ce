"""Kurtosis of noise on a ramp: 3 whatever the wavelet, because what the wrap-around makes at the border is left out."""
from __future__ import annotations

import numpy as np
import pytest
import pywt
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.limits import WAVELETS
from seam_inspector.plugin.noise.measure.band_noise import inner_ranges, measure_noise

from tests.examples import at_most
from tests.numbers.noise.inner_coefficients import inner_kurtoses


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
    found = kurtoses(ramp(side), wavelet)
    for level, kurtosis in enumerate(found, 1):
        kept = inner_ranges(side, wavelet, levels)[level - 1]
        values = 3 * (kept.stop - kept.start) ** 2
        if values < 192:
            assert kurtosis is None  # a long filter sees the border from everywhere
        else:
            assert kurtosis == pytest.approx(3, abs=5 * np.sqrt(24 / values))
    assert found[0] is not None


@pytest.mark.parametrize("levels", [2, 3, 4, 5, 6])
def test_noise_on_a_ramp_has_three_at_every_level(levels: int) -> None:
    found = kurtoses(ramp(1024), "coif3", levels)
    for level, kurtosis in enumerate(found, 1):
        if level < 6:
            assert kurtosis == pytest.approx(3, abs=6 * np.sqrt(24 / (3 * (1024 / 2**level - 16) ** 2)))
    assert levels < 6 or found[5] is None  # 4 x 4 coefficients are left


@pytest.mark.parametrize("wavelet", ["haar", "db2", "sym5", "coif3"])
def test_the_figures_are_scipys_on_coefficients_that_do_not_see_the_border(wavelet: str) -> None:
    band = ramp(256)
    for ours, theirs in zip(kurtoses(band, wavelet), inner_kurtoses(band, wavelet, 3)):
        assert ours is None or ours == pytest.approx(theirs, rel=1e-4)


@at_most(40)
@given(wavelet=st.sampled_from(WAVELETS), eighths=st.integers(8, 60), levels=st.integers(1, 3))
def test_inner_coefficients_are_those_of_a_longer_line(wavelet: str, eighths: int, levels: int) -> None:
    length = 8 * eighths
    line = np.random.default_rng(eighths).normal(0, 1, 3 * length)
    alone, longer = (
        pywt.wavedec(samples, wavelet, mode="periodization", level=levels)[:0:-1]
        for samples in (line[length : 2 * length], line)
    )
    for kept, details, there in zip(inner_ranges(length, wavelet, levels), alone, longer):
        same = np.isclose(details, there[len(details) : 2 * len(details)], rtol=0, atol=1e-13)
        assert same[kept].all()
        if kept.stop > kept.start and wavelet in ("haar", "db2", "db4", "sym5", "coif1", "coif3"):  # no tap near 0
            assert not same[: kept.start].all() or kept.start == 0
            assert same[kept].sum() >= same.sum() - 2


def test_a_window_too_small_for_the_filter_has_none() -> None:
    assert kurtoses(ramp(64), "db38") == (None, None, None)
    assert kurtoses(ramp(64), "coif3")[2] is None
