"""How a whole mosaic is scanned: its settings, the blocks that are scanned one by one, squares in them, rectangles that
are worth to be measured densely, and which parts of a mosaic given seams call for."""
from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np

from ....imagery import limits as imagery_limits
from ....imagery import messages as imagery_messages
from ....imagery.errors import SettingsError
from ....imagery.grids import Grid, PixelWindow
from ....imagery.lines import points_along
from ....imagery.wavelets import check_decomposition
from .. import messages
from ..limits import DENSITIES, MOST_LEVELS, SEAMS, STANDARD_PIECE_M, WORST_COUNT
from ..profile.cell_table import CELL_PX
from ..seamlines.seam_pieces import SidedSeam

LEAST_PIECE_M = 0.01  # what is shorter is no length; scan_request lengthens what can't be measured
CELLS_PX = tuple(CELL_PX * 2**power for power in range(5))
"""Sides of a pixel of the picture of losses: whole cells, and whole pixels in a block."""


@dataclass(frozen=True)
class ScanSettings:
    """What is measured, and how it is told."""

    wavelet: str = imagery_limits.DEFAULT_WAVELET
    """Any orthogonal wavelet of PyWavelets."""
    levels: int = imagery_limits.DEFAULT_LEVELS
    """R, 1 to 4."""
    density: str = SEAMS
    """``seams``: everything along the seams, samples elsewhere; ``full``: everything everywhere."""
    cell_px: int = 2 * CELL_PX
    """Side of a pixel of the picture of losses, px of the mosaic: 16, 32, 64, 128 or 256."""
    piece_m: float = STANDARD_PIECE_M
    """Length of the pieces into which seams are cut."""
    corridor_m: float = 0.0
    """What is read on either side of given seamlines; 0: everything."""
    worst_count: int = WORST_COUNT
    """Windows of the least kept places."""
    source_field: str = ""
    """Field of given seamlines that names the source of a polygon, where that can't be guessed."""

    @property
    def told(self) -> dict[str, str]:
        """What its results say of how they were measured."""
        notes = {
            "wavelet": self.wavelet, "levels": str(self.levels), "density": self.density,
            "piece_m": f"{self.piece_m:.4g}",
        }  # fmt: skip
        return {**notes, "corridor_m": f"{self.corridor_m:.4g}"} if self.corridor_m else notes

    def check(self) -> None:
        """Raise SettingsError when a value is out of its range."""
        imagery_limits.check_settings(self, ScanSettings)
        if not 1 <= self.levels <= MOST_LEVELS:
            raise SettingsError(imagery_messages.LEVELS_OUT_OF_RANGE(levels=self.levels, least=1, most=MOST_LEVELS))
        check_decomposition(self.wavelet, self.levels)
        for name, choices in (("density", DENSITIES), ("cell_px", CELLS_PX)):
            if (value := getattr(self, name)) not in choices:
                raise SettingsError(messages.CHOICE_UNKNOWN(name=name, value=value, known=", ".join(map(str, choices))))
        for name, least in (("piece_m", LEAST_PIECE_M), ("corridor_m", 0.0), ("worst_count", 0)):
            if (value := getattr(self, name)) < least:
                raise SettingsError(messages.SCAN_LENGTHS(name=name, value=value, least=f"{least:g}"))


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
    """The blocks that a mosaic is scanned in; ``inspection.Block`` is another thing."""

    grid: Grid

    @property
    def rows(self) -> int:
        """Number of rows of blocks."""
        return -(-self.grid.rows // BLOCK_PX)

    @property
    def columns(self) -> int:
        """Number of columns of blocks."""
        return -(-self.grid.columns // BLOCK_PX)

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


def rectangles(wanted: np.ndarray, top: int = 0, left: int = 0) -> list[PixelWindow]:
    """Rectangles that cover the units, (rows, columns) bool, and no unit twice, in pixels; ``top``, ``left``: row and
    column of the first unit of a part.

    The rectangle around all is cut in two where that saves most time, and so are its parts, as long as it saves any.
    """
    rows, columns = (np.flatnonzero(wanted.any(axis=axis)) for axis in (1, 0))
    if not len(rows):
        return []
    wanted = wanted[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
    top, left = top + int(rows[0]), left + int(columns[0])
    height, width = wanted.shape
    best = float("inf") if height * width > _MOST_UNITS else float(_costs(np.array(height), np.array(width)))
    down, across = _costs_of_cuts(wanted), _costs_of_cuts(wanted.T)
    if min(down.min(initial=np.inf), across.min(initial=np.inf)) >= best:
        return [PixelWindow(left * UNIT_PX, top * UNIT_PX, width * UNIT_PX, height * UNIT_PX)]
    if down.min(initial=np.inf) <= across.min(initial=np.inf):
        cut = int(down.argmin()) + 1
        return rectangles(wanted[:cut], top, left) + rectangles(wanted[cut:], top + cut, left)
    cut = int(across.argmin()) + 1
    return rectangles(wanted[:, :cut], top, left) + rectangles(wanted[:, cut:], top, left + cut)


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


def units_along(seams: Iterable[SidedSeam], blocks: BlockGrid, beside_px: int = BESIDE_PX) -> np.ndarray:
    """Units of all blocks that a seam runs through, or near by, (rows, columns) bool."""
    grid, along_seams = blocks.grid, np.zeros((blocks.rows * UNITS, blocks.columns * UNITS), bool)
    size = np.array([grid.columns, grid.rows])
    reach = np.unique([*np.arange(-beside_px, beside_px, UNIT_PX), beside_px])
    beside = np.stack(np.meshgrid(reach, reach), axis=-1).reshape(-1, 1, 2)
    for seam in seams:
        points = points_along(grid.to_pixels(seam.vertices), _STEP_PX)
        points = points[((points >= -beside_px) & (points <= size + beside_px)).all(axis=1)]
        units = np.floor((points + beside) / UNIT_PX).astype(np.int64).reshape(-1, 2)
        column, row = units[((units >= 0) & (units * UNIT_PX < size)).all(axis=1)].T
        along_seams[row, column] = True
    return along_seams


def blocks_near(units: np.ndarray, blocks: BlockGrid, reach: float = 0.0) -> list[BlockKey]:
    """Blocks with any unit at most ``reach`` units from one of some, (rows, columns) bool of all blocks, row by row."""
    near, most = set[BlockKey](), int(reach // UNITS) + 1
    for row, column in np.unique(np.argwhere(units) // UNITS, axis=0).tolist():
        held = np.argwhere(units[place_of((row, column), UNITS)])
        for down, across in product(range(-most, most + 1), repeat=2):
            first = UNITS * np.array([down, across])
            apart = held - held.clip(first, first + UNITS - 1)  # from the nearest unit of that block
            if (np.square(apart).sum(axis=1) <= reach**2).any():
                near.add((row + down, column + across))
    return [key for key in blocks if key in near]
