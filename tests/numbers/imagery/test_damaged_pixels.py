"""Pixels that GDAL makes up where a tile is damaged are not measured; who reads them is told where they are."""
from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.clips import read_clip
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe
from seam_inspector.plugin.imagery.raster_pool import open_raster, rasters_kept
from seam_inspector.plugin.imagery.rasters import RasterRef

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import orthoimage, read_pixels

SIDE, TILE = 512, 128
DAMAGED, SOUND = PixelWindow(128, 256, 64, 64), PixelWindow(0, 0, 64, 64)


@pytest.fixture
def damaged(make_raster: MakeRaster) -> str:
    """A TIFF of JPEG tiles; the one in column 1, row 2 ends in its middle and goes on with zeros."""
    options = ["TILED=YES", f"BLOCKXSIZE={TILE}", f"BLOCKYSIZE={TILE}", "COMPRESS=JPEG", "PHOTOMETRIC=YCBCR"]
    path = make_raster("damaged.tif", orthoimage((SIDE, SIDE)), options=options)
    dataset = gdal.Open(path)
    band = dataset.GetRasterBand(1)
    start, size = (int(band.GetMetadataItem(f"BLOCK_{what}_1_2", "TIFF")) for what in ("OFFSET", "SIZE"))
    del band, dataset
    with open(path, "r+b") as file:
        file.seek(start + size // 2)
        file.write(bytes(size - size // 2))
    return path


def test_the_raster_the_window_and_gdals_words_are_told(damaged: str) -> None:
    with pytest.raises(RasterError) as caught:
        OpenRaster(RasterRef(damaged)).read(DAMAGED)
    why = re.escape("JPEGLib:Premature end of JPEG file")
    assert re.fullmatch(
        rf"damaged\.tif is damaged in columns 128 to 191, rows 256 to 319 \(GDAL: {why}\); copy it again\.",
        str(caught.value),
    )


def test_whoever_asks_again_is_told_again(damaged: str) -> None:
    """What GDAL made up must not come out of its cache."""
    raster = OpenRaster(RasterRef(damaged))
    for _ in range(2):
        with pytest.raises(RasterError, match="damaged in columns"):
            raster.read(DAMAGED)
    with rasters_kept():
        for _ in range(2):
            with pytest.raises(RasterError, match="damaged in columns"):
                open_raster(RasterRef(damaged)).read(DAMAGED)


def test_pixels_that_are_warped_are_told_too(damaged: str, make_raster: MakeRaster) -> None:
    coarse = make_raster("coarse.tif", orthoimage((SIDE // 2, SIDE // 2)), gsd=0.2)
    with pytest.raises(RasterError, match="damaged in columns"):
        read_clip(OpenRaster(RasterRef(damaged)), describe(RasterRef(coarse)), PixelWindow(0, 0, 256, 256))


def test_bytes_behind_a_photo_do_no_harm(make_raster: MakeRaster, tmp_path: Path) -> None:
    """Some cameras leave a few before the end of a JPEG; libjpeg warns of them."""
    path = tmp_path / "photo.jpg"
    gdal.Translate(str(path), make_raster("photo.tif", orthoimage((64, 64))), format="JPEG")
    whole = path.read_bytes()
    expected = read_pixels(str(path), 0, 0, 64, 64)
    path.write_bytes(whole[:-2] + bytes(16) + whole[-2:])
    np.testing.assert_array_equal(OpenRaster(RasterRef(str(path))).read(PixelWindow(0, 0, 64, 64)).bands, expected)


def test_sound_tiles_are_read_smaller_though_gdal_doubts_them(make_raster: MakeRaster) -> None:
    """A half to an eighth of a JPEG tile is decoded alone, and taken for cut off beside a last tile of one column."""
    options = ["TILED=YES", "COMPRESS=JPEG", "PHOTOMETRIC=YCBCR"]
    path = make_raster("sound.tif", orthoimage((300, 513)), options=options)
    whole, doubted = OpenRaster(RasterRef(path)).read(PixelWindow(0, 0, 512, 256)).bands, 0
    for column in range(0, 512, 64):
        window, said = PixelWindow(column, 0, 64, 64), []
        gdal.PushErrorHandler(lambda level, number, text, said=said: said.append(text))
        gdal.Open(path).ReadAsArray(column, 0, 64, 64, buf_xsize=8, buf_ysize=8)
        gdal.PopErrorHandler()
        smaller = OpenRaster(RasterRef(path)).read(window, (8, 8), averaged=True).bands
        if said:
            means = whole[:, :64, column : column + 64].reshape(-1, 8, 8, 8, 8).mean((2, 4))
            np.testing.assert_allclose(smaller, means, atol=0.51)
            doubted += 1
    if not doubted:
        pytest.skip("this GDAL doubts no sound tile")
