"""The window layer as the desk sees it: its rows, kept up to date one by one, which are stale, and the selection.

A row is read when it changed and somebody asks. Its values are up to date while the window lies where it lay when they
were measured and the inputs are what they were then. Both come back by undo, and values come by other ways too (a
result is no step of undo), so what is known are fingerprints: of which place and inputs which values are.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import replace
from typing import Any, NamedTuple

from qgis.core import QgsMapLayer, QgsVectorLayer
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.grids import Extent
from ....toolkit import layers as layer_editing
from ....toolkit.desk.widgets import single_shot
from ....toolkit.table_fields import whole_number
from ....toolkit.translation import tr
from ...measure.window_records import WindowRecord
from ...tables import window_layer
from ...tables.window_layer import UNNUMBERED

_STALE = "seam_inspector/stale"  # custom property of the layer: numbers of the windows to be inspected again


class Version(NamedTuple):
    """What a window's values are of."""

    extent: Extent | None
    """Where it lay."""
    state: int | None
    """The number of the inputs' state; None is the one in which the layer was first seen."""


class WindowWatch(QObject):
    """Follows one layer at a time."""

    windowsChanged = pyqtSignal()
    """Once for all changes that come together."""
    selectionChanged = pyqtSignal()
    """Other windows are selected; never before the windows themselves are told."""
    replaced = pyqtSignal()
    """The layer has another data source."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._layer: QgsVectorLayer | None = None
        self._notifier = single_shot(self, self._notify)
        self._told: set[int] | None = set()  # the selection
        self._is_unmoved = False
        self._left: dict[str, tuple[dict[int, set[tuple[object, Version]]], int | None, int | None]] = {}
        """What is known, by id, of layers that were followed before, their first state and the last one."""
        self._forget()

    def _forget(self) -> None:
        self._rows: dict[int, WindowRecord] = {}  # by feature id, in the order of their numbers
        self._fids: dict[int, int] = {}  # by number
        self._unread: set[int] | None = None  # None: all of them
        self._unnumbered: set[int] = set()
        self._given: dict[int | Extent | None, int] = {}  # numbers of windows that have none, by feature id and place
        self._last_number = 0  # a number is not used again, or an old result would be taken for a new window's
        self._saved: dict[int, WindowRecord] = {}
        self._bereft: set[int] = set()  # numbers of windows that went, or whose fields did, and with them their values
        self.state: int | None = None
        """The number of the inputs' state."""
        self._first_state: int | None = None
        self._known: dict[int, set[tuple[object, Version]]] = {}  # fingerprints of values, by number
        self._marks = self._kept_marks()
        self._noted = self._marks  # as the layer's property is known to be

    @property
    def layer(self) -> QgsVectorLayer | None:
        """The layer, while it is there."""
        return self._layer

    def watch(self, layer: QgsMapLayer | None) -> None:
        """Follow another layer; none when it can't hold windows."""
        for signal, slot in self._signals():
            with suppress(TypeError, RuntimeError):  # the layer is gone already
                signal.disconnect(slot)
        if self._layer is not None and not sip.isdeleted(self._layer):
            self._left.pop(self._layer.id(), None)
            if self._kept_marks() == self._noted:  # not somebody else's
                self._left[self._layer.id()] = self._known, self._first_state, self.state
        self._layer = layer if window_layer.holds_windows(layer) else None
        had_windows = bool(self._rows)
        if self._told:
            self._told = None  # of equal ids others are meant now
        self._forget()
        if self._layer is not None and self._layer.id() in self._left:
            self._known, self._first_state, self.state = self._left[self._layer.id()]
        for signal, slot in self._signals():
            signal.connect(slot)
        if had_windows or self._told is None or self._by_fid():
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
        self.save_stale()
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

    def prepare(self, fids: Iterable[int], levels: int, besides: Iterable[str] = ()) -> list[int]:
        """See to it that the layer can be edited and has all fields, and these windows their numbers in it.

        ``besides``: fields of what operators say that are to be written.

        Returns their feature ids, some of which may be new ones. Raises WindowLayerError when it can't be edited.
        """
        assert self._layer is not None
        layer_editing.start_editing(self._layer)
        self._by_fid()
        asked, besides = list(fids), tuple(besides)
        is_numbered = self._unnumbered.isdisjoint(asked)
        if is_numbered and not window_layer.lacks_fields(self._layer, levels, besides):
            return asked
        with layer_editing.edit_step(self._layer, tr("Add fields")):
            selected = self._layer.selectedFeatureIds()
            renewed = window_layer.complete_fields(self._layer, levels, besides)
            if renewed:
                self._layer.selectByIds([renewed.get(fid, fid) for fid in selected])
            now = [renewed.get(fid, fid) for fid in asked]
            rows = self._by_fid()
            lacking = {fid: rows[fid].window_id for fid in now if fid in self._unnumbered and fid in rows}
            window_layer.write_numbers(self._layer, lacking)
        return now

    def take_bereft(self) -> list[WindowRecord]:
        """Windows that undo or redo brought back without the values that were written since they first came."""
        back = [row for number in self._bereft if (row := self.numbered(number)) is not None]
        self._bereft.difference_update(row.window_id for row in back)
        return [row for row in back if not row.verdict]

    def _by_fid(self) -> dict[int, WindowRecord]:
        """Rows by feature id, as they are now."""
        if self._layer is not None and (self._unread is None or self._unread):
            self._read(self._layer)
        return self._rows

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
            if row.window_id not in self._known:  # what it has when it is first seen is trusted; a copy's is not
                is_trusted = row.verdict and not is_copy and row.window_id not in self._marks
                self._known[row.window_id] = {(row.measured, Version(row.extent, None))} if is_trusted else set()
            rows[row.fid] = self._marked(row)
        self._rows = dict(sorted(rows.items(), key=lambda item: item[1].window_id))
        self._fids = {row.window_id: fid for fid, row in self._rows.items()}

    def _took_in_place(self, unread: set[int], fresh: list[WindowRecord]) -> bool:
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

    # Stale windows: those whose values are not of this version, of place and inputs

    def set_state(self, state: int | None) -> None:
        """The inputs are these now; while it is not known which they are, as before."""
        if state is None or state == self.state:
            return
        if self._first_state is None:
            self._first_state = state
        self.state = state
        self._mark(self._fids)

    def note_measured(self, versions: Mapping[int, Version]) -> None:
        """The values that these windows have now, by number, are of these versions."""
        for number, version in versions.items():
            if (row := self.numbered(number)) is not None:
                self._known[number].add((row.measured, version))
        self._mark(versions)

    def mark_stale(self, numbers: Iterable[int]) -> None:
        """The values that these windows have are outdated, whatever the present inputs are."""
        outdated = [number for number in numbers if self.numbered(number) is not None]
        self._known.update((number, set()) for number in outdated)
        self._mark(outdated)

    def save_stale(self) -> None:
        """The marks are kept with the layer in the project, those included of windows that a filter hides."""
        if self._layer is not None:
            stale = {row.window_id for row in self.rows() if row.stale}
            self._noted = stale.union(self._marks.difference(self._known))
            self._layer.setCustomProperty(_STALE, [str(number) for number in sorted(self._noted)])

    def _kept_marks(self) -> set[int]:
        """Those that the layer has in the project; of what others wrote there, none."""
        stale = self._layer.customProperty(_STALE, []) if self._layer is not None else []
        numbers = map(whole_number, stale if isinstance(stale, list) else [stale])
        return {number for number in numbers if number is not None}

    def _mark(self, numbers: Iterable[int]) -> None:
        """Those of them that are there."""
        rows = [self._rows[self._fids[number]] for number in numbers if number in self._fids]
        changed = {row.fid: marked for row in rows if (marked := self._marked(row)) is not row}
        self._rows.update(changed)
        if changed:
            self._notifier.start()

    def _marked(self, row: WindowRecord) -> WindowRecord:
        """With the mark of whether it is stale; the row itself where it has the right one."""
        stale = bool(row.verdict) and not self._is_up_to_date(row)
        return row if row.stale == stale else replace(row, stale=stale)

    def _is_up_to_date(self, row: WindowRecord) -> bool:
        values, known = row.measured, self._known[row.window_id]
        is_first = self.state == self._first_state and (values, Version(row.extent, None)) in known
        return is_first or (values, Version(row.extent, self.state)) in known

    # Selection

    def selected(self) -> list[int]:
        """Feature ids of the selected windows."""
        rows = self._by_fid()
        return sorted(fid for fid in self._layer.selectedFeatureIds() if fid in rows) if self._layer else []

    def select(self, fids: Iterable[int]) -> None:
        """Select these windows and no others, on the map and in the table alike."""
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
            (layer.updatedFields, self._fields_changed),
            (layer.subsetStringChanged, self._all_changed),
            (layer.beforeCommitChanges, self._about_to_be_saved),
            (layer.afterCommitChanges, self._was_saved),
            (layer.afterRollBack, self._was_rolled_back),
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
            self._bereft.add(row.window_id)
        self._notifier.start()

    def _fields_changed(self) -> None:
        self._bereft.update(self._fids)
        self._all_changed()

    def _was_rolled_back(self) -> None:
        if self._layer is not None:
            layer_editing.forget_quiet_changes(self._layer)
        self._all_changed()

    def _all_changed(self, *_: object) -> None:
        self._unread = None
        self._notifier.start()

    def _about_to_be_saved(self, *_: object) -> None:
        self._saved = {row.window_id: row for row in self.rows()}

    def _was_saved(self) -> None:
        """A format may round numbers and cut texts, and the ids are others now; the windows are what they were."""
        if self._layer is not None:
            layer_editing.forget_quiet_changes(self._layer)
        self._all_changed()
        for row in self.rows():
            old, known = self._saved.get(row.window_id, row), self._known[row.window_id]
            versions = [version for values, version in known if values == old.measured]
            known.update(
                (row.measured, version._replace(extent=row.extent) if version.extent == old.extent else version)
                for version in versions
            )
        self._mark(self._fids)

    def _source_changed(self) -> None:
        if not self._is_unmoved:
            self.replaced.emit()

    def _selection_changed(self, *_: object) -> None:
        if not self._notifier.isActive():  # else the windows that changed are told first
            self._tell_selection()

    def _notify(self) -> None:
        self.windowsChanged.emit()
        self._tell_selection()  # saving gives features other ids, and undo takes them away

    def _tell_selection(self) -> None:
        selected = set(self.selected())
        if selected != self._told:
            self._told = selected
            self.selectionChanged.emit()
