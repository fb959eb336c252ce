"""What a mosaic would look like if its sources had been cut hard where it passes from one to another.

Everything that was done to the whole of it is in it: tones source by source, and sharpening, blur or resampling as a
linear filter. What the mosaic lacks beside it was lost at the seams.
"""
from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, cached_property

import numpy as np

from ..seam_cells import UNKNOWN, is_one_of, present
from .border import smooth_border, to_the_pixel
from .boxes import near_border
from .compression import was_compressed
from .followed_source import FollowedSource, high_pass
from .foreign_ground import IsCompressed
from .levelling import SQUARE_PX, Levelled, evened_gains, levelled, square_means
from .likely_source import FINE, LikelySource, Sampling, likely_source
from .meeting import by_shares, mixed_shares, where_several_meet
from .mixed_ground import MixedGround, mixed_ground
from .source_filters import (
    FEWEST_PIXELS,
    SAMPLE,
    Filters,
    cut_of,
    filtered,
    find_filters,
    share_left,
    through_filter,
)

FEWEST_UNSURE_PIXELS = 16000  # that a filter is learned from where its source is followed for sure nearly nowhere
MIN_LEFT_UNMIXED = 0.01  # of the fine detail, that sources on their own sides leave over, for them to be mixed
MOST_LEFT_OF_THAT = 0.5  # where both mixed explain it
HOPELESS_LEFT_OF_THAT = 0.75  # after some rounds, of which true mixtures had up to 0.45 by then
MOST_LEFT_BY_MIXED = 10.0  # times what they leave over one by one; true mixtures have up to 4
MOST_LEFT_MIXED = 0.05  # of the fine detail, for a filter to be believed that was learned where sources may be mixed
MIN_THIRD_SHARE = 0.25  # of the pixels, that a third image surely has where two are mixed everywhere
MOST_LEFT_OF_THIRD = 0.05  # of what seemed to be a smaller part of a third: the two mixed explain it

_ROUNDS = 3
_SETTLED = 0.005  # of the pixels: what changes less is settled
_UNSURE_PX = 12  # from a border that is not settled


@dataclass(frozen=True, eq=False)
class ExpectedMosaic:
    """The hard cut as this mosaic would show it."""

    plane: np.ndarray
    """(rows, columns) float32; the mosaic itself where no source explains it."""
    unfiltered: np.ndarray
    """The cut before anything came over the whole mosaic: in its tones, as sharp as its sources."""
    labels: np.ndarray
    """(rows, columns) uint8: the source of every pixel, ``UNKNOWN`` where none explains it."""
    shown: Mapping[int, np.ndarray]
    """(rows, columns) float32: each source that is followed, everywhere as this mosaic would show it."""
    toned: Mapping[int, np.ndarray]
    """(rows, columns) float32: each source before anything came over the whole mosaic; ``shown`` where nothing did."""
    shares: Mapping[int, np.ndarray] | None = None
    """Share of each source in squares of 8 px, (rows / 8, columns / 8) float32, where more than two are mixed; 0
    elsewhere. None where that is nowhere."""
    filters: Filters = field(default_factory=lambda: Filters({}, False))
    """What makes ``shown`` of ``toned``; the numbers are those of planes, of which several may be of one source."""

    @property
    def is_filtered(self) -> bool:
        """Whether something came over it."""
        return any(self.toned[i] is not plane for i, plane in self.shown.items())

    def of_sources(self, source_of: Sequence[int]) -> ExpectedMosaic:
        """The cut with the numbers of sources for those of planes, several of which may be of one source."""
        numbers = np.full(UNKNOWN + 1, UNKNOWN, np.uint8)
        numbers[: len(source_of)] = source_of
        most_first = sorted(self.shown, key=lambda plane: -np.count_nonzero(self.labels == plane))
        shown: dict[int, np.ndarray] = {}
        toned: dict[int, np.ndarray] = {}
        for plane in most_first:
            for pixels, held in ((self.shown[plane], shown), (self.toned[plane], toned)):
                before = held.get(source_of[plane])
                held[source_of[plane]] = pixels if before is None else np.where(self.labels == plane, pixels, before)
        shares: dict[int, np.ndarray] = {}
        for plane, share in (self.shares or {}).items():
            shares[source_of[plane]] = shares.get(source_of[plane], 0) + share
        return replace(self, labels=numbers[self.labels], shown=shown, toned=toned, shares=shares or None)


