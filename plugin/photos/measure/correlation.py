"""Normalised cross correlation by FFT (Mikrut and Chwastek 2007, formula 1) and the peaks of it."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import fft

MIN_LOCAL_CONTRAST = 0.002  # of the grey values' range: half a grey value of 8 bits is rounding


@dataclass(frozen=True)
class Peak:
    """A place where a template fits."""

    column: float
    row: float
    value: float
    """Correlation, negative where the template fits inverted."""


class CorrelatedImage:
    """An image in which several templates of one size after another are looked for."""

    def __init__(self, image: np.ndarray, precision: type = np.float64) -> None:
        """``image`` is (rows, columns); ``precision`` of the Fourier transforms, float32 being good to 1e-3."""
        centred = np.asarray(image, dtype=np.float64)
        self._image = centred - (centred.mean() if centred.size else 0.0)
        self._precision = precision
        self._shape = tuple(fft.next_fast_len(n, real=True) for n in self._image.shape)
        self._spectrum = fft.rfft2(self._image.astype(precision), self._shape) if centred.size else None
        self._inverse: dict[tuple[int, int], np.ndarray] = {}
        self._floor = MIN_LOCAL_CONTRAST * (float(np.ptp(self._image)) if self._image.size else 0.0)

    def correlate(self, template: np.ndarray) -> np.ndarray:
        """Correlation at each place where the template lies wholly inside.

        (rows - m + 1, columns - n + 1) for a template (m, n); element (r, c) is for its first pixel on (r, c).
        Where the image has no contrast it is 0.
        """
        pattern = np.asarray(template, dtype=np.float64)
        pattern = pattern - pattern.mean()
        rows, columns = self._image.shape[0] - pattern.shape[0] + 1, self._image.shape[1] - pattern.shape[1] + 1
        energy = float(np.sum(pattern * pattern))
        if rows < 1 or columns < 1 or energy == 0:
            return np.zeros((max(rows, 0), max(columns, 0)))
        spectrum = np.conj(fft.rfft2(pattern.astype(self._precision), self._shape))
        product = fft.irfft2(self._spectrum * spectrum, self._shape)[:rows, :columns]
        return np.clip(product * (self._inverse_contrast(pattern.shape) / self._precision(energy**0.5)), -1, 1)

    def _inverse_contrast(self, size: tuple[int, ...]) -> np.ndarray:
        """One over the root of the sum of squares less its mean under a window at each place; 0 without contrast."""
        key = (size[0], size[1])
        if key not in self._inverse:
            sums = [_window_sums(values, key) for values in (self._image, self._image * self._image)]
            squares = sums[1] - sums[0] ** 2 / (key[0] * key[1])
            usable = squares > max(self._floor**2 * key[0] * key[1], 1e-12)
            made = np.where(usable, 1 / np.sqrt(np.where(usable, squares, 1.0)), 0.0)
            self._inverse[key] = made.astype(self._precision)
        return self._inverse[key]


def correlate(image: np.ndarray, template: np.ndarray) -> np.ndarray:
    """Normalised cross correlation of one template; see ``CorrelatedImage.correlate``."""
    return CorrelatedImage(image).correlate(template)


def _window_sums(values: np.ndarray, size: tuple[int, int]) -> np.ndarray:
    sums = np.zeros((values.shape[0] + 1, values.shape[1] + 1))
    np.cumsum(np.cumsum(values, axis=0), axis=1, out=sums[1:, 1:])
    rows, columns = size
    return np.asarray(sums[rows:, columns:] - sums[:-rows, columns:] - sums[rows:, :-columns] + sums[:-rows, :-columns])


def peak_pixel(field: np.ndarray) -> tuple[int, int]:
    """Row and column of the largest value."""
    row, column = np.unravel_index(int(np.argmax(field)), field.shape)
    return int(row), int(column)


def peaks(field: np.ndarray, distance: int, least: float, most: int) -> list[Peak]:
    """The highest values of either sign, at most ``most`` of each, the best first.

    They are at least ``distance`` px apart and ``least`` high.
    """
    rows, columns = np.nonzero(np.abs(field) >= least)
    values = field[rows, columns]
    order = np.argsort(-np.abs(values))
    rows, columns, values = rows[order], columns[order], values[order]
    found: list[Peak] = []
    for sign in (1, -1):
        own = sign * values > 0
        y, x, height = rows[own], columns[own], values[own]
        for _ in range(most):
            if not len(height):
                break
            found.append(Peak(float(x[0]), float(y[0]), float(height[0])))
            apart = np.maximum(np.abs(y - y[0]), np.abs(x - x[0])) > distance
            y, x, height = y[apart], x[apart], height[apart]
    return sorted(found, key=lambda peak: -abs(peak.value))
