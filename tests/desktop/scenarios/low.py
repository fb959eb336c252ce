"""The desk on a low screen, all inputs unfolded: QGIS's window stays within it, and everything can be scrolled to.

Parameters: ``block`` (folder), ``side_m``, ``screenshots`` (folder).
"""
from __future__ import annotations

from pathlib import Path

from demo.desk import Desk


def play(desk: Desk) -> None:
    """What is measured is in the report."""
    block, side_m = Path(desk.parameters["block"]), float(desk.parameters["side_m"])
    shots = Path(desk.parameters["screenshots"])
    desk.set_up(block, side_m, side_m)
    inputs = desk.dock.inputs
    inputs.box.fold(False)
    inputs.more.setCollapsed(False)
    desk.pause(0.5)
    screen = desk.window.screen().availableGeometry()
    desk.report["screen"] = [screen.width(), screen.height()]
    desk.report["window"] = [desk.window.width(), desk.window.height()]
    desk.report["dock"] = [desk.dock.width(), desk.dock.height()]
    desk.screenshot(shots / "low_inputs.png")
    body, judge = desk.dock.widget(), desk.dock.judge
    desk.report["scrolls"] = body.scrolled.verticalScrollBar().maximum() > 0
    bottom = judge.mapTo(body, judge.rect().bottomLeft()).y()
    desk.report["reached"] = 0 < bottom <= body.height()
    body.scrolled.ensureWidgetVisible(desk.dock.windows.table)
    desk.pause(0.3)
    desk.screenshot(shots / "low_judge.png")
    inputs.box.fold(True)
    desk.pause(0.5)
    desk.screenshot(shots / "low_folded.png")
