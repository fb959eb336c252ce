"""The report of a radiometric acceptance, one HTML page."""
from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from ..imagery.errors import Message
from ..toolkit.charts.chart_style import MOST_NAMED, PAPER, UNNAMED, band_colour
from ..toolkit.charts.figure_files import new_figure, svg_text
from ..toolkit.pages.templates import HowMeasured, each_raster, save_page, sentences_once
from ..toolkit.translation import filled, sentence, shown_number, tr
from .measure import limits, messages
from .measure import rules as checks
from .measure.assessment import Assessment, CheckedFigure, ImageDecision, RadiometricDecision
from .measure.image_statistics import Histogram
from .measure.rules import CLIPPED_HIGH, CLIPPED_LOW, LUMINOSITY, PEAK, SEAM_CONTRAST, SEAM_STEP, RuleSet
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
    no_limit_words,
    spot_words,
    title,
)

_STATES = {checks.ACCEPTED: "good", checks.REJECTED: "bad", checks.UNDECIDED: "open"}
_MOST_HISTOGRAMS = 100  # a tenth of a second each


def save_radiometry_report(
    path: Path, decision: RadiometricDecision, notices: Iterable[Message], rules: RuleSet
) -> None:
    """Write the report. Raises SettingsError where no file can be."""
    results = [image.result for image in decision.images]
    pairs = [(result, pair) for result in results if (pair := step_and_contrast(result)) is not None]
    figure = balance_figure(results) if pairs else None
    sources = list(dict.fromkeys(rule.source for rule in rules.rules))
    remarks = [*notices, *(notice for result in results for notice in result.notices)]
    accepted = [image.outcome == checks.ACCEPTED for image in decision.images]
    drawn = sorted(range(len(results)), key=accepted.__getitem__)[:_MOST_HISTOGRAMS]
    if len(drawn) < len(results):
        remarks.append(messages.HISTOGRAMS_OF_SOME(drawn=len(drawn), count=len(results)))
    save_page(
        path,
        "radiometry",
        HowMeasured([(tr("rules"), rules.name)], each_raster(tr("image"), (result.image for result in results))),
        verdict=(_STATES[decision.outcome], decision_word(decision).capitalize(), " ".join(decision_reasons(decision))),
        sources=sources,
        overview=[_overview(image) for image in decision.images],
        notices=sentences_once(remarks),
        balance=[[number, *_balance_row(result, *pair)] for number, (result, pair) in enumerate(pairs, 1)],
        balance_chart=None if figure is None else svg_text(figure),
        images=(_section(image, sources, number in drawn) for number, image in enumerate(decision.images)),
        area_side=limits.AREA_PX,
        seam_near=limits.SEAM_NEAR_PX,
        seam_far=limits.SEAM_FAR_PX,
        seam_station=limits.SEAM_STATION_PX,
    )  # fmt: skip


def _balance_row(result: Assessment, step: float, contrast: float) -> list[str]:
    """The worst seam of an image, where it is, and the contrast beside its seams."""
    worst = next(checked for checked in result.measured(SEAM_STEP) if checked.value == step)
    x, y = worst.spot.place if worst.spot is not None else (math.nan, math.nan)
    return [
        title(result),
        f"{shown_number(100 * step)} % ({band_words(worst.band)})",
        spot_words(worst) or "",
        filled("{x:.2f}, {y:.2f}", x=x, y=y),
        f"{shown_number(100 * contrast)} %",
    ]


def _overview(image: ImageDecision) -> list[object]:
    states = [checked.passed for checked in image.result.checked_figures]
    missing = [checked for checked in image.result.checked_figures if checked.value is None]
    word = tr(OUTCOME_WORDS[image.outcome])
    return [
        title(image.result), word, states.count(True), checks_words(image.failed) or tr("none"),
        checks_words(missing) or tr("none"),
    ]  # fmt: skip


def _section(image: ImageDecision, sources: Sequence[str], is_drawn: bool) -> dict[str, object]:
    """The page's section on one image: a row for each check, a column for each band."""
    result, is_without_limit = image.result, image.outcome == checks.UNDECIDED and not image.missed
    by_check: dict[str, dict[str, CheckedFigure]] = {}
    for checked in result.checked_figures:
        by_check.setdefault(checked.rule.check, {})[checked.band] = checked
    bands = list(dict.fromkeys(checked.band for checked in result.checked_figures if checked.value is not None))
    figure = histogram_figure(result) if is_drawn else None
    return {
        "title": title(result),
        "outcome": tr(OUTCOME_WORDS[image.outcome]).capitalize(),
        "reasons": [*([no_limit_words()] if is_without_limit else ()), *found_words(result)],
        "available": result.available,
        "histogram": None if figure is None else svg_text(figure),
        "bands": [band_words(band) for band in bands],
        "checks": [_check_row(check, figures, bands, sources) for check, figures in by_check.items()],
        "remarks": _remarks(result),
    }  # fmt: skip


