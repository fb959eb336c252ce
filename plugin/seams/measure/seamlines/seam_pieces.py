"""Seams cut in pieces of nearly equal length on the ground, which are judged one by one; what lies beside them, and
which of them is nearest to a place, for millions of places."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Union

import numpy as np
from scipy.spatial import cKDTree

from ....imagery.errors import Message
from ....imagery.grids import Grid, PixelWindow
from ....imagery.lines import as_xy, points_at, stretches_inside, vertex_stations
from .. import messages
from ..seam_cells import NONE

TOLD_OUTSIDE_M = 1.0
"""Less than this beyond the mosaic's edge is how lines end, and nothing to tell."""

Side = Union[int, str, None]
"""A source beside a seam: its number or its name; None where nothing says."""


@dataclass(frozen=True, eq=False)
class SidedSeam:
    """A seam with what lies beside it, where the producer or the labels of the mosaic say so."""

    vertices: np.ndarray
    """(n, 2) float64 map units, n >= 2; first and last are equal when it is a ring."""
    left: Side
    """On the left hand of who walks along the vertices: the source's number; or what a producer says that the mosaic
    was made from, an orthoimage's name, else a date."""
    right: Side
    """What lies on the right hand. Producers' left and right are often exchanged; ``sided`` sets them right."""

    @property
    def length(self) -> float:
        """Map units."""
        return float(vertex_stations(self.vertices)[-1])


@dataclass(frozen=True)
class SeamPiece:
    """A stretch of a seam that is measured as one."""

    seam_id: int
    """1..n, in the order of the seams."""
    station_m: float
    """Its start, metres along the seam as it was given."""
    length_m: float
    """Metres on the ground."""
    vertices: np.ndarray = field(compare=False)
    """(n, 2) float64 map units, n >= 2."""
    left: Side
    """The source on the left hand of who walks along the vertices."""
    right: Side
    """The source on the right hand."""

    @property
    def middle(self) -> tuple[float, float]:
        """Map units."""
        along = vertex_stations(self.vertices)
        x, y = points_at(self.vertices, along, along[-1:] / 2)[0].tolist()
        return x, y


def cut_in_pieces(seams: Iterable[SidedSeam], piece_m: float, grid: Grid) -> list[SeamPiece]:
    """Seams in pieces of equal length each, as close to ``piece_m`` metres as their length allows.

    What lies outside the mosaic's grid is cut off, parts inside that are shorter than a pixel too; ``cut_off`` tells
    it. A seam shorter than half a piece is one piece.
    """
    scale = np.array([grid.metres_x, grid.metres_y])
    pieces = []
    for seam_id, seam in enumerate(seams, start=1):
        for part, station in _inside(seam.vertices * scale, grid):
            along = vertex_stations(part)
            count = max(1, round(along[-1] / piece_m))
            cuts = np.linspace(0, along[-1], count + 1)
            length = float(along[-1] / count)
            for start, vertices in zip(cuts.tolist(), cut_at(part, along, cuts)):
                pieces.append(SeamPiece(seam_id, station + start, length, vertices / scale, seam.left, seam.right))
    return pieces


def cut_at(path: np.ndarray, along: np.ndarray, cuts: np.ndarray) -> Iterator[np.ndarray]:
    """What lies of a path, (n, 2), from each cut to the next; stations ``along`` its vertices and of the ``cuts``."""
    places = points_at(path, along, cuts)
    # Vertices strictly between two cuts are the part's own.
    first = np.searchsorted(along, cuts, side="right")
    last = np.searchsorted(along, cuts, side="left")
    for i in range(len(cuts) - 1):
        yield np.concatenate([places[i : i + 1], path[first[i] : last[i + 1]], places[i + 1 : i + 2]])


def joined_pieces(pieces: Sequence[SeamPiece]) -> SeamPiece:
    """Pieces that follow one another as one."""
    first, *others = pieces
    vertices = np.concatenate([first.vertices, *(piece.vertices[1:] for piece in others)])
    return replace(first, vertices=vertices, length_m=sum(piece.length_m for piece in pieces))


def around_pieces(pieces: Iterable[SeamPiece], grid: Grid, reach_px: float) -> PixelWindow:
    """The pixels within reach of some pieces."""
    places = np.concatenate([grid.to_pixels(piece.vertices) for piece in pieces])
    left, top = np.floor(places.min(axis=0) - reach_px).astype(int).tolist()
    right, bottom = np.ceil(places.max(axis=0) + reach_px).astype(int).tolist()
    return PixelWindow(left, top, right - left, bottom - top)


