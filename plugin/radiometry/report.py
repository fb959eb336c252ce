"""The report of a radiometric acceptance, one HTML page."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP, QLocale

from ..imagery.message import Message
from ..imagery.value_ranges import ValueRange
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages.how_measured import HowMeasured, each_raster
from ..toolkit.pages.templates import save_page, sentences_once
from ..toolkit.translation import decimals_beside, sentence, shown_number, tr
from .charts import balance_figure, histogram_figure, step_and_contrast
from .measure import limits
from .measure import rules as checks
from .measure.assessment import ALL_BANDS, Assessment, CheckedFigure
from .measure.rules import Rule, RuleSet

WORDS = {
    checks.CLIPPED_LOW: QT_TRANSLATE_NOOP("@default", "clipped at the dark end"),
    checks.CLIPPED_HIGH: QT_TRANSLATE_NOOP("@default", "clipped at the bright end"),
    checks.PEAK: QT_TRANSLATE_NOOP("@default", "histogram peak from mid-scale"),
    checks.CONTRAST: QT_TRANSLATE_NOOP("@default", "contrast"),
    checks.SIGNAL_TO_NOISE: QT_TRANSLATE_NOOP("@default", "signal to noise"),
    checks.COLOUR_BALANCE: QT_TRANSLATE_NOOP("@default", "colour balance"),
    checks.SEAM_STEP: QT_TRANSLATE_NOOP("@default", "step at the seams"),
    checks.SEAM_CONTRAST: QT_TRANSLATE_NOOP("@default", "contrast beside the seams"),
}


@dataclass(frozen=True)
class ImageSection:
    """What the page shows of one image."""

    title: str
    available: ValueRange | None
    histogram: str | None
    """SVG."""
    bands: Sequence[str]
    checks: Sequence[CheckRow]


@dataclass(frozen=True)
class CheckRow:
    """One check of an image."""

    name: str
    values: Sequence[str]
    """Of every band."""
    limit: str
    passed: str
    """That all bands passed, or which failed; empty where nothing was judged."""
    has_failed: bool
    remarks: Sequence[str]
    """What can't be measured or judged, and why."""
    source: int
    """Of the limit: which of the notes says it."""


def save_radiometry_report(
    path: Path, results: Sequence[Assessment], notices: Iterable[Message], rules: RuleSet
) -> None:
    """Write the report. Raises SettingsError where no file can be."""
    pairs = [(result, pair) for result in results if (pair := step_and_contrast(result)) is not None]
    figure = balance_figure(results) if pairs else None
    sources = list(dict.fromkeys(rule.source for rule in rules.rules))
    save_page(
        path,
        "radiometry",
        HowMeasured([(tr("rules"), rules.name)], each_raster(tr("image"), (result.image for result in results))),
        verdict=_verdict(results),
        sources=sources,
        overview=[_overview(result) for result in results],
        notices=sentences_once(notices),
        balance=[[_title(result), f"{shown_number(100 * step)} %", f"{shown_number(100 * contrast)} %"]
                 for result, (step, contrast) in pairs],
        balance_chart=None if figure is None else svg_text(figure),
        images=(_section(result, sources) for result in results),
        area_side=limits.AREA_PX,
        seam_near=limits.SEAM_NEAR_PX,
        seam_far=limits.SEAM_FAR_PX,
        seam_station=limits.SEAM_STATION_PX,
    )  # fmt: skip


def _verdict(results: Sequence[Assessment]) -> tuple[str, str, str]:
    """Whether all images pass: a state, a word, and how many do."""
    judged = [[one.passed for one in result.checked_figures if one.rule.has_limit] for result in results]
    failed = sum(False in outcomes for outcomes in judged)
    open_ones = sum(None in outcomes and False not in outcomes for outcomes in judged)
    counts = tr("Images or windows: {count}; failed: {failed}; not measurable in full: {open}.").format(
        count=len(results), failed=failed, open=open_ones
    )
    if failed:
        return "bad", tr("failed"), counts
    if open_ones or not results:
        return "open", tr("passed as far as it can be measured"), counts
    return "good", tr("passed"), counts


def _title(result: Assessment) -> str:
    """The image, and the window where it is not all of it."""
    name = result.image.ref.name
    if result.window_id is None:
        return name
    return tr("{name}, window {window}").format(name=name, window=result.window_id)


def _overview(result: Assessment) -> list[object]:
    states = [checked.passed for checked in result.checked_figures]
    missing = sum(checked.value is None for checked in result.checked_figures)
    failed = dict.fromkeys(tr(WORDS[one.rule.check]) for one in result.checked_figures if one.passed is False)
    return [_title(result), states.count(True), states.count(False), missing, ", ".join(failed)]


def _section(result: Assessment, sources: Sequence[str]) -> ImageSection:
    by_check: dict[str, dict[str, CheckedFigure]] = {}
    for checked in result.checked_figures:
        by_check.setdefault(checked.rule.check, {})[checked.band] = checked
    bands = list(dict.fromkeys(checked.band for checked in result.checked_figures))
    figure = histogram_figure(result)
    return ImageSection(
        _title(result),
        result.available,
        None if figure is None else svg_text(figure),
        [tr("between bands") if band == ALL_BANDS else band for band in bands],
        [_check_row(check, own, bands, sources) for check, own in by_check.items()],
    )


def _check_row(
    check: str, own: Mapping[str, CheckedFigure], bands: Sequence[str], sources: Sequence[str]
) -> CheckRow:
    values = [own[band].value if band in own else None for band in bands]
    rule = next(iter(own.values())).rule
    failed = [checked.band for checked in own.values() if checked.passed is False]
    passed = tr("passed") if any(checked.passed for checked in own.values()) else ""
    names = "" if len(failed) == len(own) else f" ({', '.join(failed)})"
    return CheckRow(
        tr(WORDS[check]),
        ["" if value is None else _worded(rule, value) for value in values],
        _limit(rule),
        tr("failed") + names if failed else passed,
        bool(failed),
        _remarks(own),
        sources.index(rule.source) + 1,
    )


def _worded(rule: Rule, value: float) -> str:
    """So precisely that it lies on the same side of its limits as the figure does."""
    is_share = rule.check != checks.SIGNAL_TO_NOISE
    scale, least = (100, 2) if is_share else (1, 1)
    limits = [scale * limit for limit in (rule.least, rule.most) if limit is not None]
    shown = shown_number(scale * value, decimals_beside(scale * value, limits, least))
    return f"{shown}\u00a0%" if is_share else shown


def _limit(rule: Rule) -> str:
    least, most = (None if limit is None else _short(rule.check, limit) for limit in (rule.least, rule.most))
    if least and most:
        return tr("{least} to {most}").format(least=least, most=most)
    if most:
        return tr("at most {most}").format(most=most)
    return tr("at least {least}").format(least=least) if least else tr("none")


def _short(check: str, limit: float) -> str:
    text = f"{limit:g}" if check == checks.SIGNAL_TO_NOISE else f"{100 * limit:g}\u00a0%"
    return text.replace(".", QLocale().decimalPoint())


def _remarks(own: Mapping[str, CheckedFigure]) -> list[str]:
    """Each reason with the bands that it concerns, where it doesn't concern all."""
    reasons: dict[str, list[str]] = {}
    for checked in own.values():
        if checked.reason is not None:
            reasons.setdefault(sentence(checked.reason), []).append(checked.band)
    return [
        reason if len(concerned) == len(own) else f"{', '.join(concerned)}: {reason}"
        for reason, concerned in reasons.items()
    ]
