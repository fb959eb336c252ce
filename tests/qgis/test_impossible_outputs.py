"""Outputs that can't be written get one sentence, leave nothing, and what was there before stays."""
from __future__ import annotations

import contextlib
import os
import re
import sqlite3
from pathlib import Path
from typing import Any

import pytest
from osgeo import gdal
from qgis.core import (
    QgsProcessingOutputLayerDefinition,
    QgsProcessingParameterFeatureSink,
    QgsProcessingParameterRasterDestination,
    QgsProject,
    QgsVectorLayer,
)

from tests.numbers.disks import full_disk
from tests.qgis.runs import Log, Run, algorithm, assert_refused, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, saved, windows
from tests.qgis.test_provider import NAMES

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("provider")]

LAYERS = (QgsProcessingParameterFeatureSink, QgsProcessingParameterRasterDestination)


def places(folder: Path, ending: str) -> dict[str, str]:
    """Where nothing can be written, and the words that say so."""
    (folder / f"folder.{ending}").mkdir()
    (folder / "file.txt").touch()
    (folder / f"loop.{ending}").symlink_to(folder / f"loop.{ending}")
    (folder / f"dangling.{ending}").symlink_to(folder / "nowhere" / "x")
    return {
        f"{folder}/gone/x.{ending}": "No such file or directory",
        f"{folder}/dangling.{ending}": "No such file or directory",
        f"{folder}/folder.{ending}": "Is a directory",
        f"{folder}/": "Is a directory",
        f"{folder}/file.txt/x.{ending}": "Not a directory",
        f"{folder}/loop.{ending}": "symbolic links",
        f"{folder}/{'x' * 260}.{ending}": "name too long",
        f"{folder}/a\0b.{ending}": "is not a file on a disk",
        f"/vsizip/{folder}/a.zip/x.{ending}": "is not a file on a disk",
        f"/vsicurl/http://127.0.0.1:9/x.{ending}": "is not a file on a disk",
        "/dev/null": "not permitted",
        "/dev/full": "not permitted",
        " ": "is not a file on a disk",
    }


