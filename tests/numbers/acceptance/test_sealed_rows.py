"""A layer of seams is as its scan left it, or the decision says what is not."""
from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest
from seam_inspector.plugin.acceptance.measure.delivered_rows import LayerDoubts, overlap
from seam_inspector.plugin.acceptance.measure.delivery import DeliveredLayer, DeliveredPiece
from seam_inspector.plugin.imagery.seam_totals import SeamTotals

Rows = list[tuple[Mapping[str, object], np.ndarray]]
STATES = "passed", "failed", "passed"


def rows() -> Rows:
    """A seam along x in three pieces of 25 m, of which the second failed."""
    return [
        ({"seam_id": 1, "station": 25.0 * place, "length": 25.0, "level": "piece", "state": state,
          "kept_1": 0.95 if state == "passed" else 0.4},
         np.array([(25.0 * place, 0.0), (25.0 * place + 25, 0.0)]))
        for place, state in enumerate(STATES)
    ]  # fmt: skip


def ends(line: np.ndarray) -> list[float]:
    return line[[0, -1]].ravel().tolist() if len(line) else []


def read(held: Rows, metadata: Mapping[str, str]) -> DeliveredLayer:
    doubts = LayerDoubts("a")
    for row, line in held:
        doubts.piece("a", row, line, 25.0 * bool(len(line)), ends(line))
    return doubts.layer(metadata)


def sealed() -> dict[str, str]:
    return SeamTotals.of_rows((row, ends(line)) for row, line in rows()).metadata


def test_in_any_order() -> None:
    found = read(rows()[::-1], sealed())
    assert (found.is_sealed, found.lacking_m) == (True, 0)


@pytest.mark.parametrize("line", [np.empty((0, 2)), np.array([(30.0, 0.0)] * 2), np.array([(30.0, np.nan)] * 2)])
def test_a_piece_that_lost_its_line_is_missed(line: np.ndarray) -> None:
    """Its row still says that it failed, and it lies nowhere."""
    held = rows()
    held[1] = held[1][0], line
    found = read(held, sealed())
    assert (found.is_sealed, found.lacking_m) == (False, 25)
    assert read(held, {}).lacking_m == 25  # of an export too, once


def test_a_piece_that_was_moved_is_noticed() -> None:
    held = rows()
    held[1] = held[1][0], held[1][1] + 5000
    assert read(held, sealed()).is_sealed is False


# --- lengths, and pieces that lie on each other -----------------------------------------------------------------


def piece(number: int, first_m: float, last_m: float, y: float = 0.0, length: object = None) -> DeliveredPiece:
    line = np.array([(first_m, y), ((first_m + last_m) / 2, y), (last_m, y)])
    made = LayerDoubts(f"sheet {number}").piece(f"sheet {number}", {"length": length}, line, last_m - first_m)
    assert made is not None
    return made


@pytest.mark.parametrize(("written", "told"), [(0.5, 0.5), (7.0, 7.0), (0.0, 5.0), (-3.0, 5.0), (None, 5.0)])
def test_a_length_that_is_none_is_that_of_the_line(written: float | None, told: float) -> None:
    assert piece(0, 0.0, 5.0, length=written).length_m == told


@pytest.mark.parametrize("shared_m", [6.0, 8.0])
def test_what_lies_on_another_piece_counts_once(shared_m: float) -> None:
    """Two of 10 m that share some of their line, others beside them, which share none."""
    pieces = [piece(0, 0.0, 10.0), piece(1, 10.0 - shared_m, 20.0 - shared_m), piece(2, 0.0, 10.0, 40.0),
              piece(3, 25.0, 35.0)]  # fmt: skip
    found = overlap(pieces)
    assert found is not None
    assert found[0] == pytest.approx(shared_m, abs=1.5)
    assert set(found[1]) == {"sheet 0", "sheet 1"}


def test_pieces_that_follow_each_other_share_nothing() -> None:
    assert overlap([piece(number, 10.0 * number, 10.0 * number + 10.0) for number in range(6)]) is None
