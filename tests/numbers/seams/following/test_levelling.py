"""Sources brought to the mosaic's grey values: balanced, dodged and flattened tones come out, fine detail stays."""
from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.levelling import left_over, levelled
from seam_inspector.plugin.seams.measure.tone import coarse_means

from tests.numbers.synthetic import texture

SHAPE = (256, 320)
EVERYWHERE = np.ones(SHAPE, bool)


@pytest.fixture(scope="module")
def source() -> np.ndarray:
    """A plane (rows, columns) float32 with large shapes and fine detail."""
    return (120 + 25 * texture(SHAPE, 2.0, 1) + 6 * texture(SHAPE, 0.0, 2)).astype(np.float32)


def brought(mosaic: np.ndarray, source: np.ndarray, own: np.ndarray, clear: np.ndarray) -> np.ndarray:
    """The source in the mosaic's grey values."""
    return levelled(coarse_means(mosaic.astype(np.float32), 3), source, own, clear).plane


def across(first: float, last: float) -> np.ndarray:
    return np.broadcast_to(np.linspace(first, last, SHAPE[1], dtype=np.float32), SHAPE)


TONES: dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "as it was": lambda plane: plane,
    "gain 0.6": lambda plane: 0.6 * plane + 20,
    "gain 1.3": lambda plane: 1.3 * plane - 30,
    "negative": lambda plane: 255 - plane,
    "dodged": lambda plane: plane * across(0.7, 1.1),
    "shadow": lambda plane: plane + across(-20, 30),
}


def fine(plane: np.ndarray) -> np.ndarray:
    return plane - ndimage.gaussian_filter(plane, 2)


@pytest.mark.parametrize("sigma", [0.5, 0.8, 1.2])
def test_fine_detail_that_is_gone_is_not_taken_for_a_tone(source: np.ndarray, sigma: float) -> None:
    mosaic = ndimage.gaussian_filter(0.8 * source + 10, sigma)
    found = brought(mosaic, source, EVERYWHERE, EVERYWHERE)
    assert fine(found).std() / fine(source).std() == pytest.approx(0.8, rel=0.06)
    assert fine(mosaic).std() < 0.9 * fine(found).std()


def unevenness(mosaic: np.ndarray, source: np.ndarray) -> float:
    means = [coarse_means(plane, 3) for plane in (mosaic, source)]
    curve, local = left_over(*means, np.ones(means[0].shape, bool))
    return 1 - local / curve if curve > 0.3 else 0.0


def test_a_tone_that_changes_from_place_to_place_leaves_more_over_than_one_curve(source: np.ndarray) -> None:
    assert unevenness(TONES["dodged"](source), source) > 0.8
    assert unevenness(TONES["shadow"](source), source) > 0.8
    noise = np.random.default_rng(3).normal(0, 6, SHAPE)
    for even in (source, 0.6 * source + 20, 255 * (np.clip(source, 1, 255) / 255) ** 0.7, source + noise):
        assert unevenness(even.astype(np.float32), source) < 0.35


@pytest.mark.parametrize("even", [0.3, 0.6, 0.8])
def test_even_ground_does_not_decide_on_a_gain(source: np.ndarray, even: float) -> None:
    """Water on most of the window: all of its squares fit any gain."""
    water = np.broadcast_to((np.arange(SHAPE[0]) < even * SHAPE[0])[:, np.newaxis], SHAPE)
    ground = np.where(water, np.float32(60), source)
    noisy = 0.8 * ground + 12 + np.where(water, 0, 2 * texture(SHAPE, 1.0, 8))
    found = levelled(coarse_means(noisy.astype(np.float32), 3), ground, EVERYWHERE, EVERYWHERE)
    np.testing.assert_allclose(found.gain, 0.8, atol=0.1)
