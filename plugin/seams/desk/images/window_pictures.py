"""The pictures of windows: read in the background when they are asked for, some of them kept."""
from __future__ import annotations

from collections.abc import Callable
from functools import partial

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....toolkit.background_tasks import BackgroundTasks, End, Job, Outcome
from ....toolkit.picture_stretch import GreyRanges, Stretch
from ....toolkit.translation import tr
from ... import jobs
from ...clip_pictures import ClipPicture, PictureRequest, WindowPictureSet
from ...measure.window.window_request import WindowRequest
from ...measure.window_records import COMPOSITE, WindowRecord
from ..inputs.block_cache import BlockCache
from ..windows.window_watch import WindowWatch

_MOST_BYTES = 256 * 2**20  # of pictures that are kept, for going back and forth

_Look = tuple[Stretch, "int | None"]


class WindowPictures(QObject):
    """Only those asked for last are read; the work for others is cancelled."""

    arrived = pyqtSignal(int)
    """Feature id of a window that has its pictures now, or its composite."""

    def __init__(self, block: BlockCache, watch: WindowWatch, background: BackgroundTasks, parent: QObject) -> None:
        super().__init__(parent)
        self._block = block
        self._watch = watch
        self._background = background
        self._kept: dict[object, WindowPictureSet] = {}
        self._ranges: dict[_Look, GreyRanges] = {}  # the same for all windows
        self._wanted: object = None
        background.ended.connect(self._ended)

    def pictures(self, fid: int) -> tuple[ClipPicture, ...] | None:
        """Those of a window; None while they are being read."""
        row = self._watch.row(fid)
        if row is None:
            return None
        self._wanted = key = self._key(row)
        look = self._look()

        def job(request: WindowRequest) -> Job:
            return jobs.pictures_job(PictureRequest(request, look[0], self._ranges.get(look, {})))

        return self._kept_or_asked(row, key, tr("Read pictures"), job, partial(self._take, key, look))

    def composite(self, fid: int) -> tuple[ClipPicture, ...] | None:
        """The hard-cut composite of a window whose pictures are there; None while it is being made, empty where the
        sources explain nothing."""
        row = self._watch.row(fid)
        shown = self._kept.get(self._key(row)) if row is not None else None
        if row is None or shown is None or not shown.pictures:
            return None
        key = COMPOSITE, self._key(row)
        job = partial(jobs.composite_picture_job, shown=shown)
        return self._kept_or_asked(row, key, tr("Cut the composite"), job, partial(self._take_composite, key))

    def _kept_or_asked(
        self, row: WindowRecord, key: object, title: str, job: Callable[[WindowRequest], Job],
        take: Callable[[object], None],
    ) -> tuple[ClipPicture, ...] | None:
        """The pictures known by a key, else None, and they are being made."""
        block, layer = self._block.silent(), self._watch.layer
        if key not in self._kept and block is not None and layer is not None:
            self._background.cancel_others({key})
            if not self._background.is_under_way(key):
                request = next(self._block.requests(block, layer, [row]))
                self._background.start(title, job(request), take, key)
        if key not in self._kept:
            return None
        self._kept[key] = self._kept.pop(key)  # the last one to go
        return self._kept[key].pictures

    def forget(self) -> None:
        """They are of another layer."""
        self._kept.clear()
        self._ranges.clear()
        self._wanted = None
        self._background.cancel_others(set())

    def _take(self, key: object, look: _Look, made: object) -> None:
        assert isinstance(made, WindowPictureSet)
        row = next((row for row in self._watch.rows() if self._key(row) == key), None)
        if row is not None:
            self._ranges[look] = made.ranges  # those of other windows are made anew when these have grown
            is_wanted, key = key == self._wanted, self._key(row)
            self._wanted = key if is_wanted else self._wanted
        self._keep(key, made)
        if row is not None:  # else it was moved or removed meanwhile
            self.arrived.emit(row.fid)

    def _take_composite(self, key: tuple[str, object], made: object) -> None:
        assert isinstance(made, WindowPictureSet)
        self._keep(key, made)
        row = next((row for row in self._watch.rows() if self._key(row) == key[1]), None)
        if row is not None:
            self.arrived.emit(row.fid)

    def _keep(self, key: object, made: WindowPictureSet) -> None:
        self._kept[key] = made
        sizes = {kept: _size(one.pictures) for kept, one in self._kept.items()}
        while sum(sizes.values()) > _MOST_BYTES and len(sizes) > 1:
            oldest = next(iter(sizes))
            del sizes[oldest], self._kept[oldest]

    def _ended(self, key: object, outcome: Outcome) -> None:
        """Nobody waits in vain for pictures that could not be read."""
        is_awaited = key is not None and key == self._wanted and key not in self._kept
        if is_awaited and not self._background.is_under_way(key):
            look = self._look()
            self._take(key, look, WindowPictureSet((), self._ranges.get(look, {})))
        elif isinstance(key, tuple) and key[0] == COMPOSITE and outcome.end is End.FAILED:
            self._take_composite(key, WindowPictureSet())

    def _key(self, row: WindowRecord) -> tuple[object, ...]:
        """What pictures are of: another place of the same window, or other inputs, make other pictures."""
        look = self._look()
        return row.window_id, row.extent, *look, tuple(self._ranges.get(look, {}).items())

    def _look(self) -> _Look:
        """What is the same for all windows: how grey values are shown, and the inputs that they come from."""
        return Stretch(self._block.inputs.stretch), self._watch.state


def _size(pictures: tuple[ClipPicture, ...]) -> int:
    """Bytes in memory."""
    return sum(pixels.nbytes for picture in pictures for pixels in (picture.pixels, *picture.reduced))
