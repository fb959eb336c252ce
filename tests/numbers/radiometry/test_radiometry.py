"""Figures of radiometric acceptance against numpy, GDAL and images whose figures are known; JRC's are of luminosity."""
from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from osgeo import gdal
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.lines import Seam
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.radiometry.measure import image_statistics
from seam_inspector.plugin.radiometry.measure.image_statistics import Histogram, luminosity, stream_statistics
from seam_inspector.plugin.radiometry.measure.measured_image import measure
from seam_inspector.plugin.radiometry.measure.rules import Rule, RuleSet, load_rules, ready_rule_files

from tests.examples import at_most
from tests.numbers.radiometry.judging import checked, checked_figure, default_rules, figure, reasons
from tests.numbers.synthetic import ORIGIN, orthoimage, texture, write_raster

MakeRaster = Callable[..., str]


def streamed(path: str, given: tuple[float, float] | None = None) -> dict[str, Histogram]:
    source = OpenRaster(RasterRef(path))
    names = source.raster.band_names
    statistics = stream_statistics(source, source.raster.whole, names, names, given)
    return statistics[0]


def grey(level: float = 128, sigma: float = 8.0, side: int = 256, seed: int = 0) -> np.ndarray:
    noise = np.random.default_rng(seed).normal(level, sigma, (side, side))
    return np.rint(noise).clip(0, 255).astype(np.uint8)


