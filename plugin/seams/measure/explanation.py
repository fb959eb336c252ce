"""Why a window lost contrast: the mosaic against each source and against the fair reference.

Follows the mosaic through its sources, builds the hard-cut composite of them, and compares grey values, contrast,
position and mixture (Pyka 2010, section 3, names the causes).
"""
from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

import numpy as np

from ...imagery import limits as imagery_limits
from ...imagery.band_curves import correlation, judged_plane, measure_bands
from ...imagery.band_names import COLOURS, LUMINANCE, has_colours
from ...imagery.clips import Clip
from ...imagery.shifts import Shift, Spectra, find_shift, shifted
from ...imagery.wavelets import Curve
from . import limits
from .causes import Cause, CauseEvidence, find_cause
from .composite import Composite, follows_at, make_composite
from .feather_prediction import expected_ratios, feathers
from .followed_source import FollowedSource, follow, high_pass, refined
from .seam_cells import UNKNOWN
from .tone import Tone, clipped_share, coarse_means, colour_shift, fit_tones
from .verdicts import Ratios, curve_ratios

MIN_SOURCE_FIT = 0.9  # share of the mosaic's fine detail that its sources explain; below it shifts are looked for
MIN_UNEXPLAINED_SHARE = 0.02  # of the pixels: a part of a window this large is looked at for a shift of its own
MIN_FIT_GAIN = 0.1  # by which shifted sources have to explain more to be believed
MIN_UNMIXED_SQUARES = 64  # of 2^R px that follow one source, for the tone to be taken from them alone


@dataclass(frozen=True)
class Change:
    """What became of a source's grey values in the mosaic, in one band."""

    tone: Tone | None
    """None where it can't be fitted."""
    contrast: tuple[float | None, ...]
    """Standard deviation of the mosaic's detail over the source's, levels 1..R; None where the source has none."""
    clipped: float
    """Share of pixels at the end of the mosaic's scale that were not at the source's."""
    colour_shift: float | None
    """Largest over smallest gain of the colours; None without colours."""
    shift: Shift | None
    """How the mosaic lies on the source on the ground, px; None where they show nothing in common."""

    @property
    def sharpness(self) -> tuple[float | None, ...]:
        """Contrast over gain, levels 1..R: 1 means that all detail came over at the gain."""
        gain = abs(self.tone.gain) if self.tone else 0.0
        return tuple(None if value is None or not gain else value / gain for value in self.contrast)


@dataclass(frozen=True)
class Explanation:
    """What the sources say about one window of the mosaic."""

    cause: Cause
    curves: dict[str, Curve]
    """Of the levelled composite, by band."""
    ratios: dict[str, Ratios]
    """The mosaic against the levelled composite, by band."""
    similarity: dict[str, float | None]
    """Correlation of the coarse components with the composite's, by band."""
    changes: tuple[dict[str, Change], ...]
    """By band: against each source in turn, then against the composite."""
    expected: tuple[float | None, ...]
    """Detail variance that a 50:50 feather would leave, levels 1..R, the smallest over the pairs of sources."""
    unclear_share: float
    """Share of pixels for which no source wins clearly."""
    mixed_share: float
    """Share of pixels in which two sources are mixed."""
    apart: float | None
    """How far the two sources that the mosaic follows most lie from each other, px; None where there are none."""


@dataclass(frozen=True, eq=False)
class MeasuredClip:
    """A clip with what was measured in it, by band name."""

    clip: Clip
    curves: dict[str, Curve]
    coarse: dict[str, np.ndarray]


@dataclass(frozen=True, eq=False)
class _Image:
    """A clip reduced to the bands that all have, with what is looked at more than once."""

    bands: np.ndarray
    names: tuple[str, ...]
    coarse: dict[str, np.ndarray]
    """Means of squares of 2^R px, by band; luminance first where there is one."""
    curves: Mapping[str, Curve]
    offset: tuple[float, float] = (0.0, 0.0)
    """How its pixel grid lies beside the mosaic's, px."""

    @cached_property
    def plane(self) -> np.ndarray:
        """What the verdict looks at, (rows, columns) float32."""
        return judged_plane(self.bands, self.names)

    @cached_property
    def spectra(self) -> Spectra:
        """Of the plane, which is compared with those of several others."""
        return Spectra(self.plane)


