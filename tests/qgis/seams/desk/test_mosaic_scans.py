"""Scan in the desk: the results come in a group, stopping and going on lose nothing."""
from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from qgis.core import Qgis, QgsApplication, QgsProject, QgsRasterLayer
from qgis.gui import QgsMessageBar
from qgis.PyQt.QtWidgets import QPushButton
from seam_inspector.plugin.seams.desk.accept_page import delivered_scans
from seam_inspector.plugin.seams.desk.mosaic_scans import scan_message
from seam_inspector.plugin.toolkit.translation import sentence

from tests.qgis.scenes import layer, line
from tests.qgis.seams.desk.scan_scene import COLUMNS, SEAM_ROW, ScanDesk, ScanScene
from tests.qgis.seams.desk.session_desk import settle, wait_for_tasks, wait_until

STATES = ["failed", "passed", "not_measured"]
SIDES = {"left_source": ("string", ["8"]), "right_source": ("string", ["1"])}
FOUND = ["Worst places", "Seams", "Source cells", "Picture of losses"]


@pytest.fixture
def desk(scan_scene: ScanScene, project: QgsProject, tmp_path: Path) -> Iterator[ScanDesk]:
    made = ScanDesk(scan_scene, tmp_path)
    yield made
    made.close()
    wait_for_tasks()
    project.clear()


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir() if path.suffix != ".xml")  # QGIS's own


def test_what_a_scan_found_lies_in_a_group_on_top(desk: ScanDesk) -> None:
    desk.use("north", "south")
    done = desk.scan()
    assert desk.titles()[:4] == FOUND
    (group,) = [node for node in desk.project.layerTreeRoot().children() if node.name() == "Scan of ortho"]
    assert [node.name() for node in group.children()] == FOUND
    assert names(desk.folder) == ["ortho_loss.tif", "ortho_scan.gpkg"]  # no journal
    seams, cells = (desk.project.mapLayersByName(name)[0] for name in ("Seams", "Source cells"))
    assert {row["verdict"] for row in seams.getFeatures()} <= {"significant", "reduced"}
    assert {row["source"] for row in cells.getFeatures()} == {"north.tif", "south.tif"}
    rows = list(seams.getFeatures())
    total, failed = (sum(row["length"] for row in rows if row["state"] in states) for states in (STATES, ["failed"]))
    assert total == pytest.approx(256, rel=0.02)
    shown = {node.name() for node in group.children() if node.itemVisibilityChecked()}
    assert shown == set(FOUND) - {"Worst places"}
    assert failed > 0.8 * total
    assert sentence(done.finding).startswith(f"{failed:.0f} of {total:.0f} m failed.")
    assert desk.messages == []


def test_a_scan_that_could_not_measure_says_so_with_names_that_no_orthoimage_has(desk: ScanDesk) -> None:
    named = layer("LineString", [line((0, SEAM_ROW), (COLUMNS, SEAM_ROW))], **SIDES)
    desk.project.addMapLayer(named)
    desk.use("north", "south", seamlines=named.id())
    bar = QgsMessageBar()
    item = scan_message(bar, desk.scan(), desk.scans.warnings, lambda: None)
    assert (item.text(), item.level()) == ("None of 256 m of seams could be measured.", Qgis.MessageLevel.Warning)
    (more,) = [button for button in item.findChildren(QPushButton) if button.text() == "More"]
    unknown = "Orthoimages that the seamline layer names and that are not given: 2 (such as 1, 8)."
    assert unknown in more.toolTip()
    assert unknown in desk.messages


