"""The fair reference: the hard-cut composite of the sources, each pixel from the one that the mosaic follows.

Across a seam the mosaic holds one source on either side, so comparing it with whole source clips mixes content with
loss. The composite holds the same content as the mosaic and has lost nothing.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..tone import Tone, whole_squares
from .boxes import near_border
from .followed_source import FollowedSource

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
            np.copyto(plain[band], _as_type(alike, dtype), where=unknown)
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


def _as_type(values: np.ndarray, dtype: np.dtype) -> np.ndarray:
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
