"""One block of a mosaic: request -> what was measured in it."""
from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Optional

import numpy as np

from ....imagery.errors import Message, NotCoveredError, RasterError
from ....imagery.grids import PixelWindow
from ....imagery.rasters import Raster, RasterRef
from ..following.boxes import enlarged, in_squares, widened
from ..following.source_filters import Learned
from ..limits import FULL
from ..profile.cell_table import CELL_PX, CellTable, MixtureTable
from ..profile.detail_sums import ROUNDING
from ..seam_cells import UNKNOWN
from ..seamlines.seam_pieces import PieceIndex
from ..workers import measuring
from . import block_grid as grid
from .block_grid import BlockKey, ScanSettings
from .block_parts import BLOCK_MARGIN_PX, SAMPLED, DensePart, measure_part, measure_plain
from .block_pixels import ALL_READ, BlockPixels, BlockReading
from .patches import UNLEARNED, SquareLook, look_at_squares, middle_sources

REACH_PX = 4.0 * grid.BESIDE_PX
"""From a given seam: what lies farther off may be beyond another one that nobody drew."""
Sides = tuple[Optional[int], Optional[int]]
"""Places among a block's sources of those on the left and right hand; None where nothing says. Producers often exchange
them."""
WHOLE_SHARE = 0.4  # of the squares: with more the block is read as a whole
MOST_MEASURED_PX = 5_200_000  # of a part, times its sources: memory grows with that, time still faster
CROWDED_PX = 384  # side of a part that is measured at once however many they are
MOST_UNEXPLAINED = 0.1  # of a part: beyond it sources that no patch follows are tried, too
LACKING, NOT_LOOKED, EMPTY, PLAIN = -1, -2, -3, -4
"""Units that no source explains, that nobody looked at, in which the mosaic has no pixels, and without texture to
tell a source by where none is near."""
MOST_LACKING = 3 / 8
"""Share of a unit without a source, or without pixels: with as much it is lacking, or empty. A strip of 24 px, wider
than those that labels are closed across, takes so much of one unit wherever it lies."""
CELLS = grid.BLOCK_PX // CELL_PX
"""Cells along a side of a block."""


@dataclass(frozen=True, eq=False)
class BlockRequest:
    """All that is needed to scan one block, in plain data that can cross threads and processes."""

    mosaic: Raster
    refs: tuple[RasterRef, ...]
    """Sources that meet the block."""
    key: BlockKey
    window: PixelWindow
    """Its pixels, on the mosaic's grid."""
    settings: ScanSettings
    wanted: np.ndarray | None = None
    """(UNITS, UNITS) bool, what is to be measured densely, without a look at patches; None: what these call for."""
    along_seams: np.ndarray | None = None
    """(UNITS, UNITS) bool, what given seams call for beside the patches."""
    pieces: PieceIndex | None = None
    """The pieces of given seams that may matter in it."""
    beside: Mapping[int, Sides] = field(default_factory=dict)
    """What lies beside each of them."""
    taps: Mapping[int, np.ndarray] = field(default_factory=dict)
    """Filters of the sources, by their numbers, of which blocks told what came over them."""
    followed: np.ndarray | None = None
    """(SQUARES + 2, SQUARES + 2) uint8: what they found followed in its squares and in those around it, else
    ``UNKNOWN``; None: any source may be."""
    numbers: tuple[int, ...] = ()
    """What its sources are numbered in the whole scan."""


