"""What happened to a mosaic in a window: the steps of production that explain what was measured (Pyka 2010).

Causes are ranked by one figure in one unit: the share of the window's finest detail energy, that of its sources, which
each of them took. What takes none of it (tones, noise, sharpening) comes after all that do.
"""
from __future__ import annotations

from dataclasses import dataclass, replace
from enum import Enum
from math import log

from ..following.compression import MIN_VANISHED
from ..profile.mixture import NARROW_PX
from ..profile.seam_profile import STRIP_PX, Measure, SeamProfile

MIN_MISSING_SHARE = 0.03  # of the pixels, lying together, that no given source explains; noise alone has made 0.02
MIN_CLIPPED_SHARE = 0.005  # of the pixels: the share that JRC's specification allows in one tail of the histogram
MIN_GAIN_RATIO = 1.05  # gains of two colours, or of two sources, 5 % apart
MIN_GAMMA_CHANGE = 1.1  # as a factor, either way
MAX_NARROWED_GAIN = 0.9  # a tenth of the contrast
MIN_BALANCED_OFFSET = 0.03  # of the mosaic's range of values: what one source was raised by against another
MIN_EVENED_POWER = 0.37  # of what a filter leaves of waves of 2.5 px, that it leaves of those of 5 px
MIN_EVENED_FIT = 0.95  # of the mosaic's fine detail, that is its sources' at a lower contrast
MIN_UNEVENNESS = 0.35  # of what a tone leaves over, explained by where on the ground it is
MAX_BLURRED_TRANSFER = 0.93  # of fine detail that comes over; a hard cut has 0.99 to 1.01, a Gaussian of 0.5 px 0.6
MIN_SHARPENED_TRANSFER = 1.07  # as far above 1 as the limit of a blur is below
BENT_TRANSFER = 0.25  # power of a power function's exponent that comes over at most: 1.6 made 1.1, 0.6 left 0.93
MAX_BLURRED_COMPRESSED = 0.4  # of strong detail: compression at quality 65 left 0.43 or more, a Gaussian of 0.8 px 0.36
MAX_FEATHERED_KEPT = 0.97  # of the finest detail in the strip along the seam, and certainly less than all of it
MIN_BLENDED_KEPT = 0.2  # two images that have nothing in common keep 0.5 of it mixed half and half; made ones kept 0.27
MOST_LIKE_BLUR = 0.7  # of what a mixture would keep: with less, filtering took it along the seam
MOST_LEFT = 0.15  # of the sources' energy in the strip, left over by weights: more than so is another mixture
MIN_MIXED_LOSS = 1 / 3  # of what a seam lost: a mixture that would take less of it is not what took it
MIN_MIXED = 0.3  # of the pixels: a feather as wide as the window leaves no border to measure it by, and its tones and
# pixels are those between two sources
MIN_MISFIT_SHARE = 0.35  # of what images differ by, that lies in their misfit: ground seen from two sides has less
MIN_RESAMPLED_PX = 0.15  # off the pixels of the source: parallax in wide feathers made up to 0.15
MIN_NOISE_DN = 1.0  # rounding to whole values leaves 0.3 to 0.8
MIN_COMPRESSED_DN = 0.5  # rounding alone leaves 0.3
MAX_NOISE_RISE = 1.7  # from weak to strong detail: noise does not ask, a power function or a wrong place do
MIN_LOSSY_VANISHED = 0.025  # of the waves, in files that say themselves that they are compressed with loss


@dataclass(frozen=True)
class SourceTone:
    """What became of one source's grey values, in the mosaic's range of values over the source's."""

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
    """Amplitude of the sources' detail that comes over at their tone, a share: below 1 blurred, above 1 sharpened."""
    least_transfer: float
    """Transfer of the source of which least comes over."""
    most_transfer: float
    """Transfer of the source of which most comes over."""
    strong_transfer: float
    """Transfer of what has most detail, which quantisation spares and a blur does not."""
    noise_dn: float
    """Standard deviation of what is not from the sources, in weak detail."""
    noise_rise: float
    """How much larger it is in strong detail."""
    quantised: float
    """Share of the coefficients of blocks of 8 px that vanish on one grid of blocks, less that on others; beyond what
    does in the sources."""
    source_traces: float = 0.0
    """Share that vanishes so in the sources, whose noise is then among what is not from them."""
    least_held: float = 1.0
    """Amplitude of the mosaic's detail over that of the source of which it holds least, by the mosaic's detail: what a
    source lost since the mosaic was made does not lower it."""


@dataclass(frozen=True)
class Misfit:
    """How far two images lie from each other as they are placed in the mosaic."""

    px: float
    share: float
    """Share of what the two finest details differ by beside the seam that would go if they fitted; 0 where they do."""


