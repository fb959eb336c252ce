"""The hard cut of the sources that the mosaic follows in a window: what it is compared with, and what can be shown."""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..compared_image import ComparedImage, MeasuredClip, on_common_bands
from ..seam_cells import UNKNOWN
from ..tone import Tone
from .composite import Composite, follows_at, make_composite
from .expected_mosaic import ExpectedMosaic, expected_mosaic
from .followed_source import FollowedSource
from .placed_sources import PlacedSources, follow_sources

MIN_CAUSE_FIT = 0.05  # of the fine detail; strangers explain 0.01 to 0.03
MIN_EXPLAINED_SHARE = 0.05  # of the pixels: with less there is nothing to compare with


@dataclass(frozen=True, eq=False)
class HardCut:
    """A window of the mosaic and its sources on their common bands, and which of them every pixel follows."""

    mosaic: ComparedImage
    sources: tuple[ComparedImage, ...]
    expected: ExpectedMosaic
    """What the mosaic would look like; its labels are those of the sources."""
    following: FollowedSource
    tones: tuple[dict[str, Tone | None], ...]
    """What became of each source's grey values in the mosaic, by band."""
    composite: Composite

    @property
    def explained(self) -> float:
        """Share of the pixels whose fine detail the sources explain."""
        return _explained(self.expected.labels)

    @property
    def is_unclear(self) -> bool:
        """Whether the sources say too little of the mosaic for the cut to mean anything."""
        return is_unclear(self.following, self.expected.labels)


def cut_hard(
    mosaic: MeasuredClip, sources: Sequence[MeasuredClip], levels: int, labels: np.ndarray | None = None
) -> HardCut:
    """Cut at least one source as the mosaic follows it.

    ``labels``, (rows, columns) uint8, says which source each pixel was taken from where that is known, else
    ``seam_cells.UNKNOWN``.
    """
    image, *images = on_common_bands((mosaic, *sources), levels)
    followed = follow_sources(image, images)
    if labels is not None:
        labels = _of_planes(labels, followed.source_of)
        followed = replace(followed, following=followed.following.with_known(labels))
    expected, labels = expected_cut(image, images, followed, labels)
    following = _merged(followed, labels, len(images))
    tones = [image.tones_of(other, _where_followed(following, i, levels)) for i, other in enumerate(images)]
    composite = make_composite(image.bands, [other.bands for other in images], image.names, labels, tones)
    return HardCut(image, tuple(images), expected, following, tuple(tones), composite)


def is_unclear(following: FollowedSource, labels: np.ndarray) -> bool:
    """Whether the sources say too little of the mosaic; ``labels`` are those of the expected one."""
    return following.fit < MIN_CAUSE_FIT or _explained(labels) < MIN_EXPLAINED_SHARE


def expected_cut(
    image: ComparedImage, images: Sequence[ComparedImage], followed: PlacedSources, known: np.ndarray | None
) -> tuple[ExpectedMosaic, np.ndarray]:
    """What the mosaic would look like cut hard, its labels those of the sources; and labels for the composite."""
    valid = {i: mask for i, of in enumerate(followed.source_of) if (mask := images[of].valid) is not None}
    found = expected_mosaic(image.plane, followed.planes, followed.fine, followed.following, valid, known)
    numbers = np.full(256, UNKNOWN, np.uint8)
    numbers[: len(followed.source_of)] = followed.source_of
    found = replace(found, labels=numbers[found.labels])
    nothing = (found.labels == UNKNOWN).all()
    return found, numbers[followed.following.labels] if nothing else found.labels


def _of_planes(labels: np.ndarray, source_of: Sequence[int]) -> np.ndarray:
    """Labels of sources as those of the first planes that are of them."""
    numbers = np.full(256, UNKNOWN, np.uint8)
    numbers[list(source_of[::-1])] = np.arange(len(source_of), dtype=np.uint8)[::-1]
    return numbers[labels]


def _explained(labels: np.ndarray) -> float:
    """Share of the pixels with a label."""
    return int(np.count_nonzero(labels != UNKNOWN)) / labels.size


def _merged(followed: PlacedSources, labels: np.ndarray, count: int) -> FollowedSource:
    """The first estimate with better labels, of ``count`` sources."""
    shares = tuple(int(np.count_nonzero(labels == i)) / labels.size for i in range(count))
    return replace(followed.following, labels=labels, shares=shares)


def _where_followed(following: FollowedSource, source: int, levels: int) -> np.ndarray:
    """Squares of 2^R px from which a source's tone is taken; all of one that is not followed."""
    where = follows_at(following, source, levels)
    return where if source in following.followed else np.ones_like(where)
