"""Planning an inspection: how many pieces of a lot, and which."""
from __future__ import annotations

from collections.abc import Hashable, Sequence

import numpy as np

from ...imagery.errors import Message, SettingsError
from ...imagery.seam_totals import PieceState
from . import messages
from .acceptance_rules import SAMPLING, SamplingRule
from .decision import PlanOutcome, RuleOutcome
from .delivery import Delivery
from .sampling_plans import SamplingPlan, isolated_lot_plan, single_sampling_plan


def rule_plan(lot_size: int, rule: SamplingRule) -> SamplingPlan:
    """Plan of the standard that a rule names. Raises SettingsError for a lot of fewer than two items."""
    if rule.lq:
        return isolated_lot_plan(lot_size, rule.lq)
    return single_sampling_plan(lot_size, rule.aql, rule.inspection_level)


def plan_sentence(plan: SamplingPlan) -> Message:
    """How many pieces are inspected and may fail, by which standard."""
    if plan.is_whole_lot:
        words = messages.WITHOUT_SAMPLE(standard=plan.standard, lot=plan.lot_size)
    elif plan.lq is not None:
        words = messages.BY_LQ(standard=plan.standard, lot=plan.lot_size, lq=plan.lq)
    else:
        words = messages.BY_AQL(
            standard=plan.standard, lot=plan.lot_size, level=plan.inspection_level, aql=plan.aql,
            letter=plan.code_letter,
        )  # fmt: skip
    size, most = plan.sample_size, plan.acceptance_number
    return messages.PLANNED_BY_STANDARD(size=size, lot=plan.lot_size, acceptance=most, plan=words)


def sampled_lot(
    delivery: Delivery, states: Sequence[PieceState], rule: SamplingRule, lot_size: int | None, seed: int
) -> tuple[PlanOutcome, RuleOutcome, tuple[Message, ...]]:
    """Draw the sample, or take that which the layers are, and count; with what is told of it.

    Where the sample is drawn here, pieces that could not be measured are no part of what it is drawn from, as far as
    the rules let so much be left out. Of a sample that was drawn before they might be failures. On ground without
    detail there are no items.
    """
    given = delivery.sampled_numbers
    measured = [number for number, state in enumerate(states) if state in (PieceState.PASSED, PieceState.FAILED)]
    here = len(states if given is None else given)
    if lot_size is not None and lot_size < here:
        raise SettingsError(messages.LOT_SMALLER_THAN_GIVEN(size=lot_size, given=here))
    size = lot_size or delivery.lot_size or (len(measured) if given is None else here)
    plan = rule_plan(max(size, 1), rule)
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
    outcome = PlanOutcome(plan, used_seed, len(inspected), failed)
    ruled = _rule_outcome(outcome, rule, max(needed - len(inspected), 0))
    notice = messages.DRAWN(size=plan.sample_size, given=len(measured), seed=seed)
    return outcome, ruled, (plan_sentence(plan), *(() if used_seed is None else (notice,)))


def _rule_outcome(outcome: PlanOutcome, rule: SamplingRule, missing: int) -> RuleOutcome:
    """``missing``: pieces of the sample that were not measured, each of which might have failed."""
    plan, failed = outcome.plan, outcome.nonconforming
    most = plan.acceptance_number
    passed = False if failed > most else True if failed + missing <= most else None
    if passed is None:
        sentence = messages.PLAN_LACKS_PIECES(needed=plan.sample_size, given=outcome.inspected)
    else:
        sentence = messages.SAMPLE_FAILED(nonconforming=failed, inspected=outcome.inspected, limit=most)
    return RuleOutcome(SAMPLING, float(failed), float(most), False, passed, rule.source, sentence)


def stratified_sample(strata: Sequence[Hashable], count: int, seed: int) -> list[int]:
    """Places of ``count`` items, all of them where there are no more, in the order in which they were drawn.

    ``strata``: that of each item. The same items, count and seed give the same sample. Every so many-th item is taken
    from a random one on (systematic sampling), the items of a stratum and the strata in random order: each item is as
    likely to be drawn as any other, and a stratum gives its share, rounded down or up. The first part of a sample of
    one stratum is a sample, too.
    """
    random, count = np.random.default_rng(seed), min(count, len(strata))
    members: dict[Hashable, list[int]] = {}
    for place, stratum in enumerate(strata):
        members.setdefault(stratum, []).append(place)
    of_strata = list(members.values())
    items = [item for number in random.permutation(len(of_strata)) for item in random.permutation(of_strata[number])]
    places = (random.random() + np.arange(count)) * (len(items) / max(count, 1))
    drawn = [int(items[min(int(place), len(items) - 1)]) for place in places]
    return [drawn[place] for place in random.permutation(count)]
