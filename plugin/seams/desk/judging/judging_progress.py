"""How many windows are judged, and how many are left to judge."""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from operator import attrgetter
from typing import TYPE_CHECKING

from ....imagery.statistics.observers import DECIDED
from ....toolkit.translation import filled, tr

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord
    from .judging import Judging


@dataclass(frozen=True)
class JudgingProgress:
    """Of all windows, by the present operator."""

    count: int
    judged: int
    """With a verdict of his."""
    unsure: int
    """Where he looked and was not sure."""
    left: int
    """To look at yet. The others can't be compared, or are not inspected."""

    @property
    def is_done(self) -> bool:
        """Whether all were looked at that can be."""
        return self.left == 0 < self.judged + self.unsure

    def words(self) -> str:
        """``38 of 109 judged, 21 to go``."""
        text = tr("{judged} of {count} judged, {left} to go")
        return filled(text, judged=self.judged, count=self.count, left=self.left) if self.count else ""

    def tip(self) -> str:
        """What the other windows are."""
        rest = self.count - self.judged - self.unsure - self.left
        said = tr(
            "Judged: {judged}. Not sure: {unsure}. To look at yet: {left}. Not inspected or not comparable: {rest}."
        )
        return filled(said, judged=self.judged, unsure=self.unsure, left=self.left, rest=rest)


def judging_progress(judging: Judging, windows: Iterable[WindowRecord]) -> JudgingProgress:
    """What the present operator has done."""
    rows = list(windows)
    words = list(map(attrgetter(judging.operator.observer), rows))  # at once: each key asks this of thousands
    said = Counter(words)
    judged = sum(said[word] for word in DECIDED)
    unsure = len(rows) - said[""] - judged
    left = sum(row.is_compared for row, word in zip(rows, words) if not word)  # as ``judging.is_to_judge``
    return JudgingProgress(len(rows), judged, unsure, left)
