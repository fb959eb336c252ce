"""Every kind of raster a block may hold: its pixels as they are, its gaps, its place on the map, or one sentence."""
from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from osgeo import gdal, osr
from seam_inspector.plugin.core.errors import NotCoveredError, RasterError
from seam_inspector.plugin.core.rasters import (
    Clip,
    Mosaic,
    RasterRef,
    describe,
    describe_mosaic,
    read_clip,
    validity_check,
)
from seam_inspector.plugin.core.systems import extent_on
from seam_inspector.plugin.core.windows import PixelWindow, standard_side_px

from tests.core.synthetic import ORIGIN, UTM33, orthoimage, read_pixels, texture, wkt, write_raster

MakeRaster = Callable[..., str]
SIZE = (256, 256)
WINDOW = PixelWindow(96, 80, 64, 64)
RED, GREEN, BLUE = gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand
GRAY, ALPHA, UNDEFINED = gdal.GCI_GrayIndex, gdal.GCI_AlphaBand, gdal.GCI_Undefined
YELLOW, CYAN = gdal.GCI_YellowBand, gdal.GCI_CyanBand


@pytest.fixture(scope="session")
def mosaic(tmp_path_factory: pytest.TempPathFactory) -> Mosaic:
    """256 x 256 px of 10 cm, red, green and blue in 8 bit."""
    folder = tmp_path_factory.mktemp("mosaic")
    return describe_mosaic(RasterRef(write_raster(folder / "mosaic.tif", orthoimage(SIZE))))


@pytest.fixture(params=[False, True], ids=["quiet GDAL", "GDAL with exceptions"])
def either_gdal(request: pytest.FixtureRequest) -> Iterator[None]:
    """GDAL and OSR as any other plugin in the same process may have left them."""
    before = bool(gdal.GetUseExceptions())
    use_exceptions(request.param)
    yield
    use_exceptions(before)


def use_exceptions(wanted: bool) -> None:
    """GDAL wants them switched off in the opposite order."""
    for module in (gdal, osr) if wanted else (osr, gdal):
        if bool(module.GetUseExceptions()) is not wanted:
            (module.UseExceptions if wanted else module.DontUseExceptions)()


def clip_of(path: str, mosaic: Mosaic, window: PixelWindow = WINDOW, system: str = "") -> Clip:
    return read_clip(RasterRef(path, system), mosaic, window)


def inside(array: np.ndarray, window: PixelWindow = WINDOW) -> np.ndarray:
    return array[..., window.row : window.row + window.height, window.column : window.column + window.width]


# --- pixels as they are ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.int16, np.int32, np.float32, np.float64])
@pytest.mark.parametrize("bands", [1, 3, 4])
def test_pixels_come_as_they_are(make_raster: MakeRaster, mosaic: Mosaic, dtype: type, bands: int) -> None:
    image = orthoimage(SIZE, bands, dtype=dtype)
    colours = [RED, GREEN, BLUE, UNDEFINED][:bands] if bands > 1 else [GRAY]
    clip = clip_of(make_raster("source.tif", image, colours=colours), mosaic)
    np.testing.assert_array_equal(clip.bands, inside(image))
    assert clip.bands.dtype == dtype
    assert (clip.invalid_share, clip.offset_x, clip.offset_y, clip.resampled) == (0, 0, 0, False)


@pytest.mark.parametrize(
    "options",
    [
        (),
        ("INTERLEAVE=BAND",),
        ("COMPRESS=LZW", "PREDICTOR=2"),
        ("TILED=YES", "COMPRESS=DEFLATE", "INTERLEAVE=BAND"),
        ("BIGTIFF=YES", "ENDIANNESS=BIG"),
    ],
)
def test_how_a_file_is_laid_out_does_not_matter(
    make_raster: MakeRaster, mosaic: Mosaic, options: tuple[str, ...]
) -> None:
    image = orthoimage(SIZE, dtype=np.uint16)
    clip = clip_of(make_raster("source.tif", image, options=options), mosaic)
    np.testing.assert_array_equal(clip.bands, inside(image))


def test_pixels_equal_those_gdal_reads(make_raster: MakeRaster, mosaic: Mosaic) -> None:
    path = make_raster("source.tif", orthoimage((300, 400)), origin=(ORIGIN[0] - 2.0, ORIGIN[1] + 3.0))
    clip = clip_of(path, mosaic)
    np.testing.assert_array_equal(clip.bands, read_pixels(path, 96 + 20, 80 + 30, 64, 64))


@pytest.mark.parametrize("shift_x", [0.0, 0.3, -0.3, 0.49, 7.25])
@pytest.mark.parametrize("shift_y", [0.0, 0.2, -0.45, -3.75])
def test_the_subpixel_offset_says_how_far_the_window_lies_right_of_and_below_the_pixels(
    make_raster: MakeRaster, mosaic: Mosaic, shift_x: float, shift_y: float
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
    make_raster: MakeRaster, mosaic: Mosaic, width: float, height: float, resampled: bool
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


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.integers(-300, 300), st.integers(-300, 300))
def test_a_window_beside_or_across_the_edge_is_not_covered(
    make_raster: MakeRaster, mosaic: Mosaic, column: int, row: int
) -> None:
    window = PixelWindow(column, row, 64, 64)
    if mosaic.grid.contains(window):
        assert clip_of(mosaic.ref.path, mosaic, window).bands.shape == (3, 64, 64)
    else:
        with pytest.raises(NotCoveredError, match="does not cover the whole window"):
            clip_of(mosaic.ref.path, mosaic, window)


