"""Noise whatever the scene: its amount, in DN and as the ratio of the signal to it, and the grain that it may have.

White noise has one variance in all detail coefficients. Grain is white noise made smooth by a Gaussian of so many
pixels, as of a scanned film: the finest levels lack it, and beyond its own size it is white. No level has more noise
than its quietest ground varies, so for each size there is a strength that the grain can't exceed.

The paper's rule compares noise with the scene's own detail, so 5 DN of it are low among leaves and strong on water.
Here noise is told from texture by the spectrum of the quietest ground: white noise is as strong at every level, texture
grows from level to level. Where there are several bands, texture is in all of them and noise in each by itself.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum
from functools import lru_cache

import numpy as np
import pywt
from scipy import special

CELL = 4  # coefficients along a side: 48 of the three components give a variance to 20 %
MIN_CELLS = 9  # fewer are no choice of ground
LEAST_SHARE = 0.002  # of the cells: the quietest there are; fewer would be chance
QUIET_SHARE = 0.05  # of the cells: quiet ground
_QUARTER = 0.25
_EXACT, _NOTHING = 1e-7, 1e-30  # of the bands' variance, and at least: bands that are the same leave nothing
_FREE = 40  # values of a cell that count as independent: 48 of white noise, fewer of grain


@dataclass(frozen=True)
class QuietGround:
    """The details of one level and band where the ground is quiet: standard deviations of noise that gives as much."""

    least: float  # on the quietest ground, DN: noise has no more
    quiet: float  # on the quietest twentieth of the ground, DN
    unevenness: float
    """Factor by which the quietest quarter exceeds the twentieth: 1 in pure noise, more where the ground differs."""


def quiet_ground(details: np.ndarray, usable: np.ndarray | None = None) -> QuietGround | None:
    """The quiet ground of a level; None where there are too few cells to choose from.

    Parameters
    ----------
    details : (3, rows, columns)
        One level of one band, without the coefficients at its border.
    usable : (rows, columns) of bool, optional
        False for coefficients to be left out.

    The ground is cut into cells of 4 x 4 coefficients. Of cells with nothing but
    noise the quieter ones are so by chance, which is allowed for (chi-square).
    """
    shape = _cell_shape(details)
    rows, columns = shape[0] * CELL, shape[2] * CELL
    squares = np.square(details[:, :rows, :columns], dtype=np.float64).sum(axis=0)
    means = squares.reshape(shape).sum(axis=(1, 3)) / (3 * CELL * CELL)
    return _quiet(means if usable is None else means[_usable_cells(usable)])


def unshared_ground(details: np.ndarray, usable: np.ndarray) -> list[QuietGround | None]:
    """Quiet ground of each band's own noise, for ``details`` (3, bands, rows, columns); empty for a single band.

    Bands show one texture, and each has its noise. What the others leave of a band in a cell is 1 / p_bb, p the inverse
    of their covariance: noise of all, weighted by p_bk / p_bb. Were it as strong in all, it has p_bb / sum p_bk^2.
    """
    bands, shape = details.shape[1], _cell_shape(details)
    if bands < 2:
        return []
    cells = details[:, :, : shape[0] * CELL, : shape[2] * CELL].reshape(3, bands, *shape)
    cells = cells.transpose(2, 4, 1, 0, 3, 5)[_usable_cells(usable)].reshape(-1, bands, 3 * CELL * CELL)
    covariance = (cells @ np.swapaxes(cells, 1, 2)).astype(np.float64) / (cells.shape[2] - bands + 1)
    values, vectors = np.linalg.eigh(covariance)
    inverse = 1 / np.maximum(values, np.maximum(_EXACT * values[:, -1:], _NOTHING))[:, np.newaxis]
    unshared = (vectors**2 * inverse).sum(axis=2) / (vectors**2 * inverse**2).sum(axis=2)
    return [_quiet(variances) for variances in unshared.T]


def _cell_shape(planes: np.ndarray) -> tuple[int, int, int, int]:
    rows, columns = planes.shape[-2:]
    return rows // CELL, CELL, columns // CELL, CELL


def _usable_cells(usable: np.ndarray) -> np.ndarray:
    """(rows / 4, columns / 4): whether all of a cell is."""
    shape = _cell_shape(usable)
    whole: np.ndarray = usable[: shape[0] * CELL, : shape[2] * CELL].reshape(shape).all(axis=(1, 3))
    return whole


def _quiet(means: np.ndarray) -> QuietGround | None:
    """Quiet ground by the variances of cells; None where they are too few."""
    if means.size < MIN_CELLS:
        return None
    shares = (max(LEAST_SHARE, 1 / (means.size + 1)), QUIET_SHARE, _QUARTER)
    least, quiet, quarter = (
        math.sqrt(variance) / _by_chance(share) for variance, share in zip(np.quantile(means, shares), shares)
    )
    return QuietGround(least, quiet, quarter / quiet if quiet > 0 else math.inf)


@lru_cache(maxsize=4096)
def _by_chance(share: float) -> float:
    """The standard deviation that such a share of cells stays below in noise of standard deviation 1."""
    return math.sqrt(2 * special.gammaincinv(_FREE / 2, share) / _FREE)


def clipped_pixels(bands: np.ndarray) -> np.ndarray:
    """(rows, columns): where any band is cut off, its smallest or largest value amid more of it. No noise is there."""
    clipped = np.zeros(bands.shape[1:], bool)
    for band in bands:
        for value in (band.min(), band.max()):
            same = np.pad(band == value, 1, constant_values=True)
            beside = same[:-2, 1:-1] & same[2:, 1:-1] & same[1:-1, :-2] & same[1:-1, 2:]
            clipped |= same[1:-1, 1:-1] & beside
    return clipped


FITTED_LEVELS = 3  # levels whose spectrum tells grain from texture
MAX_HIDDEN_PX = 1.35  # grain up to here is looked for before noise is called low; of 18 scenes' coarser one few show
SIZES_PX = (0.0, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2, 1.35, 1.5, 1.75, 2.0)
MAX_GRAIN_PX = 1.5  # above it, two of the three levels have none of it
MIN_GRAIN_PX = 0.4  # below it, noise is as good as white
MAX_MISFIT = 1.2  # standard deviations of the levels over those of grain, largest over smallest: made grain has 1.1
MAX_UNEVENNESS = 1.15  # of quiet ground that is grain: made grain has 1.1, images without it 1.2 and more
MAX_SPREAD = 1.3  # of the quiet quarter over the quietest ground: made grain has 1.2, images without it 1.4 and more
_FREQUENCIES = 4096


@dataclass(frozen=True)
class Grain:
    """Noise of one size."""

    size: float  # standard deviation of the Gaussian that white noise was smoothed by, px; 0 is white
    sigma: float  # standard deviation of the noise, DN


def possible_grains(
    least: Sequence[float | None], wavelet: str, coarsest: float = MAX_HIDDEN_PX
) -> list[Grain] | None:
    """The strongest grain that the quietest ground leaves room for, for each size up to ``coarsest`` (px).

    ``least`` as in ``QuietGround``, of levels 1, 2, ...; None where no level is known."""
    known = [(level, noise) for level, noise in enumerate(least) if noise is not None]
    if not known:
        return None
    return [
        Grain(size, min(noise / math.sqrt(grain_spectrum(wavelet, len(least), size)[level]) for level, noise in known))
        for size in SIZES_PX
        if size <= coarsest
    ]


def recognised_grain(ground: Sequence[QuietGround | None], wavelet: str) -> Grain | None:
    """The grain whose spectrum the quiet ground has, where that is as even as noise is; None elsewhere."""
    grounds = [ground for ground in ground[:FITTED_LEVELS] if ground is not None]
    if len(grounds) < FITTED_LEVELS or not all(map(_is_even, grounds)):
        return None
    quiet = np.array([ground.quiet for ground in grounds])
    sizes = [size for size in SIZES_PX if size <= MAX_GRAIN_PX]
    ratios = {size: quiet / np.sqrt(grain_spectrum(wavelet, FITTED_LEVELS, size)) for size in sizes}
    size = min(ratios, key=lambda size: ratios[size].max() / ratios[size].min())
    if size < MIN_GRAIN_PX or ratios[size].max() / ratios[size].min() > MAX_MISFIT:
        return None
    return Grain(size, float(ratios[size].min()))


def _is_even(ground: QuietGround) -> bool:
    """Whether quiet ground differs from place to place by no more than noise does."""
    return (
        ground.least > 0
        and ground.unevenness <= MAX_UNEVENNESS
        and ground.unevenness * ground.quiet <= MAX_SPREAD * ground.least
    )


def curve_if_white(variances: Sequence[float], grain: Grain, wavelet: str) -> list[float]:
    """The variances of levels 1, 2, ..., were the grain in them white noise of the same strength.

    The paper's rule holds for white noise; so it judges correlated noise by its strength, wherever that lies.
    """
    share = np.array([3 / 4**level for level in range(1, len(variances) + 1)])
    spectrum = grain_spectrum(wavelet, len(variances), grain.size)
    ground = np.maximum(np.asarray(variances) - share * spectrum * grain.sigma**2, 0)
    return [float(value) for value in ground + share * grain.sigma**2]


@lru_cache(maxsize=1024)
def grain_spectrum(wavelet: str, levels: int, size: float) -> tuple[float, ...]:
    """Mean variance of the detail coefficients of levels 1, 2, ... of grain of variance 1; all 1 for white noise."""
    frequency = np.fft.fftfreq(_FREQUENCIES)
    aliases = frequency[:, np.newaxis] + np.arange(-3, 4)  # a scanner samples what is finer than its pixels as well
    power = np.exp(-np.square(2 * np.pi * aliases * size)).sum(axis=1)
    power /= power.mean()
    variances = []
    for level in range(levels):
        low, high = _gains(wavelet, level)
        across, power = power * high, power * low
        variances.append(float(2 * across.mean() * power.mean() + across.mean() ** 2) / 3)
    return tuple(variances)


@lru_cache(maxsize=32)
def _gains(wavelet: str, level: int) -> tuple[np.ndarray, np.ndarray]:
    """The gain of power at each frequency by the low-pass and the high-pass filter of a level, from 0 on."""
    bank, frequency = pywt.Wavelet(wavelet), np.fft.fftfreq(_FREQUENCIES) * 2**level
    phases = np.exp(-2j * np.pi * np.outer(frequency, np.arange(bank.dec_len)))
    low, high = (np.asarray(np.abs(phases @ np.asarray(taps)) ** 2) for taps in (bank.dec_lo, bank.dec_hi))
    return low, high


TEXTURE_RISE = 2.0, 2.5  # of texture's coefficients from level to level: photographs have 2 and more
_QUIET_BIAS = 1.02  # quiet ground of pure noise reads as much too high
EXCELLENT_RATIO, ACCEPTABLE_RATIO = 40.0, 10.0  # signal to noise, ISO 12232: first excellent, first acceptable image
ROUNDING_SIGMA = 0.5  # DN of whole numbers: rounding alone makes 0.29
MAX_COARSE_PX = 2.0  # grain up to here is looked for before noise is called little
_BY_CHANCE = 1.15  # the bound lies above noise that is really there by as much
_OF_ALL = 1.3  # times the noise that bands do not share: texture has raised what level 1 shows by no more
_CLEAR = 0.5  # of the bound: noise found that strong is all of it; grain beside it would be two noises


class NoiseAmount(str, Enum):
    """The amount of noise by the signal to noise ratio."""

    LITTLE = "little"  # a ratio of 40 or more, or no more than rounding
    SOME = "some"  # a ratio of 10 to 40
    MUCH = "much"  # a ratio below 10
    AT_MOST_SOME = "at most some"
    """A ratio of 10 or more: little was found, and coarse grain that can hide in the texture would make it some."""
    UNCERTAIN = "uncertain"  # coarse grain that can hide in the texture would make it much
    NOT_MEASURABLE = "not measurable"  # there is no noise figure, or no signal to compare it with


_ORDER = (NoiseAmount.LITTLE, NoiseAmount.SOME, NoiseAmount.MUCH)


def white_noise(ground: Sequence[QuietGround | None], sigma: float) -> float:
    """Standard deviation of white noise, DN: what level 1 of the quiet ground has beyond texture, which rises to level
    2 as from there to level 3, within ``TEXTURE_RISE``.

    ``sigma``, that of the finest diagonal component, is the most that it can be, and the answer where a level is
    unknown.
    """
    if len(ground) < 2 or ground[0] is None or ground[1] is None:
        return sigma
    first, second = ground[0].quiet ** 2, ground[1].quiet ** 2
    least, most = ((rise**2 * first - second) / (rise**2 - 1) for rise in TEXTURE_RISE)
    variance = most
    if len(ground) > 2 and ground[2] is not None:
        third = ground[2].quiet ** 2
        bend = first + third - 2 * second
        alike = (first * third - second**2) / bend if bend > 0 else least  # where both rises are the same
        variance = sorted((least, alike, most))[1]
    return min(math.sqrt(max(variance, 0.0)) / _QUIET_BIAS, sigma)


def unshared_noise(unshared: Sequence[QuietGround | None], sigma: float, wavelet: str) -> tuple[float, float]:
    """Standard deviations of the noise that bands do not share, DN: if it is white (at most ``sigma``), and the most
    that there is room for at each level, grain of up to 2 px included. Both 0 where a level is unknown."""
    known = [ground.quiet for ground in unshared[:FITTED_LEVELS] if ground is not None]
    possible = possible_grains(known, wavelet, MAX_COARSE_PX) if len(known) == FITTED_LEVELS else None
    return (white_noise(unshared, sigma), max(grain.sigma for grain in possible)) if possible else (0.0, 0.0)


def noise_found(white: float, unshared: tuple[float, float], grain: float) -> float:
    """Standard deviation of the noise, DN, by ``white_noise``, ``unshared_noise`` and the grain that was recognised.
    What bands do not share is all of it, unless level 1 has much more: noise that they share."""
    white = unshared[0] if white < _OF_ALL * unshared[0] else white
    return max(white, grain, unshared[1] if unshared[1] > _OF_ALL * white else 0.0)


def noise_amount(
    noise: float, signal: float, least: Sequence[float | None], wavelet: str, are_whole: bool, unshared: float = 0.0
) -> NoiseAmount:
    """The amount of noise under a signal.

    Parameters
    ----------
    noise, signal : float
        Standard deviation of the noise, and mean of the pixels, DN.
    least : sequence of float or None
        The most that noise can be by the quietest ground of levels 1, 2, ..., DN; None where unknown.
    are_whole : bool
        Whether the values are whole numbers.
    unshared : float
        Noise that bands do not share, DN; where that alone is more than little, no other noise is looked for.
    """
    if signal <= 0:
        return NoiseAmount.NOT_MEASURABLE
    amount = _amount(noise, signal, are_whole)
    if _amount(unshared, signal, are_whole) is not NoiseAmount.LITTLE:
        return amount
    possible = possible_grains(least, wavelet, MAX_COARSE_PX)
    if possible is None:
        return amount if amount is NoiseAmount.MUCH else NoiseAmount.UNCERTAIN
    bound = max(grain.sigma for grain in possible) / _BY_CHANCE
    most = _amount(bound, signal, are_whole)
    is_clear = amount is not NoiseAmount.LITTLE and noise >= _CLEAR * bound
    if is_clear or _ORDER.index(most) <= _ORDER.index(amount):
        return amount
    return NoiseAmount.AT_MOST_SOME if most is NoiseAmount.SOME else NoiseAmount.UNCERTAIN


def _amount(noise: float, signal: float, are_whole: bool) -> NoiseAmount:
    if signal >= EXCELLENT_RATIO * noise or (are_whole and noise <= ROUNDING_SIGMA):
        return NoiseAmount.LITTLE
    return NoiseAmount.SOME if signal >= ACCEPTABLE_RATIO * noise else NoiseAmount.MUCH
