"""What given seams say of a block: which parts of the mosaic they call for, and what lies beside them."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Optional

import numpy as np

from .....imagery.grids import PixelWindow
from .....imagery.lines import points_at, vertex_stations
from ...following.boxes import enlarged
from ..lines.piece_index import PieceIndex
from ..lines.seam_pieces import SidedSeam
from .block_grid import LABEL_PX, MARGIN_PX, UNIT_PX, UNITS, BlockGrid, BlockKey

BESIDE_PX = 48
"""On either side of a seam that are measured densely."""
_STEP_PX = 24.0  # between the points of a line that are looked at
_AT_ONCE = 50_000  # points
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
            for points in _spaced(blocks.grid.to_pixels(seam.vertices)):
                self._mark(points, beside_px)
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
        return self._read is None or bool(self._read[key])

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

    def _within(self, reach: float) -> np.ndarray:
        """Blocks with any unit at most ``reach`` units from one along a seam, (rows, columns) bool.

        Above each block the nearest such unit of each column is looked at, then below it.
        """
        rows, columns = self._blocks.rows, self._blocks.columns
        found = np.zeros((rows, columns), bool)
        of_row: dict[int, list[int]] = {}
        for row, column in self._dense:
            of_row.setdefault(row, []).append(column)
        for turn in (1, -1):
            last = np.full(columns * UNITS, -np.inf)  # row of the nearest unit so far, counted in this direction
            for passed, row in enumerate(range(rows)[::turn]):
                first = passed * UNITS
                for column in of_row.get(row, ()):
                    dense = self._dense[row, column][::turn]
                    lowest = first + UNITS - 1 - dense[::-1].argmax(axis=0)
                    own = last[column * UNITS : (column + 1) * UNITS]
                    own[:] = np.where(dense.any(axis=0), lowest, own)
                away = np.maximum(first - last, 0)
                near = np.flatnonzero(away <= reach)
                aside = np.sqrt(reach**2 - away[near] ** 2)
                start = np.maximum(np.ceil(near - aside), 0).astype(np.int64) // UNITS
                end = np.minimum(np.floor(near + aside).astype(np.int64) // UNITS, columns - 1)
                begun, ended = (np.bincount(one, minlength=columns + 1) for one in (start, end + 1))
                found[row] |= np.cumsum(begun - ended)[:columns] > 0
        return found


def _spaced(path: np.ndarray) -> Iterator[np.ndarray]:
    """(n, 2) points along a path, ``_STEP_PX`` apart at most, so many at once."""
    along = vertex_stations(path)
    steps = int(np.ceil(along[-1] / _STEP_PX))
    for first in range(0, steps + 1, _AT_ONCE):
        places = np.arange(first, min(first + _AT_ONCE, steps + 1))
        yield points_at(path, along, places * (along[-1] / max(steps, 1)))


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
