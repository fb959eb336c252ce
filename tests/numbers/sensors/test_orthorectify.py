"""Orthoimages: they lie where the vendor's RPC puts them, and terrain models that do not fit say so."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal, osr
from scipy.ndimage import map_coordinates
from seam_inspector.plugin.imagery.errors import CancelledError, RasterError, SeamInspectorError, SettingsError
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.sensors.measure.heights import load_terrain
from seam_inspector.plugin.sensors.measure.orthorectification import Ortho, OrthoRequest, orthorectify, rpc_domain
from seam_inspector.plugin.sensors.measure.polynomials import Rational
from seam_inspector.plugin.sensors.measure.rpc import read_rpc, rpc_of_image_part
from seam_inspector.plugin.sensors.measure.sensor_model import Scaling

from tests.numbers.sensors.sensor_scenes import WGS84, made_pushbroom, made_rational
from tests.numbers.synthetic import wkt

MakeRaster = Callable[..., str]
SIDE = 400
RAMP = np.stack(np.meshgrid(np.arange(SIDE) + 0.5, np.arange(SIDE) + 0.5)).astype(np.float32)
"""An image whose two bands are its own columns and rows: an orthoimage of it tells where each pixel came from."""


def small_rpc() -> Rational:
    """Quotients that see a patch of 400 x 400 px of about 0.5 m, with relief displacement."""
    made = made_rational(3, 5, 0.002)
    image = Scaling(np.array([200.0, 200.0]), np.array([200.0, 200.0]))
    ground = Scaling(np.array([7.18, 43.67, 600.0]), np.array([0.00125, 0.0009, 300.0]))
    numerators = made.numerators.copy()
    numerators[3] = 0.9, 0.4
    return replace(made, image=image, ground=ground, numerators=numerators)


def terrain_file(path: Path, system: str | int = 4326, holes: bool = False, west: float = 7.17) -> str:
    """Hills around the patch on 20 m meshes."""
    step = 0.0002
    y, x = np.mgrid[0:120, 0:120]
    heights = (600 + 80 * np.sin(x / 9) * np.cos(y / 7)).astype(np.float32)
    if holes:
        heights[50:70, 45:60] = -9999
    dataset = gdal.GetDriverByName("GTiff").Create(str(path), 120, 120, 1, gdal.GDT_Float32)
    dataset.SetGeoTransform((west, step, 0, 43.682, 0, -step))
    dataset.SetProjection(wkt(system))
    dataset.GetRasterBand(1).SetNoDataValue(-9999)
    dataset.GetRasterBand(1).WriteArray(heights)
    dataset.FlushCache()
    return str(path)


@pytest.fixture
def job(tmp_path: Path, make_raster: MakeRaster) -> Callable[..., Ortho]:
    """Rectifies the ramp; parameters of the request by name."""
    image = make_raster("image.tif", RAMP, geotransform=(0.0, 1.0, 0.0, 0.0, 0.0, 1.0), system=None)

    def run(progress: Any = lambda share: None, cancelled: Any = lambda: False, **given: Any) -> Ortho:
        model = given.pop("model", small_rpc())
        domain = rpc_domain(small_rpc(), describe(RasterRef(image)))
        dem = given.pop("dem", None)
        defaults: dict[str, Any] = {
            "image": RasterRef(image), "model": model, "wkt": WGS84, "domain": domain, "datum": "ellipsoid",
            "dem": RasterRef(dem) if dem else None, "height": None, "output": tmp_path / "ortho.tif",
            "resampling": "bilinear",
        }  # fmt: skip
        return orthorectify(OrthoRequest(**{**defaults, **given}), progress, cancelled)

    return run


def came_from(ortho: Ortho) -> tuple[np.ndarray, np.ndarray]:
    """(n, 2) map coordinates of filled pixels and (n, 2) columns and rows that they were taken from."""
    dataset = gdal.Open(str(ortho.path))
    bands = dataset.ReadAsArray()
    left, step, _, top, _, _ = dataset.GetGeoTransform()
    row, column = np.nonzero((bands > 8).all(axis=0) & (bands < SIDE - 8).all(axis=0))
    places = np.column_stack([left + (column + 0.5) * step, top - (row + 0.5) * step])
    return places, bands[:, row, column].T


def on_ground(places: np.ndarray, system: str, dem: str) -> np.ndarray:
    """(n, 3) longitude, latitude and height of map places over a terrain model, by PROJ and scipy."""
    dataset = gdal.Open(dem)
    systems = [osr.SpatialReference() for _ in range(3)]
    for reference, name in zip(systems, (system, "EPSG:4326", dataset.GetProjection())):
        reference.SetFromUserInput(name)
        reference.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    geographic, on_dem = (
        np.array(osr.CoordinateTransformation(systems[0], target).TransformPoints(places.tolist()))
        for target in systems[1:]
    )
    left, step, _, top, _, down = dataset.GetGeoTransform()
    at = [(on_dem[:, 1] - top) / down - 0.5, (on_dem[:, 0] - left) / step - 0.5]
    return np.column_stack([geographic[:, :2], map_coordinates(dataset.ReadAsArray().astype(float), at, order=1)])


@pytest.mark.slow
def test_every_pixel_comes_from_where_the_model_sees_it(job: Callable[..., Ortho], tmp_path: Path) -> None:
    dem = terrain_file(tmp_path / "dem.tif")
    shares: list[float] = []
    ortho = job(progress=shares.append, dem=dem)
    places, seen = came_from(ortho)
    assert len(places) > 0.6 * SIDE**2
    assert np.abs(seen - small_rpc().project(on_ground(places, ortho.wkt, dem))).max() < 0.02
    assert ortho.max_px < 1e-3
    assert ortho.notices == ()
    assert shares[-1] == pytest.approx(1)
    assert shares == sorted(shares)


@pytest.mark.slow
def test_heights_above_sea_level_are_brought_to_the_ellipsoid(job: Callable[..., Ortho], tmp_path: Path) -> None:
    plain, named = terrain_file(tmp_path / "dem.tif"), terrain_file(tmp_path / "named.tif", "EPSG:4326+5773")
    raised = load_terrain(RasterRef(plain), (7.17, 43.66, 7.19, 43.68), "egm96")
    as_is = load_terrain(RasterRef(plain), (7.17, 43.66, 7.19, 43.68), "ellipsoid")
    undulation = raised.heights - as_is.heights
    assert undulation.min() > 45
    assert undulation.max() < 55  # the geoid in southern France
    for dem, datum in ((plain, "egm96"), (named, "auto")):
        ortho = job(dem=dem, datum=datum)
        places, seen = came_from(ortho)
        expected = small_rpc().project(on_ground(places, ortho.wkt, plain) + [0, 0, undulation.mean()])
        assert np.abs(seen - expected).max() < 0.05
        assert "converted to the ellipsoid" in str(ortho.notices[0])
    assert "does not say what its heights refer to" in str(job(dem=plain, datum="auto").notices[0])
    with pytest.raises(RasterError, match=r"PROJ has no grid .*AHD"):
        job(dem=terrain_file(tmp_path / "ahd.tif", "EPSG:4326+5711"), datum="auto")


def test_crop_size_format_and_extent(job: Callable[..., Ortho], tmp_path: Path) -> None:
    dem = terrain_file(tmp_path / "dem.tif")
    whole = job(dem=dem, target_wkt="EPSG:32632")
    middle = [(whole.grid.extent[i] + whole.grid.extent[i + 2]) / 2 for i in (0, 1)]
    extent = (middle[0] - 20, middle[1] - 10, middle[0] + 20, middle[1] + 10)
    part = job(dem=dem, target_wkt="EPSG:32632", extent=extent, pixel_size=2.0, format="COG", output=tmp_path / "c.tif")
    dataset = gdal.Open(str(part.path))
    assert (dataset.RasterXSize, dataset.RasterYSize) in [(21, 11), (20, 10), (21, 10), (20, 11)]
    assert dataset.GetGeoTransform()[1] == 2.0
    assert dataset.GetMetadataItem("LAYOUT", "IMAGE_STRUCTURE") == "COG"
    for given, words in (
        ({"extent": (0, 0, 10, 10), "target_wkt": "EPSG:32632"}, "extent lies outside"),
        ({"pixel_size": 0.0}, r"pixel size is 0\.0"),
        ({"pixel_size": 1e-9}, "choose larger pixels"),
        ({"pixel_size": float("nan")}, "give a positive number"),
        ({"pixel_size": float("inf")}, "give a positive number"),
        ({"dem": None, "height": float("nan")}, "are impossible on Earth"),
        ({"dem": None, "height": float("inf")}, "are impossible on Earth"),
    ):
        with pytest.raises(SeamInspectorError, match=words):
            job(**{"dem": dem, **given})


@pytest.mark.slow
def test_a_parametric_model_goes_through_an_rpc(job: Callable[..., Ortho], tmp_path: Path) -> None:
    model = made_pushbroom(1)
    height = 600.0
    image = describe(RasterRef(str(tmp_path / "image.tif")))
    domain = replace(rpc_domain(small_rpc(), image), heights=(500.0, 700.0))
    ortho = job(model=model, domain=domain, height=height, target_wkt="EPSG:4326")
    places, seen = came_from(ortho)
    expected = model.project(np.column_stack([places, np.full(len(places), height)]))
    assert np.abs(seen - expected).max() < 0.02
    assert ortho.max_px < 1e-3


def test_terrain_models_that_do_not_fit(job: Callable[..., Ortho], tmp_path: Path) -> None:
    with pytest.raises(RasterError, match="does not cover the image"):
        job(dem=terrain_file(tmp_path / "away.tif", west=20.0))
    with pytest.raises(SettingsError, match="Give either a terrain model or"):
        job()
    with pytest.raises(SettingsError, match="Give either a terrain model or"):
        job(dem=terrain_file(tmp_path / "dem.tif"), height=3.0)
    holed = job(dem=terrain_file(tmp_path / "holed.tif", holes=True))
    assert 0.01 < holed.uncovered < 0.9
    assert "has no heights under" in str(holed.notices[0])
    filled = job(dem=terrain_file(tmp_path / "dem.tif"))
    assert (gdal.Open(str(filled.path)).ReadAsArray()[0] > 0).sum() > len(came_from(holed)[0])


def test_cancelling_leaves_nothing(job: Callable[..., Ortho], tmp_path: Path) -> None:
    with pytest.raises(CancelledError):
        job(dem=terrain_file(tmp_path / "dem.tif"), cancelled=lambda: True)
    assert not (tmp_path / "ortho.tif").exists()
    with pytest.raises(SeamInspectorError, match="can't be written"):
        job(dem=terrain_file(tmp_path / "dem.tif"), output=tmp_path / "nowhere" / "ortho.tif")


@pytest.mark.parametrize("dem", ["N44E005.hgt", "N44E005_UTM.tif"])
def test_pleiades_over_srtm_lies_where_the_vendors_rpc_puts_it(data_folder: Path, tmp_path: Path, dem: str) -> None:
    folder = data_folder / "sensors" / "pleiades"
    image = describe(RasterRef(str(folder / "left_image.tif")))
    scene = read_rpc(folder / "RPC_PHR1B_P_201308051042194_SEN_690908101-001.XML")
    part, notice = rpc_of_image_part(scene, image)
    assert "from column 5000 and row 5000" in str(notice)
    request = OrthoRequest(
        image.ref, part, WGS84, rpc_domain(part, image), RasterRef(str(folder / dem)), "ellipsoid", None,
        tmp_path / "ortho.tif", "EPSG:32631", 0.5, resampling="cubic",
    )  # fmt: skip
    ortho = orthorectify(request)
    dataset = gdal.Open(str(ortho.path))
    pixels = dataset.ReadAsArray().astype(float)
    left, step, _, top, _, _ = dataset.GetGeoTransform()
    row, column = np.nonzero(pixels > 0)
    places = np.column_stack([left + (column + 0.5) * step, top - (row + 0.5) * step])
    seen = scene.project(on_ground(places, ortho.wkt, str(folder / dem))) - 5000  # where the crop starts
    inside = (seen > 4).all(axis=1) & (seen < 496).all(axis=1)
    source = gdal.Open(image.ref.path).ReadAsArray().astype(float)
    at = seen[inside][:, ::-1].T - 0.5
    expected = map_coordinates(source, at, order=3)
    gradients = np.column_stack([map_coordinates(part, at, order=1) for part in np.gradient(source)])
    shift = np.linalg.lstsq(gradients, pixels[row, column][inside] - expected, rcond=None)[0]
    assert np.abs(shift).max() < 0.1
    assert ortho.max_px < 0.1
    assert inside.sum() > 150_000


def test_uncovered_is_the_share_of_the_images_own_pixels(
    job: Callable[..., Ortho], tmp_path: Path, make_raster: MakeRaster
) -> None:
    """A hole between the places of the plan's grid counts, and what the image leaves empty does not."""
    dem = terrain_file(tmp_path / "dem.tif")
    dataset = gdal.Open(dem, gdal.GA_Update)
    west, step, *_ = dataset.GetGeoTransform()
    dataset.GetRasterBand(1).WriteArray(np.full((120, int((7.18 - west) / step)), -9999, np.float32))  # the west half
    dataset = None
    half = job(dem=dem).uncovered
    assert 0.2 < half < 0.8
    kept = RAMP.copy()
    kept[:, :, :200] = 0
    image = make_raster("half.tif", kept, geotransform=(0.0, 1.0, 0.0, 0.0, 0.0, 1.0), system=None, nodata=0)
    assert abs(job(dem=dem, image=RasterRef(image)).uncovered - half) > 0.2


@pytest.mark.parametrize(
    ("step", "words"), [(0.0008, "a grid spacing of 88.9 m"), (0.00005, "bend straight lines"), (0.0002, "")]
)
def test_meshes_beyond_10_to_30_m_are_told(
    job: Callable[..., Ortho], tmp_path: Path, step: float, words: str
) -> None:
    dem = str(tmp_path / "dem.tif")
    gdal.Warp(dem, terrain_file(tmp_path / "fine.tif"), xRes=step, yRes=step, resampleAlg="average")
    notices = " ".join(map(str, job(dem=dem).notices))
    assert words in notices
    assert bool(words) == ("10 to 30 m" in notices)


@pytest.mark.parametrize("raises", [False, True])
def test_a_model_that_gdal_can_not_take_is_a_sentence(
    job: Callable[..., Ortho], monkeypatch: pytest.MonkeyPatch, raises: bool
) -> None:
    def warp(*given: object, **named: object) -> None:
        if raises:
            raise RuntimeError("no transformer")

    monkeypatch.setattr(gdal, "Warp", warp)
    with pytest.raises(RasterError, match="no transformer" if raises else "can't be read"):
        job(height=100.0)
