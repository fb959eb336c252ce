"""The hard cut in place of the mosaic, on the map itself: as long as a key is held, or from one tap to the next."""
from __future__ import annotations

import time
from typing import TYPE_CHECKING

from qgis.gui import QgsMapCanvas
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ....imagery.errors import Message
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
        self._since: float | None = None  # when the key that shows it now was pressed
        self._preparer = single_shot(self, self._prepare, _REST_MS)
        session.selectionChanged.connect(self._follow)

    def close(self) -> None:
        """Leave nothing on the map."""
        self._session.selectionChanged.disconnect(self._follow)
        self._preparer.stop()
        self.swipe.close()

    def press(self) -> bool:
        """Show it, or take it off where it stayed. Whether there is a window whose hard cut can be shown."""
        if self.swipe.is_shown:
            self.swipe.show(False)
            self._since = None
            return True
        self._since = time.monotonic()
        self.swipe.show(True)
        return self._prepare()

    def release(self) -> None:
        """It stays where the key was but tapped."""
        since, self._since = self._since, None
        if since is not None and time.monotonic() - since >= _HELD_S:
            self.swipe.show(False)

    def _follow(self) -> None:
        """What is judged is the mosaic: another window begins with it."""
        self.swipe.show(False)
        self._since = None
        if self.swipe.is_on:
            self._preparer.start()

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
