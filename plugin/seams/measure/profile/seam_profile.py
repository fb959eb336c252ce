"""What a mosaic keeps of its sources' detail along a seam: the profile, as it is shown and judged."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from .cell_table import EDGES_PX, MIXED_BINS

STRIP_PX = 8
"""Width on either side of the seam that kept_1 is of; twice and four times that at levels 2 and 3."""
UNMIXED_SHARE = 0.1
"""A feather's width is taken from this share of either source to the other: less is what noise makes."""
WIDEST_FEATHER_PX = 2 * EDGES_PX[MIXED_BINS] / (1 - 2 * UNMIXED_SHARE)
"""Full width of a feather that does not end where one is looked for."""
BAND_KEPT = 0.9
"""The band along a seam is where less than this is kept."""
MIN_APART = 0.2  # honest pairs have 0.6 or more; 0.05 where both hold the mosaic's pixels, with noise of 1.2 DN on them
MIN_STRIP_PX = 1000  # pixels of a strip
LEAST_SEAM_PX = MIN_STRIP_PX / (2 * STRIP_PX)  # with a strip that is just large enough to be measured


class Measure(str, Enum):
    """What kept was taken by."""

    BOTH = "both"
    """Energy and mixture agree."""
    ENERGY = "energy"
    """The mosaic has less detail along the seam than the mixture of its sources would leave, or there is none."""
    MIXTURE = "mixture"
    """The mixture alone: there is too little ground to compare energies with, or other detail came along the seam."""

    @classmethod
    def of(cls, share: float) -> Measure:
        """The measure by how much of what judged is the energy, 0 to 1."""
        return cls.MIXTURE if share <= 0 else cls.ENERGY if share >= 1 else cls.BOTH


@dataclass(frozen=True)
class ProfileBin:
    """One level at one distance from the seam."""

    level: int
    """1 is the finest."""
    near_px: float
    """Its begin, pixels of the mosaic from the seam."""
    far_px: float
    """Infinite in the last bin."""
    kept: float
    """Share of the sources' detail variance, relative to the ground around."""
    low: float
    """Lower end of its 95 % interval."""
    high: float
    """Upper end."""
    gain: float
    """Amplitude of the detail that is the sources' own, relative to the ground around: what was added in the band does
    not count."""
    area_px: float
    """How many pixels lie in it."""
    mixture: float | None = None
    """Share of the source beyond the seam, the mean of both sides; None where it was not looked for."""

    @property
    def middle_px(self) -> float:
        """Middle of the bin, pixels from the seam; where it begins for the last one, which has no end."""
        return self.near_px if np.isinf(self.far_px) else (self.near_px + self.far_px) / 2


@dataclass(frozen=True)
class SeamProfile:
    """What a window, or a piece of seam, kept along its seams."""

    kept: tuple[float | None, ...]
    """Shares kept in the strip beside the seam, levels 1..R; None where there is too little to be measured."""
    low: float
    """Lower end of the 95 % interval of kept_1."""
    high: float
    """Upper end."""
    band_width_px: float
    """Full width of the band in which less than 0.9 is kept; 0 where there is none."""
    added_beside: float
    """Share of the detail in the strip that is not the sources', beyond what there is of such around."""
    bins: tuple[ProfileBin, ...]
    """Bins by level, then by distance from the seam."""
    feather_width_px: float | None = None
    """Full width of the feather, as of a linear one that goes as far from a mixture of 10 to one of 90 %, 320 px at
    most; 0 for a cut, None where it was not looked for."""
    measure: Measure = Measure.BOTH
    """What ``kept`` was taken by."""
    by_energy: float | None = None
    """kept_1 by the energy against the ground around; None without ground."""
    by_mixture: float | None = None
    """kept_1 of the mixture of sources; None where there is none to be told."""
    left_by_mixture: float = 0.0
    """Share of the sources' energy in the strip that no mixture explains, beyond what the ground leaves over."""
    lost: float = 0.0
    """Energy of the finest detail that the seams took, DN squared: over all distances."""
    energy: tuple[float, ...] = ()
    """Energy of the sources' detail in the strip, a pixel, DN squared, levels 1..R: what there is to be lost."""
    apart: float = 1.0
    """What the two sources' finest detail differs by in the strip, as a share of what it does farther off."""

    @property
    def is_between_copies(self) -> bool:
        """Whether both sources are the same along the seam alone, though no two exposures have the same noise: what
        the seam lost may be lost in them as well."""
        return self.apart < MIN_APART

    @property
    def is_of_the_ground(self) -> bool:
        """Whether ``kept`` is a share of what the ground around has, and no mixture took part in it."""
        return self.measure is Measure.ENERGY


def strip_bins(level: int) -> slice:
    """Bins of the strip beside the seam."""
    return slice(0, EDGES_PX.index(STRIP_PX * 2**level) if STRIP_PX * 2**level in EDGES_PX else len(EDGES_PX) - 1)


def in_strip(sums: np.ndarray) -> np.ndarray:
    """Sums over the strip, (levels, count), of those by bins, (levels, bins, count)."""
    return np.stack([by_bin[strip_bins(level)].sum(axis=0) for level, by_bin in enumerate(sums)])


def band_width_px(bins: Sequence[ProfileBin]) -> float:
    """Twice the distance at which BAND_KEPT is reached, linear between the middles of the bins, which have ends."""
    last: tuple[float, float] | None = None
    for profile_bin in bins:
        middle = profile_bin.middle_px
        if profile_bin.kept >= BAND_KEPT and middle > STRIP_PX / 2:
            if last is None:
                return 0.0
            share = (BAND_KEPT - last[1]) / (profile_bin.kept - last[1])
            return 2 * (last[0] + share * (middle - last[0]))
        if profile_bin.kept < BAND_KEPT:
            last = middle, profile_bin.kept
    return 0.0 if last is None else 2 * last[0]
