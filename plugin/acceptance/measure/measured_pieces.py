"""What each piece counts as, and the metres of each kind."""
from __future__ import annotations

import math
from collections.abc import Hashable, Iterable, Iterator, Sequence
from itertools import repeat

import numpy as np
from scipy import stats

from ...imagery.seam_totals import PieceState, failing_chance, holds, piece_state
from ...imagery.statistics import DECIDED, INVISIBLE, NORMAL_95, VISIBLE, Interval, agreement, critical_t
from .decision import DecidedPiece, FailureRun, MetreFigures, Observers
from .delivery import DeliveredPiece, Delivery, SeenWindow
from .sampling_risks import cluster_members

NO_VERDICT = "not_comparable"  # the scan's word


def state_of(piece: DeliveredPiece, least_kept: float) -> PieceState:
    """State of a piece, by what it kept and what the scan says of it."""
    if not piece.has_detail:
        return PieceState.NO_DETAIL
    return piece_state(piece.kept_1, piece.kept_low, piece.kept_high, least_kept, piece.verdict != NO_VERDICT)


def seen_state(windows: Sequence[SeenWindow]) -> PieceState:
    """State of a piece by what an operator saw in the windows over it, the nearest that was judged.

    The first operator's word comes first. A visible loss fails.
    """
    words = (word for window in windows for word in (window.observer, window.observer_2) if word in DECIDED)
    word = next(words, "")
    return {VISIBLE: PieceState.FAILED, INVISIBLE: PieceState.PASSED}.get(word, PieceState.NOT_MEASURED)


def is_unclear(piece: DeliveredPiece, least_kept: float) -> bool:
    """Whether its interval holds the limit."""
    low, high = piece.kept_low, piece.kept_high
    return low is not None and high is not None and holds(low, high, least_kept)


def known_within(pieces: Iterable[DecidedPiece], least_kept: float) -> float:
    """Half the 95 % interval of the metres of some pieces that failed, as their intervals let pieces lie on the other
    side of the limit; m. Each is as likely to keep less than the least as its own interval says."""
    squares = (
        one.piece.length_m**2 * chance * (1 - chance) for one in pieces if one.is_unclear
        for chance in [failing_chance(one.piece.kept_1, one.piece.kept_low, one.piece.kept_high, least_kept)]
    )
    return NORMAL_95 * math.fsum(squares) ** 0.5


def ends_within(pieces: Sequence[DecidedPiece]) -> float:
    """Half the 95 % interval of the metres that failed, as failures end inside of pieces and sums are of whole ones; m.

    Where a failed piece and a sound one of a seam follow each other, the failure ends anywhere within half a piece
    from there. Pieces in the delivery's order.
    """
    squares = (
        (one.piece.length_m**2 + other.piece.length_m**2) / 24  # of an even spread over a piece: its square by 12
        for one, other in zip(pieces, pieces[1:])
        if (one.state is PieceState.FAILED) != (other.state is PieceState.FAILED) and _goes_on(one.piece, other.piece)
    )
    return NORMAL_95 * math.fsum(squares) ** 0.5


def _goes_on(piece: DeliveredPiece, other: DeliveredPiece) -> bool:
    """Whether the other one follows along the seam, be it that one between them is not there."""
    if not piece.seam_id or piece.seam != other.seam or piece.station_m is None or other.station_m is None:
        return False
    return other.station_m - piece.station_m < 2 * piece.length_m


def metre_figures(
    pieces: Sequence[DecidedPiece], runs: Sequence[FailureRun], unknown: Sequence[FailureRun]
) -> MetreFigures:
    """Figures of the whole delivery: sums of pieces. ``unknown``: rows of pieces that were not measured."""
    longest = [max((run.length_m for run in rows), default=0.0) for rows in (runs, unknown)]
    return _figures("", pieces, [(one, one.piece.length_m) for one in pieces], longest)


def sheet_figures(
    delivery: Delivery, pieces: Sequence[DecidedPiece], runs: Sequence[FailureRun], unknown: Sequence[FailureRun]
) -> list[MetreFigures]:
    """Figures of each sheet by itself, of one without seams too.

    A piece over a border counts in the sheet of its middle, its metres where they lie.
    """
    counted: dict[str, list[DecidedPiece]] = {sheet: [] for sheet in delivery.sheets}
    parts: dict[str, list[tuple[DecidedPiece, float]]] = {sheet: [] for sheet in counted}
    longest = {sheet: [0.0, 0.0] for sheet in counted}
    for one in pieces:
        counted[one.piece.sheet].append(one)
        for part in one.piece.in_sheets:
            parts[part.sheet].append((one, one.piece.length_m * (part.stop - part.start)))
    for kind, run in [*((0, run) for run in runs), *((1, run) for run in unknown)]:
        here, metres = "", 0.0
        for sheet, length in _in_sheets(run, delivery):
            here, metres = sheet, length if sheet != here else metres + length
            longest[sheet][kind] = max(longest[sheet][kind], metres)
    return [_figures(sheet, counted[sheet], parts[sheet], longest[sheet]) for sheet in counted]


