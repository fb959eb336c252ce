"""Windows judged by keys until the process kills itself, and the project as its operator finds it afterwards.

Parameters: ``brighton``, ``screenshots``, ``home`` (folders), ``part``: ``judge`` (a saved project, ended by SIGKILL),
``reopen`` (the same project), ``unsaved`` (one without a file).
"""
from __future__ import annotations

import json
import os
import signal
import time
from dataclasses import replace
from pathlib import Path

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import Qt
from qgis.utils import iface

from demo.desk import Desk
from demo.gaps import Gaps

JUDGED = 30
SIDE_M, SPACING_M = 1.9, 2.2


def play(desk: Desk) -> None:
    """One part."""
    home = Path(desk.parameters["home"])
    {"judge": judge, "reopen": reopen, "unsaved": unsaved}[desk.parameters["part"]](desk, home)


def judge(desk: Desk, home: Path) -> None:
    """Ends by SIGKILL."""
    desk.set_up(Path(desk.parameters["brighton"]), SIDE_M, SPACING_M, mosaic="mosaic_feather0p4m")
    desk.session.set_inputs(replace(desk.session.inputs, reference="sources"))
    assert desk.project.write(str(home / "project.qgz"))
    work(desk, home)
    os.kill(os.getpid(), signal.SIGKILL)


def unsaved(desk: Desk, home: Path) -> None:
    """In a project without a file; the windows are offered when QGIS forgot the project."""
    desk.set_up(Path(desk.parameters["brighton"]), SIDE_M, SPACING_M, mosaic="mosaic_feather0p4m")
    desk.session.set_inputs(replace(desk.session.inputs, reference="sources"))
    desk.dock.place.trigger()
    desk.wait(lambda: desk.session.windows() and not desk.session.is_busy, 30, "windows placed")
    desk.pause(1)
    desk.screenshot(Path(desk.parameters["screenshots"]) / "unsaved.png")
    layer = desk.session.window_layer()
    assert desk.project.write(str(home / "project.qgz"))
    desk.pause(1)
    desk.screenshot(Path(desk.parameters["screenshots"]) / "moved.png")
    assert Path(layer.source().split("|")[0]).parent == home
    desk.drop_changes()
    # QGIS would ask before it ends
    desk.wait(lambda: not QgsApplication.taskManager().countActiveTasks(), 60, "the end of all tasks")


def work(desk: Desk, home: Path) -> None:
    """Places, inspects and judges; what was judged is told in a file."""
    session = desk.session
    desk.dock.place.trigger()
    desk.wait(lambda: session.windows() and not session.is_busy, 30, "windows placed")
    with Gaps() as gaps:
        desk.dock.inspect.trigger()
        desk.wait(lambda: all(row.verdict for row in session.windows()), 120, "all windows inspected")
        desk.wait_for_work()
    compared = [row.fid for row in session.windows() if row.verdict != "not_comparable"]
    session.select(compared[:1])
    keys = [Qt.Key.Key_V, Qt.Key.Key_I]
    start = time.perf_counter()
    with Gaps() as judging:
        for turn in range(JUDGED):
            session.select([compared[turn]])
            desk.press(keys[turn % 2])
    kept = list(home.glob("*.gpkg*"))
    told = {
        "judged": {str(row.window_id): row.observer for row in session.windows() if row.observer},
        "verdicts": {str(row.window_id): row.verdict for row in session.windows()},
        "seconds": time.perf_counter() - start,
        "inspecting_gap_ms": 1000 * gaps.longest_s,
        "judging_gap_ms": 1000 * judging.longest_s,
        "bytes": {path.name: path.stat().st_size for path in kept},
    }
    (home / "told.json").write_text(json.dumps(told))


def reopen(desk: Desk, home: Path) -> None:
    """What was judged, and its curves, without measuring again."""
    told = json.loads((home / "told.json").read_text())
    desk.open_dock()
    start = time.perf_counter()
    iface.addProject(str(home / "project.qgz"))
    session = desk.session
    desk.wait(lambda: len(session.windows()) == len(told["verdicts"]), 30, "windows back")
    desk.report["reopening_s"] = time.perf_counter() - start
    desk.wait(lambda: session.mosaic_grid() is not None, 20, "mosaic open")
    rows = session.windows()
    assert {str(row.window_id): row.observer for row in rows if row.observer} == told["judged"]
    assert {str(row.window_id): row.verdict for row in rows} == told["verdicts"]
    assert not any(row.stale for row in rows)
    assert not session.is_busy
    (fid,) = [row.fid for row in rows if row.window_id == int(next(iter(told["judged"])))]
    desk.pause(0.5)
    desk.screenshot(Path(desk.parameters["screenshots"]) / "restored.png")
    with Gaps() as gaps:
        session.select([fid])
        desk.wait(lambda: desk.curves_of(fid), 20, "its curve")
    desk.report["curve_gap_ms"] = 1000 * gaps.longest_s
    desk.dock.zoom_to(fid)
    desk.wait_for_map()
    desk.rest_mouse()
    desk.screenshot(Path(desk.parameters["screenshots"]) / "reopened.png")
    measured = [row for row in rows if session.result(row.fid) is not None]
    desk.report["with curves"] = len(measured)
    desk.report["with a picture of the loss"] = sum(
        getattr(session.result(row.fid), "loss", None) is not None for row in measured
    )
    desk.report["windows"], desk.report["judged"] = len(rows), len(told["judged"])
    for name in ("seconds", "inspecting_gap_ms", "judging_gap_ms", "bytes"):
        desk.report[name] = told[name]
    desk.drop_changes()
    # QGIS would ask before it ends
    desk.wait(lambda: not QgsApplication.taskManager().countActiveTasks(), 60, "the end of all tasks")
