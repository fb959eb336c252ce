"""RPC, model and points files, and grids of the geoid: against GDAL, to and fro, and as others write them."""
from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, osr
from seam_inspector.plugin.imagery.errors import RasterError, SensorModelError
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.sensors.measure import registry, rpc
from seam_inspector.plugin.sensors.measure.adjustment import adjust
from seam_inspector.plugin.sensors.measure.fit_files import FORMAT, ModelFile, load_model, save_model
from seam_inspector.plugin.sensors.measure.heights import above_ellipsoid
from seam_inspector.plugin.sensors.measure.points import control_points, file_points, image_points, write_point_file
from seam_inspector.plugin.sensors.measure.rpc import BiasedRpc, Domain, open_image, read_rpc, to_metadata, write_rpc
from seam_inspector.plugin.sensors.measure.sensor_model import SensorModel, reprojected

from tests.numbers.sensors.sensor_scenes import (
    COLUMNS,
    MIDDLE,
    ROWS,
    WGS84,
    made_pushbroom,
    made_rational,
    places,
    points,
)

DOMAIN = Domain((0, COLUMNS), (0, ROWS), (0, 1200), (MIDDLE[0], MIDDLE[1]))
UTM = "EPSG:32632"


def by_gdal(image: str | Path, ground: np.ndarray) -> np.ndarray:
    """The places where GDAL sees (n, 3) ground by the RPC of an image, or beside it, in its pixels."""
    if not Path(image).exists():
        gdal.GetDriverByName("GTiff").Create(str(image), 10, 10, 1).FlushCache()
    dataset = gdal.Open(str(image))
    assert dataset.GetMetadata("RPC")
    seen, sound = gdal.Transformer(dataset, None, ["METHOD=RPC"]).TransformPoints(1, ground.tolist())
    assert all(sound)
    return np.array(seen)[:, :2]


def fitted(kind: str) -> tuple[SensorModel, str]:
    """A model of a kind, and the system it is in."""
    ground = places(60, 2)
    made = {
        "pushbroom": made_pushbroom(1),
        "rpc_bias": BiasedRpc(made_rational(3, 2, 0.002), np.array([[3.0, -4], [1.0, 2], [-2, 1]])),
    }
    if kind in made:
        return made[kind], WGS84
    if kind == "rational in UTM":
        image = made_rational(1, 2, 0.002).project(ground)
        given = points(image, reprojected(ground, WGS84, UTM), None, UTM)
        return adjust(registry.RATIONAL.request(), given).fitted.model, UTM
    image = made_rational(1, 2, 0.0 if "polynomial" in kind else 0.002).project(ground)
    order = {"polynomial_3d": 2, "rational": 2}.get(kind, 1)
    return adjust(registry.KINDS[kind].request(str(order), "xy"), points(image, ground)).fitted.model, WGS84


KINDS = ("polynomial_3d", "rational", "dlt", "pushbroom", "rpc_bias", "rational in UTM")


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_gdal_sees_every_model_in_space_where_it_sees_itself(kind: str, tmp_path: Path) -> None:
    model, wkt = fitted(kind)
    domain = DOMAIN
    if wkt == UTM:
        middle = reprojected(MIDDLE[None], WGS84, UTM)[0]
        domain = Domain(DOMAIN.columns, DOMAIN.rows, DOMAIN.heights, (middle[0], middle[1]))
    made = rpc.rpc_of(model, wkt, domain)
    assert (made.max_px == 0) == (kind in ("polynomial_3d", "rational", "dlt"))
    assert made.max_px < 0.005
    ground = places(200, 8)
    seen = model.project(reprojected(ground, WGS84, UTM) if wkt == UTM else ground)
    inside = (seen > 0).all(axis=1) & (seen[:, 0] < COLUMNS) & (seen[:, 1] < ROWS)
    assert inside.sum() > 50
    rpc.write_rpc(made.rpc, tmp_path / "image_RPC.TXT")
    assert np.abs(by_gdal(tmp_path / "image.tif", ground[inside]) - seen[inside]).max() < 0.01