def explain(
    mosaic: MeasuredClip, sources: Sequence[MeasuredClip], wavelet: str, levels: int, labels: np.ndarray | None = None
) -> Explanation:
    """Explain one window by at least one source.

    ``labels``, (rows, columns) uint8, says which source each pixel was taken from where that is known, else
    ``seam_cells.UNKNOWN``.
    """
    image, *images = _on_common_bands((mosaic, *sources), levels)
    following = _decided(_follow(image, images), labels)
    tones = [_tones(image, other, _where_followed(following, i, levels)) for i, other in enumerate(images)]
    following = _decided(refined(following, image.plane, _levelled_planes(images, tones, following)), labels)
    shifts = [_shift(image, other, following, i) for i, other in enumerate(images)]
    composite = make_composite([other.bands for other in images], image.names, following, tones)
    curves, coarse = measure_bands(composite.levelled, image.names, wavelet, levels)
    against_composite = _composite_changes(image, composite, following, wavelet, levels)
    return Explanation(
        cause=find_cause(_evidence(against_composite, shifts, following)),
        curves=curves,
        ratios={name: curve_ratios(mosaic.curves[name], curve) for name, curve in curves.items()},
        similarity={name: correlation(mosaic.coarse[name], own) for name, own in coarse.items()},
        changes=(*(_changes(image, *compared) for compared in zip(images, tones, shifts)), against_composite),
        expected=expected_ratios(feathers([other.plane for other in images], wavelet, levels), levels),
        unclear_share=following.unclear_share,
        mixed_share=following.mixed_share,
        apart=_apart(images, following),
    )


def _on_common_bands(measured: Sequence[MeasuredClip], levels: int) -> Iterator[_Image]:
    """The mosaic and its sources, reduced to the bands that all of them have."""
    held = [one.clip.raster.band_names for one in measured]
    names = tuple(name for name in held[0] if all(name in others for others in held))
    for one, own in zip(measured, held):
        order = [own.index(name) for name in names]
        bands = one.clip.bands if order == list(range(len(one.clip.bands))) else one.clip.bands[order]
        yield _image(bands, names, one.curves, levels, (one.clip.offset_x, one.clip.offset_y))


def _image(
    bands: np.ndarray, names: tuple[str, ...], curves: Mapping[str, Curve], levels: int, offset: tuple[float, float]
) -> _Image:
    coarse = {name: coarse_means(band, levels) for name, band in zip(names, bands)}
    if has_colours(names):
        weighted = sum(weight * coarse[name] for weight, name in zip(imagery_limits.LUMINANCE_WEIGHTS, names))
        coarse = {LUMINANCE: np.asarray(weighted), **coarse}
    return _Image(bands, names, coarse, curves, offset)


def _follow(image: _Image, images: Sequence[_Image]) -> FollowedSource:
    """What the mosaic follows; where that explains it badly, once more with the sources also moved to where it lies."""
    shape = (image.bands.shape[1], image.bands.shape[2])
    count = len(images)

    @lru_cache(maxsize=1)  # a window of one strip is asked for twice
    def fine(start: int, stop: int) -> list[np.ndarray]:
        return [high_pass(one.plane[start:stop]) for one in (image, *images)]

    plain = follow(fine, shape, count)
    unexplained = float(plain.unexplained.mean())
    if plain.fit >= MIN_SOURCE_FIT and unexplained < MIN_UNEXPLAINED_SHARE:
        return plain
    shifts = {i: _shift_where(image.spectra, other.spectra, plain.unexplained) for i, other in enumerate(images)}
    moved = {i: s for i, s in shifts.items() if s is not None and s.length >= limits.MIN_MISREGISTRATION_PX}
    if not moved:
        return plain

    def with_moved(start: int, stop: int) -> list[np.ndarray]:
        known = fine(start, stop)
        return known + [shifted(known[1 + i], s.x, s.y) for i, s in moved.items()]

    found = follow(with_moved, shape, count + len(moved))
    explains_part = unexplained >= MIN_UNEXPLAINED_SHARE and found.unexplained.mean() <= unexplained / 2
    better = explains_part or found.fit >= plain.fit + MIN_FIT_GAIN
    return _merged(found, [*range(count), *moved], count) if better else plain


def _shift_where(image: Spectra, reference: Spectra, where: np.ndarray) -> Shift | None:
    """In the part where it matters; in the whole window where that part is too small or shows nothing."""
    return (find_shift(image, reference, where) if where.any() else None) or find_shift(image, reference)


def _merged(following: FollowedSource, source_of: Sequence[int], count: int) -> FollowedSource:
    """The same with the moved sources under the numbers of those that they were made from."""
    shares = np.bincount(source_of, weights=following.shares, minlength=count)
    return replace(following, labels=np.array(source_of, np.uint8)[following.labels], shares=tuple(shares.tolist()))


