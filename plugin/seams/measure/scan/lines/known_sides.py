"""What given seams say of the ground beside them: which source each pixel was taken from."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .....imagery.grids import PixelWindow
from ...following.boxes import enlarged
from ...seam_cells import UNKNOWN
from ..blocks.block_grid import LABEL_PX
from .piece_index import PieceIndex

REACH_PX = 192.0
"""How far beside a line its sides are told."""
MOST_ASIDE_PX = 40.0
"""How far a line may lie from the seam that the mosaic shows, for that to be its seam."""


@dataclass(frozen=True, eq=False)
class KnownSides:
    """The given seams near one block, and its sources on either hand. Plain arrays, which can cross processes."""

    index: PieceIndex
    sides: np.ndarray
    """(2, pieces) uint8: of all pieces the source on the left hand and on the right, ``UNKNOWN`` where nothing says."""

    @classmethod
    def near(
        cls, index: PieceIndex, sides: np.ndarray, sources: Sequence[int], window: PixelWindow
    ) -> KnownSides | None:
        """Of a block by all of the scan; None where no side is known near it.

        ``sides``: (2, pieces) int, numbers in the scan, negative where nothing says; ``sources``: those of the block.
        """
        part = index.near(window, REACH_PX)
        if not len(part):
            return None
        own = np.full(sides.shape, UNKNOWN, np.uint8)
        numbers = part.numbers
        for place, number in enumerate(sources[:UNKNOWN]):
            own[:, numbers] = np.where(sides[:, numbers] == number, np.uint8(place), own[:, numbers])
        return cls(part, own) if (own[:, numbers] != UNKNOWN).any() else None

    def labels(self, window: PixelWindow) -> np.ndarray:
        """Of the block's sources, (rows, columns) uint8 of a window, ``UNKNOWN`` where nothing says."""
        rows, columns = (
            first + LABEL_PX / 2 + LABEL_PX * np.arange(-(-length // LABEL_PX))
            for first, length in ((window.row, window.height), (window.column, window.width))
        )
        found = self.index.beside(columns[np.newaxis, :], rows[:, np.newaxis], REACH_PX)
        left, right = self.sides
        told = np.where(found.on_left, left[found.number], right[found.number])
        # A line may lie aside of the seam that the mosaic shows, which is then what tells where it runs.
        known = (found.number >= 0) & (found.distance_px >= MOST_ASIDE_PX)
        labels = np.where(known, told, np.uint8(UNKNOWN))
        return enlarged(labels, LABEL_PX)[: window.height, : window.width]
