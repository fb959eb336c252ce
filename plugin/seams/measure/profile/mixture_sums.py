"""kept by mixture, of many pieces of seam: sums, and what follows from them (``mixture``)."""
from __future__ import annotations

from functools import cached_property

import numpy as np

from .cell_table import MIXED_BINS, PRODUCTS, MixtureTable, WholeCells
from .energy_sums import BLOCK_CELLS
from .intervals import Kept
from .mixture import SLOTS, feather_width_px, fit_mixtures, followed_energy, mixed_energy
from .seam_profile import in_strip, strip_bins

GROUPS = 8
"""Of blocks of 32 px, each left out in turn: the jackknife (Tukey 1958)."""
LEAST_ERROR = 0.02
"""Of kept, however long the seam: a border drawn where the mosaic fits best follows a mixture's noise."""
WIDE_ERROR, WIDE_PX = 0.05, 200.0
"""Of kept, of a feather so wide: there is less unmixed ground to learn tones and filters of."""
NARROW_ERROR, NARROW_PX = 0.03, 8.0
"""Of kept, of a feather narrower than that: it may be a cut whose border was drawn in the wrong place."""
MIN_BESIDE_PX = 500
"""Pixels of the strip beside which another source is known: with fewer nothing is said of a mixture."""
_AT_A_TIME = 32  # seams, whose groups take eight times their memory
_AREA = PRODUCTS.index("area")


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
        whole = np.concatenate([finest.sum(axis=1, keepdims=True), sums[:, GROUPS:]], axis=1)
        fitted = [fit_mixtures(whole[:, level]) for level in range(whole.shape[1])]
        self._other = fitted[0].other
        self._area = whole[:, 0, :, _AREA]
        edge, left = (np.stack([getattr(one, name) for one in fitted], axis=1) for name in ("edge", "left"))
        self.edge, self.left, self.soft_left = map(
            self._both_sides, (edge, left, left * fitted[0].soft[:, np.newaxis])
        )
        """(levels, MIXED_BINS, count) each, DN squared: energy of the mosaic's detail that is the cut's own edge; what
        the mixture leaves over; and as much of that as a feather's ramp makes of what the sources differ by."""
        other = self._other[:, np.newaxis]
        mixed, plain = (self._both_sides(way(whole, other)) for way in (mixed_energy, followed_energy))
        shown, self.plain = (self._both_sides(way(whole, other, False)) for way in (mixed_energy, followed_energy))
        """(levels, MIXED_BINS, count), DN squared: energy of the sources' detail as the mosaic shows it."""
        self.bins, self.before = _ratio(mixed, plain), _ratio(mixed * self.plain, plain * shown)
        """(levels, MIXED_BINS, count) each: kept, and that as a multiple of what is kept of the sources as the mosaic
        shows them; NaN where nothing is known."""
        own, plain, shown, source = map(in_strip, (mixed, plain, shown, self.plain))
        self.before_in_strip = _ratio(own * source, plain * shown)
        """(levels, count): the same of the strip."""
        enough = self._both_sides(self._area)[strip_bins(0)].sum(axis=0) >= MIN_BESIDE_PX
        self.levels = np.where(enough, _ratio(own, plain), np.nan)
        """kept_r (levels, count), NaN where nothing can be told."""
        self.kept = self._kept(finest)

    @cached_property
    def feather_widths_px(self) -> np.ndarray:
        """(count,): of the seam between two sources that is longest in each piece; NaN where there is none."""
        found = np.full(self._count, np.nan)
        longest = np.zeros(self._count)
        for number, piece in enumerate(self._piece.tolist()):
            area = float(self._area[number].sum())
            if area > longest[piece]:
                found[piece], longest[piece] = feather_width_px(self._other[number]), area
        return found

    def shares(self) -> np.ndarray:
        """Of the other source, (MIXED_BINS, count): the mean of both sides, NaN where there is nothing."""
        return _ratio(*map(self._both_sides, (self._other * self._area, self._area)))

    def _kept(self, sums: np.ndarray) -> Kept:
        """``sums``: (n, groups, SLOTS, products) of level 1."""
        energies = [_left_out(sums[start : start + _AT_A_TIME]) for start in range(0, max(len(sums), 1), _AT_A_TIME)]
        own, plain = (
            self._both_sides(np.concatenate(parts))[:, strip_bins(0)].sum(axis=1) for parts in zip(*energies)
        )
        estimates = own / np.maximum(plain, 1e-12)
        deviations = estimates - estimates.mean(axis=0)
        variance = (GROUPS - 1) / GROUPS * (deviations**2).sum(axis=0)
        value = self.levels[0]
        error = np.sqrt(variance) / np.maximum(value, 1e-6)
        widths = np.nan_to_num(self.feather_widths_px)
        wide = WIDE_ERROR * np.minimum(widths / WIDE_PX, 1)
        narrow = np.where((widths > 0) & (widths < NARROW_PX), NARROW_ERROR, 0)
        total = np.sqrt(error**2 + LEAST_ERROR**2 + wide**2 + narrow**2)
        # The floor is known, the rest comes of few groups (Welch and Satterthwaite).
        freedom = (GROUPS - 1) * (total / np.maximum(error, 1e-3)) ** 4
        return Kept.of(value, total, freedom)

    def _both_sides(self, values: np.ndarray) -> np.ndarray:
        """Of (n, ..., SLOTS) the sums of both sides and all seams of a piece, (..., MIXED_BINS, count)."""
        sides = values.reshape(*values.shape[:-1], 2, MIXED_BINS).sum(axis=-2)
        found = np.zeros((self._count, *sides.shape[1:]))
        np.add.at(found, self._piece, sides)
        return np.moveaxis(found, 0, -1)


def _left_out(sums: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Energies that are left and those of the sources without each group in turn, (n, groups, SLOTS) each; ``sums`` as
    ``MixedStrips`` has them of level 1."""
    left_out = sums.sum(axis=1, keepdims=True) - sums
    other = fit_mixtures(left_out.reshape(-1, SLOTS, len(PRODUCTS))).other.reshape(left_out.shape[:3])
    return mixed_energy(left_out, other), followed_energy(left_out, other)


def _ratio(own: np.ndarray, plain: np.ndarray) -> np.ndarray:
    return np.divide(own, plain, out=np.full(own.shape, np.nan), where=plain > 0)
