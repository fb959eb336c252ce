"""The blocks of a mosaic that are scanned one by one, squares in them, rectangles worth to be measured densely, and
which parts of a mosaic given seams call for."""
from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np

from ....imagery.grids import Grid, PixelWindow
from ....imagery.lines import points_at, vertex_stations
from ..seamlines.seam_pieces import SidedSeam

BLOCK_PX = 2048
"""Side of a block: what is held in memory at a time."""
SQUARE_PX = 128
"""Side of a square: one patch in each is looked at."""
SQUARES = BLOCK_PX // SQUARE_PX
"""Along a side of a block."""
UNIT_PX = 32
"""What is measured densely is told in units of this side."""
UNITS = BLOCK_PX // UNIT_PX
"""Along a side of a block."""
LABEL_PX = 4
"""Side of a sample of the labels that are kept."""
LABELS = BLOCK_PX // LABEL_PX
"""Along a side of a block."""

BlockKey = tuple[int, int]
"""Row and column of a block, from the top left."""


@dataclass(frozen=True)
class BlockGrid:
    """The blocks that a mosaic has."""

    grid: Grid

    @property
    def rows(self) -> int:
        """Number of rows of blocks."""
        return -(-self.grid.rows // BLOCK_PX)

    @property
    def columns(self) -> int:
        """Number of columns of blocks."""
        return -(-self.grid.columns // BLOCK_PX)

    @property
    def label_size(self) -> tuple[int, int]:
        """Columns and rows of labels."""
        return labels_in(self.grid.columns), labels_in(self.grid.rows)

    def __iter__(self) -> Iterator[BlockKey]:
        """All blocks, row by row."""
        return ((row, column) for row in range(self.rows) for column in range(self.columns))

    def window(self, key: BlockKey) -> PixelWindow:
        """The pixels of a block; those at the right and bottom edge are smaller."""
        row, column = key
        whole = PixelWindow(column * BLOCK_PX, row * BLOCK_PX, BLOCK_PX, BLOCK_PX)
        return whole.cut_to(self.grid.columns, self.grid.rows)


def labels_in(length: int) -> int:
    """Labels whose middle lies within so many pixels."""
    return -(-(length - LABEL_PX // 2) // LABEL_PX)


def place_of(key: BlockKey, side: int) -> tuple[slice, slice]:
    """Place of a block in an array of the whole mosaic that has ``side`` samples along a block's."""
    row, column = key
    return slice(row * side, (row + 1) * side), slice(column * side, (column + 1) * side)


def squares_met(window: PixelWindow, side_px: int) -> tuple[slice, slice]:
    """Rows and columns of the squares that a window meets, counted from the corner of its grid."""
    return (
        slice(window.row // side_px, -(-(window.row + window.height) // side_px)),
        slice(window.column // side_px, -(-(window.column + window.width) // side_px)),
    )


MARGIN_PX = 16
"""Around a rectangle: what labels and the finest details need to know beyond it."""
_MOST_UNITS = 2560  # of a rectangle, 2.6 million px: beyond that it only takes memory
_ALONE_PX = 60_000.0  # pixels that take as long as the mere calls


def rectangles(wanted: np.ndarray) -> list[PixelWindow]:
    """Rectangles that cover the units, (rows, columns) bool, and no unit twice; pixels from the corner of the first
    unit on.

    The rectangle around all is cut in two where that saves most time, and so are its parts, as long as it saves any.
    """
    return [
        PixelWindow(left * UNIT_PX, top * UNIT_PX, (right - left) * UNIT_PX, (bottom - top) * UNIT_PX)
        for top, bottom, left, right in _divided(wanted, 0, 0)
    ]


_Part = tuple[int, int, int, int]  # first and last row, first and last column


def _divided(wanted: np.ndarray, top: int, left: int) -> list[_Part]:
    """Rectangles of a part whose first unit is at ``top``, ``left``."""
    rows, columns = (np.flatnonzero(wanted.any(axis=axis)) for axis in (1, 0))
    if not len(rows):
        return []
    wanted = wanted[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    top, left = top + int(rows[0]), left + int(columns[0])
    height, width = wanted.shape
    best = float("inf") if height * width > _MOST_UNITS else float(_costs(np.array(height), np.array(width)))
    down, across = _costs_of_cuts(wanted), _costs_of_cuts(wanted.T)
    if min(down.min(initial=np.inf), across.min(initial=np.inf)) >= best:
        return [(top, top + height, left, left + width)]
    if down.min(initial=np.inf) <= across.min(initial=np.inf):
        cut = int(down.argmin()) + 1
        return _divided(wanted[:cut], top, left) + _divided(wanted[cut:], top + cut, left)
    cut = int(across.argmin()) + 1
    return _divided(wanted[:, :cut], top, left) + _divided(wanted[:, cut:], top, left + cut)


def _costs_of_cuts(wanted: np.ndarray) -> np.ndarray:
    """Costs of the rectangles around what is above and below each cut between two rows, (rows - 1,)."""
    return _above(wanted)[:-1] + _above(wanted[::-1])[:-1][::-1]


def _above(wanted: np.ndarray) -> np.ndarray:
    """What the rectangle around each row and all before it costs, (rows,); the first row is not empty."""
    some = wanted.any(axis=1)
    length = wanted.shape[1]
    first = np.minimum.accumulate(np.where(some, wanted.argmax(axis=1), length))
    last = np.maximum.accumulate(np.where(some, length - wanted[:, ::-1].argmax(axis=1), 0))
    row = np.maximum.accumulate(np.where(some, np.arange(1, len(wanted) + 1), 0))
    return _costs(row, last - first)


def _costs(height: np.ndarray, width: np.ndarray) -> np.ndarray:
    """Time as pixels."""
    return np.asarray((height * UNIT_PX + 2.0 * MARGIN_PX) * (width * UNIT_PX + 2.0 * MARGIN_PX) + _ALONE_PX)


BESIDE_PX = 48
"""On either side of a seam that are measured densely."""
_STEP_PX = 24.0  # between the points of a line that are looked at
_NO_UNITS = np.zeros((UNITS, UNITS), bool)


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
        return self._dense.get(key, _NO_UNITS)

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
            self._dense.setdefault(key, _NO_UNITS.copy())[row[group] % UNITS, column[group] % UNITS] = True

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
