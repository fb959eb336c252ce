"""Small areas of a raster: which of them are uniform, how noisy those are, and which may be grey.

An area is 16 x 16 pixels. It is uniform when its four quadrants have the same mean, as far as the noise within them
lets one tell: the variance between the quadrants' means, times the pixels of one, is at most 3.86 times the variance
within (99 % of what white noise gives). This does not depend on how much noise there is, so noisy images have uniform
areas too; edges, gradients and coarse texture fail it.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ...imagery.rasters import ValueRange
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
    corners: np.ndarray
    """(n, 2) int64: column and row of the upper left pixel."""


def sample_areas(
    bands: np.ndarray, invalid: np.ndarray | None, step: int, corner: tuple[int, int] = (0, 0)
) -> Areas:
    """The areas of (bands, rows, columns) whose upper left corners lie ``step`` px apart, without invalid pixels.

    ``corner``: column and row of the first pixel in the raster.
    """
    side = limits.AREA_PX
    if min(bands.shape[1:]) < side:
        nothing = np.empty((0, len(bands)))
        return Areas(nothing, nothing, nothing.astype(bool), np.empty((0, 2), np.int64))
    seen = np.lib.stride_tricks.sliding_window_view(bands, (side, side), axis=(1, 2))[:, ::step, ::step]
    rows, columns = np.indices(seen.shape[1:3]).reshape(2, -1) * step
    corners = np.column_stack([columns, rows]) + corner
    if invalid is not None:
        bad = np.lib.stride_tricks.sliding_window_view(invalid, (side, side))[::step, ::step].any(axis=(2, 3))
        parts, corners = seen[:, ~bad], corners[~bad.ravel()]
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
    means, noise, uniform = (figure.reshape(len(bands), -1).T for figure in (means, np.sqrt(within), uniform))
    return Areas(means, noise, uniform, corners)


def joined(parts: Sequence[Areas]) -> Areas:
    """The areas of several blocks as those of one."""
    return Areas(
        np.concatenate([part.means for part in parts]),
        np.concatenate([part.noise for part in parts]),
        np.concatenate([part.uniform for part in parts]),
        np.concatenate([part.corners for part in parts]),
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


def maybe_grey(areas: Areas, bands: Sequence[int], available: ValueRange) -> np.ndarray:
    """(n,) bool: which areas may be grey, for somebody to look at.

    They are uniform in all the bands, of mid-tone, and their bands differ by at most 10 % of the range. Whether they
    are grey, or bare soil under a clean light, or something blue under a warm one, no pixel tells.
    """
    extent = available[1] - available[0]
    means = areas.means[:, list(bands)]
    spread = np.ptp(means, axis=1) / extent if len(means) else np.empty(0)
    chosen = areas.uniform[:, list(bands)].all(axis=1) & _is_mid_tone(means, available).all(axis=1)
    return np.asarray(chosen & (spread <= limits.MAX_GREY_SPREAD))


def _is_mid_tone(means: np.ndarray, available: ValueRange) -> np.ndarray:
    low, high = available
    least, most = (low + share * (high - low) for share in MID_TONES)
    return (means >= least) & (means <= most)


def _quarter(count: int) -> int:
    return max(round(UNIFORM_SHARE * count), limits.MIN_AREAS)
