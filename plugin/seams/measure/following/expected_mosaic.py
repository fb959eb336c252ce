"""What a mosaic would look like if its sources had been cut hard where it passes from one to another.

Everything that was done to the whole of it is in it: tones source by source, and sharpening, blur or resampling as a
linear filter. What the mosaic lacks beside it was lost at the seams.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from ..compared_image import ComparedImage
from ..seam_cells import UNKNOWN, is_one_of, present
from .border import smooth_border, to_the_pixel
from .boxes import near_border, widened
from .compression import JPEG_SQUARE_PX, IsCompressed, compressed_sides, was_compressed
from .followed_source import high_pass
from .levelling import TONE_PX, Levelled, levelled, levelled_by, square_means
from .likely_source import FINE, FineDetail, LikelySource, Sampling, likely_source
from .meeting import by_shares, mixed_shares, where_several_meet
from .mixed_ground import mixed_filters
from .placed_sources import PlacedSources
from .source_filters import (
    FEWEST_PIXELS,
    UNFILTERED,
    UNTOUCHED,
    Filters,
    cut_of,
    filtered,
    find_filters,
    through_filter,
)

FEWEST_UNSURE_PIXELS = 16000  # that a filter is learned from where its source is followed for sure nearly nowhere
MIN_LEFT_MIXED = 0.01  # of the fine detail, that an image leaves over where it is followed, for it to be mixed there
MIN_MIXED_SHARE = 0.25  # of the pixels, that two images have which are mixed
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
    filters: Filters = UNFILTERED
    """What makes ``shown`` of ``toned``; the numbers are those of planes, of which several may be of one source."""
    was_compressed: bool = False
    """Whether the mosaic shows traces of a codec."""
    spoilt: np.ndarray | None = None
    """(rows, columns) bool: ground beside the ends of compressed sources, whose detail is not all their own."""

    @property
    def is_filtered(self) -> bool:
        """Whether something came over it."""
        return any(self.toned[i] is not plane for i, plane in self.shown.items())

    def filling(self, mosaic: ComparedImage) -> np.ndarray:
        """The mosaic's plane with what is expected where it has no pixels: any other filling would end in a step."""
        return mosaic.plane if mosaic.valid is None else np.where(mosaic.valid, mosaic.plane, self.plane)

    def of_sources(self, source_of: Sequence[int]) -> ExpectedMosaic:
        """The cut with the numbers of sources for those of planes, several of which may be of one source."""
        numbers = np.full(UNKNOWN + 1, UNKNOWN, np.uint8)
        numbers[: len(source_of)] = source_of
        shown: dict[int, np.ndarray] = {}
        toned: dict[int, np.ndarray] = {}
        for plane in sorted(self.shown, key=lambda plane: -np.count_nonzero(self.labels == plane)):  # most first
            for pixels, held in ((self.shown[plane], shown), (self.toned[plane], toned)):
                before = held.get(source_of[plane])
                held[source_of[plane]] = pixels if before is None else np.where(self.labels == plane, pixels, before)
        shares: dict[int, np.ndarray] = {}
        for plane, share in (self.shares or {}).items():
            shares[source_of[plane]] = shares.get(source_of[plane], 0) + share
        return replace(self, labels=numbers[self.labels], shown=shown, toned=toned, shares=shares or None)


@dataclass(frozen=True)
class Closeness:
    """How closely a mosaic is looked at."""

    sampling: Sampling = FINE
    """How closely sources are told from each other."""
    patch_px: int = 0
    """Side of patches as for ``mosaic_of``, whose ground this is compared with."""
    has_warped: bool = False
    """Whether a source was warped to the mosaic's grid, which explains it no better than another image."""


WINDOW = Closeness()


