"""The one place that opens rasters and reads pixels.

A raster is named by a plain ``RasterRef``; every read opens its own dataset, so references can cross
threads and processes, and a file that changes on disk is read as it is now.
"""
from __future__ import annotations

import math
import os
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Callable

import numpy as np
from osgeo import gdal, gdal_array

from . import messages, thresholds
from .bands import BandRoles, band_roles
from .errors import NotCoveredError, RasterError
from .messages import Message
from .quiet import quiet
from .systems import extent_on, metres_per_unit, same_coordinates
from .windows import Extent, Grid, PixelWindow

GeoTransform = tuple[float, float, float, float, float, float]

UNREFERENCED: GeoTransform = (0.0, 1.0, 0.0, 0.0, 0.0, -1.0)
"""Where QGIS puts a raster without a place on the map: x is the column, y the row downwards, so negative."""


@dataclass(frozen=True)
class RasterRef:
    """Where a raster is, in plain data."""

    path: str
    """What GDAL opens."""
    wkt: str = ""
    """Reference system to assume where the file itself names none."""

    @property
    def name(self) -> str:
        """File name without its folder."""
        return os.path.basename(self.path) or self.path


@dataclass(frozen=True)
class Raster:
    """What there is to know about a raster before its pixels are read."""

    ref: RasterRef
    wkt: str
    """Reference system; empty when neither the file nor its reference names one."""
    grid: Grid | None
    """None when the raster is rotated, mirrored or south-up."""
    extent: Extent
    """Bounding box in the raster's own reference system."""
    ground_sample_distance: float
    """Metres on the ground per pixel, the shorter side."""
    band_names: tuple[str, ...]
    """``red``, ``green``, ``blue`` first where all three are there, ``nir``, ``band_N``; no alpha."""

    @property
    def has_luminance(self) -> bool:
        """Whether there are red, green and blue to mix."""
        return self.band_names[:3] == ("red", "green", "blue")


@dataclass(frozen=True)
class Mosaic(Raster):
    """A raster whose pixel grid windows can lie on."""

    grid: Grid

    @property
    def has_place(self) -> bool:
        """Whether it lies on the ground; a raster without georeference lies on its own pixels."""
        return bool(self.wkt) or (self.grid.left, self.grid.top, self.grid.pixel_width) != (0, 0, 1)


@dataclass(frozen=True)
class Clip:
    """The pixels of one raster inside a window of the mosaic, on that raster's own grid."""

    raster: Raster
    bands: np.ndarray
    """(bands, rows, columns) in the raster's data type; the few invalid pixels hold the valid ones' mean."""
    invalid_share: float
    """Share of pixels that were filled."""
    offset_x: float = 0.0
    """How far the window lies to the right of the clip's pixels, px, within half a pixel."""
    offset_y: float = 0.0
    """How far the window lies below the clip's pixels, px."""
    resampled: bool = False
    """Whether the pixels had to be warped to the mosaic's grid."""


@dataclass(frozen=True)
class Image:
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
        return self.band_names[:3] == ("red", "green", "blue")

    @property
    def whole(self) -> PixelWindow:
        """All of its pixels."""
        return PixelWindow(0, 0, self.columns, self.rows)


def describe(ref: RasterRef) -> Raster:
    """Open a raster and say what it is. Raises RasterError when it can't be opened or used."""
    dataset = _open(ref)
    return _describe(dataset, ref)


def describe_mosaic(ref: RasterRef) -> Mosaic:
    """Like ``describe``, for the raster whose grid the windows lie on: north-up and with a reference system."""
    raster = describe(ref)
    if not raster.wkt:
        raise RasterError(messages.NO_REFERENCE_SYSTEM(name=ref.name))
    if raster.grid is None:
        raise RasterError(messages.NOT_NORTH_UP(name=ref.name))
    return Mosaic(**vars(raster))


