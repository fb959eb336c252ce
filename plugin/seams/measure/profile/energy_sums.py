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
"""Relative error of one block: pixels beside a seam that are given to the wrong source."""
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
"""Share of what a soft feather leaves over that is taken for what its ramp makes of what the sources differ by, and its
error: as well it may be detail of theirs that a codec changed, or that a part of the piece without a feather kept."""
BLOCK_CELLS = 2
"""A side of the blocks whose scatter the interval follows from: as much ground as 64 px of strip."""


class EnergySums:
    """Adds up the cells of ``count`` pieces of seam."""

    def __init__(self, count: int, levels: int) -> None:
        self._count, self._levels = count, levels
        self.own, self.shared, self.expected_shared = np.zeros((3, levels, len(EDGES_PX), count))
        """mm, mc and what is expected of that: (levels, bins, count)."""
        self._by_kept = np.zeros((len(TRIED), levels, len(EDGES_PX), count))
        self.area, self.plain = np.zeros((2, levels, len(EDGES_PX), count))
        """Pixels and ss, with ground or without."""
        self._squares = np.zeros(count)  # of what is expected of blocks of 32 px in the strip
        self._noise = np.zeros((3, count))  # scatter, blocks of ground, reach; each times what is expected
        self._left = np.zeros((levels, count))  # that the ground makes one expect in the strip, DN squared
        self._unsure = np.zeros(count)  # share of the mosaic's finest detail in the strip

    def add(self, table: CellTable, ground: Sequence[LevelGround | None], piece: np.ndarray) -> None:
        """Some cells; ``piece`` (rows of the table,): the one that each belongs to, or -1."""
        in_pieces = np.flatnonzero(piece >= 0)
        if not len(in_pieces):
            return
        near, cells, piece = table.chosen(in_pieces), table.cell[in_pieces], piece[in_pieces]
        place = near.bin.astype(np.intp) * self._count + piece
        for level, level_ground in enumerate(ground):
            self._sum(self.area[level], place, near.area[level])
            self._sum(self.plain[level], place, near.cc[level])
            if level_ground is not None:
                self._add_level(near, level, level_ground, table.whole.energy(level)[cells], place, piece)

    @property
    def expected(self) -> np.ndarray:
        """mm where all is kept, (levels, bins, count)."""
        return self._by_kept[_ALL]

    def kept(self) -> tuple[Kept, np.ndarray]:
        """kept_1 of every piece, and kept_r (levels, count), NaN where nothing can be told."""
        expected = np.stack([in_strip(one) for one in self._by_kept])
        mm = in_strip(self.own)
        return self._with_interval(mm[0], in_strip(self.area)[0], expected[:, 0]), _kept(mm, expected)

    def by_bins(self, level: int) -> Kept:
        """kept of one level, 0 the finest, at every distance, (bins, count)."""
        return self._with_interval(self.own[level], self.area[level], self._by_kept[:, level])

    def take_out(self, edge: np.ndarray, left: np.ndarray) -> None:
        """Take out what no source has, energy by (levels, some bins, count), DN squared: what the mosaic's detail has
        of the cut's own edge, and what soft feathers leave over."""
        unsure = SURE_LEFT * left
        self._unsure = in_strip(unsure)[0] / np.maximum(in_strip(self.own)[0], 1e-12)
        self.own[:, : edge.shape[1]] -= edge + unsure

    def _with_interval(self, own: np.ndarray, area_px: np.ndarray, by_kept: np.ndarray) -> Kept:
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
        kept = _kept(own, by_kept)
        with np.errstate(divide="ignore", invalid="ignore"):
            by_response = np.nan_to_num(np.log(kept * by_kept[_ALL] / own), nan=0.0, posinf=0.0, neginf=0.0)
        error = np.hypot(error / _slope(kept, by_kept), RESPONSE_ERROR * by_response)
        return Kept.of(kept, error, np.broadcast_to(blocks - 1, error.shape))

    @property
    def left_by_ground(self) -> np.ndarray:
        """Energy in the strips that sources leave over as they do on the ground around, DN squared, (levels, count)."""
        return self._left

    def _add_level(
        self, near: CellTable, level: int, ground: LevelGround, energy: np.ndarray, place: np.ndarray,
        piece: np.ndarray,
    ) -> None:
        ss = near.cc[level]
        for total, kept in zip(self._by_kept, TRIED.tolist()):
            if kept != 1:
                self._sum(total[level], place, kept * ss * ground.amplitude(kept * energy))
        amplitude, gain = ground.amplitude(energy), ground.gain(energy)
        expected = ss * amplitude
        for total, values in (
            (self.own, near.mm[level]), (self.expected, expected), (self.shared, near.mc[level]),
            (self.expected_shared, ss * gain),
        ):
            self._sum(total[level], place, values)
        strip = near.bin < strip_bins(level).stop
        strip_piece, expected = piece[strip], expected[strip]
        left_over = ss[strip] * np.maximum(amplitude[strip] - gain[strip] ** 2, 0)
        self._left[level] += np.bincount(strip_piece, left_over, self._count)
        if level:
            return
        side = BLOCK_CELLS
        rows, columns = (one[strip].astype(np.int64) // side for one in (near.row, near.column))
        blocks = (strip_piece.astype(np.int64) << 40) + (rows << 20) + columns
        keys, of_block = np.unique(blocks, return_inverse=True)
        self._squares += np.bincount(keys >> 40, np.bincount(of_block, expected) ** 2, self._count)
        weight = np.bincount(strip_piece, expected, self._count)
        self._noise += weight * np.array((ground.scatter**2, ground.blocks, ground.reach**2))[:, np.newaxis]

    def _sum(self, total: np.ndarray, place: np.ndarray, values: np.ndarray) -> None:
        total += np.bincount(place, values, total.size).reshape(total.shape)


def _kept(own: np.ndarray, by_kept: np.ndarray) -> np.ndarray:
    """The share of which such an energy is left, (...), NaN where nothing is expected; ``by_kept`` (TRIED, ...)."""
    at, first, last = _between(own, by_kept)
    known = by_kept[_ALL] > 0
    with np.errstate(divide="ignore", invalid="ignore"):
        part = (np.maximum(own, 0) - first) / (last - first)
    lower, upper = np.append(0, TRIED)[at], TRIED[at]
    return np.where(known, lower + part * (upper - lower), np.nan)


def _slope(kept: np.ndarray, by_kept: np.ndarray) -> np.ndarray:
    """Change of an energy with what is kept, both as shares: 1 without noise."""
    at = np.clip(np.searchsorted(TRIED, np.nan_to_num(kept, nan=1.0)), 1, len(TRIED) - 1)
    first, last = (np.take_along_axis(by_kept, place[np.newaxis], 0)[0] for place in (at - 1, at))
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = np.log(last / first) / np.log(TRIED[at] / TRIED[at - 1])
    return np.asarray(np.clip(np.nan_to_num(slope, nan=1.0), LEAST_SLOPE, 1))


def _between(own: np.ndarray, by_kept: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The value tried above an energy, the energy of the one below, 0 for the first, and its own."""
    rising = np.maximum.accumulate(by_kept, axis=0)
    at = np.minimum((rising < own).sum(axis=0), len(TRIED) - 1)
    last = np.take_along_axis(rising, at[np.newaxis], 0)[0]
    first = np.where(at > 0, np.take_along_axis(rising, np.maximum(at - 1, 0)[np.newaxis], 0)[0], 0)
    return at, first, last