@dataclass(frozen=True, eq=False)
class BlockScan:
    """What was measured in one block."""

    key: BlockKey
    sources: tuple[int, ...]
    """Numbers in the whole scan of the sources that its own mean."""
    squares: np.ndarray
    """(SQUARES, SQUARES) uint8: number of the source that the patch of each square follows, or ``UNKNOWN``."""
    dense: np.ndarray
    """(UNITS, UNITS) bool: what was measured pixel by pixel."""
    wanted: np.ndarray
    """(UNITS, UNITS) bool: what is to be, when all blocks have told what came over their sources."""
    labels: np.ndarray
    """(LABELS, LABELS) uint8: number of the source that is followed, or ``UNKNOWN``."""
    mixture: np.ndarray
    """(CELLS, CELLS) float32: share of the pixels that are a mixture of two sources; NaN where not measured."""
    grey: np.ndarray
    """(CELLS, CELLS) float32: mean of the mosaic; NaN where not measured densely."""
    grain: np.ndarray
    """(CELLS, CELLS) float32: rms of the finest detail of the source that has most of it, DN; NaN likewise."""
    cells: CellTable
    beside: MixtureTable
    """What is mixed of what along its seams."""
    ground: np.ndarray
    """(UNITS, UNITS) int16: number of the source that most of a unit follows, or ``LACKING``, ``EMPTY`` or
    ``PLAIN``."""
    learned: Learned = UNLEARNED
    """What its patches tell of what came over the mosaic."""
    notices: tuple[Message, ...] = ()
    """What could not be read; the block then lacks it."""
    reading: BlockReading = ALL_READ
    """What could be read."""

    @classmethod
    def nothing(cls, request: BlockRequest, notices: tuple[Message, ...]) -> BlockScan:
        """A block of which nothing could be measured; without notices the mosaic has no pixels there."""
        made, window = _Block(request), request.window
        valid = None if notices else np.zeros((window.height, window.width), bool)
        return made.result(valid, notices, BlockReading((window,), False) if notices else ALL_READ)


@measuring()
def scan_block(request: BlockRequest) -> BlockScan:
    """Look at the patches of a block, then measure what they call for. A block that can't be read tells why in its
    notices; it never raises for that."""
    try:
        return _looked_at(request) if request.wanted is None else _measured_where(request.wanted, request)
    except NotCoveredError:
        return BlockScan.nothing(request, ())
    except RasterError as error:
        nothing = BlockScan.nothing(request, (error.message.as_warning(),))
    if request.wanted is None and request.along_seams is not None:
        # What can be read beside given seams is measured, though the block as a whole can't be read to be looked at.
        return replace(nothing, wanted=request.along_seams)
    return nothing


