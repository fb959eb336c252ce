"""The feather across a seam: the share of the source beyond it, by distance, as one ramp.

A ramp is straight or half a cosine, and has a width, an offset from the border that was drawn, and on either side a
floor: what the other source explains of pure ground. Where a source was compressed since, the other one, which shows
the same ground, holds some of what it lost (regression with errors in the variables, Fuller 1987), and the mosaic of
it: up to half of a side's detail follows the other source, and no seam mixed it in.

Ramps are weighted by Akaike's criterion (Burnham and Anderson 2002), so that neither noise makes a feather nor the
raster of widths a step; a cut and a feather are as likely beforehand, however many ramps there are of either. What the
shares deviate from the ramp more than their noise lets them is real and comes back by its share of the variance
(DerSimonian and Laird 1986): without noise all does.
"""
from __future__ import annotations

from functools import cache

import numpy as np

from .cell_table import EDGES_PX, MIXED_BINS
from .seam_profile import STRIP_PX

WIDTHS_PX = (0, 7, 8.5, 10, 12, 15, 17.5, 20, 25, 30, 36, 43, 50, 60, 80, 110, 150, 200, 260, 350, 600, 1e6)
"""Full widths, a factor of 1.2 apart up to 60 px and of 1.4 beyond; the last one is a mixture that is the same
everywhere. Narrower than 7 px none can be told from a cut whose border is known to a pixel."""
OFFSETS_PX = (-8, -6, -4, -3, -2, -1, 0, 1, 2, 3, 4, 6, 8)
"""Offsets from the border, which noise and compression draw so far off (squares of 8 px)."""
MOST_FLOOR, FLOOR_SPREAD = 0.5, 0.15
"""Share of the other source that explains pure ground: of both sides together at most, since halves everywhere are a
mixture; and the standard deviation of a side's. Beside a lossless orthoimage, on the side whose orthoimage alone was
compressed by JPEG 75 since, it was 0.35 to 0.5."""
BEYOND = EDGES_PX.index(STRIP_PX)
"""First bin beyond the strip."""
_SAMPLES = 16  # of a bin, over which a ramp is averaged
_PRICE = 2.0  # of a parameter (Akaike 1974)
_SURE = 3.0  # standard deviations
_ENDLESS = WIDTHS_PX[-1]
_RAMPS = [
    (width, offset, is_even) for width in WIDTHS_PX for offset in (OFFSETS_PX if width != _ENDLESS else (0,))
    for is_even in ((True, False) if 0 < width < _ENDLESS else (True,))
]
_IS_SOFT = np.array([width > 0 for width, *_ in _RAMPS])  # a cut that was drawn in the wrong place mixes nothing


