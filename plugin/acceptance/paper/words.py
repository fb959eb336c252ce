"""How people meet the figures of a decision: their names, and values as they are written."""
from __future__ import annotations

from qgis.PyQt.QtCore import QT_TR_NOOP

from ...toolkit.translation import decimals_beside, filled, formatted, shown_number, tr
from ..measure import acceptance_rules as rules
from ..measure.decision import AcceptanceOutcome, Decision, MetreFigures, RuleOutcome
from ..measure.sampling_plans import SamplingPlan

_CHECKS = {
    rules.KEPT: QT_TR_NOOP("least detail kept"),
    rules.FAILED_SHARE: QT_TR_NOOP("share of the seams that failed"),
    rules.LONGEST_FAILURE: QT_TR_NOOP("longest failure without a break"),
    rules.MEASURED_SHARE: QT_TR_NOOP("share of the seams that was measured"),
    rules.SAMPLING: QT_TR_NOOP("failed pieces in the sample"),
}
_OUTCOMES = {
    AcceptanceOutcome.ACCEPTED: QT_TR_NOOP("Accepted"),
    AcceptanceOutcome.REJECTED: QT_TR_NOOP("Rejected"),
    AcceptanceOutcome.UNDECIDED: QT_TR_NOOP("Undecided"),
}
_SHARE = 100, 2, "\u00a0%"
_UNITS = {
    rules.KEPT: _SHARE, rules.FAILED_SHARE: _SHARE, rules.MEASURED_SHARE: (100, 1, "\u00a0%"),
    rules.LONGEST_FAILURE: (1, 1, "\u00a0m"), rules.SAMPLING: (1, 0, ""),
}  # fmt: skip
"""What a figure is multiplied by, with how many decimals it is shown at least, and its unit."""
QUALITY_STANDARDS = "ISO 19157:2013", "ISO/TS 19157-2:2016", "ISO 19115-3:2016"
DIGEST_STANDARD = "FIPS 180-4 (SHA-256)"  # with their editions, on which the decision rests, its record and its digests
NOTHING = "\u2013"  # where there is no value


def check_word(check: str) -> str:
    """What a rule looks at."""
    return tr(_CHECKS[check])


def plan_words(plan: SamplingPlan) -> str:
    """The standard with its edition, and what the plan was looked up by."""
    if plan.lq is not None:
        return filled(tr("{standard}, single sampling of an isolated lot (procedure A), limiting quality {lq:g} %"),
            standard=plan.standard, lq=plan.lq)
    return filled(tr("{standard}, single sampling, level {level}, AQL {aql}"), standard=plan.standard,
        level=plan.inspection_level, aql=plan.aql)


def rounded(value: float | None) -> float | None:
    """To a thousandth: people read the layers, and more digits mean nothing."""
    return None if value is None else round(value, 3)


def metres(value: float | None) -> str:
    """A length with its unit, to a tenth as in the sentences beside it."""
    return NOTHING if value is None else f"{formatted(value, '.1f')}\u00a0m"


def share(value: float | None, decimals: int = 2) -> str:
    return NOTHING if value is None else f"{formatted(100 * value, f'.{decimals}f')}\u00a0%"


def share_beside(value: float | None, limit: float) -> str:
    """A fraction of 1 in per cent, whole where that is on the same side of its limit."""
    return NOTHING if value is None else f"{_beside(100 * value, 100 * limit, 0)}\u00a0%"


def jnd_words(value: float | None) -> str:
    """A visible loss, and whether an eye sees it, which is what rounding keeps."""
    if value is None:
        return ""
    shown = f"{_beside(value, 1.0, 1)}\u00a0JND"
    return shown if value >= 1 else filled(tr("{loss}, not visible"), loss=shown)


def _beside(value: float, limit: float, decimals: int) -> str:
    return shown_number(value, decimals_beside(value, [limit], decimals))


def failing_sentence(decision: Decision) -> str:
    if decision.by_observer:
        return tr("A piece of seam fails where the operator saw a loss in its window, whatever it kept.")
    least = f"{formatted(100 * decision.rules.least_kept, '.6g')}\u00a0%"
    return filled(tr("A piece of seam fails where it keeps less than {least} of the detail."), least=least)


def outcome_value(outcome: RuleOutcome) -> str:
    """So precisely that it lies on the same side of its limit as the figure does."""
    if outcome.value is None or outcome.check == rules.SAMPLING:
        return NOTHING if outcome.value is None else f"{outcome.value:.0f}"
    scale, decimals, unit = _UNITS[outcome.check]
    return _beside(scale * outcome.value, scale * outcome.limit, decimals) + unit


def outcome_limit(outcome: RuleOutcome) -> str:
    scale, _, unit = _UNITS[outcome.check]
    limit = formatted(scale * outcome.limit, ".6g") + unit
    return filled(tr("at least {least}"), least=limit) if outcome.is_least else filled(tr("at most {most}"), most=limit)


def outcome_title(outcome: AcceptanceOutcome) -> str:
    return tr(_OUTCOMES[outcome])


SHEET_COLOURS = {
    AcceptanceOutcome.ACCEPTED: "#009e73", AcceptanceOutcome.REJECTED: "#d55e00",
    AcceptanceOutcome.UNDECIDED: "#e69f00", None: "#8c959f",
}  # fmt: skip
"""Colours of sheets on the map; None for those without a verdict."""


def sheet_word(outcome: AcceptanceOutcome | None, figures: MetreFigures) -> str:
    """The verdict on a sheet; empty where none was taken."""
    if not figures.piece_count:
        return tr("No seams")
    return "" if outcome is None else outcome_title(outcome)


def outcome_word(outcome: RuleOutcome) -> str:
    open_ = tr("too little") if outcome.check == rules.MEASURED_SHARE else tr("can't be told")
    return {True: tr("passed"), False: tr("failed"), None: open_}[outcome.passed]
