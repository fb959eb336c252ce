"""A hundred windows of real orthoimages, the worst first, judged by keys alone; a second operator judges blind.

Parameters: ``brighton``, ``screenshots`` (folders).
"""
from __future__ import annotations

import statistics
import time
from pathlib import Path

from qgis.core import QgsApplication, QgsRectangle
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QComboBox, QWidget
from qgis.utils import iface

from demo.desk import Desk
from demo.gaps import Gaps

JUDGED = 30
WORDS = ((Qt.Key.Key_V, "visible"), (Qt.Key.Key_I, "invisible"), (Qt.Key.Key_U, "unsure"))


def play(desk: Desk) -> None:
    """Places, inspects, judges, and looks at every step."""
    folder, shots = Path(desk.parameters["brighton"]), Path(desk.parameters["screenshots"])
    desk.set_up(folder, 7.6, 2.2, mosaic="mosaic_feather0p4m")
    session = desk.session
    desk.dock.place.trigger()
    desk.wait(lambda: session.windows() and not session.is_busy, 30, "windows placed")
    desk.report["placed"] = len(session.windows())
    desk.dock.place.trigger()
    desk.wait_for_work()
    assert len(session.windows()) == desk.report["placed"], "placing twice doubles nothing"
    desk.dock.inspect.trigger()
    desk.wait(lambda: all(row.verdict for row in session.windows()), 60, "all windows inspected")
    desk.wait_for_work()
    desk.sort_by_loss()
    desk.session.select([])
    with desk.judging():  # begins with the worst
        judge_by_keys(desk, shots)
    leave_keys(desk)
    with desk.judging():
        annotate(desk, shots)
        judge_blind(desk, shots)
    compare(desk, shots)
    look_at_the_table(desk, shots)
    keep_in_project(desk, shots)


def judge_by_keys(desk: Desk, shots: Path) -> None:
    """One key a window, from the map and the desk; the map follows at 2x."""
    session, keys = desk.session, 0
    everywhere = [desk.canvas, desk.dock.judge, iface.mainWindow(), desk.dock]
    seen, wrong, key_times = [], [], []
    with Gaps() as gaps:
        for number in range(JUDGED):
            key, word = WORDS[number % 7 % 3]
            fid = session.selected()[0]
            window = session.row(fid).window_id
            key_times.append(press(desk, everywhere[number % len(everywhere)], key))
            keys += 1
            row = next(row for row in session.windows() if row.window_id == window)
            seen.append(row.loss or 0.0)
            if row.observer != word or not in_the_middle(desk):
                wrong.append((window, number % len(everywhere), row.observer))
            if number == 12:
                desk.rest_mouse()
                desk.wait_for_map()
                desk.screenshot(shots / "judging.png")
    desk.report["wrong"] = wrong
    desk.report["key_ms"] = [round(1000 * one) for one in (statistics.median(key_times), max(key_times))]
    desk.report["keys_per_window"] = keys / JUDGED
    desk.report["worst_first"] = seen == sorted(seen, reverse=True)
    desk.report["judge_gap_ms"], desk.report["judge_work_ms"] = 1000 * gaps.longest_s, 1000 * gaps.longest_work_s
    desk.report["progress"] = desk.dock.judge._progress.text()
    before = session.selected()
    press(desk, desk.canvas, Qt.Key.Key_Backspace)
    desk.report["taken back"] = desk.dock.judge._progress.text()
    press(desk, desk.canvas, Qt.Key.Key_V)
    assert session.selected() == before


def leave_keys(desk: Desk) -> None:
    """What is typed into the desk, into QGIS's Layers panel, or while nothing is judged, judges nothing."""
    session = desk.session
    before, judged = session.selected(), [row.observer for row in session.windows()]
    for widget in (desk.dock.windows.table, desk.canvas, iface.layerTreeView()):
        for key, _ in WORDS:
            press(desk, widget, key)
    assert [row.observer for row in session.windows()] == judged
    session.select(before)
    line = desk.dock.windows._search
    line.setFocus()
    QTest.keyClicks(line, "vin1")
    assert line.text() == "vin1", "a text field keeps its letters"
    assert session.selected() == before
    line.clear()
    choice = next(box for box in desk.dock.findChildren(QComboBox) if box.isVisible())
    QTest.mouseClick(choice, Qt.MouseButton.LeftButton)
    choice.hidePopup()
    assert QApplication.focusWidget() is not choice, "a click on a choice leaves it the keys"
    desk.pause(0.7)


