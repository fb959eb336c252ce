"""What a report's sections are made of: the part that lost most, the map sketch, the overview, contrast from pairs."""
from __future__ import annotations

from collections.abc import Callable

import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery import clips
from seam_inspector.plugin.imagery.clips import read_overview
from seam_inspector.plugin.imagery.limits import judged_band
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.window_records import PairRecord, contrast_of

from tests.numbers.synthetic import ORIGIN, orthoimage

MakeRaster = Callable[..., str]


def test_the_overview_is_a_small_picture_of_the_place(make_raster: MakeRaster) -> None:
    pixels = orthoimage((400, 600))
    pixels[..., :100] = 0
    mosaic = describe_mosaic(RasterRef(make_raster("mosaic.tif", pixels, nodata=0)))
    left, top = ORIGIN
    overview = read_overview(mosaic, (left - 50, top - 20, left + 30, top + 50), 150)
    assert overview is not None
    block, extent = overview
    assert extent == pytest.approx((left, top - 20, left + 30, top))
    assert block.bands.shape == (3, 100, 150)
    assert not block.valid[:, :49].any()
    assert block.valid[:, 51:].all()
    assert read_overview(mosaic, (left + 100, top, left + 200, top + 10), 150) is None


def test_a_huge_file_without_overviews_is_not_read(make_raster: MakeRaster, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(clips, "MAX_OVERVIEW_PIXELS", 20_000)
    path = make_raster("mosaic.tif", orthoimage((400, 600)))
    mosaic = describe_mosaic(RasterRef(path))
    assert read_overview(mosaic, mosaic.extent, 100) is None
    dataset = gdal.Open(path, gdal.GA_Update)
    dataset.BuildOverviews("AVERAGE", [4])
    del dataset
    assert read_overview(mosaic, mosaic.extent, 100) is not None


def test_contrast_is_the_composites_else_the_largest_of_the_sources() -> None:
    rows = [("a", "luminance", 0.4), ("b", "luminance", 0.7), ("b", "red", 3.0), ("c", "luminance", None)]
    pairs = [PairRecord(source, band, None, contrast) for source, band, contrast in rows]
    assert contrast_of(pairs) == 0.7
    assert contrast_of([*pairs, PairRecord("composite", "luminance", None, 0.5)]) == 0.5
    assert contrast_of([*pairs, PairRecord("composite", "luminance", None, None)]) == 0.7
    assert contrast_of([PairRecord("a", "band_1", None, 0.2)]) == 0.2
    assert contrast_of([]) is None
    assert judged_band(["red", "luminance"]) == "luminance"
    assert judged_band(["nir", "red"]) == "nir"
