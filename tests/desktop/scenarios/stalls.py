"""Windows of 1024 px: how long the interface stands still while they are drawn, inspected and judged.

Then hundreds of others are placed.

Parameters: ``rasters`` (the mosaic first, then its sources), ``boxes`` (windows in pixels), ``screenshots`` (folder).
"""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from qgis.core import QgsFeature, QgsGeometry, QgsPointXY, QgsRasterLayer, QgsVectorLayer

from demo.desk import Desk
from demo.gaps import Gaps

AGAIN = 10
"""How many are inspected once more, and how many of them judged meanwhile."""


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    from seam_inspector.plugin.imagery.grids import PixelWindow

    windows = [PixelWindow(*box) for box in desk.parameters["boxes"]]
    mosaic, *sources = desk.load_rasters([Path(path) for path in desk.parameters["rasters"]])
    desk.open_dock()
    session = desk.session
    session.set_inputs(
        replace(session.inputs, mosaic=mosaic.id(), sources=tuple(layer.id() for layer in sources), seamlines="")
    )
    desk.wait(lambda: session.mosaic_grid() is not None, 20, "mosaic open")
    desk.show_all(mosaic.extent())
    with Gaps() as first:  # QGIS makes the layer then
        session.add_window(windows[0])
        desk.wait(lambda: any(map(desk.curves_of, session.selected())), 60, "curves of the first window")
    note(desk, "first", first)
    with Gaps() as drawing:
        for window in windows[1:]:
            session.add_window(window)
            desk.pause(0.05)
        desk.wait(lambda: not session.is_busy, 300, "windows drawn and inspected")
        desk.pause(0.5)
    note(desk, "drawing", drawing)
    fids = [row.fid for row in session.windows()]
    with Gaps() as inspecting:
        session.inspect(fids[:AGAIN])
        desk.wait(lambda: not session.is_busy, 120, "windows inspected")
        desk.pause(0.5)
    note(desk, "inspecting", inspecting)
    with Gaps() as judging:
        session.inspect(fids[:AGAIN])
        for fid in fids[:AGAIN]:
            session.select([fid])
            desk.pause(0.2)
            session.judge([fid], "visible")
            desk.pause(0.2)
        desk.wait(lambda: not session.is_busy, 120, "windows inspected while others are judged")
    note(desk, "judging", judging)
    with Gaps() as placing:
        place(desk, mosaic)
    note(desk, "placing", placing)
    desk.report["placed"] = len(session.windows()) - len(fids)
    desk.report["windows"] = len(fids)
    desk.report["inspected"] = sum(bool(row.verdict) for row in session.windows())
    session.select(fids[:1])
    desk.wait(lambda: desk.curves_of(fids[0]), 30, "curves")
    desk.screenshot(Path(desk.parameters["screenshots"]) / "stalls.png")


def place(desk: Desk, mosaic: QgsRasterLayer) -> None:
    """Hundreds of windows along seams across the mosaic."""
    box, session = mosaic.extent(), desk.session
    seams = QgsVectorLayer(f"LineString?crs={mosaic.crs().authid()}", "seams", "memory")
    lines = []
    for share in (0.2, 0.35, 0.5, 0.65, 0.8):
        y = box.yMinimum() + share * box.height()
        line = QgsFeature()
        line.setGeometry(QgsGeometry.fromPolylineXY([QgsPointXY(box.xMinimum(), y), QgsPointXY(box.xMaximum(), y)]))
        lines.append(line)
    seams.dataProvider().addFeatures(lines)
    desk.project.addMapLayer(seams)
    side = 128 * mosaic.rasterUnitsPerPixelX()
    session.set_inputs(replace(session.inputs, seamlines=seams.id(), side_m=side, spacing_m=side / 2))
    before = len(session.windows())
    session.place_windows()
    desk.wait(lambda: len(session.windows()) > before and not session.is_busy, 60, "windows placed")
    desk.pause(0.5)
    desk.project.removeMapLayer(seams.id())  # QGIS asks before it forgets one in memory


def note(desk: Desk, name: str, gaps: Gaps) -> None:
    """Into the report."""
    desk.report[f"{name}_gap_ms"] = 1000 * gaps.longest_s
    desk.report[f"{name}_work_ms"] = 1000 * gaps.longest_work_s
    desk.report[f"{name}_gaps"] = gaps.long_ones
