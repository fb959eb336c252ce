"""Pictures for the eye: the grey values that become black and white, and picture files. No QGIS.

Never band by band: colours stay as they are. What is measured is never touched.
"""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from enum import Enum
from itertools import product

import numpy as np
from osgeo import gdal, gdal_array

from ..imagery.gdal_calls import gdal_silenced, taken_from_memory
from ..imagery.grids import PixelWindow
from ..imagery.limits import LARGEST_VALUE
from ..imagery.open_raster import OpenRaster
from ..imagery.rasters import is_range_known, value_range

DARKEST, BRIGHTEST = 2.0, 98.0  # percentiles that become black and white: QGIS's own cumulative cut
_MOST_OF_ALL = 99.99  # percent of the values, by which a range of 16 bit is told
_MOST_SAMPLES = 1 << 18  # of one band: the percentiles of every fourth pixel of 1024 x 1024 are as good
_SAMPLED_SIDE = 1024  # of a whole raster, px
_MOST_DECODED = 16_000_000  # pixels of a raster that are decoded at once to sample it; beyond, pieces are read
_PIECES, _PIECE_PX = 5, 256  # a side, and a side of each
_LEAST_SPAN = 1e-6  # of the value of pixels that are all alike, so that float32 holds what is beside it
_LEAST_RANGE = 1e-300
_ROWS_AT_ONCE = 256  # are stretched in one go: little memory, and the interface's thread gets its turn

GreyRange = tuple[float, float]  # the values that become black and white, the same for all bands

GreyRanges = Mapping[str, GreyRange]  # grey ranges by data type, since numbers of two types can't be compared


class Stretch(str, Enum):
    """The way in which grey values become brightness on the screen."""

    DELIVERED = "delivered"  # 8 bit as it is, 16 bit by the range of values that is in use: the same in all windows
    COMMON = "common"  # the mosaic's darkest and brightest 2 % cut off: the same in all windows


def ranges_with(known: GreyRanges, stretch: Stretch, sources: Iterable[tuple[OpenRaster, float]]) -> GreyRanges:
    """The ranges known so far in a project, with those of more rasters, the mosaic's first.

    ``sources``: open rasters, each with the largest value seen in it. A range grows when a larger value is seen, so
    that what was delivered is not cut off, but for the few that ``largest_of`` passes over;
    all other ranges stay as the first raster of their type gave them.
    """
    ranges = dict(known)
    for source, largest in sources:
        kind = source.raster.data_type
        high = ranges[kind][1] if kind in ranges else 0.0
        if stretch is not Stretch.DELIVERED or kind not in ("uint8", "uint16"):
            if kind not in ranges:
                ranges[kind] = cut_range([raster_sample(source)])
        elif largest > high or kind not in ranges:
            if kind not in ranges and not is_range_known(source.raster):
                largest = max(largest, largest_of(raster_sample(source)))
            values = value_range(source.raster, largest)
            assert values is not None  # both types have one
            ranges[kind] = values[0], max(values[1], high)
    return ranges


def largest_of(values: np.ndarray) -> float:
    """The value that 99.99 % do not exceed: a single hot pixel would make all others dark. 0 without any."""
    return float(np.percentile(values, _MOST_OF_ALL)) if values.size else 0.0


def cut_range(samples: Sequence[np.ndarray]) -> GreyRange:
    """The range of values without the darkest and the brightest 2 %."""
    values = np.concatenate([sample.ravel() for sample in samples])
    if values.dtype.kind == "f":
        values = values[np.abs(values) <= LARGEST_VALUE]
    if not values.size:
        return 0.0, 1.0
    low, high = (float(value) for value in np.percentile(values, (DARKEST, BRIGHTEST)))
    if high > low and np.isfinite(255 / (high - low)):
        return low, high
    half = max(0.5, abs(low) * _LEAST_SPAN)
    return low - half, low + half


def thinned(band: np.ndarray, valid: np.ndarray | None = None) -> np.ndarray:
    """Some of the (valid) pixels of (rows, columns), enough to tell percentiles."""
    step = 1
    while (band.shape[0] // step) * (band.shape[1] // step) > _MOST_SAMPLES:
        step += 1
    some = band[::step, ::step]
    return some.ravel() if valid is None else some[valid[::step, ::step]]


def raster_sample(source: OpenRaster) -> np.ndarray:
    """Valid values from all over a raster, all its shown bands; it need not be decoded as a whole."""
    whole, first = source.raster.whole, source.dataset.GetRasterBand(1)
    step = max(1, max(whole.width, whole.height) // _SAMPLED_SIDE)
    if first.GetOverviewCount() or whole.width * whole.height <= _MOST_DECODED:
        blocks = [source.thinned(whole, step)]
    else:
        blocks = [
            source.read(PixelWindow(column, row, _PIECE_PX, _PIECE_PX).cut_to(whole.width, whole.height))
            for row, column in product(_starts(whole.height), _starts(whole.width))
        ]
    shown = 3 if source.raster.has_luminance else 1
    return np.concatenate([block.bands[:shown, block.valid].ravel() for block in blocks])


def brightness(bands: np.ndarray, ranges: GreyRanges) -> np.ndarray:
    """(rows, columns, 3) uint8 of one or three bands (bands, rows, columns)."""
    low, high = ranges[str(bands.dtype)]
    is_short = bands.dtype.kind == "u" and bands.dtype.itemsize <= 2
    table = to_bytes(np.arange(np.iinfo(bands.dtype).max + 1), low, high) if is_short else None
    pixels = np.empty((*bands.shape[1:], 3), np.uint8)
    for i, band in enumerate(bands):
        for top in range(0, len(band), _ROWS_AT_ONCE):
            rows = slice(top, top + _ROWS_AT_ONCE)
            pixels[rows, :, i] = to_bytes(band[rows], low, high) if table is None else table[band[rows]]
    if len(bands) == 1:
        pixels[..., 1:] = pixels[..., :1]
    return pixels


def to_bytes(values: np.ndarray, low: float, high: float) -> np.ndarray:
    """0 at ``low`` and below, and for what is no number, 255 at ``high`` and above."""
    span = max(high - low, _LEAST_RANGE)  # values of 64 bit may round to one number
    scaled = np.clip(values.astype(np.float64) - low, 0, span) * (255 / span)
    if values.dtype.kind == "f":
        scaled = np.nan_to_num(scaled, copy=False, nan=0.0)
    return np.rint(scaled).astype(np.uint8)


def _starts(length: int) -> list[int]:
    """The starts of pieces that lie evenly along a side."""
    return sorted(set(np.linspace(0, max(0, length - _PIECE_PX), _PIECES, dtype=int).tolist()))


def encoded(pixels: np.ndarray, driver: str, quality: int = 88) -> bytes:
    """The bytes of a picture file, PNG or JPEG, of (rows, columns) or (rows, columns, 3) uint8."""
    bands = np.moveaxis(np.atleast_3d(pixels), 2, 0)
    path = f"/vsimem/report-{id(pixels)}"
    with gdal_silenced():
        memory = gdal_array.OpenArray(np.ascontiguousarray(bands))
        options = [f"QUALITY={quality}"] if driver == "JPEG" else []
        copy = gdal.GetDriverByName(driver).CreateCopy(path, memory, options=options)
        copy = None  # noqa: F841 - closing the dataset writes the file
        return taken_from_memory(path)
