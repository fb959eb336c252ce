"""What scipy says of the coefficients of PyWavelets' periodised decomposition that do not see the border."""
from __future__ import annotations

import numpy as np
import pywt
from scipy import stats

from tests.numbers.synthetic import wavedec


def inner_kurtoses(band: np.ndarray, wavelet: str, levels: int) -> list[float]:
    """The kurtosis of each level, the three components less their means together."""
    sides = [_inner(length, wavelet, levels) for length in band.shape]
    kurtoses = []
    for components, rows, columns in zip(wavedec(band, wavelet, levels)[:0:-1], *sides):
        parts = [part[np.ix_(rows, columns)] for part in components]
        values = np.concatenate([(part - part.mean()).ravel() for part in parts])
        kurtoses.append(float(stats.kurtosis(values, fisher=False)))
    return kurtoses


def _inner(length: int, wavelet: str, levels: int) -> list[np.ndarray]:
    """Indices of each level's coefficients of a line that are the same where it is the middle of a longer one."""
    line = np.random.default_rng(0).normal(0, 1, 3 * length)
    alone, longer = (
        pywt.wavedec(samples, wavelet, mode="periodization", level=levels)[:0:-1]
        for samples in (line[length : 2 * length], line)
    )
    return [
        np.flatnonzero(np.isclose(details, there[len(details) : 2 * len(details)], rtol=0, atol=1e-13))
        for details, there in zip(alone, longer)
    ]
