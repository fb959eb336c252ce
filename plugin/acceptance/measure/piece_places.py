"""Where pieces of seam touch: every end of a piece is a place, and ends that meet are the same one."""
from __future__ import annotations

import heapq
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence

import numpy as np
from scipy.spatial import cKDTree

from .delivery import DeliveredPiece

TOUCHING = 0.02  # of a typical piece: ends nearer than that touch. 0.5 m of 25 m, a few pixels of a staircase


class PiecePlaces:
    """The two places of each piece, as numbers."""

    def __init__(self, pieces: Sequence[DeliveredPiece], typical_m: float, unit_m: float) -> None:
        self._pieces, self._typical_m, self._tolerance_m = pieces, typical_m, TOUCHING * typical_m
        self._ends = np.array([[piece.vertices[0], piece.vertices[-1]] for piece in pieces]) * unit_m
        self._same = _Same(2 * len(pieces))
        for one, other in self._along_seams():
            self._same.join(one, other)
        for one, other in cKDTree(self._ends.reshape(-1, 2)).query_pairs(self._tolerance_m):
            if one // 2 != other // 2:
                self._same.join(one, other)
        self._at: dict[int, list[int]] = defaultdict(list)
        for end in range(2 * len(pieces)):
            self._at[self._same.first(end)].append(end // 2)

    def of(self, number: int) -> tuple[int, int]:
        """Where a piece begins and ends."""
        return self._same.first(2 * number), self._same.first(2 * number + 1)

    def at(self, place: int) -> Sequence[int]:
        """The pieces that begin or end there."""
        return self._at[place]

    def joined(self, failed: Iterable[int], unknown: Iterable[int]) -> dict[int, tuple[int, int]]:
        """The places of failed pieces, the same for two where no more than a typical piece of unknown ones lies
        between.
        """
        ends = {number: self.of(number) for number in failed}
        ways: dict[int, list[tuple[int, float]]] = defaultdict(list)
        for number in unknown:
            one, other = self.of(number)
            ways[one].append((other, self._pieces[number].length_m))
            ways[other].append((one, self._pieces[number].length_m))
        own = {place for places in ends.values() for place in places}
        same = _Same(2 * len(self._pieces))
        for place in own & set(ways):
            for other in self._reached(place, ways):
                if other in own:
                    same.join(place, other)
        return {number: (same.first(one), same.first(other)) for number, (one, other) in ends.items()}

    def _reached(self, start: int, ways: dict[int, list[tuple[int, float]]]) -> Iterator[int]:
        """Places no farther than a typical piece."""
        near, waiting = {start: 0.0}, [(0.0, start)]
        while waiting:
            metres, place = heapq.heappop(waiting)
            for other, length in ways.get(place, ()):
                there = metres + length
                if there <= self._typical_m * (1 + 1e-9) and there < near.get(other, np.inf):
                    near[other] = there
                    heapq.heappush(waiting, (there, other))
        yield from near

    def _along_seams(self) -> Iterator[tuple[int, int]]:
        seams: dict[tuple[str, str], list[tuple[float, int]]] = {}
        for number, piece in enumerate(self._pieces):
            if piece.seam_id and piece.station_m is not None:
                seams.setdefault(piece.seam, []).append((piece.station_m, number))
        for stations in seams.values():
            stations.sort()
            for (station, number), (next_station, next_number) in zip(stations, stations[1:]):
                if abs(next_station - station - self._pieces[number].length_m) <= self._tolerance_m:
                    yield self._nearest_ends(number, next_number)

    def _nearest_ends(self, number: int, other: int) -> tuple[int, int]:
        apart = np.hypot(*(self._ends[number][:, np.newaxis] - self._ends[other][np.newaxis]).transpose(2, 0, 1))
        apart[1, 0] -= 1e-9  # as the lines are drawn, where a ring of two pieces leaves the choice
        one, two = np.unravel_index(int(apart.argmin()), apart.shape)
        return 2 * number + int(one), 2 * other + int(two)


class _Same:
    """Which of some numbers are the same."""

    def __init__(self, count: int) -> None:
        self._before = list(range(count))

    def first(self, number: int) -> int:
        before = self._before
        while before[number] != number:
            before[number] = number = before[before[number]]
        return number

    def join(self, one: int, other: int) -> None:
        one, other = sorted((self.first(one), self.first(other)))
        self._before[other] = one
