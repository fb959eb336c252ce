"""Whether rasters that may be sources of a mosaic are the mosaic again, another mosaic, or something else, by pixels.

Small patches are compared with the mosaic. A source is like it where the mosaic follows that source, and unlike it
where it follows another. What is like it everywhere is a copy, or an orthoimage on well registered ground: such images
are like each other everywhere, so that likeness alone tells nothing. What was made from the mosaic turns with it from
one orthoimage to the other; an orthoimage is less like it where another one beats it. What is put together from others
is another mosaic.
"""
from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum
from itertools import combinations

import numpy as np

from ....imagery.errors import Message, RasterError
from ....imagery.grids import Extent, PixelWindow
from ....imagery.open_raster import describe_mosaic, placed
from ....imagery.raster_pool import RasterPool
from ....imagery.rasters import Raster, RasterRef
from ....imagery.reference_systems import extent_on
from ..following.boxes import in_squares
from ..source_images import Source, is_same_file, sources_in
from . import messages
from .mosaic_copies import (
    FEWEST,
    FEWEST_TURNS,
    LEAST_DROP,
    LEAST_LIKE,
    MEDIAN_LIKE,
    SAME_PLACE,
    covered_share,
    first_band,
    is_made_of,
    likeness_of,
    scattered,
)
from .raster_facts import SUGGESTED, Suitability, left_out

PLAINLY_MORE = 0.05  # of a correlation with the mosaic: an eighth of it is what noise does to 64 x 64 px
LEAST_AGREEING = 0.95  # of the places where two others differ: copies 0.97 and more, orthoimages 0.9 and less
SLIGHTLY_DISTINCT = 0.1  # the same of one that covers it all where others are parts
DISTINCT = 0.3  # correlation with one above that with another: it is that one's image, and no neighbour on even ground
MOST_EVEN = 1.5  # two orthoimages of a pair lack about as much where the mosaic follows the other
ROUNDING = 0.01  # of a correlation: what sharpening or bits change
MANY_BEATEN = 8  # pairs of others at such places
LEAST_FOLLOWED = 0.4  # of a difference between two others that the mosaic shows: what turns with it shows as much
LEAST_FOLLOWING = 0.85  # of those pairs


class Origin(Enum):
    """What a raster that is like the mosaic everywhere is."""

    SOURCE = "source"
    MOSAIC = "mosaic"
    UNKNOWN = "unknown"
    """The others do not say: nothing of the mosaic turns there, or there are no others."""


@dataclass(frozen=True)
class Rival:
    """Another raster at one place."""

    like_mosaic: float
    """Correlation of its fine detail with the mosaic's."""
    like_one: float
    """With that of the raster in question."""


@dataclass(frozen=True)
class PlaceLikeness:
    """A raster at one place, and the others there by name."""

    like: float
    """Correlation of its fine detail with the mosaic's."""
    rivals: Mapping[str, Rival]


def origin_of(comparisons: Sequence[PlaceLikeness], is_whole: bool) -> Origin:
    """By its places, with those rivals that are not even more like the mosaic, as other copies are.

    One that covers the whole mosaic is a copy of it more often than not; of others the drop is asked first.
    """
    found = [one for one in _without_copies(comparisons) if one.rivals]
    if not found:
        return Origin.UNKNOWN
    best = np.array([max(rival.like_mosaic for rival in one.rivals.values()) for one in found])
    likes = np.array([one.like for one in found])
    beaten = best - likes > PLAINLY_MORE
    if is_whole and _turns_where_beaten([one for one, is_beaten in zip(found, beaten) if is_beaten]):
        return Origin.MOSAIC
    if min(beaten.sum(), (~beaten).sum()) >= FEWEST_TURNS:
        lacks_there, lacks_elsewhere = (float(np.median(1 - likes[which])) for which in (beaten, ~beaten))
        if lacks_there > LEAST_DROP * lacks_elsewhere:
            return Origin.SOURCE
    return Origin.MOSAIC if _turns(found) else Origin.UNKNOWN


