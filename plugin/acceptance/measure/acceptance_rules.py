"""The rules by which a delivery is accepted or rejected: what they check, against which limits, from which source.
"""
from __future__ import annotations

import math
from dataclasses import dataclass

from .limits import STANDARD_MEASURED_SHARE

KEPT, FAILED_SHARE, LONGEST_FAILURE = "kept", "failed_share", "longest_failure"
MEASURED_SHARE, SAMPLING = "measured_share", "sampling"
CHECKS = (KEPT, FAILED_SHARE, LONGEST_FAILURE, MEASURED_SHARE, SAMPLING)
OWN_LIMIT = "Seam Inspector's own"

KEY_OF_LIMIT = {KEPT: "least", MEASURED_SHARE: "least", FAILED_SHARE: "most", LONGEST_FAILURE: "most"}


@dataclass(frozen=True)
class SamplingRule:
    """Single sampling by attributes as ISO 2859-1 plans it."""

    aql: str
    """Acceptance quality limit as the standard writes it: nonconforming pieces per hundred."""
    inspection_level: str
    """``S-1``..``S-4``, ``I``, ``II`` or ``III``."""
    severity: str
    """``normal``, ``tightened`` or ``reduced``."""
    source: str
    """Where the plan comes from."""


@dataclass(frozen=True)
class AcceptanceRule:
    """One figure of the delivery and its limit."""

    check: str
    """``failed_share``, ``longest_failure`` or ``measured_share``."""
    limit: float
    """A fraction of 1, or metres; a value that is exactly it passes."""
    source: str
    """Where it comes from."""

    @property
    def is_least(self) -> bool:
        """Whether ``limit`` is the smallest value that passes, not the largest."""
        return KEY_OF_LIMIT[self.check] == "least"

    def passes(self, value: float) -> bool:
        """Whether a value is within the limit; the last digits of a sum decide nothing."""
        return (value >= self.limit if self.is_least else value <= self.limit) or math.isclose(value, self.limit)


@dataclass(frozen=True)
class AcceptanceRules:
    """All rules of one contract."""

    name: str
    """In words."""
    least_kept: float
    """A piece fails when its ``kept_1`` is smaller; one that keeps exactly as much passes."""
    kept_source: str
    """Where that limit comes from."""
    rules: tuple[AcceptanceRule, ...]
    """What decides beside the sampling."""
    sampling: SamplingRule | None = None
    """None: all pieces are inspected."""

    def limit(self, check: str) -> float | None:
        """Of a check; None where there is none."""
        return next((rule.limit for rule in self.rules if rule.check == check), None)


def standard_measured() -> AcceptanceRule:
    """What holds where nothing is said of how much has to be measured."""
    return AcceptanceRule(MEASURED_SHARE, STANDARD_MEASURED_SHARE, OWN_LIMIT)