def test_threads_read_the_same_file_at_once(mosaic: Mosaic) -> None:
    windows = [PixelWindow(8 * index, 4 * index, 64, 64) for index in range(24)]
    with ThreadPoolExecutor(8) as pool:
        clips = list(pool.map(lambda window: clip_of(mosaic.ref.path, mosaic, window), windows))
    image = orthoimage(SIZE)
    for window, clip in zip(windows, clips):
        np.testing.assert_array_equal(clip.bands, inside(image, window))


# --- resampled -------------------------------------------------------------------------------------------------


def scene(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """A smooth scene by coordinates of the mosaic's reference system."""
    right, up = x - ORIGIN[0], y - ORIGIN[1]
    waves = 60 * np.sin(2 * np.pi * right / 3.1) * np.cos(2 * np.pi * up / 4.3)
    return np.asarray(120 + waves + 30 * np.sin(2 * np.pi * (right + 2 * up) / 5.7))


def scene_in_window() -> np.ndarray:
    row, column = np.mgrid[80:144, 96:160]
    return scene(ORIGIN[0] + (column + 0.5) * 0.1, ORIGIN[1] - (row + 0.5) * 0.1)


def scene_raster(
    make_raster: MakeRaster,
    gsd: float = 0.1,
    turn_deg: float = 0.0,
    mirror: tuple[int, int] = (1, 1),
    system: int = UTM33,
    side_m: float = 10.0,
    **options: Any,
) -> str:
    """The scene as a float32 raster in any reference system, about the middle of WINDOW, turned and mirrored.

    Where its pixels lie comes from PROJ, so that it is true whoever warps it. ``gsd`` and ``side_m`` are in
    units of the system.
    """
    to_mosaic = osr.CoordinateTransformation(reference(system), reference(UTM33))
    to_system = osr.CoordinateTransformation(reference(UTM33), reference(system))
    x0, y0, _ = to_system.TransformPoint(ORIGIN[0] + 12.8, ORIGIN[1] - 11.2)
    side = round(side_m / gsd)
    cosine, sine = gsd * math.cos(math.radians(turn_deg)), gsd * math.sin(math.radians(turn_deg))
    a, b, d, e = mirror[0] * cosine, mirror[1] * sine, mirror[0] * sine, -mirror[1] * cosine
    geotransform = (x0 - (a + b) * side / 2, a, b, y0 - (d + e) * side / 2, d, e)
    row, column = np.mgrid[:side, :side] + 0.5
    x, y = geotransform[0] + a * column + b * row, geotransform[3] + d * column + e * row
    points = to_mosaic.TransformPoints(np.column_stack([x.ravel(), y.ravel()]).tolist())
    placed = np.array(points)[:, :2].reshape(side, side, 2)
    image = scene(placed[..., 0], placed[..., 1]).astype(np.float32)
    return make_raster("source.tif", image, geotransform=geotransform, system=system, **options)


def reference(system: int) -> osr.SpatialReference:
    made = osr.SpatialReference()
    made.ImportFromEPSG(system)
    made.SetAxisMappingStrategy(osr.OAMS_TRADITIONAL_GIS_ORDER)
    return made


@pytest.mark.parametrize("times", [2, 5])
def test_a_finer_source_is_averaged(make_raster: MakeRaster, mosaic: Mosaic, times: int) -> None:
    image = (100 + 30 * texture((256 * times, 256 * times), 0.5)).astype(np.float32)
    clip = clip_of(make_raster("source.tif", image, gsd=0.1 / times), mosaic)
    assert clip.resampled
    assert (clip.offset_x, clip.offset_y) == (0, 0)
    averaged = image.reshape(256, times, 256, times).mean(axis=(1, 3))
    np.testing.assert_allclose(clip.bands[0], inside(averaged), atol=0.01)


def test_a_finer_8_bit_source_is_averaged_to_8_bit(make_raster: MakeRaster, mosaic: Mosaic) -> None:
    image = orthoimage((512, 512), 3)
    clip = clip_of(make_raster("source.tif", image, gsd=0.05), mosaic)
    assert clip.bands.dtype == np.uint8
    averaged = image.reshape(3, 256, 2, 256, 2).mean(axis=(2, 4))
    np.testing.assert_allclose(clip.bands, inside(averaged), atol=0.51)


@pytest.mark.parametrize("gsd", [0.12, 0.2, 0.25])
def test_a_coarser_source_is_interpolated_by_cubic_convolution(
    make_raster: MakeRaster, mosaic: Mosaic, gsd: float
) -> None:
    clip = clip_of(scene_raster(make_raster, gsd, side_m=12.0), mosaic)
    assert clip.resampled
    # Linear interpolation is off by up to (pi gsd / 3.1 m)^2 / 2 of 90: 0.67, 1.8, 2.9.
    np.testing.assert_allclose(clip.bands[0], scene_in_window(), atol=40 * (np.pi * gsd / 3.1) ** 3)


@pytest.mark.parametrize(
    ("turn_deg", "mirror"),
    [(0, (1, -1)), (0, (-1, 1)), (0, (-1, -1)), (7, (1, 1)), (90, (1, 1)), (-135, (1, 1)), (30, (1, -1))],
    ids=["south-up", "mirrored", "upside down", "turned by 7", "turned by 90", "turned by -135", "turned and south-up"],
)
def test_a_turned_or_mirrored_source_is_warped(
    make_raster: MakeRaster, mosaic: Mosaic, turn_deg: float, mirror: tuple[int, int]
) -> None:
    path = scene_raster(make_raster, 0.1, turn_deg, mirror)
    assert describe(RasterRef(path)).grid is None
    clip = clip_of(path, mosaic)
    assert clip.resampled
    np.testing.assert_allclose(clip.bands[0], scene_in_window(), atol=1.5)


@pytest.mark.parametrize(
    ("system", "gsd", "side_m"),
    [(32634, 0.1, 12.0), (3857, 0.14, 14.0), (4326, 1.2e-6, 1.5e-4), (3035, 0.05, 10.0)],
    ids=["next UTM zone", "web mercator", "degrees", "LAEA, finer"],
)
def test_a_source_in_another_system_is_warped(
    make_raster: MakeRaster, mosaic: Mosaic, system: int, gsd: float, side_m: float
) -> None:
    clip = clip_of(scene_raster(make_raster, gsd, system=system, side_m=side_m), mosaic)
    assert clip.resampled
    # Half an eighth of a pixel is what GDAL's warper allows itself: 1.5 of 120 a metre x 0.0125 m.
    np.testing.assert_allclose(clip.bands[0], scene_in_window(), atol=3.0)


def test_the_detail_of_a_turned_source_of_the_same_pixel_size_is_not_averaged_away(
    make_raster: MakeRaster, mosaic: Mosaic
) -> None:
    image = orthoimage(SIZE, 1, beta=1.0, dtype=np.float32)[0]
    south_up = (ORIGIN[0] + 0.05, 0.1, 0.0, ORIGIN[1] - 25.55, 0.0, 0.1)  # half a pixel off in both axes
    turned = clip_of(make_raster("source.tif", image[::-1], geotransform=south_up), mosaic).bands[0]
    averaged = sum(inside(np.roll(image, (down, right), (0, 1))) for down in (0, 1) for right in (0, 1)) / 4
    assert np.diff(turned).var() > 1.2 * np.diff(averaged).var()


def test_gaps_of_a_warped_source_count(make_raster: MakeRaster, mosaic: Mosaic) -> None:
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


def test_nodata_in_one_band_of_a_warped_source_stays_valid(make_raster: MakeRaster, mosaic: Mosaic) -> None:
    image = orthoimage((512, 512), 3)
    image[2, ::2, 1::2] = 0  # a quarter of the blue pixels, one in each pixel of the window
    clip = clip_of(make_raster("source.tif", image, gsd=0.05, nodata=0), mosaic)
    assert clip.invalid_share == 0
    averaged = image.reshape(3, 256, 2, 256, 2).mean(axis=(2, 4))
    np.testing.assert_allclose(clip.bands, inside(averaged), atol=0.51)


def test_a_warped_source_that_ends_in_the_window_does_not_cover_it(make_raster: MakeRaster, mosaic: Mosaic) -> None:
    with pytest.raises(NotCoveredError, match=r"source.tif"):
        clip_of(scene_raster(make_raster, 0.2, side_m=6.0), mosaic)


# --- gaps ------------------------------------------------------------------------------------------------------


def nodata_in(kind: type, value: float) -> Callable[..., str]:
    def make(make_raster: MakeRaster, image: np.ndarray, gap: np.ndarray) -> str:
        image = image.astype(kind)
        image[:, gap] = value
        return make_raster("gaps.tif", image, nodata=value)

    return make


def not_finite(value: float) -> Callable[..., str]:
    def make(make_raster: MakeRaster, image: np.ndarray, gap: np.ndarray) -> str:
        image = image.astype(np.float32)
        image[0, gap] = value  # one band is enough: there is nothing to measure in it
        return make_raster("gaps.tif", image)

    return make


def alpha_band(make_raster: MakeRaster, image: np.ndarray, gap: np.ndarray) -> str:
    alpha = np.where(gap, 0, 255).astype(np.uint8)
    return make_raster("gaps.tif", np.concatenate([image, alpha[np.newaxis]]), colours=[RED, GREEN, BLUE, ALPHA])


def mask_inside(make_raster: MakeRaster, image: np.ndarray, gap: np.ndarray) -> str:
    return make_raster("gaps.tif", image, valid=~gap)


def mask_beside(make_raster: MakeRaster, image: np.ndarray, gap: np.ndarray) -> str:
    path = make_raster("gaps.tif", image, valid=~gap, mask_inside=False)
    assert Path(path + ".msk").exists()
    return path


GAPS = {
    "nodata 0": nodata_in(np.uint8, 0),
    "nodata 255": nodata_in(np.uint8, 255),
    "nodata in 16 bit": nodata_in(np.uint16, 65535),
    "nodata in signed 16 bit": nodata_in(np.int16, -32768),
    "nodata in float": nodata_in(np.float32, -9999),
    "the lowest float as nodata": nodata_in(np.float32, float(np.finfo(np.float32).min)),
    "nodata with decimals": nodata_in(np.float32, 0.1),
    "NaN as nodata": nodata_in(np.float64, math.nan),
    "NaN": not_finite(math.nan),
    "infinity": not_finite(math.inf),
    "minus infinity": not_finite(-math.inf),
    "alpha band": alpha_band,
    "mask inside": mask_inside,
    "mask beside": mask_beside,
}


@pytest.mark.parametrize("kind", GAPS)
def test_a_few_invalid_pixels_are_filled_with_the_mean_of_the_valid_ones(
    make_raster: MakeRaster, mosaic: Mosaic, kind: str
) -> None:
    image, gap = orthoimage(SIZE), np.zeros(SIZE, bool)
    gap[100:102, 120:122] = True  # 4 of 4096, 0.098 %
    gap[0:60] = gap[:, :90] = True  # and a lot outside the window
    clip = clip_of(GAPS[kind](make_raster, image, gap), mosaic)
    hole = inside(gap)
    assert clip.bands.shape == (3, 64, 64)
    assert clip.invalid_share == 4 / 4096
    for band, filled in zip(inside(image), clip.bands):
        np.testing.assert_array_equal(filled[~hole], band[~hole])
        np.testing.assert_allclose(filled[hole], band[~hole].mean(), atol=1)


@pytest.mark.parametrize("kind", GAPS)
def test_a_raster_with_more_invalid_pixels_takes_no_part(make_raster: MakeRaster, mosaic: Mosaic, kind: str) -> None:
    image, gap = orthoimage(SIZE), np.zeros(SIZE, bool)
    gap[100, 120:125] = True  # 5 of 4096, 0.12 %
    path = GAPS[kind](make_raster, image, gap)
    with pytest.raises(NotCoveredError, match=r"0\.12% of the pixels of gaps\.tif are invalid .* 0\.1% are allowed"):
        clip_of(path, mosaic)
    assert clip_of(path, mosaic, PixelWindow(0, 0, 64, 64)).invalid_share == 0


@pytest.mark.parametrize("kind", GAPS)
def test_a_raster_without_any_valid_pixel_takes_no_part(make_raster: MakeRaster, mosaic: Mosaic, kind: str) -> None:
    path = GAPS[kind](make_raster, orthoimage(SIZE), np.ones(SIZE, bool))
    with pytest.raises(NotCoveredError, match=r"100\.00% of the pixels of gaps\.tif are invalid"):
        clip_of(path, mosaic)


def test_a_pixel_with_nodata_in_one_band_only_is_valid(make_raster: MakeRaster, mosaic: Mosaic) -> None:
    image = orthoimage(SIZE)
    image[2] = 0  # no blue at all
    image[1, :, ::2] = 0
    clip = clip_of(make_raster("source.tif", image, nodata=0), mosaic)
    assert clip.invalid_share == 0
    np.testing.assert_array_equal(clip.bands, inside(image))


def test_each_band_has_its_own_nodata(tmp_path: Path, make_raster: MakeRaster, mosaic: Mosaic) -> None:
    image = orthoimage(SIZE, 2)
    image[0, 90:92, 100:102], image[1, 90:92, 100:102] = 3, 250
    image[0, 95], image[1, 96] = 3, 250  # one of both only
    path = str(tmp_path / "source.vrt")
    dataset = gdal.Translate(path, make_raster("plain.tif", image), format="VRT")
    dataset.GetRasterBand(1).SetNoDataValue(3)
    del dataset
    assert clip_of(path, mosaic).invalid_share == 0  # the second band has none, so each pixel is valid
    dataset = gdal.Open(path, gdal.GA_Update)
    dataset.GetRasterBand(2).SetNoDataValue(250)
    del dataset
    assert clip_of(path, mosaic).invalid_share == 4 / 4096


def test_nodata_that_the_data_type_cannot_hold_is_no_gap(
    tmp_path: Path, make_raster: MakeRaster, mosaic: Mosaic
) -> None:
    image = orthoimage(SIZE)
    image[:, 100:110, 100:110] = 241  # -9999 in 8 bit
    path = make_raster("source.tif", image, nodata=-9999)
    clip = clip_of(path, mosaic)
    assert clip.invalid_share == 0
    np.testing.assert_array_equal(clip.bands, inside(image))


def test_validity_is_checked_from_a_part_of_the_pixels(make_raster: MakeRaster) -> None:
    image = orthoimage(SIZE)
    image[:, :100] = 0
    image[:, 150, 150] = 0
    block = describe_mosaic(RasterRef(make_raster("mosaic.tif", image, nodata=0)))
    is_valid = validity_check(block)
    assert is_valid(PixelWindow(0, 100, 128, 128))
    assert not is_valid(PixelWindow(0, 0, 64, 64))
    assert not is_valid(PixelWindow(100, 92, 128, 128))


# --- bands -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("colours", "names", "order"),
    [
        ([GRAY], "band_1", [0]),
        ([GRAY, UNDEFINED], "band_1 band_2", [0, 1]),
        ([GRAY, ALPHA], "band_1", [0]),
        ([RED, GREEN, BLUE], "red green blue", [0, 1, 2]),
        ([BLUE, GREEN, RED], "red green blue", [2, 1, 0]),
        ([RED, GREEN, BLUE, UNDEFINED], "red green blue nir", [0, 1, 2, 3]),
        ([BLUE, GREEN, RED, UNDEFINED], "red green blue nir", [2, 1, 0, 3]),
        ([UNDEFINED, RED, GREEN, BLUE], "red green blue nir", [1, 2, 3, 0]),
        ([RED, GREEN, BLUE, ALPHA], "red green blue", [0, 1, 2]),
        ([RED, GREEN, BLUE, UNDEFINED, ALPHA], "red green blue nir", [0, 1, 2, 3]),
        ([RED, GREEN, BLUE, UNDEFINED, UNDEFINED], "red green blue nir band_5", [0, 1, 2, 3, 4]),
        ([GRAY, UNDEFINED, UNDEFINED], "red green blue", [0, 1, 2]),
        ([GRAY, UNDEFINED, UNDEFINED, UNDEFINED], "red green blue nir", [0, 1, 2, 3]),
        ([GRAY, UNDEFINED, UNDEFINED, ALPHA], "red green blue", [0, 1, 2]),
        ([YELLOW, CYAN, UNDEFINED], "red green blue", [0, 1, 2]),
    ],
)
def test_band_roles(
    make_raster: MakeRaster, mosaic: Mosaic, colours: list[int], names: str, order: list[int]
) -> None:
    image = orthoimage(SIZE, len(colours))
    if ALPHA in colours:
        image[colours.index(ALPHA)] = 255
    path = make_raster("source.tif", image, colours=colours)
    dataset = gdal.Open(path)
    kept = [dataset.GetRasterBand(band + 1).GetColorInterpretation() for band in range(len(colours))]
    assert kept == colours
    raster = describe(RasterRef(path))
    assert " ".join(raster.band_names) == names
    assert raster.has_luminance is names.startswith("red green blue")
    np.testing.assert_array_equal(clip_of(path, mosaic).bands, inside(image)[order])


