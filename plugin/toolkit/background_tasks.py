"""Work in the background: QgsTasks, started, followed and stopped, whose results come in the interface's thread."""
from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from threading import Lock
from typing import Any, Callable, ClassVar, NamedTuple

from qgis.core import QgsApplication, QgsTask
from qgis.PyQt.QtCore import QObject, pyqtSignal

from ..imagery.errors import CancelledError, Message, SeamInspectorError
from . import messages
from .version_differences import SILENT_TASK

SWITCH_INTERVAL_S = 0.0005
"""Time in which threads hand Python's interpreter over, not the usual 5 ms: the interface asks for it many times while
it handles one event (each call of a method that we override is one), and would wait as many times."""
Cancelled = Callable[[], bool]
Job = Callable[[Cancelled], Iterator[tuple[float, object]]]


class Ahead(NamedTuple):
    """A result that comes ahead of one that counts as a step."""

    result: object


class Outcome(NamedTuple):
    """The end of a task; a cancelled one did not fail."""

    failure: Message | None
    is_cancelled: bool


class BackgroundTask(QgsTask):
    """Runs a job. Keep a reference until it has ended, or it is collected before it runs."""

    described: ClassVar[set[str]] = set()  # all descriptions, by which QGIS tells of a task
    arrived = pyqtSignal(object)
    ended = pyqtSignal(object)

    def __init__(
        self, description: str, job: Job, take: Callable[[object], None] | None = None, key: object = None,
        steps: int = 0,
    ) -> None:  # fmt: skip
        """``take``: gets each result; None once nobody waits for them any more. ``key``: what the task is for, so that
        nothing is asked for twice. ``steps``: how many results count in the progress, those that come ahead left out; 0
        for work that goes unseen, about which QGIS does not ask when it closes.
        """
        flags = QgsTask.Flag.CanCancel
        if not steps:
            flags |= QgsTask.Flag.CancelWithoutPrompt
        super().__init__(description, flags if SILENT_TASK is None else flags | SILENT_TASK)
        self.described.add(description)
        self.take, self.key, self.steps = take, key, steps
        self._job = job
        self._failure: Message | None = None

    def run(self) -> bool:
        try:
            for share, result in self._job(self.isCanceled):
                self.arrived.emit(result)
                self.setProgress(100 * share)
        except CancelledError:
            pass  # as ``finished`` tells
        except SeamInspectorError as error:
            self._failure = error.message
        except Exception as error:  # the last door: a task must not raise into QGIS
            self._failure = messages.TASK_FAILED(task=self.description(), error=f"{type(error).__name__}: {error}")
        return True  # QGIS would say of anything else that it failed, over what we say of it

    def finished(self, result: bool) -> None:
        is_cancelled = self._failure is None and (self.isCanceled() or not result)
        self.ended.emit(Outcome(self._failure, is_cancelled))


