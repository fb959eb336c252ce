"""From a clip to its curves by band, and which of the bands is judged."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from . import thresholds
from .rasters import Clip, Raster
from .wavelets import Curve, clip_curves

LUMINANCE = "luminance"


def judged_band(raster: Raster) -> str:
    """Luminance where there are three bands or more, else the first band."""
    return LUMINANCE if raster.has_luminance else raster.band_names[0]


def measure_clip(clip: Clip, wavelet: str, levels: int) -> tuple[dict[str, Curve], dict[str, np.ndarray]]:
    """Curves and coarse components of a clip by band name, luminance first where there is one."""
    return measure_bands(clip.bands, clip.raster.band_names, wavelet, levels)


def measure_bands(
    bands: np.ndarray, names: Sequence[str], wavelet: str, levels: int
) -> tuple[dict[str, Curve], dict[str, np.ndarray]]:
    """The same for bands (bands, rows, columns) with their names."""
    mixed = tuple(names[:3]) == ("red", "green", "blue")
    curves, coarse = clip_curves(bands, wavelet, levels, thresholds.LUMINANCE_WEIGHTS if mixed else ())
    by_name = [LUMINANCE, *names] if mixed else list(names)
    if mixed:
        curves, coarse = [curves[-1], *curves[:-1]], [coarse[-1], *coarse[:-1]]
    return dict(zip(by_name, curves)), dict(zip(by_name, coarse))


def luminance(bands: np.ndarray) -> np.ndarray:
    """The luminance, (rows, columns) float32, of bands whose first three are red, green and blue."""
    red, green, blue = (np.float32(weight) for weight in thresholds.LUMINANCE_WEIGHTS)
    mixture: np.ndarray = bands[0] * red
    mixture += bands[1] * green
    mixture += bands[2] * blue
    return mixture


def judged_plane(bands: np.ndarray, names: Sequence[str]) -> np.ndarray:
    """What the verdict looks at, (rows, columns) float32: the luminance, else the first band."""
    if tuple(names[:3]) == ("red", "green", "blue"):
        return luminance(bands)
    return bands[0].astype(np.float32)


def correlation(a: np.ndarray, b: np.ndarray) -> float | None:
    """Correlation of two arrays of one shape; None where one of them is constant."""
    a, b = (x.astype(np.float64).ravel() for x in (a, b))
    a, b = a - a.mean(), b - b.mean()
    scale = np.sqrt((a @ a) * (b @ b))
    return float(a @ b / scale) if scale > 0 else None
