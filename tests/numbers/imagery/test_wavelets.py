"""The curve is that of ``pywt.wavedec2`` in float64, and what Pyka's papers say about it holds."""
from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
import pywt
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery import limits as imagery_limits
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.wavelets import (
    Curve,
    clip_curves,
    detail_components,
    placed_components,
)

from tests.numbers.synthetic import decompose, luminance, orthoimage, placed_wavedec, texture, wavedec, without_mean

WEIGHTS = (0.299, 0.587, 0.114)
NEGLIGIBLE = 1e-25  # share of the total variance: rounding of float64, also that of PyWavelets


def shares(curve: Curve) -> np.ndarray:
    return np.array([*curve.detail, curve.background])


def curve_of(band: np.ndarray, wavelet: str = "coif3", levels: int = 3) -> Curve:
    ((curve,), _) = clip_curves(band[np.newaxis], wavelet, levels)
    return curve


def assert_curve(curve: Curve, band: np.ndarray, wavelet: str, levels: int) -> None:
    """Every share to 1e-6 of the variance, every component to 1e-4 of itself, as the design promises."""
    expected = decompose(band, wavelet, levels)
    assert len(curve.detail) == levels
    np.testing.assert_allclose(shares(curve), expected.shares, rtol=0, atol=1e-6)
    matters = expected.shares > NEGLIGIBLE
    matters[-1] &= expected.coarse.size > 1  # a single pixel less its mean is 0
    np.testing.assert_allclose(shares(curve)[matters], expected.shares[matters], rtol=1e-4, atol=0)
    assert (np.abs(shares(curve)[expected.shares < NEGLIGIBLE]) < 1e-20).all()
    assert curve.variance == pytest.approx(expected.energy / band.size, rel=1e-7)


def test_the_wavelets_are_the_orthogonal_ones_of_pywavelets() -> None:
    """dmey's published coefficients are orthonormal to 0.2 % only."""
    discrete = pywt.wavelist(kind="discrete")
    orthogonal = {name for name in discrete if pywt.Wavelet(name).orthogonal}
    assert {*imagery_limits.WAVELETS} == orthogonal - {"dmey"}


@pytest.mark.parametrize("wavelet", imagery_limits.WAVELETS)
def test_curve_with_every_wavelet(wavelet: str) -> None:
    clips = [
        (orthoimage((64, 200), 1)[0], 3),
        (np.round(60000 + texture((72, 136), 1.0)).astype(np.uint16), 2),
        ((1e6 + 3 * texture((64, 64), 2.0)).astype(np.float32), 6),
        (0.2 + 0.1 * texture((66, 90), 0.5), 1),
    ]
    for band, levels in clips:
        assert_curve(curve_of(band, wavelet, levels), band, wavelet, levels)


