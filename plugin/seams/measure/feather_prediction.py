"""What a feather between two sources would leave of their detail, known before any mosaic exists.

A 50:50 blend of two images has the detail variance (1 + rho) / 2 of their mean, with rho = 2 cov / (v_a + v_b) of
their detail coefficients: images that do not fit, or whose noise differs, cancel each other.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from ...imagery import limits as imagery_limits
from ...imagery.wavelets import component_products


@dataclass(frozen=True)
class Feather:
    """Two sources of one window, blended half and half."""

    first: int
    """Index of a source."""
    second: int
    rho: tuple[float | None, ...]
    """Agreement of their details, levels 1..R, 1 for equal images; None where neither has detail."""

    @property
    def ratios(self) -> tuple[float | None, ...]:
        """Detail variance that a 50:50 feather leaves of their mean, levels 1..R."""
        return tuple(None if rho is None else (1 + rho) / 2 for rho in self.rho)


def feathers(planes: Sequence[np.ndarray], wavelet: str, levels: int) -> list[Feather]:
    """Every pair of the sources' planes, (rows, columns) each, of one window."""
    pairs = list(combinations(range(len(planes)), 2))
    if not pairs:
        return []
    products = component_products(np.stack(planes), wavelet, levels, pairs)
    found = []
    for (i, j), shared in zip(pairs, products.cross):
        energy = products.own[i] + products.own[j]
        least = imagery_limits.MIN_SHARE * (products.own_totals[i] + products.own_totals[j])
        rho = tuple(2 * s / e if e > least else None for s, e in zip(shared[:-1].tolist(), energy[:-1].tolist()))
        found.append(Feather(i, j, rho))
    return found


def expected_ratios(found: Sequence[Feather], levels: int) -> tuple[float | None, ...]:
    """The smallest over the pairs, level by level: where feathering will hurt most."""
    return tuple(
        min((ratio for ratio in (feather.ratios[level] for feather in found) if ratio is not None), default=None)
        for level in range(levels)
    )
