"""Work in the background: one QgsTask for every job."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum
from typing import Callable, NamedTuple

from qgis.core import QgsTask
from qgis.PyQt.QtCore import pyqtSignal

from ..imagery.errors import Message, SeamInspectorError
from . import messages
from .interface_first import interface_first
from .quiet_tasks import hush_end
from .version_differences import SILENT_TASK

Cancelled = Callable[[], bool]
Job = Callable[[Cancelled], Iterator[tuple[float, object]]]


class Ahead(NamedTuple):
    """What a job yields ahead of a result that counts as a step."""

    result: object


class End(Enum):
    """How a task ended; a cancelled one did not fail."""

    DONE = "done"
    FAILED = "failed"
    CANCELLED = "cancelled"


@dataclass(frozen=True)
class Outcome:
    """What the interface learns when a task has ended."""

    end: End
    message: Message | None = None
    """Why it failed."""


class BackgroundTask(QgsTask):
    """Runs a job. Keep a reference until it has ended, or it is collected before it runs."""

    arrived = pyqtSignal(object)
    ended = pyqtSignal(object)

    def __init__(self, description: str, job: Job, is_unseen: bool = False) -> None:
        """``is_unseen``: nothing that the user would miss, so that QGIS need not ask before it closes."""
        flags = QgsTask.Flag.CanCancel
        if is_unseen:
            flags |= QgsTask.Flag.CancelWithoutPrompt
        super().__init__(description, flags if SILENT_TASK is None else flags | SILENT_TASK)
        self._job = job
        self._failure: Message | None = None

    def run(self) -> bool:
        try:
            with interface_first():
                for share, result in self._job(self.isCanceled):
                    self.arrived.emit(result)
                    self.setProgress(100 * share)
        except SeamInspectorError as error:
            self._failure = error.message
        except Exception as error:  # the last door: a task must not raise into QGIS
            self._failure = messages.TASK_FAILED(task=self.description(), error=f"{type(error).__name__}: {error}")
        return True  # QGIS would say of anything else that it failed, over what we say of it

    def finished(self, result: bool) -> None:
        hush_end()
        if self._failure is not None:
            self.ended.emit(Outcome(End.FAILED, self._failure))
        elif self.isCanceled() or not result:
            self.ended.emit(Outcome(End.CANCELLED))
        else:
            self.ended.emit(Outcome(End.DONE))
