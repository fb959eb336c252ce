"""Small areas of a raster: which are uniform, how noisy those are, which may be grey, and what is known to be grey.

An area is 16 x 16 pixels. It is uniform when its four quadrants have the same mean, as far as the noise within them
lets one tell: the variance between the quadrants' means, times the pixels of one, is at most 3.86 times the variance
within (99 % of what white noise gives). This does not depend on how much noise there is, so noisy images have uniform
areas too; edges, gradients and coarse texture fail it.

What is grey in nature no image tells: bare soil under a clean light and grey asphalt under a warm one have the same
pixels. So grey areas come from the user; what may be grey is found only to be looked at (``find_maybe_grey``).
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from osgeo import ogr
from scipy import special

from ...imagery.grids import PixelWindow
from ...imagery.lines import burnt
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import ValueRange
from . import limits

MAX_QUADRANT_RATIO = 3.86  # variance between the four quadrants over that within: 99 % of F(3, 252), white noise
MID_TONES = (0.25, 0.75)  # of the available range: the middle half
UNIFORM_SHARE = 0.25  # the quarter of the uniform areas with the least noise: the others may be fine texture

_HALF = limits.AREA_PX // 2
_PIXELS = _HALF * _HALF  # pixels of a quadrant
_FREE = 4 * (_PIXELS - 1)  # degrees of freedom of the noise within an area
_QUADRANTS = np.kron(np.eye(2).repeat(_HALF, axis=0), np.eye(2).repeat(_HALF, axis=0))
"""(pixels of an area in a row, 4): which of them belong to each quadrant; a matrix product is the fastest sum."""


@dataclass(frozen=True, eq=False)
class Areas:
    """Samples of a raster with b bands: n areas."""

    means: np.ndarray  # (n, b) float64
    noise: np.ndarray  # (n, b) float64: standard deviation within the quadrants
    uniform: np.ndarray  # (n, b) bool
    corners: np.ndarray  # (n, 2) int64: column and row of the upper left pixel


def sample_areas(
    bands: np.ndarray, invalid: np.ndarray | None, step: int, corner: tuple[int, int] = (0, 0)
) -> Areas:
    """The areas of a block of pixels that lie in even steps and have no invalid pixel.

    ``bands``: (bands, rows, columns). ``step``: px between upper left corners. ``corner``: column and row of the
    block's first pixel in the raster.
    """
    side = limits.AREA_PX
    if min(bands.shape[1:]) < side:
        nothing = np.empty((0, len(bands)))
        return Areas(nothing, nothing, nothing.astype(bool), np.empty((0, 2), np.int64))
    seen = np.lib.stride_tricks.sliding_window_view(bands, (side, side), axis=(1, 2))[:, ::step, ::step]
    rows, columns = np.indices(seen.shape[1:3]).reshape(2, -1) * step
    corners = np.column_stack([columns, rows]) + corner
    if invalid is not None:
        bad = np.lib.stride_tricks.sliding_window_view(invalid, (side, side))[::step, ::step].any(axis=(2, 3))
        parts, corners = seen[:, ~bad], corners[~bad.ravel()]
    else:
        parts = seen.reshape(len(bands), -1, side, side)
    dtype = np.float32 if bands.dtype.kind in "iu" and bands.dtype.itemsize <= 2 else np.float64
    areas = parts.astype(dtype).reshape(-1, side * side)
    # Less the first pixel, so that float32 keeps the small differences of large values.
    origins = areas[:, 0].copy()
    areas -= origins[:, np.newaxis]
    sums = (areas @ _QUADRANTS.astype(dtype)).astype(np.float64)
    squares = np.einsum("ij,ij->i", areas, areas).astype(np.float64)
    within = np.maximum(squares - (sums**2).sum(axis=1) / _PIXELS, 0) / _FREE
    between = (sums / _PIXELS).var(axis=1, ddof=1) * _PIXELS
    means = origins + sums.sum(axis=1) / (4 * _PIXELS)
    uniform = between <= MAX_QUADRANT_RATIO * within
    means, noise, uniform = (figure.reshape(len(bands), -1).T for figure in (means, np.sqrt(within), uniform))
    return Areas(means, noise, uniform, corners)


def joined(parts: Sequence[Areas]) -> Areas:
    columns = zip(*((part.means, part.noise, part.uniform, part.corners) for part in parts))
    return Areas(*map(np.concatenate, columns))


def signal_to_noise(areas: Areas, band: int, available: ValueRange) -> float | None:
    """Mean over standard deviation in a band's uniform mid-tone areas.

    Of the uniform areas whose mean lies in the middle half of the range, the quarter with the least noise is taken
    (the others may be fine texture): mean of their means over the root mean square of their noise. Those with the
    least noise are so in part by chance, which is allowed for as white noise has it (chi-square). None where there
    are fewer than eight such areas; infinite where they do not vary at all.
    """
    chosen = areas.uniform[:, band] & _is_mid_tone(areas.means[:, band], available)
    if np.count_nonzero(chosen) < limits.MIN_AREAS:
        return None
    means, noise = areas.means[chosen, band], areas.noise[chosen, band]
    best = np.argsort(noise, kind="stable")[: max(round(UNIFORM_SHARE * len(noise)), limits.MIN_AREAS)]
    deviation = float(np.sqrt(np.mean(noise[best] ** 2) / _by_chance(len(best) / len(noise))))
    return float(means[best].mean()) / deviation if deviation > 0 else float("inf")


def _by_chance(share: float) -> float:
    """Mean variance of the share of areas with the least, where all have white noise of variance 1."""
    return float(special.chdtr(_FREE + 2, 2 * special.gammaincinv(_FREE / 2, share))) / share


def _is_mid_tone(means: np.ndarray, available: ValueRange) -> np.ndarray:
    low, high = available
    least, most = (low + share * (high - low) for share in MID_TONES)
    return (means >= least) & (means <= most)


@dataclass(frozen=True)
class GreyArea:
    """An area of which the user says that it is grey."""

    number: int  # number of its feature in the layer
    wkb: bytes  # a polygon in the image's reference system


@dataclass(frozen=True)
class GreyTone:
    number: int  # number of the area, as in ``GreyArea``
    pixels: int  # valid ones
    means: tuple[float, float, float]  # means of red, green and blue, DN
    place: tuple[float, float]  # the middle of its pixels, in the image's reference system


@dataclass(frozen=True)
class ColourBalance:
    """The difference of the colours of grey areas from grey."""

    value: float  # largest difference between the means of red, green and blue of all areas, share of the range
    means: tuple[float, float, float]  # means of red, green and blue over all areas, DN
    tones: tuple[GreyTone, ...]  # tones of the areas that counted
    worst: GreyTone  # the area whose bands differ most
    worst_value: float  # how much its bands differ, as a share of the range


@dataclass(frozen=True, eq=False)
class MaybeGrey:
    """The areas that may be grey, for somebody to look at."""

    corners: np.ndarray  # (n, 2): columns and rows of the upper left pixels of areas of 16 x 16
    means: np.ndarray  # (n, 3) of red, green and blue, DN
    spreads: np.ndarray  # (n,): largest difference between the bands, as a share of the range
    share: float  # share of these among all areas that were looked at

    @property
    def difference(self) -> float:
        """The largest difference between the bands over all of them, as a share of the range: their median."""
        return float(np.median(self.spreads))

    @property
    def middle(self) -> tuple[float, float]:
        """Column and row of the middle of the area that is nearest to the middle of all."""
        centres = self.corners + limits.AREA_PX / 2
        nearest = np.argmin(np.hypot(*(centres - np.median(centres, axis=0)).T))
        column, row = centres[nearest]
        return float(column), float(row)


def grey_tones(source: OpenRaster, window: PixelWindow, areas: Sequence[GreyArea]) -> tuple[GreyTone, ...]:
    """The colours of the areas that have valid pixels in a window of a north-up raster with red, green and blue.

    Raises RasterError when the raster can't be read.
    """
    return tuple(filter(None, (_tone(source, window, area) for area in areas)))


def _tone(source: OpenRaster, window: PixelWindow, area: GreyArea) -> GreyTone | None:
    grid = source.raster.grid
    geometry = ogr.CreateGeometryFromWkb(area.wkb)
    if geometry is None:  # QGIS keeps rings that GDAL has none of
        return None
    xmin, xmax, ymin, ymax = geometry.GetEnvelope()
    edges = np.array([[grid.column_at(xmin), grid.row_at(ymax)], [grid.column_at(xmax) + 1, grid.row_at(ymin) + 1]])
    if not np.isfinite(edges).all():
        return None
    first = window.column, window.row
    bounds = np.clip(np.floor(edges), first, np.add(first, (window.width, window.height))).astype(int)
    (left, top), (width, height) = bounds[0].tolist(), (bounds[1] - bounds[0]).tolist()
    if width <= 0 or height <= 0:
        return None
    count, sums, places = 0, np.zeros(3), np.zeros(2)
    for block in source.blocks(PixelWindow(left, top, width, height), limits.MAX_BLOCK_PIXELS):
        inside = burnt([(geometry, 1)], grid, block) == 1
        if not inside.any():
            continue
        bands, invalid = source.read(block)
        if invalid is not None:
            inside &= ~invalid
        rows, columns = np.nonzero(inside)
        count += len(rows)
        sums += bands[:3, rows, columns].sum(axis=1, dtype=np.float64)
        places += (block.column + columns + 0.5).sum(), (block.row + rows + 0.5).sum()
    if not count:
        return None
    red, green, blue = (sums / count).tolist()
    column, row = places / count
    return GreyTone(area.number, count, (red, green, blue), grid.to_map(column, row))


def colour_balance(tones: Sequence[GreyTone], available: ValueRange) -> ColourBalance | None:
    """The colour balance by grey areas; None where too few pixels of them are neither too dark nor too bright."""
    low, high = available
    least, most = (low + share * (high - low) for share in limits.GREY_TONES)
    usable = tuple(tone for tone in tones if least <= min(tone.means) and max(tone.means) <= most)
    if sum(tone.pixels for tone in usable) < limits.MIN_GREY_PIXELS:
        return None
    spreads = [(max(tone.means) - min(tone.means)) / (high - low) for tone in usable]
    red, green, blue = np.mean([tone.means for tone in usable], axis=0).tolist()
    value = (max(red, green, blue) - min(red, green, blue)) / (high - low)
    worst = int(np.argmax(spreads))
    return ColourBalance(value, (red, green, blue), usable, usable[worst], spreads[worst])


def find_maybe_grey(areas: Areas, available: ValueRange) -> MaybeGrey | None:
    """The areas that may be grey, for somebody to look at; None where there is none.

    They are uniform in red, green and blue, of mid-tone, and these differ by at most 10 % of the range. Whether they
    are grey, or bare soil under a clean light, or something blue under a warm one, no pixel tells.
    """
    means = areas.means[:, :3]
    spreads = np.ptp(means, axis=1) / (available[1] - available[0]) if len(means) else np.empty(0)
    chosen = areas.uniform[:, :3].all(axis=1) & _is_mid_tone(means, available).all(axis=1)
    chosen &= spreads <= limits.MAX_GREY_SPREAD
    if not chosen.any():
        return None
    return MaybeGrey(areas.corners[chosen], means[chosen], spreads[chosen], float(chosen.mean()))
