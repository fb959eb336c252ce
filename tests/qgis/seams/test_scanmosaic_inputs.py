"""``seaminspector:scanmosaic`` with mosaics, orthoimages and seamlines of all kinds."""
from __future__ import annotations

import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from qgis.core import QgsGeometry

from tests.numbers.synthetic import write_raster
from tests.qgis.runs import Run, assert_sentence, run
from tests.qgis.scenes import at, layer, line
from tests.qgis.seams.scan_scenes import COLUMNS, ROWS, SEAM_METRES, Files, cut, images, seam_columns, write_scene

pytestmark = pytest.mark.usefixtures("provider")

FEATHER_PX = 24.0
RGB = [gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand]


def places() -> list[tuple[float, float]]:
    columns = seam_columns(ROWS, COLUMNS)
    return [(columns[row], row + 0.5) for row in range(0, ROWS, 4)]


@pytest.fixture(scope="module")
def feathered(tmp_path_factory: pytest.TempPathFactory) -> Files:
    return write_scene(tmp_path_factory.mktemp("feathered"), width=FEATHER_PX)


def scan(files: Files, **more: Any) -> Run:
    return run("scanmosaic", **files.given(**more))


def assert_failed_along_the_seam(outcome: Run, metres: float = SEAM_METRES, by: float = 0.05) -> None:
    """All of it, and nothing is said that an operator had to look into."""
    assert outcome.complaint is None
    assert outcome.log.warnings == outcome.log.errors == []
    assert outcome.results["SEAM_METRES"] == pytest.approx(metres, rel=by)
    assert outcome.results["FAILED_METRES"] == pytest.approx(outcome.results["SEAM_METRES"])


def assert_lost_along_the_seam(outcome: Run) -> None:
    """Loss is told where compression or resampling blurs it a little, so that some pieces are just above the limit."""
    assert outcome.complaint is None
    assert outcome.log.warnings == outcome.log.errors == []
    assert outcome.results["SEAM_METRES"] == pytest.approx(SEAM_METRES, rel=0.05)
    assert outcome.results["FAILED_METRES"] > 0.5 * SEAM_METRES
    assert max(outcome.column("kept_1", "SEAMS")) < 0.85


# what the pixels are


