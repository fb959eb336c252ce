"""Pads of black or white around an image without a value for no data are no ground; what only looks like them is."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.clips import Clip, read_clip
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef

from tests.numbers.clips import SIZE, MakeRaster
from tests.numbers.synthetic import orthoimage

WHOLE = PixelWindow(0, 0, *SIZE)
PAD = 100  # columns of the pad: no multiple of JPEG's squares


def clip(path: str, mosaic: Raster) -> Clip:
    return read_clip(OpenRaster(RasterRef(path)), mosaic, WHOLE, partly=True, holes=True)


def padded(value: float, kind: type = np.uint8) -> np.ndarray:
    image = np.clip(orthoimage(SIZE), 10, 245).astype(kind)
    image[:, :, :PAD] = value
    return image


@pytest.mark.parametrize(("kind", "value"), [(np.uint8, 0), (np.uint8, 255), (np.uint16, 0), (np.uint16, 65535)])
def test_a_pad_is_no_ground(make_raster: MakeRaster, mosaic: Raster, kind: type, value: int) -> None:
    shown = clip(make_raster("padded.tif", padded(value, kind)), mosaic)
    assert not shown.valid[:, :PAD].any()
    assert shown.valid[:, PAD:].all()


@pytest.mark.parametrize("quality", [60, 75, 90])
@pytest.mark.parametrize("value", [0, 255])
@pytest.mark.parametrize("nodata", [None, 0])
def test_a_pad_under_jpeg_is_no_ground_and_what_shares_its_squares_is(
    make_raster: MakeRaster, tmp_path: Path, mosaic: Raster, quality: int, value: int, nodata: int | None
) -> None:
    """Whether the file names black or not: JPEG leaves it a few grey values off."""
    options = ["COMPRESS=JPEG", f"JPEG_QUALITY={quality}", "PHOTOMETRIC=YCBCR", "TILED=YES"]
    path = str(tmp_path / "jpeg.tif")
    plain = make_raster("padded.tif", padded(value))
    gdal.Translate(path, plain, creationOptions=options, noData=nodata)
    shown = clip(path, mosaic)
    assert not shown.valid[:, :PAD].any()
    assert shown.valid[:, PAD : PAD + 16].mean() > 0.9
    assert shown.valid[:, PAD + 16 :].all()


def test_a_value_that_the_file_names_is_taken_at_its_word(make_raster: MakeRaster, mosaic: Raster) -> None:
    image = padded(0)
    image[:, :, PAD : PAD + 64] = 255
    shown = clip(make_raster("named.tif", image, nodata=0), mosaic)
    assert shown.valid is not None
    np.testing.assert_array_equal(shown.valid, np.arange(SIZE[1])[np.newaxis] >= np.full((SIZE[0], 1), PAD))


@pytest.mark.parametrize("value", [0, 255])
def test_a_bright_roof_and_deep_shadow_are_ground(make_raster: MakeRaster, mosaic: Raster, value: int) -> None:
    """Wherever they lie: no corner of the image is of them."""
    image = np.clip(orthoimage(SIZE), 10, 245)
    image[:, 60:160, :100] = value
    image[:, 180:190, 100:110] = value
    shown = clip(make_raster("roof.tif", image), mosaic)
    assert shown.valid is None
    assert shown.invalid_share == 0


def test_what_lies_within_a_padded_image_is_ground(make_raster: MakeRaster, mosaic: Raster) -> None:
    """A pond of the pad's value, as large as a pad, that reaches no edge."""
    image = padded(0)
    image[:, 100:180, 150:230] = 0
    shown = clip(make_raster("pond.tif", image), mosaic)
    assert shown.valid[:, PAD:].all()


def test_a_small_black_corner_is_ground(make_raster: MakeRaster, mosaic: Raster) -> None:
    image = np.clip(orthoimage(SIZE), 10, 245)
    image[:, :24, :24] = 0
    assert clip(make_raster("corner.tif", image), mosaic).valid is None


@pytest.mark.parametrize("value", [0, 255])
@pytest.mark.parametrize("width", [1, 2, 20])
def test_a_strip_along_the_image_s_edge_is_no_ground_however_narrow(
    make_raster: MakeRaster, mosaic: Raster, width: int, value: int
) -> None:
    image = np.clip(orthoimage(SIZE), 10, 245)
    image[:, :, -width:] = value
    shown = clip(make_raster("framed.tif", image), mosaic)
    assert shown.valid is not None
    np.testing.assert_array_equal(shown.valid, np.broadcast_to(np.arange(SIZE[1]) < SIZE[1] - width, SIZE))
