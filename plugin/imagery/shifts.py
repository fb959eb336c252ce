"""How one image lies on another: the sub-pixel shift by phase correlation (Kuglin and Hines 1975).

The phases of the two spectra alone decide, weighted towards the lower frequencies, which noise, blur and aliasing touch
least. It is measured on square tiles, so that the part of a mosaic that stems from another image does not take part:
the tile with the clearest peak leads, and those that agree with it are taken together.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache
from itertools import combinations, product
from typing import NamedTuple

import numpy as np
from scipy import fft, ndimage

MIN_SHIFT_PEAK = 0.15  # height of the phase correlation's peak that is no accident, in large tiles
MIN_SHIFT_PEAK_PX = 20.0  # over the tile's side, in small ones: unrelated tiles reach 15 / side
SAME_SHIFT_PX = 1.5  # tiles whose shifts, to the whole pixel, differ by less look at the same image
MIN_TILE_SHARE = 0.8  # of a tile's pixels have to come from the source whose shift is asked for


_Tile = tuple[int, int, int]
"""First row, first column and side, px."""

_TILE_PX, _LEAST_TILE_PX = 256, 32
_TILES_A_SIDE = 2
_ENOUGH_LARGE_TILES = 2  # that agree: strangers don't
_CUTOFF = 0.12  # cycles a pixel at which the weight has fallen to exp(-1/2)
_ALL_FREQUENCIES_PX = 128  # side of a tile that needs all; a larger one is as exact without the upper half of them
_STEPS, _ROUNDS = 8, 3  # of the fine search, each way: to 1/8, 1/64, 1/512 px
_SPLINE_REACH_PX = 12  # further away a sample of a cubic spline counts for less than 1e-6
_STRIDE = 4  # of the pixels of a mask that are looked at


@dataclass(frozen=True)
class Shift:
    """How far an image lies to the right of and below another, px."""

    x: float
    y: float
    peak: float
    """Height of the correlation's peak: 1 for equal images, near 0 for strangers."""

    @property
    def length(self) -> float:
        """Distance, px."""
        return float(np.hypot(self.x, self.y))


def farthest_apart(shifts: Sequence[Shift]) -> float:
    """The largest distance between two shifts, px; 0 where there are no two."""
    return max((float(np.hypot(a.x - b.x, a.y - b.y)) for a, b in combinations(shifts, 2)), default=0.0)


@dataclass(frozen=True, eq=False)
class Spectra:
    """An image that is compared with several others: the spectrum of each of its tiles is computed once."""

    pixels: np.ndarray
    """(rows, columns) of real type."""
    _known: dict[_Tile, np.ndarray] = field(default_factory=dict)

    def of(self, tile: _Tile) -> np.ndarray:
        """The spectrum of one tile less its mean, (rows, rows / 2 + 1), as far as it counts."""
        if tile not in self._known:
            row, column, side = tile
            pixels = self.pixels[row : row + side, column : column + side].astype(np.float32)
            pixels -= pixels.mean()
            pixels *= _plan(side).window
            half = _plan(side).half
            down = fft.fft(fft.rfft(pixels, axis=1)[:, : half + 1], axis=0)
            self._known[tile] = np.concatenate([down[:half], down[-half:]])
        return self._known[tile]


def shifted(image: np.ndarray, x: float, y: float) -> np.ndarray:
    """An image (rows, columns) of floating type, moved to the right and down by any distance; its edges are repeated.

    By cubic splines along one axis after the other.
    """
    return _moved(_moved(image, y, 0), x, 1)


