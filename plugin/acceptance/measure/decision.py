"""The decision on a delivery, with all that it rests on."""
from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np

from ...imagery.errors import Message
from ...imagery.statistics import Agreement, Interval
from .acceptance_rules import AcceptanceRules
from .delivery import DeliveredPiece, Delivery, SeenWindow, part_of_line
from .sampling_plans import OperatingCharacteristic, SamplingPlan


class PieceState(Enum):
    """What became of a piece."""

    PASSED = "passed"
    FAILED = "failed"
    NOT_MEASURED = "not_measured"


@dataclass(frozen=True, eq=False)
class DecidedPiece:
    """A piece of seam, held against the least that it must keep."""

    piece: DeliveredPiece
    """As it was delivered."""
    state: PieceState
    """Passed, failed or not measured."""
    is_unclear: bool
    """Its 95 % interval holds the limit, so that nobody can tell on which side of it the piece is."""
    run: int | None
    """The failure without a break it belongs to, by its ``FailureRun.number``; None where it did not fail."""
    is_sampled: bool
    """Whether the decision by a plan looks at it; with all inspected every piece is."""
    windows: tuple[SeenWindow, ...] = ()
    """Inspected windows that lie over it, the one whose middle is nearest first."""

    @property
    def is_measured(self) -> bool:
        """Whether it passed or failed."""
        return self.state is not PieceState.NOT_MEASURED


@dataclass(frozen=True)
class FailedPart:
    """The part of a piece that a failure takes, as shares of its length along its line."""

    piece: int
    """Its number."""
    start: float
    stop: float
    is_turned: bool = False
    """Whether the failure runs against its line."""

    @property
    def share(self) -> float:
        return self.stop - self.start

    def turned(self, is_turned: bool = True) -> FailedPart:
        """The same part, counted from the line's other end."""
        if not is_turned:
            return self
        return FailedPart(self.piece, 1 - self.stop, 1 - self.start, not self.is_turned)


@dataclass(frozen=True)
class FailureRun:
    """Failed pieces that follow each other without a break, across sheets where their ends touch."""

    number: int
    """1 for the longest."""
    length_m: float
    """From where it begins to where it ends inside of its pieces, as far as these tell."""
    pieces: tuple[int, ...]
    """The pieces' numbers, in the order in which they follow each other."""
    sheets: tuple[str, ...]
    """That it lies in."""
    place: tuple[float, float]
    """A point half-way along it, in the delivery's reference system."""
    parts: tuple[FailedPart, ...]
    """What it takes of its pieces, and of those that passed at its ends, in its order."""
    within_m: float
    """Half the 95 % interval of its length; 0 where nothing tells."""


@dataclass(frozen=True)
class MetreFigures:
    """Of a sheet, or of the whole delivery."""

    name: str
    """Of the sheet; empty for the whole delivery."""
    piece_count: int
    """All pieces."""
    failed_count: int
    """Pieces that failed."""
    total_m: float
    """Of all seams."""
    measured_m: float
    """Of the pieces that could be measured."""
    failed_m: float
    """Of the failed parts of those."""
    unclear_m: float
    """In pieces of which the interval holds the limit, failed or passed."""
    longest_failure_m: float | None
    """Of the pieces in it alone; None where they are a sample."""

    @property
    def not_measured_m(self) -> float:
        """Of the pieces that could not be measured."""
        return self.total_m - self.measured_m

    @property
    def failed_share(self) -> float | None:
        """Of what was measured, 0 to 1; None where nothing was."""
        return self.failed_m / self.measured_m if self.measured_m else None

    @property
    def measured_share(self) -> float:
        """Of all seams, 0 to 1."""
        return self.measured_m / self.total_m if self.total_m else 0.0


@dataclass(frozen=True)
class RuleOutcome:
    """One rule, held against the delivery."""

    check: str
    """One of ``acceptance_rules.CHECKS``."""
    value: float | None
    """Share as a fraction of 1, length in metres, or nonconforming items; None where it can't be measured."""
    limit: float
    """The smallest or largest value that passes."""
    is_least: bool
    """Whether ``limit`` is the smallest one."""
    passed: bool | None
    """None where it can't be told."""
    source: str
    """Where the limit comes from."""
    sentence: Message
    """The outcome in words."""


