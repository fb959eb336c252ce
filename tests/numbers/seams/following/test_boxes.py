"""Means, borders and openings in squares around every sample, against scipy's."""
from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import ndimage
from seam_inspector.plugin.seams.measure.following.boxes import (
    box_means,
    near_border,
    opened,
    square_shares,
    square_sums,
    widened,
)

SHAPES = st.tuples(st.integers(9, 40), st.integers(9, 40))


@pytest.mark.parametrize("mirrored", [False, True])
@pytest.mark.parametrize("sides", [(7, 17), (1, 3), (3,), (5, 3, 9)])
@pytest.mark.parametrize("shape", [(40, 60), (17, 64), (6, 30), (5, 5)])
def test_means_are_those_of_a_uniform_filter(shape: tuple[int, int], sides: tuple[int, ...], mirrored: bool) -> None:
    values = np.random.default_rng(1).normal(5, 2, shape)
    mode = "reflect" if mirrored else "nearest"
    for found, side in zip(box_means(values, sides, mirrored), sides):
        assert found.shape == shape
        np.testing.assert_allclose(found, ndimage.uniform_filter(values, side, mode=mode), rtol=1e-4, atol=1e-5)


@given(shape=SHAPES, reach=st.integers(1, 6), seed=st.integers(0, 999))
def test_near_a_border_there_is_more_than_one_label(shape: tuple[int, int], reach: int, seed: int) -> None:
    labels = np.random.default_rng(seed).integers(0, 3, (8, 8)).repeat(6, 0).repeat(6, 1)[: shape[0], : shape[1]]
    side = 2 * reach + 1
    expected = ndimage.minimum_filter(labels, side) != ndimage.maximum_filter(labels, side)
    np.testing.assert_array_equal(near_border(labels.astype(np.uint8), reach), expected)


@given(shape=SHAPES, reach=st.integers(1, 6), share=st.floats(0, 0.3), seed=st.integers(0, 999))
def test_widened_is_scipys_dilation(shape: tuple[int, int], reach: int, share: float, seed: int) -> None:
    mask = np.random.default_rng(seed).random(shape) < share
    square = np.ones((2 * reach + 1,) * 2, bool)
    np.testing.assert_array_equal(widened(mask, reach), ndimage.binary_dilation(mask, square))


@given(shape=SHAPES, side=st.integers(2, 8), share=st.floats(0, 0.2), seed=st.integers(0, 999))
def test_opened_is_scipys_opening(shape: tuple[int, int], side: int, share: float, seed: int) -> None:
    mask = np.random.default_rng(seed).random(shape) >= share / side
    square = np.ones((side, side), bool)
    np.testing.assert_array_equal(opened(mask, side), ndimage.binary_opening(mask, square))


@given(shape=SHAPES, side=st.sampled_from([2, 4]), seed=st.integers(0, 99))
def test_sums_over_squares_are_those_of_numpy(shape: tuple[int, int], side: int, seed: int) -> None:
    a, b = np.random.default_rng(seed).normal(size=(2, *shape)).astype(np.float32)
    rows, columns = (length // side for length in shape)
    whole = (a * b)[: rows * side, : columns * side].reshape(rows, side, columns, side)
    np.testing.assert_allclose(square_sums(a, b, side), whole.sum(axis=(1, 3)), atol=1e-4)
    np.testing.assert_allclose(square_shares(a, side) * side**2, square_sums(a, np.ones_like(a), side), atol=1e-4)
    mask = a > 0
    shares = mask[: rows * side, : columns * side].reshape(rows, side, columns, side).mean(axis=(1, 3))
    np.testing.assert_allclose(square_shares(mask, side), shares, atol=1e-6)
