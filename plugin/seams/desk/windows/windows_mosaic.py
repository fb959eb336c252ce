"""Which mosaic the windows of a layer are of: another one would take over what was judged and measured there."""
from __future__ import annotations

import json
from typing import TYPE_CHECKING

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.documents import json_document
from ....imagery.rasters import RasterRef
from ....toolkit import layers
from ....toolkit.reference_systems import known_system
from .. import messages
from ..inputs.block_cache import BlockCache, KnownMosaic

if TYPE_CHECKING:
    from ..keeping import Keeping
    from .window_watch import WindowWatch

_KEY = "mosaic"  # in the file of results, where windows have their numbers for keys


class WindowsMosaic(QObject):
    """Mosaic of every layer followed: kept with what was measured in its windows, so that it goes where they go."""

    doubted = pyqtSignal(object)
    """The Message why nothing goes on with these windows and this mosaic; once for each two of them."""

    def __init__(self, block: BlockCache, watch: WindowWatch, keeping: Keeping, parent: QObject) -> None:
        super().__init__(parent)
        self._block, self._watch, self._keeping = block, watch, keeping
        self._known: dict[str, KnownMosaic] = {}  # by the layer's id
        self._asked: tuple[str, KnownMosaic] | None = None

    def note(self) -> None:
        """Something is measured or judged in the present mosaic."""
        if self._of_layer() is None:
            self.take()

    def leave(self) -> None:
        """The mosaic may become another: what earlier versions left in the windows is of this one."""
        if self._holds_something():
            self.note()

    def take(self) -> None:
        """The windows are of the present mosaic, whatever they were of."""
        layer, now = self._watch.layer, self._block.known_mosaic()
        if layer is None or now is None:
            return
        self._known[layer.id()] = now
        if (file := self._keeping.results) is not None:
            file.note(_KEY, json.dumps(now).encode())
        self._block.doubt = None

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
        layer, file = self._watch.layer, self._keeping.results
        if layer is None:
            return None
        if layer.id() not in self._known and file is not None and (known := _known(file.noted(_KEY))) is not None:
            self._known[layer.id()] = known
        return self._known.get(layer.id())

    def _holds_something(self) -> bool:
        return any(row.verdict or row.observer or row.observer_2 for row in self._watch.rows())


def _known(noted: bytes | None) -> KnownMosaic | None:
    """None where nothing is noted, and for what somebody else wrote there."""
    try:
        found = json_document(noted or b"null")
    except ValueError:
        return None
    is_ours = isinstance(found, list) and len(found) == 2 and all(isinstance(one, str) for one in found)
    return KnownMosaic(*found) if is_ours else None
