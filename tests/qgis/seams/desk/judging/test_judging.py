"""Judging: what a verdict writes and where it leads, what the project keeps, two operators."""
from __future__ import annotations

from dataclasses import replace

from qgis.core import QgsProject
from qgis.PyQt.QtCore import Qt
from seam_inspector.plugin.imagery.statistics import FIRST
from seam_inspector.plugin.seams.desk.judge_bar import JudgeBar
from seam_inspector.plugin.seams.desk.judging import Judging, JudgingSettings
from seam_inspector.plugin.seams.desk.windows.windows_panel import WindowsPanel

from tests.qgis.seams.desk.judging.conftest import Asked
from tests.qgis.seams.desk.windows_session import WindowsSession, columns_of, window

VERDICT = 1


def five() -> list:
    """Five windows to be judged."""
    return [window(fid, "reduced", (0.9, 1, 1), kept=(kept,)) for fid, kept in enumerate((0.9, 0.6, 0.8, 0.5, 0.7), 1)]


# One key a window


def test_a_verdict_goes_on_to_the_next_window_to_judge(judging: Judging, session: WindowsSession) -> None:
    stepped: list[int] = []
    judging.stepped.connect(stepped.append)
    session.select([1])
    for word in ("visible", "invisible"):
        assert judging.judge(word)
    assert stepped == [12]  # 2 and 10 are judged, 3 and 4 not compared
    assert [row.observer for row in session.rows] == ["visible", "visible", "", "", "invisible", "invisible"]


def test_a_key_goes_to_a_window_that_is_not_in_view_before_it_judges(session: WindowsSession) -> None:
    seen: set[int] = set()
    judging = Judging(session, is_in_view=seen.__contains__)
    judging.stepped.connect(seen.add)
    session.put(five())
    session.select([2])
    assert judging.judge("visible")
    assert seen == {2}
    assert not any(row.observer for row in session.rows)
    assert judging.judge("visible")
    assert [row.window_id for row in session.rows if row.observer] == [2]
    judging.close()


def test_after_the_last_window_keys_that_come_too_late_judge_nothing(
    judging: Judging, bar: JudgeBar, session: WindowsSession
) -> None:
    session.put([replace(row, observer="invisible" * (row.window_id != 3)) for row in five()])
    session.select([3])
    judging.judge("visible")
    judging.begin()
    assert session.selected() == []
    assert not judging.judge("unsure")
    assert [row.observer for row in session.rows] == ["invisible", "invisible", "visible", "invisible", "invisible"]
    assert bar.sentence() == "No window is left to judge."
    session.put([*session.rows, window(6, "not_comparable"), window(7, "not_comparable"), window(8)])
    assert "3 not comparable or not inspected" in bar._progress.toolTip()
    judging.take_back()
    assert session.selected() == [3]


def test_judging_starts_with_the_first_of_the_order_where_no_window_is_selected(
    judging: Judging, panel: WindowsPanel, session: WindowsSession
) -> None:
    """And not with the one that was looked at last."""
    session.put([replace(row, loss=float(row.window_id)) for row in five()])
    panel.table.sortByColumn(VERDICT + 1, Qt.SortOrder.DescendingOrder)  # by the loss
    assert panel.ordered_fids() == [5, 4, 3, 2, 1]
    session.select([2])
    judging.follow()
    session.select([])
    judging.go_on()
    assert session.selected() == [5]
    judging.judge("visible")
    session.select([1])
    judging.follow()
    session.select([])
    judging.go_on()
    assert session.selected() == [4]  # the worst that is not judged


def test_the_worst_places_are_gone_through_in_their_order_and_none_is_left_out(
    judging: Judging, bar: JudgeBar, panel: WindowsPanel, session: WindowsSession
) -> None:
    session.put([*five(), window(6), window(7, "not_comparable")])
    judging.walk([4, 7, 2, 6])
    gone = []
    while session.selected():
        gone += session.selected()
        judging.judge("unsure" if gone == [4] else "visible")
        assert panel.table.selected_fids() == session.selected()
    assert gone == [4, 7, 2, 6]
    assert bar.sentence() == "No window at the worst places is left to judge."
    judging.take_back()
    assert session.selected() == [6]
    judging.step(-1)
    assert session.selected() == [2]
    session.select([1])  # which was not asked for
    judging.judge("visible")
    assert session.selected() == [3]


