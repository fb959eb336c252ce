"""Undo and redo of what the operator does: one step each, whatever comes from the background meanwhile."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from qgis.core import QgsProject, QgsVectorLayer
from qgis.PyQt.QtWidgets import QMainWindow
from seam_inspector.plugin.imagery.statistics import SECOND
from seam_inspector.plugin.seams.desk.windows.undo_actions import UndoActions

from tests.qgis.scenes import BLURRED, SHARP, outline, saved, windows
from tests.qgis.seams.desk.session_desk import SHARP_WINDOW, Desk, settle, wait_until


def test_each_action_is_one_step_and_results_are_none(desk: Desk) -> None:
    first = desk.add()
    desk.session.judge([first], "visible")
    second = desk.add(SHARP_WINDOW)
    desk.session.judge([first, second], "invisible")
    desk.session.remove([first])
    assert desk.steps() == ["Add windows", "Judge windows", "Add windows", "Judge windows", "Remove windows"]
    found = []
    while desk.layer().undoStack().canUndo():
        desk.undo()
        found.append([(row.window_id, row.observer) for row in desk.session.windows()])
    assert found == [[(1, "invisible"), (2, "invisible")], [(1, "visible"), (2, "")], [(1, "visible")], [(1, "")], []]


@pytest.mark.parametrize("is_saved", [True, False])
def test_judging_a_layer_drawn_elsewhere_is_one_step_with_the_fields_it_needs(desk: Desk, is_saved: bool) -> None:
    drawn = desk.use(windows())
    drawn.startEditing()
    assert drawn.addFeatures([windows(box).getFeature(1) for box in (BLURRED, SHARP)])
    if is_saved:
        assert drawn.commitChanges(False)
    before = drawn.undoStack().count()
    desk.session.judge([row.fid for row in desk.session.windows()], "visible")
    assert [row.observer for row in desk.session.windows()] == ["visible"] * 2
    assert desk.steps()[before:] == ["Judge windows"]
    desk.undo()
    assert len(desk.session.windows()) == 2
    assert drawn.fields().count() == 0
    desk.redo()
    assert [row.observer for row in desk.session.windows()] == ["visible"] * 2


def test_judging_the_same_again_is_no_step(desk: Desk) -> None:
    fid = desk.add()
    for _ in range(2):
        desk.session.judge([fid], "visible")
    assert desk.steps() == ["Add windows", "Judge windows"]


def test_a_result_that_arrives_leaves_redo_as_it_is(desk: Desk) -> None:
    first, second = desk.add(), desk.add(SHARP_WINDOW)
    desk.session.judge([first], "visible")
    desk.undo()
    desk.session.set_inputs(replace(desk.session.inputs, wavelet="db4"))
    desk.session.inspect([first, second])
    desk.wait()
    assert not any(row.stale for row in desk.session.windows())
    desk.redo()
    assert desk.rows()[1].observer == "visible"


def test_a_result_that_arrives_while_its_window_is_undone_is_there_on_redo(desk: Desk) -> None:
    desk.session.add_window(SHARP_WINDOW)
    desk.wait()
    desk.undo()
    desk.redo()
    desk.session.inspect([row.fid for row in desk.session.windows()])
    desk.undo()
    desk.wait()
    assert desk.session.windows() == []
    desk.redo()
    wait_until(lambda: [row.verdict for row in desk.session.windows()] == ["preserved"], "for the result")
    assert not desk.rows()[1].stale


def test_undone_fields_come_back_with_the_results(desk: Desk) -> None:
    desk.use(windows(BLURRED, SHARP))
    desk.session.inspect_pending()
    desk.wait()
    desk.undo()
    assert [row.verdict for row in desk.session.windows()] == ["", ""]
    desk.redo()
    wait_until(lambda: [row.verdict for row in desk.session.windows()] == ["significant", "preserved"])


def test_a_moved_window_that_comes_back_takes_no_result_of_another_place(desk: Desk) -> None:
    fid = desk.add()
    desk.layer().changeGeometry(fid, outline(SHARP))
    desk.session.inspect([fid])
    desk.wait()
    for _ in range(2):
        desk.undo()
    desk.redo()  # drawn, not moved: the result is of the later place
    settle(0.1)
    assert [(row.verdict, row.stale) for row in desk.session.windows()] == [("", False)]


def test_results_alone_are_asked_for_before_they_are_forgotten(desk: Desk, tmp_path: Path) -> None:
    path = saved(windows(BLURRED, window_id=("integer", [1])), tmp_path / "saved.gpkg")
    layer = desk.use(QgsVectorLayer(path, "windows", "ogr"))
    desk.session.inspect_pending()
    desk.wait()
    assert layer.commitChanges(False)
    assert not layer.isModified()
    desk.session.set_inputs(replace(desk.session.inputs, wavelet="db4"))
    desk.session.inspect_pending()
    desk.wait()
    assert desk.steps() == []
    assert layer.isModified()
    assert layer.commitChanges(False)
    assert not layer.isModified()
    (feature,) = QgsVectorLayer(path, "saved", "ogr").getFeatures()
    assert feature["ratio_1"] == desk.rows()[1].ratio
    desk.session.inspect([desk.rows()[1].fid])
    desk.wait()
    assert layer.isModified()
    assert layer.rollBack()
    assert layer.startEditing()
    assert not layer.isModified()


def test_layers_that_write_each_change_at_once_can_be_worked_in(desk: Desk, tmp_path: Path) -> None:
    path = saved(windows(BLURRED), tmp_path / "saved.gpkg")
    QgsProject.instance().setAutoTransaction(True)
    try:
        layer = desk.use(QgsVectorLayer(path, "windows", "ogr"))
        desk.session.inspect_pending()
        desk.wait()
        (row,) = desk.session.windows()
        desk.session.judge([row.fid], "visible")
        assert [(row.verdict, row.observer) for row in desk.session.windows()] == [("significant", "visible")]
        desk.undo()
        assert desk.rows()[1].observer == ""
        assert layer.commitChanges(), layer.commitErrors()
        (feature,) = QgsVectorLayer(path, "saved", "ogr").getFeatures()
        assert feature["verdict"] == "significant"
    finally:
        desk.project.removeAllMapLayers()
        QgsProject.instance().setAutoTransaction(False)


def test_placed_windows_can_be_undone_by_the_button_as_soon_as_they_are_there(desk: Desk) -> None:
    window = QMainWindow()
    actions = UndoActions(desk.session, window, window)
    desk.session.place_windows()
    desk.wait()
    count = len(desk.session.windows())
    assert count > 1
    assert actions.undo.isEnabled()
    assert "Add windows" in actions.undo.toolTip()
    actions.undo.trigger()
    assert desk.session.windows() == []
    assert (actions.undo.isEnabled(), actions.redo.isEnabled()) == (False, True)
    actions.redo.trigger()
    assert len(desk.session.windows()) == count
    actions.close()


def test_who_judges_blind_undoes_no_steps_of_others(desk: Desk) -> None:
    """What the first operator said is out of sight, and would go unseen."""
    window = QMainWindow()
    steps = UndoActions(desk.session, window, window)
    first = desk.add()
    desk.session.judge([first], "visible")
    steps.keep_steps(True)
    assert not steps.undo.isEnabled()
    desk.session.judge([first], "invisible", SECOND)
    settle()
    assert steps.undo.isEnabled()
    for _ in range(3):
        steps.undo.trigger()
        settle()
    (row,) = desk.session.windows()
    assert (row.observer, row.observer_2) == ("visible", "")
    steps.keep_steps(False)
    assert steps.undo.isEnabled()
    steps.close()
