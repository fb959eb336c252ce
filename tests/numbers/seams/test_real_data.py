"""Real orthoimages: Brighton's two mosaics and PackO's tile, against PyWavelets and against what is known of them."""
from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal, ogr
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.judgement.causes import Cause
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.window.inspection import Block, inspect_windows, make_block, window_request
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult

from tests.numbers.synthetic import decompose, luminance, read_pixels, write_raster

SIDE = 256
BANDS = ("luminance", "red", "green", "blue")
HARD, FEATHERED = "mosaic_hardseam.tif", "mosaic_feather0p4m.tif"


def block_of(mosaic: str, sources: Sequence[Path]) -> Block:
    block, notices = make_block(describe_mosaic(RasterRef(mosaic)), [RasterRef(str(path)) for path in sources])
    assert notices == []
    return block


def inspect(block: Block, windows: Sequence[PixelWindow]) -> list[WindowResult]:
    extents = [block.mosaic.grid.window_extent(window) for window in windows]
    requests = [window_request(block, number, extent, InspectionSettings()) for number, extent in enumerate(extents)]
    with ThreadPoolExecutor(2) as pool:
        results = list(inspect_windows(requests, pool, 4))
    assert [result.window for result in results] == list(windows)
    return results


def shares(pixels: np.ndarray) -> dict[str, np.ndarray]:
    """detail_1, 2, 3 and background of each band by PyWavelets."""
    return {name: decompose(band).shares for name, band in zip(BANDS, [luminance(pixels), *pixels])}


@pytest.fixture(scope="module")
def labels(brighton: Path) -> np.ndarray:
    """The source that each pixel of the mosaics is from; 0 outside."""
    return read_pixels(str(brighton / "source_label.tif"), 0, 0, 3423, 2987)[0]


@pytest.fixture(scope="module")
def on_seams(labels: np.ndarray) -> list[PixelWindow]:
    """Windows inside the mosaics with at least two sources, none of which has more than 85 %."""
    windows = []
    for row in range(0, labels.shape[0] - SIDE, SIDE):
        for column in range(0, labels.shape[1] - SIDE, SIDE):
            values, counts = np.unique(labels[row : row + SIDE, column : column + SIDE], return_counts=True)
            if values[0] > 0 and counts.max() <= 0.85 * SIDE**2:
                windows.append(PixelWindow(column, row, SIDE, SIDE))
    return windows


def sources_by_gdal(folder: Path, window: PixelWindow) -> dict[str, np.ndarray]:
    """The pixels of every orthoimage that covers a window of the mosaics, read by geotransforms alone."""
    left, width, _, top, _, height = gdal.Open(str(folder / HARD)).GetGeoTransform()
    sources = {}
    for path in sorted(folder.glob("DJI_*.tif")):
        dataset = gdal.Open(str(path))
        origin = dataset.GetGeoTransform()
        column = window.column + round((left - origin[0]) / width)
        row = window.row + round((top - origin[3]) / height)
        fits = 0 <= column <= dataset.RasterXSize - SIDE and 0 <= row <= dataset.RasterYSize - SIDE
        if fits:
            pixels = read_pixels(str(path), column, row, SIDE, SIDE)
            if (pixels > 0).any(axis=0).all():
                sources[path.name] = pixels
    return sources


