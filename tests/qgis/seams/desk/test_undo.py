"""Undo and redo of what the operator does: one step each, whatever comes from the background meanwhile."""
from __future__ import annotations

from dataclasses import replace

from qgis.PyQt.QtWidgets import QMainWindow
from seam_inspector.plugin.seams.desk.desk_keys import UndoActions

from tests.qgis.scenes import BLURRED, SHARP, windows
from tests.qgis.seams.desk.session_desk import SHARP_WINDOW, Desk, wait_until


def test_each_action_is_one_step_in_words_and_leads_to_its_window(desk: Desk) -> None:
    gone: list[int] = []
    desk.session.stepped.connect(gone.append)
    first = desk.add()
    desk.session.judge([first], "visible")
    second = desk.add(SHARP_WINDOW)
    desk.session.judge([first, second], "invisible")
    desk.session.judge([first, second], "invisible")  # the same again is no step
    desk.session.remove([first])
    assert desk.steps() == [
        "drawing window 1", "judging window 1", "drawing window 2", "judging 2 windows", "removing window 1"
    ]
    items = []
    while desk.session.steps.canUndo():
        desk.undo()
        items.append([(row.window_id, row.observer) for row in desk.session.windows()])
    assert items == [[(1, "invisible"), (2, "invisible")], [(1, "visible"), (2, "")], [(1, "visible")], [(1, "")], []]
    assert gone == [first, first, first]
    while desk.session.steps.canRedo():
        desk.redo()
    (row,) = desk.session.windows()
    assert (row.window_id, row.verdict, row.observer, row.stale) == (2, "preserved", "invisible", False)
    assert desk.session.result(row.fid) is not None
    assert desk.session.selected() == [row.fid]


def test_edits_that_are_discarded_take_with_them_what_was_done_meanwhile_alone(desk: Desk) -> None:
    fid = desk.add()
    desk.session.judge([fid], "visible")
    assert desk.layer().startEditing()
    desk.undo()
    desk.session.judge([fid], "unsure")
    desk.session.note([fid], {"confidence": 80})
    assert desk.layer().rollBack()
    assert (desk.steps(), desk.rows()[1].observer) == (["drawing window 1"], "visible")
    desk.session.judge([fid], "invisible")
    assert desk.layer().startEditing()
    desk.session.note([fid], {"remark": "kerb gone"})
    desk.undo()
    desk.undo()
    assert desk.layer().rollBack()
    assert desk.steps() == ["drawing window 1", "judging window 1", "judging window 1"]
    desk.undo()
    assert desk.rows()[1].observer == "visible"


def test_an_inspection_is_undone_with_what_it_measured(desk: Desk) -> None:
    fid = desk.add()
    desk.session.set_inputs(replace(desk.session.inputs, wavelet="db4"))
    before, shown = desk.rows()[1], desk.session.result(fid)
    assert shown is not None
    desk.session.inspect([fid])
    desk.wait()
    after = desk.rows()[1]
    assert desk.steps()[1:] == ["inspecting window 1"]
    desk.undo()
    assert (desk.rows()[1].ratios, desk.rows()[1].stale) == (before.ratios, True)
    assert desk.session.result(fid).clips == shown.clips  # the chart of these values, too
    desk.redo()
    assert (desk.rows()[1].ratios, desk.rows()[1].stale) == (after.ratios, False)
    assert desk.session.result(fid).clips != shown.clips
    desk.undo()
    assert desk.session.result(fid).clips == shown.clips
    desk.session.set_inputs(replace(desk.session.inputs, wavelet="coif3"))
    assert not desk.rows()[1].stale


def test_what_arrives_of_an_inspection_that_was_undone_is_dropped(desk: Desk) -> None:
    desk.use(windows(BLURRED, SHARP))
    desk.session.inspect_pending()
    desk.undo()
    desk.wait()
    assert [row.verdict for row in desk.session.windows()] == ["", ""]


def test_a_result_that_arrives_while_its_window_is_undone_is_there_on_redo(desk: Desk) -> None:
    desk.session.add_window(SHARP_WINDOW)
    wait_until(desk.session.windows, "for the window")
    desk.undo()
    desk.wait()
    assert desk.session.windows() == []
    desk.redo()
    wait_until(lambda: [row.verdict for row in desk.session.windows()] == ["preserved"], "for the result")
    assert not desk.rows()[1].stale


def test_placed_windows_are_one_step_of_the_button(desk: Desk) -> None:
    window = QMainWindow()
    actions = UndoActions(desk.session.steps, window, window)
    desk.session.place_windows()
    desk.wait()
    count = len(desk.session.windows())
    assert count > 1
    assert actions.undo.toolTip() == f"Undo placing {count} windows"
    actions.undo.trigger()
    assert desk.session.windows() == []
    assert (actions.undo.isEnabled(), actions.redo.isEnabled()) == (False, True)
    actions.redo.trigger()
    assert [row.read("origin") for row in desk.session.windows()] == ["placed"] * count
