"""Seams traced from labels: where they are, smooth, joined, and the same in whatever tiles the labels come."""
from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
import pytest
from seam_inspector.plugin.imagery.grids import Grid
from seam_inspector.plugin.seams.measure.seamlines.seam_tracing import SidedSeam, seams_of, trace_borders

from tests.numbers.seams.scan.lines.labelled import (
    LABEL_PX,
    distances,
    edges_of,
    estimated,
    points_along,
    points_between,
)
from tests.numbers.synthetic import read_pixels

SIDE = 200  # samples of a small mosaic


def trace_seams(labels: np.ndarray, grid: Grid, side: int = 512) -> list[SidedSeam]:
    return seams_of(trace_borders(edges_of(labels, side), grid, labels.shape[1], LABEL_PX))


def grid_of(labels: np.ndarray) -> Grid:
    rows, columns = labels.shape
    return Grid(576000.0, 5188000.0, 0.5, 0.5, columns * LABEL_PX, rows * LABEL_PX)


def traced(labels: np.ndarray, side: int = 512) -> list[SidedSeam]:
    return trace_seams(labels.astype(np.int16), grid_of(labels), side)


def pixels(seam: SidedSeam, labels: np.ndarray) -> np.ndarray:
    """Vertices as columns and rows of the mosaic."""
    grid = grid_of(labels)
    return (seam.vertices - (grid.left, grid.top)) / (grid.pixel_width, -grid.pixel_height)


def half_plane(angle_deg: float, offset: float = 0.0) -> np.ndarray:
    """Labels 0 and 1 on either side of a line through the middle."""
    row, column = np.mgrid[:SIDE, :SIDE] - (SIDE - 1) / 2
    angle = np.radians(angle_deg)
    return (column * np.sin(angle) - row * np.cos(angle) > offset).astype(np.int16)


def off_the_line(places: np.ndarray, angle_deg: float) -> np.ndarray:
    angle = np.radians(angle_deg)
    column, row = (places - SIDE * LABEL_PX / 2).T
    return abs(column * np.sin(angle) - row * np.cos(angle))


@pytest.mark.parametrize("angle_deg", [0, 3, 10, 30, 45, 63, 90, 120, 178])
def test_a_straight_seam_has_no_stairs(angle_deg: float) -> None:
    labels = half_plane(angle_deg)
    (seam,) = traced(labels)
    places = points_along([seam.vertices], grid_of(labels))
    off = off_the_line(places, angle_deg)
    assert off[40:-40].max() < 3
    assert off.max() < 6  # its ends are corners of samples
    path = pixels(seam, labels)
    length = np.hypot(*np.diff(path, axis=0).T).sum()
    assert length < 1.005 * np.hypot(*(path[-1] - path[0]))


@pytest.mark.parametrize("angle_deg", [0, 40, 90, 135])
def test_left_and_right_are_seen_when_walking_along(angle_deg: float) -> None:
    for labels in (half_plane(angle_deg), 1 - half_plane(angle_deg)):
        (seam,) = traced(labels)
        path = pixels(seam, labels)
        middle, ahead = path.mean(axis=0), path[-1] - path[0]
        ahead /= np.hypot(*ahead)
        left_hand = np.array([ahead[1], -ahead[0]])  # rows run down
        for side, hand in ((seam.left, left_hand), (seam.right, -left_hand)):
            column, row = (middle + 60 * hand) // LABEL_PX
            assert labels[int(row), int(column)] == side


def test_seams_meet_where_three_sources_do() -> None:
    labels = np.zeros((SIDE, SIDE), np.int16)
    labels[100:] = 1
    labels[100:, 90:] = 2
    seams = traced(labels)
    assert {(seam.left, seam.right) for seam in seams} == {(0, 1), (0, 2), (1, 2)}
    ends = Counter(tuple(end) for seam in seams for end in seam.vertices[[0, -1]].tolist())
    assert sorted(ends.values()) == [1, 1, 1, 3]
    assert sorted(pixels(seams[0], labels).tolist()) == [[360, 400], [800, 400]]


def test_what_none_is_followed_in_has_no_seam_and_a_narrow_gap_does_not_hide_one() -> None:
    labels = half_plane(90)
    labels[:60] = -1
    labels[:, 97:102] = -1
    labels[150:, 70:130] = -1
    (seam,) = traced(labels)
    path = pixels(seam, labels)
    np.testing.assert_allclose(path[:, 0], 400, atol=6)
    np.testing.assert_allclose(sorted(path[[0, -1], 1]), [240, 600], atol=12)


