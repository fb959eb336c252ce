"""``seaminspector:interiororientation`` as QGIS runs it: contracts, hand measurement, files, bad input."""
from __future__ import annotations

import json
import math
import re
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsRasterLayer
from seam_inspector.plugin.photos.measure.camera_calibration import read_calibration
from seam_inspector.plugin.photos.measure.orientation import read_measures

from tests.numbers.photos.photos import Place
from tests.numbers.synthetic import write_plain
from tests.qgis.photos.photo_scenes import PhotoScene, make_photo, points
from tests.qgis.runs import Run, assert_refused, assert_sentence, run

pytestmark = pytest.mark.usefixtures("provider")

FIELDS = "mark column row x_mm y_mm residual_x residual_y correlation status reason photo".split()
CROSS = {"TEMPLATE_KIND": "ring with cross"}


@pytest.fixture(scope="module")
def scene(tmp_path_factory: pytest.TempPathFactory) -> PhotoScene:
    return make_photo(tmp_path_factory.mktemp("photo"), seed=3, rotation=1.2)


@pytest.fixture(scope="module")
def blotted(tmp_path_factory: pytest.TempPathFactory) -> PhotoScene:
    """A photo of that kind with mark 2 under a blot."""
    scene = make_photo(tmp_path_factory.mktemp("blotted"), seed=4)
    column, row = (int(value) for value in scene.frame.places["2"])
    pixels = scene.frame.pixels.copy()
    pixels[row - 40 : row + 40, column - 40 : column + 40] = 90
    write_plain(scene.photo, pixels)
    return scene


def distances(outcome: Run, truth: dict[str, Place]) -> dict[str, float]:
    return {
        row["mark"]: math.dist((row["column"], row["row"]), truth[row["mark"]])
        for row in outcome.rows() if row["column"] is not None
    }


def test_marks_of_a_photo_that_nobody_looked_at(scene: PhotoScene, tmp_path: Path) -> None:
    names = {"PARAMETERS": "parameters.json", "WORLD_FILE": "photo.bpw", "REPORT": "report.html"}
    files = {parameter: str(tmp_path / name) for parameter, name in names.items()}
    outcome = run("interiororientation", **scene.inputs, **CROSS, **files)
    assert outcome.complaint is None
    assert outcome.layer().fields().names() == FIELDS
    assert outcome.column("status") == ["measured"] * 4
    assert outcome.column("reason") == [None] * 4
    assert max(distances(outcome, scene.frame.places).values()) < 0.1
    assert (outcome.results["MARKS"], outcome.results["FAILED"]) == (4, 0)
    assert outcome.results["RMS_UM"] == pytest.approx(
        math.sqrt(np.mean([row["residual_x"] ** 2 + row["residual_y"] ** 2 for row in outcome.rows()])), rel=1e-9
    )
    for feature in outcome.features():
        point = feature.geometry().asPoint()
        assert (point.x(), point.y()) == (feature["column"], -feature["row"])
    made = json.loads(Path(files["PARAMETERS"]).read_text(encoding="utf-8"))
    to_mm = np.array(made["to_mm"])
    for row in outcome.rows():
        x, y, _ = to_mm @ [row["column"], row["row"], 1]
        assert x - row["x_mm"] == pytest.approx(row["residual_x"] / 1000, abs=1e-9)
        assert y - row["y_mm"] == pytest.approx(row["residual_y"] / 1000, abs=1e-9)
    assert np.allclose(to_mm @ np.array(made["to_pixels"]), np.eye(3), atol=1e-9)
    assert made["pixel_size_um"]["x"] == pytest.approx(1000 / scene.frame.scale, rel=1e-3)
    assert made["scale_px_per_mm"]["x"] * made["pixel_size_um"]["x"] == pytest.approx(1000)
    assert made["lies"] == {"turned_deg": 0, "mirrored": False, "known_by": "dots"}
    assert (made["redundancy"], made["mirrored"]) == (2, False)
    page = Path(files["REPORT"]).read_text(encoding="utf-8")
    assert page.count("<img") == 4
    assert "http" not in re.sub(r"\"data:[^\"]*\"|http-equiv", "", page)


