"""What is kept along every piece of seam: the cells of all blocks added up to the piece that is nearest to them."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .....imagery.grids import PixelWindow
from .....imagery.rasters import Raster
from ...profile.detail_cells import CELL_PX, EDGES_PX
from ...profile.seam_profile import (
    BAND_KEPT,
    FAR_PX,
    LEAST_OF_LOW,
    MIN_STRIP_PX,
    ProfileBin,
    SeamProfile,
    band_width_px,
    interval_factor,
    strip_bins,
)
from ...visibility import visibility, white_grey
from ..blocks.cell_table import CellTable
from ..blocks.scan_block import CELLS
from ..lines.piece_index import PieceIndex
from .block_ground import LevelGround, whole_cells

REACH_PX = 144.0
"""How far from a piece cells are counted to it: what lies beyond is ground."""
MOST_ASIDE_PX = 40.0
"""How far a line may lie from the seam that the mosaic shows, for that to be its seam."""
BINS = EDGES_PX.index(128)
"""Bins that are told apart along a piece."""


@dataclass(frozen=True, eq=False)
class PieceProfile:
    """One piece of seam as it was measured."""

    profile: SeamProfile | None
    """None where there is too little ground to be measured."""
    area_px: float
    """Of its strip, level 1."""
    fit: float
    """Share of the mosaic's finest detail in the strip that its sources explain."""
    visibility: float | None = None
    """The loss in just noticeable differences of contrast at 2x; None where nothing says how bright the ground is."""


