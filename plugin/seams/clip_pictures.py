"""The clips of a window as 8-bit pictures for the eye, all stretched alike. Reads pixels, knows no Qt.

What is measured is never touched: pictures are made from clips of their own.
"""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass

import numpy as np

from ..imagery.clips import MAX_MISSING_SHARE, Clip, read_clip
from ..imagery.errors import RasterError
from ..imagery.open_raster import OpenRaster
from ..toolkit.pictures import (
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
from .measure.window.measured_window import WindowRequest

_NO_DATA_GREYS, _NO_DATA_SQUARE = (88, 104), 8  # squares that say that there is nothing, and their side, px


@dataclass(frozen=True, eq=False)
class ClipPicture:
    """One raster's clip, ready to be drawn."""

    raster: str  # file name without its folder
    is_mosaic: bool
    pixels: np.ndarray  # (rows, columns, 3) uint8, stretched in common with all pictures of the window
    covered: float  # share of the window in which it has pixels


def make_pictures(request: WindowRequest) -> tuple[list[ClipPicture], GreyRanges]:
    """The mosaic's picture, then those of the sources that cover some of the window, in the request's order; and the
    grey values that are black and white in them, as delivered.

    A raster that can't be read there has none. Colours where there are red, green and blue, else the first band
    in grey; squares where a raster has no data. Without a window there are no pictures.
    """
    clips = list(_clips(request))
    largest = ((source, largest_of(np.concatenate([thinned(band) for band in _shown(clip)]))) for source, clip in clips)
    ranges = ranges_with({}, Stretch.DELIVERED, largest)
    pictures = []
    for source, clip in clips:
        pixels, covered = brightness(_shown(clip), ranges), 1.0
        if clip.valid is not None:
            _mark_no_data(pixels, clip.valid)
            covered = float(clip.valid.mean())
        pictures.append(ClipPicture(clip.raster.ref.name, source.ref == request.mosaic.ref, pixels, covered))
    return pictures, ranges


def stretched(clips: Sequence[Clip]) -> list[np.ndarray]:
    """(rows, columns, 3) uint8 of each clip, all stretched in common by what they hold."""
    samples: dict[str, list[np.ndarray]] = {}
    for clip in clips:
        bands = _shown(clip)
        samples.setdefault(str(bands.dtype), []).extend(thinned(band, clip.valid) for band in bands)
    ranges = {kind: cut_range(parts) for kind, parts in samples.items()}
    return [brightness(_shown(clip), ranges) for clip in clips]


def bytes_picture(bands: np.ndarray, in_colour: bool, valid: np.ndarray) -> np.ndarray:
    """(rows, columns, 3) uint8 of bands (bands, rows, columns), stretched by its valid pixels; white elsewhere."""
    shown = bands[: 3 if in_colour else 1]
    low, high = np.percentile(shown[:, valid], (DARKEST, BRIGHTEST)) if valid.any() else (0.0, 1.0)
    pixels = np.moveaxis(to_bytes(shown, low, high if high > low else low + 1), 0, 2)
    return np.where(valid[..., np.newaxis], pixels, np.uint8(255)).repeat(3 // len(shown), axis=2)


def _clips(request: WindowRequest) -> Iterator[tuple[OpenRaster, Clip]]:
    """Images that have pixels in the window, be it a few."""
    if request.window is None:
        return
    for ref in (request.mosaic.ref, *(source.ref for source in request.sources)):
        with suppress(RasterError):
            source = OpenRaster(ref)
            clip = read_clip(source, request.mosaic, request.window, partly=True, holes=True)
            if clip.valid is None or clip.valid.mean() > 1 - MAX_MISSING_SHARE:
                yield source, clip


def _shown(clip: Clip) -> np.ndarray:
    return clip.bands[: 3 if clip.raster.has_luminance else 1]


def _mark_no_data(pixels: np.ndarray, valid: np.ndarray) -> None:
    rows, columns = (np.arange(side) // _NO_DATA_SQUARE for side in valid.shape)
    squares = np.array(_NO_DATA_GREYS, np.uint8)[(rows[:, np.newaxis] + columns) % 2]
    np.copyto(pixels, squares[..., np.newaxis], where=~valid[..., np.newaxis])
