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

    own: tuple[str, ...]
    """Those on the mosaic's own pixels, in their order."""
    resampled: tuple[str, ...]
    """The others."""
    shares: tuple[float, ...] | None
    """Shares of the window's pixels that follow ``own``, or ``resampled`` where there are no others; None where that
    can't be told."""


def source_use(result: WindowResult) -> SourceUse:
    """What an inspected window says of its sources; it is kept of thousands, whose results are not."""
    pairs = {pair.source: pair.resampled for pair in result.pairs if pair.source != COMPOSITE}
    explanation = result.explanation
    return SourceUse(
        tuple(name for name, is_resampled in pairs.items() if not is_resampled),
        tuple(name for name, is_resampled in pairs.items() if is_resampled),
        None if explanation is None or explanation.is_unclear else tuple(explanation.shares),
    )


def source_doubts(uses: Iterable[SourceUse]) -> Iterator[Message]:
    """Sentences on sources by their file names."""
    took_part: Counter[str] = Counter()
    is_followed: set[str] = set()
    resampled: set[str] = set()
    for use in uses:
        resampled.update(use.resampled if use.own else ())
        if use.shares is None:
            continue
        names = use.own or use.resampled
        took_part.update(names)
        is_followed.update(name for name, share in zip(names, use.shares) if share >= LEAST_FOLLOWED)
    doubtful = [name for name, count in took_part.items() if count >= FEWEST_WINDOWS and name not in is_followed]
    if len(doubtful) == 1:
        yield messages.SOURCE_NOT_FOLLOWED(name=doubtful[0], count=took_part[doubtful[0]])
    elif doubtful:
        yield messages.SOURCES_NOT_FOLLOWED(name=doubtful[0], count=len(doubtful), all=len(took_part))
    if resampled:
        yield messages.SOURCES_RESAMPLED(name=min(resampled), count=len(resampled))
