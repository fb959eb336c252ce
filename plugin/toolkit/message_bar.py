"""What the desk tells: messages in QGIS's message bar, and in its log where they are too many for the bar."""
from __future__ import annotations

from collections.abc import Iterable
from html import escape

from qgis.core import Qgis, QgsMessageLog

from ..imagery.errors import Level, Message
from .translation import sentence, tr

_LEVELS = {
    Level.INFO: Qgis.MessageLevel.Success,  # the bar is told of what was done, never of a mere fact
    Level.WARNING: Qgis.MessageLevel.Warning,
    Level.ERROR: Qgis.MessageLevel.Critical,
}


def bar_level(message: Message) -> int:
    """The Qgis.MessageLevel of a message in the message bar."""
    return int(_LEVELS[message.level])


def write_log(messages: Iterable[Message]) -> None:
    """One line each, on the plugin's own page, without a notice in the message bar. The page is rich text."""
    for message in messages:
        text = escape(sentence(message), quote=False)
        QgsMessageLog.logMessage(text, tr("Seam Inspector"), _LEVELS[message.level], False)
