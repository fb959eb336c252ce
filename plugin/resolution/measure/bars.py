"""The bars in a profile: where they are, how bright they and their gaps are, and whether they stand out."""
from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from scipy.signal import find_peaks

from ...imagery.errors import BarLineError, Message
from ...imagery.rasters import BIT_DEPTHS, Raster
from . import target as limits
from .profiles import Patch, Profile, Segment, bar_profile, perpendicular_line, read_patch

MIN_BAR_PROMINENCE = 0.25  # of the inner bars' range: half the criterion, so that bars below it are still counted
BARS_WITHIN = 0.5  # of a line's length: its middle holds inner bars and gaps, and no ground
GROUND_BEYOND = 0.15  # of a line's length, beyond its ends: what lies there is ground
GROUND_WITHIN = 0.03  # the same, before its ends
MIN_CLEAR_SPACING_PX = 3.2  # further apart than any bars that aliasing feigns, ground taken for a bar included

_VERTEX_SHARE = 1 / 8  # of a cycle, either side of an extreme: the part of a bar that a parabola is fitted to
_GROUND = (0.55, 1.25)  # of a cycle from an outer bar's middle: where the ground beside it is least blurred by the bar


@dataclass(frozen=True)
class Extreme:
    """The middle of a bar or of a gap."""

    position: float  # px from the line's start, to a fraction of a pixel
    value: float  # DN


@dataclass(frozen=True)
class BarReading:
    """The bars and gaps of a profile in one band."""

    profile: Profile
    bright: bool  # whether the bars are brighter than the ground
    bars: tuple[Extreme, ...]  # the bars that stand out, in the order of the profile
    gaps: tuple[Extreme, ...]  # the gap between each two neighbouring bars
    grounds: tuple[float, ...]  # the ground beside the outer bars, within a cycle and as unlike them as it gets, DN
    full_amplitude: float  # what the amplitude is a share of, DN: to the darkest place, until the target puts it right
    full_error: float  # standard deviation of the full amplitude, DN
    amplitude: float | None  # mean of the inner bars less that of the gaps, DN; None for fewer than two bars
    amplitude_error: float | None  # its standard deviation, DN: from the noise, and from how much bars and gaps differ
    modulation: float | None  # (max - min)/(max + min) of bars and gaps; None for fewer than two bars
    plain: str | None = None  # the ``place`` of the gaps' plain brightness; None until the target puts it right

    @property
    def spacing(self) -> float | None:
        """px from one bar to the next; None for fewer than two."""
        if len(self.bars) < 2:
            return None
        places = [(2 * i, bar.position) for i, bar in enumerate(self.bars)]
        places += [(2 * i + 1, gap.position) for i, gap in enumerate(self.gaps)]
        half_cycles, positions = zip(*places)
        return float(2 * np.polyfit(half_cycles, positions, 1)[0])

    @property
    def share(self) -> float | None:
        return None if self.amplitude is None or self.full_amplitude <= 0 else self.amplitude / self.full_amplitude

    @property
    def share_error(self) -> float | None:
        if self.share is None or not self.amplitude or self.amplitude_error is None:
            return None
        errors = self.amplitude_error / self.amplitude, self.full_error / self.full_amplitude
        return abs(self.share) * math.hypot(*errors)

    @property
    def inner_bars(self) -> tuple[Extreme, ...]:
        """The bars between the outer ones, which other ground does not reach; all when there is none."""
        return self.bars[1:-1] or self.bars

    def threshold(self, criterion: float) -> float:
        """The brightness, DN, that the gaps of a resolved group lie beyond, on the whole."""
        down = -1 if self.bright else 1
        return mean_value(self.inner_bars) + down * criterion * self.full_amplitude

    @property
    def is_flat(self) -> bool:
        """Whether no bar rises out of the noise."""
        return self.full_amplitude <= limits.MIN_NOISE_RATIO * self.profile.noise


