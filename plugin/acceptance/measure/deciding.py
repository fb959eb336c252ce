"""The decision on a delivery by its rules.

What decides are sums of whole pieces. A rule is kept or broken where nothing that is not known could turn it round:

- Shares of the measured metres stand for all of them where as much was measured as the rules ask for. With less a share
  is too large only where it would be so with all else sound, and kept where it would be with all else lost.
- Pieces count by what they kept, also those whose interval holds the limit, and failures by whole pieces, though they
  end inside of these. Where the limit of a sum lies within what that leaves open, it can't be told.
- A row of pieces that were not measured may be a failure: longer than one may be, it leaves that rule open. So does a
  piece that passed and is much longer than a failure may be: it can hold one and keep enough as a whole.
- Layers that are not as their scan left them, or lack seams that it had, can't be accepted, nor sheets that nobody has
  looked at; a scan of other files than those that are there or given decides nothing.
"""
from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import reduce
from typing import Optional

import numpy as np

from ...imagery.errors import Message, Stated
from ...imagery.file_identity import states_in
from ...imagery.seam_totals import MOSAIC_FILES, NEIGHBOURS, SOURCE_FILES, PieceState
from . import messages
from .acceptance_rules import (
    FAILED_SHARE,
    LONGEST_FAILURE,
    MEASURED_SHARE,
    AcceptanceRule,
    AcceptanceRules,
    limits_in_words,
)
from .decision import AcceptanceOutcome, DecidedPiece, Decision, FailureRun, MetreFigures, RuleOutcome
from .delivery import Delivery, Seal, SheetState
from .failure_runs import failure_runs, unknown_runs
from .inspection_plan import sampled_lot
from .measured_pieces import (
    MEASURED,
    ends_within,
    is_unclear,
    known_within,
    measured_with,
    metre_figures,
    sheet_figures,
    state_of,
    surely_failed_m,
)
from .seen_ground import SeenGround, ground_sentences, unseen_seams

_NAMED = 3  # layers that a sentence names
_SPARE = 0.05  # of the metres, by which forecasts of what will be measured may be too large


def decide(delivery: Delivery, rules: AcceptanceRules, lot_size: int | None = None, seed: int = 0) -> Decision:
    """Accept a delivery, reject it, or say what would decide it.

    ``lot_size``: pieces of the whole lot where a plan decides; None: those that are given. ``seed``: of the sample that
    is drawn then. Raises SettingsError for a lot size that can't be.
    """
    states = [state_of(piece, rules.least_kept) for piece in delivery.pieces]
    lot = None if rules.sampling is None else sampled_lot(delivery, states, rules.sampling, lot_size, seed)
    runs = failure_runs(delivery.pieces, states, delivery.unit_m)
    of_run = {number: run.number for run in runs for number in run.pieces}
    pieces = tuple(
        DecidedPiece(
            piece, state, state in MEASURED and is_unclear(piece, rules.least_kept), of_run.get(piece.number)
        )
        for piece, state in zip(delivery.pieces, states)
    )  # fmt: skip
    unknown = unknown_runs(delivery.pieces, states, delivery.unit_m)
    whole, sheets = metre_figures("", pieces, runs, unknown), sheet_figures(delivery, pieces, runs, unknown)
    longest = [pieces[number] for number in runs[0].pieces] if runs else []
    outcomes = _Ruling(whole, pieces, longest, rules).outcomes()
    sheet_outcomes: list[AcceptanceOutcome | None] = [None] * len(sheets)
    if lot is None and not delivery.is_part:
        sheet_outcomes = [*_sheet_outcomes(sheets, pieces, rules, delivery)]
    if delivery.is_part:
        outcomes = [_of_sample(outcome) for outcome in outcomes]
        whole, *sheets = (replace(figures, longest_failure_m=None) for figures in (whole, *sheets))
    longest_rule = None if delivery.is_part else rules.rule(LONGEST_FAILURE)
    unknown = () if longest_rule is None else tuple(run for run in unknown if not longest_rule.passes(run.length_m))
    if lot is not None:
        outcomes.insert(0, lot[1])
    outcome, sure = outcome_of(outcomes), [*_against_any(delivery)]
    lacking = [*_lacking(delivery, whole, rules), *_unseen(delivery, sheets if lot is None else (), rules)]
    unsealed = [*_unsealed(delivery)]
    if sure or ((lacking or unsealed) and outcome is AcceptanceOutcome.ACCEPTED):
        outcome = AcceptanceOutcome.UNDECIDED
    doubts = [*sure, *(() if outcome is AcceptanceOutcome.REJECTED else lacking)]
    why = _why(rules, outcomes, outcome, doubts, unsealed)
    advice = [advice for _, advice in doubts]
    advice += [*_advice_by_rules(whole, pieces, outcomes, delivery, rules), *(advice for _, advice in unsealed)]
    sentences = (
        _HEADLINES[outcome](rules=rules.name, why=why),
        *(advice[:1] if outcome is AcceptanceOutcome.UNDECIDED else ()),
        *_layers(delivery),
        *_figures(whole, runs, rules),
        *_unknown_rows(unknown),
        *_sample_sentences(delivery, lot is not None),
        *(() if lot is None else lot[2]),
    )
    return Decision(
        outcome, why, sentences, rules, delivery, tuple(outcomes), whole, tuple(sheets), tuple(sheet_outcomes), pieces,
        runs, unknown, None if lot is None else lot[0],
    )  # fmt: skip