def expected_mosaic(
    mosaic: np.ndarray,
    planes: Sequence[np.ndarray],
    fine: Sequence[np.ndarray],
    following: FollowedSource,
    valid: Mapping[int, np.ndarray],
    known: np.ndarray | None = None,
    filters: Filters | None = None,
    sampling: Sampling = FINE,
    patch_px: int = 0,
    has_warped: bool = False,
    given: Sequence[np.ndarray] | None = None,
    interpolated: Collection[int] = (),
) -> ExpectedMosaic:
    """Planes (rows, columns) float32 of the mosaic and its sources, ``following`` a first estimate.

    ``fine``: the fine detail of the mosaic, then of the sources (``high_pass``).

    ``valid``: pixels that a source has, of those that don't have all. ``known``: labels that are known, else
    ``UNKNOWN``; they go before the estimate.
    ``filters``: what came over the mosaic, where that is known from more ground than there is here. ``sampling``: how
    closely sources are told from each other. ``patch_px``: as for ``mosaic_of``, whose ground this is compared with.
    ``has_warped``: whether a source was warped to the mosaic's grid, which explains it no better than another image.
    ``given``: the planes before any of them was moved, where that was done. ``interpolated``: those that lie between
    the mosaic's pixels, or were moved.
    """
    window = _Window(mosaic, planes, fine, following, valid, known, sampling, patch_px, has_warped, interpolated)
    if filters is None:
        learned, labels, in_tone = window.learned()
    else:
        learned, labels = filters, window.labels(window.likely(filters))
        in_tone = window.in_tone(labels)
    toned = {i: one.plane for i, one in in_tone.items()}
    shown = {i: learned.applied(i, plane) for i, plane in toned.items()}
    is_found = known is None and len(toned) > 1
    if is_found:
        labels = to_the_pixel(mosaic, shown, labels, valid)
    # Seams that are given are read as a corridor by a scan, which a third image mixed into it is not known from.
    near = where_several_meet(labels, list(shown), valid) if is_found and len(shown) > 2 else None
    shares = None
    if near is not None:
        shares = mixed_shares(fine[0], {i: high_pass(plane) for i, plane in shown.items()}, labels, near)
        labels = by_shares(labels, shares)
    if is_found:
        labels = smooth_border(labels)
    cut = cut_of(mosaic, toned, labels)
    unfiltered = cut
    if given is not None:  # to be moved by parts of a pixel costs detail as well
        unmoved = {i: one.plane + one.gain * (given[i] - planes[i]) for i, one in in_tone.items()}
        unfiltered = cut_of(mosaic, unmoved, labels)
    if not learned.taps:
        return ExpectedMosaic(cut, unfiltered, labels, shown, shown, shares, learned)
    if not learned.came_over_cuts:
        placed = {i: learned.placed(i, plane) for i, plane in toned.items()}
        return ExpectedMosaic(cut_of(mosaic, shown, labels), unfiltered, labels, shown, placed, shares, learned)
    plane = filtered(cut, next(iter(learned.taps.values())))
    return ExpectedMosaic(np.where(labels == UNKNOWN, mosaic, plane), unfiltered, labels, shown, toned, shares, learned)


