"""How a seam is made of orthoimages: cut, feathered over a known width or blended, maybe after changing one of them."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from .known_windows import KnownWindow, crooked_cut, hard_cut

PYRAMID_LEVELS = 5
MEETING_RADIUS = 0.25
"""Of the frame's side: how far from its middle three sources may meet."""

Mix = Callable[[KnownWindow, np.random.Generator], "Mixed"]
Change = Callable[[np.ndarray, np.random.Generator], np.ndarray]
"""Of one source's bands, 8 bit to 8 bit."""


@dataclass(frozen=True, eq=False)
class Mixed:
    """A mosaic of one frame and all that is known of it."""

    bands: np.ndarray
    """(bands, rows, columns) 8 bit."""
    hard: np.ndarray
    """The hard cut of the same sources, changed in the same way."""
    labels: np.ndarray
    """(rows, columns) uint8: the window's source on whose side of the seam each pixel lies."""
    given: tuple[int, ...]
    """The window's sources that are given to whoever judges the mosaic."""

    @property
    def foreign(self) -> np.ndarray:
        """Pixels from a source that is not given, (rows, columns) bool."""
        return ~np.isin(self.labels, self.given)


def hard(window: KnownWindow, rng: np.random.Generator) -> Mixed:
    """Cut as the window is."""
    bands = hard_cut(window.sources, window.labels)
    return Mixed(bands, bands, window.labels, _all(window))


def feathered(width_px: float, shape: str = "cosine") -> Mix:
    """Sources weighted across the cut over a full width; for ``gaussian`` it is the sigma."""
    return changed({}, width_px, shape)


def changed(changes: dict[int, Change], width_px: float = 0.0, shape: str = "cosine") -> Mix:
    """Feathered after the main sources (0 and 1) were changed; width 0: cut hard."""

    def mix(window: KnownWindow, rng: np.random.Generator) -> Mixed:
        sources = list(window.sources)
        for number, change in changes.items():
            sources[window.main[number]] = change(sources[window.main[number]], rng)
        cut = hard_cut(sources, window.labels)
        bands = feather(sources, window.labels, width_px, shape) if width_px else cut
        return Mixed(bands, cut, window.labels, _all(window))

    return mix


def blended(window: KnownWindow, rng: np.random.Generator) -> Mixed:
    """By Laplacian pyramids (Burt and Adelson 1983)."""
    pyramids = [(laplacian(source), gaussian(window.labels == k)) for k, source in enumerate(window.sources)]
    levels = [sum(image[r] * mask[r] for image, mask in pyramids) for r in range(PYRAMID_LEVELS + 1)]
    blend = levels.pop()
    while levels:
        fine = levels.pop()
        blend = fine + expand(blend, fine.shape[-2:])
    return Mixed(whole_values(blend), hard_cut(window.sources, window.labels), window.labels, _all(window))


def missing(share: float, width_px: float = 0.0) -> Mix:
    """A share of the pixels comes from a source that is not given."""

    def mix(window: KnownWindow, rng: np.random.Generator) -> Mixed:
        first, second = window.main
        depth = signed_distance(window.labels == second)
        labels = np.where(depth >= np.quantile(depth[window.middle], 1 - share), second, first).astype(np.uint8)
        cut = hard_cut(window.sources, labels)
        bands = feather(window.sources, labels, width_px, "cosine") if width_px else cut
        return Mixed(bands, cut, labels, tuple(k for k in _all(window) if k != second))

    return mix


def meeting(width_px: float) -> Mix:
    """Three sources that meet inside the window."""

    def mix(window: KnownWindow, rng: np.random.Generator) -> Mixed:
        reach = int(MEETING_RADIUS * window.side)
        other = np.roll(crooked_cut(len(window.labels), rng), rng.integers(-reach, reach, 2), (0, 1))
        first, second = window.main
        third = next(k for k in _all(window) if k not in (first, second))
        labels = np.where((window.labels == second) & other, third, window.labels).astype(np.uint8)
        cut = hard_cut(window.sources, labels)
        bands = feather(window.sources, labels, width_px, "cosine") if width_px else cut
        return Mixed(bands, cut, labels, _all(window))

    return mix


def feather(sources: Sequence[np.ndarray], labels: np.ndarray, width_px: float, shape: str) -> np.ndarray:
    """Weights by the distance from each source's own border; where two meet they add up to 1 as they are."""
    numbers = np.unique(labels)
    weights = [ramp(signed_distance(labels == number), width_px, shape) for number in numbers]
    total = np.maximum(np.sum(weights, axis=0), 1e-6)
    blended = sum(weight / total * sources[number] for number, weight in zip(numbers, weights))
    return whole_values(np.asarray(blended))


def ramp(distance: np.ndarray, width_px: float, shape: str) -> np.ndarray:
    """0 outside, 1 inside, over a full width (``gaussian``: sigma), (rows, columns) float32."""
    if shape == "gaussian":
        return ndimage.gaussian_filter((distance > 0).astype(np.float32), width_px, mode="nearest")
    part = np.clip(distance / width_px + 0.5, 0, 1)
    return (part if shape == "linear" else 0.5 - 0.5 * np.cos(np.pi * part)).astype(np.float32)


def signed_distance(inside: np.ndarray) -> np.ndarray:
    """Distance from the border between inside (positive) and outside, px."""
    if inside.all() or not inside.any():
        return np.full(inside.shape, np.inf if inside.all() else -np.inf)
    inner, outer = ndimage.distance_transform_edt(inside), ndimage.distance_transform_edt(~inside)
    return np.asarray(np.where(inside, inner - 0.5, 0.5 - outer))


def seam_distance(labels: np.ndarray) -> np.ndarray:
    """Distance from the nearest border between two labels, px."""
    return np.asarray(np.min([np.abs(signed_distance(labels == number)) for number in np.unique(labels)], axis=0))


def gaussian(mask: np.ndarray) -> list[np.ndarray]:
    """The pyramid of an image that is halved from level to level."""
    levels = [mask.astype(np.float32)]
    for _ in range(PYRAMID_LEVELS):
        levels.append(_smoothed(levels[-1])[..., ::2, ::2])
    return levels


def laplacian(bands: np.ndarray) -> list[np.ndarray]:
    """What each level of the pyramid has above the next; last the coarsest."""
    coarser = gaussian(bands)
    return [*(fine - expand(coarse, fine.shape[-2:]) for fine, coarse in zip(coarser, coarser[1:])), coarser[-1]]


def expand(bands: np.ndarray, shape: Sequence[int]) -> np.ndarray:
    """Doubled in size."""
    wide = np.zeros((*bands.shape[:-2], *shape), np.float32)
    wide[..., ::2, ::2] = 4 * bands
    return _smoothed(wide)


def _smoothed(bands: np.ndarray) -> np.ndarray:
    kernel = np.array([1, 4, 6, 4, 1], np.float32) / 16
    rows = ndimage.convolve1d(bands, kernel, axis=-2, mode="mirror")
    return np.asarray(ndimage.convolve1d(rows, kernel, axis=-1, mode="mirror"))


def whole_values(bands: np.ndarray) -> np.ndarray:
    """Rounded to 8 bit, and held inside it."""
    return np.clip(np.rint(bands), 0, 255).astype(np.uint8)


def _all(window: KnownWindow) -> tuple[int, ...]:
    return tuple(range(len(window.sources)))
