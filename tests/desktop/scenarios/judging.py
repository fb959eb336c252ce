"""A new operator judges all windows of a block by keys, the map with the room of QGIS's panels.

Before, what he does is taken back and done again by the keys of undo, wherever the focus is; and keys are held down.

Parameters: ``block``, ``screenshots`` (folders), ``side_m``.
"""
from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

from qgis.core import QgsFeature, QgsGeometry, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication, QDockWidget, QLineEdit, QPushButton, QWidget
from qgis.utils import iface

from demo.desk import Desk
from tests.desktop.scenarios import held_keys

KEYS = (Qt.Key.Key_V, Qt.Key.Key_I, Qt.Key.Key_I, Qt.Key.Key_V, Qt.Key.Key_U)
CONTROL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier


def play(desk: Desk) -> None:
    """Undo, held keys, then in, through all windows, and out again."""
    block, side_m = Path(desk.parameters["block"]), float(desk.parameters["side_m"])
    desk.set_up(block, side_m, side_m / 2)  # windows that are larger than the map at 2x, so that there are places
    desk.place_and_inspect()
    undo(desk)
    desk.report["has_xdotool"] = shutil.which("xdotool") is not None  # it presses keys as the X server does
    if desk.report["has_xdotool"]:
        held_keys.play(desk)
        desk.press_in(desk.dock.windows.table, Qt.Key.Key_Z, CONTROL)
    desk.project.addMapLayer(QgsRasterLayer(str(block / "mosaic.tif"), "over"))  # hides the mosaic
    desk.project.layerTreeRoot().findLayer(desk.session.inputs.mosaic).setItemVisibilityChecked(False)
    desk.wait_for_map()
    desk.window.activateWindow()
    desk.canvas.setFocus()
    desk.wait(lambda: QApplication.focusWidget() is not None, 5, "focus in the main window")
    desk.report["before"] = looks(desk)
    begin(desk)
    places(desk)
    flicker(desk)
    judge(desk)
    key(desk, Qt.Key.Key_J)
    desk.wait_for_map()
    desk.screenshot(picture(desk, "after"))
    desk.report["after"] = looks(desk)
    key(desk, Qt.Key.Key_J)
    desk.new_project()
    desk.pause(0.5)
    is_as_before = looks(desk)["widths"].keys() == desk.report["before"]["widths"].keys()
    desk.report["as_before_in_a_new_project"] = is_as_before


def undo(desk: Desk) -> None:
    """Each key takes one action back, and does it again."""
    session = desk.session
    layer, before = session.window_layer(), everything(desk)
    assert session.steps.count() == 2, session.steps.count()
    fid = next(row.fid for row in session.windows() if row.is_compared)
    session.select([fid])
    desk.wait(lambda: desk.curves_of(fid), 20, "curve of the window to judge")
    session.judge([fid], "visible")
    edited = add_edited_layer(desk)
    for active in (layer, edited):
        iface.setActiveLayer(active)
        desk.pause(0.2)
        for name, widget in everywhere(desk).items():
            if name in ("map", "layers") and active is edited:
                continue  # QGIS's own undo is for the layer that is edited there
            take_back_and_redo(desk, fid, widget, f"{name}, {active.name()}")
    desk.dock.draw.trigger()
    take_back_and_redo(desk, fid, desk.canvas, "map while drawing, another layer edited")
    desk.dock.draw.trigger()
    iface.setActiveLayer(layer)
    draw_and_undo(desk)
    line = desk.dock.windows.findChild(QLineEdit)
    line.setFocus()
    QTest.keyClicks(line, "ab")
    desk.press_in(line, Qt.Key.Key_Z, CONTROL)
    assert session.row(fid).observer == "visible", "a text field keeps its own undo"
    line.clear()
    desk.dock.setFloating(True)
    desk.pause(0.5)
    take_back_and_redo(desk, fid, desk.dock.windows.table, "floating")
    desk.dock.setFloating(False)
    for _ in range(3):
        desk.press_in(desk.dock.windows.table, Qt.Key.Key_Z, CONTROL)
    assert session.windows() == [], "all windows that were placed are one step, and so is their inspection"
    for _ in range(2):
        desk.press_in(desk.dock.windows.table, Qt.Key.Key_Y, CONTROL)
    desk.wait(lambda: everything(desk) == before, 10, "windows and results back")
    session.select([session.windows()[-1].fid])
    desk.press(Qt.Key.Key_Delete)
    assert len(session.windows()) == len(before) - 1
    desk.press_in(desk.dock.windows.table, Qt.Key.Key_Z, CONTROL)
    assert everything(desk) == before
    edited.rollBack()  # else QGIS asks
    desk.project.removeMapLayer(edited.id())


def everything(desk: Desk) -> list[tuple[Any, ...]]:
    """What is known of the windows."""
    return [(row.window_id, row.verdict, row.observer) for row in desk.session.windows()]


