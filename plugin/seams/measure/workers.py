"""Work done for many requests by an executor: results in order, within a bound of memory, until it is cancelled."""
from __future__ import annotations

import logging
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import BrokenExecutor, Executor, Future, wait
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import islice
from typing import Callable, NoReturn, TypeVar

from ...imagery.errors import CancelledError, Message, SeamInspectorError
from ...imagery.messages import CANCELLED
from ...imagery.raster_pool import own_threads
from . import messages

_log = logging.getLogger("seam_inspector")
Request = TypeVar("Request")
Result = TypeVar("Result")

_PATIENCE_SECONDS = 0.2  # between two looks at whether the run was cancelled
_MANY = 16  # tasks under way: each then has several requests
_AT_A_TIME = 8


@dataclass(frozen=True, eq=False)
class Workers:
    """Who measures, until when, and who is told how far it is."""

    executor: Executor | None = None
    """A thread per core where None."""
    ahead: int = 0
    """Most requests under way or waiting to be taken, so that memory does not grow with their number; twice this
    machine's cores where 0."""
    cancelled: Callable[[], bool] = lambda: False
    """Is asked several times a second whether to end."""
    progress: Callable[[float], object] = lambda share: None
    """Is told the share that is done, 0 to 1, now and then; what it raises ends the work."""

    @property
    def together(self) -> int:
        """Requests that are handed out at once: several where many take them, as one takes as long as all."""
        return _AT_A_TIME if self.ahead > _MANY else 1

    @contextmanager
    def at_work(self) -> Iterator[Workers]:
        """These, with an executor as long as the block lasts."""
        with own_threads(self.executor, self.ahead) as (executor, ahead):
            yield replace(self, executor=executor, ahead=ahead)

    def part(self, first: float, last: float = 1.0) -> Workers:
        """These at a part of the work, from one share that is done to another."""
        return replace(self, progress=lambda share: self.progress(first + (last - first) * share))

    def tell(self, share: float) -> None:
        """So much is done. Raises CancelledError where nobody wants more."""
        self.progress(share)
        if self.cancelled():
            raise CancelledError(CANCELLED())

    def map(self, work: Callable[[Request], Result], requests: Iterable[Request], count: int) -> Iterator[Result]:
        """What is made of each of so many requests, in their order. Raises what it raises, CancelledError."""
        done = 0
        for done, result in enumerate(in_order(requests, work, _raised, self, self.together), 1):
            yield result
            self.tell(done / count)
        if done < count:
            raise CancelledError(CANCELLED())


def _raised(_request: object, reason: Message) -> NoReturn:
    raise SeamInspectorError(reason)


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
            assert workers.executor is not None
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
