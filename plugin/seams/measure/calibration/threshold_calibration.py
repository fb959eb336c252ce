"""Judging the judge: how well a measure tells the windows where an observer saw a loss from those where he saw none.

A measure is low where detail was lost. At a threshold t every window with measure <= t is flagged (of the visibility,
which is high there, with measure >= t); sensitivity is the share of the visible losses that are flagged, specificity
the share of the invisible ones that are not. Both for all t are the ROC curve; the area under it is the probability
that a visible loss has the lower value (Hanley and McNeil 1982). Pyka 2010, section 6, asks for it: limits of loss
need research on statistically significant samples.
"""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from ....imagery import limits as imagery_limits
from ....imagery.errors import Message
from ....imagery.grids import Extent
from ....imagery.statistics import Interval
from .. import limits, messages
from .neighbourhoods import MIN_NEIGHBOURHOODS, Neighbourhoods, find_neighbourhoods
from .verdict_statistics import MIN_VERDICTS, best_threshold, roc_area, wanted_verdicts

STANDARD_LIMITS = {
    "kept_1": limits.MAX_SIGNIFICANT_KEPT, "ratio_1": imagery_limits.MAX_SIGNIFICANT_RATIO,
    "visibility": limits.JUST_VISIBLE,
}  # fmt: skip
"""What the plugin itself takes a measure to tell a loss at."""

_ROUNDING = 1 / 40  # of the threshold's range: a twentieth of what it is off by at most, so nothing is lost
_FINEST_STEP = 1e-9  # a threshold that has to stay below a number stays that far below it


@dataclass(frozen=True)
class Verdicts:
    """The values of one measure in the windows that an observer judged; none of them NaN."""

    measure: str
    """Name of the field it comes from."""
    visible: tuple[float, ...]
    """Windows where a loss was seen."""
    invisible: tuple[float, ...]
    """Windows where none was seen."""
    visible_places: tuple[int, ...] = ()
    """The neighbourhood of each visible verdict; without these every window stands for itself."""
    invisible_places: tuple[int, ...] = ()
    """The neighbourhood of each invisible verdict."""
    is_loss: bool = False
    """Whether the measure is high where detail was lost."""

    @property
    def neighbourhoods(self) -> Neighbourhoods:
        """What is resampled."""
        if self.visible_places or self.invisible_places:
            return Neighbourhoods(self.visible_places, self.invisible_places)
        return Neighbourhoods.of_single_windows(len(self.visible), len(self.invisible))


def verdicts_of(
    measure: str, values: Sequence[tuple[Extent | None, bool, float]], is_loss: bool = False
) -> Verdicts:
    """Verdicts of judged windows: where each lies, whether a loss was seen there, and the measure's value."""
    places = find_neighbourhoods([extent for extent, _, _ in values])
    rows = [(seen, value, place) for (_, seen, value), place in zip(values, places)]
    return Verdicts(
        measure,
        visible=tuple(value for seen, value, _ in rows if seen),
        invisible=tuple(value for seen, value, _ in rows if not seen),
        visible_places=tuple(place for seen, _, place in rows if seen),
        invisible_places=tuple(place for seen, _, place in rows if not seen),
        is_loss=is_loss,
    )


@dataclass(frozen=True)
class Step:
    """What a threshold does to the judged windows."""

    threshold: float
    """Windows with the measure at or below it, for one of loss at or above it, are flagged."""
    flagged_visible: int
    """How many of the visible losses it flags."""
    flagged_invisible: int
    """How many windows without a visible loss it flags in vain."""
    sensitivity: float
    """Share of the visible losses that are flagged, 0 to 1."""
    specificity: float
    """Share of the windows without one that are not, 0 to 1."""

    @property
    def youden(self) -> float:
        """Youden's index, sensitivity + specificity - 1: 0 is a guess, 1 is without fault."""
        return self.sensitivity + self.specificity - 1


@dataclass(frozen=True)
class ThresholdCalibration:
    """What the verdicts say of one measure."""

    verdicts: Verdicts
    steps: tuple[Step, ...] = ()
    """One for each value that occurs, that which flags least first: between two values nothing changes. Empty with too
    few verdicts."""
    area: Interval | None = None
    """Under the ROC curve; 0.5 is a guess, 1 is without fault. None with too few verdicts."""
    best: Step | None = None
    """The threshold with the largest Youden index of fitted distributions; None where it can't be set or is a guess."""
    best_range: tuple[float, float] | None = None
    """The interval of the best threshold of all windows like these, 95 %."""
    wanted: tuple[int, int] | None = None
    """How many visible and invisible verdicts would be enough; None with too few to say."""
    neighbourhoods: int | None = None
    """How many neighbourhoods the judged windows form; None where they were taken as if each stood for itself."""
    notices: tuple[Message, ...] = ()
    """Why there is no number, or how far to trust it."""


