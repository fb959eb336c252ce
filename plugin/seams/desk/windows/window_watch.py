"""The window layer as the desk sees it: its rows, kept up to date one by one, which are stale, and the selection."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from typing import Any

from qgis.core import QgsMapLayer, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....toolkit import layer_editing
from ....toolkit.desk.widgets import single_shot
from ....toolkit.translation import tr
from ...measure.window_records import WindowRecord
from ...tables import window_layer
from .window_rows import LayerRows
from .window_versions import Version, WindowVersions

_STALE = "seam_inspector/stale"  # custom property of the layer: numbers of the windows to be inspected again


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
        self._forget()

    def _forget(self) -> None:
        stale = self._layer.customProperty(_STALE, []) or [] if self._layer is not None else []
        self._versions = WindowVersions(int(number) for number in stale if str(number).lstrip("-").isdigit())
        self._rows = LayerRows(self._layer, self._versions)
        self._saved: dict[int, WindowRecord] = {}
        self._bereft: set[int] = set()  # numbers of windows that went, or whose fields did, and with them their values

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
        had_windows = bool(self._rows)
        self._told = None if self._told else set()  # of equal ids others are meant now
        self._forget()
        for signal, slot in self._signals():
            signal.connect(slot)
        if had_windows or self._told is None or self._rows.by_fid():
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
        return list(self._rows.by_fid().values())

    def row(self, fid: int) -> WindowRecord | None:
        """One window."""
        return self._rows.by_fid().get(fid)

    def fid(self, window_id: int) -> int | None:
        """The feature id of a window."""
        row = self._rows.by_number(window_id)
        return row.fid if row is not None else None

    def numbered(self, window_id: int) -> WindowRecord | None:
        """The window with a number."""
        return self._rows.by_number(window_id)

    @property
    def next_number(self) -> int:
        """The first of the numbers for new windows."""
        return self._rows.next_number

    def prepare(self, fids: Iterable[int], levels: int, besides: Iterable[str] = ()) -> list[int]:
        """See to it that the layer can be edited and has all fields, and these windows their numbers in it.

        ``besides``: fields of what operators say that are to be written.

        Returns their feature ids, some of which may be new ones. Raises WindowLayerError when it can't be edited.
        """
        assert self._layer is not None
        layer_editing.start_editing(self._layer)
        self._rows.by_fid()
        asked, besides = list(fids), tuple(besides)
        if not window_layer.lacks_fields(self._layer, levels, besides) and not self._rows.lack_numbers(asked):
            return asked
        with layer_editing.edit_step(self._layer, tr("Add fields")):
            selected = self._layer.selectedFeatureIds()
            renewed = window_layer.complete_fields(self._layer, levels, besides)
            if renewed:
                self._layer.selectByIds([renewed.get(fid, fid) for fid in selected])
            now = [renewed.get(fid, fid) for fid in asked]
            window_layer.write_numbers(self._layer, self._rows.numbers_to_write(now))
        return now

    def take_bereft(self) -> list[WindowRecord]:
        """Windows that undo or redo brought back without the values that were written since they first came."""
        back = [row for number in self._bereft if (row := self._rows.by_number(number)) is not None]
        self._bereft.difference_update(row.window_id for row in back)
        return [row for row in back if not row.verdict]

    # Stale windows: those whose values are not of this version, of place and inputs

    @property
    def state(self) -> int | None:
        """The number of the inputs' state."""
        return self._versions.state

    def set_state(self, state: int | None) -> None:
        """The inputs are these now; while it is not known which they are, as before."""
        if self._versions.set_state(state):
            self._mark(self._rows.known_numbers)

    def note_measured(self, versions: Mapping[int, Version]) -> None:
        """The values that these windows have now, by number, are of these versions."""
        for number, version in versions.items():
            row = self._rows.by_number(number)
            if row is not None:
                self._versions.note(row, version)
        self._mark(versions)

    def mark_stale(self, numbers: Iterable[int]) -> None:
        """The values that these windows have are outdated, whatever the present inputs are."""
        outdated = [number for number in numbers if self._rows.by_number(number) is not None]
        self._versions.outdate(outdated)
        self._mark(outdated)

    def save_stale(self) -> None:
        """The marks are kept with the layer in the project."""
        if self._layer is not None:
            stale = self._versions.stale_numbers(self.rows())
            self._layer.setCustomProperty(_STALE, [str(number) for number in sorted(stale)])

    def _mark(self, numbers: Iterable[int]) -> None:
        """Those of them that are there."""
        if self._rows.mark(numbers):
            self._notifier.start()

    # Selection

    def selected(self) -> list[int]:
        """Feature ids of the selected windows."""
        rows = self._rows.by_fid()
        return sorted(fid for fid in self._layer.selectedFeatureIds() if fid in rows) if self._layer else []

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
        self._rows.change(fid)
        self._notifier.start()

    def _feature_deleted(self, fid: int) -> None:
        number = self._rows.remove(fid)
        if number is not None:
            self._bereft.add(number)
        self._notifier.start()

    def _fields_changed(self) -> None:
        self._bereft.update(self._rows.known_numbers)
        self._all_changed()

    def _was_rolled_back(self) -> None:
        if self._layer is not None:
            layer_editing.forget_quiet_changes(self._layer)
        self._all_changed()

    def _all_changed(self, *_: object) -> None:
        self._rows.change_all()
        self._notifier.start()

    def _about_to_be_saved(self, *_: object) -> None:
        self._saved = {row.window_id: row for row in self.rows()}

    def _was_saved(self) -> None:
        """A format may round numbers and cut texts, and the ids are others now; the windows are what they were."""
        if self._layer is not None:
            layer_editing.forget_quiet_changes(self._layer)
        self._all_changed()
        self._versions.follow_saved(self.rows(), self._saved)
        self._mark(self._rows.known_numbers)

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
