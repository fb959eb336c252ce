"""How much detail a mosaic keeps, by distance from its seams, relative to the ground around.

    kept_r(d) = sum over cells at distance d of mm / sum of cc a0(cc)^2

with a0^2 the share mm / cc that cells far from any seam have at their energy. It does not change with anything that was
done to the whole mosaic, since that was done to the ground around, too. For two textures that have nothing in common a
50:50 blend keeps 0.5.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.special import stdtrit

from .detail_cells import CELL_PX, EDGES_PX, DetailCells
from .energy_response import EnergyResponse, fit_response
from .ground import scatter_of_blocks

STRIP_PX = 8
"""Width on either side of the seam that kept_1 is of; twice and four times that at levels 2 and 3."""
BAND_KEPT = 0.9
"""The band along a seam is where less than this is kept."""

FAR_PX = 32
"""Ground beyond this distance is what the strip is compared with."""
FARTHER_PX = (128, 96, 64, 48)
"""Where there is enough of it, ground so far off: wide feathers reach beyond ``FAR_PX``."""
ENOUGH_FAR_CELLS = 300
FEWEST_FAR_CELLS = 24
MIN_STRIP_PX = 1000  # pixels of a strip; a seam of some 60 px

_BLOCK_CELLS = 2  # a side of the blocks whose scatter the interval follows from: as much ground as 64 px of strip
_BLOCK_AREA_PX = float((_BLOCK_CELLS * CELL_PX) ** 2)
_LABEL_ERROR = 0.13  # of one such block: pixels beside a seam that are given to the wrong source
_LEAST_ERROR = 0.02  # of kept, however long the seam: borders that are drawn where the mosaic fits best
LEAST_OF_LOW = 0.94
"""Of kept: in a feather the border is drawn where either side is nearest to the mixture, which makes it seem more."""
REACH_ERROR = 0.8
"""Of what is still missing where the ground around begins: a feather reaches into that."""
_CONFIDENCE = 0.95


@dataclass(frozen=True)
class ProfileBin:
    """One level at one distance from the seam."""

    level: int
    near_px: float
    far_px: float
    """Infinite in the last bin."""
    kept: float
    low: float
    high: float
    """95 % interval of ``kept``."""
    gain: float
    """The same by the detail that is the composite's own, so that what was added in the band does not count."""
    area_px: float

    @property
    def middle_px(self) -> float:
        """Of the bin; where it begins for the last one, which has no end."""
        return self.near_px if np.isinf(self.far_px) else (self.near_px + self.far_px) / 2


@dataclass(frozen=True)
class SeamProfile:
    """What a window kept along its seams."""

    kept: tuple[float | None, ...]
    """In the strip beside the seam, levels 1..R; None where there is too little to be measured."""
    low: float
    high: float
    """95 % interval of kept_1."""
    band_width_px: float
    """Full width of the band in which less than 0.9 is kept; 0 where there is none."""
    added_beside: float
    """By how much more of the detail in the strip than around is not the composite's, as a share."""
    bins: tuple[ProfileBin, ...]


def seam_profile(cells: DetailCells) -> SeamProfile | None:
    """The profile of a window, a strip or a mosaic; None without a seam, or with too little ground around."""
    if not cells.has_seam or cells.area[0, strip_bins(0)].sum() < MIN_STRIP_PX:
        return None
    far, beyond = ground_cells(cells)
    if far is None:
        return None
    levels = [_LevelProfile(cells, level, far, beyond) for level in range(len(cells.mm))]
    strips = [level.strip() for level in levels]
    beside = strips[0]
    assert beside is not None
    bins = [level.bins() for level in levels]
    return SeamProfile(
        tuple(None if one is None else one.kept for one in strips),
        beside.low,
        beside.high,
        band_width_px(bins[0][:-1]) if beside.kept < BAND_KEPT else 0.0,
        max(0.0, 1 - beside.gain**2 / beside.kept) if beside.kept > 0 else 0.0,
        tuple(one for found in bins for one in found),
    )


def local_kept(cells: DetailCells, level: int = 0) -> np.ndarray | None:
    """kept_r of every cell, (rows, columns), NaN where none can be told: the picture of where detail was lost."""
    far, beyond = ground_cells(cells)
    if far is None:
        return None
    return _LevelProfile(cells, level, far, beyond).by_cell()


def interval_factor(
    scatter: float | np.ndarray, strip_blocks: np.ndarray, far_blocks: float | np.ndarray, area_px: np.ndarray,
    reach: float | np.ndarray,
) -> np.ndarray:
    """What kept is divided and multiplied by at the ends of its 95 % interval.

    ``scatter`` between blocks of the ground, as many as ``far_blocks``; ``strip_blocks`` that what is judged is as good
    as, ``area_px`` of it; ``reach``: what a feather may have taken from the ground itself, as a share.
    """
    error = np.sqrt(
        scatter**2 * (1 / np.maximum(strip_blocks, 1) + 1 / np.maximum(far_blocks, 1))
        + _LABEL_ERROR**2 * _BLOCK_AREA_PX / area_px
        + reach**2
        + _LEAST_ERROR**2
    )
    return np.asarray(np.exp(stdtrit(np.maximum(far_blocks - 1, 1), (1 + _CONFIDENCE) / 2) * error))


def strip_bins(level: int) -> slice:
    """Bins of the strip beside the seam."""
    return slice(0, EDGES_PX.index(STRIP_PX * 2**level) if STRIP_PX * 2**level in EDGES_PX else len(EDGES_PX) - 1)


