"""Figures of radiometric acceptance against numpy, GDAL and images whose figures are known."""
from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from seam_inspector.plugin.imagery.errors import RasterError
from seam_inspector.plugin.imagery.lines import Seam
from seam_inspector.plugin.imagery.open_raster import OpenRaster
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.radiometry.measure import image_statistics
from seam_inspector.plugin.radiometry.measure.image_statistics import Histogram, stream_statistics
from seam_inspector.plugin.radiometry.measure.measured_image import measure
from seam_inspector.plugin.radiometry.measure.rules import RuleSet

from tests.examples import at_most
from tests.numbers.radiometry.jrc import default_rules
from tests.numbers.radiometry.judging import checked, checked_figure, figure, reasons
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
