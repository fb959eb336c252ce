"""What goes back to the producer, failure by failure."""
from __future__ import annotations

import pytest
from seam_inspector.plugin.acceptance.measure.decision import defects_of

from tests.numbers.acceptance.made_decisions import IMAGES, PIECE_M, decided, window_on, with_windows


def test_pieces_without_a_break_are_one_defect_the_longest_first() -> None:
    defects = defects_of(decided(["a", "b"], failed=[(1, 20), (0, 3), (0, 4), (0, 5)]))
    assert [(defect.run.number, defect.run.sheets) for defect in defects] == [(1, ("a",)), (2, ("b",))]
    assert [defect.run.length_m for defect in defects] == [75, 25]
    assert len(defects[0].pieces) == 3
    assert defects[0].run.place == pytest.approx(decided(["a"]).delivery.pieces[4].middle, abs=1)
    assert (defects[1].worst.piece.left_source, defects[1].worst.piece.right_source) == IMAGES
    assert defects_of(decided()) == ()


def test_cause_and_remarks_come_from_the_windows_on_it() -> None:
    plain = decided(failed=[(0, 10), (0, 11)])
    seen = with_windows(
        plain, window_on(plain, 11, "blur", "kerb gone"),
        window_on(plain, 10, "feathering", "kerb gone", "<b>"),
        window_on(plain, 30, "gamma", "elsewhere"),
    )  # fmt: skip
    (defect,) = defects_of(seen)
    assert defect.worst.piece.number == 10
    assert defect.cause == "feathering"
    assert set(defect.remarks) == {"kerb gone", "<b>"}
    assert defect.run.length_m == 2 * PIECE_M


def test_a_window_over_two_failures_is_of_the_one_nearest_to_its_middle() -> None:
    """Pieces of 25 m, of which the window shows parts of three; none of it is said of a failure that it only meets."""
    plain = decided(failed=[(0, 10), (0, 12)])
    upper, lower = defects_of(with_windows(plain, window_on(plain, 12, "blur", "kerb gone")))
    assert [(defect.pieces[0].piece.number, defect.remarks) for defect in (upper, lower)] == [
        (10, ()), (12, ("kerb gone",)),
    ]  # fmt: skip
    assert (upper.cause, lower.cause) == ("", "blur")
