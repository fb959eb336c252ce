"""The files of sensor models through QGIS: what other programs write is read, and what is written they read."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr, osr
from qgis.core import QgsProject

from tests.numbers.sensors.sensor_scenes import COLUMNS, ROWS
from tests.qgis.runs import assert_sentence, run
from tests.qgis.sensors.test_sensor_models import gcps, scene

pytestmark = pytest.mark.usefixtures("provider", "project")


def empty_image(path: Path) -> str:
    """An image as large as the scene, and sparse."""
    options = ["SPARSE_OK=TRUE", "TILED=YES"]
    gdal.GetDriverByName("GTiff").Create(str(path), int(COLUMNS), int(ROWS), 1, options=options).FlushCache()
    return str(path)


def test_a_fit_is_written_for_gdal_and_the_georeferencer(tmp_path: Path) -> None:
    image, ground = scene(12, 0.3)
    roles: list[str | None] = ["control"] * 9 + ["check"] * 3
    small = np.array([30.0, 20.0])
    image = image / [COLUMNS, ROWS] * small
    source = tmp_path / "image.tif"
    pixels = np.arange(600).reshape(20, 30) % 251
    gdal.GetDriverByName("GTiff").Create(str(source), 30, 20, 1).WriteArray(pixels.astype(np.uint8))
    files = {"RPC": "image.RPB", "RPC_IMAGE": "copy.tif", "POINTS": "image.points", "MODEL_FILE": "rpc.json"}
    written = {name: str(tmp_path / file) for name, file in files.items()}
    outcome = run(
        "fitsensormodel", GCPS=gcps(image, ground, roles), IMAGE=str(source), MODEL="rational", HEIGHTS="ellipsoid",
        **written,
    )
    assert {name: outcome.results[name] for name in files} == written
    moved = tmp_path / "elsewhere.tif"  # without whatever was written beside it
    moved.write_bytes((tmp_path / "copy.tif").read_bytes())
    np.testing.assert_array_equal(gdal.Open(str(moved)).ReadAsArray(), pixels)
    beside, inside = (gdal.Open(str(tmp_path / name)).GetMetadata("RPC") for name in ("image.tif", "elsewhere.tif"))
    for name in ("LINE_NUM_COEFF", "SAMP_DEN_COEFF", "LAT_OFF", "SAMP_SCALE"):
        pair = [np.array(items[name].split(), float) for items in (beside, inside)]
        np.testing.assert_allclose(*pair, rtol=1e-9, atol=1e-12)
    rows = [line.split(",") for line in (tmp_path / "image.points").read_text().splitlines()[2:]]
    assert [row[4] for row in rows] == ["1"] * 9 + ["0"] * 3
    residuals = np.array([[row["residual_column"], row["residual_row"]] for row in outcome.rows()])
    np.testing.assert_allclose(np.array(rows)[:, 5:7].astype(float), residuals)
    again = run("fitsensormodel", GCPS=written["POINTS"], IMAGE=str(source), MODEL="polynomial_2d", CHECK_SHARE=0)
    assert again.results["CONTROL_COUNT"] == 9


def test_points_inside_a_tiff_are_read(project: QgsProject, tmp_path: Path) -> None:
    """One set of points as a layer and as the tags of a TIFF: the same fit."""
    image, ground = scene(12, 0.3)
    tiff = empty_image(tmp_path / "scene.tif")
    dataset = gdal.Open(tiff, gdal.GA_Update)
    system = osr.SpatialReference()
    system.ImportFromEPSG(4326)
    points = [gdal.GCP(*map(float, (*position, *place))) for place, position in zip(image, ground)]
    dataset.SetGCPs(points, system.ExportToWkt())
    dataset = None
    common = {"MODEL": "rational", "IMAGE": tiff, "CHECK_SHARE": 0, "RPC_IMAGE": None}
    layer = run("fitsensormodel", GCPS=gcps(image, ground), HEIGHTS="ellipsoid", **common).results
    for given in ({"GCPS": tiff}, {}):
        outcome = run("fitsensormodel", **given, **common)
        assert outcome.complaint is None
        assert outcome.results["CONTROL_COUNT"] == 12
        assert outcome.results["CONTROL_RMSE_X"] == pytest.approx(layer["CONTROL_RMSE_X"], rel=1e-6)
    assert_sentence(run("fitsensormodel", MODEL="rational").complaint, "There are no points")


@pytest.mark.parametrize("of_file", [False, True])
def test_the_vertical_part_of_a_compound_system_is_used(tmp_path: Path, of_file: bool) -> None:
    """A system as the code of a layer, and in a file, where QGIS forgets it: the same as egm96 said outright."""
    image, ground = scene(12, 0.3)
    layer: object = gcps(image, ground, system="EPSG:9707")  # WGS 84 + EGM96 height
    if of_file:
        system = osr.SpatialReference()
        system.SetFromUserInput("EPSG:4326+5773")
        file = ogr.GetDriverByName("GPKG").CreateDataSource(str(tmp_path / "points.gpkg"))
        table = file.CreateLayer("points", system, ogr.wkbPoint25D)
        for name in ("column", "row"):
            table.CreateField(ogr.FieldDefn(name, ogr.OFTReal))
        for place, position in zip(image, ground):
            row = ogr.Feature(table.GetLayerDefn())
            row["column"], row["row"] = map(float, place)
            row.SetGeometry(ogr.CreateGeometryFromWkt("POINT Z ({} {} {})".format(*position)))
            table.CreateFeature(row)
        table = file = row = None
        layer = str(tmp_path / "points.gpkg")
    by_system = run("fitsensormodel", GCPS=layer, MODEL="rational", CHECK_SHARE=0)
    said = run("fitsensormodel", GCPS=gcps(image, ground), HEIGHTS="egm96", MODEL="rational", CHECK_SHARE=0)
    assert any("EGM96" in line and "are converted to the ellipsoid" in line for line in by_system.log.infos)
    heights = [[row["z"] for row in outcome.rows()] for outcome in (by_system, said)]
    assert heights[0] == pytest.approx(heights[1])
    assert np.abs(np.array(heights[0]) - ground[:, 2]).min() > 30


def test_a_grid_of_the_geoid_is_asked_for_and_used(tmp_path: Path) -> None:
    image, ground = scene(12, 0.3)
    grid = str(tmp_path / "it's a geoid.tif")
    dataset = gdal.GetDriverByName("GTiff").Create(grid, 20, 20, 1, gdal.GDT_Float32)
    dataset.SetGeoTransform((6, 0.2, 0, 45, 0, -0.2))
    dataset.GetRasterBand(1).Fill(50)
    dataset = None  # closes the file
    layer = gcps(image, ground)
    outcome = run("fitsensormodel", GCPS=layer, MODEL="rational", CHECK_SHARE=0, HEIGHTS="geoid", GEOID=grid)
    assert [row["z"] for row in outcome.rows()] == pytest.approx(ground[:, 2] + 50)
    for given in ({"HEIGHTS": "geoid"}, {"GEOID": grid}):
        assert_sentence(run("fitsensormodel", GCPS=layer, MODEL="rational", **given).complaint, "give both or neither")
