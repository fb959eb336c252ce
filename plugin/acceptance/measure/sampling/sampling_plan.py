"""A plan of sampling, and what it risks."""
from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SamplingPlan:
    """How many items of a lot are inspected, and how many of these may be nonconforming."""

    lot_size: int
    """Items: pieces of seam."""
    sample_size: int
    acceptance_number: int
    """Ac: the lot is accepted up to so many nonconforming items in the sample."""
    rejection_number: int
    """Re: it is rejected from so many on."""
    aql: float
    """Acceptance quality limit: nonconforming items per hundred."""
    inspection_level: str
    severity: str
    code_letter: str
    """Of the table's row that the plan was taken from, arrows followed."""
    lot_letter: str
    """Of the lot size and the inspection level, before any arrow."""

    @property
    def is_whole_lot(self) -> bool:
        """Whether every item is inspected, since the sample would be as large as the lot."""
        return self.sample_size >= self.lot_size


@dataclass(frozen=True)
class OperatingCharacteristic:
    """How likely a lot is accepted by how good it is."""

    nonconforming_shares: tuple[float, ...]
    """Fractions of 1, rising."""
    accepted: tuple[float, ...]
    """The probability of acceptance at each."""
    producers_risk: float
    """Probability that a lot as good as the AQL is rejected."""
    limiting_quality: float
    """The smallest share of nonconforming items at which a lot is accepted with 10 % at most (LQ, LTPD)."""
    consumers_risk: float
    """With which it is then: 10 %, or what whole items of a lot leave below."""
    distribution: str
    """``hypergeometric`` for a lot of known size, ``binomial`` for a series of lots."""
