"""The window layer as the desk sees it: its rows, kept up to date one by one, which are stale, and the selection."""
from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import replace
from typing import Any

from qgis.core import QgsMapLayer, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, QTimer, pyqtSignal

from ..adapters import window_layer
from ..adapters.window_layer import UNNUMBERED, WindowRow
from ..core.windows import Extent

_STALE = "seam_inspector/stale"  # custom property of the layer: numbers of the windows to be inspected again


class WindowWatch(QObject):
    """Follows one layer at a time. A change marks rows as unread; they are read when somebody asks."""

    windowsChanged = pyqtSignal()
    """Once for all changes that come together."""
    selectionChanged = pyqtSignal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._layer: QgsVectorLayer | None = None
        self._notifier = QTimer(self)
        self._notifier.setSingleShot(True)
        self._notifier.timeout.connect(self._notify)
        self._forget()

    def _forget(self) -> None:
        self._rows: dict[int, WindowRow] = {}
        self._fids: dict[int, int] = {}
        self._unread: set[int] | None = None  # None: all of them
        self._moved: set[int] = set()
        self._origins: dict[int, Extent] = {}  # where a window lay before it became stale by moving
        self._stale: set[int] = set()
        self._unnumbered: set[int] = set()
        self._given: dict[int | Extent, int] = {}  # numbers of windows that have none, by feature id and by place
        self._last_number = 0  # a number is not used again, or an old result would be taken for a new window's
        self._told: set[int] = set()

    @property
    def layer(self) -> QgsVectorLayer | None:
        """The layer, while it is there."""
        return self._layer

    def watch(self, layer: QgsMapLayer | None) -> None:
        """Follow another layer; none when it can't hold windows."""
        for signal, slot in self._signals():
            with suppress(TypeError, RuntimeError):  # the layer is gone already
                signal.disconnect(slot)
        self._layer = layer if window_layer.holds_windows(layer) else None
        self._forget()
        if self._layer is not None:
            stale = self._layer.customProperty(_STALE, []) or []
            self._stale = {int(number) for number in stale if str(number).lstrip("-").isdigit()}
        for signal, slot in self._signals():
            signal.connect(slot)
        self._told = set(self.selected())
        self._notifier.start()
        self.selectionChanged.emit()

    def close(self) -> None:
        """Let go of the layer and tell nothing more."""
        self.blockSignals(True)
        self.save_stale()
        self.watch(None)
        self._notifier.stop()

    # Rows

    def rows(self) -> list[WindowRow]:
        """All windows by their number."""
        self._read()
        return list(self._rows.values())

    def row(self, fid: int) -> WindowRow | None:
        """One window."""
        self._read()
        return self._rows.get(fid)

    def fid(self, window_id: int) -> int | None:
        """The feature id of a window."""
        self._read()
        return self._fids.get(window_id)

    @property
    def next_number(self) -> int:
        """The first of the numbers for new windows."""
        self._read()
        return self._last_number + 1

    def prepare(self, fids: Iterable[int], levels: int) -> list[int]:
        """See to it that the layer can be edited and has all fields, and these windows their numbers in it.

        Returns their feature ids, some of which may be new ones. Raises WindowLayerError when it can't be edited.
        """
        assert self._layer is not None
        window_layer.start_editing(self._layer)
        selected = self._layer.selectedFeatureIds()
        renewed = window_layer.complete_fields(self._layer, levels)
        if renewed:
            self._layer.selectByIds([renewed.get(fid, fid) for fid in selected])
        self._read()
        now = [renewed.get(fid, fid) for fid in fids]
        numbers = {fid: self._rows[fid].window_id for fid in now if fid in self._unnumbered and fid in self._rows}
        if numbers:
            window_layer.write_numbers(self._layer, numbers)
        return now

    def _read(self) -> None:
        unread, self._unread = self._unread, set()
        moved, self._moved = self._moved, set()
        if self._layer is None or (unread is not None and not unread):
            return
        before = self._rows
        rows = {} if unread is None else {fid: row for fid, row in before.items() if fid not in unread}
        fresh = window_layer.read_rows(self._layer, unread)
        fresh.sort(key=lambda row: (row.fid < 0, abs(row.fid)))  # of two with one number the older one keeps it
        taken = {row.window_id for row in rows.values()}
        self._last_number = max([self._last_number, *(row.window_id for row in fresh)])
        self._unnumbered = {fid for fid in self._unnumbered if fid in rows}
        for row in fresh:
            if row.window_id == UNNUMBERED or row.window_id in taken:
                row = self._numbered(row, taken)
            taken.add(row.window_id)
            if row.fid in moved and row.verdict:
                self._follow_move(row, before.get(row.fid))
            rows[row.fid] = self._marked(row)
        self._rows = dict(sorted(rows.items(), key=lambda item: item[1].window_id))
        self._fids = {row.window_id: fid for fid, row in self._rows.items()}

    def _numbered(self, row: WindowRow, taken: set[int]) -> WindowRow:
        """With a number that is written as soon as the window is inspected."""
        numbers = (self._given.get(row.fid), self._given.get(row.extent))
        number = next((number for number in numbers if number is not None and number not in taken), None)
        if number is None:
            self._last_number = number = self._last_number + 1
        self._given[row.fid] = self._given[row.extent] = number
        self._unnumbered.add(row.fid)
        return replace(row, window_id=number)

    # Stale windows

    def mark_stale(self, numbers: Iterable[int]) -> None:
        """These windows are to be inspected again."""
        self._set_stale(self._stale.union(numbers))

    def mark_inspected(self, numbers: Iterable[int]) -> None:
        """These windows are up to date."""
        self._set_stale(self._stale.difference(numbers))

    def save_stale(self) -> None:
        """The marks are kept with the layer in the project."""
        if self._layer is not None:
            self._read()
            self._layer.setCustomProperty(_STALE, [str(number) for number in sorted(self._stale)])

    def _set_stale(self, numbers: set[int]) -> None:
        if numbers != self._stale:
            self._stale = numbers
            self._origins.clear()
            self._rows = {fid: self._marked(row) for fid, row in self._rows.items()}
            self._notifier.start()

    def _marked(self, row: WindowRow) -> WindowRow:
        stale = bool(row.verdict) and row.window_id in self._stale
        return row if row.stale == stale else replace(row, stale=stale)

    def _follow_move(self, row: WindowRow, before: WindowRow | None) -> None:
        """A window that was moved is stale, until it is moved back."""
        number = row.window_id
        if number not in self._stale:
            if before is None or before.extent != row.extent:
                self._stale.add(number)
            if before is not None:
                self._origins[number] = before.extent
        elif self._origins.get(number) == row.extent:
            self._stale.discard(number)

    # Selection

    def selected(self) -> list[int]:
        """Feature ids of the selected windows."""
        self._read()
        return sorted(fid for fid in self._layer.selectedFeatureIds() if fid in self._rows) if self._layer else []

    def select(self, fids: Iterable[int]) -> None:
        """Select these windows and no others."""
        chosen = set(fids)
        if self._layer is not None and chosen != set(self._layer.selectedFeatureIds()):
            self._layer.selectByIds(list(chosen))

    # What the layer tells

    def _signals(self) -> list[tuple[Any, Any]]:
        layer = self._layer
        if layer is None:
            return []
        return [
            (layer.featureAdded, self._feature_changed),
            (layer.featureDeleted, self._feature_deleted),
            (layer.attributeValueChanged, self._feature_changed),
            (layer.geometryChanged, self._geometry_changed),
            (layer.updatedFields, self._all_changed),
            (layer.subsetStringChanged, self._all_changed),
            (layer.afterCommitChanges, self._all_changed),
            (layer.afterRollBack, self._all_changed),
            (layer.dataChanged, self._all_changed),
            (layer.selectionChanged, self._selection_changed),
        ]

    def _feature_changed(self, fid: int, *_: object) -> None:
        if self._unread is not None:
            self._unread.add(fid)
        self._notifier.start()

    def _feature_deleted(self, fid: int) -> None:
        row = self._rows.pop(fid, None)
        if row is not None and self._fids.get(row.window_id) == fid:
            del self._fids[row.window_id]
        if self._unread is not None:
            self._unread.discard(fid)
        self._notifier.start()

    def _geometry_changed(self, fid: int, *_: object) -> None:
        self._moved.add(fid)
        self._feature_changed(fid)

    def _all_changed(self, *_: object) -> None:
        self._unread = None
        self._notifier.start()

    def _selection_changed(self, *_: object) -> None:
        self._told = set(self.selected())
        self.selectionChanged.emit()

    def _notify(self) -> None:
        selected = set(self.selected())
        self.windowsChanged.emit()
        if selected != self._told:  # saving gives features other ids, and undo takes them away
            self._told = selected
            self.selectionChanged.emit()
