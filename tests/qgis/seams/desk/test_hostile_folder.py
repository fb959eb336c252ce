"""A folder handed over by somebody else, with links and edited files by the names that the desk gives to its own."""
from __future__ import annotations

import json
import os
from dataclasses import fields
from pathlib import Path

import pytest
from qgis.core import QgsProject
from seam_inspector.plugin.resolution.line_layers import create_bar_layer
from seam_inspector.plugin.seams.desk.inputs.project_inputs import Inputs, load_inputs
from seam_inspector.plugin.seams.desk.judging import JudgingSettings, load_judging
from seam_inspector.plugin.seams.desk.mosaic_scans import _is_ours
from seam_inspector.plugin.seams.jobs import ScanFiles
from seam_inspector.plugin.seams.tables.window_file import count_windows
from seam_inspector.plugin.toolkit.geopackages import free_path

from tests.numbers.synthetic import UTM33, wkt


@pytest.mark.skipif(os.name == "nt", reason="links and pipes of POSIX")
def test_links_by_the_names_of_our_own_files_are_not_followed(qgis_app: object, tmp_path: Path) -> None:
    home, outside = tmp_path / "home", tmp_path / "outside"
    home.mkdir()
    for name in ("windows.gpkg", "bar_groups.gpkg"):
        (home / name).symlink_to(outside)
    os.mkfifo(home / "windows_3.gpkg")
    assert free_path(home, "windows").name == "windows_2.gpkg"
    made = create_bar_layer(wkt(UTM33), home)
    assert "bar_groups_2.gpkg" in made.source()
    assert count_windows(home / "windows.gpkg") is None
    assert count_windows(home / "windows_3.gpkg") is None
    assert not outside.exists()


@pytest.mark.skipif(os.name == "nt", reason="links of POSIX")
def test_a_scan_takes_no_names_that_are_taken(tmp_path: Path) -> None:
    """Nobody is asked where a scan of the desk goes, so that nobody has to lose a file by it."""
    files = ScanFiles(tmp_path / "a_loss.tif", tmp_path / "a_scan.gpkg")
    assert _is_ours(files)
    for name in (files.picture, files.layers):
        name.symlink_to(tmp_path / "outside")
        assert not _is_ours(files)
        name.unlink()
    files.picture.write_bytes(b"somebody else's")
    assert not _is_ours(files)
    files.picture.with_name("a_loss.tif.scan").mkdir()
    assert _is_ours(files)


@pytest.mark.parametrize("value", [10**300, 10**390, -(10**390), 1e308, float("nan"), float("-inf")])
def test_numbers_that_no_box_can_show_are_no_settings(qgis_app: object, value: float) -> None:
    project = QgsProject()
    for key, kind in (("inputs", Inputs), ("judging", JudgingSettings)):
        project.writeEntry("SeamInspector", key, json.dumps(dict.fromkeys([item.name for item in fields(kind)], value)))
    assert load_inputs(project) == Inputs()
    assert load_judging(project) == JudgingSettings()
