"""Thousands of windows inspected and hundreds judged by keys in one run, with all else an operator does in between.

Parameters: ``block``, ``work``, ``screenshots`` (folders), ``windows`` (to inspect), ``judged``, ``rounds``. What is
counted after each round is in the report, and written to ``work``/rounds.jsonl as it comes.
"""
from __future__ import annotations

import ctypes
import gc
import json
import os
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any

from qgis.core import QgsApplication, QgsFeature, QgsGeometry, QgsPointXY, QgsVectorLayer
from qgis.PyQt.QtCore import QCoreApplication, QEvent, QObject, Qt
from qgis.PyQt.QtTest import QTest
from qgis.PyQt.QtWidgets import QApplication
from qgis.utils import iface

from demo.desk import Desk
from demo.gaps import Gaps

SIDE_PX, APART_M = 64, 3.2
DRAWN, TABBED = 3, 5  # windows of a round that are drawn, and looked at in every tab
SCANNED = (3, 7)  # rounds that end with a scan
STALL_S = 0.05
WORDS = (Qt.Key.Key_V, Qt.Key.Key_I, Qt.Key.Key_U)


def play(desk: Desk) -> None:
    """All that is counted and timed is in the report."""
    parameters, work = desk.parameters, Path(desk.parameters["work"])
    set_up(desk, Path(parameters["block"]), parameters["windows"])
    assert desk.project.write(str(work / "project.qgz"))
    rounds, per_round = parameters["rounds"], parameters["windows"] // parameters["rounds"]
    desk.report["rounds"] = []
    for number in range(1, rounds + 1):
        figures: dict[str, Any] = {"round": number}
        inspect(desk, per_round, figures)
        judge(desk, parameters["judged"] // rounds, figures)
        look_around(desk, figures)
        draw_and_undo(desk, figures)
        if number in SCANNED:
            scan(desk)
        figures["windows"] = sum(bool(row.verdict) for row in desk.session.windows())
        figures["judged"] = sum(bool(row.observer) for row in desk.session.windows())
        figures |= counts(desk)
        desk.report["rounds"].append(figures)
        with open(work / "rounds.jsonl", "a", encoding="utf-8") as file:
            file.write(json.dumps(figures) + "\n")
    desk.rest_mouse()
    desk.screenshot(Path(parameters["screenshots"]) / "soak.png")
    desk.drop_changes()


def set_up(desk: Desk, block: Path, windows: int) -> None:
    """Windows side by side all over the mosaic, not inspected yet; then the block's own seamlines again."""
    desk.set_up(block, 6.4, 2 * APART_M)
    session, mosaic = desk.session, desk.session.mosaic_layer()
    side = SIDE_PX * mosaic.rasterUnitsPerPixelX()
    seamlines = session.inputs.seamlines
    box, apart = mosaic.extent(), APART_M
    lines = QgsVectorLayer(f"LineString?crs={mosaic.crs().authid()}", "lines", "memory")
    features = []
    rows = min(int((box.height() - side) / apart), int(1.2 * windows * apart / box.width()) + 1)
    for row in range(rows):
        y = box.yMinimum() + side / 2 + row * apart
        line = QgsFeature()
        line.setGeometry(QgsGeometry.fromPolylineXY([QgsPointXY(box.xMinimum(), y), QgsPointXY(box.xMaximum(), y)]))
        features.append(line)
    lines.dataProvider().addFeatures(features)
    desk.project.addMapLayer(lines)
    # Of so small a window there is too little ground to judge its seam by.
    session.set_inputs(
        replace(session.inputs, seamlines=lines.id(), side_m=side, spacing_m=apart, reference="sources")
    )
    desk.dock.place.trigger()
    desk.wait(lambda: session.windows() and not session.is_busy, 300, "windows placed")
    session.set_inputs(replace(session.inputs, seamlines=seamlines))
    desk.project.removeMapLayer(lines.id())
    desk.wait(lambda: session.mosaic_grid() is not None, 60, "mosaic open again")
    assert len(session.windows()) >= windows, f"{len(session.windows())} of {windows} windows find room in the block"


@contextmanager
def timed(figures: dict[str, Any], name: str) -> Iterator[None]:
    """Stalls, and what the interface's thread worked."""
    before = time.thread_time()
    with Gaps() as gaps:
        yield
    figures[f"{name}_work_s"] = time.thread_time() - before
    figures[f"{name}_stalls"] = sum(work > STALL_S for _, work, _ in gaps.long_ones)
    figures[f"{name}_longest_ms"] = 1000 * gaps.longest_work_s
    figures.setdefault("stalled_at", []).extend(where for _, work, where in gaps.long_ones if work > STALL_S)


def inspect(desk: Desk, count: int, figures: dict[str, Any]) -> None:
    """The next windows, as many in one go."""
    session = desk.session
    fids = [row.fid for row in session.windows() if not row.verdict][:count]
    start = time.perf_counter()
    with timed(figures, "inspect"):
        session.inspect(fids)
        desk.wait(lambda: not session.is_busy, 60 + count, "windows inspected")
        desk.pause(0.5)
    figures["inspect_ms"] = 1000 * (time.perf_counter() - start) / len(fids)
    figures["inspect_work_ms"] = 1000 * figures.pop("inspect_work_s") / len(fids)


def judge(desk: Desk, count: int, figures: dict[str, Any]) -> None:
    """Judge windows by one key each; the map follows."""
    with desk.judging():
        desk.wait(lambda: desk.session.selected(), 10, "a window to judge")
        judge_by_keys(desk, count, figures)


def judge_by_keys(desk: Desk, count: int, figures: dict[str, Any]) -> None:
    """What they take is counted."""
    with timed(figures, "key"):
        for number in range(count):
            before = desk.session.selected()
            press(desk, WORDS[number % 5 % 3])
            desk.wait(lambda before=before: desk.session.selected() != before, 10, "the next window")
    figures["key_work_ms"] = 1000 * figures.pop("key_work_s") / max(count, 1)


def look_around(desk: Desk, figures: dict[str, Any]) -> None:
    """Tabs, lost detail: what an operator opens and closes."""
    session, dock = desk.session, desk.dock
    fids = [row.fid for row in session.windows() if row.verdict][-TABBED:]
    with timed(figures, "look"):
        for fid in fids:
            session.select([fid])
            dock.zoom_to(fid)
            for tab in (1, 0):
                desk.show_tab(tab)
            desk.wait(lambda fid=fid: desk.curves_of(fid), 30, "curves")
        for _ in range(2):
            session.lost_detail.trigger()
            desk.pause(0.05)
    session.select([])
    desk.show_all(session.mosaic_layer().extent())


def draw_and_undo(desk: Desk, figures: dict[str, Any]) -> None:
    """Windows are drawn by a drag each; the last one is deleted, brought back, and deleted again."""
    session = desk.session
    centre = session.mosaic_layer().extent().center()
    pixel = desk.canvas.mapUnitsPerPixel()
    with timed(figures, "draw"):
        desk.dock.draw.trigger()
        for number in range(DRAWN):
            count = len(session.windows())
            left, top = centre.x() + 40 * number * pixel, centre.y() + 40 * number * pixel
            desk.drag((left, top), (left + 80 * pixel, top - 80 * pixel))
            desk.wait(lambda count=count: len(session.windows()) == count + 1 and not session.is_busy, 60, "one drawn")
        desk.dock.draw.trigger()
        desk.rest_mouse()
        count = len(session.windows())
        for key, modifiers, left in (
            (Qt.Key.Key_Delete, Qt.KeyboardModifier.NoModifier, count - 1),
            (Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier, count),
            (Qt.Key.Key_Y, Qt.KeyboardModifier.ControlModifier, count - 1),
        ):
            table = desk.dock.windows.table
            table.setFocus()
            QTest.keyClick(table, key, modifiers)
            desk.wait(lambda left=left: len(session.windows()) == left, 20, "a window gone or back")
    session.select([])


def scan(desk: Desk) -> None:
    """The whole mosaic; what was found is taken off the project again, so that each round begins alike."""
    before = set(desk.project.mapLayers())
    items: list[object] = []
    desk.dock.scans.scanned.connect(items.append)
    desk.dock.scan.trigger()
    desk.wait(lambda: items and not desk.dock.scans.is_busy, 600, "the scan's end")
    desk.dock.scans.scanned.disconnect(items.append)
    desk.wait_for_work()
    iface.messageBar().clearWidgets()
    group = [node for node in desk.project.layerTreeRoot().findGroups() if not before & set(node.findLayerIds())]
    desk.project.removeMapLayers([layer for layer in desk.project.mapLayers() if layer not in before])
    for node in group:
        node.parent().removeChildNode(node)


def press(desk: Desk, key: Qt.Key) -> None:
    """A key over the map."""
    desk.canvas.setFocus()
    desk.wait(lambda: QApplication.focusWidget() is not None, 5, "focus in the main window")
    QTest.keyClick(QApplication.focusWidget(), key)
    desk.pause(0.05)


def settle(desk: Desk) -> None:
    """Until the map is drawn."""
    desk.pause(0.5)
    desk.wait(lambda: not desk.canvas.isDrawing(), 60, "the map drawn")


def counts(desk: Desk) -> dict[str, Any]:
    """What could grow without bound."""
    desk.wait_for_work()
    desk.wait(lambda: not QgsApplication.taskManager().countActiveTasks(), 60, "no task left")
    desk.pause(1)
    QCoreApplication.sendPostedEvents(None, int(QEvent.Type.DeferredDelete))
    gc.collect()
    trim: Callable[[int], int] | None = getattr(ctypes.CDLL(None), "malloc_trim", None)
    if trim is not None:
        trim(0)  # what is free goes back to the system, else it would be counted
    held = gc.get_objects()
    ours = Counter(type(thing).__name__ for thing in held if type(thing).__module__.startswith("seam_inspector"))
    names = [link for link in map(link_of, Path("/proc/self/fd").iterdir()) if link]
    return {
        "rss_mb": memory_mb(),
        "python_objects": len(held),
        "our_objects": sum(ours.values()),
        "most_of_ours": ours.most_common(8),
        "qt_objects": len(desk.window.findChildren(QObject)) + len(desk.canvas.findChildren(QObject)),
        "widgets": len(QApplication.allWidgets()),
        "scene_items": len(desk.canvas.scene().items()),
        "layers": desk.project.count(),
        "tasks": QgsApplication.taskManager().count(),
        "files_open": len(names),
        "databases_open": sum(name.endswith((".gpkg", ".gpkg-wal", ".gpkg-shm", ".db", ".sqlite")) for name in names),
        "threads": len(os.listdir("/proc/self/task")),
        "python_threads": threading.active_count(),
        "temporary_files": sum(len(files) for _, _, files in os.walk(os.environ["TMPDIR"])),
        "undo_steps": desk.session.steps.count(),
        "load": os.getloadavg()[0],
    }


def link_of(path: Path) -> str:
    """The path that an open file leads to; empty for one that is closed meanwhile."""
    try:
        return os.readlink(path)
    except OSError:
        return ""


def memory_mb() -> float:
    """Resident."""
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6