def test_bands_keep_their_roles_when_warped(make_raster: MakeRaster, mosaic: Mosaic) -> None:
    image = orthoimage((512, 512), 5)
    image[4] = 255
    path = make_raster("source.tif", image, gsd=0.05, colours=[BLUE, GREEN, RED, UNDEFINED, ALPHA])
    clip = clip_of(path, mosaic)
    assert clip.raster.band_names == ("red", "green", "blue", "nir")
    averaged = image.reshape(5, 256, 2, 256, 2).mean(axis=(2, 4))
    np.testing.assert_allclose(clip.bands, inside(averaged)[[2, 1, 0, 3]], atol=0.51)


PALETTE = [(10, 200, 30, 255), (255, 0, 0, 255), (0, 0, 128, 255), (90, 90, 90, 255), (7, 8, 9, 255)]


def test_a_palette_is_expanded(make_raster: MakeRaster, mosaic: Mosaic) -> None:
    indices = np.random.default_rng(1).integers(0, 5, SIZE).astype(np.uint8)
    path = make_raster("source.tif", indices, palette=PALETTE)
    assert describe(RasterRef(path)).band_names == ("red", "green", "blue")
    clip = clip_of(path, mosaic)
    np.testing.assert_array_equal(np.moveaxis(clip.bands, 0, -1), np.array(PALETTE)[inside(indices)][..., :3])
    finer = make_raster("finer.tif", np.kron(indices, np.ones((2, 2), np.uint8)), palette=PALETTE, gsd=0.05)
    warped = clip_of(finer, mosaic)
    assert warped.resampled
    np.testing.assert_array_equal(warped.bands, clip.bands)


