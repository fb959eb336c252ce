"""How people meet the figures of a decision: their names, and values as they are written."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from qgis.PyQt.QtCore import QT_TR_NOOP

from ...toolkit.translation import decimals_beside, filled, formatted, shown_number, tr
from ..measure import acceptance_rules as rules
from ..measure.decision import AcceptanceOutcome, Decision, MetreFigures, RuleOutcome


@dataclass(frozen=True)
class Check:
    """What a rule looks at, as the page and the quality record tell it."""

    title: str
    description: str
    scale: float  # what a figure is multiplied by
    decimals: int  # with how many it is shown at least
    unit: str
    figure: Callable[[MetreFigures], float | None]  # of a sheet, or of all; None where it has none


CHECKS = {
    rules.FAILED_SHARE: Check(
        QT_TR_NOOP("share of the seams that failed"),
        QT_TR_NOOP("Length of the pieces of seam that failed, divided by the measured length."),
        100, 2, "\u00a0%", lambda metres: metres.failed_share,
    ),
    rules.LONGEST_FAILURE: Check(
        QT_TR_NOOP("longest failure without a break"),
        QT_TR_NOOP("Length of the longest row of failed pieces that follow each other without a break, across sheets "
                   "too."),
        1, 1, "\u00a0m", lambda metres: metres.longest_failure_m if metres.piece_count else None,
    ),
    rules.KEPT: Check(
        QT_TR_NOOP("least detail kept"),
        QT_TR_NOOP("Share of the finest detail of the orthoimages that is left in the piece of seam that kept least."),
        100, 2, "\u00a0%", lambda metres: metres.least_kept,
    ),
    rules.SAMPLING: Check(
        QT_TR_NOOP("failed pieces in the sample"), QT_TR_NOOP("Pieces of seam in the sample that failed."), 1, 0, "",
        lambda _: None,
    ),
    rules.MEASURED_SHARE: Check(
        QT_TR_NOOP("share of the seams that was measured"),
        QT_TR_NOOP("Length of seam that could be measured, divided by the length of all seams on ground with detail."),
        100, 1, "\u00a0%", lambda metres: metres.measured_share if metres.piece_count else None,
    ),
}  # fmt: skip
"""What rules look at, in the order of the quality record."""
_OUTCOMES = {
    AcceptanceOutcome.ACCEPTED: QT_TR_NOOP("Accepted"),
    AcceptanceOutcome.REJECTED: QT_TR_NOOP("Rejected"),
    AcceptanceOutcome.UNDECIDED: QT_TR_NOOP("Undecided"),
}
QUALITY_STANDARDS = "ISO 19157:2013", "ISO/TS 19157-2:2016", "ISO 19115-3:2016"
NOTHING = "\u2013"  # where there is no value


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
    """How visible a loss is, rounded to the same side of what an eye just sees."""
    return "" if value is None else f"{_beside(value, 1.0, 1)}\u00a0JND"


def _beside(value: float, limit: float, decimals: int) -> str:
    return shown_number(value, decimals_beside(value, [limit], decimals))


def failing_sentence(decision: Decision) -> str:
    least = f"{formatted(100 * decision.rules.least_kept, '.6g')}\u00a0%"
    return filled(tr("A piece of seam fails where it keeps less than {least} of the detail."), least=least)


def outcome_value(outcome: RuleOutcome) -> str:
    """So precisely that it lies on the same side of its limit as the figure does."""
    if outcome.value is None or outcome.check == rules.SAMPLING:
        return NOTHING if outcome.value is None else f"{outcome.value:.0f}"
    check = CHECKS[outcome.check]
    return _beside(check.scale * outcome.value, check.scale * outcome.limit, check.decimals) + check.unit


def outcome_limit(outcome: RuleOutcome) -> str:
    check = CHECKS[outcome.check]
    limit = formatted(check.scale * outcome.limit, ".6g") + check.unit
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
    return {True: tr("passed"), False: tr("failed"), None: tr("open")}[outcome.passed]
