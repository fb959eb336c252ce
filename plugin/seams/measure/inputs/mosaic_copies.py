"""Sources that were made from the mosaic instead of the other way round: they would explain all of it, and hide all."""
from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from ....imagery.clips import MAX_OVERVIEW_PIXELS, read_clip
from ....imagery.errors import Message, RasterError
from ....imagery.gdal_paths import vrt_parts
from ....imagery.grids import Extent, Grid, PixelWindow
from ....imagery.limits import measured_bands
from ....imagery.open_raster import OpenRaster, placed
from ....imagery.raster_pool import RasterPool
from ....imagery.rasters import Raster, RasterRef
from ....imagery.reference_systems import same_coordinates
from ..following.followed_source import high_pass
from ..following.source_filters import filtered, fit_filter
from ..source_images import Source, is_same_file, sources_in
from . import messages

SIDE_PX = 64  # of a patch that is compared
PLACES = 16
"""Along each side of the mosaic, where so many have room: what follows another source on 1 % of it is missed once in
thirteen times."""
EXPLAINED_PLACES = 6  # along each side of the mosaic, where the other sources are tried
FEWEST_PLACES = 4  # along each side
FEWEST = 4  # patches with content, without which nothing is said
SAME_PLACE = 0.9  # of the mosaic, that a copy of it or of what it was cut from covers
THINNED = 4  # pixels of an overview that are averaged, as its grid may be off the mosaic's by part of a pixel
MOST_READ_PX = 1024  # side of what is read of the mosaic at one place
# Correlations of differences between neighbours, Brighton, smallest and median of all places. Overviews: 0.84 and 0.96
# or more (two images of one ground, pixels averaged as much: 0.53 and 0.88 or less). Copies by JPEG 75: 0.33 and 0.80
# (two images: -0.16 and 0.30; a mosaic and one of its sources: -0.37 and 0.36).
LEAST_COARSER, MEDIAN_COARSER = 0.7, 0.93
LEAST_LIKE, MEDIAN_LIKE = 0.3, 0.6
LEAST_BESIDE_EQUAL = 0.8  # where other places are equal, which no compression with loss leaves
MOST_SIZE_DIFFERENCE = 0.001  # of the pixels of a copy
PLAINLY, NEARLY_ALL = 2.0, 0.005  # times as much of the detail is lacking; and a share that rounding leaves
HARDLY_LACKING = 0.05  # of the detail: as much as an orthoimage loses when it is resampled
FEWEST_TURNS = 2  # places; one may be by chance
LEAST_DROP = 2.5  # where it is beaten an orthoimage lacks as many times what it lacks elsewhere, copies at most twice
LEAST_CONTENT = 2.0  # variance of differences between neighbours, DN squared: below it rounding counts


class Likeness(Enum):
    """What a source that lies where the mosaic lies is to it."""

    OTHER = "other"
    EQUAL = "equal"
    """In every pixel that was compared."""
    LIKE = "like"
    """Alike everywhere, as after compression with loss, or equal and with more around."""
    COARSER = "coarser"
    """Its pixels are larger, and made from the mosaic's or from what those were made of."""


def leave_out_copies(mosaic: Raster, sources: Sequence[Source]) -> tuple[list[Source], list[Message]]:
    """The sources without copies, overviews and VRTs of the mosaic, and what to tell of those.

    Only sources that cover the mosaic, all of it or nearly, are opened, and compared in 256 places, or in all of it
    where that has fewer. One that differs anywhere is none, nor is one that others beat where the mosaic turns to them:
    orthoimages of one flight or triplet are alike. One that is like it everywhere would explain all of the mosaic and
    hide every loss, if it was made from it; where the other sources do not explain the mosaic it is what that was cut
    from, and stays. So does the first one if there is no other source, and a notice says what that means.
    """
    kept: list[Source] = []
    copies: list[Source] = []
    alike: list[Source] = []
    notices: list[Message] = []
    with RasterPool(most=2) as pool:
        for source in sources:
            likeness = _likeness(mosaic, source, pool)
            if likeness is Likeness.OTHER:
                kept.append(source)
            elif likeness is Likeness.LIKE:
                alike.append(source)
            elif likeness is Likeness.EQUAL:
                copies.append(source)
            elif likeness is Likeness.COARSER:
                notices.append(messages.OVERVIEW_AMONG_SOURCES(name=source.ref.name))
        places = _places_with_content(mosaic, pool) if alike else []
        lacking = {one: _lacking(one, mosaic, places, pool) for one in (*kept, *alike)}
        turning = [
            one for one in alike if _takes_turns(own := lacking[one], [of for of in lacking.values() if of is not own])
        ]
        alike = [one for one in alike if one not in turning]
        known = {*kept, *turning}
        true = [one for one in sources if one in known]
        if alike and not _explain([lacking[one] for one in true if _has_judged_band(one, mosaic, pool)]):
            # Which of them the mosaic was cut from can't be told.
            true = [one for one in sources if one in known or one in alike]
        else:
            copies += alike
    if copies and not true:
        true.append(copies.pop(0))
        notices.append(messages.ONLY_SOURCE_IS_EQUAL(name=true[0].ref.name))
    return true, [*(messages.COPY_AMONG_SOURCES(name=copy.ref.name) for copy in copies), *notices]


