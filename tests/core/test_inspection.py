"""From a mosaic, its sources and a rectangle to the result of a window, and from many requests to many results."""
from __future__ import annotations

import pickle
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from osgeo import gdal
from scipy import ndimage
from seam_inspector.plugin.core import messages
from seam_inspector.plugin.core.contrast import Verdict
from seam_inspector.plugin.core.errors import SettingsError
from seam_inspector.plugin.core.inspection import (
    Block,
    Settings,
    Source,
    WindowRequest,
    WindowResult,
    inspect_window,
    inspect_windows,
    make_block,
    window_request,
)
from seam_inspector.plugin.core.messages import Message
from seam_inspector.plugin.core.rasters import Mosaic, RasterRef, describe_mosaic
from seam_inspector.plugin.core.windows import PixelWindow

from tests.core.synthetic import ORIGIN, decompose, luminance, orthoimage, texture, write_raster

MakeRaster = Callable[..., str]
SIZE = (256, 256)
WINDOW = PixelWindow(64, 96, 64, 128)
FAR_AWAY = (0.0, 0.0, 100.0, 100.0)


def inside(array: np.ndarray, window: PixelWindow = WINDOW) -> np.ndarray:
    return array[..., window.row : window.row + window.height, window.column : window.column + window.width]


def softened(image: np.ndarray, sigma: float) -> np.ndarray:
    return np.stack([ndimage.gaussian_filter(band, sigma, mode="wrap") for band in image])


def mosaic_of(make_raster: MakeRaster, image: np.ndarray, name: str = "mosaic.tif", **options: Any) -> Mosaic:
    return describe_mosaic(RasterRef(make_raster(name, image, **options)))


def block_of(mosaic: Mosaic, *paths: str) -> Block:
    block, notices = make_block(mosaic, [RasterRef(path) for path in paths])
    assert notices == []
    return block


def inspect(block: Block, window: PixelWindow = WINDOW, **settings: Any) -> WindowResult:
    extent = block.mosaic.grid.window_extent(window)
    return inspect_window(window_request(block, 7, extent, Settings(**settings)))


def templates(notices: Any) -> list[str]:
    return [notice.template for notice in notices]


# --- the block -------------------------------------------------------------------------------------------------


def test_the_mosaic_among_its_sources_is_dropped_with_a_notice(make_raster: MakeRaster, tmp_path: Path) -> None:
    image = orthoimage((64, 64))
    mosaic, source = mosaic_of(make_raster, image), make_raster("source.tif", image)
    (tmp_path / "folder").mkdir()
    otherwise = str(tmp_path / "folder" / ".." / "mosaic.tif")
    for named in (mosaic.ref.path, otherwise):
        block, notices = make_block(mosaic, [RasterRef(named), RasterRef(source)])
        assert [kept.ref.path for kept in block.sources] == [source]
        assert templates(notices) == [messages.MOSAIC_AMONG_SOURCES.template]
        assert str(notices[0]).startswith("mosaic.tif is the mosaic itself")
    indexed = [Source(RasterRef(otherwise), mosaic.extent), Source(RasterRef(source), mosaic.extent)]
    block, notices = make_block(mosaic, [], indexed)
    assert [kept.ref.path for kept in block.sources] == [source]
    assert templates(notices) == [messages.MOSAIC_AMONG_SOURCES.template]


def test_a_source_named_twice_takes_part_once(make_raster: MakeRaster, tmp_path: Path) -> None:
    image = orthoimage((64, 64))
    mosaic, source = mosaic_of(make_raster, image), make_raster("source.tif", image)
    (tmp_path / "link.tif").symlink_to(source)
    names = [source, str(tmp_path / "." / "source.tif"), str(tmp_path / "link.tif")]
    indexed = [Source(RasterRef(name), FAR_AWAY) for name in names]
    block, notices = make_block(mosaic, [RasterRef(name) for name in names], indexed)
    assert [kept.ref.path for kept in block.sources] == [source]
    assert block.sources[0].extent == pytest.approx(mosaic.extent)
    assert notices == []


