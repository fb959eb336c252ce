"""Each source brought to the mosaic's grey values where the mosaic follows it, whatever evened out its tones.

A gain that may change evenly over the window, and a bias that may change from place to place: balancing, dodging and a
flattened background all come to that. Neither is taken from fine detail, which is what is measured, nor across a seam,
whose step of tone stays as it is.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ....imagery.statistics import robust_sigma
from ..tone import coarse_means, tukey_weights
from .boxes import enlarged

LEVELS = 3
TONE_PX = 2**LEVELS
"""Side of the squares that are compared."""

_MIN_FOLLOWED = 0.9  # of a square's pixels that follow the source
_FEWEST_SQUARES = 24
_FEWEST_FOR_TREND = 150
_NEAR_SQUARES = 5  # a side: what is wider than that is background
_SMOOTH_SQUARES = 2.0  # sigma of the bias
_EVEN = 0.01  # of the standard deviation of what squares differ by from those around
_ROUNDING = 1e-6  # of the largest value: what single precision makes of means of even ground, and as much again
_RIDGE = 0.01  # so that ground which says nothing of a term leaves it out
_ROUNDS = 3


@dataclass(frozen=True, eq=False)
class Levelled:
    """A source in the mosaic's grey values."""

    plane: np.ndarray
    """(rows, columns) float32"""
    gain: np.ndarray
    """(rows, columns) float32: what its detail was multiplied by."""


def levelled(
    mosaic_means: np.ndarray, source: np.ndarray, followed: np.ndarray, clear: np.ndarray, patch: int = 0
) -> Levelled:
    """A source's plane in the mosaic's grey values; (rows, columns), float32 and bool.

    ``mosaic_means``: of the mosaic's squares of 8 px. ``followed``: pixels that follow the source, ``clear``: pixels
    that follow one source for sure. ``patch``: see ``gain_field``.
    """
    where = square_means(followed & clear) > _MIN_FOLLOWED
    if not patch and np.count_nonzero(where) < _FEWEST_SQUARES:
        where = square_means(followed) > _MIN_FOLLOWED
    gains = gain_field(mosaic_means, square_means(source), where, patch)
    return levelled_by(mosaic_means, source, followed, to_pixels(gains, source.shape))


def levelled_by(mosaic_means: np.ndarray, source: np.ndarray, followed: np.ndarray, gain: np.ndarray) -> Levelled:
    """A source's plane in the mosaic's grey values where its ``gain``, (rows, columns), is known."""
    # A square that two sources share tells neither's tone.
    bias = _spread_out(mosaic_means - square_means(gain) * square_means(source), square_means(followed))
    plane = to_pixels(bias, source.shape)
    plane += gain * source
    return Levelled(plane, gain)


def square_means(plane: np.ndarray) -> np.ndarray:
    """Means of the squares of 8 px of a plane (rows, columns), whose edge continues where the last ones stick out."""
    beyond = [-length % 2**LEVELS for length in plane.shape]
    return coarse_means(np.pad(plane, [(0, by) for by in beyond], mode="edge") if any(beyond) else plane, LEVELS)


def left_over(mosaic: np.ndarray, source: np.ndarray, where: np.ndarray) -> tuple[float, float]:
    """Scale of what the mosaic's means of squares differ by from the source's: after one curve of tones for all of
    the window, and after a gain and bias that change from place to place; (rows, columns), ``where`` bool.

    With too few squares both are 0.
    """
    if np.count_nonzero(where) < _FEWEST_SQUARES:
        return 0.0, 0.0
    x, y = source[where].astype(np.float64), mosaic[where].astype(np.float64)
    terms = np.vander((x - x.mean()) / max(float(x.std()), 1e-6), 4)
    bias = mosaic - gain_field(mosaic, source, where) * source
    local = bias - _spread_out(bias, where.astype(np.float32))
    return robust_sigma(y - terms @ np.linalg.lstsq(terms, y, rcond=None)[0]), robust_sigma(local[where])


