"""Aerial photos by their orientations: seen as orthority and OpenCV see them, resampled as GDAL does, or refused."""
from __future__ import annotations

import csv
import re
import sys
from pathlib import Path

import cv2
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from osgeo import gdal
from scipy.ndimage import map_coordinates
from seam_inspector.plugin.imagery.errors import SeamInspectorError
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.imagery.reference_systems import transform_points
from seam_inspector.plugin.sensors.measure.camera_files import document, read_cameras
from seam_inspector.plugin.sensors.measure.frames import BrownLens, FisheyeLens, FrameCamera, FrameInterior, camera_axes
from seam_inspector.plugin.sensors.measure.oriented_frames import FrameFiles, OrientedFrame, read_block
from seam_inspector.plugin.sensors.measure.orthorectification import OrthoRequest, orthorectify
from seam_inspector.plugin.sensors.measure.photo_warp import KERNELS, Resampler
from seam_inspector.plugin.sensors.measure.rpc import open_image

from tests.numbers.synthetic import wkt

COLUMNS, ROWS, FOCAL = 80, 60, 100.0
CENTRE = np.array([500_000.0, 4_000_000.0, 1500.0])
YAML = "cam:\n  type: pinhole\n  im_size: [80, 60]\n  focal_len: 60\n  sensor_size: [80, 60]\n"
TABLE = "filename,x,y,z,omega,phi,kappa\nphoto,500000,4000000,1500,1,-2,30\n"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A photo whose two bands are its own columns and rows, a terrain with a hill, and its orientations."""
    ramp = np.stack(np.meshgrid(np.arange(COLUMNS) + 0.5, np.arange(ROWS) + 0.5)).astype(np.float32)
    photo = gdal.GetDriverByName("GTiff").Create(str(tmp_path / "photo.tif"), COLUMNS, ROWS, 2, gdal.GDT_Float32)
    photo.WriteArray(ramp)
    photo = None
    y, x = np.mgrid[0:200, 0:200]
    heights = 100 + 300 * np.exp(-((x - 110) ** 2 + (y - 90) ** 2) / 800)
    terrain = gdal.GetDriverByName("GTiff").Create(str(tmp_path / "dem.tif"), 200, 200, 1, gdal.GDT_Float32)
    terrain.SetGeoTransform((CENTRE[0] - 2000, 20, 0, CENTRE[1] + 2000, 0, -20))
    terrain.SetProjection(wkt(32633))
    terrain.WriteArray(heights.astype(np.float32))
    terrain = None
    (tmp_path / "camera.yaml").write_text(YAML)
    (tmp_path / "places.csv").write_text(TABLE)
    return tmp_path


def oriented(folder: Path, interior: str = "camera.yaml", exterior: str = "places.csv", system: str = "EPSG:32633",
             datum: str = "as_terrain") -> OrientedFrame:
    files = FrameFiles(folder / interior, folder / exterior, system, datum)
    block = read_block(files, RasterRef(str(folder / "dem.tif")), "auto", 0.0)
    return block.frame(open_image(RasterRef(str(folder / "photo.tif"))))


def interior(path: Path, size: tuple[int, int]) -> FrameInterior:
    return read_cameras(document(path), path).of("", size)


@pytest.mark.parametrize("exterior", ["camera_pos_ori.txt", "ngi_ext_param.geojson"])
def test_points_lie_where_orthority_sees_them(data_folder: Path, exterior: str) -> None:
    folder = data_folder / "frames" / "ngi"
    with open(folder / "projected_0182.csv", encoding="utf-8") as file:
        rows = [[float(row[name]) for name in ("x", "y", "z", "column", "row")] for row in csv.DictReader(file)]
    image = open_image(RasterRef(str(folder / "3324c_2015_1004_05_0182_RGB.tif")))
    files = FrameFiles(folder / "ngi_int_param.yaml", folder / exterior, "", "as_terrain")
    made = read_block(files, RasterRef(str(folder / "dem.tif")), "auto", 0.0).frame(image)
    table = np.array(rows)
    assert np.abs(made.camera.project(table[:, :3]) - table[:, 3:]).max() < 2e-4


BROWN = YAML.replace("pinhole", "brown") + "  k1: -0.264\n  k2: 0.1\n  k3: -0.02\n  p1: 0.002\n  p2: -0.001\n"


@pytest.mark.parametrize(("camera", "angles", "system", "size"), [
    (YAML, "1,-2,30", 32633, 4.0),
    (BROWN, "1,-2,30", 32633, 4.0),  # no quotient of polynomials of the third degree
    (BROWN, "20,-25,110", 32633, 8.0),  # 30 degrees off the vertical
    (BROWN, "20,-25,110", 4326, 8e-5),
    (YAML.replace("pinhole", "fisheye") + "  k1: -0.05\n  k2: 0.01\n", "1,-2,30", 32633, 4.0),
])  # fmt: skip
def test_an_orthoimage_takes_each_pixel_from_where_the_camera_saw_it(
    folder: Path, camera: str, angles: str, system: int, size: float
) -> None:
    (folder / "camera.yaml").write_text(camera)
    (folder / "places.csv").write_text(TABLE.replace("1,-2,30", angles))
    made, output = oriented(folder), folder / "ortho.tif"
    ortho = orthorectify(OrthoRequest(
        RasterRef(str(folder / "photo.tif")), made.camera, made.wkt, made.domain, RasterRef(str(folder / "dem.tif")),
        made.terrain_datum, None, output, wkt(system), size, resampling="bilinear",
    ))
    assert (ortho.rms_px, ortho.max_px) == (0, 0)
    opened = gdal.Open(str(output))
    seen, place = opened.ReadAsArray(), opened.GetGeoTransform()
    rows, columns = np.mgrid[0:seen.shape[1], 0:seen.shape[2]]
    at = np.stack([place[0] + (columns + 0.5) * place[1], place[3] + (rows + 0.5) * place[5]], axis=-1).reshape(-1, 2)
    x, y = transform_points(at, wkt(system), wkt(32633)).T.reshape(2, *columns.shape)
    terrain = gdal.Open(str(folder / "dem.tif")).ReadAsArray()
    z = map_coordinates(terrain, [(CENTRE[1] + 2000 - y) / 20 - 0.5, (x - CENTRE[0] + 2000) / 20 - 0.5], order=1)
    expected = made.camera.project(np.stack([x, y, z], axis=-1).reshape(-1, 3)).T.reshape(seen.shape)
    inner = (expected[0] > 2) & (expected[0] < COLUMNS - 2) & (expected[1] > 2) & (expected[1] < ROWS - 2)
    known = (np.abs(x - CENTRE[0]) < 1900) & (np.abs(y - CENTRE[1]) < 1900)  # where the terrain reaches
    assert (inner & known).sum() > 10_000
    assert np.abs(seen - expected)[:, inner & known].max() < 0.02
    beyond = (expected < -2).any(axis=0) | (expected[0] > COLUMNS + 2) | (expected[1] > ROWS + 2)
    assert not seen[:, beyond & known].any()


@pytest.mark.parametrize(("form", "resampling"), [("GTiff", "cubic"), ("COG", "cubic"), ("GTiff", "nearest")])
def test_dark_pixels_are_not_empty_ones(folder: Path, form: str, resampling: str) -> None:
    """In the photo's data type and colours, black where it is black, empty outside of it alone."""
    pixels = np.full((3, ROWS, COLUMNS), 200, np.uint8)
    pixels[:, 20:40, 30:50] = 0
    photo = gdal.GetDriverByName("GTiff").Create(str(folder / "photo.tif"), COLUMNS, ROWS, 3, gdal.GDT_Byte)
    photo.WriteArray(pixels)
    photo = None
    made, output = oriented(folder), folder / "ortho.tif"
    orthorectify(OrthoRequest(
        RasterRef(str(folder / "photo.tif")), made.camera, made.wkt, made.domain, None, made.terrain_datum, 100.0,
        output, made.wkt, 4.0, resampling=resampling, format=form,
    ))
    assert sorted(path.name for path in folder.glob("ortho*")) == ["ortho.tif"]
    opened = gdal.Open(str(output))
    assert gdal.Info(opened, format="json")["metadata"]["IMAGE_STRUCTURE"].get("LAYOUT") == {"COG": "COG"}.get(form)
    bands = [opened.GetRasterBand(number) for number in (1, 2, 3)]
    assert [band.GetColorInterpretation() for band in bands] == [
        gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand
    ]
    assert all(band.GetNoDataValue() == 0 and band.DataType == gdal.GDT_Byte for band in bands)
    seen = opened.ReadAsArray()
    held = (seen != 0).any(axis=0)
    assert held.sum() * 16 == pytest.approx(COLUMNS * ROWS * (1400 / 60) ** 2, rel=0.02)
    assert 0.03 < ((seen <= 1).all(axis=0) & held).sum() / held.sum() < 0.1