class BackgroundTasks(QObject):
    """Keeps every task until it has ended, or QGIS would run one whose Python half is gone."""

    progressChanged = pyqtSignal(int, int)  # steps done and asked for; (0, 0) when all is done
    failed = pyqtSignal(object)  # the Message of a task that failed
    ended = pyqtSignal(object, object)  # the key of a task, and its Outcome

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        sys.setswitchinterval(SWITCH_INTERVAL_S)
        self._tasks: list[BackgroundTask] = []
        self._done = self._asked = 0

    @property
    def is_busy(self) -> bool:
        """Whether a task that counts is under way."""
        return self._asked > 0

    def is_under_way(self, key: object) -> bool:
        """Whether there is a task for this already, and not a cancelled one."""
        return any(task.take is not None and task.key == key and not task.isCanceled() for task in self._tasks)

    def start(
        self, description: str, job: Job, take: Callable[[object], None], key: object = None, steps: int = 0
    ) -> None:
        """Run a job in a task; the arguments as there."""
        task = BackgroundTask(description, job, take, key, steps)
        task.arrived.connect(self._arrived)
        task.ended.connect(self._ended)
        self._tasks.append(task)
        self._asked += steps
        if steps:
            self.progressChanged.emit(self._done, self._asked)
        QgsApplication.taskManager().addTask(task)

    def cancel_others(self, keys: set[object]) -> None:
        """Cancel the unseen work that nobody waits for any more."""
        for task in list(self._tasks):
            if task.take is not None and not task.steps and task.key is not None and task.key not in keys:
                task.cancel()

    def stop(self) -> None:
        """Cancel the work that counts; results that have arrived, or are about to, stay."""
        for task in list(self._tasks):
            if task.take is not None and task.steps:
                task.cancel()

    def abandon(self) -> None:
        """Cancel everything; what still arrives is of layers that may be gone and reaches nobody."""
        for task in self._tasks:
            task.take = None
        for task in list(self._tasks):
            task.cancel()
        self._settle()

    def close(self) -> None:
        """Cancel everything and tell nothing any more."""
        self.blockSignals(True)
        self.abandon()

    def _arrived(self, result: object) -> None:
        task = self.sender()
        if task.take is None or (task.isCanceled() and not task.steps):  # what was cancelled midway is not whole
            return
        if isinstance(result, Ahead):
            task.take(result.result)
            return
        task.take(result)
        if task.steps and self._asked:
            self._done += 1
            self.progressChanged.emit(self._done, self._asked)

    def _ended(self, outcome: Outcome) -> None:
        task = self.sender()
        self._tasks = [other for other in self._tasks if other is not task]
        if task.take is None:
            return
        if outcome.failure is not None:
            self.failed.emit(outcome.failure)
        if task.steps:
            self._settle()
        self.ended.emit(task.key, outcome)

    def _settle(self) -> None:
        """Idle again once nothing that counts is under way."""
        if self._asked and not any(task.take is not None and task.steps for task in self._tasks):
            self._done = self._asked = 0
            self.progressChanged.emit(0, 0)


_LONGEST_REST_S = 0.5
Work = Callable[[], Any]


class LatestOnly(QObject):
    """A thread that does one thing at a time; a newer request takes the place of the one that waits."""

    arrived = pyqtSignal(object)
    """What was found, in the interface's thread; nothing comes of what was asked before ``forget``."""
    failed = pyqtSignal(object)  # the Message of what failed in a way that nobody foresaw
    _ended = pyqtSignal(int, object)

    def __init__(self, name: str, parent: QObject | None = None, rest: float = 0.0) -> None:
        """``rest``: how long the thread rests after each piece of work, as a multiple of the time that took."""
        super().__init__(parent)
        self._name, self._rest = name, rest
        self._thread = ThreadPoolExecutor(1, name)
        self._lock = Lock()
        self._waiting: Future[None] | None = None
        self._turn = 0
        self._ended.connect(self._take)

    def ask(self, work: Work) -> None:
        """Have this done next; its result is told unless it is None."""
        self._drop_waiting()
        self._waiting = self._thread.submit(self._run, work, self._turn)

    def forget(self) -> None:
        """Drop the work that waits, and the result of what is under way."""
        self._drop_waiting()
        with self._lock:
            self._turn += 1

    def close(self) -> None:
        """Take no more work; drop the result of what is under way."""
        self.forget()
        self._thread.shutdown(wait=False)

    def _drop_waiting(self) -> None:
        if self._waiting is not None:
            self._waiting.cancel()

    def _run(self, work: Work, turn: int) -> None:
        begun = time.perf_counter()
        try:
            outcome = work()
        except Exception as error:  # the last door: nobody else would learn of it
            outcome = messages.TASK_FAILED(task=self._name, error=f"{type(error).__name__}: {error}")
        with self._lock:  # after ``close`` this may be gone
            if turn == self._turn and outcome is not None:
                self._ended.emit(turn, outcome)
        time.sleep(min(self._rest * (time.perf_counter() - begun), _LONGEST_REST_S))

    def _take(self, turn: int, outcome: object) -> None:
        if turn == self._turn:
            (self.failed if isinstance(outcome, Message) else self.arrived).emit(outcome)