@dataclass(frozen=True)
class PlanOutcome:
    """What a plan of sampling decided."""

    plan: SamplingPlan
    characteristic: OperatingCharacteristic
    seed: int | None
    """Of the drawing; None where the sample came with the layer, or is the whole lot."""
    inspected: int
    """Items of the sample that were measured."""
    nonconforming: int
    """Of these, that failed."""


@dataclass(frozen=True)
class Observers:
    """What operators saw in the windows, against each other and against the tool."""

    both: Agreement | None
    """The two operators; None where only one judged."""
    with_tool: Agreement | None
    """The first operator (first) against the tool, which 'sees' what it calls significant; None where nobody judged."""


@dataclass(frozen=True, eq=False)
class Decision:
    """What is done with a delivery, and why."""

    accepted: bool
    """Whether all rules are kept."""
    sentences: tuple[Message, ...]
    """The decision with its risk first, then its reasons, then what could not be measured or told."""
    rules: AcceptanceRules
    """By which it was taken."""
    delivery: Delivery
    """What was decided on."""
    outcomes: tuple[RuleOutcome, ...]
    """Of the rules that decide."""
    whole: MetreFigures
    """The metres of all sheets together."""
    sheets: tuple[MetreFigures, ...]
    """In the order of ``Delivery.sheets``; one without seams has no pieces."""
    failed_share: Interval | None
    """Of the measured metres, with its 95 % interval; None where nothing was measured."""
    pieces: tuple[DecidedPiece, ...]
    """In the delivery's order."""
    runs: tuple[FailureRun, ...]
    """The longest first."""
    plan: PlanOutcome | None = None
    """None with all inspected."""
    observers: Observers | None = None
    """None without windows."""
    by_observer: bool = False
    """Whether pieces failed by what operators saw, whatever they kept."""

    @property
    def failed(self) -> tuple[DecidedPiece, ...]:
        """The pieces to send back."""
        return tuple(one for one in self.pieces if one.state is PieceState.FAILED)

    @property
    def longest_failure_m(self) -> float | None:
        """None where the delivery is a sample, which does not tell."""
        return self.whole.longest_failure_m


@dataclass(frozen=True, eq=False)
class Defect:
    """A failure without a break."""

    number: int
    """1 for the longest."""
    sheets: tuple[str, ...]
    length_m: float
    lines: tuple[np.ndarray, ...]
    """(n, 2) x and y of what it takes of each piece, in the delivery's reference system."""
    place: tuple[float, float]
    """A point half-way along it."""
    worst: DecidedPiece
    """The piece that kept least."""
    band_width_m: float | None
    """Of its widest band; None where none is known."""
    cause: str
    """Of the inspected window that lies nearest to the worst piece, else of another one on it; empty without any."""
    remarks: tuple[str, ...]
    """What operators wrote of the windows on it."""


def defects_of(decision: Decision) -> tuple[Defect, ...]:
    """The longest first."""
    return tuple(_defect(decision, run) for run in decision.runs)


def _defect(decision: Decision, run: FailureRun) -> Defect:
    pieces = [decision.pieces[number] for number in run.pieces]
    worst = min(pieces, key=_kept)
    widths = [one.piece.band_width_m for one in pieces if one.piece.band_width_m is not None]
    windows = _windows([worst, *pieces])
    vertices = (decision.pieces[part.piece].piece.vertices for part in run.parts)
    lines = [part_of_line(line, part.start, part.stop) for line, part in zip(vertices, run.parts)]
    return Defect(
        run.number, run.sheets, run.length_m, tuple(lines), run.place, worst,
        max(widths, default=None), next((one.cause for one in windows if one.cause), ""),
        tuple(dict.fromkeys(words for one in windows for words in (one.remark, one.remark_2) if words)),
    )  # fmt: skip


def _kept(one: DecidedPiece) -> float:
    return float("inf") if one.piece.kept_1 is None else one.piece.kept_1


def _windows(pieces: list[DecidedPiece]) -> list[SeenWindow]:
    """Those that lie on any of the pieces, each once, those of the first piece in front."""
    return list({one.window_id: one for piece in pieces for one in piece.windows}.values())