def read_bars(profile: Profile, bars: int, bright: bool | None = None) -> BarReading:
    """Find the bars of a group, ``bright`` (than the ground) or dark, None for whichever there are ``bars`` of.

    A bar stands out by a quarter of the profile's range, on the side of a gap at least: the ground beside the outer
    bars may be as bright as they are. Its brightness and place are those of the vertex of a parabola through its middle
    quarter of a cycle, and so are a gap's.
    """
    margin = (1 - BARS_WITHIN) / 2 * profile.length
    middle = profile.values[_between(profile, margin, profile.length - margin)]
    low, high = float(middle.min()), float(middle.max())
    if bright is None:
        bright = _is_bright(profile, low, high, bars)
    sign = 1.0 if bright else -1.0
    values, x = sign * profile.values, profile.positions
    places = _bar_places(profile, sign, high - low, bars)
    if len(places) < 2:
        extremes = tuple(Extreme(float(place), float(np.interp(place, x, profile.values))) for place in places)
        return BarReading(profile, bright, extremes, (), (), high - low, 0.0, None, None, None)
    cycle = float(places[-1] - places[0]) / (len(places) - 1)
    between = [np.flatnonzero((x > first) & (x < last)) for first, last in zip(places, places[1:])]
    lows = [x[inside[np.argmin(values[inside])]] for inside in between]
    tops = tuple(_vertex(x, profile.values, float(place), cycle, sign) for place in places)
    bottoms = tuple(_vertex(x, profile.values, float(place), cycle, -sign) for place in lows)
    beside = [_ground(x, values, top.position, cycle, side) for top, side in ((tops[0], -1), (tops[-1], 1))]
    grounds = [value for value in beside if value is not None]
    inner = tops[1:-1] or tops
    height, depth = sign * mean_value(inner), sign * mean_value(bottoms)
    single = profile.error_over(max(2 * cycle * _VERTEX_SHARE, 0.5))
    for part in (inner, bottoms):
        if len(part) > 1:
            single = max(single, float(np.std([extreme.value for extreme in part], ddof=1)))
    error = single * math.sqrt(1 / len(inner) + 1 / len(bottoms))
    highest, lowest = max(sign * top.value for top in tops), min(sign * bottom.value for bottom in bottoms)
    total = sign * (highest + lowest)
    modulation = abs(highest - lowest) / total if total > 0 else None
    plain = tuple(sign * value for value in grounds)
    full = height - min([lowest, *grounds])
    return BarReading(profile, bright, tops, bottoms, plain, full, error, height - depth, error, modulation)


def mean_value(extremes: Sequence[Extreme]) -> float:
    """The mean brightness of bars or gaps, DN."""
    return float(np.mean([extreme.value for extreme in extremes]))


def _between(profile: Profile, low: float, high: float) -> np.ndarray:
    return (profile.positions >= low - 1e-9) & (profile.positions <= high + 1e-9)


def _is_bright(profile: Profile, low: float, high: float, bars: int) -> bool:
    """Bars are what there are ``bars`` of; where that says nothing clear, what the ground at both ends is not."""
    places = [_bar_places(profile, sign, high - low, bars) for sign in (1.0, -1.0)]
    clear = [len(peaks) == bars and np.ptp(peaks) >= MIN_CLEAR_SPACING_PX * (bars - 1) for peaks in places]
    if clear[0] != clear[1]:
        return bool(clear[0])
    length, beyond, within = profile.length, GROUND_BEYOND * profile.length, GROUND_WITHIN * profile.length
    ends = _between(profile, -beyond, within) | _between(profile, length - within, length + beyond)
    ground = float(np.median(profile.values[ends]))
    return ground < (low + high) / 2


def _bar_places(profile: Profile, sign: float, extent: float, bars: int) -> np.ndarray:
    """px: the middles of the bars that stand out. Outer ones beside bright ground are known by their gaps alone."""
    x = profile.positions
    peaks = x[_peaks(profile, sign, extent)]
    gaps = x[_peaks(profile, -sign, extent)]
    if len(peaks) == bars or len(gaps) != bars - 1 or bars < 3:
        return np.asarray(peaks)
    half = float(gaps[-1] - gaps[0]) / (len(gaps) - 1) / 2
    if gaps[0] - half < 0 or gaps[-1] + half > profile.length:
        return np.asarray(peaks)
    return np.concatenate([[gaps[0] - half], (gaps[1:] + gaps[:-1]) / 2, [gaps[-1] + half]])


def _peaks(profile: Profile, sign: float, extent: float) -> np.ndarray:
    peaks = find_peaks(sign * profile.values, prominence=max(MIN_BAR_PROMINENCE * extent, 1e-9))[0]
    places = profile.positions[peaks]
    return np.asarray(peaks[(places >= 0) & (places <= profile.length)])


def _vertex(x: np.ndarray, values: np.ndarray, place: float, cycle: float, sign: float) -> Extreme:
    """The top of a bar, or with the ``sign`` -1 its bottom: of a parabola, or the mean where it is flat or rings."""
    for _ in range(2):  # the second time around the place that the first one found
        near = np.abs(x - place) <= max(cycle * _VERTEX_SHARE, 0.25)
        dx = x[near] - place
        square, slope, level = np.polyfit(dx, values[near], 2)
        half = float(np.abs(dx).max())
        offset = -slope / (2 * square) if square else 0.0
        if sign * square >= 0 or abs(offset) > half:
            return Extreme(place, float(values[near].mean()))
        place += offset
    return Extreme(place, float(level - slope**2 / (4 * square)))


