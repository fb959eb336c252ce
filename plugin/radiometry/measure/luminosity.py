"""The luminosity of pixels, which JRC's specification judges."""
from __future__ import annotations

import numpy as np

from ...imagery import limits as imagery_limits
from ...imagery.rasters import Raster
from .rules import LUMINOSITY


def has_luminosity(image: Raster) -> bool:
    """Whether there are red, green and blue to mix, or one band that is its own luminosity."""
    return image.has_luminance or len(image.band_names) == 1


def luminosity(bands: np.ndarray) -> np.ndarray:
    """0.299 R + 0.587 G + 0.114 B of (bands, ...), whose first three are red, green and blue; a single band as it is.

    Whole numbers are rounded to whole numbers of the same type: their histogram has the same bins.
    """
    if len(bands) == 1:
        return np.asarray(bands[0])
    is_whole, size = bands.dtype.kind in "iu", bands.dtype.itemsize
    kind = np.float32 if size == 1 or bands.dtype == np.float32 else np.float64  # 24 bits tell 8 of them to 1e-5
    red, green, blue = (kind(weight) for weight in imagery_limits.LUMINANCE_WEIGHTS)
    mixed = bands[0] * red
    mixed += bands[1] * green
    mixed += bands[2] * blue
    if not is_whole:
        return np.asarray(mixed, bands.dtype)
    if bands.dtype.kind == "i":
        return np.rint(mixed).astype(bands.dtype)
    mixed += kind(0.5)
    return mixed.astype(bands.dtype)  # cuts off, so this rounds, in less time


def figure_bands(image: Raster, bands: np.ndarray, names: tuple[str, ...]) -> np.ndarray:
    """(names, ...): the bands of an image, or its luminosity, by their names."""
    own = image.band_names
    if names == own:
        return bands
    return np.stack([luminosity(bands) if name == LUMINOSITY else bands[own.index(name)] for name in names])
