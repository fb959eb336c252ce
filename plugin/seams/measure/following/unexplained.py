"""Ground that no given source explains: by the noise of each source where anything was compressed, else by the best
ground of all, which tells images that are nearly alike as well.
"""
from __future__ import annotations

from collections.abc import Collection, Sequence
from itertools import combinations, combinations_with_replacement

import numpy as np
from scipy import ndimage

from ..seam_cells import is_one_of, present
from .best_ground import MIN_ALIKE_STRANGE, MIN_EVEN_LEFT, MIN_STRANGE, learn_best_ground
from .boxes import SMALLEST_PART_PX, box_means, enlarged, opened, without_islands
from .compression import IsCompressed
from .followed_source import CELL_PX, LEAST_ENERGY, MIN_TEXTURED, NEAR_CELLS, WIDE_CELLS
from .foreign_ground import NOISE_CELL_PX, CellSums, foreign_ground

MIN_TEXTURE = 0.3  # of the energy that a source would have

_STRIP_CELLS = 4  # a side of the least part that no source explains: a seam leaves something over along itself
_ALIKE_CELLS = 12  # the same where a source does resemble it
_EVEN_PART, _EVEN_SHARE = 0.5, 0.4  # of what is left over around: most cells leave so much, of a step of tones few do


def unexplained_cells(
    sums: CellSums, is_compressed: IsCompressed, interpolated: Collection[int], is_window: bool
) -> np.ndarray:
    """Cells that the sources explain worse than true ones do, (cell rows, cell columns) bool.

    ``interpolated``: sources that lie between the mosaic's pixels, which are judged by ground of their own.
    ``is_window``: whether all of it may be of no given source; a part of a block has too little ground to say that.
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
    seen = textured & (box_means(rest * wide >= _EVEN_PART * left_over * mosaic, (WIDE_CELLS,))[0] >= _EVEN_SHARE)
    strange = _strange_parts(wide, left_over, textured, seen, is_window)
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
    numbers, parts = frozenset(present(labels)), np.zeros_like(strange)
    for group in filter(None, (numbers.difference(interpolated), numbers.intersection(interpolated))):
        of_group = is_one_of(labels, group)
        parts |= _strange_parts(wide, mixed, textured & of_group, seen & of_group, is_window)
    return parts


def _strange_parts(
    wide: np.ndarray, left_over: np.ndarray, textured: np.ndarray, seen: np.ndarray, is_window: bool
) -> np.ndarray:
    """Parts of which more is left over of the mosaic's energy than true sources leave, (cell rows, cell columns) bool;
    of images that resemble the true one, too.

    ``wide``: the mosaic's energy over the wide squares, ``left_over`` of it. ``textured``: what is told at all,
    ``seen``: of which much is left over not only along a line. ``is_window``: as in ``unexplained_cells``.
    """
    could_be = opened(seen & (left_over > MIN_STRANGE * wide), _STRIP_CELLS).any()
    could_be = could_be or opened(seen & (left_over > MIN_ALIKE_STRANGE * wide), _ALIKE_CELLS).any()
    if not could_be and not (is_window and _is_much_left(wide, left_over, textured)):
        return np.zeros_like(seen)  # whatever true sources leave over
    ground = learn_best_ground(wide[textured], left_over[textured])
    if ground is None:
        return np.zeros_like(textured)
    if is_window and ground.is_of_none():
        return textured
    strange, alike = ground.strangeness(wide, left_over)
    parts = opened(seen & (strange > MIN_STRANGE), _STRIP_CELLS) | opened(seen & alike, _ALIKE_CELLS)
    if not parts.any():
        return parts
    return without_islands(_to_borders(parts, strange).view(np.uint8), SMALLEST_PART_PX // CELL_PX**2) > 0


def _is_explained(wide: np.ndarray, left_over: np.ndarray, textured: np.ndarray) -> bool:
    """Whether nothing could be strange, whatever true sources leave over: the usual window, in a tenth of the time."""
    much = (textured & (left_over > least * wide) for least in (MIN_STRANGE, MIN_ALIKE_STRANGE))
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
