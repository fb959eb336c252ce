"""The hard cut of the sources that the mosaic follows in a window: what it is compared with, and what can be shown.

Across a seam the mosaic holds one source on either side, so comparing it with whole source clips mixes content with
loss. The cut, each pixel from the source that the mosaic follows, holds the same content and has lost nothing.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from ..compared_image import ComparedImage, MeasuredClip, judged_planes, on_common_bands
from ..following.boxes import near_border
from ..following.expected_mosaic import ExpectedMosaic, expected_mosaic
from ..following.followed_source import FollowedSource
from ..following.likely_source import MIN_FIT
from ..following.placed_sources import PlacedSources, follow_sources
from ..following.source_filters import cut_of
from ..profile.window_detail import WindowDetail, window_detail
from ..seam_cells import UNKNOWN, present
from ..tone import Tone, whole_squares

LEAST_CHANGE = 0.1  # of a grey value of 16 bit: tones that change no more leave it as it was
_EASED_PX = 48  # beside a seam
_FEWEST_FAR = 64  # squares


def make_composite(
    mosaic: np.ndarray,
    sources: Sequence[np.ndarray],
    names: tuple[str, ...],
    labels: np.ndarray,
    tones: Sequence[Mapping[str, Tone | None]],
) -> tuple[np.ndarray, np.ndarray]:
    """Both forms of the cut through the sources' bands, (bands, rows, columns) each, in the order of ``names``, as
    ``HardCut`` has them.

    ``labels``, (rows, columns): the source of every pixel. Where no source explains the mosaic, its own pixels stand,
    so that nothing is gained or lost there.
    """
    dtype = np.result_type(*(bands.dtype for bands in sources))
    followed = sorted(present(labels), key=lambda i: -np.count_nonzero(labels == i)) or [0]
    toned = {i: [tones[i].get(name) or Tone(1.0, 0.0) for name in names] for i in followed}
    gains = {i: np.array([[[tone.gain]] for tone in of], np.float32) for i, of in toned.items()}
    biases = {i: np.array([[[tone.bias]] for tone in of], np.float32) for i, of in toned.items()}
    main = followed[0]
    in_its_tone = (mosaic - biases[main]) / np.where(gains[main] == 0, 1, gains[main])
    plain = cut_of(as_type(in_its_tone, dtype), {i: sources[i].astype(dtype) for i in followed}, labels)
    if all(abs(tone.gain - 1) * 2**16 + abs(tone.bias) < LEAST_CHANGE for of in toned.values() for tone in of):
        return plain, plain
    shown = {i: np.asarray(gains[i] * sources[i] + biases[i], np.float32) for i in followed}
    return plain, cut_of(mosaic, shown, labels)


def as_type(values: np.ndarray, dtype: np.dtype) -> np.ndarray:
    """Rounded, and cut to what the type holds."""
    if dtype.kind == "f":
        return values.astype(dtype)
    ends = np.iinfo(dtype)
    return np.clip(np.rint(values), ends.min, ends.max).astype(dtype)


def follows_at(following: FollowedSource, source: int, levels: int) -> np.ndarray:
    """Squares of 2^R px that follow one source clearly and wholly, (rows / 2^R, columns / 2^R) bool; where there are
    enough, those away from its seams, over which feathers and blends of several bands ease tones. All squares for one
    that is not followed."""
    places, side = whole_squares((following.labels == source) & following.clear, levels), 2**levels
    eased = near_border(following.labels[::side, ::side], -(-_EASED_PX // side))[: places.shape[0], : places.shape[1]]
    far = places & ~eased
    if source not in following.followed:
        return np.ones_like(places)
    return far if np.count_nonzero(far) >= _FEWEST_FAR else places


MIN_EXPLAINED_SHARE = 0.05  # of the pixels: with less there is nothing to compare with


@dataclass(frozen=True, eq=False)
class JudgedGround:
    """The judged band of a window and of the ground that was read around it."""

    followed: PlacedSources
    expected: ExpectedMosaic
    """What the mosaic would look like; its labels are those of the sources."""
    inside: tuple[slice, slice]
    """Rows and columns of the window."""

    @property
    def labels(self) -> np.ndarray:
        """(rows, columns) uint8: the source of every pixel of the window, ``UNKNOWN`` where none explains it."""
        return self.expected.labels[self.inside]

    @property
    def explained(self) -> float:
        """Share of the window's pixels whose fine detail the sources explain."""
        return float((self.labels != UNKNOWN).mean())

    @property
    def is_unclear(self) -> bool:
        """Whether the sources say too little of the mosaic for the cut to mean anything."""
        return self.followed.following.fit < MIN_FIT or self.explained < MIN_EXPLAINED_SHARE

    @cached_property
    def following(self) -> FollowedSource:
        """The first estimate of the window alone, with better labels; with its own where nothing is explained."""
        first = self.followed.following
        is_explained = (self.expected.labels != UNKNOWN).any()
        by_plane = np.array(self.followed.source_of, np.uint8)
        labels = self.labels if is_explained else by_plane[first.labels[self.inside]]
        shares = tuple(float((labels == i).mean()) for i in range(len(self.followed.images)))
        clear, mixed, unexplained, likely = (
            mask[self.inside] for mask in (first.clear, first.mixed, first.unexplained, first.likely)
        )
        return FollowedSource(labels, clear, mixed, shares, first.fit, unexplained, likely)

    def detail(self, wavelet: str, levels: int) -> WindowDetail:
        """What the mosaic has of its sources' detail."""
        mosaic = self.expected.filling(self.followed.mosaic)
        return window_detail(mosaic, self.expected, wavelet, levels).judged_inside(*self.inside)