_HEADLINES = {
    AcceptanceOutcome.ACCEPTED: messages.ACCEPTED, AcceptanceOutcome.REJECTED: messages.REJECTED,
    AcceptanceOutcome.UNDECIDED: messages.UNDECIDED,
}  # fmt: skip


Doubt = tuple[Message, Message]  # why a delivery can't be accepted as it is given, and what would decide it


def outcome_of(outcomes: Sequence[RuleOutcome]) -> AcceptanceOutcome:
    """A broken rule rejects, whatever else is unknown; one that can't be told leaves the decision open."""
    passed = [outcome.passed for outcome in outcomes]
    if False in passed:
        return AcceptanceOutcome.REJECTED
    return AcceptanceOutcome.UNDECIDED if None in passed else AcceptanceOutcome.ACCEPTED


def _against_any(delivery: Delivery) -> Iterator[Doubt]:
    """Why nothing is decided: what was measured is not, or not only, what is given."""
    files = delivery.files
    if files.not_scanned:
        yield messages.FILES_NOT_SCANNED(names=_first_names(files.not_scanned)), messages.WOULD_SCAN_AGAIN()
    if files.changed:
        count, names = len(files.changed), _first_names(files.changed)
        yield messages.FILES_CHANGED(count=count, names=names), messages.WOULD_SCAN_AGAIN()
    if others := files.layers_of_others:
        reason = messages.LAYERS_OF_OTHERS(count=len(others), names=_first_names(others))
        yield reason, messages.WOULD_GIVE_MOSAICS()
    if files.twice and not delivery.is_part:
        count, names = len(files.twice), _first_names(files.twice)
        yield messages.SCANNED_TWICE(count=count, names=names), messages.WOULD_LEAVE_OUT()


def _unsealed(delivery: Delivery) -> Iterator[Doubt]:
    names = {seal: [layer.name for layer in delivery.layers if layer.seal is seal] for seal in Seal}
    advice = messages.WOULD_GIVE_LAYER()
    if changed := names[Seal.BROKEN]:
        yield messages.LAYERS_WERE_CHANGED(count=len(changed), names=_first_names(changed)), advice
    if missing := names[Seal.MISSING]:
        yield messages.LAYERS_WITHOUT_SEAL(count=len(missing), names=_first_names(missing)), advice


def _lacking(delivery: Delivery, whole: MetreFigures, rules: AcceptanceRules) -> Iterator[Doubt]:
    """What is missing of the delivery, so that it can't be accepted."""
    if gone := delivery.files.gone:
        yield messages.FILES_GONE(count=len(gone), names=_first_names(gone)), messages.WOULD_SCAN_AGAIN()
    if delivery.lacking_m:
        yield messages.SEAMS_LACK(metres=delivery.lacking_m), messages.WOULD_GIVE_LAYER()
    for layer in delivery.layers:
        if names := layer.settings.get("may_be_copies"):
            yield messages.SOURCES_ARE_MOSAIC(names=names), messages.WOULD_GIVE_ORIGINALS()
    least, unseen = rules.limit(MEASURED_SHARE), sum(layer.unseen_m for layer in delivery.layers)
    if least is not None and unseen and (seen := whole.measured_m / (whole.judged_m + unseen)) < least:
        yield messages.SEAMS_UNSEEN(metres=unseen, value=seen, limit=least), messages.WOULD_GIVE_ORTHOIMAGES()
    for layer in delivery.layers:
        if least is not None and layer.unexplained > 1 - least:
            reason = messages.MOSAIC_LACKS(name=layer.name, share=layer.unexplained, limit=1 - least)
            yield reason, messages.WOULD_GIVE_ORTHOIMAGES()
    for reason in [*unseen_seams(delivery, whole, rules)][:1]:
        yield reason, messages.WOULD_GIVE_SEAMS()