def test_micmac_reads_the_marks(scene: PhotoScene, tmp_path: Path, data_folder: Path) -> None:
    """Elements, one within the other, are those of MicMac's own file for the UNBC photo."""
    path = tmp_path / "MeasuresIm-photo.bmp.xml"
    outcome = run("interiororientation", **scene.inputs, **CROSS, MEASURES=str(path))
    assert outcome.results["MEASURES"] == str(path)
    again = read_measures(path)
    assert [(photo, mark) for photo, mark, _ in again] == [("photo.bmp", mark) for mark in outcome.column("mark")]
    for (_, _, place), row in zip(again, outcome.rows()):
        assert place == pytest.approx((row["column"], row["row"]), abs=1e-5)
    theirs = data_folder / "fiducials" / "unbc" / "MeasuresIm-15BCC02013_114.jpg.xml"
    assert elements(path) == elements(theirs)
    assert read_calibration(path).marks == {mark: place for _, mark, place in again}
    assert outcome.column("photo") == ["photo.bmp"] * 4


def elements(path: Path) -> list[tuple[str, int]]:
    """The names of a document's elements in their order, and how many lie in each."""
    return [(element.tag, len(element)) for element in ElementTree.parse(path).iter()]


def test_the_world_file_puts_the_photo_in_millimetres(scene: PhotoScene, tmp_path: Path) -> None:
    copy = tmp_path / "photo.png"
    write_plain(copy, scene.frame.pixels)
    outcome = run("interiororientation", **scene.inputs, **CROSS, WORLD_FILE=str(tmp_path / "photo.pgw"))
    transform = gdal.Open(str(copy)).GetGeoTransform()
    for row in outcome.rows():
        x, y = gdal.ApplyGeoTransform(transform, row["column"], row["row"])
        assert (x, y) == pytest.approx((row["x_mm"], row["y_mm"]), abs=0.02)
    shown = QgsRasterLayer(str(copy), "photo")
    assert shown.isValid()
    assert shown.extent().width() == pytest.approx(shown.extent().height(), rel=0.01)
    assert 212 / 0.86 <= shown.extent().width() <= 212 / 0.86 * 1.06
    again = run("interiororientation", **{**scene.inputs, "PHOTO": str(copy)}, **CROSS)
    for feature in again.features():  # now the map is in millimetres, the columns and rows are what they were
        assert feature.geometry().asPoint().x() == pytest.approx(feature["x_mm"], abs=0.02)
    assert again.column("column") == pytest.approx(outcome.column("column"), abs=1e-6)


def test_a_mark_measured_by_hand_takes_the_place_of_a_failed_one(blotted: PhotoScene) -> None:
    first = run("interiororientation", **blotted.inputs, **CROSS)
    assert dict(zip(first.column("mark"), first.column("status"))) == {
        "1": "measured", "2": "failed", "3": "measured", "4": "measured"
    }
    failed = next(row for row in first.rows() if row["mark"] == "2")
    assert failed["reason"]
    assert (failed["column"], failed["row"]) == (None, None)
    assert "RMS_UM" not in first.results  # three marks determine an affine transformation, nothing is left over
    truth = blotted.frame.places["2"]
    second = run("interiororientation", **blotted.inputs, **CROSS, POSITIONS=points({"2": truth}), MEASURE=False)
    assert second.column("status") == ["measured", "given", "measured", "measured"]
    assert second.rows()[1]["column"] == pytest.approx(truth[0])
    assert second.results["FAILED"] == 0
    field = points({"2": truth}, measure=("integer", [0]))
    third = run("interiororientation", **blotted.inputs, **CROSS, POSITIONS=field)
    assert third.column("status") == second.column("status")


