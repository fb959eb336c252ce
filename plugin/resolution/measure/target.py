"""The bar target: which group is how wide, and when it counts as resolved."""
from __future__ import annotations

import math
from dataclasses import dataclass

from ...imagery.errors import SettingsError
from . import limits, messages

DIRECTIONS = ("along", "across")
"""To the flight: the direction in which a line crosses the bars."""
GROUP, COARSEST = limits.FULL_AMPLITUDES
CYCLE, BAR = limits.DISTANCES


@dataclass(frozen=True)
class Target:
    """A calibration target and the criterion that its groups are judged by (Walczykowski et al. 2009, section 4)."""

    bars: int = limits.DEFAULT_BARS
    """Bars in each group."""
    reference_group: int = limits.DEFAULT_REFERENCE_GROUP
    """Number of the group whose width is known."""
    reference_grd_cm: float = limits.DEFAULT_REFERENCE_GRD_CM
    """Its distance, cm on the ground: of what ``grd_of`` says."""
    step: float = limits.DEFAULT_GROUP_STEP
    """How many times as wide the next coarser group is."""
    criterion: float = limits.DEFAULT_CRITERION
    """Share of the full amplitude that the bars of a resolved group keep."""
    reversed: bool = False
    """Whether higher numbers are coarser."""
    full_amplitude: str = GROUP
    """What the criterion is a share of: the bars of the ``group`` against plain gaps, or the ``coarsest`` one."""
    grd_of: str = CYCLE
    """What a distance is the width of: ``cycle``, a bar and a gap together; ``bar``, one of them."""

    def check(self) -> None:
        """Raise SettingsError for a target that can't be."""
        if self.bars < limits.MIN_BARS:
            raise SettingsError(messages.TOO_FEW_BARS(bars=self.bars, least=limits.MIN_BARS))
        if not 0 < self.reference_grd_cm < math.inf:
            raise SettingsError(messages.GRD_NOT_POSITIVE(grd=self.reference_grd_cm))
        if not 1 < self.step < math.inf:
            raise SettingsError(messages.STEP_TOO_SMALL(step=self.step))
        if not 0 < self.criterion <= 1:
            raise SettingsError(messages.CRITERION_OUT_OF_RANGE(criterion=self.criterion))
        if self.full_amplitude not in limits.FULL_AMPLITUDES:
            known = ", ".join(limits.FULL_AMPLITUDES)
            raise SettingsError(messages.FULL_AMPLITUDE_UNKNOWN(word=self.full_amplitude, known=known))
        if self.grd_of not in limits.DISTANCES:
            raise SettingsError(messages.GRD_OF_UNKNOWN(word=self.grd_of, known=", ".join(limits.DISTANCES)))

    def grd_cm(self, group: int) -> float:
        """Ground resolved distance of a group, cm: of a bar and a gap together, or of one bar (``grd_of``)."""
        finer = group - self.reference_group
        return self.reference_grd_cm * self.step ** (finer if self.reversed else -finer)

    def has_group(self, group: int) -> bool:
        """Whether a target can have bars of that number: so near the reference group that they have a width."""
        return abs(group - self.reference_group) * math.log(self.step) <= math.log(limits.MAX_GROUP_RATIO)

    def cycle_cm(self, group: int) -> float:
        """Width of a bar and a gap of a group together, cm."""
        return self.grd_cm(group) * (2 if self.grd_of == BAR else 1)
