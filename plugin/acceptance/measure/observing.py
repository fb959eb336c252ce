"""What operators saw in the windows: over which pieces they lie, and who agrees with whom."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...imagery.statistics import DECIDED, INVISIBLE, VISIBLE, agreement
from .decision import Observers
from .delivery import DeliveredPiece, SeenWindow

_TOOL_WORDS = {"significant": VISIBLE, "reduced": INVISIBLE, "preserved": INVISIBLE}  # docs/desk/judging.md


def windows_over(piece: DeliveredPiece, windows: Sequence[SeenWindow], extents: np.ndarray) -> tuple[SeenWindow, ...]:
    """Those that hold the middle of a piece, the one whose own middle is nearest first.

    ``extents``: (n, 4) left, bottom, right and top of the windows.
    """
    if not len(windows):
        return ()
    x, y = piece.middle
    left, bottom, right, top = extents.T
    held = np.flatnonzero((left <= x) & (x <= right) & (bottom <= y) & (y <= top))
    apart = np.hypot((left + right)[held] / 2 - x, (bottom + top)[held] / 2 - y)
    return tuple(windows[int(place)] for place in held[np.argsort(apart, kind="stable")])


def observers(windows: Sequence[SeenWindow]) -> Observers | None:
    """None where nobody judged a window."""
    both = agreement([(window.observer, window.observer_2) for window in windows])
    tool = agreement([(window.observer, _TOOL_WORDS.get(window.verdict, "")) for window in windows])
    if not any(word in DECIDED for window in windows for word in (window.observer, window.observer_2)):
        return None
    return Observers(both if both.count else None, tool if tool.count else None)