def _looked_at(request: BlockRequest) -> BlockScan:
    """What the patches of a block say, and the units in which they call for more. Raises NotCoveredError or RasterError
    where it can't be read."""
    settings = request.settings
    # Those of a block at the mosaic's edge may be too few for a patch.
    width, height = max(request.window.width, grid.SQUARE_PX), max(request.window.height, grid.SQUARE_PX)
    around = replace(request.window, width=width, height=height)
    pixels = BlockPixels(request.mosaic, request.refs, around, BLOCK_MARGIN_PX if settings.density == FULL else 0)
    made = _Block(request)
    look = look_at_squares(pixels, settings.wavelet, settings.levels)
    midway = middle_sources(pixels, look, 1), middle_sources(pixels, look, 0)
    doubtful = widened(enlarged(look.doubtful, grid.SQUARE_PX // grid.UNIT_PX), 1)  # and a unit around it
    wanted = called_for(look.source, UNKNOWN, midway) | doubtful
    if request.along_seams is not None:
        wanted |= request.along_seams[: wanted.shape[0], : wanted.shape[1]]
    wanted = wanted[: -(-request.window.height // grid.UNIT_PX), : -(-request.window.width // grid.UNIT_PX)]
    if settings.density == FULL:  # all cells between the seams, instead of samples of them
        cells = measure_plain(pixels, look, wanted, settings.wavelet, settings.levels)
    else:
        sides, sampled = grid.UNIT_PX // CELL_PX, look.cells
        sampled = sampled.chosen(~wanted[sampled.row // sides, sampled.column // sides])
        cells = sampled.moved(request.window.row // CELL_PX, request.window.column // CELL_PX)
    made.take_look(look, wanted, cells)
    return made.result(pixels.valid, pixels.notices, BlockReading((), True, pixels.has_sources))


def _measured_where(wanted: np.ndarray, request: BlockRequest) -> BlockScan:
    """What is measured pixel by pixel in some units of a block, (UNITS, UNITS) bool."""
    wanted = wanted[: -(-request.window.height // grid.UNIT_PX), : -(-request.window.width // grid.UNIT_PX)]
    margin_px = 0 if wanted.mean() >= WHOLE_SHARE else None
    pixels, made = BlockPixels(request.mosaic, request.refs, request.window, margin_px), _Block(request)
    waiting = deque(grid.rectangles(wanted))
    unread: list[PixelWindow] = []
    has_mosaic = not waiting
    while waiting:
        window = waiting.popleft()
        try:
            part = _measured(pixels, window, request)
        except NotCoveredError:
            has_mosaic = True
            continue
        except RasterError as error:
            pixels.notices.append(error.message.as_warning())
            unread.append(window.moved_by(request.window.column, request.window.row))
            continue
        has_mosaic = True
        if part is None:
            waiting.extendleft(reversed(_halves(window)))
        else:
            made.take_part(part)
    return made.result(pixels.valid, pixels.notices, BlockReading(tuple(unread), has_mosaic, pixels.has_sources))


def called_for(
    source: np.ndarray, unknown: int = UNKNOWN, midway: tuple[np.ndarray, np.ndarray] | None = None,
    pairs: range | None = None,
) -> np.ndarray:
    """Units between squares that follow different sources, bool; ``source``: (rows, columns) of squares.

    Between two patches there is a seam somewhere; ground of a patch's width beside it is enough, the samples tell the
    rest. ``midway``: what the patches between squares follow, to the right and downwards (``middle_sources``): they
    tell in which half the seam lies. ``pairs``: the rows, and columns, of squares that are compared with the next ones;
    all where None.
    """
    per_square = grid.SQUARE_PX // grid.UNIT_PX
    units = np.zeros([length * per_square for length in source.shape], bool)
    known = source != unknown
    across, down = midway or (None, None)
    for view, labels, there, middles in (
        (units, source, known, across), (units.T, source.T, known.T, None if down is None else down.T),
    ):
        differ = (labels[:, :-1] != labels[:, 1:]) & there[:, :-1] & there[:, 1:]
        for row, column in np.argwhere(differ).tolist():
            if pairs is not None and column not in pairs:
                continue
            first, last = 1, 2 * per_square - 1
            middle = unknown if middles is None else middles[row, column]
            if middle == labels[row, column]:
                first = per_square - 1
            elif middle == labels[row, column + 1]:
                last = per_square + 1
            start = column * per_square
            view[row * per_square : (row + 1) * per_square, start + first : start + last] = True
    return units


def _measured(pixels: BlockPixels, window: PixelWindow, request: BlockRequest) -> DensePart | None:
    """A rectangle by the sources that are followed around it, and that given seams name; by all where they leave
    something over, and where there is but one, which makes no seam. None where these are so many that halves of it,
    with fewer around each, are to be measured instead."""
    placed = window.moved_by(request.window.column, request.window.row)
    everyone = pixels.numbers
    around = set(everyone)
    if request.followed is not None:
        rows, columns = grid.squares_met(window, grid.SQUARE_PX)
        # And those around them, as the array begins a square before.
        nearby = request.followed[rows.start : rows.stop + 2, columns.start : columns.stop + 2]
        around = set(np.unique(nearby).tolist())
    named = set[Optional[int]]()
    if request.pieces is not None:
        near = request.pieces.near(placed, float(grid.MARGIN_PX)).numbers.tolist()
        named = {side for number in near for side in request.beside[number]}
    if None in named:  # nothing says which source lies beside a seam
        named = set()
    likely = tuple(i for i in everyone if i in around or i in named)
    for numbers in dict.fromkeys([likely, everyone] if len(likely) > 1 else [everyone]):
        measured_px = window.width * window.height * len(numbers)
        if measured_px > MOST_MEASURED_PX and max(window.width, window.height) > CROWDED_PX:
            return None
        part = measure_part(pixels, placed, numbers, request.taps, request.settings)
        if part.unexplained <= MOST_UNEXPLAINED:
            break
    return part


def _halves(window: PixelWindow) -> tuple[PixelWindow, PixelWindow]:
    """Across its longer side, in whole squares."""
    length = max(window.width, window.height)
    first = -(-length // (2 * grid.SQUARE_PX)) * grid.SQUARE_PX
    if length == window.width:
        return replace(window, width=first), replace(window, column=window.column + first, width=length - first)
    return replace(window, height=first), replace(window, row=window.row + first, height=length - first)


class _Block:
    """What becomes a BlockScan."""

    def __init__(self, request: BlockRequest) -> None:
        levels, self._window = request.settings.levels, request.window
        dense, wanted = np.zeros((2, grid.UNITS, grid.UNITS), bool)
        mixture, grey, grain = np.full((3, CELLS, CELLS), np.nan, np.float32)
        self._scan = BlockScan(
            request.key, request.numbers, np.full((grid.SQUARES, grid.SQUARES), UNKNOWN, np.uint8), dense, wanted,
            np.full((grid.LABELS, grid.LABELS), UNKNOWN, np.uint8), mixture, grey, grain, CellTable.empty(levels),
            MixtureTable.empty(levels), np.full((grid.UNITS, grid.UNITS), EMPTY, np.int16),
        )
        self._valid = np.ones((grid.LABELS, grid.LABELS), bool)
        self._plain = np.zeros((grid.SQUARES, grid.SQUARES), bool)
        self._learned = UNLEARNED
        self._tables, self._mixtures = [self._scan.cells], [self._scan.beside]

    def take_look(self, look: SquareLook, wanted: np.ndarray, cells: CellTable) -> None:
        """What the patches, and ``cells``, say where nothing more is measured."""
        self._learned = look.learned
        self._scan.wanted[: wanted.shape[0], : wanted.shape[1]] = wanted
        rows, columns = look.source.shape
        self._scan.squares[:rows, :columns] = look.source
        self._plain[:rows, :columns] = look.plain & (look.source == UNKNOWN)
        side = grid.SQUARE_PX // grid.LABEL_PX
        self._scan.labels[: rows * side, : columns * side] = enlarged(look.source, side)
        self._scan.mixture[cells.row % CELLS, cells.column % CELLS] = 0
        self._tables.append(cells)

    def take_part(self, part: DensePart) -> None:
        """What was measured in a rectangle; what sticks out of the block is left out."""
        inside = part.window.moved_by(-self._window.column, -self._window.row).cut_to(grid.BLOCK_PX, grid.BLOCK_PX)
        for name, plane in part.planes.items():
            target = self._valid if name == "valid" else getattr(self._scan, name)
            place = target[grid.squares_met(inside, grid.BLOCK_PX // len(target))]
            place[...] = plane[: place.shape[0], : place.shape[1]]
        self._scan.dense[grid.squares_met(inside, grid.UNIT_PX)] = True
        self._tables.append(part.cells)
        self._mixtures.append(part.beside)

    def _ground(self) -> np.ndarray:
        """Ground of the units as ``BlockScan`` has it."""
        side, scan = grid.LABELS // grid.UNITS, self._scan
        labels, valid = (in_squares(plane, side) for plane in (scan.labels, self._valid))
        rows, columns = (
            np.clip(grid.labels_in(length) - side * np.arange(grid.UNITS), 0, side)
            for length in (self._window.height, self._window.width)
        )
        inside, has_pixels = np.outer(rows, columns), valid.sum(axis=(1, 3))
        held = np.sort(labels.transpose(0, 2, 1, 3).reshape(grid.UNITS, grid.UNITS, -1), axis=2)  # UNKNOWN last
        known = np.count_nonzero(held != UNKNOWN, axis=2)
        middle = np.take_along_axis(held, known[:, :, np.newaxis] // 2, axis=2)[:, :, 0]  # of two that which has more
        ground = np.where(has_pixels - known >= MOST_LACKING * has_pixels, LACKING, middle.astype(np.int16))
        ground[enlarged(self._plain, grid.SQUARE_PX // grid.UNIT_PX) & ~scan.dense] = PLAIN
        is_even = scan.grain <= ROUNDING * np.abs(scan.grey)  # never where that is not known
        ground[in_squares(is_even, CELLS // grid.UNITS).all(axis=(1, 3))] = PLAIN
        ground[inside - has_pixels >= np.maximum(MOST_LACKING * inside, 1)] = EMPTY
        ground[inside == 0] = EMPTY
        return ground

    def result(
        self, valid: np.ndarray | None, notices: Sequence[Message], reading: BlockReading
    ) -> BlockScan:
        """All that was taken; nothing is followed where the mosaic has no pixels, (rows, columns) bool ``valid``."""
        rows, columns = grid.labels_in(self._window.height), grid.labels_in(self._window.width)
        self._valid[rows:], self._valid[:, columns:] = False, False
        if valid is not None:
            self._valid[:rows, :columns] &= valid[SAMPLED][:rows, :columns]
        self._scan.labels[~self._valid] = UNKNOWN
        return replace(
            self._scan, cells=CellTable.joined(self._tables), beside=MixtureTable.joined(self._mixtures),
            ground=self._ground(), learned=self._learned, notices=tuple(dict.fromkeys(notices)), reading=reading,
        )
