"""What inspected windows say of the sources: which of them the mosaic follows nowhere, and which took no part."""
from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterable, Iterator

from ....imagery.message import Message
from ..causes import Cause
from ..window.window_result import WindowResult
from ..window_records import COMPOSITE
from . import messages

FEWEST_WINDOWS = 5  # in which a source took part, before it is questioned
LEAST_FOLLOWED = 0.02  # of a window's pixels; of estimated labels some 0.6 % are wrong


def source_doubts(results: Iterable[WindowResult], followed: Collection[str] = ()) -> Iterator[Message]:
    """Sentences on sources by their file names; ``followed``: those that the mosaic is known to follow somewhere."""
    took_part: Counter[str] = Counter()
    is_followed = set(followed)
    resampled: set[str] = set()
    for result in results:
        own, other = _compared(result)
        resampled.update(other if own else ())
        found = result.explanation
        if found is None or found.cause is Cause.UNCLEAR:
            continue
        names = own or other
        took_part.update(names)
        is_followed.update(name for name, share in zip(names, found.shares) if share >= LEAST_FOLLOWED)
    doubtful = [name for name, count in took_part.items() if count >= FEWEST_WINDOWS and name not in is_followed]
    if len(doubtful) == 1:
        yield messages.SOURCE_NOT_FOLLOWED(name=doubtful[0], count=took_part[doubtful[0]])
    elif doubtful:
        yield messages.SOURCES_NOT_FOLLOWED(name=doubtful[0], count=len(doubtful), all=len(took_part))
    if resampled:
        yield messages.SOURCES_RESAMPLED(name=min(resampled), count=len(resampled))


def _compared(result: WindowResult) -> tuple[list[str], list[str]]:
    """Names of the sources on the mosaic's own pixels and of the resampled ones, in their order."""
    pairs = {pair.source: pair.resampled for pair in result.pairs if pair.source != COMPOSITE}
    return [name for name, is_other in pairs.items() if not is_other], [name for name, other in pairs.items() if other]
