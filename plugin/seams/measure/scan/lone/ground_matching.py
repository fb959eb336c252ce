"""How much fine detail ground like that has: cells are compared with others that look like them.

A generalised linear model with a logarithmic link (McCullagh and Nelder 1989) of the finest energy over a quadratic in
the brightness and the colour. It is fitted to cells off the seam, so whatever was done to the whole mosaic is in it.
Coarser detail is left out: it would tell grounds apart better, and would hide feathers between images that show the
ground in different places, since these take from it, too.
"""
from __future__ import annotations

import numpy as np

CAP = 2.0
"""A cell counts at most as so many times what is expected of it: kerbs and roofs are not what is looked for."""

_ROUNDS = 12
_RIDGE = 1e-4
_OUTERMOST = (0.01, 0.99)  # of each property: beyond these quantiles the model is held where it is
_MOST_EXPONENT = 15.0


def expected_energies(
    properties: np.ndarray, energies: np.ndarray, weights: np.ndarray, wanted: np.ndarray
) -> np.ndarray:
    """What is expected of cells with the properties ``wanted``, (m, p), from others, (n, p), and their energies.

    ``energies`` and ``weights``: (n,). Returns (m,), all positive.
    """
    own, asked = properties.astype(np.float64), wanted.astype(np.float64)
    low, high = np.quantile(own, _OUTERMOST, axis=0)
    own, asked = np.clip(own, low, high), np.clip(asked, low, high)
    middle, spread = own.mean(axis=0), np.maximum(own.std(axis=0), 1e-9)
    level = max(float(np.average(energies, weights=weights)), 1e-12)
    coefficients = _fitted(_terms((own - middle) / spread), energies / level, weights)
    return np.asarray(level * np.exp(_bounded(_terms((asked - middle) / spread) @ coefficients)))


def capped_means(values: np.ndarray, weights: np.ndarray, groups: np.ndarray) -> np.ndarray:
    """The mean of each group, with none counted as more than ``CAP`` times the mean; 0 for an empty one."""
    count = int(groups.max()) + 1 if len(groups) else 0
    total = np.bincount(groups, weights, count)
    total = np.where(total > 0, total, 1)
    mean = np.bincount(groups, weights * values, count) / total
    for _ in range(_ROUNDS):
        mean = np.bincount(groups, weights * np.minimum(values, CAP * mean[groups]), count) / total
    return mean


def _terms(properties: np.ndarray) -> np.ndarray:
    """1, the properties and their products, (n, terms)."""
    first, second = np.triu_indices(properties.shape[1])
    return np.column_stack([np.ones(len(properties)), properties, properties[:, first] * properties[:, second]])


def _fitted(terms: np.ndarray, values: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Coefficients of the logarithm of what is expected; ratios above ``CAP`` count as that."""
    weighted = terms.T * weights
    normal = weighted @ terms
    ridge = np.full(len(normal), _RIDGE * np.trace(normal) / len(normal))
    ridge[0] = 0
    inverse = np.linalg.inv(normal + np.diag(ridge))
    exponent = np.zeros(len(values))
    coefficients = np.zeros(len(normal))
    for _ in range(_ROUNDS):
        working = np.minimum(values * np.exp(-exponent), CAP) - 1 + exponent
        coefficients = inverse @ (weighted @ working)
        exponent = _bounded(terms @ coefficients)
    return np.asarray(coefficients)


def _bounded(exponents: np.ndarray) -> np.ndarray:
    return np.clip(exponents, -_MOST_EXPONENT, _MOST_EXPONENT)