def describe_picture(ref: RasterRef) -> Mosaic:
    """Like ``describe_mosaic``, for a raster that may lie anywhere: it needs no reference system, and one without any
    georeference lies as QGIS shows it, a unit a pixel, from (0, 0) to the right and down."""
    dataset = _open(ref)
    placed = dataset.GetGeoTransform(can_return_null=True) is not None
    raster = _describe(dataset, ref, None if placed else (0.0, 1.0, 0.0, 0.0, 0.0, -1.0))
    if raster.grid is None:
        raise RasterError(messages.NOT_NORTH_UP(name=ref.name))
    return Mosaic(**vars(raster))


def band_index(ref: RasterRef, number: int) -> int:
    """Where a band of the file, from 1 on, stands among those that are measured.

    Raises RasterError for a band that is not there or holds no values to measure.
    """
    roles = band_roles(_open(ref))
    measured = tuple(range(len(roles.names))) if roles.palette is not None else roles.indices
    if number - 1 not in measured:
        raise RasterError(messages.BAND_NOT_THERE(name=ref.name, band=number, count=len(measured)))
    return measured.index(number - 1)


def nodata_value(ref: RasterRef) -> float | None:
    """The first band's nodata value; None without one. Raises RasterError when the raster can't be opened."""
    dataset = _open(ref)  # a band does not keep it open
    value = dataset.GetRasterBand(1).GetNoDataValue()
    return None if value is None else float(value)


def read_bands(ref: RasterRef, window: PixelWindow) -> tuple[np.ndarray, np.ndarray]:
    """The pixels of a window inside a raster as they are: (bands, rows, columns), and (rows, columns) which are valid.

    Raises RasterError when they can't be read.
    """
    dataset = _open(ref)
    inside = (window.column, window.row, window.width, window.height)
    data = _gdal(lambda: dataset.ReadAsArray(*inside), ref, messages.NOT_READABLE(name=ref.name))
    bands, invalid = _split(dataset, data.reshape(dataset.RasterCount, window.height, window.width), inside, ref)
    return bands, np.ones(bands.shape[1:], bool) if invalid is None else ~invalid


def read_clip(ref: RasterRef, mosaic: Mosaic, window: PixelWindow) -> Clip:
    """The pixels of a raster under a window of the mosaic.

    They are read as they are when the pixel sizes agree to 1 % and the axes are parallel, since resampling
    destroys what is measured; the sub-pixel offset is reported. Otherwise the raster is warped to the
    window's grid, by averaging where it is finer and by cubic convolution where it is not.

    Raises NotCoveredError when more than 0.1 % of the pixels are invalid, RasterError when the raster can't
    be read.
    """
    dataset = _open(ref)
    raster = _describe(dataset, ref)
    if raster.wkt == "":
        raise RasterError(messages.NO_REFERENCE_SYSTEM(name=ref.name))
    if raster.grid is not None and _on_mosaic_system(raster.wkt, mosaic) and _same_pixel_size(raster.grid, mosaic.grid):
        return _clip_as_it_is(dataset, raster, raster.grid, mosaic.grid.window_extent(window), window)
    return _clip_warped(dataset, raster, mosaic, window)


def validity_check(mosaic: Mosaic) -> Callable[[PixelWindow], bool]:
    """A function that says whether the mosaic has enough valid pixels in a window, from every fourth pixel.

    Meant for many windows in one thread: it keeps the mosaic open. Raises RasterError when the mosaic can't be
    read, and so does the function.
    """
    pixels = Pixels(mosaic.ref)

    def is_valid(window: PixelWindow) -> bool:
        invalid = pixels.read(window, 4)[1]
        return invalid is None or bool(invalid.mean() <= thresholds.MAX_INVALID_SHARE)

    return is_valid