@pytest.mark.parametrize("times", [1, 2], ids=["as it is", "warped"])
@pytest.mark.parametrize("how", ["transparent entry", "nodata index", "mask"])
def test_gaps_of_a_palette(
    tmp_path: Path, make_raster: MakeRaster, mosaic: Mosaic, how: str, times: int
) -> None:
    indices = np.random.default_rng(1).integers(0, 4, SIZE).astype(np.uint8)
    indices[100:102, 120:122] = 4
    enlarged = np.kron(indices, np.ones((times, times), np.uint8))
    options: dict[str, Any] = {"palette": PALETTE, "gsd": 0.1 / times}
    options.update({"nodata index": {"nodata": 4}, "mask": {"valid": enlarged != 4}}.get(how, {}))
    path = make_raster("source.tif", enlarged, **options)
    if how == "transparent entry":  # TIFF keeps no transparency of its palettes
        dataset = gdal.Translate(str(tmp_path / "source.vrt"), path, format="VRT")
        table = dataset.GetRasterBand(1).GetColorTable().Clone()
        table.SetColorEntry(4, (*PALETTE[4][:3], 0))
        dataset.GetRasterBand(1).SetColorTable(table)
        del dataset
        path = str(tmp_path / "source.vrt")
    clip = clip_of(path, mosaic)
    assert clip.bands.shape == (3, 64, 64)
    assert clip.resampled is (times > 1)
    assert clip.invalid_share == 4 / 4096
    valid = inside(indices) != 4
    colours = np.array(PALETTE)[inside(indices)][..., :3]
    np.testing.assert_array_equal(np.moveaxis(clip.bands, 0, -1)[valid], colours[valid])
    np.testing.assert_allclose(clip.bands[:, ~valid].mean(axis=1), colours[valid].mean(axis=0), atol=1)


