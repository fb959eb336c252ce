"""Ground that no given source explains: by the noise of each source where anything was compressed, else by the best
ground of all, which tells images that are nearly alike as well.
"""
from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from itertools import combinations, combinations_with_replacement

import numpy as np
from scipy import ndimage

from ..seam_cells import is_one_of, present
from .best_ground import (
    MIN_ALIKE_STRANGE,
    MIN_EVEN_LEFT,
    MIN_STAND_IN_FACTOR,
    MIN_STAND_IN_STRANGE,
    MIN_STRANGE,
    BestGround,
    learn_best_ground,
)
from .boxes import SMALLEST_PART_PX, box_means, enlarged, narrowed, opened, without_islands
from .compression import IsCompressed
from .followed_source import CELL_PX, LEAST_ENERGY, MIN_TEXTURED, NEAR_CELLS, WIDE_CELLS
from .foreign_ground import NOISE_CELL_PX, CellSums, foreign_ground

MIN_TEXTURE = 0.3  # of the energy that a source would have

_STRIP_CELLS = 4  # a side of the least part that no source explains: a seam leaves something over along itself
_ALIKE_CELLS = 12  # the same where a source does resemble it
_MIXED_LEFT = 0.5  # of what one source leaves over: with less a mixture explains the mosaic
_AS_STRONG = 0.85  # of the energy that a source would have, for it to stand in for another
_NOWHERE_FACTOR = 50.0  # times as much as other sources leave over on their ground; resampled ones had 34 to 76
_NOWHERE_SPREAD = 1.45  # between the quartiles of that, by what its best ground leaves over; resampled ones had 1.34
_FOREIGN_LEFT, _FOREIGN_FACTOR = 0.1, 20.0  # as the first: evenly or not, resampled ones left over 0.03 or 14 times
_EVEN_PART, _EVEN_SHARE = 0.5, 0.4  # of what is left over around: most cells leave so much, of a step of tones few do


