"""Windows without a mosaic: on whose pixels they lie, what is foretold of them, and why of some nothing is."""
from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal, ogr
from scipy import ndimage
from seam_inspector.plugin.imagery.clips import read_clip
from seam_inspector.plugin.imagery.errors import Message, SettingsError
from seam_inspector.plugin.imagery.grids import Extent, PixelWindow
from seam_inspector.plugin.imagery.open_raster import OpenRaster, describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.planning.loss_forecast import (
    Forecast,
    ForecastRequest,
    ForecastSettings,
    forecast_window,
)
from seam_inspector.plugin.seams.measure.source_images import Source, covers, gather_sources
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window, make_block, window_request
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings

from tests.numbers.synthetic import ORIGIN, UTM33, decompose, luminance, orthoimage, texture, wkt

MakeRaster = Callable[..., str]
SIZE = (320, 256)
def box(column: float, row: float, width: float = 128, height: float = 128) -> Extent:
    """A rectangle of pixels of 0.1 m."""
    left, top = ORIGIN[0] + 0.1 * column, ORIGIN[1] - 0.1 * row
    return left, top - 0.1 * height, left + 0.1 * width, top


def forecast(
    *paths: str, extent: Extent | None = None, system: int = UTM33, seamlines: tuple[bytes, ...] | None = None,
    **changed: Any,
) -> Forecast:
    sources, _ = gather_sources([RasterRef(path) for path in paths], [], wkt(system))
    return foretold(sources, extent or box(64, 64), ForecastSettings(**changed), wkt(system), seamlines)


def foretold(
    sources: Sequence[Source], extent: Extent, settings: ForecastSettings, system: str,
    seamlines: tuple[bytes, ...] | None = None,
) -> Forecast:
    covering = tuple(source for source in sources if covers(source.extent, extent))
    return forecast_window(ForecastRequest(7, covering, extent, system, settings, seamlines))


def images(count: int = 2, shape: tuple[int, int] = SIZE) -> list[np.ndarray]:
    """Orthoimages of one scene, each with its noise."""
    scene = orthoimage(shape).astype(float)
    noise = [np.random.default_rng(i).normal(0, 6, scene.shape) for i in range(count)]
    return [(scene + plane).clip(1, 254).astype(np.uint8) for plane in noise]


def assert_nothing_foretold(result: Forecast, reason: str) -> None:
    assert reason in str(result.reason)
    assert result.pairs == ()
    assert result.expected is None


def templates(notices: tuple[Message, ...]) -> list[str]:
    return [str(notice) for notice in notices]


def test_a_blended_mosaic_keeps_what_was_foretold(make_raster: MakeRaster) -> None:
    a, b = (image.astype(np.float32) for image in images())
    paths = [make_raster(name, image) for name, image in (("a.tif", a), ("b.tif", b))]
    result = forecast(*paths)
    mosaic = describe_mosaic(RasterRef(make_raster("mosaic.tif", (a + b) / 2)))
    block, _ = make_block(mosaic, [RasterRef(path) for path in paths])
    seen = inspect_window(window_request(block, 1, box(64, 64), InspectionSettings()))
    contrast = [pair.change.contrast for pair in seen.pairs if pair.band == "luminance" and pair.change]
    (pair,) = result.pairs
    for level, ratio in enumerate(pair.feather.ratios):
        of_a, of_b = (float(row[level] or math.nan) ** 2 for row in contrast)  # the mosaic's energy over each source's
        assert 2 / (1 / of_a + 1 / of_b) == pytest.approx(ratio, rel=1e-3)
    assert result.expected == pair.feather.ratios
    assert seen.explanation.expected == pytest.approx(result.expected)


def test_a_pixel_grid_that_lies_beside_is_no_shift_on_the_ground(make_raster: MakeRaster) -> None:
    """One ground, sampled 0.3 px further right and 0.4 px further up: no pixel lies elsewhere."""
    scene = 120 + 30 * texture(SIZE, 2.4)
    moved = np.fft.ifft2(ndimage.fourier_shift(np.fft.fft2(scene), (0.4, -0.3))).real
    paths = [
        make_raster("a.tif", scene.astype(np.float32)),
        make_raster("b.tif", moved.astype(np.float32), origin=(ORIGIN[0] + 0.03, ORIGIN[1] + 0.04)),
    ]
    for order in (paths, paths[::-1]):
        (pair,) = forecast(*order).pairs
        assert (pair.shift.x, pair.shift.y) == pytest.approx((0, 0), abs=0.05)
        assert not pair.resampled


