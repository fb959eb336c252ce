"""What is done to windows: steps that are in the file at once and can be undone, and inspections in the background.

Steps know windows by their numbers, since feature ids change where somebody edits the layer with QGIS's tools. What is
gone meanwhile is left out.
"""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import islice
from typing import Any, Callable, NamedTuple, Union

from qgis.core import QgsFeature, QgsFeatureRequest, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import SeamInspectorError
from ....imagery.grids import Extent
from ....toolkit.background_tasks import BackgroundTasks
from ....toolkit.desk.widgets import QUndoCommand, QUndoStack, single_shot
from ....toolkit.translation import filled, tr
from ... import jobs
from ...measure.window.measured_window import MeasureWindow, measure_window
from ...measure.window.window_result import WindowClips, WindowResult
from ...measure.window.window_tables import result_of
from ...measure.window_records import WindowRecord
from ...tables import window_file, window_layer
from ...tables.window_layer import WindowChange
from ...window_summary import is_same
from ..inputs.block_cache import BlockCache
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
        self._saved = self._kept = 0  # steps taken that are in the file, and those of them that are still known
        self._is_silent = False
        watch.saved.connect(self._note_saved)
        watch.rolledBack.connect(self._drop_unsaved)

    def do(self, step: Step, words: str) -> None:
        """Take a step. Raises WindowLayerError, and nothing is done, when the layer can't be written."""
        self._apply(step, False, words)
        self.note(step, words)

    def note(self, step: Step, words: str) -> None:
        """A step that is being taken."""
        self._kept = min(self._kept, self.stack.index())
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

    def _replay(self, step: Step, is_undone: bool, words: str) -> bool:
        if self._is_silent:
            return is_undone  # whether the step is to be forgotten
        try:
            self.stepped.emit(self._apply(step, is_undone, words))
        except SeamInspectorError as error:
            self.failed.emit(error.message)
        return False

    def _note_saved(self) -> None:
        """All that is done is in the file; what comes now lies in the buffer of QGIS's pencil."""
        self._saved = self._kept = self.stack.index()

    def _drop_unsaved(self) -> None:
        """What was done since the pencil was taken up is gone, and what was undone is there again."""
        self._is_silent = True
        while self.stack.index() > self._kept:
            self.stack.undo()
        while self.stack.index() < self._saved and self.stack.canRedo():
            self.stack.redo()
        self._is_silent = False
        self._note_saved()


class _Command(QUndoCommand):
    """What QUndoStack calls; it takes the step first when it is pushed, which is done by then."""

    def __init__(self, words: str, replay: Callable[[bool], bool]) -> None:
        super().__init__(words)
        self._replay, self._is_pushed = replay, False

    def undo(self) -> None:
        self.setObsolete(self._replay(True))

    def redo(self) -> None:
        if self._is_pushed:
            self._replay(False)
        self._is_pushed = True


def words_of(rows: Sequence[WindowRecord], single: str, several: str) -> str:
    """What a step is called that does something to windows: ``{number}`` of the one, or ``{count}``."""
    if len(rows) == 1:
        return filled(single, number=rows[0].window_id)
    return filled(several, count=len(rows))


MOST_HELD = 500
"""Results in memory, of 30 to 150 kB each; others are read from the file when somebody asks."""
_WRITE_MS = 150  # at least, from one writing to the next: those of a long run are written together
_AT_ONCE, _PAUSE_MS = 3, 20  # results, of some 12 ms each; then the interface has its turn


class _Version(NamedTuple):
    """What a result is of."""

    extent: Extent | None  # the extent that the window had
    inputs: str  # their fingerprint


