"""Fifty windows of 1024 px: how long the interface stands still while they are drawn, inspected and judged.

Parameters: ``rasters`` (the mosaic first, then its sources), ``boxes`` (windows in pixels), ``screenshots`` (folder).
"""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from demo.desk import Desk
from demo.gaps import Gaps

JUDGED = 10


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    from seam_inspector.plugin.core.windows import PixelWindow

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
        desk.wait(lambda: desk.curves_of(session.selected()[0]), 30, "curves of the first window")
    note(desk, "first", first)
    with Gaps() as drawing:
        for window in windows[1:]:
            session.add_window(window)
            desk.pause(0.05)
        desk.wait(lambda: not session.is_busy, 120, "windows drawn and inspected")
        desk.pause(0.5)
    note(desk, "drawing", drawing)
    fids = [row.fid for row in session.windows()]
    with Gaps() as inspecting:
        session.inspect(fids)
        desk.wait(lambda: not session.is_busy, 120, "windows inspected")
        desk.pause(0.5)
    note(desk, "inspecting", inspecting)
    with Gaps() as judging:
        session.inspect(fids)
        for fid in fids[:JUDGED]:
            session.select([fid])
            desk.pause(0.2)
            session.judge([fid], "visible")
            desk.pause(0.2)
        desk.wait(lambda: not session.is_busy, 120, "windows inspected while others are judged")
    note(desk, "judging", judging)
    desk.report["windows"] = len(fids)
    desk.report["inspected"] = sum(bool(row.verdict) for row in session.windows())
    session.select(fids[:1])
    desk.wait(lambda: desk.curves_of(fids[0]), 30, "curves")
    desk.screenshot(Path(desk.parameters["screenshots"]) / "stalls.png")


def note(desk: Desk, name: str, gaps: Gaps) -> None:
    """Into the report."""
    desk.report[f"{name}_gap_ms"] = 1000 * gaps.longest_s
    desk.report[f"{name}_work_ms"] = 1000 * gaps.longest_work_s
    desk.report[f"{name}_gaps"] = gaps.long_ones
