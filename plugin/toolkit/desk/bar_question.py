"""A message in QGIS's message bar with a button that goes on from there."""
from __future__ import annotations

from collections.abc import Callable
from html import escape

from qgis.core import Qgis, QgsProject
from qgis.gui import QgsMessageBar, QgsMessageBarItem
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtWidgets import QPushButton

from ..translation import tr
from .tooltips import plain_tip


class BarQuestion(QObject):
    """One at a time; it stays until it is answered or dismissed, or the project is closed."""

    def __init__(self, bar: QgsMessageBar, parent: QObject) -> None:
        super().__init__(parent)
        self._bar = bar
        self._item: QgsMessageBarItem | None = None
        self._go_on: Callable[[], None] | None = None
        QgsProject.instance().cleared.connect(self.dismiss)

    def ask(
        self, text: str, level: Qgis.MessageLevel, words: str = "", tip: str = "",
        go_on: Callable[[], None] | None = None,
    ) -> None:
        """Say it, with a button of these words where there is something to go on with."""
        self.dismiss()
        item = self._bar.createMessage(tr("Seam Inspector"), escape(text, quote=False))
        if go_on is not None:
            button = QPushButton(words, item)
            button.setToolTip(plain_tip(tip))
            button.clicked.connect(self._answer)
            item.layout().addWidget(button)
        self._item, self._go_on = item, go_on
        self._bar.pushWidget(item, level, 0)

    def close(self) -> None:
        """Leave nothing behind."""
        QgsProject.instance().cleared.disconnect(self.dismiss)
        self.dismiss()

    def dismiss(self) -> None:
        """Leave nothing in the bar."""
        item, self._item = self._item, None
        if item is not None and not sip.isdeleted(item):
            self._bar.popWidget(item)

    def _answer(self) -> None:
        self.dismiss()
        if self._go_on is not None:
            self._go_on()
