"""What the tests of inspection share."""
from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from scipy import ndimage
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.open_raster import describe_mosaic
from seam_inspector.plugin.imagery.rasters import Raster, RasterRef
from seam_inspector.plugin.seams.measure.judgement.verdicts import Verdict
from seam_inspector.plugin.seams.measure.source_images import gather_sources
from seam_inspector.plugin.seams.measure.window.inspection import Block, inspect_window, window_request
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult

MakeRaster = Callable[..., str]
SIZE = (256, 256)
WINDOW = PixelWindow(64, 96, 64, 128)
FAR_AWAY = (0.0, 0.0, 100.0, 100.0)


def inside(array: np.ndarray, window: PixelWindow = WINDOW) -> np.ndarray:
    return array[..., window.row : window.row + window.height, window.column : window.column + window.width]


def softened(image: np.ndarray, sigma: float) -> np.ndarray:
    return np.stack([ndimage.gaussian_filter(band, sigma, mode="wrap") for band in image])


def mosaic_of(make_raster: MakeRaster, image: np.ndarray, name: str = "mosaic.tif", **options: Any) -> Raster:
    return describe_mosaic(RasterRef(make_raster(name, image, **options)))


def block_of(mosaic: Raster, *paths: str) -> Block:
    """Also where the mosaic is a copy of one of them, which ``make_block`` would leave out."""
    sources, notices = gather_sources([RasterRef(path) for path in paths], (), mosaic.wkt, mosaic.ref)
    assert notices == []
    return Block(mosaic, tuple(sources))


def inspect(block: Block, window: PixelWindow = WINDOW, **settings: Any) -> WindowResult:
    extent = block.mosaic.grid.window_extent(window)
    return inspect_window(window_request(block, 7, extent, InspectionSettings(**settings)))


def templates(notices: Any) -> list[str]:
    return [notice.template for notice in notices]


def assert_not_comparable(result: WindowResult, reason: str) -> None:
    assert result.judgement.verdict is Verdict.NOT_COMPARABLE
    assert reason in str(result.judgement.reason)
    assert set(result.judgement.ratios.detail) == {None}
