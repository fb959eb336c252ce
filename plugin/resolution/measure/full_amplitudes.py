"""What the amplitude of a group is a share of, from what all groups of the target show together."""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from .bar_lines import MeasuredLine
from .bars import MIN_CLEAR_SPACING_PX, BarReading, read_bars
from .target import COARSEST, DIRECTIONS, Target
from .target_levels import TargetLevels, kept_slope, target_levels

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
            groups = _groups(lines, direction, band, target)
            levels = target_levels([
                pair for pair in groups if (pair[1].spacing or 0) >= MIN_ALIAS_FREE_PX
            ])
            if levels is None:
                continue
            coarsest = _with_levels(max(groups, key=lambda pair: pair[0])[1], levels)
            lines = [
                line if line.line.direction != direction or band not in line.readings else replace(
                    line, readings={**line.readings, band: _judged(line.readings[band], levels, coarsest, target)}
                )
                for line in lines
            ]
    return lines


def distance_error(reading: BarReading, grd_cm: float, target: Target) -> float | None:
    """Standard deviation of the distance at which the amplitude falls to the criterion, cm.

    The error of the amplitude's share, over how fast a blur takes that share from group to group there. None where the
    share has none.
    """
    if reading.share_error is None:
        return None
    criterion = target.criterion
    kept = criterion if target.full_amplitude == COARSEST else criterion / (2 - criterion)
    by_kept = 1.0 if target.full_amplitude == COARSEST else 2 / (1 + kept) ** 2  # share = 2 kept / (1 + kept)
    return grd_cm * reading.share_error / (by_kept * kept_slope(kept))


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


def _groups(
    lines: Sequence[MeasuredLine], direction: str, band: str, target: Target
) -> list[tuple[float, BarReading]]:
    """Distance and reading of the groups of a direction that show all their bars."""
    return [
        (target.grd_cm(line.line.group), line.readings[band]) for line in lines
        if line.line.direction == direction and line.line.group is not None and band in line.readings
        and len(line.readings[band].bars) == target.bars
    ]


def _judged(reading: BarReading, levels: TargetLevels, coarsest: BarReading, target: Target) -> BarReading:
    if target.full_amplitude == COARSEST:
        return replace(
            reading, full_amplitude=coarsest.full_amplitude, full_error=coarsest.full_error, plain=coarsest.plain
        )
    return _with_levels(reading, levels)


def _with_levels(reading: BarReading, levels: TargetLevels) -> BarReading:
    """Its bars against the target's plain gaps."""
    if not reading.bars:
        return reading
    sign = 1.0 if reading.bright else -1.0
    top = max(sign * bar.value for bar in reading.inner_bars)
    error = math.hypot((reading.amplitude_error or 0.0) / math.sqrt(2), levels.error)
    return replace(reading, full_amplitude=top - sign * levels.gap, full_error=error, plain=levels.place)
