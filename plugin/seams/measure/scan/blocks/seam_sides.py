"""Given seams near a block, and what they say lies beside them."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Optional

import numpy as np

from .....imagery.grids import PixelWindow
from ...following.boxes import enlarged
from ..lines.piece_index import PieceIndex
from .block_grid import LABEL_PX
from .rectangles import MARGIN_PX
from .seam_squares import BESIDE_PX

REACH_PX = 4.0 * BESIDE_PX
"""From a seam: what lies farther off may be beyond another one that nobody drew."""

Sides = tuple[Optional[int], Optional[int]]
"""Numbers of the sources on the left and right hand; None where nothing says. Producers often exchange them."""


@dataclass(frozen=True, eq=False)
class SeamSides:
    """The pieces of seam that may matter in a block."""

    pieces: PieceIndex
    beside: Mapping[int, Sides]
    """What lies beside each of them."""

    def named_near(self, window: PixelWindow) -> set[int]:
        """Sources that lie beside the seams in a window, on the mosaic's grid; none where one of them is not named."""
        near = [self.beside[number] for number in self.pieces.near(window, float(MARGIN_PX)).numbers.tolist()]
        found = {side for sides in near for side in sides}
        return set() if None in found else {side for side in found if side is not None}

    def parts(self, window: PixelWindow) -> np.ndarray:
        """What lies on the same hand of the same two sources' seam, (rows, columns) int of a window of whole
        ``LABEL_PX``; -1 far from all seams."""
        rows, columns = (
            first + np.arange(LABEL_PX / 2, length, LABEL_PX)
            for first, length in ((window.row, window.height), (window.column, window.width))
        )
        nearest = self.pieces.beside(columns, rows[:, np.newaxis], REACH_PX)
        found = np.full(nearest.number.shape, -1)
        numbers = self.pieces.numbers
        pairs = {sides: number for number, sides in enumerate(sorted(set(self.beside.values()), key=str))}
        of_piece = np.array([pairs[self.beside[number]] for number in numbers.tolist()])
        near = nearest.number >= 0
        found[near] = 2 * of_piece[np.searchsorted(numbers, nearest.number[near])] + nearest.on_left[near]
        return enlarged(found, LABEL_PX)
