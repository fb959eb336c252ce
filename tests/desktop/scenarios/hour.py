"""An hour at the desk in minutes: a hundred windows placed, inspected, judged by keys; killed midway, then finished.

Parameters: ``brighton``, ``work``, ``screenshots`` (folders), ``stage`` (``begin`` | ``finish``). The first stage ends
with the process; what it measured is in ``work``/begun.json.
"""
from __future__ import annotations

import json
import os
import signal
import time
from dataclasses import replace
from pathlib import Path

from qgis.core import QgsApplication, QgsRectangle
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication

from demo.desk import Desk
from demo.gaps import Gaps

SIDE_M, SPACING_M = 1.9, 2.2  # 64 px: larger windows would share too many pixels for 100 of them to have room
JUDGED_BEFORE = 30
WORDS = ((Qt.Key.Key_V, "visible"), (Qt.Key.Key_I, "invisible"), (Qt.Key.Key_U, "unsure"))


def play(desk: Desk) -> None:
    """One of the stages."""
    work = Path(desk.parameters["work"])
    if desk.parameters["stage"] == "begin":
        begin(desk, work)
    else:
        finish(desk, work, Path(desk.parameters["screenshots"]))


def begin(desk: Desk, work: Path) -> None:
    """From an empty project to thirty judged windows; then the power fails."""
    desk.set_up(Path(desk.parameters["brighton"]), SIDE_M, SPACING_M, mosaic="mosaic_feather0p4m")
    session = desk.session
    # Of so small a window there is too little ground to judge its seam by.
    session.set_inputs(replace(session.inputs, reference="sources"))
    assert desk.project.write(str(work / "project.qgz"))
    with Gaps() as gaps:
        desk.dock.place.trigger()
        desk.wait(lambda: session.windows() and not session.is_busy, 30, "windows placed")
        desk.dock.inspect.trigger()
        desk.wait(lambda: all(row.verdict for row in session.windows()), 90, "all windows inspected")
    desk.wait_for_work()
    assert desk.project.write(str(work / "project.qgz"))
    desk.sort_by_loss()
    begun = judge(desk, JUDGED_BEFORE)
    begun |= {"placed": len(session.windows()), "gap_ms": 1000 * gaps.longest_s, "work_ms": 1000 * gaps.longest_work_s}
    begun["verdicts"] = verdicts(desk)
    (work / "begun.json").write_text(json.dumps(begun))
    desk.pause(0.3)  # what is judged is on the disk by then
    os.kill(os.getpid(), signal.SIGKILL)


def finish(desk: Desk, work: Path, shots: Path) -> None:
    """The project opened again has what was judged and measured; the rest is judged, and all of it exported."""
    begun = json.loads((work / "begun.json").read_text())
    assert desk.project.read(str(work / "project.qgz"))
    desk.open_dock()
    session = desk.session
    desk.wait(lambda: len(session.windows()) == begun["placed"], 20, "windows back")
    desk.wait(lambda: session.mosaic_grid() is not None, 20, "mosaic open again")
    desk.wait(lambda: found(desk) == begun["judged"], 20, "what was judged before the end")
    desk.report["kept"] = len(found(desk))
    assert verdicts(desk) == begun["verdicts"]
    assert not session.is_busy
    assert all(session.result(row.fid) is not None for row in session.windows())
    first = next(row for row in session.windows() if row.verdict != "not_comparable")
    desk.dock.zoom_to(first.fid)
    desk.wait(lambda: desk.curves_of(first.fid), 20, "curves without measuring again")
    desk.report["stale"] = sum(row.stale for row in session.windows())
    desk.rest_mouse()
    desk.screenshot(shots / "hour_reopened.png")
    left = sum(row.is_compared and not row.observer for row in session.windows())
    with Gaps() as gaps:
        done = judge(desk, left)
    desk.report["judged"] = len(found(desk))
    desk.report["to_judge"] = sum(row.is_compared for row in session.windows())
    desk.report["keys_per_window"] = (done["keys"] + begun["keys"]) / desk.report["to_judge"]
    desk.report["judged_an_hour"] = 3600 * left / done["seconds"]
    desk.report["not_followed"] = begun["not_followed"] + done["not_followed"]
    desk.report["gap_ms"] = max(begun["gap_ms"], 1000 * gaps.longest_s)
    desk.report["work_ms"] = max(begun["work_ms"], 1000 * gaps.longest_work_s)
    desk.dock.windows.table.selectAll()
    desk.dock.windows.copy()
    desk.report["copied"] = QApplication.clipboard().text().splitlines()
    desk.screenshot(shots / "hour_finished.png")
    desk.drop_changes()
    desk.wait(lambda: not QgsApplication.taskManager().activeTasks(), 60, "no task that QGIS would ask about")


def judge(desk: Desk, count: int) -> dict[str, object]:
    """So many windows, by one key each; the map follows."""
    keys = lost = 0
    desk.session.select([])
    press(desk, Qt.Key.Key_J)  # begins with the first to judge
    start = time.perf_counter()
    for number in range(count):
        press(desk, WORDS[number % 5 % 3][0])
        keys += 1
        lost += not is_followed(desk)
    seconds = time.perf_counter() - start
    press(desk, Qt.Key.Key_J)
    return {"keys": keys, "not_followed": lost, "seconds": seconds, "judged": found(desk)}


def found(desk: Desk) -> dict[str, str]:
    """What the operator said, by the windows' numbers."""
    return {str(row.window_id): row.observer for row in desk.session.windows() if row.observer}


def verdicts(desk: Desk) -> dict[str, str]:
    """Verdicts by the windows' numbers."""
    return {str(row.window_id): row.verdict for row in desk.session.windows()}


def press(desk: Desk, key: Qt.Key) -> None:
    """A key over the map."""
    desk.window.activateWindow()
    desk.canvas.setFocus()
    desk.wait(lambda: QApplication.focusWidget() is not None, 5, "focus in the main window")
    QTest.keyClick(QApplication.focusWidget(), key)
    desk.pause(0.05)


def is_followed(desk: Desk) -> bool:
    """Whether the selected window is in the middle of the map, one image pixel on 2 x 2 of the screen's.

    After the last one no window is selected.
    """
    if not desk.session.selected():
        return not any(row.is_compared and not row.observer for row in desk.session.windows())
    extent, row = desk.canvas.extent(), desk.session.row(desk.session.selected()[0])
    middle = QgsRectangle(*row.extent).center()
    pixel = desk.session.mosaic_grid().pixel_width / 2
    return bool(extent.center().distance(middle) < 4 * pixel and abs(desk.canvas.mapUnitsPerPixel() / pixel - 1) < 0.01)