def test_what_is_no_source_is_left_out_and_the_rest_stays(make_raster: MakeRaster, tmp_path: Path) -> None:
    image = orthoimage((64, 64))
    mosaic = mosaic_of(make_raster, image)
    (tmp_path / "notes.txt").write_text("not a raster")
    bare, good = make_raster("bare.tif", image, system=None), make_raster("good.tif", image)
    paths = [str(tmp_path / "gone.tif"), str(tmp_path / "notes.txt"), bare, good]
    block, notices = make_block(mosaic, [RasterRef(path) for path in paths])
    assert [kept.ref.name for kept in block.sources] == ["good.tif"]
    sentences = [str(notice) for notice in notices]
    assert "gone.tif is left out: " in sentences[0]
    assert "does not exist" in sentences[0]
    assert "notes.txt is left out: notes.txt is not a raster" in sentences[1]
    assert "bare.tif is left out: bare.tif has no coordinate reference system" in sentences[2]
    assert len(sentences) == 3


def test_without_any_source_there_is_no_job(make_raster: MakeRaster) -> None:
    mosaic = mosaic_of(make_raster, orthoimage((64, 64)))
    with pytest.raises(SettingsError, match=r"No sources are given; choose the orthoimages .* or their index layer\."):
        make_block(mosaic, [])
    block, notices = make_block(mosaic, [mosaic.ref])  # something was named, so the windows say what is missing
    assert block.sources == ()
    assert len(notices) == 1


def test_footprints_lie_in_the_mosaics_system(make_raster: MakeRaster) -> None:
    mosaic = mosaic_of(make_raster, orthoimage(SIZE))
    # 15 degrees east is 500 000 m in zone 33; the upper left corner lies at 45.1535 degrees north.
    degrees = (15.0, 1.27e-6, 0.0, 45.1535, 0.0, -9e-7)
    block = block_of(mosaic, make_raster("degrees.tif", orthoimage(SIZE), geotransform=degrees, system=4326))
    xmin, ymin, xmax, ymax = block.sources[0].extent
    assert xmin == pytest.approx(500000.0, abs=0.01)
    assert xmax - xmin == pytest.approx(25.6, rel=0.01)
    assert ymax - ymin == pytest.approx(25.6, rel=0.01)
    assert ymax == pytest.approx(5000000, abs=20)


# --- overlap ---------------------------------------------------------------------------------------------------


def test_a_source_outside_the_window_is_never_opened(make_raster: MakeRaster) -> None:
    image = orthoimage(SIZE)
    mosaic, source = mosaic_of(make_raster, image), make_raster("source.tif", image)
    indexed = [Source(RasterRef(f"/nowhere/{number}.tif"), FAR_AWAY) for number in range(500)]
    block, notices = make_block(mosaic, [RasterRef(source)], indexed)
    assert notices == []
    assert len(block.sources) == 501
    result = inspect(block)
    assert [clip.raster for clip in result.clips] == ["mosaic.tif", "source.tif"]
    assert result.notices == ()
    over = Source(RasterRef("/nowhere/over.tif"), mosaic.extent)
    result = inspect(make_block(mosaic, [RasterRef(source)], [over])[0])
    assert [str(notice) for notice in result.notices] == ["/nowhere/over.tif does not exist; check the path."]
    assert result.source_count == 1


@pytest.mark.parametrize("side", range(4), ids=["left", "bottom", "right", "top"])
@pytest.mark.parametrize(
    ("metres", "taken"), [(5.0, True), (0.0, True), (-0.1, True), (-0.25, False), (-3.0, False), (-50.0, False)]
)
def test_a_footprint_must_cover_the_window_but_for_a_pixel(side: int, metres: float, taken: bool) -> None:
    """``metres`` is how far the source reaches beyond that side of the window; a pixel is 0.1 m."""
    mosaic = a_mosaic()
    extent = list(mosaic.grid.window_extent(WINDOW))
    extent[side] += metres if side >= 2 else -metres
    source = Source(RasterRef("/nowhere.tif"), tuple(extent))  # type: ignore[arg-type]
    assert (source in Block(mosaic, (source,)).sources_over(WINDOW)) is taken


def a_mosaic() -> Mosaic:
    """One that is nowhere on disk."""
    path = "/vsimem/seam_inspector_mosaic.tif"
    if gdal.VSIStatL(path) is None:
        write_raster(Path(path), orthoimage(SIZE))
    return describe_mosaic(RasterRef(path))


# --- one window ------------------------------------------------------------------------------------------------


