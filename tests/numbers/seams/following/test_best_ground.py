"""What true sources leave over is learned, and other images are told by leaving more."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.seams.measure.following.best_ground import BestGround, learn_best_ground

COUNT = 4000  # places
OWN = np.exp(np.random.default_rng(0).uniform(np.log(100), np.log(3000), COUNT)).astype(np.float32)
"""The mosaic's energy at each."""


def left_by_noise(noise: float, spread: float = 0.15) -> np.ndarray:
    """What noise of that energy leaves over, as chance scatters it."""
    return (noise * np.exp(spread * np.random.default_rng(1).standard_normal(COUNT))).astype(np.float32)


def learned(own: np.ndarray, left: np.ndarray) -> BestGround:
    found = learn_best_ground(own, left)
    assert found is not None
    return found


@pytest.mark.parametrize("share", [0.0, 0.3, 0.6])
def test_other_images_do_not_count_for_what_true_sources_leave_over(share: float) -> None:
    left = left_by_noise(10) + np.where(np.arange(COUNT) < share * COUNT, np.float32(0.2) * OWN, 0)
    found = learned(OWN, left)
    energies = np.array([200.0, 600.0, 2000.0])
    assert found.response(energies) * energies == pytest.approx([10, 10, 10], rel=0.25)
    assert not found.is_of_none()
    strange, alike = found.strangeness(OWN, left)
    of_other = np.arange(COUNT) < share * COUNT
    assert np.count_nonzero(alike[of_other]) >= 0.99 * np.count_nonzero(of_other)
    assert alike[~of_other].mean() < 0.02
    assert np.median(strange[~of_other]) == pytest.approx(0, abs=0.01)


def test_strong_detail_may_all_be_of_another_image() -> None:
    of_other = OWN > 800
    left = np.where(of_other, np.float32(0.9) * OWN, left_by_noise(10))
    found = learned(OWN, left)
    assert not found.is_of_none()
    strange, _ = found.strangeness(OWN, left)
    assert strange[of_other].min() > 0.85
    assert strange[~of_other].max() < 0.05


@pytest.mark.parametrize(("left", "expected"), [(0.19, True), (0.16, False), (0.12, False)])
def test_an_image_leaves_plainly_more_than_true_sources(left: float, expected: bool) -> None:
    """True sources leave 0.1; the image 1.9, 1.6 and 1.2 times as much."""
    found = learned(OWN, np.float32(0.1) * OWN)
    assert found.strangeness(np.array([500.0]), np.array([left * 500]))[1].tolist() == [expected]


@pytest.mark.parametrize(("left", "expected"), [(0.06, True), (0.04, False)])
def test_what_is_next_to_nothing_is_no_image(left: float, expected: bool) -> None:
    found = learned(OWN, np.float32(0.002) * OWN)
    assert found.strangeness(np.array([500.0]), np.array([left * 500]))[1].tolist() == [expected]


def test_where_noise_hides_the_detail_nothing_is_told() -> None:
    found = learned(OWN, left_by_noise(90))
    strange, alike = found.strangeness(np.array([110.0, 1000.0]), np.array([110.0, 1000.0]))
    assert strange[0] == 0
    assert strange[1] > 0.95
    np.testing.assert_array_equal(alike, [False, True])


@pytest.mark.parametrize(("share", "power", "expected"), [
    (0.25, 0.0, True),  # images that merely resemble the true one lack an even share of it
    (0.15, 0.0, False),  # so little may be compression
    (0.25, -0.33, False),  # JPEG of quality 50
    (0.25, -1.0, False),  # noise
    (0.97, 0.0, True),  # strangers
])
def test_ground_of_none_of_the_sources(share: float, power: float, expected: bool) -> None:
    """``share``: what is left over of strong detail; ``power`` of the energy that shares go by."""
    left = np.minimum(share * (OWN / 2100) ** power, 1) * OWN
    assert learned(OWN, left.astype(np.float32)).is_of_none() is expected


def test_nothing_is_learned_of_energies_that_are_no_numbers() -> None:
    own = OWN.copy()
    own[: len(own) // 2] = np.inf
    assert learn_best_ground(own, np.full(len(own), np.nan)) is None