def put_together_from(comparisons: Sequence[PlaceLikeness], by: float = DISTINCT) -> tuple[str, str] | None:
    """Two others that a raster was put together from: plainly the one's image here, and the second's there."""
    found = _without_copies(comparisons)
    for (first, second), both in _pairs_of_rivals(found):
        more = np.array([a.like_one - b.like_one for a, b in both])
        is_like = np.array([max(a.like_one, b.like_one) for a, b in both]) >= MEDIAN_LIKE
        if (is_like & (more > by)).any() and (is_like & (more < -by)).any():
            return first, second
    return None


def _pairs_of_rivals(
    comparisons: Sequence[PlaceLikeness],
) -> Iterator[tuple[tuple[str, str], list[tuple[Rival, Rival]]]]:
    """The names of every two others, and both at each place that they share."""
    for pair in combinations(sorted({name for one in comparisons for name in one.rivals}), 2):
        shared = [one.rivals for one in comparisons if set(pair) <= one.rivals.keys()]
        yield pair, [(rivals[pair[0]], rivals[pair[1]]) for rivals in shared]


def _turns(comparisons: Sequence[PlaceLikeness]) -> bool:
    """Whether the mosaic follows one of two others here and the second there, and the raster does so with it."""
    agreeing: list[bool] = []
    is_turning = False
    for _, both in _pairs_of_rivals(comparisons):
        ours = np.array([b.like_mosaic - a.like_mosaic for a, b in both])
        theirs = np.array([b.like_one - a.like_one for a, b in both])
        plain = np.abs(ours) > PLAINLY_MORE
        agreeing += (ours * theirs > 0)[plain].tolist()
        is_turning = is_turning or bool((ours > PLAINLY_MORE).any() and (ours < -PLAINLY_MORE).any())
    return is_turning and float(np.mean(agreeing)) >= LEAST_AGREEING


def _turns_where_beaten(comparisons: Sequence[PlaceLikeness]) -> bool:
    """Whether it follows the mosaic even where others are more like that, as a copy with loss does."""
    followed: list[bool] = []
    for one in comparisons:
        for first, second in combinations(one.rivals.values(), 2):
            ours = first.like_mosaic - second.like_mosaic
            if abs(ours) > PLAINLY_MORE:
                followed.append((first.like_one - second.like_one) / ours > LEAST_FOLLOWED)
    return len(followed) >= MANY_BEATEN and float(np.mean(followed)) >= LEAST_FOLLOWING and _turns(comparisons)


def _without_copies(comparisons: Sequence[PlaceLikeness]) -> list[PlaceLikeness]:
    """Without rivals that lack plainly less of the mosaic than the raster does, each at its worst of their places."""
    names = {name for one in comparisons for name in one.rivals}
    kept = set()
    for name in names:
        shared = [one for one in comparisons if name in one.rivals]
        least = min(one.rivals[name].like_mosaic for one in shared)
        if 1 - min(one.like for one in shared) <= MOST_EVEN * (1 - least) + ROUNDING:
            kept.add(name)
    return [
        PlaceLikeness(one.like, {name: rival for name, rival in one.rivals.items() if name in kept})
        for one in comparisons
    ]


SIDE_PX = 64  # of a patch
PLACES, PLACES_OF_ALL = 5, 10  # along each side of what a raster shares with the mosaic; of one that covers it all
ENOUGH = 6  # places with content, after which one that is like the mosaic here and unlike it there is a source
LEAST_VALID = 0.2  # of a patch
COARSE_PX = 8  # side of the means that tell whether two patches show the same things
LEAST_SAME_CONTENT = 0.3  # median correlation of those
SINGLE_SHARE = 0.9  # of places that one other candidate explains: it is the same image, and none put together
SAME_IMAGE_PLACE = 0.98  # of each of two images, that the other covers
MOST_TURNING = 36  # places at which it is seen whether one turns with the mosaic
MOST_LABELS = 32  # values of a raster that says which class or which image a pixel is of; images have more
LEAST_EVEN = 0.9  # of the pixels of labels that are as the next one; noise alone makes it less
MOST_COMPARED = 8  # places at which a raster is compared with other candidates

Cancelled = Callable[[], bool]


