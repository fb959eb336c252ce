"""Signals that are followed for a time."""
from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import Any


class Connections:
    """Connections of signals with slots, until ``close``."""

    def __init__(self, *followed: tuple[Any, Callable[..., Any]]) -> None:
        self._followed = list(followed)
        for signal, slot in followed:
            signal.connect(slot)

    def close(self) -> None:
        while self._followed:
            signal, slot = self._followed.pop()
            with suppress(TypeError, RuntimeError):  # who emits it is gone already
                signal.disconnect(slot)
