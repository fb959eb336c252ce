"""JRC's figures are of the luminosity: against numpy, on made and on real images."""
from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.radiometry.measure.image_statistics import luminosity
from seam_inspector.plugin.radiometry.measure.rules import Rule, RuleSet, load_rules, ready_rule_files

from tests.numbers.radiometry.judging import checked, checked_figure, figure, reasons
from tests.numbers.synthetic import orthoimage, texture

MakeRaster = Callable[..., str]
REAL_WINDOWS = [
    ("seams/brighton/DJI_0025_ortho.tif", (700, 700, 700, 600)),
    ("seams/brighton/DJI_0026_ortho.tif", (500, 900, 800, 500)),
    ("seams/brighton/DJI_0028_ortho.tif", (600, 600, 512, 512)),
    ("seams/brighton/DJI_0031_ortho.tif", (300, 700, 900, 400)),
    ("seams/brighton/DJI_0034_ortho.tif", (800, 500, 600, 700)),
    ("seams/brighton/mosaic_hardseam.tif", None),
    ("seams/packo/19FD5606Ax00020_16371.tif", None),
    ("seams/packo/19FD5606Ax00020_16373.tif", None),
    ("noise/seneca/IMG_0460.jpg", (1000, 500, 1500, 1200)),
    ("frames/ngi/3324c_2015_1004_05_0182_RGB.tif", None),
]


def mixed(pixels: np.ndarray) -> np.ndarray:
    red, green, blue = pixels[:3].astype(np.float64)
    return np.rint(0.299 * red + 0.587 * green + 0.114 * blue)


def own_figures(values: np.ndarray) -> dict[str, float]:
    """JRC's measures of 8 bit luminosities by numpy alone."""
    counts = np.bincount(values.astype(np.int64), minlength=256)
    return {
        "clipped_low": (values <= 4).mean(), "clipped_high": (values >= 251).mean(),
        "peak": abs(counts.argmax() - 127.5) / 255, "contrast": values.std() / 255,
    }  # fmt: skip


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.int16, np.float32])
def test_it_is_the_weighted_sum_in_the_type_of_the_pixels(dtype: type) -> None:
    random = np.random.default_rng(0)
    span = (0.0, 1.0) if dtype is np.float32 else (np.iinfo(dtype).min, np.iinfo(dtype).max)
    bands = random.uniform(*span, (4, 200, 200)).astype(dtype)
    red, green, blue = bands[:3].astype(np.float64)
    exact = 0.299 * red + 0.587 * green + 0.114 * blue
    computed = luminosity(bands)
    assert computed.dtype == dtype
    assert np.abs(computed - exact).max() <= (1e-6 if dtype is np.float32 else 0.502)
    assert (luminosity(bands[:1]) == bands[0]).all()


def test_grey_pixels_keep_their_value() -> None:
    for dtype in (np.uint8, np.uint16):
        values = np.arange(np.iinfo(dtype).max + 1, dtype=dtype)
        assert (luminosity(np.stack([values] * 3)) == values).all()


@pytest.mark.release
@pytest.mark.parametrize(("name", "box"), REAL_WINDOWS)
def test_figures_of_real_images_are_numpys(data_folder: Path, name: str, box: tuple[int, int, int, int] | None) -> None:
    path = data_folder / name
    if not path.exists():
        pytest.skip(f"{name} is not there")
    source = OpenRaster(RasterRef(str(path)))
    window = source.raster.whole if box is None else PixelWindow(*box)
    dataset = gdal.Open(str(path))
    pixels = dataset.ReadAsArray(window.column, window.row, window.width, window.height)
    nodata = dataset.GetRasterBand(1).GetNoDataValue()
    valid = np.ones(pixels.shape[1:], bool) if nodata is None else ~(pixels == nodata).all(axis=0)
    result = checked(str(path), window)
    for check, expected in own_figures(mixed(pixels)[valid]).items():
        computed = checked_figure(result, check, "luminosity")
        assert computed.value == pytest.approx(expected, abs=1e-6, rel=1e-4), check  # ties are rounded up
        assert computed.passed is computed.rule.passes(float(expected))


@pytest.fixture
def naip(make_raster: MakeRaster) -> str:
    """Red, green and blue as they should be, and a lake that is black in infrared."""
    common = 128 + 34 * texture((512, 512), 2.0, 1)
    ground = np.stack([common + 5 * texture((512, 512), 1.0, seed) for seed in range(4)])
    ground[:, 300:380, :] = 120 + np.random.default_rng(0).normal(0, 4, (4, 80, 512))
    ground[3, :60, :] = np.random.default_rng(1).uniform(0, 4, (60, 512))  # 12 % of the sheet
    colours = (gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand, gdal.GCI_Undefined)
    return make_raster("m_naip.tif", np.rint(ground).clip(0, 255).astype(np.uint8), colours=colours)


def test_a_sheet_with_water_that_is_dark_in_infrared_passes(naip: str) -> None:
    result = checked(naip)
    assert result.image.band_names == ("red", "green", "blue", "nir")
    judged = {figure.rule.check: figure.passed for figure in result.checked_figures if figure.band == "luminosity"}
    assert judged == {"clipped_low": True, "clipped_high": True, "peak": True, "contrast": True}
    assert figure(result, "clipped_low", "luminosity") < 0.001
    assert not [figure for figure in result.checked_figures if figure.passed is False]


def test_the_stricter_rules_see_the_infrared(naip: str) -> None:
    strict = load_rules(ready_rule_files()["jrc_lpis_each_band"])
    result = checked(naip, rules=strict)
    assert figure(result, "clipped_low", "nir") == pytest.approx(60 / 512, rel=0.01)
    assert checked_figure(result, "clipped_low", "nir").passed is False
    assert checked_figure(result, "clipped_low", "green").passed is True


def test_a_rule_for_one_band_is_for_that_band(make_raster: MakeRaster) -> None:
    bands = orthoimage((200, 200), bands=3)
    rules = RuleSet("own", tuple(Rule("contrast", None, 1.0, "s", band=band) for band in ("red", "luminosity", "nir")))
    result = checked(make_raster("a.tif", bands), rules=rules)
    assert [figure.band for figure in result.checked_figures] == ["red", "luminosity", "nir"]
    assert figure(result, "contrast", "red") == pytest.approx(bands[0].std() / 255)
    assert figure(result, "contrast", "luminosity") == pytest.approx(mixed(bands).std() / 255, rel=1e-4)
    assert reasons(result) == {"contrast": "not measurable: it has no band nir."}


def test_two_bands_have_no_luminosity(make_raster: MakeRaster) -> None:
    said = reasons(checked(make_raster("two.tif", orthoimage((200, 200), bands=2))))
    assert said["contrast"].startswith("not measurable: it has no red, green and blue to mix; name one of its bands")


def test_every_figure_can_be_of_the_luminosity(make_raster: MakeRaster) -> None:
    """A channel with noise of its own weighs as much as it does in the mix."""
    noise = np.random.default_rng(0).normal(0, 10, (3, 256, 256))
    bands = np.rint(128 + noise).clip(0, 255).astype(np.uint8)
    rules = RuleSet("own", (Rule("signal_to_noise", 5, None, "s", band="luminosity"),))
    deviation = 10 * np.sqrt(0.299**2 + 0.587**2 + 0.114**2)
    ratio = figure(checked(make_raster("a.tif", bands), rules=rules), "signal_to_noise", "luminosity")
    assert ratio == pytest.approx(128 / deviation, rel=0.1)
