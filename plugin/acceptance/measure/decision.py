"""The decision on a delivery, with all that it rests on."""
from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from math import dist, inf
from typing import Any

import numpy as np

from ...imagery.errors import Message
from ...imagery.grids import middle_of
from ...imagery.lines import line_wkt
from ...imagery.records import GEOMETRY, TableRows
from ...imagery.seam_totals import PieceState
from .acceptance_rules import AcceptanceRules
from .delivery import DeliveredPiece, Delivery, SeamCover, SeenWindow
from .orthoimage_cover import COVERED
from .sampling_plans import SamplingPlan

_ALONG = np.linspace(0, 1, 11)  # places along a piece of which one may be nearest to what was looked at


class AcceptanceOutcome(Enum):
    """What is decided. The values are words of the outputs."""

    ACCEPTED = "accepted"  # every rule is kept
    REJECTED = "rejected"  # a rule is broken, whatever else is unknown
    UNDECIDED = "undecided"  # none is broken as far as can be told, and of one at least it can't be told


class Unmeasured(Enum):
    """Why a piece on ground with detail was not measured."""

    ROUGH = "rough"  # its interval is too wide: it fails as likely as that says
    UNCOVERED = "uncovered"  # an orthoimage ends beside it or before it, or was not given
    UNEXPLAINED = "unexplained"  # the orthoimages show the place, and not what the mosaic was made from
    SHORT = "short"  # there is too little of it
    OTHER = "other"  # no orthoimages are given, or their files can't be read any more


@dataclass(frozen=True)
class DecidedPiece:
    """A piece of seam, held against the least that it must keep."""

    piece: DeliveredPiece  # the piece as it was delivered
    state: PieceState  # passed, failed, not measured, or on ground without detail
    is_unclear: bool  # it was measured, and its 95 % interval holds the limit: it counts by its value
    run: int | None  # the ``FailureRun.number`` of the failure that it belongs to; None where it did not fail
    cover: SeamCover | None = None  # None where that is not known

    @property
    def unmeasured(self) -> Unmeasured | None:
        """Why it was not measured; None where it was, or there is nothing to measure."""
        if self.state is not PieceState.NOT_MEASURED:
            return None
        if None not in (self.piece.kept_1, self.piece.kept_low, self.piece.kept_high):
            return Unmeasured.ROUGH
        if self.cover is None:
            return Unmeasured.OTHER
        if self.cover.is_short:
            return Unmeasured.SHORT
        return Unmeasured.UNCOVERED if self.cover.both < COVERED else Unmeasured.UNEXPLAINED

    @property
    def blank_m(self) -> float:
        """Metres of which nobody knows by what the producer gave: all of a piece whose orthoimages lack pixels, or show
        something else than the mosaic; of one that passed those where they lack pixels."""
        if self.unmeasured in (Unmeasured.UNCOVERED, Unmeasured.UNEXPLAINED):
            return self.piece.length_m
        if self.cover is None or self.cover.side >= COVERED or self.state is not PieceState.PASSED:
            return 0.0
        return self.piece.length_m * (1 - self.cover.side)


@dataclass(frozen=True)
class FailureRun:
    """Failed pieces that follow each other without a break, across sheets where their ends touch."""

    number: int  # 1 for the longest
    length_m: float  # length of its pieces together
    pieces: tuple[int, ...]  # the pieces' numbers, in the order in which they follow each other
    sheets: tuple[str, ...]  # that it lies in
    place: tuple[float, float]  # a point half-way along it, in the delivery's reference system
    joined_m: float = 0.0  # length of it with all failures that meet it, and those that meet these


@dataclass(frozen=True)
class MetreFigures:
    """Numbers of pieces and metres of seam, of a sheet or of the whole delivery."""

    name: str  # name of the sheet; empty for the whole delivery
    piece_count: int  # all pieces
    failed_count: int  # pieces that failed
    total_m: float  # metres of all seams
    no_detail_m: float  # metres on ground without detail, which has nothing to lose and is not judged
    measured_m: float  # metres of the pieces that could be measured
    failed_m: float  # metres of the pieces that failed
    unclear_m: float  # in pieces of which the interval holds the limit, failed or passed
    longest_failure_m: float | None  # metres of the failed pieces in the longest failure; None where they are a sample
    failed_unclear_m: float = 0.0  # metres that failed, in pieces whose interval reaches above the limit
    longest_unknown_m: float = 0.0  # metres of the longest row of pieces that failed or were not measured
    least_kept: float | None = None  # share kept by the measured piece that kept least; None where none was measured

    @property
    def judged_m(self) -> float:
        """Metres of the pieces on ground with detail: what shares are of."""
        return self.total_m - self.no_detail_m

    @property
    def not_measured_m(self) -> float:
        """Metres of the pieces on ground with detail that could not be measured."""
        return self.judged_m - self.measured_m

    @property
    def failed_share(self) -> float | None:
        """Share of the measured metres that failed, 0 to 1; None where nothing was measured."""
        return self.failed_m / self.measured_m if self.measured_m else None

    @property
    def measured_share(self) -> float:
        """Share of the seams on ground with detail that could be measured, by metres, 0 to 1."""
        return self.measured_m / self.judged_m if self.judged_m > 0 else 0.0


