"""The judge bar: what it says, its buttons, how much is judged, confidence and remark, and how narrow it gets."""
from __future__ import annotations

import pytest
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QLineEdit
from seam_inspector.plugin.seams.desk.judge_bar import JudgeBar
from seam_inspector.plugin.seams.desk.judging import Judging

from tests.qgis.seams.desk.windows_session import WindowsSession

DESCENDING = Qt.SortOrder.DescendingOrder


@pytest.mark.parametrize(
    ("fids", "sentence"),
    [
        ([], "Select a window to judge it."),
        ([1], "Reduced. 10.0 % of detail lost beside the seam."),
        (
            [2],
            "Significant loss. 44 % of detail lost beside the seam: feathered. Feather less.",
        ),
        ([3], "Not inspected yet."),
        ([4], "No source covers <window> in west_12.tif."),
        ([10], "Preserved. As much of the finest detail is left beside the seam as around it."),
        ([12], "Significant loss. Detail at level 1 is 45 % of the sources'. Changed since: inspect it again."),
        ([1, 2, 12], "3 windows selected."),
    ],
)
def test_sentence(bar: JudgeBar, session: WindowsSession, fids: list[int], sentence: str) -> None:
    session.select(fids)
    assert bar.sentence() == sentence


def test_buttons_show_and_write_the_judgement_and_go_on(bar: JudgeBar, session: WindowsSession) -> None:
    session.select([2])
    assert (bar._visible.isChecked(), bar._invisible.isChecked()) == (True, False)
    bar._invisible.click()
    assert session.row(2).observer == "invisible"  # type: ignore[union-attr]
    assert session.selected() == [12]
    bar._unsure.click()
    assert session.row(12).observer == "unsure"  # type: ignore[union-attr]
    session.select([2])
    assert (bar._visible.isChecked(), bar._invisible.isChecked()) == (False, True)
    bar._invisible.click()  # again: takes it back, and stays
    assert session.row(2).observer == ""  # type: ignore[union-attr]
    assert session.selected() == [2]
    session.select([])
    assert not any(button.isEnabled() for button in (bar._visible, bar._invisible, bar._unsure))


def test_a_judgement_that_was_not_written_is_not_shown(
    bar: JudgeBar, session: WindowsSession, monkeypatch: pytest.MonkeyPatch
) -> None:
    session.select([1])
    monkeypatch.setattr(session, "judge", lambda fids, word, operator: None)  # the layer is read-only
    bar._visible.click()
    assert not bar._visible.isChecked()
    assert session.selected() == [1]


def test_how_much_is_judged_is_always_said(bar: JudgeBar, session: WindowsSession, judging: Judging) -> None:
    assert bar._progress.text() == "2 to go: 2 of 4 judged"
    session.select([1])
    judging.judge("unsure")
    assert bar._progress.text() == "1 to go: 2 of 4 judged, 1 not sure"
    assert "1 not sure" in bar._progress.toolTip()
    judging.judge("visible")
    assert bar._progress.text() == "0 to go: 3 of 4 judged, 1 not sure"
    judging.change(operator=2)
    assert bar._progress.text() == "4 to go: 0 of 4 judged"


def test_confidence_and_remark_are_written_where_the_operator_is(
    bar: JudgeBar, session: WindowsSession, judging: Judging
) -> None:
    session.select([1])
    bar.key_actions()["sure 70"]()
    assert session.row(1).confidence == 70  # type: ignore[union-attr]
    bar.key_actions()["sure 100"]()
    judging.change(operator=2)
    bar.key_actions()["sure 10"]()
    row = session.row(1)
    assert row is not None
    assert (row.confidence, row.confidence_2) == (100, 10)


def test_a_digit_after_a_verdict_is_the_judged_window_s(bar: JudgeBar, session: WindowsSession) -> None:
    keys = bar.key_actions()
    session.select([1])
    keys["visible"]()
    assert session.selected() == [12]
    keys["sure 80"]()
    assert bar._progress.text() == "Window 1: 80 % sure"
    keys["sure 70"]()  # corrected
    assert _sure(session) == {1: 70}
    assert session.selected() == [12]
    session.select([2])
    session.select([12])
    assert bar._progress.text() == "1 to go: 3 of 4 judged"
    keys["sure 50"]()
    assert _sure(session) == {1: 70, 12: 50}


def _sure(session: WindowsSession) -> dict[int, int]:
    return {row.window_id: row.confidence for row in session.rows if row.confidence is not None}


def test_a_remark_takes_one_key_and_enter(bar: JudgeBar, session: WindowsSession) -> None:
    def remark(words: str, key: Qt.Key) -> None:
        assert bar.key_actions()["remark"]()
        assert bar.question.labelText() == "Remark on window 1:"
        QTest.keyClicks(bar.question.findChild(QLineEdit), words)
        QTest.keyClick(bar.question, key)

    session.select([1])
    remark("by the kerb", Qt.Key.Key_Return)
    assert session.row(1).remark == "by the kerb"  # type: ignore[union-attr]
    assert bar.remark.isChecked()
    assert "by the kerb" in bar.remark.toolTip()
    remark("no", Qt.Key.Key_Escape)
    assert session.row(1).remark == "by the kerb"  # type: ignore[union-attr]
    session.select([2])
    assert not bar.remark.isChecked()
    session.select([])
    assert not bar.key_actions()["remark"]()


def test_blind_tells_nothing_of_what_was_found(bar: JudgeBar, session: WindowsSession, judging: Judging) -> None:
    session.select([2])
    judging.change(is_blind=True)
    assert bar.sentence() == "Window 2. Results are hidden."
    assert bar._chip.isHidden()
    assert "significant" not in bar._sentence.toolTip().lower()
    assert "blind" in bar.operators.currentText()


def test_a_remark_right_after_a_verdict_is_of_the_window_just_judged(bar: JudgeBar, session: WindowsSession) -> None:
    keys = bar.key_actions()
    session.select([1])
    keys["visible"]()
    keys["sure 80"]()
    (following,) = session.selected()
    assert keys["remark"]()
    assert bar.question.labelText() == "Remark on window 1:"
    bar.question.setTextValue("kerb gone")
    bar.question.accept()
    assert (session.row(1).remark, session.row(following).remark) == ("kerb gone", "")  # type: ignore[union-attr]
