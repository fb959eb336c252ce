"""How many windows are judged, and how many are left to judge."""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import compress
from operator import is_not
from typing import TYPE_CHECKING

from ....imagery.statistics import DECIDED, Operator
from ....toolkit.translation import filled, tr

if TYPE_CHECKING:
    from ...measure.window_records import WindowRecord


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
        """``38 of 109 judged, 21 to go``; where nothing is judged or to judge, as before an inspection, just that."""
        if self.count and not self.judged + self.unsure + self.left:
            return tr("nothing to judge yet")
        text = tr("{judged} of {count} judged, {left} to go")
        return filled(text, judged=self.judged, count=self.count, left=self.left) if self.count else ""

    def tip(self) -> str:
        """What the other windows are."""
        rest = self.count - self.judged - self.unsure - self.left
        said = tr(
            "Judged: {judged}. Not sure: {unsure}. To look at yet: {left}. Not inspected or not comparable: {rest}."
        )
        return filled(said, judged=self.judged, unsure=self.unsure, left=self.left, rest=rest)


_JUDGED, _UNSURE, _LEFT, _REST = "judged", "unsure", "left", "rest"


class JudgingTally:
    """Counts what one operator has done. Only windows that changed are counted anew: each key asks of thousands."""

    def __init__(self) -> None:
        self._operator: Operator | None = None
        self._windows: Sequence[WindowRecord] = ()
        self._counts: Counter[str] = Counter()
        self.left: set[int] = set()
        """Feature ids of the windows to look at yet."""

    def take(self, operator: Operator, windows: Sequence[WindowRecord]) -> None:
        """How they are now; a window that is as it was is the same record. The list is not to be changed."""
        if operator != self._operator or len(windows) != len(self._windows):
            self._operator, self._windows = operator, ()
            self._counts.clear()
            self.left.clear()
            self._add(windows)
        else:
            changed = [*map(is_not, self._windows, windows)]
            for row in compress(self._windows, changed):
                self._counts[_kind(row, operator)] -= 1
                self.left.discard(row.fid)
            self._add(compress(windows, changed))
        self._windows = windows

    def progress(self) -> JudgingProgress:
        """Of the windows that were taken last."""
        counts = self._counts
        return JudgingProgress(len(self._windows), counts[_JUDGED], counts[_UNSURE], counts[_LEFT])

    def _add(self, windows: Iterable[WindowRecord]) -> None:
        assert self._operator is not None
        for row in windows:
            kind = _kind(row, self._operator)
            self._counts[kind] += 1
            if kind == _LEFT:
                self.left.add(row.fid)


def is_left(row: WindowRecord, operator: Operator) -> bool:
    """Whether the operator has to look at a window yet."""
    return _kind(row, operator) == _LEFT


def _kind(row: WindowRecord, operator: Operator) -> str:
    word = getattr(row, operator.observer)
    if word:
        return _JUDGED if word in DECIDED else _UNSURE
    return _LEFT if row.is_compared else _REST
