"""The clips of a window as 8-bit pictures for the eye, all stretched alike. Reads pixels, knows no Qt.

What is measured is never touched: pictures are made from clips of their own.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Callable

import numpy as np

from ..imagery.clips import Clip, read_clip
from ..imagery.errors import RasterError
from ..imagery.open_raster import OpenRaster
from ..imagery.rasters import RasterRef
from .measure.inspection import WindowRequest

DARKEST, BRIGHTEST = 2.0, 98.0  # percentiles that become black and white: QGIS's own cumulative cut
_MOST_SAMPLES = 1 << 18  # of one band of one clip: the percentiles of every fourth pixel of 1024 x 1024 are as good
_ROWS_AT_ONCE = 256  # are stretched in one go: little memory, and the interface's thread gets its turn
_SMALLEST_SIDE = 256  # of the reduced pictures, px

_Stretches = dict[np.dtype, tuple[float, float]]
"""The values that become black and white, the same for all bands so that colours stay as they are, by data type:
numbers of two types can't be compared."""


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
    """The same at 1/2, 1/4, ... of the size, each pixel the mean of 2 x 2: what is drawn when all is to be seen."""


def make_pictures(request: WindowRequest, cancelled: Callable[[], bool] = lambda: False) -> list[ClipPicture]:
    """The mosaic's picture, then those of the sources that cover the window, in the request's order.

    A raster that can't be read there has none. Colours where there are red, green and blue, else the first band
    in grey. Without a window, or when cancelled, there are no pictures.
    """
    clips = list(_clips(request, cancelled))
    stretches = {} if cancelled() else _stretches(clip for clip, _ in clips)
    pictures = []
    while clips and not cancelled():
        clip, is_mosaic = clips.pop(0)  # freed as soon as it is drawn
        pixels = _picture(clip, stretches)
        name = clip.raster.ref.name
        pictures.append(
            ClipPicture(name, is_mosaic, pixels, clip.offset_x, clip.offset_y, clip.resampled, tuple(_reduced(pixels)))
        )
    return [] if cancelled() else pictures


def stretched(clips: Sequence[Clip]) -> list[np.ndarray]:
    """(rows, columns, 3) uint8 of each clip, all stretched in common."""
    stretches = _stretches(clips)
    return [_picture(clip, stretches) for clip in clips]


def bytes_picture(bands: np.ndarray, in_colour: bool, valid: np.ndarray) -> np.ndarray:
    """(rows, columns, 3) uint8 of bands (bands, rows, columns), stretched by its valid pixels; white elsewhere."""
    shown = bands[: 3 if in_colour else 1]
    low, high = np.percentile(shown[:, valid], (DARKEST, BRIGHTEST)) if valid.any() else (0.0, 1.0)
    pixels = np.moveaxis(_bytes(shown, low, high if high > low else low + 1), 0, 2)
    return np.where(valid[..., np.newaxis], pixels, np.uint8(255)).repeat(3 // len(shown), axis=2)


def _clips(request: WindowRequest, cancelled: Callable[[], bool]) -> Iterator[tuple[Clip, bool]]:
    """Clips and whether each is the mosaic's."""
    if request.window is None:
        return
    refs: list[RasterRef] = [request.mosaic.ref, *(source.ref for source in request.sources)]
    for i, ref in enumerate(refs):
        if cancelled():
            return
        with suppress(RasterError):
            yield read_clip(OpenRaster(ref), request.mosaic, request.window), i == 0


def _shown_bands(clip: Clip) -> np.ndarray:
    return clip.bands[: 3 if clip.raster.has_luminance else 1]


def _stretches(clips: Iterable[Clip]) -> _Stretches:
    samples: dict[np.dtype, list[np.ndarray]] = {}
    for clip in clips:
        for band in _shown_bands(clip):
            step = 1
            while (band.shape[0] // step) * (band.shape[1] // step) > _MOST_SAMPLES:
                step += 1
            samples.setdefault(band.dtype, []).append(band[::step, ::step].ravel())
    found = {}
    for key, parts in samples.items():
        low, high = np.percentile(np.concatenate(parts), (DARKEST, BRIGHTEST))
        found[key] = (float(low), float(high)) if high > low else (float(low) - 0.5, float(low) + 0.5)
    return found


def _picture(clip: Clip, stretches: _Stretches) -> np.ndarray:
    bands = _shown_bands(clip)
    pixels = np.empty((*clip.bands.shape[1:], 3), np.uint8)
    for i, band in enumerate(bands):
        _stretch(band, *stretches[band.dtype], pixels[..., i])
    if len(bands) == 1:
        pixels[..., 1:] = pixels[..., :1]
    return pixels


def _stretch(band: np.ndarray, low: float, high: float, out: np.ndarray) -> None:
    table = None
    if band.dtype.kind == "u" and band.dtype.itemsize <= 2:
        table = _bytes(np.arange(np.iinfo(band.dtype).max + 1), low, high)
    for top in range(0, len(band), _ROWS_AT_ONCE):
        rows = slice(top, top + _ROWS_AT_ONCE)
        out[rows] = _bytes(band[rows], low, high) if table is None else table[band[rows]]


def _bytes(values: np.ndarray, low: float, high: float) -> np.ndarray:
    scaled = (values.astype(np.float64) - low) * (255 / (high - low))
    return np.rint(scaled).clip(0, 255).astype(np.uint8)


def _reduced(pixels: np.ndarray) -> Iterator[np.ndarray]:
    while min(pixels.shape[:2]) >= 2 and max(pixels.shape[:2]) > _SMALLEST_SIDE:
        rows, columns = (side // 2 * 2 for side in pixels.shape[:2])
        even = pixels[:rows, :columns].astype(np.uint16)
        total = even[0::2, 0::2] + even[1::2, 0::2] + even[0::2, 1::2] + even[1::2, 1::2]
        pixels = ((total + 2) // 4).astype(np.uint8)
        yield pixels
