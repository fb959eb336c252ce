"""A decision is on the files that were scanned: another mosaic, or a file that was changed since, decides nothing."""
from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from osgeo import gdal

from tests.qgis.acceptance.seam_scenes import decision
from tests.qgis.runs import Run, run
from tests.qgis.seams.scan_scenes import Files, write_scene

pytestmark = pytest.mark.usefixtures("provider")

SIDES = "west", "east"


def scan(files: Files, folder: Path, **more: Any) -> None:
    outputs = {"LOSS": None, "SEAMS": str(folder / "seams.gpkg"), "CELLS": None, "WORST": None}
    made = run("scanmosaic", **{**files.given(), **outputs, **more})
    assert made.complaint is None
    made.close()


@pytest.fixture(scope="module")
def scanned(tmp_path_factory: pytest.TempPathFactory, provider: object) -> Path:
    """A sound mosaic, its orthoimages and its seams, never written to."""
    folder = tmp_path_factory.mktemp("scanned")
    scan(write_scene(folder), folder)
    return folder


@pytest.fixture
def project(scanned: Path, tmp_path: Path) -> Path:
    """A folder of one's own with what was scanned; the first one is hidden meanwhile, as after a move."""
    moved, hidden = tmp_path / "project", scanned.with_name("hidden")
    shutil.copytree(scanned, moved)
    os.rename(scanned, hidden)
    yield moved
    os.rename(hidden, scanned)


def decide(folder: Path, **more: Any) -> Run:
    papers = dict.fromkeys(("DEFECTS", "REPORT", "QUALITY"))
    made = run("acceptmosaic", SEAMS=[str(folder / "seams.gpkg")], **{**papers, **more})
    assert made.complaint is None
    return made


def rewrite(path: Path, at: float = 0.4, keep_time: bool = True) -> None:
    """Another tenth of a file, of the same size."""
    before, held = path.stat(), bytearray(path.read_bytes())
    start, count = round(at * len(held)), len(held) // 10
    held[start : start + count] = bytes(255 - byte for byte in held[start : start + count])
    path.write_bytes(held)
    if keep_time:
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))


def test_files_that_were_moved_and_are_given_are_the_same(project: Path) -> None:
    given = {"MOSAIC": [str(project / "mosaic.tif")], "SOURCES": [str(project / f"{side}.tif") for side in SIDES]}
    made = decide(project, **given)
    assert made.results["DECISION"] == "accepted"


@pytest.mark.parametrize("name", ["mosaic.tif", "west.tif", "east.tif"])
def test_another_file_of_the_same_size_and_time_decides_nothing(scanned: Path, tmp_path: Path, name: str) -> None:
    """The scanned file lies where it was, and nothing is given."""
    shutil.copy2(scanned / name, tmp_path / name)
    try:
        rewrite(scanned / name)
        made = decide(scanned)
        assert made.results["DECISION"] == "undecided"
        assert f"files were changed since they were scanned: 1 ({name})" in decision(made)
        assert any("or a new scan of the present files" in text for text in made.log.warnings)
    finally:
        shutil.copy2(tmp_path / name, scanned / name)


def test_another_mosaic_decides_nothing_whatever_the_scan_found(project: Path, tmp_path: Path) -> None:
    other = Path(write_scene(tmp_path, width=24.0, name="bad").mosaic)
    for limits in ({}, {"MIN_KEPT": 1.0}):
        made = decide(project, MOSAIC=[str(other)], **limits)
        assert made.results["DECISION"] == "undecided"
        assert made.results.get("ACCEPTED") is None
        assert "the files given are not the ones that were scanned: 1 (bad.tif)" in decision(made)
    renamed = shutil.move(other, tmp_path / "mosaic.tif")
    assert "not the ones that were scanned: 1 (mosaic.tif)" in decision(decide(project, MOSAIC=[str(renamed)]))


def test_what_is_gone_is_told(project: Path) -> None:
    gone, given = decide(project), decide(project, MOSAIC=[str(project / "mosaic.tif")])
    assert (gone.results["DECISION"], given.results["DECISION"]) == ("undecided", "accepted")
    assert "files of the scanned mosaic can no longer be found: 1 (mosaic.tif)" in decision(gone)
    assert any("Orthoimages that were scanned can no longer be found: 2" in text for text in given.log.warnings)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "change", "named"),
    [
        ("all.vrt", lambda folder: None, ""),
        ("all.vrt", lambda folder: show(folder / "all.vrt"), ""),
        ("all.vrt", lambda folder: rewrite(folder / "b.tif"), "b.tif"),
        ("all.vrt", lambda folder: (folder / "b.tif").unlink(), "b.tif"),
        ("all.vrt", lambda folder: swap(folder / "all.vrt"), "all.vrt"),
        ("all.tif", lambda folder: show(folder / "all.tif"), ""),
        ("all.tif", lambda folder: rewrite(folder / "b.tif"), "b.tif"),
    ],
)
def test_a_vrt_is_the_sheets_that_it_names(
    scanned: Path, tmp_path: Path, name: str, change: Callable[[Path], object], named: str
) -> None:
    for sheet, column in (("a", 0), ("b", 350)):
        gdal.Translate(str(tmp_path / f"{sheet}.tif"), str(scanned / "mosaic.tif"), srcWin=[column, 0, 350, 520])
    gdal.BuildVRT(str(tmp_path / name), [str(tmp_path / "a.tif"), str(tmp_path / "b.tif")]).FlushCache()
    files = Files(str(tmp_path / name), str(scanned / "west.tif"), str(scanned / "east.tif"))
    scan(files, tmp_path)
    change(tmp_path)
    for given in ({}, {"MOSAIC": [files.mosaic]}):
        made = decide(tmp_path, **given)
        assert made.results["DECISION"] == ("undecided" if named else "accepted")
        assert named in decision(made)


def show(path: Path) -> None:
    """What QGIS writes when it shows a raster."""
    dataset = gdal.Open(str(path))
    dataset.GetRasterBand(1).ComputeStatistics(False)


@pytest.mark.slow
def swap(vrt: Path) -> None:
    """Put two sheets each in the other's place."""
    text = vrt.read_text(encoding="utf-8")
    vrt.write_text(text.replace("a.tif", "?").replace("b.tif", "a.tif").replace("?", "b.tif"), encoding="utf-8")


def test_a_mosaic_is_all_of_its_files(scanned: Path, tmp_path: Path) -> None:
    mosaic = tmp_path / "mosaic.img"
    gdal.Translate(str(mosaic), str(scanned / "mosaic.tif"), format="HFA", creationOptions=["USE_SPILL=YES"])
    scan(Files(str(mosaic), str(scanned / "west.tif"), str(scanned / "east.tif")), tmp_path)
    show(mosaic)
    assert decide(tmp_path, MOSAIC=[str(mosaic)]).results["DECISION"] == "accepted"
    rewrite(tmp_path / "mosaic.ige")
    for given, words in (({}, "were changed since"), ({"MOSAIC": [str(mosaic)]}, "not the ones that were scanned")):
        made = decide(tmp_path, **given)
        assert words in decision(made)
        assert "mosaic.ige" in decision(made)
