"""Normalised cross correlation by FFT (Mikrut and Chwastek 2007, formula 1) and the peaks of it."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy import fft

from ...imagery.errors import SeamInspectorError
from . import messages

MIN_LOCAL_CONTRAST = 0.002  # of the grey values' range: half a grey value of 8 bits is rounding
MIN_CURVATURE = 1e-4  # of a correlation: per px squared; true peaks have 0.005 and more
SURFACE_REACH_PX = 1  # 3 x 3 correlations for six coefficients; wider ones follow grain and scratches more


@dataclass(frozen=True)
class Peak:
    """The place of a template that fits."""

    column: float
    row: float
    value: float  # correlation, negative where the template fits inverted


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
        """Correlation at each place where the template lies wholly inside: (rows - m + 1, columns - n + 1) for a
        template (m, n); element (r, c) is for its first pixel on (r, c). Where the image has no contrast it is 0."""
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
    row, column = np.unravel_index(int(np.argmax(field)), field.shape)
    return int(row), int(column)


def peaks(field: np.ndarray, distance: int, least: float, most: int) -> list[Peak]:
    """The highest values of either sign, at most ``most`` of each, the best first. They are at least ``distance`` px
    apart and ``least`` high."""
    rows, columns = np.nonzero(np.abs(field) >= least)
    values = field[rows, columns]
    order = np.argsort(-np.abs(values))
    rows, columns, values = rows[order], columns[order], values[order]
    highest: list[Peak] = []
    for sign in (1, -1):
        same = sign * values > 0
        y, x, height = rows[same], columns[same], values[same]
        for _ in range(min(most, len(height))):
            if len(height):
                highest.append(Peak(float(x[0]), float(y[0]), float(height[0])))
                apart = np.maximum(np.abs(y - y[0]), np.abs(x - x[0])) > distance
                y, x, height = y[apart], x[apart], height[apart]
    return sorted(highest, key=lambda peak: -abs(peak.value))


class SurfaceError(SeamInspectorError):
    """A surface without a usable extremum."""


def fit_surface(values: np.ndarray) -> np.ndarray:
    """a0..a5 of a0 + a1 x + a2 y + a3 x2 + a4 xy + a5 y2 by least squares. ``values`` is (2 n + 1, 2 n + 1); x runs to
    the right and y downwards from its middle, px."""
    n = values.shape[0] // 2
    y, x = np.mgrid[-n : n + 1, -n : n + 1].astype(np.float64)
    x, y = x.ravel(), y.ravel()
    terms = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=1)
    return np.asarray(np.linalg.lstsq(terms, values.ravel().astype(np.float64), rcond=None)[0])


def surface_extremum(coefficients: np.ndarray, reach: float, contrast: float = 1.0) -> tuple[float, float, bool]:
    """x and y where both derivatives vanish, and whether it is a maximum. Raises SurfaceError for a saddle, for a
    surface flatter than ``MIN_CURVATURE`` of the contrast, and for an extremum further than ``reach`` from the middle
    along an axis."""
    _, a1, a2, a3, a4, a5 = coefficients
    determinant = 4 * a3 * a5 - a4 * a4
    small, _ = sorted(np.abs(np.linalg.eigvalsh([[2 * a3, a4], [a4, 2 * a5]])))
    if not np.isfinite(small) or small <= MIN_CURVATURE * contrast:
        raise SurfaceError(messages.SURFACE_FLAT())
    if determinant < 0:
        raise SurfaceError(messages.SURFACE_SADDLE())
    x, y = (a4 * a2 - 2 * a5 * a1) / determinant, (a4 * a1 - 2 * a3 * a2) / determinant
    if max(abs(x), abs(y)) > reach:
        raise SurfaceError(messages.SURFACE_OUTSIDE())
    return float(x), float(y), bool(a3 < 0)


def subpixel_maximum(values: np.ndarray, row: int, column: int) -> tuple[float, float]:
    """Column and row of the maximum near a pixel of a field, sub-pixel; the field's pixel (r, c) lies at (c, r). Raises
    SurfaceError where there is none."""
    rows, columns = values.shape
    reach = min(SURFACE_REACH_PX, row, column, rows - 1 - row, columns - 1 - column)
    if reach < 1:
        raise SurfaceError(messages.SURFACE_OUTSIDE())
    around = values[row - reach : row + reach + 1, column - reach : column + reach + 1]
    x, y, is_maximum = surface_extremum(fit_surface(around), reach)
    if not is_maximum:
        raise SurfaceError(messages.SURFACE_SADDLE())
    return column + x, row + y
