"""The algorithms of sensor models through QGIS: their contracts, their files and those of other programs, bad input."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal, ogr, osr
from qgis.core import QgsFeature, QgsGeometry, QgsPoint, QgsPointXY, QgsProject, QgsVectorLayer
from seam_inspector.plugin.sensors.measure.rpc import write_rpc

from tests.numbers.sensors.sensor_scenes import COLUMNS, ROWS, WGS84, made_rational, places, pleiades_grid, ten_spread
from tests.numbers.synthetic import write_raster
from tests.qgis.runs import Log, assert_refused, assert_sentence, run

pytestmark = pytest.mark.usefixtures("provider", "project")

NOISE = 0.3
NUMBERS = [f"{group}_{kind}_{axis}" for group in ("CHECK", "CONTROL") for kind in ("RMSE", "MAX") for axis in "XY"]


def gcps(
    image: np.ndarray, ground: np.ndarray, roles: list[str | None] | None = None, system: str = WGS84, **fields: Any
) -> QgsVectorLayer:
    """A point layer as the algorithms want it; ``fields`` are further columns of texts or numbers."""
    kinds = "".join(f"&field={name}:{'string' if name == 'id' else 'double'}" for name in fields)
    kinds = f"&field=column:double&field=row:double&field=role:string{kinds}"
    layer = QgsVectorLayer(f"PointZ?crs={system}{kinds}", "gcps", "memory")
    rows = []
    for index, ((column, row), (x, y, z)) in enumerate(zip(image, ground)):
        feature = QgsFeature(layer.fields())
        role = roles[index] if roles else None
        feature.setAttributes([float(column), float(row), role, *(values[index] for values in fields.values())])
        point = QgsGeometry(QgsPoint(x, y, z)) if np.isfinite(z) else QgsGeometry.fromPointXY(QgsPointXY(x, y))
        feature.setGeometry(point)
        rows.append(feature)
    layer.dataProvider().addFeatures(rows)
    return layer


def scene(count: int = 60, noise: float = NOISE) -> tuple[np.ndarray, np.ndarray]:
    ground = places(count, 3)
    image = made_rational(1, 2, 0.001).project(ground)
    return image + np.random.default_rng(3).normal(0, noise, image.shape), ground


def test_fit_keeps_its_contract(project: QgsProject, tmp_path: Path) -> None:
    image, ground = scene()
    image[7] += 40
    roles: list[str | None] = ["control"] * 30 + ["check"] * 30
    names = [f"p{index}" for index in range(60)]
    files = {"MODEL_FILE": tmp_path / "m.json", "RPC": tmp_path / "image_RPC.TXT", "REPORT": tmp_path / "r.html"}
    outcome = run(
        "fitsensormodel", GCPS=gcps(image, ground, roles, id=names), MODEL="rational", ORDER=1, ROBUST=True,
        HEIGHTS="ellipsoid", **{name: str(path) for name, path in files.items()},
    )
    assert outcome.complaint is None
    rows = outcome.rows()
    assert list(rows[0]) == [
        "id", "role", "column", "row", "z", "residual_column", "residual_row", "residual_x", "residual_y", "blunder"
    ]  # fmt: skip
    assert [row["id"] for row in rows] == names
    assert rows[7]["blunder"] == 1
    assert sum(row["blunder"] for row in rows) <= 3
    assert rows[7]["residual_column"] == pytest.approx(-40, abs=3)
    results = outcome.results
    kept = [row for row in rows if row["role"] == "check" and not row["blunder"]]
    assert results["CHECK_COUNT"] == len(kept)
    for axis in "XY":
        residuals = np.array([row[f"residual_{axis.lower()}"] for row in kept])
        assert results[f"CHECK_RMSE_{axis}"] == pytest.approx(np.sqrt(np.mean(residuals**2)))
        assert results[f"CHECK_MAX_{axis}"] == pytest.approx(np.abs(residuals).max())
    assert set(NUMBERS) | {"CONTROL_COUNT", "CONDITION"} <= set(results)
    assert any("Blunders found and left out of fit and errors" in line for line in outcome.log.warnings)
    document = json.loads(files["MODEL_FILE"].read_text())
    assert (document["version"], document["model"], "p7" in document["facts"]["blunders"]) == (1, "rational", True)
    gdal.GetDriverByName("GTiff").Create(str(tmp_path / "image.tif"), 4, 4, 1).FlushCache()
    transformer = gdal.Transformer(gdal.Open(str(tmp_path / "image.tif")), None, ["METHOD=RPC"])
    seen = np.array(transformer.TransformPoints(1, ground.tolist())[0])[:, :2]
    residuals = np.array([[row["residual_column"], row["residual_row"]] for row in rows])
    assert np.abs(seen - image - residuals).max() < 0.01
    report = files["REPORT"].read_text()
    assert "<svg" in report or "image/svg+xml" in report
    assert "p7" in report


def test_the_bias_of_an_rpc_is_the_result(tmp_path: Path) -> None:
    """In the outputs, the log and the report, to what was put in."""
    ground = places(12, 3)
    rpc = made_rational(3, 5, 0.001)
    write_rpc(rpc, tmp_path / "vendor_RPC.TXT")
    outcome = run(
        "fitsensormodel", GCPS=gcps(rpc.project(ground) + [3.5, -1.25], ground), MODEL="rpc_bias", BIAS="shift",
        IMAGE_RPC=str(tmp_path / "vendor_RPC.TXT"), HEIGHTS="ellipsoid", REPORT=str(tmp_path / "r.html"),
    )
    assert outcome.results["BIAS_COLUMN"] == pytest.approx(3.5, abs=1e-6)
    assert outcome.results["BIAS_ROW"] == pytest.approx(-1.25, abs=1e-6)
    words = "off by 3.50 columns and -1.25 rows"
    assert words in (tmp_path / "r.html").read_text(encoding="utf-8")
    assert any(words in line for line in outcome.log.infos)


def test_points_files_take_heights_from_the_terrain_model(tmp_path: Path, data_folder: Path) -> None:
    dem = data_folder / "sensors" / "pleiades" / "N44E005.hgt"
    ground = places(20, 1) - [1.9, -0.5, 0]  # onto the tile
    transform = gdal.Open(str(dem)).GetGeoTransform()
    heights = gdal.Open(str(dem)).ReadAsArray()
    column = (ground[:, 0] - transform[0]) / transform[1]
    row = (ground[:, 1] - transform[3]) / transform[5]
    ground[:, 2] = heights[row.astype(int), column.astype(int)]
    image = made_rational(1, 2, 0.001).project(ground + [1.9, -0.5, 0])
    path = tmp_path / "image.points"
    lines = [f"{x},{y},{c},{-r},1,0,0,0" for (x, y, _), (c, r) in zip(ground, image)]
    path.write_text("\n".join(["mapX,mapY,sourceX,sourceY,enable", *lines]) + "\n")
    given = {"GCPS": str(path), "MODEL": "polynomial_3d", "DEM": str(dem), "DEM_HEIGHTS": "egm96"}
    assert_refused("fitsensormodel", "names no coordinate reference system", **given)
    outcome = run("fitsensormodel", GCPS_CRS="EPSG:4326", **given)
    assert outcome.complaint is None
    assert outcome.results["CONTROL_COUNT"] == 15
    assert outcome.column("z") == pytest.approx(list(ground[:, 2] + 51), abs=80)  # bilinear, and the geoid
    assert any("converted to the ellipsoid" in line for line in outcome.log.infos)
    path.write_text("#CRS: EPSG:4326\n" + path.read_text())
    assert run("fitsensormodel", **given).complaint is None


def test_comparison_gives_the_table_and_a_reason(data_folder: Path, tmp_path: Path) -> None:
    nodes = ten_spread(pleiades_grid(data_folder), np.random.default_rng(0))
    layer = gcps(nodes[:, :2] + np.random.default_rng(1).normal(0, NOISE, (10, 2)), nodes[:, 2:])
    rpc = data_folder / "sensors" / "pleiades" / "RPC_P1BP--2017092838284574CP.XML"
    report = tmp_path / "report.html"
    outcome = run(
        "comparesensormodels", GCPS=layer, CHECK_SHARE=0, HEIGHTS="ellipsoid", IMAGE_RPC=str(rpc), REPORT=str(report)
    )
    assert outcome.complaint is None
    rows = {(row["model"], row["order"], row["variant"]): row for row in outcome.rows()}
    assert len(rows) == 16
    assert {row["method"] for row in rows.values()} == {"leave_one_out"}
    assert outcome.results["RECOMMENDED"] == "rpc_bias shift"
    assert rows["rpc_bias", None, "shift"]["recommended"] == 1
    assert rows["rpc_bias", None, "shift"]["mean_x"] < 0.5 < rows["polynomial_2d", 1, None]["mean_x"]
    assert "needs at least 19" in rows["rational", 2, None]["reason"]
    assert outcome.results["RECOMMENDATION"] in outcome.log.infos
    assert "rpc_bias" in report.read_text()


def test_orthorectify_with_model_file_and_rpc(data_folder: Path, tmp_path: Path) -> None:
    folder = data_folder / "sensors" / "pleiades"
    given = {"IMAGE": str(folder / "left_image.tif"), "DEM": str(folder / "N44E005_UTM.tif"), "DEM_HEIGHTS": "egm96"}
    vendor = str(folder / "RPC_PHR1B_P_201308051042194_SEN_690908101-001.XML")
    outcome = run("orthorectify", RPC=vendor, OUTPUT=str(tmp_path / "a.tif"), CRS="EPSG:32631", PIXEL_SIZE=1, **given)
    assert outcome.complaint is None
    dataset = gdal.Open(outcome.results["OUTPUT"])
    assert dataset.GetGeoTransform()[1] == 1
    assert outcome.results["ERROR_MAX"] < 0.1
    assert outcome.results["UNCOVERED"] == 0
    again = run("orthorectify", OUTPUT=str(tmp_path / "b.tif"), CRS="EPSG:32631", PIXEL_SIZE=1, **given)  # its .geom
    assert np.array_equal(gdal.Open(again.results["OUTPUT"]).ReadAsArray(), dataset.ReadAsArray())


@pytest.mark.parametrize("missing", [np.nan, np.inf])
def test_a_point_without_height_shuts_out_no_model_in_space(missing: float) -> None:
    image, ground = scene(25, 0.1)
    heights = ground[:, 2].copy()
    heights[6] = missing
    layer = gcps(image, ground * [1, 1, np.nan], z=heights.tolist())
    compared = run("comparesensormodels", GCPS=layer, HEIGHTS="ellipsoid")
    assert compared.complaint is None
    assert not compared.results["RECOMMENDED"].startswith("polynomial_2d")
    fitted = run("fitsensormodel", GCPS=layer, HEIGHTS="ellipsoid", CHECK_SHARE=0)
    assert fitted.results["CONTROL_COUNT"] == 24
    for outcome in (compared, fitted):
        assert [line for line in outcome.log.warnings if "left out" in line] == [
            "Point 7 is left out: it has no height, and no terrain model has one there."
        ]


def test_a_row_per_number_of_points_from_the_fewest_on() -> None:
    log = Log()
    outcome = run("planpoints", log, MODEL="polynomial_3d 1", COUNTS="12; 6 12", SIGMA=0.3)
    assert outcome.complaint is None
    rows = outcome.rows("OUTPUT")
    assert [row["control_count"] for row in rows] == [6, 12]
    assert rows[0]["image_50"] > rows[1]["image_50"]
    assert all(row["image_50"] <= row["image_90"] and row["model"] == "polynomial_3d 1" for row in rows)


def test_an_rpc_is_planned_by(tmp_path: Path) -> None:
    path = tmp_path / "image_RPC.TXT"
    write_rpc(made_rational(3, 2), path)
    given = {"MODEL": "rpc_bias shift", "COUNTS": "1,9", "SIGMA": 0, "IMAGE_RPC": str(path),
             "LOWEST": 100, "HIGHEST": 900}  # fmt: skip
    few, many = run("planpoints", **given).rows("OUTPUT")
    assert few["image_50"] / many["image_50"] == pytest.approx(3, rel=0.35)


def test_what_can_not_be_planned_is_told(tmp_path: Path) -> None:
    plain = write_raster(tmp_path / "plain.tif", np.full((8, 8), 9, np.uint8))
    for counts in ("", "ten", "0", "5.5", "-3", "99999"):
        assert_refused("planpoints", "give whole numbers from 1 to 1000", COUNTS=counts or " ")
    assert_refused("planpoints", "needs at least", COUNTS="5", MODEL="rational 3")
    assert_refused("planpoints", "no RPC", COUNTS="5", MODEL="rpc_bias shift")
    assert_refused("planpoints", "no RPC to plan by", COUNTS="5", IMAGE=str(plain))
    assert_refused("planpoints", "give metres, the lowest first", COUNTS="5", LOWEST=400)
    assert_refused("planpoints", "give metres, the lowest first", COUNTS="5", HIGHEST=90000)


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
