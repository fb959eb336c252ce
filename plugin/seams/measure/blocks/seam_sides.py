"""What given seams say of a block: which parts of the mosaic they call for, and what lies beside them."""
from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import product
from typing import Optional

import numpy as np

from ....imagery.grids import PixelWindow
from ....imagery.lines import points_at, vertex_stations
from ..seamlines.piece_index import PieceIndex
from ..seamlines.seam_pieces import SidedSeam
from .block_grid import MARGIN_PX, UNIT_PX, UNITS, BlockGrid, BlockKey

BESIDE_PX = 48
"""On either side of a seam that are measured densely."""
_STEP_PX = 24.0  # between the points of a line that are looked at
_NONE = np.zeros((UNITS, UNITS), bool)


class SeamSquares:
    """Units of the mosaic along its seamlines, and the blocks in the corridor around them.

    Only blocks that a seam meets are held, so that memory grows with the seams and not with the mosaic.
    """

    def __init__(
        self, seams: Iterable[SidedSeam], blocks: BlockGrid, corridor_px: float = 0.0, beside_px: int = BESIDE_PX
    ) -> None:
        """``corridor_px``: how far from the seams is read at all, 0: everything; ``beside_px``: what is measured."""
        self._blocks = blocks
        self._dense: dict[BlockKey, np.ndarray] = {}
        for seam in seams:
            path = blocks.grid.to_pixels(seam.vertices)
            along = vertex_stations(path)
            self._mark(points_at(path, along, np.linspace(0, along[-1], int(along[-1] / _STEP_PX) + 2)), beside_px)
        self._read = self._within(corridor_px / UNIT_PX) if corridor_px else None

    def dense_in(self, key: BlockKey) -> np.ndarray:
        """Units of a block that a seam runs through, or near by, (UNITS, UNITS) bool."""
        return self._dense.get(key, _NONE)

    @property
    def met(self) -> list[BlockKey]:
        """The blocks with such units, row by row."""
        return sorted(self._dense)

    def is_read(self, key: BlockKey) -> bool:
        """Whether anything of a block is to be read."""
        return self._read is None or key in self._read

    def _mark(self, points: np.ndarray, beside_px: int) -> None:
        """Units within reach of points (n, 2), columns and rows in pixels."""
        grid = self._blocks.grid
        size = np.array([grid.columns, grid.rows])
        points = points[((points >= -beside_px) & (points <= size + beside_px)).all(axis=1)]
        reach = np.unique([*np.arange(-beside_px, beside_px, UNIT_PX), beside_px])
        beside = np.stack(np.meshgrid(reach, reach), axis=-1).reshape(-1, 1, 2)
        units = np.floor((points + beside) / UNIT_PX).astype(np.int64).reshape(-1, 2)
        column, row = units[((units >= 0) & (units * UNIT_PX < size)).all(axis=1)].T
        number = row // UNITS * self._blocks.columns + column // UNITS
        order = np.argsort(number, kind="stable")
        for group in np.split(order, np.flatnonzero(np.diff(number[order])) + 1) if len(order) else ():
            key = divmod(int(number[group[0]]), self._blocks.columns)
            self._dense.setdefault(key, _NONE.copy())[row[group] % UNITS, column[group] % UNITS] = True

    def _within(self, reach: float) -> set[BlockKey]:
        """Blocks with any unit at most ``reach`` units from one along a seam."""
        blocks, most = set[BlockKey](), int(reach // UNITS) + 1
        for (row, column), dense in self._dense.items():
            units = np.argwhere(dense)
            for down, across in product(range(-most, most + 1), repeat=2):
                first = UNITS * np.array([down, across])
                apart = units - units.clip(first, first + UNITS - 1)  # from the nearest unit of that block
                if (np.square(apart).sum(axis=1) <= reach**2).any():
                    blocks.add((row + down, column + across))
        return blocks


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
        named = {side for sides in near for side in sides}
        return set() if None in named else {side for side in named if side is not None}
