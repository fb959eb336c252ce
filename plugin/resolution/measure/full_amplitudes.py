"""The full amplitude, of which a group shows a share: from all groups of the target together."""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.special import ndtr

from .bars import MIN_CLEAR_SPACING_PX, BarReading, MeasuredLine, mean_value, read_bars
from .target import COARSEST, DIRECTIONS, Target

MAX_CONTRAST_ERROR = 0.15  # relative: bars that say less of the target's contrast are not asked
MIN_GROUP_ERROR = 0.02  # relative, of an amplitude: a blur is not quite a Gaussian one, and phases differ

IN_GROUPS = "groups"  # a target's plain brightness is measured in its own bars and gaps, by the fall of amplitudes
BESIDE_BARS = "ground"  # in the ground beside the bars
NOWHERE = "nowhere"  # the darkest place that was seen is taken

_COARSE = 3  # groups that say the middle: in finer ones saturation and a blur's far reach shift it
_WIDTHS = np.geomspace(1.2, 40.0, 240)  # of the coarsest group's cycle, in standard deviations of the blur


@dataclass(frozen=True)
class TargetLevels:
    """A target's plain brightness in one band, DN."""

    gap: float  # brightness of its gaps, where nothing blurs them
    error: float  # standard deviation of the gaps' brightness, DN
    place: str  # where it was measured: IN_GROUPS, BESIDE_BARS or NOWHERE


def kept_contrast(width: np.ndarray | float) -> np.ndarray:
    """The share of its contrast that is left in a group of bars whose cycle is ``width`` sigmas of a Gaussian blur.

    The middle of an inner bar less that of a gap beside it; the ground beside the bars has no part in it.
    """
    quarter = np.asarray(width) / 4
    return np.asarray(1 - 4 * ndtr(-quarter) + 4 * ndtr(-3 * quarter) - 2 * ndtr(-5 * quarter))


def target_levels(groups: Sequence[tuple[float, BarReading]]) -> TargetLevels | None:
    """The plain brightness of a target in one band; None where no group shows bars. ``groups``: cycle, in any unit, and
    reading.

    A blur raises gaps by what it takes from the bars, so bars and gaps together say the middle of the target's
    contrast, and the fall of their difference from group to group says how much of it even the coarsest one lost. The
    ground beside the bars counts where the groups don't say otherwise, as it may be other ground.
    """
    usable = [(cycle, reading) for cycle, reading in groups if reading.amplitude is not None and reading.amplitude > 0]
    if not usable:
        return None
    usable.sort(key=lambda pair: -pair[0])
    bright = usable[0][1].bright
    sign = 1.0 if bright else -1.0
    cycles = np.array([cycle for cycle, reading in usable if reading.bright == bright])
    used = [reading for _, reading in usable if reading.bright == bright]
    tops = np.array([sign * mean_value(reading.inner_bars) for reading in used])
    bottoms = np.array([sign * mean_value(reading.gaps) for reading in used])
    heights = tops - bottoms
    errors = np.hypot([reading.amplitude_error or 0.0 for reading in used], MIN_GROUP_ERROR * heights)
    middle = float(np.mean((tops + bottoms)[:_COARSE]) / 2)
    contrast, error = _contrast(cycles, heights, errors)
    beside = [2 * (middle - sign * value) for reading in used for value in reading.grounds]
    ground = max(beside, default=0.0)  # the contrast, if the darkest ground beside the bars is the target's own
    seen, close = float(heights.max()), float(errors[0])
    tell = error <= MAX_CONTRAST_ERROR * contrast
    if tell and (error < close or abs(ground - contrast) > 2 * error):
        return TargetLevels(sign * (middle - contrast / 2), error / 2, IN_GROUPS)
    if ground > seen:
        return TargetLevels(sign * (middle - ground / 2), close / 2, BESIDE_BARS)
    return TargetLevels(sign * (middle - seen / 2), close / 2, NOWHERE)


