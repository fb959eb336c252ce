"""What the layers can't tell where they are a sample: how far failures go on between its pieces."""
from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace

from ...imagery.errors import Message
from . import messages
from .acceptance_rules import LONGEST_FAILURE
from .decision import MetreFigures, RuleOutcome
from .delivery import Delivery


def of_sample(outcome: RuleOutcome) -> RuleOutcome:
    """Pieces of a sample may show that a failure is too long, but not that none is."""
    if outcome.check != LONGEST_FAILURE or outcome.passed is False:
        return outcome
    return replace(outcome, value=None, passed=None, sentence=messages.RUN_NOT_IN_SAMPLE())


def without_runs(figures: Iterable[MetreFigures]) -> tuple[MetreFigures, ...]:
    """Of a sample: no longest failure."""
    return tuple(replace(one, longest_failure_m=None) for one in figures)


def sample_sentences(delivery: Delivery, by_plan: bool) -> Iterator[Message]:
    """That the layers are a sample, and what that means for the decision."""
    if not delivery.is_part:
        return
    yield messages.SAMPLE_GIVEN(given=len(delivery.sampled_numbers or ()))
    if not by_plan:
        yield messages.SAMPLE_ONLY()
