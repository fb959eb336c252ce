"""What blocks tell once they and their neighbours are measured.

Of one block: the borders of what it follows, what its ground makes one expect, its part of the picture of losses. And
what is kept along pieces of seam: the cells of all blocks beside them, added up to the piece that is nearest.
"""
from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import product

import numpy as np

from ....imagery.grids import Grid, PixelWindow
from ....imagery.lines import points_at, vertex_stations
from ....imagery.records import RecordFiles
from ....imagery.seam_totals import KeptBeside, profile_text
from ..blocks.block_grid import BLOCK_PX, LABEL_PX, LABELS, UNITS, BlockGrid, BlockKey, squares_met
from ..blocks.scan_block import CELLS, NOT_LOOKED, BlockScan
from ..profile.cell_table import CELL_PX, EDGES_PX, MIXED_BINS, CellTable, MixtureTable
from ..profile.detail_sums import ROUNDING
from ..profile.ground import FAR_PX, LevelGround, grounds
from ..profile.seam_profile import STRIP_PX, SeamProfile, strip_bins
from ..profile.seam_sums import SeamSums, StripProfile
from ..seam_cells import NONE
from ..seamlines.seam_pieces import PieceIndex, SeamPiece, around_pieces, sources_beside
from ..seamlines.seam_tracing import MARGIN, cleaned_edges
from ..workers import measuring
from .block_runs import whole_block
from .loss_raster import NODATA, loss_cells
from .scan_result import PieceFigures

REACH_PX = 144.0
"""How far from a piece cells are counted to it: what lies beyond is ground."""
MOST_ASIDE_PX = 40.0
"""How far a line may lie from the seam that the mosaic shows, for that to be its seam."""


@dataclass(frozen=True, eq=False)
class BlockOutputs:
    """What comes back."""

    key: BlockKey
    edges: np.ndarray
    """(4, n) of its borders, as ``cleaned_edges`` has them."""
    cells: np.ndarray | None
    """``loss_cells``, its sources numbered from 1 on as in the whole scan; None where nothing is shown."""
    sources: Sequence[int]
    """That are followed anywhere, ascending."""
    ground: np.ndarray
    """(UNITS, UNITS) int32: as ``BlockScan`` has it, with the numbers of the whole scan."""


def _ground_of(files: RecordFiles, key: BlockKey, scan: BlockScan) -> list[LevelGround | None]:
    """What the ground of a block, or of that with its neighbours, makes one expect, by level."""

    def with_neighbours() -> CellTable:
        near = [(key[0] + down, key[1] + across) for down, across in product((-1, 0, 1), repeat=2) if down or across]
        measured = [whole_block(files, beside) for beside in near]
        return CellTable.joined([scan.cells, *(beside.cells for beside in measured if beside is not None)])

    return grounds(scan.cells, with_neighbours)


@measuring()
def block_outputs(
    files: RecordFiles, size: tuple[int, int], cell_px: int, traces: bool, key: BlockKey
) -> BlockOutputs:
    """Outputs of one block. Raises SettingsError where what was measured can't be read any more.

    ``size``: columns and rows of labels of the whole mosaic; ``cell_px``: side of the picture's cells, 0 where none is
    wanted; ``traces``: whether borders are.
    """
    scan, edges = whole_block(files, key), np.zeros((4, 0), np.int64)
    tile = _label_tile(key).cut_to(*size)
    if traces and tile.width and tile.height:
        around = tile.with_margin(MARGIN).cut_to(*size)
        edges = cleaned_edges(_labels_in(around, files, key, scan), tile, size, LABEL_PX)
    if scan is None:
        return BlockOutputs(key, edges, None, (), np.full((UNITS, UNITS), NOT_LOOKED, np.int32))
    cells = loss_cells(scan, scan.labels + 1, _ground_of(files, key, scan), cell_px) if cell_px else None
    if cells is not None and (cells == NODATA).all():
        cells = None
    used = np.flatnonzero(np.bincount(scan.labels.ravel() - NONE)[1:]).tolist()
    return BlockOutputs(key, edges, cells, used, scan.ground)


def _label_tile(key: BlockKey) -> PixelWindow:
    return PixelWindow(key[1] * LABELS, key[0] * LABELS, LABELS, LABELS)


