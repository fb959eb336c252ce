"""Work done for many requests by an executor: results in order, within a bound of memory, until it is cancelled."""
from __future__ import annotations

import logging
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, Executor, Future, wait
from dataclasses import dataclass
from itertools import islice
from typing import Callable, TypeVar

from ...imagery.errors import Message, SeamInspectorError
from . import messages

_log = logging.getLogger("seam_inspector")
Request = TypeVar("Request")
Result = TypeVar("Result")

_PATIENCE_SECONDS = 0.2  # between two looks at whether the run was cancelled
_MANY = 16  # tasks under way: each then has several requests
_AT_A_TIME = 8


@dataclass(frozen=True, eq=False)
class Workers:
    """Who measures, and until when."""

    executor: Executor
    ahead: int
    """Most requests under way or waiting to be taken, so that memory does not grow with their number."""
    cancelled: Callable[[], bool] = lambda: False

    @property
    def together(self) -> int:
        """Requests that are handed out at once: several where many take them, as one takes as long as all."""
        return _AT_A_TIME if self.ahead > _MANY else 1


def in_order(
    requests: Iterable[Request],
    measure: Callable[[Request], Result],
    failed: Callable[[Request, Message], Result],
    workers: Workers,
    together: int = 1,
) -> Iterator[Result]:
    """Results in the order of the requests, each as soon as it and those before it are ready.

    ``together``: how many requests are handed out at once. ``failed`` makes the result of a request whose measurement
    raised an error that nobody foresaw. Stops when the run is cancelled, with the results that are ready by then, in a
    fraction of a second even while a window is under way. Raises BrokenExecutor when nobody is left to measure.
    """
    waiting: deque[tuple[list[Request], Future[list[Result]]]] = deque()
    requests = iter(requests)
    try:
        while some := list(islice(requests, together)):
            if workers.cancelled():
                break
            try:
                future = workers.executor.submit(_each, measure, some)
            except RuntimeError as error:  # of one that was shut down, for which Python has no error of its own
                raise BrokenExecutor(str(error)) from None
            waiting.append((some, future))
            if len(waiting) >= workers.ahead:
                yield from _ready(*waiting.popleft(), failed, workers.cancelled)
        while waiting:
            yield from _ready(*waiting.popleft(), failed, workers.cancelled)
    finally:
        for _, future in waiting:
            future.cancel()


def _each(measure: Callable[[Request], Result], requests: Sequence[Request]) -> list[Result]:
    return [measure(request) for request in requests]


def _ready(
    requests: Sequence[Request],
    future: Future[list[Result]],
    failed: Callable[[Request, Message], Result],
    cancelled: Callable[[], bool],
) -> Iterator[Result]:
    """The results as soon as they are there; none when ``cancelled`` says so before."""
    while not future.done():
        if cancelled():
            future.cancel()
            return
        wait([future], timeout=_PATIENCE_SECONDS)
    error = future.exception()
    if error is None:
        yield from future.result()
    elif isinstance(error, Exception) and not isinstance(error, BrokenExecutor):
        reason = unforeseen(error)
        yield from (failed(request, reason) for request in requests)
    else:
        raise error


def unforeseen(error: Exception) -> Message:
    """Why there is no result, of an error that nobody foresaw there; where it came from goes to the log."""
    if isinstance(error, SeamInspectorError):
        return error.message
    _log.error("%s", error, exc_info=error)
    return messages.WINDOW_FAILED(error=f"{type(error).__name__}: {error}")
