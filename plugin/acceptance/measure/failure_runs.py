"""Failures without a break: failed pieces that follow each other, along a seam and on across seams and sheets.

Two pieces follow each other where their ends touch. Where more than two failed pieces meet in a node, a run goes on
along its own seam alone; all that hangs together there is summed, too. A piece that was not measured, or that lies on
ground without detail, says nothing of whether the failure ends there: one that is no longer than a typical piece does
not break a run, and its own metres don't count. What passed always breaks it, and so does a gap.
"""
from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from ...imagery.seam_totals import PieceState
from .decision import FailureRun
from .delivery import DeliveredPiece, typical_m

_SAY_NOTHING = (PieceState.NOT_MEASURED, PieceState.NO_DETAIL)
_TOUCHING = 0.02  # of a typical piece: ends nearer than that touch. 0.5 m of 25 m, a few pixels of a staircase


def _failed_ends(
    pieces: Sequence[DeliveredPiece], states: Sequence[PieceState], unit_m: float
) -> dict[int, tuple[int, int]]:
    """The numbers of the two places that each failed piece joins: the same for ends that touch, and for those between
    which nothing lies but one piece that says nothing, no longer than a typical one."""
    typical = typical_m(pieces)
    ends = np.array([piece.vertices[end] for piece in pieces for end in (0, -1)]) * unit_m
    touching = [(end, other) for end, other in cKDTree(ends).query_pairs(_TOUCHING * typical) if end // 2 != other // 2]
    places = _united(touching, len(ends)).reshape(-1, 2).tolist()
    failed = [number for number, state in enumerate(states) if state is PieceState.FAILED]
    failed_places = {place for number in failed for place in places[number]}
    bridged = [
        places[number] for number, state in enumerate(states)
        if state in _SAY_NOTHING and pieces[number].length_m <= typical * (1 + 1e-9)
        and failed_places.issuperset(places[number])
    ]
    same = _united(bridged, len(ends)).tolist()
    return {number: (same[places[number][0]], same[places[number][1]]) for number in failed}


def _united(pairs: Sequence[tuple[int, int]], count: int) -> np.ndarray:
    """(count,) numbers of which those are the same that pairs join."""
    ones, others = np.array(pairs, int).reshape(-1, 2).T
    graph = coo_matrix((np.ones(len(ones)), (ones, others)), (count, count))
    return np.asarray(connected_components(graph, directed=False)[1])


Step = tuple[int, bool]  # a piece, and whether it is walked from its first place to its second


def _unbroken_lines(
    ends: Mapping[int, tuple[int, int]], seams: Mapping[int, tuple[str, str] | None]
) -> list[tuple[Step, ...]]:
    """The lines of pieces that go on without a break; each piece lies in one. A ring is walked once round.

    ``ends``: the two places that each piece joins; ``seams``: what the seam that it is of is known by.
    """
    goes_on = _next_ends(ends, seams)
    every = [(piece, end) for piece in ends for end in (0, 1)]
    seen: set[int] = set()
    lines = []
    for piece, end in [*(step for step in every if step not in goes_on), *every]:  # what is left over are rings
        steps: list[Step] = []
        while piece not in seen:
            seen.add(piece)
            steps.append((piece, end == 0))
            piece, end = goes_on.get((piece, 1 - end), (piece, end))
        if steps:
            lines.append(tuple(steps))
    return lines


_End = tuple[int, int]  # a piece, and 0 for its first place, 1 for its second


def _next_ends(ends: Mapping[int, tuple[int, int]], seams: Mapping[int, tuple[str, str] | None]) -> dict[_End, _End]:
    """Ends of pieces, each with the end of the one that follows there."""
    meeting: dict[int, list[_End]] = defaultdict(list)
    for piece, places in ends.items():
        for end, place in enumerate(places):
            meeting[place].append((piece, end))
    following: dict[_End, _End] = {}
    for there in meeting.values():
        by_seam: dict[tuple[str, str] | None, list[_End]] = defaultdict(list)
        for piece, end in there:
            by_seam[seams[piece] if len(there) > 2 else None].append((piece, end))
        if len(there) > 2:
            by_seam.pop(None, None)  # of no seam that is known
        for pair in by_seam.values():
            if len(pair) == 2:
                following[pair[0]], following[pair[1]] = pair[1], pair[0]
    return following


def failure_runs(
    pieces: Sequence[DeliveredPiece], states: Sequence[PieceState], unit_m: float = 1.0
) -> tuple[FailureRun, ...]:
    """The longest first; ``unit_m``: metres in a unit of the coordinates."""
    if PieceState.FAILED not in states:
        return ()
    ends = _failed_ends(pieces, states, unit_m)
    lines = _unbroken_lines(ends, {number: pieces[number].seam if pieces[number].seam_id else None for number in ends})
    runs = sorted((_run(steps, pieces) for steps in lines), key=lambda run: -run.length_m)
    groups, joined_m = _united([*ends.values()], 2 * len(pieces)), defaultdict[int, float](float)
    for number, (place, _) in ends.items():
        joined_m[groups[place]] += pieces[number].length_m
    return tuple(
        replace(run, number=number, joined_m=joined_m[groups[ends[run.pieces[0]][0]]])
        for number, run in enumerate(runs, 1)
    )


def unknown_runs(
    pieces: Sequence[DeliveredPiece], states: Sequence[PieceState], unit_m: float = 1.0
) -> tuple[FailureRun, ...]:
    """Rows of pieces that were not measured, with those that failed among them, the longest first: if all of that had
    failed, they were failures."""
    worst = [PieceState.FAILED if state is PieceState.NOT_MEASURED else state for state in states]
    return tuple(
        run for run in failure_runs(pieces, worst, unit_m)
        if any(states[number] is PieceState.NOT_MEASURED for number in run.pieces)
    ) if PieceState.NOT_MEASURED in states else ()


def _run(steps: Sequence[Step], pieces: Sequence[DeliveredPiece]) -> FailureRun:
    if steps[0][0] > steps[-1][0]:
        steps = tuple((number, not forward) for number, forward in reversed(steps))  # in the order of the layer
    run_pieces = [pieces[number] for number, _ in steps]
    reached = np.cumsum([piece.length_m for piece in run_pieces])
    half = reached[-1] / 2
    at = int(np.searchsorted(reached, half))
    share = 1 - float(reached[at] - half) / run_pieces[at].length_m
    place = run_pieces[at].point(share if steps[at][1] else 1 - share)
    sheets = tuple(dict.fromkeys(piece.sheet for piece in run_pieces))
    return FailureRun(0, float(reached[-1]), tuple(piece.number for piece in run_pieces), sheets, place)
