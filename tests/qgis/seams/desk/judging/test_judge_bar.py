"""The judge bar: what it says, its buttons, how much is judged, confidence and remark, and how narrow it gets."""
from __future__ import annotations

import pytest
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication
from seam_inspector.plugin.seams.desk.judge_bar import JudgeBar
from seam_inspector.plugin.seams.desk.judging import Judging
from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel
from seam_inspector.plugin.toolkit.desk.widgets import with_units
from seam_inspector.plugin.toolkit.translation import percent

from tests.qgis.seams.desk.judging.conftest import Asked
from tests.qgis.seams.desk.windows_session import WindowsSession, filter_to, window

DESCENDING = Qt.SortOrder.DescendingOrder


@pytest.mark.parametrize(
    ("fids", "sentence"),
    [
        ([], "Select a window to judge it."),
        ([1], "Reduced. 10.0 % of detail lost beside the seam (10.0 m²)."),
        (
            [2],
            "Significant loss. 44 % of detail lost beside the seam (44 m²): feathered. Cut hard or feather less.",
        ),
        ([3], "Not inspected yet."),
        ([4], "No source covers <window> in west_12.tif."),
        (
            [10],
            "Preserved. Along the seam as much of the finest detail is left as around it.",
        ),
        ([12], "Significant loss. Detail at level 1 is 45 % of the source's. Changed since: inspect it again."),
        ([1, 2, 12], "3 windows selected: 2 significant, 1 reduced, 1 changed since."),
    ],
)
def test_sentence(bar: JudgeBar, session: WindowsSession, fids: list[int], sentence: str) -> None:
    session.select(fids)
    assert bar.sentence() == sentence


@pytest.mark.parametrize(
    ("ratio", "text"), [(0.38, "38"), (0.9996, "99.9"), (1.0, "100"), (1.004, "100.4"), (0.052, "5.2"), (2.5, "250"),
     (0.0, "0"), (0.0006, "0.1"), (0.0003, "0.03"), (0.00001, "0.001"), (1e-9, "0.001")]
)
def test_percent_never_hides_on_which_side_of_one_a_ratio_is(qgis_app: QApplication, ratio: float, text: str) -> None:
    assert percent(ratio) == text



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
    assert "Not sure: 1." in bar._progress.toolTip()
    judging.judge("visible")
    assert bar._progress.text() == "0 to go: 3 of 4 judged, 1 not sure"
    judging.change(operator=2)
    assert bar._progress.text() == "4 to go: 0 of 4 judged"


def test_before_an_inspection_nothing_is_done(bar: JudgeBar, session: WindowsSession) -> None:
    session.put([window(1), window(2)])
    assert bar._progress.text() == "nothing to judge yet"
    assert not bar._next.isEnabled()
    session.change(1, verdict="reduced", ratios=(0.9, 1, 1))
    assert bar._progress.text() == "1 to go: 0 of 1 judged"
    assert bar._next.isEnabled()


def test_steps_and_position(bar: JudgeBar, panel: WindowsPanel, session: WindowsSession) -> None:
    session.select([2])
    assert bar._position.text() == "2 of 6"
    bar._forth.click()
    assert session.selected() == [3]
    bar._back.click()
    bar._back.click()
    assert session.selected() == [1]
    assert not bar._back.isEnabled()
    panel.table.sortByColumn(0, DESCENDING)
    assert bar._position.text() == "6 of 6"
    assert not bar._forth.isEnabled()
    filter_to(panel, choice="preserved")
    assert bar._position.text() == "- of 1"


def test_confidence_and_remark_are_written_where_the_operator_is(
    bar: JudgeBar, session: WindowsSession, judging: Judging
) -> None:
    session.select([1])
    bar.key_actions()["sure 70"]()
    assert session.row(1).confidence == 70  # type: ignore[union-attr]
    bar.key_actions()["sure 100"]()
    assert bar.notes.confidence.value() == session.row(1).confidence == 100  # type: ignore[union-attr]
    bar.notes.confidence.setValue(85)
    judging.change(operator=2)
    assert bar.notes.confidence.text() == "- %"
    bar.key_actions()["sure 10"]()
    row = session.row(1)
    assert row is not None
    assert (row.confidence, row.confidence_2) == (85, 10)


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


def test_a_digit_given_before_the_verdict_is_the_selected_window_s(bar: JudgeBar, session: WindowsSession) -> None:
    keys = bar.key_actions()
    session.select([1])
    for key in ("sure 60", "visible", "sure 90", "invisible"):
        keys[key]()
    assert _sure(session) == {1: 60, 12: 90}