@pytest.mark.parametrize("name", NAMES)
def test_what_can_not_be_written_is_refused_first(name: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """Before anything is read: the other parameters may hold nothing."""
    job = algorithm(name)
    for output in job.destinationParameterDefinitions():
        if not isinstance(output, LAYERS):
            continue
        folder = tmp_path / output.name().replace(":", "_")
        folder.mkdir()
        is_raster = isinstance(output, QgsProcessingParameterRasterDestination)
        refused = places(folder, "tif" if is_raster else "gpkg")
        if is_raster:
            refused |= dict.fromkeys(["postgres:dbname=x", "ogr:dbname='x.gpkg'", "http://x/y.tif"], "not a file on")
        before = sorted(folder.rglob("*"))
        for path, words in refused.items():
            assert_refused(name, words, **{output.name(): path})
            assert sorted(folder.rglob("*")) == before
    assert not capfd.readouterr().err


@pytest.mark.parametrize("name", NAMES)
def test_a_raster_is_no_jpeg(name: str, tmp_path: Path) -> None:
    """Every one is a GeoTIFF, and a file's name doesn't say otherwise; QGIS offers no other."""
    job = algorithm(name)
    rasters = [one for one in job.destinationParameterDefinitions() if isinstance(one, LAYERS[1])]
    for output in rasters:
        assert output.defaultFileExtension() == "tif"
        assert set(output.supportedOutputRasterLayerExtensions()) == {"tif", "tiff"}
        for ending in ("jpg", "PNG", "img", "vrt", "xyzzy"):
            assert_refused(name, r"GeoTIFF \(\*\.tif \*\.tiff\)", **{output.name(): str(tmp_path / f"out.{ending}")})
    if name == "fitsensormodel":
        assert_refused(name, r"GeoTIFF files \(\*\.tif", RPC_IMAGE=str(tmp_path / "out.jpg"))
    assert not list(tmp_path.iterdir())


def test_a_name_that_no_table_can_have(tmp_path: Path) -> None:
    for name in ("-rf", "%s{0}", "<img src=x onerror=alert(1)>", "'; drop table x; --", "=cmd|' /C calc'!A0"):
        words = "none in a GeoPackage begins with"
        assert_refused("inspectwindows", words, OUTPUT=str(tmp_path / f"{name.replace('/', '')}.gpkg"))
    assert not list(tmp_path.iterdir())


def test_a_name_that_qgis_reads_otherwise(tmp_path: Path) -> None:
    """A disk has room for them, and QGIS would write another file, or none."""
    for name, part in (("a|b.shp", "|"), ("a\\b.csv", "\\"), ("a:b.geojson", ":"), ("a%20b.gpkg", "%20")):
        words = re.escape(f"can't be {tmp_path}/{name}: QGIS takes '{part}'")
        assert_refused("inspectwindows", words, OUTPUT=str(tmp_path / name))
    assert not list(tmp_path.iterdir())


def test_names_with_other_signs_are_names(scene: Scene, tmp_path: Path) -> None:
    for name in ("ä, b;c=d 100% #1?.gpkg", "a%20b.shp", "it's.gpkg"):
        found = inspected(scene, OUTPUT=str(tmp_path / name))
        assert found.complaint is None
        assert len(found.rows()) == 6
        assert (tmp_path / name).exists()


def test_a_database_that_others_write_is_left_to_them(tmp_path: Path) -> None:
    path = saved(windows(SHARP, name=("string", ["older"])), tmp_path / "made.gpkg")
    with contextlib.closing(sqlite3.connect(path, isolation_level=None)) as other:
        other.execute("BEGIN IMMEDIATE")
        for output in (path, f"ogr:dbname='{path}' table=\"new\" (geom)"):
            assert_refused("inspectwindows", "being written by another program", OUTPUT=output)
    assert QgsVectorLayer(path, "made", "ogr").featureCount() == 1


# --- disks that are full -----------------------------------------------------------------------------------------


def inspected(scene: Scene, log: Log | None = None, **outputs: Any) -> Run:
    given = {"WINDOWS": windows(*[SHARP] * 3, *[BLURRED] * 3), "MOSAIC": str(scene.mosaic), "SOURCES": scene.sources}
    return run("inspectwindows", log, **{**given, "CURVES": None, "PAIRS": None, "PROFILES": None, **outputs})


@pytest.mark.parametrize(("ending", "room"), [
    ("gpkg", 1), ("gpkg", 30_000), ("gpkg", 70_000), ("csv", 1), ("shp", 1), ("kml", 1)
])
def test_a_full_disk_keeps_what_was_there(
    scene: Scene, tmp_path: Path, ending: str, room: int, capfd: pytest.CaptureFixture[str]
) -> None:
    """GDAL tells of a disk that is full as it closes the file, to nobody."""
    output = Path(saved(windows(SHARP, name=("string", ["older"])), tmp_path / f"made.{ending}"))
    before = {one.name: one.read_bytes() for one in tmp_path.iterdir()}
    capfd.readouterr()
    with full_disk(room):
        found = inspected(scene, OUTPUT=str(output))
    assert_sentence(found.complaint, "can't be written")
    assert str(output) in str(found.complaint)
    assert {one.name: one.read_bytes() for one in tmp_path.iterdir()} == before
    assert not capfd.readouterr().err
    os.unlink(output)
    with full_disk(room):
        assert_sentence(inspected(scene, OUTPUT=str(output)).complaint, "can't be written")
    assert not output.exists()


def test_an_empty_layer_that_is_not_there_is_no_result(scene: Scene, tmp_path: Path) -> None:
    """These windows are too small for a profile: of a disk that is full, nothing is left to go on with."""
    with full_disk(1):
        found = inspected(scene, OUTPUT=str(tmp_path / "a.gpkg"), PROFILES=str(tmp_path / "b.gpkg"))
    assert_sentence(found.complaint, "can't be written")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("ending", ["gpkg", "shp", "geojson", "csv", "kml", "fgb", "sqlite", "ods", "gml"])
def test_an_empty_layer_is_a_result(scene: Scene, tmp_path: Path, ending: str) -> None:
    found = inspected(scene, OUTPUT="TEMPORARY_OUTPUT", PROFILES=str(tmp_path / f"empty.{ending}"))
    assert found.complaint is None
    assert not found.log.errors


def test_a_layer_that_can_not_be_written_costs_no_other(scene: Scene, tmp_path: Path) -> None:
    log = Log()
    with full_disk(1):
        found = inspected(scene, log, OUTPUT="memory:", CURVES=str(tmp_path / "curves.csv"))
    assert found.complaint is None
    assert len(found.rows("OUTPUT")) == 6
    assert "CURVES" not in found.results
    assert_sentence(log.errors[0], "curves.csv can't be written")
    assert not list(tmp_path.iterdir())


def test_an_older_layer_is_replaced_with_its_parts(scene: Scene, tmp_path: Path) -> None:
    for ending in ("gpkg", "shp"):
        output = saved(windows(SHARP, name=("string", ["older"])), tmp_path / f"made.{ending}")
        assert inspected(scene, OUTPUT=output).complaint is None
        assert QgsVectorLayer(output, "made", "ogr").featureCount() == 6
        assert not [one.name for one in tmp_path.iterdir() if one.name.startswith(".")]
    assert gdal.OpenEx(str(tmp_path / "made.gpkg")) is not None


# --- runs that do not come to their end --------------------------------------------------------------------------


class Cancelled(Log):
    """A run that is cancelled as soon as a window is done."""

    def __init__(self) -> None:
        super().__init__()
        self.progressChanged.connect(lambda progress: self.cancel() if progress > 0 else None)


@pytest.mark.parametrize("ending", ["gpkg", "shp"])
def test_what_a_cancelled_run_measured_replaces_nothing(scene: Scene, tmp_path: Path, ending: str) -> None:
    output = Path(saved(windows(*[SHARP] * 9, name=("string", ["older"] * 9)), tmp_path / f"made.{ending}"))
    before = {one.name: one.read_bytes() for one in tmp_path.iterdir()}
    log = Cancelled()
    found = inspected(scene, log, WINDOWS=windows(*[SHARP] * 200), OUTPUT=str(output))
    assert {name: (tmp_path / name).read_bytes() for name in before} == before
    part = tmp_path / f"made_2.{ending}"
    assert found.results["OUTPUT"] == str(part)
    assert 0 < QgsVectorLayer(str(part), "part", "ogr").featureCount() < 200
    assert len(found.rows("OUTPUT")) == QgsVectorLayer(str(part), "part", "ogr").featureCount()
    assert_sentence(log.warnings[-1], f"{output} is as it was, .* in {part}")
    assert not [one.name for one in tmp_path.iterdir() if one.name.startswith(".")]


def test_a_layer_that_can_not_be_replaced_gets_a_name_beside_it(
    scene: Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A layer on Windows while QGIS has it open."""
    output, replace = saved(windows(SHARP, name=("string", ["older"])), tmp_path / "made.gpkg"), os.replace

    def refuse(source: Any, target: Any) -> None:
        if str(target) == output:
            raise PermissionError
        replace(source, target)

    monkeypatch.setattr(os, "replace", refuse)
    log = Log()
    found = inspected(scene, log, OUTPUT=output)
    assert len(found.rows("OUTPUT")) == 6
    assert found.results["OUTPUT"] == str(tmp_path / "made_2.gpkg")
    assert QgsVectorLayer(output, "made", "ogr").featureCount() == 1
    assert_sentence(log.warnings[-1], "made.gpkg is open in another program")


def test_a_run_that_is_killed_leaves_the_older_layer(scene: Scene, tmp_path: Path) -> None:
    output = Path(saved(windows(SHARP, name=("string", ["older"])), tmp_path / "made.gpkg"))
    before = output.read_bytes()
    seen: list[bool] = []

    class Looking(Log):
        def setProgress(self, progress: float) -> None:
            seen.append(output.read_bytes() == before)

    assert inspected(scene, Looking(), OUTPUT=str(output)).complaint is None
    assert seen
    assert all(seen)  # nothing is put aside meanwhile, so a kill finds it
    assert output.read_bytes() != before


def test_qgis_loads_the_layer_from_its_place(scene: Scene, tmp_path: Path) -> None:
    for count, log in ((2, Log()), (200, Cancelled())):
        output = QgsProcessingOutputLayerDefinition(str(tmp_path / "new.gpkg"), QgsProject.instance())
        found = inspected(scene, log, WINDOWS=windows(*[SHARP] * count), OUTPUT=output)
        assert list(found.context.layersToLoadOnCompletion()) == [found.results["OUTPUT"]]
    assert found.results["OUTPUT"] == str(tmp_path / "new_2.gpkg")
