"""The decision on a delivery by its rules: what decides are sums of whole pieces (``ruling``), and nothing that is not
what was scanned, or that nobody has looked at, is accepted (``doubts``)."""
from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import reduce

from ...imagery.errors import Message
from ...imagery.file_identity import states_in
from ...imagery.seam_totals import SOURCE_FILES
from . import messages
from .acceptance_rules import FAILED_SHARE, LONGEST_FAILURE, MEASURED_SHARE, AcceptanceRules, limits_in_words
from .decision import AcceptanceOutcome, DecidedPiece, Decision, RuleOutcome
from .delivery import Delivery, Seal
from .doubts import Doubt, against_any, lacking, layer_sentences, unsealed
from .failure_runs import failure_runs, unknown_runs
from .inspection_plan import sampled_lot
from .measured_pieces import MEASURED, is_unclear, metre_figures, pieces_of_sheets, state_of
from .ruling import Ruling


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
            piece, state, state in MEASURED and is_unclear(piece, rules.least_kept), of_run.get(piece.number),
            delivery.files.cover.get(piece.number),
        )
        for piece, state in zip(delivery.pieces, states)
    )  # fmt: skip
    unknown = unknown_runs(delivery.pieces, states, delivery.unit_m)
    of_sheets = pieces_of_sheets(delivery, pieces)
    whole, *sheets = (metre_figures(name, some, runs, unknown) for name, some in [("", pieces), *of_sheets.items()])
    rulings = [
        Ruling(figures, some, [pieces[number] for run in runs if run.number in numbers for number in run.pieces], rules)
        for figures, some in zip((whole, *sheets), (pieces, *of_sheets.values()))
        for numbers in [{decided.run for decided in some}]
    ]
    ruling, *of_each = rulings
    outcomes = ruling.outcomes()
    if delivery.is_part:
        outcomes = [_of_sample(outcome) for outcome in outcomes]
        whole, *sheets = (replace(figures, longest_failure_m=None) for figures in (whole, *sheets))
    longest_rule = None if delivery.is_part else rules.rule(LONGEST_FAILURE)
    unknown = () if longest_rule is None else tuple(run for run in unknown if not longest_rule.passes(run.length_m))
    if lot is not None:
        outcomes.insert(0, lot[1])
    outcome, sure, changed = outcome_of(outcomes), [*against_any(delivery)], [*unsealed(delivery)]
    lacks = [] if sure else [*lacking(delivery, whole, sheets if lot is None else (), rules, outcome)]
    if sure:  # figures of something else keep no rule and break none, and are no failures
        outcomes, runs = [replace(rule, passed=None, low=None, high=None) for rule in outcomes], ()
    if sure or ((lacks or changed) and outcome is AcceptanceOutcome.ACCEPTED):
        outcome = AcceptanceOutcome.UNDECIDED
    sheet_outcomes: list[AcceptanceOutcome | None] = [None] * len(sheets)
    if lot is None and not delivery.is_part:
        sheet_outcomes = [*_sheet_outcomes(of_each, delivery)]
    doubts = sure or ([] if outcome is AcceptanceOutcome.REJECTED else lacks)
    reasons, always = _reasons(() if sure else outcomes, outcome, doubts), [reason for reason, _ in changed]
    if rules.is_of_file:
        always.append(messages.LIMITS_ARE(limits=limits_in_words(rules)))
    besides = reasons[1:] if outcome is AcceptanceOutcome.UNDECIDED else []
    foremost = _joined([*reasons[: len(reasons) - len(besides)], *always])
    has_sources = any(states_in(layer.settings.get(SOURCE_FILES, "")) for layer in delivery.layers)
    by_rules = ruling.advice(outcomes, delivery.is_part, has_sources)
    advice = [*(advice for _, advice in doubts), by_rules, *(advice for _, advice in changed)]
    first_advice = [*filter(None, advice), messages.WOULD_COMPLETE_SAMPLE][:1]
    sentences = (
        _HEADLINES[outcome](rules=rules.name, why=foremost),
        *(first_advice if outcome is AcceptanceOutcome.UNDECIDED else ()),
        *(messages.OPEN_BESIDES(why=reason) for reason in besides),
        *layer_sentences(delivery),
        *((messages.WITHOUT_DETAIL(metres=whole.no_detail_m, all=whole.total_m),) if whole.no_detail_m else ()),
        *((messages.NOT_MEASURED(metres=whole.not_measured_m, all=whole.judged_m),) if whole.not_measured_m else ()),
        *_looked_at(delivery),
        *(() if lot is None else lot[2]),
    )
    return Decision(
        outcome, _joined([*reasons, *always]), foremost, sentences, rules, delivery, tuple(outcomes), whole,
        tuple(sheets), tuple(sheet_outcomes), pieces, runs, unknown, None if lot is None else lot[0],
    )  # fmt: skip


