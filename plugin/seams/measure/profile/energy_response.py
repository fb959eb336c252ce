"""How strong detail came over as a function of how strong it was.

Compression, noise and sharpening treat weak and strong detail differently, and what a seam did shows only where that is
taken out. The ratio of a value to an energy is a smooth curve over the logarithm of the energy, fitted by a generalised
linear model with a logarithmic link (McCullagh and Nelder 1989): a parabola takes three numbers where a table of
quantiles would take a dozen, so a small window is enough.
"""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

_LEAST_ENERGY = 1e-2  # DN squared: below what rounding to whole values leaves
_ROUNDS = 5
_SETTLED = 1e-6  # change of the logarithm of a ratio
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
        return self.at(log_energies(energies))

    def at(self, logs: np.ndarray) -> np.ndarray:
        """The same by ``log_energies``, for those who ask more than once."""
        logs = np.minimum(np.maximum(logs, self.lowest), self.highest)
        logs -= self.middle
        first, second, third = self.coefficients.tolist()
        exponents = logs * third
        exponents += second
        exponents *= logs
        exponents += first
        np.minimum(exponents, _MOST_EXPONENT, out=exponents)
        np.maximum(exponents, -_MOST_EXPONENT, out=exponents)
        return np.asarray(np.exp(exponents, out=exponents))


def log_energies(energies: np.ndarray) -> np.ndarray:
    """What a curve is a parabola of."""
    return np.asarray(np.log(energies + _LEAST_ENERGY))


def sampled(values: np.ndarray) -> np.ndarray:
    """As many of them, evenly spread, as a curve is fitted to."""
    return values[:: -(-len(values) // _MOST_POINTS) or 1]


def fit_response(energies: np.ndarray, values: np.ndarray) -> EnergyResponse:
    """The curve through the ratios values / energies, both (n,), n at least 3; strong detail counts for more."""
    energies, values = sampled(energies).astype(np.float64), sampled(values).astype(np.float64)
    energies += _LEAST_ENERGY
    logs = np.log(energies)
    lowest, highest = _quantiles(logs)
    middle = float(logs.mean())
    logs -= middle
    ratios = values / energies
    terms = np.stack([np.ones_like(logs), logs, logs * logs])
    weighted = terms * np.sqrt(energies)
    normal = weighted @ terms.T
    normal += _RIDGE * np.trace(normal) * np.eye(3)
    inverse = np.linalg.inv(normal)
    mean = float(values.sum() / energies.sum())
    exponent = np.full(len(logs), np.log(max(mean, np.exp(-_MOST_EXPONENT))))
    coefficients = np.zeros(3)
    for _ in range(_ROUNDS):
        working = ratios * np.exp(-exponent)
        working -= 1
        np.minimum(working, _MOST_STEP, out=working)
        working += exponent
        before, coefficients = coefficients, inverse @ (weighted @ working)
        exponent = coefficients @ terms
        np.minimum(exponent, _MOST_EXPONENT, out=exponent)
        np.maximum(exponent, -_MOST_EXPONENT, out=exponent)
        if np.abs(coefficients - before).max() < _SETTLED:
            break
    return EnergyResponse(coefficients, middle, lowest, highest)


def _quantiles(values: np.ndarray) -> tuple[float, float]:
    """The outermost, as ``np.quantile`` has them."""
    places = [share * (len(values) - 1) for share in _OUTERMOST]
    whole = [int(place) for place in places]
    beside = [min(place + 1, len(values) - 1) for place in whole]
    ordered = np.partition(values, sorted({*whole, *beside}))
    first, last = (
        float(ordered[a] + (place - a) * (ordered[b] - ordered[a])) for place, a, b in zip(places, whole, beside)
    )
    return first, last
