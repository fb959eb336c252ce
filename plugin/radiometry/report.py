"""The report of a radiometric acceptance, one HTML page."""
from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from ..imagery.errors import Message
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages.templates import HowMeasured, each_raster, save_page, sentences_once
from ..toolkit.translation import filled, sentence, shown_number, tr
from .charts import balance_figure, histogram_figure, step_and_contrast
from .measure import limits
from .measure import rules as checks
from .measure.assessment import Assessment, CheckedFigure, ImageDecision, RadiometricDecision, RadiometricOutcome
from .measure.rules import RuleSet
from .words import (
    CHECK_WORDS,
    OUTCOME_WORDS,
    band_words,
    checks_words,
    decision_reasons,
    decision_word,
    figure_words,
    found_words,
    limit_words,
    outcome_reasons,
    spot_words,
    title,
)

_STATES = {
    RadiometricOutcome.ACCEPTED: "good",
    RadiometricOutcome.REJECTED: "bad",
    RadiometricOutcome.UNDECIDED: "open",
}


@dataclass(frozen=True)
class CheckRow:
    """One check of an image."""

    name: str
    values: Sequence[tuple[str, str]]
    """Bands and their figures."""
    limit: str
    passed: str
    """That all bands passed, or which failed; empty where nothing was judged."""
    has_failed: bool
    remarks: Sequence[str]
    """What can't be measured or judged, and why."""
    source: int
    """Of the limit: which of the notes says it."""


def save_radiometry_report(
    path: Path, decision: RadiometricDecision, notices: Iterable[Message], rules: RuleSet
) -> None:
    """Write the report. Raises SettingsError where no file can be."""
    results = [image.result for image in decision.images]
    pairs = [(result, pair) for result in results if (pair := step_and_contrast(result)) is not None]
    figure = balance_figure(results) if pairs else None
    sources = list(dict.fromkeys(rule.source for rule in rules.rules))
    told = [*notices, *(notice for result in results for notice in result.notices)]
    save_page(
        path,
        "radiometry",
        HowMeasured([(tr("rules"), rules.name)], each_raster(tr("image"), (result.image for result in results))),
        verdict=_verdict(decision),
        sources=sources,
        overview=[_overview(image) for image in decision.images],
        notices=sentences_once(told),
        balance=[[number, *_balance_row(result, *pair)] for number, (result, pair) in enumerate(pairs, 1)],
        balance_chart=None if figure is None else svg_text(figure),
        images=(_section(image, sources) for image in decision.images),
        area_side=limits.AREA_PX,
        seam_near=limits.SEAM_NEAR_PX,
        seam_far=limits.SEAM_FAR_PX,
        seam_station=limits.SEAM_STATION_PX,
    )  # fmt: skip


def _balance_row(result: Assessment, step: float, contrast: float) -> list[str]:
    """The worst seam of an image, where it is, and the contrast beside its seams."""
    at_seams = [one for one in result.checked_figures if one.rule.check == checks.SEAM_STEP and one.value == step]
    x, y = at_seams[0].spot.place if at_seams[0].spot is not None else (math.nan, math.nan)
    return [
        title(result),
        f"{shown_number(100 * step)} % ({band_words(at_seams[0].band)})",
        spot_words(at_seams[0]) or "",
        filled("{x:.2f}, {y:.2f}", x=x, y=y),
        f"{shown_number(100 * contrast)} %",
    ]


def _verdict(decision: RadiometricDecision) -> tuple[str, str, str]:
    """Its state, its word and its reasons."""
    return _STATES[decision.outcome], decision_word(decision), " ".join(decision_reasons(decision))


def _overview(image: ImageDecision) -> list[object]:
    states = [checked.passed for checked in image.result.checked_figures]
    missing = [checked for checked in image.result.checked_figures if checked.value is None]
    word = tr(OUTCOME_WORDS[image.outcome])
    return [
        title(image.result), word, states.count(True), checks_words(image.failed) or tr("none"),
        checks_words(missing) or tr("none"),
    ]  # fmt: skip


def _section(image: ImageDecision, sources: Sequence[str]) -> dict[str, object]:
    """What the page shows of one image."""
    result = image.result
    by_check: dict[str, dict[str, CheckedFigure]] = {}
    for checked in result.checked_figures:
        by_check.setdefault(checked.rule.check, {})[checked.band] = checked
    figure = histogram_figure(result)
    said: set[str] = set()
    return {
        "title": title(result),
        "outcome": tr(OUTCOME_WORDS[image.outcome]),
        "reasons": [*outcome_reasons(image), *found_words(result)],
        "available": result.available,
        "histogram": None if figure is None else svg_text(figure),
        "checks": [_check_row(check, own, sources, said) for check, own in by_check.items()],
    }


def _check_row(check: str, own: Mapping[str, CheckedFigure], sources: Sequence[str], said: set[str]) -> CheckRow:
    rule = next(iter(own.values())).rule
    failed = [band_words(checked.band) for checked in own.values() if checked.passed is False]
    passed = tr("passed") if any(checked.passed for checked in own.values()) else ""
    names = "" if len(failed) == len(own) else f" ({', '.join(failed)})"
    return CheckRow(
        tr(CHECK_WORDS[check]),
        [(band_words(band), figure_words(rule, one.value)) for band, one in own.items() if one.value is not None],
        limit_words(rule),
        tr("failed") + names if failed else passed,
        bool(failed),
        _remarks(own, said),
        sources.index(rule.source) + 1,
    )


def _remarks(own: Mapping[str, CheckedFigure], said: set[str]) -> list[str]:
    """Each reason with the bands that it concerns, where it doesn't concern all; a long one once for each image.

    ``said`` holds those of the rows above, and is added to."""
    reasons: dict[str, list[str]] = {}
    for checked in own.values():
        if checked.reason is not None:
            words = sentence(checked.reason)
            shown = tr("not measurable, for the reason above") if checked.value is None and words in said else words
            reasons.setdefault(shown, []).append(band_words(checked.band))
    said.update(sentence(checked.reason) for checked in own.values() if checked.reason is not None)
    return [
        reason if len(concerned) == len(own) else f"{', '.join(concerned)}: {reason}"
        for reason, concerned in reasons.items()
    ]