def _likeness(mosaic: Raster, source: Source, pool: RasterPool) -> Likeness:
    if covered_share(mosaic.extent, source.extent) < SAME_PLACE:
        return Likeness.OTHER
    if is_made_of(source.ref, mosaic.ref):
        return Likeness.EQUAL
    try:
        other = pool.open(source.ref)
        raster = placed(other.raster)
        tolerance = 0.01 * mosaic.grid.pixel_width
        if not raster.is_north_up or not same_coordinates(raster.wkt, mosaic.wkt, mosaic.extent, tolerance):
            return Likeness.OTHER
        ratio = raster.grid.pixel_width / mosaic.grid.pixel_width
        if ratio < 1 - MOST_SIZE_DIFFERENCE:
            return Likeness.OTHER  # the mosaic may have been made of something finer
        return _compared(pool.open(mosaic.ref), mosaic, other, ratio > 1 + MOST_SIZE_DIFFERENCE)
    except RasterError:
        return Likeness.OTHER  # the scan says so where it needs it


def _compared(mosaic: OpenRaster, known: Raster, other: OpenRaster, coarser: bool) -> Likeness:
    """Raises RasterError when one of them can't be read."""
    names = [name for name in known.band_names if name in other.raster.band_names]
    if not names:
        return Likeness.OTHER
    mine = [known.band_names.index(name) for name in names]
    others = [other.raster.band_names.index(name) for name in names]
    least = LEAST_COARSER if coarser else LEAST_LIKE
    all_equal, found = not coarser, []
    for window, under in _places(other.raster.grid, known.grid):
        size = (max(window.width // THINNED, 1), max(window.height // THINNED, 1)) if coarser else None
        if under.width * under.height > MAX_OVERVIEW_PIXELS:
            return Likeness.OTHER  # so much finer is no mosaic of which somebody has an overview
        ours, theirs = mosaic.read(under, size, averaged=coarser), other.read(window, size, averaged=coarser)
        both = theirs.valid & ours.valid
        first, second = ours.bands[mine].astype(np.float64), theirs.bands[others].astype(np.float64)
        equal = bool((ours.valid == theirs.valid).all() and (first == second)[:, both].all())
        all_equal = all_equal and equal
        like = likeness_of(first, second, both)
        if not np.isnan(like):
            found.append(1.0 if equal else like)
            if found[-1] < least:
                return Likeness.OTHER
    if len(found) < FEWEST:
        return Likeness.OTHER
    if coarser:
        return Likeness.COARSER if np.median(found) >= MEDIAN_COARSER else Likeness.OTHER
    if all_equal and _same_place(other.raster.extent, known.extent, known.grid.pixel_width):
        return Likeness.EQUAL
    is_like = min(found) >= LEAST_BESIDE_EQUAL if max(found) == 1 else np.median(found) >= MEDIAN_LIKE
    return Likeness.LIKE if is_like else Likeness.OTHER


def _places(grid: Grid, mosaic: Grid) -> Iterator[tuple[PixelWindow, PixelWindow]]:
    """Windows of a raster with the pixels of the mosaic under them, one in each part of it, in no order."""
    scale_x, scale_y = grid.pixel_width / mosaic.pixel_width, grid.pixel_height / mosaic.pixel_height
    coarser = scale_x > 1 + MOST_SIZE_DIFFERENCE
    places = PLACES // 2 if coarser else PLACES
    side = max(int(min(4 * SIDE_PX, MOST_READ_PX / scale_x)), 8 * THINNED) if coarser else SIDE_PX
    first = (mosaic.left - grid.left) / grid.pixel_width, (grid.top - mosaic.top) / grid.pixel_height
    columns, rows = int(mosaic.columns / scale_x), int(mosaic.rows / scale_y)
    width, height = min(side, columns, grid.columns), min(side, rows, grid.rows)
    for row, column in _patches((rows, columns), (height, width), places):
        window = PixelWindow(round(first[0]) + column, round(first[1]) + row, width, height)
        if not grid.contains(window):
            continue
        left = (grid.left - mosaic.left) / mosaic.pixel_width + window.column * scale_x
        top = (mosaic.top - grid.top) / mosaic.pixel_height + window.row * scale_y
        under = PixelWindow(round(left), round(top), round(width * scale_x), round(height * scale_y))
        if mosaic.contains(under):
            yield window, under


def scattered(down: int, across: int | None = None) -> Iterator[np.ndarray]:
    """A place in each of so many by so many parts of a rectangle, in no order: how far down and across, 0 to 1."""
    counts = down, down if across is None else across
    rng = np.random.default_rng(0)
    for place in rng.permutation(counts[0] * counts[1]):
        yield (np.array(divmod(place, counts[1])) + rng.random(2)) / counts


def _patches(size: tuple[int, int], patch: tuple[int, int], most: int) -> Iterator[list[int]]:
    """Where patches of a rectangle begin, down and across: one in each of ``most`` parts along each side. Where fewer
    cover a side, they lie evenly from its one end to the other."""
    counts = [min(max(-(-whole // max(part, 1)), FEWEST_PLACES), most) for whole, part in zip(size, patch)]
    rooms = [whole - part for whole, part in zip(size, patch)]
    for shares in scattered(*counts):
        yield [
            int(share * (room + 1)) if count == most else int(share * count) * room // (count - 1)
            for share, room, count in zip(shares, rooms, counts)
        ]


def first_band(
    source: Source, mosaic: Raster, window: PixelWindow, pool: RasterPool
) -> tuple[np.ndarray, np.ndarray]:
    """Of a source in a window of the mosaic, (1, rows, columns) float64, and where it has pixels, (rows, columns) bool.

    Raises RasterError.
    """
    clip = read_clip(pool.open(source.ref), mosaic, window, partly=True)
    valid = np.ones(clip.bands.shape[1:], bool) if clip.valid is None else clip.valid
    return clip.bands[:1].astype(np.float64), valid


def likeness_of(
    first: np.ndarray, second: np.ndarray, valid: np.ndarray, least_content: float = LEAST_CONTENT
) -> float:
    """Correlation of the differences between neighbours in two stacks (bands, rows, columns), where both have pixels;
    nan where one of them shows no more than the least."""
    a, b = _differences(first, valid), _differences(second, valid)
    squares = a @ a, b @ b
    if not min(squares) > least_content * len(a):
        return np.nan
    return float(a @ b / np.sqrt(squares[0] * squares[1]))


def _differences(bands: np.ndarray, valid: np.ndarray) -> np.ndarray:
    with np.errstate(invalid="ignore", over="ignore"):  # of infinite values: such rasters are no copies of each other
        across, down = np.diff(bands, axis=2), np.diff(bands, axis=1)
    if not valid.all():
        across, down = across[:, valid[:, 1:] & valid[:, :-1]], down[:, valid[1:] & valid[:-1]]
    return np.concatenate([across.ravel(), down.ravel()])


def covered_share(first: Extent, second: Extent) -> float:
    """What a second rectangle has of the first, as a share of that; 0 where that has no area, as where its pixels are
    smaller than coordinates can tell apart."""
    width = min(first[2], second[2]) - max(first[0], second[0])
    height = min(first[3], second[3]) - max(first[1], second[1])
    area = (first[2] - first[0]) * (first[3] - first[1])
    return max(width, 0.0) * max(height, 0.0) / area if area > 0 else 0.0


def _same_place(first: Extent, second: Extent, tolerance: float) -> bool:
    return max(abs(a - b) for a, b in zip(first, second)) < tolerance


def _takes_turns(own: np.ndarray, others: Sequence[np.ndarray]) -> bool:
    """Whether one that is like the mosaic everywhere explains it best here, and there another one does and it lacks
    much more: it is an orthoimage, as no copy turns away from its mosaic. By what each lacks (``_lacking``)."""
    best = np.fmin.reduce([np.full_like(own, np.nan), *others])
    wins, is_beaten = best > PLAINLY * own + NEARLY_ALL, own > PLAINLY * best + NEARLY_ALL
    if min(np.count_nonzero(wins), np.count_nonzero(is_beaten)) < FEWEST_TURNS:
        return False
    lacking, others_lacking = float(np.median(own[wins])), float(np.median(best[is_beaten]))
    # A copy with loss beats the others along the seams only, where they are mixed and it lacks what the loss took.
    drops = float(np.median(own[is_beaten])) >= LEAST_DROP * lacking + NEARLY_ALL
    return drops and lacking + HARDLY_LACKING <= PLAINLY * (others_lacking + HARDLY_LACKING)


def _has_judged_band(source: Source, mosaic: Raster, pool: RasterPool) -> bool:
    """Whether a source can take part at all."""
    try:
        return mosaic.judged_band in measured_bands(pool.open(source.ref).raster.band_names)
    except RasterError:
        return False


def _explain(lacking: Sequence[np.ndarray]) -> bool:
    """Whether in most places one of the sources is like the mosaic, by what each lacks."""
    if not lacking:
        return False
    best = np.fmin.reduce(lacking)
    return 2 * int(np.count_nonzero(best <= 1 - MEDIAN_LIKE**2)) > len(best)


@dataclass(frozen=True, eq=False)
class _MosaicPlace:
    """A place of the mosaic."""

    window: PixelWindow
    values: np.ndarray
    """(1, rows, columns): its first band."""
    valid: np.ndarray


def _places_with_content(mosaic: Raster, pool: RasterPool) -> list[_MosaicPlace]:
    """Spread over the mosaic, those with content."""
    grid, opened, found = mosaic.grid, pool.open(mosaic.ref), []
    side = min(SIDE_PX, grid.columns, grid.rows)
    for row in np.linspace(0, grid.rows - side, EXPLAINED_PLACES).astype(int).tolist():
        for column in np.linspace(0, grid.columns - side, EXPLAINED_PLACES).astype(int).tolist():
            window = PixelWindow(column, row, side, side)
            ours = opened.read(window)
            values = ours.bands[:1].astype(np.float64)
            if ours.valid.mean() >= 0.5 and not np.isnan(likeness_of(values, values, ours.valid)):
                found.append(_MosaicPlace(window, values, ours.valid))
    return found


def _lacking(source: Source, mosaic: Raster, places: Sequence[_MosaicPlace], pool: RasterPool) -> np.ndarray:
    """Share of the mosaic's detail that a source does not explain, (places,); nan where it has hardly any pixels.

    Through a filter: one that was resampled into the mosaic explains it as well as one that lies on its pixels.
    """
    found = np.full(len(places), np.nan)
    for number, place in enumerate(places):
        if not sources_in([source], mosaic.grid.window_extent(place.window)):
            continue
        try:
            values, valid = first_band(source, mosaic, place.window, pool)
        except RasterError:
            continue
        both = place.valid & valid
        if both.mean() > 0.2:
            shown = _shown(place.values[0], values[0], both)[np.newaxis]
            found[number] = 1 - np.maximum(likeness_of(place.values, shown, both, 0.0), 0.0) ** 2
    return found


def _shown(mosaic: np.ndarray, source: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """A source as the mosaic shows it, (rows, columns); as it is where that can't be told."""
    own, its = (np.where(valid, one, one[valid].mean()).astype(np.float32) for one in (mosaic, source))
    taps = fit_filter(high_pass(own), high_pass(its), valid)
    return its if taps is None else filtered(its, taps)


def is_made_of(ref: RasterRef, mosaic: RasterRef) -> bool:
    """Whether a raster is a VRT that names the mosaic."""
    if not ref.path.lower().endswith(".vrt") or not os.path.isfile(ref.path):
        return False
    return any(is_same_file(RasterRef(part), mosaic) for part in vrt_parts(ref.path))
