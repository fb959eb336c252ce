"""What a raster is, and its clips: the pixels under a window of the mosaic."""
from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from osgeo import gdal

from . import limits, messages
from .band_names import has_colours, measured_bands
from .band_roles import band_roles
from .datasets import GeoTransform, RasterRef, check_bands, gdal_call, open_dataset, split_bands
from .errors import NotCoveredError, RasterError
from .grids import Extent, Grid, PixelWindow
from .reference_systems import extent_on, metres_per_unit, same_coordinates

MAX_SYSTEM_SHIFT_PX = 0.01  # two reference systems whose coordinates agree this closely are one
MAX_SKEW = 1e-6  # of a pixel per pixel: 0.05 px across 50 000 px
MAX_OVERVIEW_PIXELS = 64_000_000  # that may have to be decoded for the sketch's background: about a second


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
        return has_colours(self.band_names)

    @property
    def judged_band(self) -> str:
        """The name of the band that a verdict is taken from: luminance where there is one, else the first."""
        return measured_bands(self.band_names)[0]


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


def describe(ref: RasterRef) -> Raster:
    """Open a raster and say what it is. Raises RasterError when it can't be opened or used."""
    dataset = open_dataset(ref)
    return describe_dataset(dataset, ref)


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
    dataset = open_dataset(ref)
    placed = dataset.GetGeoTransform(can_return_null=True) is not None
    raster = describe_dataset(dataset, ref, None if placed else (0.0, 1.0, 0.0, 0.0, 0.0, -1.0))
    if raster.grid is None:
        raise RasterError(messages.NOT_NORTH_UP(name=ref.name))
    return Mosaic(**vars(raster))


def band_index(ref: RasterRef, number: int) -> int:
    """Where a band of the file, from 1 on, stands among those that are measured.

    Raises RasterError for a band that is not there or holds no values to measure.
    """
    roles = band_roles(open_dataset(ref))
    measured = tuple(range(len(roles.names))) if roles.palette is not None else roles.indices
    if number - 1 not in measured:
        raise RasterError(messages.BAND_NOT_THERE(name=ref.name, band=number, count=len(measured)))
    return measured.index(number - 1)


def nodata_value(ref: RasterRef) -> float | None:
    """The first band's nodata value; None without one. Raises RasterError when the raster can't be opened."""
    dataset = open_dataset(ref)  # a band does not keep it open
    value = dataset.GetRasterBand(1).GetNoDataValue()
    return None if value is None else float(value)


def read_bands(ref: RasterRef, window: PixelWindow) -> tuple[np.ndarray, np.ndarray]:
    """The pixels of a window inside a raster as they are: (bands, rows, columns), and (rows, columns) which are valid.

    Raises RasterError when they can't be read.
    """
    dataset = open_dataset(ref)
    inside = (window.column, window.row, window.width, window.height)
    data = gdal_call(lambda: dataset.ReadAsArray(*inside), ref, messages.NOT_READABLE(name=ref.name))
    bands, invalid = split_bands(dataset, data.reshape(dataset.RasterCount, window.height, window.width), inside, ref)
    return bands, np.ones(bands.shape[1:], bool) if invalid is None else ~invalid


def read_clip(ref: RasterRef, mosaic: Mosaic, window: PixelWindow) -> Clip:
    """The pixels of a raster under a window of the mosaic.

    They are read as they are when the pixel sizes agree to 1 % and the axes are parallel, since resampling
    destroys what is measured; the sub-pixel offset is reported. Otherwise the raster is warped to the
    window's grid, by averaging where it is finer and by cubic convolution where it is not.

    Raises NotCoveredError when more than 0.1 % of the pixels are invalid, RasterError when the raster can't
    be read.
    """
    dataset = open_dataset(ref)
    raster = describe_dataset(dataset, ref)
    if raster.wkt == "":
        raise RasterError(messages.NO_REFERENCE_SYSTEM(name=ref.name))
    if raster.grid is not None and _on_mosaic_system(raster.wkt, mosaic) and _same_pixel_size(raster.grid, mosaic.grid):
        return _clip_as_it_is(dataset, raster, raster.grid, mosaic.grid.window_extent(window), window)
    return _clip_warped(dataset, raster, mosaic, window)


