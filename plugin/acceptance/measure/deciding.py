"""The decision on a delivery by its rules."""
from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from ...imagery.errors import Exceeding, Message, SettingsError
from ...imagery.statistics import Interval
from . import messages
from .acceptance_rules import FAILED_SHARE, LONGEST_FAILURE, MEASURED_SHARE, AcceptanceRule, AcceptanceRules
from .decision import DecidedPiece, Decision, FailureRun, MetreFigures, Observers, PieceState, RuleOutcome
from .delivery import Delivery, SeenWindow
from .failure_runs import failure_runs
from .inspection_plan import sampled_lot
from .measured_pieces import (
    failed_share_interval,
    failed_shares,
    is_unclear,
    metre_figures,
    observers,
    of_sample,
    piece_state,
    sample_sentences,
    seen_state,
    sheet_figures,
    windows_over,
    without_runs,
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
    windows = _windows(delivery)
    states = [
        seen_state(over) if by_observer else piece_state(piece, rules.least_kept)
        for piece, over in zip(delivery.pieces, windows)
    ]
    unclear = [not by_observer and is_unclear(piece, rules.least_kept) for piece in delivery.pieces]
    runs = failure_runs(delivery.pieces, states, delivery.unit_m, None if by_observer else rules.least_kept)
    whole = metre_figures("", delivery, states, unclear, runs)
    outcomes = [_outcome(rule, _value(rule.check, whole)) for rule in rules.rules]
    sheets = list(sheet_figures(delivery, states, unclear, runs))
    if delivery.is_part:
        outcomes = [of_sample(outcome) for outcome in outcomes]
        whole, *sheets = without_runs((whole, *sheets))
    plan, sampled, told = None, set(range(len(states))), []
    if rules.sampling is not None:
        lot = sampled_lot(delivery, states, rules.sampling, lot_size, seed)
        plan, sampled, told = lot.outcome, lot.pieces, list(lot.notices)
        outcomes.insert(0, lot.rule_outcome)
    interval = _interval(delivery, states, runs)
    accepted = all(outcome.passed is True for outcome in outcomes)
    sentences = (
        _decision_sentence(rules, outcomes, accepted),
        *_figures(whole, interval, runs, rules),
        *sample_sentences(delivery, rules.sampling is not None),
        *told,
        *(_by_observer(delivery) if by_observer else ()),
        *_observers_sentences(seen),
    )
    pieces = _decided(delivery, states, unclear, runs, sampled, windows)
    return Decision(
        accepted, sentences, rules, delivery, tuple(outcomes), whole, tuple(sheets), interval, pieces, runs, plan,
        seen, by_observer,
    )  # fmt: skip


def _value(check: str, whole: MetreFigures) -> float | None:
    if check == MEASURED_SHARE:
        return whole.measured_share
    return whole.failed_share if check == FAILED_SHARE else whole.longest_failure_m


def _outcome(rule: AcceptanceRule, value: float | None) -> RuleOutcome:
    if value is None:
        sentence = messages.NOTHING_WAS_MEASURED()
        return RuleOutcome(rule.check, None, rule.limit, rule.is_least, None, rule.source, sentence)
    passed = rule.passes(value)
    sentence = _rule_sentence(rule, value, passed)
    return RuleOutcome(rule.check, value, rule.limit, rule.is_least, passed, rule.source, sentence)


def _rule_sentence(rule: AcceptanceRule, value: float, passed: bool) -> Message:
    limit, above = rule.limit, Exceeding(value, rule.limit)
    if rule.check == FAILED_SHARE:
        if passed:
            return messages.SHARE_KEPT(value=value, limit=limit)
        return messages.SHARE_EXCEEDED(value=above, limit=limit)
    if rule.check == LONGEST_FAILURE:
        if passed:
            return messages.RUN_KEPT(value=value, limit=limit)
        return messages.RUN_EXCEEDED(value=above, limit=limit)
    if passed:
        return messages.MEASURED_ENOUGH(value=value, limit=limit)
    return messages.MEASURED_TOO_LITTLE(value=value, limit=limit)


def _interval(delivery: Delivery, states: Sequence[PieceState], runs: Sequence[FailureRun]) -> Interval | None:
    measured = [
        (piece.length_m, share, piece.seam)
        for piece, state, share in zip(delivery.pieces, states, failed_shares(len(states), runs))
        if state is not PieceState.NOT_MEASURED
    ]
    return failed_share_interval(*zip(*measured)) if measured else None


def _decided(
    delivery: Delivery, states: Sequence[PieceState], unclear: Sequence[bool], runs: Sequence[FailureRun],
    sampled: set[int], windows: Sequence[tuple[SeenWindow, ...]],
) -> tuple[DecidedPiece, ...]:
    of_run = {number: run.number for run in runs for number in run.pieces}
    return tuple(
        DecidedPiece(piece, state, told, of_run.get(piece.number), piece.number in sampled, over)
        for piece, state, told, over in zip(delivery.pieces, states, unclear, windows)
    )


def _windows(delivery: Delivery) -> list[tuple[SeenWindow, ...]]:
    """Those over each piece."""
    extents = np.array([window.extent for window in delivery.windows]).reshape(-1, 4)
    return [windows_over(piece, delivery.windows, extents) for piece in delivery.pieces]


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
    if not longest.is_longest:
        yield messages.LONGEST_AT_LEAST()
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
