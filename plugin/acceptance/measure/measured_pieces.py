"""What each piece counts as, and the metres of each kind."""
from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Sequence

import numpy as np

from ...imagery.seam_totals import PieceState, failing_chance, holds, piece_state
from ...imagery.statistics import NORMAL_95
from .decision import DecidedPiece, FailureRun, MetreFigures, Unmeasured
from .delivery import DeliveredPiece, Delivery
from .orthoimage_cover import COVERED

NO_VERDICT = "not_comparable"  # the scan's word
_LEAST = 1e-3  # share kept, of which a logarithm is taken
MEASURED = (PieceState.PASSED, PieceState.FAILED)


def state_of(piece: DeliveredPiece, least_kept: float) -> PieceState:
    """State of a piece, by what it kept and what the scan says of it."""
    if not piece.has_detail:
        return PieceState.NO_DETAIL
    return piece_state(piece.kept_1, piece.kept_low, piece.kept_high, least_kept, piece.verdict != NO_VERDICT)


def is_unclear(piece: DeliveredPiece, least_kept: float) -> bool:
    """Whether its interval holds the limit."""
    low, high = piece.kept_low, piece.kept_high
    return low is not None and high is not None and holds(low, high, least_kept)


def _failing_chance(decided: DecidedPiece, least_kept: float) -> float:
    """How likely a piece whose interval holds the limit keeps less than that."""
    piece = decided.piece
    return failing_chance(piece.kept_1, piece.kept_low, piece.kept_high, least_kept)


def roughly_failed_m(pieces: Iterable[DecidedPiece], least_kept: float) -> float:
    """Metres that fail of pieces that are measured too roughly to count, as far as may be expected."""
    return math.fsum(
        decided.piece.length_m * _failing_chance(decided, least_kept) for decided in pieces
        if decided.unmeasured is Unmeasured.ROUGH
    )


def known_within(pieces: Iterable[DecidedPiece], least_kept: float) -> float:
    """Half the 95 % interval of the metres of some pieces that failed, as their intervals let pieces lie on the other
    side of the limit; m. Each is as likely to keep less than the least as its own interval says."""
    unclear = [decided for decided in pieces if decided.is_unclear]
    chances = [_failing_chance(decided, least_kept) for decided in unclear]
    squares = (decided.piece.length_m**2 * chance * (1 - chance) for decided, chance in zip(unclear, chances))
    return NORMAL_95 * math.fsum(squares) ** 0.5


def surely_failed_m(pieces: Sequence[DecidedPiece], least_kept: float) -> float:
    """Metres of the longest row among pieces of a failure, in their order, that would surely fail as one piece: what
    they keep together is known better than what each does."""
    lengths = np.array([decided.piece.length_m for decided in pieces])
    kept, low, high = np.array([_interval(decided.piece) for decided in pieces]).T
    above = lengths * np.log(kept / least_kept)
    metres, above, squares = (
        np.concatenate([[0.0], np.cumsum(values)])
        for values in (lengths, above, (lengths * np.log(high / low) / 2) ** 2)
    )
    longest = 0.0
    for first in range(len(pieces)):
        ends = above[first + 1 :] - above[first] + np.sqrt(np.maximum(squares[first + 1 :] - squares[first], 0))
        longest = max(longest, float((metres[first + 1 :] - metres[first])[ends < 0].max(initial=0.0)))
    return longest


def _interval(piece: DeliveredPiece) -> tuple[float, float, float]:
    """What a piece kept and the ends of its interval, those of a point where there is none."""
    kept = max(piece.kept_1 or 0.0, _LEAST)
    return kept, max(piece.kept_low or kept, _LEAST), max(piece.kept_high or kept, _LEAST)


