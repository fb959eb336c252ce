"""The rules that a run's parameters state: ready ones, a file, or limits one by one; never two of these at once."""
from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from qgis.PyQt.QtCore import QT_TR_NOOP

from ..imagery.documents import read_rules, ready_rules
from ..imagery.errors import SettingsError
from ..toolkit.algorithms import parameters as common
from ..toolkit.algorithms.base import SeamInspectorAlgorithm
from ..toolkit.algorithms.run import Run
from ..toolkit.translation import filled, sentence, tr
from .measure import acceptance_rules, messages
from .measure.sampling_plans import AQLS, DEFAULT_LEVEL, DEFAULT_LQ, INSPECTION_LEVELS, LIMITING_QUALITIES, word_of

READY_RULES, RULES = "READY_RULES", "RULES"
MIN_KEPT, MAX_SHARE, MAX_RUN, MIN_MEASURED = "MIN_KEPT", "MAX_SHARE", "MAX_RUN", "MIN_MEASURED"
PLAN, AQL, LQ, INSPECTION_LEVEL = "PLAN", "AQL", "LQ", "INSPECTION_LEVEL"
ALL, ISO2859, ISOLATED = "all", "iso2859", "iso2859_2"
QUALITIES = {AQL: (AQLS, acceptance_rules.STANDARD_AQL), LQ: (LIMITING_QUALITIES, DEFAULT_LQ)}
"""What the standards have of each, and what is taken where none is given."""
LIMITS = {
    MIN_KEPT: acceptance_rules.STANDARD_KEPT,
    MAX_SHARE: 100 * acceptance_rules.STANDARD_FAILED_SHARE,
    MAX_RUN: acceptance_rules.STANDARD_LONGEST_M,
    MIN_MEASURED: 100 * acceptance_rules.STANDARD_MEASURED_SHARE,
}
"""What parameters that are numbers hold when nobody changes them."""
MOST = {MIN_KEPT: 1.0, MAX_SHARE: 100.0, MAX_RUN: None, MIN_MEASURED: 100.0}
DEFAULTS: dict[str, object] = {
    **LIMITS, PLAN: ALL, AQL: acceptance_rules.STANDARD_AQL, LQ: DEFAULT_LQ, INSPECTION_LEVEL: DEFAULT_LEVEL
}

_ORIGINS = {
    MIN_KEPT: QT_TR_NOOP("below it a loss is called significant"),
    MAX_SHARE: QT_TR_NOOP("Beeldmateriaal (NL) lets 2 % deviate if it is not contiguous"),
    MAX_RUN: QT_TR_NOOP("half a standard window of 100 m"),
    MIN_MEASURED: QT_TR_NOOP("nothing is accepted on a guess"),
}
"""Origins of the defaults: docs/acceptance/rules.md."""


def stated_rules(run: Run) -> acceptance_rules.AcceptanceRules:
    """Raises SettingsError for limits that can't be, and for a parameter beside rules that are given."""
    given: dict[str, Any] = {
        **{name: run.real(name) for name in LIMITS}, **{name: standard_quality(run, name) for name in QUALITIES},
        PLAN: run.word(PLAN), INSPECTION_LEVEL: run.word(INSPECTION_LEVEL),
    }  # fmt: skip
    path, ready = (run.text(RULES) if run.parameters.get(RULES) else ""), run.word(READY_RULES)
    if path and ready:
        raise SettingsError(messages.TWO_RULES(ready=ready, name=Path(path).name))
    if not path and not ready:
        return _of_parameters(run, given)
    name = Path(path).name or ready
    for parameter, value in given.items():
        if value != DEFAULTS[parameter]:
            raise SettingsError(messages.RULES_AND_PARAMETER(parameter=parameter, value=value, name=name))
    return read_rules(Path(path) if path else ready_rules("acceptance")[ready], acceptance_rules.rules_of_objects, tr)


def standard_quality(run: Run, name: str) -> str:
    """AQL or LQ as the standard writes it, also of a number."""
    known, usual = QUALITIES[name]
    return word_of(run.raster_value(name), known) or usual


def sampling_rule(run: Run, source: str = "") -> acceptance_rules.SamplingRule | None:
    """The plan of a standard that a run asks for; None where it asks for none."""
    plan = run.word(PLAN)
    if plan == ISOLATED:
        return acceptance_rules.SamplingRule("", "", source, standard_quality(run, LQ))
    level = run.word(INSPECTION_LEVEL)
    return acceptance_rules.SamplingRule(standard_quality(run, AQL), level, source) if plan == ISO2859 else None


def with_standard_words(parameters: dict[str, Any]) -> dict[str, Any]:
    """For QGIS's own check: qualities that are numbers, or written in another way, as the standard's words."""
    words = {name: word_of(parameters.get(name), known) for name, (known, _) in QUALITIES.items()}
    return {**parameters, **{name: word for name, word in words.items() if word is not None}}


def _of_parameters(run: Run, given: dict[str, Any]) -> acceptance_rules.AcceptanceRules:
    def source(name: str) -> str:
        if given[name] != DEFAULTS[name]:
            return filled(tr("stated for this decision ({parameter})"), parameter=name)
        text = tr("the software's default ({parameter}): {origin}")
        return filled(text, parameter=name, origin=tr(_ORIGINS[name]))

    sampling = None if given[PLAN] == ALL else sampling_rule(run, source(PLAN))
    kept, most, run_m, least = (given[name] for name in LIMITS)
    rules = acceptance_rules.limit_rules(kept, most / 100, run_m, least / 100)
    ruled = tuple(
        replace(rule, source=source(name)) for rule, name in zip(rules.rules, (MAX_SHARE, MAX_RUN, MIN_MEASURED))
        if sampling is None or name == MIN_MEASURED
    )
    rules = replace(rules, kept_source=source(MIN_KEPT), rules=ruled, sampling=sampling)
    return replace(rules, name=sentence(acceptance_rules.limits_in_words(rules)))


LOT_SIZE, SEED = "LOT_SIZE", "SEED"
_LARGEST_SEED = 2**31 - 1


def add_plan_parameters(algorithm: SeamInspectorAlgorithm) -> None:
    algorithm.addDescribed(common.whole(LOT_SIZE, tr("Lot size"), 0, 0), tr(
        "How many pieces of seam the whole lot has; 0: as many as the layers hold."
    ))
    algorithm.addDescribed(
        common.choice(AQL, tr("Acceptance quality limit (AQL)"), AQLS, acceptance_rules.STANDARD_AQL),
        tr("The percentage of failing pieces up to which lots should nearly always be accepted, by ISO 2859-1."),
    )
    algorithm.addDescribed(common.choice(LQ, tr("Limiting quality (LQ)"), LIMITING_QUALITIES, DEFAULT_LQ), tr(
        "The percentage of failing pieces with which an isolated lot should hardly ever be accepted, by ISO 2859-2: at "
        "least three times the percentage that you want."
    ))
    algorithm.addDescribed(
        common.choice(INSPECTION_LEVEL, tr("Inspection level"), INSPECTION_LEVELS, DEFAULT_LEVEL),
        tr("How large the sample is for its lot: II unless something else was agreed; S-1 is the smallest."),
    )
    algorithm.addDescribed(common.whole(SEED, tr("Seed"), acceptance_rules.STANDARD_SEED, 0, _LARGEST_SEED), tr(
        "Starts the random draw: the same seed draws the same sample again."
    ), advanced=True)
