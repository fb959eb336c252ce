"""The piece of a seam that lies nearest to a place, for millions of places."""
from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from ....imagery.grids import Grid, PixelWindow
from ....imagery.lines import as_xy
from .seam_pieces import SeamPiece

STEP_PX = 0.5
"""Lines are looked up by points at most this far apart; the distance is then taken to the line itself."""
_SHORTEST_PX = 1e-6  # of a stretch, to divide by: some have no length

_STRETCH = np.dtype(
    [("start", complex), ("step", complex), ("number", np.int64), ("station", float), ("metres", float)]
)
"""A straight stretch of a piece: where it starts and what it adds (column + 1j row, px), the piece's number, and on the
ground where it starts along the seam and how long it is (m)."""


@dataclass(frozen=True, eq=False)
class NearestPieces:
    """Places along and beside the pieces nearest to them; all arrays of one shape."""

    number: np.ndarray
    """int: of the piece, -1 where none is in reach; the rest is then of no meaning."""
    distance_px: np.ndarray
    """float64: to the piece, infinite where none is in reach."""
    on_left: np.ndarray
    """bool: on the left hand of who walks along the piece (outside a bend of more than 90 degrees it may err)."""
    station_m: np.ndarray
    """float64: metres along the seam where the nearest point of the piece lies."""


class PieceIndex:
    """The pieces of all seams, or those near one block, by place.

    Places are columns and rows of the mosaic as real numbers: 0 is the left (upper) edge of the first pixel, 0.5 its
    middle. Pieces are numbered as they were given, also in the part of an index that ``near`` returns. Plain arrays:
    it can be sent to another process, and threads may share it.
    """

    def __init__(self, pieces: Iterable[SeamPiece], grid: Grid) -> None:
        held = list(pieces)
        if not held:
            self._stretches = np.empty(0, dtype=_STRETCH)
            return
        places = np.concatenate([piece.vertices for piece in held])
        number = np.repeat(np.arange(len(held)), [len(piece.vertices) for piece in held])
        within = number[1:] == number[:-1]
        x, y = places.T
        line = grid.column_at(x) + 1j * grid.row_at(y)
        metres = np.where(within, np.hypot(np.diff(x) * grid.metres_x, np.diff(y) * grid.metres_y), 0)
        # Metres since the first vertex of all, less those up to the piece's own first vertex.
        passed = np.append(0, np.cumsum(metres))
        first = np.searchsorted(number, np.arange(len(held)))
        station = np.array([piece.station_m for piece in held])[number] + passed - passed[first[number]]
        stretches = np.empty(len(line) - 1, dtype=_STRETCH)
        stretches["start"], stretches["step"], stretches["number"] = line[:-1], np.diff(line), number[:-1]
        stretches["station"], stretches["metres"] = station[:-1], metres
        self._stretches = stretches[within]

    def __len__(self) -> int:
        """How many straight stretches it holds."""
        return len(self._stretches)

    @property
    def numbers(self) -> np.ndarray:
        """The pieces that it holds, ascending."""
        return np.unique(self._stretches["number"])

    def near(self, window: PixelWindow, reach_px: float) -> PieceIndex:
        """The part of the index with all that lies within ``reach_px`` of a window; pieces keep their numbers."""
        left, top = window.column - reach_px, window.row - reach_px
        right, bottom = window.column + window.width + reach_px, window.row + window.height + reach_px
        start, stop = self._stretches["start"], self._stretches["start"] + self._stretches["step"]
        met = (np.minimum(start.real, stop.real) <= right) & (np.maximum(start.real, stop.real) >= left)
        met &= (np.minimum(start.imag, stop.imag) <= bottom) & (np.maximum(start.imag, stop.imag) >= top)
        part = PieceIndex.__new__(PieceIndex)
        part._stretches = self._stretches[met]
        return part

    def beside(self, columns: np.ndarray, rows: np.ndarray, reach_px: float) -> NearestPieces:
        """The nearest piece of each place within ``reach_px``, how far off it is, the side of it that the place is on,
        and where along the seam.

        ``columns``, ``rows``: real numbers, broadcast to one shape. The distance is true to 0.1 px.
        """
        columns, rows = np.broadcast_arrays(np.asarray(columns, dtype=float), np.asarray(rows, dtype=float))
        places = columns.ravel() + 1j * rows.ravel()
        number, distance = np.full(len(places), -1), np.full(len(places), np.inf)
        on_left, station = np.zeros(len(places), dtype=bool), np.zeros(len(places))
        if len(self) and len(places):
            hit, stretch = self._nearest_of(places, reach_px)
            along = _along(stretch, places[hit]).clip(0, 1)
            away = places[hit] - stretch["start"] - along * stretch["step"]
            kept = abs(away) <= reach_px
            hit, stretch, away, along = hit[kept], stretch[kept], away[kept], along[kept]
            number[hit], distance[hit] = stretch["number"], abs(away)
            on_left[hit] = (away * stretch["step"].conj()).imag < 0  # rows run down
            station[hit] = stretch["station"] + along * stretch["metres"]
        shape = columns.shape
        return NearestPieces(
            number.reshape(shape), distance.reshape(shape), on_left.reshape(shape), station.reshape(shape)
        )

    def _nearest_of(self, places: np.ndarray, reach_px: float) -> tuple[np.ndarray, np.ndarray]:
        """The places that have a stretch about in reach, and those stretches."""
        column, row = int(np.floor(places.real.min())), int(np.floor(places.imag.min()))
        width, height = int(np.ceil(places.real.max())) - column, int(np.ceil(places.imag.max())) - row
        stretches = self.near(PixelWindow(column, row, width, height), reach_px)._stretches
        counts = np.maximum(np.ceil(abs(stretches["step"]) / STEP_PX), 1).astype(int)
        # Of a long stretch, which may run far beyond, only points about the places are made.
        middle, half = complex(column + width / 2, row + height / 2), max(width, height) / 2 + reach_px + 2 * STEP_PX
        along, length = _along(stretches, middle), abs(stretches["step"]) / counts
        spread = np.sqrt(2) * half / np.maximum(length, _SHORTEST_PX) + 1
        first = np.floor((along * counts - spread).clip(0, counts)).astype(int)
        number = np.ceil((along * counts + spread).clip(0, counts)).astype(int) - first
        of_point = np.repeat(np.arange(len(stretches)), number)
        place = np.arange(len(of_point)) - np.repeat(np.cumsum(number) - number, number) + first[of_point]
        share = (place + 0.5) / counts[of_point]
        points = stretches["start"][of_point] + share * stretches["step"][of_point]
        # What is out of reach isn't looked up.
        reached = (abs(points.real - column - width / 2) <= width / 2 + reach_px + STEP_PX) & (
            abs(points.imag - row - height / 2) <= height / 2 + reach_px + STEP_PX
        )
        points, of_point = points[reached], of_point[reached]
        if not len(points):
            return np.empty(0, dtype=int), stretches[:0]
        tree = cKDTree(as_xy(points), balanced_tree=False, compact_nodes=False)
        _, nearest = tree.query(as_xy(places), distance_upper_bound=reach_px + STEP_PX)
        hit = np.flatnonzero(nearest < len(points))
        return hit, stretches[of_point[nearest[hit]]]


def _along(stretches: np.ndarray, places: complex | np.ndarray) -> np.ndarray:
    """A place along each stretch: 0 at its start, 1 at its end, less or more beyond them."""
    step = stretches["step"]
    away = (places - stretches["start"]) * step.conj()
    return np.asarray(away.real / np.maximum(abs(step) ** 2, np.finfo(float).tiny))
