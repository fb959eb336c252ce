"""The clips of a window as 8-bit pictures for the eye, all stretched alike. Reads pixels, knows no Qt.

What is measured is never touched: pictures are made from clips of their own.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Callable

import numpy as np

from ..imagery.clips import MAX_MISSING_SHARE, Clip, read_clip
from ..imagery.errors import RasterError
from ..imagery.grids import PixelWindow
from ..imagery.limits import has_colours
from ..imagery.open_raster import OpenRaster
from ..toolkit.picture_stretch import (
    BRIGHTEST,
    DARKEST,
    GreyRanges,
    Stretch,
    brightness,
    cut_range,
    largest_of,
    ranges_with,
    thinned,
    to_bytes,
)
from .measure.window.explained_window import WindowComposite
from .measure.window.window_request import WindowRequest
from .measure.window_records import COMPOSITE

LEAST_SIDE_PX = 384  # of a picture: smaller windows are shown with the ground around them
_SMALLEST_SIDE = 256  # of the reduced pictures, px
_NO_DATA_GREYS, _NO_DATA_SQUARE = (88, 104), 8  # squares that say that there is nothing, and their side, px


@dataclass(frozen=True, eq=False)
class ClipPicture:
    """One raster's clip, ready to be drawn."""

    raster: str
    """File name without its folder."""
    is_mosaic: bool
    pixels: np.ndarray
    """(rows, columns, 3) uint8, C-contiguous, stretched in common with all pictures of the window."""
    offset_x: float = 0.0
    """How far the window lies to the right of these pixels, px."""
    offset_y: float = 0.0
    """How far the window lies below these pixels, px."""
    resampled: bool = False
    """Whether the pixels were warped to the mosaic's grid, which softens them."""
    reduced: tuple[np.ndarray, ...] = ()
    """Its pixels at 1/2, 1/4, ... of the size, each the mean of 2 x 2: what is drawn when all is to be seen."""
    inside: PixelWindow | None = None
    """The window's own pixels, where there is ground around them; None: the picture is the window."""
    is_composite: bool = False
    """Whether it is the hard-cut composite of the sources, and no raster's."""
    covered: float = 1.0
    """Share of the window in which it has pixels."""


@dataclass(frozen=True)
class PictureRequest:
    """A window to be shown, and how."""

    window: WindowRequest
    stretch: Stretch = Stretch.DELIVERED
    ranges: GreyRanges = field(default_factory=dict)
    """Known so far in this project, so that all windows look alike."""


@dataclass(frozen=True, eq=False)
class WindowPictureSet:
    """The pictures of one window, the mosaic's first, and the ranges of values by which all windows are shown."""

    pictures: tuple[ClipPicture, ...] = ()
    ranges: GreyRanges = field(default_factory=dict)
    used: GreyRanges = field(default_factory=dict)
    """Those of this window: its own, where each window has a stretch of its own."""


def make_pictures(request: PictureRequest, cancelled: Callable[[], bool] = lambda: False) -> WindowPictureSet:
    """The mosaic's picture, then those of the sources that cover some of the window, in the request's order.

    A raster that can't be read there has none. Colours where there are red, green and blue, else the first band
    in grey; squares where a raster has no data. Without a window, or when cancelled, there are no pictures.
    """
    window = request.window.window
    if window is None:
        return WindowPictureSet((), request.ranges)
    shown, inside = with_ground(window)
    clips = list(_clips(request.window, shown, inside, cancelled))
    if cancelled():
        return WindowPictureSet((), request.ranges)
    ranges, kept = request.ranges, request.ranges
    if request.stretch is Stretch.WINDOW:
        ranges = _own_ranges(((_shown_bands(clip), clip.valid) for _, clip in clips), inside)
    else:
        ranges = kept = ranges_with(ranges, request.stretch, ((source, _largest(clip)) for source, clip in clips))
    pictures = []
    while clips and not cancelled():
        source, clip = clips.pop(0)  # freed as soon as it is drawn
        pixels = brightness(_shown_bands(clip), ranges)
        if clip.valid is not None:
            _mark_no_data(pixels, clip.valid)
        pictures.append(
            ClipPicture(
                clip.raster.ref.name, source.ref == request.window.mosaic.ref, pixels, clip.offset_x, clip.offset_y,
                clip.resampled, tuple(_reduced(pixels)), inside if shown != window else None,
                covered=1.0 if clip.valid is None else float(_part(clip.valid, inside).mean()),
            )
        )
    return WindowPictureSet(() if cancelled() else tuple(pictures), kept, ranges)


