"""What is kept along seams: the one estimator, for the seam of a window as for every piece of a mosaic's.

By energy against the ground around (``energy_sums``) and by the mixture of the sources that meet (``mixture``), which
needs no ground, and does not see what else was done along the seam. For two textures that have nothing in common a
50:50 blend keeps 0.5.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .cell_table import EDGES_PX, MIXED_BINS, CellTable, MixtureTable
from .energy_sums import EnergySums
from .ground import LevelGround
from .intervals import MIN_CARRIED, MOST_KEPT, MOST_UNEXPLAINED, Kept, together, weighted
from .mixture import MOST_EVERYWHERE, MixedStrips, MixtureSums
from .seam_profile import (
    BAND_KEPT,
    MIN_STRIP_PX,
    UNMIXED_SHARE,
    Measure,
    ProfileBin,
    SeamProfile,
    band_width_px,
    in_strip,
)


@dataclass(frozen=True, eq=False)
class StripProfile:
    """One piece of seam as it was measured."""

    profile: SeamProfile | None
    """None where there is too little to be measured."""
    area_px: float
    """Area of the strip, level 1, px."""
    fit: float
    """Share of the mosaic's finest detail in the strip that its sources explain."""
    texture: float
    """That detail's energy as a share of its sources'."""


class SeamSums:
    """Adds up the cells beside the seams of ``count`` pieces; then tells every piece."""

    def __init__(self, count: int, levels: int) -> None:
        self._count, self._levels = count, levels
        self._energy, self._mixture = EnergySums(count, levels), MixtureSums(count, levels)

    def add(
        self, table: CellTable, mixture: MixtureTable, ground: Sequence[LevelGround | None], piece: np.ndarray
    ) -> None:
        """Some cells; ``piece`` (rows of the table,): the one that each belongs to, or -1; all parts of a cell, unless
        that is -1, to the same. Numbers of sources in ``mixture`` must mean the same every time."""
        self._energy.add(table, ground, piece)
        of_cell, known = np.full(len(table.whole), -1), piece >= 0
        of_cell[table.cell[known]] = piece[known]
        self._mixture.add(mixture, of_cell[np.searchsorted(table.whole.keys, mixture.keys)])

    def profiles(self, levels: int | None = None) -> list[StripProfile]:
        """Profiles of all pieces, in their order; with the bins of so many ``levels``, one at least, all where None."""
        energy, mixed = self._energy, self._mixture.result()
        # Beyond what the ground leaves over as well.
        left_over = in_strip(mixed.left)
        more_left = np.maximum(left_over - in_strip(energy.left_by_ground), 0)
        mm = in_strip(energy.own)  # with all that was added
        energy.take_out(mixed.edge, mixed.soft_left * (more_left / np.maximum(left_over, 1e-12))[:, np.newaxis])
        by_energy, energy_levels = energy.kept()
        # Of the sources before anything came over the mosaic, which may have left what they agree in.
        by_energy = by_energy.times(np.nan_to_num(mixed.before_in_strip[0], nan=1.0))
        energy_levels *= np.nan_to_num(mixed.before_in_strip, nan=1.0)
        # Where a mixture is told and does not end, the ground around is mixed as well.
        is_endless = (mixed.shares()[-1] >= MOST_EVERYWHERE) & (mixed.kept.low <= MOST_KEPT)
        by_energy = by_energy.times(np.where(is_endless, np.nan, 1.0))
        left_share = more_left[0] / np.maximum(in_strip(mixed.plain)[0], 1e-12)
        area, plain, shared = map(in_strip, (energy.area, energy.plain, energy.shared))
        expected, expected_shared = in_strip(energy.expected)[0], in_strip(energy.expected_shared)[0]
        # As much as the ground has of it, where there is ground.
        is_mixed = mixed.carried * plain[0] >= MIN_CARRIED * expected_shared
        is_replaced = ~is_mixed & (more_left[0] > MOST_UNEXPLAINED * expected)
        is_told, is_mixture = (np.where(which, 1.0, np.nan) for which in (~is_replaced, is_mixed))
        judged, share = together(by_energy.times(is_told), mixed.kept.times(is_mixture))
        kept = np.where(share > 0, energy_levels, mixed.levels)
        kept[0] = judged.value
        fit = np.maximum(shared[0], 0) ** 2 / np.maximum(mm[0] * plain[0], 1e-12)
        texture = mm[0] / np.maximum(plain[0], 1e-12)
        gain, before = (a / np.maximum(b, 1e-12) for a, b in ((shared[0], expected_shared), (mm[0], expected)))
        added = np.where(before > 0, np.maximum(1 - gain**2 / np.maximum(before, 1e-12), 0), 0)
        width = mixed.feather_widths_px
        by_bins = [energy.by_bins(level) for level in range(self._levels if levels is None else levels)]
        bins = self._bins(mixed, share, judged, by_bins)
        lost = self._lost(mixed, share, by_bins[0])
        strips = []
        for number in range(self._count):
            profile = None
            if area[0, number] >= MIN_STRIP_PX and not np.isnan(judged.value[number]):
                own_bins = tuple(known for one in bins if (known := one[number]) is not None)
                finest = [one for one in own_bins if one.level == 1 and not np.isinf(one.far_px)]
                profile = SeamProfile(
                    tuple(map(_known, kept[:, number])), float(judged.low[number]), float(judged.high[number]),
                    band_width_px(finest) if kept[0, number] < BAND_KEPT else 0.0, float(added[number]), own_bins,
                    _known(width[number]), Measure.of(float(share[number])),
                    _known(by_energy.value[number]), _known(mixed.kept.value[number]), float(left_share[number]),
                    float(lost[number]),
                    tuple((plain / np.maximum(area, 1))[:, number].tolist()),
                )
            strips.append(StripProfile(profile, float(area[0, number]), float(fit[number]), float(texture[number])))
        return strips

    def _bins(
        self, mixed: MixedStrips, share: np.ndarray, judged: Kept, by_bins: Sequence[Kept]
    ) -> list[list[ProfileBin | None]]:
        """Bins of every piece, by level and distance, None where there is nothing."""
        energy, ends = self._energy, [*zip(EDGES_PX, (*EDGES_PX[1:], np.inf))]
        shares = np.full((len(EDGES_PX), self._count), np.nan)
        shares[:MIXED_BINS] = mixed.shares()
        bins = []
        for level, by_energy in enumerate(by_bins):
            area = energy.area[level]
            before, mixture = np.full((2, *area.shape), np.nan)
            before[:MIXED_BINS], mixture[:MIXED_BINS] = mixed.before[level], mixed.bins[level]
            ways = by_energy.times(np.nan_to_num(before, nan=1.0))
            # As kept itself is taken; there is energy alone beyond where a mixture is looked for.
            of_energy = np.where(share > 0, 1.0, 0.0) if level else np.where(
                np.isnan(mixture) & (share > 0), 1.0, share
            )
            kept, low, high = (
                weighted(of_energy, one, factor * mixture) for factor, one in
                ((1, ways.value), (judged.low / judged.value, ways.low), (judged.high / judged.value, ways.high))
            )
            gain = energy.shared[level] / np.maximum(energy.expected_shared[level], 1e-12)
            columns = (kept, low, high, gain, area, shares if not level else np.full(area.shape, np.nan))
            for place, numbers in enumerate(zip(*(column.tolist() for column in columns))):
                bins.append([
                    None if number != number or not pixels else
                    ProfileBin(level + 1, *ends[place], number, bottom, top, beside, pixels, _known(other))
                    for number, bottom, top, beside, pixels, other in zip(*numbers)
                ])
        return bins

    def _lost(self, mixed: MixedStrips, share: np.ndarray, by_energy: Kept) -> np.ndarray:
        """Energy of the finest detail that the seams took, DN squared of the sources, (count,)."""
        energy = self._energy
        mixture = np.nan_to_num(mixed.bins[0], nan=1.0)
        by_mixture = (mixed.plain[0] * (1 - mixture)).sum(axis=0)
        # A mixture that does not end where it is looked for goes on beyond.
        shares, farther = mixed.shares()[-1], energy.plain[0, MIXED_BINS:].sum(axis=0)
        by_mixture += farther * np.where(shares >= UNMIXED_SHARE, 1 - mixture[-1], 0)
        kept = np.nan_to_num(by_energy.value[:MIXED_BINS] * np.nan_to_num(mixed.before[0], nan=1.0), nan=1.0)
        source = energy.plain[0, :MIXED_BINS]
        within = np.logical_and.accumulate(kept < BAND_KEPT, axis=0)
        by_energy = np.where(within, source * (1 - kept), 0).sum(axis=0)
        return np.asarray(np.where(share > 0, np.maximum(by_energy, by_mixture), by_mixture))


def _known(value: float) -> float | None:
    return None if np.isnan(value) else float(value)
