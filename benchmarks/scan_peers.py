"""What the scan of a mosaic is measured against: the bare read, windows side by side, a loop with PyWavelets."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from threading import local

import numpy as np
import pywt
from osgeo import gdal
from seam_inspector.plugin.imagery.grids import PixelWindow
from seam_inspector.plugin.imagery.limits import LUMINANCE_WEIGHTS
from seam_inspector.plugin.imagery.open_raster import describe, describe_mosaic
from seam_inspector.plugin.imagery.rasters import RasterRef
from seam_inspector.plugin.seams.measure.source_images import Source
from seam_inspector.plugin.seams.measure.window.inspection import Block, inspect_window
from seam_inspector.plugin.seams.measure.window.measured_window import InspectionSettings, WindowRequest

from .timing import Speed, timed

READ_PX, WINDOW_PX = 2048, 1024
"""Side of what is read at a time, and of a standard window of 0.10 m pixels."""
WAVELET, LEVELS, CELL_PX = "coif3", 3, 16


class Datasets(local):
    """The rasters, opened anew in each thread; so nothing is in GDAL's cache at the start."""

    def __init__(self, paths: Sequence[Path]) -> None:
        self.all = [gdal.Open(str(path)) for path in paths]

    def read(self, at: PixelWindow) -> list[np.ndarray]:
        """The pixels of a window of all rasters, which lie on one grid."""
        return [one.ReadAsArray(at.column, at.row, at.width, at.height) for one in self.all]


def windows(side: int, size: int) -> Iterator[PixelWindow]:
    """Windows that together are a square, row by row; those at its far edges are smaller."""
    for row in range(0, side, size):
        for column in range(0, side, size):
            yield PixelWindow(column, row, min(size, side - column), min(size, side - row))


def sampled(side: int, size: int, count: int) -> list[PixelWindow]:
    """Some whole windows of a square, evenly spread over all rows and columns."""
    whole = [one for one in windows(side, size) if one.width == one.height == size]
    return [whole[int((number + 0.5) * len(whole) / count)] for number in range(min(count, len(whole)))]


def megapixels(of: Iterable[PixelWindow]) -> float:
    """Megapixels of the mosaic, in all windows together."""
    return sum(one.width * one.height for one in of) / 1e6


def bare_read(paths: Sequence[Path], side: int, threads: int) -> None:
    """All pixels of all rasters by GDAL alone, each tile decoded once."""
    datasets = Datasets(paths)
    with ThreadPoolExecutor(threads) as executor:
        for _ in executor.map(lambda at: len(datasets.read(at)), windows(side, READ_PX)):
            pass


def inspected_windows(paths: Sequence[Path], side: int, threads: int, count: int) -> Speed:
    """Speed of ``inspect_window``, over a sample of the windows that would cover the mosaic."""
    refs = [RasterRef(str(path)) for path in paths]
    block = Block(describe_mosaic(refs[0]), tuple(Source(ref, describe(ref).extent) for ref in refs[1:]))
    places = sampled(side, WINDOW_PX, count)
    requests = [WindowRequest(number, block.mosaic, block.sources, place, InspectionSettings())
                for number, place in enumerate(places)]

    def inspect() -> None:
        with ThreadPoolExecutor(threads) as executor:
            for result in executor.map(inspect_window, requests):
                assert result.source_count == len(block.sources)

    return Speed.of(megapixels(places), timed(inspect))


def pywavelets_loop(paths: Sequence[Path], side: int, threads: int, count: int, by_band: bool = False) -> Speed:
    """Speed of a plain loop: read, ``pywt.wavedec2``, sums by cell of every raster.

    It measures the luminance, or ``by_band`` red, green and blue, over a sample of blocks. It leaves out what costs the
    scan most: which source is followed.
    """
    decompose = decomposed_bands if by_band else decomposed
    datasets = Datasets(paths)
    places = sampled(side, READ_PX, count)

    def decompose_all() -> None:
        with ThreadPoolExecutor(threads) as executor:
            for sums in executor.map(lambda at: cell_sums(list(map(decompose, datasets.read(at)))), places):
                assert np.isfinite(sums[0]).all()

    return Speed.of(megapixels(places), timed(decompose_all))


def decomposed(bands: np.ndarray) -> list:
    """The details of the luminance, coarsest first."""
    plane = np.zeros(bands.shape[1:], np.float32)
    for band, weight in zip(bands, LUMINANCE_WEIGHTS):
        plane += np.float32(weight) * band
    return pywt.wavedec2(plane, WAVELET, mode="periodization", level=LEVELS)[1:]


def decomposed_bands(bands: np.ndarray) -> list:
    """The details of all bands, coarsest first."""
    return pywt.wavedec2(bands.astype(np.float32), WAVELET, mode="periodization", level=LEVELS, axes=(1, 2))[1:]


def cell_sums(rasters: list[list]) -> list[np.ndarray]:
    """The sums m m of the mosaic, c c and m c of each source, by level and cell."""
    mosaic, *sources = rasters
    sums = []
    for level in range(LEVELS):
        side = CELL_PX >> (LEVELS - level)
        pairs = [(mosaic[level], mosaic[level])]
        pairs += [pair for one in sources for pair in ((one[level], one[level]), (mosaic[level], one[level]))]
        for one, other in pairs:
            product = sum(a * b for a, b in zip(one, other))
            *bands, rows, columns = product.shape
            cells = product.reshape(*bands, rows // side, side, columns // side, side)
            sums.append(cells.sum(axis=(-3, -1)))
    return sums
