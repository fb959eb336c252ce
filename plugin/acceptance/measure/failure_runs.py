"""Failures without a break: failed pieces that follow each other, along a seam and on across seams and sheets.

Two pieces follow each other where one begins at the station at which the other ends, or where their ends touch. At a
node each piece goes on into one other at most, along its own seam if that fails too, else into the straightest one: a
run is a line that one can walk, not a whole network. A piece that could not be measured says nothing of whether the
failure ends there: it does not break a run unless what was not measured is longer than a typical piece, and its own
metres don't count. What passed always breaks it, and so does a gap between two sheets.
"""
from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
from scipy.spatial import cKDTree

from .decision import FailureRun, PieceState
from .delivery import DeliveredPiece

TOUCHING = 0.02  # of a typical piece: ends nearer than that touch. 0.5 m of 25 m, a few pixels of a staircase
_START, _END = 0, 1
End = tuple[int, int]  # the place of a piece in the list, and which of its ends


def failure_runs(
    pieces: Sequence[DeliveredPiece], states: Sequence[PieceState], unit_m: float = 1.0
) -> tuple[FailureRun, ...]:
    """The longest first; ``unit_m``: metres in a unit of the coordinates."""
    if PieceState.FAILED not in states:
        return ()
    typical = float(np.median([piece.length_m for piece in pieces]))
    links = _Links(pieces, TOUCHING * typical, unit_m)
    failed = {number for number, state in enumerate(states) if state is PieceState.FAILED}
    links.join(failed)
    links.join(failed | {number for number, state in enumerate(states) if state is PieceState.NOT_MEASURED})
    found: list[list[int]] = []
    for walk in links.walks(failed):
        found += _stretches(walk, failed, pieces, typical)
    found.sort(key=lambda run: -sum(pieces[place].length_m for place in run))
    return tuple(_run(number, [pieces[place] for place in places]) for number, places in enumerate(found, 1))


class _Links:
    """Which end of a piece goes on into which end of another."""

    def __init__(self, pieces: Sequence[DeliveredPiece], tolerance_m: float, unit_m: float) -> None:
        self._pieces, self._tolerance_m = pieces, tolerance_m
        self._ends = np.array([[piece.vertices[0], piece.vertices[-1]] for piece in pieces]) * unit_m
        self._other: dict[End, End] = {}

    def join(self, members: set[int]) -> None:
        """Link free ends of these pieces: along their seams first, then where they touch, the straightest first."""
        for one, other in self._along_seams(members):
            self._link(one, other)
        for one, other in self._touching(members):
            self._link(one, other)

    def walks(self, starts: set[int]) -> Iterator[list[int]]:
        """The pieces in the order in which they are linked; each that is a start lies in one of the walks."""
        seen: set[int] = set()
        for number in sorted(starts):
            if number in seen:
                continue
            back = self._walk((number, _START))
            if len(back) > 1 and back[-1] == number:
                walk = _opened(back[:-1], starts)
            else:
                walk = [*reversed(back), *self._walk((number, _END))[1:]]
            seen.update(walk)
            yield walk

    def _walk(self, end: End) -> list[int]:
        """From a piece over one of its ends, as far as it goes; round a ring it comes back to where it began."""
        found = [end[0]]
        while (into := self._other.get(end)) is not None:
            found.append(into[0])
            end = into[0], 1 - into[1]
            if into[0] == found[0]:
                break
        return found

    def _link(self, one: End, other: End) -> None:
        if one[0] != other[0] and one not in self._other and other not in self._other:
            self._other[one], self._other[other] = other, one

    def _along_seams(self, members: set[int]) -> Iterator[tuple[End, End]]:
        seams: dict[tuple[str, str], list[tuple[float, int]]] = {}
        for number in members:
            piece = self._pieces[number]
            if piece.seam_id and piece.station_m is not None:
                seams.setdefault(piece.seam, []).append((piece.station_m, number))
        for stations in seams.values():
            stations.sort()
            for (station, number), (next_station, next_number) in zip(stations, stations[1:]):
                if abs(next_station - station - self._pieces[number].length_m) <= self._tolerance_m:
                    yield self._nearest_ends(number, next_number)

    def _nearest_ends(self, number: int, other: int) -> tuple[End, End]:
        apart = np.hypot(*(self._ends[number][:, np.newaxis] - self._ends[other][np.newaxis]).transpose(2, 0, 1))
        apart[_END, _START] -= 1e-9  # as the lines are drawn, where a ring of two pieces leaves the choice
        one, two = np.unravel_index(int(apart.argmin()), apart.shape)
        return (number, int(one)), (other, int(two))

    def _touching(self, members: set[int]) -> list[tuple[End, End]]:
        ends = [(number, side) for number in sorted(members) for side in (_START, _END)]
        free = [end for end in ends if end not in self._other]
        if not free:
            return []
        tree = cKDTree(np.array([self._ends[number][end] for number, end in free]))
        pairs = [(free[one], free[other]) for one, other in sorted(tree.query_pairs(self._tolerance_m))]
        return sorted((pair for pair in pairs if pair[0][0] != pair[1][0]), key=self._turn)

    def _turn(self, pair: tuple[End, End]) -> float:
        """How sharply a line turns there: 0 straight on, 2 back."""
        one, other = (self._outward(end) for end in pair)
        return 1 + float(one @ other)

    def _outward(self, end: End) -> np.ndarray:
        """The direction from the piece's other end to this one."""
        number, side = end
        way = self._ends[number][side] - self._ends[number][1 - side]
        length = float(np.hypot(*way))
        return way / length if length else way


def _opened(ring: list[int], failed: set[int]) -> list[int]:
    """A ring as a line that begins behind a piece that did not fail, where there is one."""
    start = next((place for place, number in enumerate(ring) if number not in failed), 0)
    return ring[start:] + ring[:start]


def _stretches(
    walk: Sequence[int], failed: set[int], pieces: Sequence[DeliveredPiece], longest_gap_m: float
) -> Iterator[list[int]]:
    """A walk, cut where too much was not measured, without what was not measured at its ends."""
    found: list[int] = []
    gap: list[int] = []
    for number in walk:
        if number not in failed:
            gap.append(number)
            continue
        if found and sum(pieces[one].length_m for one in gap) > longest_gap_m:
            yield found
            found = []
        found, gap = [*found, number], []
    if found:
        yield found


def _run(number: int, members: Sequence[DeliveredPiece]) -> FailureRun:
    lengths = np.cumsum([piece.length_m for piece in members])
    middle = members[int(np.searchsorted(lengths, lengths[-1] / 2))].middle
    sheets = tuple(dict.fromkeys(piece.sheet for piece in members))
    return FailureRun(number, float(lengths[-1]), tuple(piece.number for piece in members), sheets, middle)
