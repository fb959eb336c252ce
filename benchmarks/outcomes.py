"""An operation done to a window, what was read of it, and whether that is what happened."""
from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from .known_windows import KnownWindow
from .production import Operation
from .readings import Reading, peers, read
from .true_profile import truth_of

POOL = 4
"""So many times as many windows as an operation gets: each gets other ones."""
HARDLY_LOST = 0.95
"""Share of the detail along the seam: where more is left, a feather took nothing that anybody could name."""


@dataclass(frozen=True, eq=False)
class Outcome:
    """What became of one window."""

    operation: Operation
    window: KnownWindow
    reading: Reading
    peers: tuple[float, float, float]
    truth: float
    """kept_1 as it is; nan where the mosaic holds a source that is not given."""
    foreign: float
    """Share of the pixels from a source that is not given, or that was not made use of."""
    allowed: frozenset[str]

    @property
    def true_causes(self) -> tuple[str, ...]:
        """What was done, without a feather between images so alike that it took nothing."""
        causes = self.operation.true_causes
        if not self.truth > HARDLY_LOST:
            return causes
        return tuple(cause for cause in causes if cause != "feathering") or ("none",)

    @property
    def is_main_right(self) -> bool:
        """Whether the main cause is the true one, or one that can't be told from it where no detail was lost."""
        true = self.true_causes[0]
        return self.reading.cause in (true, self.operation.true_causes[0]) or (
            true == "none" and self.reading.cause in self.allowed)

    @property
    def is_true(self) -> bool:
        """Whether the main cause is one of those that took part."""
        return self.reading.cause in self.allowed or self.reading.cause == self.true_causes[0]

    @property
    def are_all_named(self) -> bool:
        return self.is_true and set(self.true_causes) <= set(self.reading.causes)

    @property
    def is_unsaid(self) -> bool:
        """Whether pixels took no part and nobody said so."""
        return self.foreign > 0 and not self.reading.says_that_missing(self.foreign)

    @property
    def has_kept(self) -> bool:
        return not np.isnan(self.reading.kept)

    def tone_errors(self) -> Iterator[tuple[str, float]]:
        """By how much what was measured of the main sources' grey values and places is off, each with what it is."""
        for turn, source in enumerate(self.window.main):
            change, tone = self.reading.tones.get(source), self.operation.tone(bool(turn))
            if change is None or self.foreign:
                continue
            if tone is not None and tone.gamma == 1 and change.tone is not None:
                yield "A, %", 100 * (change.tone.gain / tone.gain - 1)
                yield "B, DN", change.tone.bias - tone.bias
            if tone is not None:
                yield "gamma", (change.tone.gamma if change.tone else np.nan) - tone.gamma
            shift = self.operation.shift(bool(turn))
            if shift is not None:
                found = change.shift
                yield "shift, px", float(np.hypot(found.y - shift[0], found.x - shift[1])) if found else np.nan

    @property
    def holds_truth(self) -> bool:
        """Whether the interval of kept_1 does."""
        return self.reading.low <= self.truth <= self.reading.high


def outcomes(operations: Sequence[Operation], windows: Sequence[KnownWindow], count: int) -> Iterator[Outcome]:
    """Each operation in ``count`` of the windows that it fits, in turn, window by window."""
    tasks: dict[int, list[Operation]] = defaultdict(list)
    for turn, operation in enumerate(operations):
        fitting = [place for place, window in enumerate(windows) if operation.fits(window)]
        for number in range(min(count, len(fitting))):
            tasks[fitting[(turn * count + number) % len(fitting)]].append(operation)
    for place, planned in sorted(tasks.items()):
        for operation in planned:
            yield outcome(operation, windows[place])


def outcome(operation: Operation, window: KnownWindow) -> Outcome:
    """Make a mosaic and read it."""
    made = operation.make(window)
    reading = read(made, window)
    missing = made.foreign[window.middle].mean()
    truth = np.nan if missing else truth_of(made, window.middle).least
    foreign = max(float(missing), _left_out(window, reading, len(made.sources)))
    return Outcome(operation, window, reading, peers(made, window), truth, foreign, made.allowed)


def _left_out(window: KnownWindow, reading: Reading, given: int) -> float:
    """Share of the pixels from sources that cover the window partly, if those were left out without a figure."""
    if reading.source_count >= given or not np.isnan(reading.explained):
        return 0.0
    partial = [k for k, mask in enumerate(window.valid) if not mask[window.middle].all()]
    return float(np.isin(window.labels[window.middle], partial).mean())
