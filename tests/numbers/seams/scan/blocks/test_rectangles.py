"""Rectangles that are measured densely cover all that is wanted, and nothing twice."""
from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import array_shapes, arrays
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.measure.blocks.block_grid import MARGIN_PX, UNIT_PX, UNITS, rectangles

from tests.examples import at_most

MOST_PX = 2.7e6


def covered(found: list[PixelWindow], shape: tuple[int, ...]) -> np.ndarray:
    """How often each unit is, (rows, columns)."""
    counts = np.zeros(shape, int)
    for one in found:
        assert one.width > 0
        assert one.height > 0
        assert not (one.column % UNIT_PX)
        assert not (one.row % UNIT_PX)
        assert not (one.width % UNIT_PX)
        assert not (one.height % UNIT_PX)
        rows = slice(one.row // UNIT_PX, (one.row + one.height) // UNIT_PX)
        columns = slice(one.column // UNIT_PX, (one.column + one.width) // UNIT_PX)
        assert rows.stop <= shape[0]
        assert columns.stop <= shape[1]
        counts[rows, columns] += 1
    return counts


def read_px(found: list[PixelWindow]) -> int:
    """Pixels of all, with their margins."""
    return sum((one.width + 2 * MARGIN_PX) * (one.height + 2 * MARGIN_PX) for one in found)


@given(arrays(bool, array_shapes(min_dims=2, max_dims=2, max_side=24)))
def test_all_that_is_wanted_is_covered_once(wanted: np.ndarray) -> None:
    counts = covered(rectangles(wanted), wanted.shape)
    assert counts.max(initial=0) <= 1
    assert counts[wanted].all()
    if not wanted.any():
        assert not counts.any()


@given(st.integers(0, 2**32 - 1), st.sampled_from([0.002, 0.02, 0.1, 0.5, 0.95, 1.0]))
@at_most(30)
def test_of_a_whole_block_too_and_none_is_larger_than_memory_allows(seed: int, share: float) -> None:
    wanted = np.random.default_rng(seed).random((UNITS, UNITS)) < share
    found = rectangles(wanted)
    counts = covered(found, wanted.shape)
    assert counts.max(initial=0) <= 1
    assert counts[wanted].all()
    assert all(one.width * one.height <= MOST_PX for one in found)


@pytest.mark.parametrize("wanted", [np.eye(UNITS, dtype=bool), np.fliplr(np.eye(UNITS, dtype=bool))])
def test_a_slanting_seam_is_not_measured_as_one_square(wanted: np.ndarray) -> None:
    found = rectangles(wanted)
    assert covered(found, wanted.shape)[wanted].all()
    assert read_px(found) < 0.4 * (UNITS * UNIT_PX) ** 2