def _labels_in(around: PixelWindow, files: RecordFiles, key: BlockKey, scan: BlockScan | None) -> np.ndarray:
    """Labels of a block, and of as much of its neighbours as cleaning has to know."""
    labels_around = np.full((around.height, around.width), NONE, np.int32)
    rows, columns = squares_met(around, LABELS)
    for beside in product(range(rows.start, rows.stop), range(columns.start, columns.stop)):
        tile = _label_tile(beside).moved_by(-around.column, -around.row)
        shared = tile.cut_to(around.width, around.height)
        if (held := scan if beside == key else whole_block(files, beside)) is not None:
            place = squares_met(shared.moved_by(-tile.column, -tile.row), 1)
            labels_around[squares_met(shared, 1)] = held.labels[place]
    return labels_around


Pieces = tuple[Sequence[SeamPiece], np.ndarray, PieceIndex]
"""Some pieces, their numbers, ascending, in an index, and that, with all that lies near them."""


@measuring()
def measure_pieces(
    files: RecordFiles, blocks: BlockGrid, levels: int, looks_beside: bool, request: Pieces
) -> tuple[list[PieceFigures], float]:
    """Some pieces by the blocks around them, their profiles without bins; and the brightest cell of any strip.
    ``looks_beside``: whether it is asked which sources lie beside them. Raises SettingsError where what was measured
    can't be read any more."""
    (pieces, numbers, index), grid = request, blocks.grid
    around = around_pieces(pieces, grid, REACH_PX)
    place = squares_met(around, CELL_PX)
    sums, along = PieceSums(numbers, index, levels), _cells_along(pieces, grid)
    grain = np.full(len(pieces), np.nan)
    for key in blocks_of(around, blocks):
        window = blocks.window(key)
        scan = whole_block(files, key) if np.isin(index.near(window, REACH_PX).numbers, numbers).any() else None
        if scan is not None:
            ground = _ground_of(files, key, scan)
            sums.add(scan.cells.within(place), scan.beside.within(place), ground, window, scan.grey)
            piece, row, column = along[:, (along[1:] // CELLS == np.array(key)[:, np.newaxis]).all(axis=0)]
            np.fmax.at(grain, piece, scan.grain[row % CELLS, column % CELLS])
    grey, brightest = sums.grey
    sides: list[tuple[int, int] | None] = [None] * len(pieces)
    unchanged = [False] * len(pieces)
    if looks_beside:
        labels = partial(_labels_at, files, blocks)
        beside = sources_beside(pieces, labels, grid, LABEL_PX)
        aside = sources_beside(pieces, labels, grid, LABEL_PX, (MOST_ASIDE_PX - 8, MOST_ASIDE_PX))
        is_unchanged = (beside[:, 0] != NONE) & (np.hstack([beside, aside]) == beside[:, :1]).all(axis=1)
        sides, unchanged = [(left, right) for left, right in beside.tolist()], is_unchanged.tolist()
    strips = without_even(sums.profiles(), grain, grey)
    texts = [_profile_text(strip.profile, grid.ground_sample_distance) for strip in strips]
    strips = [replace(strip, profile=strip.profile and replace(strip.profile, bins=())) for strip in strips]
    figures = zip(pieces, strips, grey.tolist(), grain.tolist(), texts, sides, unchanged)
    return [PieceFigures(*measured) for measured in figures], brightest


def _profile_text(profile: SeamProfile | None, pixel_m: float) -> str:
    if profile is None or profile.kept[0] is None:
        return ""
    bins = [bin_ for bin_ in profile.bins if bin_.level == 1 and bin_.far_px <= EDGES_PX[MIXED_BINS]]
    return profile_text((
        KeptBeside(0, STRIP_PX * pixel_m, profile.kept[0]),
        *(KeptBeside(bin_.near_px * pixel_m, bin_.far_px * pixel_m, bin_.kept) for bin_ in bins),
    ))


def without_even(strips: Sequence[StripProfile], grain: np.ndarray, grey: np.ndarray) -> list[StripProfile]:
    """Pieces along even ground without a profile: what little detail is there reaches in from beside, and its ratios
    are those of rounding. ``grain``, ``grey``: (pieces,) as ``PieceFigures`` has them."""
    is_even = grain <= ROUNDING * np.abs(grey)  # never where that is not known
    return [replace(strip, profile=None) if even else strip for strip, even in zip(strips, is_even.tolist())]


def blocks_of(around: PixelWindow, blocks: BlockGrid) -> list[BlockKey]:
    """The blocks that a window meets, row by row."""
    rows, columns = squares_met(around.cut_to(blocks.grid.columns, blocks.grid.rows), BLOCK_PX)
    return [(row, column) for row in range(rows.start, rows.stop) for column in range(columns.start, columns.stop)]


def by_blocks(pieces: Sequence[SeamPiece], blocks: BlockGrid, together: int = 1) -> list[np.ndarray]:
    """Numbers of pieces by the block that their middles lie in, or by so many that lie side by side, row by row."""
    of_block: defaultdict[BlockKey, list[int]] = defaultdict(list)
    for number, piece in enumerate(pieces):
        middle = piece.vertices[len(piece.vertices) // 2][np.newaxis]
        column, row = blocks.grid.to_pixels(middle)[0] // BLOCK_PX
        of_block[int(row), int(column) // together].append(number)
    return [np.array(of_block[key]) for key in sorted(of_block)]


def _labels_at(files: RecordFiles, blocks: BlockGrid, columns: np.ndarray, rows: np.ndarray) -> np.ndarray:
    """Labels at places, as ``LabelsAt`` gives them."""
    labels_at = np.full(columns.shape, NONE, np.int32)
    inside = (columns >= 0) & (rows >= 0) & (columns < blocks.columns * LABELS) & (rows < blocks.rows * LABELS)
    number = np.where(inside, rows // LABELS * blocks.columns + columns // LABELS, -1)
    for block in np.unique(number[inside]).tolist():
        scan, in_block = whole_block(files, divmod(block, blocks.columns)), number == block
        if scan is not None:
            labels_at[in_block] = scan.labels[rows[in_block] % LABELS, columns[in_block] % LABELS]
    return labels_at


class PieceSums:
    """Adds up blocks; then tells every piece."""

    def __init__(self, numbers: np.ndarray, index: PieceIndex, levels: int) -> None:
        """``numbers`` (pieces,) of those that are measured, ascending; ``index``: they and all others near them."""
        self._numbers, self._index = numbers, index
        self._sums = SeamSums(len(numbers), levels)
        self._grey = np.zeros((2, len(numbers)))  # of the strip's cells: mean of the mosaic times area, and area
        self._brightest = 0.0

    def add(
        self, table: CellTable, mixture: MixtureTable, ground: Sequence[LevelGround | None], window: PixelWindow,
        grey: np.ndarray | None = None,
    ) -> None:
        """The cells of one block. ``mixture`` has numbers of sources that mean the same in all blocks. ``grey``: means
        of the mosaic as ``BlockScan`` has them, None where not known."""
        index = self._index.near(window, REACH_PX)
        whole = table.whole
        beside = np.flatnonzero(whole.bin < MIXED_BINS)
        if not len(beside) or not len(index):
            return
        near = index.beside((whole.column[beside] + 0.5) * CELL_PX, (whole.row[beside] + 0.5) * CELL_PX, REACH_PX)
        nearest = np.array(EDGES_PX)[whole.bin[beside]]
        is_its_own = (near.distance_px <= nearest + MOST_ASIDE_PX) | (nearest >= FAR_PX)
        place = np.searchsorted(self._numbers, near.number).clip(0, len(self._numbers) - 1)
        piece_of = np.full(len(whole), -1)
        piece_of[beside] = np.where(is_its_own & (self._numbers[place] == near.number), place, -1)
        piece = np.where(table.bin < MIXED_BINS, piece_of[table.cell], -1)
        if grey is not None:
            strip = (table.bin < strip_bins(0).stop) & (piece >= 0)
            values, area = grey[table.row[strip] % CELLS, table.column[strip] % CELLS], table.area[0, strip]
            self._grey += [np.bincount(piece[strip], weights, len(self._numbers)) for weights in (area * values, area)]
            self._brightest = float(np.fmax.reduce(values, initial=self._brightest))
        self._sums.add(table, mixture, ground, piece)

    def profiles(self) -> list[StripProfile]:
        """Profiles of every piece, in their order."""
        return self._sums.profiles(levels=1)

    @property
    def grey(self) -> tuple[np.ndarray, float]:
        """Mean of the mosaic in the strip of every piece, NaN where it is not known, and its brightest cell."""
        total, area = self._grey
        return np.divide(total, area, out=np.full(len(area), np.nan), where=area > 0), self._brightest


def _cells_along(pieces: Sequence[SeamPiece], grid: Grid) -> np.ndarray:
    """The cells that pieces run through, (3, n) int: place of the piece, row and column."""
    cells = [np.zeros((3, 0), np.int64)]
    for place, piece in enumerate(pieces):
        path = grid.to_pixels(piece.vertices)
        along = vertex_stations(path)
        count = max(int(along[-1] // CELL_PX), 1)
        column, row = np.floor(points_at(path, along, (np.arange(count) + 0.5) / count * along[-1]) / CELL_PX).T
        cells.append(np.stack([np.full(count, place), row, column]).astype(np.int64))
    return np.concatenate(cells, axis=1)
