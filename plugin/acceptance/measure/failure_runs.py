"""Failures without a break: failed pieces that follow each other, along a seam and on across seams and sheets.

Two pieces follow each other where one begins at the station at which the other ends, or where their ends touch. A run
is the longest line that one can walk through failed pieces that hang together; what it leaves over at nodes are runs
of their own. A piece that could not be measured says nothing of whether the failure ends there: it does not break a run
unless what was not measured is longer than a typical piece, and its own metres don't count. What passed always breaks
it, and so does a gap between two sheets. Where a run begins and ends inside its pieces is estimated (``failure_ends``).
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from .decision import FailureRun, PieceState
from .delivery import DeliveredPiece
from .failure_ends import UsualKept, usual_kept
from .longest_walks import Step, longest_walks
from .piece_places import PiecePlaces
from .run_ends import RunEnds, run_parts


def failure_runs(
    pieces: Sequence[DeliveredPiece], states: Sequence[PieceState], unit_m: float = 1.0, least_kept: float | None = None
) -> tuple[FailureRun, ...]:
    """The longest first; ``unit_m``: metres in a unit of the coordinates.

    ``least_kept``: below which pieces failed; None where they failed by something else, so that nothing tells where
    inside of them: then they are failed from end to end.
    """
    failed = [number for number, state in enumerate(states) if state is PieceState.FAILED]
    if not failed:
        return ()
    typical = float(np.median([piece.length_m for piece in pieces]))
    places = PiecePlaces(pieces, typical, unit_m)
    ends = places.joined(failed, [number for number, state in enumerate(states) if state is PieceState.NOT_MEASURED])
    walks = longest_walks(ends, {number: pieces[number].length_m for number in failed})
    run_ends = None
    if least_kept is not None:
        run_ends = RunEnds(pieces, states, places, _usual(pieces, states, places), least_kept)
        run_ends.count_neighbours(walk.steps for walk in walks)
    runs = [_run(walk.steps, walk.is_longest, pieces, run_ends) for walk in walks]
    runs.sort(key=lambda run: -run.length_m)
    return tuple(replace(run, number=number) for number, run in enumerate(runs, 1))


def _usual(pieces: Sequence[DeliveredPiece], states: Sequence[PieceState], places: PiecePlaces) -> UsualKept:
    """Of pieces that passed and touch none that failed."""
    beside = {
        place for number, state in enumerate(states) if state is PieceState.FAILED for place in places.of(number)
    }
    return usual_kept([
        (piece.kept_1, piece.kept_low, piece.kept_high)
        for number, (piece, state) in enumerate(zip(pieces, states))
        if state is PieceState.PASSED and piece.kept_1 is not None and not beside & set(places.of(number))
    ])


def _run(
    steps: Sequence[Step], is_longest: bool, pieces: Sequence[DeliveredPiece], run_ends: RunEnds | None
) -> FailureRun:
    if steps[0][0] > steps[-1][0]:
        steps = tuple((number, not forward) for number, forward in reversed(steps))  # in the order of the layer
    if run_ends is None:
        parts, within = run_parts(steps, pieces, (0.0, 0.0)), 0.0
    else:
        parts, within = run_ends.parts(steps)
    lengths = np.cumsum([part.share * pieces[part.piece].length_m for part in parts])
    half = int(np.searchsorted(lengths, lengths[-1] / 2))
    sheets = tuple(dict.fromkeys(pieces[part.piece].sheet for part in parts))
    numbers = tuple(pieces[number].number for number, _ in steps)
    return FailureRun(
        0, float(lengths[-1]), numbers, sheets, parts[half].middle(pieces[parts[half].piece]), parts, within, is_longest
    )