# --- place on the map ------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "system",
    [
        wkt(UTM33).replace("WGS 84 / UTM zone 33N", "site grid"),
        "+proj=utm +zone=33 +datum=WGS84 +units=m +no_defs",
        "+proj=tmerc +lat_0=0 +lon_0=15 +k=0.9996 +x_0=500000 +y_0=0 +datum=WGS84 +units=m",
        wkt(25833),  # ETRS89: other numbers by the continent's drift only, which PROJ leaves alone
    ],
    ids=["renamed", "PROJ's UTM", "PROJ's transverse Mercator", "ETRS89"],
)
def test_the_same_system_under_another_name_is_not_warped(
    make_raster: MakeRaster, mosaic: Mosaic, system: str
) -> None:
    image = orthoimage(SIZE)
    clip = clip_of(make_raster("source.tif", image, system=None), mosaic, system=system)
    assert clip.raster.wkt != mosaic.wkt
    assert not clip.resampled
    np.testing.assert_array_equal(clip.bands, inside(image))


def test_the_same_numbers_in_another_zone_are_another_place(make_raster: MakeRaster, mosaic: Mosaic) -> None:
    with pytest.raises(NotCoveredError, match=r"source\.tif"):
        clip_of(make_raster("source.tif", orthoimage(SIZE), system=32634), mosaic)