def test_what_a_lens_folds_back_is_not_shown() -> None:
    lens = BrownLens((-0.3,))
    distance = np.linspace(0, 3, 3001)
    shown, _ = lens.distorted(distance, np.zeros(3001))
    turn = 1 / np.sqrt(0.9)  # of r - 0.3 r^3
    assert np.isfinite(shown[distance < turn - 0.01]).all()
    assert np.isnan(shown[distance > turn + 0.01]).all()


@given(st.lists(st.floats(-0.05, 0.05), min_size=4, max_size=4), st.integers(0, 10_000))
def test_a_fisheye_is_opencv_s(angular: list[float], seed: int) -> None:
    places = np.random.default_rng(seed).uniform(-0.8, 0.8, (20, 2))
    expected = cv2.fisheye.distortPoints(places[:, None], np.eye(3), np.array(angular))[:, 0]
    shown = FisheyeLens(tuple(angular)).distorted(*places.T)
    assert np.column_stack(shown) == pytest.approx(expected, abs=1e-9)


@given(st.lists(st.floats(-0.05, 0.05), min_size=5, max_size=5), st.integers(0, 10_000))
def test_brown_s_lens_is_opencv_s(terms: list[float], seed: int) -> None:
    places = np.random.default_rng(seed).uniform(-0.6, 0.6, (20, 2))
    k1, k2, p1, p2, k3 = terms
    ahead = np.column_stack([places, np.ones(20)])
    expected, _ = cv2.projectPoints(ahead, np.zeros(3), np.zeros(3), np.eye(3), np.array(terms))
    shown = BrownLens((k1, k2, k3), (p1, p2)).distorted(*places.T)
    assert np.column_stack(shown) == pytest.approx(expected[:, 0], abs=1e-9)


