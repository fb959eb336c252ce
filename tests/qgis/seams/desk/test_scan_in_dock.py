"""The dock's Scan: its button, its progress, what it says in the end, and that nothing stays behind."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from qgis.core import QgsApplication, QgsProcessingContext, QgsProject, QgsVectorLayer
from qgis.gui import QgisInterface, QgsMessageBar
from qgis.PyQt.QtCore import Qt
from qgis.PyQt.QtWidgets import QPushButton
from seam_inspector.plugin.seams.desk.accept_page import AcceptPage
from seam_inspector.plugin.seams.desk.dock import InspectionDock

from tests.qgis.plugin_lives import action_of, assert_leaves_nothing
from tests.qgis.seams.desk.scan_scene import PIECE_M, ScanDesk, ScanScene
from tests.qgis.seams.desk.session_desk import settle, wait_for_tasks, wait_until
from tests.qgis.seams.desk.windows_session import filter_to


def opened(plugin: Any, scene: ScanScene, folder: Path) -> InspectionDock:
    """The plugin's dock on the mosaic and its sources."""
    action_of(plugin).trigger()
    dock: InspectionDock = plugin.desk("seamInspectorAction").dock
    desk = ScanDesk(scene, folder)
    desk.close()
    rasters = desk.rasters
    sources = tuple(rasters[name].id() for name in ("north", "south"))
    dock.session.set_inputs(
        replace(dock.session.inputs, mosaic=rasters["ortho"].id(), sources=sources, piece_m=PIECE_M, side_m=12.8)
    )
    wait_until(lambda: dock.session.mosaic_grid() is not None, "for the mosaic")
    return dock


def scan(dock: InspectionDock) -> None:
    """Scan by its button, to the end."""
    dock.scan.trigger()
    wait_until(lambda: not dock.scans.is_at_work, "for the scan")


def judge_buttons(iface: QgisInterface) -> list[QPushButton]:
    """In the message bar."""
    return [button for button in iface.messageBar().findChildren(QPushButton) if button.text().startswith("Judge")]


def test_the_button_waits_for_something_to_scan(plugin: Any, scan_scene: ScanScene, tmp_path: Path) -> None:
    action_of(plugin).trigger()
    dock = plugin.desk("seamInspectorAction").dock
    assert not dock.scan.isEnabled()
    dock = opened(plugin, scan_scene, tmp_path)
    assert dock.scan.isEnabled()
    dock.scan.trigger()
    assert not dock.scan.isEnabled()
    assert dock.stop.isEnabled()
    assert not dock.progress.parentWidget().isHidden()
    wait_until(lambda: not dock.scans.is_at_work, "for the scan")
    assert dock.scan.isEnabled()
    assert not dock.stop.isEnabled()
    assert dock.progress.parentWidget().isHidden()


def test_the_worst_places_are_inspected_and_the_first_is_shown(
    plugin: Any, qgis_iface: QgisInterface, scan_scene: ScanScene, tmp_path: Path
) -> None:
    dock = opened(plugin, scan_scene, tmp_path)
    assert not dock.worst.isEnabled()
    scan(dock)
    assert dock.worst.isEnabled()
    (button,) = judge_buttons(qgis_iface)
    assert button.text().startswith("Judge")
    button.click()
    rows = dock.session.windows
    wait_until(lambda: rows() and all(row.verdict for row in rows()), "for the verdicts")
    windows = rows()
    assert [row.window_id for row in windows] == list(range(1, len(windows) + 1))
    assert dock.session.selected() == [windows[0].fid]
    assert [row.read("origin") for row in windows] == ["scan"] * len(windows)
    assert sorted(filter_to(dock.windows, "scan")) == sorted(row.fid for row in windows)
    assert filter_to(dock.windows, "drawn") == []
    filter_to(dock.windows)
    assert dock.scans.worst_layer() is not dock.session.window_layer()
    dock.session.judge([windows[0].fid], "visible")
    by_loss = 3
    dock.windows.table.sortByColumn(by_loss, Qt.SortOrder.DescendingOrder)
    places = []
    for _ in range(2):
        dock.judge_worst()  # once more: they are there
        settle(0.1)
        (fid,) = dock.session.selected()
        places.append(dock.session.row(fid))
    worst, following = places
    assert not worst.observer
    assert 1 < worst.window_id < following.window_id
    assert dock.windows.table.horizontalHeader().sortIndicatorSection() == by_loss
    assert [row.window_id for row in rows()] == [row.window_id for row in windows]
    assert dock.steps.undo.toolTip().startswith("Undo judging window 1")
    settle(0.1)
    assert judge_buttons(qgis_iface) == []
    assert "Worst places" in dock.judge._progress.text()
    dock.judging.action.trigger()
    dock.session.leave_windows()
    settle(0.1)
    assert (dock.judging.is_on, dock.judge._progress.text(), dock.judge.sentence()) == (False, "", "")
    status: Any = qgis_iface.statusBarIface()
    assert status.method_calls[-1][0] == "clearMessage"


def test_unloading_while_it_scans_leaves_nothing(
    qgis_iface: QgisInterface, project: QgsProject, scan_scene: ScanScene, tmp_path: Path
) -> None:
    def use(plugin: Any) -> None:
        dock = opened(plugin, scan_scene, tmp_path)
        dock.scan.trigger()
        wait_until(lambda scans=dock.scans: scans.news is None or scans.news.share > 0, "for the first block")

    def no_losses() -> None:
        wait_for_tasks()
        assert not [layer for layer in project.mapLayers().values() if "losses" in layer.name()]

    assert_leaves_nothing(qgis_iface, 2, use, no_losses)


def test_a_message_that_is_shown_is_replaced_and_goes_when_it_is_so_no_more(
    monkeypatch: pytest.MonkeyPatch, qgis_iface: QgisInterface, plugin: Any
) -> None:
    bar = QgsMessageBar()
    monkeypatch.setattr(qgis_iface, "messageBar", lambda: bar)
    action_of(plugin).trigger()
    session, long = plugin.desk("seamInspectorAction").dock.session, "Many <words> " * 30
    for text in (long, "Another.", long):
        session.messageRaised.emit(text, 1)
    settle(0.1)
    assert len(bar.items()) == 2
    session.messageOutdated.emit(long)
    settle(0.1)
    assert [item.text() for item in bar.items()] == ["Another."]
    action_of(plugin).trigger()


def test_accept_opens_the_decision_on_the_scan(plugin: Any, scan_scene: ScanScene, tmp_path: Path) -> None:
    dock = opened(plugin, scan_scene, tmp_path)
    scan(dock)
    dock.accept.trigger()
    (page,) = dock.findChildren(AcceptPage)
    values = page.values()
    job = QgsApplication.processingRegistry().createAlgorithmById("seaminspector:acceptmosaic")
    assert set(values) <= {parameter.name() for parameter in job.parameterDefinitions()}
    context = QgsProcessingContext()
    context.setProject(QgsProject.instance())
    assert job.checkParameterValues({**values, "DEFECTS": "TEMPORARY_OUTPUT", "REPORT": None}, context)[0]
    (seams,) = values["SEAMS"]
    assert QgsVectorLayer(seams, "seams", "ogr").featureCount() > 0
    page.close()