@dataclass(frozen=True)
class SourceCandidate:
    """A raster that may be a source."""

    key: str
    name: str
    ref: RasterRef


@dataclass(frozen=True)
class _Placed:
    """A candidate with its footprint in the mosaic's reference system."""

    candidate: SourceCandidate
    source: Source
    is_whole: bool
    """Whether it covers the mosaic."""


@dataclass(frozen=True, eq=False)
class _Patch:
    """One place of a raster and the mosaic."""

    window: PixelWindow
    bands: np.ndarray
    """First band, (1, rows, columns)."""
    valid: np.ndarray
    like: float
    """Correlation of the fine detail with the mosaic's."""
    coarse: float


def look_at_candidates(
    mosaic: RasterRef,
    candidates: Sequence[SourceCandidate],
    known: Collection[str] = (),
    cancelled: Cancelled = lambda: False,
) -> Iterator[tuple[str, Suitability]]:
    """The standing of each candidate, by key, those that cover the mosaic first, as they are looked at.

    ``known``: keys of those whose standing is known already; those that cover the mosaic are looked at again, as there
    may be others now that they are made of.

    Raises RasterError when the mosaic can't be read; a candidate that can't be is left out.
    """
    raster = describe_mosaic(mosaic)
    with RasterPool(most=64) as pool:
        there: list[_Placed] = []
        for candidate in candidates:
            try:
                there.append(_placed(candidate, raster, pool))
            except RasterError as error:
                yield candidate.key, left_out(messages.PIXELS_NOT_READ(why=error.message))
        look = _Look(raster, there, pool)
        for one in sorted(there, key=lambda one: not one.is_whole):
            if cancelled():
                return
            if one.candidate.key in known and not one.is_whole:
                continue
            try:
                yield one.candidate.key, look.standing(one)
            except RasterError as error:
                yield one.candidate.key, left_out(messages.PIXELS_NOT_READ(why=error.message))


def _placed(candidate: SourceCandidate, mosaic: Raster, pool: RasterPool) -> _Placed:
    raster = placed(pool.open(candidate.ref).raster)
    extent = extent_on(raster.extent, raster.wkt, mosaic.wkt)
    return _Placed(candidate, Source(candidate.ref, extent), covered_share(mosaic.extent, extent) >= SAME_PLACE)


