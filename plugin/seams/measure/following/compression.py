"""Traces of compression in squares of 8 px, as JPEG leaves them: fine waves vanish in the squares of one grid (Fan and
de Queiroz 2003)."""
from __future__ import annotations

from collections.abc import Collection
from functools import cache
from typing import Callable

import numpy as np
from scipy import fft

from ....imagery.wavelets import product

IsCompressed = Callable[["int | None"], bool]
"""Whether the mosaic or a source shows traces of a codec; of None whether any of them does."""
JPEG_SQUARE_PX = 8
MIN_VANISHED = 0.05
"""Share of the fine waves that vanish on one grid more than on others: JPEG of 60 to 95 has 0.3 to 0.65, images that
were resampled from JPEGs up to 0.033."""

_VANISHED_DN = 1.5  # of an amplitude: five times what rounding to whole values makes of one that is 0
_HIGH_FREQUENCY = 6  # of 0 to 14, both axes together
_SAMPLED_SQUARES = 400  # at most, of each of the 64 grids: 17,000 waves to tell a share of some per cent by


def was_compressed(plane: np.ndarray) -> bool:
    """Whether an image shows traces of JPEG.

    Parameters
    ----------
    plane : (rows, columns)
        Grey values of 8 bit as they were read, neither filtered nor resampled.
    """
    return vanished_share(plane) > MIN_VANISHED


def compressed_sides(mosaic_was: bool, plane_of: Callable[[int], np.ndarray], sources: Collection[int]) -> IsCompressed:
    """Whether a mosaic ``mosaic_was`` compressed, or planes of its sources were, each looked at when it is asked of."""
    source_was = cache(lambda number: was_compressed(plane_of(number)))
    return lambda number: mosaic_was or (any(map(source_was, sources)) if number is None else source_was(number))


def vanished_share(plane: np.ndarray) -> float:
    """Share of the fine waves that vanish on the best of the 64 grids of squares, less that on the others.

    Parameters
    ----------
    plane : (rows, columns)
        Grey values in units of 8 bit.
    """
    side = JPEG_SQUARE_PX
    basis = fft.dct(np.eye(side), axis=0, norm="ortho").astype(np.float32)
    rows, columns = (length // side - 1 for length in plane.shape)
    if min(rows, columns) < 1:
        return 0.0
    step = int(np.ceil(np.sqrt(rows * columns / _SAMPLED_SQUARES)))
    fine = np.add.outer(np.arange(side), np.arange(side)) >= _HIGH_FREQUENCY
    transform = np.kron(basis, basis)[fine.ravel()].T.copy()  # of a square's 64 pixels at once
    shares = []
    for top in range(side):
        for leftmost in range(side):
            part = plane[top : top + rows * side, leftmost : leftmost + columns * side]
            squares = part.reshape(rows, side, columns, side)[::step, :, ::step].swapaxes(1, 2)
            waves = product(squares.reshape(-1, side**2).astype(np.float32, copy=False), transform)
            shares.append(int(np.count_nonzero(np.abs(waves, out=waves) < _VANISHED_DN)) / waves.size)
    best = int(np.argmax(shares))
    return shares[best] - float(np.median(np.delete(shares, best)))
