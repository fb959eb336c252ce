"""Windows along seams: where to measure, evenly, inside the mosaic and without measuring a place twice.

Every stretch of a seam inside the mosaic is divided evenly: as many windows as the spacing goes into its length
(rounded, at least one), exactly one spacing apart, the rest split between both ends. Each window so stands for
the stretch half a spacing to either side of it; where it would stick out of the mosaic, or hold too few valid
pixels, it is moved within that stretch, and dropped when it fits nowhere there.
"""
from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Callable

import numpy as np

from ....imagery import limits as imagery_limits
from ....imagery.errors import Message
from ....imagery.grids import Grid, PixelWindow
from ....imagery.lines import Seam
from .. import limits, messages
from .seam_track import SeamTrack
from .window_index import WindowIndex
from .window_sides import window_side_px

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


@dataclass(frozen=True)
class Placement:
    """Where to measure, and where not."""

    windows: tuple[PlacedWindow, ...]
    dropped: tuple[Message, ...]
    """For the log: each stretch of a seam that got no window, and in one sentence a reason those that need none."""


def place_windows(
    seams: Sequence[Seam],
    grid: Grid,
    side_m: float = imagery_limits.STANDARD_SIDE_M,
    spacing_m: float = limits.STANDARD_SPACING_M,
    levels: int = imagery_limits.DEFAULT_LEVELS,
    is_valid: Callable[[PixelWindow], bool] = lambda window: True,
) -> Placement:
    """Standard windows along seams.

    ``seams``: in the CRS of the mosaic, longest first. ``side_m``: metres that a window spans at least.
    ``spacing_m``: metres along the seam between windows. ``levels``: of the decomposition, 1..8.

    All windows lie inside the mosaic and are centred on their seam to half a pixel; no two on one seam share more
    than half of their pixels. A seam that lies within windows of longer ones gets none, nor does one shorter than
    a sixteenth of a window's side or than 8 px.

    Raises SettingsError when a length is not a positive number or the window is too small for the levels.
    """
    side_px = window_side_px(grid, side_m, spacing_m, levels)
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
    dropped: list[Message] = []
    outside = tiny = covered = crowded = 0
    for seam in seams:
        track = SeamTrack(seam, grid, side_px)
        inside = track.stretches(0, 0, grid.columns, grid.rows)
        stretches = inside[np.diff(inside)[:, 0] >= shortest_m]
        if not np.diff(inside).any():
            outside += 1
        elif not len(stretches):
            tiny += 1
        elif all(map(placed.covers, *track.pixels_along(stretches).T)):
            covered += 1
        else:
            found, lost, too_near = _along(track, stretches, spacing_m, densest_m, is_valid)
            for station, window in found:
                placed.add(window)
                windows.append(PlacedWindow(len(windows) + 1, seam.seam_id, station, window))
            dropped += [_lost(seam.seam_id, start, end) for start, end in lost]
            crowded += too_near
    dropped += _summary(crowded, covered, tiny, shortest_m, outside)
    return Placement(tuple(windows), tuple(dropped))


def _summary(crowded: int, covered: int, tiny: int, shortest_m: float, outside: int) -> Iterator[Message]:
    """What the log says about windows and seams that are too many to name."""
    if crowded:
        yield messages.WINDOWS_CROWDED(count=crowded)
    if covered:
        yield messages.SEAMS_COVERED(count=covered)
    if tiny:
        yield messages.SEAMS_TINY(count=tiny, shortest=shortest_m)
    if outside:
        yield messages.SEAMS_OUTSIDE(count=outside)


def _lost(seam_id: int, start: float, end: float) -> Message:
    """What the log says about windows from one station to another that found no place."""
    if start == end:
        return messages.STATION_WITHOUT_WINDOW(seam=seam_id, station=start)
    return messages.STRETCH_WITHOUT_WINDOW(seam=seam_id, start=start, end=end)


def _along(
    track: SeamTrack, stretches: np.ndarray, spacing_m: float, densest_m: float, is_valid: Callable[[PixelWindow], bool]
) -> tuple[list[tuple[float, PixelWindow]], list[tuple[float, float]], int]:
    """Windows on one seam.

    ``stretches``: (k, 2) stations in metres between which the seam lies inside the mosaic.

    Returns (station, window) in the order of stations; first and last station of each row of windows that would
    stick out or hold too few valid pixels; and how many windows were left out because they would share too much
    with another one.
    """
    spots = np.concatenate([_spots(start, end, max(spacing_m, densest_m)) for start, end in stretches])
    asked = sum(_count(start, end, spacing_m) for start, end in stretches)
    fitting = track.fitting_stretches()
    inside = ((fitting[:, 0] <= spots[:, :1]) & (spots[:, :1] <= fitting[:, 1])).any(axis=1)
    taken = WindowIndex(track.side_px)
    found: list[tuple[float, PixelWindow]] = []
    too_near = asked - len(spots)
    to_move = ~inside
    for number, window in zip(np.flatnonzero(inside), track.windows(spots[inside, 0])):
        if taken.shares_too_much(window):
            too_near += 1
        elif is_valid(window):
            taken.add(window)
            found.append((float(spots[number, 0]), window))
        else:
            to_move[number] = True

    lost = np.zeros(len(spots), dtype=bool)
    for number in np.flatnonzero(to_move):
        stations = track.nearby(fitting, *spots[number])
        for moved, window in zip(stations.tolist(), track.windows(stations)):
            if not taken.shares_too_much(window) and is_valid(window):
                taken.add(window)
                found.append((moved, window))
                break
        else:
            lost[number] = True
    return sorted(found, key=lambda one: one[0]), list(_rows(spots[:, 0], lost)), too_near


def _count(start: float, end: float, spacing_m: float) -> int:
    """How many windows a stretch gets."""
    return max(1, math.floor((end - start) / spacing_m + 0.5))


def _spots(start: float, end: float, spacing_m: float) -> np.ndarray:
    """(n, 3): stations of windows on a stretch, and from where to where each stands for the seam, metres."""
    count = _count(start, end, spacing_m)
    station = (start + end - (count - 1) * spacing_m) / 2 + spacing_m * np.arange(count)
    between = (station[1:] + station[:-1]) / 2
    return np.column_stack([station, np.append(start, between), np.append(between, end)])


def _rows(stations: np.ndarray, chosen: np.ndarray) -> Iterator[tuple[float, float]]:
    """First and last station of every row of chosen ones."""
    edge = np.diff(np.concatenate([[0], chosen.astype(int), [0]]))
    for first, after in zip(np.flatnonzero(edge > 0), np.flatnonzero(edge < 0)):
        yield float(stations[first]), float(stations[after - 1])
