"""Clips: the pixels of a raster under a window of the mosaic, and small pictures of the mosaic itself.

Drawn windows are rectangles on the map, laid on the pixels of images in any reference system.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from osgeo import gdal, gdal_array
from scipy import ndimage

from . import limits, messages
from .errors import NotCoveredError, RasterError, Stated
from .gdal_calls import gdal_call
from .grids import Extent, NumberedWindow, PixelWindow, middle_of
from .open_raster import OpenRaster, PixelBlock, placed
from .rasters import MAX_SYSTEM_SHIFT_PX, Raster
from .reference_systems import extent_on, same_coordinates


@dataclass(frozen=True)
class DrawnWindow(NumberedWindow):
    """A rectangle to be measured on every image under it."""

    extent: Extent
    """In ``wkt``."""
    wkt: str
    """Reference system; empty when unknown, and then the images' own is assumed."""


def extent_on_image(extent: Extent, wkt: str, image: Raster) -> Extent | None:
    """An extent in the image's reference system; None where it can't be transformed there."""
    if not wkt or not image.wkt or not image.has_place:
        return extent
    try:
        return extent_on(extent, wkt, image.wkt)
    except RasterError:
        return None


MAX_MISSING_SHARE = 0.995  # of the window: a source that covers less of it can't be told from others there
HOLE_PX = 8  # side of a square without pixels that is a hole
PAD_PX = 64
"""Side of a square that is wholly of a pad, px: 6 m at 0.1 m, more than shadows without any light. At the edge of what
was read, beyond which it goes on, half of it."""
BESIDE_PX = 8
"""Pixels beside a pad that a square of JPEG may share with it."""
_MOST_OFF = 3  # DN of 8 bit, off black or white: what JPEG 60 leaves of pads
_MOST_RINGING = 32  # the same in squares that an image shares: of Brighton's pads JPEG 75 made more of 1 pixel in 100
_MOST_WARPED_PX = 2**26  # of a raster, that are held at once to be warped
_KERNEL_PX = 4.0  # on either side of what lies under a pixel: cubic convolution looks at two, whatever GDAL rounds
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

    They are read as they are when the pixel sizes agree to 1 % and the axes are parallel; the sub-pixel offset is
    reported. Otherwise the raster is warped to the window's grid, by averaging where it is finer and by cubic
    convolution where it is not. With ``holes`` ``valid`` tells of small ones, too.

    Raises NotCoveredError when more than 0.1 % of the pixels are invalid, or with ``partly`` when all but 0.5 % are;
    RasterError when the raster can't be read.
    """
    raster, grid = placed(source.raster), mosaic.grid
    if not (
        raster.is_north_up
        and same_coordinates(raster.wkt, mosaic.wkt, mosaic.extent, MAX_SYSTEM_SHIFT_PX * grid.pixel_width)
        and abs(raster.grid.pixel_width / grid.pixel_width - 1) <= limits.MAX_PIXEL_SIZE_DIFFERENCE
        and abs(raster.grid.pixel_height / grid.pixel_height - 1) <= limits.MAX_PIXEL_SIZE_DIFFERENCE
    ):
        return _clip_warped(source, mosaic, window, partly, holes)
    x, y = middle_of(grid.window_extent(window))
    column, row = raster.grid.column_at(x) - window.width / 2, raster.grid.row_at(y) - window.height / 2
    under = replace(window, column=round(column), row=round(row))
    # Six decimals: below that it is rounding of coordinates of millions of metres.
    offsets = round(column - under.column, 6), round(row - under.row, 6)
    inside, most = under.cut_to(source.columns, source.rows), MAX_MISSING_SHARE if partly else limits.MAX_INVALID_SHARE
    if min(inside.width, inside.height) <= 0 or inside.width * inside.height < (1 - most) * under.width * under.height:
        raise NotCoveredError(messages.NOT_COVERED(name=source.ref.name))
    bands, invalid = block = _without_pads(source, inside)
    if inside != under:
        margins = under.margins_of(inside)
        bands, invalid = np.pad(bands, ((0, 0), *margins)), np.pad(~block.valid, margins, constant_values=True)
    return _filled(Clip(source.raster, bands, 0.0, *offsets), invalid, partly, holes)


def read_overview(mosaic: Raster, extent: Extent, longest_px: int) -> tuple[PixelBlock, Extent] | None:
    """A small picture of a part of the mosaic, and where it lies.

    None where the part lies outside, or where the file has no overviews and too many pixels would be decoded.
    Raises RasterError when the mosaic can't be read.
    """
    source, grid = OpenRaster(mosaic.ref), mosaic.grid
    corners = grid.to_pixels(np.reshape(extent, (2, 2)))
    if not np.isfinite(corners).all():
        return None
    first, last = np.floor(corners.min(axis=0)).astype(int), np.ceil(corners.max(axis=0)).astype(int)
    part = PixelWindow(*first.tolist(), *(last - first).tolist())
    window = part.cut_to(grid.columns, grid.rows)
    pixels = window.width * window.height
    if not pixels or (pixels > MAX_OVERVIEW_PIXELS and not source.dataset.GetRasterBand(1).GetOverviewCount()):
        return None
    reduction = max(1.0, max(window.width, window.height) / longest_px)
    size = max(1, round(window.width / reduction)), max(1, round(window.height / reduction))
    return source.read(window, size), grid.window_extent(window)


def _clip_warped(source: OpenRaster, mosaic: Raster, window: PixelWindow, partly: bool, holes: bool) -> Clip:
    raster = source.raster
    times = mosaic.ground_sample_distance / raster.ground_sample_distance if raster.ground_sample_distance else math.inf
    if window.width * window.height * times**2 > limits.MAX_AVERAGED_PIXELS:
        raise RasterError(messages.MUCH_FINER(name=source.ref.name, times=times))
    rows = max(1, int(_MOST_WARPED_PX / (window.width * max(times, 1) ** 2)))
    ends = window.row + window.height
    strips = [replace(window, row=row, height=min(rows, ends - row)) for row in range(window.row, ends, rows)]
    blocks = [_warped(source, mosaic, strip, times) for strip in strips]
    bands = np.concatenate([block.bands for block in blocks], axis=1)
    valid = np.concatenate([block.valid for block in blocks])
    return _filled(Clip(raster, bands, 0.0, resampled=True), None if valid.all() else ~valid, partly, holes)


def _warped(source: OpenRaster, mosaic: Raster, window: PixelWindow, times: float) -> PixelBlock:
    """A window of the mosaic by a raster's valid pixels, whose sides are the mosaic's over ``times``."""
    raster, extent = source.raster, mosaic.grid.window_extent(window)
    left, bottom, right, top = extent_on(extent, mosaic.wkt, raster.wkt)
    back = gdal.InvGeoTransform(raster.placement)
    corners = np.array([gdal.ApplyGeoTransform(back, x, y) for x in (left, right) for y in (bottom, top)])
    reach = _KERNEL_PX * max(times, 1)
    size = source.columns, source.rows
    column, row = np.floor(corners.min(axis=0) - reach).clip(0, size).astype(int).tolist()
    end, below = np.ceil(corners.max(axis=0) + reach).clip(0, size).astype(int).tolist()
    under = PixelWindow(column, row, end - column, below - row)
    if min(under.width, under.height) <= 0:
        shape = window.height, window.width
        return PixelBlock(np.zeros((len(raster.band_names), *shape), raster.data_type), np.ones(shape, bool))
    bands, invalid = _without_pads(source, under)
    failure = messages.NOT_READABLE(name=source.ref.name)
    kind = gdal_array.NumericTypeCodeToGDALTypeCode(bands.dtype.type)
    held = gdal.GetDriverByName("MEM").Create("", under.width, under.height, len(bands), kind)
    x, y = gdal.ApplyGeoTransform(raster.placement, under.column, under.row)
    held.SetGeoTransform((x, *raster.placement[1:3], y, *raster.placement[4:]))
    held.WriteArray(bands)
    if invalid is not None:
        held.CreateMaskBand(gdal.GMF_PER_DATASET)
        held.GetRasterBand(1).GetMaskBand().WriteArray(np.where(invalid, 0, 255).astype(np.uint8))
    is_finer = times > 1 / (1 - limits.MAX_PIXEL_SIZE_DIFFERENCE)
    pixels = gdal_call(lambda: gdal.Warp(
        "", held, format="MEM", srcSRS=raster.wkt, dstSRS=mosaic.wkt, outputBounds=extent, width=window.width,
        height=window.height, dstAlpha=True, resampleAlg="average" if is_finer else "cubic",
    ), failure).ReadAsArray()  # fmt: skip
    return PixelBlock(pixels[:-1], pixels[-1] == 0)


def _without_pads(source: OpenRaster, window: PixelWindow) -> PixelBlock:
    """Pixels of a raster without its pads of black or white."""
    bands, invalid = source.read(window)
    if bands.dtype.kind != "u":
        return PixelBlock(bands, invalid)
    rows, columns = (np.append(np.arange(0, length, PAD_PX // 2), length - 1) for length in bands.shape[1:])
    few = bands[:, rows[:, np.newaxis], columns]  # which no pad can miss
    extremes = 0, int(np.iinfo(bands.dtype).max)
    values = [value for value in extremes if _is_of(few, value).any() and _is_padded(source, value)]
    if values:
        beyond = PixelWindow(0, 0, source.columns, source.rows).margins_of(window)
        beside = _pads(bands, values, [tuple(0 if more else PAD_PX for more in sides) for sides in beyond])
        invalid = beside if invalid is None else invalid | beside
    return PixelBlock(bands, invalid)


def _is_padded(source: OpenRaster, value: int) -> bool:
    """Whether around an image there is a value that its file doesn't name, or that a codec changed: where the rim of
    one of its corners is of that along a side."""
    if not (source.is_all_valid or source.raster.is_lossy):
        return False
    squares = (square for corner in source.corners for square in (corner, corner.swapaxes(1, 2)))
    return any(_is_of(square[:, row], value).all() for square in squares for row in (0, -1))


def _filled(clip: Clip, invalid: np.ndarray | None, partly: bool, holes: bool) -> Clip:
    """A clip whose invalid pixels hold the mean of the others, with where it is valid if only partly.

    Raises NotCoveredError when there are too many.
    """
    if invalid is None:
        return clip
    most, pixels = MAX_MISSING_SHARE if partly else limits.MAX_INVALID_SHARE, invalid.size
    share = int(np.count_nonzero(invalid)) / pixels
    if share > most:
        raise NotCoveredError(
            messages.TOO_MANY_INVALID(name=clip.raster.ref.name, share=Stated(share, most), most=most)
        )
    valid = ~invalid
    # Of a large window samples tell the mean as well.
    some = np.s_[::8, ::8] if pixels > MANY_PIXELS and valid[::8, ::8].any() else np.s_[:, :]
    known = valid[some]
    bands = np.require(clip.bands, requirements="W")
    for band in bands:
        mean = band[some][known].mean(dtype=np.float64)
        np.copyto(band, mean if bands.dtype.kind == "f" else np.rint(mean), where=invalid, casting="unsafe")
    # More than single pixels, which may be dark ground that has the value of no data.
    rows, columns = (length // HOLE_PX for length in invalid.shape)
    squares = invalid[: rows * HOLE_PX, : columns * HOLE_PX].reshape(rows, HOLE_PX, columns, HOLE_PX)
    is_told = share > limits.MAX_INVALID_SHARE or (holes and squares.all(axis=(1, 3)).any())
    return replace(clip, bands=bands, invalid_share=share, valid=valid if is_told else None)


def _pads(bands: np.ndarray, values: Sequence[int], beyond: Sequence[tuple[int, ...]]) -> np.ndarray:
    """Pads of these values that reach the edge of the bands (bands, rows, columns), with what JPEG made of them in
    squares that they share with an image, (rows, columns) bool. ``beyond``: above and below, left and right, so many
    pixels that are no image's: at its edge a strip is a pad, however narrow."""
    padded = np.zeros(bands.shape[1:], bool)
    inner = tuple(slice(first, first + length) for (first, _), length in zip(beyond, padded.shape))
    rows, columns = (np.pad(np.ones(length, bool), sides) for length, sides in zip(padded.shape, beyond))
    around = rows[:, np.newaxis] | columns  # without its corners, in which a small square would seem large
    for value in values:
        around[inner] = alike = _is_of(bands, value)
        large = ndimage.grey_opening(around.view(np.uint8), size=PAD_PX)[inner] > 0
        if not large.any():
            continue
        parts, _ = ndimage.label(alike)
        at_edge = np.concatenate([parts[[0, -1]].ravel(), parts[:, [0, -1]].ravel()])
        pad = np.isin(parts, np.intersect1d(parts[large], at_edge))
        if (bands[:, pad] != value).any():
            ringing = _is_of(bands, value, _MOST_RINGING) & ndimage.maximum_filter(pad, size=2 * BESIDE_PX + 1)
            pad = ndimage.binary_propagation(pad, mask=ringing)
        padded |= pad
    return padded


def _is_of(bands: np.ndarray, value: int, most_off: int = _MOST_OFF) -> np.ndarray:
    off = most_off if bands.dtype == np.uint8 else 0
    return np.asarray((bands <= off if value == 0 else bands >= value - off).all(axis=0))
