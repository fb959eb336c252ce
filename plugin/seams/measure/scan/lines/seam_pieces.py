"""Seams cut in pieces of nearly equal length on the ground, which are judged one by one."""
from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Protocol, Union

import numpy as np

from .....imagery.errors import Message, SettingsError
from .....imagery.grids import Grid
from .....imagery.lines import points_at, vertex_stations
from .. import messages

TOLD_OUTSIDE_M = 1.0
"""Less than this beyond the mosaic's edge is how lines end, and nothing to tell."""

Side = Union[int, str, None]
"""A source beside a seam: its number or its name; None where nothing says."""


class SidedLine(Protocol):
    """What a seam is known by here."""

    @property
    def vertices(self) -> np.ndarray:
        """(n, 2) float64 map units."""

    @property
    def left(self) -> Side:
        """The source on the left hand of who walks along the vertices."""

    @property
    def right(self) -> Side:
        """The source on the right hand."""


@dataclass(frozen=True, eq=False)
class SeamPiece:
    """A stretch of a seam that is measured as one."""

    seam_id: int
    """1..n, in the order of the seams."""
    station_m: float
    """Where it starts, metres along the seam as it was given."""
    length_m: float
    """Metres on the ground."""
    vertices: np.ndarray
    """(n, 2) float64 map units, n >= 2."""
    left: Side
    """The source on the left hand of who walks along the vertices."""
    right: Side
    """The source on the right hand."""


def cut_in_pieces(seams: Iterable[SidedLine], piece_m: float, grid: Grid) -> list[SeamPiece]:
    """Seams in pieces of equal length each, as close to ``piece_m`` metres as their length allows.

    What lies outside the mosaic's grid is cut off, parts inside that are shorter than a pixel too; ``cut_off`` tells
    it. A seam shorter than half a piece is one piece. Raises SettingsError when ``piece_m`` is not a positive number.
    """
    if not (math.isfinite(piece_m) and piece_m > 0):
        raise SettingsError(messages.SCAN_LENGTHS(name="PIECE", value=piece_m, least="0.01"))
    scale = np.array([grid.metres_x, grid.metres_y])
    pieces = []
    for seam_id, seam in enumerate(seams, start=1):
        for part, station in _inside(seam.vertices * scale, grid):
            along = vertex_stations(part)
            count = max(1, round(along[-1] / piece_m))
            cuts = np.linspace(0, along[-1], count + 1)
            places = points_at(part, along, cuts)
            # Vertices strictly between two cuts are the piece's own.
            first = np.searchsorted(along, cuts, side="right")
            last = np.searchsorted(along, cuts, side="left")
            for i in range(count):
                own = np.concatenate([places[i : i + 1], part[first[i] : last[i + 1]], places[i + 1 : i + 2]])
                start = station + float(cuts[i])
                length = along[-1] / count
                pieces.append(SeamPiece(seam_id, start, float(length), own / scale, seam.left, seam.right))
    return pieces


def cut_off(seams: Iterable[SidedLine], pieces: Sequence[SeamPiece], grid: Grid) -> Message | None:
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
    shortest = grid.ground_sample_distance
    along = vertex_stations(path)
    if ((path >= low) & (path <= high)).all():
        if along[-1] >= shortest:
            yield path, 0.0
        return
    # Each straight stretch is inside between two shares of its length (Liang and Barsky).
    start, step = path[:-1], np.diff(path, axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):
        bounds = np.stack([(low - start) / step, (high - start) / step])
    within = (start >= low) & (start <= high)
    enter = np.where(step == 0, np.where(within, -np.inf, np.inf), bounds.min(axis=0)).max(axis=1).clip(0)
    leave = np.where(step == 0, np.where(within, np.inf, -np.inf), bounds.max(axis=0)).min(axis=1).clip(max=1)
    touched = np.flatnonzero(enter < leave)
    # A part goes on where one stretch is left at its end and the next one entered at its start.
    goes_on = (np.diff(touched) == 1) & (leave[touched[:-1]] == 1) & (enter[touched[1:]] == 0)
    for run in np.split(touched, np.flatnonzero(~goes_on) + 1):
        if not len(run):
            continue
        head = start[run[0]] + enter[run[0]] * step[run[0]]
        tail = start[run[-1]] + leave[run[-1]] * step[run[-1]]
        part = np.concatenate([head[np.newaxis], path[run[1:]], tail[np.newaxis]])
        if vertex_stations(part)[-1] >= shortest:
            yield part, float(along[run[0]] + enter[run[0]] * np.hypot(*step[run[0]]))