def annotate(desk: Desk, shots: Path) -> None:
    """How sure, and why: one digit, and R with a few words."""
    session = desk.session
    press(desk, desk.canvas, Qt.Key.Key_N)  # a digit right after V would be of the window just judged
    number = session.row(session.selected()[0]).window_id
    press(desk, desk.canvas, Qt.Key.Key_7)
    press(desk, desk.canvas, Qt.Key.Key_R)
    edit = QApplication.focusWidget()
    QTest.keyClicks(edit, "faint band by the kerb")
    desk.screenshot(shots / "judging_remark.png")
    QTest.keyClick(edit, Qt.Key.Key_Return)
    desk.pause(0.2)
    (row,) = (row for row in session.windows() if row.window_id == number)
    assert (row.confidence, row.remark) == (70, "faint band by the kerb"), row
    press(desk, QApplication.focusWidget() or desk.canvas, Qt.Key.Key_V)
    assert [row.observer for row in session.windows() if row.window_id == number] == ["visible"]


def judge_blind(desk: Desk, shots: Path) -> None:
    """A second operator, who is told nothing."""
    session, model = desk.session, desk.dock.judging.model
    selected = [row.fid for row in session.windows() if row.verdict == "significant"][:1]
    session.select(selected)
    desk.pause(0.3)
    model.change(operator=2, is_blind=True)
    desk.pause(0.3)
    assert "significant" not in iface.statusBarIface().currentMessage()
    press(desk, desk.canvas, Qt.Key.Key_N)
    for number in range(20):
        press(desk, desk.canvas, WORDS[number % 5 % 2][0])
    desk.rest_mouse()
    desk.wait_for_map()
    desk.screenshot(shots / "judging_blind.png")
    desk.report["second"] = sum(bool(row.observer_2) for row in session.windows())
    desk.report["blind_columns"] = [column.title() for column in desk.dock.windows.table.visible_columns()]
    model.change(operator=1, is_blind=False)


def compare(desk: Desk, shots: Path) -> None:
    """Where both differ."""
    session = desk.session
    for row in session.windows():  # the first one judges the same, but for a few
        if row.observer_2:
            other = "invisible" if row.window_id % 6 == 0 else row.observer_2
            session.judge([row.fid], other)
    desk.dock.windows.set_filter("", "operators_differ")
    desk.pause(0.7)
    desk.report["disagreements"] = len(desk.dock.windows.ordered_fids())
    desk.screenshot(shots / "judging_differ.png")
    desk.dock.windows.set_filter("", "")


def look_at_the_table(desk: Desk, shots: Path) -> None:
    """Numbers in the filter, rows for a spreadsheet."""
    windows = desk.dock.windows
    windows.set_filter("kept < 0.7 and cause = 'feathering'", "")
    desk.pause(0.7)
    desk.report["filtered"] = len(windows.ordered_fids())
    desk.screenshot(shots / "judging_filter.png")
    windows._search.setText("kept < 0.7 and sharp > 1")
    desk.pause(0.7)
    desk.report["wrong_filter"] = windows._problem.text()
    desk.screenshot(shots / "judging_wrong_filter.png")
    windows.set_filter("", "")
    windows.table.selectRow(0)
    windows.copy()
    desk.report["copied"] = QApplication.clipboard().text()


def keep_in_project(desk: Desk, shots: Path) -> None:
    """Filter and place are there when the project is opened again."""
    desk.dock.windows.sort_by_number()
    desk.dock.windows.set_filter("kept < 0.9", "")
    desk.pause(0.7)
    fids = desk.dock.windows.ordered_fids()
    desk.dock.zoom_to(fids[3])
    desk.pause(0.3)
    before = [desk.session.row(fid).window_id for fid in desk.dock.windows.ordered_fids()]
    place = desk.session.row(fids[3]).window_id
    desk.save_and_reopen()
    desk.pause(1)
    windows = desk.dock.windows
    assert [desk.session.row(fid).window_id for fid in windows.ordered_fids()] == before
    desk.report["reopened"] = [desk.session.row(fid).window_id for fid in desk.session.selected()] == [place]
    desk.rest_mouse()
    desk.screenshot(shots / "judging_reopened.png")
    desk.wait(lambda: not QgsApplication.taskManager().activeTasks(), 60, "no task that QGIS would ask about")


def press(desk: Desk, widget: QWidget, key: Qt.Key) -> float:
    """A key where a widget has the focus. Returns the seconds until it is taken."""
    desk.window.activateWindow()
    widget.setFocus()
    desk.wait(lambda: QApplication.focusWidget() is not None, 5, "focus in the main window")
    start = time.perf_counter()
    QTest.keyClick(QApplication.focusWidget(), key)
    taken = time.perf_counter() - start
    desk.pause(0.1)  # until it is up
    return taken


def in_the_middle(desk: Desk) -> bool:
    """Whether the map shows the selected window in its middle, one image pixel on 2 x 2 of the screen's."""
    extent, row = desk.canvas.extent(), desk.session.row(desk.session.selected()[0])
    middle = QgsRectangle(*row.extent).center()
    pixel = desk.session.mosaic_grid().pixel_width / 2
    return bool(extent.center().distance(middle) < 4 * pixel and abs(desk.canvas.mapUnitsPerPixel() / pixel - 1) < 0.01)