@pytest.mark.release
def test_real_orthoimages_blended_half_and_half(make_raster: MakeRaster, data_folder: Path) -> None:
    folder = data_folder / "seams" / "brighton"
    paths = [str(folder / f"DJI_{number}_ortho.tif") for number in ("0025", "0034")]
    mosaic = describe_mosaic(RasterRef(str(folder / "mosaic_hardseam.tif")))
    windows = [
        PixelWindow(column, row, 256, 256)
        for row in range(0, mosaic.grid.rows - 256, 256)
        for column in range(0, mosaic.grid.columns - 256, 256)
    ]
    sources, _ = gather_sources([RasterRef(path) for path in paths], [], mosaic.wkt)
    forecasts = []
    for window in windows:
        extent = mosaic.grid.window_extent(window)
        result = foretold(sources, extent, ForecastSettings(), mosaic.wkt)
        if result.reason is not None:
            continue
        assert result.extent == pytest.approx(extent)
        clips = [read_clip(OpenRaster(RasterRef(path)), mosaic, window).bands for path in paths]
        planes = [luminance(bands) for bands in clips]
        both, *energies = (
            np.array([np.sum(part**2) for part in decompose(plane).details]) for plane in (sum(planes) / 2, *planes)
        )
        np.testing.assert_allclose(result.expected, both / np.mean(energies, axis=0), rtol=1e-4)
        forecasts.append(result)
    assert len(forecasts) >= 10
    first = np.array([result.expected[0] for result in forecasts], float)
    assert 0.5 < np.median(first) < 0.65  # half of the finest detail would go: noise of two photos, 0.9 px apart
    lengths = [result.pairs[0].shift.length for result in forecasts if result.pairs[0].shift is not None]
    assert 0.4 < np.median(lengths) < 1.8  # as measured on these images by others


def test_a_mosaic_feathered_at_that_width_keeps_what_was_foretold(make_raster: MakeRaster) -> None:
    a, b = (image.astype(np.float32) for image in images(shape=(256, 256)))
    weight = np.clip((np.arange(256) + 0.5 - 128) / 20 + 0.5, 0, 1).astype(np.float32)  # 20 px of 0.1 m
    left, top = ORIGIN
    line = ogr.CreateGeometryFromWkt(f"LINESTRING ({left + 12.8} {top}, {left + 12.8} {top - 30})")
    paths = [make_raster(name, image) for name, image in (("a.tif", a), ("b.tif", b))]
    seams = (bytes(line.ExportToWkb()),)
    result = forecast(*paths, extent=box(64, 64), seamlines=seams, width_m=2.0, ramp="linear")
    cut = np.where(weight > 0.5, b, a)
    window = np.s_[:, 64:192, 64:192]
    blended, hard = (
        np.array([np.sum(part**2) for part in decompose(luminance(image[window])).details])
        for image in (weight * b + (1 - weight) * a, cut)
    )
    assert result.kept == result.pairs[0].kept
    assert result.kept.window == pytest.approx(blended / hard, abs=0.02)
    assert all(strip < whole for strip, whole in zip(result.kept.strip, result.kept.window) if strip and whole)
    assert result.notices == ()


def test_a_seam_that_had_to_be_assumed_is_told(make_raster: MakeRaster) -> None:
    paths = [make_raster(f"{number}.tif", image) for number, image in enumerate(images())]
    unknown = forecast(*paths, width_m=2.0)
    beside = forecast(*paths, width_m=2.0, seamlines=())
    assert unknown.notices == ()
    assert templates(beside.notices) == [
        "Where no seamline divides a window in two, the seam is assumed to run through its middle."
    ]
    assert beside.kept == unknown.kept


@pytest.mark.parametrize("changed", [{"width_m": -1.0}, {"width_m": math.nan}, {"ramp": "steep"}, {"wavelet": "x"}])
def test_settings_out_of_range_are_refused(changed: dict[str, Any]) -> None:
    with pytest.raises(SettingsError):
        ForecastSettings(**changed).check()


