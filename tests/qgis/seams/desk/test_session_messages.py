"""What the user of a session can get wrong is told in one sentence; many windows are no burden."""
from __future__ import annotations

from dataclasses import replace

import pytest
from qgis.core import Qgis, QgsGeometry, QgsPointXY
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.tables import window_file

from tests.qgis.runs import assert_sentence
from tests.qgis.scenes import BLURRED, SHARP, layer, windows
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, Desk, settle, wait_for_tasks
from tests.work import calls_of

# What the user can get wrong


def test_bad_inputs_are_told_in_one_sentence(desk: Desk) -> None:
    cases = [
        ({"mosaic": ""}, "No mosaic"),
        ({"sources": ()}, "No sources"),
        ({"wavelet": "bior2.2"}, "not orthogonal"),
    ]
    for change, words in cases:
        desk.messages.clear()
        desk.set(desk.inputs(**change))
        desk.session.add_window(BLURRED_WINDOW)
        desk.wait()
        assert len(desk.messages) == 1, change
        assert_sentence(desk.messages[0], words)
    desk.messages.clear()
    desk.set(desk.inputs(seamlines=""))
    desk.session.place_windows()
    assert_sentence(desk.messages.pop(), "No seamlines")
    assert desk.levels[-1] == Qgis.MessageLevel.Critical
    empty = layer("LineString", [])
    desk.project.addMapLayer(empty)
    desk.session.set_inputs(desk.inputs(seamlines=empty.id()))
    wait_for_tasks()
    desk.messages.clear()
    desk.session.place_windows()
    desk.wait()
    assert_sentence(desk.messages.pop(), "seamline layer is empty")


def test_a_window_that_is_no_rectangle_is_told_to_be_measured_as_one(desk: Desk) -> None:
    drawn = desk.use(windows(BLURRED, SHARP))
    desk.session.inspect_pending()
    desk.wait()
    assert not [message for message in desk.messages if "boxes around them" in message]
    box = drawn.getFeature(1).geometry().boundingBox()
    corners = [(box.xMinimum(), box.yMinimum()), (box.xMinimum(), box.yMaximum()), (box.xMaximum(), box.yMinimum())]
    triangle = QgsGeometry.fromPolygonXY([[QgsPointXY(*corner) for corner in corners]])
    drawn.startEditing()
    assert drawn.changeGeometry(1, triangle)
    desk.session.inspect([1, 2])
    desk.wait()
    assert [message for message in desk.messages if "boxes around them" in message] == [
        "Windows that are no rectangles along the mosaic's axes are measured in the boxes around them: 1."
    ]


def test_a_file_that_cant_be_written_to_is_told_and_stops_the_run(desk: Desk) -> None:
    desk.use(windows(BLURRED, SHARP))
    desk.session.inspect_pending()
    desk.layer().setReadOnly(True)
    desk.wait()
    desk.session.add_window(PixelWindow(0, 128, 128, 128))
    desk.session.judge([1], "visible")
    desk.session.remove([1])
    assert 4 <= len(desk.messages) <= 5  # the second window may have been measured by then
    for message in desk.messages:
        assert_sentence(message, "can't be edited")
    assert not any(row.verdict or row.observer for row in desk.session.windows())
    assert not desk.session.is_busy


# Speed


def test_two_thousand_windows_are_no_burden(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    boxes = [(8 * (index % 48), 4 * (index // 48), 64, 64) for index in range(2000)]
    desk.use(windows(*boxes, window_id=("integer", list(range(1, 2001)))))
    assert len(desk.session.windows()) == 2000
    desk.session.judge([1], "visible")  # adds the fields

    def judge() -> None:
        desk.session.judge([2], "visible")
        assert desk.session.row(2).observer == "visible"  # type: ignore[union-attr]
        assert len(desk.session.windows()) == 2000

    settle(0.02)
    judging = calls_of(judge)
    desk.session.resultArrived.connect(lambda fid: desk.session.row(fid))
    asking = calls_of(lambda: desk.session.inspect([1000]))
    desk.wait()
    assert desk.rows()[1000].verdict
    result = desk.session.result(1000)
    assert result is not None
    results = desk.session._results
    results._unwritten = {1001: replace(result, window_id=1001)}
    results._versions = {1001: results._versions[1000]._replace(extent=desk.rows()[1001].extent)}
    monkeypatch.setattr(window_file, "store", lambda *_: None)  # a result takes as long whatever the others are
    writing = calls_of(desk.session._results.write)
    assert desk.session.row(1001).verdict  # type: ignore[union-attr]
    assert max(judging, asking, writing) < 6000  # three calls for each of the windows
