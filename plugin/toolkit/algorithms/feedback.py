"""What an algorithm tells while it runs: messages in QGIS's log of the run, each by its level."""
from __future__ import annotations

from collections.abc import Iterable

from qgis.core import QgsProcessingFeedback

from ...imagery.message import Level, Message
from ..translation import sentence


def tell(feedback: QgsProcessingFeedback, *messages: Message) -> None:
    """Tell messages as information, warnings or errors; the run goes on."""
    push = {Level.INFO: feedback.pushInfo, Level.WARNING: feedback.pushWarning, Level.ERROR: feedback.reportError}
    for message in messages:
        push[message.level](sentence(message))


class TellOnce:
    """Tells each sentence once: a raster that can't be compared is not named in every window."""

    def __init__(self, feedback: QgsProcessingFeedback) -> None:
        self._feedback = feedback
        self._told: set[str] = set()

    def tell(self, messages: Iterable[Message]) -> None:
        """Tell those that were not told before."""
        for message in messages:
            if (text := str(message)) not in self._told:
                tell(self._feedback, message)
            self._told.add(text)
