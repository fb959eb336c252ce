"""Small areas of a raster: which of them are uniform, how noisy those are, and whether grey ones are grey.

An area is 16 x 16 pixels. It is uniform when its four quadrants have the same mean, as far as the noise within them
lets one tell: the variance between the quadrants' means, times the pixels of one, is at most 3.86 times the variance
within (99 % of what white noise gives). This does not depend on how much noise there is, so noisy images have uniform
areas too; edges, gradients and coarse texture fail it.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...imagery.value_ranges import ValueRange
from . import limits

MAX_QUADRANT_RATIO = 3.86  # variance between the four quadrants over that within: 99 % of F(3, 252), white noise
MID_TONES = (0.25, 0.75)  # of the available range: the middle half
UNIFORM_SHARE = 0.25  # the quarter of the uniform areas with the least noise: the others may be fine texture

_HALF = limits.AREA_PX // 2
_PIXELS = _HALF * _HALF
"""Of a quadrant."""
_QUADRANTS = np.kron(np.eye(2).repeat(_HALF, axis=0), np.eye(2).repeat(_HALF, axis=0))
"""(pixels of an area in a row, 4): which of them belong to each quadrant; a matrix product is the fastest sum."""


@dataclass(frozen=True, eq=False)
class Areas:
    """n areas of a raster with b bands."""

    means: np.ndarray
    """(n, b) float64."""
    noise: np.ndarray
    """(n, b) float64: standard deviation within the quadrants."""
    uniform: np.ndarray
    """(n, b) bool."""


def sample_areas(bands: np.ndarray, invalid: np.ndarray | None, step: int) -> Areas:
    """The areas of (bands, rows, columns) whose upper left corners lie ``step`` px apart, without invalid pixels."""
    side = limits.AREA_PX
    if min(bands.shape[1:]) < side:
        nothing = np.empty((0, len(bands)))
        return Areas(nothing, nothing, nothing.astype(bool))
    seen = np.lib.stride_tricks.sliding_window_view(bands, (side, side), axis=(1, 2))[:, ::step, ::step]
    if invalid is not None:
        bad = np.lib.stride_tricks.sliding_window_view(invalid, (side, side))[::step, ::step].any(axis=(2, 3))
        parts = seen[:, ~bad]
    else:
        parts = seen.reshape(len(bands), -1, side, side)
    dtype = np.float32 if bands.dtype.kind in "iu" and bands.dtype.itemsize <= 2 else np.float64
    areas = parts.astype(dtype).reshape(-1, side * side)
    # Less the first pixel, so that float32 keeps the small differences of large values.
    origins = areas[:, 0].copy()
    areas -= origins[:, np.newaxis]
    sums = (areas @ _QUADRANTS.astype(dtype)).astype(np.float64)
    squares = np.einsum("ij,ij->i", areas, areas).astype(np.float64)
    within = np.maximum(squares - (sums**2).sum(axis=1) / _PIXELS, 0) / (4 * (_PIXELS - 1))
    between = (sums / _PIXELS).var(axis=1, ddof=1) * _PIXELS
    means = origins + sums.sum(axis=1) / (4 * _PIXELS)
    uniform = between <= MAX_QUADRANT_RATIO * within
    return Areas(*(figure.reshape(len(bands), -1).T for figure in (means, np.sqrt(within), uniform)))


def joined(parts: Sequence[Areas]) -> Areas:
    """The areas of several blocks as those of one."""
    return Areas(
        np.concatenate([part.means for part in parts]),
        np.concatenate([part.noise for part in parts]),
        np.concatenate([part.uniform for part in parts]),
    )


def signal_to_noise(areas: Areas, band: int, available: ValueRange) -> float | None:
    """Mean over standard deviation in a band's uniform mid-tone areas.

    Of the uniform areas whose mean lies in the middle half of the range, the quarter with the least noise is taken
    (the others may be fine texture): mean of their means over the root mean square of their noise. None where there
    are fewer than eight such areas; infinite where they do not vary at all.
    """
    chosen = areas.uniform[:, band] & _is_mid_tone(areas.means[:, band], available)
    if np.count_nonzero(chosen) < limits.MIN_AREAS:
        return None
    means, noise = areas.means[chosen, band], areas.noise[chosen, band]
    best = np.argsort(noise, kind="stable")[: _quarter(len(noise))]
    deviation = float(np.sqrt(np.mean(noise[best] ** 2)))
    return float(means[best].mean()) / deviation if deviation > 0 else float("inf")


def colour_balance(areas: Areas, bands: Sequence[int], available: ValueRange) -> float | None:
    """Largest difference between the bands on neutral areas as a share of the range.

    Neutral are areas that are uniform in all the bands, of mid-tone, and whose bands differ by at most 10 % of the
    range; of those the quarter with the least colour is taken. None where there are fewer than eight.
    """
    extent = available[1] - available[0]
    means = areas.means[:, list(bands)]
    spread = np.ptp(means, axis=1) / extent if len(means) else np.empty(0)
    chosen = areas.uniform[:, list(bands)].all(axis=1) & _is_mid_tone(means, available).all(axis=1)
    chosen &= spread <= limits.MAX_NEUTRAL_SPREAD
    if np.count_nonzero(chosen) < limits.MIN_AREAS:
        return None
    means, spread = means[chosen], spread[chosen]
    best = np.argsort(spread, kind="stable")[: _quarter(len(spread))]
    return float(np.ptp(means[best].mean(axis=0))) / extent


def _is_mid_tone(means: np.ndarray, available: ValueRange) -> np.ndarray:
    low, high = available
    least, most = (low + share * (high - low) for share in MID_TONES)
    return (means >= least) & (means <= most)


def _quarter(count: int) -> int:
    return max(round(UNIFORM_SHARE * count), limits.MIN_AREAS)
