"""Samples and the squares around them: sums and borders, from runs that double, a few additions whatever the side; and
parts of samples that are too small to be believed."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy import ndimage

SMALLEST_PART_PX = 600
"""Pixels of one source on their own that are believed; a square of 24 px."""
PIECE_PX = 128
"""Rows worked on at a time, so that what lies between two passes stays in the cache."""


def square_sums(a: np.ndarray, b: np.ndarray, side: int) -> np.ndarray:
    """Sums of a x b, (rows, columns) each, over squares of ``side``, a power of two up to ``PIECE_PX``; without what
    sticks out of whole squares."""
    rows, columns = (length // side for length in a.shape)
    whole, piece = slice(columns * side), PIECE_PX // side
    sums = np.empty((rows, columns), np.float32)
    for start in range(0, rows, piece):
        part = slice(start * side, min(start + piece, rows) * side)
        sums[start : start + piece] = _summed(a[part, whole] * b[part, whole], side)
    return sums


def square_shares(values: np.ndarray, side: int) -> np.ndarray:
    """Means of values, or shares of a mask (rows, columns), over such squares, float32."""
    rows, columns = (length // side * side for length in values.shape)
    sums = _summed(values[:rows, :columns].astype(np.float32, copy=False), side)
    return np.asarray(sums * np.float32(1 / side**2))


def _summed(part: np.ndarray, side: int) -> np.ndarray:
    """Over squares, by halves: numpy takes three times as long over runs of four. Whole rows first are fastest."""
    for _ in range(side.bit_length() - 1):
        part = part[0::2] + part[1::2]
    for _ in range(side.bit_length() - 1):
        part = part[:, 0::2] + part[:, 1::2]
    return part


def box_means(values: np.ndarray, sides: Sequence[int], mirrored: bool = False) -> list[np.ndarray]:
    """Means over squares of odd sides around samples (rows, columns), float32; edges go on as they are or mirrored."""
    samples, mode = values.astype(np.float32, copy=False), "reflect" if mirrored else "nearest"
    return [ndimage.uniform_filter(samples, side, mode=mode) for side in sides]


def box_counts(mask: np.ndarray, side: int) -> np.ndarray:
    """How many are set in squares of an odd side, up to 15, around every sample, (rows, columns) uint8; the edges
    continue as they are."""
    return runs(runs(np.pad(mask.view(np.uint8), side // 2, "edge"), side, 0, np.add), side, 1, np.add)


def near_border(labels: np.ndarray, reach: int) -> np.ndarray:
    """Samples in whose square of 2 ``reach`` + 1 there is more than one label, (rows, columns) bool."""
    across, down = labels[:, 1:] != labels[:, :-1], labels[1:] != labels[:-1]
    # Where a square has two labels, two neighbours in it have.
    return _dilated(across, 2 * reach + 1, 2 * reach, reach) | _dilated(down, 2 * reach, 2 * reach + 1, reach)


def widened(mask: np.ndarray, reach: int) -> np.ndarray:
    """Samples in whose square of 2 ``reach`` + 1 one is set, (rows, columns) bool."""
    return _dilated(mask, 2 * reach + 1, 2 * reach + 1, reach)


def narrowed(mask: np.ndarray, reach: int) -> np.ndarray:
    """Samples in whose square of 2 ``reach`` + 1 all are set, (rows, columns) bool; beyond the edges all are."""
    return mask if mask.all() else ~widened(~mask, reach)


def opened(mask: np.ndarray, side: int) -> np.ndarray:
    """What squares of ``side`` samples that are wholly set cover, (rows, columns) bool."""
    return _dilated(runs(runs(mask, side, 0, np.logical_and), side, 1, np.logical_and), side, side, side - 1)


def enlarged(samples: np.ndarray, times: int, shape: tuple[int, ...] | None = None) -> np.ndarray:
    """Each sample (rows, columns) as a square of as many along both sides; with a ``shape``, what sticks out of whole
    squares as those beside it."""
    squares = samples.repeat(times, axis=1).repeat(times, axis=0)  # whole rows last are faster
    if shape is None or squares.shape == shape:
        return squares
    return np.pad(squares, [(0, length - have) for length, have in zip(shape, squares.shape)], mode="edge")


def in_squares(values: np.ndarray, side: int) -> np.ndarray:
    """The whole squares of ``side`` samples of (rows, columns): (rows of squares, side, columns of squares, side)."""
    rows, columns = (length // side for length in values.shape)
    return values[: rows * side, : columns * side].reshape(rows, side, columns, side)


def runs(values: np.ndarray, length: int, axis: int, together: np.ufunc) -> np.ndarray:
    """Runs of ``length`` samples along an axis, those that are wholly inside, each put together."""
    count = values.shape[axis] - length + 1
    combined, taken, part, width = None, 0, values, 1
    while True:
        if length & width:
            piece = _along(part, axis, taken, taken + count)
            combined = piece if combined is None else together(combined, piece)
            taken += width
        if 2 * width > length:
            break
        held = part.shape[axis] - width
        part = together(_along(part, axis, 0, held), _along(part, axis, width, width + held))
        width *= 2
    assert combined is not None
    return combined


def _along(values: np.ndarray, axis: int, start: int, stop: int) -> np.ndarray:
    return values[:, start:stop] if axis else values[start:stop]


def _dilated(mask: np.ndarray, down: int, across: int, pad: int) -> np.ndarray:
    padded = np.zeros((mask.shape[0] + 2 * pad, mask.shape[1] + 2 * pad), bool)
    padded[pad : pad + mask.shape[0], pad : pad + mask.shape[1]] = mask
    return runs(runs(padded, down, 0, np.logical_or), across, 1, np.logical_or)


def without_islands(labels: np.ndarray, least: int) -> np.ndarray:
    """Parts of fewer than ``least`` samples go with what is nearest to them; labels (rows, columns) uint8."""
    numbers = np.flatnonzero(np.bincount(labels.ravel(), minlength=1))
    if len(numbers) == 1:
        return labels
    small = np.zeros(labels.shape, bool)
    for number in numbers.tolist():
        parts, count = ndimage.label(labels == number)
        few = np.bincount(parts.ravel(), minlength=count + 1) < least
        few[0] = False
        if few.any():
            small |= few[parts]
    return filled_in(labels, small)


def filled_in(labels: np.ndarray, open_to: np.ndarray) -> np.ndarray:
    """What is ``open_to`` what surrounds it goes with what is nearest, (rows, columns); labels if all or nothing is."""
    if not open_to.any() or open_to.all():
        return labels
    filled, small = labels.copy(), open_to
    islands, _ = ndimage.label(small, np.ones((3, 3)))
    for number, place in enumerate(ndimage.find_objects(islands), 1):
        # What is nearest to an island touches it.
        around = tuple(slice(max(part.start - 1, 0), part.stop + 1) for part in place)
        nearest = ndimage.distance_transform_edt(small[around], return_distances=False, return_indices=True)
        np.copyto(filled[around], labels[around][tuple(nearest)], where=islands[around] == number)
    return filled
