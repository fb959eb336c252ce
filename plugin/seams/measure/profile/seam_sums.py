"""What is kept along seams: the one estimator, for the seam of a window as for every piece of a mosaic's.

By energy against the ground around (``energy_sums``) and by the mixture of the sources that meet (``mixture``), which
needs no ground, and does not see what else was done along the seam. For two textures that have nothing in common a
50:50 blend keeps 0.5.
"""
from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from dataclasses import dataclass

import numpy as np

from .cell_table import EDGES_PX, MIXED_BINS, CellTable, MixtureTable
from .energy_sums import SURE_LEFT, EnergySums
from .ground import LevelGround
from .intervals import MIN_CARRIED, MOST_KEPT_LOW, MOST_UNEXPLAINED, Kept, together, weighted
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
        energy, mixed = copy(self._energy), self._mixture.result()
        mm = in_strip(energy.mosaic_energy)[0]  # with all that was added
        more_left = energy.take_out(mixed.edge, mixed.left_over, mixed.soft_left_over, mixed.rounded)
        by_energy, energy_levels = energy.kept()
        # Where a mixture is told and does not end, the ground around is mixed as well.
        is_endless = (mixed.shares()[MIXED_BINS - 1] >= MOST_EVERYWHERE) & (mixed.kept.low <= MOST_KEPT_LOW)
        # Of the sources before anything came over the mosaic, which may have left what they agree in.
        by_energy = by_energy.times(np.where(is_endless, np.nan, mixed.before_in_strip[0]))
        area, plain, by_ground = map(in_strip, (energy.area, energy.plain, energy.left_by_ground))
        shared, expected, expected_shared = (
            in_strip(sums)[0] for sums in (energy.shared, energy.expected, energy.expected_shared)
        )
        # What the mosaic would have of the sources, by the ground where there is any.
        whole = np.maximum(np.where(expected > 0, expected, in_strip(mixed.plain)[0]), 1e-12)
        # As much as the ground has of it, where there is ground.
        is_mixed = mixed.carried * plain[0] >= MIN_CARRIED * expected_shared
        is_replaced = ~is_mixed & (more_left[0] > MOST_UNEXPLAINED * expected)
        # Of other ground than the sources' nobody knows what energy it had.
        foreign = np.maximum(more_left - by_ground, 0)[0] / whole
        by_energy = by_energy.times(np.where(is_replaced, np.nan, 1.0)).less_sure(foreign)
        judged, share = together(by_energy, mixed.kept.times(np.where(is_mixed, 1.0, np.nan)))
        # Codecs leave over up to twice as much from place to place, noise along a seam much more than on the ground.
        unsure = SURE_LEFT * np.minimum(more_left, by_ground)[0] / whole
        judged = judged.less_sure(unsure * (1 - share))  # of the mixture's part in it
        kept = np.where(share > 0, energy_levels * mixed.before_in_strip, mixed.levels)
        kept[0] = judged.value
        gain, amplitude = shared / np.maximum(expected_shared, 1e-12), mm / np.maximum(expected, 1e-12)
        by_bins = [
            energy.by_bins(level).times(mixed.before[level])
            for level in range(self._levels if levels is None else levels)
        ]
        bins = self._bins(mixed, share, judged, by_bins)
        added = np.where(amplitude > 0, np.maximum(1 - gain**2 / np.maximum(amplitude, 1e-12), 0), 0)
        lost = self._lost(mixed, share, by_bins[0])
        fit = np.maximum(shared, 0) ** 2 / np.maximum(mm * plain[0], 1e-12)
        texture = mm / np.maximum(plain[0], 1e-12)
        strips = []
        for number in range(self._count):
            profile = None
            if area[0, number] >= MIN_STRIP_PX and not np.isnan(judged.value[number]):
                own_bins = tuple(known_bin for row in bins if (known_bin := row[number]) is not None)
                finest = [each for each in own_bins if each.level == 1 and not np.isinf(each.far_px)]
                profile = SeamProfile(
                    kept=tuple(map(_known, kept[:, number])),
                    low=float(judged.low[number]),
                    high=float(judged.high[number]),
                    band_width_px=band_width_px(finest) if kept[0, number] < BAND_KEPT else 0.0,
                    added_beside=float(added[number]),
                    bins=own_bins,
                    feather_width_px=_known(mixed.feather_widths_px[number]),
                    measure=Measure.of(float(share[number])),
                    by_energy=_known(by_energy.value[number]),
                    by_mixture=_known(mixed.kept.value[number]),
                    left_by_mixture=float(more_left[0, number] / whole[number]),
                    lost=float(lost[number]),
                    energy=tuple((plain / np.maximum(area, 1))[:, number].tolist()),
                    apart=float(mixed.apart[number]),
                )
            strips.append(StripProfile(profile, float(area[0, number]), float(fit[number]), float(texture[number])))
        return strips

    def _bins(
        self, mixed: MixedStrips, share: np.ndarray, judged: Kept, by_bins: Sequence[Kept]
    ) -> list[list[ProfileBin | None]]:
        """Bins of every piece, by level and distance, None where there is nothing."""
        energy, ends, bins = self._energy, [*zip(EDGES_PX, (*EDGES_PX[1:], np.inf))], []
        for level, by_energy in enumerate(by_bins):
            area, mixture = energy.area[level], mixed.bins[level]
            # As kept itself is taken; there is energy alone beyond where a mixture is looked for.
            alone = (share > 0) & (np.isnan(mixture) | (level > 0))
            kept, low, high = (
                weighted(np.where(alone, 1.0, share), by_way, factor * mixture) for factor, by_way in (
                    (1, by_energy.value), (judged.low / judged.value, by_energy.low),
                    (judged.high / judged.value, by_energy.high),
                )
            )
            gain = energy.shared[level] / np.maximum(energy.expected_shared[level], 1e-12)
            columns = (kept, low, high, gain, area, np.full(area.shape, np.nan) if level else mixed.shares())
            for place, numbers in enumerate(zip(*(column.tolist() for column in columns))):
                bins.append([
                    None if np.isnan(share_kept) or not pixels else
                    ProfileBin(level + 1, *ends[place], share_kept, bottom, top, beside, pixels, _known(other))
                    for share_kept, bottom, top, beside, pixels, other in zip(*numbers)
                ])
        return bins

    def _lost(self, mixed: MixedStrips, share: np.ndarray, by_energy: Kept) -> np.ndarray:
        """Energy of the finest detail that the seams took, DN squared of the sources, (count,)."""
        last, plain = MIXED_BINS - 1, self._energy.plain[0]
        mixture = np.nan_to_num(mixed.bins[0], nan=1.0)
        by_mixture = (mixed.plain[0] * (1 - mixture)).sum(axis=0)
        # A mixture that does not end where it is looked for goes on beyond.
        is_endless = mixed.shares()[last] >= UNMIXED_SHARE
        by_mixture += plain[MIXED_BINS:].sum(axis=0) * np.where(is_endless, 1 - mixture[last], 0)
        kept = np.nan_to_num(by_energy.value[:MIXED_BINS], nan=1.0)
        within = np.logical_and.accumulate(kept < BAND_KEPT, axis=0)
        by_energy = np.where(within, plain[:MIXED_BINS] * (1 - kept), 0).sum(axis=0)
        return np.asarray(np.where(share > 0, np.maximum(by_energy, by_mixture), by_mixture))


def _known(value: float) -> float | None:
    return None if np.isnan(value) else float(value)
