"""Seams in pieces of equal length on the ground, and which piece is nearest."""
from __future__ import annotations

import time

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from osgeo import ogr
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import PieceIndex, SeamPiece, cut_in_pieces, cut_off

GRID = Grid(576000.0, 5188000.0, 0.25, 0.25, 8000, 6000)  # 2000 x 1500 m


def seam(*places: tuple[float, float], left: int | str | None = 0, right: int | str | None = 1) -> SeamPiece:
    """A seam by metres from the upper left corner of the mosaic, x to the right and y down."""
    x, y = np.array(places, dtype=float).T
    return SeamPiece(0, 0.0, 0.0, np.column_stack([GRID.left + x, GRID.top - y]), left, right)


def crooked(seed: int, count: int, step_m: float = 3.0) -> SeamPiece:
    """A random walk inside the mosaic."""
    rng = np.random.default_rng(seed)
    heading = np.cumsum(rng.normal(0, 0.3, count)) + rng.uniform(0, 6)
    x = 1000 + np.cumsum(step_m * np.cos(heading))
    y = 750 + np.cumsum(step_m * np.sin(heading))
    return seam(*zip(x.clip(5, 1995), y.clip(5, 1495)))


def metres(line: np.ndarray) -> float:
    return float(np.hypot(*np.diff(line, axis=0).T).sum())


def test_a_stretch_that_leads_out_of_all_mosaics_takes_no_memory() -> None:
    near = PieceIndex([seam((0, 0), (10, 10), (10, 1e15))], GRID).beside([30.0], [4000.0], 30.0)
    assert (near.number, near.distance_px) == ([0], pytest.approx([10.0], abs=0.1))


