"""A line across the bars of one group: its profiles, the bars in them, and what makes them doubtful."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from ...imagery.errors import BarLineError, Message
from ...imagery.rasters import BIT_DEPTHS, Raster
from .bars import BarReading, read_bars
from .profiles import Patch, Segment, bar_profile, perpendicular_line, read_patch

MAX_SATURATED_SHARE = 0.25  # of the middle of a bar: more is not noise that touches the limit
MAX_SWATH = 0.65  # of a cycle, either side: bars are 2.5 cycles long (USAF-1951, STANAG), the blur takes half a cycle
LINE_BEYOND_BARS = 0.2  # of a cycle, how much longer than bars and gaps a line is drawn: where no bars tell the cycle

GREEN = "green"


@dataclass(frozen=True)
class BarLine:
    """One line of the user, in pixels of the raster."""

    group: int | None
    """Number of the group; None where none is given."""
    direction: str
    """``along`` or ``across`` the flight, or what was given instead."""
    segment: Segment | None
    """None where the line can't be used."""
    reason: Message | None = None
    """Why it can't be used."""
    seen: Mapping[str, bool] = field(default_factory=dict)
    """Whether each observer who judged the group tells its bars apart."""


@dataclass(frozen=True)
class MeasuredLine:
    """What a line showed."""

    line: BarLine
    segment: Segment | None
    """The line turned to be perpendicular to the bars; None when it could not be measured."""
    readings: dict[str, BarReading] = field(default_factory=dict)
    """By band."""
    saturated: dict[str, float] = field(default_factory=dict)
    """The DN that bars are clipped at, by band."""
    shifts: dict[str, float] = field(default_factory=dict)
    """Displacement of a band's bars against those of green along the line, px, by band."""
    reason: Message | None = None
    """Why it could not be measured."""


def measure_line(raster: Raster, line: BarLine, bars: int, width: float, band: int | None = None) -> MeasuredLine:
    """Profiles across the bars of one group and what they show; never raises for a line that can't be measured.

    ``width``: px either side that the profile is averaged over. ``band``: the place of the one band that is measured,
    None for all. Raises RasterError when the raster can't be read.
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
    width = _width_within(width, [read_bars(bar_profile(patch, index, segment, width), bars) for index in places], bars)
    every = {index: read_bars(bar_profile(patch, index, segment, width), bars) for index in places}
    readings = {names[index]: reading for index, reading in every.items()}
    clipped = {names[index]: _saturation(patch, index, segment, width, reading) for index, reading in every.items()}
    reference = readings.get(GREEN)
    if GREEN in names and reference is None:
        reference = read_bars(bar_profile(patch, names.index(GREEN), segment, width), bars)
    shifts = {}
    for name, reading in readings.items():
        shift = _shift(reading, reference)
        if shift is not None:
            shifts[name] = shift
    saturated = {name: value for name, value in clipped.items() if value is not None}
    return MeasuredLine(line, segment, readings, saturated, shifts)


def _width_within(width: float, readings: Sequence[BarReading], bars: int) -> float:
    """px either side of a line that stay within the bars' length, though their ends are blurred; ``width`` at most."""
    spacings = [one.spacing for one in readings if len(one.bars) == bars and one.spacing is not None]
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
    mine, others = ([one.position for one in (*each.bars, *each.gaps)] for each in (reading, reference))
    return float(np.mean(np.subtract(mine, others)))
