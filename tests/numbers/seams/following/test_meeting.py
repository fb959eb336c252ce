"""Shares of several sources in a wide feather: against weights that are planted."""
from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import nnls
from seam_inspector.plugin.seams.measure.following.meeting import (
    SQUARE_PX,
    by_shares,
    mixed_shares,
    where_several_meet,
)
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN

from tests.numbers.synthetic import texture

SHAPE = (128, 160)
NUMBERS = (0, 2, 5)


@pytest.fixture(scope="module")
def sources() -> dict[int, np.ndarray]:
    """High-passed planes that have half of their detail in common."""
    common, *own = (25 * texture(SHAPE, 0.5, seed) for seed in range(1, 5))
    return {number: (common + one).astype(np.float32) for number, one in zip(NUMBERS, own)}


@pytest.fixture(scope="module")
def labels() -> np.ndarray:
    """Three sources that meet in the middle."""
    found = np.zeros(SHAPE, np.uint8)
    found[:, 80:] = NUMBERS[1]
    found[64:, 80:] = NUMBERS[2]
    return found


def near(labels: np.ndarray) -> np.ndarray:
    found = where_several_meet(labels, NUMBERS, {})
    assert found is not None
    return found


def test_shares_are_those_that_were_mixed(sources: dict[int, np.ndarray], labels: np.ndarray) -> None:
    planted = dict(zip(NUMBERS, (0.5, 0.2, 0.3)))
    mosaic = sum(share * sources[number] for number, share in planted.items()).astype(np.float32)
    found = mixed_shares(mosaic, sources, labels, near(labels))
    for number, share in planted.items():
        np.testing.assert_allclose(found[number], share, atol=0.02)


def test_no_share_is_below_0(sources: dict[int, np.ndarray], labels: np.ndarray) -> None:
    """Against the non-negative least squares of scipy, over a whole square of 40 px."""
    mosaic = 0.7 * sources[0] + 0.5 * sources[2] - 0.2 * sources[5]
    found = mixed_shares(mosaic, sources, labels, near(labels))
    row, column = 8, 10
    around = np.s_[(row - 2) * SQUARE_PX : (row + 3) * SQUARE_PX, (column - 2) * SQUARE_PX : (column + 3) * SQUARE_PX]
    weights, _ = nnls(np.stack([source[around].ravel() for source in sources.values()], axis=1), mosaic[around].ravel())
    np.testing.assert_allclose([one[row, column] for one in found.values()], weights / weights.sum(), atol=0.01)


def test_a_cut_is_no_mixture(sources: dict[int, np.ndarray], labels: np.ndarray) -> None:
    mosaic = np.choose(np.searchsorted(NUMBERS, labels), list(sources.values()))
    assert not any(one.any() for one in mixed_shares(mosaic, sources, labels, near(labels)).values())


def test_two_sources_do_not_meet_a_third_that_is_far_or_has_no_pixels(labels: np.ndarray) -> None:
    assert where_several_meet(np.where(labels == 5, 2, labels), NUMBERS, {}) is None
    assert where_several_meet(labels, NUMBERS, {2: np.zeros(SHAPE, bool)}) is None
    far = np.zeros((64, 640), np.uint8)
    far[:, 300:], far[:, 600:] = 2, 5
    assert where_several_meet(far, NUMBERS, {}) is None


def test_what_is_most_of_a_mixture_of_three_is_followed(labels: np.ndarray) -> None:
    squares = tuple(length // SQUARE_PX for length in SHAPE)
    shares = {0: np.full(squares, 0.3), 2: np.full(squares, 0.45), 5: np.full(squares, 0.25)}
    unknown = np.where(np.arange(SHAPE[1]) < 8, np.uint8(UNKNOWN), labels)
    found = by_shares(unknown, shares)
    assert (found[:, :8] == UNKNOWN).all()
    assert (found[:, 8:] == 2).all()