def test_vendor_files_are_read_as_gdal_reads_them(data_folder: Path, tmp_path: Path) -> None:
    folder = data_folder / "sensors" / "pleiades"
    ground = np.array([[5.25, 44.15, 900.0], [5.3, 44.1, 1500.0], [5.2, 44.2, 400.0]])
    dimap = rpc.read_rpc(folder / "RPC_PHR1B_P_201308051042194_SEN_690908101-001.XML")
    geom = rpc.read_rpc(folder / "left_image.geom")
    assert np.abs(dimap.project(ground) - geom.project(ground)).max() < 1e-4
    # GDAL's own reader of DIMAP wants the vendor's names beside the image.
    name = "IMG_PHR1B_P_201308051042194_SEN_690908101-001_R1C1.TIF"
    for kind in ("RPC", "DIM"):
        vendor = folder / "RPC_PHR1B_P_201308051042194_SEN_690908101-001.XML"
        target = tmp_path / vendor.name.replace("RPC_", f"{kind}_", 1)
        target.write_bytes(vendor.read_bytes())
    assert np.abs(by_gdal(tmp_path / name, ground) - dimap.project(ground)).max() < 1e-6
    image = open_image(RasterRef(str(data_folder / "sensors" / "worldview3" / "wv3_20.NTF")))
    ntf = rpc.own_rpc(image)
    place = np.array([[float(ntf.ground.offset[0]), float(ntf.ground.offset[1]), 40.0]])
    assert np.abs(by_gdal(image.ref.path, place) - ntf.project(place)).max() < 1e-6
    beside = rpc.own_rpc(open_image(RasterRef(str(folder / "left_image.tif"))))
    assert beside is not None  # OSSIM's .geom


def test_dimap_is_read_with_namespaces_and_in_its_encoding_but_not_with_entities(
    data_folder: Path, tmp_path: Path
) -> None:
    vendor = data_folder / "sensors" / "pleiades" / "RPC_PHR1B_P_201308051042194_SEN_690908101-001.XML"
    plain, text, ground = rpc.read_rpc(vendor), vendor.read_text(), np.array([[5.25, 44.15, 900.0]])
    path = tmp_path / "RPC.XML"
    spaced = text.replace("<Dimap_Document>", '<d:Dimap_Document xmlns="urn:a" xmlns:d="urn:b">')
    spaced = spaced.replace("</Dimap_Document>", "</d:Dimap_Document>").replace('"UTF-8"', '"UTF-16"')
    path.write_text(spaced, encoding="utf-16")
    assert np.array_equal(rpc.read_rpc(path).project(ground), plain.project(ground))
    declared = '<!DOCTYPE d [<!ENTITY e "0.1">]>\n<Dimap_Document>'
    lacking = text.replace("LINE_OFF>", "LINE_OF>")
    no_number = text.replace("<LINE_OFF>", "<LINE_OFF>x")
    for wrong in (text.replace("<Dimap_Document>", declared), lacking, no_number, text[:-40], "<Dimap_Document/>"):
        assert wrong != text
        path.write_text(wrong)
        with pytest.raises(SensorModelError, match=r"RPC\.XML holds no complete RPC"):
            rpc.read_rpc(path)


@pytest.mark.parametrize("content", ["", "LINE_OFF: 3\n", "<Rational_Function_Model></Rational_Function_Model>"])
def test_a_file_that_is_no_rpc_is_refused(tmp_path: Path, content: str) -> None:
    path = tmp_path / "wrong_RPC.TXT"
    path.write_text(content)
    with pytest.raises(SensorModelError, match=r"wrong_RPC\.TXT holds no complete RPC"):
        rpc.read_rpc(path)
    with pytest.raises(SensorModelError, match="does not exist"):
        rpc.read_rpc(tmp_path / "lost.txt")


@pytest.mark.slow
@pytest.mark.parametrize("kind", [*KINDS, "polynomial_2d"])
def test_a_model_file_gives_the_model_back(kind: str, tmp_path: Path) -> None:
    model, wkt = fitted(kind)
    path = tmp_path / "model.json"
    save_model(ModelFile(model, wkt, DOMAIN, {"condition": np.float64(3), "sigma_px": float("nan")}), path)
    again = load_model(path)
    ground = places(20, 1)
    assert np.array_equal(again.model.project(ground), model.project(ground))
    assert (again.wkt, again.domain) == (wkt, DOMAIN)
    assert again.facts == {"condition": 3.0, "sigma_px": None}
    assert type(again.model) is type(model)


