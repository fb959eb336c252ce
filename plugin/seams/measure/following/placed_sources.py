"""The sources that a mosaic follows, though they may not lie where it does.

Where the sources as they are given explain it badly, they are tried once more where the mosaic lies on them.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from scipy import ndimage

from ....imagery.shifts import Shift, farthest_apart, find_shift, shifted
from ..compared_image import ComparedImage
from ..seam_cells import UNKNOWN
from .boxes import narrowed
from .followed_source import HIGH_PASS_PX, FollowedSource, follow_planes, high_pass
from .source_filters import REACH_PX, UNFILTERED, Filters, filtered, fit_filter

MIN_SOURCE_FIT = 0.9  # share of the mosaic's fine detail that its sources explain; below it shifts are looked for
MIN_UNEXPLAINED_SHARE = 0.02  # of the pixels: a part of a window this large is looked at for a shift of its own
MIN_MOVED_PX = 0.15  # by which a source is moved to be tried again
FARTHEST_FILTERED_PX = 1.2  # a filter of 5 x 5 taps moves an image as far
ALIKE_SHIFTS_PX = 0.2
MIN_BOTH_SHARE = 0.05  # of the pixels: an image that lies where it should and also elsewhere is kept in both places
MAX_LEFT = 0.5  # of what was left over, when moved sources explain a part that had none
MAX_UNCLEAR_LEFT = 0.7  # of what was unclear, when filters tell more
MIN_UNCLEAR_SHARE = 0.3  # of the pixels: a filter may tell more
MIN_FIT_GAIN = 0.1  # by which shifted sources have to explain more to be believed
MIN_IDLE_FIT = 0.97  # of the fine detail: with less, one that is hardly followed is looked for elsewhere


@dataclass(frozen=True, eq=False)
class PlacedSources:
    """A mosaic, and planes of its sources: as they are given, and of some moved to where it lies."""

    mosaic: ComparedImage
    images: tuple[ComparedImage, ...]
    """The sources as they are given."""
    following: FollowedSource
    """The plane that the mosaic follows, by a first estimate."""
    planes: tuple[np.ndarray, ...]
    fine: tuple[np.ndarray, ...]
    """The fine detail of the mosaic, then of the planes."""
    source_of: tuple[int, ...]
    """Number of the source that each plane is of."""
    moves: Mapping[int, Shift] = field(default_factory=dict)
    """Shifts of those planes that were moved."""
    known: np.ndarray | None = None
    """(rows, columns) uint8: the plane of every pixel where it is known, else ``UNKNOWN``; None: nowhere."""

    @cached_property
    def valid(self) -> dict[int, np.ndarray]:
        """Pixels that a plane has, (rows, columns) bool, of those that don't have all."""
        masks = (self.images[of].valid for of in self.source_of)
        return {plane: mask for plane, mask in enumerate(masks) if mask is not None}

    @cached_property
    def clear(self) -> np.ndarray:
        """(rows, columns) bool: where one plane is followed for sure. What fills the mosaic where it has no pixels must
        tell nothing of tones and filters."""
        valid = self.mosaic.valid
        clear = self.following.clear
        return clear if valid is None else clear & narrowed(valid, HIGH_PASS_PX + REACH_PX)

    def with_known(self, known: np.ndarray | None) -> PlacedSources:
        """These sources with labels that are known, numbers of sources, (rows, columns) uint8, else ``UNKNOWN``."""
        if known is None:
            return self
        first_plane = np.full(UNKNOWN + 1, UNKNOWN, np.uint8)
        first_plane[list(self.source_of[::-1])] = np.arange(len(self.source_of), dtype=np.uint8)[::-1]
        return replace(self, following=self.following.with_known(first_plane[known]), known=first_plane[known])


def follow_given(
    image: ComparedImage, images: Sequence[ComparedImage], filters: Filters = UNFILTERED
) -> PlacedSources:
    """What the mosaic follows of sources where they are given; ``filters``: what came over it, as far as known."""
    planes = tuple(map(_continued, images))
    fine = _fine_details(image, (image.plane, *planes))
    following = follow_planes([fine[0], *(filters.applied(i, plane) for i, plane in enumerate(fine[1:]))])
    return PlacedSources(image, tuple(images), following, planes, fine, tuple(range(len(planes))))


def _continued(image: ComparedImage) -> np.ndarray:
    """A source's plane that goes on as it ends where it has no pixels: any other filling would end in a step."""
    if image.valid is None:
        return image.plane
    return image.plane[tuple(ndimage.distance_transform_edt(~image.valid, return_distances=False, return_indices=True))]


def _fine_details(mosaic: ComparedImage, planes: Sequence[np.ndarray]) -> tuple[np.ndarray, ...]:
    """Planes high-passed; 0 where the mosaic has no pixels, since what fills it there ends in a step, which would be
    detail that no source has."""
    fine = tuple(map(high_pass, planes))
    if mosaic.valid is None:
        return fine
    known = narrowed(mosaic.valid, HIGH_PASS_PX)
    return tuple(plane * known for plane in fine)


