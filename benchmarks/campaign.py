"""Operations done to windows on all cores: which operation gets which windows, and who works it out."""
from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import groupby
from multiprocessing import get_all_start_methods, get_context

from .known_windows import KnownWindow, WindowFacts
from .outcomes import Finding, Outcome, find
from .production import Operation

POOL = 8
"""So many times as many windows as an operation gets: each gets other ones."""


@dataclass(frozen=True, eq=False)
class Task:
    """Operations of one making on one window: the seam is made once for all that comes over it."""

    window: KnownWindow
    operations: tuple[Operation, ...]
    with_peers: bool = False


Done = tuple[WindowFacts, list[Finding]]

_TASKS: list[Task] = []
"""What processes that were forked off find there: neither operations nor windows have to be sent to them."""


def spread(
    operations: Sequence[Operation], windows: Sequence[KnownWindow], count: int, with_peers: bool = False
) -> list[Task]:
    """Each operation in ``count`` of the windows that it fits, in turn, window by window."""
    planned: dict[int, list[Operation]] = defaultdict(list)
    for turn, operation in enumerate(operations):
        fitting = [place for place, window in enumerate(windows) if operation.fits(window)]
        for number in range(min(count, len(fitting))):
            planned[fitting[(turn * count + number) % len(fitting)]].append(operation)
    return [
        Task(windows[place], tuple(own), with_peers)
        for place, found in sorted(planned.items()) for _, own in groupby(found, key=lambda one: one.making.name)
    ]


def outcomes(tasks: Sequence[Task], jobs: int = 1) -> Iterator[Outcome]:
    """Outcomes of all tasks in turn, worked out by so many processes."""
    for task, (facts, findings) in zip(tasks, _worked_out(tasks, jobs)):
        for operation, finding in zip(task.operations, findings):
            yield Outcome(operation, facts, finding)


def _worked_out(tasks: Sequence[Task], jobs: int) -> Iterator[Done]:
    if jobs == 1 or "fork" not in get_all_start_methods():
        yield from map(_done, tasks)
        return
    _TASKS[:] = tasks
    with get_context("fork").Pool(jobs) as pool:
        yield from pool.imap(_done_by_number, range(len(tasks)))
    _TASKS.clear()


def _done_by_number(number: int) -> Done:
    return _done(_TASKS[number])


def _done(task: Task) -> Done:
    return _facts(task.window), [find(operation, task.window, task.with_peers) for operation in task.operations]


@lru_cache(maxsize=2)
def _facts(window: KnownWindow) -> WindowFacts:
    return WindowFacts.of(window)
