"""The bars in a profile: where they are, how bright they and their gaps are, and whether they stand out."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.signal import find_peaks

from . import limits
from .profiles import Profile

MIN_BAR_PROMINENCE = 0.25  # of the full amplitude: half the criterion, so that bars below it are still counted
GROUND_BEYOND = 0.15  # of a line's length, beyond its ends: what lies there is ground
GROUND_WITHIN = 0.03  # the same, before its ends
MIN_GROUND_OFFSET = 0.15  # of the full amplitude: ground nearer to the middle is neither bright nor dark

_VERTEX_SHARE = 1 / 8  # of a cycle, either side of an extreme: the part of a bar that a parabola is fitted to
_FLANK = (0.3, 0.8)  # of a cycle from an outer bar: where the ground beside it is its gap


@dataclass(frozen=True)
class Extreme:
    """The middle of a bar or of a gap."""

    position: float
    """px from the line's start, to a fraction of a pixel."""
    value: float
    """DN."""


@dataclass(frozen=True)
class BarReading:
    """What a profile shows in one band."""

    profile: Profile
    bright: bool
    """Whether the bars are brighter than the ground."""
    bars: tuple[Extreme, ...]
    """The bars that stand out, in the order of the profile."""
    gaps: tuple[Extreme, ...]
    """The gap between each two neighbouring bars."""
    flanks: tuple[Extreme, ...]
    """The ground beside the outer bars, within a cycle."""
    full_amplitude: float
    """Brightest bar less darkest gap, the ground beside the outer bars included, DN."""
    amplitude: float | None
    """The smallest difference of a bar to a gap beside it, DN; None for fewer than two bars."""
    modulation: float | None
    """(max - min)/(max + min) of the bars and the gaps between them; None for fewer than two bars."""

    @property
    def spacing(self) -> float | None:
        """px from one bar to the next; None for fewer than two."""
        places = [(2 * i, bar.position) for i, bar in enumerate(self.bars)]
        places += [(2 * i + 1, gap.position) for i, gap in enumerate(self.gaps)]
        if len(self.bars) < 2:
            return None
        half_cycles, positions = zip(*places)
        return float(2 * np.polyfit(half_cycles, positions, 1)[0])

    @property
    def share(self) -> float | None:
        """The amplitude's share of the full amplitude."""
        return None if self.amplitude is None or self.full_amplitude <= 0 else self.amplitude / self.full_amplitude

    @property
    def is_flat(self) -> bool:
        """Whether nothing rises out of the noise."""
        return self.full_amplitude <= limits.MIN_NOISE_RATIO * self.profile.noise


def read_bars(profile: Profile, bars: int) -> BarReading:
    """Find the bars of a group in a profile, bright ones on dark ground or dark ones on bright ground.

    A bar stands out by a quarter of the profile's range. Its brightness and place are those of the vertex of a
    parabola through its middle quarter of a cycle, and so are a gap's.
    """
    drawn = _between(profile, 0, profile.length)
    low, high = float(profile.values[drawn].min()), float(profile.values[drawn].max())
    bright = _is_bright(profile, (low + high) / 2, high - low, bars)
    sign = 1.0 if bright else -1.0
    values = sign * profile.values
    peaks = _peaks(profile, sign, high - low)
    x = profile.positions
    if len(peaks) < 2:
        found = tuple(Extreme(float(x[peak]), float(profile.values[peak])) for peak in peaks)
        return BarReading(profile, bright, found, (), (), high - low, None, None)
    cycle = float(x[peaks[-1]] - x[peaks[0]]) / (len(peaks) - 1)
    lows = [first + int(np.argmin(values[first:last])) for first, last in zip(peaks, peaks[1:])]
    tops = [_vertex(x, values, float(x[place]), cycle) for place in peaks]
    bottoms = [_vertex(x, -values, float(x[place]), cycle) for place in lows]
    bottoms = [Extreme(one.position, -one.value) for one in bottoms]
    flanks = [_flank(x, values, top.position, cycle, side) for top, side in ((tops[0], -1), (tops[-1], 1))]
    outer = [flank for flank in flanks if flank is not None]
    full = max(top.value for top in tops) - min(one.value for one in (*bottoms, *outer))
    amplitude = min(top.value - bottom.value for pair, bottom in zip(zip(tops, tops[1:]), bottoms) for top in pair)
    sides = [sign * max(top.value for top in tops), sign * min(bottom.value for bottom in bottoms)]
    total = sum(sides)
    modulation = abs(sides[0] - sides[1]) / total if total > 0 else None
    signed = [tuple(Extreme(one.position, sign * one.value) for one in group) for group in (tops, bottoms, outer)]
    return BarReading(profile, bright, signed[0], signed[1], signed[2], full, amplitude, modulation)


