"""The report of a radiometric acceptance, one HTML page."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from qgis.PyQt.QtCore import QT_TRANSLATE_NOOP

from ..imagery.message import Message
from ..toolkit.charts.figure_files import svg_text
from ..toolkit.pages import html_page
from ..toolkit.pages.html_page import Html
from ..toolkit.translation import sentence, tr
from .charts import balance_figure, histogram_figure, step_and_contrast
from .measure import limits
from .measure import rules as checks
from .measure.assessment import ALL_BANDS, Assessment, RuleFinding
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
_PASSED = QT_TRANSLATE_NOOP("@default", "passed")
_FAILED = QT_TRANSLATE_NOOP("@default", "failed")


def radiometry_page(results: Sequence[Assessment], notices: Iterable[Message], rules: RuleSet) -> str:
    """The whole report."""
    parts: list[Html] = [html_page.paragraph(tr("Rules: {name}.").format(name=rules.name))]
    parts.append(_overview(results))
    parts += [html_page.paragraph(words, "warning") for words in dict.fromkeys(map(sentence, notices))]
    parts += _balance(results)
    for result in results:
        parts += _image(result)
    parts += [html_page.heading(tr("How it is measured")), *map(html_page.paragraph, _method())]
    return html_page.page(tr("Radiometric acceptance"), parts)


def title(result: Assessment) -> str:
    """The image, and the window where it is not all of it."""
    name = result.image.ref.name
    if result.window_id is None:
        return name
    return tr("{name}, window {window}").format(name=name, window=result.window_id)


def _overview(results: Sequence[Assessment]) -> Html:
    rows = []
    for result in results:
        states = [finding.passed for finding in result.findings]
        missing = sum(finding.value is None for finding in result.findings)
        failed = dict.fromkeys(tr(WORDS[finding.rule.check]) for finding in result.findings if finding.passed is False)
        rows.append([title(result), states.count(True), states.count(False), missing, ", ".join(failed)])
    return html_page.table(
        [tr("image"), tr("passed"), tr("failed"), tr("not measurable"), tr("what failed")], rows
    )


def _balance(results: Sequence[Assessment]) -> list[Html]:
    """Tonal unity and contrast beside each other, where there are seams."""
    pairs = [(result, pair) for result in results if (pair := step_and_contrast(result)) is not None]
    if not pairs:
        return []
    words = tr(
        "Tonal balancing and feathering lower the step at the seams and take contrast away with it, so both have to be "
        "looked at together."
    )
    parts = [html_page.heading(tr("Tonal unity and contrast")), html_page.paragraph(words)]
    rows = [[title(result), f"{100 * step:.2f} %", f"{100 * contrast:.2f} %"] for result, (step, contrast) in pairs]
    table = html_page.table([tr("image"), tr("largest step at a seam"), tr("contrast beside the seams")], rows)
    figure = balance_figure(results)
    drawing = [html_page.drawing(svg_text(figure))] if figure is not None else []
    return [*parts, html_page.row([table, *drawing])]


def _image(result: Assessment) -> list[Html]:
    parts = [html_page.heading(title(result))]
    if result.available is not None:
        words = tr("Available range: {low:g} to {high:g} DN.").format(low=result.available[0], high=result.available[1])
        parts.append(html_page.paragraph(words, "small"))
    figure = histogram_figure(result)
    if figure is not None:
        parts.append(html_page.drawing(svg_text(figure)))
    return [html_page.together(parts), _table(result)]


def _table(result: Assessment) -> Html:
    """A row for each check, with its figure of every band."""
    by_check: dict[str, dict[str, RuleFinding]] = {}
    for finding in result.findings:
        by_check.setdefault(finding.rule.check, {})[finding.band] = finding
    bands = list(dict.fromkeys(finding.band for finding in result.findings))
    rows = []
    for check, own in by_check.items():
        rule = next(iter(own.values())).rule
        values = [_value(own[band]) if band in own else "" for band in bands]
        rows.append([tr(WORDS[check]), *values, _limit(rule), _state(own), rule.source])
    names = [tr("between bands") if band == ALL_BANDS else band for band in bands]
    return html_page.table([tr("check"), *names, tr("limit"), tr("result"), tr("source of the limit")], rows)


def _value(finding: RuleFinding) -> str:
    return "" if finding.value is None else _worded(finding.rule.check, finding.value)


def _worded(check: str, value: float) -> str:
    return f"{value:.1f}" if check == checks.SIGNAL_TO_NOISE else f"{100 * value:.2f}\u00a0%"


def _limit(rule: Rule) -> str:
    least, most = (None if limit is None else _short(rule.check, limit) for limit in (rule.least, rule.most))
    if least and most:
        return tr("{least} to {most}").format(least=least, most=most)
    if most:
        return tr("at most {most}").format(most=most)
    return tr("at least {least}").format(least=least) if least else tr("none")


def _short(check: str, limit: float) -> str:
    return f"{limit:g}" if check == checks.SIGNAL_TO_NOISE else f"{100 * limit:g}\u00a0%"


def _state(own: Mapping[str, RuleFinding]) -> html_page.Markup:
    """Whether all bands passed, which of them failed, and what can't be measured or judged and why."""
    said = []
    failed = [finding.band for finding in own.values() if finding.passed is False]
    if failed:
        names = "" if len(failed) == len(own) else f" ({', '.join(failed)})"
        said.append(f"<b>{html_page.text(tr(_FAILED) + names)}</b>")
    elif any(finding.passed for finding in own.values()):
        said.append(html_page.text(tr(_PASSED)))
    reasons: dict[str, list[str]] = {}
    for finding in own.values():
        if finding.reason is not None:
            reasons.setdefault(sentence(finding.reason), []).append(finding.band)
    for reason, concerned in reasons.items():
        said.append(html_page.text(reason if len(concerned) == len(own) else f"{', '.join(concerned)}: {reason}"))
    return html_page.Markup("<br>".join(said))


def _method() -> list[str]:
    side, far = limits.AREA_PX, limits.SEAM_FAR_PX
    return [
        tr(
            "Clipping, peak and contrast come from the histogram of all valid pixels. The peak is the fullest of 256 "
            "bins; contrast is the standard deviation as a share of the available range."
        ),
        tr(
            "Signal to noise: areas of {side} x {side} px, spread over the image, whose mean lies in the middle half "
            "of the range and whose four quadrants have the same mean as far as their noise lets one tell; the quarter "
            "with the least noise, mean over standard deviation."
        ).format(side=side),
        tr(
            "Colour balance: such areas whose bands differ by at most 10 % of the range; the quarter with the least "
            "colour, largest difference between the bands' means."
        ),
        tr(
            "Step at the seams: difference of the means {near} to {far} px on either side for every {station} px of "
            "seam, their median along each seam, the largest of all seams as a share of the image's largest value. "
            "Contrast beside the seams is the standard deviation of the same pixels, as a share of the range."
        ).format(near=limits.SEAM_NEAR_PX, far=far, station=limits.SEAM_STATION_PX),
    ]
