"""What a layer of seams says that can hardly be meant: other units, words instead of numbers."""
from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

import numpy as np

from ...imagery.errors import Message, SettingsError
from . import messages
from .measured_pieces import NO_VERDICT

MOST_KEPT = 3.0  # a seam that was sharpened keeps more than 1; shares of three times that are none
_OTHER_LENGTH = 1.1  # times the line's: feet, kilometres, or the length of something else


@dataclass
class LayerDoubts:
    """Of one layer, piece by piece."""

    sheet: str
    kept: list[float] = field(default_factory=list)
    claimed: list[float] = field(default_factory=list)
    """Of pieces with a verdict: where the scan has none, its interval is too wide, any number may stand."""
    words: list[str] = field(default_factory=list)
    """That stand where numbers should."""
    lengths: list[tuple[float, float]] = field(default_factory=list)
    """In the field and along the line, metres, where they differ."""

    def see_kept(self, written: str, kept: float | None, verdict: str = "") -> float | None:
        """What counts of a piece's ``kept_1``, as it is ``written`` and as a number: nothing below 0."""
        if kept is None:
            if written and written.lower() not in ("nan", "inf", "-inf"):
                self.words.append(written)
            return None
        self.kept.append(kept)
        if verdict != NO_VERDICT:
            self.claimed.append(kept)
        return kept if kept >= 0 else None

    def see_length(self, length: float, line: float) -> None:
        """A length from the field, beside that of the line."""
        if line > 0 and not 1 / _OTHER_LENGTH <= length / line <= _OTHER_LENGTH:
            self.lengths.append((length, line))

    def told(self) -> Iterator[Message]:
        """Raises SettingsError where the layer's ``kept_1`` are no shares."""
        if self.kept and (middle := float(np.median(self.kept))) > MOST_KEPT:
            raise SettingsError(messages.KEPT_NO_SHARES(name=self.sheet, value=middle))
        if self.words:
            yield messages.KEPT_NO_NUMBERS(count=len(self.words), name=self.sheet, value=self.words[0])
        if negative := sum(kept < 0 for kept in self.kept):
            yield messages.KEPT_NEGATIVE(count=negative, name=self.sheet)
        if large := sum(kept > MOST_KEPT for kept in self.claimed):
            yield messages.KEPT_LARGE(count=large, name=self.sheet, value=max(self.claimed))
        if self.lengths:
            length, line = max(self.lengths, key=lambda pair: abs(np.log(pair[0] / pair[1])))
            yield messages.LENGTHS_DIFFER(count=len(self.lengths), name=self.sheet, length=length, line=line)
