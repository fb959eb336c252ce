"""A sparse look at a block: a patch in every square of 128 px tells which source is followed there.

Where a patch is unsure of it, or its neighbours follow another source, the squares are measured densely.
"""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np
from scipy import ndimage

from ....imagery.wavelets import placed_components
from ..following.boxes import enlarged, in_squares, opened
from ..following.compression import IsCompressed, compressed_sides, was_compressed
from ..following.expected_mosaic import mosaic_of
from ..following.followed_source import (
    LEAST_ENERGY,
    MIN_MIXTURE_FIT,
    MIN_TEXTURED,
    MIN_WINNER_LEAD,
    high_pass,
    highest,
    is_likelier,
    is_sure,
    local_correlation,
    mixtures,
)
from ..following.foreign_ground import foreign_patches
from ..following.likely_source import MIN_FIT
from ..following.source_filters import MAX_LEFT_UNFILTERED, UNTOUCHED, Learned, best_filter, filtered
from ..profile.cell_table import CELL_PX, CellTable
from ..seam_cells import UNKNOWN, present
from .block_grid import SQUARE_PX
from .block_pixels import MOST_HELD, BlockPixels, Planes

PATCH_PX = 40
"""Side of a patch."""
PATCH_START_PX = 36
"""Its first pixel in its square: its middle cell of 16 px is one of the block's."""

MIN_QUARTER_FIT = 0.15  # of a quarter's: strangers reach 0.1 there by chance
_INNER = slice(4, 36)  # of a patch: what its high-pass knows
_KNOWN = slice(6, 34)  # of a patch: what a filter may be learned from
_CELL = slice(12, 12 + CELL_PX)  # of a patch: its middle
_STRANGE_SQUARES = 2  # a side of what lies together, so that one patch alone condemns nothing
_MIN_VALID = 0.98  # of a patch
_FARTHEST_FILLED = 1.5  # squares
_MANY = 100  # patches
_ROUNDS = 3  # in which a filter is learned without the patches that it explains worst
_OUTLYING = 3.0  # times what is left over of most patches
UNLEARNED = Learned({}, {})
"""What is learned where no patch tells anything."""


@dataclass(frozen=True, eq=False)
class SquareLook:
    """What the patches of a block say, each (rows, columns) of squares."""

    source: np.ndarray
    """uint8: number of the source that is followed, ``UNKNOWN`` where none explains it or there are no pixels."""
    doubtful: np.ndarray
    """bool: where a patch shows more than one source, or none for sure."""
    cells: CellTable
    """One cell of each patch that follows one source for sure, finest level only."""
    learned: Learned = UNLEARNED
    """What came over the mosaic here."""
    plain: np.ndarray | bool = False
    """bool: those whose patch has no texture to tell a source by."""


def look_at_squares(pixels: BlockPixels, wavelet: str, levels: int) -> SquareLook:
    """The patches of a block that was read as a whole."""
    rows, columns = (_starts(length) for length in (pixels.window.height, pixels.window.width))
    shape = len(rows), len(columns)
    planes = pixels.patches(rows, columns, PATCH_PX)
    with_patch = _share(planes.mosaic.valid, shape) >= _MIN_VALID
    empty = np.zeros(shape, bool)
    if pixels.valid is not None:
        firsts = [np.arange(0, length, SQUARE_PX) for length in pixels.valid.shape]
        has_any = np.logical_or.reduceat(np.logical_or.reduceat(pixels.valid, firsts[0], axis=0), firsts[1], axis=1)
        empty = ~with_patch & ~has_any
    if not planes.sources or empty.all():
        nothing = np.full(shape, UNKNOWN, np.uint8)
        return SquareLook(nothing, np.zeros(shape, bool), CellTable.empty(levels))
    fine = high_pass(planes.mosaic.plane)
    fines = {i: high_pass(source.plane) for i, source in planes.sources.items()}
    patches = _patches(fine, fines, planes, with_patch, empty)
    if not patches.sampled.any():
        nothing = CellTable.empty(levels)
        return SquareLook(patches.source, patches.doubtful, nothing, plain=_is_plain(fine, shape))

    def cells_of(patches: _Patches) -> tuple[CellTable, Learned]:
        sampled = np.where(patches.sampled, patches.source, np.uint8(UNKNOWN))
        return _cells(planes, sampled, (rows, columns), wavelet, levels)

    mosaic_was = was_compressed(planes.mosaic.plane)
    is_compressed = compressed_sides(mosaic_was, lambda number: planes.sources[number].plane, fines)
    shown, supposed = fines, dict[int, np.ndarray]()
    if patches.share_left > MAX_LEFT_UNFILTERED:  # what came over the mosaic made it unlike its sources
        supposed = _best_filters(fine, fines, planes, shape)
        shown = {i: filtered(plane, supposed[i]) if i in supposed else plane for i, plane in fines.items()}
        patches = _patches(fine, shown, planes, with_patch, empty)
    cells, learned = cells_of(patches)
    if not learned.is_plain:
        shown = {i: learned.applied(i, plane) if i in learned.taps else shown[i] for i, plane in fines.items()}
        patches = _patches(fine, shown, planes, with_patch, empty)
        cells, learned = cells_of(patches)
    # What was warped is explained as badly as by another image.
    strangers = patches.strangers(is_compressed) & ~np.isin(patches.source, list(planes.resampled))
    if strangers.any():
        patches = replace(
            patches, source=np.where(strangers, np.uint8(UNKNOWN), patches.source),
            doubtful=patches.doubtful & ~strangers, sampled=patches.sampled & ~strangers,
        )
        cells, learned = cells_of(patches)
    learned = Learned({**supposed, **learned.taps}, {**dict.fromkeys(supposed, 1.0), **learned.left_over})
    return SquareLook(patches.source, patches.doubtful, cells, learned, plain=_is_plain(fine, shape))


