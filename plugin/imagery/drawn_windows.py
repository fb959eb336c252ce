"""Rectangles on the map, laid on the pixels of images in any reference system."""
from __future__ import annotations

from dataclasses import dataclass

from . import messages
from .errors import RasterError, WindowError
from .grids import Extent, Grid, NumberedWindow, PixelWindow, snap_window
from .rasters import Raster
from .reference_systems import extent_on


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
