"""Whether each piece passed, failed, or could not be measured; and the metres of each kind."""
from __future__ import annotations

from collections.abc import Sequence

from ...imagery.statistics.observers import DECIDED, INVISIBLE, VISIBLE
from .decision import MetreFigures, PieceState
from .delivery import DeliveredPiece, Delivery, SeenWindow
from .failure_runs import failure_runs

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
    name: str, pieces: Sequence[DeliveredPiece], states: Sequence[PieceState], unclear: Sequence[bool], longest_m: float
) -> MetreFigures:
    """Of pieces with their states; ``unclear``: whether their intervals hold the limit."""
    lengths = [piece.length_m for piece in pieces]
    measured = [state is not PieceState.NOT_MEASURED for state in states]
    failed = [state is PieceState.FAILED for state in states]
    told = [here and known for here, known in zip(unclear, measured)]
    measured_m, failed_m, unclear_m = (_sum(lengths, kind) for kind in (measured, failed, told))
    return MetreFigures(
        name, len(pieces), sum(failed), sum(lengths), measured_m, failed_m, unclear_m, longest_m
    )  # fmt: skip


def sheet_figures(
    delivery: Delivery, states: Sequence[PieceState], unclear: Sequence[bool]
) -> tuple[MetreFigures, ...]:
    """Of each sheet by itself, of one without seams too."""
    found = []
    members: dict[str, list[int]] = {}
    for place, piece in enumerate(delivery.pieces):
        members.setdefault(piece.sheet, []).append(place)
    for sheet in delivery.sheets:
        places = members.get(sheet, [])
        pieces, own = [delivery.pieces[place] for place in places], [states[place] for place in places]
        runs = failure_runs(pieces, own, delivery.unit_m)
        longest = runs[0].length_m if runs else 0.0
        found.append(metre_figures(sheet, pieces, own, [unclear[place] for place in places], longest))
    return tuple(found)


def _sum(lengths: Sequence[float], kind: Sequence[bool]) -> float:
    return sum((length for length, counts in zip(lengths, kind) if counts), 0.0)
