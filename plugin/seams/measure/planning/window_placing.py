"""Windows along seams: where to measure, evenly, inside the mosaic and without measuring a place twice.

Every stretch of a seam inside the mosaic is divided evenly: as many windows as the spacing goes into its length
(rounded, at least one), exactly one spacing apart, the rest split between both ends. Each window so stands for
the stretch half a spacing to either side of it; where it would stick out of the mosaic, or hold too few valid
pixels, it is moved within that stretch, and dropped when it fits nowhere there."""
from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from operator import itemgetter
from typing import Callable

import numpy as np
from scipy import ndimage

from ....imagery import limits as imagery_limits
from ....imagery.errors import Message, SettingsError
from ....imagery.grids import Grid, PixelWindow, standard_side_px, standard_window
from ....imagery.lines import Seam, points_at, stretches_inside, vertex_stations
from ....imagery.records import Column
from .. import limits, messages

_MOST_PLACES = 12  # named in a sentence
MIN_SEAM_PX = 8  # around two or three pixels: noise of labels
MIN_SEAM_SHARE = 1 / 16  # of a window's side: a seam shorter and narrower than that is 0.4 % of the window


@dataclass(frozen=True)
class PlacedWindow:
    """A window on a seam."""

    window_id: int
    """1..n, in the order of seam and station."""
    seam_id: int
    """The seam it lies on."""
    station_m: float
    """Metres along the seam from its start to the window's centre."""
    window: PixelWindow
    """Its pixels on the mosaic's grid."""


PLACED_COLUMNS: tuple[Column[PlacedWindow], ...] = (
    Column("window_id", "integer", lambda placed: placed.window_id),
    Column("seam_id", "integer", lambda placed: placed.seam_id),
    Column("station", "real", lambda placed: placed.station_m),
)
"""Fields of placed windows."""


@dataclass(frozen=True)
class Placement:
    """Places to measure, and places not to."""

    windows: tuple[PlacedWindow, ...]
    dropped: tuple[Message, ...]
    """For the log, in a sentence a reason: places along seams that got no window, and those that need none."""


@dataclass(frozen=True)
class PlacingSettings:
    """How windows are placed."""

    side_m: float = imagery_limits.STANDARD_SIDE_M
    """Metres that a window spans at least."""
    spacing_m: float = limits.STANDARD_SPACING_M
    """Metres along the seam between windows."""
    levels: int = imagery_limits.DEFAULT_LEVELS
    """Levels of the decomposition, 1..8."""


def place_windows(
    seams: Sequence[Seam], grid: Grid, settings: PlacingSettings,
    is_valid: Callable[[PixelWindow], bool] = lambda window: True,
) -> Placement:
    """Standard windows along seams in the CRS of the mosaic, longest first.

    All windows lie inside the mosaic and are centred on their seam to half a pixel; no two on one seam share more
    than half of their pixels. A seam that lies within windows of longer ones gets none, nor does one shorter than
    a sixteenth of a window's side or than 8 px.

    Raises SettingsError when a length is not a positive number or the window is too small for the levels.
    """
    side_px = window_side_px(grid, settings)
    metres_x, metres_y = grid.pixel_width * grid.metres_x, grid.pixel_height * grid.metres_y
    if side_px > min(grid.columns, grid.rows):
        too_small = messages.MOSAIC_TOO_SMALL(
            width=grid.columns * metres_x, height=grid.rows * metres_y, side=side_px * max(metres_x, metres_y)
        )
        return Placement((), (too_small.as_warning(),))
    # Half a side apart windows share half of their pixels; one more pixel allows for the snapping.
    densest_m = (side_px / 2 + 1) * max(metres_x, metres_y)
    shortest_m = max(MIN_SEAM_SHARE * side_px, MIN_SEAM_PX) * grid.ground_sample_distance

    placed = WindowIndex(side_px)
    windows: list[PlacedWindow] = []
    places: list[str] = []
    left_out = crowded = 0
    for seam in seams:
        track = SeamTrack(seam, grid, side_px)
        inside = track.stretches()
        stretches = inside[np.diff(inside)[:, 0] >= shortest_m]
        if not len(stretches) or all(map(placed.covers, *grid.to_pixels(track.points_along(stretches)).T)):
            left_out += 1
        else:
            along, lost, too_near = _along(track, stretches, settings.spacing_m, densest_m, is_valid)
            for station, window in along:
                placed.add(window)
                windows.append(PlacedWindow(len(windows) + 1, seam.seam_id, station, window))
            for start, end in lost:
                places.append(f"{seam.seam_id} ({start:.1f}" + (f"\u2013{end:.1f} m)" if end > start else " m)"))
            crowded += too_near
    named = ", ".join([*places[:_MOST_PLACES], *["\u2026"] * (len(places) > _MOST_PLACES)])
    dropped = (
        (len(places), messages.PLACES_WITHOUT_WINDOW(count=len(places), places=named)),
        (crowded, messages.WINDOWS_CROWDED(count=crowded)),
        (left_out, messages.SEAMS_LEFT_OUT(count=left_out, shortest=shortest_m)),
    )
    return Placement(tuple(windows), tuple(sentence for count, sentence in dropped if count))


