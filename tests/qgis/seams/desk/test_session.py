"""The session behind the desk, on real layers: windows, what undo takes back, and layers made elsewhere."""
from __future__ import annotations

import pytest
from qgis.core import NULL, QgsApplication, QgsVectorLayer
from qgis.PyQt.QtCore import QEventLoop
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.statistics import OPERATORS, Operator

from tests.qgis.scenes import BLURRED, SHARP, outline, pixel_box, windows
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, SHARP_WINDOW, Desk, settle, wait_until

# One window


def test_a_new_window_is_inspected_in_the_background(desk: Desk) -> None:
    arrived: list[int] = []
    desk.session.resultArrived.connect(arrived.append)
    desk.session.add_window(BLURRED_WINDOW)
    assert desk.session.is_busy
    assert [row.verdict for row in desk.session.windows()] == [""]
    desk.wait()
    fid = desk.rows()[1].fid
    assert desk.session.selected() == [fid]
    assert arrived == [fid]
    result = desk.session.result(fid)
    assert result is not None
    assert result.window == BLURRED_WINDOW
    row = desk.session.row(fid)
    assert row is not None
    assert (row.window_id, row.verdict, row.sources, row.observer) == (1, "significant", 2, "")
    assert row.ratios == pytest.approx(result.judgement.ratios.detail)
    assert row.background_ratio == pytest.approx(result.judgement.ratios.background)
    assert result.explanation is not None
    assert row.cause == result.explanation.cause.value
    assert row.composite_ratio == pytest.approx(result.explanation.ratios["luminance"].detail[0])
    assert pixel_box(desk.layer().getFeature(fid).geometry()) == BLURRED
    assert not row.stale
    assert desk.messages == []


def test_windows_get_the_next_number_and_none_twice(desk: Desk) -> None:
    first, second = desk.add(), desk.add(SHARP_WINDOW)
    assert sorted(desk.rows()) == [1, 2]
    desk.session.remove([second])
    third = desk.add(SHARP_WINDOW)
    assert {row.window_id: row.fid for row in desk.session.windows()} == {1: first, 3: third}


@pytest.mark.parametrize("operator", OPERATORS)
def test_a_verdict_that_is_taken_back_takes_along_how_sure_the_operator_was(desk: Desk, operator: Operator) -> None:
    names = {"window_id": ("integer", [1, 2]), "observer": ("string", ["", ""])}
    desk.use(windows(SHARP, BLURRED, **names))
    desk.session.judge([1, 2], "visible", operator)
    desk.session.note([1, 2], {operator.confidence: 90})
    first = desk.rows()[1].fid
    desk.session.judge([first], "", operator)
    said = [(getattr(row, operator.observer), getattr(row, operator.confidence)) for row in desk.session.windows()]
    assert said == [("", None), ("visible", 90)]
    desk.undo()
    assert getattr(desk.rows()[1], operator.confidence) == 90


def test_what_is_drawn_measured_and_judged_is_in_the_file_at_once(desk: Desk) -> None:
    for fid in (desk.add(), desk.add(SHARP_WINDOW)):
        desk.session.judge([fid], "visible")
    assert not desk.layer().isEditable()
    saved = QgsVectorLayer(desk.layer().source(), "saved", "ogr")
    names = ("window_id", "verdict", "observer", "origin")
    said = [tuple(feature[name] for name in names) for feature in saved.getFeatures()]
    assert said == [(1, "significant", "visible", "drawn"), (2, "preserved", "visible", "drawn")]
    for table in ("curves", "pairs", "results", "profiles"):
        beside = QgsVectorLayer(desk.layer().source().replace("=windows", f"={table}"), table, "ogr")
        numbers = {feature["window_id"] for feature in beside.getFeatures()}
        assert numbers in ({1, 2}, set() if table == "profiles" else {})


