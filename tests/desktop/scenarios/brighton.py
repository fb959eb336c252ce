"""Eight real sources and 100 windows along the seams, and their looks on the map.

Parameters: ``brighton``, ``screenshots`` (folders).
"""
from __future__ import annotations

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
