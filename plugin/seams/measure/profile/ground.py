"""What the ground far from any seam makes one expect of the ground beside it."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .energy_response import EnergyResponse, fit_response


@dataclass(frozen=True, eq=False)
class GroundResponse:
    """What became of detail far from seams, by its energy, and how much that scatters."""

    amplitude: EnergyResponse
    """Energy of the mosaic's detail over that of the composite's."""
    gain: EnergyResponse
    """Their inner product over the energy of the composite's."""
    scatter: float
    """Standard deviation of log kept between blocks of 32 px."""
    blocks: float
    """How many such blocks, all of one weight, the ground is as good as."""


def ground_response(
    energy: np.ndarray, own: np.ndarray, shared: np.ndarray, block_own: np.ndarray, block_energy: np.ndarray,
    block_of: np.ndarray,
) -> GroundResponse:
    """From cells (n,) far from any seam: energy a pixel of the composite's and the mosaic's detail and their inner
    product a pixel; and of the same cells their sums mm and cc, with the number of the block each lies in, below 0
    where it takes no part in the scatter."""
    amplitude = fit_response(energy, own)
    gain = fit_response(energy, np.maximum(shared, 0))
    chosen = block_of >= 0
    sums = (block_own[chosen], (block_energy * amplitude(energy))[chosen])
    block_own, expected = (np.bincount(block_of[chosen], values) for values in sums)
    return GroundResponse(amplitude, gain, *scatter_of_blocks(block_own, expected))


def scatter_of_blocks(own: np.ndarray, expected: np.ndarray) -> tuple[float, float]:
    """Standard deviation of the logarithm of own / expected between blocks, and how many blocks of one weight these
    are as good as."""
    known = expected > 0
    if np.count_nonzero(known) < 2:
        return 1.0, 1.0
    weights = expected[known]
    ratios = own[known] / weights
    mean = float((weights * ratios).sum() / weights.sum())
    count = float(weights.sum() ** 2 / (weights**2).sum())
    variance = float((weights * (ratios - mean) ** 2).sum() / weights.sum()) * count / max(count - 1, 1)
    return float(np.sqrt(variance)) / max(mean, 1e-6), count