def test_a_wrong_model_file_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "model.json"
    model, wkt = fitted("rational")
    save_model(ModelFile(model, wkt, DOMAIN, {}), path)
    document = json.loads(path.read_text())
    for change, words in (
        ({"version": 99}, "is of version 99"),
        ({"format": "other"}, "is not a sensor model file"),
        ({"model": "unknown"}, "is not a sensor model file"),
        ({"parameters": {}}, "is not a sensor model file"),
        ({"parameters": {**document["parameters"], "denominators": []}}, "is not a sensor model file"),
        ({"parameters": {**document["parameters"], "order": 1}}, "is not a sensor model file"),
        ({"domain": {"columns": [1]}}, "is not a sensor model file"),
    ):
        assert document["format"] == FORMAT
        path.write_text(json.dumps({**document, **change}))
        with pytest.raises(SensorModelError, match=words):
            load_model(path)
    path.write_text("no json")
    with pytest.raises(SensorModelError, match="is not a sensor model file"):
        load_model(path)


OLD = "mapX,mapY,pixelX,pixelY,enable,dX,dY,residual\n{rows}"
NEW = '#CRS: GEOGCRS["WGS 84",ID["EPSG",4326]]\nmapX,mapY,sourceX,sourceY,enable,dX,dY,residual\n{rows}'
ROWS_OF_FILE = "7.1,43.6,120.5,-30.25,1,0,0,0\n7.2,43.7,50,-60,0,0,0,0\n7.3,43.8,0,-1,1,0.1,0.2,0.3\n"


@pytest.mark.parametrize(("layout", "wkt"), [(OLD, ""), (NEW, 'GEOGCRS["WGS 84",ID["EPSG",4326]]')])
def test_points_files_old_and_new(tmp_path: Path, layout: str, wkt: str) -> None:
    path = tmp_path / "image.points"
    path.write_text(layout.format(rows=ROWS_OF_FILE))
    for plain in (None, (0.0, 1.0, 0.0, 0.0, 0.0, 1.0)):
        points, notices = file_points(path, "EPSG:32632", plain)
        assert points.wkt == (wkt or "EPSG:32632")
        assert points.ids == ("1", "3")
        assert [*map(str, notices)] == ["Points that are switched off in the georeferencer and left out: 1."]
        np.testing.assert_array_equal(points.ground, [[7.1, 43.6, np.nan], [7.3, 43.8, np.nan]])
        np.testing.assert_array_equal(points.image, [[120.5, 30.25], [0.0, 1.0]])
    path.write_text(layout.format(rows="7.1,43.6,5010.0,4980.0,1\n"))
    np.testing.assert_array_equal(file_points(path, UTM, (5e3, 2.0, 0.0, 5e3, 0.0, -2.0))[0].image, [[5.0, 10.0]])
    if not wkt:
        with pytest.raises(SensorModelError, match="names no coordinate reference system"):
            file_points(path, "", None)


def test_a_wrong_points_file_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "image.points"
    for content, words in (
        ("", "is not a points file"),
        ("a,b\n1,2\n", "is not a points file"),
        *((OLD.format(rows=f"7.1,43.6,120.5,-30.25,1\n7.2,{number},3,4,1\n"), "Line 3 of image.points can't be read")
          for number in ("nan", "inf", "x")),
        (OLD.format(rows="7.1,43.6\n"), "Line 2 of image.points"),
    ):
        path.write_text(content)
        with pytest.raises(SensorModelError, match=words):
            file_points(path, UTM, None)


def test_an_rpc_is_fitted_to_a_hundred_metres_of_height_at_least() -> None:
    for heights, fitted in (((700, 702), (651, 751)), ((0, 900), (0, 900)), ((-20, 79), (-20.5, 79.5))):
        assert rpc.rpc_heights(Domain((0, COLUMNS), (0, ROWS), heights, (0, 0))) == fitted


def image_file(path: Path) -> str:
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), 30, 20, 2, gdal.GDT_UInt16)
    dataset.WriteArray(np.arange(1200, dtype=np.uint16).reshape(2, 20, 30))
    dataset.FlushCache()
    return str(path)


def assert_same_rpc(items: dict[str, str], expected: dict[str, str]) -> None:
    for name, value in expected.items():
        np.testing.assert_allclose(
            np.array(items[name].split(), float), np.array(value.split(), float), rtol=1e-9, atol=1e-12, err_msg=name
        )


@pytest.mark.parametrize("name", ["image.RPB", "image_RPC.TXT"])
def test_gdal_reads_an_rpc_beside_its_image(tmp_path: Path, name: str) -> None:
    rpc = made_rational(3, 4)
    write_rpc(rpc, tmp_path / name)
    assert_same_rpc(gdal.Open(image_file(tmp_path / "image.tif")).GetMetadata("RPC"), to_metadata(rpc))
    assert_same_rpc(to_metadata(read_rpc(tmp_path / name)), to_metadata(rpc))


