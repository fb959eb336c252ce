"""Pixel grids and windows: standard sizes, snapping, and the rectangle a window covers on the ground."""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar

from . import limits, messages
from .errors import SettingsError, WindowError

if TYPE_CHECKING:
    import numpy as np

Extent = tuple[float, float, float, float]
"""xmin, ymin, xmax, ymax in map units."""

_Places = TypeVar("_Places", float, "np.ndarray")


@dataclass(frozen=True)
class NumberedWindow:
    """A window's number and place: what all know of it."""

    window_id: int
    extent: Extent | None
    """The rectangle around it, in the reference system asked for; None where there is none, or it can't be measured."""


@dataclass(frozen=True)
class PixelWindow:
    """A rectangle of whole pixels on one raster's grid."""

    column: int
    """First column, 0 at the left edge."""
    row: int
    """First row, 0 at the top edge."""
    width: int
    """Number of columns."""
    height: int
    """Number of rows."""

    def cut_to(self, columns: int, rows: int) -> PixelWindow:
        """The part of it inside a raster of that size; without columns or rows where there is none."""
        left, top = max(self.column, 0), max(self.row, 0)
        right, bottom = min(self.column + self.width, columns), min(self.row + self.height, rows)
        return PixelWindow(left, top, max(right - left, 0), max(bottom - top, 0))

    def with_margin(self, px: int) -> PixelWindow:
        """It and as many pixels on all sides."""
        return PixelWindow(self.column - px, self.row - px, self.width + 2 * px, self.height + 2 * px)

    def moved_by(self, columns: int, rows: int) -> PixelWindow:
        """One of its size so far to the right and down."""
        return PixelWindow(self.column + columns, self.row + rows, self.width, self.height)

    def moved_into(self, columns: int, rows: int) -> PixelWindow:
        """One of its size, as near as it gets inside a raster of that size; one that is larger begins at the corner."""
        column = min(max(self.column, 0), max(columns - self.width, 0))
        row = min(max(self.row, 0), max(rows - self.height, 0))
        return PixelWindow(column, row, self.width, self.height)

    def margins_of(self, part: PixelWindow) -> tuple[tuple[int, int], tuple[int, int]]:
        """What lies around a part of it, as numpy pads: rows above and below, columns to the left and to the right."""
        above, left = part.row - self.row, part.column - self.column
        return (above, self.height - part.height - above), (left, self.width - part.width - left)

    def shared_pixels(self, other: PixelWindow) -> int:
        """How many pixels two windows on the same grid have in common."""
        shared = self.moved_by(-other.column, -other.row).cut_to(other.width, other.height)
        return shared.width * shared.height


@dataclass(frozen=True)
class Grid:
    """A north-up pixel grid: where pixels lie on the map."""

    left: float
    """x of the left edge of column 0, map units."""
    top: float
    """y of the top edge of row 0, map units."""
    pixel_width: float
    """Map units per column, positive."""
    pixel_height: float
    """Map units per row, positive (rows run south)."""
    columns: int
    """Number of columns."""
    rows: int
    """Number of rows."""
    metres_x: float = 1.0
    """Metres on the ground per map unit along x, at the raster's middle."""
    metres_y: float = 1.0
    """Metres on the ground per map unit along y."""

    @property
    def extent(self) -> Extent:
        """The whole grid on the map."""
        return self.window_extent(PixelWindow(0, 0, self.columns, self.rows))

    @property
    def ground_sample_distance(self) -> float:
        """The shorter side of a pixel on the ground, metres."""
        return min(self.pixel_width * self.metres_x, self.pixel_height * self.metres_y)

    def column_at(self, x: _Places) -> _Places:
        """Columns from the left edge to a place on the map; 0.5 is the middle of the first one."""
        return (x - self.left) / self.pixel_width

    def row_at(self, y: _Places) -> _Places:
        """Rows from the upper edge down to a place on the map; 0.5 is the middle of the first one."""
        return (self.top - y) / self.pixel_height

    def to_pixels(self, points: np.ndarray) -> np.ndarray:
        """Columns and rows of places on the map, both (n, 2)."""
        import numpy as np  # not when QGIS starts

        return np.column_stack([self.column_at(points[:, 0]), self.row_at(points[:, 1])])

    def to_map(self, column: float, row: float) -> tuple[float, float]:
        """The place on the map of a column and a row."""
        return self.left + float(column) * self.pixel_width, self.top - float(row) * self.pixel_height

    def window_extent(self, window: PixelWindow) -> Extent:
        """The rectangle of a pixel window on the map."""
        return (
            self.left + window.column * self.pixel_width,
            self.top - (window.row + window.height) * self.pixel_height,
            self.left + (window.column + window.width) * self.pixel_width,
            self.top - window.row * self.pixel_height,
        )