def test_results_selection_and_steps_outlast_edits_with_the_tools_of_qgis(desk: Desk) -> None:
    first, second = desk.add(), desk.add(SHARP_WINDOW)
    desk.session.select([first])
    desk.layer().startEditing()
    desk.session.judge([second], "visible")
    assert desk.layer().isModified()  # among his edits
    desk.session.add_window(PixelWindow(0, 128, 128, 128))
    desk.wait()
    assert all(row.verdict and not row.stale for row in desk.session.windows())
    assert desk.layer().commitChanges(), desk.layer().commitErrors()
    settle()
    rows = desk.rows()
    assert all(row.fid > 0 and not row.stale for row in rows.values())
    assert all(desk.session.result(row.fid) is not None for row in rows.values())
    for observer, count in (("visible", 2), ("", 2)):  # the new window, then what was said of the second one
        desk.undo()
        settle()
        assert len(desk.session.windows()) == count
        assert desk.rows()[2].observer == observer
    desk.layer().startEditing()
    desk.session.judge([first], "visible")
    assert desk.layer().rollBack()
    assert desk.rows()[1].observer == ""
    assert desk.steps() == ["drawing window 1", "drawing window 2"]  # what was done before can be taken back still


@pytest.mark.parametrize("danger", ["close the project", "close the session", "choose another layer"])
def test_dangers_while_the_layer_is_made(desk: Desk, danger: str) -> None:
    for steps in range(5):
        desk.session.add_window(BLURRED_WINDOW)
        for _ in range(steps):
            QgsApplication.processEvents(QEventLoop.ProcessEventsFlag.AllEvents, 1)
        if danger == "close the project":
            desk.project.clear()
            assert not desk.session.is_busy
            assert desk.session.windows() == []
            break
        if danger == "close the session":
            desk.session.close()
            assert not desk.session.is_busy
            break
        other = desk.use(windows(SHARP))
        desk.wait()
        assert desk.layer() is other
        assert len(desk.session.windows()) in (1, 2)
        desk.set(desk.inputs(windows=""))
    settle(0.1)
    assert desk.messages == []


def test_stop_keeps_what_is_done(desk: Desk) -> None:
    boxes = [(column, row, 64, 64) for row in range(0, 192, 64) for column in range(0, 448, 64)]
    desk.use(windows(*boxes))
    desk.session.inspect_pending()
    wait_until(lambda: desk.session.result(1) is not None)
    desk.session.stop()
    desk.wait()
    verdicts = [row.verdict for row in desk.session.windows()]
    assert verdicts[0]
    assert not verdicts[-1]
    desk.session.inspect_pending()
    desk.wait()
    assert all(row.verdict for row in desk.session.windows())


# Layers made elsewhere


def test_a_copied_window_gets_a_number_of_its_own(desk: Desk) -> None:
    fid = desk.add()
    copy = desk.layer().getFeature(fid)
    copy.setGeometry(outline(SHARP))
    copy["fid"] = NULL
    desk.layer().startEditing()
    assert desk.layer().addFeature(copy)
    assert desk.layer().commitChanges()
    assert sorted(desk.rows()) == [1, 2]
    assert desk.rows()[1].fid == fid
    desk.session.inspect([desk.rows()[2].fid])
    desk.wait()
    assert {number: row.verdict for number, row in desk.rows().items()} == {1: "significant", 2: "preserved"}
    assert desk.layer().getFeature(desk.rows()[2].fid)["window_id"] == 2


@pytest.mark.parametrize("epsg", [3857, 4326, 32634])
def test_the_window_layer_may_have_another_reference_system(desk: Desk, epsg: int) -> None:
    desk.use(windows(SHARP, epsg=epsg))
    fid = desk.add(BLURRED_WINDOW)
    desk.session.inspect_pending()
    desk.wait()
    result = desk.session.result(fid)
    assert result is not None
    assert result.window == BLURRED_WINDOW
    sharp = desk.session.result(1)
    assert sharp is not None
    assert sharp.window == SHARP_WINDOW