@pytest.mark.parametrize("transform", [None, (500.0, 2.0, 0.1, 900.0, 0.2, -3.0), (0.0, 1.0, 0.0, 0.0, 0.0, 1.0)])
def test_points_come_back_from_the_georeferencers_file(
    tmp_path: Path, transform: tuple[float, ...] | None
) -> None:
    image, ground = np.array([[1.5, 2.25], [10.0, 7.0]]), np.array([[7.1, 43.6, 1.0], [7.2, 43.7, 2.0]])
    points, path = control_points(["1", "2"], image, ground, "EPSG:4326"), tmp_path / "image.points"
    write_point_file(path, points, np.array([True, True]), np.array([[3.0, -4.0], [0.0, 0.0]]), transform)
    points, notices = file_points(path, "", transform)
    np.testing.assert_allclose(points.image, image, atol=1e-9)
    np.testing.assert_array_equal(points.ground[:, :2], ground[:, :2])
    assert (points.wkt, notices) == ("EPSG:4326", [])
    lines = path.read_text().splitlines()
    assert lines[1] == "mapX,mapY,sourceX,sourceY,enable,dX,dY,residual"
    assert lines[2].split(",")[4:] == ["1", "3.0", "-4.0", "5.0"]


def test_points_inside_a_tiff(tmp_path: Path) -> None:
    path = tmp_path / "gcps.tif"
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), 30, 20, 1)
    system = osr.SpatialReference()
    system.ImportFromEPSG(32632)
    dataset.SetGCPs([gdal.GCP(5e5, 4e6, 0, 1.5, 2.5), gdal.GCP(5.1e5, 4.1e6, 0, 10, 4)], system.ExportToWkt())
    dataset = None
    points = image_points(open_image(RasterRef(str(path))))
    np.testing.assert_allclose(points.image, [[1.5, 2.5], [10, 4]])
    np.testing.assert_allclose(points.ground[:, :2], [[5e5, 4e6], [5.1e5, 4.1e6]])
    assert np.isnan(points.ground[:, 2]).all()  # GDAL's 0 stands for a height that is not known
    with pytest.raises(SensorModelError, match="holds no sound ground control points"):
        image_points(open_image(RasterRef(image_file(tmp_path / "image.tif"))))


def egm96_file(path: Path, first: float = -180.0) -> str:
    """The undulation of EGM96 by PROJ on a grid of a degree."""
    longitude, latitude = np.meshgrid(first + np.arange(361.0), 85 - np.arange(171.0))
    places = np.column_stack([longitude.ravel(), latitude.ravel(), np.zeros(longitude.size)])
    places[:, 0] = (places[:, 0] + 180) % 360 - 180
    heights = above_ellipsoid(places, "EPSG:5773").reshape(longitude.shape)
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), 361, 171, 1, gdal.GDT_Float32)
    dataset.SetGeoTransform((first - 0.5, 1, 0, 85.5, 0, -1))
    dataset.SetProjection('GEOGCS["WGS 84",DATUM["WGS_1984",SPHEROID["WGS 84",6378137,298.257223563]],'
                          'PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]]')
    dataset.GetRasterBand(1).WriteArray(heights)
    dataset.FlushCache()
    return str(path)


@pytest.mark.parametrize("first", [-180.0, 0.0])
def test_a_grid_of_ones_own_is_added(tmp_path: Path, first: float) -> None:
    """At the grid's own nodes it is what PROJ has, whichever longitude the file begins at."""
    nodes = np.array([[7, 43, 10.0], [-70, -12, 20.0], [179, 60, 0.0], [-180, 0, 0.0]])
    heights = above_ellipsoid(nodes, RasterRef(egm96_file(tmp_path / "geoid.tif", first)))
    np.testing.assert_allclose(heights, above_ellipsoid(nodes, "EPSG:5773"), atol=1e-4)


def test_what_is_no_grid_of_the_geoid_says_so(tmp_path: Path) -> None:
    places = np.array([[7.1, 43.6, 0.0]])
    with pytest.raises(RasterError, match="is not a geoid grid"):
        above_ellipsoid(places, RasterRef(image_file(tmp_path / "image.tif")))
    west = gdal.Translate(str(tmp_path / "w.tif"), egm96_file(tmp_path / "g.tif"), projWin=(-90, 60, -60, 20))
    west = None
    assert west is None
    with pytest.raises(RasterError, match="has no values at some of the places"):
        above_ellipsoid(places, RasterRef(str(tmp_path / "w.tif")))