def test_the_result_of_a_window(make_raster: MakeRaster) -> None:
    scene = orthoimage(SIZE, 3, seed=1)
    images = {
        "mosaic.tif": softened(scene, 0.6),
        "a.tif": scene,
        "b.tif": np.round(softened(scene, 0.3) * 0.8 + 20 + np.roll(orthoimage(SIZE, 3, seed=5), 3, 1) * 0.1).astype(
            np.uint8
        ),
    }
    mosaic = mosaic_of(make_raster, images["mosaic.tif"])
    shifted = make_raster("b.tif", images["b.tif"], origin=(ORIGIN[0] + 0.02, ORIGIN[1] + 0.04))
    result = inspect(block_of(mosaic, make_raster("a.tif", images["a.tif"]), shifted))

    assert (result.window_id, result.window, result.source_count, result.notices) == (7, WINDOW, 2, ())
    assert [(clip.raster, clip.role) for clip in result.clips] == [
        ("mosaic.tif", "mosaic"),
        ("a.tif", "source"),
        ("b.tif", "source"),
    ]
    expected = {}
    for clip in result.clips:
        assert list(clip.curves) == ["luminance", "red", "green", "blue"]
        pixels = inside(images[clip.raster])
        for (band, curve), values in zip(clip.curves.items(), [luminance(pixels), *pixels]):
            expected[clip.raster, band] = decompose(values)
            shares = np.array([*curve.detail, curve.background])
            np.testing.assert_allclose(shares, expected[clip.raster, band].shares, rtol=1e-4, atol=1e-7)
            assert curve.variance == pytest.approx(values.var(), rel=1e-6)

    assert [(pair.source, pair.band) for pair in result.pairs] == [
        (source, band) for source in ("a.tif", "b.tif") for band in ("luminance", "red", "green", "blue")
    ]
    for pair in result.pairs:
        own, other = expected["mosaic.tif", pair.band], expected[pair.source, pair.band]
        ratios = own.shares / other.shares
        assert (*pair.ratios.detail, pair.ratios.background) == pytest.approx(tuple(ratios), rel=1e-4)
        similarity = np.corrcoef(own.coarse.ravel(), other.coarse.ravel())[0, 1]
        assert pair.similarity == pytest.approx(similarity, abs=1e-6)
        offset = (-0.2, 0.4) if pair.source == "b.tif" else (0, 0)
        assert (pair.offset_x, pair.offset_y) == pytest.approx(offset, abs=1e-5)
        assert not pair.resampled
    assert 0.5 < result.pairs[4].similarity < 0.9999

    of_sources = [expected[name, "luminance"].shares for name in ("a.tif", "b.tif")]
    largest = np.max([expected["mosaic.tif", "luminance"].shares / shares for shares in of_sources], axis=0)
    ratios = result.judgement.ratios
    assert (*ratios.detail, ratios.background) == pytest.approx(tuple(largest), rel=1e-4)
    assert result.judgement.reason is None


@pytest.mark.parametrize(
    ("sigma", "verdict"), [(0.0, Verdict.PRESERVED), (0.3, Verdict.REDUCED), (1.0, Verdict.SIGNIFICANT)]
)
def test_the_softer_the_mosaic_the_worse_the_verdict(make_raster: MakeRaster, sigma: float, verdict: Verdict) -> None:
    scene = orthoimage(SIZE, 3)
    mosaic = mosaic_of(make_raster, softened(scene, sigma) if sigma else scene)
    result = inspect(block_of(mosaic, make_raster("source.tif", scene)))
    assert result.judgement.verdict is verdict
    assert result.judgement.reason is None


def test_the_largest_loss_of_one_source_is_not_a_loss_against_every_source(make_raster: MakeRaster) -> None:
    scene = orthoimage(SIZE, 3)
    mosaic = mosaic_of(make_raster, softened(scene, 1.0))
    sharp, soft = make_raster("sharp.tif", scene), make_raster("soft.tif", softened(scene, 1.0))
    assert inspect(block_of(mosaic, sharp)).judgement.verdict is Verdict.SIGNIFICANT
    assert inspect(block_of(mosaic, sharp, soft)).judgement.verdict is Verdict.PRESERVED


