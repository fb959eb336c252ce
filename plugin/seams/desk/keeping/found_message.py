"""Windows that a project lacks, in QGIS's message bar, with the button that opens them."""
from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Callable

from qgis.core import Qgis
from qgis.gui import QgsMessageBar
from qgis.PyQt.QtCore import QObject

from ....imagery.errors import Message
from ....toolkit.desk.message_bar import BarQuestion
from ....toolkit.translation import sentence, tr


class FoundMessage(BarQuestion):
    """Offers each file once, since who dismisses it has seen where it is."""

    def __init__(self, bar: QgsMessageBar, open_windows: Callable[[Path], None], parent: QObject) -> None:
        super().__init__(bar, parent)
        self._open = open_windows
        self._offered: set[Path] = set()

    def show(self, path: Path, message: Message) -> None:
        """Say where they are."""
        if path not in self._offered:
            self._offered.add(path)
            self.ask(
                sentence(message), Qgis.MessageLevel.Warning, tr("Open the windows"),
                tr("Adds the layer of these windows and brings back what was not saved."), partial(self._go, path),
            )  # fmt: skip

    def _go(self, path: Path) -> None:
        self._offered.discard(path)  # the project may be left without saving once more
        self._open(path)