def gain_field(mosaic: np.ndarray, source: np.ndarray, where: np.ndarray, patch: int = 0) -> np.ndarray:
    """The gain at every square, (rows, columns): by its place and its brightness where there is ground enough.

    ``patch``: side in squares of patches that are each compared by themselves, 0: every square with those around it.
    Both see other scales, and so another gain where a mosaic was sharpened: one filter goes with one of them.
    """
    ones = np.ones(mosaic.shape, np.float32)
    if np.count_nonzero(where) < _FEWEST_SQUARES:
        return ones
    places = np.flatnonzero(where)
    x, y = (np.take(off_near, places).astype(np.float64) for off_near in _off_near((source, mosaic), where, patch))
    # Even ground tells nothing of a gain, and where there is much of it residuals would seem to be none.
    telling = np.abs(x) > max(_EVEN * x.std(), _ROUNDING * float(np.abs(source).max()))
    if np.count_nonzero(telling) < _FEWEST_SQUARES:
        return ones
    places, x, y = (values[telling] for values in (places, x, y))
    fields = _places(source, places) if len(places) >= _FEWEST_FOR_TREND else [ones]
    terms = np.stack([np.take(field, places) * x for field in fields])
    weights = np.ones(len(x))
    factors = np.eye(len(fields))[0]
    for _ in range(_ROUNDS):
        weighted = terms * weights
        normal = weighted @ terms.T
        if normal[0, 0] <= 0:
            return ones
        normal += np.diag([0.0, *[_RIDGE * normal[0, 0]] * (len(fields) - 1)])
        factors = np.linalg.solve(normal, weighted @ y)
        weights = tukey_weights(y - factors @ terms)
    return np.asarray(sum(factor * field for factor, field in zip(factors, fields)), np.float32)


def _off_near(planes: Sequence[np.ndarray], where: np.ndarray, patch: int = 0) -> list[np.ndarray]:
    """What squares of planes differ by from the mean of those near them, ``where`` they count, (rows, columns) bool."""
    weight = np.maximum(_near_means(where.astype(np.float32), patch), np.float32(1e-6))
    return [means - _near_means(np.where(where, means, 0), patch) / weight for means in planes]


def _near_means(values: np.ndarray, patch: int) -> np.ndarray:
    """Means of what is near to every square: around it, or of its patch."""
    if not patch:
        return np.asarray(ndimage.uniform_filter(values, _NEAR_SQUARES))
    sums, counts = values, np.ones(values.shape, np.float32)
    for axis in (0, 1):
        firsts = np.arange(0, values.shape[axis], patch)
        sums, counts = (np.add.reduceat(values, firsts, axis=axis) for values in (sums, counts))
    means = enlarged(sums / counts, patch)
    return np.asarray(means[: values.shape[0], : values.shape[1]])


def _places(source: np.ndarray, places: np.ndarray) -> list[np.ndarray]:
    """What the gain may depend on, each -1 to 1 or so: dodging changes it from place to place, light falls off with
    the square of the distance, and a power function acts by brightness."""
    down, across = np.meshgrid(*(np.linspace(-1, 1, length) for length in source.shape), indexing="ij")
    low, high = np.percentile(np.take(source, places), (5, 95))
    bright = np.clip((source - (low + high) / 2) / max((high - low) / 2, 1e-6), -1.5, 1.5)
    bright = ndimage.uniform_filter(bright, 3, mode="nearest")
    return [np.ones(source.shape), down, across, down**2, across**2, down * across, bright, bright**2]


def _spread_out(bias: np.ndarray, share: np.ndarray) -> np.ndarray:
    """Bias, smoothed where it is known, and carried on from there to where it is not."""
    weight = np.where(share > _MIN_FOLLOWED, share, 1e-4 * share)
    total = float(weight.sum())
    mean = float((weight * bias).sum()) / total
    known, weights = (
        ndimage.gaussian_filter(values, _SMOOTH_SQUARES, mode="nearest") for values in (weight * bias, weight)
    )
    least = 1e-3
    return np.asarray((known + least * mean) / (weights + least), np.float32)


def to_pixels(squares: np.ndarray, shape: tuple[int, ...], side: int = TONE_PX) -> np.ndarray:
    """Linear between the middles of the squares, (rows, columns) float32 of ``side`` px."""
    across = _between(squares.astype(np.float32, copy=False).T, side)[: shape[1]]
    return _between(np.ascontiguousarray(across.T), side)[: shape[0]]


def _between(values: np.ndarray, side: int) -> np.ndarray:
    """Linear between values along the first axis, ``side`` samples each; constant beyond the middles of the last."""
    steps = (np.arange(side, dtype=np.float32)[:, np.newaxis] + np.float32(0.5)) / np.float32(side)
    around = np.concatenate([values[:1], values, values[-1:]])[:, np.newaxis]
    made = steps * (around[1:] - around[:-1])
    made += around[:-1]
    return made.reshape(-1, values.shape[1])[side // 2 : -(side // 2)]
