"""A hundred small windows side by side: what the map tells of them from afar, from near, selected and judged.

Parameters: ``brighton`` (folder), ``screenshots`` (folder), ``name`` (of the pictures).
"""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from qgis.gui import QgsMessageBarItem
from qgis.utils import iface

from demo.desk import Desk

MOSAIC = "mosaic_feather0p4m"
SIDE_M, SPACING_M = 1.9, 2.2  # 64 px: larger windows would share too many pixels for 100 of them to have room
OBSERVERS = ("visible", "invisible", "unsure")


def play(desk: Desk) -> None:
    """Pictures, and what QGIS says over the map after a run."""
    shots, name = Path(desk.parameters["screenshots"]), desk.parameters["name"]
    desk.set_up(Path(desk.parameters["brighton"]), SIDE_M, SPACING_M, mosaic=MOSAIC)
    desk.session.set_inputs(replace(desk.session.inputs, reference="sources"))
    desk.dock.place.trigger()
    desk.wait(lambda: desk.session.windows() and not desk.session.is_busy, 30, "windows placed")
    desk.screenshot(shots / f"{name}_placed.png")
    iface.messageBar().clearWidgets()
    desk.dock.inspect.trigger()
    desk.wait(lambda: all(row.verdict for row in desk.session.windows()), 60, "all windows inspected")
    desk.wait_for_work()
    desk.pause(1)
    desk.report["said_over_the_map"] = len(iface.messageBar().findChildren(QgsMessageBarItem))
    desk.screenshot(shots / f"{name}_run.png")
    desk.rest_mouse()
    desk.session.select([])
    desk.wait_for_map()
    desk.screenshot(shots / f"{name}_far.png")
    rows = desk.session.windows()
    desk.report["windows"] = len(rows)
    for place, observer in enumerate(OBSERVERS):
        desk.session.judge([row.fid for row in rows[place::6]], observer)
    near = desk.canvas.extent()
    near.scale(0.25)
    for shot, selected in (("judged", ()), ("selected", rows[:40:3])):
        desk.session.select([row.fid for row in selected])
        desk.canvas.zoomToFullExtent()
        desk.wait_for_map()
        desk.screenshot(shots / f"{name}_{shot}_far.png")
        desk.canvas.setExtent(near)
        desk.canvas.refresh()
        desk.wait_for_map()
        desk.screenshot(shots / f"{name}_{shot}_near.png")
    desk.dock.zoom_to(rows[0].fid)
    desk.wait_for_map()
    desk.screenshot(shots / f"{name}_twofold.png")