def test_after_a_step_a_digit_is_the_selected_window_s(bar: JudgeBar, session: WindowsSession) -> None:
    keys = bar.key_actions()
    session.select([1])
    for key in ("visible", "before", "sure 40"):
        keys[key]()
    assert _sure(session) == {10: 40}


def test_the_last_window_gets_its_digit_though_none_is_selected_then(bar: JudgeBar, session: WindowsSession) -> None:
    keys = bar.key_actions()
    session.put([window(1, "reduced")])
    session.select([1])
    for key in ("visible", "sure 30"):
        keys[key]()
    assert _sure(session) == {1: 30}


def _sure(session: WindowsSession) -> dict[int, int]:
    return {row.window_id: row.confidence for row in session.rows if row.confidence is not None}


def test_a_remark_takes_one_key_and_enter(bar: JudgeBar, session: WindowsSession) -> None:
    session.select([1])
    bar.activateWindow()
    QTest.qWaitForWindowActive(bar)
    assert bar.notes.isHidden()
    assert bar.key_actions()["remark"]()
    assert bar.notes._label.text() == "Remark on window 1:"
    QTest.keyClicks(bar.notes._edit, "by the kerb")
    QTest.keyClick(bar.notes._edit, Qt.Key.Key_Return)
    assert session.row(1).remark == "by the kerb"  # type: ignore[union-attr]
    assert not bar.notes._edit.hasFocus()
    session.select([2])
    assert bar.notes.isHidden()
    session.select([1])
    assert bar.notes._edit.text() == "by the kerb"
    bar.key_actions()["remark"]()
    QTest.keyClicks(bar.notes._edit, "no")
    QTest.keyClick(bar.notes._edit, Qt.Key.Key_Escape)
    assert session.row(1).remark == "by the kerb"  # type: ignore[union-attr]
    assert bar.notes._edit.text() == "by the kerb"


def test_several_windows_are_not_judged_at_once_unasked(
    bar: JudgeBar, session: WindowsSession, asked: Asked
) -> None:
    session.select([1, 2, 12])
    asked.answer = False
    bar._visible.click()
    assert asked.questions == ["Judge 3 windows as visible?"]
    assert session.row(1).observer == ""  # type: ignore[union-attr]
    assert not bar._visible.isChecked()
    asked.answer = True
    bar._unsure.click()
    assert [session.row(fid).observer for fid in (1, 2, 12)] == ["unsure"] * 3  # type: ignore[union-attr]
    assert session.selected() == [1, 2, 12]


def test_blind_tells_nothing_of_what_was_found(bar: JudgeBar, session: WindowsSession, judging: Judging) -> None:
    session.select([2])
    judging.change(is_blind=True)
    assert bar.sentence() == "Window 2. What was found is hidden."
    assert bar._chip.isHidden()
    assert "significant" not in bar._sentence.toolTip().lower()
    assert "blind" in bar.operators.text()


@pytest.mark.parametrize("width", [412, 1400])
def test_the_bar_is_as_narrow_as_the_dock(bar: JudgeBar, session: WindowsSession, width: int) -> None:
    font = bar.font()
    font.setPixelSize(12)
    bar.setFont(font)
    session.select([4])
    bar.resize(width, 100)
    QTest.qWait(1)
    assert bar.minimumSizeHint().width() <= 412
    beside = bar._sentence.geometry().bottom() >= bar._visible.geometry().top()
    assert beside == (width == 1400)


@pytest.mark.parametrize("is_high", [False, True])
def test_what_to_do_is_read_in_a_narrow_dock(bar: JudgeBar, session: WindowsSession, is_high: bool) -> None:
    """It ends the sentence, and a long one is no reason to leave it out."""
    font = bar.font()
    font.setPixelSize(12)
    bar.setFont(font)
    bar.set_high(is_high)
    bar.resize(470, 200)
    words = "A cause that takes some words, as 22 m of a strip do in other languages than this one; "
    session.change(4, reason=4 * words + "what to do.")
    session.select([4])
    QTest.qWait(1)
    assert bar._sentence._fitting(bar._sentence.fontMetrics()) == bar.sentence()


def test_the_dock_need_not_grow_by_what_is_judged(bar: JudgeBar, session: WindowsSession, judging: Judging) -> None:
    least = set()
    for key in ("", "unsure", "invisible"):
        if key:
            judging.judge(key)
        judging.say_sure(100)
        QTest.qWait(1)
        least.add(bar.minimumSizeHint().width())
    assert len(least) == 1


def test_units_stay_with_their_numbers() -> None:
    assert with_units("16 % of 3,634 m\u00b2, 1.9 m and 2.2 px in 7 places; 5 more") == (
        "16\u00a0% of 3,634\u00a0m\u00b2, 1.9\u00a0m and 2.2\u00a0px in 7 places; 5 more"
    )
