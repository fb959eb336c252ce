"""Messages of the desk in QGIS's message bar, and many in its log."""
from __future__ import annotations

from collections.abc import Iterable
from html import escape

from qgis.core import Qgis, QgsMessageLog

from ...imagery.errors import Level, Message
from ..translation import sentence, tr

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


_MOST_CHARACTERS = 90  # QGIS cuts what is longer than a line
_BESIDE_BUTTON = 50  # characters of a line on a screen of 1,366 px with two docks, where a button stands beside them


def brief_words(text: str) -> tuple[str, str]:
    """The words of a message that the bar has room for, whole sentences where there are several; and the rest."""
    ends = [place + 1 for place in range(_MOST_CHARACTERS) if text[place : place + 2] in (". ", "? ", "! ")]
    if len(text) <= (_BESIDE_BUTTON if ends else _MOST_CHARACTERS):
        return text, ""
    last_word = max(text.rfind(" ", 0, _MOST_CHARACTERS), 0) or _MOST_CHARACTERS
    end = max((end for end in ends if end <= _BESIDE_BUTTON), default=ends[0] if ends else last_word)
    return text[:end] + ("" if ends else " …"), text[end:].lstrip()
