"""The first inspection of the guide (docs/start/first_inspection.md), step by step, with a picture of each.

Parameters: ``project`` (of the block, as demo/project.py writes it), ``screenshots`` (folder). What a step of the page
says is done here by the same button, key or click; what the page says will be seen is asserted.
"""
from __future__ import annotations

from pathlib import Path

from qgis.PyQt.QtCore import Qt, QTimer
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QDialogButtonBox, QFileDialog, QLineEdit, QToolButton, QWidget
from qgis.utils import iface

from demo.desk import Desk

DOCK_PX = 500


def play(desk: Desk) -> None:
    """The steps in the page's order."""
    shots = Path(desk.parameters["screenshots"])
    open_the_block(desk)
    open_the_desk(desk)
    desk.screenshot(shots / "first_desk.png")
    place(desk)
    desk.screenshot(shots / "first_placed.png")
    inspect(desk)
    desk.screenshot(shots / "first_inspected.png")
    read(desk)
    desk.screenshot(shots / "first_read.png")
    judge(desk, shots / "first_judged.png")
    write_report(desk, desk.folder / "seam_inspection.html")
    desk.screenshot(shots / "first_reported.png")
    desk.new_project()


def open_the_block(desk: Desk) -> None:
    """Project > Open."""
    assert desk.project.read(desk.parameters["project"])
    desk.wait_for_map()


def open_the_desk(desk: Desk) -> None:
    """Raster > Seam Inspector: mosaic, sources and seamlines are chosen already."""
    desk.open_dock()
    arrange(desk)
    desk.wait(lambda: desk.session.mosaic_grid() is not None, 30, "mosaic chosen and open")
    desk.wait(lambda: desk.dock.place.isEnabled(), 30, "all that is wanted chosen")
    inputs = desk.session.inputs
    assert desk.project.mapLayer(inputs.mosaic).name() == "mosaic"
    assert len(inputs.sources) == 5
    assert desk.project.mapLayer(inputs.seamlines).name() == "seamlines"
    desk.show_all(desk.session.mosaic_layer().extent())
    desk.rest_mouse()


def place(desk: Desk) -> None:
    """Place: windows of 102.4 m along the seams."""
    click_button(desk, desk.dock.place)
    desk.wait(lambda: desk.session.windows() and not desk.session.is_busy, 60, "windows placed")
    desk.report["windows"] = len(desk.session.windows())
    desk.rest_mouse()
    desk.wait_for_map()


def inspect(desk: Desk) -> None:
    """Inspect: every window has a verdict, on the map and in the table."""
    click_button(desk, desk.dock.inspect)
    desk.wait(lambda: all(row.verdict for row in desk.session.windows()), 120, "all windows inspected")
    desk.wait_for_work()
    desk.report["verdicts"] = [row.verdict for row in desk.session.windows()]
    desk.rest_mouse()
    desk.wait_for_map()


def read(desk: Desk) -> None:
    """A click on the heading loss: worst first; one on the second row; View > Zoom to Selection; Lost detail."""
    desk.sort_by_loss()
    table = desk.dock.windows.table
    fids = desk.dock.windows.ordered_fids()
    second = min(1, len(fids) - 1)  # a small block may have one window only
    fid, index = fids[second], table.model().index(second, 0)
    QTest.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier,
                     table.visualRect(index).center())
    desk.wait(lambda: desk.session.selected() == [fid], 10, "row selected")
    desk.wait(lambda: desk.curves_of(fid), 30, "chart drawn")
    iface.actionZoomToSelected().trigger()
    desk.wait_for_map()
    click_button(desk, desk.session.lost_detail)
    desk.report["sentence"] = desk.dock.judge.sentence()
    desk.rest_mouse()
    desk.wait_for_map()


def judge(desk: Desk, picture: Path) -> None:
    """Enter: the window at 2x; J: judging; V: visible, and on to the next."""
    first = desk.session.selected()[0]
    click_button(desk, desk.session.lost_detail)
    desk.press(Qt.Key.Key_Return)
    desk.wait_for_map()
    desk.screenshot(picture)
    with desk.judging():
        desk.press_on_map(Qt.Key.Key_V)
    desk.wait(lambda: desk.session.row(first).observer == "visible", 10, "judged")
    desk.wait_for_map()


def write_report(desk: Desk, path: Path) -> None:
    """Report asks for a file; a message tells when it is written."""
    def answer() -> None:
        dialog = QApplication.activeModalWidget()
        if not isinstance(dialog, QFileDialog):
            QTimer.singleShot(100, answer)
            return
        dialog.findChild(QLineEdit).setText(str(path))
        dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save).click()

    QTimer.singleShot(100, answer)
    click_button(desk, desk.dock.report)
    desk.wait(path.exists, 120, "report written")
    desk.wait(lambda: iface.messageBar().currentItem() is not None, 30, "report told")
    desk.pause(0.5)


def click_button(desk: Desk, action: object) -> None:
    """The tool button of an action, as a mouse does."""
    button = next(widget for widget in desk.dock.findChildren(QToolButton) if widget.defaultAction() is action)
    assert button.isVisible()
    QTest.mouseClick(button, Qt.MouseButton.LeftButton)


def arrange(desk: Desk) -> None:
    """Few layers, a desk of a good width."""
    layers = desk.window.findChild(QWidget, "Layers")
    desk.window.resizeDocks([layers, desk.dock], [140, DOCK_PX], Qt.Orientation.Horizontal)
    desk.pause(0.5)
