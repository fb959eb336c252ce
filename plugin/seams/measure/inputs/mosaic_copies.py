"""Copies of a mosaic among its sources: they would explain all of it, and hide every loss.

A copy is valid wherever the mosaic is and follows it across the borders between other sources, and no true orthoimage
does. What only looks like one stays, and is told.
"""
from __future__ import annotations

import os
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from enum import Enum
from typing import NamedTuple

import numpy as np
from scipy import ndimage

from ....imagery.clips import read_clip
from ....imagery.errors import Message, NotCoveredError, RasterError
from ....imagery.gdal_paths import vrt_parts
from ....imagery.grids import Extent, PixelWindow
from ....imagery.raster_pool import RasterPool, file_stamp
from ....imagery.rasters import Raster, RasterRef
from ..following.followed_source import high_pass
from ..following.source_filters import filtered, fit_filter
from ..source_images import Footprints, Source, is_same_file
from . import messages
from .grey_values import grey_factor

SIDE_PX = 64  # of a patch that is compared
PLACES, FEWEST_PLACES = 12, 4  # along each side of the mosaic
MOST_READ_PX = 4096  # along each side, where it is averaged to larger pixels
FEWEST = 4  # patches with content, without which nothing is said
LEAST_COVER = 0.1  # of the mosaic, by a raster's rectangle: a copy may leave out empty ground, or be one of a part
MOST_THINNED = 16  # times larger pixels: an overview that is smaller still explains nothing
EDGE_PX = 2  # along nodata, where compression and resampling leave others
MOST_MISSING = 0.01  # of a patch, where the mosaic has pixels and another one has none
LEAST_BOTH = 0.9  # of a patch, where both have pixels: a filter is learned of no less
# Shares of the mosaic's detail that a source does not explain. Brighton, copies by JPEG 50: 0.5 in the median, above
# 0.91 in 4.6 % of the places; its orthoimages: 0.43 to 0.71, and 11 to 39 %.
MOST_LACKING, MEDIAN_LACKING = 0.91, 0.64
MOST_WEAK = 0.05  # of the places, where compression leaves less
LITTLE = 0.1  # more lacks another image of the ground; the nearest images of one pass lack 0.19 of each other
PLAINLY, NEARLY_ALL = 2.0, 0.005  # times as much of the detail is lacking; and a share that rounding leaves
HARDLY_LACKING = 0.05  # of the detail: as much as an orthoimage loses when it is resampled
FEWEST_TURNS = 2  # places; one may be by chance
LEAST_FOLLOWED = 0.4  # lower quartile of shares: copies and overviews 0.69 and more, other orthoimages 0.0 and less
LEAST_DROP = 2.5  # where it is beaten an orthoimage lacks as many times what it lacks elsewhere, copies at most twice
LEAST_CONTENT = 2.0  # variance of differences between neighbours, DN squared: below it rounding counts


class Likeness(Enum):
    """What a source is to the mosaic."""

    OTHER = "other"
    COPY = "copy"
    EQUAL = "equal"
    """The mosaic itself wherever it lies, and the other sources do not say whether it or the mosaic was first."""
    LIKE = "like"
    """Nearly so."""
    MOSAIC = "mosaic"
    """Another mosaic of the other sources, or a part of one."""
    TURNING = "turning"
    """Another source here and not there: it or that is a mosaic."""
    UNLIKE = "unlike"
    """Nothing of the mosaic in any place."""


_known: dict[object, dict[int, Likeness]] = {}
_MOST_KNOWN = 8  # judgements of this process that are known again


def leave_out_copies(mosaic: Raster, sources: Sequence[Source]) -> tuple[list[Source], list[Message]]:
    """The sources without copies, overviews and VRTs of the mosaic, and what to tell of those and of doubtful ones."""
    likeness = likenesses(mosaic, sources)
    copies, equal, like = (
        [n for n, one in likeness.items() if one is of] for of in (Likeness.COPY, Likeness.EQUAL, Likeness.LIKE)
    )
    if len(copies) == len(sources) > 0:  # nothing could be said without any
        equal.append(copies.pop(0))
    left_out, doubtful = set(copies), {*equal, *like}
    return [replace(one, may_be_copy=n in doubtful) for n, one in enumerate(sources) if n not in left_out], [
        *(messages.COPY_AMONG_SOURCES(name=sources[n].ref.name) for n in copies),
        *(messages.MAY_BE_COPY(name=sources[n].ref.name) for n in equal),
        *(messages.MAY_BE_ALTERED_COPY(name=sources[n].ref.name) for n in like),
    ]


