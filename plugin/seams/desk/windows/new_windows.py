"""Windows come into being: drawn one by one or placed along the seams, and the layer that holds them.

All of that belongs to the interface's thread, and QGIS takes some 20 ms to write a GeoPackage, to open it, and to start
its editing; so it is done in steps, between which the interface has its turn.
"""
from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Sequence
from functools import partial
from typing import Any

from qgis.core import QgsGeometry, QgsProject
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import Message, SeamInspectorError
from ....imagery.grids import Extent, PixelWindow
from ....toolkit import layers
from ....toolkit.background_tasks import BackgroundTasks
from ....toolkit.desk.message_bar import write_log
from ....toolkit.desk.widgets import single_shot
from ....toolkit.translation import tr
from ... import jobs
from ...measure import messages
from ...measure.inspection import Block
from ...measure.window_placing import Placement
from ...tables import window_layer
from .. import messages as keeping_messages
from ..inputs.block_cache import BlockCache
from ..keeping import home_of
from .window_watch import WindowWatch

_PLACING = "placing"
_AT_ONCE = 25  # windows added in one step, some 10 ms with all that follows them


class NewWindows(QObject):
    """Does one thing after the other, step by step."""

    layerMade = pyqtSignal(str)
    """Id of a new window layer in the project, to be followed from now on."""
    drawn = pyqtSignal(list)
    """Feature ids of windows that are to be inspected at once."""
    told = pyqtSignal(object)
    """A Message."""

    def __init__(
        self, project: QgsProject, block: BlockCache, watch: WindowWatch, background: BackgroundTasks, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._project = project
        self._block = block
        self._watch = watch
        self._background = background
        self._waiting: deque[Iterator[None]] = deque()
        self._is_at_work = False
        self._clock = single_shot(self, self._go_on)

    @property
    def is_busy(self) -> bool:
        """Whether there are steps left."""
        return bool(self._waiting)

    def draw(self, window: PixelWindow) -> None:
        """Add one window, or take the one that is there already; where there is a layer for it, at once."""
        self._start(self._drawing(window))

    def place(self) -> None:
        """Place windows along the seamlines; they are added when all are found.

        Raises SeamInspectorError when the inputs do not allow it.
        """
        block = self._block.required()
        lines = self._block.seamlines(block)
        if lines is None:
            raise SeamInspectorError(messages.NO_SEAMLINES())
        if self._background.is_under_way(_PLACING):
            return
        inputs = self._block.inputs
        job = jobs.placing_job(lines, block.mosaic, inputs.placing)
        self._background.start(tr("Place windows"), job, partial(self._take, inputs.mosaic), _PLACING, steps=1)

    def copy(self, outlines: Sequence[QgsGeometry]) -> None:
        """Add windows of these outlines, in the mosaic's reference system, to a new layer."""
        self._start(self._copying(outlines))

    def abandon(self) -> None:
        """What is under way is of a layer that is followed no more; a layer that is just being taken over is ours."""
        if self._is_at_work:
            return
        self._clock.stop()
        while self._waiting:
            self._waiting.popleft().close()  # type: ignore[attr-defined]

    # What there is to do, in steps

    def _drawing(self, window: PixelWindow) -> Iterator[None]:
        yield from self._with_layer(block := self._block.required())
        found = [fid for fid in self._there(block, [window]) if fid is not None]
        self.drawn.emit(found or [fid for fids in self._added(self._outlines(block, [window]), 0) for fid in fids])

    def _copying(self, outlines: Sequence[QgsGeometry]) -> Iterator[None]:
        yield from self._with_layer(self._block.required())
        for _ in self._added(outlines, _AT_ONCE):
            yield

    def _placing(self, mosaic: str, placement: Placement) -> Iterator[None]:
        if mosaic != self._block.inputs.mosaic:
            return
        found = [placed.window for placed in placement.windows]
        windows = found
        if found:
            yield from self._with_layer(block := self._block.required())
            windows = [one for one, there in zip(found, self._there(block, found)) if there is None]
            for _ in self._added(self._outlines(block, windows), _AT_ONCE):
                yield
        write_log(placement.dropped)
        self.told.emit(_placed_message(len(windows), len(found) - len(windows), placement.dropped))

    def _with_layer(self, block: Block) -> Iterator[None]:
        """Make the window layer when there is none."""
        if self._watch.layer is not None:
            return
        folder = home_of(self._project)
        path = window_layer.write_window_file(block.mosaic.wkt, self._block.inputs.levels, folder)
        yield
        made = window_layer.open_window_layer(path)
        yield
        self._project.addMapLayer(made)
        if not self._project.homePath():
            self.told.emit(keeping_messages.WINDOWS_KEPT_MEANWHILE(path=path))
        yield
        self.layerMade.emit(made.id())
        yield
        layers.start_editing(made)
        yield

    def _there(self, block: Block, windows: Sequence[PixelWindow]) -> list[int | None]:
        """The layer's windows at the same places, None where there is none: nothing is doubled."""
        places = [layers.extent(outline) for outline in self._outlines(block, windows)]
        pixel = min(places[0][2] - places[0][0], places[0][3] - places[0][1]) / windows[0].width
        taken = {_in_pixels(row.extent, places[0], pixel): row.fid for row in self._watch.rows() if row.extent}
        return [taken.get(_in_pixels(place, places[0], pixel)) for place in places]

    def _outlines(self, block: Block, windows: Sequence[PixelWindow]) -> list[QgsGeometry]:
        """In the layer's reference system."""
        layer = self._watch.layer
        assert layer is not None
        return self._block.outlines(block, layer, windows)

    def _added(self, outlines: Sequence[QgsGeometry], at_once: int) -> Iterator[list[int]]:
        layer = self._watch.layer
        assert layer is not None
        with layers.edit_step(layer, tr("Add windows")):
            self._watch.prepare([], self._block.inputs.levels)
            yield from window_layer.add_windows(layer, outlines, self._watch.next_number, at_once)

    def _take(self, mosaic: str, placement: Any) -> None:
        self._start(self._placing(mosaic, placement))

    def _start(self, steps: Iterator[None]) -> None:
        self._waiting.append(steps)
        if len(self._waiting) == 1:
            self._go_on()

    def _go_on(self) -> None:
        """One step."""
        self._is_at_work = True
        try:
            next(self._waiting[0])
        except StopIteration:
            self._waiting.popleft()
        except SeamInspectorError as error:
            self._waiting.popleft()
            self.told.emit(error.message)
        except BaseException:
            self._waiting.popleft()
            raise
        finally:
            self._is_at_work = False
            if self._waiting:
                self._clock.start()


def _in_pixels(extent: Extent, origin: Extent, pixel: float) -> tuple[int, ...]:
    """Where a window lies from another one on the same grid, to the next pixel: files round coordinates."""
    return tuple(round((edge - start) / pixel) for edge, start in zip(extent, origin))


def _placed_message(count: int, there: int, dropped: Sequence[Message]) -> Message:
    """What became of placing: windows added, places that had theirs already, and places without one."""
    if not count:
        if there:
            return messages.WINDOWS_THERE_ALREADY(there=there)
        return dropped[0] if len(dropped) == 1 else messages.NO_WINDOW_PLACED()
    if there:
        return messages.WINDOWS_PLACED_BESIDES(count=count, there=there)
    if dropped:
        return messages.WINDOWS_PLACED_IN_PART(count=count)
    return messages.WINDOWS_PLACED(count=count)
