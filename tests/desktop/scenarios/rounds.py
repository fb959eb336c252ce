"""New project, load, Place, Inspect, again and again in one QGIS, with scans between and threads that end soon.

Parameters: ``block``, ``rounds``. The report tells the rounds whose windows had no sound reference system.
"""
from __future__ import annotations

import sqlite3
from contextlib import closing
from pathlib import Path

from qgis.PyQt.QtCore import QThreadPool

from demo.desk import Desk
from tests.desktop.scenarios.soak import scan

SIDE_M, SPACING_M = 12.8, 60.0
ENDING_MS = 100  # after which a thread of QGIS that has nothing to do ends, instead of 30 s
SCANNED = 10  # every so many rounds


def play(desk: Desk) -> None:
    """Each round ends with an empty project."""
    QThreadPool.globalInstance().setExpiryTimeout(ENDING_MS)
    desk.report |= {"rounds": 0, "unsound": []}
    for number in range(desk.parameters["rounds"]):
        desk.set_up(Path(desk.parameters["block"]), SIDE_M, SPACING_M)
        if number % SCANNED == 0:
            scan(desk)
        place(desk, number)
        desk.dock.inspect.trigger()
        desk.wait(lambda: all(row.verdict for row in desk.session.windows()), 120, "all windows inspected")
        desk.report["rounds"] += 1
        desk.new_project()


def place(desk: Desk, number: int) -> None:
    """Windows along the seams, and what system they have."""
    session = desk.session
    desk.dock.place.trigger()
    desk.wait(lambda: session.windows() and not session.is_busy, 60, "windows placed")
    desk.pause(2 * ENDING_MS / 1000)
    layer, mosaic = session.window_layer(), session.mosaic_layer()
    with closing(sqlite3.connect(layer.source().partition("|")[0])) as file:
        (code,) = file.execute("SELECT srs_id FROM gpkg_geometry_columns WHERE table_name = 'windows'").fetchone()
    if mosaic.crs().authid() != f"EPSG:{code}" or not layer.crs().toWkt() or layer.crs() != mosaic.crs():
        desk.report["unsound"].append((number, code, layer.crs().description()))