def brute_force(pieces: list[SeamPiece], columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Distance in pixels of each place to each piece, (pieces, places)."""
    out = np.full((len(pieces), len(columns)), np.inf)
    place = columns + 1j * rows
    for number, piece in enumerate(pieces):
        x, y = piece.vertices.T
        line = (x - GRID.left) / GRID.pixel_width + 1j * (GRID.top - y) / GRID.pixel_height
        for start, stop in zip(line[:-1], line[1:]):
            share = ((place - start) * (stop - start).conjugate()).real / max(abs(stop - start) ** 2, 1e-30)
            out[number] = np.minimum(out[number], abs(place - start - share.clip(0, 1) * (stop - start)))
    return out


def test_a_seam_is_cut_evenly_and_the_rest_is_spread() -> None:
    pieces = cut_in_pieces([seam((10, 10), (80, 10), (80, 50))], 25, GRID)
    assert [piece.length_m for piece in pieces] == pytest.approx([27.5] * 4)
    assert [piece.station_m for piece in pieces] == pytest.approx([0, 27.5, 55, 82.5])
    assert {(piece.seam_id, piece.left, piece.right) for piece in pieces} == {(1, 0, 1)}
    np.testing.assert_allclose(pieces[2].vertices, seam((65, 10), (80, 10), (80, 22.5)).vertices)


@given(st.integers(0, 10_000), st.integers(2, 60), st.floats(1, 300))
def test_pieces_together_are_the_seam(seed: int, count: int, piece_m: float) -> None:
    whole = crooked(seed, count)
    pieces = cut_in_pieces([whole], piece_m, GRID)
    lengths = np.array([piece.length_m for piece in pieces])
    assert lengths.sum() == pytest.approx(metres(whole.vertices))
    assert np.ptp(lengths) < 1e-6
    assert len(pieces) == 1 or piece_m * 2 / 3 <= lengths[0] <= piece_m * 1.5
    for piece in pieces:
        assert metres(piece.vertices) == pytest.approx(piece.length_m, abs=1e-6)
    for piece, other in zip(pieces, pieces[1:]):
        np.testing.assert_array_equal(piece.vertices[-1], other.vertices[0])


def test_lengths_are_metres_on_the_ground_where_the_map_has_degrees() -> None:
    grid = Grid(20.0, 52.0, 1e-5, 1e-5, 4000, 4000, 68_500.0, 111_250.0)
    line = SeamPiece(0, 0, 0, np.array([[20.001, 51.999], [20.003, 51.999], [20.003, 51.998]]), "a", "b")
    pieces = cut_in_pieces([line], 62.0625, grid)
    assert [piece.length_m for piece in pieces] == pytest.approx([62.0625] * 4)
    np.testing.assert_allclose(pieces[-1].vertices[-1], [20.003, 51.998], rtol=0, atol=1e-12)


def test_what_leaves_the_mosaic_is_cut_off_and_told() -> None:
    # From outside into the mosaic, out over the upper edge, in again and to its lower right corner.
    line = seam((-50, 20), (100, 20), (100, -30), (200, -30), (200, 20), (2000, 1500), (2100, 1500))
    pieces = cut_in_pieces([line], 10_000, GRID)
    assert [piece.station_m for piece in pieces] == pytest.approx([50, 330])
    assert pieces[0].length_m == pytest.approx(120)
    assert pieces[1].length_m == pytest.approx(20 + np.hypot(1800, 1480))
    for piece in pieces:
        x, y = piece.vertices.T
        assert GRID.left <= x.min() < x.max() <= GRID.left + 2000
        assert GRID.top - 1500 <= y.min() < y.max() <= GRID.top
    notice = cut_off([line], pieces, GRID)
    assert str(notice).startswith("310 m of the 2780 m")


@given(st.integers(0, 10_000))
def test_what_is_left_of_a_seam_is_what_gdal_finds_inside(seed: int) -> None:
    """A walk in long steps, out of the mosaic and in again."""
    rng = np.random.default_rng(seed)
    line = seam(*(rng.uniform(-0.2, 1.2, (30, 2)) * (2000, 1500)).tolist())
    whole = ogr.CreateGeometryFromWkt("LINESTRING (" + ", ".join(f"{x} {y}" for x, y in line.vertices) + ")")
    left, bottom, right, top = GRID.extent
    box = ogr.CreateGeometryFromWkt(f"POLYGON (({left} {bottom}, {right} {bottom}, {right} {top}, {left} {top}, "
                                    f"{left} {bottom}))")
    pieces = cut_in_pieces([line], 1e6, GRID)
    assert sum(piece.length_m for piece in pieces) == pytest.approx(whole.Intersection(box).Length(), abs=2)
    assert sum(metres(piece.vertices) for piece in pieces) == pytest.approx(sum(piece.length_m for piece in pieces))


@pytest.mark.parametrize("reach_px", [1.0, 20.0, 400.0])
def test_the_nearest_piece_is_that_of_a_search_through_all(reach_px: float) -> None:
    pieces = cut_in_pieces([crooked(seed, 150) for seed in range(4)], 25, GRID)
    rng = np.random.default_rng(5)
    # A third anywhere, the others about the seams.
    about = np.concatenate([piece.vertices for piece in pieces])
    about = about[rng.integers(0, len(about), 2000)] + rng.normal(0, 3, (2000, 2))
    columns = np.concatenate([rng.uniform(-50, 8050, 1000), (about[:, 0] - GRID.left) / GRID.pixel_width])
    rows = np.concatenate([rng.uniform(-50, 6050, 1000), (GRID.top - about[:, 1]) / GRID.pixel_height])
    near = PieceIndex(pieces, GRID).beside(columns, rows, reach_px)
    number, distance = near.number, near.distance_px
    true = brute_force(pieces, columns, rows)
    nearest = true.min(axis=0)
    sure = abs(nearest - reach_px) > 0.1
    np.testing.assert_array_equal((number >= 0)[sure], (nearest <= reach_px)[sure])
    hit = number >= 0
    np.testing.assert_allclose(distance[hit], nearest[hit], atol=0.1)
    # The piece named is the nearest one, or as near as makes no difference.
    np.testing.assert_allclose(true[number[hit], np.flatnonzero(hit)], nearest[hit], atol=0.1)
    assert np.isinf(distance[~hit]).all()


def test_a_hundred_thousand_pieces_cost_a_block_next_to_nothing() -> None:
    """A block takes some 300 ms."""
    grid = Grid(0.0, 200_000.0, 0.25, 0.25, 800_000, 800_000)
    rng = np.random.default_rng(2)
    start = rng.uniform(0, 200_000, (100_000, 1, 2))
    pieces = [SeamPiece(1, 0, 25, line, 0, 1) for line in start + np.array([[0, 0], [12, 3], [20, 15]])]
    index = PieceIndex(pieces, grid)
    blocks = [PixelWindow(column * 2048, row * 2048, 2048, 2048) for row in range(10) for column in range(20)]
    started = time.process_time()
    assert sum(len(index.near(block, 300)) for block in blocks) > 0
    assert time.process_time() - started < 0.01 * len(blocks)