class PieceSums:
    """Adds up blocks; then tells every piece. Some 500 bytes a piece."""

    def __init__(self, count: int, levels: int) -> None:
        self._count, self._levels = count, levels
        self._strip = np.zeros((5, levels, count))  # mm, expected, mc, shared and expected, area
        self._bins = np.zeros((3, BINS, count), np.float32)  # level 1: mm, expected, area
        self._squares = np.zeros((levels, count))  # of what is expected of blocks of 32 px
        self._noise = np.zeros((3, count))  # scatter, blocks of ground, reach; each times what is expected
        self._plain = np.zeros((levels, count))  # cc in the strip
        self._grey = np.zeros((2, count))  # of the strip's cells: mean of the mosaic times area, and area
        self._brightest = 0.0  # of cells

    def add(
        self, table: CellTable, ground: Sequence[LevelGround | None], index: PieceIndex, window: PixelWindow,
        grey: np.ndarray | None = None,
    ) -> None:
        """The cells of one block; ``grey``: means of the mosaic as ``BlockScan`` has them, None where not known."""
        index = index.near(window, REACH_PX)
        whole = whole_cells(table)
        beside = np.flatnonzero(whole.nearest < BINS)
        if not len(beside) or not len(index):
            return
        piece_of = np.full(len(whole.row), -1)
        number, distance = index.nearest(
            (whole.column[beside] + 0.5) * CELL_PX, (whole.row[beside] + 0.5) * CELL_PX, REACH_PX
        )
        nearest = np.array(EDGES_PX)[whole.nearest[beside]]
        is_its_own = (distance <= nearest + MOST_ASIDE_PX) | (nearest >= FAR_PX)
        piece_of[beside] = np.where(is_its_own, number, -1)
        found = np.flatnonzero((table.bin < BINS) & (piece_of[whole.of_row] >= 0))
        near, cells = table.chosen(found), whole.of_row[found]
        self._add_grey(near, grey, piece_of[cells])
        for level in range(self._levels):
            of = ground[level]
            if of is not None:
                self._add_level(near, level, of, whole.energy(level)[cells], piece_of[cells])

    def _add_grey(self, near: CellTable, grey: np.ndarray | None, piece: np.ndarray) -> None:
        if grey is None:
            return
        strip = near.bin < strip_bins(0).stop
        values = grey[near.row[strip] % CELLS, near.column[strip] % CELLS]
        area = near.area[0][strip]
        self._grey += [np.bincount(piece[strip], one, self._count) for one in (area * values, area)]
        self._brightest = float(np.fmax.reduce(values, initial=self._brightest))

    def _add_level(
        self, near: CellTable, level: int, ground: LevelGround, energy: np.ndarray, piece: np.ndarray
    ) -> None:
        expected = near.cc[level] * ground.response.amplitude(energy)
        shared = near.cc[level] * ground.response.gain(energy)
        strip = near.bin < strip_bins(level).stop
        own = piece[strip]
        for total, values in zip(
            self._strip[:, level], (near.mm[level], expected, near.mc[level], shared, near.area[level])
        ):
            total += np.bincount(own, values[strip], self._count)
        blocks = (own.astype(np.int64) << 40) + (near.row[strip].astype(np.int64) // 2 << 20) + near.column[strip] // 2
        keys, of_block = np.unique(blocks, return_inverse=True)
        sums = np.bincount(of_block, expected[strip])
        self._squares[level] += np.bincount(keys >> 40, sums**2, self._count)
        self._plain[level] += np.bincount(own, near.cc[level][strip], self._count)
        if level:
            return
        weight = np.bincount(own, expected[strip], self._count)
        values = (ground.response.scatter**2, ground.response.blocks, ground.reach**2)
        self._noise += weight * np.array(values)[:, np.newaxis]
        number = near.bin.astype(np.int64) * self._count + piece
        for total, sums in zip(self._bins, (near.mm[0], expected, near.area[0])):
            total += np.bincount(number, sums, BINS * self._count).reshape(BINS, self._count)

    def profiles(self, mosaic: Raster | None = None) -> list[PieceProfile]:
        """Of every piece, in their order; ``mosaic``: what its grey values mean on a screen."""
        mm, expected, mc, shared, area = self._strip
        known = (expected > 0) & (area >= MIN_STRIP_PX)
        kept = np.where(known, mm, np.nan) / np.where(known, expected, 1)
        gain = mc[0] / np.maximum(shared[0], 1e-12)
        weight = np.where(expected[0] > 0, expected[0], 1)
        scatter, blocks, reach = self._noise / weight
        strip_blocks = expected[0] ** 2 / np.where(self._squares[0] > 0, self._squares[0], 1)
        factor = interval_factor(
            np.sqrt(scatter), strip_blocks, np.maximum(blocks, 1), np.maximum(area[0], 1), np.sqrt(reach)
        )
        energies = mm[0] * self._plain[0]
        variance = self._plain / np.maximum(area, 1)
        grey = self._grey[0] / np.maximum(self._grey[1], 1)
        white = white_grey(mosaic, self._brightest) if mosaic else np.nan
        fit = np.maximum(mc[0], 0) ** 2 / np.where(energies > 0, energies, 1)
        low, high = kept[0] / factor * LEAST_OF_LOW, kept[0] * factor
        found = []
        for number in range(self._count):
            if not known[0, number]:
                found.append(PieceProfile(None, float(area[0, number]), 0.0))
                continue
            finest = float(kept[0, number])
            bins = self._bins_of(number)
            profile = SeamProfile(
                tuple(None if np.isnan(one) else float(one) for one in kept[:, number]), float(low[number]),
                float(high[number]), band_width_px(bins) if finest < BAND_KEPT else 0.0,
                max(0.0, 1 - float(gain[number]) ** 2 / finest) if finest > 0 else 0.0, tuple(bins),
            )
            seen = visibility(profile.kept, variance[:, number].tolist(), float(grey[number]), white)
            found.append(PieceProfile(profile, float(area[0, number]), float(fit[number]), seen))
        return found

    def _bins_of(self, number: int) -> list[ProfileBin]:
        """Level 1 by distance, without intervals of their own."""
        mm, expected, area = self._bins[:, :, number].tolist()
        return [
            ProfileBin(1, EDGES_PX[i], EDGES_PX[i + 1], mm[i] / expected[i], np.nan, np.nan, np.nan, area[i])
            for i in range(BINS) if expected[i] > 0
        ]
