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


CUT = " …"
_BUTTON = 13  # characters that it takes, by which the rest is shown


def brief_words(text: str, most: int) -> tuple[str, str]:
    """The words of a message for which a line of so many characters has room, whole sentences where they have; and the
    rest, whose button takes room, too."""
    if len(text) <= most:
        return text, ""
    room = max(most - _BUTTON, _BUTTON)
    ends = [place + 1 for place in range(room) if text[place : place + 2] in (". ", "? ", "! ")]
    end = max(ends, default=0) or max(text.rfind(" ", 0, room), 0) or room
    return text[:end] + ("" if ends else CUT), text[end:].lstrip()
