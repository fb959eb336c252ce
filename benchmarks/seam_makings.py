"""How a seam is made of orthoimages: cut, feathered over a known width or blended, maybe after changing one of them."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from .detail import luminance_of
from .known_windows import KnownWindow, crooked_cut

PYRAMID_LEVELS = 5
MEETING_RADIUS = 0.25
"""Share of the frame's side: how far from its middle three sources may meet."""

Mix = Callable[[KnownWindow, np.random.Generator], "Mixed"]
Change = Callable[[np.ndarray, np.random.Generator], np.ndarray]
"""Change of one source's bands, 8 bit to 8 bit."""


@dataclass(frozen=True, eq=False)
class Part:
    """What a mosaic took of a source, or of one component of it."""

    plane: np.ndarray
    """Luminance, (rows, columns) float32, in the mosaic's tones."""
    weight: np.ndarray
    """How much of it each pixel has, (rows, columns) float32."""


@dataclass(frozen=True, eq=False)
class Mixed:
    """A mosaic of one frame and all that is known of it."""

    bands: np.ndarray
    """(bands, rows, columns) 8 bit."""
    planes: tuple[np.ndarray, ...]
    """Luminance of the window's sources as they went into the mosaic, in its tones, (rows, columns) float32."""
    parts: tuple[Part, ...]
    """What the mosaic is the sum of; the weights of whole sources add up to 1."""
    labels: np.ndarray
    """(rows, columns) uint8: the window's source on whose side of the seam each pixel lies."""
    given: tuple[int, ...]
    """The window's sources that are given to whoever judges the mosaic."""

    @property
    def foreign(self) -> np.ndarray:
        """Pixels from a source that is not given, (rows, columns) bool."""
        return ~np.isin(self.labels, self.given)


def mixed(
    sources: Sequence[np.ndarray], weights: Sequence[np.ndarray], labels: np.ndarray, given: Sequence[int] | None = None
) -> Mixed:
    """Whole sources by weights that add up to 1, (rows, columns) each; all sources are given unless said otherwise."""
    bands = whole_values(np.asarray(sum(weight * source for weight, source in zip(weights, sources))))
    planes = tuple(luminance_of(source) for source in sources)
    parts = tuple(Part(plane, weight) for plane, weight in zip(planes, weights) if weight.any())
    return Mixed(bands, planes, parts, labels, tuple(range(len(sources)) if given is None else given))


def cut_or_feathered(
    sources: Sequence[np.ndarray], labels: np.ndarray, width_px: float = 0.0, shape: str = "cosine",
    given: Sequence[int] | None = None,
) -> Mixed:
    """Width 0: cut hard."""
    return mixed(sources, feather_weights(len(sources), labels, width_px, shape), labels, given)


def hard(window: KnownWindow, rng: np.random.Generator) -> Mixed:
    """Cut as the window is."""
    return cut_or_feathered(window.sources, window.labels)


def feathered(width_px: float, shape: str = "cosine") -> Mix:
    """Sources weighted across the cut over a full width; for ``gaussian`` it is the sigma."""
    return changed({}, width_px, shape)


def changed(changes: dict[int, Change], width_px: float = 0.0, shape: str = "cosine") -> Mix:
    """Feathered after the main sources (0 and 1) were changed; width 0: cut hard."""

    def mix(window: KnownWindow, rng: np.random.Generator) -> Mixed:
        sources = list(window.sources)
        for number, change in changes.items():
            sources[window.main[number]] = change(sources[window.main[number]], rng)
        return cut_or_feathered(sources, window.labels, width_px, shape)

    return mix


def each_changed(change: Change, width_px: float = 0.0) -> Mix:
    """Feathered after every source was changed in a way of its own, as its draw has it; width 0: cut hard."""

    def mix(window: KnownWindow, rng: np.random.Generator) -> Mixed:
        return cut_or_feathered([change(source, rng) for source in window.sources], window.labels, width_px)

    return mix