class _Look:
    """The mosaic and all candidates, of which each is held against it and against the others."""

    def __init__(self, mosaic: Raster, known: Sequence[_Placed], pool: RasterPool) -> None:
        self._mosaic = mosaic
        self._known = {id(one.source): one for one in known}
        self._parts = [one.source for one in known if not one.is_whole]
        self._wholes = [one.source for one in known if one.is_whole]
        self._names = {one.candidate.key: one.candidate.name for one in known}
        self._pool = pool

    def standing(self, one: _Placed) -> Suitability:
        """Raises RasterError when the mosaic or the candidate can't be read."""
        if is_same_file(one.source.ref, self._mosaic.ref):
            return left_out(messages.IS_THE_MOSAIC())
        if is_made_of(one.source.ref, self._mosaic.ref):
            return left_out(messages.MADE_OF_MOSAIC())
        patches: list[_Patch] = []
        for window in _windows(self._mosaic, one.source.extent, PLACES_OF_ALL if one.is_whole else PLACES):
            if (patch := self._patch(one.source, window)) is not None:
                patches.append(patch)
            if not one.is_whole and len(patches) >= ENOUGH and _is_mixed(patches):
                break
        reason = self._against(one, patches)
        if reason is not None:
            return left_out(reason)
        return replace(SUGGESTED, is_followed=any(patch.like >= MEDIAN_LIKE for patch in patches))

    def _against(self, one: _Placed, patches: Sequence[_Patch]) -> Message | None:
        """What speaks against a candidate."""
        is_like = any(patch.like >= MEDIAN_LIKE for patch in patches)
        if not is_like and (count := self._label_count(one)):
            return messages.HOLDS_LABELS(count=count)
        if len(patches) < FEWEST:
            return messages.MAY_BE_MOSAIC() if one.is_whole else None
        likes = np.array([patch.like for patch in patches])
        if likes.min() >= LEAST_LIKE and np.median(likes) >= MEDIAN_LIKE:
            return self._against_alike(one, patches)
        if not is_like:
            if one.is_whole:
                return messages.NOT_FOLLOWED()
            if np.median([patch.coarse for patch in patches]) < LEAST_SAME_CONTENT:
                return messages.OTHER_CONTENT()
        return self._against_others(one, patches)

    def _against_alike(self, one: _Placed, patches: Sequence[_Patch]) -> Message | None:
        """Of one that is like the mosaic everywhere."""
        origin = origin_of([self._compared(patch, one) for patch in patches[:MOST_TURNING]], one.is_whole)
        if origin is Origin.MOSAIC:
            return messages.MOSAIC_AGAIN() if one.is_whole else messages.MOSAIC_PART_AGAIN()
        if one.is_whole and self._parts:  # what covers it all where others are parts is a mosaic before it is a source
            over_parts = [PlaceLikeness(patch.like, self._rivals(patch, self._others(patch, one))) for patch in patches]
            if (pair := put_together_from(over_parts, SLIGHTLY_DISTINCT)) is not None:
                return messages.ANOTHER_MOSAIC(first=self._names[pair[0]], second=self._names[pair[1]])
        return messages.MOSAIC_OR_ITS_SOURCE() if one.is_whole and origin is Origin.UNKNOWN else None

    def _against_others(self, one: _Placed, patches: Sequence[_Patch]) -> Message | None:
        """Whether it is an altered copy of the mosaic, which turns with it where it is like it, or is put together from
        other candidates: they explain it where the mosaic is not like it."""
        like = [patch for patch in patches if patch.like >= MEDIAN_LIKE]
        turning = [self._compared(patch, one) for patch in like[:MOST_TURNING]] if one.is_whole else []
        if origin_of(turning, one.is_whole) is Origin.MOSAIC:
            return messages.MOSAIC_ALTERED()
        unlike = [patch for patch in patches if patch.like < LEAST_LIKE and self._others(patch, one)][:MOST_COMPARED]
        explained = [names for patch in unlike if (names := self._explainers(patch, one))]
        if unlike and 2 * len(explained) >= len(unlike):
            explained += [names for patch in like[:MOST_COMPARED] if (names := self._explainers(patch, one))]
            counts = Counter(name for names in explained for name in names)
            first, most = counts.most_common(1)[0]
            if most < SINGLE_SHARE * len(explained):
                if one.is_whole:
                    second = next(names[0] for names in explained if first not in names)
                    return messages.ANOTHER_MOSAIC(first=first, second=second)
                pair = put_together_from([self._compared(patch, one) for patch in patches])
                return pair and messages.ANOTHER_MOSAIC(first=self._names[pair[0]], second=self._names[pair[1]])
            if self._is_same_image(one, first):
                return messages.SAME_IMAGE(name=first)
        return messages.MAY_BE_MOSAIC() if one.is_whole and not unlike else None

    def _label_count(self, one: _Placed) -> int:
        """How many values a raster has that holds labels, as far as was looked; 0 for an image."""
        raster = self._pool.open(one.source.ref)
        values: set[float] = set()
        for window in _windows(raster.raster, raster.raster.extent, PLACES):
            block = raster.read(window)
            band = block.bands[0]
            values.update(np.unique(band[block.valid]).tolist())
            if len(values) > MOST_LABELS or (band[:, 1:] == band[:, :-1]).mean() < LEAST_EVEN:
                return 0
        return len(values) if len(values) > 1 else 0

    def _is_same_image(self, one: _Placed, name: str) -> bool:
        """Whether the candidate that is like it everywhere lies where it does and comes before it."""
        for other in self._known.values():
            if other is one:
                return False
            if other.candidate.name == name:
                here, there = one.source.extent, other.source.extent
                return min(covered_share(here, there), covered_share(there, here)) > SAME_IMAGE_PLACE
        return False

    def _compared(self, patch: _Patch, one: _Placed) -> PlaceLikeness:
        """With all others there, those that cover the mosaic among them unless they would have to be warped."""
        extent = self._mosaic.grid.window_extent(patch.window)
        wholes = [source for source in self._wholes if self._pool.open(source.ref).raster.wkt == self._mosaic.wkt]
        others = [source for source in sources_in([*self._parts, *wholes], extent) if source is not one.source]
        return PlaceLikeness(patch.like, self._rivals(patch, others))

    def _others(self, patch: _Patch, one: _Placed) -> list[Source]:
        """Candidates at a place; those that cover the mosaic explain each other, and only where there are no others."""
        extent = self._mosaic.grid.window_extent(patch.window)
        parts = [source for source in sources_in(self._parts, extent) if source is not one.source]
        if parts or not one.is_whole:
            return parts
        return [source for source in sources_in(self._wholes, extent) if source is not one.source]

    def _explainers(self, patch: _Patch, one: _Placed) -> list[str]:
        """Names of the other candidates that this one is like at a place."""
        rivals = self._rivals(patch, self._others(patch, one))
        return [self._names[key] for key, rival in rivals.items() if rival.like_one >= MEDIAN_LIKE]

    def _rivals(self, patch: _Patch, others: Sequence[Source]) -> dict[str, Rival]:
        """Other candidates at a place, by their keys, where there is enough to see."""
        ours = self._pool.open(self._mosaic.ref).read(patch.window)
        mosaic, found = ours.bands[:1].astype(np.float64), {}
        for source in others:
            try:
                bands, valid = first_band(source, self._mosaic, patch.window, self._pool)
            except RasterError:
                continue
            both = patch.valid & valid & ours.valid
            if both.mean() < LEAST_VALID or np.isnan(like_one := likeness_of(patch.bands, bands, both)):
                continue
            found[self._known[id(source)].candidate.key] = Rival(likeness_of(mosaic, bands, both, 0.0), like_one)
        return found

    def _patch(self, source: Source, window: PixelWindow) -> _Patch | None:
        """None where one of them has too few pixels there, or nothing to see."""
        ours = self._pool.open(self._mosaic.ref).read(window)
        if ours.valid.mean() < LEAST_VALID:
            return None
        try:
            bands, valid = first_band(source, self._mosaic, window, self._pool)
        except RasterError:
            return None
        first, both = ours.bands[:1].astype(np.float64), valid & ours.valid
        if both.mean() < LEAST_VALID or np.isnan(like := likeness_of(first, bands, both)):
            return None
        return _Patch(window, bands, valid, like, _coarse_correlation(first[0], bands[0], both))