@dataclass(frozen=True)
class CauseEvidence:
    """What was measured in a window against its sources."""

    missing: float
    """Share of the pixels that no given source explains."""
    profile: SeamProfile | None
    """None without a seam, or with too little to be measured."""
    lost: float
    """Share of the window's finest detail energy that its seams took."""
    mixed: float
    """Share of the pixels in which two sources together explain the mosaic and neither does alone."""
    sharpness: float | None
    """Sharpness of the whole window, as an amplitude."""
    clipped: float
    """Share of pixels, in the band that has most."""
    clipped_lost: float
    """Share of the window's finest detail energy that is gone where it is clipped."""
    tones: tuple[SourceTone, ...]
    """Tones of the sources that are followed."""
    unevenness: float
    """Share of what the tones leave over that depends on the place: dodging."""
    misfit: Misfit | None
    """Misfit of the two images that the mosaic follows most; None where there are none, or it can't be told."""
    off_pixel: float
    """How far its pixels lie off those of a source that it follows, px, 0 to 0.71."""
    texture: Texture | None
    """None where too little is unmixed."""
    lossy_file: bool
    """Whether the mosaic's file says that it is compressed with loss."""
    lossy_sources: bool
    """Whether the file of a source that is followed does."""
    filter_power: float | None = None
    """The power of what the filter that came over the sources leaves of waves of 2.5 px, that it leaves of those of
    5 px, the least of any source; None where no filter explains more than a lower contrast."""
    fit: float = 1.0
    """Share of the mosaic's fine detail that its sources explain as they are, the mean over the window."""
    mid_scale_gain: float = 1.0
    """Gain of tones over some tens of pixels, which fine detail is compared at, over that of tones at large."""
    unit_dn: float = 1.0
    """How many grey values of the mosaic are one of 8 bit."""
    seams: tuple[SeamProfile, ...] = ()
    """Profiles of the seams between each two sources; none where there is a single one."""

    @property
    def by_seam(self) -> list[CauseEvidence]:
        """The evidence on each seam that lost detail for sure; on all together where none did so alone."""
        total = max(sum(seam.lost for seam in self.seams), 1e-9)
        each = [replace(self, profile=seam, lost=self.lost * seam.lost / total, seams=()) for seam in self.seams]
        return [seam for seam in each if seam.has_seam_loss] or [self]

    @property
    def is_compressed(self) -> bool:
        least = MIN_LOSSY_VANISHED if self.lossy_file else MIN_VANISHED
        return self.texture is not None and self.texture.quantised >= least

    @property
    def has_compressed_sources(self) -> bool:
        """Whether noise of a codec in the sources is among what is not from them, by its traces or by their files."""
        if self.texture is None or self.texture.noise_dn < MIN_COMPRESSED_DN * self.unit_dn:
            return False
        return self.lossy_sources or self.texture.source_traces >= MIN_VANISHED

    @property
    def has_codec_noise(self) -> bool:
        """Whether a codec left noise in the mosaic or in its sources, so that no other noise can be told."""
        return self.is_compressed or self.has_compressed_sources

    @property
    def feather_width_px(self) -> float:
        """Full width of the seam's feather; 0 for a cut, and where none was looked for."""
        return (self.profile.feather_width_px if self.profile else None) or 0.0

    @property
    def is_mixed(self) -> bool:
        """Whether much lies between two sources, so that small differences from either say nothing."""
        return self.mixed >= MIN_MIXED

    @property
    def has_seam_loss(self) -> bool:
        """Whether less than all is kept along a seam for sure; without a profile, whether much is a mixture."""
        if self.profile is None:
            return self.is_mixed
        kept = self.profile.kept[0]
        return kept is not None and kept <= MAX_FEATHERED_KEPT and self.profile.high < 1

    @property
    def is_smoothed_seam(self) -> bool:
        """Whether less is left along the seam than a mixture of its images leaves: somebody softened it."""
        profile = self.profile
        if profile is None or not self.has_seam_loss:
            return False
        if profile.high < MIN_BLENDED_KEPT:
            return True
        if profile.measure is not Measure.ENERGY or profile.by_energy is None or profile.by_mixture is None:
            return False
        return profile.by_energy < MOST_LIKE_BLUR * profile.by_mixture

    @property
    def mixed_loss(self) -> float:
        """Share of what a seam lost that mixing its images took: all where nothing says otherwise."""
        profile = self.profile
        if profile is None or profile.measure is not Measure.ENERGY or profile.by_mixture is None:
            return 1.0
        share = max(1 - profile.by_mixture, 0.0) / max(1 - (profile.kept[0] or 0.0), 1e-6)
        return 1.0 if share >= MIN_MIXED_LOSS else share

    @property
    def is_other_mixture(self) -> bool:
        """Whether both images are there along the seam, and no weights explain it. Noise and compression explain
        nothing anywhere, so they must be known not to be there."""
        if self.profile is None or self.feather_width_px < NARROW_PX:
            return False
        is_clean = self.texture is not None and not self.has_codec_noise and not self.is_noisy
        return is_clean and self.profile.left_by_mixture > MOST_LEFT

    @property
    def is_noisy(self) -> bool:
        if self.texture is None or self.has_codec_noise:
            return False
        least = MIN_NOISE_DN * self.unit_dn * max(self.texture.transfer, 1)
        return self.texture.noise_dn >= least and self.texture.noise_rise <= MAX_NOISE_RISE

    @property
    def least_transfer(self) -> float:
        """Share of fine detail that comes over of the source of which least does; by the whole window where none is
        unmixed. A codec's noise is taken to be on the side that shows its traces."""
        if self.texture is not None and not self.is_mixed:
            return self.texture.least_held if self.has_compressed_sources else self.texture.least_transfer
        is_unmixed = not self.is_mixed and not self.feather_width_px
        return self.sharpness if is_unmixed and self.sharpness is not None else 1.0

    @property
    def bends(self) -> tuple[float, float]:
        """What power functions alone may have left of fine detail, at least, and made of it, at most: of grey values
        that were evened out over 8 px they bend what is finer once more."""
        exponents = [1.0, *(tone.gamma for tone in self.tones)]
        return min(exponents) ** BENT_TRANSFER, max(exponents) ** BENT_TRANSFER

    @property
    def off_seam_lost(self) -> float:
        """Share of the window's finest detail energy that is gone and that neither the seams nor clipping took, so that
        all that was taken adds up to what the sharpness says."""
        seam_loss = self.lost if self.has_seam_loss else 0.0
        return max(1 - (1.0 if self.sharpness is None else self.sharpness) ** 2 - seam_loss - self.clipped_lost, 0.0)

    @property
    def is_evened(self) -> bool:
        """Whether contrast was taken of fine and less fine detail alike and from all sources, as by a dodger that
        evens out a coarse overview. Blur and resampling take far more of what is finest."""
        if self.texture is None or self.is_mixed:
            return False
        if self.texture.most_transfer > MAX_BLURRED_TRANSFER * self.bends[0]:
            return False
        if self.has_seam_loss and self.off_seam_lost <= self.lost:
            return False
        if self.filter_power is None:
            return self.fit >= MIN_EVENED_FIT and not self.has_codec_noise
        return self.filter_power >= MIN_EVENED_POWER

    @property
    def is_blurred(self) -> bool:
        """Whether less fine detail comes over than compression, a power function or evened light leave."""
        if self.is_evened:
            return False
        if self.is_compressed and self.texture is not None:
            return self.texture.strong_transfer <= MAX_BLURRED_COMPRESSED
        return self.least_transfer <= MAX_BLURRED_TRANSFER * self.bends[0]

    @property
    def spread(self) -> tuple[float, float]:
        """How far the sources' tones lie apart: the largest factor between gains, and between raised middles."""
        gains = [abs(tone.gain) for tone in self.tones if tone.gain]
        offsets = [tone.offset for tone in self.tones]
        return (
            max(gains) / min(gains) if len(gains) > 1 else 1.0,
            max(offsets) - min(offsets) if len(offsets) > 1 else 0.0,
        )


