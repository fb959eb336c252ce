"""The rules by which a delivery is accepted or rejected: what they check, against which limits, from which source."""
from __future__ import annotations

from dataclasses import dataclass

KEPT, FAILED_SHARE, LONGEST_FAILURE = "kept", "failed_share", "longest_failure"
MEASURED_SHARE, SAMPLING = "measured_share", "sampling"
CHECKS = (KEPT, FAILED_SHARE, LONGEST_FAILURE, MEASURED_SHARE, SAMPLING)


@dataclass(frozen=True)
class SamplingRule:
    """Single sampling by attributes as ISO 2859-1 plans it."""

    aql: float
    """Acceptance quality limit: nonconforming pieces per hundred."""
    inspection_level: str
    """``S-1``..``S-4``, ``I``, ``II`` or ``III``."""
    severity: str
    """``normal``, ``tightened`` or ``reduced``."""
    source: str


@dataclass(frozen=True)
class AcceptanceRule:
    """One figure of the delivery and its limit."""

    check: str
    """One of ``CHECKS``, ``KEPT`` and ``SAMPLING`` apart."""
    least: float | None
    """Smallest value that passes; shares are fractions of 1, lengths metres. None for no such limit."""
    most: float | None
    """Largest value that passes."""
    source: str
    """Where the limit comes from."""


@dataclass(frozen=True)
class AcceptanceRules:
    """All rules of one contract."""

    name: str
    least_kept: float
    """A piece fails when its ``kept_1`` is smaller; one that keeps exactly as much passes."""
    kept_source: str
    """Where that limit comes from."""
    rules: tuple[AcceptanceRule, ...]
    sampling: SamplingRule | None = None
    """None: all pieces are inspected."""

    @property
    def is_sampled(self) -> bool:
        return self.sampling is not None