@dataclass(frozen=True, eq=False)
class _Window:
    """What ``expected_mosaic`` is given."""

    mosaic: np.ndarray
    planes: Sequence[np.ndarray]
    fine: Sequence[np.ndarray]
    following: FollowedSource
    valid: Mapping[int, np.ndarray]
    known: np.ndarray | None
    sampling: Sampling
    patch_px: int
    has_warped: bool
    interpolated: Collection[int]

    def likely(self, filters: Filters | None, left_out: Collection[int] = ()) -> LikelySource:
        """The most likely source of every pixel, of those that are followed at first."""
        sources = {i: self.fine[1 + i] for i in sorted(self.following.followed) if i not in left_out}
        return _likely(self.fine[0], sources, self.following, self.valid, filters, self.sampling,
                       self.is_compressed, self.interpolated)

    @cached_property
    def is_compressed(self) -> IsCompressed:
        """See ``foreign_ground``."""
        mosaic, planes, followed = self.mosaic, self.planes, self.following.followed  # self would stay alive
        mosaic_was = cache(lambda: was_compressed(mosaic))
        source_was = cache(lambda number: number < len(planes) and was_compressed(planes[number]))

        def is_compressed(number: int | None) -> bool:
            return mosaic_was() or (any(map(source_was, followed)) if number is None else source_was(number))

        return is_compressed

    def labels(self, likely: LikelySource, strange: np.ndarray | bool = True) -> np.ndarray:
        """(rows, columns) uint8; ``strange``: where no source may explain the mosaic."""
        unexplained = np.logical_and(likely.unexplained, strange & (not self.has_warped))
        followed = likely.labels | (unexplained * np.uint8(UNKNOWN))
        return followed if self.known is None else np.where(self.known == UNKNOWN, followed, self.known)

    def in_tone(self, labels: np.ndarray) -> dict[int, Levelled]:
        """The sources that any pixel follows, in the mosaic's grey values."""
        # A part of a block is too small to tell tones where sources may be mixed.
        sure = self.following.clear if self.patch_px else _sure_unmixed(labels, self.following)
        return _in_tone(self.mosaic, dict(enumerate(self.planes)), labels, sure, self.patch_px)

    def learned(self) -> tuple[Filters, np.ndarray, dict[int, Levelled]]:
        """What came over the sources, their labels, and themselves in tone."""
        likely = self.likely(None)
        labels = self.labels(likely)
        in_tone, unmixed = self.in_tone(labels), _sure_unmixed(labels, self.following)
        anywhere = _sure(labels, unmixed)
        mosaic_fine, fine = self.fine[0], dict(enumerate(self.fine[1:]))
        filters = find_filters(mosaic_fine, fine, in_tone, labels, anywhere)
        made = self._made(in_tone, filters, labels)
        pair, few = self._mixable(made, labels)
        ground = self._ground(in_tone, filters, made, labels, pair, few) if len(pair) == 2 else None
        mixed = None if ground is None else self._mixed(likely, labels, filters, pair, few, *ground)
        if mixed is not None:
            return mixed
        # A filter that was learned of a mixture takes what that took.
        is_doubtful = np.count_nonzero(anywhere) > np.count_nonzero(unmixed)
        if is_doubtful and share_left(mosaic_fine, made, labels, present(labels)) > MOST_LEFT_MIXED:
            filters = find_filters(mosaic_fine, fine, in_tone, labels, unmixed)
        return filters, labels, in_tone

    def _mixed(
        self, alone: LikelySource, labels: np.ndarray, found: Filters, pair: Sequence[int], few: Sequence[int],
        ground: MixedGround, gains: Mapping[int, np.ndarray],
    ) -> tuple[Filters, np.ndarray, dict[int, Levelled]] | None:
        """What ``learned`` tells where two sources are mixed nearly everywhere; None where one by one, ``alone``, they
        explain far more than with what the mixture says came over them."""
        found = found.with_own(dict(zip(pair, ground.taps)), range(len(self.planes)))
        # What resembled the mosaic as long as nobody knew what it was mixed of is no seam.
        made = ground.mosaic[SAMPLE]
        chance = {i for i in few if share_left(self.fine[0], made, labels, [i]) <= MOST_LEFT_OF_THIRD}
        kept = {*pair, *present(labels)} - chance
        likely = self.likely(found, [i for i in self.following.followed if i not in kept])
        if likely.left > MOST_LEFT_BY_MIXED * alone.left:
            return None
        labels = self.labels(likely, labels == UNKNOWN)
        means = square_means(self.mosaic)
        again = {
            i: levelled(means, self.planes[i], labels == i, labels == i, gain=gain)
            for i, gain in gains.items() if (labels == i).any()
        }
        return found, labels, {**self.in_tone(labels), **again}

    def _mixable(self, made: np.ndarray, labels: np.ndarray) -> tuple[list[int], list[int]]:
        """The two sources that most pixels follow, or did at first, and those that few do, all of those that leave
        something over where they are followed."""
        most_first = sorted(present(labels), key=lambda i: -np.count_nonzero(labels == i))
        alone = {i for i in most_first if share_left(self.fine[0], made, labels, [i]) < MIN_LEFT_UNMIXED}
        followed = [*most_first, *(i for i in self.following.followed if i not in most_first)]
        pair = [i for i in followed if i not in alone][:2]
        few = [
            i for i in most_first if i not in pair and i not in alone and (labels == i).mean() < MIN_THIRD_SHARE
        ]
        return pair, few

    def _ground(
        self, in_tone: Mapping[int, Levelled], found: Filters, made: np.ndarray, labels: np.ndarray,
        pair: Sequence[int], few: Sequence[int],
    ) -> tuple[MixedGround, dict[int, np.ndarray]] | None:
        """Where two sources mixed nearly everywhere explain more than each on its own side, and their gains; None for
        other windows."""
        where = is_one_of(labels, (*pair, *few, UNKNOWN))
        for i in pair:
            where &= self.valid.get(i, True)
        inside = np.where(where, labels, np.uint8(UNKNOWN))
        left_alone = share_left(self.fine[0], made, inside, pair)
        if left_alone < MIN_LEFT_UNMIXED:
            return None
        gains = [in_tone[i].gain if i in in_tone else np.float32(1) for i in pair]
        gains = evened_gains([self.planes[i] for i in pair], gains, where)
        images = [gain * self.fine[1 + i] for i, gain in zip(pair, gains)]
        shown = [found.placed(i, one) if i in found.taps else one for i, one in zip(pair, images)]

        def left_of_that(made: np.ndarray) -> float:
            return share_left(self.fine[0], made[SAMPLE], inside, pair) / left_alone

        ground = mixed_ground(
            self.fine[0], images, shown, where, lambda made: left_of_that(made) > HOPELESS_LEFT_OF_THAT
        )
        if ground is None or left_of_that(ground.mosaic) > MOST_LEFT_OF_THAT:
            return None
        return ground, {i: ground.gain * gain for i, gain in zip(pair, gains) if i in in_tone}

    def _made(self, in_tone: Mapping[int, Levelled], found: Filters, labels: np.ndarray) -> np.ndarray:
        """What the sources make of the mosaic's fine detail, each on its own side, a ``SAMPLE``."""
        place = np.s_[:] if found.taps else SAMPLE  # a filter needs what is around
        shown = {i: found.applied(i, one.gain[place] * self.fine[1 + i][place]) for i, one in in_tone.items()}
        made = cut_of(self.fine[0][place], shown, labels[place])
        return made[SAMPLE] if found.taps else made