# --- bad input -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("rows", "words"), [
    ("1,106,-106\n2,-106,-106\n", "too few marks: 2, and the affine model needs 3"),
    ("1,106,-106\n2,-106,-106\n3,106,-106.1\n4,106,106\n", "'1' and '3' .* are at the same place"),
    ("1,0.106,-0.106\n2,-0.106,-0.106\n3,-0.106,0.106\n", "give millimetres"),
    ("1,10.6,-10.6\n2,-10.6,-10.6\n3,-10.6,10.6\n", "give millimetres"),
    ("1,106000,-106000\n2,-106000,-106000\n3,-106000,106000\n", "give millimetres"),
    ("1,106,-106\n1,-106,-106\n", "the mark '1' twice"),
    ("1,106\n", "Row 2 .* no mark with two numbers"),
    ("", "holds no marks"),
    ("[" * 200_000, "neither a CSV"),
])  # fmt: skip
def test_a_bad_calibration_is_refused(scene: PhotoScene, tmp_path: Path, rows: str, words: str) -> None:
    path = tmp_path / "camera.csv"
    path.write_text("mark,x_mm,y_mm\n" + rows, encoding="utf-8")
    assert_refused("interiororientation", words, PHOTO=str(scene.photo), CALIBRATION=str(path))


def complaint(scene: PhotoScene, **parameters: Any) -> str | None:
    return run("interiororientation", **{**scene.inputs, **CROSS, **parameters}).complaint


def test_a_photo_without_marks(scene: PhotoScene, tmp_path: Path) -> None:
    white = write_plain(tmp_path / "white.tif", np.full((600, 600), 255, np.uint8))
    assert_sentence(complaint(scene, PHOTO=white), "All pixels of white.tif are alike")
    noise = np.random.default_rng(1).integers(0, 255, (600, 600)).astype(np.uint8)
    assert_sentence(complaint(scene, PHOTO=write_plain(tmp_path / "noise.tif", noise)), "No mark was found")


def test_the_report_shows_where_a_failed_mark_should_be(blotted: PhotoScene, tmp_path: Path) -> None:
    report = tmp_path / "report.html"
    outcome = run("interiororientation", **blotted.inputs, **CROSS, REPORT=str(report))
    assert outcome.column("status").count("failed") == 1
    page = report.read_text(encoding="utf-8")
    assert page.count("<img") == 4
    column, row = blotted.frame.places["2"]
    (said,) = set(re.findall(r"2: ([\d.]+); ([\d.]+), failed; it should be here", page))
    assert math.dist([float(value) for value in said], (column, row)) < 1
    for words in ("pixel size", "rotation", "principal point", str(blotted.calibration), "0.212 mm"):
        assert words in page


def test_too_few_marks_found_keep_what_was_measured(blotted: PhotoScene, tmp_path: Path) -> None:
    pixels = blotted.frame.pixels.copy()
    for name in ("2", "3"):
        column, row = (int(value) for value in blotted.frame.places[name])
        pixels[row - 40 : row + 40, column - 40 : column + 40] = 90
    photo = write_plain(tmp_path / "two.tif", pixels)
    report = tmp_path / "report.html"
    outcome = run(
        "interiororientation", **{**blotted.inputs, "PHOTO": photo}, **CROSS,
        POSITIONS=points(dict(blotted.frame.places)), REPORT=str(report),
    )
    assert outcome.complaint is None
    assert outcome.column("status") == ["measured", "failed", "failed", "measured"]
    assert all(row["reason"] for row in outcome.rows() if row["status"] == "failed")
    assert "RMS_UM" not in outcome.results
    assert not any(key in outcome.results for key in ("PARAMETERS", "WORLD_FILE"))
    assert_sentence(outcome.log.errors[0], "the affine model needs 3")
    assert report.is_file()
