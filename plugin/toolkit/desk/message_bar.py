"""Messages of the desk in QGIS's message bar, some with a button to go on with, and many in its log."""
from __future__ import annotations

from collections.abc import Callable, Iterable
from html import escape

from qgis.core import Qgis, QgsMessageLog, QgsProject
from qgis.gui import QgsMessageBar, QgsMessageBarItem
from qgis.PyQt import sip
from qgis.PyQt.QtCore import QObject
from qgis.PyQt.QtWidgets import QPushButton

from ...imagery.errors import Level, Message
from ..translation import sentence, tr
from .widgets import plain_tip

_LEVELS = {
    Level.INFO: Qgis.MessageLevel.Success,  # the bar is told of what was done, never of a mere fact
    Level.WARNING: Qgis.MessageLevel.Warning,
    Level.ERROR: Qgis.MessageLevel.Critical,
}


def bar_level(message: Message) -> int:
    """The Qgis.MessageLevel of a message in the message bar."""
    return int(_LEVELS[message.level])


def write_log(messages: Iterable[Message]) -> None:
    """Write a line each to the plugin's page of the log, without a notice in the message bar. The page is rich text."""
    for message in messages:
        text = escape(sentence(message), quote=False)
        QgsMessageLog.logMessage(text, tr("Seam Inspector"), _LEVELS[message.level], False)


_MOST_CHARACTERS = 90  # QGIS cuts what is longer than a line, beside a map of 1,366 px with two docks


def brief_words(text: str) -> tuple[str, str]:
    """What of a message stands in the bar: all of it, or whole sentences, or as many words as there is room for; and
    the rest."""
    if len(text) <= _MOST_CHARACTERS:
        return text, ""
    ends = [place + 1 for place in range(_MOST_CHARACTERS) if text[place : place + 2] in (". ", "? ", "! ")]
    end = ends[-1] if ends else max(text.rfind(" ", 0, _MOST_CHARACTERS), 0) or _MOST_CHARACTERS
    return text[:end] + ("" if ends else " …"), text[end:].lstrip()


class BarQuestion(QObject):
    """A question in the message bar, one at a time, until it is answered or dismissed, or the project closes."""

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

    @property
    def is_asking(self) -> bool:
        """Whether it is neither answered nor dismissed."""
        return self._item is not None and not sip.isdeleted(self._item)

    def close(self) -> None:
        """Dismiss the question and follow the project no more."""
        QgsProject.instance().cleared.disconnect(self.dismiss)
        self.dismiss()

    def dismiss(self) -> None:
        """Leave nothing in the bar."""
        if self.is_asking:
            self._bar.popWidget(self._item)
        self._item = None

    def _answer(self) -> None:
        self.dismiss()
        if self._go_on is not None:
            self._go_on()
