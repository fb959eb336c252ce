"""Simple operations on whole photos, in strips, their place on the map kept (Mikrut and Chwastek 2007, section 3.3)."""
from __future__ import annotations

from typing import Callable

import numpy as np
from scipy import ndimage

from ...imagery import messages as imagery_messages
from ...imagery.errors import CancelledError, SettingsError
from ...imagery.raster_writer import WrittenBands, raster_writer
from ...imagery.rasters import RasterRef
from . import limits, messages
from .photo import Photo

MAX_FILTER_PX = 101  # a wider one wants another tool

EDGES = (limits.LAPLACE, limits.SOBEL)  # they have signs or grow
_APPLIED: dict[str, Callable[[np.ndarray, float, float], np.ndarray]] = {
    limits.NEGATIVE: lambda pixels, size, largest: largest - pixels,
    limits.GREY: lambda pixels, size, largest: pixels * (255 / largest),
    limits.MEAN: lambda pixels, size, largest: ndimage.uniform_filter(pixels, (0, int(size), int(size))),
    limits.GAUSSIAN: lambda pixels, size, largest: ndimage.gaussian_filter(pixels, (0, size, size)),
    limits.LAPLACE: lambda pixels, size, largest: np.stack([ndimage.laplace(band) for band in pixels]),
    limits.SOBEL: lambda pixels, size, largest: np.stack([
        np.hypot(ndimage.sobel(band, 0), ndimage.sobel(band, 1)) for band in pixels
    ]),
}
"""The operations on a strip, (bands, rows, columns) float64, by the size and the largest value of the photo."""


def enhance(
    ref: RasterRef, path: str, operation: str, size: float, cancelled: Callable[[], bool] = lambda: False,
    progress: Callable[[float], None] = lambda share: None,
) -> None:
    """Write the photo's enhanced copy as a GeoTIFF.

    ``size`` is the side of the mean's square, odd, or the Gaussian's standard deviation, px. Mean and Gaussian keep the
    data type; the negative too, its values taken from the largest the type (or its number of bits) can hold; Laplace
    and Sobel, which have signs or grow, are float32. Grey is 8 bit. Edges are mirrored. Invalid pixels stay invalid.

    Raises SettingsError for a size out of range, RasterError for a raster that can't be read or written, CancelledError
    when cancelled; no half-written file is left then, and an older one as it was.
    """
    margin = _margin(operation, size)
    photo = Photo(ref)
    grey = operation == limits.GREY
    kind = np.dtype(np.uint8 if grey else np.float32 if operation in EDGES else photo.raster.data_type)
    largest = photo.largest
    count = 1 if grey else len(photo.raster.band_names)
    with raster_writer(path, photo.raster, WrittenBands(count, kind)) as writer:
        for row, pixels, invalid in photo.strips(margin, grey):
            if cancelled():
                raise CancelledError(imagery_messages.CANCELLED())
            made = _APPLIED[operation](pixels, size, largest)[:, margin : pixels.shape[1] - margin]
            if kind.kind != "f":
                made = np.clip(np.rint(made), np.iinfo(kind).min, np.iinfo(kind).max)
            writer.write(row, made.astype(kind), invalid)
            progress((row + made.shape[1]) / photo.rows)


def _margin(operation: str, size: float) -> int:
    """Width of a pixel's surroundings that count, px."""
    if operation == limits.MEAN:
        if size < 3 or size % 2 != 1 or size > MAX_FILTER_PX:
            raise SettingsError(messages.FILTER_SIDE(size=size, most=MAX_FILTER_PX))
        return int(size) // 2
    if operation == limits.GAUSSIAN:
        if not 0 < size <= MAX_FILTER_PX:
            raise SettingsError(messages.FILTER_DEVIATION(size=size, most=MAX_FILTER_PX))
        return int(4 * size + 0.5)
    return 1 if operation in EDGES else 0
