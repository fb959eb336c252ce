"""The longest failure without a break: along a seam, across seams and sheets, and never over a gap."""
from __future__ import annotations

import numpy as np
import pytest
from seam_inspector.plugin.acceptance.measure.deciding import decide
from seam_inspector.plugin.acceptance.measure.decision import FailureRun
from seam_inspector.plugin.acceptance.measure.delivery import DeliveredPiece
from seam_inspector.plugin.acceptance.measure.failure_runs import failure_runs
from seam_inspector.plugin.acceptance.measure.measured_pieces import state_of

from tests.numbers.acceptance.deliveries import delivery, rules, seam

F, P, N = 0.4, 0.95, None  # failed, passed, not measured


def whole_runs(*seams: list[DeliveredPiece], unit_m: float = 1.0) -> tuple[FailureRun, ...]:
    """Failed from end to end of each piece."""
    pieces = delivery(*seams).pieces
    return failure_runs(pieces, [state_of(piece, 0.7) for piece in pieces], unit_m)


def lengths(*seams: list[DeliveredPiece]) -> list[float]:
    return [run.length_m for run in whole_runs(*seams)]


@pytest.mark.parametrize(
    ("kept", "expected"),
    [
        ([P, P, P], []),
        ([F, P, F, F, P, F, F, F], [30, 20, 10]),
        ([F, F, F], [30]),
        ([F, N, F, P, F], [20, 10]),  # what could not be measured does not break a run, and does not count
        ([F, N, N, F], [10, 10]),  # unless it is longer than a typical piece
        ([N, F, N], [10]),
    ],
)
def test_along_one_seam(kept: list[float | None], expected: list[float]) -> None:
    assert lengths(seam(kept)) == expected


def test_crumbs_of_polygons_make_no_typical_piece() -> None:
    assert lengths(seam([F, N, F]), seam([P] * 200, 0.04, seam_id="2", start=(0, 99), number=3)) == [20]


def test_pieces_of_any_order_and_direction() -> None:
    pieces = seam([F, F, F, P])
    turned = [DeliveredPiece(**{**vars(piece), "vertices": piece.vertices[::-1]}) for piece in pieces]
    shuffled = [DeliveredPiece(**{**vars(turned[old]), "number": new}) for new, old in enumerate([2, 0, 3, 1])]
    (run,) = whole_runs(shuffled)
    assert run.length_m == 30
    assert run.pieces in [(1, 3, 0), (0, 3, 1)]
    assert run.place == pytest.approx((15, 0))


def test_a_run_goes_on_over_a_sheet_border_where_the_seams_touch() -> None:
    first, second = seam([P, F, F]), seam([F, F, P], sheet="b", start=(30.1, 0.1), number=3)
    (run,) = whole_runs(first, second)
    assert run.length_m == 40
    assert set(run.sheets) == {"a", "b"}


def test_a_gap_between_sheets_breaks_it() -> None:
    assert lengths(seam([P, F, F]), seam([F, F, P], sheet="b", start=(31, 0), number=3)) == [20, 20]


def test_a_station_that_lacks_breaks_it() -> None:
    pieces = seam([F, F, F])
    assert lengths([DeliveredPiece(**{**vars(piece), "number": place}) for place, piece in enumerate(pieces[::2])]) == [
        10, 10,
    ]  # fmt: skip


def test_three_seams_at_a_node_are_a_line_and_a_branch() -> None:
    along = seam([F, F, F, F])
    branch = seam([F, F], seam_id="2", start=(20, 0), way=(0, 1), number=4)
    assert lengths(along, branch) == [40, 20]
    far = seam([F], seam_id="3", start=(0, 90), number=6)
    assert [run.joined_m for run in whole_runs(along, branch, far)] == [60, 60, 10]


def test_a_ring_is_one_run() -> None:
    corners = [((0, 0), (1, 0)), ((10, 0), (0, 1)), ((10, 10), (-1, 0)), ((0, 10), (0, -1))]
    sides = [
        seam([kept], start=start, way=way, seam_id=str(number), number=number)
        for number, ((start, way), kept) in enumerate(zip(corners, [F, N, F, F]))
    ]
    assert lengths(*sides) == [30]


def test_degrees_are_no_metres() -> None:
    pieces = seam([F, F, F])
    small = [DeliveredPiece(**{**vars(piece), "vertices": piece.vertices / 111_000}) for piece in pieces]
    for place, piece in enumerate(small):
        vars(piece)["station_m"] = None if place else 0.0
    assert [run.length_m for run in whole_runs(small, unit_m=111_000.0)] == [30]


def test_a_seam_that_sheets_cut_is_one_seam() -> None:
    pieces = [
        DeliveredPiece(**{**vars(piece), "sheet": f"sheet {place // 2}", "scan": "mosaic"})
        for place, piece in enumerate(seam([F, P, F, F, P, F]))
    ]
    assert len({piece.seam for piece in pieces}) == 1
    assert lengths(pieces) == [20, 10, 10]
    decision = decide(delivery(pieces), rules())
    assert [sheet.longest_failure_m for sheet in decision.sheets] == pytest.approx([
        decision.runs[number].length_m for number in (1, 0, 2)
    ])  # fmt: skip


def star(ways: list[tuple[float, int]], sound: int = 0) -> list[list[DeliveredPiece]]:
    """Seams that meet in a point: their directions in degrees, and how many pieces of them failed there."""
    seams, number = [], 0
    for place, (degrees, failed) in enumerate(ways):
        way = float(np.cos(np.radians(degrees))), float(np.sin(np.radians(degrees)))
        seams.append(seam([F] * failed + [P] * sound, seam_id=str(place), way=way, number=number))
        number += failed + sound
    return seams


@pytest.mark.parametrize("degrees", [(90, 200, 340), (90, 210, 330), (0, 180, 90)])
def test_at_a_node_of_three_seams_each_failure_ends_whatever_the_angles(degrees: tuple[float, float, float]) -> None:
    assert lengths(*star(list(zip(degrees, (10, 7, 5))))) == [100, 70, 50]
    assert lengths(*star(list(zip(degrees, (4, 2, 2))), sound=5)) == [40, 20, 20]
    assert lengths(*star(list(zip(degrees, (4, 2, 0))), sound=5)) == [60]
