"""Windows of 1024 px: how long the interface stands still while they are drawn, inspected and judged.

First the curves under the mouse are drawn anew while it moves and drags; in the end hundreds of windows are placed.

Parameters: ``rasters`` (the mosaic first, then its sources), ``boxes`` (windows in pixels), ``screenshots`` (folder).
"""
from __future__ import annotations

import time
from collections.abc import Iterator
from dataclasses import replace
from itertools import cycle
from pathlib import Path

from qgis.core import QgsFeature, QgsGeometry, QgsPointXY, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtTest import QTest

from demo.desk import Desk, Point
from demo.gaps import Gaps

AGAIN = 10  # how many are inspected once more, and how many of them judged meanwhile
LIVE_S = 4.0
FRAME_S = 0.016


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
    seams = add_seams(desk, mosaic)
    follow_the_mouse(desk, mosaic, seams)
    with Gaps() as first:  # QGIS makes the layer then
        session.add_window(windows[0])
        desk.wait(lambda: any(map(desk.curves_of, session.selected())), 60, "curves of the first window")
    first.note(desk.report, "first")
    with Gaps() as drawing:
        for window in windows[1:]:
            session.add_window(window)
            desk.pause(0.05)
        desk.wait(lambda: not session.is_busy, 300, "windows drawn and inspected")
        desk.pause(0.5)
    drawing.note(desk.report, "drawing")
    fids = [row.fid for row in session.windows()]
    with Gaps() as inspecting:
        session.inspect(fids[:AGAIN])
        desk.wait(lambda: not session.is_busy, 120, "windows inspected")
        desk.pause(0.5)
    inspecting.note(desk.report, "inspecting")
    with Gaps() as judging:
        session.inspect(fids[:AGAIN])
        for fid in fids[:AGAIN]:
            session.select([fid])
            desk.pause(0.2)
            session.judge([fid], "visible")
            desk.pause(0.2)
        desk.wait(lambda: not session.is_busy, 120, "windows inspected while others are judged")
    judging.note(desk.report, "judging")
    with Gaps() as placing:
        place(desk, mosaic, seams)
    placing.note(desk.report, "placing")
    desk.report["placed"] = len(session.windows()) - len(fids)
    desk.report["windows"] = len(fids)
    desk.report["inspected"] = sum(bool(row.verdict) for row in session.windows())
    session.select(fids[:1])
    desk.wait(lambda: desk.curves_of(fids[0]), 30, "curves")
    desk.screenshot(Path(desk.parameters["screenshots"]) / "stalls.png")
    before = open_files()
    desk.new_project()
    desk.pause(1)
    desk.report["files_released"] = before - open_files()


def follow_the_mouse(desk: Desk, mosaic: QgsRasterLayer, seams: QgsVectorLayer) -> None:
    """Along a seam the window under the mouse has its curves; then one is dragged; and what stays open."""
    session, box, view = desk.session, mosaic.extent(), desk.canvas.viewport()
    inputs = session.inputs
    session.set_inputs(replace(inputs, seamlines=seams.id(), side_m=512 * mosaic.rasterUnitsPerPixelX()))
    desk.wait(lambda: session.seam_point_near(box.center().x(), box.center().y(), 1.0), 20, "seams found")
    desk.dock.draw.trigger()
    start, step = box.xMinimum() + 0.3 * box.width(), 0.002 * box.width()
    steps = [(start + number * step, box.center().y()) for number in range(200)]
    points = cycle([*steps, *reversed(steps)])
    move(desk, points, 1.0)  # blocks are read the first time
    with Gaps() as moving:
        move(desk, points, LIVE_S)
    moving.note(desk.report, "moving")
    desk.wait(lambda: session.live is not None, 20, "curves of the window under the mouse")
    QTest.mousePress(view, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, desk.pixel(steps[0]))
    with Gaps() as dragging:
        move(desk, cycle([(x, y - 0.1 * box.height()) for x, y in steps[60:]]), LIVE_S)
    dragging.note(desk.report, "dragging")
    QTest.keyClick(desk.canvas, Qt.Key.Key_Escape)
    QTest.mouseRelease(view, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier, desk.pixel(steps[0]))
    for count in (20, 200):
        move(desk, points, count * FRAME_S)
        desk.report[f"files_after_{count}"] = open_files()
    desk.dock.draw.trigger()
    desk.rest_mouse()
    session.set_inputs(inputs)


def move(desk: Desk, points: Iterator[Point], seconds: float) -> None:
    """Move the mouse from point to point."""
    end = time.perf_counter() + seconds
    while time.perf_counter() < end:
        QTest.mouseMove(desk.canvas.viewport(), desk.pixel(next(points)))
        desk.pause(FRAME_S)


def open_files() -> int:
    """How many files this process has open."""
    return len(list(Path("/proc/self/fd").iterdir()))


def add_seams(desk: Desk, mosaic: QgsRasterLayer) -> QgsVectorLayer:
    """Seams across the mosaic."""
    box = mosaic.extent()
    seams = QgsVectorLayer(f"LineString?crs={mosaic.crs().authid()}", "seams", "memory")
    lines = []
    for share in (0.2, 0.35, 0.5, 0.65, 0.8):
        y = box.yMinimum() + share * box.height()
        line = QgsFeature()
        line.setGeometry(QgsGeometry.fromPolylineXY([QgsPointXY(box.xMinimum(), y), QgsPointXY(box.xMaximum(), y)]))
        lines.append(line)
    seams.dataProvider().addFeatures(lines)
    desk.project.addMapLayer(seams)
    return seams


def place(desk: Desk, mosaic: QgsRasterLayer, seams: QgsVectorLayer) -> None:
    """Hundreds of windows along the seams."""
    session, side = desk.session, 128 * mosaic.rasterUnitsPerPixelX()
    session.set_inputs(replace(session.inputs, seamlines=seams.id(), side_m=side, spacing_m=side / 2))
    before = len(session.windows())
    session.place_windows()
    desk.wait(lambda: len(session.windows()) > before and not session.is_busy, 60, "windows placed")
    desk.pause(0.5)
    desk.project.removeMapLayer(seams.id())  # QGIS asks before it forgets one in memory
