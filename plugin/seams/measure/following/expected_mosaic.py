"""What a mosaic would look like if its sources had been cut hard where it passes from one to another.

Everything that was done to the whole of it is in it: tones source by source, and sharpening, blur or resampling as a
linear filter. What the mosaic lacks beside it was lost at the seams.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..seam_cells import UNKNOWN
from .border import BORDER_PX, smooth_border, to_the_pixel
from .boxes import near_border
from .followed_source import FollowedSource
from .levelling import SQUARE_PX, Levelled, levelled, square_means
from .likely_source import FINE, LikelySource, Sampling, likely_source
from .mosaic_filter import FEWEST_PIXELS, filtered, fit_filter

MIN_FILTERED_GAIN = 0.002  # of the fine detail that a filter has to explain more to be applied
MAX_LEFT_UNFILTERED = 0.005  # of the fine detail: with no more left over, labels are as sure without a filter
MIN_SINGLE_GAIN = 0.02  # of one source's detail, that a filter of its own has to explain more than one for all

_FEWEST_SAMPLES = 300
_ROUNDS = 3
_SETTLED = 0.005  # of the pixels: what changes less is settled
_UNSURE_PX = 12  # from a border that is not settled
_EVERY = 4  # rows and columns apart are looked at to see whether a filter explains more
_SAMPLE = np.s_[::_EVERY, ::_EVERY]


@dataclass(frozen=True, eq=False)
class ExpectedMosaic:
    """The hard cut as this mosaic would show it."""

    plane: np.ndarray
    """(rows, columns) float32; the mosaic itself where no source explains it."""
    unfiltered: np.ndarray
    """The same before anything came over the whole mosaic: in its tones, as sharp as its sources."""
    labels: np.ndarray
    """(rows, columns) uint8: the source of every pixel, ``UNKNOWN`` where none explains it."""
    shown: Mapping[int, np.ndarray]
    """(rows, columns) float32: each source that is followed, everywhere as this mosaic would show it."""
    toned: Mapping[int, np.ndarray]
    """The same before anything came over the whole mosaic; the very same where nothing did."""

    @property
    def is_filtered(self) -> bool:
        """Whether something came over it."""
        return any(self.toned[i] is not plane for i, plane in self.shown.items())

    def of_sources(self, source_of: Sequence[int]) -> ExpectedMosaic:
        """With the numbers of sources for those of planes, several of which may be of one source."""
        numbers = np.full(UNKNOWN + 1, UNKNOWN, np.uint8)
        numbers[: len(source_of)] = source_of
        most_first = sorted(self.shown, key=lambda plane: -np.count_nonzero(self.labels == plane))
        shown: dict[int, np.ndarray] = {}
        toned: dict[int, np.ndarray] = {}
        for plane in most_first:
            for pixels, found in ((self.shown[plane], shown), (self.toned[plane], toned)):
                before = found.get(source_of[plane])
                found[source_of[plane]] = pixels if before is None else np.where(self.labels == plane, pixels, before)
        return replace(self, labels=numbers[self.labels], shown=shown, toned=toned)


@dataclass(frozen=True, eq=False)
class Filters:
    """What makes of the sources what the mosaic shows of them."""

    taps: Mapping[int, np.ndarray]
    """Of each source that is followed, (5, 5); empty where nothing was done to them."""
    came_over_cuts: bool
    """Whether it was done to the mosaic, its cuts included, and not to the sources before."""

    def applied(self, source: int, plane: np.ndarray) -> np.ndarray:
        """A source's plane as the mosaic shows it."""
        return filtered(plane, self.taps[source]) if self.taps else plane


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
) -> ExpectedMosaic:
    """Planes (rows, columns) float32 of the mosaic and its sources, ``following`` a first estimate.

    ``fine``: the fine detail of the mosaic, then of the sources (``high_pass``).

    ``valid``: pixels that a source has, of those that don't have all. ``known``: labels that are known, else
    ``UNKNOWN``; they go before the estimate.
    ``filters``: what came over the mosaic, where that is known from more ground than there is here. ``sampling``: how
    closely sources are told from each other. ``patch_px``: as for ``mosaic_of``, whose ground this is compared with.
    ``has_warped``: whether a source was warped to the mosaic's grid, which explains it no better than another image.
    ``given``: the planes before any of them was moved, where that was done.
    """
    own, sources = fine[0], {i: fine[1 + i] for i in sorted(following.followed)}
    likely = _likely(own, sources, following, valid, filters, sampling)
    labels = likely.labels if has_warped else likely.labels | (likely.unexplained * np.uint8(UNKNOWN))
    if known is not None:
        labels = np.where(known == UNKNOWN, labels, known)
    unmixed = _sure(labels, ~following.mixed, following.clear)
    in_tone = _in_tone(mosaic, dict(enumerate(planes)), labels, _sure(labels, labels != UNKNOWN, unmixed), patch_px)
    toned = {i: one.plane for i, one in in_tone.items()}
    found = filters
    if found is None:
        found = _find_filters(own, dict(enumerate(fine[1:])), in_tone, labels, unmixed)
    shown = {i: found.applied(i, plane) for i, plane in toned.items()}
    if known is None and len(toned) > 1:
        labels = smooth_border(to_the_pixel(mosaic, shown, labels, valid))
    cut = _cut(mosaic, toned, labels)
    unfiltered = cut
    if given is not None:  # to be moved by parts of a pixel costs detail as well
        unmoved = {i: one.plane + one.gain * (given[i] - planes[i]) for i, one in in_tone.items()}
        unfiltered = _cut(mosaic, unmoved, labels)
    if not found.taps:
        return ExpectedMosaic(cut, unfiltered, labels, shown, shown)
    if not found.came_over_cuts:
        return ExpectedMosaic(_cut(mosaic, shown, labels), unfiltered, labels, shown, toned)
    plane = filtered(cut, next(iter(found.taps.values())))
    return ExpectedMosaic(np.where(labels == UNKNOWN, mosaic, plane), unfiltered, labels, shown, toned)


