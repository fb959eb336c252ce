"""Two images mixed nearly everywhere: what each was multiplied by and filtered with, told though no ground is of one.

    m = g (w h_a * a + (1 - w) h_b * b)

on high-passed planes, with the weight w of every block of 64 px. The filters h are fitted for both images at once:
fitted to one alone a filter takes the detail that the other one's share took, and a gain falls with it.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .boxes import enlarged, square_shares, square_sums
from .followed_source import weights_of_two
from .source_filters import filtered, fit_filters

BLOCK_PX = 64
"""Side of the blocks in which weights are taken as constant."""
MIN_MIXED_WEIGHT = 0.1
"""Mean weight of the lesser image, for a window to be mixed nearly everywhere."""
_ROUNDS = 10
_SETTLED = 0.002  # of the lesser image's weight
_MIN_BLOCK = 0.5  # of a block's pixels that take part


@dataclass(frozen=True, eq=False)
class MixedGround:
    """What two images were multiplied by and filtered with."""

    gain: float
    """Gain of both, beyond what they were multiplied by already."""
    taps: np.ndarray
    """(2, 5, 5)"""
    mosaic: np.ndarray
    """(rows, columns) float32: the high-passed mosaic that this makes of them."""


def mixed_ground(
    mosaic: np.ndarray, fine: Sequence[np.ndarray], shown: Sequence[np.ndarray], where: np.ndarray
) -> MixedGround | None:
    """The mixture of two high-passed planes ``fine`` in the mosaic's tones, (rows, columns) float32; ``where``, bool:
    the pixels that take part.

    ``shown``: the same as the mosaic shows them, as far as that is known. None where there is too little.
    """
    enough = square_shares(where, BLOCK_PX) >= _MIN_BLOCK
    gain, lesser = 1.0, 0.0
    ground: MixedGround | None = None
    for _ in range(_ROUNDS):
        before = lesser
        first, lesser = _first_weights([np.where(where, plane, np.float32(0)) for plane in (mosaic, *shown)], enough)
        if lesser < MIN_MIXED_WEIGHT:
            return None
        if ground is not None and abs(lesser - before) < _SETTLED:
            break
        pixels = enlarged(first, BLOCK_PX, mosaic.shape)
        weights = pixels, 1 - pixels
        taps = fit_filters(mosaic, [gain * weight * image for weight, image in zip(weights, fine)], where)
        if taps is None:
            return None
        made = [filtered(plane, own_taps) for plane, own_taps in zip(fine, taps)]
        passed = np.array([_amplitude(b, where) / max(_amplitude(a, where), 1e-9) for a, b in zip(fine, made)])
        if passed.min() <= 0:
            return None
        # A filter that passes more and a weight that is less are the same: they are told apart as if both passed alike.
        even = np.exp(np.log(passed).mean()) / passed
        taps = even[:, np.newaxis, np.newaxis].astype(np.float32) * taps
        scale = float(taps.sum()) / len(taps)
        if scale <= 0:
            return None
        shown = [np.float32(gain * by) * image for by, image in zip(even, made)]
        gain *= scale
        ground = MixedGround(gain, taps / scale, weights[0] * shown[0] + weights[1] * shown[1])
    return ground


def _amplitude(plane: np.ndarray, where: np.ndarray) -> float:
    return float(np.sqrt(np.square(plane, where=where, out=np.zeros_like(plane)).mean()))


def _first_weights(planes: Sequence[np.ndarray], enough: np.ndarray) -> tuple[np.ndarray, float]:
    """The weight of the first image in every block of the mosaic, (block rows, block columns) float32, 0 to 1; and the
    mean of the lesser one, 0 without any block that has ``enough`` of both. ``planes``: the mosaic, then the images."""
    ma, mb, aa, ab, bb = (
        square_sums(planes[i], planes[j], BLOCK_PX).astype(np.float64)
        for i, j in ((0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
    )
    held = enough & (aa > 0) & (bb > 0)
    if not held.any():
        return np.full(held.shape, 0.5, np.float32), 0.0
    weights = np.maximum(weights_of_two(np.where(held, aa, 1), np.where(held, bb, 1), ma, mb, ab), 0)
    total = weights.sum(axis=0)
    first = np.divide(weights[0], total, out=np.full(total.shape, 0.5), where=held & (total > 0)).astype(np.float32)
    first[~held] = first[held].mean()
    return first, float(np.minimum(first[held], 1 - first[held]).mean())
