"""Inspection in the background: what was asked for, what has come, and when it is written into the window layer."""
from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import islice
from typing import Any

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import SeamInspectorError
from ....toolkit.background_tasks import BackgroundTasks
from ....toolkit.desk.widgets import single_shot
from ....toolkit.translation import tr
from ... import jobs
from ...measure.window.measured_window import MeasureWindow, measure_window
from ...measure.window.source_use import SourceUse, source_use
from ...measure.window.window_result import WindowClips, WindowCurves, WindowResult
from ...tables import window_layer
from ..inputs.block_cache import BlockCache
from ..keeping import Keeping
from .window_watch import Version, WindowWatch

MOST_HELD = 500
"""Results in memory, of 30 to 150 kB each; others are read from the file beside the layer when somebody asks."""
_WRITE_MS = 1000  # results of a long run are written together: all that show windows follow each time


class WindowResults(QObject):
    """Results by window number, since feature ids change when the layer is saved."""

    arrived = pyqtSignal(int)
    """Feature id of a window that has its result now."""
    curvesArrived = pyqtSignal(int)
    """Feature id of a window whose curves are there, and the rest is not yet."""
    failed = pyqtSignal(object)
    """The Message why results could not be written."""
    progressChanged = pyqtSignal(int, int)
    """Steps done and asked for; (0, 0) when all is done and written."""

    def __init__(
        self,
        block: BlockCache,
        watch: WindowWatch,
        background: BackgroundTasks,
        keeping: Keeping,
        parent: QObject,
        measure: MeasureWindow = measure_window,
    ) -> None:
        """``measure``: how the pixels of a single window are measured."""
        super().__init__(parent)
        self._measure = measure
        self._block = block
        self._watch = watch
        self._background = background
        self._keeping = keeping
        self._results: dict[int, WindowResult] = {}  # the last asked for last
        self._uses: dict[int, SourceUse] = {}  # of all windows that have a result
        self._clips: dict[int, WindowClips] = {}  # of windows whose results are still to come
        self._versions: dict[int, Version] = {}  # of the results
        self._unwritten: dict[int, WindowResult] = {}
        self._waiting: dict[int, Version] = {}
        self._writer = single_shot(self, self.write, _WRITE_MS)
        background.progressChanged.connect(self._progress)
        watch.windowsChanged.connect(self._bring_back)

    def result(self, window_id: int) -> WindowResult | None:
        """What was measured, now or before the project was opened; None while it is being measured anew."""
        if window_id in self._results:
            self._results[window_id] = found = self._results.pop(window_id)
            return found
        row = None if window_id in self._waiting else self._watch.numbered(window_id)
        if row is None or (file := self._keeping.results) is None or (kept := file.result(row)) is None:
            return None
        self._hold(window_id, kept)
        return kept

    def source_uses(self) -> list[SourceUse]:
        """Uses of sources in all windows whose results came or were asked for."""
        return list(self._uses.values())

    def clips(self, window_id: int) -> WindowCurves | None:
        """The curves of its clips, which are there before the rest of the result."""
        return self._clips.get(window_id) or self.result(window_id)

    def is_pending(self, window_id: int) -> bool:
        """Whether a window is being inspected, or its result not written yet."""
        return window_id in self._waiting or window_id in self._unwritten

    def inspect(self, fids: Sequence[int]) -> None:
        """Inspect windows, those left out that are being inspected already.

        Raises SeamInspectorError when the inputs or the layer do not allow it.
        """
        layer = self._watch.layer
        if layer is None or not fids:
            return
        block = self._block.required()
        self._block.settings().check()
        state = self._block.state()
        fids = self._watch.prepare(fids, self._block.inputs.levels)
        rows = [row for row in map(self._watch.row, fids) if row is not None]
        rows = [row for row in rows if self._waiting.get(row.window_id) != Version(row.extent, state)]
        if rows:
            asked = {row.window_id: Version(row.extent, state) for row in rows}
            self._waiting.update(asked)
            for number in asked:
                for kept in (self._results, self._uses, self._clips):
                    kept.pop(number, None)
            job = jobs.inspection_job(self._block.requests(block, layer, rows), len(rows), self._measure)
            self._background.start(tr("Inspect windows"), job, partial(self._take, asked), steps=len(rows))

    def write(self) -> None:
        """Write what has come; it is no step of undo. What is outdated by now is written too, and stale."""
        layer, unwritten = self._watch.layer, self._unwritten
        if layer is None or not unwritten:
            return
        if layer.isEditCommandActive():  # the operator is in the middle of a change
            self._writer.start()
            return
        self._unwritten = {}
        try:
            rows = map(self._watch.numbered, unwritten)
            found = {row.fid: unwritten[row.window_id] for row in rows if row is not None}
            if found:
                window_layer.write_results(layer, found)
        except SeamInspectorError as error:
            self._background.stop()
            self.failed.emit(error.message)
            return
        self._watch.note_measured({number: self._versions[number] for number in unwritten})

    def forget(self) -> None:
        """They are of a layer that is followed no more."""
        for kept in (self._results, self._uses, self._versions, self._clips, self._unwritten, self._waiting):
            kept.clear()

    def forget_asked(self) -> None:
        """What was asked for has been cancelled."""
        self._waiting.clear()

    def close(self) -> None:
        """Write what has come, and nothing more."""
        self.write()
        self._writer.stop()
        self.forget()

    def _take(self, asked: dict[int, Version], result: Any) -> None:
        number = result.window_id
        if isinstance(result, WindowClips):
            self._clips[number] = result
            if (row := self._watch.numbered(number)) is not None:
                self.curvesArrived.emit(row.fid)
            return
        self._clips.pop(number, None)
        self._versions[number] = asked[number]
        self._unwritten[number] = result
        if (file := self._keeping.results) is not None:
            file.keep(result)
        self._hold(number, result)
        if self._waiting.get(number) == asked[number]:
            del self._waiting[number]
        if not self._writer.isActive():
            self._writer.start()
        if (row := self._watch.numbered(number)) is not None:
            self.arrived.emit(row.fid)

    def _hold(self, number: int, result: WindowResult) -> None:
        """Hold a result as the last that was asked for; the first ones go, unless they would be lost."""
        self._results.pop(number, None)
        self._results[number], self._uses[number] = result, source_use(result)
        if (file := self._keeping.results) is None:
            return
        for other in list(islice(self._results, max(len(self._results) - MOST_HELD, 0))):
            if other not in self._unwritten and file.holds(other):
                del self._results[other]

    def _bring_back(self) -> None:
        """What undo and redo bring back comes without what was not written by a step of theirs."""
        for row in self._watch.take_bereft():
            number, file = row.window_id, self._keeping.results
            version = self._versions.get(number)
            if version is None or version.extent != row.extent or self.is_pending(number):
                continue
            result = self._results.get(number) or (file.last(number) if file is not None else None)
            if result is not None:
                self._unwritten[number] = result
        if self._unwritten and not self._writer.isActive():
            self._writer.start()

    def _progress(self, done: int, asked: int) -> None:
        if not asked:
            self._waiting.clear()
            self.write()
        self.progressChanged.emit(done, asked)
