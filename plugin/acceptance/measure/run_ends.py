"""Which parts of its pieces a run takes: all of the inner ones, the estimated share of those at its ends."""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from .decision import FailedPart, PieceState
from .delivery import DeliveredPiece
from .failure_ends import FailureEnd, UsualKept, estimated_alone, estimated_ends
from .longest_walks import Step
from .piece_places import PiecePlaces

_Parts = tuple[FailedPart, ...]


class RunEnds:
    """Looks beyond the ends of runs."""

    def __init__(
        self, pieces: Sequence[DeliveredPiece], states: Sequence[PieceState], places: PiecePlaces, usual: UsualKept,
        least_kept: float,
    ) -> None:
        self._pieces, self._states, self._places = pieces, states, places
        self._usual, self._least_kept = usual, least_kept
        self._claims: Counter[int] = Counter()

    def count_neighbours(self, walks: Iterable[Sequence[Step]]) -> None:
        """A piece between two runs may be spoilt by either: each is given half of it."""
        for steps in walks:
            self._claims.update(step[0] for step in self._beyond(steps) if step is not None)

    def parts(self, steps: Sequence[Step]) -> tuple[_Parts, float]:
        """What a run takes, in its order; and half the 95 % interval of its length."""
        first, last = (self._pieces[number] for number, _ in (steps[0], steps[-1]))
        kept = [self._pieces[number].kept_1 for number, _ in steps]
        known = [one for one in kept if one is not None]
        if len(known) < len(kept):
            return run_parts(steps, self._pieces, (0.0, 0.0)), 0.0
        beyond = self._beyond(steps)
        ends = [
            self._end(number, outer, step)
            for (number, _), outer, step in zip((steps[0], steps[-1]), self._outer(steps), beyond)
        ]
        if len(steps) == 1:
            found = estimated_alone(ends[0], ends[1], self._usual, self._least_kept)
        else:
            found = estimated_ends(ends[0], known[1:-1], ends[1], self._usual, self._least_kept)
        over = found.first_m - first.length_m, found.last_m - last.length_m
        return run_parts(steps, self._pieces, over, beyond), found.within_m

    def _outer(self, steps: Sequence[Step]) -> tuple[int, int]:
        """The places where a run begins and ends."""
        (number, forward), (last, last_forward) = steps[0], steps[-1]
        return self._places.of(number)[0 if forward else 1], self._places.of(last)[1 if last_forward else 0]

    def _beyond(self, steps: Sequence[Step]) -> tuple[Step | None, Step | None]:
        """The pieces that passed beyond both ends, each as it is walked away from the run."""
        start, stop = self._outer(steps)
        return self._following(steps[0][0], start), self._following(steps[-1][0], stop)

    def _following(self, number: int, place: int) -> Step | None:
        """Along the same seam; another one only where there is no choice."""
        others = [other for other in self._places.at(place) if other != number]
        if any(self._states[other] is not PieceState.PASSED for other in others):
            return None
        same = [other for other in others if self._pieces[other].seam == self._pieces[number].seam]
        chosen = same if len(same) == 1 else others
        if len(chosen) != 1 or self._pieces[chosen[0]].kept_1 is None:
            return None
        return chosen[0], self._places.of(chosen[0])[0] == place

    def _end(self, number: int, place: int, beyond: Step | None) -> FailureEnd:
        piece = self._pieces[number]
        kept = piece.kept_1 or 0.0
        others = [other for other in self._places.at(place) if other != number]
        if any(self._states[other] is PieceState.FAILED for other in others):
            return FailureEnd(kept, piece.length_m, is_closed=True)
        if beyond is None:
            return FailureEnd(kept, piece.length_m)
        other, claims = self._pieces[beyond[0]], max(self._claims[beyond[0]], 1)
        lost = self._usual.kept - (other.kept_1 or 0.0)
        return FailureEnd(kept, piece.length_m, self._usual.kept - lost / claims, other.length_m / claims)


def run_parts(
    steps: Sequence[Step], pieces: Sequence[DeliveredPiece], over_m: tuple[float, float],
    beyond: tuple[Step | None, Step | None] = (None, None),
) -> _Parts:
    """``over_m``: by how much the run is longer than its pieces at its two ends, into those ``beyond`` them."""
    shares = [[0.0, 1.0] for _ in steps]
    outside: list[list[FailedPart]] = [[], []]
    for side, (metres, step) in enumerate(zip(over_m, beyond)):
        place = (0, -1)[side]
        if metres > 0 and step is not None:
            number, forward = step
            share = min(metres / pieces[number].length_m, 1.0)
            start, stop = (0.0, share) if forward else (1 - share, 1.0)
            outside[side].append(FailedPart(number, start, stop, is_turned=forward == (side == 0)))
        elif metres < 0:
            lacking = -metres / pieces[steps[place][0]].length_m
            shares[place][side] += (lacking, -lacking)[side]
    own = [
        FailedPart(number, start, stop).turned(not forward)
        for (number, forward), (start, stop) in zip(steps, shares)
    ]
    return (*outside[0], *own, *outside[1])