def unexplained_cells(
    sums: CellSums, is_compressed: IsCompressed, interpolated: Collection[int], is_window: bool
) -> np.ndarray:
    """Cells that the sources explain worse than true ones do, (cell rows, cell columns) bool.

    ``interpolated``: sources that lie between the mosaic's pixels, which leave more over than others do. ``is_window``:
    whether all of it may be of no given source; a part of a block has too little ground to say that.
    """
    mosaic, labels, energies, products = sums.mosaic, sums.labels, sums.energies, sums.shared
    energy, product = np.zeros_like(mosaic), np.zeros_like(mosaic)
    for i in energies:
        of = labels == i
        gain = np.float32(max(float(products[i][of].sum()), 0.0) / max(float(energies[i][of].sum()), 1e-9))
        np.copyto(energy, gain**2 * energies[i], where=of)
        np.copyto(product, gain * products[i], where=of)
    least = np.float32(LEAST_ENERGY * CELL_PX**2)
    rest = mosaic - 2 * product + energy
    wide, energy, product = (box_means(plane, (WIDE_CELLS,))[0] for plane in (mosaic, energy, product))
    wide += least
    energy += least
    # Where the mosaic shows nothing of a source's texture it was clipped, or blurred away.
    textured = (wide > MIN_TEXTURED * least) & (wide >= MIN_TEXTURE * energy)
    left_over = np.maximum(wide - np.maximum(product, 0) ** 2 / energy, 0)
    if _is_explained(wide, left_over, textured):
        return np.zeros_like(textured)
    if is_compressed(None):
        return enlarged(foreign_ground(sums, is_compressed, is_window), NOISE_CELL_PX // CELL_PX, mosaic.shape)
    # A step of tones leaves over much along a line, and nothing beside it.
    even = box_means(rest * wide >= _EVEN_PART * left_over * mosaic, (WIDE_CELLS,))[0] >= _EVEN_SHARE
    sharp = textured & (wide >= _AS_STRONG * energy)  # a seam that was brushed soft is followed all the same
    cells = _Cells(wide, left_over, textured, sharp, even, labels, is_window)
    strange = cells.strange()
    if len(energies) == 1 or not strange.any():
        return strange
    near, *with_mosaic = (box_means(plane, (NEAR_CELLS,))[0] for plane in (mosaic, *products.values()))
    shared = dict(zip(products, with_mosaic))
    common = {
        (i, j): box_means(energies[i] if i == j else sums.between(i, j), (NEAR_CELLS,))[0]
        for i, j in combinations_with_replacement(energies, 2)
    }
    mixed = left_over.copy()
    for count in (2, 3):  # a mixture of some that are given is nothing strange
        for some in combinations(energies, count):
            pairs = combinations_with_replacement(some, 2)
            by_some = _left_by(near, [shared[i] for i in some], [common[pair] for pair in pairs])
            np.minimum(mixed, by_some, out=mixed)
    if _is_explained(wide, mixed, textured):
        return np.zeros_like(strange)
    # What weights that change within a square leave over of a mixture is as much as of one that stands in.
    cells = replace(cells, left_over=mixed, sharp=sharp & (mixed > _MIXED_LEFT * left_over))
    return cells.strange(interpolated)


@dataclass(frozen=True, eq=False)
class _Cells:
    """What sources leave over of a mosaic's fine detail; (cell rows, cell columns) each."""

    wide: np.ndarray
    """Energy of the mosaic, over the wide squares."""
    left_over: np.ndarray
    """What is left over of that."""
    textured: np.ndarray
    """bool: what is told at all."""
    sharp: np.ndarray
    """bool: where a source may stand in for another."""
    even: np.ndarray
    """bool: of which much is left over not only along a line."""
    labels: np.ndarray
    """uint8: the source that is followed."""
    is_window: bool
    """A part of a block has too little ground to say that it is of no given source."""

    def strange(self, interpolated: Collection[int] = ()) -> np.ndarray:
        """Parts that no source explains, (cell rows, cell columns) bool; those that lie between the mosaic's pixels are
        judged by their own ground."""
        stand_ins, parts = self._stand_ins(), np.zeros_like(self.textured)
        numbers = frozenset(present(self.labels))
        for group in filter(None, (numbers.difference(interpolated), numbers.intersection(interpolated))):
            parts |= self._strange_parts(is_one_of(self.labels, group), stand_ins)
        return parts

    def _stand_ins(self) -> np.ndarray:
        """Cells where a source stands in for another of the same ground, (cell rows, cell columns) bool: it leaves over
        many times as much as it does on its own best ground, or all over its part as much more than the others do on
        theirs, and unevenly. One that was resampled leaves over evenly what is finest."""
        stand_ins = np.zeros_like(self.sharp)
        sharp, wide, left_over = self.sharp, self.wide, self.left_over
        if not opened(sharp & self.even & (left_over > MIN_STAND_IN_STRANGE * wide), _ALIKE_CELLS).any():
            return stand_ins
        parts = {number: sharp & (self.labels == number) for number in present(self.labels)}
        grounds = {number: learn_best_ground(wide[cells_of], left_over[cells_of]) for number, cells_of in parts.items()}
        for number, ground in grounds.items():
            if ground is None:
                continue
            part = parts[number]
            stand_ins |= part & ground.strangeness(wide, left_over, MIN_STAND_IN_STRANGE, MIN_STAND_IN_FACTOR)[1]
            # A seam leaves something over along itself.
            inside = part & narrowed(self.labels == number, WIDE_CELLS // 2 + 1)
            if inside.any() and np.median(expected := ground.response(wide[inside])) >= MIN_STAND_IN_STRANGE:
                others = [other for other in parts if other != number]
                rest = sharp & (self.labels != number)
                best = grounds[others[0]] if len(others) == 1 else learn_best_ground(wide[rest], left_over[rest])
                if best is not None and _is_nowhere_true(expected, best, wide[inside], left_over[inside]):
                    stand_ins |= part & (left_over > MIN_STAND_IN_STRANGE * wide)
        return stand_ins

    def _strange_parts(self, of: np.ndarray, stand_ins: np.ndarray) -> np.ndarray:
        """Parts of which more is left over of the mosaic's energy than true sources leave, (cell rows, cell columns)
        bool, and evenly. Images that resemble the true one are told as well, ``stand_ins`` are such."""
        textured, wide, left_over = self.textured & of, self.wide, self.left_over
        seen = textured & self.even
        certain = seen & stand_ins
        could_be = opened(seen & (left_over > MIN_STRANGE * wide), _STRIP_CELLS).any()
        if not could_be:
            could_be = opened(certain | (seen & (left_over > MIN_ALIKE_STRANGE * wide)), _ALIKE_CELLS).any()
        if not could_be and not (self.is_window and _is_much_left(wide, left_over, textured)):
            return np.zeros_like(seen)  # whatever true sources leave over
        ground = learn_best_ground(wide[textured], left_over[textured])
        if ground is None:
            return np.zeros_like(textured)
        if self.is_window and ground.is_of_none():
            return textured
        strange, alike = ground.strangeness(wide, left_over)
        parts = opened(seen & (strange > MIN_STRANGE), _STRIP_CELLS)
        inside = ndimage.binary_propagation(opened(certain, _ALIKE_CELLS), mask=certain)
        parts |= opened(seen & alike, _ALIKE_CELLS) | inside
        if not parts.any():
            return parts
        parts = _to_borders(parts, strange) | narrowed(inside, WIDE_CELLS // 2 + 1)
        return without_islands(parts.view(np.uint8), SMALLEST_PART_PX // CELL_PX**2) > 0


def _is_nowhere_true(expected: np.ndarray, others: BestGround, energy: np.ndarray, left_over: np.ndarray) -> bool:
    """Whether a source stands in for another wherever it is followed, by the mosaic's energy there, what is left and
    what share it leaves over on its own best ground."""
    of_others = others.response(energy)
    if np.mean(expected >= np.maximum(_FOREIGN_LEFT, _FOREIGN_FACTOR * of_others)) >= 0.5:
        return True
    is_more = expected >= np.maximum(MIN_STAND_IN_STRANGE, _NOWHERE_FACTOR * of_others)
    low, high = np.quantile(left_over / (expected * energy), (0.25, 0.75))
    return bool(is_more.mean() >= 0.5 and high >= _NOWHERE_SPREAD * low)


def _is_explained(wide: np.ndarray, left_over: np.ndarray, textured: np.ndarray) -> bool:
    """Whether nothing could be strange, whatever true sources leave over: the usual window, in a tenth of the time."""
    much = (textured & (left_over > least * wide) for least in (MIN_STRANGE, MIN_STAND_IN_STRANGE))
    if any(opened(cells, side).any() for cells, side in zip(much, (_STRIP_CELLS, _ALIKE_CELLS))):
        return False
    return not _is_much_left(wide, left_over, textured)


def _is_much_left(wide: np.ndarray, left_over: np.ndarray, textured: np.ndarray) -> bool:
    """Whether not even the best ground may be of a given source."""
    return np.count_nonzero(textured & (left_over > MIN_EVEN_LEFT / 2 * wide)) * 2 >= np.count_nonzero(textured)


def _to_borders(cells: np.ndarray, strange: np.ndarray) -> np.ndarray:
    """Parts without the blur of their borders: up to where half of a wide square is within them."""
    for _ in range(3):  # the blur is in what is found first
        parts, count = ndimage.label(cells)
        if not count:
            break
        boxes = enumerate(ndimage.find_objects(parts), 1)
        inside = np.clip([np.median(strange[box][parts[box] == number]) for number, box in boxes], 0, 1)
        # A share is the square of a correlation, and that is what is halfway.
        halfway = np.concatenate([[np.inf], 1 - (0.5 + 0.5 * np.sqrt(1 - inside)) ** 2])
        cells = strange > halfway[parts]
    return cells


def _left_by(mosaic: np.ndarray, shared: Sequence[np.ndarray], common: Sequence[np.ndarray]) -> np.ndarray:
    """What a mixture of some sources leaves over of the mosaic's energy, over the wide squares; its weights, all of
    which are above zero, are even within the near ones. Means over those: of the ``mosaic``, ``shared`` of each
    with it, ``common`` of each with itself and those after it."""
    count = len(shared)
    normal: dict[tuple[int, int], np.ndarray] = {}
    for (row, column), products in zip(combinations_with_replacement(range(count), 2), common):
        normal[row, column] = products.astype(np.float64)
        if row == column:
            normal[row, row] += LEAST_ENERGY * CELL_PX**2
    # By elimination, as ``solve`` has it, in a fifth of the time.
    rest = [products.astype(np.float64) for products in shared]
    for row in range(count):
        for below in range(row + 1, count):
            factor = normal[row, below] / normal[row, row]
            for column in range(below, count):
                normal[below, column] -= factor * normal[row, column]
            rest[below] -= factor * rest[row]
    for row in reversed(range(count)):
        for column in range(row + 1, count):
            rest[row] -= normal[row, column] * rest[column]
        rest[row] /= normal[row, row]
    explained = sum(weight * products for weight, products in zip(rest, shared))
    all_above = np.logical_and.reduce([weight > 0 for weight in rest])
    left_over = np.where(all_above, np.maximum(mosaic - explained, 0), mosaic)
    return box_means(left_over, (WIDE_CELLS - NEAR_CELLS + 1,))[0]
