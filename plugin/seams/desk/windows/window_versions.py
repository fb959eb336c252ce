"""Of which place and which inputs the values of windows are: those of any others are stale."""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import NamedTuple

from ....imagery.grids import Extent
from ...measure.window_records import WindowRecord


class Version(NamedTuple):
    """Of what a window's values are."""

    extent: Extent | None
    """Where it lay."""
    state: int | None
    """The number of the inputs' state; None is the one in which the layer was first seen."""


class WindowVersions:
    """The versions of all values that the windows of one layer had, by the windows' numbers."""

    def __init__(self, stale: Iterable[int] = ()) -> None:
        """``stale``: numbers of those that were so when the project was saved."""
        self._versions: dict[int, dict[object, set[Version]]] = {}
        self._marks = set(stale)
        self._state: int | None = None
        self._first_state: int | None = None

    @property
    def state(self) -> int | None:
        """The number of the inputs' state."""
        return self._state

    def set_state(self, state: int | None) -> bool:
        """The inputs are these now; while it is not known which they are, as before. Whether they are others."""
        if state is None or state == self._state:
            return False
        if self._state is None:
            self._first_state = state
        self._state = state
        return True

    def meet(self, row: WindowRecord, is_copy: bool) -> None:
        """A window was read; the values that it has when it is first seen are of this version, a copy's are not."""
        if row.window_id not in self._versions:
            is_trusted = bool(row.verdict) and not is_copy and row.window_id not in self._marks
            self._versions[row.window_id] = {row.measured: {Version(row.extent, None)}} if is_trusted else {}

    def note(self, row: WindowRecord, version: Version) -> None:
        """The values that a window has now are of this version."""
        self._versions[row.window_id].setdefault(row.measured, set()).add(version)

    def outdate(self, numbers: Iterable[int]) -> None:
        """The values of these windows are of no version that may come back."""
        self._versions.update((number, {}) for number in numbers)

    def follow_saved(self, rows: Iterable[WindowRecord], before: Mapping[int, WindowRecord]) -> None:
        """Windows were saved, which may have rounded their numbers and places; ``before``: as they were, by number."""
        for row in rows:
            old = before.get(row.window_id, row)
            versions = self._versions[row.window_id].get(old.measured, set())
            self._versions[row.window_id][row.measured] = {
                version._replace(extent=row.extent) if version.extent == old.extent else version
                for version in versions
            }

    def marked(self, row: WindowRecord) -> WindowRecord:
        """With the mark of whether it is stale; the row itself where it has the right one."""
        stale = bool(row.verdict) and not self._is_up_to_date(row)
        return row if row.stale == stale else replace(row, stale=stale)

    def stale_numbers(self, rows: Iterable[WindowRecord]) -> set[int]:
        """Of all windows of the layer, those included that were not seen yet."""
        return self._marks.difference(self._versions).union(row.window_id for row in rows if row.stale)

    def _is_up_to_date(self, row: WindowRecord) -> bool:
        known = self._versions[row.window_id].get(row.measured, ())
        is_first = self._state == self._first_state and Version(row.extent, None) in known
        return is_first or Version(row.extent, self._state) in known
