"""Which of its sources a mosaic follows, though they may not lie where it does.

Where the sources as they are given explain it badly, they are tried once more where the mosaic lies on them.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from ....imagery.shifts import Shift, Spectra, farthest_apart, find_shift, shifted
from ..compared_image import ComparedImage
from .followed_source import FollowedSource, follow_planes, high_pass
from .source_filters import filtered, fit_filter

MIN_SOURCE_FIT = 0.9  # share of the mosaic's fine detail that its sources explain; below it shifts are looked for
MIN_UNEXPLAINED_SHARE = 0.02  # of the pixels: a part of a window this large is looked at for a shift of its own
MIN_MOVED_PX = 0.15  # by which a source is moved to be tried again
FARTHEST_FILTERED_PX = 1.2  # a filter of 5 x 5 taps moves an image as far
ALIKE_SHIFTS_PX = 0.2
MIN_BOTH_SHARE = 0.05  # of the pixels: an image that lies where it should and also elsewhere is kept in both places
MAX_UNCLEAR_LEFT = 0.7  # of what was unclear, when moved sources tell more
MIN_UNCLEAR_SHARE = 0.3  # of the pixels: sources moved to where the mosaic lies may tell more
MIN_FIT_GAIN = 0.1  # by which shifted sources have to explain more to be believed
MIN_IDLE_FIT = 0.97  # of the fine detail: with less, one that is hardly followed is looked for elsewhere
MAX_IDLE_LEFT = 0.5  # of what was left over, when it is found there


@dataclass(frozen=True, eq=False)
class PlacedSources:
    """What the mosaic follows: planes of the sources, and some of them moved to where it lies."""

    following: FollowedSource
    planes: tuple[np.ndarray, ...]
    fine: tuple[np.ndarray, ...]
    """The fine detail of the mosaic, then of the planes."""
    source_of: tuple[int, ...]
    """Number of the source that each plane is of."""
    moves: Mapping[int, Shift] = field(default_factory=dict)
    """Shifts of those planes that were moved."""


def follow_sources(image: ComparedImage, images: Sequence[ComparedImage]) -> PlacedSources:
    """What the mosaic follows; where that explains it badly, once more with the sources also moved to where it lies."""
    shape = (image.bands.shape[1], image.bands.shape[2])
    count = len(images)
    planes = tuple(one.plane for one in images)
    fine = tuple(high_pass(plane) for plane in (image.plane, *planes))
    plain = follow_planes(fine)
    plain = _clearer(plain, fine, images, shape)
    first = PlacedSources(plain, planes, fine, tuple(range(count)))
    unexplained, unclear = int(np.count_nonzero(plain.unexplained)) / plain.unexplained.size, plain.unclear_share
    # Where another source fits well, one that lies elsewhere is hardly followed.
    idle = {i for i, share in enumerate(plain.shares) if share < MIN_BOTH_SHARE}
    may_lie_elsewhere = bool(idle) and plain.fit < MIN_IDLE_FIT
    if plain.fit >= MIN_SOURCE_FIT and unexplained < MIN_UNEXPLAINED_SHARE and not may_lie_elsewhere:
        return first
    shifts = {i: _shift_where(image.spectra, other.spectra, plain.unexplained) for i, other in enumerate(images)}
    moved = {i: s for i, s in shifts.items() if s is not None and s.length >= MIN_MOVED_PX}
    if not moved:
        return first
    followed = [i for i in plain.followed if i not in idle]
    of_followed = [find_shift(image.spectra, images[i].spectra, plain.labels == i) for i in followed]
    if unexplained >= MIN_UNEXPLAINED_SHARE or may_lie_elsewhere:
        of_followed += [s for i, s in moved.items() if i in idle or s.length > FARTHEST_FILTERED_PX]
    if _is_of_all(of_followed):
        return first
    placed = tuple(shifted(planes[i], s.x, s.y) for i, s in moved.items())
    fine_placed = tuple(map(high_pass, placed))
    both = PlacedSources(
        follow_planes((*fine, *fine_placed)), (*planes, *placed), (*fine, *fine_placed), (*range(count), *moved),
        moves=dict(enumerate(moved.values(), count)),
    )
    with_moved = _without_idle_planes(both, shape)
    explains_part = unexplained >= MIN_UNEXPLAINED_SHARE and with_moved.following.unexplained.mean() <= unexplained / 2
    is_clearer = unclear >= MIN_UNCLEAR_SHARE and with_moved.following.unclear_share <= MAX_UNCLEAR_LEFT * unclear
    finds_idle = may_lie_elsewhere and 1 - with_moved.following.fit <= MAX_IDLE_LEFT * (1 - plain.fit)
    is_better = with_moved.following.fit >= plain.fit + MIN_FIT_GAIN
    return with_moved if explains_part or is_clearer or finds_idle or is_better else first


def _clearer(
    plain: FollowedSource, fine: Sequence[np.ndarray], images: Sequence[ComparedImage], shape: tuple[int, int]
) -> FollowedSource:
    """``plain``, or what is followed through filters if that is clearer: images of one scene that lie on other pixels
    than the mosaic are more like each other than like it. A filter is learned of the whole window, of which a part
    follows its source."""
    if plain.unclear_share < MIN_UNCLEAR_SHARE or len(images) < 2:
        return plain
    everywhere = np.ones(shape, bool)
    shown = [fine[0]]
    for source, image in zip(fine[1:], images):
        shown.append(_through_filter(fine[0], source, everywhere if image.valid is None else image.valid))
    by_filters = follow_planes(shown)
    return by_filters if by_filters.unclear_share <= MAX_UNCLEAR_LEFT * plain.unclear_share else plain


def clearer_by_parts(found: PlacedSources, parts: np.ndarray) -> PlacedSources:
    """``found``, or with what is followed through filters if that is clearer, where seams are known: ``parts``, (rows,
    columns) int, each of one source, whichever explains most of it, -1 elsewhere. A filter is learned where its source
    is followed."""
    own, *fine = found.fine
    followed = np.full(parts.shape, -1)
    for part in np.unique(parts[parts >= 0]).tolist():
        where = parts == part
        left = [float(np.square(own[where] - _through_filter(own, one, where)[where]).sum()) for one in fine]
        followed[where] = int(np.argmin(left))
    shown = [_through_filter(own, one, followed == i) for i, one in enumerate(fine)]
    made, plain = follow_planes((own, *shown)), found.following
    is_clearer = made.unclear_share <= MAX_UNCLEAR_LEFT * plain.unclear_share
    return replace(found, following=made) if is_clearer and made.fit >= plain.fit else found


def _through_filter(own: np.ndarray, one: np.ndarray, where: np.ndarray) -> np.ndarray:
    """A source's fine detail as the mosaic shows it in a part; itself where that is too little to learn from."""
    taps = fit_filter(own, one, where)
    return one if taps is None else filtered(one, taps)


