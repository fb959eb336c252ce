"""Failures without a break: failed pieces that follow each other, along a seam and on across seams and sheets.

Two pieces follow each other where one begins at the station at which the other ends, or where their ends touch. Where
more than two failed pieces meet in a node, a run goes on along its own seam alone. A piece that could not be measured
says nothing of whether the failure ends there: it does not break a run unless what was not measured is longer than a
typical piece, and its own metres don't count. What passed always breaks it, and so does a gap between two sheets. Where
a run begins and ends inside its pieces is estimated (``failure_ends``).
"""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from statistics import NormalDist

import numpy as np

from .decision import FailedPart, FailureRun, PieceState
from .delivery import DeliveredPiece
from .failure_networks import PiecePlaces, Step, unbroken_lines

_KEPT_STEPS, _PLACES = 12, 12  # of k; in a piece
_VARIES = 0.05  # what is kept inside a failure, from piece to piece
_UNEVEN = 0.15  # half a piece holds 50 % of its detail, give or take that much
_LEAST_NOISE = 0.03
_WITHIN = NormalDist().inv_cdf(0.975)  # standard deviations of 95 %


@dataclass(frozen=True)
class UsualKept:
    """What pieces that are not spoilt keep."""

    kept: float
    noise: float
    """Its standard deviation."""


@dataclass(frozen=True)
class FailureEnd:
    """The piece at an end of a failure, and the one beyond."""

    kept: float
    length_m: float
    beyond_kept: float | None = None
    """None where the failure can't go on: there is none that was measured and passed."""
    beyond_m: float = 0.0
    is_closed: bool = False
    """Whether the next failure touches it there, so that it is spoilt up to its end."""


EndEstimate = tuple[float, float, float]
"""Metres from the inner ends of the first and the last piece outwards, more than a piece's length where it reaches into
the one beyond; and half the 95 % interval of the length of both together."""


def usual_kept(passed: Sequence[tuple[float, float | None, float | None]]) -> UsualKept:
    """``passed``: kept_1 with its 95 % interval of pieces that passed, away from failures."""
    if not passed:
        return UsualKept(1.0, 0.1)
    kept = np.array([one for one, _, _ in passed])
    stated = [(high - low) / (2 * _WITHIN) for _, low, high in passed if low is not None and high is not None]
    usual = float(np.median(kept))
    noise = 1.4826 * float(np.median(np.abs(kept - usual)))
    if len(kept) < 8:  # too few to tell their scatter
        noise = max(noise, float(np.median(stated)) if stated else 0.1)
    return UsualKept(min(usual, 1.0), max(noise, _LEAST_NOISE))


def estimated_ends(
    first: FailureEnd, inner: Sequence[float], last: FailureEnd, usual: UsualKept, least_kept: float
) -> EndEstimate:
    """Of two pieces or more. ``inner``: kept_1 of those between the first and the last."""
    inside = (np.arange(_KEPT_STEPS) + 0.5) / _KEPT_STEPS * least_kept
    known = np.zeros(_KEPT_STEPS)
    for kept in inner:
        known += _agreement(kept, np.ones(1), inside, usual)[:, 0]
    (places, metres), (other_places, other_metres) = _places(first), _places(last)
    weight = (
        known[:, np.newaxis, np.newaxis]
        + _reach(first, places, inside, usual)[:, :, np.newaxis]
        + _reach(last, other_places, inside, usual)[:, np.newaxis, :]
    )
    weight = np.exp(weight - weight.max()) * metres[:, np.newaxis] * other_metres
    return _mean(weight, places, other_places)


def estimated_alone(start: FailureEnd, stop: FailureEnd, usual: UsualKept, least_kept: float) -> EndEstimate:
    """Of a single piece: how far the failure reaches from its last end over the first, and the other way round."""
    inside = (np.arange(_KEPT_STEPS) + 0.5) / _KEPT_STEPS * least_kept
    length = start.length_m
    (places, metres), (other_places, other_metres) = _places(start), _places(stop)
    covered = np.minimum(places, length)[:, np.newaxis] + np.minimum(other_places, length) - length
    weight = _agreement(start.kept, np.clip(covered, 0, None).ravel() / length, inside, usual)
    weight = weight.reshape(_KEPT_STEPS, *covered.shape)
    weight = weight + _beyond(start, places, inside, usual)[:, :, np.newaxis]
    weight = weight + _beyond(stop, other_places, inside, usual)[:, np.newaxis, :]
    weight = np.where(covered > 0, np.exp(weight - weight[:, covered > 0].max()), 0.0)
    return _mean(weight * metres[:, np.newaxis] * other_metres, places, other_places)


