"""The rules that a run's parameters state: ready ones, a file, or limits one by one; never two of these at once."""
from __future__ import annotations

from pathlib import Path
from typing import Any

from qgis.core import QgsProcessingParameterNumber
from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SeamInspectorAlgorithm
from ..toolkit.algorithms.parameters import in_users_language
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import filled, tr
from .measure import acceptance_rules as limits
from .measure import messages
from .measure.acceptance_rules import (
    FAILED_SHARE,
    LONGEST_FAILURE,
    MEASURED_SHARE,
    AcceptanceRule,
    AcceptanceRules,
    SamplingRule,
    load_acceptance_rules,
    ready_files,
)
from .measure.sampling_plans import (
    DEFAULT_LEVEL,
    DEFAULT_LQ,
    INSPECTION_LEVELS,
    LIMITING_QUALITIES,
    NORMAL,
    SEVERITIES,
    SHARE_AQLS,
    word_of,
)

READY_RULES, RULES = "READY_RULES", "RULES"
MIN_KEPT, MAX_SHARE, MAX_RUN, MIN_MEASURED = "MIN_KEPT", "MAX_SHARE", "MAX_RUN", "MIN_MEASURED"
PLAN, AQL, LQ, INSPECTION_LEVEL, SEVERITY = "PLAN", "AQL", "LQ", "INSPECTION_LEVEL", "SEVERITY"
ALL, ISO2859, ISOLATED = "all", "iso2859", "iso2859_2"
QUALITIES = {AQL: (SHARE_AQLS, limits.STANDARD_AQL), LQ: (LIMITING_QUALITIES, DEFAULT_LQ)}
"""What the standards have of each, and what is taken where none is given."""
LIMITS = {
    MIN_KEPT: limits.STANDARD_KEPT,
    MAX_SHARE: 100 * limits.STANDARD_FAILED_SHARE,
    MAX_RUN: limits.STANDARD_LONGEST_M,
    MIN_MEASURED: 100 * limits.STANDARD_MEASURED_SHARE,
}
"""What parameters that are numbers hold when nobody changes them."""
DEFAULTS: dict[str, object] = {
    **LIMITS, PLAN: ALL, AQL: limits.STANDARD_AQL, LQ: DEFAULT_LQ, INSPECTION_LEVEL: DEFAULT_LEVEL, SEVERITY: NORMAL
}

_ORIGINS = {
    MIN_KEPT: QT_TR_NOOP("below it a loss is called significant"),
    MAX_SHARE: QT_TR_NOOP("Beeldmateriaal (NL) lets 2 % deviate if it is not contiguous"),
    MAX_RUN: QT_TR_NOOP("half a standard window of 100 m"),
    MIN_MEASURED: QT_TR_NOOP("nothing is accepted on a guess"),
}
"""Where the defaults come from: docs/acceptance/rules.md."""


def stated_rules(run: Run) -> AcceptanceRules:
    """Raises SettingsError for limits that can't be, and for a parameter that says something else than the file."""
    given = _given(run)
    own, ready = (run.text(RULES) if run.parameters.get(RULES) else ""), run.word(READY_RULES)
    if own and ready:
        raise SettingsError(messages.TWO_RULES(ready=ready, name=Path(own).name))
    if not own and not ready:
        return _of_parameters(given)
    rules = in_users_language(load_acceptance_rules(Path(own) if own else ready_files()[ready]))
    said = _as_parameters(rules)
    for name, value in given.items():
        if value not in (DEFAULTS[name], said.get(name)):
            ruled = messages.RULES_SAY_NOTHING() if said.get(name) is None else said[name]
            raise SettingsError(
                messages.RULES_AND_PARAMETER(parameter=name, value=value, name=Path(own).name or ready, ruled=ruled)
            )
    return rules


def check_limit(name: str, value: float, most: float | None = None) -> None:
    """Raise SettingsError for a number below 0, or above the most there can be."""
    if value < 0:
        raise SettingsError(messages.LIMIT_NEGATIVE(parameter=name, value=value))
    if not (most is None or value <= most):
        raise SettingsError(messages.LIMIT_NO_SHARE(parameter=name, value=value, least=0, most=most))


def standard_quality(run: Run, name: str) -> str:
    """AQL or LQ as the standard writes it, also of a number. Raises SettingsError for one that it does not have."""
    value, (known, usual) = run.raster_value(name), QUALITIES[name]
    word = usual if value is None or value == "" else word_of(value, known)
    if word is None:
        if name == LQ:
            raise SettingsError(messages.LQ_UNKNOWN(parameter=name, value=value, known=", ".join(known)))
        raise SettingsError(messages.QUALITY_UNKNOWN(parameter=name, value=value, known=", ".join(known)))
    return word


def known_word(run: Run, name: str, known: tuple[str, ...]) -> str:
    """Word of a choice; raises SettingsError for a word that is none of it."""
    word = run.word(name)
    if word not in known:
        raise SettingsError(messages.WORD_UNKNOWN(parameter=name, value=word, known=", ".join(known)))
    return word


def with_standard_words(parameters: dict[str, Any]) -> dict[str, Any]:
    """For QGIS's own check: qualities that are numbers, or written in another way, as the standard's words."""
    words = {name: word_of(parameters.get(name), known) for name, (known, _) in QUALITIES.items()}
    return {**parameters, **{name: word for name, word in words.items() if word is not None}}


