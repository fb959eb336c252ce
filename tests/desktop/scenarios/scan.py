"""A real mosaic is scanned from the dock, and the worst places are judged.

Parameters: ``brighton`` and ``screenshots`` (folders), ``mosaic`` (name), ``piece_m``, ``seamlines`` (whether given).
"""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from qgis.core import QgsRectangle
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QPushButton
from qgis.utils import iface

from demo.desk import Desk
from demo.gaps import Gaps

SIDE_M = 7.0  # 256 px


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    shots, name = Path(desk.parameters["screenshots"]), desk.parameters["mosaic"]
    desk.set_up(Path(desk.parameters["brighton"]), SIDE_M, SIDE_M, mosaic=name)
    seamlines = desk.session.inputs.seamlines
    if not desk.parameters["seamlines"]:
        desk.project.removeMapLayer(seamlines)
    desk.session.set_inputs(
        replace(
            desk.session.inputs, piece_m=desk.parameters["piece_m"],
            seamlines=seamlines if desk.parameters["seamlines"] else "",
        )
    )
    desk.wait(lambda: desk.session.mosaic_grid() is not None, 20, "mosaic open")
    desk.pause(1)
    scan(desk)
    desk.wait_for_map()
    desk.screenshot(shots / f"scan_{name}_found.png")
    judge_worst(desk)
    desk.wait_for_map()
    desk.rest_mouse()
    desk.screenshot(shots / f"scan_{name}_worst.png")
    desk.drop_changes()


def scan(desk: Desk) -> None:
    """Scan by the dock's own button, stopped once and gone on."""
    scans, bar = desk.dock.scans, desk.dock.scan_progress
    found, formats = [], []
    scans.found.connect(found.append)
    scans.changed.connect(lambda: formats.append(bar.format()))
    with Gaps() as gaps:
        desk.dock.scan.trigger()
        desk.wait(lambda: found or (scans.is_busy and scans.news.share > 0), 60, "a block")
        if scans.is_busy:
            desk.report["stop_enabled"] = desk.dock.stop.isEnabled()
            desk.dock.stop.trigger()
        desk.wait(lambda: not scans.is_at_work, 60, "the scan stopped")
    if not found:
        desk.report["bar_hidden"] = bar.isHidden()
    with Gaps() as later:
        if not found:
            desk.dock.scan.trigger()
        desk.wait(lambda: found, 120, "the scan's end")
        desk.pause(1)
    desk.report["gap_ms"] = 1000 * max(gaps.longest_s, later.longest_s)
    desk.report["work_ms"] = 1000 * max(gaps.longest_work_s, later.longest_work_s)
    desk.report["gaps"] = gaps.long_ones + later.long_ones
    done = found[0]
    desk.report["metres"], desk.report["failed"] = done.seam_metres, done.failed_metres
    desk.report["worst_count"], desk.report["layers"] = done.worst_count, titles(desk)[:4]
    desk.report["formats"] = sorted(set(formats))
    desk.report["messages"] = [item.text() for item in iface.messageBar().items()]


def judge_worst(desk: Desk) -> None:
    """Judge by the button in the message bar; then the key N leads from one to the next."""
    button = next(
        button for item in iface.messageBar().items() for button in item.findChildren(QPushButton)
        if button.text().startswith("Judge")
    )
    with Gaps() as gaps:
        button.click()
        windows = desk.session.windows
        desk.wait(lambda: windows() and all(row.verdict for row in windows()), 120, "verdicts")
        desk.pause(0.5)
    desk.report["judge_gap_ms"], desk.report["judge_work_ms"] = 1000 * gaps.longest_s, 1000 * gaps.longest_work_s
    desk.report["judge_gaps"] = gaps.long_ones
    desk.report["first"] = [desk.session.row(fid).window_id for fid in desk.session.selected()]
    walked = []
    with desk.judging():
        for _ in range(min(3, len(desk.session.windows()) - 1)):
            desk.press_on_map(Qt.Key.Key_V)
            walked += [desk.session.row(fid).window_id for fid in desk.session.selected()]
            desk.report.setdefault("in_view", []).append(in_view(desk))
    desk.report["walked"] = walked


def in_view(desk: Desk) -> bool:
    """Whether the map shows the middle of the selected window."""
    (fid,) = desk.session.selected()
    return bool(desk.canvas.extent().contains(QgsRectangle(*desk.session.row(fid).extent).center()))


def titles(desk: Desk) -> list[str]:
    """Names of all layers, the topmost first."""
    return [node.name() for node in desk.project.layerTreeRoot().findLayers()]
