"""Why a mosaic lost contrast in a window: the step of production that explains what was measured (Pyka 2010)."""
from __future__ import annotations

from dataclasses import dataclass
from enum import Enum

import numpy as np

from . import thresholds


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
class Evidence:
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


def find_cause(evidence: Evidence) -> Cause:
    """The first that holds, from the grossest interference with grey values down to the finest with detail.

    A mosaic whose detail none of the sources explains was not made from them, or not in a way we know: unclear. Where
    most of it is a mixture, its tone lies between those of two sources, and small differences to one say nothing.
    """
    if evidence.fit < thresholds.MIN_CAUSE_FIT or evidence.gain is None:
        return Cause.UNCLEAR
    if evidence.clipped >= thresholds.MIN_CLIPPED_SHARE:
        return Cause.CLIPPING
    mostly_mixed = evidence.mixed_share >= thresholds.MIN_MOSTLY_MIXED
    if not mostly_mixed:
        if abs(np.log(evidence.gamma)) >= np.log(thresholds.MIN_GAMMA_CHANGE):
            return Cause.GAMMA
        if evidence.colour_shift is not None and evidence.colour_shift >= thresholds.MIN_COLOUR_SHIFT:
            return Cause.COLOUR_SHIFT
    if abs(evidence.gain) <= (thresholds.MAX_MIXED_NARROWED_GAIN if mostly_mixed else thresholds.MAX_NARROWED_GAIN):
        return Cause.NARROWED_HISTOGRAM
    if evidence.misregistration >= thresholds.MIN_MISREGISTRATION_PX:
        return Cause.MISREGISTRATION
    if evidence.sharpness is not None and evidence.sharpness <= thresholds.MAX_BLURRED_SHARPNESS:
        return Cause.BLUR
    if evidence.mixed_share >= thresholds.MIN_MIXED_SHARE:
        return Cause.FEATHERING
    return Cause.NONE
