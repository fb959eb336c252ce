"""An operation done to a window, what was read of it, and whether that is what happened."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from .known_windows import KnownWindow, WindowFacts
from .production import Operation
from .readings import Reading, peers, read

HARDLY_LOST = 0.95
"""Share of the detail along the seam: where more is left, a feather took nothing that anybody could name."""
MIN_MISFIT_PX = 0.7
"""From there on a feather's loss may as well be the misfit's."""


@dataclass(frozen=True)
class Finding:
    """What was read of one mosaic, and what is known of it."""

    reading: Reading
    peers: tuple[float, float, float] | None
    truth: float
    """kept_1 as it is; nan where the mosaic holds a source that is not given."""
    foreign: float
    """Share of the pixels from a source that is not given, or that was not made use of."""
    mains: frozenset[str]
    """Causes that are right as the main one."""
    allowed: frozenset[str]
    """Causes that are true or that it is no mistake to name."""


@dataclass(frozen=True, eq=False)
class Outcome:
    """What became of one window."""

    operation: Operation
    window: WindowFacts
    finding: Finding

    @property
    def reading(self) -> Reading:
        return self.finding.reading

    @property
    def truth(self) -> float:
        return self.finding.truth

    @property
    def foreign(self) -> float:
        return self.finding.foreign

    @property
    def misfit(self) -> float:
        """How far the two main sources lie off each other as placed in the mosaic, px."""
        moved = self.operation.making.shift or (0.0, 0.0)
        return float(np.hypot(*np.add(self.window.misfit, moved)))

    @property
    def allowed(self) -> frozenset[str]:
        """Causes that are true or that it is no mistake to name."""
        fits = not self.misfit >= MIN_MISFIT_PX
        return self.finding.allowed if fits else self.finding.allowed | {"misregistration"}

    @property
    def true_causes(self) -> tuple[str, ...]:
        """What was done, without a feather between images so alike that it took nothing."""
        causes = self.operation.true_causes
        if not self.truth > HARDLY_LOST:
            return causes
        return tuple(cause for cause in causes if cause != "feathering") or ("none",)

    @property
    def is_main_right(self) -> bool:
        """Whether the main cause is the true one, or one that can't be told from it where no detail was lost.

        Where images that do not fit were feathered, the misfit is as right as the feather; where they were cut hard and
        at most balanced, which takes nothing either, it is as right as that.
        """
        true, said = self.true_causes[0], self.reading.cause
        if true in ("feathering", "balanced") and said == "misregistration":
            return said in self.allowed
        return said in (true, *self.finding.mains) or (true == "none" and said in self.allowed)

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

    @property
    def is_measured(self) -> bool:
        """Whether both kept_1 and its truth are known."""
        return self.has_kept and not np.isnan(self.truth)

    @property
    def error(self) -> float:
        """Error of kept_1."""
        return self.reading.kept - self.truth

    def tone_errors(self) -> Iterator[tuple[str, float]]:
        """How much what was measured of the main sources' grey values and places is off, each with what it is."""
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


def find(operation: Operation, window: KnownWindow, with_peers: bool = False) -> Finding:
    """Make a mosaic and read it."""
    made = operation.make(window)
    reading = read(made, window)
    missing = float(made.foreign[window.middle].mean())
    foreign = max(missing, _left_out(window, reading, len(made.sources)))
    return Finding(reading, peers(made, window) if with_peers else None, made.truth, foreign, made.mains,
                   made.allowed)


def _left_out(window: KnownWindow, reading: Reading, given: int) -> float:
    """Share of the pixels from sources that cover the window partly, if those were left out without a figure."""
    if reading.source_count >= given or not np.isnan(reading.explained):
        return 0.0
    partial = [k for k, mask in enumerate(window.valid) if not mask[window.middle].all()]
    return float(np.isin(window.labels[window.middle], partial).mean())