def test_a_scan_of_an_unsaved_project_moves_beside_it(
    desk: ScanDesk, tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    profile, home = desk.folder, tmp_path_factory.mktemp("home")
    monkeypatch.setattr("seam_inspector.plugin.seams.desk.window_home.unsaved_folder", lambda: profile)
    desk.project.setPresetHomePath("")
    (home / "ortho_scan.gpkg").write_text("somebody else's")
    desk.use("north", "south")
    desk.scan()
    assert names(profile) == ["ortho_loss.tif", "ortho_scan.gpkg"]
    shown = {name: desk.project.mapLayersByName(name)[0] for name in FOUND}
    looks = {name: type(layer.renderer()) for name, layer in shown.items()}
    rows = [row.attributes() for row in shown["Seams"].getFeatures()]
    assert desk.project.write(str(home / "project.qgz"))
    assert names(profile) == []
    assert names(home) == ["ortho_loss.tif", "ortho_scan.gpkg", "ortho_scan_2.gpkg", "project.qgz"]
    assert {name: type(layer.renderer()) for name, layer in shown.items()} == looks
    assert [row.attributes() for row in shown["Seams"].getFeatures()] == rows
    desk.project.clear()
    assert desk.project.read(str(home / "project.qgz"))
    assert all(desk.project.mapLayersByName(name)[0].isValid() for name in FOUND)
    assert all(desk.project.mapLayersByName(name)[0].source().startswith(str(home)) for name in FOUND)


def test_stopping_keeps_what_is_done_and_starting_goes_on(desk: ScanDesk) -> None:
    desk.use("north", "south")
    desk.scans.start()
    wait_until(lambda: desk.scans.news is not None and desk.scans.news.share > 0, "for the first block")
    desk.scans.stop()
    wait_until(lambda: not desk.scans.is_at_work, "for the end")
    settle(0.1)
    assert names(desk.folder) == ["ortho_loss.tif.scan"]
    assert desk.messages == ["The work was stopped; started again with the same output it continues from here."]
    desk.messages.clear()
    desk.scan()
    assert "continues" in desk.messages[0]
    assert desk.titles()[:4] == FOUND
    assert names(desk.folder) == ["ortho_loss.tif", "ortho_scan.gpkg"]


def test_closing_the_project_stops_the_scan(desk: ScanDesk) -> None:
    desk.use("north", "south")
    desk.scans.start()
    desk.project.clear()
    assert not desk.scans.is_at_work
    wait_for_tasks()
    settle(0.2)
    assert desk.project.mapLayers() == {}
    assert desk.messages == []


def test_a_mosaic_that_is_removed_ends_its_scan_in_a_sentence(desk: ScanDesk) -> None:
    desk.use("north", "south")
    desk.scans.start()
    desk.project.removeMapLayer(desk.rasters["ortho"].id())
    wait_until(lambda: not desk.scans.is_at_work, "for the end")
    settle(0.1)
    assert desk.messages == ["The scan was stopped: its mosaic is not in the project any more."]


def test_a_mosaic_that_is_removed_and_comes_back_has_its_scan(desk: ScanDesk, scan_scene: ScanScene) -> None:
    desk.use("north", "south")
    desk.scan()
    desk.project.removeMapLayer(desk.rasters["ortho"].id())
    settle(0.1)
    assert desk.session.mosaic_grid() is None
    (back,) = desk.project.addMapLayers([QgsRasterLayer(str(scan_scene.mosaic), "ortho")])
    wait_until(lambda: desk.session.mosaic_grid() is not None, "for the mosaic")
    shown = {node.name() for node in desk.project.layerTreeRoot().findLayers() if node.isVisible()}
    assert shown == {*FOUND, *desk.rasters, "made"} - {"Worst places"}
    assert [scan.mosaic for scan in delivered_scans(desk.project, "")] == [back.id()]


def test_closing_the_desk_leaves_no_task_and_no_layer_of_its_own(desk: ScanDesk) -> None:
    desk.use("north", "south")
    desk.scans.start()
    wait_until(lambda: desk.scans.news is not None and desk.scans.news.share > 0, "for the first block")
    desk.close()
    desk.close()
    wait_for_tasks()
    settle(0.2)
    assert not QgsApplication.taskManager().activeTasks()
    assert not any("losses" in title for title in desk.titles())
    assert not desk.project.layerTreeRoot().findGroup("Scan of ortho")
    assert names(desk.folder) in (["ortho_loss.tif.scan"], ["ortho_loss.tif", "ortho_scan.gpkg"])


def test_a_folder_that_takes_no_files_is_told_in_one_sentence(desk: ScanDesk) -> None:
    desk.use("north", "south")
    desk.project.setPresetHomePath("/proc")
    assert desk.scan() is None
    assert len(desk.messages) == 1
    assert "folder" in desk.messages[0]
    assert not desk.scans.why_not()
