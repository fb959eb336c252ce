"""Failures without a break: failed pieces that follow each other, along a seam and on across seams and sheets.

Two pieces follow each other where one begins at the station at which the other ends, or where their ends touch. Where
more than two failed pieces meet in a node, a run goes on along its own seam alone. A piece that was not measured, or
that lies on ground without detail, says nothing of whether the failure ends there: it does not break a run unless such
pieces are longer than a typical one, and its own metres don't count. What passed always breaks it, and so does a gap
between two sheets. The length of a failure is that of its pieces.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...imagery.seam_totals import PieceState
from .decision import FailureRun
from .delivery import DeliveredPiece
from .failure_networks import PiecePlaces, Step, unbroken_lines

_SAY_NOTHING = (PieceState.NOT_MEASURED, PieceState.NO_DETAIL)


def failure_runs(
    pieces: Sequence[DeliveredPiece], states: Sequence[PieceState], unit_m: float = 1.0
) -> tuple[FailureRun, ...]:
    """The longest first; ``unit_m``: metres in a unit of the coordinates."""
    failed = [number for number, state in enumerate(states) if state is PieceState.FAILED]
    if not failed:
        return ()
    typical = float(np.median([piece.length_m for piece in pieces]))
    places = PiecePlaces(pieces, typical, unit_m)
    ends = places.joined(failed, [number for number, state in enumerate(states) if state in _SAY_NOTHING])
    lines = unbroken_lines(ends, {number: pieces[number].seam if pieces[number].seam_id else None for number in failed})
    runs = sorted((_run(steps, pieces) for steps in lines), key=lambda run: -run.length_m)
    return tuple(replace(run, number=number) for number, run in enumerate(runs, 1))


def _run(steps: Sequence[Step], pieces: Sequence[DeliveredPiece]) -> FailureRun:
    if steps[0][0] > steps[-1][0]:
        steps = tuple((number, not forward) for number, forward in reversed(steps))  # in the order of the layer
    own = [pieces[number] for number, _ in steps]
    reached = np.cumsum([piece.length_m for piece in own])
    half = reached[-1] / 2
    at = int(np.searchsorted(reached, half))
    share = 1 - float(reached[at] - half) / own[at].length_m
    place = own[at].point(share if steps[at][1] else 1 - share)
    sheets = tuple(dict.fromkeys(piece.sheet for piece in own))
    return FailureRun(
        0, float(reached[-1]), tuple(piece.number for piece in own), tuple(not forward for _, forward in steps), sheets,
        place,
    )
