"""A delivery of twelve sheets, four of them spoilt in known ways, from rasters to a decision on paper: three calls."""
from __future__ import annotations

import base64
import math
import re
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsGeometry, QgsPointXY, QgsVectorLayer
from seam_inspector.plugin.acceptance.paper.defect_files import PROOF_PX

from demo.delivery import SPOILT, Delivery
from tests.made_once import the_delivery
from tests.pages import outline
from tests.qgis.qgis_processes import NEEDED, PROGRAM, environment

pytestmark = [pytest.mark.slow, NEEDED]

CLOSE = 0.05
"""Tolerance, relative to what is known of the delivery."""


@pytest.fixture(scope="module")
def delivery(tmp_path_factory: pytest.TempPathFactory) -> Delivery:
    return the_delivery(tmp_path_factory)


@pytest.fixture(scope="module")
def decided(delivery: Delivery, repository: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder with the results of a scan, a plan and a decision."""
    folder = tmp_path_factory.mktemp("decided")
    own = environment(repository, tmp_path_factory.mktemp("settings"))

    def call(*arguments: str) -> None:
        done = subprocess.run(
            [str(PROGRAM), *arguments], env=own, capture_output=True, text=True, timeout=300, check=False
        )
        assert done.returncode == 0, done.stderr
        (folder / f"{arguments[1].partition(':')[2] or 'enable'}.log").write_text(done.stdout, encoding="utf-8")

    call("plugins", "enable", "seam_inspector")
    call(
        "run", "seaminspector:scanmosaic", f"--MOSAIC={delivery.mosaic}", f"--SEAMLINES={delivery.seamlines}",
        *(f"--SOURCES={source}" for source in delivery.sources), "--PIECE=10", f"--LOSS={folder / 'loss.tif'}",
        f"--SEAMS={folder / 'seams.gpkg'}", f"--CELLS={folder / 'cells.gpkg'}", f"--WORST={folder / 'worst.gpkg'}",
    )
    call(
        "run", "seaminspector:planinspection", f"--SEAMS={folder / 'seams.gpkg'}", f"--SHEETS={delivery.index}",
        f"--MOSAIC={delivery.mosaic}", "--UNIT=windows", "--SIDE=20", f"--OUTPUT={folder / 'sample.gpkg'}",
    )
    call(
        "run", "seaminspector:acceptmosaic", f"--SEAMS={folder / 'seams.gpkg'}", f"--SHEETS={delivery.index}",
        f"--MOSAIC={delivery.mosaic}", f"--REPORT={folder / 'decision.html'}", f"--QUALITY={folder / 'quality.xml'}",
        f"--DEFECTS={folder / 'defects.gpkg'}",
    )
    return folder


def number(decided: Path, algorithm: str, name: str) -> float:
    lines = (decided / f"{algorithm}.log").read_text(encoding="utf-8").splitlines()
    return float(next(line.partition(":")[2] for line in lines if line.startswith(f"{name}:")))


def test_the_decision_is_the_truth(decided: Path, delivery: Delivery) -> None:
    assert number(decided, "acceptmosaic", "ACCEPTED") == 0
    known = {
        "TOTAL_METRES": delivery.seam_metres, "FAILED_METRES": sum(delivery.spoilt_metres),
        "LONGEST_FAILURE": max(delivery.spoilt_metres),
        "FAILED_SHARE": 100 * sum(delivery.spoilt_metres) / delivery.seam_metres,
    }  # fmt: skip
    for name, value in known.items():
        assert number(decided, "acceptmosaic", name) == pytest.approx(value, rel=CLOSE), name


def test_what_goes_back_is_what_was_spoilt(decided: Path, delivery: Delivery) -> None:
    """Each failure in its sheet, as long as it is, with its picture."""
    rows = list(QgsVectorLayer(str(decided / "defects.gpkg"), "defects", "ogr").getFeatures())
    found = {row["sheet"]: row["length"] for row in rows}
    lengths = dict(zip(("sheet_1_2", "sheet_2_1", "sheet_2_4", "sheet_3_3"), delivery.spoilt_metres))
    assert len(SPOILT) == len(rows) == 4
    assert sorted(found) == sorted(lengths)
    for sheet, length in lengths.items():
        assert found[sheet] == pytest.approx(length, abs=11), sheet  # a piece has 10 m
    assert all((decided / row["picture"]).is_file() for row in rows)


def test_the_page_of_a_failure_says_and_shows_what_decided(decided: Path, delivery: Delivery) -> None:
    """Title, pieces, layer and the place of the picture, of every failure."""
    page = (decided / "decision.html").read_text(encoding="utf-8")
    sections = re.findall(r'<section class="proof">(.*?)</section>', page, re.DOTALL)
    rows = list(QgsVectorLayer(str(decided / "defects.gpkg"), "defects", "ogr").getFeatures())
    seams = list(QgsVectorLayer(f"{decided / 'seams.gpkg'}|layername=seams", "seams", "ogr").getFeatures())
    mosaic = gdal.Open(str(delivery.mosaic))
    left, pixel, _, top, _, _ = mosaic.GetGeoTransform()
    assert len(sections) == len(rows) == len(SPOILT)
    for section, row in zip(sections, rows):
        own = [seam for seam in seams if seam["level"] == "piece" and seam.geometry().buffer(0.1, 4).intersects(
            row.geometry()) and seam["kept_1"] < 0.7]  # fmt: skip
        kept = [float(one) for one in re.findall(r"([\d.]+)\u00a0%", section.partition("one after the other")[2])]
        assert sorted(kept) == pytest.approx(sorted(100 * one["kept_1"] for one in own), abs=0.51)
        told = re.search(r"least kept ([\d.]+)\u00a0%", section)
        assert told is not None
        assert float(told[1]) == min(kept) == pytest.approx(100 * row["kept_1"], abs=0.51)
        worst = min(own, key=lambda one: one["kept_1"]).geometry()
        middle = worst.interpolate(worst.length() / 2).asPoint()
        place = ((middle.x() - left) / pixel, (top - middle.y()) / pixel)
        shown = picture_in(re.findall(r'src="data:image/jpeg;base64,([^"]+)"', section)[1])
        column, row_ = (math.floor(one - PROOF_PX / 2) for one in place)
        truth = np.moveaxis(mosaic.ReadAsArray(column, row_, PROOF_PX, PROOF_PX), 0, 2).astype(float)
        inner = slice(12, -12)
        assert np.corrcoef(shown[inner, inner].ravel(), truth[inner, inner].ravel())[0, 1] > 0.9
        marks = np.argwhere(abs(shown - (255, 214, 0)).sum(axis=2) < 60)
        assert len(marks)
        points = [QgsGeometry.fromPointXY(QgsPointXY(left + (column + x + 0.5) * pixel, top - (row_ + y + 0.5) * pixel))
                  for y, x in marks]  # fmt: skip
        assert max(min(seam.geometry().distance(point) for seam in seams) for point in points) < 5 * pixel


def picture_in(encoded: str) -> np.ndarray:
    """(rows, columns, 3) of a JPEG."""
    gdal.FileFromMemBuffer("/vsimem/panel.jpg", base64.b64decode(encoded))
    return np.moveaxis(gdal.Open("/vsimem/panel.jpg").ReadAsArray(), 0, 2).astype(float)


def test_the_sample_is_of_all_sheets_with_seams(decided: Path) -> None:
    sample = QgsVectorLayer(str(decided / "sample.gpkg"), "sample", "ogr")
    assert sample.featureCount() == number(decided, "planinspection", "SAMPLE_SIZE") == 13
    assert number(decided, "planinspection", "ACCEPTANCE_NUMBER") == 0
    assert len({row["sheet"] for row in sample.getFeatures()}) == 8


def test_the_papers_say_so(decided: Path) -> None:
    page = outline((decided / "decision.html").read_text(encoding="utf-8"))
    assert "Rejected" in page.words
    assert len(page.pictures("jpeg")) >= 4
    for sheet in ("sheet_1_2", "sheet_2_1", "sheet_2_4", "sheet_3_3"):
        assert sheet in page.words
    root = ElementTree.parse(decided / "quality.xml").getroot()
    verdicts = [one.text or "" for one in root.iter() if one.tag.endswith("}Boolean")]
    assert "false" in verdicts
