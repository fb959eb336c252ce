"""What a mosaic has of its composite's detail: sums over small cells and distances from the seam.

m and c are detail coefficients of the mosaic and of its hard-cut composite. All that is said of a seam follows from the
sums of m m, c c and m c, and sums add up: those of a window, of a strip and of a whole mosaic are one and the same.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy import ndimage

from ..following.boxes import widened
from ..seam_cells import UNKNOWN

CELL_PX = 16
"""Side of a cell."""
EDGES_PX = (0, 2, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256)
"""Where the bins of distance from the seam begin; the last one has no end."""

_GRID_PX = 2  # distances are taken on the grid of the finest coefficients
_UNKNOWN_MARGIN_PX = 8  # what is not explained reaches into its neighbours' coefficients


@dataclass(frozen=True, eq=False)
class DetailCells:
    """Sums by level, bin of distance and cell, each (levels, bins, rows, columns) float64."""

    mm: np.ndarray
    """Energy of the mosaic's detail, DN squared."""
    cc: np.ndarray
    """Energy of the composite's."""
    mc: np.ndarray
    """Their inner product."""
    area: np.ndarray
    """Pixels that the coefficients stand for; those that no source explains are left out."""
    source: np.ndarray
    """(rows, columns) uint8: the source that the middle of each cell follows, or ``UNKNOWN``."""

    @property
    def has_seam(self) -> bool:
        """Whether two sources meet."""
        return bool(self.area[0, :-1].any())


def detail_cells(details: Sequence[np.ndarray], labels: np.ndarray) -> DetailCells:
    """The cells of one window from the details of mosaic and composite, level by level as ``detail_components`` gives
    them: (3, 2 or more planes, rows / 2^r, columns / 2^r).

    ``labels``, (rows, columns): the source that each pixel follows, ``UNKNOWN`` where none explains it; those pixels
    take no part.
    """
    numbers = _bin_numbers(labels)
    rows, columns = (length // CELL_PX for length in labels.shape)
    bins = len(EDGES_PX)
    shape = (len(details), bins, rows, columns)
    sums = {name: np.zeros(shape) for name in ("mm", "cc", "mc", "area")}
    for level, (own, reference) in enumerate((one[:, 0], one[:, 1]) for one in details):
        pixels = 2 ** (level + 1)
        counted = CELL_PX // pixels
        place = np.s_[: rows * counted, : columns * counted]
        step = pixels // _GRID_PX
        index = numbers[step // 2 :: step, step // 2 :: step][place] * (rows * columns)
        index += (np.arange(rows * counted) // counted * columns)[:, np.newaxis]
        index += np.arange(columns * counted) // counted
        index = index.ravel()
        for name, products in (
            ("mm", _summed(own, own)), ("cc", _summed(reference, reference)), ("mc", _summed(own, reference))
        ):
            found = np.bincount(index, products[place].ravel(), (bins + 1) * rows * columns)
            sums[name][level] = found[: bins * rows * columns].reshape(shape[1:])
        found = np.bincount(index, minlength=(bins + 1) * rows * columns) * pixels**2
        sums["area"][level] = found[: bins * rows * columns].reshape(shape[1:])
    middle = labels[CELL_PX // 2 :: CELL_PX, CELL_PX // 2 :: CELL_PX][:rows, :columns]
    return DetailCells(source=middle.astype(np.uint8), **sums)


def _bin_numbers(labels: np.ndarray) -> np.ndarray:
    """The bin of distance from the nearest seam on a grid of 2 px; one more than there are where no source explains."""
    seam, explained = seam_samples(labels), explained_samples(labels)
    if seam.any():
        row, column = ndimage.distance_transform_edt(~seam, return_distances=False, return_indices=True)
        row -= np.arange(len(seam), dtype=row.dtype)[:, np.newaxis]
        column -= np.arange(seam.shape[1], dtype=column.dtype)
        row *= row
        column *= column
        row += column
        numbers = _bins_of_squares()[np.minimum(row, (EDGES_PX[-1] // _GRID_PX) ** 2, out=row)]
    else:
        numbers = np.full(seam.shape, len(EDGES_PX) - 1, np.intp)
    if not explained.all():
        numbers[~explained] = len(EDGES_PX)
    return numbers


def seam_samples(labels: np.ndarray) -> np.ndarray:
    """On the grid of the finest coefficients those beside which another source is followed, (rows / 2, columns / 2)
    bool."""
    coarse = np.ascontiguousarray(labels[::_GRID_PX, ::_GRID_PX])
    known = coarse != UNKNOWN
    seam = np.zeros(coarse.shape, bool)
    for here, there in ((np.s_[:, :-1], np.s_[:, 1:]), (np.s_[:-1], np.s_[1:])):
        meet = (coarse[here] != coarse[there]) & known[here] & known[there]
        seam[here] |= meet
        seam[there] |= meet
    return seam


def explained_samples(labels: np.ndarray) -> np.ndarray:
    """On the grid of the finest coefficients those that take part, (rows / 2, columns / 2) bool."""
    known = labels[::_GRID_PX, ::_GRID_PX] != UNKNOWN
    return known if known.all() else ~widened(~known, _UNKNOWN_MARGIN_PX // _GRID_PX)


@cache
def _bins_of_squares() -> np.ndarray:
    """The bin of each squared distance, samples of the grid squared."""
    squares = np.arange((EDGES_PX[-1] // _GRID_PX) ** 2 + 1)
    return np.digitize(np.sqrt(squares) * _GRID_PX, EDGES_PX) - 1


def _summed(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The products of three details, (3, rows, columns), together."""
    return np.einsum("dij,dij->ij", a, b)