def judged_ground(
    image: ComparedImage, images: Sequence[ComparedImage], known: np.ndarray | None,
    inside: tuple[slice, slice] | None = None,
) -> JudgedGround:
    """Follow the mosaic through its sources. ``known``: as for ``cut_hard``, of all that was read; ``inside``: rows and
    columns of the window, all where None."""
    followed = follow_sources(image, images).with_known(known)
    rows, columns = image.plane.shape
    return JudgedGround(followed, expected_mosaic(followed), inside or (slice(0, rows), slice(0, columns)))


@dataclass(frozen=True, eq=False)
class HardCut:
    """A window of the mosaic and its sources on their common bands, and which of them every pixel follows."""

    mosaic: ComparedImage
    sources: tuple[ComparedImage, ...]
    tones: tuple[dict[str, Tone | None], ...]
    """What became of each source's grey values in the mosaic, by band."""
    plain: np.ndarray
    """(bands, rows, columns): the sources' pixels as they are; contrast is measured against these."""
    levelled: np.ndarray
    """(bands, rows, columns): each source brought to the mosaic's grey values where it is followed, so that no tonal
    step at the seam counts as detail; ratios are measured against these. In float32, or ``plain`` itself where no tone
    was changed."""
    ground: JudgedGround
    """The judged band, with the ground that was read around the window."""


def cut_hard(
    mosaic: MeasuredClip, sources: Sequence[MeasuredClip], levels: int, labels: np.ndarray | None = None
) -> HardCut:
    """Cut at least one source as the mosaic follows it.

    ``labels``, (rows, columns) uint8 of all that was read, says which source each pixel was taken from where that is
    known, else ``seam_cells.UNKNOWN``.
    """
    ground = ground_of(mosaic, sources, labels)
    planes = [image.plane[ground.inside] for image in (ground.followed.mosaic, *ground.followed.images)]
    image, *images = on_common_bands((mosaic, *sources), planes, levels)
    tones = [image.tones_of(other, follows_at(ground.following, i, levels)) for i, other in enumerate(images)]
    bands = [other.bands for other in images]
    plain, levelled = make_composite(image.bands, bands, image.names, ground.following.labels, tones)
    return HardCut(image, tuple(images), tuple(tones), plain, levelled, ground)


def ground_of(mosaic: MeasuredClip, sources: Sequence[MeasuredClip], labels: np.ndarray | None) -> JudgedGround:
    """The judged band of at least one source, followed; ``labels``: as for ``cut_hard``."""
    image, *images = judged_planes((mosaic, *sources))
    return judged_ground(image, images, labels, mosaic.inside)
