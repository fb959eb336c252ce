"""The executor where nobody brings one: a thread per core of this machine."""
from __future__ import annotations

import os
from collections.abc import Iterator
from concurrent.futures import Executor, ThreadPoolExecutor
from contextlib import contextmanager

_AHEAD = 2  # requests under way per worker: one is measured while the next waits


@contextmanager
def own_threads(executor: Executor | None = None, ahead: int = 0) -> Iterator[tuple[Executor, int]]:
    """An executor, and how many requests it should have under way: those that are given, where they are."""
    workers = os.cpu_count() or 1
    if executor is not None:
        yield executor, ahead or ahead_of(workers)
        return
    with ThreadPoolExecutor(workers, thread_name_prefix="seam-inspector") as executor:
        yield executor, ahead_of(workers)


def ahead_of(workers: int) -> int:
    """How many requests should be under way with so many workers."""
    return _AHEAD * workers
