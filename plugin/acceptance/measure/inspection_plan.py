"""Planning an inspection: how many pieces of a lot, and which."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from ...imagery.errors import Message
from ...imagery.lines import Seam, points_at, vertex_stations
from . import messages
from .decision import PieceState
from .delivery import DeliveredPiece
from .measured_pieces import piece_state
from .sampling.clustering import intraclass_correlation, typical_cluster_size
from .sampling.drawing import stratified_sample
from .sampling.iso2859 import single_sampling_plan
from .sampling.sample_size import RiskPlan, StatedRisk, plan_by_risk
from .sampling.sampling_plan import SamplingPlan

STANDARD_CORRELATION = 0.3  # where no scan says it: what software does to a seam it does along much of it


@dataclass(frozen=True)
class CountedPlan:
    """A plan, and how it came about."""

    plan: SamplingPlan
    correlation: float | None = None
    """How much alike pieces of one seam were taken to be; None where that plays no part."""
    by_risk: RiskPlan | None = None
    """With the risks that it keeps, where these were stated."""


def plan_of_standard(lot_size: int, aql: str, inspection_level: str, severity: str) -> CountedPlan:
    """By the tables of ISO 2859-1."""
    return CountedPlan(single_sampling_plan(lot_size, aql, inspection_level, severity))


def plan_of_risk(
    pieces: Sequence[DeliveredPiece], lot_size: int, risk: StatedRisk, correlation: float | None, least_kept: float
) -> CountedPlan:
    """By stated risks. ``correlation``: None to estimate it from what the pieces kept, where a scan measured them."""
    seams = [piece.seam for piece in pieces]
    if correlation is None:
        states = [piece_state(piece, least_kept) for piece in pieces]
        known = [
            (state is PieceState.FAILED, seam) for state, seam in zip(states, seams)
            if state is not PieceState.NOT_MEASURED
        ]  # fmt: skip
        correlation = intraclass_correlation(*zip(*known)) if known else None
        correlation = STANDARD_CORRELATION if correlation is None else correlation
    found = plan_by_risk(lot_size, risk, correlation, typical_cluster_size(seams))
    return CountedPlan(found.plan, correlation, found)


def drawn_sample(pieces: Sequence[DeliveredPiece], count: int, seed: int) -> list[DeliveredPiece]:
    """In the order of drawing; in proportion from every sheet."""
    return [pieces[place] for place in stratified_sample([piece.sheet for piece in pieces], count, seed)]


def cut_pieces(seams: Sequence[Seam], sheet: str, piece_m: float, unit_m: float) -> list[DeliveredPiece]:
    """Seams without a scan, cut evenly into pieces of about a length. ``unit_m``: metres in a unit of coordinates."""
    found: list[DeliveredPiece] = []
    for seam in seams:
        along = vertex_stations(seam.vertices) * unit_m
        count = max(1, round(along[-1] / piece_m))
        cuts = np.linspace(0, along[-1], count + 1)
        for start, stop in zip(cuts[:-1], cuts[1:]):
            between = along[(along > start) & (along < stop)]
            stations = np.concatenate([[start], between, [stop]])
            found.append(
                DeliveredPiece(
                    len(found), sheet, str(seam.seam_id), float(start), float(stop - start), None, None, None, None, "",
                    "", points_at(seam.vertices, along, stations),
                )
            )
    return found


def risk_sentences(found: RiskPlan, risk: StatedRisk, correlation: float) -> Iterator[Message]:
    """The plan with the risks that it keeps, and whether these are larger than what was stated."""
    plan = found.plan
    yield messages.PLANNED_BY_RISK(
        size=plan.sample_size, lot=plan.lot_size, acceptance=plan.acceptance_number, good=risk.good_share,
        producers=found.producers_risk, bad=risk.bad_share, consumers=found.consumers_risk,
    )
    if correlation > 0:
        yield messages.PLANNED_FOR_LIKENESS(correlation=correlation, effect=found.design_effect)
    if found.producers_risk > risk.producers_risk or found.consumers_risk > risk.consumers_risk:
        yield messages.RISKS_NOT_KEPT(
            lot=plan.lot_size, producers=risk.producers_risk, consumers=risk.consumers_risk
        )