def fit_ramps(
    shares: np.ndarray, spread: np.ndarray, most_floor: np.ndarray | float = MOST_FLOOR
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Fit n seams.

    Parameters
    ----------
    shares : (n, 2 MIXED_BINS)
        Share of the other source by distance, first where the source of the lower number is followed.
    spread : (n, 2 MIXED_BINS)
        Standard deviation of each share; infinite where it is not known.
    most_floor : (n, 2)
        Highest floor of either side that its noise can make.

    Returns
    -------
    other, unsure : (n, 2 MIXED_BINS)
        Share of the other source that the seam mixed in, 0 to 1, and its standard deviation between the ramps that may
        be.
    soft : (n, 1)
        How likely it is that the seam is no cut.
    """
    models, prices = _models()
    weights = 1 / np.square(spread)
    # What is there everywhere is there in every bin beyond the strip.
    highest = (shares + _SURE * spread).reshape(len(shares), 2, MIXED_BINS)[..., BEYOND:].min(axis=2)
    floors, scores = _fit_floors(shares, weights, np.minimum(highest, most_floor).clip(0, MOST_FLOOR))
    scores += prices
    likely = np.exp((scores.min(axis=1, keepdims=True) - scores) / 2)
    likely /= likely.sum(axis=1, keepdims=True)
    expected, other = likely @ models, likely[:, _IS_SOFT] @ models[_IS_SOFT]
    mixing = models[_IS_SOFT]
    unsure = np.sqrt(np.maximum(likely[:, _IS_SOFT] @ mixing**2 - other**2, 0))
    near, beyond = (np.repeat(np.einsum("nms,nm->ns", of, likely), MIXED_BINS, axis=1) for of in
                    (floors, floors[..., ::-1]))
    contrast = 1 - near - beyond
    rest, weights = (shares - near) / contrast - expected, weights * contrast**2
    total = weights.sum(axis=1, keepdims=True)
    excess = (weights * rest**2).sum(axis=1, keepdims=True) - np.count_nonzero(weights, axis=1)[:, np.newaxis]
    squares = (weights**2).sum(axis=1, keepdims=True) / np.maximum(total, 1e-12)
    variance = np.maximum(excess, 0) / np.maximum(total - squares, 1e-12)
    other += rest * variance * weights / (1 + variance * weights)
    other[total[:, 0] <= 0] = 0  # nothing is known of a mixture
    return np.clip(other, 0, 1), unsure, likely[:, _IS_SOFT].sum(axis=1, keepdims=True)


def _fit_floors(shares: np.ndarray, weights: np.ndarray, most: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Floors of both sides with every ramp, (n, ramps, 2), by least squares, and the sums of squares that are left over
    (n, ramps).

    Pure ground of either source is told as f of the other one, a mixture as lies between: share = f (1 - ramp) +
    (1 - g) ramp, with the floor g of the side beyond."""
    models = _models()[0]
    is_first = np.arange(2 * MIXED_BINS) < MIXED_BINS
    first, second = (np.where(is_own, 1 - models, -models).T for is_own in (is_first, ~is_first))
    weighted = weights * shares
    prior = FLOOR_SPREAD**-2
    a, b, c = weights @ first**2 + prior, weights @ (first * second), weights @ second**2 + prior
    x, y = (weighted @ of - weights @ (of * models.T) for of in (first, second))
    f = np.clip((c * x - b * y) / (a * c - b**2), 0, most[:, :1])
    g = np.clip((y - b * f) / c, 0, most[:, 1:])
    f = np.clip((x - b * g) / a, 0, most[:, :1])
    on_limit = np.clip((x - y + MOST_FLOOR * (c - b)) / (a - 2 * b + c), MOST_FLOOR - most[:, 1:], most[:, :1])
    f, g = (np.where(f + g > MOST_FLOOR, at, floor) for floor, at in ((f, on_limit), (g, MOST_FLOOR - on_limit)))
    squares = (weighted * shares).sum(axis=1, keepdims=True) - 2 * weighted @ models.T + weights @ (models**2).T
    squares += a * f**2 + 2 * b * f * g + c * g**2 - 2 * (f * x + g * y)
    return np.stack([f, g], axis=2), squares


def _ramp(place: np.ndarray, is_even: bool) -> np.ndarray:
    """Share of the source of the higher number from -1/2 to 1/2 of the width: a straight line, or half a cosine."""
    place = np.clip(place, -0.5, 0.5)
    return np.asarray(0.5 + (place if is_even else 0.5 * np.sin(np.pi * place)))


@cache
def _models() -> tuple[np.ndarray, np.ndarray]:
    """Shares of the other source (models, 2 MIXED_BINS) of every ramp, and what its parameters cost (models,)."""
    edges = np.array(EDGES_PX[: MIXED_BINS + 1], float)
    inside = edges[:-1, np.newaxis] + np.diff(edges)[:, np.newaxis] * (np.arange(_SAMPLES) + 0.5) / _SAMPLES
    models, prices = [], []
    soft_share = _IS_SOFT.mean()
    for width, offset, is_even in _RAMPS:
        lower, higher = (_ramp((at - offset) / max(width, 0.5), is_even).mean(axis=1) for at in (-inside, inside))
        models.append(np.concatenate([lower, 1 - higher]))
        prices.append(_PRICE * ((width > 0) + (offset != 0)) + 2 * np.log(soft_share if width > 0 else 1 - soft_share))
    return np.array(models), np.array(prices)