def test_a_reference_may_bring_the_system_that_a_file_lacks(make_raster: MakeRaster, mosaic: Mosaic) -> None:
    image = orthoimage(SIZE)
    path = make_raster("bare.tif", image, system=None)
    assert describe(RasterRef(path)).wkt == ""
    with pytest.raises(RasterError, match=r"bare.tif has no coordinate reference system; set it"):
        describe_mosaic(RasterRef(path))
    with pytest.raises(RasterError, match=r"bare.tif has no coordinate reference system; set it"):
        clip_of(path, mosaic)
    assert describe_mosaic(RasterRef(path, wkt(UTM33))).wkt == wkt(UTM33)
    clip = clip_of(path, mosaic, system=wkt(UTM33))
    np.testing.assert_array_equal(clip.bands, inside(image))


def test_the_system_of_the_file_goes_before_that_of_its_reference(make_raster: MakeRaster) -> None:
    path = make_raster("source.tif", orthoimage((64, 64)))
    assert describe(RasterRef(path, wkt(4326))).wkt == describe(RasterRef(path)).wkt


@pytest.mark.parametrize(
    "geotransform",
    [
        (ORIGIN[0], 0.1, 0.01, ORIGIN[1], 0.01, -0.1),
        (ORIGIN[0], 0.0, 0.1, ORIGIN[1], 0.1, 0.0),
        (ORIGIN[0], 0.1, 0.0, ORIGIN[1], 0.0, 0.1),
        (ORIGIN[0], -0.1, 0.0, ORIGIN[1], 0.0, -0.1),
    ],
    ids=["skewed", "turned by 90", "south-up", "mirrored"],
)
def test_a_mosaic_that_is_not_north_up_is_refused(
    make_raster: MakeRaster, geotransform: tuple[float, ...]
) -> None:
    path = make_raster("turned.tif", orthoimage((64, 64)), geotransform=geotransform)
    with pytest.raises(RasterError, match=r"turned.tif is rotated, mirrored or south-up; warp it to a north-up grid"):
        describe_mosaic(RasterRef(path))
    assert describe(RasterRef(path)).ground_sample_distance == pytest.approx(0.1, rel=0.01)


def test_rounding_in_a_geotransform_is_no_rotation(make_raster: MakeRaster) -> None:
    geotransform = (ORIGIN[0], 0.1, 1e-11, ORIGIN[1], -1e-11, -0.1)
    assert describe_mosaic(RasterRef(make_raster("mosaic.tif", orthoimage(SIZE), geotransform=geotransform))).grid


def test_a_raster_without_a_position_is_refused(tmp_path: Path) -> None:
    path = str(tmp_path / "photo.tif")
    gdal.GetDriverByName("GTiff").Create(path, 64, 64, 3).FlushCache()
    with pytest.raises(RasterError, match=r"photo.tif has no position on the map; georeference"):
        describe(RasterRef(path))