def _between(profile: Profile, low: float, high: float) -> np.ndarray:
    return (profile.positions >= low - 1e-9) & (profile.positions <= high + 1e-9)


def _is_bright(profile: Profile, middle: float, extent: float, bars: int) -> bool:
    """Bars are what the ground at both ends is not; where that lies half-way, what there are ``bars`` of."""
    length, beyond, within = profile.length, GROUND_BEYOND * profile.length, GROUND_WITHIN * profile.length
    ends = _between(profile, -beyond, within) | _between(profile, length - within, length + beyond)
    ground = float(np.median(profile.values[ends]))
    if abs(ground - middle) > MIN_GROUND_OFFSET * extent:
        return ground < middle
    counts = [abs(len(_peaks(profile, sign, extent)) - bars) for sign in (1.0, -1.0)]
    return counts[0] <= counts[1]


def _peaks(profile: Profile, sign: float, extent: float) -> np.ndarray:
    peaks = find_peaks(sign * profile.values, prominence=max(MIN_BAR_PROMINENCE * extent, 1e-9))[0]
    places = profile.positions[peaks]
    return np.asarray(peaks[(places >= 0) & (places <= profile.length)])


def _vertex(x: np.ndarray, values: np.ndarray, place: float, cycle: float) -> Extreme:
    """The top of a bar: of a parabola, or the mean where the bar is flat or its edges ring."""
    for _ in range(2):  # the second time around the place that the first one found
        near = np.abs(x - place) <= max(cycle * _VERTEX_SHARE, 0.25)
        dx = x[near] - place
        square, slope, level = np.polyfit(dx, values[near], 2)
        half = float(np.abs(dx).max())
        offset = -slope / (2 * square) if square < 0 else 0.0
        if square >= 0 or abs(offset) > half:
            middle = _plateau(x, values, place, cycle)
            return Extreme(middle, float(values[near].mean()))
        place += offset
    return Extreme(place, float(level - slope**2 / (4 * square)))


def _plateau(x: np.ndarray, values: np.ndarray, place: float, cycle: float) -> float:
    """The middle of what lies above half of a bar's height."""
    near = np.abs(x - place) <= cycle / 2
    part = values[near]
    above = x[near][part >= (part.min() + part.max()) / 2]
    return float((above.min() + above.max()) / 2)


def _flank(x: np.ndarray, values: np.ndarray, place: float, cycle: float, side: int) -> Extreme | None:
    """The darkest stretch of a quarter of a cycle beyond an outer bar; None where the profile ends."""
    beyond = side * (x - place)
    where = np.flatnonzero((beyond >= _FLANK[0] * cycle) & (beyond <= _FLANK[1] * cycle))
    count = max(1, round(2 * _VERTEX_SHARE * cycle / float(x[1] - x[0])))
    if len(where) < count:
        return None
    means = np.convolve(values[where], np.full(count, 1 / count), "valid")
    first = int(np.argmin(means))
    return Extreme(float(x[where[first : first + count]].mean()), float(means[first]))
