"""kept by energy: what the mosaic has of its sources' detail along seams, relative to the ground around.

    sum over cells at distance d of (mm - the cut's own edge) = sum of kept_r(d) ss a0(kept_r(d) ss)^2

with a0^2 the share mm / ss that cells far from any seam have at their energy. It does not change with anything that was
done to the whole mosaic, since that was done to the ground around, too; and what a seam left is weaker detail, to which
noise adds more and of which compression takes more.
"""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .cell_table import CELL_PX, EDGES_PX, CellTable
from .ground import LevelGround
from .intervals import Kept
from .seam_profile import in_strip, strip_bins

LABEL_ERROR = 0.13
"""Relative error of one block: pixels beside a seam that are given to the wrong source. Of 113 mosaics in JPEG whose
borders were drawn up to 3 px off 80 % of the energies' intervals held the truth, without it 65 %."""
LEAST_ERROR = 0.025
"""Least relative error of kept, however long the seam: borders that are drawn where the mosaic fits best."""
TRIED = np.array([0.05, 0.2, 0.4, 0.7, 1.0, 1.3])
"""Values of kept that energies are worked out for; those between follow."""
LEAST_SLOPE = 0.2
"""Least slope of an energy over kept, both as logarithms: where noise hides more, nothing can be told."""
_ALL = int(np.flatnonzero(TRIED == 1)[0])
RESPONSE_ERROR = 0.5
"""Share of what it makes of the logarithm of kept that weaker detail is shown otherwise, taken as its error: where
tones were evened out place by place, strong and weak detail differ by where they are."""
SURE_LEFT = 0.5
"""Share of what a soft feather leaves over that is taken for what its ramp makes of what the sources differ by; and
its error: as well it may be detail of the sources that a codec changed, or that a part of the piece without a feather
kept. Of those mosaics 68 % of the energies' intervals held the truth without it. Share of what codecs leave over of any
mixture that is its error: of 114 windows with a codec on either side 96 % of all intervals held the truth, without it
94 %."""
ALONG = 0.4
"""What a codec changes along the sources where it rounds their mixture, as a share of what it makes beside them,
amplitudes. In feathers of 33 px with JPEG 75 and 90 on the same blocks on both sides the finest level's shares were off
by 0.4 to 0.6 of that, in 6 windows of three grounds."""
BLOCK_CELLS = 2
"""A side of the blocks whose scatter the interval follows from: as much ground as 64 px of strip."""