class WindowResults(QObject):
    """Results by window number, since feature ids change where the layer is edited with QGIS's tools."""

    arrived = pyqtSignal(int)  # feature id of a window that has its result now
    curvesArrived = pyqtSignal(int)  # feature id of a window whose curves are there, and the rest is not yet
    failed = pyqtSignal(object)  # the Message why results could not be written
    progressChanged = pyqtSignal(int, int)  # steps done and asked for; (0, 0) when all is done and written

    def __init__(
        self, block: BlockCache, steps: WindowSteps, watch: WindowWatch, background: BackgroundTasks,
        parent: QObject, measure: MeasureWindow = measure_window,
    ) -> None:
        """``measure``: how the pixels of a single window are measured."""
        super().__init__(parent)
        self._measure = measure
        self._block = block
        self._steps = steps
        self._watch = watch
        self._background = background
        self._results: dict[int, WindowResult] = {}  # the last asked for last
        self._clips: dict[int, WindowClips] = {}  # of windows whose results are still to come
        self._unwritten: dict[int, WindowResult] = {}
        self._waiting: dict[int, _Version] = {}
        self._versions: dict[int, _Version] = {}  # of results that are not written
        self._inspections: dict[int, ValuesStep] = {}  # that the results are of, where they can be undone
        self._writer = single_shot(self, self._write_more, _WRITE_MS)
        background.progressChanged.connect(self._progress)
        watch.windowsChanged.connect(self._write_more)  # one that was undone while it was measured may be back

    def result(self, window_id: int) -> WindowResult | None:
        """What was measured, now or before the project was opened; None while it is being measured anew."""
        row = None if window_id in self._waiting else self._watch.numbered(window_id)
        if row is None:
            return None
        result = self._results.pop(window_id, None)
        if result is not None and window_id not in self._unwritten and not _is_of(result, row):
            result = None
        if result is None and row.verdict and self._watch.path is not None:
            result = window_file.load_result(self._watch.path, window_id)
            result = result if result is not None and _is_of(result, row) else None
        if result is not None:
            self._hold(window_id, result)
        return result

    def clips(self, window_id: int) -> WindowResult | None:
        """The curves of its clips, which are there before the rest of the result."""
        return self._clips.get(window_id) or self.result(window_id)

    def is_pending(self, window_id: int) -> bool:
        """Whether a window is being inspected, or its result not written yet."""
        return window_id in self._waiting or window_id in self._unwritten

    def inspect(self, fids: Sequence[int], is_step: bool = True) -> None:
        """Inspect windows, those left out that are being inspected already. ``is_step``: as a step of undo.

        Raises SeamInspectorError when the inputs or the layer do not allow it.
        """
        if self._watch.layer is None or not fids:
            return
        block = self._block.required()
        self._block.settings().check()
        layer = self._watch.writable()
        assert layer is not None
        state = self._block.state() or ""
        self._watch.prepare(fids, self._block.inputs.levels)
        rows = [row for row in map(self._watch.row, fids) if row is not None]
        rows = [row for row in rows if self._waiting.get(row.window_id) != _Version(row.extent, state)]
        if not rows:
            return
        if is_step:
            self._note_step(rows)
        asked = {row.window_id: _Version(row.extent, state) for row in rows}
        self._waiting.update(asked)
        for number in asked:
            for kept in (self._results, self._clips):
                kept.pop(number, None)
        job = jobs.inspection_job(self._block.requests(block, layer, rows, compared=True), len(rows), self._measure)
        self._background.start(tr("Inspect windows"), job, partial(self._take, asked), steps=len(rows))

    def _note_step(self, rows: Sequence[WindowRecord]) -> None:
        layer = self._watch.writable()
        assert layer is not None
        names = window_layer.measured_names(layer)
        held = window_layer.held_values(layer, [row.fid for row in rows], names)
        step = ValuesStep({row.window_id: held[row.fid] for row in rows}, {})
        step.marks_before = {
            row.window_id: self._watch.fingerprints[row.window_id]
            for row in rows if row.window_id in self._watch.fingerprints
        }  # fmt: skip
        if self._watch.path is not None:
            step.records = window_file.load_records(self._watch.path, step.marks_before)
        self._inspections.update(dict.fromkeys(step.before, step))
        self._steps.note(step, words_of(rows, tr("inspecting window {number}"), tr("inspecting {count} windows")))

    def write(self) -> None:
        """Write all that has come for windows that are there."""
        while self._write_some():
            pass

    def _write_some(self) -> bool:
        """Write some results: into the layer first, so that a window is known to be stale if nothing more is written.
        Whether there was any."""
        layer, path = self._watch.layer, self._watch.path
        rows = [row for row in map(self._watch.numbered, self._unwritten) if row is not None][:_AT_ONCE]
        if layer is None or path is None or not rows or layer.isEditCommandActive():
            return False
        unwritten = {row.window_id: self._unwritten.pop(row.window_id) for row in rows}
        steps = self._inspections
        rows = [row for row in rows if not (row.window_id in steps and steps[row.window_id].is_undone)]
        values = {row.fid: window_layer.measured_values(layer, unwritten[row.window_id]) for row in rows}
        try:
            window_layer.write(layer, WindowChange(values), tr("Inspect windows"))
            stored, marks = [], {}
            for row in filter(None, map(self._watch.row, values)):
                number = row.window_id
                extent, inputs = self._versions[number]
                marks[number] = window_file.fingerprint(replace(row, extent=extent), inputs)
                stored.append(window_file.StoredResult(number, marks[number], unwritten[number]))
                if (step := self._inspections.pop(number, None)) is not None:
                    step.after[number], step.marks_after[number] = values[row.fid], marks[number]
            window_file.store(path, stored)
        except SeamInspectorError as error:
            self._background.stop()
            self.failed.emit(error.message)
            return False
        self._watch.note_fingerprints(marks)
        return True

    def forget(self) -> None:
        """They are of a layer that is followed no more."""
        for kept in (
            self._results, self._clips, self._unwritten, self._waiting, self._versions, self._inspections
        ):  # fmt: skip
            kept.clear()

    def forget_asked(self) -> None:
        """What was asked for has been cancelled."""
        self._waiting.clear()

    def close(self) -> None:
        """Write what has come, and nothing more."""
        self.write()
        self._writer.stop()
        self.forget()

    def _write_more(self) -> None:
        if not self._writer.isActive() and self._write_some():
            self._writer.start(_PAUSE_MS if self._unwritten else _WRITE_MS)

    def _take(self, asked: dict[int, _Version], result: Any) -> None:
        number = result.window_id
        if isinstance(result, WindowClips):
            self._clips[number] = result
            if (row := self._watch.numbered(number)) is not None:
                self.curvesArrived.emit(row.fid)
            return
        self._clips.pop(number, None)
        self._unwritten[number], self._versions[number] = result, asked[number]
        self._hold(number, result)
        if self._waiting.get(number) == asked[number]:
            del self._waiting[number]
        self._write_more()
        if (row := self._watch.numbered(number)) is not None:
            self.arrived.emit(row.fid)

    def _hold(self, number: int, result: WindowResult) -> None:
        """Hold a result as the last that was asked for; the first ones go."""
        self._results.pop(number, None)
        self._results[number] = result
        for other in list(islice(self._results, max(len(self._results) - MOST_HELD, 0))):
            if other not in self._unwritten:
                del self._results[other]

    def _progress(self, done: int, asked: int) -> None:
        if not asked:
            self._waiting.clear()
            self.write()
        self.progressChanged.emit(done, asked)


def _is_of(result: WindowResult, row: WindowRecord) -> bool:
    """Whether a row has the values of a result; undo, or another inspection, may have written others since."""
    profile = result.profile
    return (
        row.verdict == result.judgement.verdict.value
        and all(map(is_same, row.ratios, result.judgement.ratios.detail))
        and all(map(is_same, row.kept, profile.kept if profile is not None else row.kept))
    )
