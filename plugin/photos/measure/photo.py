"""Photographs and scans, whose place on the map does not matter, as grey values."""
from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ...imagery import messages as imagery_messages
from ...imagery.errors import NotCoveredError, PhotoError
from ...imagery.gdal_calls import gdal_call
from ...imagery.grids import PixelWindow
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import RasterRef
from ...imagery.wavelets import judged_plane, luminance
from . import limits, messages

MOST_GREY = 65535  # of 16 bits; a float raster's 3.4e38 is no grey value
STRIP_PIXELS = 4_000_000  # read at a time: 16 MB as float32
COARSEST_SIDE_PX = 150  # of a photo: marks up to a tenth of it wide
COARSEST_WINDOW_PX = 64  # of a search window: a coarse figure is 25 px wide with its ground

Place = tuple[float, float]  # column and row in the photo, px


class Photo(OpenRaster):
    """A raster read as grey values. Colour becomes luminance, a palette its colours' luminance; of other bands the
    first counts, alpha never. A value that a photo can have is one though the file calls it nodata: the black of a
    frame is the ground of its marks. Pixels without any (masked, transparent, NaN, a negative nodata value) hold the
    mean of the others around."""

    def contains(self, place: tuple[float, float]) -> bool:
        """Whether a column and row, pixel centres at .5, lie in the photo."""
        return 0 <= place[0] < self.columns and 0 <= place[1] < self.rows

    def holds(self, place: tuple[float, float], radius: float) -> bool:
        """Whether what is so large (px) around a place lies in the photo as a whole."""
        column, row = place
        return radius <= min(column, row, self.columns - column, self.rows - row)

    def grey(self, window: PixelWindow | None = None) -> np.ndarray:
        """(rows, columns) float32 of a window, or of all; what lies outside the photo repeats its edge."""
        window = window or self.raster.whole
        inside = window.cut_to(self.columns, self.rows)
        if min(inside.width, inside.height) <= 0:
            raise NotCoveredError(imagery_messages.NOT_COVERED(name=self.ref.name))
        pixels = self._grey(inside)
        return pixels if inside == window else np.pad(pixels, window.margins_of(inside), mode="edge")

    def reduced(self, factor: int) -> np.ndarray:
        """The whole photo, float32, each pixel the mean of ``factor`` x ``factor``; what is left over is cut off."""
        rows, columns = self.rows // factor, self.columns // factor
        if factor == 1:
            return self.grey()
        if self.roles.alpha is None and self.raster.bits != 1 and not self._nodata_is_grey:
            return self._grey(PixelWindow(0, 0, columns * factor, rows * factor), (columns, rows))
        # GDAL would average to the nearest of two values or of a palette, and leave nodata out
        made = np.empty((rows, columns), np.float32)
        step = max(1, STRIP_PIXELS // (self.columns * factor))
        for row in range(0, rows, step):
            count = min(step, rows - row)
            strip = self._grey(PixelWindow(0, row * factor, columns * factor, count * factor))
            made[row : row + count] = strip.reshape(count, factor, columns, factor).mean(axis=(1, 3))
        return made

    def strips(self, margin: int, grey: bool) -> Iterator[tuple[int, np.ndarray, np.ndarray | None]]:
        """Strips from top to bottom: the first row, the pixels (bands, rows + 2 margin, columns) float64, and which are
        invalid (rows, columns), or None. The photo is mirrored at its upper and lower edge; pixels without a value hold
        the mean of the others of their strip."""
        step = max(1, STRIP_PIXELS // self.columns)
        for row in range(0, self.rows, step):
            count = min(step, self.rows - row)
            top, bottom = max(row - margin, 0), min(row + count + margin, self.rows)
            bands, invalid = self.read(PixelWindow(0, top, self.columns, bottom - top))
            pixels = (luminance(bands)[np.newaxis] if grey and len(bands) >= 3 else bands).astype(np.float64)
            if grey:
                pixels = pixels[:1]
            without = self._without_value(bands, invalid)
            if without is not None and not without.all():
                pixels[:, without] = pixels[:, ~without].mean(axis=1, keepdims=True)
            above, below = margin - (row - top), margin - (bottom - row - count)
            if above or below:
                pixels = np.pad(pixels, ((0, 0), (above, below), (0, 0)), mode="symmetric")
            yield row, pixels, None if invalid is None else invalid[row - top : row - top + count]

    @property
    def largest(self) -> float:
        """The largest value that a pixel can have: by its number of bits, its type, or (float) its largest one."""
        kind = np.dtype(self.raster.data_type)
        if kind.kind == "f":
            band, failure = self.dataset.GetRasterBand(1), imagery_messages.NOT_READABLE(name=self.ref.name)
            return float(gdal_call(lambda: band.ComputeRasterMinMax(False), failure)[1])
        bits = self.raster.bits if kind.kind == "u" else None
        return float(2**bits - 1 if bits is not None else np.iinfo(kind).max)

    def _grey(self, window: PixelWindow, size: tuple[int, int] | None = None) -> np.ndarray:
        bands, invalid = self.read(window, size, averaged=True)
        grey = judged_plane(bands, self.roles.names)
        without = self._without_value(bands, invalid)
        if without is not None and not without.all():
            grey[without] = grey[~without].mean()
        return np.nan_to_num(grey, copy=False)

    @property
    def _nodata_is_grey(self) -> bool:
        """Whether what the file calls nodata is a value that a photo can have."""
        nodata = self.nodata
        return nodata is not None and 0 <= nodata <= MOST_GREY

    def _without_value(self, bands: np.ndarray, invalid: np.ndarray | None) -> np.ndarray | None:
        """(rows, columns) of the invalid pixels that hold no grey value; None where all do."""
        if invalid is None or not self._nodata_is_grey:
            return invalid
        held = self._nodata_mask(bands)
        return invalid if held is None else invalid & ~held


def scanned_photo(ref: RasterRef) -> Photo:
    """A photo in which marks are looked for, all over. Raises PhotoError for a raster that can't be the scan of one."""
    photo = Photo(ref)
    if max(photo.columns, photo.rows) > limits.MOST_SCANNED_PX:
        raise PhotoError(messages.PHOTO_TOO_LARGE(
            name=ref.name, columns=photo.columns, rows=photo.rows, most=limits.MOST_SCANNED_PX
        ))
    return photo


@dataclass(frozen=True)
class SearchArea:
    """A rectangle of the photo, px: left, top, right, bottom."""

    left: float
    top: float
    right: float
    bottom: float


@dataclass(frozen=True, eq=False)
class MarkFrame:
    """The marks of a calibration as they lie in the photo but for shift, scale and a small rotation."""

    marks: tuple[str, ...]
    places: np.ndarray  # (n, 2) mm, x to the right and y downwards in the photo
    areas: tuple[SearchArea, ...]  # where each mark is looked for
    scales: tuple[float, float]  # smallest and largest pixels per millimetre
    rotation: float  # largest rotation, radians

    def only(self, wanted: Sequence[int]) -> MarkFrame:
        marks, areas = tuple(self.marks[k] for k in wanted), tuple(self.areas[k] for k in wanted)
        return replace(self, marks=marks, places=self.places[list(wanted)], areas=areas)

    @property
    def sites(self) -> dict[str, Place]:
        return {mark: (float(x), float(y)) for mark, (x, y) in zip(self.marks, self.places)}


def image_pyramid(image: np.ndarray, coarsest: int) -> list[np.ndarray]:
    """An image and its halves, quarters, ... until a side would be shorter than ``coarsest`` px."""
    made = [image]
    while min(made[-1].shape) >= 2 * coarsest:
        made.append(block_means(made[-1], 2))
    return made


def block_means(pixels: np.ndarray, step: int) -> np.ndarray:
    """(rows, columns) reduced by an integer, each pixel a mean; what is left over is cut off."""
    rows, columns = (side // step for side in pixels.shape)
    return np.asarray(pixels[: rows * step, : columns * step].reshape(rows, step, columns, step).mean(axis=(1, 3)))


@dataclass(frozen=True, eq=False)
class PhotoView:
    """A piece of the photo, perhaps reduced."""

    pixels: np.ndarray  # (rows, columns)
    left: float  # column of its left edge in the photo, px
    top: float  # row of its upper edge in the photo, px
    factor: float = 1  # pixels of the photo that one of its pixels is wide


Scene = Callable[[MarkFrame], Sequence[Sequence[PhotoView]]]  # a view for each mark, at each level, coarse to fine


def whole_photo_views(image: np.ndarray, factor: int) -> Scene:
    """Views of the areas in which a frame may have its marks; the image is the photo reduced by a factor."""
    levels = list(enumerate(image_pyramid(image, COARSEST_SIDE_PX)))[::-1]
    return lambda frame: [[_cut(level, area, factor * 2.0**k) for area in frame.areas] for k, level in levels]


def window_views(views: Sequence[PhotoView]) -> Scene:
    """Views of one window for each mark, of one size."""
    pyramids = [image_pyramid(view.pixels, COARSEST_WINDOW_PX) for view in views]
    count = min(len(pyramid) for pyramid in pyramids)
    made = [
        [replace(view, pixels=pyramid[k], factor=view.factor * 2.0**k) for view, pyramid in zip(views, pyramids)]
        for k in reversed(range(count))
    ]
    return lambda frame: made


def _cut(level: np.ndarray, area: SearchArea, factor: float) -> PhotoView:
    left, top = max(int(area.left / factor), 0), max(int(area.top / factor), 0)
    piece = level[top : math.ceil(area.bottom / factor), left : math.ceil(area.right / factor)]
    return PhotoView(piece, left * factor, top * factor, factor)
