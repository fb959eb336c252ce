"""Seams that are mixed by other rules than weights across the cut, as an outsider would invent them."""
from __future__ import annotations

import numpy as np
from scipy import ndimage

from .detail import luminance_of
from .known_windows import KnownWindow, hard_cut
from .seam_makings import Mix, Mixed, Part, feather_weights, mixed, seam_distance, whole_values

BRUSH_SIGMA_PX = 1.5
BRUSH_REACH_PX = 6.0
"""Sigma of how the brush fades out from the seam."""


def darkest(width_px: float) -> Mix:
    """In a band along the seam each pixel is the darkest of its sources."""

    def mix(window: KnownWindow, rng: np.random.Generator) -> Mixed:
        used = np.unique(window.labels)
        planes = np.stack([luminance_of(window.sources[number]) for number in used])
        in_band = seam_distance(window.labels) <= width_px / 2
        chosen = np.where(in_band, used[planes.argmin(axis=0)], window.labels)
        return mixed(window.sources, _weights_of(chosen, len(window.sources)), window.labels)

    return mix


def dissolved(width_px: float) -> Mix:
    """In a band along the seam each pixel is one of its sources by chance, as a linear feather would weigh them."""

    def mix(window: KnownWindow, rng: np.random.Generator) -> Mixed:
        count = len(window.sources)
        sums = np.cumsum(feather_weights(count, window.labels, width_px, "linear"), axis=0)
        chosen = (rng.random(window.labels.shape) >= sums[:-1]).sum(axis=0)
        return mixed(window.sources, _weights_of(chosen, count), window.labels)

    return mix


def brushed(window: KnownWindow, rng: np.random.Generator) -> Mixed:
    """A hard cut that somebody softened along the seam."""
    cut = hard_cut(window.sources, window.labels).astype(np.float32)
    amount = np.exp(-np.square(seam_distance(window.labels) / BRUSH_REACH_PX) / 2).astype(np.float32)
    soft = ndimage.gaussian_filter(cut, (0, BRUSH_SIGMA_PX, BRUSH_SIGMA_PX), mode="nearest")
    planes = tuple(luminance_of(source) for source in window.sources)
    parts = []
    for number in np.unique(window.labels):
        inside = (window.labels == number).astype(np.float32)
        blurred = ndimage.gaussian_filter(planes[number], BRUSH_SIGMA_PX, mode="nearest")
        parts += [Part(planes[number], inside * (1 - amount)), Part(blurred, inside * amount)]
    return Mixed(whole_values(cut + amount * (soft - cut)), planes, tuple(parts), window.labels,
                 tuple(range(len(planes))))


def _weights_of(chosen: np.ndarray, count: int) -> list[np.ndarray]:
    return [(chosen == number).astype(np.float32) for number in range(count)]