def _decided(following: FollowedSource, labels: np.ndarray | None) -> FollowedSource:
    """What is known of where pixels were taken from goes before the estimate."""
    if labels is None:
        return following
    labels = np.where(labels == UNKNOWN, following.labels, labels)
    shares = np.bincount(labels.ravel(), minlength=len(following.shares)) / labels.size
    return replace(following, labels=labels, shares=tuple(shares.tolist()))


def _where_followed(following: FollowedSource, source: int, levels: int) -> np.ndarray:
    """Squares of 2^R px from which a source's tone is taken; all of one that is not followed."""
    where = follows_at(following, source, levels)
    return where if source in following.followed else np.ones_like(where)


def _tones(image: _Image, other: _Image, where: np.ndarray) -> dict[str, Tone | None]:
    pixels: list[tuple[np.ndarray, Sequence[float]]] = [(band[np.newaxis], (1.0,)) for band in other.bands]
    if LUMINANCE in other.coarse:
        pixels.insert(0, (other.bands[:3], imagery_limits.LUMINANCE_WEIGHTS))
    mosaic, source = (np.stack(list(one.coarse.values())) for one in (image, other))
    return dict(zip(image.coarse, fit_tones(mosaic, source, where, pixels)))


def _levelled_planes(
    images: Sequence[_Image], tones: Sequence[Mapping[str, Tone | None]], following: FollowedSource
) -> dict[int, np.ndarray]:
    """Planes of the followed sources in the mosaic's grey values."""
    planes = {}
    for i in following.followed if len(following.followed) > 1 else ():
        tone = next(iter(tones[i].values())) or Tone(1.0, 0.0)
        planes[i] = images[i].plane * np.float32(tone.gain) + np.float32(tone.bias)
    return planes


def _shift(image: _Image, other: _Image, following: FollowedSource, source: int) -> Shift | None:
    """On the ground: where the source's pixel grid lies beside the mosaic's, that is taken into account."""
    where = following.labels == source if source in following.followed else None
    shift = find_shift(image.spectra, other.spectra, where)
    return shift and replace(shift, x=shift.x + other.offset[0], y=shift.y + other.offset[1])


def _composite_changes(
    image: _Image, composite: Composite, following: FollowedSource, wavelet: str, levels: int
) -> dict[str, Change]:
    """Against the sources' pixels as they are; tones from where one source is followed, if there is enough of that."""
    curves, _ = measure_bands(composite.bands, composite.names, wavelet, levels)
    reference = _image(composite.bands, composite.names, curves, levels, (0.0, 0.0))
    unmixed = coarse_means(following.clear, levels) > 1 - 1e-6
    where = unmixed if unmixed.sum() >= MIN_UNMIXED_SQUARES else np.ones_like(unmixed)
    shift = find_shift(image.spectra, reference.spectra)
    return _changes(image, reference, _tones(image, reference, where), shift)


def _changes(image: _Image, other: _Image, tones: Mapping[str, Tone | None], shift: Shift | None) -> dict[str, Change]:
    clipped = {name: clipped_share(*bands) for name, *bands in zip(image.names, image.bands, other.bands)}
    gains = [tone.gain for tone in (tones.get(name) for name in COLOURS) if tone is not None]
    colours = colour_shift(gains) if len(gains) == len(COLOURS) else None
    clipped[LUMINANCE] = max(clipped.values())
    return {
        name: Change(tones[name], _contrast(image.curves[name], other.curves[name]), clipped[name], colours, shift)
        for name in image.coarse
    }


def _contrast(mosaic: Curve, source: Curve) -> tuple[float | None, ...]:
    return tuple(
        float(np.sqrt(m * mosaic.variance / (s * source.variance))) if s > imagery_limits.MIN_SHARE else None
        for m, s in zip(mosaic.detail, source.detail)
    )


def _evidence(
    changes: Mapping[str, Change], shifts: Sequence[Shift | None], following: FollowedSource
) -> CauseEvidence:
    """Of the judged band, the first."""
    change = next(iter(changes.values()))
    gain = change.tone.gain if change.tone else None
    lengths = [shift.length for i, shift in enumerate(shifts) if shift is not None and i in following.followed]
    return CauseEvidence(
        gain,
        change.tone.gamma if change.tone else 1.0,
        change.clipped,
        change.colour_shift,
        max(lengths, default=0.0),
        following.mixed_share,
        following.kept / abs(gain) if following.kept is not None and gain else None,
        following.fit,
    )


def _apart(images: Sequence[_Image], following: FollowedSource) -> float | None:
    if len(following.followed) < 2:
        return None
    shift = find_shift(*(images[i].spectra for i in following.followed[:2]))
    return None if shift is None else shift.length
