"""The hard cut in place of the mosaic, on the map itself: as long as a key is held, or from one tap to the next."""
from __future__ import annotations

from typing import TYPE_CHECKING

from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import Message
from ....toolkit.connections import Connections
from ....toolkit.desk.message_bar import bar_level
from ....toolkit.desk.widgets import single_shot
from ....toolkit.translation import sentence, tr
from .swipe_action import Swipe, compare
from .swiped_layer import SwipeChoice

if TYPE_CHECKING:
    from ..session import Session

_HELD_S = 0.3  # a key that is let go of sooner was tapped
_REST_MS = 400  # on a window, before its hard cut is made ready: those that are passed by are not waited for


class Flicker(QObject):
    """Once it was asked for, the hard cut of each window that is gone to lies ready."""

    told = pyqtSignal(str, int)
    """A sentence for the user, and its level in the message bar."""

    def __init__(self, canvas: QgsMapCanvas, session: Session, parent: QObject) -> None:
        super().__init__(parent)
        self._session = session
        self.swipe = Swipe(canvas, self, has_handle=False)
        self.swipe.failed.connect(self._tell)
        self._preparer = single_shot(self, self._prepare, _REST_MS)
        self._connections = Connections((session.selectionChanged, self.hide), (session.inputsChanged, self._renew))

    def close(self) -> None:
        """Leave nothing on the map."""
        self._connections.close()
        self._preparer.stop()
        self.swipe.close()

    def press(self) -> bool:
        """Show it, or take it off where it stayed. Whether there is a window whose hard cut can be shown."""
        if self.swipe.is_shown:
            self.swipe.show(False)
            return True
        self.swipe.show(True)
        return self._prepare()

    def release(self, seconds: float) -> None:
        """It stays where the key was but tapped."""
        if seconds >= _HELD_S:
            self.swipe.show(False)

    def hide(self, *_: object) -> None:
        """What is judged is the mosaic: another window begins with it."""
        self.swipe.show(False)
        if self.swipe.is_on:
            self._preparer.start()

    def _renew(self) -> None:
        """There may be another mosaic, or none any more, as in a new project."""
        if self.swipe.is_on:
            self._prepare()

    def _prepare(self) -> bool:
        selected = self._session.selected()
        request = self._session.request(selected[0]) if len(selected) == 1 else None
        if request is None or request.window is None or not request.sources:
            self.swipe.show(False)
            self.swipe.stop()
            return False
        compare(self._session, self.swipe, SwipeChoice(tr("hard cut of the sources"), request=request))
        return True

    def _tell(self, message: Message) -> None:
        self.swipe.show(False)
        self.told.emit(sentence(message), bar_level(message))