def likenesses(mosaic: Raster, sources: Sequence[Source]) -> dict[int, Likeness]:
    """What each source that is like the mosaic wherever it lies is to it, by number.

    Sources on a tenth of the mosaic or more are opened and compared with it in up to 144 places. What is judged is
    known again while the files are the same.
    """
    candidates = [n for n, one in enumerate(sources) if covered_share(mosaic.extent, one.extent) >= LEAST_COVER]
    if not candidates:
        return {}
    stamps = tuple(file_stamp(ref.path) for ref in (mosaic.ref, *(sources[n].ref for n in candidates)))
    key = mosaic.ref, tuple(sources), stamps
    found = _known.get(key)
    if found is None:
        with RasterPool() as pool:
            judge = _Judge(mosaic, sources, pool)
            found = judge.likenesses(candidates)
        if not judge.has_failed:
            _known[key] = found
        for oldest in list(_known)[:-_MOST_KNOWN]:
            _known.pop(oldest, None)
    return found


class _ComparedPlace(NamedTuple):
    """A patch of the mosaic with content."""

    window: PixelWindow
    values: np.ndarray
    """(1, rows, columns) float64: its first band."""
    valid: np.ndarray
    """(rows, columns) bool."""


class Look:
    """Places of the mosaic, averaged to larger pixels perhaps, and what sources lack of it there, each read once."""

    def __init__(self, mosaic: Raster, step: int, sources: Sequence[Source], pool: RasterPool) -> None:
        left, right, _, top, _, down = mosaic.placement
        columns, rows = mosaic.columns // step, mosaic.rows // step
        thinned = replace(
            mosaic, columns=columns, rows=rows, geotransform=(left, right * step, 0.0, top, 0.0, down * step)
        )
        self._mosaic = mosaic if step == 1 else thinned
        self._sources, self._pool = sources, pool
        width, height = min(SIDE_PX, columns), min(SIDE_PX, rows)
        most = min(PLACES, MOST_READ_PX // (SIDE_PX * step))
        windows = [PixelWindow(x, y, width, height) for y, x in _patches((rows, columns), (height, width), most)]
        self.places = [place for window in windows if (place := self._place(window)) is not None]
        footprints = Footprints(sources)
        extents = [self._mosaic.grid.window_extent(place.window) for place in self.places]
        self.over = [footprints.meeting(extent) for extent in extents]
        """Numbers of the sources over each place."""
        self._lacking: dict[tuple[int, int], float] = {}

    def _place(self, window: PixelWindow) -> _ComparedPlace | None:
        try:
            values, valid = self._read(self._mosaic.ref, window)
        except NotCoveredError:
            return None
        differences = _differences(values * grey_factor(self._mosaic), valid)
        has_content = valid.mean() > LEAST_BOTH and differences @ differences > LEAST_CONTENT * len(differences)
        return _ComparedPlace(window, values, valid) if has_content else None

    def _read(self, ref: RasterRef, window: PixelWindow) -> tuple[np.ndarray, np.ndarray]:
        clip = read_clip(self._pool.open(ref), self._mosaic, window, partly=True)
        valid = np.ones(clip.bands.shape[1:], bool) if clip.valid is None else clip.valid
        return clip.bands[:1].astype(np.float64), valid

    def source(self, number: int, k: int) -> tuple[np.ndarray, np.ndarray] | None:
        """The pixels of a source at a place, (1, rows, columns), and where it has any; None where it has not. Raises
        RasterError."""
        try:
            return self._read(self._sources[number].ref, self.places[k].window)
        except NotCoveredError:
            return None

    def lacking(self, number: int, k: int) -> float:
        """Share of the mosaic's detail at a place that a source does not explain; nan where it has too few pixels,
        or can't be read."""
        if (number, k) not in self._lacking:
            place, found = self.places[k], None
            with suppress(RasterError):  # the scan says so where it needs it
                found = self.source(number, k)
            self._lacking[number, k] = np.nan if found is None else _lacking(place.values, place.valid, *found)
        return self._lacking[number, k]


class _Turn(NamedTuple):
    """A place where the mosaic plainly follows one source and not another image of the ground."""

    first: int
    beaten: frozenset[int]
    share: float
    """Preference of a raster for the first to the best of the beaten, as a share of the mosaic's: 1 for a copy."""


class _LikeMosaic(NamedTuple):
    """A raster that is like the mosaic wherever it lies."""

    look: Look
    lacking: np.ndarray
    """What it lacks of the mosaic, (places,); nan where it has too few pixels."""
    is_part: bool
    """Whether the mosaic has pixels where it has none."""

    def best(self, aside: Collection[int]) -> np.ndarray:
        """The least that any other source lacks of the mosaic, (places,)."""
        found = (self._others(k, aside) for k in range(len(self.lacking)))
        return np.array([others[0][0] if others else np.nan for others in found])

    def turns(self, number: int, aside: Collection[int]) -> list[_Turn]:
        """Where the mosaic turns between other sources than those that are put aside."""
        found = []
        for k in np.flatnonzero(self.lacking < 1).tolist():
            (least, first), *others = self._others(k, aside) or [(np.nan, -1)]
            beaten = [(more, n) for more, n in others if plainly(more, least) and more > least + LITTLE]
            # What the mosaic was made of explains it as well as a copy does; neighbours of its one image do not.
            if beaten and not plainly(least, self.lacking[k] + HARDLY_LACKING):
                more, second = beaten[0]
                preferred = self._lacked_by(number, second, k) - self._lacked_by(number, first, k)
                share = preferred / ((more - least) * (1 - self.lacking[k]))
                found.append(_Turn(first, frozenset(n for _, n in beaten), share))
        return found

    def _others(self, k: int, aside: Collection[int]) -> list[tuple[float, int]]:
        """What the others lack of the mosaic at a place, and their numbers, the best first."""
        found = ((self.look.lacking(n, k), n) for n in self.look.over[k] if n not in aside)
        return sorted(one for one in found if not np.isnan(one[0]))

    def _lacked_by(self, number: int, other: int, k: int) -> float:
        """What another source lacks of this one at a place."""
        with suppress(RasterError):
            first, second = self.look.source(number, k), self.look.source(other, k)
            return np.nan if first is None or second is None else _lacking(*first, *second)
        return np.nan


class _Judge:
    """All sources of a mosaic, of which some are held against it and against the others."""

    def __init__(self, mosaic: Raster, sources: Sequence[Source], pool: RasterPool) -> None:
        self._mosaic, self._sources, self._pool = mosaic, sources, pool
        self._looks: dict[int, Look] = {}
        self.has_failed = False
        """Whether something could not be read, so that another time may tell more."""

    def likenesses(self, candidates: Iterable[int]) -> dict[int, Likeness]:
        """What each of those that are like the mosaic wherever they lie is to it, by number."""
        found: dict[int, Likeness] = {}
        alike: dict[int, _LikeMosaic] = {}
        for number in candidates:
            if is_made_of(self._sources[number].ref, self._mosaic.ref):
                found[number] = Likeness.COPY
            elif (one := self._alike(number)) is not None:
                alike[number] = one
        # Copies are like each other and explain each other, so they are seen by what is surely none.
        unclear = {n: one for n, one in alike.items() if not _takes_turns(one.lacking, one.best({n}))}
        aside = {*found, *(n for n, one in unclear.items() if not one.is_part)}
        for number, one in unclear.items():
            if _is_followed(one.turns(number, {number, *aside})):
                found[number] = Likeness.EQUAL if one.is_part else Likeness.COPY
            elif not one.is_part:  # an orthoimage is often like the mosaic in all of its part
                found[number] = Likeness.EQUAL if np.nanmax(one.lacking) <= NEARLY_ALL else Likeness.LIKE
        return dict(sorted(found.items()))

    def _look(self, step: int) -> Look:
        if step not in self._looks:
            self._looks[step] = Look(self._mosaic, step, self._sources, self._pool)
        return self._looks[step]

    def _alike(self, number: int) -> _LikeMosaic | None:
        """None where it is unlike the mosaic somewhere, or can't be read."""
        try:
            return self._compared(number)
        except RasterError:  # the scan says so where it needs it
            self.has_failed = True
            return None

    def _compared(self, number: int) -> _LikeMosaic | None:
        source = self._sources[number]
        width = (source.extent[2] - source.extent[0]) / self._pool.open(source.ref).columns
        step = max(round(width / self._mosaic.grid.pixel_width), 1)
        if step > MOST_THINNED:
            return None
        look, lacking, is_part = self._look(step), [], False
        for k, place in enumerate(look.places):
            pixels = look.source(number, k)
            lacking.append(look.lacking(number, k))
            inside = ndimage.binary_erosion(place.valid, iterations=EDGE_PX, border_value=1)
            is_part = is_part or pixels is None or bool((inside & ~pixels[1]).mean() > MOST_MISSING)
            if len(lacking) % FEWEST == 0 and not _is_like(lacking):
                return None
        is_known = np.count_nonzero(~np.isnan(lacking)) >= FEWEST and _is_like(lacking)
        return _LikeMosaic(look, np.array(lacking), is_part) if is_known else None


def _is_like(lacking: Sequence[float]) -> bool:
    """Whether a raster is like the mosaic so far, by what it lacks of it at some places."""
    known = np.array([one for one in lacking if not np.isnan(one)])
    return len(known) < FEWEST or bool(
        np.median(known) <= MEDIAN_LACKING and (known > MOST_LACKING).sum() <= MOST_WEAK * len(known) + 1
    )


def _is_followed(turns: Sequence[_Turn]) -> bool:
    """Whether a raster goes with the mosaic where that goes from one image to another: wherever one follows the first
    of them, and where the second plainly beats it."""
    won = Counter(turn.first for turn in turns)
    pairs = Counter((turn.first, n) for turn in turns for n in turn.beaten if won[n] >= FEWEST_TURNS)
    return _goes_along(turns) and any(
        _goes_along([turn for turn in turns if turn.first == first and second in turn.beaten])
        and _goes_along([turn for turn in turns if turn.first == second])
        for (first, second), count in pairs.items() if count >= FEWEST_TURNS
    )


def _goes_along(turns: Sequence[_Turn]) -> bool:
    return bool(turns) and bool(np.percentile([turn.share for turn in turns], 25) >= LEAST_FOLLOWED)


def plainly(more: float, less: float) -> bool:
    return more > PLAINLY * less + NEARLY_ALL


def _takes_turns(own: np.ndarray, best: np.ndarray) -> bool:
    """Whether one that is like the mosaic everywhere explains it best here, and there another one does and it lacks
    much more: it is an orthoimage, as no copy turns away from its mosaic. By what it and the best of the others lack,
    (places,)."""
    if min(np.count_nonzero(own <= NEARLY_ALL), np.count_nonzero(own > LITTLE)) >= FEWEST_TURNS:
        return True  # the mosaic itself here and not there, which no compression leaves
    wins, is_beaten = best > PLAINLY * own + NEARLY_ALL, own > PLAINLY * best + NEARLY_ALL
    if min(np.count_nonzero(wins), np.count_nonzero(is_beaten)) < FEWEST_TURNS:
        return False
    lacking, others_lacking = float(np.median(own[wins])), float(np.median(best[is_beaten]))
    # A copy with loss beats the others along the seams only, where they are mixed and it lacks what the loss took.
    drops = float(np.median(own[is_beaten])) >= max(LEAST_DROP * lacking, lacking + NEARLY_ALL)
    return drops and lacking + HARDLY_LACKING <= PLAINLY * (others_lacking + HARDLY_LACKING)


def _lacking(values: np.ndarray, valid: np.ndarray, others: np.ndarray, others_valid: np.ndarray) -> float:
    """Share of the detail of a patch (1, rows, columns) that another one does not explain; nan where too few pixels
    are in both.

    Through a filter: what was resampled into the mosaic explains it as well as what lies on its pixels.
    """
    both = valid & others_valid
    if both.mean() <= LEAST_BOTH:
        return np.nan
    shown = _shown(values[0], others[0], both)[np.newaxis]
    like = likeness_of(values, shown, both, 0.0)
    return 1.0 if np.isnan(like) else 1 - max(like, 0.0) ** 2


def _shown(mosaic: np.ndarray, source: np.ndarray, valid: np.ndarray) -> np.ndarray:
    """A source as the mosaic shows it, (rows, columns); as it is where that can't be told."""
    own, its = (np.where(valid, one, one[valid].mean()).astype(np.float32) for one in (mosaic, source))
    taps = fit_filter(high_pass(own), high_pass(its), valid)
    return its if taps is None else filtered(its, taps)


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


def covered_share(first: Extent, second: Extent) -> float:
    """What a second rectangle has of the first, as a share of that; 0 where that has no area, as where its pixels are
    smaller than coordinates can tell apart."""
    width = min(first[2], second[2]) - max(first[0], second[0])
    height = min(first[3], second[3]) - max(first[1], second[1])
    area = (first[2] - first[0]) * (first[3] - first[1])
    return max(width, 0.0) * max(height, 0.0) / area if area > 0 else 0.0


def is_made_of(ref: RasterRef, mosaic: RasterRef) -> bool:
    """Whether a raster is a VRT that names the mosaic."""
    return os.path.isfile(ref.path) and any(is_same_file(RasterRef(part), mosaic) for part in vrt_parts(ref.path))
