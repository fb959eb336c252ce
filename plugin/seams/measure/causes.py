"""Why a mosaic lost contrast in a window: the step of production that explains what was measured (Pyka 2010)."""
from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np

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


class Cause(str, Enum):
    """What explains the change. The values are the words that tables hold."""

    BLUR = "blur"
    FEATHERING = "feathering"
    NARROWED_HISTOGRAM = "narrowed histogram"
    GAMMA = "gamma"
    CLIPPING = "clipping"
    COLOUR_SHIFT = "colour shift"
    MISREGISTRATION = "misregistration"
    NONE = "none"
    UNCLEAR = "unclear"


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


def find_cause(evidence: CauseEvidence) -> Cause:
    """The first that holds: a strong blur, then from the grossest interference with grey values to the finest.

    A mosaic whose detail none of the sources explains was not made from them, or not in a way we know: unclear. Where
    most of it is a mixture, its tone lies between those of two sources, and small differences to one say nothing.
    """
    if evidence.fit < MIN_CAUSE_FIT or evidence.gain is None:
        return Cause.UNCLEAR
    mostly_mixed = evidence.mixed_share >= MIN_MOSTLY_MIXED
    narrowed = MAX_MIXED_NARROWED_GAIN if mostly_mixed else MAX_NARROWED_GAIN
    bent = abs(np.log(evidence.gamma)) >= np.log(MIN_GAMMA_CHANGE)
    sharpness = 1.0 if evidence.sharpness is None else evidence.sharpness
    rules = (
        (Cause.BLUR, sharpness <= MAX_STRONGLY_BLURRED_SHARPNESS),
        (Cause.CLIPPING, evidence.clipped >= MIN_CLIPPED_SHARE),
        (Cause.GAMMA, bent and not mostly_mixed),
        (Cause.COLOUR_SHIFT, (evidence.colour_shift or 1.0) >= MIN_COLOUR_SHIFT and not mostly_mixed),
        (Cause.NARROWED_HISTOGRAM, abs(evidence.gain) <= narrowed),
        (Cause.MISREGISTRATION, evidence.misregistration >= limits.MIN_MISREGISTRATION_PX),
        (Cause.BLUR, sharpness <= MAX_BLURRED_SHARPNESS),
        (Cause.FEATHERING, evidence.mixed_share >= MIN_MIXED_SHARE),
    )
    return next((cause for cause, holds in rules if holds), Cause.NONE)
