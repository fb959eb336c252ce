"""A Dask cluster as an executor that notices when nobody is left to do the work."""
from __future__ import annotations

import time
from concurrent.futures import CancelledError, Executor, Future, InvalidStateError
from threading import Event, Thread
from typing import TYPE_CHECKING, Any, Callable

from ..imagery.errors import Message, WorkersLostError
from . import messages

if TYPE_CHECKING:
    from distributed import Client

PATIENCE_SECONDS = 120.0
"""Without any worker: long enough for those that were lost to be started anew."""
LOOK_SECONDS = 5.0
"""Between two looks at the cluster."""


class WatchedExecutor(Executor):
    """Dask gives the work of a lost worker to others; where none is left for long, all that waits ends with
    WorkersLostError instead of waiting for ever."""

    def __init__(self, client: Client, address: str) -> None:
        """``address`` of the scheduler, for the user."""
        self._client, self._address = client, address
        self._executor = client.get_executor()
        self._waiting: set[Future[Any]] = set()
        self._closed = Event()
        self._watch = Thread(target=self._look, name="seam-inspector-cluster", daemon=True)
        self._watch.start()

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """As any executor does."""
        promised: Future[Any] = Future()
        self._waiting.add(promised)
        under_way = self._executor.submit(fn, *args, **kwargs)

        def settle(done: Future[Any]) -> None:
            try:
                error = done.exception()
            except CancelledError:  # by us, in which case nobody asks any more; else the scheduler is gone
                error = WorkersLostError(messages.SCHEDULER_LOST(address=self._address))
            self._settle(promised, error, None if error else done.result())

        under_way.add_done_callback(settle)
        promised.add_done_callback(lambda done: under_way.cancel() if done.cancelled() else None)
        return promised

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Ends the watch, and the work that nobody waits for."""
        self._closed.set()
        self._executor.shutdown(wait=False)

    def _settle(self, promised: Future[Any], error: BaseException | None, result: Any = None) -> None:
        self._waiting.discard(promised)
        try:
            if error is None:
                promised.set_result(result)
            else:
                promised.set_exception(error)
        except InvalidStateError:
            pass  # cancelled, or given up before

    def _look(self) -> None:
        last_seen = time.monotonic()
        while not self._closed.wait(LOOK_SECONDS):
            if self._client.status not in ("running", "connecting"):
                self._give_up(messages.SCHEDULER_LOST(address=self._address))
            elif self._has_workers():
                last_seen = time.monotonic()
            elif time.monotonic() - last_seen > PATIENCE_SECONDS:
                self._give_up(messages.WORKERS_LOST(address=self._address, seconds=PATIENCE_SECONDS))

    def _has_workers(self) -> bool:
        try:
            return bool(self._client.nthreads())
        except (OSError, ValueError):  # the connection is down; Dask tries to have it again
            return False

    def _give_up(self, why: Message) -> None:
        for promised in list(self._waiting):
            self._settle(promised, WorkersLostError(why))
