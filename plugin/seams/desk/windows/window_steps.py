"""What the operator did to the windows, step by step: each is in the file at once, and can be undone and done again.

Steps know windows by their numbers, since feature ids change where somebody edits the layer with QGIS's tools. What is
gone meanwhile is left out.
"""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Callable, Union

from qgis.core import QgsFeature, QgsFeatureRequest, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import SeamInspectorError
from ....toolkit.desk.widgets import QUndoCommand, QUndoStack
from ....toolkit.translation import filled
from ...measure.window.window_tables import result_of
from ...measure.window_records import WindowRecord
from ...tables import window_file, window_layer
from ...tables.window_layer import WindowChange
from .window_watch import WindowWatch

Values = dict[int, Mapping[str, object]]
"""Values of windows by number and field."""


class ValuesStep:
    """Other values of windows."""

    def __init__(self, before: Values, after: Values) -> None:
        self.before, self.after = before, after
        self.marks_before: dict[int, str] = {}
        self.marks_after: dict[int, str] = {}  # fingerprints, where the values are measured
        self.records: dict[int, bytes] = {}
        """Results that the values had which are not in the layer now, where they are measured."""
        self.is_undone = False

    def apply(self, watch: WindowWatch, layer: QgsVectorLayer, is_undone: bool, words: str) -> list[int]:
        """Numbers of the windows that are other ones now. Raises WindowLayerError."""
        self.is_undone = is_undone
        values, marks = (self.before, self.marks_before) if is_undone else (self.after, self.marks_after)
        rows = {number: row for number in values if (row := watch.numbered(number)) is not None}
        window_layer.write(layer, WindowChange({row.fid: values[number] for number, row in rows.items()}), words)
        if marks and watch.path is not None:
            records, self.records = self.records, window_file.load_records(watch.path, marks)
            window_file.store(watch.path, [
                window_file.StoredResult(number, mark, result_of(records[number]) if number in records else None)
                for number, mark in marks.items()
            ])
            watch.note_fingerprints(marks)
        return list(rows)


class PresenceStep:
    """Windows come, or go."""

    def __init__(self, numbers: Sequence[int], is_adding: bool) -> None:
        self._numbers, self._is_adding = list(numbers), is_adding
        self._away: list[QgsFeature] = []

    def apply(self, watch: WindowWatch, layer: QgsVectorLayer, is_undone: bool, words: str) -> list[int]:
        """Numbers of the windows that came. Raises WindowLayerError."""
        if self._is_adding != is_undone:
            back = [window for window in self._away if watch.numbered(int(window["window_id"])) is None]
            window_layer.write(layer, WindowChange(added=back), words)
            self._numbers, self._away = [int(window["window_id"]) for window in self._away], []
            return self._numbers
        fids = [row.fid for row in map(watch.numbered, self._numbers) if row is not None]
        watch.prepare(fids, 0)  # they come back by the numbers that they have now
        self._away = list(layer.getFeatures(QgsFeatureRequest().setFilterFids(fids)))
        window_layer.write(layer, WindowChange(removed=fids), words)
        return []


Step = Union["ValuesStep", "PresenceStep"]


class WindowSteps(QObject):
    """The steps taken in the layer that is followed."""

    failed = pyqtSignal(object)  # the Message why a step can't be undone or done again
    stepped = pyqtSignal(list)  # numbers of the windows that were changed by undo or redo and are there

    def __init__(self, watch: WindowWatch, parent: QObject) -> None:
        super().__init__(parent)
        self._watch = watch
        self.stack = QUndoStack(self)
        watch.rolledBack.connect(self.stack.clear)  # what the desk did is gone, too

    def do(self, step: Step, words: str) -> None:
        """Take a step. Raises WindowLayerError, and nothing is done, when the layer can't be written."""
        self._apply(step, False, words)
        self.note(step, words)

    def note(self, step: Step, words: str) -> None:
        """A step that is being taken."""
        self.stack.push(_Command(words, lambda is_undone: self._replay(step, is_undone, words)))

    def change(self, values: Mapping[int, Mapping[str, object]], words: str) -> None:
        """Other values, by feature id and field. Raises WindowLayerError."""
        layer = self._watch.writable()
        if layer is None:
            return
        self._watch.prepare(values, 0)
        numbers = {fid: row.window_id for fid in values if (row := self._watch.row(fid)) is not None}
        names = sorted({name for changed in values.values() for name in changed})
        before: Values = {numbers[fid]: held for fid, held in window_layer.held_values(layer, numbers, names).items()}
        self.do(ValuesStep(before, {number: values[fid] for fid, number in numbers.items()}), words)

    def add(self, features: Sequence[QgsFeature], words: str) -> list[int]:
        """Windows come, whose numbers are returned. Raises WindowLayerError."""
        layer, numbers = self._watch.writable(), [int(window["window_id"]) for window in features]
        assert layer is not None
        window_layer.write(layer, WindowChange(added=features), words)
        self.note(PresenceStep(numbers, is_adding=True), words)
        return numbers

    def remove(self, fids: Iterable[int], words: str) -> None:
        """Windows go. Raises WindowLayerError."""
        rows = [row for row in map(self._watch.row, fids) if row is not None]
        if rows:
            self.do(PresenceStep([row.window_id for row in rows], is_adding=False), words)

    def _apply(self, step: Step, is_undone: bool, words: str) -> list[int]:
        layer = self._watch.writable()
        return step.apply(self._watch, layer, is_undone, words) if layer is not None else []

    def _replay(self, step: Step, is_undone: bool, words: str) -> None:
        try:
            self.stepped.emit(self._apply(step, is_undone, words))
        except SeamInspectorError as error:
            self.failed.emit(error.message)


class _Command(QUndoCommand):
    """What QUndoStack calls; it takes the step first when it is pushed, which is done by then."""

    def __init__(self, words: str, replay: Callable[[bool], None]) -> None:
        super().__init__(words)
        self._replay, self._is_pushed = replay, False

    def undo(self) -> None:
        self._replay(True)

    def redo(self) -> None:
        if self._is_pushed:
            self._replay(False)
        self._is_pushed = True


def words_of(rows: Sequence[WindowRecord], single: str, several: str) -> str:
    """What a step is called that does something to windows: ``{number}`` of the one, or ``{count}``."""
    if len(rows) == 1:
        return filled(single, number=rows[0].window_id)
    return filled(several, count=len(rows))
