"""Many windows on any ``concurrent.futures.Executor``, their results in order."""
from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Executor, Future, wait
from typing import Callable, TypeVar

from ...imagery.errors import Message, WorkersLostError
from ...imagery.raster_pool import own_threads
from . import messages
from .inspection import WindowRequest, inspect_in_stages, inspect_window
from .window.measured_window import MeasureWindow
from .window.window_result import WindowClips, WindowResult, not_comparable

Request = TypeVar("Request")
Result = TypeVar("Result")

_PATIENCE_SECONDS = 0.2  # between two looks at whether the run was cancelled


def inspect_windows(
    requests: Iterable[WindowRequest],
    executor: Executor | None = None,
    ahead: int = 0,
    cancelled: Callable[[], bool] = lambda: False,
) -> Iterator[WindowResult]:
    """``inspect_window`` for many, in their order, each as soon as it is ready.

    ``executor``: where they are measured, a thread per core where None; ``ahead``: how many it should have under way,
    twice this machine's cores where 0. A window that fails in a way nobody foresaw is ``not_comparable`` for that
    reason.
    """
    with own_threads(executor, ahead) as opened:
        yield from in_order(requests, inspect_window, not_comparable, *opened, cancelled)


def inspect_one(request: WindowRequest, measure: MeasureWindow) -> Iterator[WindowClips | WindowResult]:
    """``inspect_in_stages`` for a window that somebody waits for; what nobody foresaw becomes the reason likewise."""
    try:
        yield from inspect_in_stages(request, measure)
    except Exception as error:  # as an executor keeps it for ``in_order``
        yield not_comparable(request, _unforeseen(error))


def in_order(
    requests: Iterable[Request],
    measure: Callable[[Request], Result],
    failed: Callable[[Request, Message], Result],
    executor: Executor,
    ahead: int,
    cancelled: Callable[[], bool] = lambda: False,
) -> Iterator[Result]:
    """Results in the order of the requests, each as soon as it and those before it are ready.

    At most ``ahead`` windows are under way or waiting to be taken, so memory does not grow with their number.
    ``failed`` makes the result of a request whose measurement raised an error that nobody foresaw. Stops when
    ``cancelled`` says so, with the results that are ready by then, within a fraction of a second even while a window
    is under way. Raises WorkersLostError when nobody is left to measure.
    """
    waiting: deque[tuple[Request, Future[Result]]] = deque()
    try:
        for request in requests:
            if cancelled():
                break
            waiting.append((request, executor.submit(measure, request)))
            if len(waiting) >= ahead:
                yield from _ready(*waiting.popleft(), failed, cancelled)
        while waiting:
            yield from _ready(*waiting.popleft(), failed, cancelled)
    finally:
        for _, future in waiting:
            future.cancel()


def _ready(
    request: Request,
    future: Future[Result],
    failed: Callable[[Request, Message], Result],
    cancelled: Callable[[], bool],
) -> Iterator[Result]:
    """The result as soon as it is there; nothing when ``cancelled`` says so before."""
    while not future.done():
        if cancelled():
            future.cancel()
            return
        wait([future], timeout=_PATIENCE_SECONDS)
    error = future.exception()
    if error is None:
        yield future.result()
    elif isinstance(error, Exception) and not isinstance(error, WorkersLostError):
        yield failed(request, _unforeseen(error))
    else:
        raise error


def _unforeseen(error: Exception) -> Message:
    return messages.WINDOW_FAILED(error=f"{type(error).__name__}: {error}")
