"""Windows by place: which one covers it, and which shares too much with another."""
from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from ....imagery.grids import PixelWindow

MAX_SHARED_SHARE = 0.5  # two windows on one seam share at most half of their pixels


class WindowIndex:
    """Windows of one size by place."""

    def __init__(self, side_px: int) -> None:
        self._side = side_px
        self._cells: defaultdict[tuple[int, int], list[PixelWindow]] = defaultdict(list)

    def add(self, window: PixelWindow) -> None:
        """Take a window in."""
        self._cells[window.column // self._side, window.row // self._side].append(window)

    def _around(self, column: float, row: float) -> Iterator[PixelWindow]:
        """All windows whose corner lies less than a side from a place, and some more."""
        home_column, home_row = int(column // self._side), int(row // self._side)
        for near_column in (home_column - 1, home_column, home_column + 1):
            for near_row in (home_row - 1, home_row, home_row + 1):
                yield from self._cells.get((near_column, near_row), ())

    def covers(self, column: float, row: float) -> bool:
        """Whether a place lies in a window."""
        return any(
            0 <= column - window.column <= window.width and 0 <= row - window.row <= window.height
            for window in self._around(column, row)
        )

    def shares_too_much(self, window: PixelWindow) -> bool:
        """Whether a window shares more than half of its pixels with one that is here."""
        most = MAX_SHARED_SHARE * window.width * window.height
        return any(window.shared_pixels(other) > most for other in self._around(window.column, window.row))