def test_the_settings_are_those_of_the_request(make_raster: MakeRaster) -> None:
    scene = orthoimage(SIZE, 1)
    mosaic = mosaic_of(make_raster, softened(scene, 0.3))
    block = block_of(mosaic, make_raster("source.tif", scene))
    result = inspect(block, wavelet="db4", levels=5)
    shares = decompose(inside(softened(scene, 0.3))[0], "db4", 5).shares
    curve = result.clips[0].curves["band_1"]
    np.testing.assert_allclose([*curve.detail, curve.background], shares, rtol=1e-4)
    ratio = result.judgement.ratios.detail[0]
    assert 0.5 < ratio < 0.99
    assert inspect(block, wavelet="db4", levels=5, max_ratio=0.99).judgement.verdict is Verdict.SIGNIFICANT


def test_settings_out_of_range_are_refused() -> None:
    Settings().check()
    for wrong in ({"wavelet": "bior2.2"}, {"levels": 0}, {"levels": 9}, {"max_ratio": 1.0}):
        with pytest.raises(SettingsError):
            Settings(**wrong).check()  # type: ignore[arg-type]


def test_a_drawn_rectangle_is_snapped(make_raster: MakeRaster) -> None:
    block = block_of(mosaic_of(make_raster, orthoimage(SIZE)), make_raster("a.tif", orthoimage(SIZE)))
    xmin, ymin, xmax, ymax = block.mosaic.grid.window_extent(WINDOW)
    request = window_request(block, 3, (xmin - 0.03, ymin - 0.12, xmax + 0.04, ymax + 0.31), Settings())
    assert request.window == PixelWindow(64, 95, 64, 128)
    assert inspect_window(request).window == request.window


# --- bands that fit and bands that don't -----------------------------------------------------------------------


def test_one_band(make_raster: MakeRaster) -> None:
    scene = orthoimage(SIZE, 1, dtype=np.uint16)
    result = inspect(block_of(mosaic_of(make_raster, softened(scene, 1)), make_raster("a.tif", scene)))
    assert [list(clip.curves) for clip in result.clips] == [["band_1"], ["band_1"]]
    assert result.judgement.verdict is Verdict.SIGNIFICANT


def test_near_infrared_is_compared_where_both_have_it(make_raster: MakeRaster) -> None:
    rgb, nir = [gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand], [gdal.GCI_Undefined]
    scene = orthoimage(SIZE, 4)
    mosaic = mosaic_of(make_raster, scene, colours=rgb + nir)
    four = make_raster("four.tif", scene, colours=rgb + nir)
    three = make_raster("three.tif", scene[:3], colours=rgb)
    result = inspect(block_of(mosaic, four, three))
    assert list(result.clips[0].curves) == ["luminance", "red", "green", "blue", "nir"]
    assert list(result.clips[2].curves) == ["luminance", "red", "green", "blue"]
    assert [pair.source for pair in result.pairs if pair.band == "nir"] == ["four.tif"]
    assert result.notices == ()
    fewer = inspect(block_of(describe_mosaic(RasterRef(three)), four))
    assert list(fewer.clips[1].curves) == ["luminance", "red", "green", "blue", "nir"]
    assert "nir" not in [pair.band for pair in fewer.pairs]


def test_infrared_is_no_part_of_the_luminance(make_raster: MakeRaster) -> None:
    scene = orthoimage(SIZE, 4)
    four = [gdal.GCI_RedBand, gdal.GCI_GreenBand, gdal.GCI_BlueBand, gdal.GCI_Undefined]
    mosaic = mosaic_of(make_raster, np.concatenate([scene[:3], 255 - scene[3:]]), colours=four)
    result = inspect(block_of(mosaic, make_raster("a.tif", scene, colours=four)))
    assert result.judgement.ratios.detail == (1.0, 1.0, 1.0)


def test_a_source_of_one_band_takes_no_part_in_a_coloured_mosaic(make_raster: MakeRaster) -> None:
    scene = orthoimage(SIZE, 3)
    mosaic, colour = mosaic_of(make_raster, scene), make_raster("colour.tif", scene)
    grey = make_raster("grey.tif", scene[0])
    result = inspect(block_of(mosaic, grey, colour))
    assert [clip.raster for clip in result.clips] == ["mosaic.tif", "colour.tif"]
    assert [str(notice) for notice in result.notices] == [
        "grey.tif has no luminance (its bands: band_1); choose sources with the mosaic's bands."
    ]
    assert result.judgement.verdict is Verdict.PRESERVED
    alone = inspect(block_of(mosaic, grey))
    assert alone.judgement.verdict is Verdict.NOT_COMPARABLE
    assert "grey.tif has no luminance" in str(alone.judgement.reason)
    other_way = inspect(block_of(describe_mosaic(RasterRef(grey)), colour))
    assert "colour.tif has no band_1 (its bands: red, green, blue)" in str(other_way.judgement.reason)