@given(st.floats(-0.28, 0.1), st.integers(0, 10_000))
def test_views_are_the_way_back(k1: float, seed: int) -> None:
    camera = FrameCamera(
        FrameInterior(np.full(2, FOCAL), np.array([41.0, 28.0]), BrownLens((k1, 0.05), (0.001, -0.002))), CENTRE,
        camera_axes(10, -20, 70),
    )  # fmt: skip
    image = np.random.default_rng(seed).uniform(0, 60, (30, 2))
    heights = np.random.default_rng(seed + 1).uniform(0, 300, 30)
    ground = np.column_stack([camera.places_at(camera.views(image), heights), heights])
    assert camera.project(ground) == pytest.approx(image, abs=1e-5)


def test_values_that_are_no_heights_are_not_in_their_range_though_no_nodata_says_so(folder: Path) -> None:
    expected = oriented(folder).domain.heights
    terrain = gdal.Open(str(folder / "dem.tif"), gdal.GA_Update)
    terrain.GetRasterBand(1).WriteArray(np.full((9, 9), -32768, np.float32))
    terrain.GetRasterBand(1).WriteArray(np.full((9, 9), 1e30, np.float32), 30, 0)
    terrain = None
    assert oriented(folder).domain.heights == pytest.approx(expected, abs=0.01)


