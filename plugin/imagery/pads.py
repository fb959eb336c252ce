"""Pads of black or white around an image whose file names no value for them: they are no ground.

JPEG leaves them a few grey values off, and its squares beside them hold both.
"""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy import ndimage

CORNER_PX = 16
"""Side of the squares at an image's corners, one of which is wholly of its pads."""
PAD_PX = 64
"""Side of a square that is wholly of a pad, px: 6 m at 0.1 m, more than shadows without any light. At the edge of what
was read, beyond which it goes on, half of it."""
BESIDE_PX = 8
"""Pixels beside a pad that a square of JPEG may share with it."""
_MOST_OFF = 3  # DN of 8 bit, off black or white: what JPEG 60 leaves of pads


def pad_values(corners: Sequence[np.ndarray]) -> tuple[int, ...]:
    """The values of pads by squares at an image's corners, (bands, rows, columns) of integers each: 0 for black, the
    largest one of the data type for white; none where no square is wholly of either."""
    values = (0, int(np.iinfo(corners[0].dtype).max)) if corners and corners[0].dtype.kind == "u" else ()
    return tuple(value for value in values if any(_is_of(corner, value).all() for corner in corners))


def may_have_pads(bands: np.ndarray) -> bool:
    """Whether any of the places that a pad in these bands, (bands, rows, columns), can't miss is black or white."""
    if bands.dtype.kind != "u":
        return False
    few = bands[:, :: PAD_PX // 2, :: PAD_PX // 2]
    return bool(_is_of(few, 0).any() or _is_of(few, int(np.iinfo(bands.dtype).max)).any())


def pads(bands: np.ndarray, values: Sequence[int]) -> np.ndarray:
    """Pads of these values that reach the edge of the bands (bands, rows, columns), with what JPEG's squares share with
    them, (rows, columns) bool."""
    padded = np.zeros(bands.shape[1:], bool)
    for value in values:
        parts, _ = ndimage.label(_is_of(bands, value))
        large = ndimage.grey_opening((parts > 0).view(np.uint8), size=PAD_PX) > 0
        at_edge = np.concatenate([parts[[0, -1]].ravel(), parts[:, [0, -1]].ravel()])
        pad = np.isin(parts, np.intersect1d(parts[large], at_edge))
        is_exact = (bands[:, pad] == value).all()
        padded |= pad if is_exact else ndimage.maximum_filter(pad, size=2 * BESIDE_PX + 1)
    return padded


def _is_of(bands: np.ndarray, value: int) -> np.ndarray:
    off = _MOST_OFF if bands.dtype == np.uint8 else 0
    return np.asarray((bands <= off if value == 0 else bands >= value - off).all(axis=0))