def read_overview(mosaic: Mosaic, extent: Extent, longest_px: int) -> tuple[np.ndarray, np.ndarray, Extent] | None:
    """A small picture of a part of the mosaic: (bands, rows, columns), which pixels are valid, and where it lies.

    None where the part lies outside, or where the file has no overviews and too many pixels would be decoded.
    Raises RasterError when the mosaic can't be read.
    """
    dataset = open_dataset(mosaic.ref)
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
    if window.width * window.height / used**2 > MAX_OVERVIEW_PIXELS:
        return None
    inside = (window.column, window.row, window.width, window.height)
    size = {"buf_xsize": max(1, round(window.width / reduction)), "buf_ysize": max(1, round(window.height / reduction))}
    data = gdal_call(lambda: dataset.ReadAsArray(*inside, **size), mosaic.ref)
    data = data.reshape(dataset.RasterCount, *tuple(size.values())[::-1])
    bands, invalid = split_bands(dataset, data, inside, mosaic.ref)
    valid = np.ones(bands.shape[1:], bool) if invalid is None else ~invalid
    return bands, valid, grid.window_extent(window)


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
    finest = (1 - limits.MAX_PIXEL_SIZE_DIFFERENCE) * mosaic.ground_sample_distance
    if band_roles(dataset).palette is not None:
        dataset = gdal_call(lambda: _palette_expanded(dataset), raster.ref)
    warped = gdal_call(
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
    if whole.shared_pixels(window) < (1 - limits.MAX_INVALID_SHARE) * pixels:
        raise NotCoveredError(messages.NOT_COVERED(name=name))
    left, top = max(window.column, 0), max(window.row, 0)
    right, bottom = min(window.column + window.width, whole.width), min(window.row + window.height, whole.height)
    inside = (left, top, right - left, bottom - top)
    data = np.atleast_3d(gdal_call(lambda: dataset.ReadAsArray(*inside), raster.ref, messages.NOT_READABLE(name=name)))
    data = data.reshape(dataset.RasterCount, inside[3], inside[2])
    bands, invalid = split_bands(dataset, data, inside, raster.ref)
    if inside[2:] != (window.width, window.height):
        margins = ((top - window.row, window.row + window.height - bottom), (left - window.column, 0))
        margins = (margins[0], (margins[1][0], window.column + window.width - right))
        bands = np.pad(bands, ((0, 0), *margins))
        invalid = np.pad(np.zeros(inside[3:1:-1], bool) if invalid is None else invalid, margins, constant_values=True)
    if invalid is None:
        return bands, 0.0
    share = np.count_nonzero(invalid) / pixels
    if share > limits.MAX_INVALID_SHARE:
        raise NotCoveredError(messages.TOO_MANY_INVALID(name=name, share=share, most=limits.MAX_INVALID_SHARE))
    bands = np.array(bands)
    for band in bands:
        mean = band[~invalid].mean(dtype=np.float64)
        band[invalid] = mean if bands.dtype.kind == "f" else np.rint(mean)
    return bands, share


def describe_dataset(dataset: gdal.Dataset, ref: RasterRef, place: GeoTransform | None = None) -> Raster:
    """What an open dataset is; ``place`` goes before its own. Raises RasterError when it can't be used."""
    check_bands(dataset, ref)
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
    upright = max(abs(transform[2]), abs(transform[4])) < MAX_SKEW * finest
    grid = None
    if upright and transform[1] > 0 > transform[5]:
        grid = Grid(
            transform[0], transform[3], transform[1], -transform[5], columns, rows, metres_x, metres_y
        )
    return Raster(ref, wkt, grid, extent, min(pixel_width, pixel_height), band_roles(dataset).names)


def _on_mosaic_system(wkt: str, mosaic: Mosaic) -> bool:
    tolerance = MAX_SYSTEM_SHIFT_PX * mosaic.grid.pixel_width
    return same_coordinates(wkt, mosaic.wkt, mosaic.extent, tolerance)


def _same_pixel_size(a: Grid, b: Grid) -> bool:
    scales = a.pixel_width / b.pixel_width, a.pixel_height / b.pixel_height
    return max(abs(scale - 1) for scale in scales) <= limits.MAX_PIXEL_SIZE_DIFFERENCE
