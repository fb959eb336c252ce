"""The two analysis filters of an orthogonal wavelet, and the matrices that apply them to a block of samples."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, lru_cache

import numpy as np
import pywt

MAX_FILTER_ERROR = 1e-9  # orthonormality of PyWavelets' coefficients: 1e-11 at worst (sym20), dmey 2e-3

BLOCK = 8
"""Outputs of each filter per matrix product."""


@dataclass(frozen=True)
class FilterPair:
    """Low-pass and high-pass, taps in the order in which they meet the samples."""

    low: tuple[float, ...]
    high: tuple[float, ...]

    @property
    def margin(self) -> int:
        """Samples before the first of two, and after the last, that their outputs need: there PyWavelets has them."""
        return len(self.low) // 2 - 1

    def delays_px(self, level: int) -> tuple[float, float]:
        """How far behind its own pixels lies what a coefficient of a level comes from, by the energy of the taps: along
        an axis that the low-pass and one that the high-pass came over last."""
        low, high = (_middle(taps) - (len(taps) - 1) / 2 for taps in (self.low, self.high))
        before = low * (2 ** (level - 1) - 1)
        return before + 2 ** (level - 1) * low, before + 2 ** (level - 1) * high

    @property
    def orthonormal(self) -> bool:
        """Whether the low-pass is orthonormal to its even shifts as closely as the energy chain needs."""
        even_shifts = np.correlate(self.low, self.low, "full")[len(self.low) - 1 :: 2]
        even_shifts[0] -= 1
        return bool(np.abs(even_shifts).max() < MAX_FILTER_ERROR)

    def low_matrix(self, dtype: type) -> np.ndarray:
        """(BLOCK, 2 BLOCK + L - 2): row i holds the low-pass from sample 2 i on, times its ``scale``."""
        return _band_matrix(self.low, scale(self.low, dtype), dtype)

    def both_matrix(self, dtype: type) -> np.ndarray:
        """(2 BLOCK, 2 BLOCK + L - 2): the low-pass as it is, below it the high-pass."""
        return _both_matrix(self, dtype)


@cache
def filter_pair(wavelet: str) -> FilterPair:
    """Those of a wavelet of PyWavelets."""
    bank = pywt.Wavelet(wavelet)
    return FilterPair(tuple(reversed(bank.dec_lo)), tuple(reversed(bank.dec_hi)))


@lru_cache(maxsize=1024)
def _both_matrix(filters: FilterPair, dtype: type) -> np.ndarray:
    return np.concatenate([_band_matrix(taps, 1.0, dtype) for taps in (filters.low, filters.high)])


@lru_cache(maxsize=1024)
def _band_matrix(taps: tuple[float, ...], factor: float, dtype: type) -> np.ndarray:
    matrix = np.zeros((BLOCK, 2 * BLOCK + len(taps) - 2), dtype=dtype)
    for i in range(BLOCK):
        matrix[i, 2 * i : 2 * i + len(taps)] = np.array(taps) * factor
    return matrix


@cache
def scale(taps: tuple[float, ...], dtype: type) -> float:
    """The factor, 1 to 2, with which the taps lose least when they are rounded to ``dtype``.

    Rounded as they are, they would change the gain, and with it the background of every float32 curve, by up
    to 5e-8 a level and axis; multiplied by this factor first, by less than 5e-9 at any frequency.
    """
    if dtype is np.float64:
        return 1.0
    factors = 2 ** np.linspace(0, 1, 512, endpoint=False)[:, np.newaxis]
    rounded = (factors * taps).astype(dtype) / factors
    gains, exact_gains = (np.abs(np.fft.rfft(x, 256)) ** 2 for x in (rounded, np.array(taps)))
    return float(factors[np.abs(gains - exact_gains).max(axis=1).argmin(), 0])


def _middle(taps: Sequence[float]) -> float:
    energies = np.square(taps)
    return float(energies @ np.arange(len(taps)) / energies.sum())
