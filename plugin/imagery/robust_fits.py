"""Least squares that what does not belong to the rest turns little (Holland and Welsch 1977)."""
from __future__ import annotations

import numpy as np

_TUKEY_SCALES = 4.685  # where Tukey's weights vanish: those of 95 % efficiency
_SIGMA_OF_MEDIAN = 1.4826  # standard deviation over the median of absolute values, of a normal distribution
_LEAST_SCALE = 1e-6  # of residuals: smaller ones are rounding


def tukey_weights(residuals: np.ndarray) -> np.ndarray:
    """Weight of each residual: 1 where it is 0, 0 far beyond their scale."""
    scale = max(_SIGMA_OF_MEDIAN * float(np.median(np.abs(residuals))), _LEAST_SCALE)
    return np.asarray(np.clip(1 - (residuals / (_TUKEY_SCALES * scale)) ** 2, 0, None) ** 2)


def robust_fit(terms: np.ndarray, values: np.ndarray, rounds: int = 6) -> tuple[np.ndarray, np.ndarray]:
    """Coefficients of terms (k, points) that make values (points,) of them, and what they leave over: least squares,
    reweighted."""
    weights = np.ones_like(values)
    for _ in range(rounds):
        weighted = terms * weights
        coefficients = np.linalg.lstsq(weighted @ terms.T, weighted @ values, rcond=None)[0]
        residuals = values - coefficients @ terms
        weights = tukey_weights(residuals)
    return coefficients, residuals
