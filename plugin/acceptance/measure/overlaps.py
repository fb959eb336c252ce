"""Pieces of seam that lie on each other: what was scanned twice would count twice."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from ...imagery.lines import points_at, vertex_stations
from .delivery import DeliveredPiece
from .piece_places import TOUCHING

_DIGITS = 3  # of coordinates, to which lines are the same
_PLACES = (0.1, 0.3, 0.5, 0.7, 0.9)  # of a piece: away from its ends, where others begin
_NEAR = 1.2  # steps: two lines that lie a step apart, with points at every step
_NEIGHBOURS = 12
_MOST_POINTS = 2000  # of one piece


@dataclass(frozen=True)
class Overlap:
    """What counts more than once."""

    metres: float
    """That are too many."""
    sheets: tuple[str, ...]
    """Whose pieces lie on others."""


def without_copies(pieces: Sequence[DeliveredPiece]) -> tuple[list[DeliveredPiece], int]:
    """Pieces each once, and how many are left out: the same line, drawn either way, that kept the same.

    One that was drawn for a sample stays so.
    """
    kept: dict[object, DeliveredPiece] = {}
    for piece in pieces:
        line = np.round(piece.vertices, _DIGITS) + 0.0
        key = min(line.tobytes(), line[::-1].tobytes()), piece.kept_1
        first = kept.setdefault(key, piece)
        if first.sample_number is None and piece.sample_number is not None:
            kept[key] = replace(first, sample_number=piece.sample_number)
    return list(kept.values()), len(pieces) - len(kept)


def overlap(pieces: Sequence[DeliveredPiece], unit_m: float = 1.0) -> Overlap | None:
    """Of pieces that are not the same and yet lie on each other; None where it is less than a typical piece's half."""
    typical = float(np.median([piece.length_m for piece in pieces]))
    step = TOUCHING * typical
    points, owners, asked, askers = [], [], [], []
    for number, piece in enumerate(pieces):
        along = vertex_stations(piece.vertices * unit_m)
        count = int(min(np.ceil(along[-1] / step) + 1, _MOST_POINTS))
        points.append(points_at(piece.vertices * unit_m, along, np.linspace(0, along[-1], count)))
        owners.append(np.full(count, number))
        asked.append(points_at(piece.vertices * unit_m, along, np.array(_PLACES) * along[-1]))
        askers.append(np.full(len(_PLACES), number))
    owner, asker = np.concatenate(owners), np.concatenate(askers)
    _, near = cKDTree(np.concatenate(points)).query(
        np.concatenate(asked), _NEIGHBOURS, distance_upper_bound=_NEAR * step
    )
    near_owner = np.append(owner, -1)[near]
    others = np.array([len({*row} - {-1, own}) for row, own in zip(near_owner.tolist(), asker.tolist())])
    lengths = np.array([piece.length_m for piece in pieces])
    too_many = lengths[asker] / len(_PLACES) * others / (others + 1)
    if too_many.sum() < typical / 2:
        return None
    sheets = dict.fromkeys(pieces[number].sheet for number in asker[others > 0].tolist())
    return Overlap(float(too_many.sum()), tuple(sheets))