def _places(end: FailureEnd) -> tuple[np.ndarray, np.ndarray]:
    """From the piece's inner end outwards; metres that each stands for."""
    if end.is_closed:
        return np.array([end.length_m]), np.ones(1)
    middles, each = (np.arange(_PLACES) + 0.5) / _PLACES, np.full(_PLACES, 1 / _PLACES)
    if end.beyond_kept is None:  # failures along whole seams are common: even odds that it is spoilt up to there
        return np.append(middles, 1.0) * end.length_m, np.append(each / 2, 0.5) * end.length_m
    return (
        np.concatenate([middles * end.length_m, end.length_m + middles * end.beyond_m]),
        np.concatenate([each * end.length_m, each * end.beyond_m]),
    )


def _reach(end: FailureEnd, places: np.ndarray, inside: np.ndarray, usual: UsualKept) -> np.ndarray:
    """(k, places): how well places of an end agree with what was measured, a logarithm."""
    agreement = _agreement(end.kept, np.minimum(places / end.length_m, 1), inside, usual)
    return agreement + _beyond(end, places, inside, usual)


def _beyond(end: FailureEnd, places: np.ndarray, inside: np.ndarray, usual: UsualKept) -> np.ndarray:
    """What the piece beyond an end says of its places."""
    if end.is_closed or end.beyond_kept is None or not end.beyond_m:
        return np.zeros((len(inside), len(places)))
    return _agreement(end.beyond_kept, np.clip((places - end.length_m) / end.beyond_m, 0, 1), inside, usual)


def _agreement(kept: float, share: np.ndarray, inside: np.ndarray, usual: UsualKept) -> np.ndarray:
    """(k, shares): logarithm of how likely a piece keeps that much, spoilt on a share of its length."""
    lost = (usual.kept - inside)[:, np.newaxis]
    variance = usual.noise**2 + (share * _VARIES) ** 2 + (2 * _UNEVEN * lost) ** 2 * share * (1 - share)
    return -((kept - usual.kept + share * lost) ** 2) / (2 * variance) - np.log(variance) / 2


def _mean(weight: np.ndarray, first: np.ndarray, last: np.ndarray) -> EndEstimate:
    """``weight``: (k, places of the first end, places of the last one)."""
    weight, first = weight.sum(axis=0), first[:, np.newaxis]
    weight = weight / weight.sum()
    one, other = float((weight * first).sum()), float((weight * last).sum())
    variance = float((weight * (first + last - one - other) ** 2).sum())
    return one, other, _WITHIN * variance**0.5


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

    def count_neighbours(self, lines: Iterable[Sequence[Step]]) -> None:
        """A piece between two runs may be spoilt by either: each is given half of it."""
        for steps in lines:
            self._claims.update(step[0] for step in self._beyond(steps) if step is not None)

    def parts(self, steps: Sequence[Step]) -> tuple[_Parts, float]:
        """What a run takes, in its order; and half the 95 % interval of its length."""
        first, last = (self._pieces[number] for number, _ in (steps[0], steps[-1]))
        kept = [self._pieces[number].kept_1 for number, _ in steps]
        known = [one for one in kept if one is not None]
        if len(known) < len(kept):
            return run_parts(steps, self._pieces, (0.0, 0.0)), 0.0
        beyond = self._beyond(steps)
        start, stop = [
            self._end(number, outer, step)
            for (number, _), outer, step in zip((steps[0], steps[-1]), self._outer(steps), beyond)
        ]
        if len(steps) == 1:
            first_m, last_m, within_m = estimated_alone(start, stop, self._usual, self._least_kept)
        else:
            inner, least_kept = known[1:-1], self._least_kept
            first_m, last_m, within_m = estimated_ends(start, inner, stop, self._usual, least_kept)
        over = first_m - first.length_m, last_m - last.length_m
        return run_parts(steps, self._pieces, over, beyond), within_m

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
    lines = unbroken_lines(ends, {number: pieces[number].seam if pieces[number].seam_id else None for number in failed})
    run_ends = None
    if least_kept is not None:
        run_ends = RunEnds(pieces, states, places, _usual(pieces, states, places), least_kept)
        run_ends.count_neighbours(lines)
    runs = [_run(steps, pieces, run_ends) for steps in lines]
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


def _run(steps: Sequence[Step], pieces: Sequence[DeliveredPiece], run_ends: RunEnds | None) -> FailureRun:
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
    middle = parts[half]
    place = pieces[middle.piece].point((middle.start + middle.stop) / 2)
    return FailureRun(0, float(lengths[-1]), numbers, sheets, place, parts, within)
