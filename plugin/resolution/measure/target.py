"""The bar target: which group is how wide, and when it counts as resolved."""
from __future__ import annotations

from dataclasses import dataclass

from ...imagery.errors import SettingsError
from . import limits, messages

DIRECTIONS = ("along", "across")
"""To the flight: the direction in which a line crosses the bars."""


@dataclass(frozen=True)
class Target:
    """A calibration target and the criterion that its groups are judged by (Walczykowski et al. 2009, section 4)."""

    bars: int = limits.DEFAULT_BARS
    """Bars in each group."""
    reference_group: int = limits.DEFAULT_REFERENCE_GROUP
    """Number of the group whose width is known."""
    reference_grd_cm: float = limits.DEFAULT_REFERENCE_GRD_CM
    """Width of one bar and one gap of that group together, cm on the ground."""
    step: float = limits.DEFAULT_GROUP_STEP
    """How many times as wide the next coarser group is."""
    criterion: float = limits.DEFAULT_CRITERION
    """Share of the full amplitude that the bars of a resolved group keep."""
    reversed: bool = False
    """Whether higher numbers are coarser."""

    def check(self) -> None:
        """Raise SettingsError for a target that can't be."""
        if self.bars < limits.MIN_BARS:
            raise SettingsError(messages.TOO_FEW_BARS(bars=self.bars, least=limits.MIN_BARS))
        if not self.reference_grd_cm > 0:
            raise SettingsError(messages.GRD_NOT_POSITIVE(grd=self.reference_grd_cm))
        if not self.step > 1:
            raise SettingsError(messages.STEP_TOO_SMALL(step=self.step))
        if not 0 < self.criterion <= 1:
            raise SettingsError(messages.CRITERION_OUT_OF_RANGE(criterion=self.criterion))

    def grd_cm(self, group: int) -> float:
        """Ground resolved distance of a group: one bar and one gap together, cm."""
        finer = group - self.reference_group
        return self.reference_grd_cm * self.step ** (finer if self.reversed else -finer)