def read_overview(mosaic: Mosaic, extent: Extent, longest_px: int) -> tuple[np.ndarray, np.ndarray, Extent] | None:
    """A small picture of a part of the mosaic: (bands, rows, columns), which pixels are valid, and where it lies.

    None where the part lies outside, or where the file has no overviews and too many pixels would be decoded.
    Raises RasterError when the mosaic can't be read.
    """
    dataset = _open(mosaic.ref)
    grid = mosaic.grid
    left, right = ((x - grid.left) / grid.pixel_width for x in (extent[0], extent[2]))
    top, bottom = ((grid.top - y) / grid.pixel_height for y in (extent[3], extent[1]))
    left, right = max(math.floor(left), 0), min(math.ceil(right), grid.columns)
    top, bottom = max(math.floor(top), 0), min(math.ceil(bottom), grid.rows)
    if right <= left or bottom <= top:
        return None
    window = PixelWindow(left, top, right - left, bottom - top)
    reduction = max(1.0, max(window.width, window.height) / longest_px)
    first = dataset.GetRasterBand(1)
    widths = [first.GetOverview(i).XSize for i in range(first.GetOverviewCount())]
    factors = [1.0, *(grid.columns / width for width in widths)]
    used = max(factor for factor in factors if factor <= reduction * 1.01)  # what GDAL takes for this reduction
    if window.width * window.height / used**2 > thresholds.MAX_OVERVIEW_PIXELS:
        return None
    inside = (window.column, window.row, window.width, window.height)
    size = {"buf_xsize": max(1, round(window.width / reduction)), "buf_ysize": max(1, round(window.height / reduction))}
    data = _gdal(lambda: dataset.ReadAsArray(*inside, **size), mosaic.ref)
    bands, invalid = _split(dataset, data.reshape(dataset.RasterCount, *tuple(size.values())[::-1]), inside, mosaic.ref)
    valid = np.ones(bands.shape[1:], bool) if invalid is None else ~invalid
    return bands, valid, grid.window_extent(window)
