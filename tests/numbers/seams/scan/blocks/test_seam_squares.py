"""Parts of a mosaic that its seamlines call for."""
from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.grids import Grid
from seam_inspector.plugin.seams.measure.blocks.block_grid import (
    BESIDE_PX,
    UNIT_PX,
    UNITS,
    BlockGrid,
    blocks_near,
    units_along,
)
from seam_inspector.plugin.seams.measure.seamlines.given_seams import SidedSeam

from tests.examples import at_most

COLUMNS, ROWS = 5000, 2500
GRID = Grid(1000.0, 9000.0, 0.25, 0.5, COLUMNS, ROWS)
BLOCKS = BlockGrid(GRID)
STEP_PX = 0.5
SPARE_PX = 13  # lines are looked at 24 px apart


def seam(*places: tuple[float, float]) -> SidedSeam:
    """Through columns and rows of the mosaic."""
    columns, rows = np.array(places, float).T
    vertices = np.column_stack([GRID.left + columns * GRID.pixel_width, GRID.top - rows * GRID.pixel_height])
    return SidedSeam(vertices, None, None)


def points_along(places: list[tuple[float, float]]) -> np.ndarray:
    """(n, 2), close to each other."""
    parts = [np.linspace(place, other, max(2, int(np.hypot(*np.subtract(other, place)) / STEP_PX)))
             for place, other in zip(places, places[1:])]
    return np.concatenate(parts)


def near(places: list[tuple[float, float]], reach_px: float) -> np.ndarray:
    """Units of the mosaic that reach within a distance, along an axis, of a line; (rows, columns) bool."""
    squares = np.zeros((BLOCKS.rows * UNITS, BLOCKS.columns * UNITS), bool)
    for column, row in points_along(places):
        first, last = (np.floor((np.array([row, column]) + by) / UNIT_PX).astype(int) for by in (-reach_px, reach_px))
        first = np.maximum(first, 0)
        has_pixels = row - reach_px < ROWS and column - reach_px < COLUMNS  # the last units reach beyond the mosaic
        if has_pixels and (last >= 0).all():
            squares[first[0] : last[0] + 1, first[1] : last[1] + 1] = True
    squares[-(-ROWS // UNIT_PX) :] = False
    squares[:, -(-COLUMNS // UNIT_PX) :] = False
    return squares


place = st.tuples(st.integers(-300, COLUMNS + 300), st.integers(-300, ROWS + 300))


@pytest.mark.slow
@given(st.lists(place, min_size=2, max_size=4))
@example([(0, 2511), (29, 2549)])  # beyond the edge, where a unit of few pixels begins
@at_most(25)
def test_units_beside_a_seam_are_measured_and_no_others(places: list[tuple[float, float]]) -> None:
    dense = units_along([seam(*places)], BLOCKS)
    assert dense[near(places, BESIDE_PX - SPARE_PX)].all()
    assert not dense[~near(places, BESIDE_PX + 1)].any()


def test_a_corridor_leaves_out_blocks_that_no_seam_is_near_to() -> None:
    reach = 200.0 / UNIT_PX
    assert blocks_near(units_along([seam((100, 100), (100, 1900))], BLOCKS), BLOCKS, reach) == [(0, 0), (1, 0)]
    assert (1, 0) not in blocks_near(units_along([seam((100, 100), (100, 1200))], BLOCKS), BLOCKS, reach)
    assert blocks_near(units_along([seam((100, 100), (100, 1900))], BLOCKS), BLOCKS) == [(0, 0)]
