"""Work for a picture that follows the mouse: what was asked for last is done, what was overtaken is not."""
from __future__ import annotations

import time
from concurrent.futures import ThreadPoolExecutor
from threading import Lock
from typing import Any, Callable

from qgis.PyQt.QtCore import QObject, pyqtSignal

from ...imagery.errors import Message
from .. import messages
from ..interface_first import interface_first

_LONGEST_REST_S = 0.5
Work = Callable[[], Any]


class LatestOnly(QObject):
    """A thread that does one thing at a time; a newer request takes the place of the one that waits."""

    arrived = pyqtSignal(object)
    """What was found, in the interface's thread; nothing comes of what was asked before ``forget``."""
    failed = pyqtSignal(object)
    """The Message of what failed in a way that nobody foresaw."""
    _ended = pyqtSignal(int, object)

    def __init__(self, name: str, parent: QObject | None = None, rest: float = 0.0) -> None:
        """``rest``: how long the thread rests after each piece of work, as a multiple of the time that took."""
        super().__init__(parent)
        self._rest = rest
        self._name = name
        self._thread = ThreadPoolExecutor(1, name)
        self._lock = Lock()
        self._waiting: Work | None = None
        self._is_at_work = False
        self._turn = 0
        self._ended.connect(self._take)

    def ask(self, work: Work) -> None:
        """Have this done next; its result is told unless it is None."""
        with self._lock:
            self._waiting = work
            if not self._is_at_work:
                self._is_at_work = True
                self._thread.submit(self._run)

    def forget(self) -> None:
        """Nobody waits for anything any more."""
        with self._lock:
            self._waiting = None
            self._turn += 1

    def close(self) -> None:
        """No more work; what is under way reaches nobody."""
        self.forget()
        self._thread.shutdown(wait=False)

    def _run(self) -> None:
        while True:
            with self._lock:
                work, self._waiting, turn = self._waiting, None, self._turn
                if work is None:
                    self._is_at_work = False
                    return
            begun = time.perf_counter()
            try:
                with interface_first():
                    found = work()
            except Exception as error:  # the last door: nobody else would learn of it
                found = messages.TASK_FAILED(task=self._name, error=f"{type(error).__name__}: {error}")
            with self._lock:  # after ``close`` this may be gone
                if turn == self._turn and found is not None:
                    self._ended.emit(turn, found)
            time.sleep(min(self._rest * (time.perf_counter() - begun), _LONGEST_REST_S))

    def _take(self, turn: int, found: object) -> None:
        if turn == self._turn:
            (self.failed if isinstance(found, Message) else self.arrived).emit(found)