@pytest.mark.parametrize("dtype", [np.uint8, np.uint16, np.int16])
@pytest.mark.parametrize("nodata", [None, 120])
def test_histograms_are_numpys(
    make_raster: MakeRaster, dtype: type, nodata: float | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(image_statistics.limits, "MAX_BLOCK_PIXELS", 5000)
    bands = orthoimage((211, 187), bands=2, dtype=dtype)
    if dtype is np.int16:
        bands -= 1500
    bands[:, 20:60, 30:80] = 120
    histograms = streamed(make_raster("a.tif", bands, nodata=nodata))
    valid = np.ones(bands.shape[1:], bool) if nodata is None else ~(bands == nodata).all(axis=0)
    for band, histogram in zip(bands, histograms.values()):
        values, counts = np.unique(band[valid], return_counts=True)
        seen = histogram.counts > 0
        assert histogram.values[seen].tolist() == values.tolist()
        assert histogram.counts[seen].tolist() == counts.tolist()
        assert histogram.mean == pytest.approx(band[valid].mean())
        assert histogram.deviation == pytest.approx(band[valid].std())
        assert histogram.largest == band[valid].max()


@at_most(30)
@given(low=st.floats(-1e4, 0), extent=st.floats(0.1, 1e4), seed=st.integers(0, 99))
def test_values_without_steps_are_counted_over_the_given_range(
    low: float, extent: float, seed: int, tmp_path_factory: pytest.TempPathFactory
) -> None:
    band = np.random.default_rng(seed).uniform(low, low + extent, (64, 64))
    band[0, :5] = np.nan
    path = write_raster(tmp_path_factory.mktemp("float") / "a.tif", band)
    histogram = streamed(path, (low, low + extent))["band_1"]
    assert histogram.pixels == 64 * 64 - 5
    assert histogram.mean == pytest.approx(np.nanmean(band), abs=extent / 65536)
    assert histogram.deviation == pytest.approx(np.nanstd(band), abs=extent / 65536)


def test_tails_peak_and_contrast_of_a_known_histogram(make_raster: MakeRaster) -> None:
    values = np.full(100 * 100, 150, np.uint8)
    values[:30], values[30:50], values[50:60] = 4, 5, 251
    values[60:2060] = 100
    result = checked(make_raster("a.tif", values.reshape(100, 100)))
    assert figure(result, "clipped_low") == pytest.approx(0.003)  # values 0 to 4
    assert figure(result, "clipped_high") == pytest.approx(0.001)  # values 251 to 255
    assert figure(result, "peak") == pytest.approx((150 - 127.5) / 255)
    assert figure(result, "contrast") == pytest.approx(values.std() / 255)
    judged = [checked_figure(result, check).passed for check in ("clipped_low", "peak", "contrast")]
    assert judged == [True, True, False]


@pytest.mark.parametrize(("level", "sigma"), [(128, 4.0), (100, 10.0), (150, 25.0), (128, 40.0)])
def test_signal_to_noise_recovers_what_is_there(make_raster: MakeRaster, level: float, sigma: float) -> None:
    ratio = figure(checked(make_raster("a.tif", grey(level, sigma))), "signal_to_noise")
    assert ratio == pytest.approx(level / sigma, rel=0.03)  # though the quietest quarter of equal areas is taken


def test_noise_is_taken_where_it_is_uniform_and_of_mid_tone(make_raster: MakeRaster) -> None:
    random = np.random.default_rng(1)
    scene = 128 + 30 * texture((512, 512), 3.0, 2)  # without a uniform area of its own
    scene[100:180, 100:180] = 120
    scene[300:380, 300:380] = 40  # too dark
    noisy = np.rint(scene + random.normal(0, np.where(scene == 40, 1.0, 6.0))).clip(0, 255).astype(np.uint8)
    result = checked(make_raster("a.tif", noisy))
    assert figure(result, "signal_to_noise") == pytest.approx(120 / 6, rel=0.15)


def test_without_uniform_or_grey_areas_it_says_so(make_raster: MakeRaster) -> None:
    bands = np.stack([np.rint(128 + 30 * texture((256, 256), 3.0, seed)) for seed in range(3)])
    said = reasons(checked(make_raster("a.tif", bands.clip(0, 255).astype(np.uint8))))
    assert set(said) == {"signal_to_noise", "colour_balance"}
    assert said["signal_to_noise"].startswith("not measurable: fewer than 8 uniform mid-tone areas")
    assert said["colour_balance"].startswith("not measurable: no grey areas are given, and none that may be grey were")


def test_a_flat_image_has_no_infinite_signal_to_noise(make_raster: MakeRaster) -> None:
    said = reasons(checked(make_raster("a.tif", np.full((100, 100), 128, np.uint8))))
    assert said["signal_to_noise"].startswith("not measurable: the uniform areas do not vary at all")
    assert said["colour_balance"] == "not measurable: it has no red, green and blue."


def test_too_few_valid_pixels(make_raster: MakeRaster) -> None:
    pixels = np.zeros((200, 200), np.uint8)
    pixels[:40, :40] = 90
    result = checked(make_raster("a.tif", pixels, nodata=0))
    assert len(reasons(result)) == len(result.checked_figures) == 6
    assert set(reasons(result).values()) == {
        "not measurable: 1600 pixels are valid and at least 4096 are needed; choose a larger part."
    }
    pixels[:64, :64] = 90
    assert figure(checked(make_raster("enough.tif", pixels, nodata=0)), "contrast") == 0


def test_float_values_need_a_range_from_the_rules(make_raster: MakeRaster) -> None:
    band = np.random.default_rng(0).normal(0.5, 0.05, (128, 128)).astype(np.float32)
    path = make_raster("a.tif", band)
    said = reasons(checked(path))
    assert len(said) == 6
    assert "values of type float32 have no fixed range; give the range of values" in said["contrast"]
    result = checked(path, rules=RuleSet("own", default_rules().rules, (0.0, 1.0)))
    assert figure(result, "contrast") == pytest.approx(band.std(), rel=1e-4)
    assert figure(result, "signal_to_noise") == pytest.approx(10, rel=0.1)


def test_it_stops_when_told_to(make_raster: MakeRaster) -> None:
    source = OpenRaster(RasterRef(make_raster("a.tif", grey(side=1500))))
    shares: list[float] = []
    stop = lambda share: bool(shares.append(share))  # noqa: E731
    assert measure(source, source.raster.whole, default_rules(), progress=stop) is None
    assert len(shares) == 1
    assert 0 < shares[0] < 1


def seam(*places: tuple[float, float], number: int = 1) -> Seam:
    """Through columns and rows of a raster of 0.1 m pixels."""
    return Seam(number, np.array([(ORIGIN[0] + 0.1 * column, ORIGIN[1] - 0.1 * row) for column, row in places]))


@pytest.mark.parametrize("step", [-20, 0, 7, 30])
@pytest.mark.parametrize("slant", [0, 40])
def test_the_step_at_a_seam_is_what_was_put_there(make_raster: MakeRaster, step: int, slant: int) -> None:
    rows, columns = np.mgrid[:300, :300]
    right = columns + 0.5 > 150 + slant * (rows + 0.5) / 300
    pixels = np.rint(120 + np.random.default_rng(0).normal(0, 6, (300, 300)) + step * right).astype(np.uint8)
    pixels[0, 0] = 200  # the largest value
    result = checked(make_raster("a.tif", pixels), seams=[seam((150, 0), (150 + slant, 300))])
    assert figure(result, "seam_step") == pytest.approx(abs(step) / 200, abs=0.004)
    assert checked_figure(result, "seam_step").passed is None  # the order sets no limit
    assert result.seams[0].stations == 18
    assert figure(result, "seam_contrast") == pytest.approx(6 / 255, rel=0.05)


def test_a_feather_of_two_pixels_and_an_object_on_the_seam_do_not_hide_it(make_raster: MakeRaster) -> None:
    columns = np.broadcast_to(np.arange(300) + 0.5, (300, 300))
    pixels = 100 + 30 * np.clip((columns - 148) / 4, 0, 1)
    pixels = np.rint(pixels)
    pixels[100:160, 150:180] = 250  # a roof that ends at the seam
    result = checked(make_raster("a.tif", pixels.astype(np.uint8)), seams=[seam((150, 0), (150, 300))])
    assert figure(result, "seam_step") == pytest.approx(30 / 250, abs=0.004)


def test_the_worst_seam_is_named_with_its_place(make_raster: MakeRaster) -> None:
    pixels = np.full((3, 300, 600), 100, np.uint8)
    pixels[:, :, 150:] = 110
    pixels[:, :, 300:] = np.array([150, 111, 111])[:, np.newaxis, np.newaxis]
    pixels[2, :, 450:] = 60
    seams = [seam((x, 0), (x, 300), number=i) for i, x in enumerate((150, 300, 450), 1)]
    result = checked(make_raster("a.tif", pixels), seams=seams)
    for band, number, column in (("red", 2, 300), ("green", 1, 150), ("blue", 3, 450)):
        spot = checked_figure(result, "seam_step", band).spot
        assert str(spot.what) == f"seam {number}"
        assert spot.place[0] == pytest.approx(ORIGIN[0] + 0.1 * column, abs=0.01)
        assert ORIGIN[1] - 30 < spot.place[1] < ORIGIN[1]


def test_no_seam_on_the_raster(make_raster: MakeRaster) -> None:
    path = make_raster("a.tif", grey())
    for seams in ([], [seam((900, 0), (900, 300))], [seam((10, 10), (50, 10))]):
        said = reasons(checked(path, seams=seams))
        assert said["seam_step"] == "not measurable: no seam runs across valid pixels of it for 64 px or more."
    assert "seam_step" not in {figure.rule.check for figure in checked(path).checked_figures}


def test_seams_on_a_rotated_raster_are_refused(make_raster: MakeRaster) -> None:
    path = make_raster("r.tif", grey(), geotransform=(0, 0.1, 0.02, 0, 0.02, -0.1))
    assert figure(checked(path), "contrast") > 0
    with pytest.raises(RasterError, match="rotated"):
        checked(path, seams=[seam((0, 0), (0, 300))])


def test_memory_stays_flat(tmp_path: Path) -> None:
    """Both hold the same few blocks and areas, though one has 36 times as many pixels."""
    import tracemalloc

    peaks = []
    for side in (1024, 6144):
        path = write_raster(tmp_path / f"{side}.tif", np.tile(grey(side=512), (side // 512, side // 512)))
        source = OpenRaster(RasterRef(path))
        tracemalloc.start()
        stream_statistics(source, source.raster.whole, ("luminosity",), ("band_1",))
        peaks.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    assert peaks[1] < 1.5 * peaks[0]


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
