"""What happened to a mosaic in a window: the steps of production that explain what was measured (Pyka 2010)."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum
from math import log

from . import limits

MIN_MISSING_SHARE = 0.03  # of the pixels, lying together, that no given source explains; noise alone has made 0.02
MIN_SURE_FIT, MIN_UNSURE_MISSING_SHARE = 0.9, 0.08  # where compression or filters left less of the sources' detail
MIN_CLIPPED_SHARE = 0.005  # of the pixels: the share that JRC's specification allows in one tail of the histogram
MIN_COLOUR_SHIFT = 1.05  # gains of the colours 5 % apart
MIN_GAMMA_CHANGE = 1.1  # as a factor, either way
MAX_NARROWED_GAIN = 0.9  # a tenth of the contrast
MIN_BALANCED_GAIN = 1.05  # gains of two sources 5 % apart
MIN_BALANCED_OFFSET = 0.03  # of the mosaic's range of values: what one source was raised by against another
MIN_UNEVENNESS = 0.35  # of what a tone leaves over, explained by where on the ground it is
MAX_BLURRED_TRANSFER = 0.93  # of fine detail that comes over; a hard cut has 0.99 to 1.01, a Gaussian of 0.5 px 0.6
MIN_SHARPENED_TRANSFER = 1.07
MAX_BLURRED_COMPRESSED = 0.5  # compression alone lets 0.67 and more of it pass at quality 65
MAX_FEATHERED_KEPT = 0.97  # of the finest detail in the strip along the seam, and certainly less than all of it
MIN_BLENDED_KEPT = 0.2  # two images that have nothing in common keep 0.5 of it mixed half and half; made ones kept 0.27
MIN_MIXED = 0.3  # of the pixels: a feather as wide as the window leaves no ground to tell kept_1 from
MIN_MOSTLY_MIXED = 0.5  # of the pixels: beyond it tones are those between two sources
MIN_RESAMPLED_PX = 0.08  # off the pixels of the source
MIN_NOISE_DN = 1.0  # rounding to whole values leaves 0.3 to 0.8
MIN_COMPRESSED_DN = 0.5
MAX_NOISE_RISE = 1.7  # from weak to strong detail: noise does not ask, a power function or a wrong place do
MIN_QUANTISED, MIN_LOSSY_QUANTISED = 0.05, 0.025  # of coefficients; the second in files that say it themselves


@dataclass(frozen=True)
class SourceTone:
    """What became of one source's grey values, in the mosaic's range of values over the source's."""

    share: float
    """Of the window's pixels."""
    gain: float | None
    """None where the ranges can't be compared."""
    offset: float
    """What its middle grey was raised by, as a share of the mosaic's range."""
    gamma: float
    colour_shift: float | None
    """Largest over smallest gain of the colours."""


@dataclass(frozen=True)
class Texture:
    """What became of fine detail away from the seams, at level 1."""

    transfer: float
    """Of the sources' detail that comes over at their tone: below 1 blurred, above 1 sharpened."""
    least_transfer: float
    """The same of the source of which least comes over."""
    most_transfer: float
    noise_dn: float
    """Standard deviation of what is not from the sources, in weak detail."""
    noise_rise: float
    """How much larger it is in strong detail."""
    quantised: float
    """By which share more of the coefficients of blocks of 8 px vanish on one grid of blocks than on others."""


