"""A block of photos in one run, by its reconstruction alone."""
from __future__ import annotations

import json
import os
import shutil
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal

from tests.numbers.sensors.test_orientation_files import odm
from tests.numbers.synthetic import wkt
from tests.qgis.runs import Log, assert_sentence, run, run_unchecked

pytestmark = pytest.mark.usefixtures("provider", "project")


def raster(path: Path, values: np.ndarray, place: tuple[float, ...] = (), system: int = 0) -> None:
    path.parent.mkdir(exist_ok=True)
    bands, rows, columns = values.shape
    file = gdal.GetDriverByName("GTiff").Create(str(path), columns, rows, bands, gdal.GDT_Float32)
    if place:
        file.SetGeoTransform(place)
        file.SetProjection(wkt(system))
    file.WriteArray(values.astype(np.float32))


@pytest.fixture
def project_folder(tmp_path: Path) -> Path:
    """An OpenDroneMap project of two photos and a terrain, a photo that is not there, and one without orientation."""
    folder = tmp_path / "block"
    folder.mkdir()
    path = odm(folder) / "opensfm" / "reconstruction.json"
    content = json.loads(path.read_text())
    shots = content[0]["shots"]
    shots["IMG_3.jpg"] = shots["IMG_4.jpg"] = shots["IMG_2.jpg"]
    path.write_text(json.dumps(content))
    ramp = np.stack(np.meshgrid(np.arange(400) + 0.5, np.arange(300) + 0.5))
    for name in ("IMG_2.tif", "img_3.TIF", "IMG_8.tif"):
        raster(folder / "images" / name, ramp)
    raster(folder / "odm_dem" / "dsm.tif", np.full((1, 150, 150), 400.0), (498_800, 20, 0, 5_542_200, 0, -20), 32633)
    return folder


def test_a_project_is_one_parameter_and_one_run(project_folder: Path, tmp_path: Path) -> None:
    reconstruction = project_folder / "opensfm" / "reconstruction.json"
    ways = {"PHOTOS": project_folder}, {"EXTERIOR": project_folder}, {"EXTERIOR": reconstruction}
    for number, given in enumerate(ways):
        output = tmp_path / f"orthos{number}"
        made = run("orthorectifyphotos", OUTPUT=str(output), **{name: str(path) for name, path in given.items()})
        assert made.complaint is None
        assert (made.results["PHOTO_COUNT"], made.results["LEFT_OUT_COUNT"]) == (2, 1)
        assert any("IMG_4.jpg is oriented and is not in" in line for line in made.log.warnings)
        assert sum("dsm.tif" in line for line in made.log.infos) == 1
        assert sum("with the offset of coords.txt" in line for line in made.log.infos) == 1
        orthos = [gdal.Open(str(output / name)) for name in ("IMG_2.tif", "img_3.tif")]
        grids = [ortho.GetGeoTransform() for ortho in orthos]
        assert grids[0] == grids[1]
        assert orthos[0].ReadAsArray()[0].max() > 390
        np.testing.assert_array_equal(*(ortho.ReadAsArray() for ortho in orthos))


def test_a_photo_that_can_t_be_read_costs_none_of_the_others(project_folder: Path, tmp_path: Path) -> None:
    (project_folder / "images" / "IMG_2.tif").write_bytes(b"no image")
    made = run("orthorectifyphotos", EXTERIOR=str(project_folder), OUTPUT=str(tmp_path / "orthos"))
    assert (made.results["PHOTO_COUNT"], made.results["LEFT_OUT_COUNT"]) == (1, 2)
    assert any("IMG_2.tif is left out" in line for line in made.log.warnings)


def test_a_run_that_is_cancelled_is_told_as_cancelled(project_folder: Path, tmp_path: Path) -> None:
    stopped = Log()
    stopped.cancel()
    output = tmp_path / "orthos"
    made = run_unchecked("orthorectifyphotos", stopped, EXTERIOR=str(project_folder), OUTPUT=str(output))
    assert made.complaint is None
    assert "cancelled" in made.log.warnings[-1]
    assert not list(output.iterdir())


def test_the_terrain_model_is_not_written_over(project_folder: Path, tmp_path: Path) -> None:
    output = tmp_path / "orthos"
    output.mkdir()
    terrain, link = output / "IMG_2.tif", tmp_path / "terrain.tif"
    shutil.copy(project_folder / "odm_dem" / "dsm.tif", terrain)
    os.link(terrain, link)
    before = terrain.read_bytes()
    for dem in (terrain, link):
        refused = run("orthorectifyphotos", EXTERIOR=str(project_folder), DEM=str(dem), OUTPUT=str(output))
        assert_sentence(refused.complaint, "IMG_2.tif, which belongs to an input")
        assert terrain.read_bytes() == before


def test_what_can_t_be_done_is_said(project_folder: Path, tmp_path: Path) -> None:
    given = {"EXTERIOR": str(project_folder), "OUTPUT": str(tmp_path / "orthos")}
    for changed, words in (
        ({"OUTPUT": str(project_folder / "images")}, "would be written over"),
        ({"OUTPUT": str(project_folder / "opensfm" / "reconstruction.json")}, "can't be written"),
        ({"EXTERIOR": str(tmp_path / "nothing")}, "nothing"),
        ({"EXTERIOR": None}, "Choose the folder of an OpenDroneMap project"),
        ({"EXTERIOR": None, "PHOTOS": str(project_folder / "images")}, "Choose the folder of an OpenDroneMap project"),
        ({"HEIGHT": 5000}, "img_3.TIF is left out: The camera of"),
        ({"PHOTOS": str(project_folder / "opensfm")}, "None of the photos that reconstruction.json names"),
        ({"HEIGHT": 400, "DEM": str(project_folder / "odm_dem" / "dsm.tif")}, "Give either a terrain model or"),
    ):
        assert_sentence(run("orthorectifyphotos", **{**given, **changed}).complaint, words)
    (project_folder / "odm_dem" / "dsm.tif").unlink()
    assert_sentence(run("orthorectifyphotos", **given).complaint, "Give either a terrain model or")
    (project_folder / "opensfm" / "reconstruction.json").unlink()
    assert_sentence(run("orthorectifyphotos", **given).complaint, "OpenDroneMap project")