class Pixels:
    """The pixels of a raster that stays open, for many windows in one thread; all reads stay inside the raster.

    Raises RasterError when the raster can't be opened or holds no real values, and so does every read that fails.
    """

    def __init__(self, ref: RasterRef) -> None:
        self._dataset, self._ref = _open(ref), ref
        _check_bands(self._dataset, ref)

    def image(self) -> Image:
        """What the raster is."""
        return _image(self._dataset, self._ref)

    def read(self, window: PixelWindow, shrink: int = 1) -> tuple[np.ndarray, np.ndarray | None]:
        """(bands, rows, columns) of the measured bands as they are, and where pixels are invalid (None: nowhere).

        ``shrink``: only every so many-th pixel along both sides, from overviews where there are some.
        """
        inside = (window.column, window.row, window.width, window.height)
        columns, rows = max(1, window.width // shrink), max(1, window.height // shrink)
        data = _gdal(lambda: self._dataset.ReadAsArray(*inside, buf_xsize=columns, buf_ysize=rows), self._ref)
        return _split(self._dataset, data.reshape(self._dataset.RasterCount, rows, columns), inside, self._ref)

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


class Photo:
    """A raster whose place on the map does not matter, read as grey values; it stays open as long as this lives.

    Meant for one thread. Colour becomes luminance, a palette its colours' luminance; of other bands the first
    counts, alpha never. Invalid pixels hold the mean of the valid ones around.
    """

    def __init__(self, ref: RasterRef) -> None:
        """Raises RasterError when the raster can't be opened or used."""
        self.ref = ref
        self._dataset = _open(ref)
        _check_bands(self._dataset, ref)
        self.columns, self.rows = self._dataset.RasterXSize, self._dataset.RasterYSize
        transform = self._dataset.GetGeoTransform(can_return_null=True)
        self.geotransform: GeoTransform = transform or UNREFERENCED
        """From columns and rows to map coordinates."""
        self.is_referenced = transform is not None
        self.wkt: str = self._dataset.GetProjection() or ref.wkt
        roles = band_roles(self._dataset)
        bit = self._dataset.GetRasterBand(1).GetMetadataItem("NBITS", "IMAGE_STRUCTURE") == "1"
        self._averaged_by_us = roles.palette is not None or bit  # GDAL would average to the nearest of two values

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
        step = max(1, thresholds.STRIP_PIXELS // (self.columns * factor))
        for row in range(0, rows, step):
            count = min(step, rows - row)
            strip = self._read((0, row * factor, columns * factor, count * factor))
            made[row : row + count] = strip.reshape(count, factor, columns, factor).mean(axis=(1, 3))
        return made

    def strips(self, margin: int, grey: bool) -> Iterator[Strip]:
        """The photo from top to bottom, mirrored by ``margin`` px at its upper and lower edge, float64.

        Invalid pixels hold the mean of the valid ones of their strip.
        """
        step = max(1, thresholds.STRIP_PIXELS // self.columns)
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
        return float(_gdal(lambda: band.ComputeRasterMinMax(False), self.ref)[1])

    def writer(self, path: str, dtype: np.dtype, bands: int) -> RasterWriter:
        """A GeoTIFF of the photo's size and place to be filled."""
        return RasterWriter(path, self, dtype, bands)

    def _bands(self, inside: tuple[int, int, int, int], size: tuple[int, int]) -> tuple[np.ndarray, np.ndarray | None]:
        failure = messages.NOT_READABLE(name=self.ref.name)
        options = {"buf_xsize": size[0], "buf_ysize": size[1], "resample_alg": gdal.GRIORA_Average}
        data = _gdal(lambda: self._dataset.ReadAsArray(*inside, **options), self.ref, failure)
        return _split(self._dataset, data.reshape(-1, size[1], size[0]), inside, self.ref)

    def _read(self, inside: tuple[int, int, int, int], size: tuple[int, int] | None = None) -> np.ndarray:
        size = size or inside[2:]
        bands, invalid = self._bands(inside, size)
        names = band_roles(self._dataset).names
        grey = luminance(bands) if names[:3] == ("red", "green", "blue") else bands[0].astype(np.float32)
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


class RasterWriter:
    """A GeoTIFF on another raster's grid, written strip by strip. Used with ``with``, which closes it."""

    def __init__(self, path: str, like: Photo, dtype: np.dtype, bands: int) -> None:
        """Raises RasterError where no file can be."""
        self._ref = RasterRef(path)
        kind = gdal_array.NumericTypeCodeToGDALTypeCode(dtype.type)
        options = ["TILED=YES", "COMPRESS=DEFLATE", "BIGTIFF=IF_SAFER"]
        self._dataset = _gdal(
            lambda: gdal.GetDriverByName("GTiff").Create(path, like.columns, like.rows, bands, kind, options),
            self._ref, messages.RASTER_NOT_WRITTEN(path=path),
        )
        if like.is_referenced:
            self._dataset.SetGeoTransform(like.geotransform)
        if like.wkt:
            self._dataset.SetProjection(like.wkt)
        self._mask: gdal.Band | None = None

    def __enter__(self) -> RasterWriter:
        return self

    def __exit__(self, *exception: object) -> None:
        with quiet():
            self._dataset.FlushCache()
        self._mask = self._dataset = None

    def write(self, row: int, pixels: np.ndarray, invalid: np.ndarray | None) -> None:
        """(bands, rows, columns) from a row on; invalid pixels are masked. Raises RasterError when the disk is full."""
        failure = messages.RASTER_NOT_WRITTEN(path=self._ref.path)
        for number, band in enumerate(pixels, 1):
            write = self._dataset.GetRasterBand(number).WriteArray
            if _gdal(partial(write, band, 0, row), self._ref, failure) != 0:
                raise RasterError(failure)
        if invalid is None and self._mask is None:
            return
        if self._mask is None:
            self._dataset.CreateMaskBand(gdal.GMF_PER_DATASET)  # a file beside the TIFF
            self._mask = self._dataset.GetRasterBand(1).GetMaskBand()
            self._mask.Fill(255)
        if invalid is not None:
            self._mask.WriteArray(np.where(invalid, 0, 255).astype(np.uint8), 0, row)


def luminance(bands: np.ndarray) -> np.ndarray:
    """(rows, columns) float32 of red, green and blue."""
    red, green, blue = (np.float32(weight) for weight in thresholds.LUMINANCE_WEIGHTS)
    return np.asarray(red * bands[0] + green * bands[1] + blue * bands[2], dtype=np.float32)


def _clip_as_it_is(dataset: gdal.Dataset, raster: Raster, grid: Grid, extent: Extent, window: PixelWindow) -> Clip:
    xmin, ymin, xmax, ymax = extent
    column = ((xmin + xmax) / 2 - grid.left) / grid.pixel_width - window.width / 2
    row = (grid.top - (ymin + ymax) / 2) / grid.pixel_height - window.height / 2
    own = replace(window, column=round(column), row=round(row))
    bands, invalid_share = _read_valid(dataset, raster, own)
    # Six decimals: below that it is rounding of coordinates of millions of metres.
    return Clip(raster, bands, invalid_share, round(column - own.column, 6), round(row - own.row, 6))


def _clip_warped(dataset: gdal.Dataset, raster: Raster, mosaic: Mosaic, window: PixelWindow) -> Clip:
    extent_on(mosaic.grid.window_extent(window), mosaic.wkt, raster.wkt)  # raises with the reason when GDAL can't
    finest = (1 - thresholds.MAX_PIXEL_SIZE_DIFFERENCE) * mosaic.ground_sample_distance
    if band_roles(dataset).palette is not None:
        dataset = _gdal(lambda: _palette_expanded(dataset), raster.ref)
    warped = _gdal(
        lambda: gdal.Warp(
            "",
            dataset,
            format="MEM",
            srcSRS=raster.wkt,
            dstSRS=mosaic.wkt,
            outputBounds=mosaic.grid.window_extent(window),
            width=window.width,
            height=window.height,
            resampleAlg="average" if raster.ground_sample_distance < finest else "cubic",
            dstAlpha=True,
            warpOptions=["UNIFIED_SRC_NODATA=YES"],
        ),
        raster.ref,
    )
    for i in range(dataset.RasterCount):  # GDAL keeps no roles when it adds alpha
        warped.GetRasterBand(i + 1).SetColorInterpretation(dataset.GetRasterBand(i + 1).GetColorInterpretation())
    bands, invalid_share = _read_valid(warped, raster, PixelWindow(0, 0, window.width, window.height))
    return Clip(raster, bands, invalid_share, resampled=True)


def _palette_expanded(dataset: gdal.Dataset) -> gdal.Dataset | None:
    """A paletted dataset as red, green and blue, and alpha where entries are transparent, as nodata then is."""
    band = dataset.GetRasterBand(1)
    table, nodata = band.GetColorTable().Clone(), band.GetNoDataValue()
    if nodata is not None and 0 <= nodata < table.GetCount():
        table.SetColorEntry(int(nodata), (*table.GetColorEntry(int(nodata))[:3], 0))
    opaque = all(table.GetColorEntry(i)[3] for i in range(table.GetCount()))
    indices = gdal.Translate("", dataset, format="VRT", noData="none")
    indices.GetRasterBand(1).SetColorTable(table)
    return gdal.Translate("", indices, format="VRT", rgbExpand="rgb" if opaque else "rgba")


def _read_valid(dataset: gdal.Dataset, raster: Raster, window: PixelWindow) -> tuple[np.ndarray, float]:
    """The bands of a pixel window, invalid pixels filled, and the share of those.

    Raises NotCoveredError when there are too many, RasterError when the file ends before its pixels do.
    """
    name, pixels = raster.ref.name, window.width * window.height
    whole = PixelWindow(0, 0, dataset.RasterXSize, dataset.RasterYSize)
    if whole.shared_pixels(window) < (1 - thresholds.MAX_INVALID_SHARE) * pixels:
        raise NotCoveredError(messages.NOT_COVERED(name=name))
    left, top = max(window.column, 0), max(window.row, 0)
    right, bottom = min(window.column + window.width, whole.width), min(window.row + window.height, whole.height)
    inside = (left, top, right - left, bottom - top)
    data = np.atleast_3d(_gdal(lambda: dataset.ReadAsArray(*inside), raster.ref, messages.NOT_READABLE(name=name)))
    data = data.reshape(dataset.RasterCount, inside[3], inside[2])
    bands, invalid = _split(dataset, data, inside, raster.ref)
    if inside[2:] != (window.width, window.height):
        margins = ((top - window.row, window.row + window.height - bottom), (left - window.column, 0))
        margins = (margins[0], (margins[1][0], window.column + window.width - right))
        bands = np.pad(bands, ((0, 0), *margins))
        invalid = np.pad(np.zeros(inside[3:1:-1], bool) if invalid is None else invalid, margins, constant_values=True)
    if invalid is None:
        return bands, 0.0
    share = np.count_nonzero(invalid) / pixels
    if share > thresholds.MAX_INVALID_SHARE:
        raise NotCoveredError(messages.TOO_MANY_INVALID(name=name, share=share, most=thresholds.MAX_INVALID_SHARE))
    bands = np.array(bands)
    for band in bands:
        mean = band[~invalid].mean(dtype=np.float64)
        band[invalid] = mean if bands.dtype.kind == "f" else np.rint(mean)
    return bands, share


def _split(
    dataset: gdal.Dataset, data: np.ndarray, inside: tuple[int, int, int, int], ref: RasterRef
) -> tuple[np.ndarray, np.ndarray | None]:
    """All bands of a dataset into those that are measured and a mask of invalid pixels (None: all are valid)."""
    roles = band_roles(dataset)
    in_order = roles.indices == tuple(range(len(data)))
    bands = data if in_order else data[list(roles.indices)]
    invalid = _nodata_mask(dataset, bands, roles)
    masks = []
    if roles.alpha is not None:
        masks.append(data[roles.alpha] == 0)
    first = dataset.GetRasterBand(1)
    mask_flags = _gdal(first.GetMaskFlags, ref)
    if mask_flags & (gdal.GMF_PER_DATASET | gdal.GMF_ALPHA) == gdal.GMF_PER_DATASET:
        rows, columns = data.shape[1:]
        mask_band = first.GetMaskBand()
        masks.append(_gdal(lambda: mask_band.ReadAsArray(*inside, buf_xsize=columns, buf_ysize=rows), ref) == 0)
    if bands.dtype.kind == "f":
        masks.append(~np.isfinite(bands).all(axis=0))
    if roles.palette is not None:
        indices = np.minimum(bands[0], len(roles.palette) - 1)
        masks.append(roles.palette[indices, 3] == 0)
        bands = np.moveaxis(roles.palette[indices, :3], -1, 0)
    for mask in masks:
        if mask.any():
            invalid = mask if invalid is None else invalid | mask
    return bands, invalid


def _nodata_mask(dataset: gdal.Dataset, bands: np.ndarray, roles: BandRoles) -> np.ndarray | None:
    """Pixels all of whose bands hold their nodata value, or None where there are none."""
    invalid: np.ndarray | None = None
    for band, index in zip(bands, roles.indices):
        nodata = dataset.GetRasterBand(index + 1).GetNoDataValue()
        if nodata is None:
            return None
        with np.errstate(all="ignore"):
            value = np.array(nodata).astype(bands.dtype)
        if bands.dtype.kind != "f" and value != nodata:
            return None  # a value that the data type can't hold
        held = np.isnan(band) if math.isnan(nodata) else band == value
        invalid = held if invalid is None else invalid & held
        if not invalid.any():
            return None
    return invalid


def _check_bands(dataset: gdal.Dataset, ref: RasterRef) -> None:
    if dataset.RasterCount == 0:
        raise RasterError(messages.NO_BANDS(name=ref.name))
    if any(gdal.DataTypeIsComplex(dataset.GetRasterBand(i + 1).DataType) for i in range(dataset.RasterCount)):
        raise RasterError(messages.COMPLEX_VALUES(name=ref.name))


def _image(dataset: gdal.Dataset, ref: RasterRef) -> Image:
    columns, rows = dataset.RasterXSize, dataset.RasterYSize
    band, roles = dataset.GetRasterBand(1), band_roles(dataset)
    kind = "uint8" if roles.palette is not None else np.dtype(gdal_array.GDALTypeCodeToNumericTypeCode(band.DataType))
    bits = band.GetMetadataItem("NBITS", "IMAGE_STRUCTURE")
    what = (roles.names, str(kind), int(bits) if bits else None)
    if dataset.GetGeoTransform(can_return_null=True) is None:
        return Image(ref, "", Grid(0.0, 0.0, 1.0, 1.0, columns, rows), columns, rows, None, *what)
    raster = _describe(dataset, ref)
    return Image(ref, raster.wkt, raster.grid, columns, rows, raster.ground_sample_distance, *what)


def _describe(dataset: gdal.Dataset, ref: RasterRef, place: GeoTransform | None = None) -> Raster:
    _check_bands(dataset, ref)
    transform = place or dataset.GetGeoTransform(can_return_null=True)
    if transform is None or 0 in (transform[1] or transform[2], transform[5] or transform[4]):
        raise RasterError(messages.NOT_GEOREFERENCED(name=ref.name))
    wkt = dataset.GetProjection() or ref.wkt
    columns, rows = dataset.RasterXSize, dataset.RasterYSize
    corners = [gdal.ApplyGeoTransform(transform, x, y) for x in (0, columns) for y in (0, rows)]
    xs, ys = [x for x, _ in corners], [y for _, y in corners]
    extent = (min(xs), min(ys), max(xs), max(ys))
    metres_x, metres_y = metres_per_unit(wkt, (extent[1] + extent[3]) / 2)
    pixel_width = math.hypot(transform[1] * metres_x, transform[4] * metres_y)
    pixel_height = math.hypot(transform[2] * metres_x, transform[5] * metres_y)
    finest = min(abs(transform[1]), abs(transform[5]))
    upright = max(abs(transform[2]), abs(transform[4])) < thresholds.MAX_SKEW * finest
    grid = None
    if upright and transform[1] > 0 > transform[5]:
        grid = Grid(
            transform[0], transform[3], transform[1], -transform[5], columns, rows, metres_x, metres_y
        )
    return Raster(ref, wkt, grid, extent, min(pixel_width, pixel_height), band_roles(dataset).names)


def _on_mosaic_system(wkt: str, mosaic: Mosaic) -> bool:
    tolerance = thresholds.MAX_SYSTEM_SHIFT_PX * mosaic.grid.pixel_width
    return same_coordinates(wkt, mosaic.wkt, mosaic.extent, tolerance)


def _same_pixel_size(a: Grid, b: Grid) -> bool:
    scales = a.pixel_width / b.pixel_width, a.pixel_height / b.pixel_height
    return max(abs(scale - 1) for scale in scales) <= thresholds.MAX_PIXEL_SIZE_DIFFERENCE


def _open(ref: RasterRef) -> gdal.Dataset:
    there = ref.path.startswith("/vsi") or ":" in ref.path or os.path.exists(ref.path)
    failure = messages.NOT_A_RASTER(name=ref.name) if there else messages.NOT_FOUND(path=ref.path)
    return _gdal(lambda: gdal.OpenEx(ref.path, gdal.OF_RASTER | gdal.OF_READONLY), ref, failure)


def _gdal(call: Callable[[], Any], ref: RasterRef, failure: Message | None = None) -> Any:
    """What a GDAL call returns; RasterError when it fails, whether or not GDAL's exceptions are on."""
    with quiet():
        try:
            result = call()
        except RuntimeError:
            result = None
    if result is None:
        raise RasterError(failure or messages.NOT_READABLE(name=ref.name))
    return result


def open_dataset(ref: RasterRef) -> gdal.Dataset:
    """The dataset itself, for GDAL's own operations. Raises RasterError when it can't be opened."""
    return _open(ref)
