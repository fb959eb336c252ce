"""Grey values before and after: gain, bias, gamma and clipping against numpy, scipy and what was done."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats
from seam_inspector.plugin.seams.measure.compared_image import Change
from seam_inspector.plugin.seams.measure.tone import Tone, clipped_share, coarse_means, fit_tones

from tests.examples import at_most
from tests.numbers.synthetic import orthoimage

LEVELS = 3
SIDE = 256
EVERYWHERE = np.ones((SIDE >> LEVELS, SIDE >> LEVELS), bool)


@pytest.fixture(scope="module")
def band() -> np.ndarray:
    """8 bit, (256, 256)."""
    pixels: np.ndarray = orthoimage((SIDE, SIDE))[1]
    return pixels


def fit(mosaic: np.ndarray, source: np.ndarray, where: np.ndarray = EVERYWHERE) -> Tone:
    means = [coarse_means(band, LEVELS)[np.newaxis] for band in (mosaic, source)]
    (tone,) = fit_tones(*means, where, [(source[np.newaxis], (1.0,))])
    assert tone is not None
    return tone


@at_most(25)
@given(gain=st.floats(-2, 2).filter(lambda gain: abs(gain) > 0.05), bias=st.floats(-100, 100))
def test_a_line_is_recovered(band: np.ndarray, gain: float, bias: float) -> None:
    tone = fit(gain * band.astype(np.float32) + bias, band)
    assert (tone.gain, tone.bias) == pytest.approx((gain, bias), rel=1e-3, abs=0.01)
    assert tone.gamma == 1


def test_a_quarter_of_foreign_content_does_not_turn_the_line(band: np.ndarray) -> None:
    mosaic = 0.7 * band.astype(np.float32) + 12
    mosaic[:, : SIDE // 4] = 250 - band[:, : SIDE // 4]
    x, y = (coarse_means(plane, LEVELS).ravel() for plane in (band, mosaic))
    robust = stats.theilslopes(y[::4], x[::4])
    assert fit(mosaic, band).gain == pytest.approx(0.7, rel=1e-3)
    assert abs(robust.slope - 0.7) < abs(np.polyfit(x, y, 1)[0] - 0.7)  # that least squares would have been turned
    known = EVERYWHERE & (np.arange(SIDE >> LEVELS) >= (SIDE >> LEVELS) // 4)
    assert fit(mosaic, band, known).gain == pytest.approx(0.7)


@pytest.mark.parametrize("gamma", [0.5, 0.6, 0.8, 1.25, 1.6, 2.2])
def test_a_power_function_is_recovered(band: np.ndarray, gamma: float) -> None:
    mosaic = np.rint(255 * (band / 255) ** gamma).astype(np.uint8)
    assert fit(mosaic, band).gamma == pytest.approx(gamma, abs=0.05)


def test_nothing_is_made_up_where_there_is_nothing_to_fit(band: np.ndarray) -> None:
    flat = np.full_like(band, 90)
    means = [coarse_means(plane, LEVELS)[np.newaxis] for plane in (band, flat)]
    pixels: list[tuple[np.ndarray, Sequence[float]]] = [(band[np.newaxis], (1.0,))]
    assert fit_tones(means[0], means[1], EVERYWHERE, pixels) == [None]
    assert fit_tones(means[1], means[0], EVERYWHERE, pixels) == [None]
    assert fit_tones(means[0], means[0], np.zeros_like(EVERYWHERE), pixels) == [None]


@pytest.mark.parametrize("share", [0.01, 0.03, 0.1])
def test_clipped_share_is_what_was_clipped(share: float) -> None:
    values = np.random.default_rng(2).normal(120, 25, (SIDE, SIDE))
    low, high = np.quantile(values, (share / 2, 1 - share / 2))
    source = np.clip(np.rint(values), 0, 255).astype(np.uint8)
    stretched = np.clip(np.rint((source - low) * 255 / (high - low)), 0, 255).astype(np.uint8)
    assert clipped_share(stretched, source) == pytest.approx(share, abs=0.4 * share)  # whole values are coarse


def evenly_spread() -> np.ndarray:
    """8 bit, every value as often as the others."""
    return np.random.default_rng(3).permuted(np.arange(256).repeat(SIDE)).reshape(SIDE, SIDE).astype(np.uint8)


@pytest.mark.parametrize("gain", [0.5, 0.3, 0.15, 0.08])
def test_values_that_a_gain_merges_at_the_ends_are_not_clipped(gain: float) -> None:
    source = evenly_spread()
    narrowed = np.rint(gain * source + 20).astype(np.uint8)
    assert np.count_nonzero(narrowed == narrowed.min()) > SIDE  # several values have become one
    assert clipped_share(narrowed, source) == 0


@pytest.mark.parametrize("gain", [0.5, -0.5])
def test_sharpness_is_contrast_over_gain(gain: float) -> None:
    change = Change(Tone(gain, 0.0), (0.4, None), 0.0, None, None)
    assert change.sharpness == (pytest.approx(0.8), None)
    for unknown in (None, Tone(0.0, 90.0)):
        assert Change(unknown, (0.4, None), 0.0, None, None).sharpness == (None, None)