@given(
    seed=st.integers(0, 2**32 - 1),
    wavelet=st.sampled_from(imagery_limits.WAVELETS),
    levels=st.integers(1, 6),
    height=st.integers(1, 12),
    width=st.integers(1, 12),
    beta=st.floats(0, 5),
    dtype=st.sampled_from([np.uint8, np.uint16, np.int16, np.int32, np.float32, np.float64]),
    contrast=st.floats(0.1, 60),
    offset=st.sampled_from([0, 100, 30000, 60000, 1e6]),
)
def test_curve_of_any_clip(
    seed: int,
    wavelet: str,
    levels: int,
    height: int,
    width: int,
    beta: float,
    dtype: type,
    contrast: float,
    offset: float,
) -> None:
    side = 2**levels
    shape = (side * max(height, -(-64 // side)), side * max(width, -(-64 // side)))
    values = offset + contrast * texture(shape, beta, seed)
    if np.dtype(dtype).kind in "iu":
        values = np.round(values).clip(np.iinfo(dtype).min, np.iinfo(dtype).max)
    band = values.astype(dtype)
    if band.min() == band.max():
        assert curve_of(band, wavelet, levels).variance == 0
    else:
        assert_curve(curve_of(band, wavelet, levels), band, wavelet, levels)


LARGE = (1024, 1024)
SIDES = (256, 512, 1024)
KINDS = {
    "8 bit": lambda shape: np.round(128 + 40 * texture(shape, 2.0)).clip(0, 255).astype(np.uint8),
    "8 bit, dark": lambda shape: np.round(12 + 4 * texture(shape, 2.2)).clip(0, 255).astype(np.uint8),
    "8 bit, half of it saturated": lambda shape: np.round(250 + 60 * texture(shape, 2.0)).clip(0, 255).astype(np.uint8),
    "8 bit, smooth": lambda shape: np.round(128 + 40 * texture(shape, 3.0)).clip(0, 255).astype(np.uint8),
    "12 bit": lambda shape: np.round(600 + 150 * texture(shape, 2.3)).clip(0, 4095).astype(np.uint16),
    "16 bit": lambda shape: np.round(30000 + 9000 * texture(shape, 2.5)).clip(0, 65535).astype(np.uint16),
    "16 bit, little contrast far from 0": lambda shape: np.round(60000 + 3 * texture(shape, 2.0)).astype(np.uint16),
    "32 bit": lambda shape: np.round(1e8 + 300 * texture(shape, 2.0)).astype(np.int32),
    "float32": lambda shape: (0.3 + 0.1 * texture(shape, 2.0)).astype(np.float32),
    "float32 far from 0": lambda shape: (1e4 + 3 * texture(shape, 2.7)).astype(np.float32),
    "float64 far from 0": lambda shape: 1e6 + 3 * texture(shape, 2.5),
    "too smooth for float32": lambda shape: (100 + 30 * texture(shape, 4.0)).astype(np.float32),
}


@pytest.mark.slow
@pytest.mark.parametrize("side", SIDES)
@pytest.mark.parametrize("kind", KINDS)
def test_curve_of_a_window(kind: str, side: int) -> None:
    band = KINDS[kind]((side, side))
    assert_curve(curve_of(band, "coif3", 3), band, "coif3", 3)


@pytest.mark.parametrize("bands", [3, 4, 5])
@pytest.mark.parametrize("wavelet", ["coif3", "haar"])
def test_luminance_is_that_of_the_mixed_bands(bands: int, wavelet: str) -> None:
    clip = orthoimage((96, 128), bands)
    curves, coarse = clip_curves(clip, wavelet, 3, WEIGHTS)
    assert len(curves) == len(coarse) == bands + 1
    for curve, band in zip(curves, [*clip, luminance(clip)]):
        assert_curve(curve, band, wavelet, 3)


@pytest.mark.parametrize("levels", [1, 2, 3, 4])
@pytest.mark.parametrize("wavelet", ["haar", "coif3", "sym5"])
def test_coarse_components_hold_the_coefficients_of_pywavelets(levels: int, wavelet: str) -> None:
    clip = orthoimage((64, 96), 2)
    coarse = clip_curves(clip, wavelet, levels)[1]
    for band, component in zip(clip, coarse):
        expected = decompose(band, wavelet, levels).coarse
        assert component.shape == expected.shape
        np.testing.assert_allclose(component - component.mean(), expected, atol=1e-4)


@pytest.mark.parametrize("wavelet", ["coif3", "db4", "sym5", "haar", "coif1"])
def test_placed_components_show_a_point_where_it_is(wavelet: str) -> None:
    """To half of 2^r px, in the mean over places beside the grid; PyWavelets' own, moved by whole coefficients."""
    band = orthoimage((256, 192), 1)[0].astype(np.float64)
    components = placed_components(band[np.newaxis], wavelet, 3)
    for directions, level in zip(components, reversed(placed_wavedec(band, wavelet, 3)[1:])):
        for mine, theirs in zip(directions[:, 0], level):
            np.testing.assert_allclose(mine, theirs, atol=1e-9)
    points = np.zeros((8, 256, 256), np.float32)
    places = 120 + np.arange(8)
    points[np.arange(8), places, places] = 1
    for level, directions in enumerate(placed_components(points, wavelet, 3), 1):
        energies, step = np.square(directions), 2**level
        at = step * np.arange(energies.shape[-1]) + (step - 1) / 2
        for axis in (2, 3):
            across = energies.sum(axis=axis)  # (directions, points, places)
            off = across @ at / across.sum(axis=-1) - places
            assert np.abs(off.mean(axis=1)).max() <= step / 2 + 0.1


@pytest.mark.slow
@pytest.mark.parametrize("wavelet", imagery_limits.WAVELETS)
@pytest.mark.parametrize("shape", [(1, 512, 512), (2, 104, 200), (1, 520, 72)])
def test_components_of_float32_planes_with_every_wavelet(wavelet: str, shape: tuple[int, int, int]) -> None:
    planes = np.stack([200 + 40 * texture(shape[1:], 1.5, seed) for seed in range(shape[0])]).astype(np.float32)
    components = list(detail_components(planes, wavelet, 3))
    for index, plane in enumerate(planes):
        for directions, level in zip(components, reversed(wavedec(without_mean(plane), wavelet, 3)[1:])):
            assert directions.dtype == np.float32
            for mine, theirs in zip(directions[:, index], level):
                np.testing.assert_allclose(mine, theirs, rtol=0, atol=1e-5 * np.abs(theirs).max())
                np.testing.assert_allclose(np.linalg.norm(mine), np.linalg.norm(theirs), rtol=2e-5)


@pytest.mark.parametrize("value", [0, 255, 60000, 0.1, 1e6, -3.3])
@pytest.mark.parametrize("shape", [(64, 72), LARGE])
def test_a_constant_clip_has_no_variance_and_no_shares(value: float, shape: tuple[int, int]) -> None:
    dtypes: Sequence[type] = (np.float32, np.float64) if value % 1 else (np.int32, np.float32)
    for dtype in dtypes:
        curve = curve_of(np.full(shape, value, dtype))
        assert curve.variance == 0
        assert np.isnan(shares(curve)).all()


def test_a_constant_band_does_not_spoil_the_others() -> None:
    clip = orthoimage((64, 64), 3)
    clip[1] = 77
    curves = clip_curves(clip, "coif3", 3, WEIGHTS)[0]
    assert curves[1].variance == 0
    for index in (0, 2):
        assert_curve(curves[index], clip[index], "coif3", 3)
    assert_curve(curves[3], luminance(clip), "coif3", 3)


@pytest.mark.parametrize(
    ("wavelet", "levels", "sentence"),
    [
        *((wavelet, 3, f"'{wavelet}' is not orthogonal, or no wavelet of PyWavelets")
          for wavelet in ("bior2.2", "rbio3.1", "dmey", "nonsense", "", "mexh")),
        ("coif3", 0, "0 levels were asked for; give 1 to 8"),
        ("coif3", -1, "-1 levels"),
        ("coif3", 9, "9 levels were asked for; give 1 to 8"),
    ],
)
def test_other_settings_are_refused_with_the_reason(wavelet: str, levels: int, sentence: str) -> None:
    band = texture((512, 512), 1.0)
    with pytest.raises(SettingsError, match=sentence):
        clip_curves(band[np.newaxis], wavelet, levels)
    with pytest.raises(SettingsError, match=sentence):
        next(detail_components(band[np.newaxis], wavelet, levels))


@pytest.mark.parametrize("side", [96, 1024])
def test_the_layout_in_memory_does_not_matter(side: int) -> None:
    clip = orthoimage((side, side), 3)
    by_pixel = np.ascontiguousarray(np.moveaxis(clip, 0, -1))
    spread = np.zeros((3, 2 * side, 3 * side), np.uint8)
    spread[:, ::2, 1::3] = clip
    expected, coarse = clip_curves(clip, "coif3", 3, WEIGHTS)
    for view in (np.moveaxis(by_pixel, -1, 0), spread[:, ::2, 1::3], np.asfortranarray(clip), clip[:, ::-1][:, ::-1]):
        before = view.copy()
        curves, result = clip_curves(view, "coif3", 3, WEIGHTS)
        assert curves == expected
        np.testing.assert_array_equal(result, coarse)
        np.testing.assert_array_equal(view, before)


def test_threads_do_not_get_in_each_others_way() -> None:
    clips = [orthoimage((64 * (1 + seed % 3), 128), 3, seed) for seed in range(24)]
    wavelets = ["coif3", "db4", "sym8"]

    def measure(index: int) -> list[Curve]:
        return clip_curves(clips[index], wavelets[index % len(wavelets)], 3, WEIGHTS)[0]

    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(measure, range(len(clips)))) == [measure(index) for index in range(len(clips))]
