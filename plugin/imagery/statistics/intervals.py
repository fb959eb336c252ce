"""Values with their confidence intervals."""
from __future__ import annotations

from dataclasses import dataclass

NORMAL_95 = 1.959964  # standard errors either side of a normal value that hold 95 %


@dataclass(frozen=True)
class Interval:
    """A value with its 95 % confidence interval."""

    value: float
    low: float
    high: float
