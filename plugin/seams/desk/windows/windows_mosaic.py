"""The mosaic that the windows of a layer are of: another one would take over what was judged and measured there."""
from __future__ import annotations

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import SeamInspectorError
from ....imagery.rasters import RasterRef
from ....toolkit import layers
from ....toolkit.reference_systems import known_system
from ...tables import window_file
from ...tables.window_file import KnownMosaic
from .. import messages
from ..inputs.block_cache import BlockCache
from .window_watch import WindowWatch


class WindowsMosaic(QObject):
    """Mosaic of every windows file followed, which says itself what that is."""

    doubted = pyqtSignal(object)
    """The Message why nothing goes on with these windows and this mosaic; once for each two of them."""

    notified = pyqtSignal(object)  # the Message why the file can't say it

    def __init__(self, block: BlockCache, watch: WindowWatch, parent: QObject) -> None:
        super().__init__(parent)
        self._block, self._watch = block, watch
        self._known: dict[str, KnownMosaic | None] = {}  # by the layer's id
        self._asked: tuple[str, KnownMosaic] | None = None

    def note(self) -> None:
        """Something is measured or judged in the present mosaic."""
        if self._of_layer() is None:
            self.take()

    def take(self) -> None:
        """The windows are of the present mosaic, whatever they were of."""
        layer, now = self._watch.layer, self._block.known_mosaic()
        if layer is None or now is None:
            return
        self._known[layer.id()] = now
        self._block.doubt = None
        if self._watch.path is not None:
            try:
                window_file.note_mosaic(self._watch.path, now)
            except SeamInspectorError as error:
                self.notified.emit(error.message)

    def check(self) -> None:
        """The windows or the mosaic are others than before."""
        self._block.doubt = None
        layer, now, before = self._watch.layer, self._block.known_mosaic(), self._of_layer()
        block = self._block.silent()
        if layer is not None and block is not None:
            system = known_system(layer.crs())
            if not system.isValid() or not layer.crs().toWkt():  # else the map goes nowhere while keys judge
                layer.setCrs(system if system.isValid() else layers.mosaic_crs(block.mosaic))
        if layer is None or now is None or before is None or before == now:
            return
        if before.content == now.content or not self._holds_something():
            self.take()
            return
        names = RasterRef(before.path).name, RasterRef(now.path).name
        if names[0] == names[1]:
            names = before.path, now.path
        message = messages.WINDOWS_OF_ANOTHER_MOSAIC(name=layer.name(), older=names[0], newer=names[1])
        if before.path == now.path:
            message = messages.MOSAIC_IS_ANOTHER_NOW(name=layer.name(), mosaic=names[1])
        self._block.doubt = message
        if (layer.id(), now) != self._asked:
            self._asked = layer.id(), now
            self.doubted.emit(message)

    def _of_layer(self) -> KnownMosaic | None:
        """What its windows are known to be of."""
        layer, path = self._watch.layer, self._watch.path
        if layer is None or path is None:
            return None
        if layer.id() not in self._known:
            self._known[layer.id()] = window_file.known_mosaic(path)
        return self._known[layer.id()]

    def _holds_something(self) -> bool:
        return any(row.verdict or row.observer or row.observer_2 for row in self._watch.rows())
