"""The rule of which source a mosaic follows, by sums of products of fine detail over the same ground.

Windows ask it of squares of a few pixels, the scan of its patches: own = sum m m, energy = sum s s, shared = sum m s,
common = sum s1 s2 of high-passed planes, the mosaic's m and the sources' s, arrays of one shape.
"""
from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import combinations

import numpy as np

MIN_WINNER_LEAD = 0.1  # of the correlation over the next source's
MIN_LEFT_FACTOR = 2.0  # or that the next leaves this many times as much unexplained: images of one scene are alike
MIN_MIXTURE_FIT = 0.9  # share of the mosaic's fine detail that a mixture of two explains; a hard cut stays below
MIN_MIXTURE_GAIN = 0.05  # by which the mixture has to explain more than the better source alone
MIN_MIXTURE_WEIGHT = 0.1  # of each of the two sources
LEAST_ENERGY = 1e-2  # DN squared a pixel, below what rounding to whole values leaves


def local_correlation(own: np.ndarray, energy: np.ndarray, shared: np.ndarray) -> np.ndarray:
    """Of the mosaic with a source; energies above zero."""
    return np.asarray(shared / np.sqrt(own * energy))


def highest(values: Sequence[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Index of the highest of several arrays, and its lead over the next; of one alone the value itself."""
    first, *others = values
    found, second = np.zeros(first.shape, np.intp), np.zeros_like(first) if not others else np.full_like(first, -np.inf)
    for number, other in enumerate(others, 1):
        np.copyto(found, number, where=other > first)
        second = np.maximum(second, np.minimum(first, other))
        first = np.maximum(first, other)
    return found, first - second


def is_sure(correlation: np.ndarray, lead: np.ndarray) -> np.ndarray:
    """Whether the source of highest correlation is followed for sure."""
    left, next_left = 1 - np.maximum(correlation, 0) ** 2, 1 - np.maximum(correlation - lead, 0) ** 2
    return np.asarray((lead >= MIN_WINNER_LEAD) | (next_left >= MIN_LEFT_FACTOR * left))


def mixtures(
    own: np.ndarray, energies: Mapping[int, np.ndarray], shared: Mapping[int, np.ndarray],
    common: Callable[[int, int], np.ndarray],
) -> tuple[np.ndarray, np.ndarray]:
    """Where two sources together explain the mosaic and neither does alone, and the share that two explain.

    Least squares for the weights of every two, both of which have to take part; energies above zero.
    """
    alone, explained = np.zeros_like(own), np.zeros_like(own)
    for i in energies:
        np.maximum(alone, np.maximum(shared[i], 0) ** 2 / (own * energies[i]), out=alone)
    for i, j in combinations(energies, 2):
        a, b = weights_of_two(energies[i], energies[j], shared[i], shared[j], common(i, j))
        takes_part = np.minimum(a, b) > MIN_MIXTURE_WEIGHT * (a + b)  # never where they add up to less than 0
        np.maximum(explained, np.where(takes_part, (a * shared[i] + b * shared[j]) / own, 0), out=explained)
    return (explained > MIN_MIXTURE_FIT) & (explained > alone + MIN_MIXTURE_GAIN), explained


def weights_of_two(
    energy_i: np.ndarray, energy_j: np.ndarray, shared_i: np.ndarray, shared_j: np.ndarray, common: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Weights with which two sources together come nearest to the mosaic, by least squares; energies above zero."""
    determinant = 1.001 * energy_i * energy_j - common**2
    return (
        (shared_i * energy_j - shared_j * common) / determinant, (shared_j * energy_i - shared_i * common) / determinant
    )
