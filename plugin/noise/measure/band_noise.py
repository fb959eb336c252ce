"""Random noise of one clip: how its variance spreads over the levels, and how its details are distributed.

In an image with little random noise the relative variance of the details rises from level to level. White noise
has 3/4 of its variance in level 1, 3/16 in level 2, 3/64 in level 3, so it lifts level 1 above level 2 first, and
level 2 above level 3 where it is strong (Pyka 2009). Grain coarser than a pixel does not, and is looked for in the
spectrum of the quiet ground (``grain``). Everything here is plain arrays and numbers.
"""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from enum import Enum

import numpy as np
import pywt

from ...imagery import limits as imagery_limits
from ...imagery.errors import Message, SettingsError
from ...imagery.limits import LUMINANCE, has_colours
from ...imagery.wavelets import Curve, check_decomposition, clip_curves, detail_components
from . import messages
from .grain import (
    Grain,
    NoiseAmount,
    QuietGround,
    clipped_pixels,
    curve_if_white,
    noise_amount,
    noise_found,
    possible_grains,
    quiet_ground,
    recognised_grain,
    unshared_ground,
    unshared_noise,
    white_noise,
)


def inner_ranges(length: int, wavelet: str, levels: int) -> list[slice]:
    """The coefficients free of the wrap-around, of level 1 (finest), 2, ..., R along an axis of ``length`` pixels.

    An empty slice where there is none. Coefficient k of a level is made of the samples 2 k + 1 - L/2 to 2 k + L/2 of
    the level before, L the filter's length.
    """
    half = pywt.Wavelet(wavelet).dec_len // 2
    first, last = 0, length - 1
    ranges = []
    for _ in range(levels):
        first, last = (first + half) // 2, (last - half) // 2  # the first rounded up: (first + half - 1) / 2
        ranges.append(slice(first, max(last + 1, first)))
    return ranges


MIN_NOISE_LEVELS = 2  # the rule compares level 1 with level 2
GAUSSIAN_QUARTILE = 0.6745  # median of the absolute value of a standard normal variable
MIN_KURTOSIS_VALUES = 192  # 3 x 8 x 8: the kurtosis of fewer Gaussian values is off by more than a third of a unit


class NoiseVerdict(str, Enum):
    """The verdict of the curve on random noise."""

    LOW = "low"  # rises at every level, and would if the noise that can be there were white
    UNCERTAIN = "uncertain"  # rises at every level, but grain as strong as moderate noise can hide in the texture
    MODERATE = "moderate"
    """Falls from level 1 to 2, then rises, or would if the grain were white; also any other curve that neither rises
    always nor falls on."""
    STRONG = "strong"  # falls from level 1 to 2 and from 2 to 3, or would if the grain were white
    NOT_MEASURABLE = "not measurable"  # there is no curve


@dataclass(frozen=True)
class BandNoise:
    """The noise of one band of a clip."""

    curve: Curve  # relative variances of the components
    kurtosis: tuple[float | None, ...]
    """Kurtosis of level 1 (finest), 2, ..., R: fourth central moment over squared variance of the level's three detail
    components, each less its mean, pooled; 3 for Gaussian noise, more for edges and structure. Without the coefficients
    that see the opposite border. None where a level is empty or too few are left."""
    sigma: float | None  # robust standard deviation of the noise, DN; None for a constant band
    verdict: NoiseVerdict  # what they say about random noise
    note: Message | None = None  # why it can't be measured, or what to take care of
    largest_sigma: float | None = None
    """The most that noise can be, grain of up to 1.35 px included, by the quietest ground, DN; None where unknown."""
    grain: Grain | None = None  # noise coarser than a pixel, where the quiet ground has its spectrum
    noise: float | None = None  # standard deviation of the noise that was told from texture, white or grain, DN
    signal: float | None = None  # mean of the valid pixels, DN
    amount: NoiseAmount = NoiseAmount.NOT_MEASURABLE  # how much noise that is, whatever the scene
    ground: tuple[QuietGround | None, ...] = ()  # the quiet ground of level 1 (finest), 2, ..., R
    unshared: tuple[QuietGround | None, ...] = ()
    """Quiet ground of what the clip's other bands do not have; empty for a single band, and for the luminance."""
    are_whole: bool = True  # whether the values are whole numbers

    @property
    def signal_to_noise(self) -> float | None:
        """Mean over standard deviation of the noise; None where there is no noise or no signal."""
        return self.signal / self.noise if self.noise and self.signal is not None and self.signal > 0 else None


