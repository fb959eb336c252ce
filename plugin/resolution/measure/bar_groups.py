"""The ground resolved distance from the lines measured across the bars: all groups judged together."""
from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import takewhile

import numpy as np

from ...imagery.errors import Message
from ...imagery.rasters import Raster
from . import messages
from . import target as limits
from .bars import BarReading, MeasuredLine, mean_value
from .full_amplitudes import BESIDE_BARS, MIN_ALIAS_FREE_PX, NOWHERE, distance_error, with_full_amplitudes
from .target import DIRECTIONS, GROUP, Target

MIN_NYQUIST_PX = 2.0  # a bar and a gap narrower than two pixels are aliased: Shannon
SURE = 1.96  # standard deviations: 95 %
MIN_TARGET_CONTRAST = 5.0  # bars to gaps: Walczykowski et al. 2009, section 4
MAX_BAR_SPACING_DIFFERENCE = 0.25  # relative, two steps of 2^(1/6): bars further off are not the group's
MAX_TARGET_SCALE_DIFFERENCE = 0.2  # relative: more is no error of drawing or of the pixel size


@dataclass(frozen=True)
class GroupResult:
    """The verdict on a line in one band."""

    measured: MeasuredLine
    band: str  # empty for a line that could not be measured
    grd_cm: float | None  # ground resolved distance of the group; None without a group
    resolved: bool = False
    spurious: bool = False  # whether bars are seen there that are aliasing
    reason: Message | None = None  # why it is not resolved, or what to know about it
    grd_error_cm: float | None = None  # its standard deviation, from those of the amplitudes
    may_pass: bool = False  # whether its bars stand out and their share may reach the criterion (95 %)
    may_fail: bool = True  # whether it is not resolved, or its share may lie below the criterion (95 %)

    @property
    def reading(self) -> BarReading | None:
        """The bars that the line shows in the band; None where it could not be measured."""
        return self.measured.readings.get(self.band)

    @property
    def key(self) -> tuple[str, str]:
        return self.measured.line.direction, self.band

    @property
    def distance(self) -> float:
        """Its ground resolved distance, cm; 0 without a group."""
        return self.grd_cm or 0.0

    @property
    def is_judged(self) -> bool:
        """Whether there was something to judge: a finer group depends on it then."""
        reading = self.reading
        return reading is not None and not reading.is_flat


@dataclass(frozen=True)
class TargetResolution:
    """The verdicts on all groups of a target, and its ground resolved distances."""

    results: tuple[GroupResult, ...]  # verdicts by line and band, in the order of the lines
    finest: dict[tuple[str, str], GroupResult | None]  # resolved group by direction and band; None where there is none
    contrasts: dict[str, float]  # bars to gaps of the coarsest group, DN over DN, by band that has one
    notices: tuple[Message, ...]  # what the user should know of the target as a whole
    scale_notice: Message | None = None  # says that bars do not lie as numbers and pixel size say

    def _finest(self, direction: str) -> list[GroupResult]:
        """The finest resolved group of each band of a direction; none unless every band resolves one."""
        groups = [group for (where, _), group in self.finest.items() if where == direction]
        known = [group for group in groups if group is not None]
        return known if len(known) == len(groups) else []

    def worst(self, direction: str) -> float | None:
        """The largest distance of a direction over its bands; None unless every band resolves a group."""
        return max((group.distance for group in self._finest(direction)), default=None)

    def interval(self, direction: str) -> tuple[float, float] | None:
        """The finest and the coarsest distance that may be that of a direction, cm; None without a distance.

        A group more or less changes the distance by a whole step.
        """
        ends = [self._ends(group) for group in self._finest(direction)]
        if not ends:
            return None
        lows, highs = zip(*ends)
        worst = max(group.distance for group in self._finest(direction))
        return min(max(lows), worst), max(worst, *highs)

    def _ends(self, finest: GroupResult) -> tuple[float, float]:
        """Finest and coarsest distance of a direction and band, cm: where no group surely fails, where all surely
        pass."""
        judged = [group for group in self.results if group.is_judged and group.key == finest.key]
        judged.sort(key=lambda group: -group.distance)
        possible = list(takewhile(lambda group: group.may_pass, judged))
        sure = list(takewhile(lambda group: not group.may_fail, judged)) or judged[:1]
        return min(group.distance for group in [finest, *possible]), max(finest.distance, sure[-1].distance)

    def seen(self, direction: str, observer: str | None = None) -> float | None:
        """Distance of the finest group that an observer tells apart, or all who judged it, before one that is not, cm.

        None where nobody judged a group, or the coarsest one is not told apart.
        """
        finest = None
        lines = {id(result.measured): (result.distance, result.measured.line) for result in self.results}
        for grd, line in sorted(lines.values(), key=lambda pair: -pair[0]):
            words = [seen for name, seen in line.seen.items() if observer in (None, name)]
            if line.direction != direction or not words or line.group is None:
                continue
            if not all(words):
                break
            finest = grd
        return finest

    def worst_error(self, direction: str) -> float | None:
        groups, worst = self._finest(direction), self.worst(direction)
        errors = [group.grd_error_cm for group in groups if group.distance == worst and group.grd_error_cm is not None]
        return max(errors, default=None)

    @property
    def mean_error(self) -> float | None:
        parts = [(self.worst(direction), self.worst_error(direction)) for direction in DIRECTIONS]
        relative = [error / grd for grd, error in parts if grd and error is not None]
        return self.mean * math.hypot(*relative) / 2 if self.mean is not None and len(relative) == 2 else None

    @property
    def mean(self) -> float | None:
        along, across = (self.worst(direction) for direction in DIRECTIONS)
        return None if along is None or across is None else math.sqrt(along * across)