def test_a_source_of_another_bit_depth_is_compared(make_raster: MakeRaster) -> None:
    scene = orthoimage(SIZE, 3)
    mosaic = mosaic_of(make_raster, scene)
    deep = make_raster("deep.tif", scene.astype(np.uint16) * 257)
    real = make_raster("real.tif", (scene / 255).astype(np.float32))
    ratios = [pair.ratios.detail for pair in inspect(block_of(mosaic, deep, real)).pairs]
    assert len(ratios) == 8
    for ratio in ratios:
        assert ratio == pytest.approx((1, 1, 1), rel=1e-4)


def test_a_source_of_another_pixel_size_is_marked(make_raster: MakeRaster) -> None:
    scene = orthoimage(SIZE, 3)
    fine = np.kron(scene, np.ones((1, 2, 2), np.uint8))
    block = block_of(mosaic_of(make_raster, scene), make_raster("fine.tif", fine, gsd=0.05))
    result = inspect(block)
    assert all(pair.resampled for pair in result.pairs)
    assert result.judgement.ratios.detail == pytest.approx((1, 1, 1), rel=1e-4)


# --- windows that can't be compared ----------------------------------------------------------------------------


def assert_not_comparable(result: WindowResult, reason: str) -> None:
    assert result.judgement.verdict is Verdict.NOT_COMPARABLE
    assert reason in str(result.judgement.reason)
    assert set(result.judgement.ratios.detail) == {None}


def test_a_rectangle_that_is_no_window_gives_its_reason(make_raster: MakeRaster) -> None:
    block = block_of(mosaic_of(make_raster, orthoimage(SIZE)), make_raster("a.tif", orthoimage(SIZE)))
    request = window_request(block, 3, FAR_AWAY, Settings())
    result = inspect_window(request)
    assert_not_comparable(result, "The window lies outside the mosaic; draw it on the mosaic.")
    assert (result.window_id, result.window, result.clips, result.pairs) == (3, None, (), ())
    assert_not_comparable(inspect(block, PixelWindow(10, 10, 40, 100)), "covers 40 x 100 px of the mosaic")


def test_a_window_without_sources_has_the_mosaics_curve_all_the_same(make_raster: MakeRaster) -> None:
    mosaic = mosaic_of(make_raster, orthoimage(SIZE))
    beside = make_raster("beside.tif", orthoimage(SIZE), origin=(ORIGIN[0] + 20.0, ORIGIN[1]))
    result = inspect(block_of(mosaic, beside))
    assert_not_comparable(result, "No source covers the window; add the orthoimages that overlap it")
    assert [clip.role for clip in result.clips] == ["mosaic"]


def test_gaps_of_the_mosaic(make_raster: MakeRaster) -> None:
    image = orthoimage(SIZE)
    image[:, :120] = 0
    block = block_of(mosaic_of(make_raster, image, nodata=0), make_raster("a.tif", orthoimage(SIZE)))
    assert_not_comparable(inspect(block), "18.75% of the pixels of mosaic.tif are invalid in the window")


def test_gaps_of_the_sources_are_a_reason_only_where_no_source_is_left(make_raster: MakeRaster) -> None:
    scene, gap = orthoimage(SIZE), orthoimage(SIZE)
    gap[:, 100:200] = 0
    mosaic, good = mosaic_of(make_raster, scene), make_raster("good.tif", scene)
    holed = make_raster("holed.tif", gap, nodata=0)
    assert_not_comparable(inspect(block_of(mosaic, holed)), "of the pixels of holed.tif are invalid")
    result = inspect(block_of(mosaic, holed, good))
    assert result.judgement.verdict is Verdict.PRESERVED
    assert result.notices == ()  # that a source has an edge is nothing to report


