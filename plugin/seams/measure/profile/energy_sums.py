"""kept by energy: what the mosaic has of its sources' detail along seams, relative to the ground around.

    kept_r(d) = sum over cells at distance d of (mm - the cut's own edge) / sum of ss a0(ss)^2

with a0^2 the share mm / ss that cells far from any seam have at their energy. It does not change with anything that was
done to the whole mosaic, since that was done to the ground around, too.
"""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from .cell_table import CELL_PX, EDGES_PX, CellTable, WholeCells
from .ground import LevelGround
from .intervals import Kept
from .seam_profile import in_strip, strip_bins

LABEL_ERROR = 0.13
"""Of one block: pixels beside a seam that are given to the wrong source."""
LEAST_ERROR = 0.025
"""Of kept, however long the seam: borders that are drawn where the mosaic fits best."""
BLOCK_CELLS = 2
"""A side of the blocks whose scatter the interval follows from: as much ground as 64 px of strip."""


class EnergySums:
    """Adds up the cells of ``count`` pieces of seam."""

    def __init__(self, count: int, levels: int) -> None:
        self._count, self._levels = count, levels
        self.own, self.expected, self.shared, self.expected_shared = np.zeros((4, levels, len(EDGES_PX), count))
        """mm, what is expected of it, mc and what is expected of that: (levels, bins, count)."""
        self.area, self.plain = np.zeros((2, levels, len(EDGES_PX), count))
        """Pixels and ss, with ground or without."""
        self._squares = np.zeros(count)  # of what is expected of blocks of 32 px in the strip
        self._noise = np.zeros((3, count))  # scatter, blocks of ground, reach; each times what is expected
        self._left = np.zeros((levels, count))  # that the ground makes one expect in the strip, DN squared

    def add(
        self, table: CellTable, whole: WholeCells, ground: Sequence[LevelGround | None], piece_of: np.ndarray
    ) -> None:
        """Some cells, ``whole`` those of ``table``; ``piece_of`` (cells,): the piece that each belongs to, or -1."""
        piece = piece_of[whole.of_row]
        found = np.flatnonzero(piece >= 0)
        if not len(found):
            return
        near, cells, piece = table.chosen(found), whole.of_row[found], piece[found]
        place = near.bin.astype(np.intp) * self._count + piece
        for level, one in enumerate(ground):
            self._sum(self.area[level], place, near.area[level])
            self._sum(self.plain[level], place, near.cc[level])
            if one is not None:
                self._add_level(near, level, one, whole.energy(level)[cells], place, piece)

    def kept(self) -> tuple[Kept, np.ndarray]:
        """kept_1 of every piece, and kept_r (levels, count), NaN where nothing can be told."""
        own, expected = (in_strip(one) for one in (self.own, self.expected))
        levels = np.divide(np.maximum(own, 0), expected, out=np.full(own.shape, np.nan), where=expected > 0)
        return self.with_interval(levels[0], in_strip(self.area)[0]), levels

    def take_out(self, edge: np.ndarray) -> None:
        """What the mosaic's detail has of the cut's own edge, energy by (levels, some bins, count), DN squared."""
        self.own[:, : edge.shape[1]] -= edge

    def with_interval(self, kept: np.ndarray, area_px: np.ndarray) -> Kept:
        """Shares of an area, (..., count) each, as sure as the scatter of the ground around lets them be."""
        expected = np.maximum(in_strip(self.expected)[0], 1e-12)
        scatter, blocks, reach = self._noise / expected
        blocks, area_px = np.maximum(blocks, 1), np.maximum(area_px, 1)
        # Texture is uneven: blocks of one weight that a strip is as good as, by its area.
        density = expected**2 / np.maximum(self._squares, 1e-12) / np.maximum(in_strip(self.area)[0], 1)
        own_blocks = np.maximum(density * area_px, 1)
        error = np.sqrt(
            scatter * (1 / own_blocks + 1 / blocks) + LABEL_ERROR**2 * (BLOCK_CELLS * CELL_PX) ** 2 / area_px
            + reach + LEAST_ERROR**2
        )
        return Kept.of(kept, error, np.broadcast_to(blocks - 1, error.shape))

    @property
    def left_by_ground(self) -> np.ndarray:
        """Energy in the strips that sources leave over as they do on the ground around, DN squared, (levels, count)."""
        return self._left

    def _add_level(
        self, near: CellTable, level: int, ground: LevelGround, energy: np.ndarray, place: np.ndarray,
        piece: np.ndarray,
    ) -> None:
        amplitude, gain = ground.amplitude(energy), ground.gain(energy)
        expected, mm, ss = near.cc[level] * amplitude, near.mm[level], near.cc[level]
        for total, values in (
            (self.own, mm), (self.expected, expected), (self.shared, near.mc[level]), (self.expected_shared, ss * gain)
        ):
            self._sum(total[level], place, values)
        strip = near.bin < strip_bins(level).stop
        own, expected = piece[strip], expected[strip]
        left = ss[strip] * np.maximum(amplitude[strip] - gain[strip] ** 2, 0)
        self._left[level] += np.bincount(own, left, self._count)
        if level:
            return
        side = BLOCK_CELLS
        rows, columns = (one[strip].astype(np.int64) // side for one in (near.row, near.column))
        blocks = (own.astype(np.int64) << 40) + (rows << 20) + columns
        keys, of_block = np.unique(blocks, return_inverse=True)
        self._squares += np.bincount(keys >> 40, np.bincount(of_block, expected) ** 2, self._count)
        weight = np.bincount(own, expected, self._count)
        self._noise += weight * np.array((ground.scatter**2, ground.blocks, ground.reach**2))[:, np.newaxis]

    def _sum(self, total: np.ndarray, place: np.ndarray, values: np.ndarray) -> None:
        total += np.bincount(place, values, total.size).reshape(total.shape)
