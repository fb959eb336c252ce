"""Eight real sources and 100 windows along the seams, their looks on the map, and how soon a curve follows a click.

Parameters: ``brighton`` and ``block`` (folders; the latter may be empty), ``screenshots`` (folder).
"""
from __future__ import annotations

import statistics
import time
from dataclasses import replace
from pathlib import Path

from qgis.gui import QgsMessageBarItem
from qgis.PyQt.QtCore import Qt
from qgis.utils import iface

from demo.desk import Desk
from demo.gaps import Gaps
from tests.desktop.scenarios import dense

MOSAIC = "mosaic_feather0p4m"
SIDE_M, SPACING_M = 1.9, 2.2  # 64 px: larger windows would share too many pixels for 100 of them to have room
CLICK_SIDE_M = 100  # 1024 px of the demonstration block
CLICKS = 10


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    folder, shots = Path(desk.parameters["brighton"]), Path(desk.parameters["screenshots"])
    desk.set_up(folder, SIDE_M, SPACING_M, mosaic=MOSAIC)
    # Of so small a window there is too little ground to judge its seam by.
    desk.session.set_inputs(replace(desk.session.inputs, reference="sources"))
    desk.report["sources"] = len(desk.session.inputs.sources)
    place(desk)
    inspect(desk)
    dense.look(desk, shots)
    judge(desk)
    desk.screenshot(shots / "brighton.png")
    desk.save_and_reopen()
    desk.report["reopened"] = len(desk.session.windows())
    desk.report["stale"] = sum(row.stale for row in desk.session.windows())
    desk.report["judged"] = [row.observer for row in desk.session.windows() if row.observer]
    if desk.parameters["block"]:
        time_clicks(desk, Path(desk.parameters["block"]))


def place(desk: Desk) -> None:
    """Place windows by the dock's own button."""
    session = desk.session
    start = time.perf_counter()
    with Gaps() as gaps:
        desk.dock.place.trigger()
        desk.wait(lambda: session.windows() and not session.is_busy, 30, "windows placed")
    desk.report["placed"] = len(session.windows())
    desk.report["placing_s"] = time.perf_counter() - start
    desk.report["placing_gap_ms"], desk.report["placing_gaps"] = 1000 * gaps.longest_s, gaps.long_ones
    desk.wait_for_work()


def inspect(desk: Desk) -> None:
    """All of them, by the dock's own button; the event loop never stalls."""
    session = desk.session
    session.select([session.windows()[0].fid])
    desk.pause(1)
    iface.messageBar().clearWidgets()
    before = iface.messageBar().findChildren(QgsMessageBarItem)  # taken away, and deleted when this play ends
    start = time.perf_counter()
    with Gaps() as gaps:
        desk.dock.inspect.trigger()
        desk.wait(lambda: all(row.verdict for row in session.windows()), 60, "all windows inspected")
        desk.report["run_s"] = time.perf_counter() - start
        desk.pause(0.5)
    desk.wait_for_work()
    said = [one for one in iface.messageBar().findChildren(QgsMessageBarItem) if one not in before]
    desk.report["said_over_the_map"] = len(said)
    desk.report["results"] = sum(session.result(row.fid) is not None for row in session.windows())
    desk.report["verdicts"] = sorted({row.verdict for row in session.windows()})
    desk.report["compared"] = sum(row.verdict != "not_comparable" for row in session.windows())
    desk.report["gap_ms"], desk.report["gaps"] = 1000 * gaps.longest_s, gaps.long_ones


def judge(desk: Desk) -> None:
    """The first window that was compared, by the key V."""
    session = desk.session
    fid = next(row.fid for row in session.windows() if row.verdict != "not_comparable")
    desk.dock.zoom_to(fid)
    desk.wait(lambda: desk.curves_of(fid), 20, "curve of the window to judge")
    desk.report["sentence"] = desk.dock.judge.sentence()
    with desk.judging():
        desk.press_on_map(Qt.Key.Key_V)
    assert session.row(fid).observer == "visible"
    assert session.selected() != [fid], "the next window"
    session.select([fid])
    desk.rest_mouse()


def time_clicks(desk: Desk, block: Path) -> None:
    """Windows of 1024 px with two sources: seconds from the release of the button to the curve on the screen.

    In the demonstration block, since the real mosaic has holes wherever such a window could lie.
    """
    desk.new_project()
    desk.set_up(block, CLICK_SIDE_M, CLICK_SIDE_M)
    session = desk.session
    desk.dock.draw.trigger()
    times, sizes = [], set()
    for point in two_source_points(desk):
        before = len(session.windows())
        desk.click(point, Qt.KeyboardModifier.ControlModifier)  # also where there is a window already
        start = time.perf_counter()
        desk.wait(lambda count=before + 1: shown(desk, count), 20, "curve of a clicked window")
        times.append(time.perf_counter() - start)
        desk.wait(lambda: not session.is_busy, 20, "idle after a click")
        result = session.result(session.selected()[0])
        sizes.add((result.window.width, result.window.height, result.source_count))
        desk.pause(0.2)
    desk.dock.draw.trigger()
    desk.report["clicks"], desk.report["clicked"] = len(times), sorted(sizes)
    desk.report["click_s"] = statistics.median(times[1:])  # the first one reads from the disk
    desk.report["first_click_s"] = times[0]


def two_source_points(desk: Desk) -> list[tuple[float, float]]:
    """Where a standard window has just two sources."""
    from seam_inspector.plugin.seams.desk.map.window_tool import clicked_window

    session, grid = desk.session, desk.session.mosaic_grid()
    extent = session.mosaic_layer().extent()
    points = []
    for row in range(1, 40):
        for column in range(1, 40):
            point = (
                extent.xMinimum() + column / 40 * extent.width(), extent.yMinimum() + row / 40 * extent.height()
            )  # fmt: skip
            if len(session.block().sources_over(clicked_window(grid, point, session.inputs))) == 2:
                points.append(point)
    assert len(points) >= CLICKS
    return points[:: len(points) // CLICKS][:CLICKS]


def shown(desk: Desk, count: int) -> bool:
    """Whether the last of so many windows has its curve on the screen."""
    selected = desk.session.selected()
    return len(selected) == 1 and len(desk.session.windows()) == count and desk.first_curves_of(selected[0])