def _is_mixed(patches: Sequence[_Patch]) -> bool:
    likes = [patch.like for patch in patches]
    return max(likes) >= MEDIAN_LIKE and sum(like < LEAST_LIKE for like in likes) >= 2


def _coarse_correlation(first: np.ndarray, second: np.ndarray, both: np.ndarray) -> float:
    """Of means over squares; 1 where there is nothing to tell from."""
    there = in_squares(both, COARSE_PX).all(axis=(1, 3))
    a, b = (in_squares(one, COARSE_PX).mean(axis=(1, 3))[there] for one in (first, second))
    if len(a) < 8 or min(a.std(), b.std()) == 0:
        return 1.0
    return float(np.corrcoef(a, b)[0, 1])


def _windows(mosaic: Raster, extent: Extent, places: int) -> Iterator[PixelWindow]:
    """Patches of the mosaic under a footprint, one in each part of it, in no order."""
    grid = mosaic.grid
    left, right = ((x - grid.left) / grid.pixel_width for x in (extent[0], extent[2]))
    top, bottom = ((grid.top - y) / grid.pixel_height for y in (extent[3], extent[1]))
    left, top, right, bottom = max(left, 0), max(top, 0), min(right, grid.columns), min(bottom, grid.rows)
    width, height = min(SIDE_PX, int(right - left)), min(SIDE_PX, int(bottom - top))
    if min(width, height) < COARSE_PX:
        return
    whole = PixelWindow(0, 0, width, height)
    for row, column in scattered(places):
        yield replace(
            whole, column=int(left + column * (right - left - width)), row=int(top + row * (bottom - top - height))
        )