def _likely(
    own: np.ndarray, sources: Mapping[int, np.ndarray], following: FollowedSource, valid: Mapping[int, np.ndarray],
    filters: Filters | None, sampling: Sampling, is_compressed: IsCompressed,
    interpolated: Collection[int],
) -> LikelySource:
    """The most likely source of every pixel. What came over each is learned where it is followed, and as that is told
    better with it, learned anew until it settles; what leaves least of the mosaic over counts."""
    if filters is not None:
        shown = {i: filters.applied(i, one) for i, one in sources.items()}
        return likely_source(own, shown, following.labels, following.clear, valid, sampling, is_compressed,
                             interpolated)
    labels, clear, best = following.labels, following.clear, None
    for _ in range(_ROUNDS):
        won = {i: one for i, one in sources.items() if (labels == i).any()}
        shown = {i: through_filter(own, one, _surest(labels == i, clear)) for i, one in won.items()}
        likely = likely_source(own, shown, labels, clear, valid, sampling, is_compressed, interpolated)
        changed, labels = np.count_nonzero(likely.labels != labels) / labels.size, likely.labels
        if best is None or likely.left < best.left:
            best = likely
        if changed < _SETTLED or len(won) < 2 or all(shown[i] is won[i] for i in won):
            break
        clear = ~(likely.unexplained | near_border(labels, _UNSURE_PX))
    assert best is not None
    return best


def _sure_unmixed(labels: np.ndarray, following: FollowedSource) -> np.ndarray:
    """Where one source is followed for sure, or at least without another, (rows, columns) bool."""
    return _sure(np.where(following.mixed, np.uint8(UNKNOWN), labels), following.clear)


def _sure(labels: np.ndarray, clear: np.ndarray) -> np.ndarray:
    """What is clear of every source that any pixel follows, or all of one of which that is too little."""
    parts = (_surest(labels == i, clear) for i in present(labels))
    return np.logical_or.reduce([np.zeros(labels.shape, bool), *parts])


def _surest(part: np.ndarray, clear: np.ndarray) -> np.ndarray:
    """What is clear of a part, or all of it where that is too little to learn from and the part is large."""
    sure = part & clear
    is_enough = np.count_nonzero(sure) >= FEWEST_PIXELS or np.count_nonzero(part) < FEWEST_UNSURE_PIXELS
    return sure if is_enough else part


def mosaic_of(
    mosaic: np.ndarray,
    planes: Mapping[int, np.ndarray],
    own: np.ndarray,
    fine: Mapping[int, np.ndarray],
    labels: np.ndarray,
    within: np.ndarray,
    patch_px: int,
) -> tuple[np.ndarray, Filters]:
    """The expected mosaic where labels are known for sure and no seam is near, ``UNKNOWN`` elsewhere: (rows, columns)
    float32; and what came over the mosaic.

    ``own``, ``fine``: the fine detail of the mosaic and of the sources. ``within``: pixels a filter may be taken from.
    ``patch_px``: side of the patches that all of them consist of.
    """
    sure = labels != UNKNOWN
    in_tone = _in_tone(mosaic, planes, labels, sure, patch_px)
    filters = find_filters(own, fine, in_tone, labels, sure & within)
    return cut_of(mosaic, {i: filters.applied(i, one.plane) for i, one in in_tone.items()}, labels), filters


def _in_tone(
    mosaic: np.ndarray, planes: Mapping[int, np.ndarray], labels: np.ndarray, clear: np.ndarray, patch_px: int
) -> dict[int, Levelled]:
    """The sources that any pixel follows, in the mosaic's grey values."""
    means = square_means(mosaic)
    return {i: levelled(means, planes[i], labels == i, clear, patch_px // SQUARE_PX) for i in present(labels)}
