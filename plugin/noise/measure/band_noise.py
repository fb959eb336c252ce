"""Random noise of one clip: how its variance spreads over the levels, and how its details are distributed.

In an image with little random noise the relative variance of the details rises from level to level. White noise
has 3/4 of its variance in level 1, 3/16 in level 2, 3/64 in level 3, so it lifts level 1 above level 2 first, and
level 2 above level 3 where it is strong (Pyka 2009). Everything here is plain arrays and numbers.
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from ...imagery import limits as imagery_limits
from ...imagery.band_names import LUMINANCE, has_colours
from ...imagery.errors import SettingsError
from ...imagery.message import Message
from ...imagery.wavelets import Curve, check_decomposition, clip_curves, detail_components
from . import messages

MIN_NOISE_LEVELS = 2  # the rule compares level 1 with level 2
GAUSSIAN_QUARTILE = 0.6745  # median of the absolute value of a standard normal variable


class NoiseVerdict(str, Enum):
    """What the curve says about random noise."""

    LOW = "low"
    """Rises at every level."""
    MODERATE = "moderate"
    """Falls from level 1 to 2, then rises; also any other curve that neither rises always nor falls on."""
    STRONG = "strong"
    """Falls from level 1 to 2 and from 2 to 3."""
    NOT_MEASURABLE = "not measurable"
    """There is no curve."""


@dataclass(frozen=True)
class BandNoise:
    """The noise of one band of a clip."""

    curve: Curve
    kurtosis: tuple[float | None, ...]
    """Of level 1 (finest), 2, ..., R: fourth central moment over squared variance of the level's three detail
    components pooled; 3 for Gaussian noise, more for edges and structure. None where a level is empty."""
    sigma: float | None
    """Robust standard deviation of the noise, DN; None for a constant band."""
    verdict: NoiseVerdict
    note: Message | None = None
    """Why it can't be measured, or what to take care of."""


def check_noise_settings(wavelet: str, levels: int) -> None:
    """Raise SettingsError unless the wavelet is orthogonal and there are two levels or more."""
    check_decomposition(wavelet, levels)
    if levels < MIN_NOISE_LEVELS:
        raise SettingsError(messages.NOISE_LEVELS_TOO_FEW(levels=levels, least=MIN_NOISE_LEVELS))


def noise_verdict(detail: Sequence[float]) -> tuple[NoiseVerdict, Message | None]:
    """The verdict on the relative variances of levels 1..R, R >= 2, and what to take care of.

    Low: each level is larger than the one before. Strong: neither level 2 nor level 3 is. Else moderate; a curve
    that rises from level 1 to 2 and falls later, which white noise does not make, has a note (Pyka 2009, section 4,
    met none).
    """
    rises = [finer < coarser for finer, coarser in zip(detail, detail[1:])]
    if all(rises):
        return NoiseVerdict.LOW, None
    if len(rises) > 1 and not any(rises[:2]):
        return NoiseVerdict.STRONG, None
    return NoiseVerdict.MODERATE, messages.NOISE_HUMP() if rises[0] else None


def measure_noise(
    bands: np.ndarray, names: Sequence[str],
    wavelet: str = imagery_limits.DEFAULT_WAVELET, levels: int = imagery_limits.DEFAULT_LEVELS, raster: str = "",
    masked: np.ndarray | None = None,
) -> dict[str, BandNoise]:
    """Curve, kurtosis, sigma and verdict of every band of a clip, and of its luminance, which comes first.

    ``bands`` is (bands, rows, columns) of any real type, finite, both sides multiples of ``2 ** levels``; ``names``
    as in ``Image.band_names``: there is a luminance where the first three are red, green and blue. ``raster`` is
    the name for messages. ``masked``, (rows, columns) of bool: pixels that were filled; coefficients that belong to
    them take no part in kurtosis and sigma (a smooth fill has none of the noise).

    ``sigma`` is the median absolute value of the finest diagonal component over 0.6745 (Donoho and Johnstone 1994).

    Raises SettingsError for a wavelet that is not orthogonal or levels out of range.
    """
    check_noise_settings(wavelet, levels)
    weights = imagery_limits.LUMINANCE_WEIGHTS if has_colours(names) else ()
    curves, _ = clip_curves(bands, wavelet, levels, weights)
    all_names = [*names, LUMINANCE] if weights else list(names)
    kurtoses: list[list[float | None]] = [[] for _ in curves]
    sigmas: list[float] = []
    for level, components in enumerate(detail_components(bands, wavelet, levels), 1):
        if weights:
            mixed = np.tensordot(components[:, :3], np.array(weights, components.dtype), axes=(1, 0))
            components = np.concatenate([components, mixed[:, np.newaxis]], axis=1)
        kept = None if masked is None or not masked.any() else ~_in_cells(masked, 2**level)
        for index, (own, curve) in enumerate(zip(kurtoses, curves)):
            details = components[:, index] if kept is None else components[:, index][:, kept]
            empty = curve.variance == 0 or curve.detail[level - 1] <= imagery_limits.MIN_SHARE
            own.append(None if empty else _kurtosis(details))
            if level == 1:
                sigmas.append(float(np.median(np.abs(details[2]))) / GAUSSIAN_QUARTILE)
    measured = {}
    for name, curve, kurtosis, sigma in zip(all_names, curves, kurtoses, sigmas):
        if curve.variance == 0:
            verdict, note = NoiseVerdict.NOT_MEASURABLE, messages.NOISE_CONSTANT(name=raster, band=name)
            measured[name] = BandNoise(curve, tuple(kurtosis), None, verdict, note)
        else:
            measured[name] = BandNoise(curve, tuple(kurtosis), sigma, *noise_verdict(curve.detail))
    if weights:
        measured = {LUMINANCE: measured[LUMINANCE], **measured}
    return measured


def _kurtosis(details: np.ndarray) -> float | None:
    """Fourth central moment over squared variance of all values; None where they do not vary."""
    deviations = details.ravel() - details.dtype.type(details.mean(dtype=np.float64))
    squares = deviations * deviations
    variance = float(squares.mean(dtype=np.float64))
    squares *= squares
    return float(squares.mean(dtype=np.float64)) / variance**2 if variance > 0 else None


def _in_cells(mask: np.ndarray, side: int) -> np.ndarray:
    """(rows / side, columns / side): whether any pixel of each cell is masked."""
    rows, columns = mask.shape
    return mask.reshape(rows // side, side, columns // side, side).any(axis=(1, 3))
