"""What each piece counts as, and the metres of each kind."""
from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from ...imagery.seam_totals import PieceState, failing_chance, holds, piece_state
from ...imagery.statistics import NORMAL_95
from .decision import DecidedPiece, FailureRun, MetreFigures
from .delivery import DeliveredPiece, Delivery

NO_VERDICT = "not_comparable"  # the scan's word
_SURE = 0.975  # probability: the lower end of a 95 % interval
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


def known_within(pieces: Iterable[DecidedPiece], least_kept: float) -> float:
    """Half the 95 % interval of the metres of some pieces that failed, as their intervals let pieces lie on the other
    side of the limit; m. Each is as likely to keep less than the least as its own interval says."""
    unclear = [decided for decided in pieces if decided.is_unclear]
    chances = [_failing_chance(decided, least_kept) for decided in unclear]
    squares = (decided.piece.length_m**2 * chance * (1 - chance) for decided, chance in zip(unclear, chances))
    return NORMAL_95 * math.fsum(squares) ** 0.5


def surely_failed_m(pieces: Sequence[DecidedPiece], least_kept: float) -> float:
    """Metres of the longest row among pieces of a failure, in their order, that failed all, as sure as their intervals
    say; one that passed among them would break it."""
    chances = [_failing_chance(decided, least_kept) if decided.is_unclear else 1.0 for decided in pieces]
    logs = np.concatenate([[0.0], np.cumsum(np.log(np.maximum(chances, 1e-9)))])
    metres = np.concatenate([[0.0], np.cumsum([decided.piece.length_m for decided in pieces])])
    first = np.searchsorted(-logs, -logs + math.log(_SURE))
    return float((metres - metres[first]).max())


def measured_with(pieces: Sequence[DecidedPiece], least_kept: float, piece_m: float) -> float:
    """The share of the metres on ground with detail that would be measured in pieces of a length, 0 to 1.

    Intervals narrow by the root of the length, as those of pieces that are put together do; no piece gets longer than
    its seam. What scans measured at 2 and 4 times the length lay within 0.06 of that (Brighton, a generated block, the
    same half smooth; JPEG 60 and 75).
    """
    whole: dict[object, float] = defaultdict(float)
    for piece in (decided.piece for decided in pieces):
        whole[piece.seam] += piece.length_m if piece.seam_id else math.inf
    measured = total = 0.0
    for piece in (decided.piece for decided in pieces if decided.state is not PieceState.NO_DETAIL):
        total += piece.length_m
        kept, low, high = piece.kept_1, piece.kept_low, piece.kept_high
        longer_m = min(piece_m, whole[piece.seam])
        has_verdict, narrower = piece.verdict != NO_VERDICT, min(piece.length_m / longer_m, 1.0) ** 0.5
        if kept and low and high:
            low, high = (kept * (end / kept) ** narrower for end in (low, high))
            has_verdict |= narrower < 1
        measured += piece.length_m * (piece_state(kept, low, high, least_kept, has_verdict) in MEASURED)
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
    """Sums of whole pieces. ``runs`` and ``unknown``: rows of pieces that failed, or were not measured; what lies in
    other pieces than these does not count."""
    metres = {
        state: math.fsum(decided.piece.length_m for decided in pieces if decided.state is state) for state in PieceState
    }
    failed, failures = metres[PieceState.FAILED], [piece for piece in pieces if piece.state is PieceState.FAILED]
    lengths = {decided.piece.number: decided.piece.length_m for decided in pieces}
    kept = (decided.piece.kept_1 for decided in pieces if decided.state in MEASURED)
    return MetreFigures(
        name, len(pieces), len(failures), math.fsum(metres.values()),
        metres[PieceState.NO_DETAIL], metres[PieceState.PASSED] + failed, failed,
        math.fsum(decided.piece.length_m for decided in pieces if decided.is_unclear), _longest_m(runs, lengths),
        math.fsum(decided.piece.length_m for decided in failures if decided.is_unclear), _longest_m(unknown, lengths),
        min((share for share in kept if share is not None), default=None),
    )  # fmt: skip


def counted_again(
    pieces: Iterable[DecidedPiece], shared: Mapping[int, int], states: Sequence[PieceState]
) -> float:
    """Metres of pieces in some states beyond those that would count if each place did once, m; ``shared``: in how many
    other scans' mosaics pieces lie."""
    return math.fsum(
        decided.piece.length_m * (1 - 1 / (1 + shared[decided.piece.number])) for decided in pieces
        if decided.state in states and decided.piece.number in shared
    )


def _longest_m(runs: Iterable[FailureRun], lengths: Mapping[int, float]) -> float:
    """Metres of the longest row of pieces that follow each other in a run; ``lengths``: of those that count."""
    longest = 0.0
    for run in runs:
        metres = 0.0
        for number in run.pieces:
            metres = metres + lengths[number] if number in lengths else 0.0
            longest = max(longest, metres)
    return longest


def pieces_of_sheets(delivery: Delivery, pieces: Sequence[DecidedPiece]) -> dict[str, list[DecidedPiece]]:
    """Pieces by the sheet of their middle, none for a sheet without seams."""
    of_sheet: dict[str, list[DecidedPiece]] = {sheet: [] for sheet in delivery.sheets}
    for decided in pieces:
        of_sheet[decided.piece.sheet].append(decided)
    return of_sheet