def measured_with(pieces: Sequence[DecidedPiece], least_kept: float, piece_m: float) -> float:
    """The share of the metres on ground with detail that would be measured in pieces of a length, 0 to 1.

    Intervals narrow by the root of the length, as those of pieces that are put together do; no piece gets longer than
    its seam. What scans measured at 2 and 4 times the length lay within 0.06 of that (Brighton, a generated block, the
    same half smooth; JPEG 60 and 75). Where orthoimages end within the strip it is measured once what both show is as
    long as the shortest piece that was.
    """
    whole: dict[object, float] = defaultdict(float)
    shortest = min((decided.piece.length_m for decided in pieces if decided.state in MEASURED), default=math.inf)
    for piece in (decided.piece for decided in pieces):
        whole[piece.seam] += piece.length_m if piece.seam_id else math.inf
    measured = total = 0.0
    for decided in (decided for decided in pieces if decided.state is not PieceState.NO_DETAIL):
        piece = decided.piece
        total += piece.length_m
        kept, low, high = piece.kept_1, piece.kept_low, piece.kept_high
        longer_m = min(piece_m, whole[piece.seam])
        has_verdict, narrower = piece.verdict != NO_VERDICT, min(piece.length_m / longer_m, 1.0) ** 0.5
        if kept and low and high:
            low, high = (kept * (end / kept) ** narrower for end in (low, high))
            has_verdict |= narrower < 1
        is_measured = piece_state(kept, low, high, least_kept, has_verdict) in MEASURED
        if kept is None and decided.cover is not None and decided.cover.both < COVERED <= decided.cover.side:
            is_measured = decided.cover.both * longer_m >= shortest
        measured += piece.length_m * is_measured
    return measured / total if total else 0.0


def ends_within(pieces: Sequence[DecidedPiece]) -> float:
    """Half the 95 % interval of the metres that failed, as failures end inside of pieces and sums are of whole ones; m.

    Where a failed piece and a sound one of a seam follow each other, the failure ends anywhere within half a piece
    from there. Pieces in the delivery's order.
    """
    squares = (
        (first.piece.length_m**2 + other.piece.length_m**2) / 24  # of an even spread over a piece: its square by 12
        for first, other in zip(pieces, pieces[1:])
        if (first.state is PieceState.FAILED) != (other.state is PieceState.FAILED)
        and _goes_on(first.piece, other.piece)
    )
    return NORMAL_95 * math.fsum(squares) ** 0.5


def _goes_on(piece: DeliveredPiece, other: DeliveredPiece) -> bool:
    """Whether the other one follows along the seam, be it that one between them is not there."""
    if not piece.seam_id or piece.seam != other.seam or piece.station_m is None or other.station_m is None:
        return False
    return other.station_m - piece.station_m < 2 * piece.length_m


def metre_figures(
    name: str, pieces: Sequence[DecidedPiece], runs: Sequence[FailureRun], unknown: Sequence[FailureRun]
) -> MetreFigures:
    """Sums of whole pieces. ``runs`` and ``unknown``: rows of pieces that failed, or were not measured, of which those
    count whole that hold any of the pieces."""
    metres = {
        state: math.fsum(decided.piece.length_m for decided in pieces if decided.state is state) for state in PieceState
    }
    failed, failures = metres[PieceState.FAILED], [piece for piece in pieces if piece.state is PieceState.FAILED]
    numbers = {decided.piece.number for decided in pieces}
    longest, longest_unknown = (
        max((run.length_m for run in rows if not numbers.isdisjoint(run.pieces)), default=0.0)
        for rows in (runs, unknown)
    )
    kept = (decided.piece.kept_1 for decided in pieces if decided.state in MEASURED)
    return MetreFigures(
        name, len(pieces), len(failures), math.fsum(metres.values()),
        metres[PieceState.NO_DETAIL], metres[PieceState.PASSED] + failed, failed,
        math.fsum(decided.piece.length_m for decided in pieces if decided.is_unclear), longest,
        math.fsum(decided.piece.length_m for decided in failures if decided.is_unclear), longest_unknown,
        min((share for share in kept if share is not None), default=None),
    )  # fmt: skip


def pieces_of_sheets(delivery: Delivery, pieces: Sequence[DecidedPiece]) -> dict[str, list[DecidedPiece]]:
    """Pieces by the sheet of their middle, none for a sheet without seams."""
    of_sheet: dict[str, list[DecidedPiece]] = {sheet: [] for sheet in delivery.sheets}
    for decided in pieces:
        of_sheet[decided.piece.sheet].append(decided)
    return of_sheet
