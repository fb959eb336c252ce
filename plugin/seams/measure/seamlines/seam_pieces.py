"""Seams cut in pieces of nearly equal length on the ground, which are judged one by one, and what lies beside them."""
from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Union

import numpy as np

from ....imagery.errors import Message, SettingsError
from ....imagery.grids import Grid
from ....imagery.lines import points_at, stretches_inside, vertex_stations
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
    it. A seam shorter than half a piece is one piece. Raises SettingsError when ``piece_m`` is not a positive number.
    """
    if not (math.isfinite(piece_m) and piece_m > 0):
        raise SettingsError(messages.SCAN_LENGTHS(name="piece_m", value=piece_m, least="0.01"))
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