def _is_of_all(shifts: Sequence[Shift | None]) -> bool:
    """Whether the mosaic lies as far off all sources that it follows, so near that a filter tells it better."""
    known = [shift for shift in shifts if shift is not None]
    if not known or max(shift.length for shift in known) > FARTHEST_FILTERED_PX:
        return False
    return farthest_apart(known) < ALIKE_SHIFTS_PX


def _without_idle_planes(both: PlacedSources, shape: tuple[int, int]) -> PlacedSources:
    """Sources without the planes that hardly won: an image mixed with itself a bit farther on is no mixture of two."""
    shares = both.following.shares
    of_source = {i: max(shares[k] for k, of in enumerate(both.source_of) if of == i) for i in both.source_of}
    kept = [k for k, of in enumerate(both.source_of) if shares[k] == of_source[of] or shares[k] >= MIN_BOTH_SHARE]
    if len(kept) == len(both.source_of):
        return both
    fine = (both.fine[0], *(both.fine[1 + k] for k in kept))
    return PlacedSources(
        follow_planes(fine), tuple(both.planes[k] for k in kept), fine, tuple(both.source_of[k] for k in kept),
        moves={place: both.moves[k] for place, k in enumerate(kept) if k in both.moves},
    )


def _shift_where(image: Spectra, reference: Spectra, where: np.ndarray) -> Shift | None:
    """Shift in the part where it matters; in the whole window where that part is too small or shows nothing."""
    return (find_shift(image, reference, where) if where.any() else None) or find_shift(image, reference)