def _figures(
    name: str, counted: Sequence[DecidedPiece], parts: Sequence[tuple[DecidedPiece, float]],
    longest_m: Sequence[float],
) -> MetreFigures:
    """``parts``: pieces and how many metres of each; ``longest_m``: failure, and row of what was not measured."""
    metres = {state: math.fsum(length for one, length in parts if one.state is state) for state in PieceState}
    failed = metres[PieceState.FAILED]
    return MetreFigures(
        name, len(counted), sum(one.state is PieceState.FAILED for one in counted), math.fsum(metres.values()),
        metres[PieceState.NO_DETAIL], metres[PieceState.PASSED] + failed, failed,
        math.fsum(length for one, length in parts if one.is_unclear), longest_m[0],
        math.fsum(length for one, length in parts if one.is_unclear and one.state is PieceState.FAILED), longest_m[1],
    )  # fmt: skip


def _in_sheets(run: FailureRun, delivery: Delivery) -> Iterator[tuple[str, float]]:
    """Sheets and metres, as they follow each other along a run."""
    for number, is_turned in zip(run.pieces, run.turned):
        piece = delivery.pieces[number]
        for part in reversed(piece.in_sheets) if is_turned else piece.in_sheets:
            yield part.sheet, (part.stop - part.start) * piece.length_m


_TOOL_WORDS = {"significant": VISIBLE, "reduced": INVISIBLE, "preserved": INVISIBLE}  # docs/desk/judging.md


def windows_over(delivery: Delivery) -> Iterator[tuple[SeenWindow, ...]]:
    """For each piece those that hold its middle, the one whose own middle is nearest first."""
    if not delivery.windows:
        yield from repeat((), len(delivery.pieces))
        return
    left, bottom, right, top = np.array([window.extent for window in delivery.windows]).T
    for piece in delivery.pieces:
        x, y = piece.middle
        held = np.flatnonzero((left <= x) & (x <= right) & (bottom <= y) & (y <= top))
        apart = np.hypot((left + right)[held] / 2 - x, (bottom + top)[held] / 2 - y)
        yield tuple(delivery.windows[int(place)] for place in held[np.argsort(apart, kind="stable")])


def observers(windows: Sequence[SeenWindow]) -> Observers | None:
    """None where nobody judged a window."""
    both = agreement([(window.observer, window.observer_2) for window in windows])
    tool = agreement([(window.observer, _TOOL_WORDS.get(window.verdict, "")) for window in windows])
    if not any(word in DECIDED for window in windows for word in (window.observer, window.observer_2)):
        return None
    return Observers(both if both.count else None, tool if tool.count else None)


CONFIDENCE = 0.95


def failed_interval(pieces: Sequence[DecidedPiece]) -> Interval | None:
    """The share of failed metres of the pieces that were measured; None where nothing was."""
    measured = [
        (one.piece.length_m, float(one.state is PieceState.FAILED), one.piece.seam) for one in pieces if one.is_measured
    ]  # fmt: skip
    return failed_share_interval(*zip(*measured)) if measured else None


def failed_share_interval(
    lengths: Sequence[float], failed: Sequence[float], clusters: Sequence[Hashable]
) -> Interval | None:
    """Failed share of metres, pieces being drawn seam by seam (``clusters``); ``failed``: the share of each that did.

    The interval of Korn and Graubard 1998 (Survey Methodology 24, 193-201), made for small shares of clustered data:
    that of Clopper and Pearson for the effective number of pieces, which is what the linearised variance over clusters
    says, smaller by the t-distribution for what that variance itself rests on: the fewer clusters make it up, and
    failures on a few long seams are few, the fewer its degrees of freedom (Satterthwaite 1946, Biometrics Bulletin 2,
    110-114). It is never smaller than the effective number of clusters, each of them as good as one piece, and that
    where they do not vary at all.
    With a single cluster nothing is known of others: the interval is 0 to 1. None where nothing was measured.
    """
    weights, values = np.asarray(lengths, float), np.asarray(failed, float)
    total = float(weights.sum())
    if total <= 0:
        return None
    share = min(float((weights * values).sum() / total), 1.0)  # rounding
    members = cluster_members(clusters)
    count = int(members.max()) + 1
    if count < 2:
        return Interval(share, 0.0, 1.0)
    effective = _effective_count(weights, values, share, members, count)
    low, high = _clopper_pearson(share * effective, effective)
    return Interval(share, min(low, share), max(high, share))


def _effective_count(
    weights: np.ndarray, values: np.ndarray, share: float, members: np.ndarray, count: int
) -> float:
    """Number of independent pieces that would tell as much."""
    sizes = np.bincount(members, weights)
    clusters, pieces = float(sizes.sum() ** 2 / (sizes**2).sum()), float(weights.sum() ** 2 / (weights**2).sum())
    squares = (np.bincount(members, weights * (values - share)) / weights.sum()) ** 2
    variance = float(squares.sum()) * count / (count - 1)  # of the ratio, linearised
    if variance <= 0:
        return clusters
    freedom = float(np.clip(squares.sum() ** 2 / (squares**2).sum(), 1.0, count - 1))
    fewer = (stats.norm.ppf((1 + CONFIDENCE) / 2) / float(critical_t(CONFIDENCE, freedom))) ** 2
    return float(np.clip(share * (1 - share) / variance * fewer, clusters, pieces))


def _clopper_pearson(found: float, count: float) -> tuple[float, float]:
    tail = (1 - CONFIDENCE) / 2
    low = float(stats.beta.ppf(tail, found, count - found + 1)) if found > 0 else 0.0
    high = float(stats.beta.ppf(1 - tail, found + 1, count - found)) if found < count else 1.0
    return low, high
