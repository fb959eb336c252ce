"""The fair reference: the hard-cut composite of the sources, each pixel from the one that the mosaic follows.

Across a seam the mosaic holds one source on either side, so comparing it with whole source clips mixes content with
loss. The composite holds the same content as the mosaic and has lost nothing.
"""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from .followed_source import FollowedSource
from .tone import Tone, coarse_means


@dataclass(frozen=True, eq=False)
class Composite:
    """Two forms of one cut."""

    names: tuple[str, ...]
    """Bands that the mosaic and all sources have."""
    bands: np.ndarray
    """(bands, rows, columns): the sources' pixels as they are; contrast is measured against these."""
    levelled: np.ndarray
    """(bands, rows, columns) float32: each source brought to the mosaic's grey values where it is followed, so that
    no tonal step at the seam counts as detail; ratios are measured against these."""


def make_composite(
    sources: Sequence[np.ndarray],
    names: tuple[str, ...],
    following: FollowedSource,
    tones: Sequence[Mapping[str, Tone | None]],
) -> Composite:
    """The cut through the sources' bands, (bands, rows, columns) each, in the order of ``names``."""
    dtype = np.result_type(*(bands.dtype for bands in sources))
    plain = sources[0].astype(dtype, copy=len(sources) > 1)
    levelled = np.empty(plain.shape, np.float32)
    for i, bands in enumerate(sources):
        chosen = following.labels == i
        if not chosen.any():
            continue
        for band, name in enumerate(names):
            tone = tones[i].get(name) or Tone(1.0, 0.0)
            values = bands[band] * np.float32(tone.gain)
            values += np.float32(tone.bias)
            np.copyto(levelled[band], values, where=chosen)
            if i:
                np.copyto(plain[band], bands[band], where=chosen)
    return Composite(names, plain, levelled)


def follows_at(following: FollowedSource, source: int, levels: int) -> np.ndarray:
    """Squares of 2^R px that follow one source clearly and wholly, (rows / 2^R, columns / 2^R) bool."""
    return coarse_means((following.labels == source) & following.clear, levels) > 1 - 1e-6