def _ground(x: np.ndarray, values: np.ndarray, place: float, cycle: float, side: int) -> float | None:
    """The darkest stretch of an eighth of a cycle beyond an outer bar; None where the profile ends."""
    beyond = side * (x - place)
    where = np.flatnonzero((beyond >= _GROUND[0] * cycle) & (beyond <= _GROUND[1] * cycle))
    count = max(1, round(_VERTEX_SHARE * cycle / float(x[1] - x[0])))
    if len(where) < count:
        return None
    return float(np.convolve(values[where], np.full(count, 1 / count), "valid").min())


MAX_SATURATED_SHARE = 0.25  # of the middle of a bar: more is not noise that touches the limit
MAX_SWATH = 0.65  # of a cycle, either side: bars are 2.5 cycles long (USAF-1951, STANAG), the blur takes half a cycle
LINE_BEYOND_BARS = 0.2  # of a cycle, how much longer than bars and gaps a line is drawn: where no bars tell the cycle

GREEN = "green"


@dataclass(frozen=True)
class BarLine:
    """One line of the user, in pixels of the raster."""

    group: int | None  # number of the group; None where none is given
    direction: str  # ``along`` or ``across`` the flight, or what was given instead
    segment: Segment | None  # None where the line can't be used
    reason: Message | None = None  # why it can't be used
    seen: Mapping[str, bool] = field(default_factory=dict)  # whether each observer tells its bars apart


@dataclass(frozen=True)
class MeasuredLine:
    line: BarLine
    segment: Segment | None  # the line turned to be perpendicular to the bars; None when it could not be measured
    readings: dict[str, BarReading] = field(default_factory=dict)  # readings by band
    saturated: dict[str, float | None] = field(default_factory=dict)  # the DN that bars are clipped at, by band
    shifts: dict[str, float | None] = field(default_factory=dict)  # px along the line from the bars of green, by band
    reason: Message | None = None  # why it could not be measured


def measure_line(raster: Raster, line: BarLine, bars: int, width: float, band: int | None = None) -> MeasuredLine:
    """Profiles across the bars of one group and what they show; never raises for a line that can't be measured.

    ``line``: in pixels of the raster. ``width``: px either side of it that are averaged over. ``band``: the place of
    the only one that is measured, None for all. Raises RasterError when the raster can't be read.
    """
    if line.segment is None or line.reason is not None:
        return MeasuredLine(line, None, reason=line.reason)
    try:
        patch = read_patch(raster, line.segment, bars)
    except BarLineError as error:
        return MeasuredLine(line, None, reason=error.message)
    names = raster.band_names
    places = list(range(len(names))) if band is None else [band]
    segment = perpendicular_line(patch, places, line.segment, width)

    def read(index: int, width: float) -> BarReading:
        return read_bars(bar_profile(patch, index, segment, width), bars)

    width = _width_within(width, [read(index, width) for index in places], bars)
    readings = {names[index]: read(index, width) for index in places}
    saturated = {names[index]: _saturation(patch, index, segment, width, readings[names[index]]) for index in places}
    green = readings.get(GREEN) or (read(names.index(GREEN), width) if GREEN in names else None)
    shifts = {name: _shift(reading, green) for name, reading in readings.items()}
    return MeasuredLine(line, segment, readings, saturated, shifts)


def _width_within(width: float, readings: Sequence[BarReading], bars: int) -> float:
    """px either side of a line that stay within the bars' length, though their ends are blurred; ``width`` at most."""
    spacings = [reading.spacing for reading in readings if len(reading.bars) == bars and reading.spacing is not None]
    cycle = min(spacings) if spacings else readings[0].profile.length / (bars + LINE_BEYOND_BARS)
    return min(width, max(0.0, MAX_SWATH * cycle - 0.5))


def _saturation(patch: Patch, band: int, segment: Segment, width: float, reading: BarReading) -> float | None:
    """The DN that two bars or more are clipped at; None when they are not."""
    if len(reading.bars) < 2 or reading.spacing is None or patch.highest is None:
        return None
    along, beside = patch.distances(segment)
    near = (np.abs(beside) <= width + 0.5) & patch.valid
    values = patch.bands[band]
    largest_values = {patch.highest, *(2.0**bits - 1 for bits in BIT_DEPTHS)}
    limits = largest_values if reading.bright else {0.0}
    clipped = []
    for bar in reading.bars:
        middle = values[near & (np.abs(along - bar.position) <= max(reading.spacing / 8, 0.5))]
        if middle.size:
            extreme = float(middle.max() if reading.bright else middle.min())
            if extreme in limits and np.mean(middle == extreme) > MAX_SATURATED_SHARE:
                clipped.append(extreme)
    return clipped[0] if len(clipped) >= 2 else None


def _shift(reading: BarReading, reference: BarReading | None) -> float | None:
    """Mean displacement of bars and gaps; None where they don't correspond."""
    if reference is None or len(reading.bars) < 2 or len(reading.bars) != len(reference.bars):
        return None
    mine, others = ([extreme.position for extreme in (*each.bars, *each.gaps)] for each in (reading, reference))
    return float(np.mean(np.subtract(mine, others)))
