"""The one place that opens rasters and reads pixels.

A raster is named by a plain ``RasterRef``; every read opens its own dataset, so references can cross
threads and processes, and a file that changes on disk is read as it is now.
"""
from __future__ import annotations

import math
import os
from dataclasses import dataclass, replace
from typing import Any, Callable

import numpy as np
from osgeo import gdal

from . import messages, thresholds
from .bands import BandRoles, band_roles
from .errors import NotCoveredError, RasterError
from .messages import Message
from .quiet import quiet
from .systems import extent_on, metres_per_unit, same_coordinates
from .windows import Extent, Grid, PixelWindow

GeoTransform = tuple[float, float, float, float, float, float]


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
    dataset = _open(mosaic.ref)

    def is_valid(window: PixelWindow) -> bool:
        inside = (window.column, window.row, window.width, window.height)
        size = {"buf_xsize": max(1, window.width // 4), "buf_ysize": max(1, window.height // 4)}
        data = _gdal(lambda: dataset.ReadAsArray(*inside, **size), mosaic.ref)
        data = data.reshape(dataset.RasterCount, size["buf_ysize"], size["buf_xsize"])
        invalid = _split(dataset, data, inside, mosaic.ref)[1]
        return invalid is None or bool(invalid.mean() <= thresholds.MAX_INVALID_SHARE)

    return is_valid


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


def _describe(dataset: gdal.Dataset, ref: RasterRef) -> Raster:
    if dataset.RasterCount == 0:
        raise RasterError(messages.NO_BANDS(name=ref.name))
    if any(gdal.DataTypeIsComplex(dataset.GetRasterBand(i + 1).DataType) for i in range(dataset.RasterCount)):
        raise RasterError(messages.COMPLEX_VALUES(name=ref.name))
    transform = dataset.GetGeoTransform(can_return_null=True)
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


@dataclass(frozen=True)
class Image:
    """An image as a sensor took it, which may have no place on the map yet."""

    ref: RasterRef
    columns: int
    rows: int
    geotransform: GeoTransform | None
    """None where the file has none."""
    georeferenced: bool
    """Whether a reference system goes with the geotransform."""
    rpc: dict[str, str]
    """GDAL's metadata domain RPC; empty where the image has none."""
    satellite: str
    """What the metadata call the satellite; may be empty."""


def describe_image(ref: RasterRef) -> Image:
    """What there is to know about an image before it is georeferenced. Raises RasterError."""
    dataset = open_dataset(ref)
    if dataset.RasterCount == 0:
        raise RasterError(messages.NO_BANDS(name=ref.name))
    transform = dataset.GetGeoTransform(can_return_null=True)
    about = {**(dataset.GetMetadata() or {}), **(dataset.GetMetadata("IMAGERY") or {})}
    named = next((str(about[key]) for key in ("SATELLITEID", "NITF_ISORCE") if key in about), "")
    return Image(
        ref,
        dataset.RasterXSize,
        dataset.RasterYSize,
        tuple(transform) if transform is not None else None,
        bool(dataset.GetProjection()),
        dict(dataset.GetMetadata("RPC") or {}),
        named,
    )


def open_dataset(ref: RasterRef) -> gdal.Dataset:
    """The dataset itself, for GDAL's own operations. Raises RasterError when it can't be opened."""
    return _open(ref)
