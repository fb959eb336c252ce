"""Clips: the pixels of a raster under a window of the mosaic, and small pictures of the mosaic itself.

Drawn windows are rectangles on the map, laid on the pixels of images in any reference system.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from osgeo import gdal
from scipy import ndimage

from . import limits, messages
from .errors import Exceeding, NotCoveredError, RasterError, WindowError
from .gdal_calls import gdal_call, gdal_pixels
from .grids import Extent, Grid, NumberedWindow, PixelWindow, snap_window
from .open_raster import OpenRaster, PixelBlock, damaged, placed
from .rasters import Raster
from .reference_systems import extent_on, same_coordinates


@dataclass(frozen=True)
class DrawnWindow(NumberedWindow):
    """A rectangle to be measured on every image under it."""

    extent: Extent
    """In ``wkt``."""
    wkt: str
    """Reference system; empty when unknown, and then the images' own is assumed."""


def pixels_under(drawn: DrawnWindow, image: Raster, levels: int = 0) -> PixelWindow | None:
    """The pixels of an image under a window, cut to the image and to multiples of ``2 ** levels``; None where the
    image does not show it.

    Raises WindowError when the image is rotated, or too few or too many pixels are under it.
    """
    if not image.is_north_up:
        raise WindowError(messages.WINDOW_IMAGE_ROTATED(name=image.ref.name))
    extent = extent_on_image(drawn.extent, drawn.wkt, image)
    if extent is None or not shown_share(image.grid, extent):
        return None
    return snap_window(image.grid, extent, levels)


def extent_on_image(extent: Extent, wkt: str, image: Raster) -> Extent | None:
    """An extent in the image's reference system; None where it can't be transformed there."""
    if not wkt or not image.wkt or not image.has_place:
        return extent
    try:
        return extent_on(extent, wkt, image.wkt)
    except RasterError:
        return None


def shown_share(grid: Grid, extent: Extent) -> float:
    """How much of an extent a grid covers."""
    shared = shared_extent(grid.extent, extent)
    whole = (extent[2] - extent[0]) * (extent[3] - extent[1])
    return (shared[2] - shared[0]) * (shared[3] - shared[1]) / whole if shared is not None and whole > 0 else 0.0


def shared_extent(a: Extent, b: Extent) -> Extent | None:
    xmin, ymin, xmax, ymax = max(a[0], b[0]), max(a[1], b[1]), min(a[2], b[2]), min(a[3], b[3])
    return (xmin, ymin, xmax, ymax) if xmin < xmax and ymin < ymax else None


MAX_SYSTEM_SHIFT_PX = 0.01  # two reference systems whose coordinates agree this closely are one
MAX_MISSING_SHARE = 0.995  # of the window: a source that covers less of it can't be told from others there
HOLE_PX = 8  # side of a square without pixels that is a hole
PAD_PX = 64
"""Side of a square that is wholly of a pad, px: 6 m at 0.1 m, more than shadows without any light. At the edge of what
was read, beyond which it goes on, half of it."""
BESIDE_PX = 8
"""Pixels beside a pad that a square of JPEG may share with it."""
_MOST_OFF = 3  # DN of 8 bit, off black or white: what JPEG 60 leaves of pads
MANY_PIXELS = 4096 * 512  # of a window: more than any that is inspected by itself
MAX_OVERVIEW_PIXELS = 64_000_000  # that may have to be decoded for the sketch's background: about a second


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
    valid: np.ndarray | None = None
    """(rows, columns) bool: where it has pixels, when it covers the window only partly."""


def read_clip(
    source: OpenRaster, mosaic: Raster, window: PixelWindow, partly: bool = False, holes: bool = False
) -> Clip:
    """The pixels of a raster under a window of the mosaic.

    They are read as they are when the pixel sizes agree to 1 % and the axes are parallel, since resampling
    destroys what is measured; the sub-pixel offset is reported. Otherwise the raster is warped to the
    window's grid, by averaging where it is finer and by cubic convolution where it is not. With ``holes`` ``valid``
    tells of small ones, too: of a large window they are a share that would be passed over.

    Raises NotCoveredError when more than 0.1 % of the pixels are invalid, or with ``partly`` when all but 0.5 % are;
    RasterError when the raster can't be read.
    """
    raster, grid = placed(source.raster), mosaic.grid
    if (
        raster.is_north_up
        and same_coordinates(raster.wkt, mosaic.wkt, mosaic.extent, MAX_SYSTEM_SHIFT_PX * grid.pixel_width)
        and abs(raster.grid.pixel_width / grid.pixel_width - 1) <= limits.MAX_PIXEL_SIZE_DIFFERENCE
        and abs(raster.grid.pixel_height / grid.pixel_height - 1) <= limits.MAX_PIXEL_SIZE_DIFFERENCE
    ):
        return _clip_as_it_is(source, grid.window_extent(window), window, partly, holes)
    return _clip_warped(source, mosaic, window, partly, holes)


