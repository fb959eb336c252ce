"""How much the details of the quietest ground vary: on no level can there be more noise than that."""
from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy import stats

CELL = 4  # coefficients along a side: 48 of the three components give a variance to 20 %
MIN_CELLS = 9  # fewer are no choice of ground
LEAST_SHARE = 0.002  # of the cells: the quietest there are; fewer would be chance
QUIET_SHARE = 0.05  # of the cells: quiet ground
_QUARTER = 0.25
_FREE = 40  # values of a cell that count as independent: 48 of white noise, fewer of grain


@dataclass(frozen=True)
class QuietGround:
    """The details of one level and band where the ground is quiet: standard deviations of noise that gives as much."""

    least: float
    """On the quietest ground, DN: noise has no more."""
    quiet: float
    """On the quietest twentieth of the ground, DN."""
    unevenness: float
    """By how much the quietest quarter exceeds the twentieth: 1 in pure noise, more where the ground differs."""


def quiet_ground(details: np.ndarray, usable: np.ndarray | None = None) -> QuietGround | None:
    """What the quiet ground of a level has; None where there are too few cells to choose from.

    ``details`` is (3, rows, columns), one level of one band without the coefficients at its border; ``usable``, (rows,
    columns) of bool, leaves out more. The ground is cut into cells of 4 x 4 coefficients. Of cells with nothing but
    noise the quieter ones are so by chance, which is allowed for (chi-square).
    """
    rows, columns = (size // CELL * CELL for size in details.shape[1:])
    shape = (rows // CELL, CELL, columns // CELL, CELL)
    squares = np.square(details[:, :rows, :columns], dtype=np.float64).sum(axis=0)
    means = squares.reshape(shape).sum(axis=(1, 3)) / (3 * CELL * CELL)
    if usable is not None:
        means = means[usable[:rows, :columns].reshape(shape).all(axis=(1, 3))]
    if means.size < MIN_CELLS:
        return None
    shares = (max(LEAST_SHARE, 1 / (means.size + 1)), QUIET_SHARE, _QUARTER)
    least, quiet, quarter = (
        math.sqrt(found) / _by_chance(share) for found, share in zip(np.quantile(means, shares), shares)
    )
    return QuietGround(least, quiet, quarter / quiet if quiet > 0 else math.inf)


@lru_cache(maxsize=4096)
def _by_chance(share: float) -> float:
    """The standard deviation that such a share of cells stays below in noise of standard deviation 1."""
    return math.sqrt(stats.chi2.ppf(share, _FREE) / _FREE)


def clipped_pixels(bands: np.ndarray) -> np.ndarray:
    """(rows, columns): where any band is cut off, its smallest or largest value amid more of it. No noise is there."""
    found = np.zeros(bands.shape[1:], bool)
    for band in bands:
        for value in (band.min(), band.max()):
            same = band == value
            amid = same.copy()
            amid[1:] &= same[:-1]
            amid[:-1] &= same[1:]
            amid[:, 1:] &= same[:, :-1]
            amid[:, :-1] &= same[:, 1:]
            found |= amid
    return found
