"""The window layer as the desk sees it: its rows, kept up to date one by one, which are stale, and the selection."""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import replace
from typing import Any

from qgis.core import QgsMapLayer, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, QTimer, pyqtSignal

from ....imagery.grids import Extent
from ....toolkit import layer_editing
from ...measure.window_records import WindowRecord
from ...tables import window_layer
from ...tables.window_layer import UNNUMBERED

_STALE = "seam_inspector/stale"  # custom property of the layer: numbers of the windows to be inspected again
_SHORTEST_TEXT = 100  # letters; some formats cut longer ones

Place = tuple["Extent | None", "int | None"]
"""Where a window lay and the number of the inputs' state; None is the state in which the layer was first seen."""


class WindowWatch(QObject):
    """Follows one layer at a time. A change marks rows as unread; they are read when somebody asks."""

    windowsChanged = pyqtSignal()
    """Once for all changes that come together."""
    selectionChanged = pyqtSignal()
    replaced = pyqtSignal()
    """The layer has another data source."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._layer: QgsVectorLayer | None = None
        self._notifier = QTimer(self)
        self._notifier.setSingleShot(True)
        self._notifier.timeout.connect(self._notify)
        self._forget()

    def _forget(self) -> None:
        self._rows: dict[int, WindowRecord] = {}
        self._fids: dict[int, int] = {}
        self._unread: set[int] | None = None  # None: all of them
        self._measured: dict[int, set[tuple[object, Place]]] = {}  # what was found in a window, and for which place
        self._marks: set[int] = set()  # numbers of those that were stale when the project was saved
        self._state: int | None = None
        self._first_state: int | None = None
        self._unnumbered: set[int] = set()
        self._given: dict[int | Extent | None, int] = {}  # numbers of windows that have none, by feature id and place
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
            self._marks = {int(number) for number in stale if str(number).lstrip("-").isdigit()}
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

    def rows(self) -> list[WindowRecord]:
        """All windows by their number."""
        self._read()
        return list(self._rows.values())

    def row(self, fid: int) -> WindowRecord | None:
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
        layer_editing.start_editing(self._layer)
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
        if self._layer is None or (unread is not None and not unread):
            return
        rows = {} if unread is None else {fid: row for fid, row in self._rows.items() if fid not in unread}
        fresh = window_layer.read_layer(self._layer, unread)
        fresh.sort(key=lambda row: (row.fid < 0, abs(row.fid)))  # of two with one number the older one keeps it
        taken = {row.window_id for row in rows.values()}
        self._last_number = max([self._last_number, *(row.window_id for row in fresh)])
        self._unnumbered = {fid for fid in self._unnumbered if fid in rows}
        for row in fresh:
            is_copy = row.window_id in taken
            if row.window_id == UNNUMBERED or is_copy:
                row = self._numbered(row, taken)
            taken.add(row.window_id)
            if row.window_id not in self._measured:
                is_trusted = bool(row.verdict) and not is_copy and row.window_id not in self._marks
                self._measured[row.window_id] = {(_finding(row), (row.extent, None))} if is_trusted else set()
            rows[row.fid] = self._marked(row)
        self._rows = dict(sorted(rows.items(), key=lambda item: item[1].window_id))
        self._fids = {row.window_id: fid for fid, row in self._rows.items()}

    def _numbered(self, row: WindowRecord, taken: set[int]) -> WindowRecord:
        """With a number that is written as soon as the window is inspected."""
        numbers = (self._given.get(row.fid), self._given.get(row.extent))
        number = next((number for number in numbers if number is not None and number not in taken), None)
        if number is None:
            self._last_number = number = self._last_number + 1
        self._given[row.fid] = self._given[row.extent] = number
        self._unnumbered.add(row.fid)
        return replace(row, window_id=number)

    # Stale windows: those whose values were not found at this place and with these inputs

    @property
    def state(self) -> int | None:
        """The number of the inputs' state."""
        return self._state

    def set_state(self, state: int | None) -> None:
        """The inputs are these now; while it is not known which they are, as before."""
        if state is None or state == self._state:
            return
        if self._state is None:
            self._first_state = state
        self._state = state
        before, self._rows = self._rows, {fid: self._marked(row) for fid, row in self._rows.items()}
        if self._rows != before:
            self._notifier.start()

    def note_measured(self, places: Mapping[int, Place]) -> None:
        """The values of these windows, by number, were found there."""
        self._read()
        for number, place in places.items():
            if number in self._fids:
                row = self._rows[self._fids[number]]
                self._measured[number].add((_finding(row), place))
                self._rows[row.fid] = self._marked(row)
        self._notifier.start()

    def save_stale(self) -> None:
        """The marks are kept with the layer in the project."""
        if self._layer is not None:
            self._read()
            unseen = self._marks.difference(self._measured)
            stale = unseen.union(row.window_id for row in self._rows.values() if row.stale)
            self._layer.setCustomProperty(_STALE, [str(number) for number in sorted(stale)])

    def _marked(self, row: WindowRecord) -> WindowRecord:
        stale = bool(row.verdict) and not self._is_up_to_date(row)
        return row if row.stale == stale else replace(row, stale=stale)

    def _is_up_to_date(self, row: WindowRecord) -> bool:
        known, finding = self._measured[row.window_id], _finding(row)
        is_first = self._state == self._first_state and (finding, (row.extent, None)) in known
        return is_first or (finding, (row.extent, self._state)) in known

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
            (layer.geometryChanged, self._feature_changed),
            (layer.updatedFields, self._all_changed),
            (layer.subsetStringChanged, self._all_changed),
            (layer.afterCommitChanges, self._all_changed),
            (layer.afterRollBack, self._all_changed),
            (layer.dataChanged, self._all_changed),
            (layer.dataSourceChanged, self.replaced),
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


def _finding(row: WindowRecord) -> object:
    """What was found in a window, as far as every format keeps it."""
    ratios = [f"{ratio:.9g}" for ratio in (*row.ratios, row.background_ratio, row.composite_ratio) if ratio is not None]
    return row.verdict, row.cause, row.reason[:_SHORTEST_TEXT], row.sources, tuple(ratios)