def cut_off(seams: Iterable[SidedSeam], pieces: Sequence[SeamPiece], grid: Grid) -> Message | None:
    """How many metres of the seams lie outside the mosaic; None where that is less than a metre."""
    scale = np.array([grid.metres_x, grid.metres_y])
    given = sum(float(vertex_stations(seam.vertices * scale)[-1]) for seam in seams)
    outside = given - sum(piece.length_m for piece in pieces)
    return messages.SEAMS_CUT_OFF(outside=outside, given=given) if outside > TOLD_OUTSIDE_M else None


def _inside(path: np.ndarray, grid: Grid) -> Iterator[tuple[np.ndarray, float]]:
    """The parts of a path inside the grid, all in metres, each with the station where it starts."""
    xmin, ymin, xmax, ymax = grid.extent
    low = np.array([xmin * grid.metres_x, ymin * grid.metres_y])
    high = np.array([xmax * grid.metres_x, ymax * grid.metres_y])
    along = vertex_stations(path)
    for first, last in stretches_inside(path, along, low, high):
        if last - first >= grid.ground_sample_distance:
            (part,) = cut_at(path, along, np.array([first, last]))
            yield part.clip(low, high), float(first)


LabelsAt = Callable[[np.ndarray, np.ndarray], np.ndarray]
"""Takes columns and rows of samples, int of one shape, and gives the labels there, ``NONE`` outside."""

_STATIONS = 6  # along a piece
_OFFSETS_PX = (10.0, 20.0)  # to either side: beyond the errors of labels at a seam, and within narrow parts
_TINY = np.finfo(float).tiny
_LEAST_SHARE = 0.5  # of the samples on a side that have to agree


def sources_beside(
    pieces: Sequence[SeamPiece], labels_at: LabelsAt, grid: Grid, label_px: int,
    offsets_px: tuple[float, ...] = _OFFSETS_PX,
) -> np.ndarray:
    """(pieces, 2) int: the source that most labels on the left and on the right hand of each piece show, so far from
    it, ``NONE`` where they don't agree."""
    places = np.empty((len(pieces), 2, _STATIONS, len(offsets_px), 2))
    shares = (np.arange(_STATIONS) + 0.5) / _STATIONS
    for i, piece in enumerate(pieces):
        path = grid.to_pixels(piece.vertices)
        along = vertex_stations(path)
        places[i] = points_beside(path, along, shares * along[-1], offsets_px)
    samples = np.floor(places / label_px).astype(np.int64).reshape(len(pieces), 2, _STATIONS * len(offsets_px), 2)
    labels = labels_at(samples[..., 0], samples[..., 1])
    votes = np.where(labels == NONE, 0, (labels[..., np.newaxis] == labels[..., np.newaxis, :]).sum(axis=3))
    most = votes.max(axis=2, keepdims=True)
    best = np.where(votes == most, labels, np.iinfo(labels.dtype).max).min(axis=2)  # of several the lowest
    return np.where(most[..., 0] >= _LEAST_SHARE * labels.shape[2], best, NONE)


def points_beside(
    path: np.ndarray, along: np.ndarray, wanted: np.ndarray, offsets: tuple[float, ...]
) -> np.ndarray:
    """(2, stations, offsets, 2) columns and rows to the left and to the right of a path, (n, 2) of such, at ``wanted``
    stations; ``along``: those of its vertices."""
    middle = points_at(path, along, wanted)[:, np.newaxis]
    across, down = np.diff(path, axis=0)[np.searchsorted(along, wanted).clip(1, len(path) - 1) - 1].T
    left = np.column_stack([down, -across])  # rows run down
    aside = left / np.maximum(np.hypot(across, down), _TINY)[:, np.newaxis]
    far = aside[:, np.newaxis] * np.array(offsets)[:, np.newaxis]
    return np.stack([middle + far, middle - far])


def sided(piece: SeamPiece, shown: Sequence[int], numbers: Mapping[str, int]) -> SeamPiece:
    """A piece with what lies beside it, ``shown`` as in ``sources_beside``.

    One whose sides aren't named gets the numbers of its sources, None where labels don't agree, and the same number
    twice where the mosaic doesn't change sources there. One that is named keeps its names; they are exchanged where the
    labels say so (``numbers``: of the names).
    """
    left, right = (None if label == NONE else int(label) for label in shown)
    if piece.left is None and piece.right is None:
        return replace(piece, left=left, right=right)
    left_named, right_named = (
        numbers.get(side) if isinstance(side, str) else side for side in (piece.left, piece.right)
    )

    def agreeing(first: int | None, other: int | None) -> int:
        return (first is not None and first == left) + (other is not None and other == right)

    if left != right and agreeing(right_named, left_named) > agreeing(left_named, right_named):
        return replace(piece, left=piece.right, right=piece.left)
    return piece


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
