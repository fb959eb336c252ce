"""From a clip to its curves by band, and to what the verdict looks at."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from . import limits
from .band_names import has_colours, measured_bands
from .clips import Clip
from .wavelets import Curve, clip_curves, detail_components

Directions = tuple[tuple[float, ...], ...]
"""Relative variance of LH, HL and HH, for level 1 (finest), 2, ..., R; NaN for a constant clip."""

_STRIP = 65536  # pixels worked on at a time, so that they stay in the cache


def measure_clip(clip: Clip, wavelet: str, levels: int) -> tuple[dict[str, Curve], dict[str, np.ndarray]]:
    """Curves and coarse components of a clip by band name, luminance first where there is one."""
    return measure_bands(clip.bands, clip.raster.band_names, wavelet, levels)


def measure_bands(
    bands: np.ndarray, names: Sequence[str], wavelet: str, levels: int
) -> tuple[dict[str, Curve], dict[str, np.ndarray]]:
    """The same for bands (bands, rows, columns) with their names."""
    weights = limits.LUMINANCE_WEIGHTS if has_colours(names) else ()
    curves, coarse = clip_curves(bands, wavelet, levels, weights)
    if weights:
        curves, coarse = [curves[-1], *curves[:-1]], [coarse[-1], *coarse[:-1]]
    measured = measured_bands(names)
    return dict(zip(measured, curves)), dict(zip(measured, coarse))


def measure_directions(clip: Clip, wavelet: str, levels: int) -> dict[str, Directions]:
    """Relative variances of the directional components of a clip by band name, luminance first where there is one.

    The decomposition is a whole one, in float64, of the luminance too: some five times the work of the curves.
    """
    bands, names = clip.bands.astype(np.float64), clip.raster.band_names
    if has_colours(names):
        weights = np.array(limits.LUMINANCE_WEIGHTS)
        bands = np.concatenate([np.tensordot(weights, bands[: len(weights)], axes=1)[np.newaxis], bands])
    energies = bands.var(axis=(1, 2)) * bands[0].size
    found = [np.sum(parts**2, axis=(2, 3)) for parts in detail_components(bands, wavelet, levels)]
    shares = np.array(found) / np.where(energies > 0, energies, np.nan)  # (levels, directions, bands)
    return {
        name: tuple(map(tuple, own.tolist())) for name, own in zip(measured_bands(names), np.moveaxis(shares, 2, 0))
    }


def luminance(bands: np.ndarray) -> np.ndarray:
    """The luminance, (rows, columns) float32, of bands whose first three are red, green and blue."""
    rows, columns = bands.shape[1:]
    mixture = np.empty((rows, columns), np.float32)
    strip = max(1, _STRIP // columns)
    weighted = np.empty((min(strip, rows), columns), np.float32)
    red, *others = (np.float32(weight) for weight in limits.LUMINANCE_WEIGHTS)
    for start in range(0, rows, strip):
        part = mixture[start : start + strip]
        np.multiply(bands[0, start : start + strip], red, out=part)
        for band, weight in zip(bands[1:], others):
            part += np.multiply(band[start : start + strip], weight, out=weighted[: len(part)])
    return mixture


def judged_plane(bands: np.ndarray, names: Sequence[str]) -> np.ndarray:
    """What the verdict looks at, (rows, columns) float32: the luminance, else the first band."""
    return luminance(bands) if has_colours(names) else bands[0].astype(np.float32)


def correlation(a: np.ndarray, b: np.ndarray) -> float | None:
    """Correlation of two arrays of one shape; None where one of them is constant."""
    a, b = (x.astype(np.float64).ravel() for x in (a, b))
    a, b = a - a.mean(), b - b.mean()
    scale = np.sqrt((a @ a) * (b @ b))
    return float(a @ b / scale) if scale > 0 else None
