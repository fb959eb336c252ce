"""Which parts of a mosaic given seamlines call for."""
from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from scipy import ndimage

from .....imagery.lines.paths import points_at, vertex_stations
from ..lines.seam_pieces import SidedLine
from .block_grid import UNIT_PX, UNITS, BlockGrid, BlockKey, place_of

BESIDE_PX = 48
"""On either side of a seam that are measured densely."""
_STEP_PX = 24.0  # between the points of a line that are looked at


class SeamSquares:
    """Units (rows, columns) of the whole mosaic along its seamlines, and in the corridor around them."""

    def __init__(
        self, seams: Iterable[SidedLine], blocks: BlockGrid, corridor_px: float = 0.0, beside_px: int = BESIDE_PX
    ) -> None:
        """``corridor_px``: how far from the seams is read at all, 0: everything; ``beside_px``: what is measured."""
        grid = blocks.grid
        self.dense = np.zeros((blocks.rows * UNITS, blocks.columns * UNITS), bool)
        """bool: those that a seam runs through, or near by."""
        for seam in seams:
            points = _spaced(grid.to_pixels(seam.vertices))
            reach = np.unique([*np.arange(-beside_px, beside_px, UNIT_PX), beside_px])
            for by in reach:
                for to in reach:
                    self._mark(np.floor((points + (to, by)) / UNIT_PX).astype(np.int64))
        self.dense[-(-grid.rows // UNIT_PX) :] = False
        self.dense[:, -(-grid.columns // UNIT_PX) :] = False
        self._read = self.dense
        if not corridor_px:
            self._read = np.ones_like(self.dense)
        elif self.dense.any():
            self._read = ndimage.distance_transform_edt(~self.dense) * UNIT_PX <= corridor_px

    def dense_in(self, key: BlockKey) -> np.ndarray:
        """Those of a block, (UNITS, UNITS) bool."""
        return self.dense[place_of(key, UNITS)]

    def is_read(self, key: BlockKey) -> bool:
        """Whether anything of a block is to be read."""
        return bool(self._read[place_of(key, UNITS)].any())

    def _mark(self, squares: np.ndarray) -> None:
        column, row = squares.T
        inside = (column >= 0) & (row >= 0) & (column < self.dense.shape[1]) & (row < self.dense.shape[0])
        self.dense[row[inside], column[inside]] = True


def _spaced(path: np.ndarray) -> np.ndarray:
    """(n, 2) points along a path, ``_STEP_PX`` apart at most."""
    along = vertex_stations(path)
    return points_at(path, along, np.linspace(0, along[-1], int(np.ceil(along[-1] / _STEP_PX)) + 1))
