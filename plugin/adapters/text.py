"""Words for the user: translations of our own texts and of the core's messages."""
from __future__ import annotations

from qgis.PyQt.QtCore import QCoreApplication

from ..core.messages import Message


def tr(text: str) -> str:
    """The text in the user's language."""
    return QCoreApplication.translate("@default", text)


def sentence(message: Message) -> str:
    """A message of the core in the user's language."""
    return message.worded(tr)
