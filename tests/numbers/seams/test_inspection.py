"""From a mosaic, its sources and a rectangle to the result of a window."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import ogr
from seam_inspector.plugin.imagery.errors import SettingsError
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure import messages as seams_messages
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.seam_cells import Cell
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window, make_block, window_request
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings

from tests.numbers.seams.inspecting import (
    FAR_AWAY,
    SIZE,
    WINDOW,
    MakeRaster,
    block_of,
    inside,
    inspect,
    mosaic_of,
    softened,
    templates,
)
from tests.numbers.synthetic import ORIGIN, decompose, luminance, orthoimage


def test_the_mosaic_among_its_sources_is_dropped_with_a_notice(make_raster: MakeRaster, tmp_path: Path) -> None:
    image = orthoimage((64, 64))
    mosaic, source = mosaic_of(make_raster, image), make_raster("source.tif", image)
    (tmp_path / "folder").mkdir()
    otherwise = str(tmp_path / "folder" / ".." / "mosaic.tif")
    for named in (mosaic.ref.path, otherwise):
        block, notices = make_block(mosaic, [RasterRef(named), RasterRef(source)])
        assert [kept.ref.path for kept in block.sources] == [source]
        assert templates(notices) == [seams_messages.MOSAIC_AMONG_SOURCES.template]
        assert str(notices[0]).startswith("mosaic.tif is the mosaic itself")
    indexed = [Source(RasterRef(otherwise), mosaic.extent), Source(RasterRef(source), mosaic.extent)]
    block, notices = make_block(mosaic, [], indexed)
    assert [kept.ref.path for kept in block.sources] == [source]
    assert templates(notices) == [seams_messages.MOSAIC_AMONG_SOURCES.template]


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
    with pytest.raises(SettingsError, match=r"No sources are given; choose the orthoimages .* or an index of them\."):
        make_block(mosaic, [])
    block, notices = make_block(mosaic, [mosaic.ref])  # something was named, so the windows say what is missing
    assert block.sources == ()
    assert len(notices) == 1


def test_cells_that_name_other_sources_are_told(make_raster: MakeRaster) -> None:
    image = orthoimage((64, 64))
    mosaic, source = mosaic_of(make_raster, image), make_raster("source.tif", image)
    for name, expected in (("elsewhere", [seams_messages.CELLS_OF_OTHERS.template]), ("folder/SOURCE.jp2", [])):
        _, notices = make_block(mosaic, [RasterRef(source)], (), [Cell(name, b"", mosaic.extent)])
        assert templates(notices) == expected


def test_a_source_outside_the_window_is_never_opened(make_raster: MakeRaster) -> None:
    image = orthoimage(SIZE)
    mosaic, source = mosaic_of(make_raster, image), make_raster("source.tif", image // 2 + 60)  # no copy
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
    result = inspect(block_of(mosaic, make_raster("a.tif", images["a.tif"]), shifted), reference="sources")

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
        of_mosaic, other = expected["mosaic.tif", pair.band], expected[pair.source, pair.band]
        ratios = of_mosaic.shares / other.shares
        assert (*pair.ratios.detail, pair.ratios.background) == pytest.approx(tuple(ratios), rel=1e-4)
        similarity = np.corrcoef(of_mosaic.coarse.ravel(), other.coarse.ravel())[0, 1]
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
@pytest.mark.parametrize("reference", ["sources", "composite", "seam"])
def test_the_softer_the_mosaic_the_worse_the_verdict(
    make_raster: MakeRaster, reference: str, sigma: float, verdict: Verdict
) -> None:
    scene = orthoimage(SIZE, 3)
    mosaic = mosaic_of(make_raster, softened(scene, sigma) if sigma else scene)
    result = inspect(block_of(mosaic, make_raster("source.tif", scene)), reference=reference)
    assert result.judgement.verdict is verdict
    assert result.paper_verdict is verdict
    assert result.reference == reference
    reason = result.judgement.reason
    if reference == "seam" and verdict is not Verdict.SIGNIFICANT:  # one source: the sharpness alone is judged
        assert reason.template == seams_messages.NO_SEAM.template
    else:
        assert reason is None


@pytest.mark.parametrize("reference", ["seam", "composite"])
def test_strangers_make_no_composite_to_be_judged_against(make_raster: MakeRaster, reference: str) -> None:
    mosaic = mosaic_of(make_raster, orthoimage(SIZE, 3))
    block = block_of(mosaic, make_raster("stranger.tif", orthoimage(SIZE, 3)[:, ::-1, ::-1].copy()))
    by_sources = inspect(block, reference="sources")
    assert by_sources.judgement.verdict is not Verdict.NOT_COMPARABLE
    result = inspect(block, reference=reference)
    assert result.judgement.verdict is Verdict.NOT_COMPARABLE
    assert "No source explains" in str(result.judgement.reason)
    assert result.paper_verdict is by_sources.judgement.verdict
    assert [cause.value for cause in result.causes] == ["unclear"]
    assert result.explained == 0
    assert result.profile is None


def test_cells_say_how_a_mosaic_was_cut_that_no_source_explains(make_raster: MakeRaster) -> None:
    mosaic = mosaic_of(make_raster, orthoimage(SIZE, 3))
    stranger = make_raster("stranger.tif", orthoimage(SIZE, 3)[:, ::-1, ::-1].copy())
    xmin, ymin, xmax, ymax = mosaic.extent
    box = ogr.CreateGeometryFromWkt(f"POLYGON(({xmin} {ymin},{xmax} {ymin},{xmax} {ymax},{xmin} {ymax},{xmin} {ymin}))")
    cell = Cell("stranger.tif", bytes(box.ExportToWkb()), mosaic.extent)
    block, _ = make_block(mosaic, [RasterRef(stranger)], cells=[cell])
    assert inspect(block, reference="composite").judgement.verdict is not Verdict.NOT_COMPARABLE


def test_settings_out_of_range_are_refused() -> None:
    InspectionSettings().check()
    for wrong in ({"wavelet": "bior2.2"}, {"levels": 0}, {"levels": 9}, {"max_ratio": 1.0}, {"reference": "x"},
                  {"min_kept": 0.0}, {"min_kept": 1.0}):
        with pytest.raises(SettingsError):
            InspectionSettings(**wrong).check()  # type: ignore[arg-type]


def test_a_drawn_rectangle_is_snapped(make_raster: MakeRaster) -> None:
    block = block_of(mosaic_of(make_raster, orthoimage(SIZE)), make_raster("a.tif", orthoimage(SIZE)))
    xmin, ymin, xmax, ymax = block.mosaic.grid.window_extent(WINDOW)
    request = window_request(block, 3, (xmin - 0.03, ymin - 0.12, xmax + 0.04, ymax + 0.31), InspectionSettings())
    assert request.window == PixelWindow(64, 95, 64, 128)
    assert inspect_window(request).window == request.window
