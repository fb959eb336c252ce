"""What all map tools of the docks have in common: they draw, follow the canvas's keys, and leave nothing on it."""
from __future__ import annotations

from qgis.gui import QgsMapCanvas, QgsMapTool
from qgis.PyQt.QtCore import QPoint, Qt, pyqtSignal
from qgis.PyQt.QtGui import QKeyEvent
from qgis.PyQt.QtWidgets import QApplication


class DrawingTool(QgsMapTool):
    """A cross for a cursor, and the canvas's keys for as long as the tool is in use."""

    finished = pyqtSignal()
    """The operator is done; whoever set this tool restores the previous one."""

    def __init__(self, canvas: QgsMapCanvas) -> None:
        super().__init__(canvas)
        self._active = False
        self.previous: QgsMapTool | None = None  # the canvas's before this one; never another of ours
        self.setCursor(Qt.CursorShape.CrossCursor)

    def close(self) -> None:
        """Leave the canvas as if the tool had never been there. It can't be used afterwards."""
        self.canvas().unsetMapTool(self)
        self.deleteLater()

    def activate(self) -> None:
        super().activate()
        if not self._active:
            self._active = True
            self._listen()

    def deactivate(self) -> None:
        if self._active:
            self._active = False
            self._listen_no_more()
        self._clear()
        super().deactivate()

    def _listen(self) -> None:
        # While a button is down the canvas hands keys to nobody but the listeners of its signals.
        self.canvas().keyPressed.connect(self._key_pressed)

    def _listen_no_more(self) -> None:
        self.canvas().keyPressed.disconnect(self._key_pressed)

    def _key_pressed(self, event: QKeyEvent) -> None:
        raise NotImplementedError

    def _clear(self) -> None:
        """Give up what is being drawn and take it off the canvas."""
        raise NotImplementedError


def is_drag(start: QPoint, end: QPoint) -> bool:
    """Whether the mouse moved too far, in screen pixels, for a click."""
    return (end - start).manhattanLength() > QApplication.startDragDistance()
