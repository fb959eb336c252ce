"""A folder handed over by somebody else, with links and edited files by the names that the desk gives to its own."""
from __future__ import annotations

import json
import os
from dataclasses import fields
from pathlib import Path
from typing import Any

import pytest
from qgis.core import (
    QgsFeatureRequest,
    QgsGeometry,
    QgsLineString,
    QgsPolygon,
    QgsProject,
    QgsVectorLayer,
)
from qgis.PyQt.QtCore import QObject
from seam_inspector.plugin.imagery.record_store import RecordFolder
from seam_inspector.plugin.resolution.line_layers import create_bar_layer
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs, load_inputs
from seam_inspector.plugin.seams.desk.judging import JudgingSettings, load_judging
from seam_inspector.plugin.seams.desk.mosaic_scans import _is_ours
from seam_inspector.plugin.seams.desk.unsaved_windows import _KIND, UnsavedWindows, left_by
from seam_inspector.plugin.seams.desk.windows.windows_mosaic import KnownMosaic, _known
from seam_inspector.plugin.seams.jobs import ScanFiles
from seam_inspector.plugin.toolkit.geopackages import free_path

from tests.numbers.synthetic import UTM33, wkt
from tests.qgis.scenes import layer, saved, windows
from tests.qgis.seams.desk.session_desk import Desk

OUTSIDE = ("/etc/passwd", "../outside", "/vsicurl/http://127.0.0.1:9/x")
WKB = "01" + "03000000" + "01000000" + "ffffff7f"  # a polygon whose ring says that it has two thousand million points
BAD: tuple[Any, ...] = (
    {"number": float("inf"), "wkb": None, "values": {}, "stale": False},
    {"number": 10**400, "wkb": None, "values": {}, "stale": False},
    {"number": 7, "wkb": None, "values": [[1, 2]], "stale": False},
    {"number": "../outside", "wkb": None, "values": {}, "stale": False},
    {"number": 8, "wkb": 5, "values": {}, "stale": False},
    [], None, 3,
)  # fmt: skip
ODD = {"number": 9, "wkb": WKB, "values": {"remark": OUTSIDE[0], "mosaic": [1], "confidence": 2**70}, "stale": 1}


def test_what_was_not_saved_brings_words_and_names_no_file(desk: Desk, tmp_path: Path) -> None:
    outside = tmp_path / "outside"
    outside.write_text("mine")
    desk.add()
    assert desk.layer().commitChanges()
    assert desk.project.write(str(tmp_path / "project.qgz"))
    desk.project.clear()
    (found,) = tmp_path.glob("windows*.gpkg")
    kept = RecordFolder(found.with_name(f"{found.name}.unsaved"), _KIND)
    kept.files.save("project", str(outside).encode())
    for place, record in enumerate((*BAD, ODD)):
        kept.files.save(f"outside{place}", json.dumps(record).encode())
    kept.files.save("deep", b"[" * 100_000)
    kept.close()
    desk.project.setPresetHomePath("")
    assert desk.project.read(str(tmp_path / "project.qgz"))
    desk.wait_for_opening()
    assert set(desk.rows()) in ({1}, {1, 9})
    assert outside.read_text() == "mine"
    desk.layer().rollBack()


def test_many_windows_are_written_in_one_go_as_the_layer_is_left(
    qgis_app: object, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """QGIS goes through all that was added each time it is asked: a few at a time would take the square of the time."""
    places = saved(windows(*[(0, 0, 64, 64)] * 60, window_id=("integer", list(range(60)))), tmp_path / "windows.gpkg")
    opened = QgsVectorLayer(str(places), "windows", "ogr")
    opened.startEditing()
    owner = QObject()
    unsaved = UnsavedWindows(opened, tmp_path / "windows.gpkg.unsaved", lambda layer, number: False, owner)
    asked: list[object] = []
    for one in opened.getFeatures():
        opened.changeAttributeValue(one.id(), opened.fields().indexOf("window_id"), 100 + one.id())

    def counted(request: QgsFeatureRequest) -> Any:
        asked.append(request)
        return QgsVectorLayer.getFeatures(opened, request)

    monkeypatch.setattr(opened, "getFeatures", counted)
    unsaved.close()
    assert len(asked) == 1
    left = left_by(tmp_path / "windows.gpkg.unsaved")
    assert left is not None
    assert left.unsaved == 120  # 60 that are no more, and 60 with other numbers


@pytest.mark.skipif(os.name == "nt", reason="links and pipes of POSIX")
def test_links_by_the_names_of_our_own_files_are_not_followed(qgis_app: object, tmp_path: Path) -> None:
    home, outside = tmp_path / "home", tmp_path / "outside"
    home.mkdir()
    for name in ("windows.gpkg", "bar_groups.gpkg", "a.gpkg.unsaved"):
        (home / name).symlink_to(outside)
    os.mkfifo(home / "b.gpkg.unsaved")
    assert free_path(home, "windows").name == "windows_2.gpkg"
    made = create_bar_layer(wkt(UTM33), home)
    assert "bar_groups_2.gpkg" in made.source()
    assert left_by(home / "a.gpkg.unsaved") is None
    assert left_by(home / "b.gpkg.unsaved") is None
    assert not outside.exists()


@pytest.mark.skipif(os.name == "nt", reason="links of POSIX")
def test_a_scan_takes_no_names_that_are_taken(tmp_path: Path) -> None:
    """Nobody is asked where a scan of the desk goes, so that nobody has to lose a file by it."""
    files = ScanFiles(tmp_path / "a_loss.tif", tmp_path / "a_scan.gpkg", tmp_path / "a_loss_so_far.tif")
    assert _is_ours(files)
    for name in (files.picture, files.layers, files.so_far):
        name.symlink_to(tmp_path / "outside")
        assert not _is_ours(files)
        name.unlink()
    files.picture.write_bytes(b"somebody else's")
    assert not _is_ours(files)
    files.picture.with_name("a_loss.tif.scan").mkdir()
    assert _is_ours(files)


@pytest.mark.parametrize("noted", [b"[" * 100_000, b"{", b"[1, 2]", b'["a"]', b"7", b'{"path": "a"}', b"\xff"])
def test_a_mosaic_that_somebody_else_noted_is_none(noted: bytes) -> None:
    assert _known(noted) is None
    assert _known(b'["a.tif", "b"]') == KnownMosaic("a.tif", "b")


@pytest.mark.parametrize("value", [10**300, 10**390, -(10**390), 1e308, float("nan"), float("-inf")])
def test_numbers_that_no_box_can_show_are_no_settings(qgis_app: object, value: float) -> None:
    project = QgsProject()
    for key, kind in (("inputs", Inputs), ("judging", JudgingSettings)):
        project.writeEntry("SeamInspector", key, json.dumps(dict.fromkeys([one.name for one in fields(kind)], value)))
    assert load_inputs(project) == Inputs()
    assert load_judging(project) == JudgingSettings()


def test_a_window_of_coordinates_that_are_no_numbers_has_no_outline(desk: Desk) -> None:
    nowhere = QgsGeometry(QgsPolygon(QgsLineString([float("nan")] * 4, [float("nan")] * 4)))
    desk.use(layer("Polygon", [nowhere]))
    assert [row.extent for row in desk.rows().values()] == [None]
