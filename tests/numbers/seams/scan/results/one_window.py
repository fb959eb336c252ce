"""One window with known seams as the scan holds it: a table, the seam's pieces, the ground."""
from __future__ import annotations

import numpy as np
from seam_inspector.plugin.imagery.grids import Grid, PixelWindow
from seam_inspector.plugin.seams.measure.blocks.block_grid import LABEL_PX, LABELS, SQUARES, UNITS
from seam_inspector.plugin.seams.measure.blocks.scan_block import CELLS, BlockScan
from seam_inspector.plugin.seams.measure.profile.cell_table import CELL_PX
from seam_inspector.plugin.seams.measure.profile.seam_sums import StripProfile
from seam_inspector.plugin.seams.measure.profile.window_detail import WindowDetail
from seam_inspector.plugin.seams.measure.scan.piece_sums import PieceSums
from seam_inspector.plugin.seams.measure.seam_cells import UNKNOWN
from seam_inspector.plugin.seams.measure.seamlines.seam_pieces import PieceIndex, SeamPiece

from tests.numbers.seams.profile.blends import LEVELS, SIDE, Blend

GRID = Grid(1000.0, 2000.0, 0.1, 0.1, SIDE, SIDE)
WINDOW = PixelWindow(0, 0, SIDE, SIDE)


def pieces_of(made: Blend, count: int = 1, grid: Grid = GRID) -> list[SeamPiece]:
    """Pieces of the seam that runs from top to bottom, of equal numbers of rows."""
    rows = np.arange(SIDE)
    columns = made.labels.argmax(axis=1).astype(float)
    vertices = np.column_stack([grid.left + columns * grid.pixel_width, grid.top - (rows + 0.5) * grid.pixel_height])
    cuts = np.linspace(0, SIDE - 1, count + 1).astype(int)
    pieces = []
    for first, last in zip(cuts, cuts[1:]):
        part = vertices[first : last + 1]
        length = float(np.hypot(*np.diff(part, axis=0).T).sum())
        pieces.append(SeamPiece(1, sum(piece.length_m for piece in pieces), length, part, 0, 1))
    return pieces


def sums_of(pieces: list[SeamPiece], grid: Grid = GRID) -> PieceSums:
    """Sums of all pieces."""
    return PieceSums(np.arange(len(pieces)), PieceIndex(pieces, grid), LEVELS)


def profiles_of(detail: WindowDetail, pieces: list[SeamPiece]) -> list[StripProfile]:
    """Profiles by the window's own ground."""
    sums = sums_of(pieces)
    sums.add(detail.cells, detail.mixture, detail.ground, WINDOW)
    return sums.profiles()


def scan_of_window(detail: WindowDetail, labels: np.ndarray) -> BlockScan:
    """The first block of a mosaic that is no more than the window."""
    full = np.full((LABELS, LABELS), UNKNOWN, np.uint8)
    coarse = labels[LABEL_PX // 2 :: LABEL_PX, LABEL_PX // 2 :: LABEL_PX]
    full[: coarse.shape[0], : coarse.shape[1]] = coarse
    mixture = np.full((CELLS, CELLS), np.nan, np.float32)
    count = SIDE // CELL_PX
    mixture[:count, :count] = np.linspace(0, 1, count**2).reshape(count, count)
    return BlockScan(
        (0, 0), (0, 1), np.full((SQUARES, SQUARES), UNKNOWN, np.uint8), *np.zeros((2, UNITS, UNITS), bool), full,
        mixture, mixture.copy(), mixture.copy(), detail.cells, detail.mixture,
        np.zeros((UNITS, UNITS), bool),
    )
