"""Overviews of the picture of losses, made where it shows something: most of a mosaic may never have been measured.

GDAL would look at every pixel, of which a country has thousands of millions, and could not be stopped.
"""
from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from osgeo import gdal

TILE = 256
"""Side of the parts of an overview that are made at a time; a picture that is no larger has none."""


def write_overviews(dataset: gdal.Dataset, tiles: Iterable[tuple[int, int]], of_names: int) -> None:
    """Halve a picture until it is no larger than a tile: means, and of the band ``of_names`` what most pixels name.

    ``tiles``: rows and columns of tiles of the first overview that are not empty.
    """
    longest = max(dataset.RasterXSize, dataset.RasterYSize)
    factors = [2**level for level in range(1, 31) if longest / 2 ** (level - 1) > TILE]
    if not factors:
        return
    dataset.BuildOverviews("NONE", factors)
    wanted = set(tiles)
    nodata = dataset.GetRasterBand(1).GetNoDataValue()
    bands = [dataset.GetRasterBand(number + 1) for number in range(dataset.RasterCount)]
    for level in range(len(factors)):
        for row, column in sorted(wanted):
            for number, band in enumerate(bands, 1):
                finer = band.GetOverview(level - 1) if level else band
                left, top = 2 * TILE * column, 2 * TILE * row
                width, height = min(2 * TILE, finer.XSize - left), min(2 * TILE, finer.YSize - top)
                pixels = finer.ReadAsArray(left, top, width, height)
                made = most_named(pixels, nodata) if number == of_names else means(pixels, nodata)
                band.GetOverview(level).WriteArray(made, left // 2, top // 2)
        wanted = {(row // 2, column // 2) for row, column in wanted}


def means(pixels: np.ndarray, nodata: float) -> np.ndarray:
    """Of two by two, without those that are not known."""
    four = _four(pixels, nodata)
    known = four != nodata
    count = known.sum(axis=0)
    total = np.where(known, four, 0).sum(axis=0, dtype=np.float64)
    return np.where(count, total / np.maximum(count, 1), nodata).astype(np.float32)


def most_named(pixels: np.ndarray, nodata: float) -> np.ndarray:
    """Of two by two the number that stands there most often; of several the first."""
    four = _four(pixels, nodata)
    votes = np.where(four != nodata, (four[:, np.newaxis] == four).sum(axis=1), 0)
    return np.take_along_axis(four, votes.argmax(axis=0)[np.newaxis], axis=0)[0]


def _four(pixels: np.ndarray, nodata: float) -> np.ndarray:
    """(4, rows, columns) of each two by two; beyond the edge nothing is known."""
    rows, columns = pixels.shape
    even = np.pad(pixels, ((0, rows % 2), (0, columns % 2)), constant_values=nodata)
    return np.stack([even[row::2, column::2] for row in (0, 1) for column in (0, 1)])