@dataclass(frozen=True)
class CauseEvidence:
    """What was measured in a window against the hard cut of its sources."""

    missing: float
    """Share of the pixels that no given source explains."""
    kept: float | None
    """kept_1 beside the seam; None without a seam."""
    kept_high: float | None
    """Upper end of its interval."""
    mixed: float
    """Share of the pixels in which two sources together explain the mosaic and neither does alone."""
    sharpness: float | None
    """Of the whole window."""
    clipped: float
    """Share of pixels, in the band that has most."""
    tones: tuple[SourceTone, ...]
    """Of the sources that are followed."""
    unevenness: float
    """Share of what the tones leave over that depends on the place: dodging."""
    misregistration: float
    """How far the mosaic lies off one of its sources on the ground, px."""
    apart: float
    """How much farther off one source than off another, px: the images that meet in the window do not fit."""
    off_pixel: float
    """How far its pixels lie off those of a source that it follows, px, 0 to 0.71."""
    texture: Texture | None
    """None where too little is unmixed."""
    lossy_file: bool
    """Whether the mosaic's file says that it is compressed with loss."""
    fit: float = 1.0
    """Share of the mosaic's fine detail that its sources explain as they are, the mean over the window."""
    unit_dn: float = 1.0
    """How many grey values of the mosaic are one of 8 bit."""

    @property
    def is_compressed(self) -> bool:
        found = self.texture
        if found is None or found.noise_dn < MIN_COMPRESSED_DN * self.unit_dn:
            return False
        return found.quantised >= (MIN_LOSSY_QUANTISED if self.lossy_file else MIN_QUANTISED)

    @property
    def is_mostly_mixed(self) -> bool:
        """Whether its tones lie between those of two sources, so that small differences say nothing."""
        return self.mixed >= MIN_MOSTLY_MIXED

    @property
    def is_smoothed_seam(self) -> bool:
        """Whether less is left along the seam than any mixture of images leaves: somebody softened it."""
        return self.kept_high is not None and self.kept_high < MIN_BLENDED_KEPT and self.mixed < MIN_MIXED

    @property
    def least_transfer(self) -> float:
        """Of fine detail, by the source of which least comes over; by the whole window where none is unmixed."""
        if self.texture is not None:
            return self.texture.least_transfer
        return 1.0 if self.sharpness is None or self.mixed >= MIN_MIXED else self.sharpness

    @property
    def is_uneven(self) -> bool:
        return self.unevenness >= MIN_UNEVENNESS

    @property
    def is_resampled(self) -> bool:
        return self.off_pixel >= MIN_RESAMPLED_PX

    @property
    def spread(self) -> tuple[float, float]:
        """How far the sources' tones lie apart: the largest factor between gains, and between raised middles."""
        gains = [abs(tone.gain) for tone in self.tones if tone.gain]
        offsets = [tone.offset for tone in self.tones]
        return (
            max(gains) / min(gains) if len(gains) > 1 else 1.0,
            max(offsets) - min(offsets) if len(offsets) > 1 else 0.0,
        )

    @property
    def is_balanced(self) -> bool:
        gains, offsets = self.spread
        return gains >= MIN_BALANCED_GAIN or offsets >= MIN_BALANCED_OFFSET


Strength = Callable[[CauseEvidence], float]
"""0 where a cause took no part; else the more it explains, the higher. Above 1: of the seam itself."""


def _missing(found: CauseEvidence) -> float:
    least = MIN_MISSING_SHARE if found.fit >= MIN_SURE_FIT else MIN_UNSURE_MISSING_SHARE
    return 3 + found.missing if found.missing >= least else 0.0


def _misregistration(found: CauseEvidence) -> float:
    if found.misregistration < limits.MIN_MISREGISTRATION_PX:
        return 0.0
    return 2.5 if found.apart >= limits.MIN_MISREGISTRATION_PX / 2 else 0.95


def _feathering(found: CauseEvidence) -> float:
    kept, high = found.kept, found.kept_high
    if found.is_smoothed_seam:
        return 0.0
    if kept is not None and high is not None and kept <= MAX_FEATHERED_KEPT and high < 1:
        return 2 - kept
    return 1.2 if found.mixed >= MIN_MIXED else 0.0


def _blur(found: CauseEvidence) -> float:
    if found.is_resampled and not found.is_smoothed_seam:
        return 0.0
    if found.is_smoothed_seam and found.kept is not None:
        return 2 - found.kept
    least = found.least_transfer
    most = MAX_BLURRED_COMPRESSED if found.is_compressed else MAX_BLURRED_TRANSFER
    return 1 - least**2 if least <= most else 0.0