def _unseen(delivery: Delivery, sheets: Sequence[MetreFigures], rules: AcceptanceRules) -> Iterator[Doubt]:
    """What of the delivery nobody has looked at, so that it can't be accepted; ``sheets``: that were to be measured."""
    for layer in delivery.layers:
        if layer.unread:
            place = layer.settings.get("unread_at", "")
            yield (messages.MOSAIC_PARTLY_READ(name=layer.name, share=layer.unread, place=place),
                   messages.WOULD_SEE_SHEETS())
    # One scan of many sheets may leave a corner of one: what may be lost without a break.
    most = (rules.limit(LONGEST_FAILURE) or 0.0) if delivery.outlines else 0.0
    blank = [layer.name for layer in delivery.layers if layer.is_blank]
    if not delivery.is_part and any(sheet.measured_m for sheet in sheets):
        blank += [sheet.name for sheet in sheets if sheet.judged_m > most and not sheet.measured_m]
    of_state = {state: [sheet.name for sheet in delivery.outlines if sheet.state is state] for state in SheetState}
    advice = messages.WOULD_SEE_SHEETS()
    if blank:
        yield messages.SHEETS_NOT_MEASURED(count=len(blank), names=_first_names(blank)), advice
    if names := of_state[SheetState.LEFT_OUT]:
        yield messages.SHEETS_LEFT_OUT(count=len(names), names=_first_names(names)), advice
    if names := of_state[SheetState.DAMAGED]:
        yield messages.SHEETS_DAMAGED(count=len(names), names=_first_names(names)), advice


def _sheet_outcomes(
    sheets: Sequence[MetreFigures], pieces: Sequence[DecidedPiece], rules: AcceptanceRules, delivery: Delivery
) -> Iterator[AcceptanceOutcome | None]:
    """Outcome of each sheet by its own metres; pieces over a border are looked at in the sheet of their middle.

    None is accepted on a layer that is not as its scan left it, none decided on where files are not those of the scan.
    """
    trusted = {layer.name for layer in delivery.layers if layer.seal in (Seal.WHOLE, Seal.NOT_ASKED)}
    all_trusted, strange = len(trusted) == len(delivery.layers), any(_against_any(delivery))
    of_sheet: dict[str, list[DecidedPiece]] = {}
    for decided in pieces:
        of_sheet.setdefault(decided.piece.sheet, []).append(decided)
    for sheet in sheets:
        sheet_pieces = of_sheet.get(sheet.name, [])
        outcome = outcome_of(_Ruling(sheet, sheet_pieces, sheet_pieces, rules).outcomes()) if sheet_pieces else None
        layers = {decided.piece.seam[0] for decided in sheet_pieces}
        is_doubtful = bool(delivery.files.gone) or not (all_trusted or layers <= trusted)
        if sheet_pieces and (strange or (is_doubtful and outcome is AcceptanceOutcome.ACCEPTED)):
            outcome = AcceptanceOutcome.UNDECIDED
        yield outcome


