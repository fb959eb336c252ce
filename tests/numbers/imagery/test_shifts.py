"""Shifts between two images: known ones by Fourier's theorem, scikit-image's word, masks, and images that don't fit."""
from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import ndimage
from seam_inspector.plugin.imagery.shifts import find_shift, shifted

from tests.numbers.synthetic import texture

ACCURACY = 0.05  # px
SHIFTS = [(0.0, 0.0), (0.3, -0.2), (0.5, 0.5), (-1.37, 2.81), (7.25, -3.6), (0.02, 0.98), (-31.4, 20.1)]
def pair(x: float, y: float, side: int = 256, seed: int = 0, beta: float = 1.8) -> tuple[np.ndarray, np.ndarray]:
    """A grey image that lies x px to the right of and y px below another one, cut from the same larger scene."""
    scene = 120 + 30 * texture((side + 128, side + 128), beta, seed)
    moved = np.fft.ifft2(ndimage.fourier_shift(np.fft.fft2(scene), (y, x))).real
    inner = np.s_[64 : 64 + side, 64 : 64 + side]
    return moved[inner], scene[inner]


def assert_shift(image: np.ndarray, reference: np.ndarray, x: float, y: float, **given: np.ndarray) -> None:
    shift = find_shift(image, reference, **given)
    assert (shift.x, shift.y) == pytest.approx((x, y), abs=ACCURACY)
    assert shift.length == pytest.approx(np.hypot(x, y), abs=2 * ACCURACY)


@pytest.mark.parametrize(("x", "y"), SHIFTS)
@pytest.mark.parametrize("side", [128, 256, 600])
def test_known_shifts(x: float, y: float, side: int) -> None:
    assert_shift(*pair(x, y, side), x, y)


def test_neither_tone_nor_noise_nor_blur_moves_it() -> None:
    image, reference = pair(1.3, -0.6)
    noise = np.random.default_rng(3)
    assert_shift(0.4 * image + 80, reference, 1.3, -0.6)
    assert_shift(255 * (image / 255).clip(0, 1) ** 0.6, reference, 1.3, -0.6)
    assert_shift(image + noise.normal(0, 4, image.shape), reference, 1.3, -0.6)
    assert_shift(ndimage.gaussian_filter(image, 0.8), reference, 1.3, -0.6)
    assert_shift(np.rint(image).clip(0, 255).astype(np.uint8), np.rint(reference).clip(0, 255), 1.3, -0.6)


@pytest.mark.parametrize("side", [64, 128, 256, 700])
@pytest.mark.parametrize("beta", [0.0, 1.6, 3.0])
def test_strangers_have_no_shift(side: int, beta: float) -> None:
    strangers = [texture((side, side), beta, seed) for seed in range(6)]
    assert all(find_shift(a, b) is None for a, b in combinations(strangers, 2))


def test_a_constant_image_has_no_shift() -> None:
    _, image = pair(0, 0)
    flat = np.full_like(image, 9)
    assert find_shift(flat, image) is find_shift(image, flat) is find_shift(flat, flat) is None


def test_of_a_mosaic_of_two_images_each_part_has_its_own_shift() -> None:
    (west, reference), (east, _) = pair(1.4, -0.7, 512), pair(-0.8, 0.9, 512)
    is_west = np.zeros((512, 512), bool)
    is_west[:, :300] = True
    mosaic = np.where(is_west, west, east)
    assert_shift(mosaic, reference, 1.4, -0.7, where=is_west)
    assert_shift(mosaic, reference, -0.8, 0.9, where=~is_west)


def test_the_part_of_a_stranger_does_not_take_part() -> None:
    image, reference = pair(0.6, 1.1, 512)
    known = np.zeros((512, 512), bool)
    known[100:420, :200] = True
    stranger = 120 + 30 * texture((512, 512), 1.8, seed=77)
    assert_shift(np.where(known, image, stranger), reference, 0.6, 1.1, where=known)
    assert find_shift(np.where(known, image, stranger), reference, ~known) is None


def test_a_tile_that_lies_elsewhere_does_not_lower_the_peak() -> None:
    (most, reference), (other, _) = pair(2.3, -1.1, 512), pair(-4.2, 3.4, 512)
    alone = find_shift(most, reference)
    mosaic = most.copy()
    mosaic[256:, 256:] = other[256:, 256:]
    shift = find_shift(mosaic, reference)
    assert (shift.x, shift.y) == pytest.approx((2.3, -1.1), abs=ACCURACY)
    assert shift.peak == pytest.approx(alone.peak, abs=0.05)


@pytest.mark.parametrize("share", [0.0, 0.001])
def test_too_little_room_has_no_shift(share: float) -> None:
    image, reference = pair(0.6, 1.1)
    where = np.random.default_rng(1).random(image.shape) < share
    assert find_shift(image, reference, where) is None


@given(st.floats(-40, 40), st.floats(-40, 40), st.integers(0, 99))
def test_an_image_is_moved_as_scipy_moves_it(x: float, y: float, seed: int) -> None:
    image = np.random.default_rng(seed).uniform(0, 255, (37, 53)).astype(np.float32)
    expected = ndimage.shift(image.astype(np.float64), (y, x), order=3, mode="nearest")
    assert np.abs(shifted(image, x, y) - expected).max() < 2e-3
