"""Failed pieces of seam as a network: the places where they touch, and the longest walks through them.

A walk takes each piece once and comes through no place twice, but it may begin and end where it comes through, as on a
ring. The longest walk of a network, then the longest through what it leaves over, until every piece lies in one. In a
network without loops they are exact; with loops all ways are tried, up to ``MOST_STEPS``.
"""
from __future__ import annotations

import heapq
from collections import defaultdict
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from .delivery import DeliveredPiece

TOUCHING = 0.02  # of a typical piece: ends nearer than that touch. 0.5 m of 25 m, a few pixels of a staircase


class PiecePlaces:
    """The two places of each piece, as numbers."""

    def __init__(self, pieces: Sequence[DeliveredPiece], typical_m: float, unit_m: float) -> None:
        self._pieces, self._typical_m, self._tolerance_m = pieces, typical_m, TOUCHING * typical_m
        self._ends = np.array([[piece.vertices[0], piece.vertices[-1]] for piece in pieces]) * unit_m
        touching = cKDTree(self._ends.reshape(-1, 2)).query_pairs(self._tolerance_m)
        joined = [(one, other) for one, other in touching if one // 2 != other // 2]
        self._places = _united([*self._along_seams(), *joined], 2 * len(pieces)).reshape(-1, 2).tolist()
        self._at: dict[int, list[int]] = defaultdict(list)
        for number, places in enumerate(self._places):
            for place in places:
                self._at[place].append(number)

    def of(self, number: int) -> tuple[int, int]:
        """Where a piece begins and ends."""
        start, stop = self._places[number]
        return start, stop

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
        bridged = [
            (place, other) for place in own & set(ways) for other in self._reached(place, ways) if other in own
        ]
        same = _united(bridged, 2 * len(self._pieces)).tolist()
        return {number: (same[one], same[other]) for number, (one, other) in ends.items()}

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


def _united(pairs: Sequence[tuple[int, int]], count: int) -> np.ndarray:
    """(count,) numbers of which those are the same that pairs join."""
    ones, others = np.array(pairs, int).reshape(-1, 2).T
    graph = coo_matrix((np.ones(len(ones)), (ones, others)), (count, count))
    return np.asarray(connected_components(graph, directed=False)[1])


MOST_STEPS = 20_000  # for one walk: 16 loops that meet take fewer
_MOST_WORK = 5_000_000  # steps times places: in large networks a step costs more
_MOST_LOOKED_AT = 500_000  # pieces, again and again; then what is left over is walked as it comes

Step = tuple[int, bool]
"""A piece, and whether it is walked from its first place to its second."""


Walk = tuple[tuple[Step, ...], bool]
"""A line through a network, and whether no longer one can be; with too many loops that is not known."""


@dataclass(frozen=True)
class _Way:
    """Pieces in a row with no choice between them."""

    start: Hashable
    stop: Hashable
    length: float
    steps: tuple[Step, ...]

    def turned(self) -> _Way:
        steps = tuple((piece, not forward) for piece, forward in reversed(self.steps))
        return _Way(self.stop, self.start, self.length, steps)


def longest_walks(ends: Mapping[int, tuple[Hashable, Hashable]], lengths: Mapping[int, float]) -> list[Walk]:
    """``ends``: the two places that each piece joins."""
    found: list[Walk] = []
    looked_at = 0
    waiting = _networks(ends)
    while waiting:
        own = {piece: ends[piece] for piece in waiting.pop()}
        looked_at += len(own)
        if looked_at > _MOST_LOOKED_AT:
            found += ((way.steps, False) for way in _ways(own, lengths))
            continue
        walk = _longest(_ways(own, lengths))
        found.append(walk)
        for piece, _ in walk[0]:
            del own[piece]
        waiting += _networks(own)
    return found


def _networks(ends: Mapping[int, tuple[Hashable, Hashable]]) -> list[list[int]]:
    """Pieces that hang together."""
    at = _at(ends)
    found, seen = [], set()
    for first in ends:
        if first in seen:
            continue
        seen.add(first)
        network = [first]
        for piece in network:  # grows
            for other in (other for place in ends[piece] for other in at[place]):
                if other not in seen:
                    seen.add(other)
                    network.append(other)
            for place in ends[piece]:
                at[place] = []
        found.append(network)
    return found


def _at(ends: Mapping[int, tuple[Hashable, Hashable]]) -> dict[Hashable, list[int]]:
    at: dict[Hashable, list[int]] = defaultdict(list)
    for piece, places in ends.items():
        for place in places:
            at[place].append(piece)
    return at


def _ways(ends: Mapping[int, tuple[Hashable, Hashable]], lengths: Mapping[int, float]) -> list[_Way]:
    """One network as ways from choice to choice; a ring without any is one way."""
    at = _at(ends)
    choices = [place for place, pieces in at.items() if len(pieces) != 2 or pieces[0] == pieces[1]]
    seen: set[int] = set()
    found = []
    for start in choices or list(at)[:1]:
        for first in at[start]:
            if first in seen:
                continue
            steps: list[Step] = []
            place, piece = start, first
            while True:
                seen.add(piece)
                forward = ends[piece][0] == place
                steps.append((piece, forward))
                place = ends[piece][1 if forward else 0]
                following = next((other for other in at[place] if other not in seen), None)
                if len(at[place]) != 2 or place == start or following is None:
                    break
                piece = following
            found.append(_Way(start, place, sum(lengths[piece] for piece, _ in steps), tuple(steps)))
    return found


def _longest(ways: Sequence[_Way]) -> Walk:
    """Through one network."""
    at: dict[Hashable, list[tuple[int, _Way]]] = defaultdict(list)
    for number, way in enumerate(ways):
        at[way.start].append((number, way))
        at[way.stop].append((number, way.turned()))
    best = _across_tree(at, max(ways, key=lambda way: way.length))
    if len(at) == len(ways) + 1:
        return _walk(best, True)
    longest, tried = _length(best), 0
    whole = _length(ways)
    for out in at.values():
        out.sort(key=lambda one: one[1].length)
    waiting: list[tuple[Hashable, float, frozenset[Hashable], frozenset[int], tuple[_Way, ...]]]
    waiting = [(place, 0.0, frozenset(), frozenset(), ()) for place in at]
    most_steps = min(MOST_STEPS, _MOST_WORK // len(at))
    while waiting and longest < whole and tried < most_steps:
        place, length, been, used, path = waiting.pop()
        for number, way in at[place]:
            if number in used:
                continue
            tried += 1
            on, there = (*path, way), length + way.length
            if there > longest:
                best, longest = on, there
            if way.stop not in been and longest < whole:
                waiting.append((way.stop, there, been | {way.stop}, used | {number}, on))
    return _walk(best, not waiting or longest >= whole)


def _across_tree(at: Mapping[Hashable, Sequence[tuple[int, _Way]]], any_way: _Way) -> tuple[_Way, ...]:
    """The longest walk through a network without loops, by two sweeps; through another one a long one."""
    far = _farthest(at, any_way.start)
    return _farthest(at, far[-1].stop if far else any_way.start) or (any_way,)


def _farthest(at: Mapping[Hashable, Sequence[tuple[int, _Way]]], start: Hashable) -> tuple[_Way, ...]:
    """The walk from a place to the one that is farthest."""
    came: dict[Hashable, _Way | None] = {start: None}
    metres = {start: 0.0}
    order = [start]
    for place in order:  # grows
        for _, way in at[place]:
            if way.stop not in came:
                came[way.stop], metres[way.stop] = way, metres[place] + way.length
                order.append(way.stop)
    place = max(order, key=metres.__getitem__)
    path: list[_Way] = []
    while (last := came[place]) is not None:
        path.append(last)
        place = last.start
    return tuple(reversed(path))


def _length(path: Iterable[_Way]) -> float:
    return sum(way.length for way in path)


def _walk(path: Iterable[_Way], is_longest: bool) -> Walk:
    return tuple(step for way in path for step in way.steps), is_longest
