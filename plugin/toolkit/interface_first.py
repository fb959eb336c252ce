"""Threads of ours that let the interface go first."""
from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Lock

_INTERVAL_S = 0.0005
_lock = Lock()
_threads = 0
_interval_before = 0.0


@contextmanager
def interface_first() -> Iterator[None]:
    """While a thread runs Python it hands the interpreter over within half a millisecond, not Python's usual five.

    The interface asks for the interpreter many times while it handles one event (each call of a method that we
    override is one), and would wait as many times.
    """
    global _threads, _interval_before
    with _lock:
        if not _threads:
            _interval_before = sys.getswitchinterval()
            sys.setswitchinterval(_INTERVAL_S)
        _threads += 1
    try:
        yield
    finally:
        with _lock:
            _threads -= 1
            if not _threads:
                sys.setswitchinterval(_interval_before)
