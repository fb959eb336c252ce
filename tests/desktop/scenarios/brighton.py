"""Eight sources and 100 windows: how smoothly the desk works, and how soon a curve follows a click.

Parameters: ``brighton`` and ``block`` (folders; the latter may be empty), ``screenshots`` (folder).
"""
from __future__ import annotations

import statistics
import time
from pathlib import Path

from demo.desk import Desk, Gaps

WINDOWS = 100
CLICKS = 10


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    run_hundred(desk)
    desk.screenshot(Path(desk.parameters["screenshots"]) / "brighton.png")
    if desk.parameters["block"]:
        desk.new_project()
        time_clicks(desk)


def run_hundred(desk: Desk) -> None:
    """Windows along the seams, and a few by click until there are 100."""
    desk.set_up(Path(desk.parameters["brighton"]), 3.8, 1.9, mosaic="mosaic_feather0p4m")
    session = desk.session
    desk.report["sources"] = len(session.inputs.sources)
    start = time.perf_counter()
    with Gaps() as placing:
        desk.dock.place.trigger()
        desk.wait(lambda: session.windows(), 60, "windows placed")
    desk.report["placed"] = len(session.windows())
    desk.report["placing_s"] = time.perf_counter() - start
    desk.report["placing_gap_ms"] = 1000 * placing.longest
    desk.report["placing_gaps"] = placing.long_ones
    desk.wait_for_work()
    desk.dock.draw.trigger()
    extent, missing = session.mosaic_layer().extent(), WINDOWS - len(session.windows())
    for number in range(missing):
        before = len(session.windows())
        x = extent.xMinimum() + (0.3 + 0.4 * number / missing) * extent.width()
        desk.click((x, extent.center().y()))
        desk.wait(lambda count=before: len(session.windows()) == count + 1, 10, "window by click")
    desk.dock.draw.trigger()
    desk.wait_for_work()
    session.select([session.windows()[0].fid])
    desk.pause(1)
    start = time.perf_counter()
    with Gaps() as gaps:
        session.inspect([row.fid for row in session.windows()])
        desk.wait(lambda: not session.is_busy, 120, "100 windows inspected")
        seconds = time.perf_counter() - start
        desk.pause(0.5)
    desk.report["windows"] = len(session.windows())
    desk.report["inspected"] = sum(bool(row.verdict) for row in session.windows())
    desk.report["results"] = sum(session.result(row.fid) is not None for row in session.windows())
    desk.report["run_s"] = seconds
    desk.report["gap_ms"] = 1000 * gaps.longest
    desk.report["gaps"] = gaps.long_ones
    desk.wait_for_map()


def time_clicks(desk: Desk) -> None:
    """Windows of 1024 px with two sources: seconds from the release of the button to the curve on the screen."""
    desk.set_up(Path(desk.parameters["block"]), 100, 100)
    session = desk.session
    desk.dock.draw.trigger()
    times, counts = [], []
    for point in two_source_points(desk):
        before = len(session.windows())
        desk.click(point)
        start = time.perf_counter()
        desk.wait(lambda count=before: shown(desk, count + 1), 30, "curve of a clicked window")
        times.append(time.perf_counter() - start)
        counts.append(session.row(session.selected()[0]).sources)
        desk.wait_for_work()
    desk.dock.draw.trigger()
    desk.report["clicks"] = len(times)
    desk.report["click_s"] = statistics.median(times[1:])  # the first one loads matplotlib and reads from the disk
    desk.report["first_click_s"] = times[0]
    desk.report["click_sources"] = counts


def two_source_points(desk: Desk) -> list[tuple[float, float]]:
    """Along the seams, where a standard window has just two sources."""
    from seam_inspector.plugin.gui.window_tool import clicked_window

    session, grid = desk.session, desk.session.mosaic_grid()
    extent = session.mosaic_layer().extent()
    points = []
    for row in range(1, 40):
        for column in range(1, 40):
            point = (
                extent.xMinimum() + column / 40 * extent.width(), extent.yMinimum() + row / 40 * extent.height()
            )  # fmt: skip
            if session.source_count_over(clicked_window(grid, point, session.inputs)) == 2:
                points.append(point)
    assert len(points) >= CLICKS
    return points[:: len(points) // CLICKS][:CLICKS]


def shown(desk: Desk, count: int) -> bool:
    """Whether the last of so many windows has its curve on the screen."""
    selected = desk.session.selected()
    return len(selected) == 1 and len(desk.session.windows()) == count and desk.curves_of(selected[0])