def test_the_extent_bounds_all_corners(make_raster: MakeRaster) -> None:
    turned = make_raster("a.tif", orthoimage((40, 30)), geotransform=(1000.0, 0.3, 0.4, 2000.0, 0.4, -0.3))
    assert describe(RasterRef(turned)).extent == pytest.approx((1000, 1988, 1025, 2012))
    upright = describe(RasterRef(make_raster("b.tif", orthoimage((40, 30)), gsd=0.5)))
    assert upright.grid is not None
    assert upright.extent == upright.grid.extent == pytest.approx((500000, 4999980, 500015, 5000000))


@pytest.mark.parametrize(
    ("latitude", "along_meridian", "along_parallel"),
    [  # metres per degree of WGS 84, from the usual table of the length of a degree
        (0, 110574, 111320),
        (15, 110649, 107550),
        (30, 110852, 96486),
        (45, 111132, 78847),
        (-60, 111412, 55800),
        (75, 111618, 28902),
    ],
)
def test_metres_mean_metres_in_a_geographic_system(
    make_raster: MakeRaster, latitude: float, along_meridian: float, along_parallel: float
) -> None:
    step = 1e-6
    geotransform = (15.0, step, 0.0, latitude + 32 * step, 0.0, -step)
    path = make_raster("degrees.tif", orthoimage((64, 64)), geotransform=geotransform, system=4326)
    grid = describe_mosaic(RasterRef(path)).grid
    assert grid.metres_y == pytest.approx(along_meridian, abs=1)
    assert grid.metres_x == pytest.approx(along_parallel, abs=1)
    metres = min(along_meridian, along_parallel) * step
    assert standard_side_px(grid, 100) == 2 ** math.ceil(math.log2(100 / metres))


@pytest.mark.parametrize(
    ("system", "metres"),
    [(2225, 12 / 39.37), ("+proj=utm +zone=33 +datum=WGS84 +units=ft", 0.3048), ("+proj=utm +zone=33 +units=km", 1000)],
    ids=["survey feet", "feet", "kilometres"],
)
def test_metres_mean_metres_whatever_the_unit_of_the_system(
    make_raster: MakeRaster, system: str | int, metres: float
) -> None:
    path = make_raster("units.tif", orthoimage((64, 64)), gsd=0.5, system=wkt(system))
    grid = describe_mosaic(RasterRef(path)).grid
    assert (grid.metres_x, grid.metres_y) == pytest.approx((metres, metres))
    assert grid.ground_sample_distance == pytest.approx(0.5 * metres)


def test_rasters_in_degrees_are_compared_as_they_are(make_raster: MakeRaster) -> None:
    geotransform = (15.0, 1.3e-6, 0.0, 52.0, 0.0, -9e-7)
    image = orthoimage(SIZE)
    block = describe_mosaic(RasterRef(make_raster("m.tif", image, geotransform=geotransform, system=4326)))
    shifted = (15.0 + 4.25 * 1.3e-6, 1.3e-6, 0.0, 52.0 - 3.5 * 9e-7, 0.0, -9e-7)
    clip = clip_of(make_raster("s.tif", image, geotransform=shifted, system=4326), block)
    assert not clip.resampled
    assert clip.offset_x == pytest.approx(-0.25, abs=1e-3)
    assert abs(clip.offset_y) == pytest.approx(0.5, abs=1e-3)
    assert clip.bands.shape == (3, 64, 64)


def test_an_extent_is_carried_to_another_system() -> None:
    extent = (499000.0, 4990000.0, 509000.0, 5000000.0)
    assert extent_on(extent, wkt(UTM33), wkt(UTM33)) == extent
    xmin, ymin, xmax, ymax = extent_on(extent, wkt(UTM33), wkt(4326))
    to_degrees = osr.CoordinateTransformation(reference(UTM33), reference(4326))
    edge = np.linspace(0, 1, 11)
    border = [(499000 + 10000 * s, y) for s in edge for y in (extent[1], extent[3])]
    border += [(x, 4990000 + 10000 * s) for s in edge for x in (extent[0], extent[2])]
    degrees = np.array(to_degrees.TransformPoints(border))
    assert xmin == pytest.approx(degrees[:, 0].min(), abs=1e-6)
    assert xmax == pytest.approx(degrees[:, 0].max(), abs=1e-6)
    assert ymin == pytest.approx(degrees[:, 1].min(), abs=1e-6)
    assert ymax == pytest.approx(degrees[:, 1].max(), abs=1e-6)


# --- what is no raster to measure ------------------------------------------------------------------------------


LOCAL = 'LOCAL_CS["site",UNIT["metre",1]]'


