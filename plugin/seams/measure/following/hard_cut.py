"""The hard cut of the sources that the mosaic follows in a window: what it is compared with, and what can be shown.

Across a seam the mosaic holds one source on either side, so comparing it with whole source clips mixes content with
loss. The cut, each pixel from the source that the mosaic follows, holds the same content and has lost nothing.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..compared_image import ComparedImage, MeasuredClip, judged_planes, on_common_bands
from ..profile.window_detail import LossPicture, WindowDetail, loss_picture, window_detail
from ..seam_cells import UNKNOWN
from ..tone import Tone, whole_squares
from .boxes import near_border
from .expected_mosaic import ExpectedMosaic, expected_mosaic
from .followed_source import FollowedSource
from .likely_source import MIN_FIT
from .placed_sources import PlacedSources, follow_sources
from .source_filters import LEAST_MOVED_PX

LEAST_GAIN_CHANGE, LEAST_BIAS = 1e-6, 1e-2
_EASED_PX = 48  # beside a seam
_FEWEST_FAR = 64  # squares


@dataclass(frozen=True, eq=False)
class Composite:
    """Two forms of one cut."""

    names: tuple[str, ...]
    """Bands that the mosaic and all sources have."""
    bands: np.ndarray
    """(bands, rows, columns): the sources' pixels as they are; contrast is measured against these."""
    levelled: np.ndarray
    """(bands, rows, columns): each source brought to the mosaic's grey values where it is followed, so that no tonal
    step at the seam counts as detail; ratios are measured against these. In float32, or ``bands`` itself where no tone
    was changed."""


def make_composite(
    mosaic: np.ndarray,
    sources: Sequence[np.ndarray],
    names: tuple[str, ...],
    labels: np.ndarray,
    tones: Sequence[Mapping[str, Tone | None]],
) -> Composite:
    """The cut through the sources' bands, (bands, rows, columns) each, in the order of ``names``.

    ``labels``, (rows, columns): the source of every pixel. Where no source explains the mosaic, its own pixels stand,
    so that nothing is gained or lost there.
    """
    dtype = np.result_type(*(bands.dtype for bands in sources))
    counts = [int(np.count_nonzero(labels == i)) for i in range(len(sources))]
    first, *others = sorted((i for i, count in enumerate(counts) if count), key=lambda i: -counts[i]) or [0]
    plain = sources[first].astype(dtype, copy=True)
    is_level = all(_is_as_it_was(tones[i].get(name)) for i in (first, *others) for name in names)
    levelled = plain if is_level else np.empty(plain.shape, np.float32)
    for band, name in enumerate(names if not is_level else ()):
        _in_tone(sources[first][band], tones[first].get(name), out=levelled[band])
    for i in others:
        chosen, place = _cropped(labels == i)
        for band, name in enumerate(names):
            if not is_level:
                np.copyto(levelled[band][place], _in_tone(sources[i][band][place], tones[i].get(name)), where=chosen)
            np.copyto(plain[band][place], sources[i][band][place], where=chosen)
    unknown = labels >= len(sources)
    if unknown.any():
        for band, name in enumerate(names):
            tone = tones[first].get(name) or Tone(1.0, 0.0)
            if not is_level:
                np.copyto(levelled[band], mosaic[band], where=unknown)
            alike = (mosaic[band] - np.float32(tone.bias)) / np.float32(tone.gain or 1.0)
            np.copyto(plain[band], as_type(alike, dtype), where=unknown)
    return Composite(names, plain, levelled)


def _is_as_it_was(tone: Tone | None) -> bool:
    """Whether a tone changes no grey value of 16 bit by a tenth."""
    return tone is None or (abs(tone.gain - 1) < LEAST_GAIN_CHANGE and abs(tone.bias) < LEAST_BIAS)


def _in_tone(values: np.ndarray, tone: Tone | None, out: np.ndarray | None = None) -> np.ndarray:
    gain, bias = (tone.gain, tone.bias) if tone else (1.0, 0.0)
    toned = np.multiply(values, np.float32(gain), out=out)
    toned += np.float32(bias)
    return toned