@dataclass(frozen=True)
class RuleOutcome:
    check: str  # one of ``acceptance_rules.CHECKS``
    value: float | None  # share of 1, metres, or nonconforming items; None where it can't be measured
    limit: float  # the smallest or largest value that passes
    is_least: bool  # whether ``limit`` is the smallest one
    passed: bool | None  # None where it can't be told
    source: str  # where the limit comes from
    sentence: Message  # the outcome in words
    low: float | None = None  # the smallest that the value may be, by what is not known; None: nothing is told of that
    high: float | None = None  # the largest one


@dataclass(frozen=True)
class PlanOutcome:
    plan: SamplingPlan
    seed: int | None  # seed of the drawing; None where the sample came with the layer, or is the whole lot
    inspected: int  # items of the sample that were measured
    nonconforming: int  # inspected items that failed


@dataclass(frozen=True)
class Decision:
    """What is done with a delivery, and why."""

    outcome: AcceptanceOutcome
    """Accepted, rejected or undecided."""
    why: Message
    """Its reasons: all rules that were kept, those that were broken, or what is open."""
    foremost: Message
    """Likewise, of what is open only what would decide it first; and which layers are not as their scan left them."""
    sentences: tuple[Message, ...]
    """The decision with its foremost reasons, where it is undecided what would decide it and what else is open, then
    what it rests on."""
    rules: AcceptanceRules
    """The rules by which it was taken."""
    delivery: Delivery
    """What was decided on."""
    outcomes: tuple[RuleOutcome, ...]
    """Outcomes of the rules that decide."""
    whole: MetreFigures
    """The metres of all sheets together."""
    sheets: tuple[MetreFigures, ...]
    """In the order of ``Delivery.sheets``; one without seams has no pieces."""
    sheet_outcomes: tuple[AcceptanceOutcome | None, ...]
    """Outcome of each sheet by itself, by the same limits; None for one without seams, or where a sample decides."""
    pieces: tuple[DecidedPiece, ...]
    """In the delivery's order."""
    runs: tuple[FailureRun, ...]
    """The longest first."""
    unknown_runs: tuple[FailureRun, ...] = ()
    """Rows of pieces without a break that were not measured, with those that failed among them, longer than a failure
    may be; the longest first."""
    plan: PlanOutcome | None = None
    """None with all inspected."""

    def to_geodataframe(self) -> Any:
        """Its pieces as a ``geopandas.GeoDataFrame``, one row each: what was measured, and what it counts as."""
        return self._rows().to_geodataframe()

    def to_dataframe(self) -> Any:
        """Likewise as a ``pandas.DataFrame``, lines as WKT in ``geometry``."""
        return self._rows().to_dataframe()

    def _rows(self) -> TableRows:
        rows = TableRows(wkt=self.delivery.wkt)
        for decided in self.pieces:
            piece = decided.piece
            rows.append({
                "sheet": piece.sheet, "seam_id": piece.seam_id, "station": piece.station_m, "length": piece.length_m,
                "kept_1": piece.kept_1, "kept_low": piece.kept_low, "kept_high": piece.kept_high,
                "left_source": piece.left_source, "right_source": piece.right_source, "state": decided.state.value,
                "is_unclear": decided.is_unclear, "failure": decided.run, GEOMETRY: line_wkt(piece.vertices),
            })
        return rows

    @property
    def accepted(self) -> bool | None:
        """None where it is undecided."""
        return {AcceptanceOutcome.ACCEPTED: True, AcceptanceOutcome.REJECTED: False}.get(self.outcome)

    @property
    def failed(self) -> tuple[DecidedPiece, ...]:
        """The pieces to send back."""
        return tuple(decided for decided in self.pieces if decided.state is PieceState.FAILED)

    @property
    def longest_failure_m(self) -> float | None:
        """None where the delivery is a sample, which does not tell."""
        return self.whole.longest_failure_m


@dataclass(frozen=True, eq=False)
class Defect:
    """A failure without a break, with its pieces."""

    run: FailureRun
    pieces: tuple[DecidedPiece, ...]  # in the order in which they follow each other
    windows: tuple[SeenWindow, ...] = ()  # inspected ones of it, nearest to the worst first

    @property
    def worst(self) -> DecidedPiece:
        return min(self.pieces, key=lambda decided: inf if decided.piece.kept_1 is None else decided.piece.kept_1)

    @property
    def cause(self) -> str:
        """Cause of the inspected window nearest to the worst piece that has one; empty without any."""
        return next((window.cause for window in self.windows if window.cause), "")

    @property
    def remarks(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys(remark for window in self.windows for remark in window.remarks))


def defects_of(decision: Decision) -> tuple[Defect, ...]:
    """The longest first, each with the windows that hold a part of it."""
    defects = []
    for run in decision.runs:
        defect = Defect(run, tuple(decision.pieces[number] for number in run.pieces))
        x, y = np.array([decided.piece.point(share) for decided in defect.pieces for share in _ALONG]).T
        windows = [
            window for window in decision.delivery.windows for left, bottom, right, top in [window.extent]
            if ((x >= left) & (x <= right) & (y >= bottom) & (y <= top)).any()
        ]
        windows.sort(key=lambda window: dist(middle_of(window.extent), defect.worst.piece.middle))
        defects.append(replace(defect, windows=tuple(windows)))
    return tuple(defects)
