"""``comparemarks`` and ``enhancephoto`` as QGIS runs them, and a batch of photos from the command line."""
from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsVectorLayer

from tests.numbers.synthetic import orthoimage, write_plain
from tests.qgis.photos.photo_scenes import make_photo, points
from tests.qgis.runs import assert_refused, assert_sentence, run

pytestmark = pytest.mark.usefixtures("provider")
PROGRAM = shutil.which("qgis_process.bin") or shutil.which("qgis_process")


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


def test_a_copy_of_a_photo_is_enhanced(tmp_path: Path) -> None:
    pixels = orthoimage((40, 60), 1)[0]
    photo = write_plain(tmp_path / "photo.bmp", pixels)
    outcome = run("enhancephoto", PHOTO=photo, OPERATION="negative", OUTPUT=str(tmp_path / "out.tif"))
    assert outcome.complaint is None
    assert (gdal.Open(outcome.results["OUTPUT"]).ReadAsArray() == 255 - pixels).all()
    assert_sentence(run("enhancephoto", PHOTO=photo, OPERATION="mean", SIZE=4).complaint, "odd number")
    assert_refused("enhancephoto", "does not exist", PHOTO="/nowhere/photo.tif", OPERATION="negative")


@pytest.mark.skipif(PROGRAM is None, reason="neither qgis_process.bin nor qgis_process is on the path")
def test_a_photo_that_fails_does_not_stop_the_rest(tmp_path: Path, repository: Path) -> None:
    """One call for each photo, as a batch makes them."""
    environment = {
        **os.environ, "QT_QPA_PLATFORM": "offscreen", "QGIS_PLUGINPATH": str(repository / "build" / "plugins"),
        "QGIS_CUSTOM_CONFIG_PATH": str(tmp_path / "settings"),
    }

    def call(*arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [str(PROGRAM), *arguments], env=environment, capture_output=True, text=True, timeout=300, check=False
        )

    call("plugins", "enable", "seam_inspector")
    scene = make_photo(tmp_path, seed=3, side=560)
    white = write_plain(tmp_path / "white.tif", np.full((300, 300), 255, np.uint8))
    codes = []
    for number, photo in enumerate((str(scene.photo), white, str(tmp_path / "lost.tif"), str(scene.photo))):
        output = tmp_path / f"marks{number}.gpkg"
        said = call(
            "run", "--json", "seaminspector:interiororientation", f"--PHOTO={photo}",
            f"--CALIBRATION={scene.calibration}", "--TEMPLATE_KIND=ring with cross", f"--OUTPUT={output}",
            f"--PARAMETERS={tmp_path / f'{number}.json'}", f"--REPORT={tmp_path / f'{number}.html'}",
        )
        codes.append(said.returncode)
        assert "Traceback" not in said.stdout + said.stderr
        if said.returncode == 0:
            assert json.loads(said.stdout[said.stdout.index("{") :])["results"]["FAILED"] == 0
            assert QgsVectorLayer(str(output), "marks", "ogr").featureCount() == 4
        else:
            assert "are alike" in said.stderr or "does not exist" in said.stderr
    assert [code == 0 for code in codes] == [True, False, False, True]
