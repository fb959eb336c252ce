"""The pixels of a clip: as they are in the file, or warped where grids do not agree."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.errors import NotCoveredError, RasterError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef

from tests.numbers.clips import (
    BLUE,
    GRAY,
    GREEN,
    RED,
    SIZE,
    UNDEFINED,
    MakeRaster,
    clip_of,
    inside,
    scene,
    scene_raster,
)
from tests.numbers.synthetic import ORIGIN, orthoimage, texture


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.int16, np.int32, np.float32, np.float64])
@pytest.mark.parametrize("bands", [1, 3, 4])
def test_pixels_come_as_they_are(make_raster: MakeRaster, mosaic: Raster, dtype: type, bands: int) -> None:
    image = orthoimage(SIZE, bands, dtype=dtype)
    colours = [RED, GREEN, BLUE, UNDEFINED][:bands] if bands > 1 else [GRAY]
    clip = clip_of(make_raster("source.tif", image, colours=colours), mosaic)
    np.testing.assert_array_equal(clip.bands, inside(image))
    assert clip.bands.dtype == dtype
    assert (clip.invalid_share, clip.offset_x, clip.offset_y, clip.resampled) == (0, 0, 0, False)


@pytest.mark.parametrize("shift_x", [0.0, 0.3, -0.3, 0.49, 7.25])
@pytest.mark.parametrize("shift_y", [0.0, 0.2, -0.45, -3.75])
def test_the_subpixel_offset_says_how_far_the_window_lies_right_of_and_below_the_pixels(
    make_raster: MakeRaster, mosaic: Raster, shift_x: float, shift_y: float
) -> None:
    """The source's grid lies that many pixels to the right of and below the mosaic's."""
    row, column = np.mgrid[:256, :256].astype(np.float32)
    path = make_raster(
        "source.tif", np.stack([column, row]), origin=(ORIGIN[0] + 0.1 * shift_x, ORIGIN[1] - 0.1 * shift_y)
    )
    clip = clip_of(path, mosaic)
    assert not clip.resampled
    assert max(abs(clip.offset_x), abs(clip.offset_y)) <= 0.5
    places = clip.bands + np.array([shift_x, shift_y]).reshape(2, 1, 1)  # on the mosaic's grid
    wanted = np.mgrid[80:144, 96:160][::-1]
    np.testing.assert_allclose(wanted[0] - places[0], clip.offset_x, atol=1e-5)
    np.testing.assert_allclose(wanted[1] - places[1], clip.offset_y, atol=1e-5)


@pytest.mark.parametrize(
    ("width", "height", "resampled"),
    [
        (0.1, 0.1, False),
        (0.1005, 0.1005, False),
        (0.0995, 0.1009, False),
        (0.12, 0.12, True),
        (0.098, 0.098, True),
        (0.1, 0.102, True),
        (0.102, 0.1, True),
    ],
)
def test_pixel_sizes_within_a_percent_are_not_resampled(
    make_raster: MakeRaster, mosaic: Raster, width: float, height: float, resampled: bool
) -> None:
    geotransform = (ORIGIN[0] - 2, width, 0.0, ORIGIN[1] + 2, 0.0, -height)
    row, column = np.mgrid[:350, :350].astype(np.float64)
    x, y = geotransform[0] + (column + 0.5) * width, geotransform[3] - (row + 0.5) * height
    path = make_raster("source.tif", np.stack([x - ORIGIN[0], ORIGIN[1] - y]), geotransform=geotransform)
    clip = clip_of(path, mosaic)
    assert clip.resampled is resampled
    centre = clip.bands[:, 31:33, 31:33].mean(axis=(1, 2))  # metres from the mosaic's corner
    wanted = np.array([96 + 32, 80 + 32]) * 0.1
    offset = np.array([clip.offset_x, clip.offset_y]) * 0.1
    np.testing.assert_allclose(wanted - centre, offset, atol=0.002)
    step = (clip.bands[0, 0, -1] - clip.bands[0, 0, 0]) / 63
    assert step == pytest.approx(0.1 if resampled else width, rel=0.0005)


@pytest.mark.parametrize("side", ["left", "right", "top", "bottom"])
def test_a_source_may_end_just_inside_the_window(make_raster: MakeRaster, side: str) -> None:
    """One row or column of 1024 is less than 0.1 % of the pixels, two are more."""
    image = orthoimage((1024, 1024), 1)[0]
    block = describe_mosaic(RasterRef(make_raster("mosaic.tif", image)))
    whole = PixelWindow(0, 0, 1024, 1024)
    for missing in (1, 2):
        cut = {
            "left": (image[:, missing:], (ORIGIN[0] + 0.1 * missing, ORIGIN[1])),
            "right": (image[:, :-missing], ORIGIN),
            "top": (image[missing:], (ORIGIN[0], ORIGIN[1] - 0.1 * missing)),
            "bottom": (image[:-missing], ORIGIN),
        }
        part, origin = cut[side]
        path = make_raster(f"cut{missing}.tif", part, origin=origin)
        if missing == 2:
            with pytest.raises(NotCoveredError, match=r"cut2.tif does not cover the whole window"):
                clip_of(path, block, whole)
            continue
        clip = clip_of(path, block, whole)
        edge = {"left": np.s_[:, 0], "right": np.s_[:, -1], "top": np.s_[0], "bottom": np.s_[-1]}[side]
        kept = np.ones(image.shape, bool)
        kept[edge] = False
        assert clip.invalid_share == 1 / 1024
        np.testing.assert_array_equal(clip.bands[0][kept], image[kept])
        np.testing.assert_allclose(clip.bands[0][edge], part.mean(), atol=1)


def scene_in_window() -> np.ndarray:
    row, column = np.mgrid[80:144, 96:160]
    return scene(ORIGIN[0] + (column + 0.5) * 0.1, ORIGIN[1] - (row + 0.5) * 0.1)


@pytest.mark.parametrize("times", [2, 5])
def test_a_finer_source_is_averaged(make_raster: MakeRaster, mosaic: Raster, times: int) -> None:
    image = (100 + 30 * texture((256 * times, 256 * times), 0.5)).astype(np.float32)
    clip = clip_of(make_raster("source.tif", image, gsd=0.1 / times), mosaic)
    assert clip.resampled
    assert (clip.offset_x, clip.offset_y) == (0, 0)
    averaged = image.reshape(256, times, 256, times).mean(axis=(1, 3))
    np.testing.assert_allclose(clip.bands[0], inside(averaged), atol=0.01)


def test_a_source_too_fine_to_be_averaged_is_refused(tmp_path: Path, mosaic: Raster) -> None:
    """A sparse file of next to no bytes, whose pixels under one window nobody wants to wait for."""
    side, times = 300_000, 1000
    path = str(tmp_path / "finest.tif")
    finest = gdal.GetDriverByName("GTiff").Create(path, side, side, 1, options=["SPARSE_OK=YES", "TILED=YES"])
    left, width, _, top, _, height = mosaic.placement
    finest.SetGeoTransform((left, width / times, 0.0, top, 0.0, height / times))
    finest.SetProjection(mosaic.wkt)
    finest = None
    with pytest.raises(RasterError, match=r"finest.tif has pixels 1000 times finer than the mosaic's"):
        clip_of(path, mosaic)


@pytest.mark.parametrize("gsd", [0.12, 0.2, 0.25])
def test_a_coarser_source_is_interpolated_by_cubic_convolution(
    make_raster: MakeRaster, mosaic: Raster, gsd: float
) -> None:
    clip = clip_of(scene_raster(make_raster, gsd, side_m=12.0), mosaic)
    assert clip.resampled
    # Linear interpolation is off by up to (pi gsd / 3.1 m)^2 / 2 of 90: 0.67, 1.8, 2.9.
    np.testing.assert_allclose(clip.bands[0], scene_in_window(), atol=40 * (np.pi * gsd / 3.1) ** 3)


@pytest.mark.parametrize(
    ("turn_deg", "mirror"),
    [(0, (-1, 1)), (0, (-1, -1)), (7, (1, 1)), (90, (1, 1)), (-135, (1, 1)), (30, (1, -1))],
    ids=["mirrored", "upside down", "turned by 7", "turned by 90", "turned by -135", "turned and south-up"],
)
def test_a_turned_or_mirrored_source_is_warped(
    make_raster: MakeRaster, mosaic: Raster, turn_deg: float, mirror: tuple[int, int]
) -> None:
    path = scene_raster(make_raster, 0.1, turn_deg, mirror)
    assert not describe(RasterRef(path)).is_north_up
    clip = clip_of(path, mosaic)
    assert clip.resampled
    np.testing.assert_allclose(clip.bands[0], scene_in_window(), atol=1.5)


@pytest.mark.parametrize(
    ("system", "gsd", "side_m"),
    [(32634, 0.1, 12.0), (3857, 0.14, 14.0), (4326, 1.2e-6, 1.5e-4), (3035, 0.05, 10.0)],
    ids=["next UTM zone", "web mercator", "degrees", "LAEA, finer"],
)
def test_a_source_in_another_system_is_warped(
    make_raster: MakeRaster, mosaic: Raster, system: int, gsd: float, side_m: float
) -> None:
    clip = clip_of(scene_raster(make_raster, gsd, system=system, side_m=side_m), mosaic)
    assert clip.resampled
    # Half an eighth of a pixel is what GDAL's warper allows itself: 1.5 of 120 a metre x 0.0125 m.
    np.testing.assert_allclose(clip.bands[0], scene_in_window(), atol=3.0)


@pytest.mark.parametrize("nodata", [None, 0])
def test_a_south_up_source_is_turned_over_pixel_by_pixel(
    make_raster: MakeRaster, mosaic: Raster, nodata: int | None
) -> None:
    image = orthoimage(SIZE)
    image[:, 100:110, 100:120] = 0
    x, y = ORIGIN
    north_up, south_up = (x, 0.1, 0.0, y, 0.0, -0.1), (x, 0.1, 0.0, y - 25.6, 0.0, 0.1)
    expected, turned = (
        clip_of(make_raster(name, rows, geotransform=place, nodata=nodata), mosaic, partly=True)
        for name, rows, place in (("north.tif", image, north_up), ("south.tif", image[:, ::-1], south_up))
    )
    assert not turned.resampled
    np.testing.assert_array_equal(turned.bands, expected.bands)
    assert (turned.valid is None) is (nodata is None)
    assert nodata is None or np.array_equal(turned.valid, expected.valid)


def test_gaps_of_a_warped_source_count(make_raster: MakeRaster, mosaic: Raster) -> None:
    image = orthoimage((512, 512), 3)
    image[:, 160:288, 192:200] = 0  # 4 columns of the window
    with pytest.raises(NotCoveredError, match=r"6.25% of the pixels of gap.tif are invalid .* 0.1% are allowed"):
        clip_of(make_raster("gap.tif", image, gsd=0.05, nodata=0), mosaic)
    image = orthoimage((512, 512), 3)
    image[:, 180:184, 220:224] = 0  # 4 pixels of the window
    clip = clip_of(make_raster("spots.tif", image, gsd=0.05, nodata=0), mosaic)
    assert clip.invalid_share == 4 / 4096
    hole = np.zeros((64, 64), bool)
    hole[10:12, 14:16] = True
    averaged = inside(image.reshape(3, 256, 2, 256, 2).mean(axis=(2, 4)))
    np.testing.assert_allclose(clip.bands[:, ~hole], averaged[:, ~hole], atol=0.51)
    for band, filled in zip(averaged, clip.bands):
        np.testing.assert_allclose(filled[hole], band[~hole].mean(), atol=1.5)


def test_a_warped_source_that_ends_in_the_window_does_not_cover_it(make_raster: MakeRaster, mosaic: Raster) -> None:
    with pytest.raises(NotCoveredError, match=r"source.tif"):
        clip_of(scene_raster(make_raster, 0.2, side_m=6.0), mosaic)