class Cause(str, Enum):
    """What made the window what it is, by the word that tables hold. Those that took nothing are told in this order."""

    MISSING_SOURCE = "missing source"
    FEATHERING = "feathering"
    OTHER_MIXTURE = "other mixture"
    SOFTENED = "softened seam"
    BLUR = "blur"
    RESAMPLED = "resampled"
    SHARPENED = "sharpened"
    COMPRESSED = "compressed"
    NOISE_ADDED = "noise added"
    CLIPPING = "clipping"
    DODGING = "dodging"
    GAMMA = "gamma"
    NARROWED_HISTOGRAM = "narrowed histogram"
    COLOUR_SHIFT = "colour shift"
    MISREGISTRATION = "misregistration"
    BALANCED = "balanced"
    NONE = "none"
    UNCLEAR = "unclear"


MIXTURES = (Cause.FEATHERING, Cause.OTHER_MIXTURE)
"""Causes that mix images."""
ALONG_THE_SEAM = (*MIXTURES, Cause.SOFTENED, Cause.MISREGISTRATION, Cause.UNCLEAR)
"""Causes that take detail beside a seam alone."""
ALL_OVER = (Cause.BLUR, Cause.RESAMPLED, Cause.COMPRESSED, Cause.CLIPPING, Cause.DODGING)
"""Causes that take detail in the whole window."""


