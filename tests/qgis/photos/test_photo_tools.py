"""``comparemarks`` and ``enhancephoto`` as QGIS runs them."""
from __future__ import annotations

import os
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsCoordinateTransformContext, QgsVectorFileWriter, QgsVectorLayer

from tests.numbers.synthetic import orthoimage, write_plain
from tests.qgis.photos.photo_scenes import points
from tests.qgis.runs import assert_refused, assert_sentence, run

pytestmark = pytest.mark.usefixtures("provider")


def test_two_operators() -> None:
    first = {"1": (10.0, 10.0), "2": (500.0, 20.0), "3": (20.0, 600.0)}
    second = {"1": (10.3, 10.4), "2": (500.0, 20.2), "3": (20.0, 600.0)}
    outcome = run(
        "comparemarks", FIRST=points(first), SECOND=points(second), PIXEL_SIZE=20, DIFFERENCES="TEMPORARY_OUTPUT"
    )
    px, um = outcome.rows()
    distances = [0.5, 0.2, 0.0]
    assert (px["unit"], um["unit"], px["count"]) == ("px", "um", 3)
    assert px["mean"] == pytest.approx(np.mean(distances))
    assert px["standard_deviation"] == pytest.approx(np.std(distances, ddof=1))
    assert (px["maximum"], um["maximum"], px["minimum"]) == pytest.approx((0.5, 10, 0), abs=1e-9)
    assert outcome.results["MEAN_UM"] == pytest.approx(20 * np.mean(distances))
    assert outcome.column("distance", "DIFFERENCES") == pytest.approx(distances)


def test_photos_are_told_apart() -> None:
    places = {"1": (10.0, 10.0), "2": (500.0, 20.0)}
    given = points(places, photo=("string(20)", ["a", "b"]))
    other = points({"1": (11.0, 10.0), "2": (500.0, 20.0)}, photo=("string(20)", ["a", "a"]))
    outcome = run("comparemarks", FIRST=given, SECOND=other)
    assert outcome.results["COUNT"] == 1
    assert [row["unit"] for row in outcome.rows()] == ["px"]
    assert_sentence(outcome.log.warnings[0], "pixel size is not known")
    nothing = run("comparemarks", FIRST=given, SECOND=points({"7": (1.0, 1.0)}))
    assert_sentence(nothing.complaint, "no mark in common")


COUNT = 10
DRAWN = np.random.default_rng(7).normal(0, 0.16, (COUNT, 4, 2))  # a mean distance of 0.2 px
CORNERS = [(200.0, 190.0), (5670.0, 200.0), (650.0, 5200.0), (5660.0, 5213.0)]


def measured_places(photo: int, moved: bool) -> dict[str, tuple[float, float]]:
    moves = DRAWN[photo] if moved else np.zeros((4, 2))
    return {str(k + 1): (float(x + dx), float(y + dy)) for k, ((x, y), (dx, dy)) in enumerate(zip(CORNERS, moves))}


def measures(photo: int, moved: bool) -> str:
    """Measured places as MicMac writes them."""
    rows = (f"<OneMesureAF1I><NamePt>{name}</NamePt><PtIm>{x!r}  {y!r}</PtIm></OneMesureAF1I>"
            for name, (x, y) in measured_places(photo, moved).items())
    return (f'<?xml version="1.0" ?><SetOfMesureAppuisFlottants><MesureAppuiFlottant1Im><NameIm>{photo}.jpg</NameIm>'
            f"{''.join(rows)}</MesureAppuiFlottant1Im></SetOfMesureAppuisFlottants>")


def saved(layer: QgsVectorLayer, path: Path) -> None:
    options = QgsVectorFileWriter.SaveVectorOptions()
    options.driverName = "GPKG" if path.suffix == ".gpkg" else "CSV"
    error = QgsVectorFileWriter.writeAsVectorFormatV3(layer, str(path), QgsCoordinateTransformContext(), options)
    assert error[0] == QgsVectorFileWriter.WriterError.NoError, error


def in_pixels(places: dict[str, tuple[float, float]], **fields: Any) -> QgsVectorLayer:
    columns, rows = zip(*places.values())
    return points(places, column=("double", columns), row=("double", rows), **fields)


