"""Tasks under way: started, followed, stopped; their results handed to whoever asked, in the interface's thread."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

from qgis.core import QgsApplication
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...imagery.errors import Message
from ..background_task import Ahead, BackgroundTask, Job, Outcome


@dataclass(frozen=True)
class _Request:
    take: Callable[[object], None]
    """Gets each result."""
    key: object
    """What the task is for, so that nothing is asked for twice."""
    steps: int
    """How many results count in the progress, those that come ahead left out; 0 for work that goes unseen, about which
    QGIS does not ask when it closes."""


class BackgroundTasks(QObject):
    """Keeps every task until it has ended, or QGIS would run one whose Python half is gone."""

    progressChanged = pyqtSignal(int, int)
    """Steps done and asked for; (0, 0) when all is done."""
    failed = pyqtSignal(object)
    """The Message of a task that failed."""
    ended = pyqtSignal(object, object)
    """The key of a task, and its Outcome."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._tasks: dict[BackgroundTask, _Request | None] = {}  # None: nobody waits for its results any more
        self._done = self._asked = 0

    @property
    def is_busy(self) -> bool:
        """Whether a task that counts is under way."""
        return self._asked > 0

    def is_under_way(self, key: object) -> bool:
        """Whether there is a task for this already, and not a cancelled one."""
        return any(
            request is not None and request.key == key and not task.isCanceled()
            for task, request in self._tasks.items()
        )

    def start(
        self, description: str, job: Job, take: Callable[[object], None], key: object = None, steps: int = 0
    ) -> None:
        """Run a job in a task; ``take`` gets each of its results."""
        task = BackgroundTask(description, job, is_unseen=not steps)
        task.arrived.connect(self._arrived)
        task.ended.connect(self._ended)
        self._tasks[task] = _Request(take, key, steps)
        self._asked += steps
        if steps:
            self.progressChanged.emit(self._done, self._asked)
        QgsApplication.taskManager().addTask(task)

    def cancel_others(self, keys: set[object]) -> None:
        """Cancel the unseen work that nobody waits for any more."""
        for task, request in list(self._tasks.items()):
            if request is not None and not request.steps and request.key is not None and request.key not in keys:
                task.cancel()

    def stop(self) -> None:
        """Cancel the work that counts; results that have arrived, or are about to, stay."""
        for task, request in list(self._tasks.items()):
            if request is not None and request.steps:
                task.cancel()

    def abandon(self) -> None:
        """Cancel everything; what still arrives is of layers that may be gone and reaches nobody."""
        self._tasks = dict.fromkeys(self._tasks)
        for task in list(self._tasks):
            task.cancel()
        self._settle()

    def close(self) -> None:
        """Cancel everything and listen no more."""
        for task in list(self._tasks):
            task.arrived.disconnect(self._arrived)
            task.ended.disconnect(self._ended)
            task.cancel()
        self._tasks.clear()
        self._done = self._asked = 0

    def _arrived(self, result: object) -> None:
        task = self.sender()
        request = self._tasks.get(task)
        if request is None or (task.isCanceled() and not request.steps):  # what was cancelled midway is not whole
            return
        if isinstance(result, Ahead):
            request.take(result.result)
            return
        request.take(result)
        if request.steps and self._asked:
            self._done += 1
            self.progressChanged.emit(self._done, self._asked)

    def _ended(self, outcome: Outcome) -> None:
        request = self._tasks.pop(self.sender(), None)
        if request is None:
            return
        if isinstance(outcome.message, Message):
            self.failed.emit(outcome.message)
        if request.steps:
            self._settle()
        self.ended.emit(request.key, outcome)

    def _settle(self) -> None:
        """Idle again once nothing that counts is under way."""
        if self._asked and not any(request is not None and request.steps for request in self._tasks.values()):
            self._done = self._asked = 0
            self.progressChanged.emit(0, 0)
