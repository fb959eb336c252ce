"""Windows chosen on an image: spread over its valid part, where it is least saturated."""
from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from ...imagery import limits as imagery_limits
from ...imagery.grids import PixelWindow
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster, value_range

NOISE_WINDOW_PX = 1024  # side of a window; Pyka 2009, section 3
NOISE_SHRINK = 8  # every 8th pixel shows where an image is saturated or invalid
NOISE_WINDOWS = 25  # at most, chosen on an image; Pyka 2009, section 3: 25 fragments
MAX_NOISE_PLACES = 10  # places along an image's side that are looked at: 100 reduced reads at most
SATURATION_STEP = 0.005  # windows whose saturated shares differ by less are alike and are chosen by their spread

Allowed = Callable[[PixelWindow], bool]


@dataclass(frozen=True)
class _Place:
    """A place that was looked at."""

    window: PixelWindow
    apart: bool  # whether it belongs to the places that do not overlap each other
    lowest: float  # smallest value of the bands there
    at_lowest: float  # share of pixels that hold it in one band or another
    highest: float
    at_highest: float


def choose_windows(
    source: OpenRaster, levels: int, region: PixelWindow | None = None, allowed: Allowed = lambda window: True
) -> list[PixelWindow]:
    """Up to 25 square windows of an image, 1024 px, that do not overlap, those with the least saturation first.

    Parameters
    ----------
    levels : int
        Levels of the decomposition: no window is smaller than ``2 ** levels`` px.
    region : PixelWindow, optional
        The part of the image in which they lie; all of it when left out.
    allowed : callable
        Whether a window may be chosen.

    Looks at up to 10 x 10 places by
    every 8th pixel, so the time does not grow with the raster. Places with an invalid pixel among those are
    left out, and so are those that are not ``allowed``. Saturated is a pixel with the
    lowest or highest value of the available range in any band; where the range is not known (float), none is.
    Among places whose saturated shares differ by less than half a per cent, the one farthest from all chosen
    before is next, the first one being nearest to the middle; places side by side come before those between them.

    Where no place of 1024 px is valid, the side is halved, down to 64 px. Empty when even then there is none.

    Raises RasterError when the raster can't be read.
    """
    region = region or source.raster.whole
    side = min(NOISE_WINDOW_PX, 2 ** int(math.log2(min(region.width, region.height))))
    while side >= max(imagery_limits.MIN_SIDE_PX, 2**levels):
        places = [
            place
            for window, apart in _lattice(region, side)
            if allowed(window) and (place := _look(source, window, apart)) is not None
        ]
        if places:
            return _spread(places, _saturated_shares(source.raster, places), _centre(region))
        side //= 2
    return []


def _lattice(region: PixelWindow, side: int) -> Iterator[tuple[PixelWindow, bool]]:
    """Places half a side apart or farther, away from the edges, and whether they belong to those without overlap."""
    lefts, tops = (_starts(length, side) for length in (region.width, region.height))
    for i, top in enumerate(tops):
        for j, left in enumerate(lefts):
            yield PixelWindow(region.column + left, region.row + top, side, side), i % 2 == j % 2 == 0


def _starts(length: int, side: int) -> list[int]:
    """Starts of as many windows as fit side by side, equal gaps between them and to the edges, and those half way."""
    fitting = length // side
    gap = (length - fitting * side) / (fitting + 1)
    count = min(2 * fitting - 1, MAX_NOISE_PLACES)
    return [round(start) for start in np.linspace(gap, length - side - gap, count)]


def _look(source: OpenRaster, window: PixelWindow, apart: bool) -> _Place | None:
    """The values at a place, by few of its pixels; None when any of them is invalid."""
    bands, invalid = source.thinned(window, min(NOISE_SHRINK, window.width // 16))
    if invalid is not None and invalid.any():
        return None
    lowest, highest = bands.min(), bands.max()
    at_lowest, at_highest = ((bands == value).any(axis=0).mean() for value in (lowest, highest))
    return _Place(window, apart, float(lowest), float(at_lowest), float(highest), float(at_highest))


def _saturated_shares(image: Raster, places: list[_Place]) -> list[float]:
    available = value_range(image, max(place.highest for place in places))
    if available is None:
        return [0.0] * len(places)
    low, high = available
    return [place.at_lowest * (place.lowest <= low) + place.at_highest * (place.highest >= high) for place in places]


def _spread(places: list[_Place], shares: list[float], middle: tuple[float, float]) -> list[PixelWindow]:
    """The windows to take, in the order in which they are chosen."""
    classes = [(int(share / SATURATION_STEP), not place.apart) for share, place in zip(shares, places)]
    chosen: list[PixelWindow] = []
    remaining = list(range(len(places)))
    while remaining and len(chosen) < NOISE_WINDOWS:
        best = min(classes[index] for index in remaining)
        alike = [index for index in remaining if classes[index] == best]
        if chosen:
            index = max(alike, key=lambda i: min(_distance(places[i].window, _centre(window)) for window in chosen))
        else:
            index = min(alike, key=lambda i: _distance(places[i].window, middle))
        chosen.append(places[index].window)
        remaining = [i for i in remaining if not places[i].window.shared_pixels(chosen[-1])]
    return chosen


def _centre(window: PixelWindow) -> tuple[float, float]:
    return window.column + window.width / 2, window.row + window.height / 2


def _distance(window: PixelWindow, point: tuple[float, float]) -> float:
    return math.dist(_centre(window), point)
