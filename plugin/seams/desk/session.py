"""The one model behind the dock, the map tool and all panels: inputs, windows, results, and work in the background."""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from qgis.core import QgsProject, QgsRasterLayer, QgsVectorLayer
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...imagery.errors import Message, SeamInspectorError
from ...imagery.grids import Grid, PixelWindow
from ...imagery.statistics import FIRST, Operator
from ...toolkit.desk.message_bar import bar_level
from ...toolkit.layer_editing import edit_step
from ...toolkit.translation import sentence, tr
from ..clip_pictures import ClipPicture
from ..measure.inputs.source_use import SourceUse
from ..measure.inputs.valid_cells import FEWEST_PX, SEARCHED_SIDES
from ..measure.inspection import Block, WindowRequest
from ..measure.live.live_window import LiveWindow
from ..measure.window.window_result import WindowCurves, WindowResult
from ..measure.window_records import WindowRecord
from ..scan_job import ScanOrder
from ..tables import window_layer
from .desk_parts import DeskParts
from .inputs.project_inputs import Inputs
from .loss_view import LossView
from .map.window_coverage import Coverage
from .project_follower import ProjectFollower
from .windows.window_watch import WindowWatch


class Session(QObject):
    """Inputs, windows, results. Everything that reads pixels runs in tasks; results come back by signals."""

    inputsChanged = pyqtSignal()
    coverageChanged = pyqtSignal()
    windowsChanged = pyqtSignal()
    selectionChanged = pyqtSignal()
    curvesArrived = pyqtSignal(int)
    resultArrived = pyqtSignal(int)
    liveChanged = pyqtSignal()
    picturesArrived = pyqtSignal(int)
    progressChanged = pyqtSignal(int, int)
    messageRaised = pyqtSignal(str, int)
    windowsFound = pyqtSignal(object, object)
    """Path of windows that the project lacks, and the Message that says so."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.loss_view = LossView(self)
        """Whether lost detail is painted over the map and the images."""
        self._watch = WindowWatch(self)
        self._watch.windowsChanged.connect(self.windowsChanged)
        self._watch.selectionChanged.connect(self.selectionChanged)
        self._parts = parts = DeskParts(QgsProject.instance(), self._watch, self)
        self._block, self._seams, self._coverage = parts.block, parts.seams, parts.coverage
        self._live, self._keeping, self._pictures = parts.live, parts.keeping, parts.pictures
        self._results, self._new, self._background = parts.results, parts.new, parts.background
        self._coverage.changed.connect(self.coverageChanged)
        self._live.changed.connect(self.liveChanged)
        self._results.curvesArrived.connect(self.curvesArrived)
        self._results.arrived.connect(self.resultArrived)
        self._results.progressChanged.connect(self.progressChanged)
        self._pictures.arrived.connect(self.picturesArrived)
        self._follower = ProjectFollower(parts, self)
        self._follower.inputsChanged.connect(self.inputsChanged)
        self._follower.windowsFound.connect(self.windowsFound)
        self._new.layerMade.connect(self._follower.take_layer)
        self._new.drawn.connect(self._take_drawn)
        for told in (
            parts.inputs_background.failed, parts.background.failed, self._live.failed, self._results.failed,
            self._keeping.told, self._new.told, self._follower.told,
        ):
            told.connect(self._tell)

    def close(self) -> None:
        """Stop all work, keep what is done, and let go of the project and the window layer; once is enough."""
        self._follower.close()
        self._parts.close()

    # Inputs

    @property
    def inputs(self) -> Inputs:
        """What is inspected and how."""
        return self._block.inputs

    def set_inputs(self, inputs: Inputs) -> None:
        """Change the inputs and remember them in the project. Inspected windows become stale when they matter."""
        self._follower.set_inputs(inputs)

    def mosaic_layer(self) -> QgsRasterLayer | None:
        """The mosaic, while it is there."""
        return self._block.mosaic_layer()

    def mosaic_grid(self) -> Grid | None:
        """The mosaic's pixel grid; None while there is no mosaic that windows can lie on, or it is being opened."""
        block = self._block.silent()
        return block.mosaic.grid if block is not None else None

    def block(self) -> Block | None:
        """Mosaic and sources under inspection; None while there are none, or they are being opened."""
        return self._block.silent()

    def problem(self) -> Message | None:
        """Why nothing can be inspected now: an input is missing or can't be used, or the mosaic is being opened."""
        return self._block.problem()

    def scan_order(self) -> ScanOrder:
        """What a scan of the whole mosaic is made of. Raises SeamInspectorError when the inputs do not allow one."""
        return self._block.scan_order()

    def source_count_over(self, window: PixelWindow) -> int:
        """How many sources' footprints cover a window."""
        block = self._block.silent()
        return len(block.sources_over(window)) if block is not None else 0

    def coverage(self, window: PixelWindow) -> Coverage:
        """What mosaic and sources have in a window, as far as it was looked at."""
        return self._coverage.at(window)

    def nearest_judgeable(self, window: PixelWindow, on_seam: bool) -> PixelWindow | None:
        """The nearest window of that size that can be judged, its middle on a seam; None where none is near."""
        grid = self.mosaic_grid()
        if grid is None:
            return None
        xmin, ymin, xmax, ymax = grid.window_extent(window)
        reach, spacing = SEARCHED_SIDES * max(xmax - xmin, ymax - ymin), FEWEST_PX * grid.pixel_width
        middle = (xmin + xmax) / 2, (ymin + ymax) / 2
        return self._coverage.nearest(window, self._seams.points(*middle, reach, spacing) if on_seam else None)

    def request(self, fid: int) -> WindowRequest | None:
        """A window as it is measured, and the sources over it; None while there is no block."""
        row, block, layer = self.row(fid), self.block(), self.window_layer()
        if row is None or block is None or layer is None:
            return None
        return next(self._block.requests(block, layer, [row]))

    def seam_point_near(self, x: float, y: float, reach: float) -> tuple[float, float] | None:
        """The nearest point of a seam within ``reach``, all in the mosaic's reference system."""
        return self._seams.nearest(x, y, reach)

    # The window under the mouse

    @property
    def live(self) -> LiveWindow | None:
        """The window that is being drawn or moved, as far as it is known; ``liveChanged`` tells."""
        return self._live.current

    def hover(self, window: PixelWindow, is_live: bool) -> None:
        """A window that a click or the end of a drag would make; ``is_live``: its curves are to be seen meanwhile."""
        self._live.hover(window, is_live)

    def leave(self) -> None:
        """The mouse is over no window any more."""
        self._live.leave()

    # Windows

    def window_layer(self) -> QgsVectorLayer | None:
        """The layer that holds the windows, while it is there."""
        return self._watch.layer

    def windows(self) -> list[WindowRecord]:
        """All windows by their number."""
        return self._watch.rows()

    def row(self, fid: int) -> WindowRecord | None:
        """One window."""
        return self._watch.row(fid)

    def numbered(self, window_id: int) -> WindowRecord | None:
        """The window with a number, which it keeps when feature ids change."""
        return self._watch.numbered(window_id)

    def selected(self) -> list[int]:
        """Feature ids of the selected windows."""
        return self._watch.selected()

    def select(self, fids: Sequence[int]) -> None:
        """Select windows, on the map and in the table alike."""
        self._watch.select(fids)

    def add_window(self, window: PixelWindow) -> None:
        """A new window, selected and inspected at once in the background; the first one waits for its layer."""
        self._new.draw(window)

    def remove(self, fids: Sequence[int]) -> None:
        """Remove windows; undo brings them back."""
        with self._raised():
            if self._watch.layer is not None and fids:
                window_layer.remove_windows(self._watch.layer, fids)

    def judge(self, fids: Sequence[int], word: str, operator: Operator = FIRST) -> None:
        """Write what an operator saw: ``visible``, ``invisible``, ``unsure`` or nothing."""
        self.note(fids, {operator.observer: word or None})

    def note(self, fids: Sequence[int], values: Mapping[str, object]) -> None:
        """Write what an operator says of windows, by his fields' names; None takes it back."""
        with self._raised():
            if (layer := self._watch.layer) is None:
                return
            others = window_layer.not_judged_so(layer, fids, values)  # the same again is no step
            if others:
                with edit_step(layer, tr("Judge windows")):
                    prepared = self._watch.prepare(others, self.inputs.levels, values)
                    window_layer.write_judgement(layer, prepared, values)
                self._keeping.note_judged(layer)

    # Work in the background

    @property
    def is_busy(self) -> bool:
        """Whether windows are being made, placed or inspected."""
        return self._background.is_busy or self._new.is_busy

    @property
    def can_stop(self) -> bool:
        """Whether there is work that ``stop`` ends."""
        return self._background.is_busy

    def is_pending(self, fid: int) -> bool:
        """Whether a window is being inspected, or its result not written yet."""
        row = self.row(fid)
        return row is not None and self._results.is_pending(row.window_id)

    def place_windows(self) -> None:
        """Place windows along the seamlines; they are added when all are found, and not inspected yet."""
        with self._raised():
            self._new.place()

    def inspect(self, fids: Sequence[int]) -> None:
        """Inspect windows, those left out that are being inspected already."""
        with self._raised():
            self._results.inspect(fids)

    def inspect_pending(self) -> None:
        """Inspect all windows that are not inspected yet or have changed since."""
        self.inspect([row.fid for row in self.windows() if not row.verdict or row.stale])

    def stop(self) -> None:
        """Cancel placing and inspection; what is done stays."""
        self._results.forget_asked()
        self._background.stop()

    def result(self, fid: int) -> WindowResult | None:
        """All that was measured in a window in this session; None until it is complete."""
        row = self.row(fid)
        return self._results.result(row.window_id) if row is not None else None

    def source_uses(self) -> list[SourceUse]:
        """Of all windows that were inspected in this session."""
        return self._results.source_uses()

    def clips(self, fid: int) -> WindowCurves | None:
        """The curves of a window, which ``curvesArrived`` tells before the rest; its result once that is there."""
        row = self.row(fid)
        return self._results.clips(row.window_id) if row is not None else None

    def pictures(self, fid: int) -> tuple[ClipPicture, ...] | None:
        """The clips of a window as pictures; when they are not there yet they are read in the background."""
        return self._pictures.pictures(fid)

    def composite(self, fid: int) -> tuple[ClipPicture, ...] | None:
        """The hard-cut composite of a window whose pictures are there; None while it is made, empty without one."""
        return self._pictures.composite(fid)

    def _take_drawn(self, fids: list[int]) -> None:
        self.select(fids)
        self.inspect(fids)

    def open_windows(self, path: Path) -> None:
        """Take the windows of a file that the desk has made."""
        with self._raised():
            self._follower.open_windows(path)

    def _tell(self, message: Message) -> None:
        self.messageRaised.emit(sentence(message), bar_level(message))

    @contextmanager
    def _raised(self) -> Iterator[None]:
        """Errors the user can mend become a message, not a traceback."""
        try:
            yield
        except SeamInspectorError as error:
            self._tell(error.message)
