"""What is told of many windows, for a log that stays readable: one sentence of each kind, with the windows' numbers."""
from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

from ...imagery.errors import Message
from .. import messages

_MOST_STRETCHES = 12  # of numbers in a sentence


class WindowNotices:
    """Gathers the sentences window by window. One begins with a word, as QGIS writes it behind its progress' number."""

    def __init__(self) -> None:
        self._found: dict[tuple[object, ...], dict[int, Message]] = {}

    def add(self, window_id: int, notices: Iterable[Message | None]) -> None:
        """What is to be told of a window; the first of a kind stands for all that it has of it."""
        for notice in notices:
            if notice is not None:
                self._found.setdefault(_kind(notice), {}).setdefault(window_id, notice)

    def told(self) -> list[Message]:
        """A sentence of each kind, in the order in which they were found."""
        return [_about(said) for said in self._found.values()]


def _kind(message: Message) -> tuple[object, ...]:
    """Its template with those of the sentences in it."""
    return (message.template, *(_kind(value) for value in message.values.values() if isinstance(value, Message)))


def _about(said: dict[int, Message]) -> Message:
    (first, what), count = next(iter(said.items())), len(said)
    if count == 1:
        told = messages.OF_A_WINDOW(window=first, what=what)
    elif len(set(map(str, said.values()))) == 1:
        told = messages.OF_WINDOWS(count=count, windows=_numbers(sorted(said)), what=what)
    else:
        told = messages.OF_WINDOWS_SUCH_AS(count=count, windows=_numbers(sorted(said)), window=first, what=what)
    return replace(told, level=what.level)


def _numbers(ordered: Sequence[int]) -> str:
    """Each stretch of consecutive ones by its ends: 1-4, 7."""
    stretches: list[list[int]] = []
    for number in ordered:
        if stretches and number == stretches[-1][-1] + 1:
            stretches[-1][1:] = [number]
        else:
            stretches.append([number])
    told = ["\u2013".join(map(str, stretch)) for stretch in stretches[:_MOST_STRETCHES]]
    return ", ".join(told if len(stretches) <= _MOST_STRETCHES else [*told, "\u2026"])