@dataclass(frozen=True, eq=False)
class _Patches:
    """What patches say, each (rows, columns)."""

    source: np.ndarray
    """uint8: as in ``SquareLook``."""
    sure: np.ndarray
    """bool: where it is that one for sure, and nothing else."""
    doubtful: np.ndarray
    """bool: where a dense look is called for."""
    sampled: np.ndarray
    """bool: those that follow one source, and so clearly that they are not mixed with the next. Not those alone that
    tell it best: smooth ground comes over otherwise."""
    energy: np.ndarray
    """Energy of the mosaic, DN squared, 0 where it shows nothing to tell a source by."""
    left_over: np.ndarray
    """What the sources leave over of it, alone or mixed."""

    @property
    def share_left(self) -> float:
        """Share of the mosaic's fine detail that they leave over."""
        return float(self.left_over[self.energy > 0].sum() / max(self.energy.sum(), 1e-9))

    def strangers(self, is_compressed: IsCompressed) -> np.ndarray:
        """bool: of an image that isn't given, where so much lies together that it is no chance; where nothing was
        compressed also one that a given one resembles."""
        foreign, alike = foreign_patches(self.energy, self.left_over, self.source, is_compressed)
        strangers = opened(foreign & ~self.doubtful, _STRANGE_SQUARES)
        return strangers if is_compressed(None) else strangers | opened(alike, _STRANGE_SQUARES)


def _patches(
    fine: np.ndarray, fines: dict[int, np.ndarray], planes: Planes, with_patch: np.ndarray, empty: np.ndarray
) -> _Patches:
    shape = with_patch.shape[0], with_patch.shape[1]
    followed = _followed(fine, fines, planes, shape)
    winner = np.where(with_patch, followed.source, np.uint8(UNKNOWN))
    doubtful, sure = followed.doubtful & with_patch, followed.sure & with_patch
    silent = ~empty & (~with_patch | (_is_plain(fine, shape) & (winner == UNKNOWN) & ~doubtful))
    filled, alone, known = winner, silent, winner != UNKNOWN
    if silent.any() and known.any():  # squares that say nothing follow what is nearest to them
        distance, (row, column) = ndimage.distance_transform_edt(~known, return_indices=True)
        filled, alone = np.where(silent, winner[row, column], winner), silent & (distance > _FARTHEST_FILLED)
    doubtful |= alone & ~with_patch
    sampled = followed.sampled & with_patch & ~doubtful & (filled != UNKNOWN) & sure.any()
    energy = np.where(with_patch, followed.energy, 0)
    return replace(followed, source=filled, sure=sure, doubtful=doubtful, sampled=sampled, energy=energy)


def middle_sources(pixels: BlockPixels, look: SquareLook, axis: int) -> np.ndarray:
    """Between squares that follow different sources a patch midway: the source that it follows for sure,
    ``UNKNOWN`` where it follows none for sure or the squares do not differ.

    ``axis`` 1: of each square and the next one to the right, (rows, columns - 1) uint8; 0: downwards.
    """
    here, there = (np.s_[:, :-1], np.s_[:, 1:]) if axis else (np.s_[:-1], np.s_[1:])
    source = look.source
    middles = np.full(source[here].shape, UNKNOWN, np.uint8)
    held = source < MOST_HELD
    differ = (source[here] != source[there]) & held[here] & held[there]
    squares = np.argwhere(differ)
    starts = squares * SQUARE_PX + PATCH_START_PX
    starts[:, axis] += SQUARE_PX // 2
    last = np.array([pixels.window.height, pixels.window.width]) - PATCH_PX
    squares, starts = (kept[(starts <= last).all(axis=1)] for kept in (squares, starts))
    if not len(squares):
        return middles
    planes = pixels.strip_of_patches(starts[:, 0], starts[:, 1], PATCH_PX)
    shape = len(squares), 1
    valid = _share(planes.mosaic.valid, shape) >= _MIN_VALID
    fines = {i: high_pass(source.plane) for i, source in planes.sources.items()}
    fines = {i: look.learned.applied(i, fine) for i, fine in fines.items()}
    followed = _followed(high_pass(planes.mosaic.plane), fines, planes, shape)
    middles[tuple(squares.T)] = np.where(followed.sure & valid, followed.source, UNKNOWN)[:, 0]
    return middles


