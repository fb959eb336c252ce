"""Ticks where the seam of the judged window enters what is seen of it."""
from __future__ import annotations

import numpy as np
from seam_inspector.plugin.seams.desk.map.seam_ticks import Tick, seam_ticks

SAMPLE = 4


def middles(seam: np.ndarray) -> np.ndarray:
    """Column and row, px, of squares by their row and column."""
    return (seam[:, ::-1] + 0.5) * SAMPLE


def test_a_slanting_seam_crosses_two_edges_of_the_box() -> None:
    rows = np.arange(64)
    seam = np.stack([rows, rows // 2 + 10], axis=1)  # from 40 px at the top to 166 at the bottom
    found = seam_ticks(middles(seam), (0, 0, 256, 256), SAMPLE)
    assert [tick.inwards for tick in found] == [(0, 1), (0, -1)]
    top, bottom = found
    assert abs(top.column - 42) <= SAMPLE
    assert abs(bottom.column - 166) <= SAMPLE
    assert (top.row, bottom.row) == (0, 256)


def test_what_is_seen_decides_where_the_edges_are_and_each_crossing_has_one_tick() -> None:
    rows = np.arange(64)
    upright = np.stack([rows, np.full(64, 10)], axis=1)
    other = np.stack([rows, np.full(64, 40)], axis=1)
    seam = np.concatenate([upright, other])
    found = seam_ticks(middles(seam), (20.0, 100.0, 200.0, 150.0), SAMPLE)
    assert sorted(tick.column for tick in found) == [42.0, 42.0, 162.0, 162.0]
    assert {tick.row for tick in found} == {100.0, 150.0}
    assert seam_ticks(middles(seam)[:0], (0, 0, 256, 256), SAMPLE) == []
    assert Tick(20.0, 120.0, (1, 0)) not in found
