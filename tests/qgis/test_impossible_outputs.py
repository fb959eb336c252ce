"""Outputs that can't be written get one sentence, leave nothing, and what was there before stays."""
from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import pytest
from qgis.core import (
    QgsProcessingOutputLayerDefinition,
    QgsProject,
    QgsVectorLayer,
)

from tests.numbers.disks import full_disk
from tests.qgis.runs import Log, Run, assert_refused, assert_sentence, run
from tests.qgis.scenes import BLURRED, SHARP, Scene, saved, windows

pytestmark = [pytest.mark.slow, pytest.mark.usefixtures("provider")]


def test_a_name_that_no_table_can_have(tmp_path: Path) -> None:
    for name in ("-rf", "%s{0}", "<img src=x onerror=alert(1)>", "'; drop table x; --", "=cmd|' /C calc'!A0"):
        words = "means something else there to QGIS or GDAL"
        assert_refused("inspectwindows", words, OUTPUT=str(tmp_path / f"{name.replace('/', '')}.gpkg"))
    assert not list(tmp_path.iterdir())


def test_a_name_that_qgis_reads_otherwise(tmp_path: Path) -> None:
    """A disk has room for them, and QGIS would write another file, or none."""
    for name, part in (("a|b.shp", "|"), ("a\\b.csv", "\\"), ("a:b.geojson", ":"), ("a%20b.gpkg", "%20")):
        words = re.escape(f"can't be {tmp_path}/{name}: '{part}' means something else")
        assert_refused("inspectwindows", words, OUTPUT=str(tmp_path / name))
    assert not list(tmp_path.iterdir())


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
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    capfd.readouterr()
    with full_disk(room):
        outcome = inspected(scene, OUTPUT=str(output))
    assert_sentence(outcome.complaint, "can't be written")
    assert str(output) in str(outcome.complaint)
    assert {path.name: path.read_bytes() for path in tmp_path.iterdir()} == before
    assert not capfd.readouterr().err
    os.unlink(output)
    with full_disk(room):
        assert_sentence(inspected(scene, OUTPUT=str(output)).complaint, "can't be written")
    assert not output.exists()


@pytest.mark.parametrize("ending", ["gpkg", "shp", "geojson", "csv", "kml", "fgb", "sqlite", "ods", "gml"])
def test_an_empty_layer_is_a_result(scene: Scene, tmp_path: Path, ending: str) -> None:
    outcome = inspected(scene, OUTPUT="TEMPORARY_OUTPUT", PROFILES=str(tmp_path / f"empty.{ending}"))
    assert outcome.complaint is None
    assert not outcome.log.errors


def test_a_layer_that_can_not_be_written_costs_no_other(scene: Scene, tmp_path: Path) -> None:
    log = Log()
    with full_disk(1):
        outcome = inspected(scene, log, OUTPUT="memory:", CURVES=str(tmp_path / "curves.csv"))
    assert outcome.complaint is None
    assert len(outcome.rows("OUTPUT")) == 6
    assert "CURVES" not in outcome.results
    assert_sentence(log.errors[0], "curves.csv can't be written")
    assert not list(tmp_path.iterdir())


# --- runs that do not come to their end --------------------------------------------------------------------------


class Cancelled(Log):
    """A run that is cancelled as soon as a window is done."""

    def __init__(self) -> None:
        super().__init__()
        self.progressChanged.connect(lambda progress: self.cancel() if progress > 0 else None)


@pytest.mark.parametrize("ending", ["gpkg", "shp"])
def test_what_a_cancelled_run_measured_replaces_nothing(scene: Scene, tmp_path: Path, ending: str) -> None:
    output = Path(saved(windows(*[SHARP] * 9, name=("string", ["older"] * 9)), tmp_path / f"made.{ending}"))
    before = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    log = Cancelled()
    outcome = inspected(scene, log, WINDOWS=windows(*[SHARP] * 200), OUTPUT=str(output))
    assert {name: (tmp_path / name).read_bytes() for name in before} == before
    part = tmp_path / f"made_2.{ending}"
    assert outcome.results["OUTPUT"] == str(part)
    assert 0 < QgsVectorLayer(str(part), "part", "ogr").featureCount() < 200
    assert len(outcome.rows("OUTPUT")) == QgsVectorLayer(str(part), "part", "ogr").featureCount()
    assert_sentence(log.warnings[-1], f"{output} is unchanged, .* is {part}")
    assert not [path.name for path in tmp_path.iterdir() if path.name.startswith(".")]


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
    outcome = inspected(scene, log, OUTPUT=output)
    assert len(outcome.rows("OUTPUT")) == 6
    assert outcome.results["OUTPUT"] == str(tmp_path / "made_2.gpkg")
    assert QgsVectorLayer(output, "made", "ogr").featureCount() == 1
    assert_sentence(log.warnings[-1], "made.gpkg is unchanged, .* or another program has the file open; .*made_2.gpkg")


def test_qgis_loads_the_layer_from_its_place(scene: Scene, tmp_path: Path) -> None:
    for count, log in ((2, Log()), (200, Cancelled())):
        output = QgsProcessingOutputLayerDefinition(str(tmp_path / "new.gpkg"), QgsProject.instance())
        outcome = inspected(scene, log, WINDOWS=windows(*[SHARP] * count), OUTPUT=output)
        assert list(outcome.context.layersToLoadOnCompletion()) == [outcome.results["OUTPUT"]]
    assert outcome.results["OUTPUT"] == str(tmp_path / "new_2.gpkg")