SEVERITY = (
    NoiseVerdict.NOT_MEASURABLE, NoiseVerdict.LOW, NoiseVerdict.UNCERTAIN, NoiseVerdict.MODERATE, NoiseVerdict.STRONG,
)
"""The verdicts from the mildest on."""


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

    Parameters
    ----------
    bands : (bands, rows, columns)
        Any real type, finite, both sides multiples of ``2 ** levels``.
    names : sequence of str
        As in ``Image.band_names``: there is a luminance where the first three are red, green and blue.
    wavelet, levels : str, int
        An orthogonal wavelet of PyWavelets; two levels or more.
    raster : str
        The name for messages.
    masked : (rows, columns) of bool, optional
        Pixels that were filled: their coefficients take no part in kurtosis and sigma (a smooth fill has no noise).

    ``sigma`` is the median absolute value of the finest diagonal component over 0.6745 (Donoho and Johnstone 1994).

    Raises SettingsError for a wavelet that is not orthogonal or levels out of range.
    """
    check_noise_settings(wavelet, levels)
    weights = imagery_limits.LUMINANCE_WEIGHTS if has_colours(names) else ()
    curves, _ = clip_curves(bands, wavelet, levels, weights)
    all_names = [*names, LUMINANCE] if weights else list(names)
    kurtoses: list[list[float | None]] = [[] for _ in curves]
    grounds: list[list[QuietGround | None]] = [[] for _ in curves]
    alone = []
    sigmas: list[float] = []
    masked = np.zeros(bands.shape[1:], bool) if masked is None else np.asarray(masked, bool)
    silent = clipped_pixels(bands) | masked
    signals = [float(band.mean(dtype=np.float64)) for band in bands[:, ~masked]]
    if weights:
        signals.append(float(np.dot(weights, signals[:3])))
    inner = list(zip(*(inner_ranges(length, wavelet, levels) for length in bands.shape[1:])))
    for level, components in enumerate(detail_components(bands, wavelet, levels), 1):
        usable = ~_in_cells(silent, 2**level)[inner[level - 1]]
        alone.append(unshared_ground(components[(slice(None), slice(None), *inner[level - 1])], usable))
        if weights:
            mixed = np.tensordot(components[:, :3], np.array(weights, components.dtype), axes=(1, 0))
            components = np.concatenate([components, mixed[:, np.newaxis]], axis=1)
        kept = ~_in_cells(masked, 2**level)
        for index, curve in enumerate(curves):
            details = components[:, index]
            if level == 1:
                sigmas.append(float(np.median(np.abs(details[2][kept]))) / GAUSSIAN_QUARTILE)
            details = details[(slice(None), *inner[level - 1])]
            grounds[index].append(quiet_ground(details, usable))
            empty = curve.variance == 0 or curve.detail[level - 1] <= imagery_limits.MIN_SHARE
            kurtoses[index].append(None if empty else _kurtosis(details[:, kept[inner[level - 1]]]))
    measured = {}
    unshared = [*zip(*alone), *[()] * (len(curves) - len(alone[0]))]
    for name, curve, kurtosis, sigma, ground, other, signal in zip(
        all_names, curves, kurtoses, sigmas, grounds, unshared, signals
    ):
        if curve.variance == 0:
            verdict, note = NoiseVerdict.NOT_MEASURABLE, messages.NOISE_CONSTANT(name=raster, band=name)
            measured[name] = BandNoise(curve, tuple(kurtosis), None, verdict, note)
        else:
            noise = BandNoise(
                curve, tuple(kurtosis), sigma, NoiseVerdict.UNCERTAIN, signal=signal, ground=tuple(ground),
                unshared=other, are_whole=bands.dtype.kind in "iu",
            )
            measured[name] = judged(noise, wavelet)
    if weights:
        measured = {LUMINANCE: measured[LUMINANCE], **measured}
    return measured


def noisiest_band(measured: Mapping[str, BandNoise]) -> str:
    """The band that stands for a clip: of the strongest verdict, and among those of the largest sigma.

    The luminance is only looked at where there is nothing else: it averages the noise of its bands away.
    """
    bands = [name for name in measured if name != LUMINANCE] or list(measured)
    return max(bands, key=lambda name: (SEVERITY.index(measured[name].verdict), measured[name].sigma or 0.0))


def judged(band: BandNoise, wavelet: str, alike: Sequence[BandNoise] = ()) -> BandNoise:
    """A band with its verdicts: by the curve, and by the noise that the quiet ground has, or has room for.

    ``alike``: the same band in other windows, where noise is as strong; so it is that of the quietest of all, and no
    stronger than that leaves room for. Nothing is judged where there is no sigma.
    """
    if band.sigma is None:
        return band
    variances = [share * band.curve.variance for share in band.curve.detail]

    def if_white(grain: Grain) -> NoiseVerdict:
        return noise_verdict(curve_if_white(variances, grain, wavelet))[0]

    verdict, note = noise_verdict(band.curve.detail)
    least = [
        min((ground.least for ground in level if ground is not None), default=None)
        for level in zip(band.ground, *(ground.ground for ground in alike))
    ]
    possible = possible_grains(least, wavelet)
    largest = None if possible is None else max(grain.sigma for grain in possible)
    grain = recognised_grain(band.ground, wavelet)
    if grain is not None and SEVERITY.index(if_white(grain)) > SEVERITY.index(verdict):
        verdict, note = if_white(grain), messages.GRAIN_FOUND()
    elif verdict is NoiseVerdict.LOW and possible is None:
        verdict, note = NoiseVerdict.UNCERTAIN, messages.GRAIN_UNKNOWN()
    elif verdict is NoiseVerdict.LOW and {if_white(hidden) for hidden in possible or ()} != {NoiseVerdict.LOW}:
        verdict, note = NoiseVerdict.UNCERTAIN, messages.GRAIN_MAY_HIDE()
    quietest = min((band, *alike), key=_unquiet)
    sigma = quietest.sigma or band.sigma
    alone = unshared_noise(quietest.unshared, sigma, wavelet)
    noise = noise_found(white_noise(quietest.ground, sigma), alone, grain.sigma if grain else 0.0)
    amount = noise_amount(noise, band.signal or 0.0, least, wavelet, band.are_whole, alone[1])
    return replace(
        band, verdict=verdict, note=note, largest_sigma=largest, grain=grain, noise=noise, amount=amount
    )


def _unquiet(band: BandNoise) -> float:
    """Standard deviation of the quiet ground at level 2, DN, where texture shows and white noise does not grow;
    infinite where it is not known."""
    second = band.ground[1] if len(band.ground) > 1 else None
    return math.inf if second is None else second.quiet


def _kurtosis(details: np.ndarray) -> float | None:
    """Fourth moment over squared variance of the values of three components, (3, values), each less its mean.

    None where they do not vary or are too few."""
    if details.size < MIN_KURTOSIS_VALUES:
        return None
    deviations = details - details.mean(axis=1, keepdims=True, dtype=np.float64).astype(details.dtype)
    squares = deviations * deviations
    variance = float(squares.mean(dtype=np.float64))
    squares *= squares
    return float(squares.mean(dtype=np.float64)) / variance**2 if variance > 0 else None


def _in_cells(mask: np.ndarray, side: int) -> np.ndarray:
    """(rows / side, columns / side): whether any pixel of each cell is masked."""
    rows, columns = mask.shape
    return mask.reshape(rows // side, side, columns // side, side).any(axis=(1, 3))
