"""How much detail a mosaic truly kept beside its seam, by what it was made of and by PyWavelets."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .detail import detail_energy, details, luminance_of
from .seam_makings import Mixed

BIN_PX = 8
FARTHEST_PX = 64
REACH_PX = 32
"""Farther than the wavelets look."""
MIN_PIXELS = 256
"""Fewest pixels of a bin."""


@dataclass(frozen=True)
class TrueProfile:
    """The share of the detail energy that is left, by distance from the seam."""

    kept: tuple[float, ...]
    """In bins of ``BIN_PX`` from the seam on; nan where there is too little of one."""

    @property
    def near(self) -> float:
        """In the first bin."""
        return self.kept[0]


def truth_kept(
    hard: np.ndarray, made: np.ndarray, distance_px: np.ndarray, level: int, wavelet: str,
    where: tuple[slice, slice] = (slice(None), slice(None)),
) -> TrueProfile:
    """The energies of two planes, (rows, columns), by distance; ``where`` narrows what is looked at.

    The transform is the undecimated one, so it makes no difference where on the grid of the decimated one a seam lies.
    """
    energies = [detail_energy(plane, level, wavelet)[where] for plane in (hard, made)]
    bins = (distance_px[where] / BIN_PX).astype(np.intp).clip(max=FARTHEST_PX // BIN_PX).ravel()
    count = FARTHEST_PX // BIN_PX + 1
    of_hard, of_made = (np.bincount(bins, energy.ravel(), count) for energy in energies)
    enough = (np.bincount(bins, minlength=count) >= MIN_PIXELS) & (of_hard > 0)
    kept = np.divide(of_made, of_hard, out=np.full(count, np.nan), where=enough)
    return TrueProfile(tuple(kept[:-1].tolist()))


@dataclass(frozen=True)
class Truth:
    """What a mosaic kept before anything came over the whole of it; nan where that can't be told."""

    near: float
    """Share kept of the finest detail energy in the ``BIN_PX`` beside the seam."""
    taken: float
    """The share of it that mixing took from the whole window."""


def truth_of(mixed: Mixed, distance_px: np.ndarray, where: tuple[slice, slice], wavelet: str = "coif3") -> Truth:
    """Truth by what the mosaic was made of.

    The sum over its parts of weight x detail, squared, over the square of the detail of the source on whose side each
    pixel lies. A hard cut keeps 1 whatever it joins: the edge of the cut itself is nobody's detail.
    """
    around = tuple(slice(max(one.start - REACH_PX, 0), one.stop + REACH_PX) for one in where)
    inside = np.zeros(distance_px.shape, bool)
    inside[where] = True
    near, inside = (inside & (distance_px <= BIN_PX))[around], inside[around]
    labels = mixed.labels[around]
    made = sum(part.weight[around] * details(part.plane[around], 1, wavelet) for part in mixed.parts)
    followed = sum(
        (labels == number) * details(plane[around], 1, wavelet) for number, plane in enumerate(mixed.planes)
    )
    energies = [np.square(one).sum(axis=0) for one in (made, followed)]
    kept = [_ratio(*(energy[pixels].sum() for energy in energies)) for pixels in (near, inside)]
    return Truth(kept[0] if near.sum() >= MIN_PIXELS else np.nan, 1 - kept[1])


def taken_by_change(before: np.ndarray, after: np.ndarray, where: tuple[slice, slice]) -> float:
    """The share of the finest detail energy that did not come over: 1 less the gain, squared."""
    fine = [details(luminance_of(bands[(slice(None), *where)]), 1, "coif3") for bands in (before, after)]
    return 1 - float((fine[0] * fine[1]).sum() / np.square(fine[0]).sum()) ** 2


def _ratio(made: float, of_sources: float) -> float:
    return float(made / of_sources) if of_sources > 0 else np.nan
