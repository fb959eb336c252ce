"""The hard cut of the sources that the mosaic follows in a window: what it is compared with, and what can be shown."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..compared_image import ComparedImage, MeasuredClip, judged_planes, on_common_bands
from ..profile.window_detail import WindowDetail, window_detail
from ..seam_cells import UNKNOWN
from ..tone import Tone
from .composite import Composite, follows_at, make_composite
from .expected_mosaic import ExpectedMosaic, expected_mosaic
from .followed_source import FollowedSource
from .likely_source import MIN_FIT
from .placed_sources import PlacedSources, follow_sources

MIN_EXPLAINED_SHARE = 0.05  # of the pixels: with less there is nothing to compare with


@dataclass(frozen=True, eq=False)
class HardCut:
    """A window of the mosaic and its sources on their common bands, and which of them every pixel follows."""

    mosaic: ComparedImage
    sources: tuple[ComparedImage, ...]
    following: FollowedSource
    tones: tuple[dict[str, Tone | None], ...]
    """What became of each source's grey values in the mosaic, by band."""
    composite: Composite
    around: JudgedGround
    """The judged band, with the ground that was read around the window."""
    inside: tuple[slice, slice]
    """Rows and columns of the window in that."""

    @property
    def labels(self) -> np.ndarray:
        """(rows, columns) uint8: the source of every pixel of the window, ``UNKNOWN`` where none explains it."""
        return self.around.expected.labels[self.inside]

    @property
    def explained(self) -> float:
        """Share of the window's pixels whose fine detail the sources explain."""
        return _explained(self.labels)

    @property
    def is_unclear(self) -> bool:
        """Whether the sources say too little of the mosaic for the cut to mean anything."""
        return is_unclear(self.following, self.labels)


@dataclass(frozen=True, eq=False)
class JudgedGround:
    """The judged band of a window and of the ground around it."""

    mosaic: ComparedImage
    sources: tuple[ComparedImage, ...]
    followed: PlacedSources
    expected: ExpectedMosaic
    """What the mosaic would look like; its labels are those of the sources."""
    labels: np.ndarray
    """(rows, columns) uint8: the source of every pixel for a composite, which has one everywhere."""

    def detail(self, wavelet: str, levels: int, inside: tuple[slice, slice]) -> WindowDetail:
        """What the mosaic has of its sources' detail; ``inside``: rows and columns that are judged."""
        valid = {i: one.valid for i, one in enumerate(self.sources) if one.valid is not None}
        return window_detail(self.mosaic.plane, self.expected, valid, wavelet, levels, inside)


def judged_ground(
    image: ComparedImage, images: Sequence[ComparedImage], known: np.ndarray | None
) -> JudgedGround:
    """Follow the mosaic through its sources. ``known``: as for ``cut_hard``, of all that was read."""
    followed = follow_sources(image, images, known is None)
    if known is not None:
        known = _of_planes(known, followed.source_of)
        followed = replace(followed, following=followed.following.with_known(known))
    valid = {i: mask for i, of in enumerate(followed.source_of) if (mask := images[of].valid) is not None}
    following = followed.following
    if image.valid is not None:  # what fills the mosaic where it has no pixels must tell nothing of tones and filters
        following = replace(following, clear=following.clear & image.valid)
    given = [images[of].plane for of in followed.source_of]
    is_moved = any(one is not plane for one, plane in zip(given, followed.planes))
    found = expected_mosaic(
        image.plane, followed.planes, followed.fine, following, valid, known, given=given if is_moved else None
    )
    found = found.of_sources(followed.source_of)
    labels = found.labels
    if image.valid is not None:
        labels[~image.valid] = UNKNOWN
    if (labels == UNKNOWN).all():
        labels = np.array(followed.source_of, np.uint8)[followed.following.labels]
    return JudgedGround(image, tuple(images), followed, found, labels)


def cut_hard(
    mosaic: MeasuredClip, sources: Sequence[MeasuredClip], levels: int, labels: np.ndarray | None = None
) -> HardCut:
    """Cut at least one source as the mosaic follows it.

    ``labels``, (rows, columns) uint8 of all that was read, says which source each pixel was taken from where that is
    known, else ``seam_cells.UNKNOWN``.
    """
    own, *others = judged_planes((mosaic, *sources))
    around = judged_ground(own, others, labels)
    rows, columns = own.plane.shape
    inside = mosaic.inside or (slice(0, rows), slice(0, columns))
    image, *images = on_common_bands((mosaic, *sources), levels)
    following = _within(around, inside)
    found = around.labels[inside]
    tones = [image.tones_of(other, _where_followed(following, i, levels)) for i, other in enumerate(images)]
    composite = make_composite(image.bands, [other.bands for other in images], image.names, found, tones)
    return HardCut(image, tuple(images), following, tuple(tones), composite, around, inside)


def is_unclear(following: FollowedSource, labels: np.ndarray) -> bool:
    """Whether the sources say too little of the mosaic; ``labels`` are those of the expected one."""
    return following.fit < MIN_FIT or _explained(labels) < MIN_EXPLAINED_SHARE


def _of_planes(labels: np.ndarray, source_of: Sequence[int]) -> np.ndarray:
    """Labels of sources as those of the first planes that are of them."""
    numbers = np.full(UNKNOWN + 1, UNKNOWN, np.uint8)
    numbers[list(source_of[::-1])] = np.arange(len(source_of), dtype=np.uint8)[::-1]
    return numbers[labels]


def _explained(labels: np.ndarray) -> float:
    """Share of the pixels with a label."""
    return int(np.count_nonzero(labels != UNKNOWN)) / labels.size


def _within(around: JudgedGround, inside: tuple[slice, slice]) -> FollowedSource:
    """The first estimate with better labels, of the window alone."""
    first, labels = around.followed.following, around.labels[inside]
    shares = tuple(int(np.count_nonzero(labels == i)) / labels.size for i in range(len(around.sources)))
    mixed = first.mixed[inside]
    return replace(
        first, labels=labels, shares=shares, clear=first.clear[inside], mixed=mixed, mixed_share=float(mixed.mean()),
        unexplained=first.unexplained[inside],
    )


def _where_followed(following: FollowedSource, source: int, levels: int) -> np.ndarray:
    """Squares of 2^R px from which a source's tone is taken; all of one that is not followed."""
    where = follows_at(following, source, levels)
    return where if source in following.followed else np.ones_like(where)