def test_brighton_equals_pywavelets(brighton: Path, on_seams: list[PixelWindow]) -> None:
    chosen = [on_seams[index] for index in np.linspace(0, len(on_seams) - 1, 6).round().astype(int)]
    block = block_of(str(brighton / HARD), sorted(brighton.glob("DJI_*.tif")))
    pairs = judged = 0
    for window, result in zip(chosen, inspect(block, chosen)):
        of_mosaic = shares(read_pixels(str(brighton / HARD), window.column, window.row, SIDE, SIDE))
        others = {name: shares(pixels) for name, pixels in sources_by_gdal(brighton, window).items()}
        assert {clip.raster for clip in result.clips} >= {HARD, *others}  # a few invalid pixels may be filled
        for clip in result.clips:
            expected = of_mosaic if clip.role == "mosaic" else others.get(clip.raster, {})
            for band in expected:
                curve = clip.curves[band]
                shown = np.array([*curve.detail, curve.background])
                np.testing.assert_allclose(shown, expected[band], rtol=1e-4, atol=1e-6)
                np.testing.assert_allclose(shown, expected[band], rtol=1e-4)
        for pair in result.pairs:
            assert (pair.offset_x, pair.offset_y, pair.resampled) == (0, 0, False)  # one common grid
            if pair.source in others:
                ratios = of_mosaic[pair.band] / others[pair.source][pair.band]
                assert (*pair.ratios.detail, pair.ratios.background) == pytest.approx(tuple(ratios), rel=1e-4)
                pairs += 1
        if {clip.raster for clip in result.clips} == {HARD, *others}:
            largest = max(of_mosaic["luminance"][0] / other["luminance"][0] for other in others.values())
            assert result.judgement.ratios.detail[0] == pytest.approx(largest, rel=1e-4)
            judged += 1
    assert pairs >= 6 * 4 * 2  # some two sources a window
    assert judged >= 3


@pytest.fixture(scope="module")
def results(brighton: Path, on_seams: list[PixelWindow]) -> tuple[list[WindowResult], list[WindowResult]]:
    """Results of the hard-cut and of the feathered mosaic."""
    sources = sorted(brighton.glob("DJI_*.tif"))
    hard, feathered = (inspect(block_of(str(brighton / name), sources), on_seams) for name in (HARD, FEATHERED))
    assert len(on_seams) >= 10
    return hard, feathered


def test_an_eye_just_sees_the_feathers_and_no_hard_cut(results: tuple[list[WindowResult], list[WindowResult]]) -> None:
    """In just noticeable differences at 2x."""
    hard, feathered = ([result.visibility for result in of if result.visibility is not None] for of in results)
    assert len(hard) == len(feathered) >= 10
    assert max(hard) < 0.1
    assert min(feathered) > 0.3
    assert np.median(feathered) == pytest.approx(1.15, abs=0.15)
    assert max(feathered) < 1.7


def test_every_source_of_a_window_takes_part_wholly_or_in_part(
    results: tuple[list[WindowResult], list[WindowResult]], on_seams: list[PixelWindow], labels: np.ndarray
) -> None:
    in_part = 0
    for window, result in zip(on_seams, results[0]):
        inside = labels[window.row : window.row + SIDE, window.column : window.column + SIDE]
        assert result.source_count >= len(np.unique(inside))
        assert result.explained == pytest.approx(1, abs=0.02)
        partial = {str(notice).split(" ")[0] for notice in result.notices}
        whole = {clip.raster for clip in result.clips if clip.role == "source"}
        assert {pair.source for pair in result.pairs} == partial | whole  # who covers a part only is named
        assert not partial & whole
        in_part += bool(partial)
    assert in_part >= 3


def test_brightons_hard_seams_are_sound_and_the_feathered_ones_are_not(
    results: tuple[list[WindowResult], list[WindowResult]]
) -> None:
    hard, feathered = results
    assert Verdict.SIGNIFICANT not in [result.judgement.verdict for result in hard]
    assert Verdict.REDUCED not in [result.judgement.verdict for result in hard]
    # Two photos of real ground fit less well here and there; the cut lost nothing by it, and the cause only says so.
    assert {result.causes for result in hard} <= {(Cause.NONE,), (Cause.MISREGISTRATION,)}
    assert np.mean([result.causes == (Cause.NONE,) for result in hard]) >= 0.9
    judged = [result for result in feathered if result.judgement.verdict is not Verdict.NOT_COMPARABLE]
    assert len(judged) >= 0.8 * len(feathered)
    flagged = [result.judgement.verdict in (Verdict.SIGNIFICANT, Verdict.REDUCED) for result in judged]
    assert np.mean(flagged) >= 0.9
    assert np.mean([result.causes[0] is Cause.FEATHERING for result in judged]) >= 0.9
    kept = [[result.profile.kept[0] for result in result if result.profile] for result in results]
    assert max(kept[1]) < min(kept[0])  # the seam's own measure parts them, all of them