def test_a_damaged_source_is_named_and_the_others_count(make_raster: MakeRaster) -> None:
    scene = orthoimage(SIZE)
    mosaic, good = mosaic_of(make_raster, scene), make_raster("good.tif", scene)
    cut = Path(make_raster("cut.tif", scene))
    block = block_of(mosaic, str(cut), good)
    cut.write_bytes(cut.read_bytes()[: cut.stat().st_size // 10])
    result = inspect(block)
    assert result.judgement.verdict is Verdict.PRESERVED
    assert ["cut.tif" in str(notice) for notice in result.notices] == [True]
    cut.unlink()
    assert "does not exist" in str(inspect(block).notices[0])


def test_a_mosaic_that_went_away(make_raster: MakeRaster) -> None:
    block = block_of(mosaic_of(make_raster, orthoimage(SIZE)), make_raster("a.tif", orthoimage(SIZE)))
    Path(block.mosaic.ref.path).unlink()
    assert_not_comparable(inspect(block), "mosaic.tif does not exist")


def test_constant_images(make_raster: MakeRaster) -> None:
    scene, flat = orthoimage(SIZE), np.full((3, *SIZE), 80, np.uint8)
    source, constant = make_raster("source.tif", scene), make_raster("flat.tif", flat)
    uniform = mosaic_of(make_raster, flat, "uniform.tif")
    assert_not_comparable(inspect(block_of(uniform, source)), "The mosaic has no variance in the window")
    mosaic = mosaic_of(make_raster, scene)
    assert_not_comparable(inspect(block_of(mosaic, constant)), "flat.tif has no variance in the window")
    result = inspect(block_of(mosaic, constant, source))
    assert result.judgement.verdict is Verdict.PRESERVED
    assert [str(notice).split(" ")[0] for notice in result.notices] == ["flat.tif"]


def test_a_source_without_the_finest_detail(make_raster: MakeRaster) -> None:
    blocks = np.kron(orthoimage((128, 128), 1), np.ones((1, 2, 2), np.uint8))
    mosaic = mosaic_of(make_raster, orthoimage(SIZE, 1))
    result = inspect(block_of(mosaic, make_raster("enlarged.tif", blocks)), wavelet="haar")
    assert result.judgement.verdict is Verdict.NOT_COMPARABLE
    assert "No source has detail at level 1" in str(result.judgement.reason)
    assert [ratio is None for ratio in result.judgement.ratios.detail] == [True, False, False]


# --- many windows ----------------------------------------------------------------------------------------------


class Inline(Executor):
    """Runs a task when it is submitted."""

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


class Stalled(Executor):
    """Never gets to its tasks."""

    def __init__(self) -> None:
        self.futures: list[Future[Any]] = []

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        self.futures.append(Future())
        return self.futures[-1]


class Failing(Inline):
    """One window of which raises what nobody foresaw."""

    def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
        def task(request: WindowRequest) -> WindowResult:
            if request.window_id == 2:
                raise MemoryError("no room")
            result: WindowResult = fn(request)
            return result

        return super().submit(task, *args, **kwargs)


@pytest.fixture
def block(make_raster: MakeRaster) -> Block:
    """A mosaic with two sources."""
    scene = orthoimage(SIZE, 3)
    mosaic = mosaic_of(make_raster, softened(scene, 0.7))
    return block_of(mosaic, make_raster("a.tif", scene), make_raster("b.tif", softened(scene, 0.3)))


class Requests:
    """Requests one after the other, and how many of them were taken."""

    def __init__(self, block: Block, count: int) -> None:
        self.taken = 0
        self._block, self._count = block, count

    def __iter__(self) -> Iterator[WindowRequest]:
        for number in range(self._count):
            self.taken += 1
            window = PixelWindow(8 * (number % 20), 4 * number % 128, 64, 64)
            yield window_request(self._block, number, self._block.mosaic.grid.window_extent(window), Settings())


def test_every_executor_gives_the_same_results_in_the_order_of_the_requests(block: Block) -> None:
    alone = [inspect_window(request) for request in Requests(block, 30)]
    assert [result.window_id for result in alone] == list(range(30))
    assert {result.judgement.verdict for result in alone} <= {Verdict.SIGNIFICANT, Verdict.REDUCED}
    assert list(inspect_windows(Requests(block, 30), Inline(), 4)) == alone
    with ThreadPoolExecutor(4) as pool:
        assert list(inspect_windows(Requests(block, 30), pool, 8)) == alone
        assert list(inspect_windows(Requests(block, 3), pool, 100)) == alone[:3]
        assert list(inspect_windows(Requests(block, 0), pool, 4)) == []


def test_a_slow_window_does_not_change_the_order(block: Block) -> None:
    others_done = threading.Event()

    class FirstIsLast(ThreadPoolExecutor):
        def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
            def task(request: WindowRequest) -> WindowResult:
                if request.window_id == 0:
                    assert others_done.wait(30)
                if request.window_id == 3:
                    others_done.set()
                result: WindowResult = fn(request)
                return result

            return super().submit(task, *args, **kwargs)

    with FirstIsLast(2) as pool:
        results = inspect_windows(Requests(block, 8), pool, 4)
        assert [result.window_id for result in results] == list(range(8))


@pytest.mark.parametrize("ahead", [1, 2, 5])
def test_no_more_windows_are_under_way_than_asked_for(block: Block, ahead: int) -> None:
    requests = Requests(block, 12)
    with ThreadPoolExecutor(2) as pool:
        for yielded, result in enumerate(inspect_windows(requests, pool, ahead)):
            assert result.window_id == yielded
            assert requests.taken == min(yielded + ahead, 12)  # so the first comes before the last is thought of


def test_a_window_that_fails_costs_no_other(block: Block) -> None:
    results = list(inspect_windows(Requests(block, 5), Failing(), 2))
    assert [result.window_id for result in results] == list(range(5))
    failed = results.pop(2)
    assert_not_comparable(failed, "The window could not be measured (MemoryError: no room); please report this.")
    assert results == [inspect_window(request) for request in Requests(block, 5) if request.window_id != 2]


def test_cancelling_keeps_what_is_ready(block: Block) -> None:
    requests, seen = Requests(block, 50), []
    for result in inspect_windows(requests, Inline(), 6, lambda: len(seen) >= 3):
        seen.append(result.window_id)
    assert seen == list(range(len(seen)))
    assert requests.taken - 1 <= len(seen) <= 10  # all that were measured, and no new ones


def test_cancelling_does_not_wait_for_windows_that_are_not_ready(block: Block) -> None:
    executor, looks = Stalled(), []

    def cancelled() -> bool:
        looks.append(None)
        return len(looks) > 4

    assert list(inspect_windows(Requests(block, 50), executor, 3, cancelled)) == []
    assert len(executor.futures) == 3
    assert all(future.cancelled() for future in executor.futures)


def test_cancelled_before_the_first(block: Block) -> None:
    executor = Stalled()
    assert list(inspect_windows(Requests(block, 50), executor, 3, lambda: True)) == []
    assert executor.futures == []


def test_whoever_stops_listening_leaves_nothing_running(block: Block) -> None:
    class OneThenNone(Stalled):
        def submit(self, fn: Any, /, *args: Any, **kwargs: Any) -> Future[Any]:
            future = super().submit(fn, *args, **kwargs)
            if len(self.futures) == 1:
                future.set_result(fn(*args, **kwargs))
            return future

    executor = OneThenNone()
    results = inspect_windows(Requests(block, 50), executor, 4)
    assert next(results).window_id == 0
    results.close()  # type: ignore[attr-defined]
    assert len(executor.futures) == 4
    assert all(future.cancelled() for future in executor.futures[1:])


def test_requests_and_results_cross_processes(block: Block) -> None:
    outside = window_request(block, 99, FAR_AWAY, Settings())
    for request in (*Requests(block, 2), outside):
        there = pickle.loads(pickle.dumps(request))
        assert there == request
        result = inspect_window(there)
        back: WindowResult = pickle.loads(pickle.dumps(result))
        assert back == result == inspect_window(request)
        assert str(back.judgement.reason) == str(result.judgement.reason)
        assert not any(isinstance(value, gdal.Dataset) for value in vars(request).values())


def test_a_result_is_small_whatever_the_window(make_raster: MakeRaster) -> None:
    """10,000 results must not hold 10,000 clips."""
    scene = (100 + 20 * texture((512, 512), 1.5)).astype(np.float32)
    block = block_of(mosaic_of(make_raster, scene), make_raster("a.tif", scene))
    small, large = (len(pickle.dumps(inspect(block, PixelWindow(0, 0, side, side)))) for side in (64, 512))
    assert large < small + 200 < 5000


def test_reasons_can_be_translated_before_their_values_are_put_in(block: Block) -> None:
    reason = window_request(block, 1, FAR_AWAY, Settings()).reason
    assert isinstance(reason, Message)
    assert reason.worded(lambda template: template.replace("mosaic", "mozaika")) == str(reason).replace(
        "mosaic", "mozaika"
    )
