"""Whether each piece passed, failed, or could not be measured; and the metres of each kind."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...imagery.statistics import DECIDED, INVISIBLE, VISIBLE
from .decision import FailureRun, MetreFigures, PieceState
from .delivery import DeliveredPiece, Delivery, SeenWindow

NO_VERDICT = "not_comparable"  # the scan's word


def piece_state(piece: DeliveredPiece, least_kept: float) -> PieceState:
    """By what it kept: less than the least fails, exactly as much passes.

    Where the scan has no verdict, its interval being too wide, the piece counts only if the whole interval lies on one
    side of the limit.
    """
    if piece.kept_1 is None or (piece.verdict == NO_VERDICT and is_unclear(piece, least_kept, True)):
        return PieceState.NOT_MEASURED
    return PieceState.FAILED if piece.kept_1 < least_kept else PieceState.PASSED


def seen_state(windows: Sequence[SeenWindow]) -> PieceState:
    """By what an operator saw in the windows over a piece, the nearest that was judged.

    The first operator's word comes first. A visible loss fails.
    """
    words = (word for window in windows for word in (window.observer, window.observer_2) if word in DECIDED)
    word = next(words, "")
    return {VISIBLE: PieceState.FAILED, INVISIBLE: PieceState.PASSED}.get(word, PieceState.NOT_MEASURED)


def is_unclear(piece: DeliveredPiece, least_kept: float, without_interval: bool = False) -> bool:
    """Whether its interval holds the limit; ``without_interval``: what is said where it has none."""
    if piece.kept_low is None or piece.kept_high is None:
        return without_interval
    return piece.kept_low < least_kept <= piece.kept_high


def metre_figures(
    name: str, delivery: Delivery, states: Sequence[PieceState], unclear: Sequence[bool], runs: Sequence[FailureRun]
) -> MetreFigures:
    """Of all pieces with their states; ``unclear``: whether their intervals hold the limit."""
    lengths = [piece.length_m for piece in delivery.pieces]
    measured = [state is not PieceState.NOT_MEASURED for state in states]
    told = [here and known for here, known in zip(unclear, measured)]
    return MetreFigures(
        name, len(lengths), states.count(PieceState.FAILED), sum(lengths), _sum(lengths, measured),
        sum((run.length_m for run in runs), 0.0), _sum(lengths, told), max((run.length_m for run in runs), default=0.0),
    )  # fmt: skip


def sheet_figures(
    delivery: Delivery, states: Sequence[PieceState], unclear: Sequence[bool], runs: Sequence[FailureRun]
) -> tuple[MetreFigures, ...]:
    """Of each sheet by itself, of one without seams too.

    A piece over a border counts in the sheet of its middle, its metres where they lie.
    """
    sums = {sheet: _SheetSums() for sheet in delivery.sheets}
    for piece, state, is_told in zip(delivery.pieces, states, unclear):
        sums[piece.sheet].pieces += 1
        sums[piece.sheet].failed_pieces += state is PieceState.FAILED
        for part in piece.in_sheets:
            metres = piece.length_m * (part.stop - part.start)
            own = sums[part.sheet]
            own.total_m += metres
            if state is not PieceState.NOT_MEASURED:
                own.measured_m += metres
                own.unclear_m += metres if is_told else 0.0
    for run in runs:
        here, metres = "", 0.0
        for sheet, length in _in_sheets(run, delivery):
            here, metres = sheet, length if sheet != here else metres + length
            sums[sheet].failed_m += length
            sums[sheet].longest_m = max(sums[sheet].longest_m, metres)
    return tuple(
        MetreFigures(
            sheet, one.pieces, one.failed_pieces, one.total_m, one.measured_m, one.failed_m, one.unclear_m,
            one.longest_m,
        )
        for sheet, one in sums.items()
    )  # fmt: skip


def failed_shares(count: int, runs: Sequence[FailureRun]) -> list[float]:
    """How much of each piece failures take."""
    shares = [0.0] * count
    for part in (part for run in runs for part in run.parts):
        shares[part.piece] += part.share
    return shares


@dataclass
class _SheetSums:
    """As ``MetreFigures``."""

    pieces: int = 0
    failed_pieces: int = 0
    total_m: float = 0.0
    measured_m: float = 0.0
    failed_m: float = 0.0
    unclear_m: float = 0.0
    longest_m: float = 0.0


def _in_sheets(run: FailureRun, delivery: Delivery) -> Iterator[tuple[str, float]]:
    """Sheets and metres, as they follow each other along a run."""
    for part in run.parts:
        piece = delivery.pieces[part.piece]
        for sheet in reversed(piece.in_sheets) if part.is_turned else piece.in_sheets:
            share = min(part.stop, sheet.stop) - max(part.start, sheet.start)
            if share > 0:
                yield sheet.sheet, share * piece.length_m


def _sum(lengths: Sequence[float], kind: Sequence[bool]) -> float:
    return sum((length for length, counts in zip(lengths, kind) if counts), 0.0)
