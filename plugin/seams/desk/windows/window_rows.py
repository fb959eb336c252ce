"""The rows of a window layer, read one by one where they changed, and the numbers of its windows."""
from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from qgis.core import QgsVectorLayer

from ....imagery.grids import Extent
from ...measure.window_records import WindowRecord
from ...tables import window_layer
from ...tables.window_layer import UNNUMBERED
from .window_versions import WindowVersions


class LayerRows:
    """What changed is marked as unread, and read once, when somebody asks."""

    def __init__(self, layer: QgsVectorLayer | None, versions: WindowVersions) -> None:
        """``versions`` tell which rows are stale."""
        self._layer, self._versions = layer, versions
        self._rows: dict[int, WindowRecord] = {}
        self._fids: dict[int, int] = {}
        self._unread: set[int] | None = None  # None: all of them
        self._unnumbered: set[int] = set()
        self._given: dict[int | Extent | None, int] = {}  # numbers of windows that have none, by feature id and place
        self._last_number = 0  # a number is not used again, or an old result would be taken for a new window's

    def __bool__(self) -> bool:
        """Whether any were there when they were last read."""
        return bool(self._rows)

    @property
    def known_numbers(self) -> Iterable[int]:
        """Of the windows as they were last read."""
        return self._fids

    def by_fid(self) -> dict[int, WindowRecord]:
        """By feature id, in the order of their numbers, as they are now."""
        if self._layer is not None and (self._unread is None or self._unread):
            self._read(self._layer)
        return self._rows

    def by_number(self, window_id: int) -> WindowRecord | None:
        """The window with a number, as it is now."""
        rows = self.by_fid()
        return rows[self._fids[window_id]] if window_id in self._fids else None

    @property
    def next_number(self) -> int:
        """The first of the numbers for new windows."""
        self.by_fid()
        return self._last_number + 1

    def lack_numbers(self, fids: Iterable[int]) -> bool:
        """Whether one of these windows has no number in the layer."""
        return not self._unnumbered.isdisjoint(fids)

    def numbers_to_write(self, fids: Iterable[int]) -> dict[int, int]:
        """Numbers of those of these windows that have none in the layer, by feature id."""
        rows = self.by_fid()
        return {fid: rows[fid].window_id for fid in fids if fid in self._unnumbered and fid in rows}

    def change(self, fid: int) -> None:
        """One is another now."""
        if self._unread is not None:
            self._unread.add(fid)

    def change_all(self) -> None:
        """All of them may be others now."""
        self._unread = None

    def remove(self, fid: int) -> int | None:
        """One is gone; its number, where no other window has it."""
        row = self._rows.pop(fid, None)
        if self._unread is not None:
            self._unread.discard(fid)
        if row is None or self._fids.get(row.window_id) != fid:
            return None
        del self._fids[row.window_id]
        return row.window_id

    def mark(self, numbers: Iterable[int]) -> bool:
        """Mark those of these windows that are there as stale or not; whether that changed any."""
        rows = [self._rows[self._fids[number]] for number in numbers if number in self._fids]
        changed = {row.fid: marked for row in rows if (marked := self._versions.marked(row)) is not row}
        self._rows.update(changed)
        return bool(changed)

    def _read(self, layer: QgsVectorLayer) -> None:
        """Those that changed."""
        unread, self._unread = self._unread, set()
        fresh = window_layer.read_layer(layer, unread)
        if unread is not None and self._took_in_place(unread, fresh):
            return
        rows = {} if unread is None else {fid: row for fid, row in self._rows.items() if fid not in unread}
        fresh.sort(key=lambda row: (row.fid < 0, abs(row.fid)))  # of two with one number the older one keeps it
        taken = {row.window_id for row in rows.values()}
        self._last_number = max([self._last_number, *(row.window_id for row in fresh)])
        self._unnumbered = {fid for fid in self._unnumbered if fid in rows}
        for row in fresh:
            is_copy = row.window_id in taken
            if row.window_id == UNNUMBERED or is_copy:
                row = self._numbered(row, taken)
            taken.add(row.window_id)
            self._versions.meet(row, is_copy)
            rows[row.fid] = self._versions.marked(row)
        self._rows = dict(sorted(rows.items(), key=lambda item: item[1].window_id))
        self._fids = {row.window_id: fid for fid, row in self._rows.items()}

    def _took_in_place(self, unread: set[int], fresh: list[WindowRecord]) -> bool:
        """Whether the same windows have the same numbers: then one that is judged costs no more among thousands."""
        if len(fresh) != len(unread):
            return False
        if any(row.fid not in self._rows or self._rows[row.fid].window_id != row.window_id for row in fresh):
            return False
        self._unnumbered.difference_update(unread)
        self._rows.update((row.fid, self._versions.marked(row)) for row in fresh)
        return True

    def _numbered(self, row: WindowRecord, taken: set[int]) -> WindowRecord:
        """With a number that is written as soon as the window is inspected."""
        numbers = (self._given.get(row.fid), self._given.get(row.extent))
        number = next((number for number in numbers if number is not None and number not in taken), None)
        if number is None:
            self._last_number = number = self._last_number + 1
        self._given[row.fid] = self._given[row.extent] = number
        self._unnumbered.add(row.fid)
        return replace(row, window_id=number)
