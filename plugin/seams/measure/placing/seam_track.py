"""A seam on the mosaic's pixel grid: windows and places along it, and where it lies inside."""
from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from ....imagery.grids import Grid, PixelWindow, standard_window
from ....imagery.lines import Seam, points_at, vertex_stations


class SeamTrack:
    """A seam on the mosaic's pixel grid, by station."""

    def __init__(self, seam: Seam, grid: Grid, side_px: int) -> None:
        self.side_px = side_px
        self._grid = grid
        self._vertices = seam.vertices
        self._station = vertex_stations(seam.vertices * (grid.metres_x, grid.metres_y))
        self._pixels = grid.to_pixels(seam.vertices)

    def _points(self, stations: np.ndarray) -> np.ndarray:
        """(n, 2) on the map."""
        return points_at(self._vertices, self._station, stations)

    def windows(self, stations: np.ndarray) -> list[PixelWindow]:
        """The window centred at each station."""
        return [standard_window(self._grid, x, y, self.side_px) for x, y in self._points(stations)]

    def nearby(self, fitting: np.ndarray, station: float, first: float, last: float) -> np.ndarray:
        """Stations from first to last that lie in the stretches (k, 2), an eighth of a window apart, nearest first."""
        within = fitting[(fitting[:, 0] <= last) & (fitting[:, 1] >= first)]
        starts, ends = np.maximum(within[:, 0], first), np.minimum(within[:, 1], last)
        every = np.concatenate([np.clip(station, starts, ends), *self._spaced(zip(starts, ends))])
        return every[np.argsort(abs(every - station), kind="stable")]

    def pixels_along(self, stretches: np.ndarray) -> np.ndarray:
        """(n, 2) columns and rows along stretches, an eighth of a window apart."""
        return self._grid.to_pixels(self._points(np.concatenate(self._spaced(stretches))))

    def _spaced(self, stretches: Iterable[tuple[float, float]]) -> list[np.ndarray]:
        """Stations along each stretch, an eighth of a window apart."""
        step = self.side_px * self._grid.ground_sample_distance / 8
        return [np.linspace(start, end, math.ceil((end - start) / step) + 1) for start, end in stretches]

    def fitting_stretches(self) -> np.ndarray:
        """(k, 2): stations between which a window centred on the seam lies inside the mosaic."""
        margin = self.side_px / 2 - 0.499  # a window is snapped by up to half a pixel
        return self.stretches(margin, margin, self._grid.columns - margin, self._grid.rows - margin)

    def stretches(self, left: float, top: float, right: float, bottom: float) -> np.ndarray:
        """(k, 2): stations between which the seam lies inside a rectangle of columns and rows (Liang-Barsky)."""
        low, high = np.array([left, top]), np.array([right, bottom])
        start, step = self._pixels[:-1], np.diff(self._pixels, axis=0)
        along = step != 0
        safe = np.where(along, step, 1)
        beside = np.where((low <= start) & (start <= high), np.inf, -np.inf)  # runs parallel: wholly in or out
        enter = np.where(along, np.minimum((low - start) / safe, (high - start) / safe), -beside)
        leave = np.where(along, np.maximum((low - start) / safe, (high - start) / safe), beside)
        enter, leave = np.maximum(enter.max(axis=1), 0), np.minimum(leave.min(axis=1), 1)
        crosses = enter <= leave
        station, length = self._station[:-1][crosses], np.diff(self._station)[crosses]
        first, last = station + enter[crosses] * length, station + leave[crosses] * length
        apart = first[1:] > last[:-1] + 1e-9 * self._station[-1]  # else the seam goes on at a vertex
        return np.column_stack([first[np.append(True, apart)[: len(first)]], last[np.append(apart, True)[: len(last)]]])
