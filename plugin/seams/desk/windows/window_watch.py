"""The window layer as the desk sees it: its rows, kept up to date one by one, which are stale, and the selection.

A row is read when it changed and somebody asks. It is stale where the fingerprint that the file has of its values is
not that of its place, the inputs and the values themselves: so it is no more once a change is taken back.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from qgis.core import QgsMapLayer, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import WindowLayerError
from ....imagery.grids import Extent
from ....toolkit.desk.widgets import single_shot
from ....toolkit.layers import layer_path
from ....toolkit.translation import tr
from ...measure import messages as seams_messages
from ...measure.window_records import WindowRecord
from ...tables import window_file, window_layer
from ...tables.window_layer import UNNUMBERED, WindowChange
from .. import messages


class WindowWatch(QObject):
    """Follows one layer at a time."""

    windowsChanged = pyqtSignal()  # once for all changes that come together
    selectionChanged = pyqtSignal()  # other windows are selected; never before the windows themselves are told
    replaced = pyqtSignal()  # the layer has another data source

    fieldMissed = pyqtSignal(object)  # the Message on a field of the windows file that was removed or renamed
    saved = pyqtSignal()  # all edits are in the file, as when QGIS's tools are taken up
    rolledBack = pyqtSignal()  # edits that were made with QGIS's tools are no more, and the desk's among them

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.layer: QgsVectorLayer | None = None
        """The layer, while it is there."""
        self._notifier = single_shot(self, self._notify)
        self._last_selected: set[int] | None = set()  # the selection
        self._is_unmoved = False
        self.state: str | None = None  # the fingerprint of the inputs
        self._forget()

    def _forget(self) -> None:
        self._rows: dict[int, WindowRecord] = {}  # by feature id, in the order of their numbers
        self._fids: dict[int, int] = {}  # by number
        self._unread: set[int] | None = None  # None: all of them
        self._unnumbered: set[int] = set()
        self._missing: list[str] = []  # fields that were removed or renamed
        self._given: dict[int | Extent | None, int] = {}  # numbers of windows that have none, by feature id and place
        is_ours = self.layer is not None and window_layer.is_in_file(self.layer)
        self.path = Path(layer_path(self.layer)) if is_ours else None
        """The windows file; None for a layer of another format, which is only read."""
        self.fingerprints = window_file.fingerprints(self.path) if self.path is not None else {}
        """What the values are of that windows have in the file, by number; of those that were removed, too."""
        self._last_number = max(self.fingerprints, default=0)  # a number is not used again

    def watch(self, layer: QgsMapLayer | None) -> None:
        """Follow another layer; none when it can't hold windows."""
        for signal, slot in self._signals():
            with suppress(TypeError, RuntimeError):  # the layer is gone already
                signal.disconnect(slot)
        self.layer = layer if window_layer.holds_windows(layer) else None
        had_windows = bool(self._rows)
        if self._last_selected:
            self._last_selected = None  # of equal ids others are meant now
        self._forget()
        for signal, slot in self._signals():
            signal.connect(slot)
        if had_windows or self._last_selected is None or self.layer is not None:
            self._notifier.start()

    @contextmanager
    def unmoved(self) -> Iterator[None]:
        """The layer's data source becomes another one with the same windows: that is not told as ``replaced``."""
        self._is_unmoved = True
        try:
            yield
        finally:
            self._is_unmoved = False

    def close(self) -> None:
        """Let go of the layer and tell nothing more."""
        self.blockSignals(True)
        self.watch(None)
        self._notifier.stop()

    # Rows

    def rows(self) -> list[WindowRecord]:
        """All windows by their number."""
        return list(self._by_fid().values())

    def row(self, fid: int) -> WindowRecord | None:
        """One window."""
        return self._by_fid().get(fid)

    def numbered(self, window_id: int) -> WindowRecord | None:
        """The window with a number, which it keeps when feature ids change."""
        rows = self._by_fid()
        return rows[self._fids[window_id]] if window_id in self._fids else None

    @property
    def next_number(self) -> int:
        """The first of the numbers for new windows."""
        self._by_fid()
        return self._last_number + 1

    def writable(self) -> QgsVectorLayer | None:
        """The layer, to be written to. Raises WindowLayerError for one that is only read."""
        if self.layer is not None and self.path is None:
            raise WindowLayerError(messages.WINDOWS_TO_COPY(name=self.layer.name()))
        return self.layer

    def prepare(self, fids: Iterable[int], levels: int) -> None:
        """See to it that the layer has the fields of so many levels, and these windows their numbers in it.

        Raises WindowLayerError when it can't be written.
        """
        layer, rows = self.writable(), self._by_fid()
        assert layer is not None
        window_layer.add_levels(layer, levels)
        lacking = {fid: {"window_id": rows[fid].window_id} for fid in self._unnumbered.intersection(fids)}
        if lacking:
            window_layer.write(layer, WindowChange(lacking), tr("Number windows"))

    def _by_fid(self) -> dict[int, WindowRecord]:
        """Rows by feature id, as they are now."""
        if self.layer is not None and (self._unread is None or self._unread):
            self._read(self.layer)
        return self._rows

    def _read(self, layer: QgsVectorLayer) -> None:
        """Windows that changed."""
        unread, self._unread = self._unread, set()
        fresh = window_layer.read_layer(layer, unread)
        if unread is not None and self._updated_in_place(unread, fresh):
            return
        rows = {} if unread is None else {fid: row for fid, row in self._rows.items() if fid not in unread}
        fresh.sort(key=lambda row: (row.fid < 0, abs(row.fid)))  # of two with one number the older one keeps it
        taken = {row.window_id for row in rows.values()}
        self._last_number = max([self._last_number, *(row.window_id for row in fresh)])
        self._unnumbered = {fid for fid in self._unnumbered if fid in rows}
        for row in fresh:
            if row.window_id == UNNUMBERED or row.window_id in taken:
                row = self._numbered(row, taken)
            taken.add(row.window_id)
            rows[row.fid] = self._marked(row)
        self._rows = dict(sorted(rows.items(), key=lambda item: item[1].window_id))
        self._fids = {row.window_id: fid for fid, row in self._rows.items()}

    def _updated_in_place(self, unread: set[int], fresh: list[WindowRecord]) -> bool:
        """Whether the same windows have the same numbers: then one that is judged costs no more among thousands."""
        if len(fresh) != len(unread):
            return False
        if any(row.fid not in self._rows or self._rows[row.fid].window_id != row.window_id for row in fresh):
            return False
        self._unnumbered.difference_update(unread)
        self._rows.update((row.fid, self._marked(row)) for row in fresh)
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

    # Stale windows: those whose values are of another place, or of other inputs

    def set_state(self, state: str | None) -> None:
        """The fingerprint of the inputs; while it is not known which they are, as before."""
        if state is not None and state != self.state:
            self.state = state
            self._mark(self._fids)

    def note_fingerprints(self, marks: Mapping[int, str]) -> None:
        """What the values are of that these windows have in the file, by number."""
        self.fingerprints.update(marks)
        self._by_fid()
        self._mark(marks)

    def _mark(self, numbers: Iterable[int]) -> None:
        """Windows of them that are there."""
        rows = [self._rows[self._fids[number]] for number in numbers if number in self._fids]
        changed = {row.fid: marked for row in rows if (marked := self._marked(row)) is not row}
        self._rows.update(changed)
        if changed:
            self._notifier.start()

    def _marked(self, row: WindowRecord) -> WindowRecord:
        """With the mark of whether it is stale; the row itself where it has the right one."""
        stale = bool(row.verdict) and self.state is not None and self.path is not None
        if stale:
            assert self.state is not None
            stale = self.fingerprints.get(row.window_id) != window_file.fingerprint(row, self.state)
        return row if row.stale == stale else replace(row, stale=stale)

    # Selection

    def selected(self) -> list[int]:
        """Feature ids of the selected windows."""
        rows = self._by_fid()
        return sorted(fid for fid in self.layer.selectedFeatureIds() if fid in rows) if self.layer else []

    def select(self, fids: Iterable[int]) -> None:
        """Select these windows and no others, on the map and in the table alike."""
        chosen = set(fids)
        if self.layer is not None and chosen != set(self.layer.selectedFeatureIds()):
            self.layer.selectByIds(list(chosen))

    # What the layer tells

    def _signals(self) -> list[tuple[Any, Any]]:
        layer = self.layer
        if layer is None:
            return []
        return [
            (layer.featureAdded, self._feature_changed),
            (layer.featureDeleted, self._feature_deleted),
            (layer.attributeValueChanged, self._feature_changed),
            (layer.geometryChanged, self._feature_changed),
            (layer.updatedFields, self._all_changed),
            (layer.subsetStringChanged, self._all_changed),
            (layer.editingStarted, self.saved),
            (layer.afterCommitChanges, self._all_changed), (layer.afterCommitChanges, self.saved),
            (layer.afterRollBack, self._all_changed), (layer.afterRollBack, self.rolledBack),
            (layer.dataChanged, self._all_changed),
            (layer.dataSourceChanged, self._source_changed),
            (layer.selectionChanged, self._selection_changed),
        ]

    def _feature_changed(self, fid: int, *_: object) -> None:
        if self._unread is not None:
            self._unread.add(fid)
        self._notifier.start()

    def _feature_deleted(self, fid: int) -> None:
        row = self._rows.pop(fid, None)
        if self._unread is not None:
            self._unread.discard(fid)
        if row is not None and self._fids.get(row.window_id) == fid:
            del self._fids[row.window_id]
        self._notifier.start()

    def _all_changed(self, *_: object) -> None:
        self._unread = None
        self._notifier.start()

    def _tell_missing(self) -> None:
        if self.layer is not None and self.path is not None:
            there = self.layer.fields().names()
            missing = [name for name in window_file.window_fields(0).names() if name not in there]
            if missing and missing != self._missing:
                self.fieldMissed.emit(seams_messages.WINDOWS_WITHOUT_FIELD(field=missing[0]))
            self._missing = missing

    def _source_changed(self) -> None:
        if self._is_unmoved:
            self.path = Path(layer_path(self.layer))
        else:
            self.replaced.emit()

    def _selection_changed(self, *_: object) -> None:
        if not self._notifier.isActive():  # else the windows that changed are told first
            self._tell_selection()

    def _notify(self) -> None:
        self.windowsChanged.emit()
        self._tell_missing()
        self._tell_selection()  # saving gives features other ids, and undo takes them away

    def _tell_selection(self) -> None:
        selected = set(self.selected())
        if selected != self._last_selected:
            self._last_selected = selected
            self.selectionChanged.emit()
