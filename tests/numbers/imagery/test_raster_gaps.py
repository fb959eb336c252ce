"""Invalid pixels and bands of every kind: nodata, alpha, masks, palettes."""
from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.errors import NotCoveredError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef

from tests.numbers.clips import (
    ALPHA,
    BLUE,
    CYAN,
    GRAY,
    GREEN,
    RED,
    SIZE,
    UNDEFINED,
    YELLOW,
    MakeRaster,
    clip_of,
    inside,
)
from tests.numbers.synthetic import orthoimage


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
    make_raster: MakeRaster, mosaic: Raster, kind: str
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
def test_a_raster_with_more_invalid_pixels_takes_no_part(make_raster: MakeRaster, mosaic: Raster, kind: str) -> None:
    image, gap = orthoimage(SIZE), np.zeros(SIZE, bool)
    gap[100, 120:125] = True  # 5 of 4096, 0.12 %
    path = GAPS[kind](make_raster, image, gap)
    with pytest.raises(NotCoveredError, match=r"0\.12% of the pixels of gaps\.tif are invalid .* 0\.1% are allowed"):
        clip_of(path, mosaic)
    assert clip_of(path, mosaic, PixelWindow(0, 0, 64, 64)).invalid_share == 0


def test_each_band_has_its_own_nodata(tmp_path: Path, make_raster: MakeRaster, mosaic: Raster) -> None:
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
        ([UNDEFINED, RED, GREEN], "red green nir", [1, 2, 0]),
        ([GRAY, RED, GREEN, ALPHA], "red green nir", [1, 2, 0]),
    ],
)
def test_band_roles(
    make_raster: MakeRaster, mosaic: Raster, colours: list[int], names: str, order: list[int]
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


@pytest.mark.parametrize("names", [
    ("NIR", "Red", "Green"), ("Near infrared", "Red (band 4)", "green"), ("B08 - NIR 1", "Red-650", "Green (560nm)"),
    ("nir_842", "red", "B03: green"),
])  # fmt: skip
@pytest.mark.parametrize("gsd", [0.1, 0.05], ids=["as it is", "warped"])
def test_the_name_of_a_band_goes_before_its_colour(
    make_raster: MakeRaster, mosaic: Raster, gsd: float, names: tuple[str, ...]
) -> None:
    """Infrared, red and green are written as a picture's red, green and blue."""
    path = make_raster("cir.tif", orthoimage((512, 512), 3), gsd=gsd, colours=[RED, GREEN, BLUE])
    before = clip_of(path, mosaic).bands
    dataset = gdal.Open(path, gdal.GA_Update)
    for number, name in enumerate(names, 1):
        dataset.GetRasterBand(number).SetDescription(name)
    del dataset
    clip = clip_of(path, mosaic)
    assert clip.raster.band_names == ("red", "green", "nir")
    np.testing.assert_array_equal(clip.bands, before[[1, 2, 0]])


@pytest.mark.parametrize("name", ["Red edge", "RedEdge", "red_edge 1", "Infrared, red and green", "coloured"])
def test_what_names_no_single_role_leaves_a_band_its_colour(make_raster: MakeRaster, name: str) -> None:
    dataset = gdal.Open(path := make_raster("named.tif", orthoimage(SIZE), colours=[RED, GREEN, BLUE]), gdal.GA_Update)
    dataset.GetRasterBand(3).SetDescription(name)
    del dataset
    assert describe(RasterRef(path)).band_names == ("red", "green", "blue")


PALETTE = [(10, 200, 30, 255), (255, 0, 0, 255), (0, 0, 128, 255), (90, 90, 90, 255), (7, 8, 9, 255)]


def test_a_palette_is_expanded(make_raster: MakeRaster, mosaic: Raster) -> None:
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
    tmp_path: Path, make_raster: MakeRaster, mosaic: Raster, how: str, times: int
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


@pytest.mark.parametrize("gsd", [0.1, 0.05])
@pytest.mark.parametrize("of_file", [None, 0])
def test_additional_nodata_counts_beside_that_of_the_file(
    make_raster: MakeRaster, mosaic: Raster, of_file: int | None, gsd: float
) -> None:
    """A black margin that the file names, a white one that only its user does, and white that is white in one band."""
    times = round(0.1 / gsd)
    image = orthoimage(SIZE, 3)
    image[:, 80:90] = 0
    image[:, 130:140] = 250
    image[0, 100:120] = 250
    path = make_raster("margins.tif", np.kron(image, np.ones((1, times, times), np.uint8)), gsd=gsd, nodata=of_file)
    valid = clip_of(path, mosaic, nodata=250, partly=True).valid
    assert valid is not None
    expected = np.ones(SIZE, bool)
    expected[130:140] = False
    expected[80:90] = of_file is None
    np.testing.assert_array_equal(valid, inside(expected))
