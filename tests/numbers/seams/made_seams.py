"""Mosaics of made-up images with a seam, as files, and what is said of them."""
from __future__ import annotations

from typing import Any

import numpy as np
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.seams.measure.window.window_result import WindowResult

from tests.numbers.seams.inspecting import MakeRaster, block_of, inspect, mosaic_of
from tests.numbers.synthetic import texture

SIDE = 320
SHAPE = (SIDE, SIDE)
WHOLE = PixelWindow(0, 0, SIDE, SIDE)
BORDER = 150


def three_images() -> list[np.ndarray]:
    """Images of one scene, each with fine detail of its own, (3, rows, columns) 8 bit."""
    scene = np.stack([110 + 6 * band + 22 * texture(SHAPE, 3.0, 40) + 5 * texture(SHAPE, 3.0, 41 + band)
                      for band in range(3)])
    return [as_bytes(scene + 9 * texture(SHAPE, 0.8, seed)) for seed in (1, 2, 3)]


def as_bytes(bands: np.ndarray) -> np.ndarray:
    return np.clip(np.rint(bands), 1, 255).astype(np.uint8)


def weight(width: float, border: float = BORDER) -> np.ndarray:
    """Weight of the second source, along columns: a linear feather of a full width, 0 for a hard cut."""
    place = np.arange(SIDE) + 0.5 - border
    return np.asarray(place > 0, float) if not width else np.clip(place / width + 0.5, 0, 1)


def blended(sources: list[np.ndarray], width: float = 0.0) -> np.ndarray:
    second = weight(width)
    return as_bytes((1 - second) * sources[0] + second * sources[1])


def inspected(
    make_raster: MakeRaster, image: np.ndarray, given: list[np.ndarray], **settings: Any
) -> WindowResult:
    mosaic = mosaic_of(make_raster, image)
    paths = [make_raster(f"{'abc'[number]}.tif", pixels, nodata=0) for number, pixels in enumerate(given)]
    return inspect(block_of(mosaic, *paths), WHOLE, **settings)
