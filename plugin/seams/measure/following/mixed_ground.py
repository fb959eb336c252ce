"""Filters of two images that a mosaic mixes nearly everywhere, so that no ground is of one alone.

    m = g (w h_a * a + (1 - w) h_b * b)

on high-passed planes, with the weight w of every square of 64 px. The filters h are fitted for both images at once:
fitted to one alone a filter takes the detail that the other one's share took, and the gain g falls with it.
"""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .boxes import enlarged, square_shares, square_sums
from .followed_source import weights_of_two
from .source_filters import filtered, fit_filters

WEIGHTS_PX = 64
"""Side of the squares in which weights are taken as constant."""
MIN_MIXED_WEIGHT = 0.1
"""Weight of the lesser image in three of four squares, for ground to be mixed nearly everywhere."""
MOST_LEFT_OF_CUT = 0.9
"""Share of what the cut leaves over: what codecs leave over of either image is left over by both."""
_ROUNDS = 10
_SETTLED = 0.002  # of the lesser image's weight
_MIN_HELD = 0.5  # of a square's pixels that take part


def mixed_filters(
    mosaic: np.ndarray, images: Sequence[np.ndarray], where: np.ndarray, cut: np.ndarray
) -> tuple[float, np.ndarray] | None:
    """The gain of two images in the mosaic's tones, and taps (2, 5, 5); None where they aren't mixed nearly everywhere.

    ``mosaic``, ``images``, ``cut``: high-passed, (rows, columns) float32; ``where``, bool: the pixels that take part;
    ``cut``: what the images make of the mosaic each on its own side.
    """
    enough = square_shares(where, WEIGHTS_PX) >= _MIN_HELD
    mosaic, lesser, shown, taps = mosaic * where, 0.0, images, None
    for _ in range(_ROUNDS):
        before = lesser
        first, lesser = _first_weights([mosaic, *(plane * where for plane in shown)], enough)
        if lesser < MIN_MIXED_WEIGHT:
            return None
        pixels = enlarged(first, WEIGHTS_PX, mosaic.shape)
        weights = pixels, 1 - pixels
        if taps is not None and abs(lesser - before) < _SETTLED:
            break
        taps = fit_filters(mosaic, [weight * image for weight, image in zip(weights, images)], where)
        if taps is None or taps.sum() <= 0:
            return None
        made = [filtered(plane, kernel) for plane, kernel in zip(images, taps)]
        passed = [float(np.square(b, where=where, out=np.zeros_like(b)).sum() /
                        np.square(a, where=where, out=np.zeros_like(a)).sum()) for a, b in zip(images, made)]
        if min(passed) <= 0:
            return None
        # A filter that passes more and a weight that is less are the same: they are told apart as if both passed alike.
        even = np.sqrt(np.sqrt(passed[0] * passed[1]) / passed).astype(np.float32)
        taps = even[:, np.newaxis, np.newaxis] * taps
        shown = [by * plane for by, plane in zip(even, made)]
    if taps is None:
        return None
    left_over = _left_over(mosaic, weights[0] * shown[0] + weights[1] * shown[1], where)
    gain = float(taps.sum()) / len(taps)
    return (gain, taps / gain) if left_over <= MOST_LEFT_OF_CUT * _left_over(mosaic, cut, where) else None


def _left_over(mosaic: np.ndarray, made: np.ndarray, where: np.ndarray) -> float:
    return float(np.square(mosaic - made)[where].sum())


def _first_weights(planes: Sequence[np.ndarray], enough: np.ndarray) -> tuple[np.ndarray, float]:
    """The weight of the first image in every square of the mosaic, (rows, columns) float32, 0 to 1; and what
    the lesser one has at least in three of four, 0 without any square that has ``enough`` of both. ``planes``: the
    mosaic, then the images."""
    ma, mb, aa, ab, bb = (
        square_sums(planes[i], planes[j], WEIGHTS_PX).astype(np.float64)
        for i, j in ((0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
    )
    held = enough & (aa > 0) & (bb > 0)
    if not held.any():
        return np.full(held.shape, 0.5, np.float32), 0.0
    weights = np.maximum(weights_of_two(np.where(held, aa, 1), np.where(held, bb, 1), ma, mb, ab), 0)
    total = weights.sum(axis=0)
    first = np.divide(weights[0], total, out=np.full(total.shape, 0.5), where=held & (total > 0)).astype(np.float32)
    first[~held] = first[held].mean()
    return first, float(np.quantile(np.minimum(first[held], 1 - first[held]), 0.25))
