"""The decision by a plan of sampling: which pieces it looks at, and what they say."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from ...imagery.errors import Message, SettingsError
from . import messages
from .acceptance_rules import SAMPLING, SamplingRule
from .decision import PieceState, PlanOutcome, RuleOutcome
from .delivery import Delivery
from .sampling.characteristic import allowed_at_aql, operating_characteristic
from .sampling.drawing import stratified_sample
from .sampling.iso2859 import single_sampling_plan
from .sampling.sampling_plan import SamplingPlan


@dataclass(frozen=True)
class SampledLot:
    """What a plan looks at and decides."""

    outcome: PlanOutcome
    rule_outcome: RuleOutcome
    pieces: set[int]
    """Numbers of the pieces of the sample."""
    notices: tuple[Message, ...]


def sampled_lot(
    delivery: Delivery, states: Sequence[PieceState], rule: SamplingRule, lot_size: int | None, seed: int
) -> SampledLot:
    """Draw the sample, or take that which the layers are, and count.

    Where the sample is drawn here, pieces that could not be measured are no part of what it is drawn from, as far as
    the rules let so much be left out. Of a sample that was drawn before they might be failures.
    """
    given = delivery.sampled_numbers
    measured = [number for number, state in enumerate(states) if state is not PieceState.NOT_MEASURED]
    here = len(states if given is None else given)
    if lot_size is not None and lot_size < here:
        raise SettingsError(messages.LOT_SMALLER_THAN_GIVEN(size=lot_size, given=here))
    size = lot_size or delivery.lot_size or (len(measured) if given is None else here)
    plan = single_sampling_plan(max(size, 1), rule.aql, rule.inspection_level, rule.severity)
    used_seed: int | None = None
    if given is not None:
        sample = list(given[: plan.sample_size])
    elif len(measured) <= plan.sample_size:
        sample = measured
    else:
        drawn = stratified_sample([delivery.pieces[number].sheet for number in measured], plan.sample_size, seed)
        sample, used_seed = [measured[place] for place in drawn], seed
    inspected = [number for number in sample if states[number] is not PieceState.NOT_MEASURED]
    failed = sum(states[number] is PieceState.FAILED for number in inspected)
    needed = min(plan.sample_size, len(measured)) if plan.is_whole_lot and given is None else plan.sample_size
    outcome = PlanOutcome(plan, operating_characteristic(plan), used_seed, len(inspected), failed)
    ruled = _rule_outcome(outcome, rule, max(needed - len(inspected), 0))
    told = list(_notices(plan, used_seed, len(measured), given))
    if ruled.passed and failed > plan.acceptance_number:
        told.append(messages.PLAN_BETWEEN(acceptance=plan.acceptance_number, rejection=plan.rejection_number))
    return SampledLot(outcome, ruled, set(sample), tuple(told))


def _rule_outcome(outcome: PlanOutcome, rule: SamplingRule, missing: int) -> RuleOutcome:
    """``missing``: pieces of the sample that were not measured, each of which might have failed."""
    plan, failed = outcome.plan, outcome.nonconforming
    most = plan.rejection_number - 1
    passed = False if failed > most else True if failed + missing <= most else None
    curve = outcome.characteristic
    if passed:
        sentence = messages.PLAN_KEPT(
            nonconforming=failed, inspected=outcome.inspected, limit=most, lot=plan.lot_size, aql=plan.aql,
            letter=plan.code_letter, allowed=allowed_at_aql(plan), producers=curve.producers_risk,
            bad=round(curve.limiting_quality * plan.lot_size), limiting=curve.limiting_quality,
            consumers=curve.consumers_risk,
        )  # fmt: skip
    elif passed is None:
        sentence = messages.PLAN_LACKS_PIECES(needed=plan.sample_size, given=outcome.inspected)
    else:
        sentence = messages.PLAN_EXCEEDED(
            nonconforming=failed, inspected=outcome.inspected, limit=most, lot=plan.lot_size, aql=plan.aql,
            letter=plan.code_letter, allowed=allowed_at_aql(plan), producers=curve.producers_risk,
        )  # fmt: skip
    return RuleOutcome(SAMPLING, float(failed), float(most), False, passed, rule.source, sentence)


def _notices(
    plan: SamplingPlan, seed: int | None, measured: int, given: Sequence[int] | None
) -> Iterator[Message]:
    if seed is not None:
        yield messages.DRAWN(size=plan.sample_size, given=measured, seed=seed)
    if given is None and plan.is_whole_lot:
        yield messages.WHOLE_LOT(lot=plan.lot_size)
