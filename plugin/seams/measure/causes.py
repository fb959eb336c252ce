"""Why a mosaic lost contrast in a window: the step of production that explains what was measured (Pyka 2010)."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from math import log

from . import limits

MIN_CAUSE_FIT = 0.05  # strangers explain 0.01 to 0.03; a Gaussian blur of 2 px leaves 0.1
MIN_CLIPPED_SHARE = 0.005  # of the pixels: the share that JRC's specification allows in one tail of the histogram
MIN_MOSTLY_MIXED = 0.5  # of the pixels: beyond it gamma and gains of the colours are those between two sources
MIN_COLOUR_SHIFT = 1.05  # gains of the colours 5 % apart
MIN_GAMMA_CHANGE = 1.1  # as a factor, either way
MAX_NARROWED_GAIN = 0.9  # a tenth of the contrast
MAX_MIXED_NARROWED_GAIN = 0.75  # of windows that are mostly mixed: halves of two sources had 0.85 and more
MAX_STRONGLY_BLURRED_SHARPNESS = 0.75  # a Gaussian blur of 0.5 px: nothing else takes as much
MAX_BLURRED_SHARPNESS = 0.93  # a hard cut has 0.99 to 1.01, a Gaussian blur of 0.5 px 0.7
MIN_MIXED_SHARE = 0.005  # of the pixels: a hard cut has 0.0001, a feather of 7 px some 0.02


@dataclass(frozen=True)
class CauseEvidence:
    """What was measured in a window against the hard-cut composite of its sources."""

    gain: float | None
    """A of the judged band; None where it could not be fitted."""
    gamma: float
    clipped: float
    """Share of pixels, in the band that has most."""
    colour_shift: float | None
    """Largest over smallest gain of the colours."""
    misregistration: float
    """Longest shift of the mosaic on a source it follows, where it follows it, px."""
    mixed_share: float
    """Share of pixels in which two sources are mixed."""
    sharpness: float | None
    """Fine contrast outside the mixtures over the gain: below 1 the mosaic was blurred."""
    fit: float
    """Share of the mosaic's fine detail that its sources explain."""

    @property
    def mostly_mixed(self) -> bool:
        """Whether its tone lies between those of two sources, so that small differences to one say nothing."""
        return self.mixed_share >= MIN_MOSTLY_MIXED

    @property
    def blurred_to(self) -> float:
        """Sharpness; 1 where it is not known."""
        return 1.0 if self.sharpness is None else self.sharpness


Condition = Callable[[CauseEvidence], bool]


def _not_from_these(found: CauseEvidence) -> bool:
    """A mosaic whose detail none of the sources explains was not made from them, or not in a way we know."""
    return found.fit < MIN_CAUSE_FIT or found.gain is None


def _narrowed(found: CauseEvidence) -> bool:
    return abs(found.gain or 1.0) <= (MAX_MIXED_NARROWED_GAIN if found.mostly_mixed else MAX_NARROWED_GAIN)


class Cause(str, Enum):
    """What explains the change: the word that tables hold, when it holds, and when it goes before all others.

    They are asked in this order, from the grossest interference with grey values to the finest.
    """

    holds: Condition
    outweighs: Condition

    def __new__(cls, word: str, holds: Condition, outweighs: Condition = lambda found: False) -> Cause:
        made = str.__new__(cls, word)
        made._value_, made.holds, made.outweighs = word, holds, outweighs
        return made

    UNCLEAR = "unclear", _not_from_these, _not_from_these
    CLIPPING = "clipping", lambda found: found.clipped >= MIN_CLIPPED_SHARE
    GAMMA = "gamma", lambda found: abs(log(found.gamma)) >= log(MIN_GAMMA_CHANGE) and not found.mostly_mixed
    COLOUR_SHIFT = (
        "colour shift", lambda found: (found.colour_shift or 1.0) >= MIN_COLOUR_SHIFT and not found.mostly_mixed
    )
    NARROWED_HISTOGRAM = "narrowed histogram", _narrowed
    MISREGISTRATION = "misregistration", lambda found: found.misregistration >= limits.MIN_MISREGISTRATION_PX
    BLUR = (
        "blur",
        lambda found: found.blurred_to <= MAX_BLURRED_SHARPNESS,
        lambda found: found.blurred_to <= MAX_STRONGLY_BLURRED_SHARPNESS,
    )
    FEATHERING = "feathering", lambda found: found.mixed_share >= MIN_MIXED_SHARE
    NONE = "none", lambda found: True


def find_cause(evidence: CauseEvidence) -> Cause:
    """The first that goes before all others, else the first that holds."""
    outweighing = (cause for cause in Cause if cause.outweighs(evidence))
    return next(outweighing, None) or next(cause for cause in Cause if cause.holds(evidence))