def causes_taken(evidence: CauseEvidence) -> tuple[tuple[Cause, float], ...]:
    """All that took part, and the share of the window's finest detail energy that each took, the most first."""
    taken = {**_of_grey_values(evidence), **_all_over(evidence)}
    for seam in evidence.by_seam:
        for cause, share in _along_the_seam(seam).items():
            taken[cause] = taken.get(cause, 0.0) + share
    if evidence.missing >= MIN_MISSING_SHARE:
        taken[Cause.MISSING_SOURCE] = evidence.missing
    if evidence.clipped >= MIN_CLIPPED_SHARE:
        taken[Cause.CLIPPING] = evidence.clipped_lost
    in_order = [(cause, taken[cause]) for cause in Cause if cause in taken]
    return tuple(sorted(in_order, key=lambda cause_and_share: -cause_and_share[1]))


def find_causes(evidence: CauseEvidence) -> tuple[Cause, ...]:
    """All causes that took part, that which took most first; ``none`` alone where nothing did."""
    return tuple(cause for cause, _ in causes_taken(evidence)) or (Cause.NONE,)


def _along_the_seam(evidence: CauseEvidence) -> dict[Cause, float]:
    """What a seam lost: to a filter, to another mixture, or to weights, of which a misfit has its share.

    That share is what images that fit would give back, beside what a feather as wide as the judged strip would; the
    farther apart they lie, the less that is a remedy.
    """
    misfit, apart_px = (evidence.misfit.share, evidence.misfit.px) if evidence.misfit else (0.0, 0.0)
    misfit = misfit if misfit >= MIN_MISFIT_SHARE else 0.0
    # A cut of images that do not fit breaks lines and loses nothing.
    taken = {Cause.MISREGISTRATION: 0.0} if misfit else {}
    if not evidence.has_seam_loss:
        return taken
    if evidence.is_smoothed_seam:
        return {**taken, Cause.SOFTENED: evidence.lost}
    if evidence.is_other_mixture:
        return {**taken, Cause.OTHER_MIXTURE: evidence.lost}
    mixed = evidence.mixed_loss
    if mixed:
        beyond_strip = 1 - 2 * STRIP_PX / max(evidence.feather_width_px, 2 * STRIP_PX)
        narrowed = max(1 - misfit, beyond_strip / max(apart_px, 1))
        taken = dict.fromkeys(taken, misfit / (misfit + narrowed) * mixed * evidence.lost)
        taken[Cause.FEATHERING] = narrowed / (misfit + narrowed) * mixed * evidence.lost
    if mixed < 1:
        taken[Cause.UNCLEAR] = (1 - mixed) * evidence.lost
    return taken


def _all_over(evidence: CauseEvidence) -> dict[Cause, float]:
    """What is missing elsewhere, which the first of these took."""
    # By ground that is not mixed: a mixture lies between its two images.
    is_resampled = not evidence.is_mixed and evidence.off_pixel >= MIN_RESAMPLED_PX
    holds = {
        Cause.DODGING: evidence.is_evened,
        Cause.RESAMPLED: is_resampled,
        Cause.BLUR: evidence.is_blurred and not is_resampled,
        Cause.COMPRESSED: evidence.is_compressed,
    }
    named = [cause for cause, is_named in holds.items() if is_named]
    return {cause: evidence.off_seam_lost if cause is named[0] else 0.0 for cause in named}


def _of_grey_values(evidence: CauseEvidence) -> dict[Cause, float]:
    """What changes grey values and takes no detail."""
    tones, texture = evidence.tones, evidence.texture
    gains = [abs(tone.gain) for tone in tones if tone.gain]
    shifts = [tone.colour_shift for tone in tones if tone.colour_shift is not None]
    bends = [abs(log(tone.gamma)) for tone in tones]
    is_uneven = evidence.unevenness >= MIN_UNEVENNESS
    has_own_tones = not is_uneven and not evidence.is_mixed
    is_bent = has_own_tones and max(bends, default=0.0) >= log(MIN_GAMMA_CHANGE)
    gain_ratio, offset = evidence.spread
    holds = {
        # Where coarser detail lost more, fine detail only seems to be more; beyond 1 tones at large were evened out.
        Cause.SHARPENED: texture is not None
        and texture.most_transfer * min(evidence.mid_scale_gain, 1) >= MIN_SHARPENED_TRANSFER * evidence.bends[1],
        Cause.NOISE_ADDED: evidence.is_noisy,
        Cause.DODGING: is_uneven and not evidence.is_mixed,
        Cause.GAMMA: is_bent,
        Cause.NARROWED_HISTOGRAM: max(gains, default=1.0) <= MAX_NARROWED_GAIN and not is_bent,
        Cause.COLOUR_SHIFT: has_own_tones and min(shifts, default=1.0) >= MIN_GAIN_RATIO,
        Cause.BALANCED: has_own_tones and (gain_ratio >= MIN_GAIN_RATIO or offset >= MIN_BALANCED_OFFSET),
    }
    return {cause: 0.0 for cause, is_named in holds.items() if is_named}