@dataclass(frozen=True, eq=False)
class _Ruling:
    """Figures that are held against the rules."""

    figures: MetreFigures
    pieces: Sequence[DecidedPiece]
    longest: Sequence[DecidedPiece]  # those of its longest failure, or all
    rules: AcceptanceRules

    def outcomes(self) -> list[RuleOutcome]:
        """Outcomes of the rules in their order, those of sampling apart."""
        return [self._outcome(rule) for rule in self.rules.rules]

    def _outcome(self, rule: AcceptanceRule) -> RuleOutcome:
        figures = self.figures
        if not figures.measured_m:
            value = figures.measured_share if rule.check == MEASURED_SHARE else None
            return RuleOutcome(
                rule.check, value, rule.limit, rule.is_least, None, rule.source, messages.NOTHING_WAS_MEASURED()
            )
        value, low, high = {
            MEASURED_SHARE: self._measured, FAILED_SHARE: self._failed, LONGEST_FAILURE: self._longest,
        }[rule.check]()
        passes = {rule.passes(low), rule.passes(high)}
        passed = passes.pop() if len(passes) == 1 else None
        if rule.check == MEASURED_SHARE:  # with less the delivery is neither good nor bad
            passed = passed or None
        sentence = _rule_sentence(rule, value, low, high, passed)
        if rule.check == LONGEST_FAILURE and passed is None and rule.passes(value):
            sentence = messages.RUN_UNKNOWN(value=value, limit=Stated(rule.limit), metres=high)
            if high == _hiding_m(self.pieces, rule):
                sentence = messages.RUN_IN_PIECE(value=value, limit=Stated(rule.limit), metres=high)
        return RuleOutcome(rule.check, value, rule.limit, rule.is_least, passed, rule.source, sentence, low, high)

    def _measured(self) -> tuple[float, float, float]:
        value = self.figures.measured_share
        return value, value, value

    def _failed(self) -> tuple[float, float, float]:
        """The share, and between what it may lie."""
        figures = self.figures
        ends = _open_ends(self.pieces, self.rules, figures)
        within = math.hypot(known_within(self.pieces, self.rules.least_kept), ends)
        least = self.rules.rule(MEASURED_SHARE)
        enough = least is None or least.passes(figures.measured_share)
        open_m, of_m = (0.0, figures.measured_m) if enough else (figures.not_measured_m, figures.judged_m)
        low, high = max(figures.failed_m - within, 0.0), min(figures.failed_m + within, figures.measured_m)
        return figures.failed_m / figures.measured_m, low / of_m, min((high + open_m) / of_m, 1.0)

    def _longest(self) -> tuple[float, float, float]:
        """What passed ends it, also where its interval holds the limit; what was not measured may be part of it."""
        longest, failures = self.figures.longest_failure_m or 0.0, dict[Optional[int], list[DecidedPiece]]()
        for decided in self.longest:
            if decided.state is PieceState.FAILED:
                failures.setdefault(decided.run, []).append(decided)
        sure = max((surely_failed_m(run, self.rules.least_kept) for run in failures.values()), default=0.0)
        return longest, min(sure, longest), max(
            longest, self.figures.longest_unknown_m, _hiding_m(self.pieces, self.rules.rule(LONGEST_FAILURE))
        )


def _hiding_m(pieces: Sequence[DecidedPiece], rule: AcceptanceRule | None) -> float:
    """Length of the longest piece that passed, where it can hide a failure longer than one may be, else 0; m."""
    longest = max((decided.piece.length_m for decided in pieces if decided.state is PieceState.PASSED), default=0.0)
    return longest if rule is not None and 0 < MOST_OF_RUN * rule.limit < longest else 0.0


def _open_ends(pieces: Sequence[DecidedPiece], rules: AcceptanceRules, figures: MetreFigures) -> float:
    """What the ends of failures leave open, where that is much of what may fail; m."""
    within = ends_within(pieces)
    return within if within > MOST_AT_ENDS * (rules.limit(FAILED_SHARE) or 0.0) * figures.measured_m else 0.0


def _rule_sentence(rule: AcceptanceRule, value: float, low: float, high: float, passed: bool | None) -> Message:
    """The outcome in words; ``passed``: None where it can't be told."""
    limit, shown = Stated(rule.limit), Stated(value, rule.limit) if passed is False else value
    if rule.check == MEASURED_SHARE:
        return messages.MEASURED(value=value, limit=limit)
    closed, open_ = {
        FAILED_SHARE: (
            messages.SHARE_FAILED(value=shown, limit=limit),
            messages.SHARE_OPEN(value=value, limit=limit, low=low, high=high),
        ),
        LONGEST_FAILURE: (
            messages.RUN_FAILED(value=shown, limit=limit),
            messages.RUN_OPEN(value=value, limit=limit, low=low, high=high),
        ),
    }[rule.check]
    return open_ if passed is None else closed


def _of_sample(outcome: RuleOutcome) -> RuleOutcome:
    """Pieces of a sample may show that a failure is too long, but not that none is: it may go on between them."""
    if outcome.check != LONGEST_FAILURE or outcome.passed is False:
        return outcome
    return replace(outcome, value=None, passed=None, sentence=messages.RUN_NOT_IN_SAMPLE())


