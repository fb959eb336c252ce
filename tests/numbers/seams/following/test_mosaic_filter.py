"""What came over a whole mosaic as a linear filter: its taps against those of scipy's operations."""
from __future__ import annotations

import numpy as np
import pytest
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.followed_source import high_pass
from seam_inspector.plugin.seams.measure.following.source_filters import (
    REACH_PX,
    filter_power,
    fit_filter,
    through_filter,
)

from tests.numbers.synthetic import texture

SHAPE = (192, 224)
EVERYWHERE = np.ones(SHAPE, bool)


@pytest.fixture(scope="module")
def plane() -> np.ndarray:
    """(rows, columns) float32"""
    return (120 + 20 * texture(SHAPE, 1.6, 1) + 6 * texture(SHAPE, 0.0, 2)).astype(np.float32)


def gaussian(sigma: float) -> np.ndarray:
    """5 x 5 taps that add up to 1."""
    point = np.zeros((2 * REACH_PX + 1,) * 2)
    point[REACH_PX, REACH_PX] = 1
    taps: np.ndarray = ndimage.gaussian_filter(point, sigma, radius=REACH_PX, mode="constant")
    return taps / taps.sum()


def tap(row: int = 0, column: int = 0) -> np.ndarray:
    made = np.zeros((2 * REACH_PX + 1,) * 2)
    made[REACH_PX + row, REACH_PX + column] = 1
    return made


def cubic_half() -> np.ndarray:
    """Keys 1981 half a pixel to the right: four taps."""
    made = np.zeros((2 * REACH_PX + 1,) * 2)
    made[REACH_PX, 1:] = np.array([-1, 9, 9, -1]) / 16
    return made


KERNELS = {
    "nothing": tap(), "unsharp": 2 * tap() - gaussian(0.8), "half a pixel, bilinear": (tap() + tap(0, 1)) / 2,
    "half a pixel, cubic": cubic_half(), "blur 0.6 px": gaussian(0.6), "a pixel": tap(-1, 1),
    "unsharp and blur": 1.5 * gaussian(0.5) - 0.5 * gaussian(1.2),
}


@pytest.mark.parametrize("gain", [None, 1.0])
@pytest.mark.parametrize("kernel", KERNELS)
def test_the_taps_are_those_that_were_applied(plane: np.ndarray, kernel: str, gain: float | None) -> None:
    made = ndimage.correlate(plane, KERNELS[kernel], mode="nearest")
    fitted = fit_filter(high_pass(made), high_pass(plane), EVERYWHERE, gain)
    assert np.abs(fitted - KERNELS[kernel]).max() < (0.02 if gain else 0.05)


@pytest.mark.parametrize("kernel", ["nothing", "unsharp", "half a pixel, cubic", "blur 0.6 px"])
def test_ground_of_another_image_does_not_spoil_the_filter(plane: np.ndarray, kernel: str) -> None:
    """Two fifths of the mosaic are of an image that shows the same ground 2 px beside, as a neighbour that is not given
    does: the source explains its own part as if all were its."""
    beside = np.roll(plane, (2, 1), (0, 1))
    is_own = np.arange(SHAPE[1]) < 0.6 * SHAPE[1]
    made = ndimage.correlate(np.where(is_own, plane, beside), KERNELS[kernel], mode="nearest")
    filtered, source = high_pass(made), high_pass(plane)
    result = through_filter(filtered, source, EVERYWHERE)
    part = np.s_[12:-12, 12 : int(0.6 * SHAPE[1]) - 12]
    assert np.square(filtered - result)[part].mean() < 0.005 * np.square(filtered)[part].mean()


def power_of(plane: np.ndarray, shown: np.ndarray) -> float:
    """Power of the filter between two planes, as it is learned."""
    taps = fit_filter(high_pass(shown.astype(np.float32)), high_pass(plane), EVERYWHERE, 1.0)
    assert taps is not None
    power = filter_power([taps])
    assert power is not None
    return power


@pytest.mark.parametrize("beta", [0.0, 1.6, 3.0])
@pytest.mark.parametrize("kept", [0.3, 0.5, 0.7])
@pytest.mark.parametrize("overview", [1.4, 2.5])
def test_detail_that_is_partly_given_back_to_an_overview_is_taken_evenly(
    beta: float, kept: float, overview: float
) -> None:
    plane = (120 + 20 * texture(SHAPE, beta, 3)).astype(np.float32)
    coarse = ndimage.gaussian_filter(plane, overview)
    assert power_of(plane, coarse + kept * (plane - coarse)) > 0.45