def test_the_last_verdict_is_taken_back_from_the_next_window(judging: Judging, session: WindowsSession) -> None:
    session.put(five())
    session.select([1])
    judging.judge("visible")
    judging.judge("visible")
    assert session.selected() == [3]
    assert judging.take_back()
    assert session.selected() == [2]
    assert [row.observer for row in session.rows][:3] == ["visible", "", ""]
    assert judging.take_back()
    assert session.selected() == [1]
    assert not any(row.observer for row in session.rows)
    assert not judging.take_back()


def test_how_sure_he_was_is_taken_back_too(judging: Judging, session: WindowsSession) -> None:
    """And what he says after his next verdict is of that."""
    session.put(five())
    session.select([1])
    for goes_back in (True, False):
        judging.judge("visible")
        session.select([1] if goes_back else session.selected())  # he goes back to say it, or says it from the next one
        judging.say_sure(90)
        judging.take_back()
        assert (session.rows[0].observer, session.rows[0].confidence) == ("", None)
        judging.judge("invisible")
        judging.say_sure(70)
        assert (session.rows[0].observer, session.rows[0].confidence) == ("invisible", 70)
        assert session.rows[1].confidence is None
        session.select([1])


def test_many_at_once_only_when_the_operator_says_so(judging: Judging, session: WindowsSession, asked: Asked) -> None:
    session.select([1, 2, 12])
    asked.answer = False
    judging.judge("visible")
    judging.note(remark="all of them")
    session.select([2, 10])
    judging.take_back()
    assert asked.questions == [
        "Judge 3 windows as visible?", "Write this into 3 windows?", "Take back the verdicts on 2 windows?"
    ]
    assert not {"judge", "note"}.intersection(call[0] for call in session.calls)


# Two operators


def test_the_second_operators_verdicts_stand_beside_the_first_s(judging: Judging, session: WindowsSession) -> None:
    judging.change(operator=2)
    session.select([2])
    assert judging.judge("unsure")
    assert (session.row(2).observer, session.row(2).observer_2) == ("visible", "unsure")  # type: ignore[union-attr]
    assert session.selected() == [10]  # judged by the first one only
    judging.note(confidence=30, remark="haze")
    row = session.row(10)
    assert row is not None
    assert (row.confidence, row.confidence_2, row.remark_2) == (None, 30, "haze")


# Blind

def test_blind_hides_all_columns_that_tell(panel: WindowsPanel, session: WindowsSession) -> None:
    session.change(2, observer_2="visible", confidence=60)
    panel.table.sortByColumn(VERDICT, Qt.SortOrder.DescendingOrder)
    panel.show_for(FIRST, is_blind=True)
    assert panel.ordered_fids() == [1, 2, 3, 4, 10, 12]  # nor does their order tell
    assert columns_of(panel) == ["window_id", "observer", "confidence"]
    index = panel.table.model().index(1, 0)
    assert index.data(Qt.ItemDataRole.ToolTipRole) is None
    assert not panel._verdicts.model().item(1).isEnabled()
    panel.show_for(FIRST, is_blind=False)
    assert "verdict" in columns_of(panel)


# The project


def test_the_project_keeps_how_windows_are_judged(
    judging: Judging, session: WindowsSession, project: QgsProject, tmp_path: object
) -> None:
    judging.change(operator=2)
    session.select([12])
    path = f"{tmp_path}/judged.qgs"
    assert project.write(path)
    session.select([])
    project.clear()
    session.begunAnew.emit()
    assert judging.settings == JudgingSettings()
    assert project.read(path)
    session.begunAnew.emit()
    assert judging.settings == JudgingSettings(2, False)