@pytest.fixture(scope="module")
def packo(data_folder: Path) -> list[Path]:
    """The three orthoimages of one tile, 256 x 256 px; the last, 16373, is visibly blurred."""
    return sorted((data_folder / "seams" / "packo").glob("*.tif"))


TILES = [PixelWindow(column, row, 64, 64) for row in range(0, 256, 64) for column in range(0, 256, 64)]


def packo_labels(packo: list[Path]) -> np.ndarray:
    """Index of the source of each pixel, as the seam graph has it."""
    graph = ogr.Open(str(packo[0].parent / "regress_graphe.gpkg"))
    layer = graph.GetLayerByName("graphe")
    burnt = gdal.GetDriverByName("MEM").Create("", 256, 256, 1)
    burnt.SetGeoTransform(gdal.Open(str(packo[0])).GetGeoTransform())
    burnt.SetProjection(gdal.Open(str(packo[0])).GetProjection())
    for index, path in enumerate(packo):
        layer.SetAttributeFilter(f"CLICHE LIKE '%{path.stem[-5:]}'")
        gdal.RasterizeLayer(burnt, [1], layer, burn_values=[index + 1])
    return burnt.ReadAsArray().astype(int) - 1


@pytest.mark.release
def test_packo_runs_on_its_own_seams(packo: list[Path], tmp_path: Path) -> None:
    labels = packo_labels(packo)
    assert set(np.unique(labels)) >= {0, 1}
    images = np.stack([read_pixels(str(path), 0, 0, 256, 256) for path in packo])
    mosaic = np.take_along_axis(images, labels.clip(0)[np.newaxis, np.newaxis], axis=0)[0]
    geotransform = gdal.Open(str(packo[0])).GetGeoTransform()
    path = write_raster(tmp_path / "mosaic.tif", mosaic, geotransform=geotransform, system=2154)
    results = inspect(block_of(path, packo), TILES)
    for window, result in zip(TILES, results):
        assert result.source_count == 3
        assert result.paper_verdict is not Verdict.NOT_COMPARABLE
        area = np.s_[..., window.row : window.row + 64, window.column : window.column + 64]
        for clip, pixels in zip(result.clips, [mosaic[area], *images[area]]):
            for band, expected in shares(pixels).items():
                curve = clip.curves[band]
                np.testing.assert_allclose([*curve.detail, curve.background], expected, rtol=1e-4, atol=1e-7)


@pytest.mark.release
def test_the_blurred_image_of_packo_is_found(packo: list[Path], tmp_path: Path) -> None:
    finest = []
    blurred, sharp = (
        inspect(block_of(copy_of(tmp_path, mosaic), sources), TILES)
        for mosaic, sources in ((packo[2], packo[:2]), (packo[1], packo[::2]))
    )
    for result in blurred:
        assert len(result.clips) == 3
        finest.append([clip.curves["luminance"].detail[0] for clip in result.clips])
    assert np.mean(np.argmin(finest, axis=1) == 0) >= 15 / 16
    verdicts = [result.paper_verdict for result in blurred]
    assert verdicts.count(Verdict.PRESERVED) <= 1
    assert verdicts.count(Verdict.SIGNIFICANT) >= 1
    assert [result.paper_verdict for result in sharp].count(Verdict.SIGNIFICANT) == 0


def copy_of(folder: Path, path: Path) -> str:
    """A copy of a raster under another name: a mosaic is never its own source."""
    copy = folder / f"copy_of_{path.name}"
    copy.write_bytes(path.read_bytes())
    return str(copy)
