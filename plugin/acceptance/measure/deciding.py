"""The decision on a delivery by its rules."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from ...imagery.errors import Exceeding, Message, SettingsError
from ...imagery.statistics import Interval
from . import messages
from .acceptance_rules import FAILED_SHARE, LONGEST_FAILURE, MEASURED_SHARE, AcceptanceRule, AcceptanceRules
from .decision import DecidedPiece, Decision, FailureRun, MetreFigures, Observers, RuleOutcome
from .delivery import Delivery
from .failure_runs import failure_runs
from .inspection_plan import sampled_lot
from .measured_pieces import (
    failed_interval,
    is_unclear,
    metre_figures,
    observers,
    piece_state,
    seen_state,
    sheet_figures,
    windows_over,
)

_WIDE = 2  # pieces: what is seen in a window that spans more is hardly about the piece in its middle


def decide(
    delivery: Delivery, rules: AcceptanceRules, lot_size: int | None = None, seed: int = 0, by_observer: bool = False
) -> Decision:
    """Accept or reject a delivery.

    ``lot_size``: pieces of the whole lot where a plan decides; None: those that are given. ``seed``: of the sample that
    is drawn then. ``by_observer``: pieces fail by what operators saw in their windows, not by what they kept. Raises
    SettingsError for a lot size that can't be.
    """
    seen = observers(delivery.windows)
    if by_observer and seen is None:
        raise SettingsError(messages.NO_WINDOW_JUDGED(count=len(delivery.windows)))
    least_kept = None if by_observer else rules.least_kept
    windows = list(windows_over(delivery))
    states = [
        seen_state(over) if least_kept is None else piece_state(piece, least_kept)
        for piece, over in zip(delivery.pieces, windows)
    ]
    lot = None if rules.sampling is None else sampled_lot(delivery, states, rules.sampling, lot_size, seed)
    runs = failure_runs(delivery.pieces, states, delivery.unit_m, least_kept)
    of_run = {number: run.number for run in runs for number in run.pieces}
    pieces = tuple(
        DecidedPiece(
            piece, state, least_kept is not None and is_unclear(piece, least_kept), of_run.get(piece.number),
            lot is None or piece.number in lot.pieces, over,
        )
        for piece, state, over in zip(delivery.pieces, states, windows)
    )  # fmt: skip
    whole, sheets = metre_figures(pieces, runs), sheet_figures(delivery, pieces, runs)
    outcomes = [_outcome(rule, _value(rule.check, whole)) for rule in rules.rules]
    if delivery.is_part:
        outcomes = [_of_sample(outcome) for outcome in outcomes]
        whole, *sheets = (replace(one, longest_failure_m=None) for one in (whole, *sheets))
    if lot is not None:
        outcomes.insert(0, lot.rule_outcome)
    interval = failed_interval(pieces, runs)
    accepted = all(outcome.passed is True for outcome in outcomes)
    sentences = (
        _decision_sentence(rules, outcomes, accepted),
        *_figures(whole, interval, runs, rules),
        *_sample_sentences(delivery, lot is not None),
        *(() if lot is None else lot.notices),
        *(_by_observer(delivery) if by_observer else ()),
        *_observers_sentences(seen),
    )
    return Decision(
        accepted, sentences, rules, delivery, tuple(outcomes), whole, tuple(sheets), interval, pieces, runs,
        None if lot is None else lot.outcome, seen, by_observer,
    )  # fmt: skip


def _of_sample(outcome: RuleOutcome) -> RuleOutcome:
    """Pieces of a sample may show that a failure is too long, but not that none is: it may go on between them."""
    if outcome.check != LONGEST_FAILURE or outcome.passed is False:
        return outcome
    return replace(outcome, value=None, passed=None, sentence=messages.RUN_NOT_IN_SAMPLE())


def _sample_sentences(delivery: Delivery, by_plan: bool) -> Iterator[Message]:
    """That the layers are a sample, and what that means for the decision."""
    if delivery.is_part:
        yield messages.SAMPLE_GIVEN(given=len(delivery.sampled_numbers or ()))
        if not by_plan:
            yield messages.SAMPLE_ONLY()


def _value(check: str, whole: MetreFigures) -> float | None:
    if check == MEASURED_SHARE:
        return whole.measured_share
    return whole.failed_share if check == FAILED_SHARE else whole.longest_failure_m


def _outcome(rule: AcceptanceRule, value: float | None) -> RuleOutcome:
    passed = None if value is None else rule.passes(value)
    if value is None:
        sentence = messages.NOTHING_WAS_MEASURED()
    else:
        limit, beyond = rule.limit, value if rule.is_least else Exceeding(value, rule.limit)
        kept, broken = {
            FAILED_SHARE: (
                messages.SHARE_KEPT(value=value, limit=limit), messages.SHARE_EXCEEDED(value=beyond, limit=limit)
            ),
            LONGEST_FAILURE: (
                messages.RUN_KEPT(value=value, limit=limit), messages.RUN_EXCEEDED(value=beyond, limit=limit)
            ),
            MEASURED_SHARE: (
                messages.MEASURED_ENOUGH(value=value, limit=limit),
                messages.MEASURED_TOO_LITTLE(value=beyond, limit=limit),
            ),
        }[rule.check]
        sentence = kept if passed else broken
    return RuleOutcome(rule.check, value, rule.limit, rule.is_least, passed, rule.source, sentence)


def _decision_sentence(rules: AcceptanceRules, outcomes: Sequence[RuleOutcome], accepted: bool) -> Message:
    """The reasons are all rules that were kept, or those that were not."""
    reasons = [outcome.sentence for outcome in outcomes if accepted or outcome.passed is not True]
    why = reasons[0]
    for also in reasons[1:]:
        why = messages.AND(why=why, also=also)
    return messages.ACCEPTED(rules=rules.name, why=why) if accepted else messages.REJECTED(rules=rules.name, why=why)


def _figures(
    whole: MetreFigures, interval: Interval | None, runs: Sequence[FailureRun], rules: AcceptanceRules
) -> Iterator[Message]:
    if interval is not None:
        yield messages.SHARE_INTERVAL(
            failed=whole.failed_m, measured=whole.measured_m, share=interval.value, low=interval.low, high=interval.high
        )
    if runs and whole.longest_failure_m is not None:
        yield from _lengths(whole, runs, rules)
    if whole.not_measured_m:
        yield messages.NOT_MEASURED(metres=whole.not_measured_m, all=whole.total_m)
    if whole.unclear_m:
        yield messages.UNCLEAR(metres=whole.unclear_m, limit=rules.least_kept)
    if rules.least_kept <= 0:
        yield messages.NOTHING_IS_ASKED()


def _by_observer(delivery: Delivery) -> Iterator[Message]:
    yield messages.BY_OBSERVER()
    left, bottom, right, top = np.array([window.extent for window in delivery.windows]).T * delivery.unit_m
    side = float(np.median(np.minimum(right - left, top - bottom)))
    piece = float(np.median([piece.length_m for piece in delivery.pieces]))
    if side > _WIDE * piece:
        yield messages.WINDOWS_WIDER_THAN_PIECES(side=side, piece=piece)


def _lengths(whole: MetreFigures, runs: Sequence[FailureRun], rules: AcceptanceRules) -> Iterator[Message]:
    """Where the longest failure is, and how sure lengths are."""
    longest, (x, y) = runs[0], runs[0].place
    yield messages.LONGEST_WHERE(metres=longest.length_m, x=x, y=y, sheets=", ".join(longest.sheets))
    within = sum(run.within_m**2 for run in runs) ** 0.5
    if not within:
        return
    yield messages.ENDS_ESTIMATED(longest=longest.within_m, all=within)
    for rule in rules.rules:
        if rule.check == LONGEST_FAILURE and abs(longest.length_m - rule.limit) <= longest.within_m:
            yield messages.LONGEST_UNCLEAR(
                low=longest.length_m - longest.within_m, high=longest.length_m + longest.within_m, limit=rule.limit
            )
        if rule.check == FAILED_SHARE and abs(whole.failed_m - rule.limit * whole.measured_m) <= within:
            low, high = (max(whole.failed_m + side * within, 0.0) / whole.measured_m for side in (-1, 1))
            yield messages.SHARE_UNCLEAR(low=low, high=min(high, 1.0), limit=rule.limit)


def _observers_sentences(seen: Observers | None) -> Iterator[Message]:
    both, tool = (None, None) if seen is None else (seen.both, seen.with_tool)
    if both is not None and both.kappa is not None:
        yield messages.OBSERVERS_AGREE(
            count=both.count, agreed=both.agreed, kappa=both.kappa.value, low=both.kappa.low, high=both.kappa.high
        )
    elif both is not None:
        yield messages.OBSERVERS_WITHOUT_KAPPA(count=both.count, agreed=both.agreed)
    if tool is not None and tool.kappa is not None:
        yield messages.TOOL_AGREES(
            count=tool.count, agreed=tool.agreed, kappa=tool.kappa.value, low=tool.kappa.low, high=tool.kappa.high
        )
    elif tool is not None:
        yield messages.TOOL_WITHOUT_KAPPA(count=tool.count, agreed=tool.agreed)