def ground_cells(cells: DetailCells) -> tuple[np.ndarray | None, int]:
    """Cells that lie wholly beyond a distance from any seam, (rows, columns) bool, None where there are too few; and
    the bin that begins there."""
    whole = cells.area[0].sum(axis=0) >= CELL_PX**2
    for distance in (*FARTHER_PX, FAR_PX):
        beyond = EDGES_PX.index(distance)
        far = np.asarray(whole & (cells.area[0, :beyond].sum(axis=0) == 0))
        if np.count_nonzero(far) >= ENOUGH_FAR_CELLS:
            break
    return (far if np.count_nonzero(far) >= FEWEST_FAR_CELLS else None), beyond


class _LevelProfile:
    """One level's sums against what the ground around makes one expect of them."""

    def __init__(self, cells: DetailCells, level: int, far: np.ndarray, beyond: int) -> None:
        self._level = level
        self._mm, self._mc, self._area = cells.mm[level], cells.mc[level], cells.area[level]
        cc = cells.cc[level]
        whole = np.maximum(self._area.sum(axis=0), 1)
        energy = cc.sum(axis=0) / whole  # a pixel
        own, shared = (values.sum(axis=0) / whole for values in (self._mm, self._mc))
        self._amplitude = fit_response(energy[far], own[far])
        gain: EnergyResponse = fit_response(energy[far], np.maximum(shared[far], 0))
        self._expected = cc * self._amplitude(energy)
        shared_expected = cc * gain(energy)
        self._scatter, self._far_blocks = _block_scatter(self._mm, self._expected, far)
        parts = (self._mm, self._expected, self._mc, shared_expected, self._area)
        self._sums = np.stack([one.reshape(len(one), -1).sum(axis=1) for one in parts])
        own_before, expected_before, _, _, area_before = self._sums[:, beyond - 1].tolist()
        still = own_before / max(expected_before, 1e-12) if area_before else 1.0
        self._reach = REACH_ERROR * min(max(1 - still, 0.0), 1.0)

    def bins(self) -> list[ProfileBin]:
        """Those that there is anything of."""
        edges = [*zip(EDGES_PX, (*EDGES_PX[1:], np.inf))]
        return [one for one in self._measured(self._sums, self._expected, edges) if one]

    def strip(self) -> ProfileBin | None:
        """The strip beside the seam; None where there is nothing of it."""
        bins = strip_bins(self._level)
        sums, expected = self._sums[:, bins].sum(axis=1, keepdims=True), self._expected[bins].sum(axis=0, keepdims=True)
        (found,) = self._measured(sums, expected, [(0, EDGES_PX[bins.stop])])
        return found

    def _measured(
        self, sums: np.ndarray, expected_cells: np.ndarray, edges: Sequence[tuple[float, float]]
    ) -> list[ProfileBin | None]:
        """Of some bins their sums (5, bins) and what is expected of their cells (bins, rows, columns)."""
        own, expected, shared, expected_shared, area = sums
        some = (expected > 0) & (area > 0)
        kept = own / np.where(some, expected, 1)
        gain = shared / np.maximum(expected_shared, 1e-12)
        factor = interval_factor(
            self._scatter, _effective(expected_cells), self._far_blocks, np.where(some, area, 1), self._reach
        )
        return [
            ProfileBin(self._level + 1, *ends, *numbers) if is_some else None
            for is_some, ends, *numbers in zip(some.tolist(), edges, *(
                column.tolist() for column in (kept, kept / factor * LEAST_OF_LOW, kept * factor, gain, area)
            ))
        ]

    def by_cell(self) -> np.ndarray:
        """mm over what is expected, cell by cell."""
        expected = self._expected.sum(axis=0)
        own = self._mm.sum(axis=0)
        return np.divide(own, expected, out=np.full(own.shape, np.nan), where=expected > 0)


def band_width_px(bins: Sequence[ProfileBin]) -> float:
    """Twice the distance at which BAND_KEPT is reached, linear between the middles of the bins, which have ends."""
    last: tuple[float, float] | None = None
    for one in bins:
        middle = one.middle_px
        if one.kept >= BAND_KEPT and middle > STRIP_PX / 2:
            if last is None:
                return 0.0
            share = (BAND_KEPT - last[1]) / (one.kept - last[1])
            return 2 * (last[0] + share * (middle - last[0]))
        if one.kept < BAND_KEPT:
            last = middle, one.kept
    return 0.0 if last is None else 2 * last[0]


def _block_scatter(mm: np.ndarray, expected: np.ndarray, far: np.ndarray) -> tuple[float, float]:
    """Standard deviation of log kept between blocks of the ground around, and how many blocks that is as good as."""
    return scatter_of_blocks(*(_blocks(np.where(far, values.sum(axis=0), 0)) for values in (mm, expected)))


def _effective(weights: np.ndarray) -> np.ndarray:
    """Of blocks with such weights, (n, rows, columns) in cells, how many equal ones each n is as good as."""
    blocks = _blocks(weights).reshape(len(weights), -1)
    squares = np.einsum("ij,ij->i", blocks, blocks)
    return blocks.sum(axis=1) ** 2 / np.where(squares > 0, squares, 1)


def _blocks(cells: np.ndarray) -> np.ndarray:
    """Sums over blocks of cells (..., rows, columns), those at the end smaller where they don't fit."""
    for axis in (-2, -1):
        length = cells.shape[axis]
        firsts = np.arange(0, length, _BLOCK_CELLS)
        cells = np.add.reduceat(cells, firsts, axis=axis)
    return cells
