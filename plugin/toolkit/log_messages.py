"""QGIS's log messages: for what is too long for the message bar."""
from __future__ import annotations

from collections.abc import Iterable

from qgis.core import Qgis, QgsMessageLog

from ..imagery.message import Message
from .translation import sentence, tr


def write_log(notes: Iterable[Message]) -> None:
    """One line each, on the plugin's own page, without a notice in the message bar."""
    for note in notes:
        QgsMessageLog.logMessage(sentence(note), tr("Seam Inspector"), Qgis.MessageLevel.Info, False)