def _moved(image: np.ndarray, by: float, axis: int) -> np.ndarray:
    whole = int(np.floor(-by))
    t = -by - whole
    pad = abs(whole) + _SPLINE_REACH_PX
    padded = np.pad(image, [(pad, pad) if axis == along else (0, 0) for along in (0, 1)], mode="edge")
    spline = ndimage.spline_filter1d(padded, 3, axis, image.dtype, "mirror")
    weights = (1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, 1 + 3 * t + 3 * t**2 - 3 * t**3, t**3
    made = np.zeros_like(image)
    for first, weight in enumerate(weights, pad + whole - 1):
        part = slice(first, first + image.shape[axis])
        made += image.dtype.type(weight / 6) * (spline[:, part] if axis else spline[part])
    return made


def find_shift(
    image: np.ndarray | Spectra, reference: np.ndarray | Spectra, where: np.ndarray | None = None
) -> Shift | None:
    """How ``image`` lies on ``reference``, both (rows, columns) of real type, or their ``Spectra``.

    ``where``, (rows, columns) bool, says which pixels matter: only tiles of mostly such pixels are looked at. None
    where there is no such tile, or none with a peak that stands out, so that no number is made up.
    """
    moved, fixed = (given if isinstance(given, Spectra) else Spectra(given) for given in (image, reference))
    peaks: list[tuple[Shift, np.ndarray]] = []
    agreeing: list[np.ndarray] = []
    leader = None
    tiles = _tiles(moved.pixels.shape, where)
    # First that which is farthest from the first one, since two may be enough.
    for tile in [*tiles[:1], *sorted(tiles[1:], key=lambda tile: -np.hypot(*np.subtract(tile, tiles[0])[:2]))]:
        side = tile[2]
        cross = fixed.of(tile).conj()
        cross *= moved.of(tile)
        magnitude = np.abs(cross)
        cross *= _plan(side).weights / np.maximum(magnitude, np.finfo(np.float32).tiny, out=magnitude)
        shift = _nearest_pixel(cross, _plan(side))
        if shift.peak < max(MIN_SHIFT_PEAK, MIN_SHIFT_PEAK_PX / side):
            continue
        peaks.append((shift, cross))
        leader = max((peak for peak, _ in peaks), key=lambda peak: peak.peak)
        agreeing = [phases for at, phases in peaks if np.hypot(at.x - leader.x, at.y - leader.y) < SAME_SHIFT_PX]
        if len(agreeing) >= _ENOUGH_LARGE_TILES and side > _ALL_FREQUENCIES_PX:
            break
    return None if leader is None else _refined(sum(agreeing) / len(agreeing), _plan(side), leader)


def _tiles(shape: tuple[int, ...], where: np.ndarray | None) -> list[_Tile]:
    """Tiles spread over the image, as large as they can be; of those the ones that lie mostly ``where`` it matters."""
    side = min(_TILE_PX, *shape[:2])
    if where is None:
        return [(row, column, side) for row, column in product(*_places(shape, side, _TILES_A_SIDE))]
    within = np.pad(where[::_STRIDE, ::_STRIDE].astype(np.int32).cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    while side >= _LEAST_TILE_PX:
        rows, columns = (np.array(places) for places in _places(shape, side, -(-2 * max(shape[:2]) // side)))
        top, bottom, left, right = (-(-edge // _STRIDE) for edge in (rows, rows + side, columns, columns + side))
        counts = within[bottom][:, right] - within[top][:, right] - within[bottom][:, left] + within[top][:, left]
        shares = (counts / np.outer(bottom - top, right - left)).ravel()
        fullest = np.argsort(-shares, kind="stable")[: _TILES_A_SIDE**2]
        fullest = fullest[shares[fullest] >= MIN_TILE_SHARE]
        if len(fullest):
            places = (divmod(int(number), len(columns)) for number in fullest)
            return [(int(rows[row]), int(columns[column]), side) for row, column in places]
        side //= 2
    return []


def _places(shape: tuple[int, ...], side: int, most: int) -> list[list[int]]:
    """First rows and first columns of tiles, evenly spread, up to ``most`` a side."""
    return [
        sorted({round(place) for place in np.linspace(0, length - side, min(most, -(-length // side) * 2 - 1))})
        for length in shape[:2]
    ]


class _TilePlan(NamedTuple):
    """What the comparison of two tiles of a side needs."""

    side: int
    half: int
    """Frequencies each way that count."""
    down: np.ndarray
    """Cycles a pixel of each row of a spectrum."""
    across: np.ndarray
    """Cycles a pixel of each column."""
    halves: np.ndarray
    """How often each column of a real image's half spectrum stands in the whole one."""
    window: np.ndarray
    weights: np.ndarray
    """Weight of each frequency; their sum over the whole spectrum is 1."""
    searches: list[tuple[np.ndarray, np.ndarray]]
    """For each round how a spectrum's rows and columns turn by the offsets tried, (offsets, rows or columns)."""


@cache
def _plan(side: int) -> _TilePlan:
    half = side // 2 if side <= _ALL_FREQUENCIES_PX else side // 4
    down, across = np.concatenate([np.arange(half), np.arange(-half, 0)]) / side, np.arange(half + 1) / side
    halves = np.where(across > 0, np.float32(2), np.float32(1))
    taper = np.hanning(side + 2)[1:-1].astype(np.float32)
    weights = np.exp(-0.5 * (across**2 + down[:, np.newaxis] ** 2) / _CUTOFF**2)
    weights[0, 0] = weights[half] = weights[:, half] = 0.0  # the mean, and what has no counterpart
    weights = (weights / (weights * halves).sum()).astype(np.float32)
    reaches = [_STEPS**-number for number in range(_ROUNDS)]
    tried = [np.linspace(-reach, reach, 2 * _STEPS + 1)[:, np.newaxis] for reach in reaches]
    searches = [(_turns(offsets, down), _turns(offsets, across)) for offsets in tried]
    return _TilePlan(side, half, down, across, halves, taper[:, np.newaxis] * taper, weights, searches)


def _nearest_pixel(cross: np.ndarray, plan: _TilePlan) -> Shift:
    """The highest point of the correlation, to the pixel; its height is that of the top itself, by a parabola."""
    count = len(cross)
    highest = np.unravel_index(fft.irfft2(cross, (count, count)).argmax(), (count, count))
    y, x = (round((place - count if place > count // 2 else place) * plan.side / count) for place in map(int, highest))
    around = np.arange(-2, 3)[:, np.newaxis]  # the correlation may have been looked at every second pixel only
    surface = _correlation(cross, plan, _turns(y + around, plan.down), _turns(x + around, plan.across))
    row, column = (int(place) + 1 for place in np.unravel_index(surface[1:-1, 1:-1].argmax(), (3, 3)))
    top = surface[row, column]
    peak = top
    for before, _, after in (surface[row - 1 : row + 2, column], surface[row, column - 1 : column + 2]):
        bend = 2 * top - before - after
        peak += (after - before) ** 2 / (8 * bend) if bend > 0 else 0.0
    return Shift(float(x + column - 2), float(y + row - 2), float(peak))


def _refined(cross: np.ndarray, plan: _TilePlan, start: Shift) -> Shift:
    """The shift ``start`` to a five hundredth of a pixel, by the sum of the spectrum itself."""
    x, y, reach, height = start.x, start.y, 1.0, start.peak
    for turns_down, turns_across in plan.searches:
        values = _correlation(cross, plan, turns_down * _turns(y, plan.down), turns_across * _turns(x, plan.across))
        i, j = np.unravel_index(values.argmax(), values.shape)
        offsets = np.linspace(-reach, reach, 2 * _STEPS + 1)
        x, y, reach, height = x + offsets[j], y + offsets[i], reach / _STEPS, values[i, j]
    return Shift(float(x), float(y), float(height))


def _correlation(cross: np.ndarray, plan: _TilePlan, turns_down: np.ndarray, turns_across: np.ndarray) -> np.ndarray:
    """The correlation of two tiles by their cross spectrum, at places given by how they turn it."""
    values: np.ndarray = (turns_down @ cross @ (turns_across * plan.halves).T).real
    return values


def _turns(by: float | np.ndarray, frequencies: np.ndarray) -> np.ndarray:
    return np.exp(2j * np.pi * by * frequencies).astype(np.complex64)