def blended(window: KnownWindow, rng: np.random.Generator) -> Mixed:
    """Seam blended by Laplacian pyramids (Burt and Adelson 1983)."""
    masks = [gaussian(window.labels == k) for k in _all(window)]
    pyramids = [laplacian(source) for source in window.sources]
    levels = [sum(image[r] * mask[r] for image, mask in zip(pyramids, masks)) for r in range(PYRAMID_LEVELS + 1)]
    blend = levels.pop()
    while levels:
        fine = levels.pop()
        blend = fine + expand(blend, fine.shape[-2:])
    planes = tuple(luminance_of(source) for source in window.sources)
    parts = [
        Part(_whole(component, plane.shape), _whole(weight, plane.shape))
        for plane, mask in zip(planes, masks) for component, weight in zip(laplacian(plane), mask) if mask[0].any()
    ]
    return Mixed(whole_values(blend), planes, tuple(parts), window.labels, _all(window))


def missing(share: float, width_px: float = 0.0) -> Mix:
    """A share of the pixels comes from a source that is not given."""

    def mix(window: KnownWindow, rng: np.random.Generator) -> Mixed:
        first, second = window.main
        depth = signed_distance(window.labels == second)
        labels = np.where(depth >= np.quantile(depth[window.middle], 1 - share), second, first).astype(np.uint8)
        given = [k for k in _all(window) if k != second]
        return cut_or_feathered(window.sources, labels, width_px, given=given)

    return mix


def meeting(width_px: float) -> Mix:
    """Three sources that meet inside the window."""

    def mix(window: KnownWindow, rng: np.random.Generator) -> Mixed:
        reach = int(MEETING_RADIUS * window.side)
        other = np.roll(crooked_cut(len(window.labels), rng), rng.integers(-reach, reach, 2), (0, 1))
        first, second = window.main
        third = next(k for k in _all(window) if k not in (first, second))
        labels = np.where((window.labels == second) & other, third, window.labels).astype(np.uint8)
        return cut_or_feathered(window.sources, labels, width_px)

    return mix


def feather(sources: Sequence[np.ndarray], labels: np.ndarray, width_px: float, shape: str) -> np.ndarray:
    """The bands, rounded to 8 bit."""
    return mixed(sources, feather_weights(len(sources), labels, width_px, shape), labels).bands


def feather_weights(count: int, labels: np.ndarray, width_px: float, shape: str) -> list[np.ndarray]:
    """Weights by the distance from each source's own border; where two meet they add up to 1. Width 0: cut hard."""
    inside = [labels == number for number in range(count)]
    if not width_px:
        return [one.astype(np.float32) for one in inside]
    weights = [
        ramp(signed_distance(one), width_px, shape) if one.any() else np.zeros(labels.shape, np.float32)
        for one in inside
    ]
    total = np.maximum(np.sum(weights, axis=0), 1e-6)
    return [weight / total for weight in weights]


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


def _whole(level: np.ndarray, shape: Sequence[int]) -> np.ndarray:
    """A level of a pyramid in the size of the image."""
    sizes = [tuple(shape)]
    while sizes[-1] != level.shape[-2:]:
        sizes.append(tuple((size + 1) // 2 for size in sizes[-1]))
    for size in sizes[-2::-1]:
        level = expand(level, size)
    return level


def _smoothed(bands: np.ndarray) -> np.ndarray:
    kernel = np.array([1, 4, 6, 4, 1], np.float32) / 16
    rows = ndimage.convolve1d(bands, kernel, axis=-2, mode="mirror")
    return np.asarray(ndimage.convolve1d(rows, kernel, axis=-1, mode="mirror"))


def whole_values(bands: np.ndarray) -> np.ndarray:
    """Rounded to 8 bit, and held inside it."""
    return np.clip(np.rint(bands), 0, 255).astype(np.uint8)


def _all(window: KnownWindow) -> tuple[int, ...]:
    return tuple(range(len(window.sources)))