def _given(run: Run) -> dict[str, object]:
    """Raises SettingsError for what can't be."""
    values: dict[str, object] = {}
    for name, most in ((MIN_KEPT, 1.0), (MAX_SHARE, 100.0), (MAX_RUN, None), (MIN_MEASURED, 100.0)):
        value = run.real(name)
        check_limit(name, value, most)
        values[name] = value
    values[PLAN] = known_word(run, PLAN, (ALL, ISO2859, ISOLATED))
    values.update({name: standard_quality(run, name) for name in QUALITIES})
    values[INSPECTION_LEVEL] = known_word(run, INSPECTION_LEVEL, INSPECTION_LEVELS)
    values[SEVERITY] = known_word(run, SEVERITY, SEVERITIES)
    return values


def _of_parameters(given: dict[str, object]) -> AcceptanceRules:
    def limit(name: str) -> float:
        return float(str(given[name]))

    def source(name: str) -> str:
        if given[name] != DEFAULTS[name]:
            return filled(tr("stated for this decision ({parameter})"), parameter=name)
        text = tr("the software's default ({parameter}): {origin}")
        return filled(text, parameter=name, origin=tr(_ORIGINS[name]))

    kept, least = limit(MIN_KEPT), 100 * limit(MIN_KEPT)
    measured = AcceptanceRule(MEASURED_SHARE, limit(MIN_MEASURED) / 100, source(MIN_MEASURED))
    of_all = {"kept": least, "measured": limit(MIN_MEASURED)}
    if given[PLAN] == ISO2859:
        aql, level, severity = (str(given[name]) for name in (AQL, INSPECTION_LEVEL, SEVERITY))
        name = tr("at least {kept:g} % kept, at least {measured:g} % measured, sampled at level {level}, AQL {aql}")
        sampling = SamplingRule(aql, level, severity, source(PLAN))
        words = filled(name, level=level, aql=float(aql), **of_all)
        return AcceptanceRules(words, kept, source(MIN_KEPT), (measured,), sampling)
    if given[PLAN] == ISOLATED:
        sampling = SamplingRule("", "", "", source(PLAN), str(given[LQ]))
        name = tr("at least {kept:g} % kept, at least {measured:g} % measured, sampled as an isolated lot, LQ {lq:g} %")
        words = filled(name, lq=float(sampling.lq), **of_all)
        return AcceptanceRules(words, kept, source(MIN_KEPT), (measured,), sampling)
    rules = (
        AcceptanceRule(FAILED_SHARE, limit(MAX_SHARE) / 100, source(MAX_SHARE)),
        AcceptanceRule(LONGEST_FAILURE, limit(MAX_RUN), source(MAX_RUN)),
        measured,
    )
    name = tr("at least {kept:g} % kept, at most {share:g} % failed, at most {run:g} m without a break, at least "
              "{measured:g} % measured")
    words = filled(name, share=limit(MAX_SHARE), run=limit(MAX_RUN), **of_all)
    return AcceptanceRules(words, kept, source(MIN_KEPT), rules)


def _as_parameters(rules: AcceptanceRules) -> dict[str, object]:
    """What a file says, in the parameters' units."""
    plan = ALL if rules.sampling is None else ISOLATED if rules.sampling.lq else ISO2859
    said: dict[str, object] = {MIN_KEPT: rules.least_kept, PLAN: plan}
    for name, check, scale in (
        (MAX_SHARE, FAILED_SHARE, 100), (MAX_RUN, LONGEST_FAILURE, 1), (MIN_MEASURED, MEASURED_SHARE, 100)
    ):
        limit = rules.limit(check)
        if limit is not None:
            said[name] = round(limit * scale, 9)
    if plan == ISOLATED and rules.sampling is not None:
        said[LQ] = rules.sampling.lq
    elif rules.sampling is not None:
        said[AQL], said[INSPECTION_LEVEL] = rules.sampling.aql, rules.sampling.inspection_level
        said[SEVERITY] = rules.sampling.severity
    return said


LOT_SIZE, SEED = "LOT_SIZE", "SEED"
_WHOLE = QgsProcessingParameterNumber.Type.Integer
_LARGEST_SEED = 2**31 - 1


def add_plan_parameters(algorithm: SeamInspectorAlgorithm) -> None:
    """LOT_SIZE, AQL, LQ, INSPECTION_LEVEL, SEVERITY and SEED."""
    algorithm.addDescribed(common.whole(LOT_SIZE, tr("Lot size"), 0, 0), tr(
        "How many pieces of seam the whole lot has; 0: as many as the layers hold."
    ))
    algorithm.addDescribed(
        common.choice(AQL, tr("Acceptance quality limit (AQL)"), SHARE_AQLS, limits.STANDARD_AQL),
        tr("The percentage of failing pieces up to which lots should nearly always be accepted, by ISO 2859-1."),
    )
    algorithm.addDescribed(common.choice(LQ, tr("Limiting quality (LQ)"), LIMITING_QUALITIES, DEFAULT_LQ), tr(
        "The percentage of failing pieces with which an isolated lot should hardly ever be accepted, as ISO 2859-2 has "
        "it: three times what you want at least."
    ))
    algorithm.addDescribed(
        common.choice(INSPECTION_LEVEL, tr("Inspection level"), INSPECTION_LEVELS, DEFAULT_LEVEL),
        tr("How large the sample is for its lot: II unless something else was agreed; S-1 is the smallest."),
    )
    algorithm.addDescribed(common.choice(SEVERITY, tr("Inspection"), SEVERITIES, NORMAL), tr(
        "Normal; tightened after two of five lots were rejected; reduced after ten that were accepted."
    ), advanced=True)
    algorithm.addDescribed(common.whole(SEED, tr("Seed"), limits.STANDARD_SEED, 0, _LARGEST_SEED), tr(
        "Of the drawing: the same seed draws the same sample again."
    ), advanced=True)
