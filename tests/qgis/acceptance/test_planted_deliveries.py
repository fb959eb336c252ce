"""Deliveries whose truth is known: scan, decision, report, record and layers say the same metres, and the
decision is right, or undecided with the reason."""
from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsVectorLayer

from tests.pages import outline
from tests.qgis.acceptance.planted import (
    GSD,
    ROWS,
    SHAPE,
    STRIP,
    STRIPS,
    Block,
    make_block,
    planted_metres,
    seam_metres,
)
from tests.qgis.acceptance.seam_scenes import decision
from tests.qgis.runs import Run, run

pytestmark = [pytest.mark.usefixtures("provider"), pytest.mark.slow]

PIECE = 10.0
PLANTED = ((0, 133, 713), (1, 57, 637), (2, 248, 861))
"""Feathers of some 60 m that begin and end inside of pieces of 10 m."""


def scan(block: Block, folder: Path, **more: Any) -> Run:
    folder.mkdir(parents=True, exist_ok=True)
    given = {"MOSAIC": block.mosaic, "SOURCES": list(block.sources), "SEAMLINES": block.seamlines, "PIECE": PIECE}
    outputs = {"LOSS": str(folder / "loss.tif"), "SEAMS": str(folder / "seams.gpkg"), "CELLS": None, "WORST": None}
    outcome = run("scanmosaic", **{**given, **outputs, **more})
    assert outcome.complaint is None
    return outcome


def decide(folder: Path, *layers: QgsVectorLayer | str, **more: Any) -> Run:
    folder.mkdir(parents=True, exist_ok=True)
    papers = {
        "REPORT": str(folder / "decision.html"), "QUALITY": str(folder / "quality.xml"),
        "DEFECTS": str(folder / "failures.gpkg"),
    }  # fmt: skip
    return run("acceptmosaic", **{"SEAMS": list(layers), **papers, **more})


def said(outcome: Run) -> str:
    return " ".join(outcome.log.infos + outcome.log.warnings)


def assert_all_say_the_same(folder: Path, outcome: Run, *layers: QgsVectorLayer | str) -> None:
    """The decision's metres are sums of rows of the layers, and those of report, record and failures."""
    assert outcome.complaint is None
    total = failed = measured = 0.0
    for layer in layers:
        held = QgsVectorLayer(layer, "seams", "ogr") if isinstance(layer, str) else layer
        names = held.fields().names()
        for row in held.getFeatures():
            if "level" in names and row["level"] == "stretch":
                continue
            state = row["state"] if "state" in names else "failed" if row["kept_1"] < 0.7 else "passed"
            total += row["length"]
            failed += row["length"] * (state == "failed")
            measured += row["length"] * (state in ("failed", "passed"))
    assert outcome.results["TOTAL_METRES"] == pytest.approx(total)
    assert outcome.results["MEASURED_METRES"] == pytest.approx(measured)
    assert outcome.results["FAILED_METRES"] == pytest.approx(failed)
    defects = QgsVectorLayer(str(folder / "failures.gpkg"), "failures", "ogr")
    lengths = [row["length"] for row in defects.getFeatures()]
    assert sum(lengths) == pytest.approx(failed, abs=0.01)
    assert max(lengths, default=0) == pytest.approx(outcome.results["LONGEST_FAILURE"], abs=0.01)
    page = outline((folder / "decision.html").read_text(encoding="utf-8")).words.replace("\u00a0", " ")
    assert f"{failed:.1f} m" in page
    assert outcome.results["DECISION"].capitalize() in page
    root = ElementTree.parse(folder / "quality.xml").getroot()
    texts = [layer.text or "" for layer in root.iter()]
    assert any(text.startswith(decision(outcome)[:60]) for text in texts)
    if measured:
        records = [float(text) for text in texts if re.fullmatch(r"-?\d+(\.\d+)?(e-?\d+)?", text)]
        assert any(abs(record - 100 * failed / measured) < 0.005 for record in records)


@pytest.fixture(scope="module")
def spoilt(tmp_path_factory: pytest.TempPathFactory) -> Block:
    return make_block(tmp_path_factory.mktemp("spoilt"), PLANTED)