def _along(
    track: SeamTrack, stretches: np.ndarray, spacing_m: float, densest_m: float, is_valid: Callable[[PixelWindow], bool]
) -> tuple[list[tuple[float, PixelWindow]], list[list[float]], int]:
    """Windows on one seam.

    ``stretches``: (k, 2) stations in metres between which the seam lies inside the mosaic.

    Returns (station, window) in the order of stations; first and last station of each row of windows that would
    stick out or hold too few valid pixels; and how many windows were left out because they would share too much
    with another one.
    """
    spots = np.concatenate([_spots(start, end, max(spacing_m, densest_m)) for start, end in stretches])
    asked = sum(_count(start, end, spacing_m) for start, end in stretches)
    fitting = track.stretches(track.side_px / 2 - 0.499)  # a window is snapped by up to half a pixel
    inside = ((fitting[:, 0] <= spots[:, :1]) & (spots[:, :1] <= fitting[:, 1])).any(axis=1)
    taken = WindowIndex(track.side_px)
    along: list[tuple[float, PixelWindow]] = []
    too_near = asked - len(spots)
    to_move = ~inside
    for number, window in zip(np.flatnonzero(inside), track.windows(spots[inside, 0])):
        if taken.shares_too_much(window):
            too_near += 1
        elif is_valid(window):
            taken.add(window)
            along.append((float(spots[number, 0]), window))
        else:
            to_move[number] = True

    lost = np.zeros(len(spots), dtype=bool)
    for number in np.flatnonzero(to_move):
        stations = track.nearby(fitting, *spots[number])
        for moved, window in zip(stations.tolist(), track.windows(stations)):
            if not taken.shares_too_much(window) and is_valid(window):
                taken.add(window)
                along.append((moved, window))
                break
        else:
            lost[number] = True
    rows = [spots[row][[0, -1], 0].tolist() for row in ndimage.find_objects(ndimage.label(lost)[0])]
    return sorted(along, key=itemgetter(0)), rows, too_near


def _count(start: float, end: float, spacing_m: float) -> int:
    """How many windows a stretch gets."""
    return max(1, math.floor((end - start) / spacing_m + 0.5))


def _spots(start: float, end: float, spacing_m: float) -> np.ndarray:
    """(n, 3): stations of windows on a stretch, and from where to where each stands for the seam, metres."""
    count = _count(start, end, spacing_m)
    station = (start + end - (count - 1) * spacing_m) / 2 + spacing_m * np.arange(count)
    between = (station[1:] + station[:-1]) / 2
    return np.column_stack([station, np.append(start, between), np.append(between, end)])


SIDES_ACROSS = 4  # of a mosaic that is too small for the window that was asked for
LONGEST_SIDE_PX = 2 ** int(math.log2(math.sqrt(imagery_limits.MAX_WINDOW_PIXELS)))
"""Longest side of a square window that is not too large."""


def window_side_px(grid: Grid, settings: PlacingSettings) -> int:
    """The side of a window in pixels. Raises SettingsError, see ``place_windows``."""
    side_px, levels = standard_side_px(grid, settings.side_m), settings.levels
    if not (math.isfinite(settings.spacing_m) and settings.spacing_m > 0):
        raise SettingsError(messages.SPACING_NOT_POSITIVE(spacing=settings.spacing_m))
    fewest = max(imagery_limits.MIN_SIDE_PX, 2**levels)
    if side_px < fewest:  # both are powers of two, so any longer side is a multiple of 2 ** levels
        metres = math.ceil(fewest * grid.ground_sample_distance * 100) / 100
        raise SettingsError(
            messages.SIDE_TOO_SHORT(side=settings.side_m, pixels=side_px, levels=levels, fewest=fewest, metres=metres)
        )
    return side_px


