"""Pieces of a scan's layer that are cut anew, and which of them as one."""
from __future__ import annotations

from typing import Any

import pytest
from osgeo import ogr
from seam_inspector.plugin.seams.measure.limits import ALL, FAILED, REDUCED
from seam_inspector.plugin.seams.measure.mending.failed_runs import FIELDS, given_pieces, part_of, seam_runs

NUMBERS = {"a.tif": 0, "b.tif": 1}


def feature(first: float, last: float, state: str = "failed", verdict: str = "significant", **more: Any) -> Any:
    """A piece of the seam 1 along the x axis."""
    line = ogr.CreateGeometryFromWkt(f"LINESTRING ({first} 0, {last} 0)")
    row = {"seam_id": 1, "station": first, "left_source": "a.tif", "right_source": "b.tif", "length": last - first,
           "kept_1": 0.5, "state": state, "verdict": verdict, **more}  # fmt: skip
    return row, bytes(line.ExportToWkb())


PASSED = feature(20, 30, "passed", "reduced")
SOUND = feature(30, 40, "passed", "preserved")


@pytest.mark.parametrize(("what", "count"), [(FAILED, 1), (REDUCED, 2), (ALL, 3)])
def test_what_is_wanted(what: str, count: int) -> None:
    pieces = given_pieces([feature(0, 10), PASSED, SOUND], FIELDS, what)
    assert [piece.is_wanted for piece in pieces].count(True) == count
    assert not any(piece.is_wanted for piece in given_pieces([feature(0, 10)], FIELDS, what, lambda vertices: False))


def test_a_piece_in_a_collection_is_one_too() -> None:
    row, wkb = feature(0, 10)
    line = ogr.CreateGeometryFromWkb(wkb).ExportToWkt()
    held = ogr.CreateGeometryFromWkt(f"GEOMETRYCOLLECTION ({line}, POINT (1 1))")
    (piece,) = given_pieces([(row, bytes(held.ExportToWkb()))], FIELDS, ALL)
    assert piece.piece.vertices.tolist() == [[0, 0], [10, 0]]


def test_pieces_that_follow_each_other_are_one_run() -> None:
    pieces = given_pieces([feature(10, 30, kept_1=0.2), feature(0, 10), feature(40, 50)], FIELDS, FAILED)
    runs, unnamed = seam_runs(pieces, NUMBERS, 0.1)
    assert [(run.numbers, run.piece.length_m, run.sides) for run in runs] == [((1, 0), 30, (0, 1)), ((2,), 10, (0, 1))]
    assert (runs[0].kept, unnamed) == (pytest.approx(0.3), [])
    assert [run.numbers for run in seam_runs(pieces, NUMBERS, 0.02)[0]] == [(1,), (0,), (2,)]  # 20 m are too long


def test_a_part_of_a_run_lies_between_two_places() -> None:
    (run,) = given_pieces([feature(10, 30, station=100.0)], FIELDS, ALL)
    part = part_of(run, 5, 12).piece
    assert (part.vertices.tolist(), part.station_m, part.length_m) == ([[15, 0], [22, 0]], 105, 7)


def test_a_ring_is_cut_in_two_halves() -> None:
    row, _ = feature(0, 40)
    ring = ogr.CreateGeometryFromWkt("LINESTRING (0 0, 10 0, 10 10, 0 10, 0 0)")
    halves = [given.piece for given in given_pieces([(row, bytes(ring.ExportToWkb()))], FIELDS, ALL)]
    assert [halve.vertices.tolist() for halve in halves] == [[[0, 0], [10, 0], [10, 10]], [[10, 10], [0, 10], [0, 0]]]
    assert [(halve.station_m, halve.length_m) for halve in halves] == [(0, 20), (20, 20)]


def test_pieces_without_two_orthoimages_are_told_apart() -> None:
    pieces = given_pieces([feature(0, 10, left_source=""), feature(20, 25, right_source="c.tif")], FIELDS, ALL)
    assert seam_runs(pieces, NUMBERS, 0.1) == ([], pieces)


@pytest.mark.parametrize("kept", [1e308, -3.5, "nan", "inf", None])
def test_what_no_seam_can_keep_is_not_measured(kept: Any) -> None:
    pieces = given_pieces([feature(0, 10, kept_1=kept), feature(10, 30)], FIELDS, FAILED)
    assert [piece.kept for piece in pieces] == [None, 0.5]
    (run,), _ = seam_runs(pieces, NUMBERS, 0.1)
    assert run.kept == 0.5
