"""The border between two sources, moved to the pixel from where it is known nearly."""
from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import numpy as np

from ..seam_cells import UNKNOWN, present
from .boxes import box_counts, near_border

BORDER_PX = 5
"""What the first labels are off by."""

_SIGMA_PX, _REACH_PX = 1.2, 5  # differences are smoothed by a Gaussian
_SMOOTH_PX = 11  # a side of what decides together
_TILE_PX = 32  # a side of what is looked at together along the border
_FEWEST_FOLLOWED = 200  # pixels that a tone is told by


def to_the_pixel(
    mosaic: np.ndarray, planes: Mapping[int, np.ndarray], labels: np.ndarray, valid: Mapping[int, np.ndarray]
) -> np.ndarray:
    """The border moved, by up to ``BORDER_PX``, to where either side differs least from the mosaic.

    ``valid``: pixels that a source has, of those that don't have all.
    """
    near = near_border(labels, BORDER_PX)
    near &= labels != UNKNOWN
    firsts = [np.arange(0, length, _TILE_PX) for length in labels.shape]
    has_border = np.logical_or.reduceat(np.logical_or.reduceat(near, firsts[0], axis=0), firsts[1], axis=1)
    if not has_border.any():
        return labels
    tiles = np.nonzero(has_border)
    rows, columns = (_reflected(_TILE_PX * places, length) for places, length in zip(tiles, labels.shape))
    # By one number each, pixels are taken in a quarter of the time.
    around = rows[:, :, np.newaxis] * labels.shape[1] + columns[:, np.newaxis, :]
    pixels = around[:, _REACH_PX:-_REACH_PX, _REACH_PX:-_REACH_PX]
    mosaic_around, before, smoothing = np.take(mosaic, around), np.take(labels, around), _smoothing()
    differences = []
    for number, plane in planes.items():
        rest = mosaic_around - np.take(plane, around)
        rest -= _followed_mean(rest, before == number)
        rest *= rest
        differences.append(smoothing @ rest @ smoothing.T)
        if number in valid:
            differences[-1][~np.take(valid[number], pixels)] = np.inf
    moved = labels.copy()
    beside = np.take(near, pixels)
    np.put(moved, pixels[beside], np.array(list(planes), np.uint8)[np.argmin(differences, axis=0)][beside])
    return moved


def _followed_mean(rest: np.ndarray, followed: np.ndarray) -> np.ndarray:
    """What a source's tone is off by in every tile where it is followed so far; 0 where that is too little."""
    followed = followed.reshape(len(followed), -1)
    counts = np.count_nonzero(followed, axis=1)
    sums = np.einsum("tn,tn->t", rest.reshape(followed.shape), followed.astype(np.float32))
    return np.where(counts >= _FEWEST_FOLLOWED, sums / np.maximum(counts, 1), 0).astype(np.float32)[:, None, None]


def smooth_border(labels: np.ndarray) -> np.ndarray:
    """Labels without what is narrower than a seam runs: where sources are mixed, noise decides which is nearer."""
    numbers = present(labels)
    if len(numbers) < 2:
        return labels
    counts = [box_counts(labels == number, _SMOOTH_PX) for number in numbers]
    return np.where(labels == UNKNOWN, labels, np.array(numbers, np.uint8)[np.argmax(counts, axis=0)])


def _reflected(starts: np.ndarray, length: int) -> np.ndarray:
    """Places of the pixels of tiles, (tiles, side), with those that smoothing reaches; mirrored at the edges."""
    places = starts[:, np.newaxis] + np.arange(-_REACH_PX, _TILE_PX + _REACH_PX)
    places = np.where(places < 0, -1 - places, places)
    return np.asarray(np.where(places >= length, np.maximum(2 * length - 1 - places, 0), places))


@cache
def _smoothing() -> np.ndarray:
    """(tile, tile and what it reaches): a Gaussian along one axis."""
    steps = np.arange(-_REACH_PX, _REACH_PX + 1)
    weights = np.exp(-0.5 * (steps / _SIGMA_PX) ** 2)
    matrix = np.zeros((_TILE_PX, _TILE_PX + 2 * _REACH_PX), np.float32)
    for i in range(_TILE_PX):
        matrix[i, i : i + len(weights)] = weights / weights.sum()
    return matrix
