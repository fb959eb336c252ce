"""What the user of a session can get wrong is told in one sentence; many windows are no burden."""
from __future__ import annotations

from qgis.core import Qgis
from seam_inspector.plugin.imagery.grids import PixelWindow

from tests.qgis.runs import assert_sentence
from tests.qgis.scenes import BLURRED, SHARP, layer, windows
from tests.qgis.seams.desk.session_desk import BLURRED_WINDOW, Desk, wait_for_tasks

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
    assert_sentence(desk.messages.pop(), "seamline layer holds no line")


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
