"""Two images mixed nearly everywhere: filters and weights of both, by images that are known."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.followed_source import high_pass
from seam_inspector.plugin.seams.measure.following.mixed_ground import mixed_filters
from seam_inspector.plugin.seams.measure.profile.window_detail import window_detail

from tests.numbers.seams.following.cuts import expected_of
from tests.numbers.synthetic import texture

SIDE = 384
OFF = ((0.4, -0.3), (-0.2, 0.45))
"""px, that each image is moved by as it is mosaicked."""


@pytest.fixture(scope="module")
def images() -> list[np.ndarray]:
    """Images of one ground, each with half of its texture to itself."""
    ground = texture((SIDE, SIDE), 1.2, 1)
    return [(120 + 12 * ground + 12 * texture((SIDE, SIDE), 1.2, 2 + i)).astype(np.float32) for i in range(2)]


def moved(images: list[np.ndarray]) -> list[np.ndarray]:
    return [ndimage.shift(image, by, order=3, mode="nearest").astype(np.float32) for image, by in zip(images, OFF)]


def ramp(first: float, last: float) -> np.ndarray:
    """The weight of the first image from left to right."""
    return np.broadcast_to(np.linspace(first, last, SIDE, dtype=np.float32), (SIDE, SIDE))


def cut_in_half(images: list[np.ndarray]) -> np.ndarray:
    return high_pass(np.where(np.arange(SIDE) < SIDE // 2, *images))


@pytest.mark.parametrize(("first", "last"), [(0.5, 0.5), (0.8, 0.2), (0.7, 0.7)])
def test_both_filters_are_known_though_no_ground_is_of_one(
    images: list[np.ndarray], first: float, last: float
) -> None:
    placed, weight = moved(images), ramp(first, last)
    mosaic = high_pass(weight * placed[0] + (1 - weight) * placed[1])
    mixed = mixed_filters(mosaic, list(map(high_pass, images)), np.ones((SIDE, SIDE), bool), cut_in_half(images))
    assert mixed is not None
    assert mixed[0] == pytest.approx(1, abs=0.08)
    for (down, across), kernel in zip(OFF, mixed[1]):
        middle = np.array([(kernel.sum(axis=axis) @ np.arange(-2, 3)) / kernel.sum() for axis in (1, 0)])
        np.testing.assert_allclose(middle, (-down, -across), atol=0.12)


def test_a_cut_is_no_mixture(images: list[np.ndarray]) -> None:
    mosaic, fine = cut_in_half(moved(images)), list(map(high_pass, images))
    assert mixed_filters(mosaic, fine, np.ones((SIDE, SIDE), bool), cut_in_half(images)) is None


@pytest.mark.parametrize(("first", "last"), [(0.75, 0.25), (0.9, 0.1)])
def test_sources_are_shown_as_sharp_as_they_were_mixed(images: list[np.ndarray], first: float, last: float) -> None:
    """A filter that is learned of one alone takes what mixing took."""
    placed, weight = moved(images), ramp(first, last)
    mosaic = weight * placed[0] + (1 - weight) * placed[1]
    expected_mosaic = expected_of(mosaic, images)
    for number, true in enumerate(placed):
        shown, expected = high_pass(expected_mosaic.shown[number]), high_pass(true)
        assert np.square(shown).sum() == pytest.approx(np.square(expected).sum(), rel=0.14)
        assert np.corrcoef(shown.ravel(), expected.ravel())[0, 1] > 0.98


def test_images_are_mixed_beside_a_third_that_is_followed_alone(images: list[np.ndarray]) -> None:
    """It is followed most, and has nothing to do with their mixture."""
    third = (120 + 12 * texture((SIDE, SIDE), 1.2, 9)).astype(np.float32)
    placed, weight = moved(images), ramp(0.75, 0.25)
    mosaic = weight * placed[0] + (1 - weight) * placed[1]
    mosaic[SIDE * 9 // 20 :] = third[SIDE * 9 // 20 :]
    expected_mosaic = expected_of(mosaic, [*images, third])
    for number, true in enumerate(placed):
        shown, expected = (high_pass(plane)[: SIDE * 2 // 5] for plane in (expected_mosaic.shown[number], true))
        assert np.square(shown).sum() == pytest.approx(np.square(expected).sum(), rel=0.2)


@pytest.mark.parametrize("contrast", [1.0, 0.5])
def test_the_mean_of_images_of_unlike_contrast_keeps_what_they_have_in_common(contrast: float) -> None:
    """Labels of such a mosaic go round whatever has more detail, here the one and there the other: gains and energies
    that are read by them differ."""
    ground = texture((SIDE, SIDE), 1.2, 1)
    places = [np.exp(0.5 * ndimage.gaussian_filter(texture((SIDE, SIDE), 3.0, 20 + i), 12)) for i in range(2)]
    first, second = (
        (120 + 12 * ground + 12 * place * texture((SIDE, SIDE), 1.2, 2 + i)).astype(np.float32)
        for i, place in enumerate(places)
    )
    mosaic = (first + second) / 2
    given = [first, (120 + contrast * (second - 120)).astype(np.float32)]
    profile = window_detail(mosaic, expected_of(mosaic, given), "coif3", 3).profile
    energies = [np.square(high_pass(plane)).sum() for plane in (mosaic, first, second)]
    assert profile.by_mixture == pytest.approx(energies[0] / np.mean(energies[1:]), abs=0.08)  # the strip is some of it
    assert profile.high < 0.9
