"""A new operator judges all windows of a block by keys, the map with the room of QGIS's panels.

Parameters: ``block``, ``screenshots`` (folders), ``side_m``, ``name`` (of the pictures).
"""
from __future__ import annotations

import time
from pathlib import Path

from qgis.core import QgsRasterLayer
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QDockWidget

from demo.desk import Desk

KEYS = (Qt.Key.Key_V, Qt.Key.Key_I, Qt.Key.Key_I, Qt.Key.Key_V, Qt.Key.Key_U)


def play(desk: Desk) -> None:
    """In, through all windows, and out again."""
    block, side_m = Path(desk.parameters["block"]), float(desk.parameters["side_m"])
    desk.set_up(block, side_m, side_m / 2)  # windows that are larger than the map at 2x, so that there are places
    desk.dock.place.trigger()
    desk.wait(lambda: desk.session.windows() and not desk.session.is_busy, 60, "windows placed")
    desk.dock.inspect.trigger()
    desk.wait(lambda: all(row.verdict for row in desk.session.windows()), 120, "all windows inspected")
    desk.wait_for_work()
    desk.project.addMapLayer(QgsRasterLayer(str(block / "mosaic.tif"), "over"))  # hides the mosaic
    desk.project.layerTreeRoot().findLayer(desk.session.inputs.mosaic).setItemVisibilityChecked(False)
    desk.wait_for_map()
    desk.window.activateWindow()
    desk.canvas.setFocus()
    desk.wait(lambda: QApplication.focusWidget() is not None, 5, "focus in the main window")
    before = looks(desk)
    begin(desk)
    places(desk)
    flicker(desk)
    judge(desk)
    desk.screenshot(picture(desk, "summary"))
    key(desk, Qt.Key.Key_J)
    desk.wait_for_map()
    desk.screenshot(picture(desk, "after"))
    after = looks(desk)
    desk.report["shown"] = [before["shown"], after["shown"]]
    desk.report["widths"] = [before["widths"], after["widths"]]
    begin_and_leave_by_a_new_project(desk, before["widths"])


def begin(desk: Desk) -> None:
    """J: the image has the screen."""
    key(desk, Qt.Key.Key_J)
    desk.wait_for_map()
    desk.rest_mouse()
    canvas, window = desk.canvas, desk.window
    desk.report["share"] = canvas.width() * canvas.height() / (window.width() * window.height())
    desk.report["focus"] = QApplication.focusWidget() is canvas
    desk.report["on_map"] = looks(desk)["shown"]
    judge = desk.dock.judge
    desk.report["judge_whole"] = judge.visibleRegion().boundingRect() == judge.rect()
    desk.screenshot(picture(desk, "judging"))


def places(desk: Desk) -> None:
    """Tab: the window's other places, then the first again."""
    seen = [desk.canvas.extent().center()]
    for _ in range(8):
        key(desk, Qt.Key.Key_Tab)
        seen.append(desk.canvas.extent().center())
    desk.report["places"] = len({(round(one.x(), 2), round(one.y(), 2)) for one in seen})
    desk.report["focus_after_tab"] = QApplication.focusWidget() is desk.canvas


def flicker(desk: Desk) -> None:
    """Space, held and tapped; the next window begins with the mosaic."""
    shower = desk.dock.flicker
    QTest.keyPress(QApplication.focusWidget(), Qt.Key.Key_Space)
    desk.wait(lambda: shower.is_shown and shower.hard_cut.layer, 30, "hard cut drawn")
    desk.pause(0.4)
    desk.screenshot(picture(desk, "hard_cut"))
    shown = [shower.is_shown]
    QTest.keyRelease(QApplication.focusWidget(), Qt.Key.Key_Space)
    desk.pause(0.1)
    shown.append(shower.is_shown)
    for _ in range(2):
        key(desk, Qt.Key.Key_Space)
        shown.append(shower.is_shown)
    key(desk, Qt.Key.Key_Space)
    key(desk, Qt.Key.Key_N)
    shown.append(shower.is_shown)
    key(desk, Qt.Key.Key_P)
    desk.report["hard_cut"] = shown


def judge(desk: Desk) -> None:
    """All windows, by one key each; what it takes is measured."""
    session, working = desk.session, []
    for number in range(1000):
        if not session.selected():
            break
        window = session.row(session.selected()[0]).window_id
        start = time.thread_time()
        key(desk, KEYS[number % len(KEYS)])
        working.append(time.thread_time() - start)
        assert session.numbered(window).observer, window
    desk.report["judged"] = len(working)
    desk.report["left"] = sum(row.is_compared and not row.observer for row in session.windows())
    desk.report["key_work_ms"] = sorted(round(1000 * one) for one in working)
    desk.pause(0.3)
    desk.report["summary"] = desk.dock.judge.sentence()
    desk.report["steps"] = [button.text() for button in desk.dock.judge._steps if button.isVisible()]


def begin_and_leave_by_a_new_project(desk: Desk, widths: dict[str, int]) -> None:
    """Nothing of QGIS stays hidden."""
    key(desk, Qt.Key.Key_J)
    desk.new_project()
    desk.pause(0.5)
    desk.report["left_by_project"] = looks(desk)["widths"].keys() == widths.keys()


def looks(desk: Desk) -> dict:
    """Docks in sight with their widths, and layers on the map."""
    docks = [one for one in desk.window.findChildren(QDockWidget) if one.isVisible()]
    widths = {dock.objectName(): dock.width() for dock in docks}
    shown = [layer.name() for layer in desk.canvas.layers() if not layer.name().startswith("strip")]
    return {"widths": widths, "shown": shown}


def key(desk: Desk, pressed: Qt.Key) -> None:
    """Where the focus is."""
    QTest.keyClick(QApplication.focusWidget() or desk.canvas, pressed)
    desk.pause(0.1)  # until it is up


def picture(desk: Desk, step: str) -> Path:
    """Path of a step's picture."""
    return Path(desk.parameters["screenshots"]) / f"{desk.parameters['name']}_{step}.png"
