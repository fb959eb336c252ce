"""kept by mixture, of many pieces of seam: sums, and what follows from them (``mixture``)."""
from __future__ import annotations

import numpy as np

from .cell_table import MIXED_BINS, PRODUCTS, MixtureTable, WholeCells
from .energy_sums import BLOCK_CELLS
from .intervals import Kept
from .mixture import SLOTS, feather_width_px, fit_mixtures, followed_energy, mixed_energy
from .seam_profile import strip_bins

GROUPS = 8
"""Of blocks of 32 px, each left out in turn: the jackknife (Tukey 1958)."""
LEAST_ERROR = 0.02
"""Of kept, however long the seam: a border drawn where the mosaic fits best follows a mixture's noise."""
MIN_BESIDE_PX = 500
"""Pixels of the strip beside which another source is known: with fewer nothing is said of a mixture."""
_AREA, _MM, _SS = (PRODUCTS.index(name) for name in ("area", "mm", "ss"))


class MixtureSums:
    """Adds up the rows of ``count`` pieces of seam, pair by pair of sources."""

    def __init__(self, count: int, levels: int) -> None:
        self._count, self._levels = count, levels
        self._sums: dict[tuple[int, int, int], np.ndarray] = {}  # piece, lower and higher number of the sources

    def add(self, table: MixtureTable, whole: WholeCells, piece_of: np.ndarray) -> None:
        """Some rows, of cells among ``whole``; ``piece_of`` (cells,): the piece that each belongs to, or -1. Numbers of
        sources must mean the same every time."""
        if not len(table):
            return
        piece = piece_of[np.searchsorted(whole.keys, table.keys)]
        table, piece = table.chosen(piece >= 0), piece[piece >= 0]
        lower, higher = np.minimum(table.source, table.other), np.maximum(table.source, table.other)
        codes = (piece.astype(np.int64) << 32) + (lower.astype(np.int64) << 16) + higher
        group = (table.row // BLOCK_CELLS * 3 + table.column // BLOCK_CELLS) % GROUPS
        slot = (table.source > table.other).astype(np.intp) * MIXED_BINS + table.bin
        places = [group.astype(np.intp) * SLOTS + slot, *[slot] * (self._levels - 1)]
        sizes = [GROUPS * SLOTS, *[SLOTS] * (self._levels - 1)]
        order = np.argsort(codes, kind="stable")
        found, firsts = np.unique(codes[order], return_index=True)
        for code, own in zip(found.tolist(), np.split(order, firsts[1:])):
            key = code >> 32, code >> 16 & 0xFFFF, code & 0xFFFF
            total = self._sums.setdefault(key, np.zeros((len(PRODUCTS), sum(sizes))))
            for product, target in zip(table.products[..., own], total):
                start = 0
                for values, place, size in zip(product, places, sizes):
                    target[start : start + size] += np.bincount(place[own], values, size)
                    start += size

    def result(self) -> MixedStrips:
        """Of all pieces."""
        keys = sorted(self._sums)
        shape = (len(keys), len(PRODUCTS), GROUPS + self._levels - 1, SLOTS)
        sums = np.stack([self._sums[key] for key in keys]).reshape(shape) if keys else np.zeros(shape)
        return MixedStrips(np.array([key[0] for key in keys], np.intp), np.moveaxis(sums, 1, -1), self._count)


class MixedStrips:
    """What ``count`` pieces are mixed of. ``piece`` (n,): that each seam between two sources belongs to; ``sums``
    (n, groups of level 1 and then the other levels, SLOTS, products)."""

    def __init__(self, piece: np.ndarray, sums: np.ndarray, count: int) -> None:
        self._piece, self._count = piece, count
        finest = sums[:, :GROUPS]
        self._whole = np.concatenate([finest.sum(axis=1, keepdims=True), sums[:, GROUPS:]], axis=1)
        levels = range(self._whole.shape[1])
        fitted = [fit_mixtures(self._whole[:, level]) for level in levels]
        self._other = fitted[0].other if len(piece) else np.zeros((0, SLOTS))
        strips = [_in_strip(level) for level in levels]
        self.edge, self.left, self.soft_left = (
            np.stack([self._both_sides(values) for values in parts]) for parts in zip(
                *((one.edge, one.left, one.left * fitted[0].soft) for one in fitted)
            )
        )
        """(levels, MIXED_BINS, count) each, DN squared: energy of the mosaic's detail that is the cut's own edge; what
        the mixture leaves over; and as much of that as a feather's ramp makes of what the sources differ by."""
        own, plain = (
            np.stack([self._by_piece(values[:, level][:, strip].sum(axis=1)) for level, strip in zip(levels, strips)])
            for values in (way(self._whole, self._other[:, np.newaxis]) for way in (mixed_energy, followed_energy))
        )
        enough = self._by_piece(self._whole[:, 0, strips[0], _AREA].sum(axis=1)) >= MIN_BESIDE_PX
        known = enough & (plain > 0)
        self.levels = np.divide(own, plain, out=np.full(own.shape, np.nan), where=known)
        """kept_r (levels, count), NaN where nothing can be told."""
        self.plain = plain
        """(levels, count): energy of the sources' detail in the strip, DN squared."""
        self.kept = self._kept(finest, strips[0])

    def feather_widths_px(self) -> np.ndarray:
        """(count,): of the seam between two sources that is longest in each piece; NaN where there is none."""
        found = np.full(self._count, np.nan)
        longest = np.zeros(self._count)
        for number, piece in enumerate(self._piece.tolist()):
            area = float(self._whole[number, 0, :, _AREA].sum())
            if area > longest[piece]:
                found[piece], longest[piece] = feather_width_px(self._other[number]), area
        return found

    def shares(self) -> np.ndarray:
        """Of the other source, (MIXED_BINS, count): the mean of both sides, NaN where there is nothing."""
        area = self._whole[:, 0, :, _AREA]
        own, every = map(self._both_sides, (self._other * area, area))
        return np.divide(own, every, out=np.full(own.shape, np.nan), where=every > 0)

    def by_bins(self, level: int) -> tuple[np.ndarray, np.ndarray]:
        """Energy of the detail that is left, and of the sources', DN squared: (MIXED_BINS, count) each."""
        products = self._whole[:, level]
        mixed, plain = mixed_energy(products, self._other), followed_energy(products, self._other)
        return self._both_sides(mixed), self._both_sides(plain)

    def _kept(self, sums: np.ndarray, strip: np.ndarray) -> Kept:
        """``sums``: (n, groups, SLOTS, products) of level 1."""
        whole = sums.sum(axis=1)
        left_out = whole[:, np.newaxis] - sums  # (n, groups, SLOTS, products)
        other = fit_mixtures(left_out.reshape(-1, SLOTS, len(PRODUCTS))).other.reshape(left_out.shape[:3])
        own, plain = (
            np.stack([self._by_piece(one[:, group][:, strip].sum(axis=1)) for group in range(GROUPS)])
            for one in (way(left_out, other) for way in (mixed_energy, followed_energy))
        )
        estimates = own / np.maximum(plain, 1e-12)
        deviations = estimates - estimates.mean(axis=0)
        variance = (GROUPS - 1) / GROUPS * (deviations**2).sum(axis=0)
        value = self.levels[0]
        error = np.sqrt(variance) / np.maximum(value, 1e-6)
        total = np.sqrt(error**2 + LEAST_ERROR**2)
        # The floor is known, the rest comes of few groups (Welch and Satterthwaite).
        freedom = (GROUPS - 1) * (total / np.maximum(error, 1e-3)) ** 4
        return Kept.of(value, total, freedom)

    def _both_sides(self, values: np.ndarray) -> np.ndarray:
        """Of (n, SLOTS) the sums of both sides, (MIXED_BINS, count)."""
        return np.stack([self._by_piece(values[:, bin_::MIXED_BINS].sum(axis=1)) for bin_ in range(MIXED_BINS)])

    def _by_piece(self, values: np.ndarray) -> np.ndarray:
        return np.bincount(self._piece, values, self._count) if len(values) else np.zeros(self._count)


def _in_strip(level: int) -> np.ndarray:
    """Which slots lie in the strip, (SLOTS,) bool."""
    return np.asarray(np.arange(SLOTS) % MIXED_BINS < strip_bins(level).stop)
