"""Invalid pixels filled smoothly from those around them, so that they add as little detail as can be."""
from __future__ import annotations

import numpy as np
from scipy import ndimage


def filled(bands: np.ndarray, invalid: np.ndarray) -> np.ndarray:
    """(bands, rows, columns) with the invalid pixels, (rows, columns) of bool, filled; at least one has to be valid.

    Pull and push (Gortler and others 1996): means of 2 x 2 valid pixels, of 2 x 2 of those, and so on until nothing
    is missing, then down again by linear interpolation. Whole numbers stay whole numbers.
    """
    if not invalid.any():
        return bands
    result = np.array(bands)
    safe = np.where(invalid, 0, bands) if bands.dtype.kind == "f" else bands
    for target, band in zip(result, safe):
        values = _pulled(band.astype(np.float64), ~invalid)[invalid]
        target[invalid] = values if bands.dtype.kind == "f" else np.rint(values)
    return result


def _pulled(band: np.ndarray, valid: np.ndarray) -> np.ndarray:
    if valid.all():
        return band
    rows, columns = band.shape
    edges = ((0, rows % 2), (0, columns % 2))
    weights = _summed(np.pad(valid.astype(np.float64), edges))
    sums = _summed(np.pad(np.where(valid, band, 0.0), edges))
    coarse = _pulled(sums / np.maximum(weights, 1), weights > 0)
    fine = ndimage.zoom(coarse, 2, order=1, mode="nearest", grid_mode=True)
    return np.where(valid, band, fine[:rows, :columns])


def _summed(values: np.ndarray) -> np.ndarray:
    rows, columns = values.shape
    return values.reshape(rows // 2, 2, columns // 2, 2).sum(axis=(1, 3))