def test_a_reduced_image_is_seen_by_the_camera_of_the_whole_one(folder: Path) -> None:
    whole = interior(folder / "camera.yaml", (COLUMNS, ROWS))
    half = interior(folder / "camera.yaml", (COLUMNS // 2, ROWS // 2))
    assert half.focal == pytest.approx(whole.focal / 2)
    assert half.principal == pytest.approx(whole.principal / 2)


@pytest.mark.parametrize(("files", "complaint"), [
    ({"camera.yaml": "a: [1"}, "no camera that can be read"),
    ({"camera.yaml": YAML + "# " + 300_000 * "x"}, "no camera that can be read"),  # which PyYAML reads for long
    ({"camera.yaml": YAML.replace("[80, 60]\n  focal", "[1.0e-320, 1.0e-320]\n  focal")}, "no camera that can be read"),
    ({"camera.yaml": YAML.replace("60\n  sensor", "1.0e+300\n  sensor")}, "no camera that can be read"),
    ({"camera.yaml": YAML + "  cx: 1.0e+300\n"}, "no camera that can be read"),
    ({"camera.yaml": "!!python/object/apply:os.system ['true']"}, "no camera that can be read"),
    ({"camera.yaml": re.sub("sensor_size: .*", "sensor_size: [0, 0]", YAML)}, "no camera that can be read"),
    ({"camera.yaml": YAML.replace("60\n  sensor", "-1\n  sensor")}, "no camera that can be read"),
    ({"camera.yaml": YAML.replace("[80, 60]\n  focal", "[60, 80]\n  focal")},
     "60 x 80 pixels and the image 80 x 60, which is another shape"),
    ({"camera.yaml": YAML + "  k6: 0.2\n"}, "distortion that is not supported"),
    ({"camera.yaml": YAML.replace("pinhole", "spherical")}, "distortion that is not supported"),
    ({"camera.yaml": YAML.replace("pinhole", "brown") + "  k1: -2\n"}, "is not valid at a part"),
    ({"camera.yaml": YAML + YAML.replace("cam:", "two:")}, "several cameras (cam, two)"),
    ({"camera.yaml": YAML.replace("[80, 60]\n  focal", "640\n  focal")}, "no camera that can be read"),
    ({"camera.yaml": YAML.replace("sensor_size: [80, 60]", "sensor_size: [60, 80]")}, "times as wide as it is high"),
    ({"camera.yaml": YAML.replace("  focal_len: 60\n", "")}, "no camera that can be read"),
    ({"camera.yaml": '{"type": "FeatureCollection", "features": []}'}, "no camera that can be read"),
    ({"places.csv": ""}, "no exterior orientation"),
    ({"places.csv": "filename,x,y\nphoto,1,2\n"}, "no exterior orientation"),
    ({"places.csv": TABLE.replace("1500", "high")}, "no exterior orientation"),
    ({"places.csv": TABLE.replace("1500", "nan")}, "no exterior orientation"),
    ({"places.csv": TABLE.replace("photo", "other")}, "does not name the image photo.tif exactly once; it names other"),
    ({"places.csv": TABLE + "photo,1,2,3,4,5,6\n"}, "exactly once"),
    ({"places.csv": "{}"}, "no exterior orientation"),
    ({"places.csv": "<Externe><Centre>1 2 3</Centre></Externe>"}, "no exterior orientation"),
    ({"places.csv": TABLE.replace("1500", "150")}, "not above the terrain"),
    ({"places.csv": TABLE.replace("1,-2,30", "85,-2,30")}, "horizon"),
])  # fmt: skip
def test_what_can_t_be_used_is_said(folder: Path, files: dict[str, str], complaint: str) -> None:
    for name, text in files.items():
        (folder / name).write_text(text)
    with pytest.raises(SeamInspectorError) as raised:
        oriented(folder)
    assert complaint in str(raised.value)


def test_without_pyyaml_it_is_named(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "yaml", None)
    with pytest.raises(SeamInspectorError, match="PyYAML, which is not installed"):
        oriented(folder)


@pytest.mark.parametrize("system", ["", "EPSG:4326", "EPSG:2263"])
def test_a_system_without_metres_is_refused(folder: Path, system: str) -> None:
    with pytest.raises(SeamInspectorError, match=r"places\.csv is in no projected coordinate reference system"):
        oriented(folder, system=system)


@pytest.mark.parametrize(("angles", "doubted"), [("0.01,-0.02,3.12", True), ("1,-2,30", False), ("0.2,0.1,0.3", False)])
def test_angles_that_look_like_radians_are_told(folder: Path, angles: str, doubted: bool) -> None:
    (folder / "places.csv").write_text(TABLE.replace("1,-2,30", angles))
    notices = [str(notice) for notice in oriented(folder).notices]
    assert any("radians" in notice for notice in notices) == doubted


PIXELS = np.random.default_rng(3).uniform(0, 255, (1, 120, 140)).astype(np.float32)


def by_gdal(name: str, step: float, count: int, left: float, top: float) -> np.ndarray:
    source = gdal.GetDriverByName("MEM").Create("", 140, 120, 1, gdal.GDT_Float32)
    source.GetRasterBand(1).WriteArray(PIXELS[0])
    source.SetGeoTransform((0, 1, 0, 0, 0, -1))
    source.SetProjection(wkt(32633))
    bounds = (left, -top - count * step, left + count * step, -top)
    made = gdal.Warp("", source, format="MEM", outputBounds=bounds, width=count, height=count,
                     resampleAlg="near" if name == "nearest" else name)  # fmt: skip
    return np.asarray(made.ReadAsArray())


# GDAL 3.6 rounds where a widened lanczos lies to whole steps, and its mean over less than a pixel is that pixel
CASES = [(name, step) for name in KERNELS for step in (0.8, 1.0, 2.0, 3.3)
         if (name, step) not in (("lanczos", 2.0), ("lanczos", 3.3), ("average", 0.8))]  # fmt: skip


@pytest.mark.parametrize(("name", "step"), CASES)
def test_values_are_those_of_gdal(name: str, step: float) -> None:
    left, top, count = 30.3, 31.7, int(60 / step)
    middles = (np.arange(count) + 0.5) * step
    columns, rows = (side.ravel() for side in np.meshgrid(left + middles, top + middles))
    values, there = Resampler.of(name, (step, step)).at(PIXELS, None, columns, rows)
    assert there.all()
    assert values.reshape(count, count) == pytest.approx(by_gdal(name, step, count, left, top), abs=0.1)


@pytest.mark.parametrize("name", KERNELS)
def test_what_is_missing_plays_no_part(name: str) -> None:
    valid = np.ones(PIXELS.shape[1:], bool)
    valid[50:60, 50:70] = False
    rng = np.random.default_rng(4)
    columns, rows = rng.uniform(30, 90, 500), rng.uniform(30, 80, 500)
    holes = np.where(valid, PIXELS, 1e6).astype(np.float32)
    flat = np.where(valid, 7.0, 1e6)[None].astype(np.float32)
    resampler = Resampler.of(name, (1.5, 1.0))
    values, there = resampler.at(holes, valid, columns, rows)
    assert (there == valid[rows.astype(int), columns.astype(int)]).all()
    assert np.abs(values[:, there]).max() < 1e4
    assert resampler.at(flat, valid, columns, rows)[0][:, there] == pytest.approx(7.0, rel=1e-4)


def test_a_widened_lanczos_is_its_formula() -> None:
    column, row = 61.3, 57.9
    across, down = ((np.arange(size) + 0.5 - place) / 2 for size, place in ((140, column), (120, row)))
    weights = [np.where(np.abs(steps) < 3, np.sinc(steps) * np.sinc(steps / 3), 0) for steps in (across, down)]
    expected = weights[1] @ PIXELS[0] @ weights[0] / weights[0].sum() / weights[1].sum()
    values, _ = Resampler.of("lanczos", (2.0, 2.0)).at(PIXELS, None, np.array([column]), np.array([row]))
    assert values[0, 0] == pytest.approx(expected, abs=0.05)
