"""The rules by which a delivery is accepted or rejected: what they check, against which limits, from which source."""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce
from pathlib import Path

from ...imagery.documents import RuleObject, read_rules
from ...imagery.errors import QT_TR_NOOP, Message, SettingsError, Stated
from ...imagery.limits import PATH_TYPES, check_type
from ...imagery.seam_totals import STANDARD_LEAST_KEPT
from . import messages
from .sampling_plans import AQLS, DEFAULT_LEVEL, INSPECTION_LEVELS, LIMITING_QUALITIES, word_of

STANDARD_KEPT = STANDARD_LEAST_KEPT  # of the finest detail's variance: where a piece is called significant
STANDARD_FAILED_SHARE = 0.02  # Beeldmateriaal Nederland: 2 % may deviate if it is not contiguous
STANDARD_LONGEST_M = 50.0  # what 'not contiguous' is taken to mean: half a standard window of 100 m (Pyka 2010)
STANDARD_MEASURED_SHARE = 0.9  # of the metres: with less the rest could turn any share of 2 % round five times over
STANDARD_AQL = "1.0"
STANDARD_SEED = 2859  # the same delivery gives the same sample

KEPT, FAILED_SHARE, LONGEST_FAILURE = "kept", "failed_share", "longest_failure"
MEASURED_SHARE, SAMPLING = "measured_share", "sampling"
CHECKS = (KEPT, FAILED_SHARE, LONGEST_FAILURE, MEASURED_SHARE, SAMPLING)
OWN_LIMIT = QT_TR_NOOP("Seam Inspector's own")

KEY_OF_LIMIT = {KEPT: "least", MEASURED_SHARE: "least", FAILED_SHARE: "most", LONGEST_FAILURE: "most"}
_OF_SHARE = (KEPT, MEASURED_SHARE, FAILED_SHARE)


@dataclass(frozen=True)
class SamplingRule:
    """Single sampling by attributes as ISO 2859-1 plans it in normal inspection, or ISO 2859-2 for an isolated lot."""

    aql: str  # acceptance quality limit: nonconforming pieces per hundred; empty for an isolated lot
    inspection_level: str  # S-1..S-4, I, II or III
    source: str  # where the plan comes from
    lq: str = ""  # limiting quality of an isolated lot as the standard writes it: nonconforming pieces per hundred


@dataclass(frozen=True)
class AcceptanceRule:
    """One figure of the delivery and its limit."""

    check: str  # failed_share, longest_failure or measured_share
    limit: float  # a fraction of 1, or metres; a value that is exactly it passes
    source: str  # where it comes from

    @property
    def is_least(self) -> bool:
        """Whether ``limit`` is the smallest value that passes, not the largest."""
        return KEY_OF_LIMIT[self.check] == "least"

    def passes(self, value: float) -> bool:
        """Whether a value is within the limit; the last digits of a sum decide nothing."""
        return (value >= self.limit if self.is_least else value <= self.limit) or math.isclose(value, self.limit)


@dataclass(frozen=True)
class AcceptanceRules:
    """All rules of one contract."""

    name: str
    """In words."""
    least_kept: float
    """A piece fails when its ``kept_1`` is smaller; one that keeps exactly as much passes."""
    kept_source: str
    """The origin of that limit."""
    rules: tuple[AcceptanceRule, ...]
    """What decides beside the sampling."""
    sampling: SamplingRule | None = None
    """None: all pieces are inspected."""
    is_of_file: bool = False
    """A file's name may be any: it says nothing of the limits."""

    def __post_init__(self) -> None:
        """Raise SettingsError for rules that every piece would keep."""
        if self.least_kept <= 0:
            raise SettingsError(messages.KEPT_NOTHING())

    def limit(self, check: str) -> float | None:
        """Limit of a check; None where there is none."""
        rule = self.rule(check)
        return None if rule is None else rule.limit

    @property
    def unlimited(self) -> list[str]:
        """Checks without a limit, where no sample decides instead."""
        checks = (FAILED_SHARE, LONGEST_FAILURE, MEASURED_SHARE)
        return [check for check in checks if self.sampling is None and self.rule(check) is None]

    def rule(self, check: str) -> AcceptanceRule | None:
        """Rule of a check; None where there is none."""
        return next((rule for rule in self.rules if rule.check == check), None)


def limits_in_words(rules: AcceptanceRules) -> Message:
    """The limits that there are, and those that there are not."""
    parts = [messages.LIMIT_OF_KEPT(limit=Stated(rules.least_kept))]
    for check, words, without in (
        (FAILED_SHARE, messages.LIMIT_OF_SHARE, messages.NO_LIMIT_OF_SHARE),
        (LONGEST_FAILURE, messages.LIMIT_OF_RUN, messages.NO_LIMIT_OF_RUN),
        (MEASURED_SHARE, messages.LIMIT_OF_MEASURED, messages.NO_LIMIT_OF_MEASURED),
    ):  # fmt: skip
        if (limit := rules.limit(check)) is not None:
            parts.append(words(limit=Stated(limit)))
        elif check in rules.unlimited:
            parts.append(without())
    if (sampling := rules.sampling) is not None:
        parts.append(messages.SAMPLED_BY_LQ(lq=float(sampling.lq)) if sampling.lq else (
            messages.SAMPLED_BY_AQL(level=sampling.inspection_level, aql=float(sampling.aql))))
    return reduce(lambda first, also: messages.WITH(first=first, also=also), parts)