def expected_mosaic(
    sources: PlacedSources, filters: Filters | None = None, closeness: Closeness = WINDOW
) -> ExpectedMosaic:
    """The hard cut of the sources, with their numbers; ``UNKNOWN`` also where the mosaic has no pixels.

    ``filters``: what came over the sources as they are given, where that is known from more ground than there is here.
    """
    mosaic, cutting = sources.mosaic.plane, _Cutting(sources, closeness)
    cut = cutting.cut(None if sources.moves else filters)
    labels, filters = cut.labels, cut.filters
    toned = {i: source.plane for i, source in cut.in_tone.items()}
    shown, shares = {i: filters.applied(i, plane) for i, plane in toned.items()}, None
    if sources.known is None and len(shown) > 1:
        labels = to_the_pixel(mosaic, shown, labels, sources.valid)
        # Seams that are given are read as a corridor by a scan, which a third image mixed into it is not known from.
        near = where_several_meet(labels, list(shown), sources.valid)
        if near is not None:
            fine = {i: high_pass(plane) for i, plane in shown.items()}
            shares = mixed_shares(sources.fine[0], fine, labels, near)
            labels = by_shares(labels, shares)
        labels = smooth_border(labels)
    plane = unfiltered = cut_of(mosaic, toned, labels)
    if sources.moves:  # to be moved by parts of a pixel costs detail as well
        given = {i: sources.images[sources.source_of[i]].plane for i in toned}
        unmoved = {i: source.plane + source.gain * (given[i] - sources.planes[i]) for i, source in cut.in_tone.items()}
        unfiltered = cut_of(mosaic, unmoved, labels)
    if filters.taps and filters.came_over_cuts:
        plane = np.where(labels == UNKNOWN, mosaic, filtered(plane, next(iter(filters.taps.values()))))
    elif filters.taps:
        plane = cut_of(mosaic, shown, labels)
        toned = {i: filters.placed(i, plane) for i, plane in toned.items()}
    expected = ExpectedMosaic(
        plane, unfiltered, labels, shown, toned, shares, filters, cutting.was_mosaic_compressed,
        _spoilt_ends(sources, labels),
    ).of_sources(sources.source_of)
    if sources.mosaic.valid is None:
        return expected
    return replace(expected, labels=np.where(sources.mosaic.valid, expected.labels, np.uint8(UNKNOWN)))


def _spoilt_ends(sources: PlacedSources, labels: np.ndarray) -> np.ndarray | None:
    """Ground of compressed sources beside their ends, (rows, columns) bool, None where none ends: squares of JPEG hold
    there what it makes of the step to what lies beyond, which on weak ground is more than the detail."""
    ends = [
        (labels == plane) & widened(~sources.valid[plane], JPEG_SQUARE_PX)
        for plane in sources.valid if sources.images[sources.source_of[plane]].raster.is_lossy
    ]
    return np.logical_or.reduce(ends) if ends else None


@dataclass(frozen=True, eq=False)
class _Cut:
    """The plane that every pixel follows, and what came over them."""

    labels: np.ndarray
    in_tone: Mapping[int, Levelled]
    """Planes that any pixel follows, in the mosaic's grey values."""
    filters: Filters


