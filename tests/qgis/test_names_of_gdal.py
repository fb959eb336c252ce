"""Rasters by names that GDAL understands and that are no paths of files: what measures them, and writes of them."""
from __future__ import annotations

import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from osgeo import gdal

from tests.qgis.runs import run
from tests.qgis.scenes import layer, outline, windows
from tests.qgis.seams.scan_scenes import COLUMNS, ROWS, Files, drawn_seam, write_scene
from tests.qgis.test_whole_rasters import image_with_rpc
from tests.range_server import serving

pytestmark = pytest.mark.usefixtures("provider")
FEATHER_PX = 40.0


@pytest.fixture(scope="module", params=[
    *("GPKG:", "/vsicurl/"),
    *(pytest.param(kind, marks=pytest.mark.release) for kind in ("/vsizip/", "http", "GTIFF_DIR:", "vrt://")),
])  # fmt: skip
def named(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Files]:
    """A feathered mosaic and its two orthoimages, by such names."""
    folder = tmp_path_factory.mktemp("named")
    paths = [Path(path) for path in vars(write_scene(folder, None, FEATHER_PX)).values()]
    if request.param == "GPKG:":
        for number, path in enumerate(paths):
            options = ["TILE_FORMAT=PNG", f"RASTER_TABLE={path.stem}", *(["APPEND_SUBDATASET=YES"] if number else [])]
            gdal.Translate(str(folder / "all.gpkg"), str(path), format="GPKG", creationOptions=options)
        yield Files(*(f"GPKG:{folder / 'all.gpkg'}:{path.stem}" for path in paths))
    elif request.param == "/vsizip/":
        with zipfile.ZipFile(folder / "all.zip", "w") as archive:
            for path in paths:
                archive.write(path, path.name)
        yield Files(*(f"/vsizip/{folder / 'all.zip'}/{path.name}" for path in paths))
    elif request.param in ("/vsicurl/", "http"):
        with serving(folder) as server:
            name = server.vsi if request.param == "/vsicurl/" else server.address
            yield Files(*(name(path.name) for path in paths))
    else:
        prefix, after = ("GTIFF_DIR:1:", "") if request.param == "GTIFF_DIR:" else ("vrt://", "?bands=1,2,3")
        yield Files(*(f"{prefix}{path}{after}" for path in paths))


def given(files: Files, folder: Path, name: str) -> dict[str, Any]:
    """Parameters of an algorithm that measures rasters."""
    spots = windows((150, 100, 256, 256))
    block = {"MOSAIC": files.mosaic, "SOURCES": files.sources}
    return {
        "placewindows": {"MOSAIC": files.mosaic, "SEAMLINES": drawn_seam(), "SIDE": 12.0, "SPACING": 20.0},
        "inspectwindows": {**block, "WINDOWS": spots},
        "scanmosaic": {**block, "PIECE": 20.0, "LOSS": str(folder / "loss.tif")},
        "predictloss": {"SOURCES": files.sources, "WINDOWS": spots},
        "checknoise": {"RASTERS": files.sources, "WINDOWS": spots},
        "checkradiometry": {"RASTERS": files.sources},
        "simulatebayer": {"RASTER": files.mosaic, "OUTPUT": str(folder / "bayer.tif")},
        "enhancephoto": {"PHOTO": files.mosaic, "OPERATION": "negative", "OUTPUT": str(folder / "enhanced.tif")},
    }[name]


@pytest.mark.parametrize("name", [
    "placewindows", "inspectwindows", "scanmosaic", "predictloss", "checknoise", "checkradiometry", "simulatebayer",
    "enhancephoto",
])  # fmt: skip
def test_rasters_of_any_name_are_measured(named: Files, tmp_path: Path, name: str) -> None:
    made = run(name, **given(named, tmp_path, name))
    assert made.complaint is None
    assert made.log.warnings == []
    made.close()


def test_a_mosaic_of_any_name_is_mended(named: Files, tmp_path: Path) -> None:
    block = {"MOSAIC": named.mosaic, "SOURCES": named.sources}
    scanned = run("scanmosaic", **block, PIECE=20.0)
    assert scanned.results["FAILED_METRES"] == pytest.approx(scanned.results["SEAM_METRES"])
    mended = run("mendseams", **block, SEAMS=scanned.layer("SEAMS"), WIDTH=10.0, PATCHES=str(tmp_path / "patches"),
                 MENDED=str(tmp_path / "mended.vrt"))  # fmt: skip
    assert mended.complaint is None
    again = run("scanmosaic", MOSAIC=mended.results["MENDED"], SOURCES=named.sources, PIECE=20.0)
    assert again.results["FAILED_METRES"] == 0
    for run_ in (scanned, mended, again):
        run_.close()


def test_photos_targets_and_satellite_images_may_lie_in_an_archive(given: dict[str, Any], tmp_path: Path) -> None:
    image, archive = image_with_rpc(tmp_path / "rpc.tif"), tmp_path / "all.zip"
    packed = [*(given[name] for name in ("target", "photo")), image, image.replace(".tif", "_RPC.TXT")]
    with zipfile.ZipFile(archive, "w") as file:
        for path in packed:
            file.write(path, Path(path).name)
    target, photo, image = (f"/vsizip/{archive}/{Path(path).name}" for path in packed[:3])
    for name, values in (
        ("measureresolution", {"RASTER": target, "GROUPS": given["bars"]}),
        ("interiororientation", {"PHOTO": photo, "CALIBRATION": given["calibration"]}),
        ("orthorectify", {"IMAGE": image, "HEIGHT": 100}), ("planpoints", {"IMAGE": image, "HEIGHT": 100}),
    ):  # fmt: skip
        assert run(name, **values).complaint is None, name


def test_sheets_in_an_archive_are_there(tmp_path: Path) -> None:
    files = write_scene(tmp_path)
    with zipfile.ZipFile(tmp_path / "all.zip", "w") as archive:
        archive.write(files.west, "west.tif")
    names = [f"/vsizip/{tmp_path}/all.zip/{name}" for name in ("west.tif", "east.tif")]
    index = layer("Polygon", [outline((0, 0, COLUMNS, ROWS))] * 2, location=("string(200)", names))
    checked = run("checkdelivery", SHEETS=index)
    assert {row["sheet"]: row["location"] for row in checked.rows()} == {"west": names[0], "east": None}
    checked.close()