def judge_lines(raster: Raster, measured: Sequence[MeasuredLine], target: Target) -> TargetResolution:
    """The verdicts on all lines of a target, and its ground resolved distance by direction and band."""
    measured = with_full_amplitudes(_countable_lines(measured, target), target)
    scale, off_scale = _pixels_per_cm(raster, measured, target)
    notices = [] if off_scale is None else [off_scale]
    results = [result for line in measured for result in _line_results(line, target, scale)]
    results, finest = _without_spurious(results)
    for (direction, band), result in finest.items():
        if result is None:
            notices.append(messages.NO_GRD(direction=direction, band=band))
    is_backwards = off_scale is not None and scale is None
    contrasts = {} if is_backwards else _contrasts(results)  # backwards: the coarsest one is not known
    if contrasts and min(contrasts.values()) < MIN_TARGET_CONTRAST:
        notices.append(messages.TARGET_CONTRAST_LOW(contrast=min(contrasts.values()), least=MIN_TARGET_CONTRAST))
    for place, notice in ((NOWHERE, messages.NO_PLAIN_PLACE), (BESIDE_BARS, messages.PLAIN_IS_GROUND)):
        places = {result.reading.plain for result in results if result.reading is not None}
        if target.full_amplitude == GROUP and place in places:
            notices.append(notice())
    return TargetResolution(tuple(results), finest, contrasts, tuple(notices), off_scale)


def _contrasts(results: Sequence[GroupResult]) -> dict[str, float]:
    """Bars to gaps of the coarsest group by band, DN over DN."""
    contrasts: dict[str, float] = {}
    for result in sorted(results, key=lambda result: -result.distance):
        reading = result.reading
        if reading is not None and reading.gaps and result.band not in contrasts:
            levels = sorted(mean_value(part) for part in (reading.inner_bars, reading.gaps))
            if levels[0] > 0:
                contrasts[result.band] = levels[1] / levels[0]
    return contrasts


def _countable_lines(measured: Sequence[MeasuredLine], target: Target) -> list[MeasuredLine]:
    """The lines, out of count those of groups that can't be and all but the first of a group and direction."""
    seen: set[tuple[int | None, str]] = set()
    lines = []
    for line in measured:
        group, direction = line.line.group, line.line.direction
        reason = line.reason
        if reason is None and group is not None and not target.has_group(group):
            reason = messages.GROUP_TOO_FAR(group=group, reference=target.reference_group)
        elif reason is None and (group, direction) in seen:
            reason = messages.GROUP_TWICE(group=group, direction=direction)
        elif reason is None:
            seen.add((group, direction))
        lines.append(line if reason is line.reason else MeasuredLine(line.line, line.segment, reason=reason))
    return lines


def _line_results(measured: MeasuredLine, target: Target, scale: float | None) -> list[GroupResult]:
    group = measured.line.group
    grd = None if group is None or not target.has_group(group) else target.grd_cm(group)
    if measured.reason is not None or group is None or grd is None:
        return [GroupResult(measured, "", grd, reason=measured.reason)]
    cycle = None if scale is None else target.cycle_cm(group) * scale
    results = []
    for band, reading in measured.readings.items():
        reason = _why_unresolved(reading, target)
        aliasing = None if reason is not None else _why_aliased(reading, cycle)
        why = reason or aliasing
        resolved, spurious = why is None, aliasing is not None
        if resolved and (value := measured.saturated.get(band)) is not None:
            why = messages.BARS_SATURATED(value=value)
        share, reach = reading.share or 0.0, SURE * (reading.share_error or 0.0)
        may_pass = (
            share + reach >= target.criterion and _why_unclear(reading, target) is None
            and _why_aliased(reading, cycle) is None
        )
        may_fail = not resolved or share - reach < target.criterion
        error = distance_error(reading, grd, target)
        results.append(GroupResult(measured, band, grd, resolved, spurious, why, error, may_pass, may_fail))
    return results


