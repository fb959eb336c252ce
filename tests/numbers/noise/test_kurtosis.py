"""Kurtosis of noise on a ramp: 3 whatever the wavelet, because what the wrap-around makes at the border is left out."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.imagery.limits import WAVELETS
from seam_inspector.plugin.noise.measure.band_noise import inner_ranges, measure_noise

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