def with_infrared(bands: np.ndarray) -> np.ndarray:
    return np.concatenate([bands, bands[:1] // 2 + 40])


def as_jpeg(path: str) -> str:
    """One picture in one piece, its place in a file beside it."""
    target = str(Path(path).with_suffix(".jpg"))
    gdal.GetDriverByName("JPEG").CreateCopy(target, gdal.Open(path), options=["QUALITY=92", "WORLDFILE=YES"])
    return target


KINDS: dict[str, Callable[[Path], Files]] = {
    "striped": lambda folder: write_scene(folder, width=FEATHER_PX, options=[]),
    "four bands": lambda folder: write_scene(
        folder, [with_infrared(bands) for bands in images()], FEATHER_PX, colours=[*RGB, gdal.GCI_Undefined]
    ),
    "16 bit": lambda folder: write_scene(folder, images(scale=16, dtype=np.uint16), FEATHER_PX),
    "paletted": lambda folder: write_scene(
        folder, [bands[0] for bands in images()], FEATHER_PX, palette=[(i, i, i, 255) for i in range(256)]
    ),
    "northing first": lambda folder: write_scene(folder, width=FEATHER_PX, system=2180, origin=(5e5, 5e5)),
    "jpeg": lambda folder: _with_jpeg(write_scene(folder, width=FEATHER_PX)),
}


def _with_jpeg(files: Files) -> Files:
    return Files(as_jpeg(files.mosaic), files.west, files.east)


@pytest.mark.parametrize("kind", KINDS)
def test_pixels_of_all_kinds(tmp_path: Path, kind: str) -> None:
    outcome = scan(KINDS[kind](tmp_path))
    (assert_lost_along_the_seam if kind == "jpeg" else assert_failed_along_the_seam)(outcome)


def test_degrees_are_measured_on_the_ground(tmp_path: Path) -> None:
    files = write_scene(tmp_path, width=FEATHER_PX, system=4326, gsd=1e-6, origin=(15.0, 50.0))
    north_south = 1e-6 * 111_229  # metres a pixel, at 50 degrees
    east_west = 1e-6 * 71_696
    steps = np.hypot(np.diff(seam_columns(ROWS, COLUMNS)) * east_west, north_south)
    assert_failed_along_the_seam(scan(files), float(steps.sum()), 0.03)


@pytest.mark.parametrize("rim", [1, 2])
def test_a_strip_of_the_mosaic_without_an_orthoimage_costs_itself_only(tmp_path: Path, rim: int) -> None:
    pair = images()
    files = write_scene(tmp_path, pair, FEATHER_PX)
    for path, image in zip(files.sources, pair):
        write_raster(Path(path), image[:, :-rim, :-rim])
    outcome = scan(files)
    assert_failed_along_the_seam(outcome)
    assert outcome.log.warnings == []


@pytest.mark.parametrize("width", [1, 12, 31])
def test_a_white_frame_that_no_file_names_is_no_ground(tmp_path: Path, width: int) -> None:
    inner = np.s_[:, width : ROWS - width, width : COLUMNS - width]
    files, whole = write_scene(tmp_path, width=FEATHER_PX), scan(write_scene(tmp_path, None, FEATHER_PX, "whole"))
    for path in (files.mosaic, *files.sources):
        framed = np.full((3, ROWS, COLUMNS), 255, np.uint8)
        framed[inner] = gdal.Open(path).ReadAsArray()[inner]
        write_raster(Path(path), framed)
    outcome = scan(files)
    assert outcome.results["SEAM_METRES"] == pytest.approx(SEAM_METRES - 0.2 * width, abs=2)
    assert outcome.column("kept_1", "SEAMS")[:2] == pytest.approx(whole.column("kept_1", "SEAMS")[:2], abs=0.03)


@pytest.mark.parametrize("by", ["alpha", "mask", "nodata"])
def test_missing_pixels_are_no_seams(tmp_path: Path, by: str) -> None:
    west, east = images()
    mosaic, there = cut(west, east, FEATHER_PX), np.ones((ROWS, COLUMNS), bool)
    there[:, :50] = False
    there[300:420, 180:260] = False  # an island on the seam
    files = write_scene(tmp_path, [west, east])
    if by == "alpha":
        bands = np.concatenate([mosaic, np.uint8(255) * there[np.newaxis].astype(np.uint8)])
        write_raster(Path(files.mosaic), bands, colours=[*RGB, gdal.GCI_AlphaBand])
    elif by == "mask":
        write_raster(Path(files.mosaic), mosaic, valid=there)
    else:
        write_raster(Path(files.mosaic), mosaic * there, nodata=0)
    outcome = scan(files, CELL=16)
    assert outcome.complaint is None
    assert outcome.log.warnings == []
    hole = QgsGeometry.fromWkt("POLYGON(({} {}, {} {}, {} {}, {} {}, {} {}))".format(
        *(value for place in ((192, 312), (248, 312), (248, 408), (192, 408), (192, 312)) for value in at(*place))
    ))
    assert all(not feature.geometry().intersects(hole) for feature in outcome.features("SEAMS"))
    assert 0.6 * SEAM_METRES < outcome.results["SEAM_METRES"] < 0.9 * SEAM_METRES
    kept = gdal.Open(outcome.results["LOSS"]).ReadAsArray()[0]
    assert (kept[:, 0] == -1).all()
    assert (kept[20:25, 13:15] == -1).all()


# how large it is


@pytest.mark.parametrize("shape", [(64, 64), (64, 700), (500, 100), (2060, 150)])
def test_sizes_that_fit_nothing(tmp_path: Path, shape: tuple[int, int]) -> None:
    outcome = scan(write_scene(tmp_path, images(shape, bands=1), 8.0), CELL=16)
    assert outcome.complaint is None
    assert not [said for said in outcome.log.warnings if "report" in said]
    if 0.3 * shape[1] > 128:  # nearer to the edge no patch lies beside the seam
        length = np.hypot(np.diff(seam_columns(*shape)), 1).sum() / 10
        assert outcome.results["SEAM_METRES"] == pytest.approx(length, rel=0.15)
    picture = gdal.Open(outcome.results["LOSS"])
    assert (picture.RasterYSize, picture.RasterXSize) == tuple(-(-side // 16) for side in shape)


# its sources


@pytest.mark.parametrize("size", [0.5, 1.05])
def test_sources_of_other_pixel_sizes(tmp_path: Path, feathered: Files, size: float) -> None:
    sources = [str(tmp_path / Path(path).name) for path in feathered.sources]
    for path, target in zip(feathered.sources, sources):
        gdal.Translate(target, path, xRes=0.1 * size, yRes=0.1 * size, resampleAlg="cubic")
    assert_failed_along_the_seam(scan(feathered, SOURCES=sources))


def test_sources_in_another_reference_system(tmp_path: Path, feathered: Files) -> None:
    sources = [str(tmp_path / Path(path).name) for path in feathered.sources]
    for path, target in zip(feathered.sources, sources):
        gdal.Warp(target, path, dstSRS="EPSG:3035", resampleAlg="cubic", xRes=0.1, yRes=0.1, dstNodata=0)
    assert_lost_along_the_seam(scan(feathered, SOURCES=sources))


def test_a_mosaic_of_one_source(tmp_path: Path) -> None:
    west, _ = images()
    files = write_scene(tmp_path, [west, west])
    outcome = scan(files, SOURCES=[files.west])
    assert outcome.complaint is None
    assert outcome.results["SEAM_METRES"] == 0
    assert outcome.results["FAILED_METRES"] == 0
    assert "WORST_KEPT" not in outcome.results
    assert outcome.column("source", "CELLS") == ["west.tif"]


def _copy(files: Files, folder: Path) -> str:
    return str(shutil.copy(files.mosaic, folder / "copy.tif"))


def _vrt(files: Files, folder: Path) -> str:
    gdal.BuildVRT(str(folder / "whole.vrt"), [files.mosaic])
    return str(folder / "whole.vrt")


def _overview(files: Files, folder: Path) -> str:
    gdal.Translate(str(folder / "half.tif"), files.mosaic, widthPct=50, heightPct=50, resampleAlg="average")
    return str(folder / "half.tif")


@pytest.mark.parametrize(("made", "words"), [
    (lambda files, _: files.mosaic, "is the mosaic itself"), (_copy, "so it is a copy"), (_vrt, "so it is a copy"),
    (_overview, "an overview of it"),
])
def test_the_mosaic_among_its_sources_is_left_out(
    tmp_path: Path, feathered: Files, made: Callable[[Files, Path], str], words: str
) -> None:
    outcome = scan(feathered, SOURCES=[made(feathered, tmp_path), *feathered.sources])
    (said,) = outcome.log.warnings
    assert_sentence(said, words)
    assert outcome.results["FAILED_METRES"] == pytest.approx(SEAM_METRES, rel=0.03)
    assert set(outcome.column("source", "CELLS")) == {"west.tif", "east.tif"}


@pytest.mark.parametrize("kind", ["VRT", "tif"])
def test_a_mosaic_that_can_not_be_read_is_refused(tmp_path: Path, feathered: Files, kind: str) -> None:
    """A VRT whose files are gone, a file without its end."""
    options = ["TILED=YES", "COMPRESS=DEFLATE"]
    gdal.Translate(str(tmp_path / "sheet.tif"), feathered.mosaic, creationOptions=options)
    if kind == "VRT":
        gdal.BuildVRT(str(tmp_path / "sheet.vrt"), [str(tmp_path / "sheet.tif")]).FlushCache()
        (tmp_path / "sheet.tif").unlink()
    else:
        dataset = gdal.Open(str(tmp_path / "sheet.tif"))
        first = int(dataset.GetRasterBand(1).GetMetadataItem("BLOCK_OFFSET_0_0", "TIFF"))
        del dataset
        (tmp_path / "sheet.tif").write_bytes((tmp_path / "sheet.tif").read_bytes()[: first + 100])
    seams = str(tmp_path / "seams.gpkg")
    outcome = run("scanmosaic", **feathered.given(MOSAIC=str(tmp_path / f"sheet.{kind.lower()}"), SEAMS=seams))
    assert f"Nothing of the mosaic sheet.{kind.lower()} could be read" in str(outcome.complaint)
    assert not Path(seams).exists()


def test_a_truncated_source_costs_its_own_ground_only(tmp_path: Path, feathered: Files) -> None:
    whole = Path(write_raster(tmp_path / "west.tif", images()[0], options=["TILED=YES"]))
    broken = tmp_path / "broken.tif"
    broken.write_bytes(whole.read_bytes()[: whole.stat().st_size // 2])
    outcome = scan(feathered, SOURCES=[str(broken), feathered.east])
    assert outcome.complaint is None
    assert_sentence(outcome.log.warnings[0], "broken.tif can't be read; the file may be truncated")
    assert "east.tif" in outcome.column("source", "CELLS")
    missing = scan(feathered, SOURCES=["/nowhere/lost.tif", *feathered.sources])
    assert_sentence(missing.log.warnings[0], "lost.tif is left out")
    assert missing.results["FAILED_METRES"] > 0


# its seamlines


@pytest.mark.parametrize(("lines", "words"), [
    ([line((9000, 9000), (9500, 9500))], "lies on the mosaic"), ([], "holds no line"),
])
def test_seamlines_that_say_nothing(feathered: Files, lines: list[QgsGeometry], words: str) -> None:
    drawn = layer("LineString", lines)
    assert_sentence(scan(feathered, SEAMLINES=drawn).complaint, words)
    assert_sentence(run("scanmosaic", MOSAIC=feathered.mosaic, SEAMLINES=drawn).complaint, words)


def test_names_of_the_seamlines_are_those_of_the_sources(feathered: Files) -> None:
    named = layer("LineString", [line(*places())], left_src=("string", ["west"]), right_src=("string", ["east.tif"]))
    pairs = [tuple(sorted((row["left_source"], row["right_source"])))
             for row in scan(feathered, SEAMLINES=named).rows("SEAMS")]
    assert set(pairs) == {("east.tif", "west.tif")}
    others = layer("LineString", [line(*places())], left_src=("string", ["7"]), right_src=("string", ["8"]))
    outcome = scan(feathered, SEAMLINES=others)
    assert "not given: 2 (such as 7, 8" in outcome.log.warnings[0]


@pytest.mark.parametrize("with_images", [True, False])
def test_dates_of_the_seamlines_come_with_the_pieces(feathered: Files, with_images: bool) -> None:
    dated = layer(
        "LineString", [line(*places())], left_src=("string", ["west"]), right_src=("string", ["east.tif"]),
        left_date=("string", ["2019-07-04"]), right_date=("string", ["2019-08-11"]),
    )  # fmt: skip
    rows = scan(feathered, SEAMLINES=dated, **({} if with_images else {"SOURCES": []})).rows("SEAMS")
    days = {row[f"{side}_source"]: row[f"{side}_date"] for row in rows for side in ("left", "right")}
    assert days == {"west.tif" if with_images else "west": "2019-07-04", "east.tif": "2019-08-11"}


def test_ground_without_a_seam_is_no_seam(feathered: Files) -> None:
    """A line where the mosaic goes on with the same image: nothing is lost there."""
    outcome = scan(feathered, SEAMLINES=layer("LineString", [line((500, 0), (500, 520))]))
    assert outcome.results["SEAM_METRES"] == outcome.results["FAILED_METRES"] == 0