def _why(
    rules: AcceptanceRules, outcomes: Sequence[RuleOutcome], outcome: AcceptanceOutcome, doubts: Sequence[Doubt],
    unsealed: Sequence[Doubt],
) -> Message:
    """All rules that were kept, those that were broken, or what is open; at the end which layers are unsealed."""
    wanted = {AcceptanceOutcome.ACCEPTED: True, AcceptanceOutcome.REJECTED: False}.get(outcome)
    reasons = [reason for reason, _ in doubts] + [rule.sentence for rule in outcomes if rule.passed is wanted]
    reasons += [reason for reason, _ in unsealed]
    if rules.is_of_file:
        reasons.append(messages.LIMITS_ARE(limits=limits_in_words(rules)))
    once = [reason for place, reason in enumerate(reasons) if reason not in reasons[:place]]
    return reduce(lambda first, also: messages.AND(why=first, also=also), once)


def _advice_by_rules(
    whole: MetreFigures, pieces: Sequence[DecidedPiece], outcomes: Sequence[RuleOutcome], delivery: Delivery,
    rules: AcceptanceRules,
) -> Iterator[Message]:
    """What would decide the rules that are open, what decides most of them first."""
    is_open = {outcome.check: outcome for outcome in outcomes if outcome.passed is None}
    if delivery.is_part and LONGEST_FAILURE in is_open:
        yield messages.WOULD_GIVE_SCAN()
    if not whole.judged_m:
        yield messages.WOULD_LOOK()
    if (lacking := whole.not_measured_m) and (MEASURED_SHARE in is_open or not whole.measured_m):
        wanted = max((rules.limit(MEASURED_SHARE) or 0.0) * whole.judged_m - whole.measured_m, 0.0)
        has_sources = any(states_in(layer.settings.get(SOURCE_FILES, "")) for layer in delivery.layers)
        yield _longer_pieces(whole, pieces, rules, wanted) if has_sources else (
            messages.WOULD_MEASURE_ALONE(wanted=wanted, lacking=lacking)
        )
    longest = is_open.get(LONGEST_FAILURE)
    if longest is not None and (longest.value or 0.0) <= longest.limit:
        if _hiding_m(pieces, rules.rule(LONGEST_FAILURE)):
            yield messages.WOULD_CUT(piece=Stated(longest.limit / 2))
        yield messages.WOULD_MEASURE_ROWS(limit=Stated(longest.limit))
    within = _open_ends(pieces, rules, whole)
    if FAILED_SHARE in is_open and within > known_within(pieces, rules.least_kept):
        piece = float(np.median([decided.piece.length_m for decided in pieces]))
        allowed = (rules.limit(FAILED_SHARE) or 0.0) * whole.measured_m
        yield messages.WOULD_SHORTEN(piece=piece, within=within, allowed=allowed)
    if (count := sum(decided.is_unclear for decided in pieces)) and is_open:
        yield messages.WOULD_TELL_APART(count=count, metres=whole.unclear_m)


def _longer_pieces(
    whole: MetreFigures, pieces: Sequence[DecidedPiece], rules: AcceptanceRules, wanted: float
) -> Message:
    """The shortest pieces that would measure as much as is wanted, where they are short enough for the rules."""
    longest = MOST_OF_RUN * (rules.limit(LONGEST_FAILURE) or math.inf)
    typical = float(np.median([decided.piece.length_m for decided in pieces]))
    lengths = [times * typical for times in (2, 4) if times * typical <= longest] or [typical]
    shares = {length: measured_with(pieces, rules.least_kept, length) for length in lengths}
    least = min((rules.limit(MEASURED_SHARE) or 0.0) + _SPARE, 1.0)
    enough = [length for length, share in shares.items() if share >= least]
    piece = min(enough, default=lengths[-1])
    lacking, share = whole.not_measured_m, shares[piece]
    return messages.WOULD_MEASURE(wanted=wanted, lacking=lacking, piece=piece, share=share) if enough else (
        messages.WOULD_LOOK_THERE(wanted=wanted, lacking=lacking, piece=piece, share=share)
    )


