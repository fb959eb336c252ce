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
_FEWEST_OWN = 200  # pixels that a tone is told by


def to_the_pixel(
    mosaic: np.ndarray, planes: Mapping[int, np.ndarray], labels: np.ndarray, valid: Mapping[int, np.ndarray]
) -> np.ndarray:
    """The border moved, by up to ``BORDER_PX``, to where either side differs least from the mosaic.

    ``valid``: pixels that a source has, of those that don't have all.
    """
    near = near_border(labels, BORDER_PX)
    near &= labels != UNKNOWN
    tiles = _tiles_with(near)
    if not len(tiles[0]):
        return labels
    rows, columns = (_reflected(_TILE_PX * places, length) for places, length in zip(tiles, labels.shape))
    # By one number each, pixels are taken in a quarter of the time.
    around = rows[:, :, np.newaxis] * labels.shape[1] + columns[:, np.newaxis, :]
    pixels = around[:, _REACH_PX:-_REACH_PX, _REACH_PX:-_REACH_PX]
    mosaic_around, before, smoothing = np.take(mosaic, around), np.take(labels, around), _smoothing()
    least: np.ndarray | None = None
    for number, plane in planes.items():
        rest = mosaic_around - np.take(plane, around)
        rest -= _own_mean(rest, before == number)
        rest *= rest
        differences = smoothing @ rest @ smoothing.T
        if number in valid:
            differences[~np.take(valid[number], pixels)] = np.inf
        if least is None:
            least, nearest = differences, np.full(differences.shape, number, np.uint8)
        else:
            np.copyto(nearest, np.uint8(number), where=differences < least)
            np.minimum(least, differences, out=least)
    moved = labels.copy()
    beside = np.take(near, pixels)
    np.put(moved, pixels[beside], nearest[beside])
    return moved


def _own_mean(rest: np.ndarray, own: np.ndarray) -> np.ndarray:
    """What a source's tone is off by in every tile where it is followed so far; 0 where that is too little."""
    own = own.reshape(len(own), -1)
    counts = np.count_nonzero(own, axis=1)
    sums = np.einsum("tn,tn->t", rest.reshape(own.shape), own.astype(np.float32))
    return np.where(counts >= _FEWEST_OWN, sums / np.maximum(counts, 1), 0).astype(np.float32)[:, None, None]


def smooth_border(labels: np.ndarray) -> np.ndarray:
    """Labels without what is narrower than a seam runs: where sources are mixed, noise decides which is nearer."""
    numbers = present(labels)
    if len(numbers) < 2:
        return labels
    counts = (box_counts(labels == number, _SMOOTH_PX) for number in numbers)
    first, most = numbers[0], next(counts)
    smooth = np.full(labels.shape, first, np.uint8)
    for number, count in zip(numbers[1:], counts):
        np.copyto(smooth, np.uint8(number), where=count > most)
        np.maximum(most, count, out=most)
    np.copyto(smooth, np.uint8(UNKNOWN), where=labels == UNKNOWN)
    return smooth


def _tiles_with(near: np.ndarray) -> tuple[np.ndarray, ...]:
    """Rows and columns of the tiles that have such pixels."""
    rows, columns = (-(-length // _TILE_PX) for length in near.shape)
    padded = np.zeros((rows * _TILE_PX, columns * _TILE_PX), bool)
    padded[: near.shape[0], : near.shape[1]] = near
    return np.nonzero(padded.reshape(rows, _TILE_PX, columns, _TILE_PX).any(axis=(1, 3)))


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