def _likely(
    own: np.ndarray, sources: Mapping[int, np.ndarray], following: FollowedSource, valid: Mapping[int, np.ndarray],
    filters: Filters | None, sampling: Sampling,
) -> LikelySource:
    """The most likely source of every pixel. What came over each is learned where it is followed, and as that is told
    better with it, learned anew until it settles; what leaves least of the mosaic over counts."""
    if filters is not None:
        shown = {i: filters.applied(i, one) for i, one in sources.items()}
        return likely_source(own, shown, following.labels, following.clear, valid, sampling)
    labels, clear, best = following.labels, following.clear, None
    for _ in range(_ROUNDS):
        present = {i: one for i, one in sources.items() if (labels == i).any()}
        shown = {i: _through_filter(own, one, _surest(labels == i, clear)) for i, one in present.items()}
        likely = likely_source(own, shown, labels, clear, valid, sampling)
        changed, labels = np.count_nonzero(likely.labels != labels) / labels.size, likely.labels
        if best is None or likely.left < best.left:
            best = likely
        if changed < _SETTLED or len(present) < 2 or all(shown[i] is present[i] for i in present):
            break
        clear = ~(likely.unexplained | near_border(labels, _UNSURE_PX))
    assert best is not None
    return best


def _sure(labels: np.ndarray, among: np.ndarray, clear: np.ndarray) -> np.ndarray:
    """``among`` some pixels those that are clear, or all of a source of which that is too little, (rows, columns)."""
    parts = (_surest((labels == i) & among, clear) for i in _present(labels))
    return np.logical_or.reduce([np.zeros(labels.shape, bool), *parts])


def _surest(part: np.ndarray, clear: np.ndarray) -> np.ndarray:
    """What is clear of a part, or all of it where that is too little to learn from."""
    sure = part & clear
    return sure if np.count_nonzero(sure) >= FEWEST_PIXELS else part


def mosaic_of(
    mosaic: np.ndarray,
    planes: Mapping[int, np.ndarray],
    own: np.ndarray,
    fine: Mapping[int, np.ndarray],
    labels: np.ndarray,
    within: np.ndarray,
    patch_px: int,
) -> tuple[np.ndarray, Filters]:
    """The same where labels are known for sure and no seam is near, ``UNKNOWN`` elsewhere: (rows, columns) float32;
    and what came over the mosaic.

    ``own``, ``fine``: the fine detail of the mosaic and of the sources. ``within``: pixels a filter may be taken from.
    ``patch_px``: side of the patches that all of them consist of.
    """
    sure = labels != UNKNOWN
    in_tone = _in_tone(mosaic, planes, labels, sure, patch_px)
    found = _find_filters(own, fine, in_tone, labels, sure & within)
    return _cut(mosaic, {i: found.applied(i, one.plane) for i, one in in_tone.items()}, labels), found