@pytest.fixture(scope="module")
def scanned(spoilt: Block, provider: object) -> Iterator[Run]:
    outcome = scan(spoilt, spoilt.folder / "scan")
    yield outcome
    outcome.close()


def test_2_failures_that_end_inside_of_pieces(spoilt: Block, scanned: Run, tmp_path: Path) -> None:
    outcome = decide(tmp_path, scanned.results["SEAMS"])
    truth = planted_metres(PLANTED)
    assert outcome.results["TOTAL_METRES"] == pytest.approx(seam_metres(), rel=0.01)
    assert outcome.results["FAILED_METRES"] == pytest.approx(truth, rel=0.08)
    assert outcome.results["FAILED_METRES"] == scanned.results["FAILED_METRES"]
    assert outcome.results["TOTAL_METRES"] == pytest.approx(scanned.results["SEAM_METRES"])
    assert outcome.results["LONGEST_FAILURE"] == pytest.approx(planted_metres(PLANTED[2:]), abs=PIECE)
    assert outcome.results["DECISION"] == "rejected"
    assert "as their scans left them (1)" in said(outcome)
    assert_all_say_the_same(tmp_path, outcome, scanned.results["SEAMS"])
    allowed = 100 * truth / seam_metres()
    for share, outcomes in ((1.25 * allowed, {"accepted"}), (allowed, {"accepted", "rejected", "undecided"}),
                            (allowed / 1.25, {"rejected"})):
        by_share = decide(tmp_path, scanned.results["SEAMS"], MAX_SHARE=share, MAX_RUN=1000)
        assert by_share.results["DECISION"] in outcomes


