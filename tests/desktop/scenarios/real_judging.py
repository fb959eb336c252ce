"""Windows along the seams of real orthoimages, the worst first, judged by keys alone; a second operator judges blind.

Parameters: ``brighton``, ``screenshots`` (folders).
"""
from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication, QgsRectangle
from qgis.gui import QgsMessageBarItem
from qgis.PyQt.QtCore import Qt
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
    inspect(desk)
    desk.sort_by_loss()
    desk.session.select([])
    with desk.judging():  # begins with the worst
        judge_by_keys(desk, shots)
    with desk.judging():
        judge_blind(desk, shots)
    desk.wait(lambda: not QgsApplication.taskManager().activeTasks(), 60, "no task that QGIS would ask about")


def inspect(desk: Desk) -> None:
    """All windows; nothing is said over the map, for the desk says it."""
    iface.messageBar().clearWidgets()
    before = iface.messageBar().findChildren(QgsMessageBarItem)  # taken away, and deleted when this play ends
    with Gaps() as gaps:
        desk.dock.inspect.trigger()
        desk.wait(lambda: all(row.verdict for row in desk.session.windows()), 60, "all windows inspected")
        desk.wait_for_work()
    items = iface.messageBar().findChildren(QgsMessageBarItem)
    desk.report["said_over_the_map"] = sum(item not in before for item in items)
    gaps.note(desk.report, "inspect")


def judge_by_keys(desk: Desk, shots: Path) -> None:
    """One key a window, from the map and the desk; the map follows at 2x."""
    session = desk.session
    everywhere = [desk.canvas, desk.dock.judge, iface.mainWindow(), desk.dock]
    seen, wrong = [], []
    with Gaps() as gaps:
        for number in range(JUDGED):
            key, word = WORDS[number % 7 % 3]
            fid = session.selected()[0]
            window = session.row(fid).window_id
            desk.press_in(everywhere[number % len(everywhere)], key)
            row = next(row for row in session.windows() if row.window_id == window)
            seen.append(row.loss or 0.0)
            if row.observer != word or not in_the_middle(desk):
                wrong.append((window, number % len(everywhere), row.observer))
            if number == 12:
                desk.rest_mouse()
                desk.wait_for_map()
                desk.screenshot(shots / "judging.png")
    desk.report["wrong"] = wrong
    desk.report["worst_first"] = seen == sorted(seen, reverse=True)
    gaps.note(desk.report, "judge")
    before = session.selected()
    desk.press_in(desk.canvas, Qt.Key.Key_Backspace)
    assert session.selected() != before
    desk.press_in(desk.canvas, Qt.Key.Key_V)
    assert session.selected() == before


def judge_blind(desk: Desk, shots: Path) -> None:
    """A second operator, who is told nothing."""
    session, model = desk.session, desk.dock.judging.model
    selected = [row.fid for row in session.windows() if row.verdict == "significant"][:1]
    session.select(selected)
    desk.pause(0.3)
    model.change(operator=2, is_blind=True)
    desk.pause(0.3)
    assert "significant" not in iface.statusBarIface().currentMessage()
    desk.press_in(desk.canvas, Qt.Key.Key_N)
    for number in range(20):
        desk.press_in(desk.canvas, WORDS[number % 5 % 2][0])
    desk.rest_mouse()
    desk.wait_for_map()
    desk.screenshot(shots / "judging_blind.png")
    desk.report["second"] = sum(bool(row.observer_2) for row in session.windows())
    desk.report["blind_columns"] = desk.headings()
    model.change(operator=1, is_blind=False)


def in_the_middle(desk: Desk) -> bool:
    """Whether the map shows the selected window in its middle, one image pixel on 2 x 2 of the screen's."""
    extent, row = desk.canvas.extent(), desk.session.row(desk.session.selected()[0])
    middle = QgsRectangle(*row.extent).center()
    pixel = desk.session.mosaic_grid().pixel_width / 2
    return bool(extent.center().distance(middle) < 4 * pixel and abs(desk.canvas.mapUnitsPerPixel() / pixel - 1) < 0.01)
