"""The dock of bar groups: lines drawn across the bars of a rendered target.

Parameters: ``target`` (raster), ``lines`` (ends of a line for each group, the coarsest first, on the map),
``reference_cm`` (of the first group), ``pictures`` (numbers of groups), ``screenshots`` (folder).
"""
from __future__ import annotations

from pathlib import Path

from qgis.core import QgsApplication, QgsProject
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QAction, QWidget
from qgis.utils import iface

from demo.desk import Desk


def play(desk: Desk) -> None:
    """Draws the groups one after the other, as an operator does."""
    shots = Path(desk.parameters["screenshots"])
    QgsProject.instance().setPresetHomePath(str(desk.folder))
    (raster,) = desk.load_rasters([Path(desk.parameters["target"])])
    desk.show_all(raster.extent())
    desk.window.findChild(QAction, "seamInspectorBarAction").trigger()
    dock = desk.window.findChild(QWidget, "SeamInspectorBarDock")
    desk.window.resizeDocks([dock], [430], Qt.Orientation.Horizontal)
    dock.image.setLayer(raster)
    desk.wait(dock.draw.isEnabled, 20, "image open")
    dock.settings.reference_group.setValue(1)
    dock.settings.reference_grd.setValue(float(desk.parameters["reference_cm"]))
    dock.draw.trigger()
    words = []
    for number, (start, end) in enumerate(desk.parameters["lines"], 1):
        dock.group.setValue(number)
        desk.drag(tuple(start), tuple(end))
        desk.pause(0.5)
        desk.wait(lambda: not QgsApplication.taskManager().countActiveTasks(), 20, "group measured")
        desk.pause(0.3)
        words.append(dock.verdict.text())
        if number in desk.parameters["pictures"]:
            desk.screenshot(shots / f"bar_dock_{number}.png")
    desk.report["words"] = words
    iface.addDockWidget(Qt.DockWidgetArea.BottomDockWidgetArea, dock)
    desk.pause(0.5)
    desk.screenshot(shots / "bar_dock_below.png")
    dock.line_layer().rollBack()
    desk.new_project()
