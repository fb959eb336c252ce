"""Seeing where detail was lost, on real images: one picture that flips, and the map swiped against the composite.

Parameters: ``brighton`` (folder), ``screenshots`` (folder).
"""
from __future__ import annotations

from pathlib import Path

from qgis.core import QgsCoordinateReferenceSystem
from qgis.PyQt.QtCore import QEvent, QPoint, QPointF, Qt
from qgis.PyQt.QtGui import QKeyEvent, QMouseEvent
from qgis.PyQt.QtWidgets import QApplication, QWidget

from demo.desk import Desk
from demo.gaps import Gaps

SIDE_M, SPACING_M = 15, 8
_LEFT, _NO_BUTTON, _NO_KEY = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    shots = Path(desk.parameters["screenshots"])
    desk.set_up(Path(desk.parameters["brighton"]), SIDE_M, SPACING_M, mosaic="mosaic_feather0p4m")
    desk.dock.place.trigger()
    desk.wait(lambda: desk.session.windows() and not desk.session.is_busy, 60, "windows placed")
    rows = desk.session.windows()
    fid = rows[len(rows) // 2].fid
    desk.session.select([fid])
    desk.session.inspect([fid])
    desk.wait_for_work()
    desk.rest_mouse()  # from the map, whose tips are web views
    flip(desk, fid, shots)
    swipe(desk, fid, shots)


def flip(desk: Desk, fid: int, shots: Path) -> None:
    """The mosaic against the composite, by Space."""
    desk.show_tab(1)
    panel = desk.dock.panels["images"]
    desk.wait(lambda: desk.session.pictures(fid), 30, "pictures")
    panel.strip.buttons[0].click()
    desk.wait(lambda: panel.large.hint == "Space: composite", 30, "composite")
    desk.window.activateWindow()
    desk.pause(0.3)
    panel.large.setFocus(Qt.FocusReason.TabFocusReason)
    send_space(panel.large, QEvent.Type.KeyPress)
    desk.report["flipped_to"] = panel.large.shown.raster
    desk.screenshot(shots / "see_composite.png")
    send_space(panel.large, QEvent.Type.KeyRelease)
    desk.pause(0.1)
    desk.report["flipped_back"] = panel.large.shown.is_mosaic
    desk.dock.lost.action.trigger()
    desk.report["loss_shown"] = desk.session.loss_view.is_shown
    desk.screenshot(shots / "see_loss.png")
    desk.dock.lost.action.trigger()


def swipe(desk: Desk, fid: int, shots: Path) -> None:
    """Sources and composite, with the map moved, turned and in another reference system."""
    desk.dock.zoom_to(fid)
    desk.wait_for_map()
    action = desk.dock.swiping
    swiped, before = action.swipe, len(desk.canvas.scene().items())
    with Gaps() as gaps:
        action.action.trigger()
        wait_for_swipe(desk)
        desk.report["swiped"] = [swiped.choice.title]
        action.start(action.choices()[-1])
        wait_for_swipe(desk)
        desk.report["swiped"].append(swiped.choice.title)
        drag_handle(desk, -200)
        desk.press_on_map(Qt.Key.Key_X)
        desk.pause(0.3)
    desk.report["swipe_work_ms"], desk.report["swipe_gap_ms"] = 1000 * gaps.longest_work_s, 1000 * gaps.longest_s
    desk.screenshot(shots / "see_swipe.png")
    desk.canvas.setRotation(30)
    wait_for_swipe(desk)
    desk.screenshot(shots / "see_swipe_turned.png")
    desk.canvas.setRotation(0)
    desk.project.setCrs(QgsCoordinateReferenceSystem("EPSG:3857"))
    wait_for_swipe(desk)
    desk.screenshot(shots / "see_swipe_mercator.png")
    desk.press_on_map(Qt.Key.Key_Escape)
    desk.pause(0.3)
    desk.report["ended"] = not swiped.is_on and not action.action.isChecked()
    desk.report["left_items"] = len(desk.canvas.scene().items()) - before


def wait_for_swipe(desk: Desk) -> None:
    """Until the map and what is swiped are drawn; the canvas begins a while after it was asked."""
    desk.canvas.refresh()
    desk.pause(1)
    swiped = desk.dock.swiping.swipe
    desk.wait(lambda: not swiped.is_drawing and not desk.canvas.isDrawing(), 60, "swipe drawn")


def drag_handle(desk: Desk, by: int) -> None:
    """With the mouse, to the right by so many pixels."""
    view = desk.canvas.viewport()
    (handle,) = (one for one in desk.canvas.findChildren(QWidget) if type(one).__name__ == "SwipeHandle")
    start = handle.mapToGlobal(handle.rect().center())
    moves = [(QEvent.Type.MouseMove, start + QPoint(by * step // 20, 0)) for step in range(1, 21)]
    last = moves[-1][1]
    for kind, at in ((QEvent.Type.MouseButtonPress, start), *moves, (QEvent.Type.MouseButtonRelease, last)):
        local = QPointF(handle.mapFromGlobal(at))
        held = _NO_BUTTON if kind == QEvent.Type.MouseButtonRelease else _LEFT
        QApplication.sendEvent(handle, QMouseEvent(kind, local, QPointF(at), _LEFT, held, _NO_KEY))
        desk.pause(0.01)
    middle = view.mapFromGlobal(handle.mapToGlobal(handle.rect().center()))
    desk.report["dragged_by"] = middle.x() - view.mapFromGlobal(start).x()


def send_space(view: QWidget, kind: QEvent.Type) -> None:
    """Press or release the key over a picture."""
    QApplication.sendEvent(view, QKeyEvent(kind, Qt.Key.Key_Space, _NO_KEY, " "))