def standard_side_px(grid: Grid, side_m: float = limits.STANDARD_SIDE_M) -> int:
    """Side of the standard window: the smallest power of two of pixels that spans at least ``side_m`` metres, 1024 px
    of 0.10 m for 100 m (Pyka 2010, section 5).

    Raises SettingsError when the side is not a positive number.
    """
    if not (math.isfinite(side_m) and side_m > 0):
        raise SettingsError(messages.SIDE_NOT_POSITIVE(side=side_m))
    pixels = side_m / grid.ground_sample_distance
    # A millionth of a pixel is rounding in the geotransform, not a longer side.
    return int(2 ** max(0, math.ceil(math.log2(max(pixels - 1e-6, 1.0)))))


def standard_window(grid: Grid, x: float, y: float, side_px: int) -> PixelWindow:
    """The square window of ``side_px`` pixels whose centre lies nearest to the map point (x, y)."""
    column, row = round(grid.column_at(x) - side_px / 2), round(grid.row_at(y) - side_px / 2)
    return PixelWindow(column, row, side_px, side_px)


def snap_window(grid: Grid, extent: Extent, levels: int = limits.DEFAULT_LEVELS) -> PixelWindow:
    """The pixels of a drawn rectangle that can be measured: whole ones, cut to the grid, trimmed evenly on both sides
    to a multiple of ``2 ** levels`` pixels, so that the decomposition needs no padding.

    Raises WindowError when the rectangle lies outside the grid, leaves a side shorter than 64 px or ``2 ** levels`` px,
    or covers more pixels than can be held in memory.
    """
    xmin, ymin, xmax, ymax = extent
    if not (xmin <= xmax and ymin <= ymax):  # NaN too
        raise WindowError(messages.WINDOW_NO_RECTANGLE(xmin=xmin, ymin=ymin, xmax=xmax, ymax=ymax))
    edges = grid.column_at(xmin), grid.column_at(xmax), grid.row_at(ymax), grid.row_at(ymin)
    if not all(map(math.isfinite, edges)):
        raise WindowError(messages.WINDOW_OUTSIDE())
    left, right, top, bottom = map(round, edges)
    if right <= 0 or bottom <= 0 or left >= grid.columns or top >= grid.rows:
        raise WindowError(messages.WINDOW_OUTSIDE())
    left, right, top, bottom = max(left, 0), min(right, grid.columns), max(top, 0), min(bottom, grid.rows)
    step = 2 ** int(levels)  # GDAL takes no integers of numpy
    column, width = _trim(left, right, step)
    row, height = _trim(top, bottom, step)
    fewest = max(limits.MIN_SIDE_PX, step)
    if min(width, height) < fewest:
        raise WindowError(messages.WINDOW_TOO_SMALL(fewest=fewest, width=right - left, height=bottom - top))
    if width * height > limits.MAX_WINDOW_PIXELS:
        most = limits.MAX_WINDOW_PIXELS // 1_000_000
        raise WindowError(messages.WINDOW_TOO_LARGE(width=width, height=height, most=most))
    return PixelWindow(column, row, width, height)


def _trim(start: int, stop: int, multiple: int) -> tuple[int, int]:
    """Start and length of the longest multiple inside [start, stop), the rest cut evenly on both sides."""
    length = (stop - start) // multiple * multiple
    return start + (stop - start - length) // 2, length


def middle_of(extent: Extent) -> tuple[float, float]:
    """x and y of its middle."""
    return (extent[0] + extent[2]) / 2, (extent[1] + extent[3]) / 2


def extents_meet(first: Extent, second: Extent) -> bool:
    """Whether two rectangles share more than a border."""
    return first[0] < second[2] and first[2] > second[0] and first[1] < second[3] and first[3] > second[1]


def covered_share(extent: Extent, other: Extent) -> float:
    """How much of an extent another one covers; 0 where it has no area, as where its pixels are smaller than
    coordinates can tell apart."""
    shared, whole = shared_extent(extent, other), (extent[2] - extent[0]) * (extent[3] - extent[1])
    return (shared[2] - shared[0]) * (shared[3] - shared[1]) / whole if shared is not None and whole > 0 else 0.0


def shared_extent(a: Extent, b: Extent) -> Extent | None:
    xmin, ymin, xmax, ymax = max(a[0], b[0]), max(a[1], b[1]), min(a[2], b[2]), min(a[3], b[3])
    return (xmin, ymin, xmax, ymax) if xmin < xmax and ymin < ymax else None