class EnergySums:
    """Adds up the cells of ``count`` pieces of seam."""

    def __init__(self, count: int, levels: int) -> None:
        self._count = count
        shape = levels, len(EDGES_PX), count
        self.area, self.plain, self.mosaic_energy, self.shared = np.zeros((4, *shape))
        """Pixels, ss, mm and mc, by level, bin and piece: the first two with ground or without."""
        self.expected_shared, self.left_by_ground = np.zeros((2, *shape))
        """mc that the ground makes one expect, and energy that sources leave over as they do there, DN squared."""
        self._by_kept = np.zeros((len(TRIED), *shape))
        self._squares = np.zeros(count)  # of what is expected of blocks of 32 px in the strip
        self._noise = np.zeros((3, count))  # scatter, blocks of ground, reach; each times what is expected
        self._unsure = np.zeros(count)  # share of the mosaic's finest detail in the strip

    def add(self, table: CellTable, ground: Sequence[LevelGround | None], piece: np.ndarray) -> None:
        """Some cells; ``piece`` (rows of the table,): the one that each belongs to, or -1."""
        in_pieces = np.flatnonzero(piece >= 0)
        if not len(in_pieces):
            return
        near, cells, piece = table.chosen(in_pieces), table.cell[in_pieces], piece[in_pieces]
        place = near.bin.astype(np.intp) * self._count + piece
        for level, level_ground in enumerate(ground):
            sums = [(self.area, near.area[level]), (self.plain, ss := near.cc[level])]
            if level_ground is not None:
                energy = table.whole.energy(level)[cells]
                amplitude, gain = level_ground.amplitude(energy), level_ground.gain(energy)
                sums += [(self.mosaic_energy, near.mm[level]), (self.shared, near.mc[level])]
                left_over = np.maximum(amplitude - gain**2, 0)
                sums += [(self.expected_shared, ss * gain), (self.left_by_ground, ss * left_over)]
                sums += [(total, kept * ss * level_ground.amplitude(kept * energy))
                         for total, kept in zip(self._by_kept, TRIED)]
                if not level:
                    self._add_noise(near, level_ground, ss * amplitude, piece)
            for total, values in sums:
                total[level] += np.bincount(place, values, total[level].size).reshape(total[level].shape)

    @property
    def expected(self) -> np.ndarray:
        """mm where all is kept, (levels, bins, count)."""
        return self._by_kept[_ALL]

    def kept(self) -> tuple[Kept, np.ndarray]:
        """kept_1 of every piece, and kept_r (levels, count), NaN where nothing can be told."""
        expected = np.stack([in_strip(energies) for energies in self._by_kept])
        mm = in_strip(self.mosaic_energy)
        return self._with_interval(mm[0], in_strip(self.area)[0], expected[:, 0]), _kept(mm, expected)

    def by_bins(self, level: int) -> Kept:
        """kept of one level, 0 the finest, at every distance, (bins, count)."""
        return self._with_interval(self.mosaic_energy[level], self.area[level], self._by_kept[:, level])

    def take_out(
        self, edge: np.ndarray, left_over: np.ndarray, soft_left_over: np.ndarray, rounded: np.ndarray
    ) -> np.ndarray:
        """Take out what no source has, energy by (levels, bins, count), DN squared: what the mosaic's detail has of the
        cut's own edge, what a codec makes of a mixture, and half of what else soft feathers leave over beyond what the
        ground does.

        Returns (levels, count): what any mixture leaves over in the strip beyond what the ground does."""
        all_left, mosaic = in_strip(left_over), np.maximum(in_strip(self.mosaic_energy)[0], 1e-12)
        more = np.maximum(all_left - in_strip(self.left_by_ground), 0)
        of_strip = (more / np.maximum(all_left, 1e-12))[:, np.newaxis]
        unsure = SURE_LEFT * np.maximum(soft_left_over * of_strip - rounded, 0)
        # (1 + ALONG r)^2 - 1, to first order, with r^2 the share of the energy that was rounded.
        by_codec = 2 * ALONG * np.sqrt(in_strip(rounded)[0] / mosaic)
        self._unsure = np.hypot(in_strip(unsure)[0] / mosaic, by_codec)
        self.mosaic_energy = self.mosaic_energy - edge - rounded - unsure
        return np.asarray(more)

    def _with_interval(self, mosaic_energy: np.ndarray, area_px: np.ndarray, by_kept: np.ndarray) -> Kept:
        """What is kept of areas, (..., count) each, by their energies and those ``by_kept``: as sure as the scatter of
        the ground around lets it be, and as what is kept shows in energies."""
        expected = np.maximum(in_strip(self.expected)[0], 1e-12)
        scatter, blocks, reach = self._noise / expected
        blocks, area_px = np.maximum(blocks, 1), np.maximum(area_px, 1)
        # Texture is uneven: blocks of one weight that a strip is as good as, by its area.
        density = expected**2 / np.maximum(self._squares, 1e-12) / np.maximum(in_strip(self.area)[0], 1)
        own_blocks = np.maximum(density * area_px, 1)
        error = np.sqrt(
            scatter * (1 / own_blocks + 1 / blocks) + LABEL_ERROR**2 * (BLOCK_CELLS * CELL_PX) ** 2 / area_px
            + reach + LEAST_ERROR**2 + self._unsure**2
        )
        kept = _kept(mosaic_energy, by_kept)
        with np.errstate(divide="ignore", invalid="ignore"):
            by_response = np.nan_to_num(np.log(kept * by_kept[_ALL] / mosaic_energy), nan=0.0, posinf=0.0, neginf=0.0)
        error = np.hypot(error / np.maximum(_slope(kept, by_kept), 1e-6), RESPONSE_ERROR * by_response)
        return Kept.of(kept, error, np.broadcast_to(blocks - 1, error.shape))

    def _add_noise(self, near: CellTable, ground: LevelGround, expected: np.ndarray, piece: np.ndarray) -> None:
        """What the interval follows from, by what is expected of cells that belong to pieces, (n,)."""
        strip = near.bin < strip_bins(0).stop
        piece, expected = piece[strip], expected[strip]
        rows, columns = (place[strip].astype(np.int64) // BLOCK_CELLS for place in (near.row, near.column))
        keys, block = np.unique((piece.astype(np.int64) << 40) + (rows << 20) + columns, return_inverse=True)
        self._squares += np.bincount(keys >> 40, np.bincount(block, expected) ** 2, self._count)
        weight = np.bincount(piece, expected, self._count)
        self._noise += weight * np.array((ground.scatter**2, ground.blocks, ground.reach**2))[:, np.newaxis]


def _kept(mosaic_energy: np.ndarray, by_kept: np.ndarray) -> np.ndarray:
    """The share of which such an energy is left, (...), NaN where nothing is expected; ``by_kept`` (TRIED, ...)."""
    tried = np.append(0, TRIED)
    rising = np.maximum.accumulate(np.concatenate([np.zeros_like(by_kept[:1]), by_kept]))
    at = np.clip((rising < mosaic_energy).sum(axis=0), 1, len(TRIED))
    below, above = np.take_along_axis(rising, np.stack([at - 1, at]), 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        part = (np.maximum(mosaic_energy, 0) - below) / (above - below)
    return np.where(by_kept[_ALL] > 0, tried[at - 1] + part * (tried[at] - tried[at - 1]), np.nan)


def _slope(kept: np.ndarray, by_kept: np.ndarray) -> np.ndarray:
    """Change of an energy with what is kept, both as shares: 1 without noise, 0 where that hides all."""
    at = np.clip(np.searchsorted(TRIED, np.nan_to_num(kept, nan=1.0)), 1, len(TRIED) - 1)
    below, above = np.take_along_axis(by_kept, np.stack([at - 1, at]), 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = np.log(above / below) / np.log(TRIED[at] / TRIED[at - 1])
    return np.where(slope < LEAST_SLOPE, 0, np.clip(np.nan_to_num(slope, nan=1.0), 0, 1))
