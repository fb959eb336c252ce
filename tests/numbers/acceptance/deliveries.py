"""Deliveries made of straight seams, to decide on."""
from __future__ import annotations

import numpy as np
from seam_inspector.plugin.acceptance.measure.acceptance_rules import (
    FAILED_SHARE,
    LONGEST_FAILURE,
    MEASURED_SHARE,
    AcceptanceRule,
    AcceptanceRules,
    SamplingRule,
)
from seam_inspector.plugin.acceptance.measure.delivery import DeliveredPiece, Delivery

Kept = "Sequence[float | None]"


def seam(
    kept: Kept, length: float = 10.0, sheet: str = "a", seam_id: str = "1", start: tuple[float, float] = (0.0, 0.0),
    way: tuple[float, float] = (1.0, 0.0), number: int = 0,
) -> list[DeliveredPiece]:
    """Pieces one after the other along a straight line, numbered from ``number``."""
    begin, step = np.array(start, float), length * np.array(way, float)
    return [
        DeliveredPiece(
            number + place, sheet, seam_id, place * length, length, value,
            None if value is None else value - 0.05, None if value is None else value + 0.05, 0.0, "", "",
            np.array([begin + place * step, begin + (place + 1) * step]),
        )
        for place, value in enumerate(kept)
    ]


def delivery(*seams: list[DeliveredPiece]) -> Delivery:
    return Delivery(tuple(piece for pieces in seams for piece in pieces), "")


def rules(
    share: float | None = 0.02, run: float | None = 50.0, measured: float = 0.9, kept: float = 0.7,
    sampling: SamplingRule | None = None,
) -> AcceptanceRules:
    limits = {FAILED_SHARE: share, LONGEST_FAILURE: run, MEASURED_SHARE: measured}
    made = tuple(AcceptanceRule(check, limit, "contract") for check, limit in limits.items() if limit is not None)
    return AcceptanceRules("contract", kept, "contract", made, sampling)
