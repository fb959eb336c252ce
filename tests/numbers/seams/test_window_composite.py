"""The hard-cut composite as it is shown: the followed source's pixels, in the mosaic's grey values."""
from __future__ import annotations

import numpy as np
from seam_inspector.plugin.imagery.errors import Message
from seam_inspector.plugin.seams.measure.window.explained_window import window_composite
from seam_inspector.plugin.seams.measure.window.inspection import window_request
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings

from tests.numbers.seams.inspecting import MakeRaster, block_of, mosaic_of
from tests.numbers.seams.made_seams import BORDER, WHOLE, as_bytes, blended, three_images


def composite(
    make_raster: MakeRaster, image: np.ndarray, given: list[np.ndarray]
) -> tuple[tuple[str, ...], np.ndarray] | Message:
    mosaic = mosaic_of(make_raster, image)
    block = block_of(mosaic, *(make_raster(f"{'abc'[i]}.tif", pixels, nodata=0) for i, pixels in enumerate(given)))
    return window_composite(window_request(block, 1, mosaic.grid.window_extent(WHOLE), InspectionSettings()))


def test_a_feather_is_cut_and_tones_are_the_mosaics(make_raster: MakeRaster) -> None:
    """The sources were darker: the composite has their detail, and no step against the mosaic."""
    first, second, other = three_images()
    mosaic = blended([first, second], 40)
    result = composite(make_raster, mosaic, [as_bytes(0.8 * plane + 5) for plane in (first, second, other)])
    assert isinstance(result, tuple)
    names, bands = result
    assert names == ("red", "green", "blue")
    assert bands.dtype == np.uint8
    away = abs(np.arange(WHOLE.width) - BORDER) > 40
    assert abs(bands[..., away].astype(int) - mosaic[..., away]).max() <= 3
    band = ~away
    cut = np.where(np.arange(WHOLE.width) < BORDER, first, second)[..., band].astype(int)
    assert abs(bands[..., band] - cut).mean() < 0.6 * abs(mosaic[..., band].astype(int) - cut).mean()


def test_strangers_make_no_composite(make_raster: MakeRaster) -> None:
    first, second, _ = three_images()
    strangers = [as_bytes(np.random.default_rng(seed).normal(120, 20, first.shape)) for seed in (5, 6)]
    assert isinstance(composite(make_raster, blended([first, second]), strangers), Message)