def _check_row(
    check: str, figures: Mapping[str, CheckedFigure], bands: Sequence[str], sources: Sequence[str]
) -> dict[str, object]:
    """``source`` says which of the notes tells where the limit comes from."""
    rule = next(iter(figures.values())).rule
    has_failed = any(checked.passed is False for checked in figures.values())
    word = tr("failed") if has_failed else tr("passed") if any(checked.passed for checked in figures.values()) else ""
    values = {band: figure_words(rule, checked.value) for band, checked in figures.items() if checked.value is not None}
    return {
        "name": tr(CHECK_WORDS[check]), "values": [values.get(band, "") for band in bands], "limit": limit_words(rule),
        "result": word if values else tr("not measurable"),
        "is_reason": has_failed or any(checked.is_missed for checked in figures.values()),
        "source": sources.index(rule.source) + 1,
    }  # fmt: skip


def _remarks(result: Assessment) -> list[str]:
    """The reasons why figures can't be measured or judged, each once with what it concerns."""
    reasons: dict[str, list[CheckedFigure]] = {}
    for checked in result.checked_figures:
        if checked.reason is not None:
            reasons.setdefault(sentence(checked.reason), []).append(checked)
    return [f"{checks_words(concerned)}: {reason}" for reason, concerned in reasons.items()]


def histogram_figure(result: Assessment) -> Figure | None:
    """The histograms of what is judged, the tails that count as clipped and where the peak has to lie.

    Without a known range they end at the largest value, and nothing is marked.
    """
    if not result.histograms or not any(histogram.pixels for histogram in result.histograms.values()):
        return None
    shown = result.available
    if shown is None:
        occurring = [histogram for histogram in result.histograms.values() if histogram.pixels]
        least = min(float(histogram.values[np.flatnonzero(histogram.counts)[0]]) for histogram in occurring)
        shown = least, max(least + 1, *(histogram.largest for histogram in occurring))
    low, high = shown
    figure = new_figure(2.7, 1.7)
    axes = figure.subplots()
    for place, (name, histogram) in enumerate(_drawn(result).items()):
        counts, middles = histogram.binned(shown)
        is_dark = name == LUMINOSITY or len(_drawn(result)) == 1
        colour = PAPER.text if is_dark else band_colour(name, place, is_alone=False)
        words = band_words(name) if place < MOST_NAMED else UNNAMED
        axes.plot(middles, 100 * counts / max(histogram.pixels, 1), color=colour, linewidth=1.1, label=words)
    known = result.checked_figures if result.available is not None else ()
    rules = {checked.rule.check: checked.rule for checked in known}
    whole = next(iter(result.histograms.values())).has_steps
    for check in (CLIPPED_LOW, CLIPPED_HIGH):
        if check in rules:
            width = rules[check].values * (1 if whole else (high - low) / 256)
            start = low - 0.5 if check == CLIPPED_LOW else high - width + 0.5
            axes.axvspan(start, start + width, color=PAPER.limit, alpha=0.2, linewidth=0)
    most = rules[PEAK].most if PEAK in rules else None
    if most is not None:
        reach, middle = most * (high - low), (low + high) / 2
        axes.axvspan(middle - reach, middle + reach, color="#009e73", alpha=0.12, linewidth=0)
    axes.set_xlim(low - 0.01 * (high - low), high + 0.01 * (high - low))
    axes.set_ylim(bottom=0)
    axes.set_xlabel(tr("value (DN)"), fontsize=7)
    axes.set_ylabel(tr("pixels (%)"), fontsize=7)
    axes.tick_params(labelsize=7)
    axes.spines[["top", "right"]].set_visible(False)
    if len(axes.get_lines()) > 1:
        axes.legend(fontsize=6, frameon=False, handlelength=1)
    return figure


def _drawn(result: Assessment) -> Mapping[str, Histogram]:
    """Histograms that are drawn: of one band the luminosity is the band itself, so that one of the two is enough."""
    return dict(list(result.histograms.items())[:1]) if len(result.image.band_names) == 1 else result.histograms


def balance_figure(results: Sequence[Assessment]) -> Figure | None:
    """Contrast beside the seams against the step at them, a numbered point for each raster with seams: tonal unity
    is bought with contrast. None with fewer than two."""
    points = [(result, *pair) for result in results if (pair := step_and_contrast(result)) is not None]
    if len(points) < 2:
        return None
    figure = new_figure(5.2, 3.4)
    axes = figure.subplots()
    for number, (_, step, contrast) in enumerate(points, 1):
        axes.plot([100 * step], [100 * contrast], "o", color=PAPER.sources[0], markersize=6)
        axes.annotate(str(number), (100 * step, 100 * contrast), xytext=(4, 4), textcoords="offset points", fontsize=8)
    axes.set_xlim(0, 115 * max(max(step for _, step, _ in points), 1e-3))
    axes.set_ylim(0, 115 * max(max(contrast for _, _, contrast in points), 1e-3))
    axes.set_xlabel(tr("largest step at a seam (% of the largest value)"))
    axes.set_ylabel(tr("contrast beside the seams (% of the range)"))
    axes.grid(True, color=PAPER.grid)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    return figure


def step_and_contrast(result: Assessment) -> tuple[float, float] | None:
    """The largest step of any seam and band, and the mean of the bands' contrasts beside the seams; None where they
    are not measured."""
    steps, contrasts = (
        [checked.value or 0.0 for checked in result.measured(check)] for check in (SEAM_STEP, SEAM_CONTRAST)
    )
    return (max(steps), math.fsum(contrasts) / len(contrasts)) if steps and contrasts else None