_HEADLINES = {
    AcceptanceOutcome.ACCEPTED: messages.ACCEPTED, AcceptanceOutcome.REJECTED: messages.REJECTED,
    AcceptanceOutcome.UNDECIDED: messages.UNDECIDED,
}  # fmt: skip


def outcome_of(outcomes: Sequence[RuleOutcome]) -> AcceptanceOutcome:
    """A broken rule rejects, whatever else is unknown; one that can't be told leaves the decision open."""
    passed = [outcome.passed for outcome in outcomes]
    if False in passed:
        return AcceptanceOutcome.REJECTED
    return AcceptanceOutcome.UNDECIDED if None in passed else AcceptanceOutcome.ACCEPTED


def _sheet_outcomes(rulings: Sequence[Ruling], delivery: Delivery) -> Iterator[AcceptanceOutcome | None]:
    """Outcome of each sheet by its own metres and by all of the failures that reach into it; pieces over a border are
    looked at in the sheet of their middle.

    None is accepted on a layer that is not as its scan left it, none decided on where files are not those of the scan.
    """
    trusted = {layer.name for layer in delivery.layers if layer.seal in (Seal.WHOLE, Seal.NOT_ASKED)}
    all_trusted, strange = len(trusted) == len(delivery.layers), any(against_any(delivery))
    for ruling in rulings:
        outcome = outcome_of(ruling.outcomes()) if ruling.pieces else None
        layers = {decided.piece.seam[0] for decided in ruling.pieces}
        is_doubtful = bool(delivery.files.gone) or not (all_trusted or layers <= trusted)
        if ruling.pieces and (strange or (is_doubtful and outcome is AcceptanceOutcome.ACCEPTED)):
            outcome = AcceptanceOutcome.UNDECIDED
        yield outcome


def _of_sample(outcome: RuleOutcome) -> RuleOutcome:
    """Pieces of a sample may show that a failure is too long, but not that none is: it may go on between them."""
    if outcome.check != LONGEST_FAILURE or outcome.passed is False:
        return outcome
    return replace(outcome, value=None, passed=None, sentence=messages.RUN_NOT_IN_SAMPLE())


def _reasons(outcomes: Sequence[RuleOutcome], outcome: AcceptanceOutcome, doubts: Sequence[Doubt]) -> list[Message]:
    """All rules that were kept, those that were broken, or what is open."""
    wanted = {AcceptanceOutcome.ACCEPTED: True, AcceptanceOutcome.REJECTED: False}.get(outcome)
    given = [rule for rule in outcomes if rule.passed is wanted]
    if wanted is None:  # what would decide it is of the first
        given.sort(key=lambda rule: (rule.check != MEASURED_SHARE, rule.check == FAILED_SHARE))
    reasons = [reason for reason, _ in doubts] + [rule.sentence for rule in given]
    return [reason for place, reason in enumerate(reasons) if reason not in reasons[:place]]


def _joined(reasons: Sequence[Message]) -> Message:
    return reduce(lambda first, also: messages.AND(why=first, also=also), reasons)


def _looked_at(delivery: Delivery) -> Iterator[Message]:
    """That the layers are a sample, and what operators said of its windows."""
    if delivery.is_part:
        yield messages.SAMPLE_GIVEN(given=len(delivery.sampled_numbers or ()))
    if windows := delivery.windows:
        visible, invisible = (sum(window.observer == word for window in windows) for word in ("visible", "invisible"))
        causes = sum(bool(window.cause) for window in windows)
        yield messages.WINDOWS_GIVEN(count=len(windows), causes=causes, visible=visible, invisible=invisible)