def calibrate(verdicts: Verdicts, most: float = math.inf) -> ThresholdCalibration:
    """Area, best threshold and verdicts wanted of one measure.

    ``most``: the threshold has to stay below it, as one that can be set does. With fewer than five visible or five
    invisible verdicts there is a notice and no number.
    """
    if verdicts.is_loss:
        negative = calibrate(_negative(verdicts))
        steps = tuple(replace(step, threshold=-step.threshold) for step in negative.steps)
        best = negative.best and replace(negative.best, threshold=-negative.best.threshold)
        ends = negative.best_range and (max(-negative.best_range[1], 0.0), -negative.best_range[0])
        return replace(negative, verdicts=verdicts, steps=steps, best=best, best_range=ends)
    visible, invisible = (np.array(kind, np.float64) for kind in (verdicts.visible, verdicts.invisible))
    if min(len(visible), len(invisible)) < MIN_VERDICTS:
        too_few = messages.TOO_FEW_VERDICTS(
            measure=verdicts.measure, visible=len(visible), invisible=len(invisible), fewest=MIN_VERDICTS
        )
        return ThresholdCalibration(verdicts, notices=(too_few,))
    places = verdicts.neighbourhoods
    is_one_place = places.fewest < MIN_NEIGHBOURHOODS
    if is_one_place:
        places = Neighbourhoods.of_single_windows(len(visible), len(invisible))
    area, fitted = (statistic(visible, invisible, places) for statistic in (roc_area, best_threshold))
    values = np.unique(np.concatenate([visible, invisible]))
    hits, vain = (np.searchsorted(np.sort(kind), values, side="right").tolist() for kind in (visible, invisible))
    steps = tuple(_step(*counts, len(visible), len(invisible)) for counts in zip(values.tolist(), hits, vain))
    name = verdicts.measure
    reach = (fitted.high - fitted.low) * _ROUNDING
    step = step_at(verdicts, min(_round_within(fitted.value, reach), most - _FINEST_STEP))
    best = step if fitted.value < most and step.youden > 0 else None
    # The range of thresholds that can be set, the given one among them.
    ends = (min(fitted.low, best.threshold), max(min(fitted.high, most), best.threshold)) if best else None
    notices = (
        (area.low <= 0.5, messages.NO_BETTER_THAN_CHANCE(measure=name, low=area.low, high=area.high)),
        (area.value == 1, messages.VERDICTS_FULLY_APART(measure=name)),
        (fitted.value < most and best is None, messages.NO_THRESHOLD(measure=name)),
        (fitted.value >= most, messages.THRESHOLD_TOO_HIGH(measure=name, threshold=fitted.value, most=most)),
        (is_one_place, messages.VERDICTS_IN_ONE_PLACE(measure=name)),
    )  # fmt: skip
    return ThresholdCalibration(
        verdicts, steps, area, best, ends,
        wanted=wanted_verdicts(area.value, len(visible), len(invisible)),
        neighbourhoods=places.count if verdicts.visible_places and not is_one_place else None,
        notices=tuple(notice for is_so, notice in notices if is_so),
    )  # fmt: skip


def step_at(verdicts: Verdicts, threshold: float) -> Step:
    """What a threshold does to judged windows, of which there is at least one of either kind."""
    if verdicts.is_loss:
        return replace(step_at(_negative(verdicts), -threshold), threshold=threshold)
    hits = sum(value <= threshold for value in verdicts.visible)
    vain = sum(value <= threshold for value in verdicts.invisible)
    return _step(threshold, hits, vain, len(verdicts.visible), len(verdicts.invisible))


def _negative(verdicts: Verdicts) -> Verdicts:
    """Verdicts of a measure of loss with its values negated, low where detail was lost."""
    visible, invisible = (tuple(-value for value in kind) for kind in (verdicts.visible, verdicts.invisible))
    return replace(verdicts, visible=visible, invisible=invisible, is_loss=False)


def _step(threshold: float, hits: int, vain: int, seen: int, unseen: int) -> Step:
    return Step(threshold, hits, vain, hits / seen, (unseen - vain) / unseen)


def _round_within(middle: float, reach: float) -> float:
    """The number with the fewest decimals that is no farther off."""
    return next((rounded for digits in range(12) if abs((rounded := round(middle, digits)) - middle) <= reach), middle)
