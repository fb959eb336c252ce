"""The desk as it looks, right of the map, in whatever theme and scale QGIS was started with.

Parameters: ``block`` (folder), ``side_m``, ``screenshots`` (folder), ``name`` (of the pictures).
"""
from __future__ import annotations

from pathlib import Path

from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QAbstractButton, QComboBox, QLabel, QLineEdit, QWidget
from qgis.utils import iface
from seam_inspector.plugin.toolkit.desk.widgets import ScrollBody

from demo.desk import Desk
from tests.desktop import eyes

INSPECTED = 4  # of the windows: what is looked at is the dock


def play(desk: Desk) -> None:
    """Pictures of everything; what is cut off is in the report."""
    block, side_m = Path(desk.parameters["block"]), float(desk.parameters["side_m"])
    folder, name = Path(desk.parameters["screenshots"]), desk.parameters["name"]
    desk.set_up(block, side_m, side_m)
    empty(desk, folder / f"{name}_empty.png")
    desk.dock.place.trigger()
    desk.wait(lambda: desk.session.windows(), 60, "windows placed")
    desk.wait_for_work()
    some = [row.fid for row in desk.session.windows()][:INSPECTED]
    desk.session.inspect(some)
    desk.wait_for_work(120)
    desk.wait(lambda: all(desk.session.row(fid).verdict for fid in some), 30, "verdicts written")
    desk.session.select([next(row.fid for row in desk.session.windows() if row.is_compared)])
    desk.rest_mouse()
    desk.pause(1)
    iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, desk.dock)
    desk.window.resizeDocks([desk.dock], [420], Qt.Orientation.Horizontal)
    desk.pause(0.5)
    desk.show_tab(0)
    desk.wait_for_map()
    desk.report["right_size"] = [desk.dock.width(), desk.dock.height()]
    look(desk, "right")
    desk.screenshot(folder / f"{name}_right.png")
    desk.show_tab(1)
    desk.wait(lambda: desk.dock.images.compared.layer is not None, 30, "hard cut")
    desk.wait_for_map()
    desk.screenshot(folder / f"{name}_right_images.png")
    look(desk, "right_images")
    desk.show_tab(0)
    if desk.window.devicePixelRatioF() == 1:
        low(desk, folder / f"{name}_low.png")


def low(desk: Desk, path: Path) -> None:
    """On a low screen, all inputs unfolded, QGIS's window stays within it, and everything can be scrolled to."""
    inputs = desk.dock.inputs
    iface.addDockWidget(Qt.DockWidgetArea.RightDockWidgetArea, desk.dock)
    desk.window.resizeDocks([desk.dock], [420], Qt.Orientation.Horizontal)
    desk.pause(0.5)
    inputs.box.fold(False)
    inputs.more.setCollapsed(False)
    desk.window.resize(1000, 700)  # QGIS's own bars may want to be wider, and nothing higher
    desk.pause(0.5)
    desk.report["low_window"] = [desk.window.width(), desk.window.height()]
    desk.report["low_dock"] = [desk.dock.width(), desk.dock.height()]
    body, judge = desk.dock.widget(), desk.dock.judge
    desk.report["low_scrolls"] = body.findChild(ScrollBody).verticalScrollBar().maximum() > 0
    bottom = judge.mapTo(body, judge.rect().bottomLeft()).y()
    desk.report["low_reached"] = 0 < bottom <= body.height()
    desk.screenshot(path)


def look(desk: Desk, side: str) -> None:
    """What is wrong, and how well words can be read, goes into the report."""
    wait_for_chart(desk)
    dock = desk.dock
    chart, judge = dock.curves.curves._chart, dock.judge
    desk.report[f"{side}_chart"] = chart.height()
    desk.report[f"{side}_judge_whole"] = judge.visibleRegion().boundingRect() == judge.rect()
    desk.report[f"{side}_cut"] = cut_off(dock)
    desk.report[f"{side}_table_overflow"] = dock.windows.table.horizontalScrollBar().maximum()
    desk.report[f"{side}_headings_cut"] = eyes.cut_headings(dock.windows.table)
    desk.report[f"{side}_contrasts"] = eyes.contrasts(dock)
    desk.report[f"{side}_no_tooltip"] = eyes.without_tooltip(dock)
    desk.report[f"{side}_steps_up"] = eyes.steps_up(dock) if "right" in side else []
    desk.report[f"{side}_no_focus_mark"] = eyes.without_focus_mark(dock)


def wait_for_chart(desk: Desk) -> None:
    """Until the curves of the selected window are drawn."""
    desk.wait(lambda: desk.curves_of(desk.session.selected()[0]), 30, "chart drawn")


def empty(desk: Desk, path: Path) -> None:
    """Before there is a window, inputs unfolded."""
    desk.dock.inputs.box.fold(False)
    desk.pause(0.5)
    desk.report["inputs_cut"] = cut_off(desk.dock)
    desk.screenshot(path)
    desk.dock.inputs.box.fold(True)


def cut_off(dock: QWidget) -> list[str]:
    """Visible controls that are smaller than they have to be, or stick out of the dock."""
    cut = []
    for widget in dock.findChildren(QWidget):
        if not widget.isVisible() or not isinstance(widget, (QAbstractButton, QComboBox, QLabel, QLineEdit)):
            continue
        text = getattr(widget, "text", lambda: "")()
        if isinstance(widget, QAbstractButton) and not text:
            continue  # those of Qt's and QGIS's own frames are smaller than they ask for
        least = widget.minimumSizeHint()
        right = widget.mapTo(dock, widget.rect().topRight()).x()
        # A theme's style sheet rounds its paddings, one way for what is asked and another for what is given
        is_small = widget.height() < least.height() - 1 or widget.width() < least.width() - 1
        if is_small or right > dock.width():
            size, asked = widget.size(), f"{least.width()}x{least.height()}"
            cut.append(f"{type(widget).__name__} {text!r} {size.width()}x{size.height()} of {asked} at {right}")
    return cut