def test_4_smooth_fields(tmp_path: Path) -> None:
    """A third of all seams on even fields, on some of which nothing can be measured; not a metre failed."""
    block = make_block(tmp_path / "block", smooth=ROWS // 3)
    made = scan(block, tmp_path / "scan")
    outcome = decide(tmp_path, made.results["SEAMS"])
    assert outcome.results["DECISION"] == "accepted", said(outcome)
    assert outcome.results["FAILED_METRES"] == made.results["FAILED_METRES"] == 0
    assert outcome.results["MEASURED_METRES"] < 0.9 * outcome.results["TOTAL_METRES"]  # less than has to be measured
    textured = gdal.Open(block.mosaic).GetGeoTransform()[3] - GSD * (ROWS // 3 - 20)  # northing
    even = [row["state"] for row in QgsVectorLayer(made.results["SEAMS"], "seams", "ogr").getFeatures()
            if row["level"] == "piece" and row.geometry().boundingBox().yMinimum() > textured]
    assert len(even) == 2 * (STRIPS - 1)
    assert set(even) == {"no_detail"}  # what float32 leaves of even ground is not to be measured
    assert "of seam lie on ground without detail" in said(outcome)
    assert_all_say_the_same(tmp_path, outcome, made.results["SEAMS"])


def test_5_a_missing_orthoimage(spoilt: Block, tmp_path: Path) -> None:
    """One of four is not there, and seams are found in the pixels: two of three are in no figure."""
    made = scan(spoilt, tmp_path / "scan", SOURCES=[*spoilt.sources[:2], spoilt.sources[3]], SEAMLINES=None)
    outcome = decide(tmp_path, made.results["SEAMS"], MAX_SHARE=100, MAX_RUN=1000)
    assert outcome.results["DECISION"] == "undecided"
    assert re.search(r"\d\d\u00a0% of the mosaic of 'seams' match no orthoimage, 10\u00a0% is", decision(outcome))
    x, y = map(float, re.search(r"around ([\d.]+), ([\d.]+) \(", decision(outcome)).groups())  # type: ignore[union-attr]
    left, top = gdal.Open(spoilt.mosaic).GetGeoTransform()[::3]
    assert 800 < (x - left) / GSD < 1200  # the third strip
    assert 0 < (top - y) / GSD < ROWS
    assert "a scan with the orthoimages that are missing" in said(outcome)
    assert_all_say_the_same(tmp_path, outcome, made.results["SEAMS"])


@pytest.mark.parametrize("spoil", ["pasted", "blank"])
def test_5_orthoimages_that_hide_a_failure(spoil: str, tmp_path: Path) -> None:
    """20 of 270 m are feathered, and there both orthoimages show the mosaic with noise, or nothing: more than may fail,
    less than has to be measured. The seamlines name no orthoimage."""
    block = make_block(tmp_path / "block", [(1, 300, 500)])
    left, mosaic = gdal.Open(block.mosaic).GetGeoTransform()[0], gdal.Open(block.mosaic).ReadAsArray()
    for path in block.sources[1:3]:
        image = gdal.Open(path, gdal.GA_Update)
        first = round((image.GetGeoTransform()[0] - left) / GSD)
        place = slice(2 * STRIP - 40 - first, 2 * STRIP + 40 - first)
        shown = mosaic[:, 295:505, first:][:, :, place] + np.random.default_rng(1).integers(-1, 2, (3, 210, 80))
        image.WriteArray(np.uint8(np.clip(shown, 1, 255) * (spoil == "pasted")), place.start, 295)
        image.GetRasterBand(1).SetNoDataValue(0)
        image.FlushCache()
    made = scan(block, tmp_path / "scan")
    outcome = decide(tmp_path / "paper", made.results["SEAMS"])
    assert (outcome.results["FAILED_METRES"], outcome.results["DECISION"]) == (0, "undecided")
    assert outcome.results["MEASURED_METRES"] > 0.9 * outcome.results["TOTAL_METRES"]
    assert "orthoimages that the mosaic was made from, complete and unchanged" in said(outcome)
    page = outline((tmp_path / "paper" / "decision.html").read_text(encoding="utf-8")).words
    assert "missing, without pixels or not explaining the mosaic along" in page


def test_6_a_filtered_layer(scanned: Run, tmp_path: Path) -> None:
    """What a filter hides may be the failures."""
    path = scanned.results["SEAMS"]
    filtered = QgsVectorLayer(path, "seams", "ogr")
    assert filtered.setSubsetString("kept_1 > 0.7")
    for given in (filtered, f"{path.partition('|')[0]}|layername=seams|subset=kept_1 > 0.7"):
        refused = decide(tmp_path, given)
        assert "remove the filter" in str(refused.complaint)


def test_8_sheet_by_sheet_or_as_one(spoilt: Block, scanned: Run, tmp_path: Path) -> None:
    """Two sheets, whose border cuts all three failures: no more differs than the pieces at the border."""
    made = []
    for number, first in enumerate((0, ROWS // 2)):
        sheet = tmp_path / f"sheet_{number}.tif"
        gdal.Translate(str(sheet), spoilt.mosaic, srcWin=[0, first, SHAPE[1], ROWS // 2])
        made.append(scan(spoilt, tmp_path / f"scan_{number}", MOSAIC=str(sheet)))
    layers = [item.results["SEAMS"] for item in made]
    outcome = decide(tmp_path, *layers)
    assert outcome.results["DECISION"] == "rejected"
    assert outcome.results["FAILED_METRES"] == pytest.approx(sum(item.results["FAILED_METRES"] for item in made))
    truth = planted_metres(PLANTED)
    assert outcome.results["FAILED_METRES"] == pytest.approx(truth, abs=0.08 * truth + PIECE)  # of a border
    borders = 3 * 2 * PIECE  # three seams are cut anew
    assert abs(outcome.results["FAILED_METRES"] - scanned.results["FAILED_METRES"]) <= borders
    assert "as their scans left them (2)" in said(outcome)
    assert_all_say_the_same(tmp_path, outcome, *layers)


def test_9_without_orthoimages(spoilt: Block, tmp_path: Path) -> None:
    """Too little seam for a verdict on pieces of 10 m."""
    made = scan(spoilt, tmp_path / "scan", SOURCES=[])
    pieces = [row for row in made.rows("SEAMS") if row["level"] == "piece"]
    assert sum(row["length"] for row in pieces) == pytest.approx(made.results["SEAM_METRES"])
    outcome = decide(tmp_path, made.results["SEAMS"])
    assert outcome.results["DECISION"] == "undecided"
    assert outcome.results["FAILED_METRES"] == made.results["FAILED_METRES"]
    assert "What would decide it: measuring at least" in said(outcome)
    assert_all_say_the_same(tmp_path, outcome, made.results["SEAMS"])