def _best_filters(
    fine: np.ndarray, fines: Mapping[int, np.ndarray], planes: Planes, shape: tuple[int, int]
) -> dict[int, np.ndarray]:
    """Taps (5, 5) of each source by the half of its patches that it explains best."""
    inside = _known_pixels(shape)
    filters = {}
    for number, plane in fines.items():
        valid = _share(planes.sources[number].valid, shape) >= _MIN_VALID
        taps = best_filter(fine, plane, enlarged(valid, PATCH_PX) & inside, PATCH_PX)
        if taps is not None:
            filters[number] = taps
    return filters


def _known_pixels(shape: tuple[int, ...]) -> np.ndarray:
    """Pixels of so many rows and columns of patches that a filter may be learned from, bool."""
    known = np.zeros(PATCH_PX, bool)
    known[_KNOWN] = True
    return np.outer(np.tile(known, shape[0]), np.tile(known, shape[1]))


def _starts(length: int) -> np.ndarray:
    """First row or column of every square's patch; the last square may be smaller, its patch lies within it or ends
    where the block does."""
    starts = np.arange(0, length, SQUARE_PX) + PATCH_START_PX
    last = (length - PATCH_PX - PATCH_START_PX) // CELL_PX * CELL_PX + PATCH_START_PX
    return np.minimum(starts, last)


def _share(valid: np.ndarray | None, shape: tuple[int, int]) -> np.ndarray:
    if valid is None:
        return np.ones(shape)
    return np.asarray(in_squares(valid, PATCH_PX).mean(axis=(1, 3)))


def _quadrants(a: np.ndarray, b: np.ndarray, shape: tuple[int, int]) -> np.ndarray:
    """Sums of a x b over the four quarters of every patch, (4, rows, columns)."""
    rows, columns = shape
    # Whole rows first: a fifth of the time.
    inner = (plane.reshape(rows, PATCH_PX, -1)[:, _INNER].reshape(rows, 2, CELL_PX, -1) for plane in (a, b))
    down = np.einsum("apij,apij->apj", *inner).reshape(rows, 2, columns, PATCH_PX)[..., _INNER]
    return np.asarray(down.reshape(rows, 2, columns, 2, CELL_PX).sum(axis=4).transpose(1, 3, 0, 2).reshape(4, *shape))


def _followed(
    fine: np.ndarray, fines: dict[int, np.ndarray], planes: Planes, shape: tuple[int, int]
) -> _Patches:
    """What each patch follows: the source of highest correlation."""
    numbers = np.array(list(fines), np.uint8)
    least = LEAST_ENERGY * (CELL_PX**2)
    mosaic = _quadrants(fine, fine, shape) + least
    energies = np.stack([_quadrants(fine, fine, shape) for fine in fines.values()]) + least
    shared = np.stack([_quadrants(fine, source, shape) for source in fines.values()])
    shares = np.stack([_share(planes.sources[i].valid, shape) for i in fines])
    shared *= (shares >= _MIN_VALID)[:, np.newaxis]
    is_cut = ((shares < _MIN_VALID) & (shares > 1 - _MIN_VALID)).any(axis=0)
    whole_mosaic, whole_energies, whole_shared = mosaic.sum(axis=0), energies.sum(axis=1), shared.sum(axis=1)
    correlation = local_correlation(whole_mosaic, whole_energies, whole_shared)
    best, lead = highest(correlation)
    winner = numbers[best]
    top = correlation.max(axis=0)
    textured = whole_mosaic > MIN_TEXTURED * least
    explained = np.maximum(top, 0) ** 2
    fits, alone, by_next = textured & (explained >= MIN_FIT), 1 - explained, 1 - np.maximum(top - lead, 0) ** 2
    sure = fits & is_sure(top, lead)
    likelier = fits & is_likelier(alone, by_next, (_INNER.stop - _INNER.start) ** 2)
    quarters = local_correlation(mosaic, energies, shared)
    quarter, quarter_lead = highest(quarters)
    quarter_fit = np.maximum(quarters.max(axis=0), 0) ** 2
    clearly = (quarter_lead >= MIN_WINNER_LEAD) & (quarter_fit >= MIN_QUARTER_FIT) & (mosaic > MIN_TEXTURED * least)
    differs = ((quarter != best) & clearly).any(axis=0)
    images = list(fines.values())
    mixed_quarters, explained_by_two = mixtures(
        mosaic, dict(enumerate(energies)), dict(enumerate(shared)),
        lambda i, j: _quadrants(images[i], images[j], shape),
    )
    # Noise hides mixtures from a quarter; no more than single sources usually have is left over by one.
    mixed_wholes, _ = mixtures(
        whole_mosaic, dict(enumerate(whole_energies)), dict(enumerate(whole_shared)),
        lambda i, j: _quadrants(images[i], images[j], shape).sum(axis=0),
        MIN_MIXTURE_FIT * float(np.median(explained[textured])) if textured.any() else MIN_MIXTURE_FIT,
    )
    mixed = mixed_quarters.any(axis=0) | mixed_wholes
    strange = textured & (explained < MIN_FIT) & ~differs & ~mixed & ~is_cut  # a source that ends there may explain it
    doubtful = (textured & ~(sure | likelier) & ~strange) | differs | mixed
    left_over = (mosaic * (1 - np.maximum(quarter_fit, explained_by_two))).sum(axis=0)
    winner = np.where(sure | likelier | doubtful, winner, np.uint8(UNKNOWN))
    impure = likelier & ~sure
    energy = np.where(textured, whole_mosaic, 0)
    return _Patches(winner, sure & ~doubtful, doubtful, ~(doubtful | impure), energy, left_over)


