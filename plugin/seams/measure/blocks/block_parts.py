"""Parts of a block: pixel by pixel along its seams, and all of the ground between them, whose source patches tell."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy import ndimage

from ....imagery.grids import PixelWindow
from ....imagery.wavelets import placed_components
from ..following.boxes import enlarged, filled_in, narrowed, square_shares, square_sums
from ..following.expected_mosaic import Closeness, expected_mosaic
from ..following.followed_source import HIGH_PASS_PX
from ..following.levelling import TONE_PX, levelled, square_means
from ..following.likely_source import QUICK
from ..following.placed_sources import PlacedSources, follow_given, follow_sources
from ..following.source_filters import known_filters
from ..profile.cell_table import CELL_PX, CellTable, MixtureTable
from ..profile.detail_sums import MeetingSources, compared_planes, detail_sums, energy_of_rounding
from ..seam_cells import UNKNOWN, is_one_of, present
from .block_grid import LABEL_PX, MARGIN_PX, SQUARE_PX, UNIT_PX, ScanSettings
from .block_pixels import BlockPixels
from .patches import PATCH_PX, SquareLook

SAMPLED = np.s_[LABEL_PX // 2 :: LABEL_PX, LABEL_PX // 2 :: LABEL_PX]
"""Pixels whose labels are kept."""
MIN_LIKELY = 0.9  # of a window: with more there is no part that is guessed
MIN_SURE = 0.3  # of a part of one source; true ones have 0.56 or more after JPEG 75, guessed ones 0.25 or less
MIN_VALID = 0.02  # of a part's pixels: with less there is nothing to be measured


@dataclass(frozen=True, eq=False)
class DensePart:
    """What was measured in a rectangle of whole squares."""

    window: PixelWindow
    """On the mosaic's grid, without margins."""
    planes: dict[str, np.ndarray]
    """(rows, columns) each: ``labels``, ``mixture``, ``grey`` and ``grain`` as ``BlockScan`` has them, and ``valid``,
    bool as the labels: where the mosaic has pixels."""
    cells: CellTable
    beside: MixtureTable
    """What is mixed of what along its seams."""
    unexplained: float
    """Share of the mosaic's valid pixels that no source explains."""