def test_islands_below_600_px_are_gone_and_larger_ones_have_a_ring() -> None:
    labels = half_plane(90)
    labels[20:26, 30:36] = 2  # 576 px squared
    labels[120:160, 30:60] = 2
    labels[60:66, 97:103] = 2  # on the seam
    labels[80:84, 150:154] = -1
    ring, seam = sorted(traced(labels), key=lambda line: line.right, reverse=True)
    assert (ring.left, ring.right) == (0, 2)
    np.testing.assert_array_equal(ring.vertices[0], ring.vertices[-1])
    np.testing.assert_allclose(pixels(ring, labels).min(axis=0), [120, 480], atol=4)
    assert (seam.left, seam.right) == (0, 1)
    assert abs(pixels(seam, labels)[:, 0] - 400).max() < 4


def test_seams_come_longest_first_and_stay_inside_the_mosaic() -> None:
    labels = np.repeat(np.repeat(np.arange(16).reshape(4, 4), 50, 0), 50, 1)
    grid = Grid(0.0, 0.0, 0.5, 0.5, SIDE * LABEL_PX - 3, SIDE * LABEL_PX - 1)  # the last samples stick out
    seams = trace_seams(labels.astype(np.int16), grid)
    lengths = [np.hypot(*np.diff(seam.vertices, axis=0).T).sum() for seam in seams]
    assert len(seams) == 24
    assert lengths == sorted(lengths, reverse=True)
    places = np.concatenate([seam.vertices for seam in seams])
    assert places[:, 0].max() == (SIDE * LABEL_PX - 3) / 2
    assert places[:, 1].min() == -(SIDE * LABEL_PX - 1) / 2


def quilt(rows: int, columns: int, seed: int) -> np.ndarray:
    """Areas of seven sources with crooked borders, and a hole."""
    rng = np.random.default_rng(seed)
    row, column = np.mgrid[:rows, :columns]
    places = rng.uniform(0, (rows, columns), (12, 2))
    labels = np.argmin([(row - y) ** 2 + (column - x) ** 2 for y, x in places], axis=0) % 7
    labels[(row - rows / 3) ** 2 + (column - columns / 2) ** 2 < 900] = -1
    return labels.astype(np.int16)


@pytest.mark.slow
@pytest.mark.parametrize("side", [37, 100, 512])
def test_the_tiles_that_labels_come_in_do_not_show(side: int) -> None:
    labels = estimated(quilt(700, 600, 1), 2)
    whole = traced(labels, max(labels.shape))
    in_tiles = traced(labels, side)
    assert len(in_tiles) == len(whole) > 10
    for seam, other in zip(whole, in_tiles):
        np.testing.assert_array_equal(seam.vertices, other.vertices)
        assert (seam.left, seam.right) == (other.left, other.right)


@pytest.fixture(scope="module")
def brighton(data_folder: Path) -> np.ndarray:
    """The source that each pixel is from, -1 outside."""
    path = data_folder / "seams" / "brighton" / "source_label.tif"
    return read_pixels(str(path), 0, 0, 3423, 2987)[0].astype(np.int16) - 1


@pytest.mark.release
@pytest.mark.parametrize(("seed", "right_near", "right_far"), [(None, 1, 1), (1, 0.94, 0.995), (2, 0.9, 0.99)])
def test_seams_of_brighton_lie_where_the_true_ones_do(
    brighton: np.ndarray, seed: int | None, right_near: float, right_far: float
) -> None:
    labels = brighton[2::4, 2::4]
    if seed is not None:
        labels = estimated(labels, seed, right_near, right_far)
    grid = Grid(576665.77, 5188204.05, 0.03, 0.03, 3423, 2987)
    seams = trace_seams(labels, grid)
    true, traced_points = points_between(brighton), points_along([seam.vertices for seam in seams], grid)
    for apart in (distances(traced_points, true), distances(true, traced_points)):
        assert (apart * 0.03 <= 0.3).mean() >= 0.95
        assert (apart * 0.03 <= 0.6).mean() >= 0.99
    length = len(traced_points) * 0.5 * 0.03
    assert 255 < length < 280  # 372 m along the stairs
    assert len(seams) < 26
