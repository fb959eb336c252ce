"""What is kept of many strips by one measure, with its interval; and what two measures say together."""
from __future__ import annotations

from typing import NamedTuple

import numpy as np

from ....imagery.statistics import critical_t

CONFIDENCE = 0.95
MOST_UNEXPLAINED, MIN_CARRIED = 0.4, 0.75
"""Shares of the energy that the ground makes one expect in the strip, that no source explains, and of the sources'
detail, that is there: with less of the second the strip is no mixture of them, and with more of the first as well
something else is in its place, and nothing is told of what is kept. Codecs left up to 0.28 over in 348 windows of five
grounds; noise over half of a strip leaves 0.5 and 0.5; a brush of 2 px has 0.01 to 0.11. Other ground
painted over a strip would read 0.5 by energy and 0.7 by mixture."""

_WIDEST = 7.0  # of the logarithm, a factor of a thousand: nothing is known, and can still be reckoned with

MOST_KEPT_LOW = 1.05
"""No seam adds detail of its sources: energies that surely tell of more are not of the ground that they are compared
with."""
WIDEST = float(np.log(2))
"""Width of the logarithm's interval, end to end: a measure that says less is left out where there is another."""


class Kept(NamedTuple):
    """kept_1 of n strips, NaN where nothing can be told."""

    value: np.ndarray
    """(n,)"""
    low: np.ndarray
    """(n,): lower end of its 95 % interval."""
    high: np.ndarray
    """(n,)"""

    @classmethod
    def of(cls, value: np.ndarray, error: np.ndarray, freedom: np.ndarray) -> Kept:
        """kept with its interval, by the standard deviation of its logarithm and the degrees of freedom of that."""
        return cls._reaching(value, critical_t(CONFIDENCE, np.maximum(freedom, 1)) * error)

    @classmethod
    def _reaching(cls, value: np.ndarray, ends: np.ndarray) -> Kept:
        """kept with an interval whose logarithm reaches so far to either side."""
        factor = np.exp(np.minimum(ends, _WIDEST))
        return cls(value, value / factor, value * factor)

    def times(self, factor: np.ndarray) -> Kept:
        """kept so many times as much, with its interval."""
        return Kept(*(end * factor for end in self))

    def less_sure(self, error: np.ndarray) -> Kept:
        """kept with another error, a standard deviation of its logarithm, beside those that its interval has."""
        return Kept._reaching(self.value, np.hypot(self.width / 2, critical_t(CONFIDENCE, np.inf) * error))

    @property
    def width(self) -> np.ndarray:
        """Width of the logarithm's interval, (n,)."""
        return np.log(np.maximum(self.high, 1e-6) / np.maximum(self.low, 1e-6))


def together(energy: Kept, mixture: Kept) -> tuple[Kept, np.ndarray]:
    """What judges, and how much of it is the energy, (n,): 1 where it judges alone, 0 where the mixture does.

    They agree where their intervals meet; then their mean counts, weighted by their precision. Else the lower one does.
    """
    has_energy, has_mixture = ~np.isnan(energy.value), mixture.low <= MOST_KEPT_LOW  # never of NaN
    mixture = Kept(*(np.where(has_mixture, end, np.nan) for end in mixture))
    meet = (energy.low <= mixture.high) & (mixture.low <= energy.high)
    has_energy &= ~has_mixture | (energy.low <= MOST_KEPT_LOW) & ((energy.width <= WIDEST) | ~meet)
    both = has_energy & has_mixture
    agree = both & meet
    by_mixture = has_mixture & ~has_energy | both & ~agree & (mixture.value < energy.value)
    precise, other = (1 / np.maximum(kept.width, 1e-3) ** 2 for kept in (energy, mixture))
    share = np.where(agree, precise / (precise + other), np.where(by_mixture, 0.0, 1.0))
    return Kept(*(weighted(share, *ends) for ends in zip(energy, mixture))), share


def weighted(share: np.ndarray, first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """The geometric mean of two, of which ``share`` is the first's; the one alone that has all of it."""
    with np.errstate(invalid="ignore"):
        mean = np.maximum(first, 1e-6) ** share * np.maximum(second, 1e-6) ** (1 - share)
    return np.asarray(np.where(share >= 1, first, np.where(share <= 0, second, mean)))