def _is_plain(fine: np.ndarray, shape: tuple[int, int]) -> np.ndarray:
    """Patches without texture to tell a source by."""
    return np.asarray(_quadrants(fine, fine, shape).sum(axis=0) <= 4 * CELL_PX**2 * MIN_TEXTURED * LEAST_ENERGY)


def _cells(
    planes: Planes, followed: np.ndarray, starts: tuple[np.ndarray, np.ndarray], wavelet: str, levels: int
) -> tuple[CellTable, Learned]:
    """The middle cells of patches that follow one source for sure, and what came over the mosaic there.

    ``followed``: (rows, columns), ``UNKNOWN`` where none is sure. Of many patches every second on both sides will do.
    """
    step = 2 if followed.size >= _MANY else 1
    kept = [np.repeat(np.arange(count) % step == step // 2, PATCH_PX) for count in followed.shape]
    chosen = np.ix_(*kept)
    followed = followed[step // 2 :: step, step // 2 :: step]
    shape = followed.shape
    within = _known_pixels(shape)
    mosaic, cell = planes.mosaic.plane[chosen], slice(_CELL.start // 2, _CELL.stop // 2)
    for _ in range(_ROUNDS):
        numbers = present(followed)
        given = {i: planes.sources[i].plane[chosen] for i in numbers}
        expected, filters = mosaic_of(mosaic, given, enlarged(followed, PATCH_PX), within, PATCH_PX)
        (details,) = placed_components(np.stack([mosaic, expected]), wavelet, 1)
        details = details.reshape(3, 2, shape[0], PATCH_PX // 2, shape[1], PATCH_PX // 2)
        m, c = details[:, :, :, cell, :, cell].swapaxes(0, 1)
        mm, cc, mc = (np.einsum("daibj,daibj->ab", a, b) for a, b in ((m, m), (c, c), (m, c)))
        rest = mm - 2 * mc + cc
        outlying = _outlying(followed, mm, rest)
        if not outlying.any():
            break
        followed = np.where(outlying, np.uint8(UNKNOWN), followed)
    rows, columns = ((start[step // 2 :: step] + _CELL.start) // CELL_PX for start in starts)
    learned = Learned(
        {i: filters.taps.get(i, UNTOUCHED) for i in numbers},
        {i: _share_left(followed == i, mm, rest) for i in numbers},
    )
    sums = [products[np.newaxis] for products in (mm, cc, mc)]
    return CellTable.far(rows, columns, followed != UNKNOWN, sums, levels), learned


def _outlying(followed: np.ndarray, energy: np.ndarray, left_over: np.ndarray) -> np.ndarray:
    """Patches of which a source leaves far more over than of most of its own, bool: what was done to them was not done
    to all it shows. What is left over has a share of the energy and, where anything was rounded, a floor."""
    outlying = np.zeros(followed.shape, bool)
    for number in present(followed):
        of = followed == number
        share = max(_share_left(of, energy, left_over), MAX_LEFT_UNFILTERED)
        outlying |= of & (left_over > _OUTLYING * (share * energy + np.median(left_over[of])))
    return outlying


def _share_left(of: np.ndarray, energy: np.ndarray, left_over: np.ndarray) -> float:
    """Share of the energy that is left over of most of some patches."""
    return float(np.median(left_over[of] / np.maximum(energy[of], 1e-9)))