def _in_tone(
    mosaic: np.ndarray, planes: Mapping[int, np.ndarray], labels: np.ndarray, clear: np.ndarray, patch_px: int
) -> dict[int, Levelled]:
    """The sources that any pixel follows, in the mosaic's grey values."""
    means = square_means(mosaic)
    return {i: levelled(means, planes[i], labels == i, clear, patch_px // SQUARE_PX) for i in _present(labels)}


def _find_filters(
    own: np.ndarray, fine: Mapping[int, np.ndarray], in_tone: Mapping[int, Levelled], labels: np.ndarray,
    sure: np.ndarray,
) -> Filters:
    """What has to be done to the sources in the mosaic's tones."""
    # The gain is even enough to be taken for the same within the reach of a high-pass.
    def reference(place: slice | tuple[slice, ...]) -> np.ndarray:
        return _cut(own[place], {i: one.gain[place] * fine[i][place] for i, one in in_tone.items()}, labels[place])

    if _is_a_multiple(own[_SAMPLE], reference(_SAMPLE), labels[_SAMPLE], sure[_SAMPLE]):
        return Filters({}, False)
    return _fitted_filters(own, reference(np.s_[:]), labels, sure)


def _present(labels: np.ndarray) -> list[int]:
    """The sources that any pixel follows."""
    left, found = int(np.count_nonzero(labels != UNKNOWN)), []
    for number in range(UNKNOWN):
        if not left:
            break
        if count := int(np.count_nonzero(labels == number)):
            found.append(number)
            left -= count
    return found


def _cut(mosaic: np.ndarray, planes: Mapping[int, np.ndarray], labels: np.ndarray) -> np.ndarray:
    """Each pixel from the plane that its label names; the mosaic's own where none is."""
    if not planes:
        return mosaic.copy()
    first, *others = sorted(planes, key=lambda i: -np.count_nonzero(labels == i))
    made = planes[first].copy()
    for i in others:
        np.copyto(made, planes[i], where=labels == i)
    unknown = labels == UNKNOWN
    if unknown.any():
        np.copyto(made, mosaic, where=unknown)
    return made


def _fitted_filters(
    fine: np.ndarray, reference: np.ndarray, labels: np.ndarray, sure: np.ndarray
) -> Filters:
    """One filter for all sources, or one for each where that explains more; none where none is needed."""
    taps = fit_filter(fine, reference, sure, gain=1.0)
    if taps is None:
        return Filters({}, False)
    common = filtered(reference, taps)
    if not _explains_more(fine, reference, common, sure):
        return Filters({}, False)
    numbers = _present(labels)
    if len(numbers) > 1:
        parts = {i: sure & (labels == i) for i in numbers}
        fitted = {i: fit_filter(fine, reference, part, gain=1.0) for i, part in parts.items()}
        single = {i: one for i, one in fitted.items() if one is not None}
        if len(single) == len(numbers) and any(
            _explains_more(fine, common, filtered(reference, single[i]), part, MIN_SINGLE_GAIN)
            for i, part in parts.items()
        ):
            return Filters(single, False)
    return Filters(dict.fromkeys(numbers, taps), True)


def _through_filter(mosaic: np.ndarray, source: np.ndarray, where: np.ndarray) -> np.ndarray:
    """A source's fine detail as the mosaic shows it."""
    own = where[_SAMPLE]
    if _is_a_multiple(mosaic[_SAMPLE], source[_SAMPLE], own.astype(np.uint8), own, MAX_LEFT_UNFILTERED):
        return source
    taps = fit_filter(mosaic, source, where)
    if taps is None:
        return source
    made = filtered(source, taps)
    return made if _explains_more(mosaic, source, made, where) else source


def _is_a_multiple(
    mosaic: np.ndarray, plain: np.ndarray, labels: np.ndarray, where: np.ndarray, most: float = MIN_FILTERED_GAIN
) -> bool:
    """Whether so little of the mosaic is left over by a multiple of the plain image that no filter is called for;
    samples of all of them.

    Beside a border, which is known to a few pixels only, nothing can be told of that.
    """
    parts = np.where(where, labels, np.uint8(UNKNOWN))
    inside = (parts != UNKNOWN) & ~near_border(parts, -(-BORDER_PX // _EVERY))
    own, before = _chosen(inside, mosaic, plain)
    return len(own) > _FEWEST_SAMPLES and _left_by_multiple(own, before) <= most * float(own @ own)


def _explains_more(
    mosaic: np.ndarray, plain: np.ndarray, made: np.ndarray, where: np.ndarray, least: float = MIN_FILTERED_GAIN
) -> bool:
    """Whether less of the mosaic is left over by a filtered image than by a mere multiple of the plain one."""
    own, before, after = _chosen(where[_SAMPLE], *(image[_SAMPLE] for image in (mosaic, plain, made)))
    rest = own - after
    return float(rest @ rest) < _left_by_multiple(own, before) - least * float(own @ own)


def _left_by_multiple(own: np.ndarray, plain: np.ndarray) -> float:
    rest = own - float(own @ plain) / max(float(plain @ plain), 1e-12) * plain
    return float(rest @ rest)


def _chosen(where: np.ndarray, *images: np.ndarray) -> list[np.ndarray]:
    places = np.flatnonzero(where)
    return [image.ravel()[places].astype(np.float64) for image in images]