def composite_picture(composite: WindowComposite, mosaic: ClipPicture, ranges: GreyRanges) -> ClipPicture:
    """The composite of a window in the place of the mosaic's pixels; the ground around it is the mosaic's."""
    shown = composite.bands[: 3 if has_colours(composite.names) else 1]
    pixels = mosaic.pixels.copy()
    _part(pixels, mosaic.inside)[...] = brightness(shown, ranges)
    return ClipPicture(
        COMPOSITE, False, pixels, reduced=tuple(_reduced(pixels)), inside=mosaic.inside, is_composite=True
    )


def with_ground(window: PixelWindow) -> tuple[PixelWindow, PixelWindow]:
    """A window with the ground around it where it is small, and where it lies in that; beyond the mosaic too."""
    left, top = (max(0, LEAST_SIDE_PX - side + 1) // 2 for side in (window.width, window.height))
    shown = PixelWindow(window.column - left, window.row - top, window.width + 2 * left, window.height + 2 * top)
    return shown, PixelWindow(left, top, window.width, window.height)


def stretched(clips: Sequence[Clip]) -> list[np.ndarray]:
    """(rows, columns, 3) uint8 of each clip, all stretched in common."""
    ranges = _own_ranges((_shown_bands(clip), clip.valid) for clip in clips)
    return [brightness(_shown_bands(clip), ranges) for clip in clips]


def bytes_picture(bands: np.ndarray, in_colour: bool, valid: np.ndarray) -> np.ndarray:
    """(rows, columns, 3) uint8 of bands (bands, rows, columns), stretched by its valid pixels; white elsewhere."""
    shown = bands[: 3 if in_colour else 1]
    low, high = np.percentile(shown[:, valid], (DARKEST, BRIGHTEST)) if valid.any() else (0.0, 1.0)
    pixels = np.moveaxis(to_bytes(shown, low, high if high > low else low + 1), 0, 2)
    return np.where(valid[..., np.newaxis], pixels, np.uint8(255)).repeat(3 // len(shown), axis=2)


def _clips(
    request: WindowRequest, shown: PixelWindow, inside: PixelWindow, cancelled: Callable[[], bool]
) -> Iterator[tuple[OpenRaster, Clip]]:
    """Those that have pixels in the window itself, be it a few."""
    for ref in (request.mosaic.ref, *(source.ref for source in request.sources)):
        if cancelled():
            return
        with suppress(RasterError):
            source = OpenRaster(ref)
            clip = read_clip(source, request.mosaic, shown, partly=True, holes=True)
            if clip.valid is None or _part(clip.valid, inside).mean() > 1 - MAX_MISSING_SHARE:
                yield source, clip


def _shown_bands(clip: Clip) -> np.ndarray:
    return clip.bands[: 3 if clip.raster.has_luminance else 1]


def _largest(clip: Clip) -> float:
    """Filled pixels hold a mean and do no harm."""
    return largest_of(np.concatenate([thinned(band) for band in _shown_bands(clip)]))


def _own_ranges(
    shown: Iterable[tuple[np.ndarray, np.ndarray | None]], inside: PixelWindow | None = None
) -> GreyRanges:
    """Grey ranges by what the clips hold in this window."""
    samples: dict[str, list[np.ndarray]] = {}
    for bands, valid in shown:
        where = None if valid is None else _part(valid, inside)
        samples.setdefault(str(bands.dtype), []).extend(thinned(_part(band, inside), where) for band in bands)
    return {kind: cut_range(parts) for kind, parts in samples.items()}


def _part(pixels: np.ndarray, inside: PixelWindow | None) -> np.ndarray:
    if inside is None:
        return pixels
    return pixels[inside.row : inside.row + inside.height, inside.column : inside.column + inside.width]


def _mark_no_data(pixels: np.ndarray, valid: np.ndarray) -> None:
    rows, columns = (np.arange(side) // _NO_DATA_SQUARE for side in valid.shape)
    squares = np.array(_NO_DATA_GREYS, np.uint8)[(rows[:, np.newaxis] + columns) % 2]
    np.copyto(pixels, squares[..., np.newaxis], where=~valid[..., np.newaxis])


def _reduced(pixels: np.ndarray) -> Iterator[np.ndarray]:
    while min(pixels.shape[:2]) >= 2 and max(pixels.shape[:2]) > _SMALLEST_SIDE:
        rows, columns = (side // 2 * 2 for side in pixels.shape[:2])
        even = pixels[:rows, :columns].astype(np.uint16)
        total = even[0::2, 0::2] + even[1::2, 0::2] + even[0::2, 1::2] + even[1::2, 1::2]
        pixels = ((total + 2) // 4).astype(np.uint8)
        yield pixels
