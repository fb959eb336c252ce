"""The amount of noise, whatever the scene: in DN, and as the ratio of the signal to it.

The paper's rule compares noise with the scene's own detail, so 5 DN of it are low among leaves and strong on water.
Here noise is told from texture by the spectrum of the quietest ground: white noise is as strong at every level, texture
grows from level to level. Where there are several bands, texture is in all of them and noise in each by itself.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from enum import Enum

from .grain import FITTED_LEVELS, QuietGround, possible_grains

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