@pytest.mark.usefixtures("either_gdal")
class TestWithAndWithoutGdalsExceptions:
    """``gdal.UseExceptions()`` is process-wide, so any plugin may have called it before."""

    def test_good_rasters(self, make_raster: MakeRaster, mosaic: Mosaic) -> None:
        image = orthoimage(SIZE)
        np.testing.assert_array_equal(clip_of(make_raster("a.tif", image), mosaic).bands, inside(image))
        assert clip_of(scene_raster(make_raster, 0.2, 5), mosaic).resampled
        fill = clip_of(make_raster("b.tif", image, valid=np.indices(SIZE).sum(axis=0) != 200), mosaic, WINDOW_BELOW)
        assert fill.invalid_share == 0

    @pytest.mark.parametrize(
        ("content", "sentence"),
        [
            (None, "does not exist; check the path"),
            (b"", "is not a raster that GDAL can read"),
            (b"x;y\n500000;5000000\n", "is not a raster that GDAL can read"),
            (b"II*\0" + bytes(60), "is not a raster that GDAL can read"),
        ],
        ids=["missing", "empty", "text", "broken header"],
    )
    def test_no_raster(self, tmp_path: Path, mosaic: Mosaic, content: bytes | None, sentence: str) -> None:
        path = tmp_path / "file.tif"
        if content is not None:
            path.write_bytes(content)
        with pytest.raises(RasterError, match=rf"file.tif {sentence}"):
            describe(RasterRef(str(path)))
        with pytest.raises(RasterError, match=rf"file.tif {sentence}"):
            clip_of(str(path), mosaic)

    @pytest.mark.parametrize("gsd", [0.1, 0.05], ids=["as it is", "warped"])
    def test_a_truncated_file(self, make_raster: MakeRaster, mosaic: Mosaic, gsd: float) -> None:
        path = Path(make_raster("cut.tif", orthoimage((512, 512)), gsd=gsd))
        path.write_bytes(path.read_bytes()[: path.stat().st_size // 8])
        with pytest.raises(RasterError, match=r"cut.tif (can't be read; the file may be truncated|is not a raster)"):
            clip_of(str(path), mosaic)

    def test_a_file_truncated_before_its_directory(self, make_raster: MakeRaster, mosaic: Mosaic) -> None:
        path = Path(make_raster("cut.tif", orthoimage(SIZE)))
        path.write_bytes(path.read_bytes()[:6])
        with pytest.raises(RasterError, match=r"cut.tif is not a raster that GDAL can read"):
            clip_of(str(path), mosaic)

    def test_a_damaged_mask(self, make_raster: MakeRaster, mosaic: Mosaic) -> None:
        valid = np.random.default_rng(0).random(SIZE) < 0.5
        path = make_raster("source.tif", orthoimage(SIZE), valid=valid, mask_inside=False)
        mask = Path(path + ".msk")
        content = mask.read_bytes()
        third = len(content) // 3
        mask.write_bytes(content[:third] + b"\x55" * third + content[2 * third :])
        with pytest.raises(RasterError, match=r"pixels of source.tif can't be read"):
            clip_of(path, mosaic)

    def test_complex_values(self, make_raster: MakeRaster, mosaic: Mosaic) -> None:
        path = make_raster("radar.tif", orthoimage(SIZE, 1).astype(np.complex64))
        with pytest.raises(RasterError, match=r"radar.tif holds complex values; convert them to magnitudes"):
            clip_of(path, mosaic)

    def test_no_bands_of_its_own(self, tmp_path: Path, make_raster: MakeRaster, mosaic: Mosaic) -> None:
        path, image = str(tmp_path / "two.gpkg"), make_raster("image.tif", orthoimage(SIZE))
        for table, append in (("a", "NO"), ("b", "YES")):
            options = [f"RASTER_TABLE={table}", f"APPEND_SUBDATASET={append}"]
            assert gdal.Translate(path, image, format="GPKG", creationOptions=options)
        with pytest.raises(RasterError, match=r"two.gpkg has no bands of its own; choose one of its subdatasets"):
            clip_of(path, mosaic)

    def test_a_raster_of_one_pixel(self, make_raster: MakeRaster, mosaic: Mosaic) -> None:
        path = make_raster("pixel.tif", np.full((3, 1, 1), 9, np.uint8), origin=(ORIGIN[0] + 12.0, ORIGIN[1] - 11.0))
        assert describe_mosaic(RasterRef(path)).grid.columns == 1
        with pytest.raises(NotCoveredError, match=r"pixel.tif does not cover the whole window"):
            clip_of(path, mosaic)

    def test_no_reference_system(self, make_raster: MakeRaster, mosaic: Mosaic) -> None:
        path = make_raster("bare.tif", orthoimage(SIZE), system=None)
        with pytest.raises(RasterError, match=r"bare.tif has no coordinate reference system"):
            clip_of(path, mosaic)

    @pytest.mark.parametrize("system", [LOCAL, "nonsense"])
    def test_a_system_that_leads_nowhere(self, make_raster: MakeRaster, mosaic: Mosaic, system: str) -> None:
        with pytest.raises(RasterError, match="can't be transformed to the mosaic's coordinate reference system"):
            extent_on((0, 0, 1, 1), system, mosaic.wkt)
        path = make_raster("site.tif", orthoimage(SIZE), system=None)
        with pytest.raises(RasterError, match="can't be transformed to the mosaic's coordinate reference system"):
            clip_of(path, mosaic, system=system)

    def test_an_unknown_place(self, make_raster: MakeRaster, mosaic: Mosaic) -> None:
        path = make_raster("far.tif", orthoimage(SIZE), origin=(1e7, 9e6), system=32634)
        with pytest.raises(NotCoveredError, match=r"far\.tif"):
            clip_of(path, mosaic)


WINDOW_BELOW = PixelWindow(96, 150, 64, 64)