def test_the_finest_source_gives_the_pixels_whatever_the_order(make_raster: MakeRaster) -> None:
    a, _ = images()
    fine = make_raster("fine.tif", np.kron(a, np.ones((1, 2, 2), np.uint8)), gsd=0.05)
    coarse = make_raster("coarse.tif", a)
    for order in ((fine, coarse), (coarse, fine)):
        result = forecast(*order, extent=box(64.5, 64.5))  # whole pixels of the finer one only
        assert result.extent == pytest.approx(box(64.5, 64.5))
        assert [pair.resampled for pair in result.pairs] == [True]


def test_a_source_with_a_hole_gives_its_place_to_the_next(make_raster: MakeRaster) -> None:
    first, second, third = images(3)
    first[:, 100:110, 100:110] = 0
    paths = [make_raster(f"{i}.tif", pixels, nodata=0) for i, pixels in enumerate((first, second, third))]
    result = forecast(*paths)
    assert [(pair.source, pair.other) for pair in result.pairs] == [("1.tif", "2.tif")]
    assert result.notices == ()  # it merely does not cover the window
    assert_nothing_foretold(forecast(*paths[:2]), "Only one source covers the window, so nothing will be feathered")


def test_sources_in_another_reference_system(make_raster: MakeRaster, tmp_path: Path) -> None:
    a, b = images(shape=(600, 600))
    plain = make_raster("plain.tif", a, nodata=0)
    other = str(tmp_path / "other.tif")
    gdal.Warp(other, make_raster("b.tif", b, nodata=0), dstSRS="EPSG:32634", dstNodata=0, resampleAlg="cubic")
    result = forecast(plain, other, extent=box(200, 200))
    assert [pair.resampled for pair in result.pairs] == [True]
    assert result.extent == pytest.approx(box(200, 200))
    shift = result.pairs[0].shift
    assert shift.length < 0.1
    degrees = describe(RasterRef(other)).extent  # windows and footprints in that system, measured on the first's pixels
    assert degrees[0] < result.extent[0]


def test_without_sources_or_with_one(make_raster: MakeRaster) -> None:
    path = make_raster("a.tif", images()[0])
    assert_nothing_foretold(forecast(path, extent=box(900, 0)), "No source covers the window; add the orthoimages")
    result = forecast(path)
    assert_nothing_foretold(result, "Only one source covers the window, so nothing will be feathered there.")
    assert result.sources == 1
    assert result.extent == pytest.approx(box(64, 64))


def test_bad_rasters_never_raise_and_are_named(make_raster: MakeRaster, tmp_path: Path) -> None:
    a, b = images()
    good = [make_raster(f"{i}.tif", image) for i, image in enumerate((a, b))]
    sources, _ = gather_sources([RasterRef(path) for path in good], [], wkt(UTM33))
    grey = make_raster("grey.tif", a[0])
    flat = make_raster("flat.tif", np.full_like(a, 9))
    cut = make_raster("cut.tif", a, options=())
    (tmp_path / "text.tif").write_text("no raster")
    bad = [grey, flat, cut, str(tmp_path / "text.tif"), "/nowhere/lost.tif"]
    added, _ = gather_sources([RasterRef(path) for path in (grey, flat, cut)], [], wkt(UTM33))
    (tmp_path / "cut.tif").write_bytes((tmp_path / "cut.tif").read_bytes()[:60_000])
    lost = [type(sources[0])(RasterRef(path), sources[0].extent) for path in bad[3:]]
    for order in ([*sources, *added, *lost], [*lost, *reversed(added), *sources], [*added, *lost, *sources]):
        result = foretold(order, box(64, 64), ForecastSettings(), wkt(UTM33))
        assert [(pair.source, pair.other) for pair in result.pairs][-1] == ("0.tif", "1.tif")
        assert result.reason is None
        said = " ".join(templates(result.notices))
        for words in ("grey.tif has no luminance", "flat.tif has no variance", "pixels of cut.tif can't be read",
                      "text.tif is not a raster", "lost.tif does not exist"):
            assert words in said
        assert len(result.notices) == 5
    alone = foretold([*lost, sources[0]], box(64, 64), ForecastSettings(), wkt(UTM33))
    assert_nothing_foretold(alone, "Only one source can be compared here: text.tif is not a raster")
    none = foretold(lost, box(64, 64), ForecastSettings(), wkt(UTM33))
    assert_nothing_foretold(none, "No source can be compared here: text.tif is not a raster")
