"""Whether the pictures of lost detail are shown: one switch for the map and the images."""
from __future__ import annotations

from qgis.PyQt.QtCore import QObject, pyqtSignal


class LossView(QObject):
    """Off at first."""

    changed = pyqtSignal(bool)
    """Shown or not from now on."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._is_shown = False

    @property
    def is_shown(self) -> bool:
        """Whether lost detail is painted over map and images."""
        return self._is_shown

    def show(self, is_shown: bool) -> None:
        """Show it, or hide it."""
        if is_shown != self._is_shown:
            self._is_shown = is_shown
            self.changed.emit(is_shown)

    def toggle(self) -> None:
        """The other of the two."""
        self.show(not self._is_shown)
