"""The pictures of windows: read in the background when they are asked for, some of them kept."""
from __future__ import annotations

from functools import partial

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....toolkit.desk.background_tasks import BackgroundTasks
from ....toolkit.translation import tr
from ... import jobs
from ...clip_pictures import ClipPicture, PictureRequest, WindowPictureSet
from ...measure.window_records import WindowRecord
from ...picture_stretch import GreyRanges, Stretch
from ..inputs.block_cache import BlockCache
from ..windows.window_watch import WindowWatch

_MOST_BYTES = 256 * 2**20  # of pictures that are kept, for going back and forth


class WindowPictures(QObject):
    """Only those asked for last are read; the work for others is cancelled."""

    arrived = pyqtSignal(int)
    """Feature id of a window that has its pictures now."""

    def __init__(self, block: BlockCache, watch: WindowWatch, background: BackgroundTasks, parent: QObject) -> None:
        super().__init__(parent)
        self._block = block
        self._watch = watch
        self._background = background
        self._pictures: dict[object, tuple[ClipPicture, ...]] = {}
        self._ranges: dict[object, GreyRanges] = {}  # by stretch and state of the inputs, the same for all windows
        self._wanted: object = None
        background.ended.connect(self._ended)

    def pictures(self, fid: int) -> tuple[ClipPicture, ...] | None:
        """Those of a window; None while they are being read."""
        row = self._watch.row(fid)
        if row is None:
            return None
        self._wanted = key = self._key(row)
        block, layer = self._block.silent(), self._watch.layer
        if key not in self._pictures and block is not None and layer is not None:
            self._background.cancel_others({key})
            if not self._background.is_under_way(key):
                request = next(self._block.requests(block, layer, [row]))
                look = self._look()
                job = jobs.pictures_job(PictureRequest(request, look[0], self._ranges.get(look, {})))
                self._background.start(tr("Read pictures"), job, partial(self._take, key, look), key)
        if key in self._pictures:
            self._pictures[key] = self._pictures.pop(key)  # the last one to go
        return self._pictures.get(key)

    def forget(self) -> None:
        """They are of another layer."""
        self._pictures.clear()
        self._ranges.clear()
        self._wanted = None
        self._background.cancel_others(set())

    def _take(self, key: object, look: tuple[Stretch, int | None], made: object) -> None:
        assert isinstance(made, WindowPictureSet)
        row = next((row for row in self._watch.rows() if self._key(row) == key), None)
        if row is not None:
            self._ranges[look] = made.ranges  # those of other windows are made anew when these have grown
            is_wanted, key = key == self._wanted, self._key(row)
            self._wanted = key if is_wanted else self._wanted
        self._keep(key, made.pictures)
        if row is not None:  # else it was moved or removed meanwhile
            self.arrived.emit(row.fid)

    def _keep(self, key: object, pictures: tuple[ClipPicture, ...]) -> None:
        self._pictures[key] = pictures
        sizes = {kept: _size(made) for kept, made in self._pictures.items()}
        while sum(sizes.values()) > _MOST_BYTES and len(sizes) > 1:
            oldest = next(iter(sizes))
            del sizes[oldest], self._pictures[oldest]

    def _ended(self, key: object, _outcome: object) -> None:
        """Nobody waits in vain for pictures that could not be read."""
        is_awaited = key is not None and key == self._wanted and key not in self._pictures
        if is_awaited and not self._background.is_under_way(key):
            look = self._look()
            self._take(key, look, WindowPictureSet((), self._ranges.get(look, {})))

    def _key(self, row: WindowRecord) -> tuple[object, ...]:
        """What pictures are of: another place of the same window, or other inputs, make other pictures."""
        look = self._look()
        return row.window_id, row.extent, *look, tuple(self._ranges.get(look, {}).items())

    def _look(self) -> tuple[Stretch, int | None]:
        """What is the same for all windows: how grey values are shown, and the inputs that they come from."""
        return Stretch(self._block.inputs.stretch), self._watch.state


def _size(pictures: tuple[ClipPicture, ...]) -> int:
    """Bytes in memory."""
    return sum(pixels.nbytes for picture in pictures for pixels in (picture.pixels, *picture.reduced))
