"""What inspected windows say of their sources."""
from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from ....imagery.errors import Message
from ..inputs import messages
from ..window_records import COMPOSITE
from .window_result import WindowResult

FEWEST_WINDOWS = 5  # in which a source took part, before it is questioned
LEAST_FOLLOWED = 0.02  # of a window's pixels; of estimated labels some 0.6 % are wrong


@dataclass(frozen=True)
class SourceUse:
    """What one window says of its sources, by their file names."""

    judged: tuple[str, ...]
    """Sources that took part, in their order."""
    only_shown: tuple[str, ...]
    """The others."""
    shares: tuple[float, ...] | None
    """Shares of the window's pixels that follow ``judged``; None where that can't be told."""


def source_use(result: WindowResult) -> SourceUse:
    """What an inspected window says of its sources; it is kept of thousands, whose results are not."""
    explanation = result.explanation
    names = dict.fromkeys(pair.source for pair in result.pairs if pair.source != COMPOSITE)
    judged = dict.fromkeys(pair.source for pair in result.pairs if explanation is None or pair.change is not None)
    return SourceUse(
        tuple(name for name in names if name in judged),
        tuple(name for name in names if name not in judged),
        None if explanation is None or explanation.is_unclear else tuple(explanation.shares),
    )


def source_doubts(uses: Iterable[SourceUse]) -> Iterator[Message]:
    """Sentences on sources by their file names."""
    took_part: Counter[str] = Counter()
    is_followed: set[str] = set()
    only_shown: set[str] = set()
    for use in uses:
        only_shown.update(use.only_shown)
        if use.shares is None:
            continue
        took_part.update(use.judged)
        is_followed.update(name for name, share in zip(use.judged, use.shares) if share >= LEAST_FOLLOWED)
    doubtful = [name for name, count in took_part.items() if count >= FEWEST_WINDOWS and name not in is_followed]
    if len(doubtful) == 1:
        yield messages.SOURCE_NOT_FOLLOWED(name=doubtful[0], count=took_part[doubtful[0]])
    elif doubtful:
        yield messages.SOURCES_NOT_FOLLOWED(name=doubtful[0], count=len(doubtful), all=len(took_part))
    if only_shown:
        yield messages.SOURCES_RESAMPLED(name=min(only_shown), count=len(only_shown))
