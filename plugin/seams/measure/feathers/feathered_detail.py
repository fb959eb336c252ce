"""What a feather of some width would leave of two sources' detail, known before any mosaic exists.

The two are mixed along every place where the seam may run,

    kept = sum |(1 - a) p + a q|^2 / sum |the one that is followed|^2

with p and q their own details: what a cut adds, its edge, is detail of neither. Texture is not even, so it is summed
where it lies: over the window, and over the feather's own strip.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from ....imagery import limits as imagery_limits
from ....imagery.wavelets import placed_components
from ..limits import GAUSSIAN, LINEAR

SIGMAS_PER_WIDTH = 4.0  # a Gaussian has no end; over two sigmas to either side the weights go from 0.02 to 0.98


@dataclass(frozen=True, eq=False)
class PlacedFeather:
    """A feather between two sources at one place in a window; its arrays are (rows, columns)."""

    weight: np.ndarray
    """Share of the second source, 0 to 1, float32."""
    strip: np.ndarray
    """The feather's full width, bool."""


def place_feather(distance: np.ndarray, ramp: str, width_m: float, pixel_m: tuple[float, float]) -> PlacedFeather:
    """The feather of a full width along a seam.

    ``distance``: (rows, columns) m from the seam, negative on one side. ``ramp``: one of ``limits.RAMPS``.
    ``pixel_m``: height and width of a pixel.
    """
    if ramp == GAUSSIAN:
        weight = _smoothed(distance > 0, width_m / SIGMAS_PER_WIDTH / np.array(pixel_m))
    else:
        across = np.clip(distance / width_m, -0.5, 0.5)
        weight = 0.5 + (across if ramp == LINEAR else np.sin(np.pi * across) / 2)
    return PlacedFeather(weight.astype(np.float32), abs(distance) <= width_m / 2)


@dataclass(frozen=True)
class KeptDetail:
    """Detail variance of the feathered sources over their own, levels 1..R; None where there is none."""

    window: tuple[float | None, ...]
    """In the whole window."""
    strip: tuple[float | None, ...]
    """In the feather's full width."""


def kept_detail(
    first: np.ndarray, second: np.ndarray, feathers: Sequence[PlacedFeather], wavelet: str, levels: int
) -> KeptDetail:
    """What feathers leave of two sources' planes, (rows, columns) each.

    Detail is summed over all places where the seam may run, and over both ways of sharing the sides out to the sources.
    """
    planes = np.stack([first, second]).astype(np.float32)
    energies = np.zeros((2, 2, levels))  # feathered and cut; window and strip
    for level, details in enumerate(placed_components(planes, wavelet, levels)):
        own, both = (details**2).sum(axis=(0, 1)), 2 * (details[:, 0] * details[:, 1]).sum(axis=0)
        for feather in feathers:
            # Of (1 - a) p + a q and a p + (1 - a) q together.
            apart = 2 * feather.weight * (1 - feather.weight)
            lost, strip = (_square_means(one, 2 ** (level + 1)) for one in (apart, feather.strip))
            for row, energy in enumerate(((1 - lost) * own + lost * both, own)):
                energies[row, 0, level] += float(energy.sum(dtype=np.float64))
                energies[row, 1, level] += float((energy * strip).sum(dtype=np.float64))
    least = imagery_limits.MIN_SHARE * planes.size * float(planes.var(axis=(1, 2), dtype=np.float64).sum())
    feathered, cut = energies
    window, strip = (
        tuple(float(a / b) if b > least else None for a, b in zip(*both)) for both in zip(feathered, cut)
    )
    return KeptDetail(window, strip)


def least_kept(found: Sequence[KeptDetail]) -> KeptDetail:
    """The smallest over several pairs of sources, level by level: where feathering will hurt most."""
    return KeptDetail(*(
        tuple(min((one for one in values if one is not None), default=None) for values in zip(*pairs))
        for pairs in ([one.window for one in found], [one.strip for one in found])
    ))


def _smoothed(mask: np.ndarray, sigma_px: np.ndarray) -> np.ndarray:
    """A mask smoothed by a Gaussian.

    A wide one is smoothed on a coarser grid, off by up to 0.02 at the window's edge and by 0.0005 in the mean.
    """
    fits = (side for side in (8, 4, 2) if 4 * side <= sigma_px.min() and not any(size % side for size in mask.shape))
    side = next(fits, 1)
    smooth = ndimage.gaussian_filter(_square_means(mask, side), sigma_px / side, mode="nearest")
    return np.asarray(ndimage.zoom(smooth, side, order=1, grid_mode=True, mode="nearest")) if side > 1 else smooth


def _square_means(values: np.ndarray, side: int) -> np.ndarray:
    """Over each coefficient's square of ``side`` px; of a mask the share that lies in it."""
    rows, columns = values.shape
    return values.reshape(rows // side, side, columns // side, side).mean(axis=(1, 3))
