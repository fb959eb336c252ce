"""What inspected windows say of sources that the mosaic does not follow, or that took no part."""
from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from osgeo import gdal
from seam_inspector.plugin.imagery.errors import Message
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.window.inspection import inspect_window, make_block, window_request
from seam_inspector.plugin.seams.measure.window.source_use import FEWEST_WINDOWS, source_doubts, source_use
from seam_inspector.plugin.seams.measure.window.window_request import InspectionSettings
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult

from tests.numbers.conftest import MakeRaster
from tests.numbers.synthetic import ORIGIN, orthoimage


@pytest.fixture
def paths(make_raster: MakeRaster) -> dict[str, str]:
    """A mosaic of two images, and another image of the same ground that it was not made from."""
    ground, rng = orthoimage((256, 512)).astype(float), np.random.default_rng(5)
    images = [
        np.clip(np.roll(ground, shift, axis=2) + rng.normal(0, 8, ground.shape), 1, 255).astype(np.uint8)
        for shift in (0, 2, 4)
    ]
    mosaic = np.concatenate([images[0][..., :256], images[1][..., 256:]], axis=-1)
    named = zip(("west", "east", "stranger", "mosaic"), (*images, mosaic))
    return {name: make_raster(f"{name}.tif", pixels) for name, pixels in named}


def inspected(mosaic: str, *sources: str) -> list[WindowResult]:
    """Windows of 128 px along the seam in its middle."""
    raster = describe_mosaic(RasterRef(mosaic))
    block, _ = make_block(raster, map(RasterRef, sources))
    left, top = ORIGIN[0] + 19.2, ORIGIN[1]
    extents = [(left, top - 12.8 - 0.8 * row, left + 12.8, top - 0.8 * row) for row in range(FEWEST_WINDOWS)]
    return [
        inspect_window(window_request(block, number, extent, InspectionSettings()))
        for number, extent in enumerate(extents, 1)
    ]


def said(results: list[WindowResult]) -> list[str]:
    found: list[Message] = list(source_doubts(map(source_use, results)))
    return [str(one) for one in found]


def test_a_source_that_no_window_follows_is_questioned(paths: dict[str, str]) -> None:
    results = inspected(paths["mosaic"], paths["west"], paths["east"], paths["stranger"])
    (sentence,) = said(results)
    assert "stranger.tif in none of the 5 windows" in sentence
    assert said(results[:-1]) == []  # too few to say so
    assert said(inspected(paths["mosaic"], paths["west"], paths["east"])) == []


def test_it_is_said_why_resampled_sources_took_no_part(paths: dict[str, str], tmp_path: Path) -> None:
    """A mosaic in degrees, where each source was reprojected to pixels of its own size."""
    made = {name: str(tmp_path / f"{name}_degrees.tif") for name in ("mosaic", "west", "east")}
    gdal.Warp(made["mosaic"], paths["mosaic"], dstSRS="EPSG:4326", resampleAlg="cubic")
    raster = describe_mosaic(RasterRef(made["mosaic"]))
    size = raster.grid.pixel_width
    for name, factor in (("west", 1.0), ("east", 1.03)):
        gdal.Warp(made[name], paths[name], dstSRS="EPSG:4326", xRes=size * factor, yRes=size * factor)
    block, _ = make_block(raster, [RasterRef(made["west"]), RasterRef(made["east"]), RasterRef(paths["east"])])
    xmin, ymin, xmax, ymax = raster.extent
    middle = (xmin + xmax) / 2, (ymin + ymax) / 2
    extent = middle[0] - 64 * size, middle[1] - 64 * size, middle[0] + 64 * size, middle[1] + 64 * size
    result = inspect_window(window_request(block, 1, extent, InspectionSettings()))
    (sentence,) = said([result])
    assert "2 others took no part" in sentence
    assert "another size" in sentence
