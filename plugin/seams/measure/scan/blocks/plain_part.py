"""The ground of a block between its seams, all of it: which source is followed there is known from its patches."""
from __future__ import annotations

from dataclasses import replace

import numpy as np

from .....imagery.wavelets import placed_components
from ...following.boxes import enlarged
from ...following.levelling import SQUARE_PX as TONE_PX
from ...following.levelling import gain_field, square_means
from ...following.source_filters import Filters
from ...profile.cell_table import CELL_PX, CellTable
from ...seam_cells import UNKNOWN
from .block_grid import SQUARE_PX, UNIT_PX
from .block_pixels import BlockPixels, Planes
from .patches import PATCH_PX, SquareLook

MARGIN_PX = 32
"""Around a block: the finest details of its outermost cells need to know so much."""


def measure_plain(
    pixels: BlockPixels, look: SquareLook, dense: np.ndarray, wavelet: str, levels: int
) -> CellTable:
    """The cells of a block but for its ``dense`` units, (rows, columns) bool, in cells of the mosaic.

    Every square is measured by the source that its patch follows. Raises RasterError where the mosaic can't be read.
    """
    own = pixels.window
    rows, columns = -(-own.height // SQUARE_PX) * SQUARE_PX, -(-own.width // SQUARE_PX) * SQUARE_PX
    window = replace(own, width=columns, height=rows).with_margin(MARGIN_PX)
    source = np.where(np.isin(look.source, list(look.learned_of)), look.source, np.uint8(UNKNOWN))
    numbers = np.unique(source[source != UNKNOWN]).tolist()
    if not numbers or look.filters is None:
        return CellTable.empty(levels)
    planes = pixels.part(window, numbers)
    labels = np.pad(enlarged(source, SQUARE_PX), MARGIN_PX, mode="edge")
    for number in numbers:
        if number not in planes.sources:
            labels[labels == number] = UNKNOWN
        elif number in planes.valid:
            labels[(labels == number) & ~planes.valid[number]] = UNKNOWN
    if planes.mosaic_valid is not None:
        labels[~planes.mosaic_valid] = UNKNOWN
    made, gain = _composite(planes, labels, list(planes.sources), look.filters)
    inside = np.s_[MARGIN_PX:-MARGIN_PX, MARGIN_PX:-MARGIN_PX]
    known = _by_cell((labels[inside] != UNKNOWN).astype(np.float32), CELL_PX) == CELL_PX**2
    measured = enlarged(dense, UNIT_PX // CELL_PX)
    known[: measured.shape[0], : measured.shape[1]] &= ~measured
    sums = np.zeros((3, levels, *known.shape), np.float32)
    for level, one in enumerate(placed_components(np.stack([planes.mosaic, made]), wavelet, levels)):
        step = 2 ** (level + 1)
        first, last = MARGIN_PX // step, ((MARGIN_PX + rows) // step, (MARGIN_PX + columns) // step)
        m, c = (one[:, k, first : last[0], first : last[1]] for k in (0, 1))
        for number, (a, b) in enumerate(((m, m), (c, c), (m, c))):
            sums[number, level] = _by_cell(np.einsum("dij,dij->ij", a, b), CELL_PX // step)
    # The gain is even within a cell, and what evens out the background has no detail.
    sums[1] *= gain**2
    sums[2] *= gain
    cell_rows, cell_columns = (
        first // CELL_PX + np.arange(length) for first, length in zip((own.row, own.column), known.shape)
    )
    return CellTable.far(cell_rows, cell_columns, known, sums, levels)


def _composite(
    planes: Planes, labels: np.ndarray, numbers: list[int], filters: Filters
) -> tuple[np.ndarray, np.ndarray]:
    """The sources as sharp as the mosaic shows them, the mosaic itself where none is followed; and by cells, without
    the margin, what their detail is multiplied by in its tones."""
    made = planes.mosaic.copy()
    means = square_means(planes.mosaic)
    gain = np.ones(means.shape, np.float32)
    for number in numbers:
        own = labels == number
        if not own.any():
            continue
        place = _around(own)
        squares = tuple(slice(part.start // TONE_PX, part.stop // TONE_PX) for part in place)
        plane = planes.sources[number][place]
        whole = own[place][TONE_PX // 2 :: TONE_PX, TONE_PX // 2 :: TONE_PX]
        found = gain_field(means[squares], square_means(plane), whole, PATCH_PX // TONE_PX)
        np.copyto(gain[squares], found, where=whole)
        np.copyto(made[place], filters.applied(number, plane), where=own[place])
    margin, per_cell = MARGIN_PX // TONE_PX, CELL_PX // TONE_PX
    inside = gain[margin:-margin, margin:-margin]
    return made, _by_cell(inside, per_cell) / per_cell**2


def _around(mask: np.ndarray) -> tuple[slice, slice]:
    """Rows and columns in which a mask is set, in whole squares of tone."""
    rows, columns = (np.flatnonzero(mask.any(axis=axis)) for axis in (1, 0))
    down, across = (
        slice(int(one[0]) // TONE_PX * TONE_PX, -(-(int(one[-1]) + 1) // TONE_PX) * TONE_PX) for one in (rows, columns)
    )
    return down, across


def _by_cell(values: np.ndarray, side: int) -> np.ndarray:
    """Sums over cells of ``side`` values a side, (rows, columns) float32."""
    rows, columns = values.shape
    down = values.reshape(rows // side, side, columns)
    summed = down[:, 0].copy()
    for row in range(1, side):
        summed += down[:, row]
    return np.asarray(summed.reshape(rows // side, columns // side, side).sum(axis=2))
