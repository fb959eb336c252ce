"""The rules of acceptance: which figures are checked, against which limits, and where those come from.

A rules file is JSON:

    {"name": "...", "value_range": [0, 4095], "rules": [
        {"check": "contrast", "least": 0.10, "most": 0.20, "source": "..."}, ...]}

``check`` is one of ``CHECKS``, each at most once; ``least`` and ``most`` are limits, both inclusive, and a rule with
neither is measured and not judged; ``source`` says where the limit comes from. ``values`` (clipped_low and
clipped_high only, 5 when left out) is how many values count as clipped. ``value_range``, optional, is the lowest and
highest value that pixels could have; without it the data type and the largest value say it. Shares are fractions
of 1. ``docs/radiometry.md`` shows the whole.
"""
from __future__ import annotations

import json
import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ...imagery.errors import SettingsError
from ...imagery.message import Message
from ...imagery.value_ranges import ValueRange
from . import messages

_JRC = "JRC, Orthoimage technical specifications for the purpose of LPIS"
_FRENCH_ORDER = "Arrêté du 16 septembre 2003, section 8.4 (France)"
_TRADED = "Pyka 2010: tonal unity at the seams is bought with contrast"
DEFAULT_RULES = {
    "name": "JRC orthoimage specification for LPIS",
    "rules": [
        {"check": "clipped_low", "most": 0.005, "values": 5, "source": f"{_JRC}: overall clipping"},
        {"check": "clipped_high", "most": 0.005, "values": 5, "source": f"{_JRC}: overall clipping"},
        {"check": "peak", "most": 0.15, "source": f"{_JRC}: histogram peak"},
        {"check": "contrast", "least": 0.10, "most": 0.20, "source": f"{_JRC}: contrast"},
        {"check": "signal_to_noise", "least": 5, "source": f"{_JRC}: noise"},
        {"check": "colour_balance", "most": 0.02, "source": f"{_JRC}: colour balance"},
        {"check": "seam_step", "source": _FRENCH_ORDER},  # which leaves the limit to the contract
        {"check": "seam_contrast", "source": _TRADED},  # a figure to stand beside the step; it has no limit of its own
    ],
}

CLIPPED_LOW, CLIPPED_HIGH, PEAK, CONTRAST = "clipped_low", "clipped_high", "peak", "contrast"
SIGNAL_TO_NOISE, COLOUR_BALANCE = "signal_to_noise", "colour_balance"
SEAM_STEP, SEAM_CONTRAST = "seam_step", "seam_contrast"
AT_SEAMS = (SEAM_STEP, SEAM_CONTRAST)
"""Measured only where seamlines are given."""
CHECKS = (CLIPPED_LOW, CLIPPED_HIGH, PEAK, CONTRAST, SIGNAL_TO_NOISE, COLOUR_BALANCE, *AT_SEAMS)
_CLIPPING = (CLIPPED_LOW, CLIPPED_HIGH)
_RULE_KEYS, _FILE_KEYS = ("check", "least", "most", "values", "source"), ("name", "value_range", "rules")
_DEFAULT_VALUES = 5


@dataclass(frozen=True)
class Rule:
    """One figure and its limits."""

    check: str
    """One of ``CHECKS``."""
    least: float | None
    """Smallest value that passes; None for no such limit."""
    most: float | None
    """Largest value that passes; None for no such limit."""
    source: str
    """Where the limits come from."""
    values: int = _DEFAULT_VALUES
    """How many values at the end of the range count as clipped."""

    @property
    def has_limit(self) -> bool:
        """Whether there is anything to pass."""
        return self.least is not None or self.most is not None

    def passes(self, value: float) -> bool:
        """Whether a value is within the limits."""
        return (self.least is None or value >= self.least) and (self.most is None or value <= self.most)


@dataclass(frozen=True)
class RuleSet:
    """All rules of one specification."""

    name: str
    rules: tuple[Rule, ...]
    value_range: ValueRange | None = None
    """Lowest and highest value that pixels could have; None: as data type and largest value say."""


def default_rules() -> RuleSet:
    """JRC's orthoimage specification for LPIS."""
    return _rule_set(DEFAULT_RULES, "")


def load_rules(path: Path) -> RuleSet:
    """The rules of a JSON file. Raises SettingsError that says what is wrong with it and where."""
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        why = getattr(error, "strerror", None) or "no UTF-8 text"
        raise SettingsError(messages.RULES_NOT_READABLE(name=path.name, error=why)) from None
    try:
        content = json.loads(text)
    except json.JSONDecodeError as error:
        raise SettingsError(messages.RULES_NOT_JSON(name=path.name, line=error.lineno, error=error.msg)) from None
    return _rule_set(content, path.name)


def _rule_set(content: Any, name: str) -> RuleSet:
    if not isinstance(content, dict) or not isinstance(content.get("rules"), list) or not content["rules"]:
        raise SettingsError(messages.RULES_NO_OBJECT(name=name))
    _check_keys(content, _FILE_KEYS, messages.RULES_PLACE(), name)
    rules = [_rule(rule, messages.RULE_PLACE(number=number), name) for number, rule in enumerate(content["rules"], 1)]
    for index, rule in enumerate(rules):
        if rule.check in (other.check for other in rules[:index]):
            raise SettingsError(messages.RULES_CHECK_TWICE(name=name, check=rule.check))
    return RuleSet(str(content.get("name") or name), tuple(rules), _range(content.get("value_range"), name))


def _rule(content: Any, place: Message, name: str) -> Rule:
    if not isinstance(content, dict):
        raise SettingsError(messages.RULES_NO_OBJECT(name=name))
    _check_keys(content, _RULE_KEYS, place, name)
    check = content.get("check")
    if check not in CHECKS:
        raise SettingsError(messages.RULES_CHECK_UNKNOWN(place=place, name=name, check=check, known=", ".join(CHECKS)))
    least, most = (_limit(content, key, place, name) for key in ("least", "most"))
    if least is not None and most is not None and least > most:
        raise SettingsError(messages.RULES_LIMITS_CROSSED(place=place, name=name))
    values = content.get("values", _DEFAULT_VALUES)
    if "values" in content and check not in _CLIPPING:
        raise SettingsError(messages.RULES_VALUES_UNUSED(place=place, name=name))
    if not isinstance(values, int) or isinstance(values, bool) or values < 1:
        raise SettingsError(messages.RULES_VALUES_BAD(place=place, name=name))
    source = content.get("source")
    if not isinstance(source, str) or not source.strip():
        raise SettingsError(messages.RULES_SOURCE_MISSING(place=place, name=name))
    return Rule(check, least, most, source, values)


def _limit(content: dict[str, Any], key: str, place: Message, name: str) -> float | None:
    limit = content.get(key)
    if limit is None:
        return None
    if not (_is_number(limit) and limit >= 0):
        raise SettingsError(messages.RULES_LIMIT_BAD(place=place, name=name, key=key))
    return float(limit)


def _range(content: Any, name: str) -> ValueRange | None:
    if content is None:
        return None
    if isinstance(content, list) and len(content) == 2 and all(map(_is_number, content)) and content[0] < content[1]:
        return float(content[0]), float(content[1])
    raise SettingsError(messages.RULES_RANGE_BAD(name=name))


def _check_keys(content: dict[str, Any], known: tuple[str, ...], place: Message, name: str) -> None:
    for key in content:
        if key not in known:
            raise SettingsError(messages.RULES_KEY_UNKNOWN(place=place, name=name, key=key, known=", ".join(known)))


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)
