"""What lies under the mouse: seams, and a window whose curves follow while it moves."""
from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from functools import partial
from typing import TYPE_CHECKING, Any

from qgis.core import QgsGeometry, QgsLineString, QgsMultiLineString, QgsPointXY
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.grids import PixelWindow
from ....imagery.lines import find_seams
from ....imagery.raster_pool import ReadingLanes
from ....toolkit.background_tasks import BackgroundTasks, LatestOnly
from ....toolkit.desk.widgets import single_shot
from ....toolkit.translation import tr
from ...measure.window.explained_window import LiveWindow, live_profile, read_live
from ...measure.window.inspection import window_request
from ...measure.window.measured_window import Measured, MeasuredAhead, MeasuredWindow, WindowRequest
from ...measure.window_records import WindowRecord
from ..inputs.block_cache import BlockCache

if TYPE_CHECKING:
    from ...charts.profile_painter import ShownProfile
    from ...measure.profile.seam_profile import SeamProfile


class SeamFinder:
    """Looks for the seams once for each layer of seamlines and mosaic, and when the seamlines are edited."""

    def __init__(self, block: BlockCache, background: BackgroundTasks) -> None:
        self._block = block
        self._background = background
        self.forget()

    def forget(self) -> None:
        """Another project."""
        self.seams = QgsGeometry()  # empty while they are being found
        self._key: object = None  # what was searched
        self._turn = object()

    def refresh(self, anew: bool = False) -> None:
        """The inputs or the project's layers have changed; ``anew``: so have the seamlines themselves."""
        block = self._block.silent()
        lines = self._block.seamlines(block) if block is not None else None
        if block is None or lines is None:
            self.forget()
            return
        seamlines = self._block.inputs.seamlines
        key = seamlines, self._block.seen(seamlines), block.mosaic
        if key == self._key and not anew:
            return
        if key != self._key:  # else those of before are better than none
            self.forget()
        self._key = key
        self._turn = turn = object()
        job = partial(_seams_job, lines, block.mosaic.grid.pixel_width)
        self._background.start(tr("Find seams"), job, partial(self._take, turn))

    def nearest(self, x: float, y: float, reach: float) -> tuple[float, float] | None:
        """The nearest point of a seam within reach; None where there is none, or while they are being found."""
        squared, point, *_ = self.seams.closestSegmentWithContext(QgsPointXY(x, y))
        return (point.x(), point.y()) if 0 <= squared <= reach**2 else None

    def _take(self, turn: object, seams: Any) -> None:
        if turn is self._turn:
            self.seams = seams


def _seams_job(lines: Iterable[bytes | None], pixel: float, _cancelled: object) -> Iterator[tuple[float, object]]:
    seams = QgsMultiLineString()
    for seam in find_seams(lines, pixel):
        seams.addGeometry(QgsLineString(*seam.vertices.T.tolist()))
    yield 1.0, QgsGeometry(seams)


@dataclass(frozen=True)
class ClickedPiece:
    """The piece of a scanned seam that was clicked."""

    record: WindowRecord  # what the scan found, as of a window
    window: PixelWindow  # the standard window around the click, which the curves are of
    profile: ShownProfile | None  # as the scan wrote it
    place: QgsPointXY  # of the click, on the mosaic


_REST_MS = 60  # a mouse that stays this long may be about to click
_IDLE_MS = 20_000  # after that the files are closed and the pixels forgotten
_NO_NUMBER = 0


class LiveWindows(QObject):
    """Three threads, each busy with what was asked for last: curves, seam profiles, and windows measured ahead.

    ``measure`` is how a single window is to be measured: what was measured ahead is there at once.
    """

    changed = pyqtSignal()  # there is another live window, or more is known of it, or there is none any more
    failed = pyqtSignal(object)  # a Message

    def __init__(self, block: BlockCache, parent: QObject) -> None:
        super().__init__(parent)
        self._block = block
        self._lanes = ReadingLanes()
        self.measure = MeasuredAhead(self._lanes)
        self.current: LiveWindow | None = None  # the window that is being moved, as far as it is known
        self._hovered: PixelWindow | None = None
        self._curves = LatestOnly("seam-inspector-live-curves", self)
        self._curves.arrived.connect(self._take_pixels)
        self._profiles = LatestOnly("seam-inspector-live-profile", self, rest=1.0)  # the curves go first
        self._profiles.arrived.connect(self._take_profile)
        self._ahead = LatestOnly("seam-inspector-ahead", self)
        self._ahead.arrived.connect(self._take_ahead)
        self.useless: PixelWindow | None = None  # the window under the mouse, where nothing can be compared
        for worker in (self._curves, self._profiles, self._ahead):
            worker.failed.connect(self.failed)
        self._rest = single_shot(self, self._measure_ahead, _REST_MS)
        self._idle = single_shot(self, self.let_go, _IDLE_MS)

    def hover(self, window: PixelWindow, is_live: bool) -> None:
        """The window under the mouse; ``is_live`` when its curves are to be seen while it moves."""
        if window == self._hovered and (self.current is not None or not is_live):
            return
        self._hovered = window
        self._rest.start()
        self.stay_open()
        if is_live:
            request = self._request(window)
            if request is not None:
                self._curves.ask(partial(read_live, request, self._lanes))
        elif self.current is not None:
            self._stop()

    def leave(self) -> None:
        """The mouse is elsewhere."""
        self._rest.stop()
        self._hovered = None
        self._stop()

    def stay_open(self, *_: object) -> None:
        """Somebody is at work: the files are used for a while longer."""
        self._idle.start()

    def let_go(self) -> None:
        """Close all files and forget their pixels: what they hold may change."""
        self._idle.stop()
        self._ahead.forget()
        self.measure.forget()
        self._lanes.let_go()

    def close(self) -> None:
        """Nothing is measured any more."""
        self.leave()
        for worker in (self._curves, self._profiles, self._ahead):
            worker.close()
        self.let_go()
        self._lanes.close()

    def _stop(self) -> None:
        self._curves.forget()
        self._profiles.forget()
        if self.current is not None:
            self.current = None
            self.changed.emit()

    def _request(self, window: PixelWindow) -> WindowRequest | None:
        block = self._block.silent()
        if block is None:
            return None
        return window_request(block, _NO_NUMBER, block.mosaic.grid.window_extent(window), self._block.settings())

    def _measure_ahead(self) -> None:
        request = self._request(self._hovered) if self._hovered is not None else None
        if request is not None:
            self._ahead.ask(lambda: (request.window, self.measure(request)))

    def _take_ahead(self, ahead: tuple[PixelWindow, Measured]) -> None:
        window, measured = ahead
        useless = None if isinstance(measured, MeasuredWindow) and measured.is_explicable else window
        if useless != self.useless:
            self.useless = useless
            self.changed.emit()

    def _take_pixels(self, pixels: MeasuredWindow) -> None:
        window, before = pixels.request.window, self.current
        assert window is not None
        profile = before.profile if before is not None else None
        self.current = LiveWindow(window, pixels.result, profile)
        self._profiles.ask(lambda: (live_profile(pixels),))
        self.changed.emit()

    def _take_profile(self, profiles: tuple[SeamProfile | None]) -> None:
        if self.current is not None:
            self.current = replace(self.current, profile=profiles[0])
            self.changed.emit()
