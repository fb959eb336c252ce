"""Failures without a break: failed pieces that follow each other, along a seam and on across seams and sheets.

Two pieces follow each other where one begins at the station at which the other ends, or where their ends touch. Where
more than two failed pieces meet in a node, a run goes on along its own seam alone. A piece that was not measured, or
that lies on ground without detail, says nothing of whether the failure ends there: it does not break a run unless such
pieces are longer than a typical one, and its own metres don't count. What passed always breaks it, and so does a gap
between two sheets. The length of a failure is that of its pieces.
"""
from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix
from scipy.sparse.csgraph import connected_components, dijkstra
from scipy.spatial import cKDTree

from ...imagery.seam_totals import PieceState
from .decision import FailureRun
from .delivery import DeliveredPiece

_SAY_NOTHING = (PieceState.NOT_MEASURED, PieceState.NO_DETAIL)
TOUCHING = 0.02  # of a typical piece: ends nearer than that touch. 0.5 m of 25 m, a few pixels of a staircase
_STARTS_AT_ONCE = 256  # places from which others are looked for: a table of them by all places is held


class PiecePlaces:
    """The two places of each piece, as numbers."""

    def __init__(self, pieces: Sequence[DeliveredPiece], typical_m: float, unit_m: float) -> None:
        self._pieces, self._typical_m, self._tolerance_m = pieces, typical_m, TOUCHING * typical_m
        self._ends = np.array([[piece.vertices[0], piece.vertices[-1]] for piece in pieces]) * unit_m
        touching = cKDTree(self._ends.reshape(-1, 2)).query_pairs(self._tolerance_m)
        joined = [(end, other) for end, other in touching if end // 2 != other // 2]
        places = _united([*self._along_seams(), *joined], 2 * len(pieces)).reshape(-1, 2).tolist()
        self._places: list[tuple[int, int]] = [(start, stop) for start, stop in places]

    def joined(self, failed: Iterable[int], unknown: Iterable[int]) -> dict[int, tuple[int, int]]:
        """The places of failed pieces, the same for two where no more than a typical piece of unknown ones lies
        between.
        """
        ends = {number: self._places[number] for number in failed}
        lengths: dict[tuple[int, int], float] = {}  # the shortest of the unknown pieces between two places
        for number in unknown:
            way = min(self._places[number]), max(self._places[number])
            lengths[way] = min(self._pieces[number].length_m, lengths.get(way, np.inf))
        failed_places = {place for places in ends.values() for place in places}
        bridged = list(_near(lengths, failed_places, self._typical_m * (1 + 1e-9)))
        same = _united(bridged, 2 * len(self._pieces)).tolist()
        return {number: (same[start], same[other]) for number, (start, other) in ends.items()}

    def _along_seams(self) -> Iterator[tuple[int, int]]:
        seams: dict[tuple[str, str], list[tuple[float, int]]] = {}
        for number, piece in enumerate(self._pieces):
            if piece.seam_id and piece.station_m is not None:
                seams.setdefault(piece.seam, []).append((piece.station_m, number))
        following = []
        for stations in seams.values():
            stations.sort()
            for (station, number), (next_station, next_number) in zip(stations, stations[1:]):
                if abs(next_station - station - self._pieces[number].length_m) <= self._tolerance_m:
                    following.append((number, next_number))
        return self._nearest_ends(np.array(following, int).reshape(-1, 2).T)

    def _nearest_ends(self, following: np.ndarray) -> Iterator[tuple[int, int]]:
        """The two ends nearest to each other, for each pair of pieces; ``following``: (2, pairs) numbers."""
        ones, others = self._ends[following]
        apart = np.hypot(*(ones[:, :, np.newaxis] - others[:, np.newaxis]).transpose(3, 0, 1, 2)).reshape(-1, 4)
        apart[:, 2] -= 1e-9  # as the lines are drawn, where a ring of two pieces leaves the choice
        ends = np.array(np.divmod(apart.argmin(axis=1), 2))
        return zip(*(2 * following + ends).tolist())


def _united(pairs: Sequence[tuple[int, int]], count: int) -> np.ndarray:
    """(count,) numbers of which those are the same that pairs join."""
    ones, others = np.array(pairs, int).reshape(-1, 2).T
    graph = coo_matrix((np.ones(len(ones)), (ones, others)), (count, count))
    return np.asarray(connected_components(graph, directed=False)[1])


def _near(lengths: Mapping[tuple[int, int], float], wanted: set[int], limit: float) -> Iterator[tuple[int, int]]:
    """Pairs of places that are wanted and no farther from each other than a limit, by ways of such lengths."""
    if not lengths:
        return
    places, ends = np.unique(np.array(list(lengths)), return_inverse=True)
    start, stop = ends.reshape(-1, 2).T
    graph = csr_matrix((list(lengths.values()), (start, stop)), shape=(len(places), len(places)))
    starts = np.flatnonzero([place in wanted for place in places.tolist()])
    for first in range(0, len(starts), _STARTS_AT_ONCE):
        some = starts[first : first + _STARTS_AT_ONCE]
        reached = np.isfinite(dijkstra(graph, directed=False, indices=some, limit=limit)[:, starts])
        yield from ((int(places[some[i]]), int(places[starts[j]])) for i, j in np.argwhere(reached).tolist())


Step = tuple[int, bool]  # a piece, and whether it is walked from its first place to its second


def unbroken_lines(
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
    failed = [number for number, state in enumerate(states) if state is PieceState.FAILED]
    if not failed:
        return ()
    typical = float(np.median([piece.length_m for piece in pieces]))
    places = PiecePlaces(pieces, typical, unit_m)
    ends = places.joined(failed, [number for number, state in enumerate(states) if state in _SAY_NOTHING])
    lines = unbroken_lines(ends, {number: pieces[number].seam if pieces[number].seam_id else None for number in failed})
    runs = sorted((_run(steps, pieces) for steps in lines), key=lambda run: -run.length_m)
    return tuple(replace(run, number=number) for number, run in enumerate(runs, 1))


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