def follow_sources(image: ComparedImage, images: Sequence[ComparedImage]) -> PlacedSources:
    """What the mosaic follows; where that explains it badly, once more with the sources also moved to where it lies."""
    first = _clearer_in_window(follow_given(image, images))
    plain = first.following
    unexplained = float(plain.unexplained.mean())
    # Where another source fits well, one that lies elsewhere is hardly followed.
    idle = {i for i, share in enumerate(plain.shares) if share < MIN_BOTH_SHARE}
    may_lie_elsewhere = bool(idle) and plain.fit < MIN_IDLE_FIT
    if plain.fit >= MIN_SOURCE_FIT and unexplained < MIN_UNEXPLAINED_SHARE and not may_lie_elsewhere:
        return first
    # The part may be too small, or show nothing: then the whole window.
    shifts = {i: (find_shift(image.spectra, other.spectra, plain.unexplained) if unexplained else None)
              or find_shift(image.spectra, other.spectra) for i, other in enumerate(images)}
    moved = {i: s for i, s in shifts.items() if s is not None and s.length >= MIN_MOVED_PX}
    if not moved:
        return first
    followed = [i for i in plain.followed if i not in idle]
    of_followed = [find_shift(image.spectra, images[i].spectra, plain.labels == i) for i in followed]
    if unexplained >= MIN_UNEXPLAINED_SHARE or may_lie_elsewhere:
        of_followed += [s for i, s in moved.items() if i in idle or s.length > FARTHEST_FILTERED_PX]
    if _is_of_all(of_followed):
        return first
    both = _without_idle_planes(_with_moved(first, moved))
    by_moved = both.following
    explains_part = unexplained >= MIN_UNEXPLAINED_SHARE and by_moved.unexplained.mean() <= MAX_LEFT * unexplained
    finds_idle = may_lie_elsewhere and 1 - by_moved.fit <= MAX_LEFT * (1 - plain.fit)
    is_better = by_moved.fit >= plain.fit + MIN_FIT_GAIN
    return both if explains_part or finds_idle or is_better else first


def _with_moved(given: PlacedSources, moved: Mapping[int, Shift]) -> PlacedSources:
    """Sources with planes of some that are moved, too."""
    placed = tuple(shifted(given.planes[i], shift.x, shift.y) for i, shift in moved.items())
    fine = (*given.fine, *_fine_details(given.mosaic, placed))
    return replace(
        given, following=follow_planes(fine), planes=(*given.planes, *placed), fine=fine,
        source_of=(*given.source_of, *moved), moves=dict(enumerate(moved.values(), len(given.planes))),
    )


def _clearer_in_window(given: PlacedSources) -> PlacedSources:
    """Images of one scene that lie on other pixels than the mosaic are more like each other than like it: a filter is
    learned of the whole window, of which a part follows its source."""
    if given.following.unclear_share < MIN_UNCLEAR_SHARE or len(given.images) < 2:
        return given
    everywhere = np.ones(given.fine[0].shape, bool)
    (mosaic, *fine), through = given.fine, []
    for number, plane in enumerate(fine):
        taps = fit_filter(mosaic, plane, given.valid.get(number, everywhere))
        through.append(plane if taps is None else filtered(plane, taps))
    plain, clearer = given.following, follow_planes([mosaic, *through])
    is_clearer = clearer.unclear_share <= MAX_UNCLEAR_LEFT * plain.unclear_share and clearer.fit >= plain.fit
    return replace(given, following=clearer) if is_clearer else given


def _is_of_all(shifts: Sequence[Shift | None]) -> bool:
    """Whether the mosaic lies as far off all sources that it follows, so near that a filter tells it better."""
    known = [shift for shift in shifts if shift is not None]
    if not known or max(shift.length for shift in known) > FARTHEST_FILTERED_PX:
        return False
    return farthest_apart(known) < ALIKE_SHIFTS_PX


def _without_idle_planes(both: PlacedSources) -> PlacedSources:
    """Sources without the planes that hardly won: an image mixed with itself a bit farther on is no mixture of two."""
    shares = both.following.shares
    of_source = {i: max(shares[k] for k, of in enumerate(both.source_of) if of == i) for i in both.source_of}
    kept = [k for k, of in enumerate(both.source_of) if shares[k] == of_source[of] or shares[k] >= MIN_BOTH_SHARE]
    if len(kept) == len(both.source_of):
        return both
    fine = (both.fine[0], *(both.fine[1 + k] for k in kept))
    return replace(
        both, following=follow_planes(fine), planes=tuple(both.planes[k] for k in kept), fine=fine,
        source_of=tuple(both.source_of[k] for k in kept),
        moves={place: both.moves[k] for place, k in enumerate(kept) if k in both.moves},
    )
