"""Rasters of a window that can be compared, and the reason where none can."""
from __future__ import annotations

from pathlib import Path

import numpy as np
from osgeo import gdal
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window, window_request
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings

from tests.numbers.seams.inspecting import (
    FAR_AWAY,
    SIZE,
    MakeRaster,
    assert_not_comparable,
    block_of,
    inspect,
    mosaic_of,
)
from tests.numbers.synthetic import ORIGIN, orthoimage


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


def test_a_rectangle_that_is_no_window_gives_its_reason(make_raster: MakeRaster) -> None:
    block = block_of(mosaic_of(make_raster, orthoimage(SIZE)), make_raster("a.tif", orthoimage(SIZE)))
    request = window_request(block, 3, FAR_AWAY, InspectionSettings())
    result = inspect_window(request)
    assert_not_comparable(result, "The window lies outside the mosaic; choose a place on it.")
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


def test_a_source_with_hardly_a_pixel_in_the_window_is_no_source_of_it(make_raster: MakeRaster) -> None:
    scene, gap = orthoimage(SIZE), orthoimage(SIZE)
    gap[:, :, 64:128] = 0
    gap[:, 96:100, 64:72] = scene[:, 96:100, 64:72]  # 32 of 8192 pixels
    mosaic, good = mosaic_of(make_raster, scene), make_raster("good.tif", scene)
    empty = make_raster("empty.tif", gap, nodata=0)
    assert_not_comparable(inspect(block_of(mosaic, empty)), "of the pixels of empty.tif are invalid")
    result = inspect(block_of(mosaic, empty, good))
    assert result.judgement.verdict is Verdict.PRESERVED
    assert result.source_count == 1
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
