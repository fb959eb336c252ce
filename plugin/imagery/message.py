"""What a sentence for the user is made of."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Callable


@dataclass(frozen=True)
class Message:
    """One sentence for the user."""

    template: str
    """English text with ``{name}`` where a value goes."""
    values: Mapping[str, object] = field(default_factory=dict)
    """What goes into the template: numbers, texts, other messages or a tuple of those."""

    def __call__(self, **values: object) -> Message:
        """The same sentence with its values."""
        return Message(self.template, values)

    def __str__(self) -> str:
        return self.worded(lambda template: template)

    def worded(self, translate: Callable[[str], str]) -> str:
        """The sentence, its template and those of the messages in it sent through ``translate``."""
        values = {name: _worded(value, translate) for name, value in self.values.items()}
        return translate(self.template).format(**values)


def _worded(value: object, translate: Callable[[str], str]) -> object:
    if isinstance(value, Message):
        return value.worded(translate)
    if isinstance(value, tuple):
        return " ".join(str(_worded(part, translate)) for part in value)
    return value
