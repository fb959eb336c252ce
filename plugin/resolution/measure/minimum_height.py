"""The lowest flying height at which a sensor keeps to a ground resolved distance (Walczykowski et al. 2009)."""
from __future__ import annotations

import statistics
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from ...imagery.errors import SettingsError
from ...imagery.message import Message
from . import messages

MIN_OBSERVATIONS = 5  # of the minimum height: the Open Skies treaty asks for five passes

Key = tuple[str, ...]


@dataclass(frozen=True)
class Observation:
    """What one pass over the target gave."""

    height_m: float
    """Flying height above the target, m."""
    grd_cm: float
    """Ground resolved distance that was read, cm."""
    key: Key = ()
    """What it is grouped by: sensor, type of image, direction."""

    @property
    def fault(self) -> Message | None:
        """Why it can't be used; None when it can."""
        if not self.height_m > 0 or not self.grd_cm > 0:
            return messages.OBSERVATION_NOT_POSITIVE(height=self.height_m, grd=self.grd_cm)
        return None

    def minimum_height(self, required_cm: float) -> float:
        """Height at which the distance would be the required one, m: both grow alike (equation 1)."""
        return self.height_m * required_cm / self.grd_cm


@dataclass(frozen=True)
class HeightResult:
    """The minimum height from the passes of one group."""

    key: Key
    heights_m: tuple[float, ...]
    """Minimum height by each pass, m."""
    reference_m: float | None
    """What it is compared with, m."""
    notice: Message | None
    """What to know about it."""

    @property
    def mean_m(self) -> float:
        """Mean of the passes, m (equation 2)."""
        return statistics.fmean(self.heights_m)

    @property
    def spread_m(self) -> float | None:
        """Standard deviation of one pass, m; None for a single one."""
        return statistics.stdev(self.heights_m) if len(self.heights_m) > 1 else None

    @property
    def tolerance_percent(self) -> float | None:
        """How far the mean lies above the reference, %; None without one."""
        return None if self.reference_m is None else 100 * (self.mean_m - self.reference_m) / self.reference_m


def check_heights(required_cm: float, reference_m: float | None) -> None:
    """Raise SettingsError for numbers that are not positive."""
    if not required_cm > 0:
        raise SettingsError(messages.GRD_NOT_POSITIVE(grd=required_cm))
    if reference_m is not None and not reference_m > 0:
        raise SettingsError(messages.REFERENCE_HEIGHT_NOT_POSITIVE(height=reference_m))


def minimum_heights(
    observations: Iterable[Observation], required_cm: float, reference_m: float | None = None
) -> list[HeightResult]:
    """The minimum height of every group of passes, in the order in which the groups first come.

    Raises SettingsError for a required distance or a reference that is not positive.
    """
    check_heights(required_cm, reference_m)
    groups: dict[Key, list[float]] = {}
    for one in observations:
        groups.setdefault(one.key, []).append(one.minimum_height(required_cm))
    return [_result(key, heights, reference_m) for key, heights in groups.items()]


def _result(key: Key, heights: Sequence[float], reference_m: float | None) -> HeightResult:
    notice = None
    if len(heights) < MIN_OBSERVATIONS:
        notice = messages.FEW_OBSERVATIONS(count=len(heights), least=MIN_OBSERVATIONS)
    return HeightResult(key, tuple(heights), reference_m, notice)
