"""Images read for themselves: what they are, in pieces, and at reduced resolution."""
from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from osgeo import gdal
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe
from seam_inspector.plugin.imagery.rasters import RasterRef

from tests.examples import at_most
from tests.numbers.synthetic import ORIGIN, orthoimage, read_pixels, write_plain, write_raster

MakeRaster = Callable[..., str]


def test_what_a_georeferenced_image_is(make_raster: MakeRaster) -> None:
    path = make_raster("a.tif", orthoimage((80, 120), dtype=np.uint16), gsd=0.25, options=["NBITS=12"])
    image = describe(RasterRef(path))
    assert (image.columns, image.rows, image.whole) == (120, 80, PixelWindow(0, 0, 120, 80))
    metres = pytest.approx(1 / 0.9996)  # along the middle of a zone of UTM
    assert image.grid == Grid(*ORIGIN, 0.25, 0.25, 120, 80, metres, metres)
    assert image.ground_sample_distance == pytest.approx(0.25 / 0.9996)
    assert (image.data_type, image.bits, image.has_luminance) == ("uint16", 12, True)


def test_a_picture_without_a_place_and_a_rotated_one(make_raster: MakeRaster, tmp_path: Path) -> None:
    memory = gdal.GetDriverByName("MEM").Create("", 30, 20, 1, gdal.GDT_Byte)
    path = str(tmp_path / "scan.png")
    gdal.GetDriverByName("PNG").CreateCopy(path, memory)
    image = describe(RasterRef(path, "a layer's system"))
    assert (image.has_place, image.ground_sample_distance) == (False, 1.0)
    assert image.grid == Grid(0, 0, 1, 1, 30, 20)
    rotated = make_raster("r.tif", orthoimage((64, 64)), geotransform=(0, 0.1, 0.02, 0, 0.02, -0.1))
    assert not describe(RasterRef(rotated)).is_north_up
    with pytest.raises(RasterError, match="rotated"):
        describe(RasterRef(rotated)).grid  # noqa: B018


@pytest.mark.parametrize("system", ["", "EPSG:4326"])
def test_pixels_without_a_place_are_no_degrees(tmp_path: Path, system: str) -> None:
    image = describe(RasterRef(write_plain(tmp_path / "scan.bmp", orthoimage((64, 64), 1)[0]), system))
    assert (image.wkt, image.has_place, image.ground_sample_distance) == (system, False, 1.0)
    assert image.grid == Grid(0, 0, 1, 1, 64, 64)


@pytest.mark.parametrize("numbers", ["5, 1, 2, 7, 2, 4", "5, 1e300, 1e300, 7, 1e300, 1e300", "nan, 1, 0, 7, 0, -1",
                                     "5, inf, 0, 7, 0, -1", "5, 1e-320, 0, 7, 0, -1e-320", "0, 1, 0, 0, 0, -1"])
def test_pixels_on_one_line_or_nowhere_have_no_place(tmp_path: Path, numbers: str) -> None:
    path = tmp_path / "placed.vrt"
    path.write_text(f'<VRTDataset rasterXSize="9" rasterYSize="9"><GeoTransform>{numbers}</GeoTransform>'
                    '<VRTRasterBand dataType="Byte" band="1"/></VRTDataset>')
    assert not describe(RasterRef(str(path))).has_place


@pytest.fixture(scope="module")
def rasters(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """One picture in tiles, in strips, and in one strip per row."""
    folder, array = tmp_path_factory.mktemp("layouts"), orthoimage((300, 210), bands=2)
    layouts = {"tiles": ["TILED=YES", "BLOCKXSIZE=64", "BLOCKYSIZE=32"], "strips": ["BLOCKYSIZE=7"], "rows": []}
    return {name: write_raster(folder / f"{name}.tif", array, options=options) for name, options in layouts.items()}


@at_most(40)
@given(
    layout=st.sampled_from(["tiles", "strips", "rows"]), most=st.integers(1, 90_000), column=st.integers(0, 200),
    row=st.integers(0, 290), width=st.integers(1, 210), height=st.integers(1, 300),
)
def test_blocks_cover_a_window_once_and_keep_to_their_size(
    rasters: dict[str, str], layout: str, most: int, column: int, row: int, width: int, height: int
) -> None:
    window = PixelWindow(column, row, min(width, 210 - column), min(height, 300 - row))
    pixels = OpenRaster(RasterRef(rasters[layout]))
    seen = np.zeros((300, 210), int)
    tile = {"tiles": 64 * 32, "strips": 210 * 7, "rows": 210 * 300}[layout]
    for block in pixels.blocks(window, most):
        assert block.width * block.height <= max(most, tile)
        seen[block.row : block.row + block.height, block.column : block.column + block.width] += 1
        bands, invalid = pixels.read(block)
        assert invalid is None
        there = (block.column, block.row, block.width, block.height)
        assert (bands == read_pixels(rasters[layout], *there)).all()
    assert seen.sum() == window.width * window.height
    inside = seen[window.row : window.row + window.height, window.column : window.column + window.width]
    assert (inside == 1).all()


def test_a_file_that_may_not_be_read_is_not_called_damaged(
    make_raster: MakeRaster, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = make_raster("a.tif", orthoimage((64, 64)))
    os.chmod(path, 0)
    monkeypatch.setattr(os, "access", lambda *asked: False)  # whoever runs the tests may be allowed everything
    monkeypatch.setattr(gdal, "OpenEx", lambda *asked: None)
    with pytest.raises(RasterError, match=r"No permission to read a\.tif"):
        describe(RasterRef(path))


@pytest.mark.usefixtures("either_gdal")
def test_metadata_that_leads_to_a_file_is_none(tmp_path: Path) -> None:
    """Whether or not somebody has turned GDAL's exceptions on, which hold for all of QGIS."""
    path = write_plain(tmp_path / "a.tif", np.zeros((1, 64, 64), np.uint8))
    Path(f"{path}.aux.xml").write_text("<PAMDataset><SRS>/etc/passwd</SRS></PAMDataset>")
    assert describe(RasterRef(str(path))).wkt == ""


def test_a_damaged_mask_is_told(tmp_path: Path) -> None:
    path = write_raster(tmp_path / "a.tif", np.zeros((1, 64, 64), np.uint8))
    write_raster(Path(f"{path}.msk"), np.zeros((3, 64, 64), np.uint8))
    content = Path(f"{path}.msk").read_bytes()
    Path(f"{path}.msk").write_bytes(content[:200] + content[:199:-1])
    with pytest.raises(RasterError, match=r"The mask of a\.tif, inside it or in the file \.msk beside it, is damaged"):
        OpenRaster(RasterRef(str(path))).read(PixelWindow(0, 0, 9, 9))


def test_what_lies_outside_is_told(make_raster: MakeRaster) -> None:
    raster = OpenRaster(RasterRef(str(make_raster("image.tif", np.ones((1, 64, 96), np.uint8)))))
    for window in (PixelWindow(-1, 0, 8, 8), PixelWindow(90, 0, 8, 8), PixelWindow(0, 0, 0, 8)):
        with pytest.raises(RasterError, match=r"image\.tif does not cover the whole window"):
            raster.read(window)
    assert raster.read(PixelWindow(0, 0, 8, 8)).bands.all()
