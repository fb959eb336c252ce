"""Messages on many windows, for a log that stays readable: one sentence of each kind, with the windows' numbers."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ...imagery.errors import Message
from .. import messages

_MOST_STRETCHES = 12  # of numbers in a sentence


class WindowNotices:
    """Gathers the sentences window by window. One begins with a word, as QGIS writes it behind its progress' number."""

    def __init__(self) -> None:
        self._by_kind: dict[tuple[object, ...], tuple[Message, dict[int, None]]] = {}

    def add(self, window_id: int, notices: Iterable[Message | None]) -> None:
        """Add messages on a window; the first of a kind stands for all."""
        for notice in notices:
            if notice is not None:
                _, windows = self._by_kind.setdefault(_kind(notice), (notice, {}))
                windows[window_id] = None

    def messages(self) -> list[Message]:
        """A sentence of each kind, in the order in which they were added."""
        made = []
        for what, windows in self._by_kind.values():
            first, count = next(iter(windows)), len(windows)
            message = messages.OF_A_WINDOW(window=first, what=what) if count == 1 else (
                messages.OF_WINDOWS(count=count, windows=_numbers(sorted(windows)), window=first, what=what))
            made.append(replace(message, level=what.level))
        return made


def _kind(message: Message) -> tuple[object, ...]:
    """The template of a message with those of the messages in it."""
    return (message.template, *(_kind(value) for value in message.values.values() if isinstance(value, Message)))


def _numbers(ordered: Sequence[int]) -> str:
    """Each stretch of consecutive ones by its ends: 1-4, 7."""
    stretches: list[list[int]] = []
    for number in ordered:
        if stretches and number == stretches[-1][-1] + 1:
            stretches[-1][1:] = [number]
        else:
            stretches.append([number])
    texts = ["\u2013".join(map(str, stretch)) for stretch in stretches[:_MOST_STRETCHES]]
    return ", ".join(texts if len(stretches) <= _MOST_STRETCHES else [*texts, "\u2026"])