def read_overview(mosaic: Raster, extent: Extent, longest_px: int) -> tuple[PixelBlock, Extent] | None:
    """A small picture of a part of the mosaic, and where it lies.

    None where the part lies outside, or where the file has no overviews and too many pixels would be decoded.
    Raises RasterError when the mosaic can't be read.
    """
    source, grid = OpenRaster(mosaic.ref), mosaic.grid
    left, right = (grid.column_at(x) for x in (extent[0], extent[2]))
    top, bottom = (grid.row_at(y) for y in (extent[3], extent[1]))
    if not all(map(math.isfinite, (left, right, top, bottom))):
        return None
    left, right = max(math.floor(left), 0), min(math.ceil(right), grid.columns)
    top, bottom = max(math.floor(top), 0), min(math.ceil(bottom), grid.rows)
    if right <= left or bottom <= top:
        return None
    window = PixelWindow(left, top, right - left, bottom - top)
    reduction = max(1.0, max(window.width, window.height) / longest_px)
    first = source.dataset.GetRasterBand(1)
    widths = [first.GetOverview(i).XSize for i in range(first.GetOverviewCount())]
    factors = [1.0, *(grid.columns / width for width in widths)]
    used = max(factor for factor in factors if factor <= reduction * 1.01)  # what GDAL takes for this reduction
    if window.width * window.height / used**2 > MAX_OVERVIEW_PIXELS:
        return None
    size = max(1, round(window.width / reduction)), max(1, round(window.height / reduction))
    return source.read(window, size), grid.window_extent(window)


def _clip_as_it_is(source: OpenRaster, extent: Extent, window: PixelWindow, partly: bool, holes: bool) -> Clip:
    grid, (xmin, ymin, xmax, ymax) = source.raster.grid, extent
    column = grid.column_at((xmin + xmax) / 2) - window.width / 2
    row = grid.row_at((ymin + ymax) / 2) - window.height / 2
    under = replace(window, column=round(column), row=round(row))
    bands, invalid_share, valid = _read_valid(source, under, partly, holes)
    # Six decimals: below that it is rounding of coordinates of millions of metres.
    offsets = round(column - under.column, 6), round(row - under.row, 6)
    return Clip(source.raster, bands, invalid_share, *offsets, valid=valid)


def _clip_warped(source: OpenRaster, mosaic: Raster, window: PixelWindow, partly: bool, holes: bool) -> Clip:
    raster, failure = source.raster, messages.NOT_READABLE(name=source.ref.name)
    extent = mosaic.grid.window_extent(window)
    extent_on(extent, mosaic.wkt, raster.wkt)  # raises with the reason when GDAL can't
    finest = (1 - limits.MAX_PIXEL_SIZE_DIFFERENCE) * mosaic.ground_sample_distance
    times = mosaic.ground_sample_distance / raster.ground_sample_distance if raster.ground_sample_distance else math.inf
    if window.width * window.height * times**2 > limits.MAX_AVERAGED_PIXELS:
        raise RasterError(messages.MUCH_FINER(name=source.ref.name, times=times))
    expanded = None if source.roles.palette is None else gdal_call(lambda: _palette_expanded(source.dataset), failure)
    warped = source.fetched(lambda dataset: gdal_pixels(
        lambda: gdal.Warp(
            "", dataset if expanded is None else expanded, format="MEM", srcSRS=raster.wkt, dstSRS=mosaic.wkt,
            outputBounds=extent, width=window.width, height=window.height, dstAlpha=True,
            warpOptions=["UNIFIED_SRC_NODATA=YES"],
            resampleAlg="average" if raster.ground_sample_distance < finest else "cubic",
        ),
        failure,
        partial(damaged, source.ref.name, PixelWindow(0, 0, source.columns, source.rows)),
    ))
    used = source.dataset if expanded is None else expanded
    for number in range(1, used.RasterCount + 1):  # GDAL keeps no roles when it adds alpha
        band, kept = used.GetRasterBand(number), warped.GetRasterBand(number)
        kept.SetColorInterpretation(band.GetColorInterpretation())
        kept.SetDescription(band.GetDescription())
    made = OpenRaster(source.ref, warped)
    whole = PixelWindow(0, 0, window.width, window.height)
    bands, invalid_share, valid = _read_valid(made, whole, partly, holes, source)
    return Clip(raster, bands, invalid_share, resampled=True, valid=valid)


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