def _why_unresolved(reading: BarReading, target: Target) -> Message | None:
    """The reason why a reading is no resolved group; None when it is one."""
    unclear = _why_unclear(reading, target)
    if unclear is None and (reading.amplitude or 0.0) < target.criterion * reading.full_amplitude:
        return messages.BARS_TOO_WEAK(share=reading.share, criterion=target.criterion)
    return unclear


def _why_unclear(reading: BarReading, target: Target) -> Message | None:
    """The reason why bars are not the group's, however strong they are; None when all of them stand out."""
    count, noise = len(reading.bars), reading.profile.noise
    if reading.is_flat or count == 0:
        return messages.NO_BARS()
    if count < target.bars or reading.amplitude is None:
        return messages.BARS_MERGED(found=count, bars=target.bars)
    if reading.amplitude <= limits.MIN_NOISE_RATIO * noise:
        return messages.BARS_IN_NOISE(amplitude=reading.amplitude, noise=noise)
    if count > target.bars:
        return messages.TOO_MANY_BARS(found=count, bars=target.bars)
    return None


def _why_aliased(reading: BarReading, cycle: float | None) -> Message | None:
    """The reason why bars can't be the group's; None when they can. ``cycle``: the group's, px; None: unknown."""
    spacing = reading.spacing
    assert spacing is not None
    narrow = spacing if cycle is None else min(cycle, spacing * (1 + MAX_BAR_SPACING_DIFFERENCE))
    if narrow < MIN_NYQUIST_PX:
        return messages.BARS_BEYOND_NYQUIST(cycle=narrow)
    if cycle is None and spacing < MIN_ALIAS_FREE_PX:
        return messages.BARS_MAYBE_ALIASED(spacing=spacing)
    if cycle is not None and abs(spacing / cycle - 1) > MAX_BAR_SPACING_DIFFERENCE:
        return messages.BARS_MISPLACED(spacing=spacing, cycle=cycle)
    return None


def _pixels_per_cm(
    raster: Raster, measured: Sequence[MeasuredLine], target: Target
) -> tuple[float | None, Message | None]:
    """The pixels that a centimetre of the target covers, by the pixel size and by the bars themselves.

    The bars are believed where both differ: a photograph may have no scale, or a target another number for its
    reference group. Only bars count for it that lie too far apart to be aliased.
    """
    ground = 0.01 / raster.ground_sample_distance if raster.has_place else None
    if _runs_backwards(_spacings(measured, target, _why_unclear)):  # then amplitudes are held against wrong ones
        return None, messages.TARGET_REVERSED()
    seen = _spacings(measured, target, _why_unresolved)
    if not seen:
        return ground, None
    scale = float(np.median([spacing / cycle for cycle, spacing in seen[:3]]))
    if ground is None:
        return scale, None
    if abs(scale / ground - 1) > MAX_TARGET_SCALE_DIFFERENCE:
        return scale, messages.TARGET_SCALE_DIFFERS(ratio=scale / ground)
    return ground, None


def _spacings(
    measured: Sequence[MeasuredLine], target: Target, why_not: Callable[[BarReading, Target], Message | None]
) -> list[tuple[float, float]]:
    """Cycle by number, cm, and spacing, px, of groups with readings that nothing is held against, coarsest first."""
    seen = []
    for line in measured:
        group = line.line.group
        if line.reason is not None or group is None:
            continue
        good = [reading for reading in line.readings.values() if why_not(reading, target) is None]
        spacings = [reading.spacing for reading in good if reading.spacing is not None]
        if spacings and float(np.median(spacings)) >= MIN_ALIAS_FREE_PX:
            seen.append((target.cycle_cm(group), float(np.median(spacings))))
    return sorted(seen, reverse=True)


def _runs_backwards(seen: Sequence[tuple[float, float]]) -> bool:
    """Whether bars of a larger distance lie closer together."""
    if len({distance for distance, _ in seen}) < 2:
        return False
    distances, spacings = np.log(np.array(seen)).T
    slope = float(np.polyfit(distances, spacings, 1)[0])
    return slope < -0.5


def _without_spurious(
    results: Sequence[GroupResult],
) -> tuple[list[GroupResult], dict[tuple[str, str], GroupResult | None]]:
    """Groups that are finer than one that is not resolved put out of count; the finest that is left."""
    judged = list(results)
    finest: dict[tuple[str, str], GroupResult | None] = {}
    order = sorted(range(len(judged)), key=lambda place: -judged[place].distance)
    lost: dict[tuple[str, str], int] = {}  # the first group of a direction and band that is not resolved
    for place in order:
        result = judged[place]
        key = result.key
        if result.reading is not None:
            finest.setdefault(key, None)  # a band that shows no bars at all resolves nothing
        if not result.is_judged:
            continue
        group = result.measured.line.group
        assert group is not None
        if result.resolved and key in lost:
            judged[place] = replace(
                result, resolved=False, spurious=True, reason=messages.BARS_SPURIOUS(group=lost[key])
            )
        elif result.resolved:
            finest[key] = result
        else:
            lost.setdefault(key, group)
    return judged, finest