@dataclass(frozen=True, eq=False)
class _Cutting:
    """Cuts sources as a mosaic follows them."""

    sources: PlacedSources
    closeness: Closeness

    @cached_property
    def was_mosaic_compressed(self) -> bool:
        return was_compressed(self.sources.mosaic.plane)

    @cached_property
    def is_compressed(self) -> IsCompressed:
        """See ``compressed_sides``."""
        sources = self.sources  # self would stay alive
        return compressed_sides(self.was_mosaic_compressed, sources.planes.__getitem__, sources.following.followed)

    def cut(self, filters: Filters | None) -> _Cut:
        """The cut by what is known of what came over the sources, else by what is learned here of that."""
        likely, known = self._most_likely(filters), self.sources.known
        is_unknown = likely.unexplained & (not self.closeness.has_warped)
        labels = np.where(is_unknown, np.uint8(UNKNOWN), likely.labels)
        labels = labels if known is None else np.where(known == UNKNOWN, labels, known)
        mixed, clear = self.sources.following.mixed, self.sources.clear
        unmixed = _sure(np.where(mixed, np.uint8(UNKNOWN), labels), clear)
        # A part of a block is too small to tell tones where sources may be mixed.
        sure = clear if self.closeness.patch_px else unmixed
        planes = dict(enumerate(self.sources.planes))
        in_tone = _in_tone(self.sources.mosaic.plane, planes, labels, sure, self.closeness.patch_px)
        if filters is None:
            mosaic, *fine = self.sources.fine
            filters = find_filters(mosaic, dict(enumerate(fine)), in_tone, labels, _sure(labels, unmixed))
            return self._mixed(_Cut(labels, in_tone, filters))
        return _Cut(labels, in_tone, filters)

    def _mixed(self, cut: _Cut) -> _Cut:
        """The cut with the tones and filters of two sources that are mixed nearly everywhere, if they are."""
        labels, in_tone, filters = cut.labels, cut.in_tone, cut.filters
        if len(in_tone) < 2:
            return cut
        mosaic, *fine = self.sources.fine
        images = {i: source.gain * fine[i] for i, source in in_tone.items()}
        shown = cut_of(mosaic, {i: filters.applied(i, image) for i, image in images.items()}, labels)
        energy, rest = np.square(mosaic), np.square(mosaic - shown)
        parts = {i: labels == i for i in in_tone}
        counts = {
            i: int(np.count_nonzero(part)) for i, part in parts.items()
            if rest[part].sum() > MIN_LEFT_MIXED * energy[part].sum()
        }
        pair = sorted(counts, key=lambda i: -counts[i])[:2]
        if len(pair) < 2 or sum(counts[i] for i in pair) < MIN_MIXED_SHARE * labels.size:
            return cut
        where = is_one_of(labels, pair)
        for valid in (self.sources.mosaic.valid, *(self.sources.valid.get(i) for i in pair)):
            where &= True if valid is None else valid
        mixed = mixed_filters(mosaic, [images[i] for i in pair], where, shown)
        if mixed is None:
            return cut
        gain, taps = mixed
        means = square_means(self.sources.mosaic.plane)
        toned = {i: levelled_by(means, self.sources.planes[i], parts[i], gain * in_tone[i].gain) for i in pair}
        by_source = {i: filters.taps.get(i, UNTOUCHED) for i in in_tone}
        return _Cut(labels, {**in_tone, **toned}, Filters({**by_source, **dict(zip(pair, taps))}, False))

    def _most_likely(self, filters: Filters | None) -> LikelySource:
        """The most likely plane of every pixel, of those that are followed at first.

        Without ``filters`` what came over each is learned where it is followed, and as that is told better with it,
        learned anew until it settles; what leaves least of the mosaic over counts.
        """
        first = self.sources.following
        mosaic, *planes = self.sources.fine
        fine = {i: planes[i] for i in sorted(first.followed)}
        labels, clear = first.labels, self.sources.clear
        if filters is not None:
            return self._likely({i: filters.applied(i, plane) for i, plane in fine.items()}, labels, clear)
        tried = []
        for _ in range(_ROUNDS):
            winners = {i: fine[i] for i in fine if (labels == i).any()}
            shown = {i: through_filter(mosaic, plane, _surest(labels == i, clear)) for i, plane in winners.items()}
            likely = self._likely(shown, labels, clear)
            tried.append(likely)
            changed, labels = np.count_nonzero(likely.labels != labels) / labels.size, likely.labels
            if changed < _SETTLED or len(winners) < 2 or all(shown[i] is winners[i] for i in winners):
                break
            clear = ~(likely.unexplained | near_border(labels, _UNSURE_PX))
        return min(tried, key=lambda likely: likely.left_over)

    def _likely(self, shown: Mapping[int, np.ndarray], labels: np.ndarray, clear: np.ndarray) -> LikelySource:
        sources = self.sources
        fine = FineDetail(sources.fine[0], shown, sources.valid, self.is_compressed)
        return likely_source(fine, labels, clear, self.closeness.sampling)


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
    mosaic: np.ndarray, planes: Mapping[int, np.ndarray], labels: np.ndarray, within: np.ndarray, patch_px: int
) -> tuple[np.ndarray, Filters]:
    """The expected mosaic where labels are known for sure and no seam is near, ``UNKNOWN`` elsewhere: (rows, columns)
    float32; and what came over the mosaic.

    ``within``: pixels a filter may be taken from. ``patch_px``: side of the patches that all of them consist of.
    """
    sure = labels != UNKNOWN
    in_tone = _in_tone(mosaic, planes, labels, sure, patch_px)
    fine = {i: high_pass(plane) for i, plane in planes.items()}
    filters = find_filters(high_pass(mosaic), fine, in_tone, labels, sure & within)
    return cut_of(mosaic, {i: filters.applied(i, source.plane) for i, source in in_tone.items()}, labels), filters


def _in_tone(
    mosaic: np.ndarray, planes: Mapping[int, np.ndarray], labels: np.ndarray, clear: np.ndarray, patch_px: int
) -> dict[int, Levelled]:
    """The sources that any pixel follows, in the mosaic's grey values."""
    means = square_means(mosaic)
    return {i: levelled(means, planes[i], labels == i, clear, patch_px // TONE_PX) for i in present(labels)}
