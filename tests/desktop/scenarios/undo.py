"""The keys of undo and redo, wherever the focus is: each takes one action back, and Qt reports nothing ambiguous.

Parameters: ``brighton``, ``screenshots`` (folders).
"""
from __future__ import annotations

from pathlib import Path

from qgis.core import QgsFeature, QgsGeometry, QgsVectorLayer
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtGui import QKeySequence
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QAction, QApplication, QWidget
from qgis.utils import iface

from demo.desk import Desk

CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


def play(desk: Desk) -> None:
    """Places, draws and judges; every step is taken back and done again from everywhere."""
    folder, shots = Path(desk.parameters["brighton"]), Path(desk.parameters["screenshots"])
    desk.set_up(folder, 1.9, 8.8, mosaic="mosaic_feather0p4m")
    desk.report["ctrl_y"] = [
        action.objectName() for action in desk.window.findChildren(QAction)
        if QKeySequence("Ctrl+Y") in action.shortcuts() and action.parent() is not desk.window
    ]  # fmt: skip
    session = desk.session
    desk.dock.place.trigger()
    desk.wait(lambda: session.windows() and not session.is_busy, 30, "windows placed")
    layer, count = session.window_layer(), len(session.windows())
    desk.report["placed"] = count
    assert desk.dock.steps.undo.isEnabled()
    desk.dock.inspect.trigger()
    desk.wait(lambda: all(row.verdict for row in session.windows()), 60, "all windows inspected")
    desk.wait_for_work()
    assert session.steps.count() == 2, session.steps.count()
    fid = next(row.fid for row in session.windows() if row.verdict != "not_comparable")
    session.select([fid])
    desk.wait(lambda: desk.curves_of(fid), 20, "curve of the window to judge")
    session.judge([fid], "visible")
    edited = add_edited_layer(desk)
    mosaic = session.mosaic_layer()
    for active in (layer, mosaic, edited):
        iface.setActiveLayer(active)
        desk.pause(0.2)
        for name, widget in everywhere(desk).items():
            if name in ("map", "layers") and active is edited:
                continue  # QGIS's own undo is for the layer that is edited there
            check(desk, fid, widget, f"{name}, {active.name()}")
    desk.dock.draw.trigger()
    check(desk, fid, desk.canvas, "map while drawing, another layer edited")
    desk.dock.draw.trigger()
    iface.setActiveLayer(layer)
    draw_and_undo(desk)
    line = desk.dock.windows._search
    line.setFocus()
    QTest.keyClicks(line, "ab")
    press(desk, line, Qt.Key.Key_Z, CONTROL)
    assert session.row(fid).observer == "visible", "a text field keeps its own undo"
    line.clear()
    desk.pause(0.3)
    desk.dock.setFloating(True)
    desk.pause(0.5)
    check(desk, fid, desk.dock.windows.table, "floating")
    desk.dock.setFloating(False)
    desk.rest_mouse()
    desk.screenshot(shots / "undo.png")
    for _ in range(3):
        press(desk, desk.dock.windows.table, Qt.Key.Key_Z, CONTROL)
    assert session.windows() == [], "all windows that were placed are one step, and so is their inspection"
    for _ in range(2):
        press(desk, desk.dock.windows.table, Qt.Key.Key_Y, CONTROL)
    desk.wait(lambda: all(row.verdict for row in session.windows()), 10, "results back")
    assert len(session.windows()) == count
    press(desk, desk.dock.windows.table, Qt.Key.Key_Y, CONTROL)
    session.select([session.windows()[3].fid])
    before = [(row.window_id, row.verdict, row.observer) for row in session.windows()]
    desk.press(Qt.Key.Key_Delete)
    assert len(session.windows()) == count - 1
    press(desk, desk.dock.windows.table, Qt.Key.Key_Z, CONTROL)
    assert [(row.window_id, row.verdict, row.observer) for row in session.windows()] == before
    desk.drop_changes()


def everywhere(desk: Desk) -> dict[str, QWidget]:
    """Widgets that may have the focus."""
    return {
        "table": desk.dock.windows.table,
        "chart": desk.dock.curves.focusWidget() or desk.dock.curves,
        "judge bar": desk.dock.judge._visible,
        "map": desk.canvas,
        "layers": iface.layerTreeView(),
    }


def add_edited_layer(desk: Desk) -> QgsVectorLayer:
    """Another layer that has something to undo."""
    made = QgsVectorLayer("Point?crs=EPSG:32615", "edited", "memory")
    desk.project.addMapLayer(made)
    made.startEditing()
    feature = QgsFeature()
    feature.setGeometry(QgsGeometry.fromWkt("POINT(0 0)"))
    made.beginEditCommand("a point")
    made.addFeature(feature)
    made.endEditCommand()
    return made


def check(desk: Desk, fid: int, widget: QWidget, where: str) -> None:
    """The judgement is taken back and done again, by each of the keys."""
    session = desk.session
    for key, modifiers in ((Qt.Key.Key_Z, CONTROL | SHIFT), (Qt.Key.Key_Y, CONTROL)):
        press(desk, widget, Qt.Key.Key_Z, CONTROL)
        assert session.row(fid).observer == "", f"Ctrl+Z: {where}"
        assert len(session.windows()) == desk.report["placed"], f"one step only: {where}"
        press(desk, widget, key, modifiers)
        assert session.row(fid).observer == "visible", f"redo: {where}"
    desk.report.setdefault("works in", []).append(where)


def draw_and_undo(desk: Desk) -> None:
    """A drawn window and its result are one step, from the map."""
    session, count = desk.session, desk.report["placed"]
    steps = session.steps.index()
    desk.dock.draw.trigger()
    center = session.mosaic_layer().extent().center()
    desk.drag((center.x(), center.y()), (center.x() + 6, center.y() - 6))
    desk.wait(lambda: len(session.windows()) == count + 1 and not session.is_busy, 20, "a window is drawn")
    desk.wait(lambda: all(row.verdict for row in session.windows()), 20, "its result is written")
    assert session.steps.index() == steps + 1
    press(desk, desk.canvas, Qt.Key.Key_Z, CONTROL)
    assert len(session.windows()) == count
    desk.dock.draw.trigger()


def press(desk: Desk, widget: QWidget, key: Qt.Key, modifiers: Qt.KeyboardModifier) -> None:
    widget.window().activateWindow()
    widget.setFocus()
    desk.pause(0.1)
    QTest.keyClick(QApplication.focusWidget() or widget, key, modifiers)
    desk.pause(0.15)
