"""Sheets that were scanned apart: seams that cross their borders, and failures that end at the edge of a sheet where no
seam goes on, so that beyond it they may be longer, and nobody looked."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial import cKDTree

from .decision import FailureRun
from .delivery import Delivery
from .failure_networks import TOUCHING

_AT_EDGE = 0.5  # of a typical piece: seams are measured to some pixels from the edge of a mosaic


def crossing_count(delivery: Delivery) -> int:
    """Places where a seam of one scan goes on in another one."""
    scans = [piece.seam[0] for piece in delivery.pieces]
    if len(set(scans)) < 2:
        return 0
    near = _ends_of_all(delivery).query_pairs(TOUCHING * _typical(delivery))
    return sum(scans[one // 2] != scans[other // 2] for one, other in near)


def _ends_of_all(delivery: Delivery) -> cKDTree:
    return cKDTree(np.array([vertices for piece in delivery.pieces for vertices in piece.vertices[[0, -1]]]))


def _typical(delivery: Delivery) -> float:
    """Length of a piece, in units of the coordinates."""
    return float(np.median([piece.length_m for piece in delivery.pieces])) / delivery.unit_m


def cut_failures(delivery: Delivery, runs: Sequence[FailureRun]) -> list[FailureRun]:
    """Those with such an end; none of a single sheet. Sheets without an outline are boxes around their seams."""
    if not runs or len(delivery.sheets) < 2:
        return []
    typical, ends = _typical(delivery), _ends_of_all(delivery)
    edges = [(ring[:-1], ring[1:]) for rings in delivery.sheet_rings().values() for ring in rings]
    starts, stops = (np.concatenate(parts) for parts in zip(*edges))

    def is_cut(place: np.ndarray) -> bool:
        if len(ends.query_ball_point(place, TOUCHING * typical)) > 1:  # another piece goes on
            return False
        along = stops - starts
        squares = np.maximum((along**2).sum(axis=1), np.finfo(float).tiny)
        shares = np.clip(((place - starts) * along).sum(axis=1) / squares, 0, 1)
        return bool((np.hypot(*(starts + shares[:, np.newaxis] * along - place).T) <= _AT_EDGE * typical).any())

    return [run for run in runs if any(map(is_cut, _ends(run, delivery)))]


def _ends(run: FailureRun, delivery: Delivery) -> tuple[np.ndarray, np.ndarray]:
    """Where a failure begins and ends, x and y."""
    first, last = (delivery.pieces[number].vertices for number in (run.pieces[0], run.pieces[-1]))
    return first[-1 if run.turned[0] else 0], last[0 if run.turned[-1] else -1]
