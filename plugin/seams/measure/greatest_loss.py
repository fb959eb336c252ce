"""Where in a window the mosaic lost most detail: the part that is worth to be shown."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np

_BLOCK = 16  # px: the part is found to this precision


def greatest_loss(mosaic: np.ndarray, sources: Sequence[np.ndarray], side: int) -> tuple[int, int]:
    """First row and column of the square of ``side`` px where most of the finest detail is gone.

    mosaic, sources: (rows, columns) of one band each, all of the same shape. It is the square in which the energy of
    the detail at level 1 (by the Haar wavelet, which needs no neighbours) fell furthest below that of every source;
    without sources the one in the middle.
    """
    rows, columns = mosaic.shape
    if not sources or min(rows, columns) < side + _BLOCK:
        return max(rows - side, 0) // 2, max(columns - side, 0) // 2
    lost = np.minimum.reduce([_detail_energy(source) for source in sources]) - _detail_energy(mosaic)
    blocks = max(1, side // _BLOCK)
    sums = np.pad(lost, ((1, 0), (1, 0))).cumsum(axis=0).cumsum(axis=1)
    squares = sums[blocks:, blocks:] - sums[:-blocks, blocks:] - sums[blocks:, :-blocks] + sums[:-blocks, :-blocks]
    row, column = np.unravel_index(np.argmax(squares), squares.shape)
    return min(int(row) * _BLOCK, rows - side), min(int(column) * _BLOCK, columns - side)


def _detail_energy(band: np.ndarray) -> np.ndarray:
    """Energy of the Haar details at level 1 in every block."""
    rows, columns = (length // _BLOCK * _BLOCK for length in band.shape)
    values = band[:rows, :columns].astype(np.float32)
    corners = values[0::2, 0::2], values[0::2, 1::2], values[1::2, 0::2], values[1::2, 1::2]
    energy = sum(corner * corner for corner in corners) - np.square(sum(corners)) / 4
    half = _BLOCK // 2
    return np.asarray(energy).reshape(rows // _BLOCK, half, columns // _BLOCK, half).sum(axis=(1, 3), dtype=np.float64)
