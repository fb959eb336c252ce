"""Photographs and scans, whose place on the map does not matter, as grey values."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from osgeo import gdal, gdal_array

from . import messages
from .band_curves import judged_plane, luminance
from .band_roles import band_roles
from .datasets import GeoTransform, RasterRef, check_bands, gdal_call, open_dataset, split_bands
from .errors import NotCoveredError
from .grids import PixelWindow

STRIP_PIXELS = 4_000_000  # read at a time: 16 MB as float32

UNREFERENCED: GeoTransform = (0.0, 1.0, 0.0, 0.0, 0.0, -1.0)
"""Where QGIS puts a raster without a place on the map: x is the column, y the row downwards, so negative."""


class Photo:
    """A raster whose place on the map does not matter, read as grey values; it stays open as long as this lives.

    Meant for one thread. Colour becomes luminance, a palette its colours' luminance; of other bands the first
    counts, alpha never. Invalid pixels hold the mean of the valid ones around.
    """

    def __init__(self, ref: RasterRef) -> None:
        """Raises RasterError when the raster can't be opened or used."""
        self.ref = ref
        self._dataset = open_dataset(ref)
        check_bands(self._dataset, ref)
        self.columns, self.rows = self._dataset.RasterXSize, self._dataset.RasterYSize
        transform = self._dataset.GetGeoTransform(can_return_null=True)
        self.geotransform: GeoTransform = transform or UNREFERENCED
        """From columns and rows to map coordinates."""
        self.is_referenced = transform is not None
        self.wkt: str = self._dataset.GetProjection() or ref.wkt
        roles = band_roles(self._dataset)
        bit = self._dataset.GetRasterBand(1).GetMetadataItem("NBITS", "IMAGE_STRUCTURE") == "1"
        self._averaged_by_us = roles.palette is not None or bit  # GDAL would average to the nearest of two values

    def contains(self, place: tuple[float, float]) -> bool:
        """Whether a column and row, pixel centres at .5, lie in the photo."""
        return 0 <= place[0] < self.columns and 0 <= place[1] < self.rows

    def grey(self, window: PixelWindow | None = None) -> np.ndarray:
        """(rows, columns) float32 of a window, or of all; what lies outside the photo repeats its edge."""
        window = window or PixelWindow(0, 0, self.columns, self.rows)
        left, top = max(window.column, 0), max(window.row, 0)
        right = min(window.column + window.width, self.columns)
        bottom = min(window.row + window.height, self.rows)
        if right <= left or bottom <= top:
            raise NotCoveredError(messages.NOT_COVERED(name=self.ref.name))
        pixels = self._read((left, top, right - left, bottom - top))
        above, below = top - window.row, window.row + window.height - bottom
        before, after = left - window.column, window.column + window.width - right
        margins = ((above, below), (before, after))
        return np.pad(pixels, margins, mode="edge") if np.any(margins) else pixels

    def reduced(self, factor: int) -> np.ndarray:
        """The whole photo, float32, each pixel the mean of ``factor`` x ``factor``; what is left over is cut off."""
        rows, columns = self.rows // factor, self.columns // factor
        if factor == 1:
            return self.grey()
        if not self._averaged_by_us:
            return self._read((0, 0, columns * factor, rows * factor), (columns, rows))
        made = np.empty((rows, columns), np.float32)
        step = max(1, STRIP_PIXELS // (self.columns * factor))
        for row in range(0, rows, step):
            count = min(step, rows - row)
            strip = self._read((0, row * factor, columns * factor, count * factor))
            made[row : row + count] = strip.reshape(count, factor, columns, factor).mean(axis=(1, 3))
        return made

    def strips(self, margin: int, grey: bool) -> Iterator[Strip]:
        """The photo from top to bottom, mirrored by ``margin`` px at its upper and lower edge, float64.

        Invalid pixels hold the mean of the valid ones of their strip.
        """
        step = max(1, STRIP_PIXELS // self.columns)
        for row in range(0, self.rows, step):
            count = min(step, self.rows - row)
            top, bottom = max(row - margin, 0), min(row + count + margin, self.rows)
            inside = (0, top, self.columns, bottom - top)
            bands, invalid = self._bands(inside, inside[2:])
            pixels = (luminance(bands)[np.newaxis] if grey and len(bands) >= 3 else bands).astype(np.float64)
            if grey:
                pixels = pixels[:1]
            if invalid is not None and not invalid.all():
                pixels[:, invalid] = pixels[:, ~invalid].mean(axis=1, keepdims=True)
            above, below = margin - (row - top), margin - (bottom - row - count)
            if above or below:
                pixels = np.pad(pixels, ((0, 0), (above, below), (0, 0)), mode="symmetric")
            own = None if invalid is None else invalid[row - top : row - top + count]
            yield Strip(row, count, margin, pixels, own)

    @property
    def bands(self) -> int:
        """How many bands there are, alpha left out; three of a palette."""
        return len(band_roles(self._dataset).names)

    @property
    def dtype(self) -> np.dtype:
        """The data type of the pixels."""
        band = self._dataset.GetRasterBand(1)
        return np.dtype(gdal_array.GDALTypeCodeToNumericTypeCode(band.DataType))

    @property
    def largest(self) -> float:
        """The largest value that a pixel can have: by its number of bits, its type, or (float) its largest one."""
        if band_roles(self._dataset).palette is not None:
            return 255.0
        band = self._dataset.GetRasterBand(1)
        bits = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE")
        if bits is not None and self.dtype.kind == "u":
            return float(2 ** int(bits) - 1)
        if self.dtype.kind != "f":
            return float(np.iinfo(self.dtype).max)
        return float(gdal_call(lambda: band.ComputeRasterMinMax(False), self.ref)[1])

    def _bands(self, inside: tuple[int, int, int, int], size: tuple[int, int]) -> tuple[np.ndarray, np.ndarray | None]:
        failure = messages.NOT_READABLE(name=self.ref.name)
        options = {"buf_xsize": size[0], "buf_ysize": size[1], "resample_alg": gdal.GRIORA_Average}
        data = gdal_call(lambda: self._dataset.ReadAsArray(*inside, **options), self.ref, failure)
        return split_bands(self._dataset, data.reshape(-1, size[1], size[0]), inside, self.ref)

    def _read(self, inside: tuple[int, int, int, int], size: tuple[int, int] | None = None) -> np.ndarray:
        size = size or inside[2:]
        bands, invalid = self._bands(inside, size)
        grey = judged_plane(bands, band_roles(self._dataset).names)
        if invalid is not None and not invalid.all():
            grey[invalid] = grey[~invalid].mean()
        return np.nan_to_num(grey, copy=False)


@dataclass(frozen=True)
class Strip:
    """Some rows of a photo with the ones around them."""

    row: int
    """The first of its own rows."""
    rows: int
    """How many are its own."""
    above: int
    """How many rows of ``pixels`` lie above its own, and as many below."""
    pixels: np.ndarray
    """(bands, rows + 2 * above, columns) float64."""
    invalid: np.ndarray | None
    """(rows, columns) of its own invalid pixels; None where all are valid."""