def measure_part(
    pixels: BlockPixels, window: PixelWindow, numbers: Sequence[int], taps: Mapping[int, np.ndarray],
    settings: ScanSettings,
) -> DensePart:
    """Measure a rectangle of a block, on the mosaic's grid, by some sources of the block; ``taps``: filters of those of
    which it is known what came over them. Raises RasterError where the mosaic can't be read."""
    around, levels = window.with_margin(MARGIN_PX), settings.levels
    planes = pixels.part(around, numbers)
    inside = np.s_[MARGIN_PX : MARGIN_PX + window.height, MARGIN_PX : MARGIN_PX + window.width]
    given = tuple(planes.sources)
    image = planes.mosaic
    known = np.ones(image.plane.shape, bool) if image.valid is None else image.valid
    valid = known[inside]
    if not given or valid.mean() < MIN_VALID:
        nothing = np.zeros((window.height // CELL_PX, window.width // CELL_PX), np.float32)
        planes_by_name = {
            "labels": np.full(valid[SAMPLED].shape, UNKNOWN, np.uint8), "valid": valid[SAMPLED], "mixture": nothing,
            "grey": nothing, "grain": np.full_like(nothing, np.nan),
        }
        return DensePart(
            window, planes_by_name, CellTable.empty(levels), MixtureTable.empty(levels), float(valid.any())
        )
    filters = known_filters(taps, given)
    if filters is not None and filters.taps:
        followed = follow_given(image, list(planes.sources.values()), filters)
    else:
        followed = follow_sources(image, list(planes.sources.values()))
    closeness = Closeness(QUICK, PATCH_PX, bool(planes.resampled))
    expected = expected_mosaic(followed, filters, closeness).of_sources(given)
    labels, likely, mixed = expected.labels, followed.following.likely, followed.following.mixed
    guessed = known & guesses(labels, likely | mixed)
    labels = np.where(guessed, np.uint8(UNKNOWN), labels)
    details = list(placed_components(compared_planes(expected.filling(image), expected), settings.wavelet, levels))
    sources = MeetingSources.of(replace(expected, labels=labels))
    cells, beside = detail_sums(details, sources, energy_of_rounding(image.plane))
    labels = filled_in(labels, guessed)
    margin = MARGIN_PX // CELL_PX
    place = np.s_[margin : margin + window.height // CELL_PX, margin : margin + window.width // CELL_PX]
    first = around.row // CELL_PX, around.column // CELL_PX
    planes_by_name = {
        "labels": labels[inside][SAMPLED], "valid": valid[SAMPLED],
        "mixture": square_shares(mixed[inside], CELL_PX), "grey": square_shares(image.plane[inside], CELL_PX),
        "grain": _grain(followed, known)[place],
    }
    unexplained = np.count_nonzero((labels[inside] == UNKNOWN) & valid) / np.count_nonzero(valid)
    tables = cells.within(place).moved(*first), beside.within(place).moved(*first)
    return DensePart(window, planes_by_name, *tables, unexplained)


def _grain(sources: PlacedSources, known: np.ndarray) -> np.ndarray:
    """Largest rms of the finest detail of the mosaic or its sources in every cell, (rows, columns) of cells: what was
    smoothed in the sources alone is no even ground. NaN where the mosaic has no pixels, ``known``, since what fills it
    there makes a step, and where no source has, which says nothing of detail."""
    squares, everywhere = [], narrowed(known, HIGH_PASS_PX)
    for number, fine in enumerate(sources.fine[1:]):
        inner = narrowed(known & sources.valid[number], HIGH_PASS_PX) if number in sources.valid else everywhere
        seen = square_shares(inner, CELL_PX) * CELL_PX**2
        total = square_sums(fine, fine if inner.all() else fine * inner, CELL_PX)
        squares.append(np.divide(total, seen, out=np.full(seen.shape, np.nan, np.float32), where=seen > 0))
    of_sources, of_mosaic = np.fmax.reduce(squares), square_sums(sources.fine[0], sources.fine[0], CELL_PX) / CELL_PX**2
    return np.sqrt(np.maximum(of_sources, of_mosaic))


def guesses(labels: np.ndarray, likely: np.ndarray) -> np.ndarray:
    """Parts, (rows, columns) bool, that hardly follow a source for sure: compression or smooth ground hide it."""
    if np.count_nonzero(likely) >= MIN_LIKELY * likely.size:
        return np.zeros(labels.shape, bool)
    coarse, sure = labels[::LABEL_PX, ::LABEL_PX], likely[::LABEL_PX, ::LABEL_PX]
    unsure = np.zeros(coarse.shape, bool)
    for number in np.unique(coarse[coarse != UNKNOWN]).tolist():
        parts, count = ndimage.label(coarse == number)
        shares = [1.0, *ndimage.mean(sure, parts, np.arange(1, count + 1))]
        unsure |= (np.array(shares) < MIN_SURE)[parts]
    return enlarged(unsure, LABEL_PX)


BLOCK_MARGIN_PX = 32
"""Around a block: the finest details of its outermost cells need to know so much."""


def measure_plain(
    pixels: BlockPixels, look: SquareLook, dense: np.ndarray, wavelet: str, levels: int
) -> CellTable:
    """The cells of a block but for its ``dense`` units, (rows, columns) bool, in cells of the mosaic.

    Their finest level only: the picture of losses shows no other. Every square is measured by the source that its patch
    follows. Raises RasterError where the mosaic can't be read.
    """
    block = pixels.window
    rows, columns = -(-block.height // SQUARE_PX) * SQUARE_PX, -(-block.width // SQUARE_PX) * SQUARE_PX
    window = replace(block, width=columns, height=rows).with_margin(BLOCK_MARGIN_PX)
    source = np.where(is_one_of(look.source, look.learned.taps), look.source, np.uint8(UNKNOWN))
    numbers = present(source)
    if not numbers:
        return CellTable.empty(levels)
    planes = pixels.part(window, numbers)
    labels = np.pad(enlarged(source, SQUARE_PX), BLOCK_MARGIN_PX, mode="edge")
    means, made = square_means(planes.mosaic.plane), planes.mosaic.plane.copy()
    is_followed, places = np.zeros(labels.shape, bool), ndimage.find_objects(labels.astype(np.int32) + 1)
    for number, image in planes.sources.items():
        place = places[number]
        squares = tuple(slice(part.start // TONE_PX, part.stop // TONE_PX) for part in place)
        here = labels[place] == number
        for valid in (image.valid, planes.mosaic.valid):
            here &= True if valid is None else valid[place]
        if here.any():
            in_tone = levelled(means[squares], image.plane[place], here, here, PATCH_PX // TONE_PX)
            np.copyto(made[place], look.learned.applied(number, in_tone.plane), where=here)
            is_followed[place] |= here
    inside = np.s_[BLOCK_MARGIN_PX:-BLOCK_MARGIN_PX, BLOCK_MARGIN_PX:-BLOCK_MARGIN_PX]
    known = square_shares(is_followed[inside], CELL_PX) == 1
    measured = enlarged(dense, UNIT_PX // CELL_PX)
    known[: measured.shape[0], : measured.shape[1]] &= ~measured
    finest = np.s_[:, 0, BLOCK_MARGIN_PX // 2 : -BLOCK_MARGIN_PX // 2, BLOCK_MARGIN_PX // 2 : -BLOCK_MARGIN_PX // 2]
    # One by one: arrays of more than 32 MB would be taken from the system every time.
    m, c = (next(placed_components(plane[np.newaxis], wavelet, 1))[finest] for plane in (planes.mosaic.plane, made))
    sums = np.stack([
        np.sum([square_sums(*both, CELL_PX // 2) for both in zip(a, b)], axis=0)[np.newaxis]
        for a, b in ((m, m), (c, c), (m, c))
    ])
    cell_rows, cell_columns = (
        first // CELL_PX + np.arange(length) for first, length in zip((block.row, block.column), known.shape)
    )
    return CellTable.far(cell_rows, cell_columns, known, sums, levels)
