"""What production does to bands: to a whole mosaic after the seams were made, or to one source before.

Each is (bands, rows, columns) 8 bit to the same, with a random generator for what needs one.
"""
from __future__ import annotations

from collections.abc import Callable, Sequence
from uuid import uuid4

import numpy as np
from osgeo import gdal
from scipy import ndimage

from .seam_makings import Change, whole_values

FLATTENED_SIGMA_PX = 40.0


def nothing(bands: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    return bands


def unsharp(amount: float, radius_px: float = 1.0) -> Change:
    return lambda bands, rng: whole_values(bands + amount * (bands - smoothed(bands, radius_px)))


def jpeg(quality: int) -> Change:
    """Once to a file and back, by GDAL's driver (which stores the colours of half the pixels)."""
    return _written("JPEG", f"QUALITY={quality}")


def jpeg2000(percent: int) -> Change:
    """To a file of so much of the size and back."""
    return _written("JP2OpenJPEG", f"QUALITY={percent}", "REVERSIBLE=NO")


def webp(quality: int) -> Change:
    """To a file and back."""
    return _written("WEBP", f"QUALITY={quality}")


def _written(driver: str, *options: str) -> Change:
    def change(bands: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        count, rows, columns = bands.shape
        memory = gdal.GetDriverByName("MEM").Create("", columns, rows, count, gdal.GDT_Byte)
        memory.WriteArray(bands)
        path = f"/vsimem/{uuid4().hex}"
        gdal.GetDriverByName(driver).CreateCopy(path, memory, options=list(options))
        found = gdal.Open(path).ReadAsArray()
        gdal.GetDriverByName(driver).Delete(path)
        return np.asarray(found)

    return change


def median3(bands: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Median of 3 x 3 pixels."""
    return np.asarray(ndimage.median_filter(bands, (1, 3, 3), mode="nearest"))


def noise(sigma: float) -> Change:
    return lambda bands, rng: whole_values(bands + rng.normal(0, sigma, bands.shape))


def gains(factors: Sequence[float]) -> Change:
    """One for each band."""
    return lambda bands, rng: whole_values(bands * np.asarray(factors, np.float32)[:, None, None])


def dodged(first: float, last: float) -> Change:
    """A gain that changes evenly from left to right."""
    return lambda bands, rng: whole_values(bands * np.linspace(first, last, bands.shape[2], dtype=np.float32))


def dodged_round(middle: float, corner: float) -> Change:
    """A gain that changes with the square of the distance from the middle, as light falls off."""

    def change(bands: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        y, x = (np.linspace(-1, 1, size, dtype=np.float32) for size in bands.shape[1:])
        return whole_values(bands * (middle + (corner - middle) * (y[:, None] ** 2 + x**2) / 2))

    return change


def flattened(share: float) -> Change:
    """That share of what a wide local mean differs from the mean is taken out."""

    def change(bands: np.ndarray, rng: np.random.Generator) -> np.ndarray:
        background = smoothed(bands, FLATTENED_SIGMA_PX) - bands.mean(axis=(1, 2), keepdims=True)
        return whole_values(bands - share * background)

    return change


def blurred(sigma_px: float) -> Change:
    return lambda bands, rng: whole_values(smoothed(bands, sigma_px))


def resampled(y_px: float, x_px: float, order: int) -> Change:
    """Moved by parts of a pixel and interpolated; order 1: bilinear, 3: cubic convolution as GDAL does it."""

    return lambda bands, rng: whole_values(interpolated(bands, y_px, x_px, order))


def interpolated(bands: np.ndarray, y_px: float, x_px: float, order: int) -> np.ndarray:
    """Moved, not rounded, float32."""
    moved = bands.astype(np.float32)
    for axis, part in ((1, y_px), (2, x_px)):
        moved = ndimage.convolve1d(moved, taps(part, order), axis=axis, mode="nearest")
    return moved


def resampled_and_balanced(bands: np.ndarray, rng: np.random.Generator) -> np.ndarray:
    """Bands as of one source: moved by its own 0.2 to 0.6 px by cubic convolution, by its own gain and bias."""
    way, length = rng.uniform(0, 2 * np.pi), rng.uniform(0.2, 0.6)
    moved = interpolated(bands, length * np.sin(way), length * np.cos(way), 3)
    return whole_values(moved * rng.uniform(0.88, 1.12) + rng.uniform(-8, 8))


def taps(part: float, order: int) -> np.ndarray:
    """The kernel, for ``ndimage.convolve1d``, that moves an image by a part of a pixel or some pixels."""
    reach = int(np.ceil(abs(part))) + 2
    at = np.abs(np.arange(-reach, reach + 1) - part)
    if order == 1:
        return np.clip(1 - at, 0, None)
    near, far = 1.5 * at**3 - 2.5 * at**2 + 1, -0.5 * at**3 + 2.5 * at**2 - 4 * at + 2  # Keys 1981, a = -1/2
    return np.where(at < 1, near, np.where(at < 2, far, 0.0))


def clipping(share: float) -> Callable[[np.ndarray], Change]:
    """A stretch until that share of the values of given bands leaves the scale, half at either end."""

    def fitted(bands: np.ndarray) -> Change:
        low, high = np.percentile(bands, (50 * share, 100 - 50 * share))
        return lambda found, rng: whole_values((found - low) * np.float32(255 / (high - low)))

    return fitted


def smoothed(bands: np.ndarray, sigma_px: float) -> np.ndarray:
    """Bands smoothed by a Gaussian."""
    return np.asarray(ndimage.gaussian_filter(bands.astype(np.float32), (0, sigma_px, sigma_px), mode="nearest"))
