"""Rasters that stay open: single images measured for themselves, and many windows of one raster in one thread."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Callable

import numpy as np
from osgeo import gdal, gdal_array

from . import limits
from .band_names import has_colours
from .band_roles import band_roles
from .datasets import RasterRef, check_bands, gdal_call, open_dataset, split_bands
from .grids import Grid, PixelWindow
from .rasters import Mosaic, describe_dataset


@dataclass(frozen=True)
class PixelImage:
    """A raster that is measured for itself, wherever it lies: a photograph or a scan needs no place on the map."""

    ref: RasterRef
    wkt: str
    """Reference system; empty when neither the file nor its reference names one, or it has no place on the map."""
    grid: Grid | None
    """None when rotated, mirrored or south-up. Without a place on the map one unit is one pixel and (0, 0) the upper
    left corner, as QGIS shows it."""
    columns: int
    rows: int
    ground_sample_distance: float | None
    """Metres on the ground per pixel, the shorter side; None when it has no place on the map."""
    band_names: tuple[str, ...]
    """As in ``Raster``."""
    data_type: str
    """numpy's name of the pixels' type as they are measured, such as ``uint8``."""
    bits: int | None
    """Bits a pixel where the file says it (NBITS), as 12 in 16."""

    @property
    def has_luminance(self) -> bool:
        """Whether there are red, green and blue to mix."""
        return has_colours(self.band_names)

    @property
    def whole(self) -> PixelWindow:
        """All of its pixels."""
        return PixelWindow(0, 0, self.columns, self.rows)


def validity_check(mosaic: Mosaic) -> Callable[[PixelWindow], bool]:
    """A function that says whether the mosaic has enough valid pixels in a window, from every fourth pixel.

    Meant for many windows in one thread: it keeps the mosaic open. Raises RasterError when the mosaic can't be
    read, and so does the function.
    """
    pixels = Pixels(mosaic.ref)

    def is_valid(window: PixelWindow) -> bool:
        invalid = pixels.read(window, 4)[1]
        return invalid is None or bool(invalid.mean() <= limits.MAX_INVALID_SHARE)

    return is_valid


class Pixels:
    """The pixels of a raster that stays open, for many windows in one thread; all reads stay inside the raster.

    Raises RasterError when the raster can't be opened or holds no real values, and so does every read that fails.
    """

    def __init__(self, ref: RasterRef) -> None:
        self._dataset, self._ref = open_dataset(ref), ref
        check_bands(self._dataset, ref)

    def image(self) -> PixelImage:
        """What the raster is."""
        return _image(self._dataset, self._ref)

    def read(self, window: PixelWindow, shrink: int = 1) -> tuple[np.ndarray, np.ndarray | None]:
        """(bands, rows, columns) of the measured bands as they are, and where pixels are invalid (None: nowhere).

        ``shrink``: only every so many-th pixel along both sides, from overviews where there are some.
        """
        inside = (window.column, window.row, window.width, window.height)
        columns, rows = max(1, window.width // shrink), max(1, window.height // shrink)
        data = gdal_call(lambda: self._dataset.ReadAsArray(*inside, buf_xsize=columns, buf_ysize=rows), self._ref)
        return split_bands(self._dataset, data.reshape(self._dataset.RasterCount, rows, columns), inside, self._ref)

    def blocks(self, window: PixelWindow, most_pixels: int) -> Iterator[PixelWindow]:
        """Pieces that together are the window, row by row, each on whole tiles or strips of the file.

        They have about ``most_pixels`` pixels, or one tile or strip where that is larger, so that every one of the
        file is decoded once.
        """
        tile_width, tile_height = self._dataset.GetRasterBand(1).GetBlockSize()
        tile_width = min(tile_width, self._dataset.RasterXSize)
        if tile_width * tile_height > most_pixels:
            wide, high = tile_width, tile_height
        else:
            across = min(max(most_pixels // (tile_width * tile_height), 1), -(-window.width // tile_width))
            wide = across * tile_width
            high = max(most_pixels // (wide * tile_height), 1) * tile_height
        for top in range(window.row // high * high, window.row + window.height, high):
            for left in range(window.column // wide * wide, window.column + window.width, wide):
                column, row = max(left, window.column), max(top, window.row)
                right = min(left + wide, window.column + window.width)
                yield PixelWindow(column, row, right - column, min(top + high, window.row + window.height) - row)


def _image(dataset: gdal.Dataset, ref: RasterRef) -> PixelImage:
    columns, rows = dataset.RasterXSize, dataset.RasterYSize
    band, roles = dataset.GetRasterBand(1), band_roles(dataset)
    kind = "uint8" if roles.palette is not None else np.dtype(gdal_array.GDALTypeCodeToNumericTypeCode(band.DataType))
    bits = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE")
    what = (roles.names, str(kind), int(bits) if bits else None)
    if dataset.GetGeoTransform(can_return_null=True) is None:
        return PixelImage(ref, "", Grid(0.0, 0.0, 1.0, 1.0, columns, rows), columns, rows, None, *what)
    raster = describe_dataset(dataset, ref)
    return PixelImage(ref, raster.wkt, raster.grid, columns, rows, raster.ground_sample_distance, *what)