def fitting_side_m(grid: Grid, settings: PlacingSettings) -> float:
    """The side itself where mosaic and levels allow it; else one that they do, in centimetres.

    The standard side grows to as many pixels as it takes to measure, unless no window fits on the mosaic.
    """
    side_m, shorter = settings.side_m, min(grid.columns, grid.rows)
    fewest = max(imagery_limits.MIN_SIDE_PX, 2**settings.levels)
    if shorter >= limits.MEASURABLE_SIDE_PX:
        fewest = max(fewest, limits.MEASURABLE_SIDE_PX)
    wanted = fewest
    with suppress(SettingsError):
        asked = window_side_px(grid, settings)
        if asked >= fewest or side_m != imagery_limits.STANDARD_SIDE_M:
            if asked <= min(shorter, LONGEST_SIDE_PX):
                return side_m
            across = 2 ** int(math.log2(max(shorter / SIDES_ACROSS, 1)))
            wanted = min(max(across, fewest), LONGEST_SIDE_PX)
    if wanted > shorter:
        return side_m
    return max(math.floor(100 * wanted * grid.ground_sample_distance + 1e-6) / 100, 0.1)


SMALLEST_SIDE_PX = 128
"""Beside missing pixels; below it there is no ground around the seam to compare it with."""


def fitting_window(
    x: float, y: float, grid: Grid, side: int, is_valid: Callable[[PixelWindow], bool]
) -> PixelWindow | None:
    """The window around a place, else the first of those aside that holds it, else of smaller ones."""
    while True:
        window = standard_window(grid, x, y, side)
        for down, across in ((i, j) for i in (0, -1, 1) for j in (0, -1, 1)):
            by = side * (2 if down and across else 3) // 8  # farther off the middle a seam would but clip a corner
            moved = window.moved_by(by * across, by * down).moved_into(grid.columns, grid.rows)
            if is_valid(moved):
                return moved
        side //= 2
        if side < SMALLEST_SIDE_PX:
            return None


MAX_SHARED_SHARE = 0.5  # two windows on one seam share at most half of their pixels


class WindowIndex:
    """Windows of one size by place."""

    def __init__(self, side_px: int) -> None:
        self._side, self._corners = side_px, np.empty((0, 2))

    def add(self, window: PixelWindow) -> None:
        """Take a window in."""
        self._corners = np.append(self._corners, [[window.column, window.row]], axis=0)

    def covers(self, column: float, row: float) -> bool:
        """Whether a place lies in a window."""
        inside = (column, row) - self._corners
        return bool(((inside >= 0) & (inside <= self._side)).all(axis=1).any())

    def shares_too_much(self, window: PixelWindow) -> bool:
        """Whether a window shares more than half of its pixels with one that is here."""
        shared = np.maximum(self._side - abs(self._corners - (window.column, window.row)), 0).prod(axis=1)
        return bool((shared > MAX_SHARED_SHARE * self._side**2).any())


class SeamTrack:
    """A seam on the mosaic's pixel grid, by station."""

    def __init__(self, seam: Seam, grid: Grid, side_px: int) -> None:
        self.side_px = side_px
        self._grid = grid
        self._vertices = seam.vertices
        self._station = vertex_stations(seam.vertices * (grid.metres_x, grid.metres_y))
        self._pixels = grid.to_pixels(seam.vertices)

    def windows(self, stations: np.ndarray) -> list[PixelWindow]:
        """The window centred at each station."""
        places = points_at(self._vertices, self._station, stations)
        return [standard_window(self._grid, x, y, self.side_px) for x, y in places]

    def nearby(self, fitting: np.ndarray, station: float, first: float, last: float) -> np.ndarray:
        """Stations from first to last that lie in the stretches (k, 2), an eighth of a window apart, nearest first."""
        within = fitting[(fitting[:, 0] <= last) & (fitting[:, 1] >= first)]
        starts, ends = np.maximum(within[:, 0], first), np.minimum(within[:, 1], last)
        every = np.concatenate([np.clip(station, starts, ends), *self._spaced(zip(starts, ends))])
        return every[np.argsort(abs(every - station), kind="stable")]

    def points_along(self, stretches: np.ndarray) -> np.ndarray:
        """(n, 2) places on the map along stretches, an eighth of a window apart."""
        return points_at(self._vertices, self._station, np.concatenate(self._spaced(stretches)))

    def _spaced(self, stretches: Iterable[tuple[float, float]]) -> list[np.ndarray]:
        """Stations along each stretch, an eighth of a window apart."""
        step = self.side_px * self._grid.ground_sample_distance / 8
        return [np.linspace(start, end, math.ceil((end - start) / step) + 1) for start, end in stretches]

    def stretches(self, margin: float = 0.0) -> np.ndarray:
        """(k, 2): stations between which the seam lies inside the mosaic, as many pixels from its edges."""
        far = np.array([self._grid.columns, self._grid.rows]) - margin
        return stretches_inside(self._pixels, self._station, np.array([margin, margin]), far)