def everywhere(desk: Desk) -> dict[str, QWidget]:
    """Widgets that may have the focus."""
    buttons = desk.dock.judge.findChildren(QPushButton)
    return {
        "table": desk.dock.windows.table,
        "chart": desk.dock.curves.focusWidget() or desk.dock.curves,
        "judge bar": next(button for button in buttons if button.isVisible() and button.isEnabled()),
        "map": desk.canvas,
        "layers": iface.layerTreeView(),
    }


def add_edited_layer(desk: Desk) -> QgsVectorLayer:
    """Another layer that has something to undo."""
    layer = QgsVectorLayer("Point?crs=EPSG:32615", "edited", "memory")
    desk.project.addMapLayer(layer)
    layer.startEditing()
    feature = QgsFeature()
    feature.setGeometry(QgsGeometry.fromWkt("POINT(0 0)"))
    layer.beginEditCommand("a point")
    layer.addFeature(feature)
    layer.endEditCommand()
    return layer


def take_back_and_redo(desk: Desk, fid: int, widget: QWidget, where: str) -> None:
    """The judgement, by each of the keys."""
    session = desk.session
    count = len(session.windows())
    for again, modifiers in ((Qt.Key.Key_Z, CONTROL | SHIFT), (Qt.Key.Key_Y, CONTROL)):
        desk.press_in(widget, Qt.Key.Key_Z, CONTROL)
        assert session.row(fid).observer == "", f"Ctrl+Z: {where}"
        assert len(session.windows()) == count, f"more than a step: {where}"
        desk.press_in(widget, again, modifiers)
        assert session.row(fid).observer == "visible", f"redo: {where}"
    desk.report.setdefault("undone_from", []).append(where)


def draw_and_undo(desk: Desk) -> None:
    """A drawn window and its result are one step, from the map."""
    session = desk.session
    count, steps = len(session.windows()), session.steps.index()
    desk.dock.draw.trigger()
    center = session.mosaic_layer().extent().center()
    desk.drag((center.x(), center.y()), (center.x() + 12.8, center.y() - 12.8))
    desk.wait(lambda: len(session.windows()) == count + 1 and not session.is_busy, 20, "a window is drawn")
    desk.wait(lambda: all(row.verdict for row in session.windows()), 20, "its result is written")
    assert session.steps.index() == steps + 1
    desk.press_in(desk.canvas, Qt.Key.Key_Z, CONTROL)
    assert len(session.windows()) == count
    desk.dock.draw.trigger()


# Judging


def begin(desk: Desk) -> None:
    """J: the image has the screen."""
    key(desk, Qt.Key.Key_J)
    desk.wait_for_map()
    desk.rest_mouse()
    canvas, window = desk.canvas, desk.window
    desk.report["share"] = canvas.width() * canvas.height() / (window.width() * window.height())
    desk.report["focus"] = QApplication.focusWidget() is canvas
    desk.report["on_map"] = looks(desk)["shown"]
    bar = desk.dock.judge
    desk.report["judge_whole"] = bar.visibleRegion().boundingRect() == bar.rect()
    desk.screenshot(picture(desk, "begun"))


def places(desk: Desk) -> None:
    """Tab: the window's other places, then the first again."""
    seen = [desk.canvas.extent().center()]
    for _ in range(8):
        key(desk, Qt.Key.Key_Tab)
        seen.append(desk.canvas.extent().center())
    desk.report["places"] = len({(round(point.x(), 2), round(point.y(), 2)) for point in seen})
    desk.report["focus_after_tab"] = QApplication.focusWidget() is desk.canvas


def flicker(desk: Desk) -> None:
    """Space, held and tapped; the next window begins with the mosaic."""
    shower = desk.dock.flicker
    QTest.keyPress(QApplication.focusWidget(), Qt.Key.Key_Space)
    desk.wait(lambda: shower.is_shown and shower.hard_cut.layer, 30, "hard cut drawn")
    desk.pause(0.4)
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
    """All windows, by one key each."""
    session, count = desk.session, 0
    while session.selected() and count < 1000:
        window = session.row(session.selected()[0]).window_id
        key(desk, KEYS[count % len(KEYS)])
        assert session.numbered(window).observer, window
        count += 1
    desk.report["judged"] = count
    desk.report["unjudged"] = sum(row.is_compared and not row.observer for row in session.windows())
    desk.pause(0.3)
    desk.screenshot(picture(desk, "summary"))


def looks(desk: Desk) -> dict[str, Any]:
    """Docks in sight with their widths, and layers on the map."""
    docks = [dock for dock in desk.window.findChildren(QDockWidget) if dock.isVisible()]
    widths = {dock.objectName(): dock.width() for dock in docks}
    shown = [layer.name() for layer in desk.canvas.layers() if not layer.name().startswith("strip")]
    return {"widths": widths, "shown": shown}


def key(desk: Desk, pressed: Qt.Key) -> None:
    """Press a key where the focus is."""
    QTest.keyClick(QApplication.focusWidget() or desk.canvas, pressed)
    desk.pause(0.1)  # until it is up


def picture(desk: Desk, step: str) -> Path:
    """Path of a step's picture."""
    return Path(desk.parameters["screenshots"]) / f"judging_{step}.png"