def _contrast(cycles: np.ndarray, heights: np.ndarray, errors: np.ndarray) -> tuple[float, float]:
    """The contrast of a target and its standard deviation, from the amplitudes of its groups.

    For each blur the contrast that fits best, all of them weighted by how well they fit. One width says nothing.
    """
    if np.ptp(cycles) < 1e-6 * cycles.max():
        return float(heights.max()), math.inf
    kept = kept_contrast(np.outer(_WIDTHS, cycles / cycles.max()))
    weight = 1 / errors**2
    information = np.sum(kept**2 * weight, axis=1)
    contrasts = np.sum(kept * heights * weight, axis=1) / information
    misfit = np.sum((heights - contrasts[:, np.newaxis] * kept) ** 2 * weight, axis=1)
    scale = max(1.0, float(misfit.min()) / max(1, len(cycles) - 2))
    likely = np.exp(-(misfit - misfit.min()) / (2 * scale))
    likely /= likely.sum()
    mean = float(np.sum(likely * contrasts))
    spread = float(np.sum(likely * ((contrasts - mean) ** 2 + scale / information)))
    return mean, math.sqrt(spread)


MIN_ALIAS_FREE_PX = 2.5  # three bars that are finer than two pixels can't seem so far apart in the 5 px they cover

_VOTES = 5  # the coarsest readings that say whether a target's bars are bright or dark


def with_full_amplitudes(measured: Sequence[MeasuredLine], target: Target) -> list[MeasuredLine]:
    """The lines, the full amplitudes of their readings put right.

    That of a group is its bars against the plain gaps of the target, or, where the target asks so, the one of the
    coarsest group of the same direction and band.
    """
    lines = _alike(measured, target.bars)
    for direction in DIRECTIONS:
        for band in dict.fromkeys(band for line in lines for band in line.readings):
            groups = [
                (target.grd_cm(line.line.group), line.readings[band]) for line in lines
                if line.line.direction == direction and line.line.group is not None and band in line.readings
                and len(line.readings[band].bars) == target.bars
            ]
            levels = target_levels([pair for pair in groups if (pair[1].spacing or 0) >= MIN_ALIAS_FREE_PX])
            if levels is None:
                continue
            coarsest = _with_levels(max(groups, key=lambda pair: pair[0])[1], levels)
            for place, line in enumerate(lines):
                if line.line.direction != direction or band not in line.readings:
                    continue
                reading = _with_levels(line.readings[band], levels)
                if target.full_amplitude == COARSEST:
                    reading = replace(
                        reading, full_amplitude=coarsest.full_amplitude, full_error=coarsest.full_error,
                        plain=coarsest.plain,
                    )  # fmt: skip
                lines[place] = replace(line, readings={**line.readings, band: reading})
    return lines


def distance_error(reading: BarReading, grd_cm: float, target: Target) -> float | None:
    """Standard deviation of the distance at which the amplitude falls to the criterion, cm.

    The error of the amplitude's share, over how fast a blur takes that share from group to group there. None where the
    share has none, or no blur changes it.
    """
    criterion = target.criterion
    kept = criterion if target.full_amplitude == COARSEST else criterion / (2 - criterion)
    widths = np.geomspace(0.5, 40, 2000)
    shares = kept_contrast(widths)
    # The change of the contrast's kept share with a relative change of the cycle, where so much is kept.
    slope = float(np.interp(kept, shares, np.gradient(shares, np.log(widths))))
    if target.full_amplitude != COARSEST:
        slope *= 2 / (1 + kept) ** 2  # share = 2 kept / (1 + kept)
    return None if reading.share_error is None or not slope else grd_cm * reading.share_error / slope


def _alike(measured: Sequence[MeasuredLine], bars: int) -> list[MeasuredLine]:
    """The lines, all of them read as the widest bars of the target are: bright ones, or dark ones."""
    clear = [
        (reading.spacing, reading.bright) for line in measured for reading in line.readings.values()
        if len(reading.bars) == bars and reading.spacing is not None and reading.spacing >= MIN_CLEAR_SPACING_PX
    ]
    if not clear:
        return list(measured)
    votes = [bright for _, bright in sorted(clear, key=lambda pair: -pair[0])[:_VOTES]]
    bright = 2 * sum(votes) > len(votes)
    return [replace(line, readings={
        band: reading if reading.bright == bright else read_bars(reading.profile, bars, bright)
        for band, reading in line.readings.items()
    }) for line in measured]


def _with_levels(reading: BarReading, levels: TargetLevels) -> BarReading:
    """The reading, its full amplitude that of its bars against the target's plain gaps."""
    if not reading.bars:
        return reading
    sign = 1.0 if reading.bright else -1.0
    top = max(sign * bar.value for bar in reading.inner_bars)
    error = math.hypot((reading.amplitude_error or 0.0) / math.sqrt(2), levels.error)
    return replace(reading, full_amplitude=top - sign * levels.gap, full_error=error, plain=levels.place)