def _read_valid(
    source: OpenRaster, window: PixelWindow, partly: bool, holes: bool, padded: OpenRaster | None = None
) -> tuple[np.ndarray, float, np.ndarray | None]:
    """The bands of a pixel window, invalid pixels filled, the share of those, and where it is valid if only partly;
    ``padded``: the raster whose corners tell of pads, where that is another one.

    Raises NotCoveredError when there are too many, RasterError when the file ends before its pixels do.
    """
    name, pixels = source.ref.name, window.width * window.height
    most = MAX_MISSING_SHARE if partly else limits.MAX_INVALID_SHARE
    inside = window.cut_to(source.columns, source.rows)
    if min(inside.width, inside.height) <= 0 or inside.width * inside.height < (1 - most) * pixels:
        raise NotCoveredError(messages.NOT_COVERED(name=name))
    bands, invalid = source.read(inside)
    if _may_have_pads(bands) and (values := _pad_values(padded or source)):
        beside = _pads(bands, values)
        invalid = beside if invalid is None else invalid | beside
    if inside != window:
        margins = window.margins_of(inside)
        bands = np.pad(bands, ((0, 0), *margins))
        invalid = np.zeros((inside.height, inside.width), bool) if invalid is None else invalid
        invalid = np.pad(invalid, margins, constant_values=True)
    if invalid is None:
        return bands, 0.0, None
    share = int(np.count_nonzero(invalid)) / pixels
    if share > most:
        raise NotCoveredError(messages.TOO_MANY_INVALID(name=name, share=Exceeding(share, most), most=most))
    valid = ~invalid
    # Of a large window samples tell the mean as well.
    some = np.s_[::8, ::8] if pixels > MANY_PIXELS and valid[::8, ::8].any() else np.s_[:, :]
    known = valid[some]
    bands = np.require(bands, requirements="W")
    for band in bands:
        mean = band[some][known].mean(dtype=np.float64)
        np.copyto(band, mean if bands.dtype.kind == "f" else np.rint(mean), where=invalid, casting="unsafe")
    is_told = share > limits.MAX_INVALID_SHARE or (holes and _has_hole(invalid))
    return bands, share, valid if is_told else None


def _may_have_pads(bands: np.ndarray) -> bool:
    """Whether any of the places that a pad in these bands, (bands, rows, columns), can't miss is black or white."""
    if bands.dtype.kind != "u":
        return False
    few = bands[:, :: PAD_PX // 2, :: PAD_PX // 2]
    return bool(_is_of(few, 0).any() or _is_of(few, int(np.iinfo(bands.dtype).max)).any())


def _pad_values(source: OpenRaster) -> tuple[int, ...]:
    """Values of pads around an image that its file doesn't name, or that a codec changed: black or white, where one of
    its corners is wholly of that."""
    if not (source.is_all_valid or source.raster.is_lossy) or source.corners[0].dtype.kind != "u":
        return ()
    values = 0, int(np.iinfo(source.corners[0].dtype).max)
    return tuple(value for value in values if any(_is_of(corner, value).all() for corner in source.corners))


def _pads(bands: np.ndarray, values: Sequence[int]) -> np.ndarray:
    """Pads of these values that reach the edge of the bands (bands, rows, columns), with what JPEG's squares share with
    them, (rows, columns) bool."""
    padded = np.zeros(bands.shape[1:], bool)
    for value in values:
        alike = _is_of(bands, value)
        large = ndimage.grey_opening(alike.view(np.uint8), size=PAD_PX) > 0
        if not large.any():
            continue
        parts, _ = ndimage.label(alike)
        at_edge = np.concatenate([parts[[0, -1]].ravel(), parts[:, [0, -1]].ravel()])
        pad = np.isin(parts, np.intersect1d(parts[large], at_edge))
        is_exact = (bands[:, pad] == value).all()
        padded |= pad if is_exact else ndimage.maximum_filter(pad, size=2 * BESIDE_PX + 1)
    return padded


def _is_of(bands: np.ndarray, value: int) -> np.ndarray:
    off = _MOST_OFF if bands.dtype == np.uint8 else 0
    return np.asarray((bands <= off if value == 0 else bands >= value - off).all(axis=0))


def _has_hole(invalid: np.ndarray) -> bool:
    """Whether more than single pixels lack somewhere; those may be dark ground that has the value of no data."""
    rows, columns = (length // HOLE_PX * HOLE_PX for length in invalid.shape)
    across = np.logical_and.reduceat(invalid[:rows, :columns], np.arange(0, columns, HOLE_PX), axis=1)
    return bool(across.reshape(rows // HOLE_PX, HOLE_PX, columns // HOLE_PX).all(axis=1).any())