def _cropped(mask: np.ndarray) -> tuple[np.ndarray, tuple[slice, slice]]:
    """The rows and columns in which a mask is set at all."""
    rows, columns = (np.flatnonzero(mask.any(axis=axis)) for axis in (1, 0))
    place = slice(rows[0], rows[-1] + 1), slice(columns[0], columns[-1] + 1)
    return mask[place], place


def as_type(values: np.ndarray, dtype: np.dtype) -> np.ndarray:
    """Rounded, and cut to what the type holds."""
    if dtype.kind == "f":
        return values.astype(dtype)
    ends = np.iinfo(dtype)
    return np.clip(np.rint(values), ends.min, ends.max).astype(dtype)


def follows_at(following: FollowedSource, source: int, levels: int) -> np.ndarray:
    """Squares of 2^R px that follow one source clearly and wholly, (rows / 2^R, columns / 2^R) bool; where there are
    enough, those away from its seams, over which feathers and blends of several bands ease tones."""
    found, side = whole_squares((following.labels == source) & following.clear, levels), 2**levels
    eased = near_border(following.labels[::side, ::side], -(-_EASED_PX // side))[: found.shape[0], : found.shape[1]]
    far = found & ~eased
    return far if np.count_nonzero(far) >= _FEWEST_FAR else found


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
    followed = follow_sources(image, images)
    if known is not None:
        known = _of_planes(known, followed.source_of)
        followed = replace(followed, following=followed.following.with_known(known))
    valid = {i: mask for i, of in enumerate(followed.source_of) if (mask := images[of].valid) is not None}
    following = followed.following
    if image.valid is not None:  # what fills the mosaic where it has no pixels must tell nothing of tones and filters
        following = replace(following, clear=following.clear & image.valid)
    given = [images[of].plane for of in followed.source_of]
    is_moved = any(one is not plane for one, plane in zip(given, followed.planes))
    interpolated = {
        i for i, of in enumerate(followed.source_of)
        if i in followed.moves or np.hypot(*images[of].offset) >= LEAST_MOVED_PX
    }
    expected = expected_mosaic(
        image.plane, followed.planes, followed.fine, following, valid, known, given=given if is_moved else None,
        interpolated=interpolated,
    )
    expected = expected.of_sources(followed.source_of)
    labels = expected.labels
    if image.valid is not None:
        labels[~image.valid] = UNKNOWN
    if (labels == UNKNOWN).all():
        labels = np.array(followed.source_of, np.uint8)[followed.following.labels]
    return JudgedGround(image, tuple(images), followed, expected, labels)


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
    planes = [one.plane[inside] for one in (own, *others)]
    image, *images = on_common_bands((mosaic, *sources), planes, levels)
    following = _within(around, inside)
    cut_labels = around.labels[inside]
    tones = [image.tones_of(other, _where_followed(following, i, levels)) for i, other in enumerate(images)]
    composite = make_composite(image.bands, [other.bands for other in images], image.names, cut_labels, tones)
    return HardCut(image, tuple(images), following, tuple(tones), composite, around, inside)


def window_loss(
    mosaic: MeasuredClip, sources: Sequence[MeasuredClip], wavelet: str, levels: int, labels: np.ndarray | None = None
) -> LossPicture | None:
    """What a window lost of its sources' detail, without its causes; None where they say too little of it.

    ``labels``: as for ``cut_hard``.
    """
    own, *others = judged_planes((mosaic, *sources))
    around = judged_ground(own, others, labels)
    rows, columns = own.plane.shape
    inside = mosaic.inside or (slice(0, rows), slice(0, columns))
    if is_unclear(_within(around, inside), around.expected.labels[inside]):
        return None
    return loss_picture(around.detail(wavelet, levels, inside), around.expected.labels, inside)


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
    return replace(
        first, labels=labels, shares=shares, clear=first.clear[inside], mixed=first.mixed[inside],
        unexplained=first.unexplained[inside],
    )


def _where_followed(following: FollowedSource, source: int, levels: int) -> np.ndarray:
    """Squares of 2^R px from which a source's tone is taken; all of one that is not followed."""
    where = follows_at(following, source, levels)
    return where if source in following.followed else np.ones_like(where)
