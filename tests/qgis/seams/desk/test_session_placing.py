"""What the desk tells after it placed windows: one short sentence, and the rest in the log."""
from __future__ import annotations

from collections.abc import Iterator

import pytest
from qgis.core import Qgis, QgsApplication, QgsGeometry
from seam_inspector.plugin.imagery.grids import PixelWindow

from tests.qgis.scenes import layer, line
from tests.qgis.seams.desk.session_desk import Desk, wait_for_tasks

_WHOLE = line((256, 0), (256, 256))
_ALONG_THE_EDGE = line((300, 2), (500, 2))  # windows would stick out of the mosaic
_BAR_CHARACTERS = 110  # about what the message bar shows of a sentence


class Log:
    """What was written to the plugin's page of the log messages."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def take(self, text: str, page: str, _level: object) -> None:
        if page == "Seam Inspector":
            self.lines.append(text)


@pytest.fixture
def log(qgis_app: QgsApplication) -> Iterator[Log]:
    made = Log()
    QgsApplication.messageLog().messageReceived.connect(made.take)
    yield made
    QgsApplication.messageLog().messageReceived.disconnect(made.take)


def place(desk: Desk, lines: list[QgsGeometry]) -> str:
    """What is told once windows are placed along some lines."""
    seams = layer("LineString", lines)
    desk.project.addMapLayer(seams)
    desk.session.set_inputs(desk.inputs(seamlines=seams.id()))
    wait_for_tasks()
    desk.messages.clear()
    desk.session.place_windows()
    desk.wait()
    assert len(desk.messages) == 1
    assert len(desk.messages[0]) < _BAR_CHARACTERS or not desk.session.windows()
    return desk.messages[0]


def test_all_placed(desk: Desk, log: Log) -> None:
    said = place(desk, [_WHOLE])
    assert said.startswith(f"Windows placed along the seams: {len(desk.session.windows())}.")
    assert desk.levels[-1] == Qgis.MessageLevel.Success
    assert log.lines == []


def test_while_a_window_is_added_there_is_nothing_to_stop(desk: Desk) -> None:
    desk.session.set_inputs(desk.inputs())
    wait_for_tasks()
    desk.session.add_window(PixelWindow(0, 0, 64, 64))
    assert desk.session.is_busy
    assert not desk.session.can_stop
    desk.wait()


def test_places_without_a_window_are_in_the_log(desk: Desk, log: Log) -> None:
    said = place(desk, [_WHOLE, _ALONG_THE_EDGE])
    count = len(desk.session.windows())
    assert said.startswith(f"Windows placed along the seams: {count}; some places have none")
    assert len(log.lines) == 1
    assert "without a window" in log.lines[0]


def test_no_window_at_all_is_a_warning_that_says_why(desk: Desk, log: Log) -> None:
    said = place(desk, [_ALONG_THE_EDGE])
    assert desk.session.windows() == []
    assert desk.levels[-1] == Qgis.MessageLevel.Warning
    assert log.lines == [said]
    assert "without a window" in said


def test_placing_twice_doubles_nothing(desk: Desk) -> None:
    place(desk, [_WHOLE])
    before = {row.window_id: row.extent for row in desk.session.windows()}
    desk.layer().commitChanges(False)  # files may round coordinates
    said = place(desk, [_WHOLE])
    assert said == f"No window was placed: all {len(before)} places along the seams have theirs already."
    assert {row.window_id: row.extent for row in desk.session.windows()} == before
    desk.session.remove([min(row.fid for row in desk.session.windows())])
    said = place(desk, [_WHOLE])
    assert said.startswith(f"Windows placed along the seams: 1; places that had theirs already: {len(before) - 1}.")
    assert sorted(row.extent for row in desk.session.windows()) == sorted(before.values())
