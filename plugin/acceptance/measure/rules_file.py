"""Files with the rules of a contract.

A rules file is JSON (``imagery/documents.py``):

    {"name": "...", "rules": [
        {"check": "kept", "least": 0.7, "source": "..."},
        {"check": "failed_share", "most": 0.02, "source": "..."},
        {"check": "longest_failure", "most": 50, "source": "..."},
        {"check": "measured_share", "least": 0.9, "source": "..."},
        {"check": "sampling", "aql": 1.0, "level": "II", "severity": "normal", "source": "..."}]}

Each check stands in it at most once, ``kept`` always, and at least one of ``failed_share``, ``longest_failure`` and
``sampling``. Shares are fractions of 1, lengths metres, the AQL items per hundred. A check that is not there does not
decide, but for ``measured_share``: then what ``STANDARD_MEASURED_SHARE`` says.
"""
from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from ...imagery.documents import RuleObject, read_rules, ready_rules
from ...imagery.errors import SettingsError
from . import messages
from .acceptance_rules import (
    CHECKS,
    FAILED_SHARE,
    KEPT,
    KEY_OF_LIMIT,
    LONGEST_FAILURE,
    MEASURED_SHARE,
    SAMPLING,
    AcceptanceRule,
    AcceptanceRules,
    SamplingRule,
    standard_measured,
)
from .sampling.iso2859 import DEFAULT_LEVEL, INSPECTION_LEVELS, NORMAL, SEVERITIES, SHARE_AQLS, aql_word

SUBJECT = "acceptance"
"""Of the ready files."""

_OF_SHARE = (KEPT, MEASURED_SHARE, FAILED_SHARE)


def ready_files() -> dict[str, Path]:
    """The ready files by their names."""
    return ready_rules(SUBJECT)


def load_acceptance_rules(path: Path) -> AcceptanceRules:
    """The rules of a JSON file. Raises SettingsError that says what is wrong with it and where."""
    return read_rules(path, _acceptance_rules)


def _acceptance_rules(whole: RuleObject, objects: Sequence[RuleObject]) -> AcceptanceRules:
    whole.allow(("name", "rules"))
    by_check: dict[str, RuleObject] = {}
    for one in objects:
        check = one.word("check", CHECKS)
        if check in by_check:
            raise SettingsError(messages.TWO_RULES_FOR_CHECK(place=one.place, name=one.file, check=check))
        by_check[check] = one
    if KEPT not in by_check:
        raise SettingsError(messages.RULES_WITHOUT_KEPT(name=whole.file))
    if not by_check.keys() & {FAILED_SHARE, LONGEST_FAILURE, SAMPLING}:
        raise SettingsError(messages.RULES_DECIDE_NOTHING(name=whole.file))
    limits = {check: _limit(one, check) for check, one in by_check.items() if check != SAMPLING}
    rules = [AcceptanceRule(check, limits[check], by_check[check].source()) for check in limits if check != KEPT]
    if MEASURED_SHARE not in limits:
        rules.append(standard_measured())
    sampling = _sampling(by_check[SAMPLING]) if SAMPLING in by_check else None
    name = str(whole.content.get("name") or whole.file)
    return AcceptanceRules(name, limits[KEPT], by_check[KEPT].source(), tuple(rules), sampling)


def _limit(one: RuleObject, check: str) -> float:
    key = KEY_OF_LIMIT[check]
    one.allow(("check", key, "source"))
    limit = one.number(key)
    if limit is None:
        raise SettingsError(messages.RULES_LIMIT_MISSING(place=one.place, name=one.file, key=key, check=check))
    if check in _OF_SHARE and limit > 1:
        raise SettingsError(messages.RULES_NO_SHARE(place=one.place, name=one.file, key=key, limit=limit))
    return limit


def _sampling(one: RuleObject) -> SamplingRule:
    one.allow(("check", "aql", "level", "severity", "source"))
    aql = aql_word(one.content.get("aql"))
    if aql is None or aql not in SHARE_AQLS:
        given, known = one.content.get("aql"), ", ".join(SHARE_AQLS)
        raise SettingsError(messages.RULES_AQL_UNKNOWN(place=one.place, name=one.file, aql=given, known=known))
    level = one.word("level", INSPECTION_LEVELS) if "level" in one.content else DEFAULT_LEVEL
    severity = one.word("severity", SEVERITIES) if "severity" in one.content else NORMAL
    return SamplingRule(aql, level, severity, one.source())