def _layers(delivery: Delivery) -> Iterator[Message]:
    """Whether layers are as their scan left them, what they are of, and whether they were measured alike."""
    layers = delivery.layers
    if layers and all(layer.seal is Seal.WHOLE for layer in layers):
        yield messages.LAYERS_SEALED(count=len(layers))
    yield from _files(delivery)
    if names := [layer.name for layer in layers if not SeenGround.of_settings(layer.settings).is_known]:
        yield messages.SEAMS_ELSEWHERE_UNKNOWN(names=_first_names(names))
    for layer in layers:
        yield from ground_sentences(layer.name, layer.settings)
    if names := [layer.name for layer in layers if layer.settings.get("seams") == "found"]:
        yield messages.SEAMS_FOUND(name=_first_names(names))
    if names := [layer.name for layer in layers if layer.settings.get("seams") == "given"]:
        yield messages.SEAMS_GIVEN(name=_first_names(names))
    for name in dict.fromkeys(name for layer in layers for name in layer.settings):
        values = list(dict.fromkeys(layer.settings[name] for layer in layers if name in layer.settings))
        if len(values) > 1 and name in COMPARED_SETTINGS:
            yield messages.SETTINGS_DIFFER(setting=name, values=_first_names(values))


def _files(delivery: Delivery) -> Iterator[Message]:
    files, settings = delivery.files, [layer.settings for layer in delivery.layers]
    if files.same:
        yield messages.FILES_AS_SCANNED(count=files.same)
    if files.mosaics > 1:
        yield messages.OF_MOSAICS(count=files.mosaics)
    alone = [scan for scan in settings if MOSAIC_FILES in scan and NEIGHBOURS not in scan]
    if (apart := len({scan[MOSAIC_FILES] for scan in alone})) > 1:
        yield messages.SCANNED_APART(count=apart)
    if files.gone_sources:
        yield messages.SOURCES_GONE(count=len(files.gone_sources), names=_first_names(files.gone_sources))
    if any(states_in(scan.get(SOURCE_FILES, "")) for scan in settings):
        yield messages.SOURCES_BELIEVED()


MOST_AT_ENDS = 0.2
"""Share of the metres that may fail, which the ends of failures inside of pieces may leave open: with more the pieces
are too coarse, as nothing above 1.25 times the allowed share is to be accepted nor below 0.8 times rejected."""
MOST_OF_RUN = 1.5
"""Times the longest failure that is allowed: how long a piece of a scan with such a PIECE may be. A longer one averages
a failure with what is sound beside it. Where no piece may fail its length does not matter."""
COMPARED_SETTINGS = ("wavelet", "levels", "density", "piece_m", "corridor_m", "seams", "version")
"""What makes figures of one layer differ from those of another."""


def _first_names(names: Sequence[str]) -> str:
    return ", ".join(names[:_NAMED]) + (" ..." if len(names) > _NAMED else "")


def _sample_sentences(delivery: Delivery, by_plan: bool) -> Iterator[Message]:
    """That the layers are a sample, and what that means for the decision."""
    if delivery.is_part:
        yield messages.SAMPLE_GIVEN(given=len(delivery.sampled_numbers or ()))
        if not by_plan:
            yield messages.SAMPLE_ONLY()


def _figures(whole: MetreFigures, runs: Sequence[FailureRun], rules: AcceptanceRules) -> Iterator[Message]:
    if whole.failed_share is not None:
        yield messages.METRES_FAILED(failed=whole.failed_m, measured=whole.measured_m, share=whole.failed_share)
    if runs and whole.longest_failure_m is not None:
        longest, (x, y) = runs[0], runs[0].place
        yield messages.LONGEST_WHERE(metres=longest.length_m, x=x, y=y, sheets=", ".join(longest.sheets))
    if whole.no_detail_m:
        yield messages.WITHOUT_DETAIL(metres=whole.no_detail_m, all=whole.total_m)
    if whole.not_measured_m:
        yield messages.NOT_MEASURED(metres=whole.not_measured_m, all=whole.judged_m)
    worst = (whole.failed_m + whole.not_measured_m) / whole.judged_m if whole.judged_m else 0.0
    share = rules.rule(FAILED_SHARE)
    if share is not None and share.passes(whole.failed_share or 0.0) and not share.passes(worst):
        yield messages.MAY_HIDE(worst=worst, limit=Stated(share.limit))
    if whole.unclear_m:
        yield messages.UNCLEAR(metres=whole.unclear_m, limit=Stated(rules.least_kept))


def _unknown_rows(rows: Sequence[FailureRun]) -> Iterator[Message]:
    """The first rows with the places where they lie, and how many more there are."""
    for run in rows[:_NAMED]:
        x, y = run.place
        yield messages.ROW_NOT_MEASURED(metres=run.length_m, x=x, y=y, sheets=", ".join(run.sheets))
    if len(rows) > _NAMED:
        yield messages.MORE_ROWS_NOT_MEASURED(count=len(rows) - _NAMED)
