"""Strength of detail as a function of how strong it was: a curve through ratios of a value to an energy.

Compression, noise and sharpening treat weak and strong detail differently. The ratio is a smooth curve over the
logarithm of the energy, fitted by a generalised linear model with a logarithmic link (McCullagh and Nelder 1989): a
parabola takes three numbers where a table of quantiles would take a dozen, so a small window is enough.
"""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

_LEAST_ENERGY = 1e-2  # DN squared: below what rounding to whole values leaves
_ROUNDS = 5
_MOST_POINTS = 3000
_MOST_EXPONENT = 8.0  # a factor of three thousand either way
_MOST_STEP = 3.0  # of an exponent, that one place asks for in a round
_RIDGE = 1e-7
_OUTERMOST = (0.02, 0.98)  # of the energies: beyond these quantiles the curve is held where it is


@dataclass(frozen=True, eq=False)
class EnergyResponse:
    """value / energy = exp(parabola of log energy)."""

    coefficients: np.ndarray
    """(3,) of 1, l, l^2, with l = log e - middle."""
    middle: float
    """Mean of log e: what grey values are counted in doesn't matter."""
    lowest: float
    """log e; below it the curve is level."""
    highest: float
    """log e; above it the curve is level."""

    def __call__(self, energies: np.ndarray) -> np.ndarray:
        """The ratio at each energy, an array of the same shape."""
        logs = np.log(energies + _LEAST_ENERGY)
        np.clip(logs, self.lowest, self.highest, out=logs)
        logs -= self.middle
        first, second, third = self.coefficients.tolist()
        return np.asarray(np.exp(bounded((logs * third + second) * logs + first)))


def sampled(values: np.ndarray) -> np.ndarray:
    """Values, evenly spread, as many as a curve is fitted to."""
    return values[:: -(-len(values) // _MOST_POINTS) or 1]


def fit_response(energies: np.ndarray, values: np.ndarray) -> EnergyResponse:
    """The curve through the ratios values / energies, both (n,), n at least 3; strong detail counts for more."""
    energies, values = sampled(energies) + np.float64(_LEAST_ENERGY), sampled(values).astype(np.float64)
    logs, ratios = np.log(energies), values / energies
    lowest, highest = np.quantile(logs, _OUTERMOST).tolist()
    middle = float(logs.mean())
    terms = np.stack([(logs - middle) ** power for power in range(3)])
    level = max(values.sum() / energies.sum(), np.exp(-_MOST_EXPONENT))
    coefficients = log_link_fit(terms, ratios / level, np.sqrt(energies), _MOST_STEP, _ROUNDS)
    coefficients[0] += np.log(level)
    return EnergyResponse(coefficients, middle, lowest, highest)


def log_link_fit(
    terms: np.ndarray, ratios: np.ndarray, weights: np.ndarray, most_step: float, rounds: int
) -> np.ndarray:
    """Coefficients (k,) of ratios (n,), about 1, = exp(coefficients @ terms (k, n)), by rounds of weighted least
    squares; a ratio counts at most as ``1 + most_step`` times what is expected."""
    weighted = terms * weights
    normal = weighted @ terms.T
    inverse = np.linalg.inv(normal + _RIDGE * np.trace(normal) * np.eye(len(terms)))
    exponent = np.zeros(len(ratios))
    for _ in range(rounds):
        coefficients = inverse @ (weighted @ (np.minimum(ratios * np.exp(-exponent) - 1, most_step) + exponent))
        exponent = bounded(coefficients @ terms)
    return coefficients


def bounded(exponents: np.ndarray) -> np.ndarray:
    return np.clip(exponents, -_MOST_EXPONENT, _MOST_EXPONENT, out=exponents)