def limit_rules(
    min_kept: float = STANDARD_KEPT,
    max_share: float = STANDARD_FAILED_SHARE,
    max_run_m: float = STANDARD_LONGEST_M,
    min_measured: float = STANDARD_MEASURED_SHARE,
) -> AcceptanceRules:
    """The rules that four limits make.

    ``min_kept``: kept_1 below which a piece of seam fails, 0 to 1. ``max_share``: of the measured metres that may fail,
    0 to 1. ``max_run_m``: metres that may fail without a break. ``min_measured``: share of the metres that has to be
    measured, 0 to 1. Raises SettingsError for a limit that can't be.
    """
    shares = {"min_kept": min_kept, "max_share": max_share, "min_measured": min_measured}
    for name, value in {**shares, "max_run_m": max_run_m}.items():
        most = 1.0 if name in shares else math.inf
        check_type(name, value, float)
        if not 0 <= value <= most:
            raise SettingsError(messages.LIMIT_NO_SHARE(parameter=name, value=value, least=0, most=most))

    def source(value: float, standard: float) -> str:
        return OWN_LIMIT if value == standard else "stated for this decision"

    ruled = tuple(AcceptanceRule(check, limit, source(limit, standard)) for check, limit, standard in (
        (FAILED_SHARE, max_share, STANDARD_FAILED_SHARE), (LONGEST_FAILURE, max_run_m, STANDARD_LONGEST_M),
        (MEASURED_SHARE, min_measured, STANDARD_MEASURED_SHARE),
    ))  # fmt: skip
    rules = AcceptanceRules("", min_kept, source(min_kept, STANDARD_KEPT), ruled)
    return replace(rules, name=str(limits_in_words(rules)))


def load_acceptance_rules(path: Path | str) -> AcceptanceRules:
    """The rules of a JSON file. Raises SettingsError that says what is wrong with it and where."""
    check_type("path", path, *PATH_TYPES)
    return read_rules(Path(path), rules_of_objects)


def rules_of_objects(whole: RuleObject, objects: Sequence[RuleObject]) -> AcceptanceRules:
    whole.allow(("name", "rules"))
    by_check: dict[str, RuleObject] = {}
    for rule in objects:
        check = rule.word("check", CHECKS)
        if check in by_check:
            raise SettingsError(messages.TWO_RULES_FOR_CHECK(place=rule.place, name=rule.file, check=check))
        by_check[check] = rule
    if KEPT not in by_check:
        raise SettingsError(messages.RULES_WITHOUT_KEPT(name=whole.file))
    if not by_check.keys() & {FAILED_SHARE, LONGEST_FAILURE, SAMPLING}:
        raise SettingsError(messages.RULES_DECIDE_NOTHING(name=whole.file))
    limits = {check: _limit(rule, check) for check, rule in by_check.items() if check != SAMPLING}
    rules = [AcceptanceRule(check, limits[check], by_check[check].source()) for check in limits if check != KEPT]
    if MEASURED_SHARE not in limits:
        rules.append(AcceptanceRule(MEASURED_SHARE, STANDARD_MEASURED_SHARE, whole.worded(OWN_LIMIT)))
    sampling = _sampling(by_check[SAMPLING]) if SAMPLING in by_check else None
    kept = limits[KEPT], by_check[KEPT].source()
    return AcceptanceRules(whole.name(), *kept, tuple(rules), sampling, is_of_file=True)


def _limit(rule: RuleObject, check: str) -> float:
    key = KEY_OF_LIMIT[check]
    rule.allow(("check", key, "source"))
    limit = rule.number(key)
    if limit is None:
        raise SettingsError(messages.RULES_LIMIT_MISSING(place=rule.place, name=rule.file, key=key, check=check))
    if check in _OF_SHARE and limit > 1:
        raise SettingsError(messages.RULES_NO_SHARE(place=rule.place, name=rule.file, key=key, limit=limit))
    return limit


def _sampling(rule: RuleObject) -> SamplingRule:
    is_isolated = "lq" in rule.content
    rule.allow(("check", "lq", "source") if is_isolated else ("check", "aql", "level", "source"))
    key, known = ("lq", LIMITING_QUALITIES) if is_isolated else ("aql", AQLS)
    word = word_of(rule.content.get(key), known)
    if word is None:
        given = rule.content.get(key)
        raise SettingsError(messages.RULES_QUALITY_UNKNOWN(
            place=rule.place, name=rule.file, key=key.upper(), value=given, known=", ".join(known)
        ))  # fmt: skip
    if is_isolated:
        return SamplingRule("", "", rule.source(), word)
    level = rule.word("level", INSPECTION_LEVELS) if "level" in rule.content else DEFAULT_LEVEL
    return SamplingRule(word, level, rule.source())
