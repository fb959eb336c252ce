"""A mosaic is scanned from the dock, the worst places are judged, and the delivery is decided on.

Parameters: ``folder`` (of images, mosaic and seamlines), ``mosaic`` (name), ``side_m``, ``screenshots`` (folder);
``piece_m`` and ``seamlines`` (whether given) where they are wanted.
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


def play(desk: Desk) -> None:
    """All that is measured is in the report."""
    shots, name = Path(desk.parameters["screenshots"]), desk.parameters["mosaic"]
    side_m = desk.parameters["side_m"]
    desk.set_up(Path(desk.parameters["folder"]), side_m, side_m, mosaic=name)
    seamlines, inputs = desk.session.inputs.seamlines, desk.session.inputs
    inputs = replace(inputs, piece_m=desk.parameters.get("piece_m", inputs.piece_m))
    if not desk.parameters.get("seamlines"):
        desk.project.removeMapLayer(seamlines)
        inputs = replace(inputs, seamlines="")
    desk.session.set_inputs(inputs)
    desk.wait(lambda: desk.session.mosaic_grid() is not None, 20, "mosaic open")
    desk.pause(1)
    scan(desk)
    judge_worst(desk)
    desk.wait_for_map()
    desk.rest_mouse()
    desk.screenshot(shots / f"scan_{name}_worst.png")
    accept(desk)
    desk.drop_changes()


def scan(desk: Desk) -> None:
    """Scan by the dock's own button, stopped once and gone on."""
    scans, bar, ends = desk.dock.scans, desk.dock.progress.parentWidget(), []
    scans.scanned.connect(ends.append)
    with Gaps() as gaps:
        desk.dock.scan.trigger()
        desk.wait(lambda: ends or (scans.news is not None and scans.news.share > 0), 60, "a block")
        if scans.is_at_work:
            desk.report["stop_enabled"] = desk.dock.stop.isEnabled()
            desk.dock.stop.trigger()
        desk.wait(lambda: not scans.is_at_work, 60, "the scan stopped")
        if not ends:
            desk.report["bar_hidden"] = bar.isHidden()
            desk.dock.scan.trigger()
        desk.wait(lambda: ends, 120, "the scan's end")
        desk.pause(1)
    gaps.note(desk.report, "scan")
    (seams,) = desk.project.mapLayersByName("Seams")
    metres = [(row["length"], row["state"]) for row in seams.getFeatures()]
    desk.report["metres"] = sum(length for length, _ in metres)
    desk.report["failed"] = sum(length for length, state in metres if state == "failed")
    layers = desk.project.layerTreeRoot().findLayers()  # the topmost first
    desk.report["worst_count"], desk.report["layers"] = ends[0].worst_count, [node.name() for node in layers][:4]


def judge_worst(desk: Desk) -> None:
    """Judge by the button in the message bar, which begins judging; then a key leads from one to the next."""
    button = next(
        button for item in iface.messageBar().items() for button in item.findChildren(QPushButton)
        if button.text().startswith("Judge")
    )
    with Gaps() as gaps:
        button.click()
        windows = desk.session.windows
        desk.wait(lambda: windows() and all(row.verdict for row in windows()), 120, "verdicts")
        desk.pause(0.5)
    gaps.note(desk.report, "judge")
    desk.report["first"] = [desk.session.row(fid).window_id for fid in desk.session.selected()]
    walked, in_sight = [], []
    assert desk.dock.judging.is_on
    with desk.judging():
        for _ in range(min(3, len(desk.session.windows()) - 1)):
            desk.press_on_map(Qt.Key.Key_V)
            walked += [desk.session.row(fid).window_id for fid in desk.session.selected()]
            in_sight.append(in_view(desk))
    desk.report["walked"], desk.report["in_view"] = walked, in_sight


def accept(desk: Desk) -> None:
    """Decide by the limits that are suggested, and save what was made."""
    from seam_inspector.plugin.seams.desk.accept_page import AcceptPage

    papers = desk.folder / "papers"
    papers.mkdir()
    desk.dock.accept.trigger()
    (page,) = desk.dock.findChildren(AcceptPage)
    page.decide()
    desk.wait(page.decider.isEnabled, 60, "decided")
    desk.report["decided"] = page.verdict.text()
    page.save(papers)
    desk.report["papers"] = sorted(path.name for path in papers.iterdir())
    page.close()


def in_view(desk: Desk) -> bool:
    """Whether the map shows the middle of the selected window."""
    (fid,) = desk.session.selected()
    return bool(desk.canvas.extent().contains(QgsRectangle(*desk.session.row(fid).extent).center()))