def _resampled(found: CauseEvidence) -> float:
    return max(1 - found.least_transfer**2, 0.05) if found.is_resampled else 0.0


def _sharpened(found: CauseEvidence) -> float:
    if found.texture is None or found.texture.most_transfer < MIN_SHARPENED_TRANSFER:
        return 0.0
    return min(1 - found.texture.most_transfer**-2, 0.9)


def _compressed(found: CauseEvidence) -> float:
    if found.texture is None or not found.is_compressed:
        return 0.0
    return 0.35 + min(found.texture.noise_dn / found.unit_dn / 100, 0.3)


def _noise(found: CauseEvidence) -> float:
    texture = found.texture
    if texture is None or found.is_compressed or found.misregistration >= limits.MIN_MISREGISTRATION_PX:
        return 0.0
    least = MIN_NOISE_DN * found.unit_dn * max(texture.transfer, 1)
    if texture.noise_dn < least or texture.noise_rise > MAX_NOISE_RISE:
        return 0.0
    return 0.1 + min(texture.noise_dn / found.unit_dn / 100, 0.3)


def _clipping(found: CauseEvidence) -> float:
    return 0.02 + found.clipped if found.clipped >= MIN_CLIPPED_SHARE else 0.0


def _dodging(found: CauseEvidence) -> float:
    return 0.06 if found.is_uneven else 0.0


def _gamma(found: CauseEvidence) -> float:
    bent = [abs(log(tone.gamma)) >= log(MIN_GAMMA_CHANGE) for tone in found.tones]
    return 0.03 if any(bent) and not found.is_uneven and not found.is_mostly_mixed else 0.0


def _colour_shift(found: CauseEvidence) -> float:
    shifts = [tone.colour_shift for tone in found.tones if tone.colour_shift is not None]
    holds = bool(shifts) and min(shifts) >= MIN_COLOUR_SHIFT and not found.is_uneven and not found.is_mostly_mixed
    return 0.025 if holds else 0.0


def _narrowed(found: CauseEvidence) -> float:
    gains = [abs(tone.gain) for tone in found.tones if tone.gain]
    if not gains or max(gains) > MAX_NARROWED_GAIN or _gamma(found):
        return 0.0
    return 0.028 * (2 - max(gains))


def _balanced(found: CauseEvidence) -> float:
    return 0.005 if found.is_balanced and not found.is_uneven and not found.is_mostly_mixed else 0.0


class Cause(str, Enum):
    """What took part in making the window what it is: the word that tables hold, and how strongly it did."""

    strength: Strength

    def __new__(cls, word: str, strength: Strength) -> Cause:
        made = str.__new__(cls, word)
        made._value_, made.strength = word, strength
        return made

    MISSING_SOURCE = "missing source", _missing
    MISREGISTRATION = "misregistration", _misregistration
    FEATHERING = "feathering", _feathering
    BLUR = "blur", _blur
    RESAMPLED = "resampled", _resampled
    SHARPENED = "sharpened", _sharpened
    COMPRESSED = "compressed", _compressed
    NOISE_ADDED = "noise added", _noise
    CLIPPING = "clipping", _clipping
    DODGING = "dodging", _dodging
    GAMMA = "gamma", _gamma
    COLOUR_SHIFT = "colour shift", _colour_shift
    NARROWED_HISTOGRAM = "narrowed histogram", _narrowed
    BALANCED = "balanced", _balanced
    NONE = "none", lambda found: 0.0
    UNCLEAR = "unclear", lambda found: 0.0


def find_causes(evidence: CauseEvidence) -> tuple[Cause, ...]:
    """All that took part, strongest first; ``none`` alone where nothing did."""
    strengths = {cause: cause.strength(evidence) for cause in Cause}
    found: Sequence[Cause] = [cause for cause, strength in strengths.items() if strength > 0]
    return tuple(sorted(found, key=lambda cause: -strengths[cause])) or (Cause.NONE,)