@pytest.fixture
def folders(tmp_path: Path) -> dict[str, Path]:
    """Ten photos as three operators have them: a layer for each, a table for each, MicMac's files."""
    made = {name: tmp_path / name for name in ("layers", "tables", "micmac")}
    for folder in made.values():
        folder.mkdir()
    for photo in range(COUNT):
        saved(in_pixels(measured_places(photo, False)), made["layers"] / f"{photo}.gpkg")
        saved(in_pixels(measured_places(photo, True)), made["tables"] / f"{photo}.csv")
        (made["micmac"] / f"MeasuresIm-{photo}.jpg.xml").write_text(measures(photo, True), encoding="utf-8")
    (made["layers"] / "report.html").write_text("<p>", encoding="utf-8")
    (made["micmac"] / "MeasuresCamera.xml").write_text("<a/>", encoding="utf-8")
    for name in ("layers/pipe.gpkg", "tables/pipe.csv", "micmac/MeasuresIm-pipe.xml"):  # nobody waits for those
        os.mkfifo(tmp_path / name)
    return made


@pytest.mark.parametrize("second", ["tables", "micmac"])
def test_the_papers_ten_photos_in_one_run(folders: dict[str, Path], second: str) -> None:
    outcome = run(
        "comparemarks", FIRST_FOLDER=str(folders["layers"]), SECOND_FOLDER=str(folders[second]),
        PHOTOS="TEMPORARY_OUTPUT", DIFFERENCES="TEMPORARY_OUTPUT", PIXEL_SIZE=20,
    )
    assert outcome.complaint is None
    distances = np.hypot(*DRAWN.reshape(-1, 2).T)
    px, um = outcome.rows()
    assert (px["count"], px["limit"], px["verdict"], um["limit"], um["verdict"]) == (40, 0.25, "within", 5, "within")
    assert (px["mean"], px["maximum"]) == pytest.approx((distances.mean(), distances.max()), abs=1e-4)
    assert px["standard_deviation"] == pytest.approx(distances.std(ddof=1), abs=1e-4)
    assert outcome.results["WITHIN_LIMIT"] == 1
    photos = outcome.rows("PHOTOS")
    assert [row["mean"] for row in photos] == pytest.approx(distances.reshape(COUNT, 4).mean(axis=1), abs=1e-4)
    assert [row["verdict"] == "within" for row in photos] == [row["mean"] <= 0.25 for row in photos]
    assert outcome.column("distance", "DIFFERENCES") == pytest.approx(distances, abs=1e-4)
    strict = run("comparemarks", FIRST_FOLDER=str(folders["layers"]), SECOND_FOLDER=str(folders[second]), LIMIT=0.1)
    assert (strict.results["WITHIN_LIMIT"], strict.column("verdict")) == (0, ["beyond"])


def test_measurements_that_can_not_be_compared(folders: dict[str, Path], tmp_path: Path) -> None:
    layers, micmac, layer = str(folders["layers"]), str(folders["micmac"]), in_pixels(measured_places(0, False))
    either = "Give each of the two measurements either as a layer or as a folder"
    assert_refused("comparemarks", either, SECOND_FOLDER=micmac)
    assert_refused("comparemarks", either, FIRST=layer, FIRST_FOLDER=layers, SECOND_FOLDER=micmac)
    empty = tmp_path / "empty"
    empty.mkdir()
    not_there = ((tmp_path / "gone", "does not exist"), ("x" * 5000, "does not exist"))
    for folder, words in ((empty, "holds neither layers"), *not_there):
        assert_sentence(run("comparemarks", FIRST=layer, SECOND_FOLDER=str(folder)).complaint, words)
    no_numbers = re.sub("<PtIm>[^<]*", "<PtIm>a b", measures(1, True))
    for text, words in (("<a", "can't be read"), (no_numbers, "has no column and row")):
        (empty / "MeasuresIm-1.xml").write_text(text, encoding="utf-8")
        assert_sentence(run("comparemarks", FIRST=layer, SECOND_FOLDER=str(empty)).complaint, words)
    same = str(folders["tables"] / "3.csv")
    assert_refused("comparemarks", "3.csv", FIRST_FOLDER=layers, SECOND_FOLDER=str(folders["tables"]), OUTPUT=same)
    twice = run("comparemarks", FIRST_FOLDER=layers, SECOND=points({"1": (1, 1), "2": (2, 2)}))
    assert_sentence(twice.complaint, "'1' twice")


def test_a_copy_of_a_photo_is_enhanced(tmp_path: Path) -> None:
    pixels = orthoimage((40, 60), 1)[0]
    photo = write_plain(tmp_path / "photo.bmp", pixels)
    outcome = run("enhancephoto", PHOTO=photo, OPERATION="negative", OUTPUT=str(tmp_path / "out.tif"))
    assert outcome.complaint is None
    assert (gdal.Open(outcome.results["OUTPUT"]).ReadAsArray() == 255 - pixels).all()
    assert_sentence(run("enhancephoto", PHOTO=photo, OPERATION="mean", SIZE=4).complaint, "odd number")
    assert_refused("enhancephoto", "does not exist", PHOTO="/nowhere/photo.tif", OPERATION="negative")
